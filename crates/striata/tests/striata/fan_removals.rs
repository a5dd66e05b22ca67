//! Fans of removals whose holes are filled freely: every level, every set of steps and every view shows what the
//! fragments say, and tables become fragments again.

use striata_testing::support;

use proptest::prelude::*;
use striata::file::{
    DecodeError, EncodeError, FileModel, SectionKind, StriataFile, WriteOptions, write_fragments,
};
use striata::mesh::{
    Face, Fragment, FragmentSequence, FragmentedMesh, IndexedMesh, PositionIndex, canonical_triangles,
    replay_fragments, shapes,
};
use striata::model::{
    BoundScope, FanFront, FanInstance, FanOptions, FanScene, Fans, LodModel, ModelKind, Patterns,
};
use striata::simplify::{RemovalOptions, build_fragments};
use striata::view::{Camera, ScreenError, Verdict};
use support::{
    ArbitraryCriterion, Random, assert_shows_set, follows_the_fragments, fragment_cases, hub_cases,
    nasty_cases, seam_cases, soups, surface_cases, with_valid_checksums,
};

fn check(mesh: &FragmentedMesh, fans: &Fans, instance: &FanInstance) {
    let mut indices = Vec::new();
    instance.indices_into(fans, &mut indices);
    assert_shows_set(&mesh.fragments, indices.as_chunks().0, |step| instance.is_refined(step));
}

/// Applies random collapses and splits, drifting toward coarse and fine in turn.
fn random_walk(mesh: &FragmentedMesh, fans: &Fans, change_count: usize, random: &mut Random) {
    let step_count = fans.step_count();
    let mut instance = FanInstance::full(fans);
    check(mesh, fans, &instance);
    for change in 0..if step_count == 0 { 0 } else { change_count } {
        let step = random.below(step_count) as u32;
        if random.below(100) < [75, 25][change / 8 % 2] {
            instance.collapse(fans, step);
            assert!(!instance.is_refined(step));
        } else {
            instance.split(fans, step);
            assert!(instance.is_refined(step));
        }
        check(mesh, fans, &instance);
    }
}

type CornersAndGroup = ([u32; 3], u32);

/// The faces of a sequence in an order that does not depend on how they were listed.
fn fragments_of(fragments: &FragmentSequence) -> Vec<[Vec<CornersAndGroup>; 2]> {
    let sorted = |faces: &mut dyn Iterator<Item = u32>| {
        let canonical = |face: u32| {
            let Face { corners, group } = fragments.faces()[face as usize];
            (canonical_triangles(&[corners])[0], group)
        };
        let mut faces: Vec<_> = faces.map(canonical).collect();
        faces.sort_unstable();
        faces
    };
    let base = sorted(&mut (0..fragments.base_face_count() as u32));
    let steps = (0..fragments.step_count() as u32).map(|step| {
        [sorted(&mut fragments.ceiling(step)), sorted(&mut fragments.floor(step).iter().copied())]
    });
    [[base, Vec::new()]].into_iter().chain(steps).collect()
}

fn follow(mesh: &FragmentedMesh, seed: u64, stride: usize) {
    let fans = Fans::build(mesh);
    follows_the_fragments(mesh, &fans, stride);
    random_walk(mesh, &fans, 48, &mut Random::new(seed));
    let levels = mesh.fragments.levels();
    let errors: Vec<f32> =
        (0..fans.step_count() as u32).map(|step| mesh.fragments.floor_error(step)).collect();
    let again = fans.to_fragments(&errors).unwrap();
    assert_eq!(fragments_of(&again), fragments_of(&mesh.fragments));
    let counts: Vec<u32> = (0..=fans.step_count()).map(|s| levels.triangle_count_at(s) as u32).collect();
    assert_eq!(fans.triangle_counts(), counts);
    // Positions of the base cannot be distinguished, but the table does not depend on them.
    let rebuilt = Fans::build(&FragmentedMesh { mesh: mesh.mesh.clone(), fragments: again });
    assert_eq!(rebuilt, fans);
}

#[test]
fn removals_follow_the_fragments() {
    fragment_cases().for_each(|(seed, mesh)| follow(&mesh, seed, 1));
}

/// Collapses are removals too: seams, groups, hubs and anything that is not a surface.
#[test]
fn collapses_as_fragments_make_the_same_table() {
    let cases = nasty_cases().chain(surface_cases()).chain(seam_cases()).chain(hub_cases().take(4));
    for case in cases {
        let mesh = FragmentedMesh::from_collapses(&case.refinable);
        follow(&mesh, case.seed, case.stride.max(1 + mesh.fragments.step_count() / 40));
        let (collapses, fragments) =
            (Fans::build_without_bounds(&case.refinable), Fans::build_without_bounds(&mesh));
        assert_eq!(collapses, fragments);
    }
}

/// A floor that is not near its step, a step without triangles, a floor that is larger than its ceiling.
#[test]
fn fragments_without_shape_are_followed() {
    let faces =
        |corners: &[[u32; 3]]| corners.iter().map(|&corners| Face { corners, group: 0 }).collect::<Vec<_>>();
    let base = faces(&[[0, 1, 2], [0, 2, 1], [3, 2, 1]]);
    let steps = [
        Fragment { floor: faces(&[[0, 1, 2], [0, 2, 1]]), ..Fragment::default() },
        Fragment { ceiling: faces(&[[0, 1, 5], [1, 2, 5], [2, 0, 5]]), ..Fragment::default() },
        Fragment { ceiling: faces(&[[0, 1, 6]]), floor: faces(&[[3, 2, 1], [1, 2, 5]]), error: 0.0 },
        Fragment { ceiling: faces(&[[0, 1, 7], [0, 6, 7]]), ..Fragment::default() },
        Fragment { floor: faces(&[[0, 1, 7], [0, 1, 6], [2, 0, 5]]), ..Fragment::default() },
    ];
    let positions = PositionIndex::identity(9);
    let fragments = FragmentSequence::from_fragments(positions, base, steps.into_iter()).unwrap();
    let triangles = replay_fragments(
        &FragmentedMesh {
            mesh: IndexedMesh::new(vec![[0.0; 3]; 9], Vec::new()),
            fragments: fragments.clone(),
        },
        5,
    )
    .triangles;
    let corners = (0..9).map(|i| [i as f32, (i * i % 5) as f32, (i % 3) as f32]);
    let mesh = FragmentedMesh { mesh: IndexedMesh::new(corners.collect(), triangles), fragments };
    for seed in 0..20 {
        follow(&mesh, seed, 1);
    }
}

fn cameras(scene: &FanScene<'_>, random: &mut Random) -> Vec<ScreenError> {
    let sphere = scene.sphere();
    let radius = sphere.radius.max(1e-3);
    let mut eye = [3.0, 0.5, 1.0];
    let screens = (0..30).map(|frame| {
        let mut around = |spread: f32| (random.below(1000) as f32 / 1000.0 - 0.5) * spread;
        let spread = if frame % 9 == 8 { 6.0 } else { 0.2 };
        eye = eye.map(|x| (x + around(spread)).clamp(-4.0, 4.0));
        let at = [0, 1, 2].map(|i| sphere.center[i] + eye[i] * radius);
        let camera = Camera::new(at, sphere.center, [0.1, 1.0, 0.2], 0.5, [800, 600]);
        let camera = camera.unwrap_or_else(|_| {
            Camera::new([9.0; 3], sphere.center, [0.1, 1.0, 0.2], 0.5, [800, 600]).unwrap()
        });
        ScreenError::new(camera, 2.0).with_model_bounds(sphere)
    });
    screens.collect()
}

#[test]
fn a_front_of_removals_shows_what_is_refined_from_the_base() {
    for (seed, mesh) in fragment_cases() {
        let fans = Fans::build(&mesh);
        let scene = FanScene::new(&fans, &mesh.mesh.positions);
        let (mut front, mut fresh) = (FanFront::new(&scene), FanInstance::full(&fans));
        for screen in cameras(&scene, &mut Random::new(seed)) {
            front.update(&scene, &screen, usize::MAX);
            fresh.refine(&scene, &screen);
            assert_eq!(front.instance(), &fresh);
            check(&mesh, &fans, &fresh);
            let mut indices = Vec::new();
            fresh.indices_into(&fans, &mut indices);
            assert_eq!(front.triangle_count(), indices.len() / 3);
        }
        let mut front = FanFront::new(&scene);
        for round in 0..10 {
            front.update(&scene, &ArbitraryCriterion(round * 7919), [usize::MAX, 5][round as usize % 2]);
            check(&mesh, &fans, front.instance());
        }
    }
}

/// With bounds over all dependents, the steps that a criterion wants need no others.
#[test]
fn what_is_wanted_is_valid_with_bounds_over_all_dependents() {
    let options = FanOptions::default().with_bounds(Some(BoundScope::Dependents));
    let mut wider = 0;
    for (seed, mesh) in fragment_cases() {
        let fans = Fans::build_with(&mesh, &options, &mut striata::ignore_progress).unwrap();
        let tree = Fans::build(&mesh);
        let scene = FanScene::new(&fans, &mesh.mesh.positions);
        for screen in cameras(&scene, &mut Random::new(seed)).into_iter().take(8) {
            let is_wanted = |step: u32| weigh(&screen, &scene, step).should_refine();
            let mut instance = FanInstance::full(&fans);
            instance.refine(&scene, &screen);
            for step in 0..fans.step_count() as u32 {
                assert_eq!(instance.is_refined(step), is_wanted(step), "step {step} of seed {seed}");
            }
            check(&mesh, &fans, &instance);
            let mut of_tree = FanInstance::full(&tree);
            of_tree.refine(&FanScene::new(&tree, &mesh.mesh.positions), &screen);
            assert!((0..fans.step_count() as u32).all(|s| !of_tree.is_refined(s) || instance.is_refined(s)));
            wider += instance.split_count() - of_tree.split_count();
        }
    }
    assert!(wider > 0);
}

fn weigh(screen: &ScreenError, scene: &FanScene<'_>, step: u32) -> Verdict {
    use striata::view::Criterion as _;
    screen.weigh(&scene.part(step))
}

/// Free retriangulation by the simplifier, through a file and back.
#[test]
fn the_removals_of_the_simplifier_survive_a_file() {
    for mesh in [shapes::terrain(20, 3), shapes::torus(20, 12, 1.0, 0.4), shapes::two_material_sphere(12, 16)]
    {
        let fragmented = build_fragments(&mesh, &RemovalOptions::default()).unwrap().fragmented;
        let (fans, patterns) = (Fans::build(&fragmented), Patterns::build(&fragmented).unwrap());
        for models in
            [vec![FileModel::Fans(&fans)], vec![FileModel::Patterns(&patterns), FileModel::Fans(&fans)]]
        {
            let mut bytes = Vec::new();
            write_fragments(&fragmented, &models, &WriteOptions::default(), &mut bytes).unwrap();
            let file = StriataFile::parse(&bytes).unwrap();
            assert!(!file.has_collapses());
            assert_eq!(file.fans().unwrap().unwrap(), fans);
            assert_eq!(&file.levels().unwrap(), fragmented.fragments.levels());
            assert_eq!(file.refinable_mesh().unwrap_err(), DecodeError::NoCollapses);
            assert_eq!(file.mesh().unwrap().groups, fragmented.mesh.groups);
            let read = file.fragmented_mesh().unwrap();
            for split_count in (0..=fans.step_count()).step_by(1 + fans.step_count() / 20) {
                let expected = canonical_triangles(&replay_fragments(&fragmented, split_count).triangles);
                assert_eq!(canonical_triangles(&replay_fragments(&read, split_count).triangles), expected);
                assert_eq!(canonical_triangles(&file.level(split_count).unwrap().triangles), expected);
            }
        }
        let mut out = Vec::new();
        let none = write_fragments(&fragmented, &[], &WriteOptions::default(), &mut out);
        assert!(matches!(none, Err(EncodeError::NoModel)));
    }
}

#[test]
fn models_of_collapses_are_not_written_with_fragments() {
    let case = surface_cases().next().unwrap();
    let strips = striata::strip::stripify(&case.refinable.mesh).unwrap();
    let model = striata::model::LodStrips::build(&case.refinable, &strips).unwrap();
    let mesh = FragmentedMesh::from_collapses(&case.refinable);
    let written =
        write_fragments(&mesh, &[FileModel::LodStrips(&model)], &WriteOptions::default(), &mut Vec::new());
    assert!(matches!(written, Err(EncodeError::NeedsCollapses { model: ModelKind::LodStrips })));
}

/// Walks randomly through what has been read: no triangle may have an inactive corner.
fn read_everything(bytes: &[u8]) -> Result<(), DecodeError> {
    let file = StriataFile::parse(bytes)?;
    file.levels()?;
    let Some(fans) = file.fans() else { return Ok(()) };
    let fans = fans?;
    let mesh = file.fragmented_mesh()?;
    mesh.mesh.check()?;
    let scene = FanScene::new(&fans, &mesh.mesh.positions);
    let mut front = FanFront::new(&scene);
    for round in 0..6 {
        front.update(&scene, &ArbitraryCriterion(round * 7919), [usize::MAX, 5][round as usize % 2]);
        check(&mesh, &fans, front.instance());
    }
    random_walk(&mesh, &fans, 10, &mut Random::new(3));
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..striata_testing::cases(300) })]

    #[test]
    fn soups_as_fragments_follow_the_oracle(case in soups()) {
        follow(&FragmentedMesh::from_collapses(&case.refinable), case.seed, 1);
    }

    #[test]
    fn damaged_fans_are_an_error_or_fans_without_cracks(
        changes in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 1..3),
        which in 0usize..24,
    ) {
        let (_, mesh) = fragment_cases().nth(which).unwrap();
        let fans = Fans::build(&mesh);
        let mut bytes = Vec::new();
        write_fragments(&mesh, &[FileModel::Fans(&fans)], &WriteOptions::default(), &mut bytes).unwrap();
        read_everything(&bytes).unwrap();
        let is_damaged = |kind: SectionKind| kind.0.starts_with(b"FN") || kind == SectionKind::SUMMARY;
        let sections = StriataFile::parse(&bytes).unwrap().sections().to_vec();
        let spans = sections.iter().filter(|s| is_damaged(s.kind)).map(|s| s.offset..s.offset + s.bytes);
        let candidates: Vec<u64> = spans.flatten().collect();
        for (index, byte) in changes {
            bytes[candidates[index.index(candidates.len())] as usize] ^= byte;
        }
        with_valid_checksums(&mut bytes);
        let _ = read_everything(&bytes);
    }
}
