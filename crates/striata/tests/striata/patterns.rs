//! Patterns against the oracle: uniform levels, any valid set, and the smallest set that satisfies a
//! condition.

use striata_testing::support;

use proptest::prelude::*;
use striata::file::{FileModel, StriataFile, WriteOptions, write_fragments};
use striata::mesh::{
    Face, Fragment, FragmentSequence, FragmentedMesh, IndexedMesh, PositionIndex, Random,
    canonical_triangles, fragment_faces, shapes,
};
use striata::model::{CriterionCondition, ModelError, Overlap, PatternInstance, PatternScene, Patterns};
use striata::simplify::{CertifiedFaces, SequenceOptions, build_sequence, certify_faces};
use striata::view::{Camera, Criterion, DetailBox, ScreenError};
use support::{
    Case, RandomSequenceOptions, closed_sets, follows_the_fragments, follows_the_oracle, fragment_cases,
    grid, hub_cases, nasty_cases, random_removals, seam_cases, smallest_set, soups, surface_cases,
    with_seams_and_groups,
};

/// Compares the triangles of an instance with the oracle, group by group.
fn shows_its_set(fragments: &FragmentSequence, instance: &PatternInstance, group_count: u32) {
    let there = fragment_faces(fragments, |step| instance.is_refined(step));
    assert_eq!(instance.triangle_count(), there.len());
    for group in 0..group_count {
        let faces = there.iter().map(|&face| fragments.faces()[face as usize]);
        let expected: Vec<_> = faces.filter(|face| face.group == group).map(|face| face.corners).collect();
        let mut found = Vec::new();
        instance.group_triangles_into(group, &mut found);
        assert_eq!(canonical_triangles(&found), canonical_triangles(&expected), "group {group}");
    }
}

fn follows_the_oracle_for_any_set(case: &Case) {
    let fragmented = FragmentedMesh::from_collapses(&case.refinable);
    let patterns = Patterns::build(&fragmented).unwrap();
    follows_the_oracle(&case.refinable, &patterns, case.stride);
    any_set_of_fragments_follows_the_oracle(&fragmented, &patterns, case.seed);
}

fn any_set_of_fragments_follows_the_oracle(fragmented: &FragmentedMesh, patterns: &Patterns, seed: u64) {
    let step_count = patterns.fragment_count();
    let errors = (0..step_count as u32).map(|step| fragmented.fragments.floor_error(step)).collect();
    let unpacked = patterns.unpack(errors).unwrap();
    let again = FragmentedMesh { mesh: fragmented.mesh.clone(), fragments: unpacked };
    // Bounds depend on the order of the faces.
    let built = Patterns::build_without_bounds(&again).unwrap();
    assert!(built == patterns.clone().without_bounds(), "unpacked and built again");
    if step_count == 0 {
        return;
    }
    let group_count = fragmented.mesh.groups.len().max(1) as u32;
    let mut random = Random::new(seed);
    let mut instance = PatternInstance::base(patterns);
    for _ in 0..24 {
        let step = random.below(step_count as u32);
        let count = instance.split_count();
        if random.below(2) == 0 {
            let inserted = instance.insert(patterns, step);
            assert!(instance.is_refined(step));
            assert_eq!(instance.split_count(), count + inserted);
        } else {
            let removed = instance.remove(patterns, step);
            assert!(!instance.is_refined(step));
            assert_eq!(instance.split_count() + removed, count);
        }
        shows_its_set(&fragmented.fragments, &instance, group_count);
    }
    for _ in 0..6 {
        let (name, percent) = (u64::from(random.below(1 << 20)), random.below(100));
        let condition = |overlap: Overlap| random_condition(overlap, name, percent);
        let mut other = PatternInstance::base(patterns);
        instance.adapt(patterns, &condition);
        other.refine(patterns, &condition);
        shows_its_set(&fragmented.fragments, &instance, group_count);
        assert_eq!(instance, other, "starting from the base and from the previous set");
        let change = instance.adapt(patterns, &condition);
        assert_eq!(change, Default::default(), "nothing is left to be done");
        assert_eq!(other.coarsen(patterns, &condition), 0);
    }
}

/// An arbitrary but deterministic condition.
fn random_condition(overlap: Overlap, seed: u64, percent: u32) -> bool {
    let name = u64::from(overlap.upper) << 32 | u64::from(overlap.lower.map_or(u32::MAX, |step| step));
    Random::new(name ^ seed << 7).below(100) < percent
}

#[test]
fn all_kinds_of_meshes_follow_the_oracle() {
    let cases = nasty_cases().chain(surface_cases()).chain(seam_cases()).chain(hub_cases().take(4));
    cases.for_each(|case| follows_the_oracle_for_any_set(&case));
}

#[test]
fn removals_with_any_triangulation_follow_the_oracle() {
    for (seed, fragmented) in fragment_cases() {
        let patterns = Patterns::build(&fragmented).unwrap();
        follows_the_fragments(&fragmented, &patterns, 1);
        any_set_of_fragments_follows_the_oracle(&fragmented, &patterns, seed);
    }
}

proptest! {
    #![proptest_config(striata_testing::cases(160))]

    #[test]
    fn soups_follow_the_oracle(case in soups()) {
        follows_the_oracle_for_any_set(&case);
    }
}

/// Small pieces of terrain, simplified as far as possible.
fn small_terrains() -> impl Iterator<Item = Case> {
    (0..12).map(|seed| {
        let mesh = striata::mesh::shapes::terrain(4, seed);
        let built = striata::simplify::build_sequence(&mesh, &Default::default());
        Case { stride: 1, seed, refinable: built.unwrap().refinable }
    })
}

#[test]
fn adapting_yields_the_smallest_set_that_satisfies_a_condition() {
    let mut sets_seen = 0;
    let collapsed = nasty_cases().chain(small_terrains());
    let collapsed = collapsed.map(|case| FragmentedMesh::from_collapses(&case.refinable));
    let removed = (0..12).map(|seed| {
        random_removals(&striata::mesh::shapes::icosphere(1, 1.0), 12, &mut support::Random::new(seed))
    });
    for fragmented in collapsed.chain(removed) {
        let fragments = &fragmented.fragments;
        if fragments.step_count() == 0 || fragments.step_count() > 12 {
            continue;
        }
        let patterns = Patterns::build(&fragmented).unwrap();
        let standing = closed_sets(fragments);
        let mut instance = PatternInstance::base(&patterns);
        for seed in 0..20 {
            let condition = |overlap: Overlap| random_condition(overlap, seed, (seed as u32 * 17) % 100);
            let smallest = smallest_set(fragments, &standing, |face, upper| {
                let lower = face.and_then(|face| fragments.creating_step(face));
                condition(Overlap { lower, upper, error: 0.0 })
            });
            instance.adapt(&patterns, &condition);
            let found = (0..fragments.step_count() as u32).filter(|&step| instance.is_refined(step));
            assert_eq!(found.fold(0, |set, step| set | 1 << step), smallest);
            sets_seen += usize::from(smallest != 0);
        }
    }
    assert!(sets_seen > 100, "only {sets_seen} conditions wanted anything");
}

#[test]
fn with_errors_as_condition_both_algorithms_agree() {
    for case in surface_cases().skip(4).take(5) {
        let fragmented = FragmentedMesh::from_collapses(&case.refinable);
        let patterns = Patterns::build(&fragmented).unwrap();
        let mut random = Random::new(case.seed);
        let (mut one, mut other) = (PatternInstance::full(&patterns), PatternInstance::base(&patterns));
        for _ in 0..20 {
            let limit = random.below(patterns.fragment_count() as u32);
            // Steps younger than the limit are never too coarse, so whatever satisfied the condition
            // before also does above it.
            let condition = |overlap: Overlap| overlap.upper < limit;
            let coarsened = one.coarsen(&patterns, &condition);
            let refined = one.refine(&patterns, &condition);
            let change = other.adapt(&patterns, &condition);
            assert_eq!(one, other, "{coarsened} removed and {refined} inserted, or {change:?}");
            assert_eq!(one.split_count(), limit as usize);
        }
    }
}

/// Inserts fragments that replace a triangle shown and that a criterion wants, until there is none left.
fn check_wanted_set(
    fragments: &FragmentSequence,
    scene: PatternScene<'_>,
    criterion: &impl Criterion,
) -> PatternInstance {
    let patterns = scene.patterns();
    let mut instance = PatternInstance::base(patterns);
    instance.adapt(patterns, &CriterionCondition::new(scene, criterion));
    let replaced_by = fragments.replacing_steps();
    let mut expected = PatternInstance::base(patterns);
    let is_wanted = |step: &u32| criterion.weigh(&scene.part(*step)).should_refine();
    let floorless = (0..fragments.step_count() as u32).filter(|&step| fragments.floor(step).is_empty());
    for step in floorless.filter(is_wanted) {
        expected.insert(patterns, step);
    }
    loop {
        let shown = fragment_faces(fragments, |step| expected.is_refined(step));
        let above = shown.iter().map(|&face| replaced_by[face as usize]);
        let above = above.filter(|&step| step != FragmentSequence::NO_STEP);
        let wanted: Vec<u32> = above.filter(is_wanted).collect();
        wanted.iter().for_each(|&step| {
            expected.insert(patterns, step);
        });
        if wanted.is_empty() {
            break;
        }
    }
    assert_eq!(instance, expected, "{} fragments, {}", instance.split_count(), expected.split_count());
    instance
}

#[test]
fn views_and_boxes_refine_everything_wanted() {
    let mesh = striata::mesh::shapes::terrain(48, 7);
    let built = striata::simplify::build_sequence(&mesh, &Default::default());
    let fragmented = FragmentedMesh::from_collapses(&built.unwrap().refinable);
    let patterns = Patterns::build(&fragmented).unwrap();
    let positions = &fragmented.mesh.positions;
    let scene = PatternScene::new(&patterns, positions);
    let all = fragmented.mesh.bounds().unwrap();
    let full = fragmented.mesh.triangle_count();
    let base = fragmented.fragments.levels().triangle_count_at(0);
    let middle: [f32; 3] = std::array::from_fn(|a| 0.5 * (all.min[a] + all.max[a]));
    let quarter =
        DetailBox { min: all.min, max: [middle[0], middle[1], all.max[2]], error_outside: f32::INFINITY };
    let shown = check_wanted_set(&fragmented.fragments, scene, &quarter).triangle_count();
    assert!(shown > full / 5 && shown < full * 4 / 5, "{shown} of {full} triangles for a quarter");
    let nowhere = DetailBox { min: [9e9; 3], max: [9e9; 3], ..quarter };
    let count = |criterion| check_wanted_set(&fragmented.fragments, scene, criterion).triangle_count();
    assert_eq!(count(&nowhere), base);
    let everywhere = DetailBox { min: all.min, max: all.max, ..quarter };
    assert_eq!(count(&everywhere), full);
    for eye in [[2.0, 2.0, 2.0], [0.1, 0.1, 0.4], [-3.0, 0.2, 0.3]] {
        let camera = Camera::new(eye, middle, [0.0, 0.0, 1.0], 0.4, [800, 600]).unwrap();
        let criterion = ScreenError::new(camera, 2.0);
        let shown = check_wanted_set(&fragmented.fragments, scene, &criterion).triangle_count();
        assert!(shown > base && shown < full, "{shown} triangles from {eye:?}");
    }
}

/// The bounds of a fragment enclose the triangles of the full mesh that its floor stands for, so every such
/// triangle that touches a box is shown.
#[test]
fn a_box_shows_full_detail() {
    let mesh = striata::mesh::shapes::terrain(40, 3);
    let built = striata::simplify::build_sequence(&mesh, &Default::default());
    let collapsed = FragmentedMesh::from_collapses(&built.unwrap().refinable);
    let removed =
        random_removals(&striata::mesh::shapes::terrain(20, 4), usize::MAX, &mut support::Random::new(3));
    for (fragmented, edge) in [(&collapsed, 0.25), (&collapsed, 0.02), (&removed, 0.25), (&removed, 0.02)] {
        let patterns = Patterns::build(fragmented).unwrap();
        let positions = &fragmented.mesh.positions;
        let scene = PatternScene::new(&patterns, positions);
        let all = fragmented.mesh.bounds().unwrap();
        let mut random = Random::new(5);
        let mut instance = PatternInstance::full(&patterns);
        for _ in 0..20 {
            let at = [(); 3].map(|()| random.unit() as f32);
            let size: [f32; 3] = std::array::from_fn(|a| all.max[a] - all.min[a]);
            let min: [f32; 3] = std::array::from_fn(|a| all.min[a] + at[a] * size[a]);
            let max = std::array::from_fn(|a| if a == 2 { all.max[a] } else { min[a] + edge * size[a] });
            let min = [min[0], min[1], all.min[2]];
            let detail = DetailBox { min, max, error_outside: f32::INFINITY };
            instance.adapt(&patterns, &CriterionCondition::new(scene, &detail));
            let mut shown = Vec::new();
            instance.triangles_into(&mut shown);
            let shown = canonical_triangles(&shown);
            // Any corner in the box makes a triangle touch it.
            let is_inside = |v: u32| (0..3).all(|a| (min[a]..=max[a]).contains(&positions[v as usize][a]));
            let touches = |t: &[u32; 3]| t.iter().any(|&v| is_inside(v));
            let mut touching = canonical_triangles(&fragmented.mesh.triangles);
            touching.retain(touches);
            assert!(touching.iter().all(|t| shown.binary_search(t).is_ok()));
            assert!(instance.triangle_count() < fragmented.mesh.triangle_count() * 4 / 5);
        }
    }
}

/// A set that satisfies a condition on the errors of overlaps shows no face with a larger error, and it is
/// mostly smaller than one that knows only the errors of floors.
#[test]
fn errors_of_overlaps_cover_their_faces() {
    let (mut by_overlap, mut by_fragment) = (0, 0);
    let collapsed = build_sequence(&shapes::terrain(24, 3), &SequenceOptions::default()).unwrap();
    let removed = random_removals(&shapes::torus(18, 12, 2.0, 0.7), usize::MAX, &mut support::Random::new(8));
    for mesh in [FragmentedMesh::from_collapses(&collapsed.refinable), removed] {
        let CertifiedFaces { fragmented, face_errors } = certify_faces(&mesh);
        let fragments = &fragmented.fragments;
        let patterns = Patterns::build_with_overlap_errors(&fragmented, &face_errors).unwrap();
        let floors = Patterns::build(&fragmented).unwrap();
        assert!(patterns.has_overlap_errors() && !floors.has_overlap_errors());
        let largest = fragments.levels().error_at(0);
        let scene = PatternScene::new(&patterns, &fragmented.mesh.positions);
        let mut instance = PatternInstance::base(&patterns);
        for share in [0.5, 0.2, 0.05, 0.01, 0.3] {
            let limit = share * largest;
            instance.adapt(&patterns, &|overlap: Overlap| overlap.error > limit);
            assert!(scene.error_of(&instance) <= limit);
            let shown = fragment_faces(fragments, |step| instance.is_refined(step));
            assert!(shown.iter().all(|&face| face_errors[face as usize] <= limit));
            by_overlap += instance.triangle_count();
            let mut other = PatternInstance::base(&floors);
            other.adapt(&floors, &|overlap: Overlap| overlap.error > limit);
            assert!(other.triangle_count() >= instance.triangle_count());
            by_fragment += other.triangle_count();
        }
        let mut bytes = Vec::new();
        write_fragments(&fragmented, &[FileModel::Patterns(&patterns)], &WriteOptions::default(), &mut bytes)
            .unwrap();
        assert_eq!(StriataFile::parse(&bytes).unwrap().patterns().unwrap().unwrap(), patterns);
        let missing = Patterns::build_with_overlap_errors(&fragmented, &face_errors[1..]);
        assert!(matches!(missing, Err(ModelError::Length { .. })));
    }
    assert!(by_overlap < by_fragment, "{by_overlap} triangles instead of {by_fragment}");
}

/// A closed ring of triangles around one vertex.
fn cone(n: u32) -> IndexedMesh {
    let rim = (0..n).map(|i| [i as f32, (i * i % 17) as f32, 0.0]);
    let triangles = (0..n).map(|i| [n, i, (i + 1) % n]).collect();
    IndexedMesh::new(rim.chain([[0.0, 0.0, 5.0]]).collect(), triangles)
}

/// Adds two copies of every triangle, and one with reversed orientation.
fn with_copies(mut mesh: IndexedMesh) -> IndexedMesh {
    let turned = |&[a, b, c]: &[u32; 3]| [[a, b, c], [b, c, a], [c, a, b], [a, c, b]];
    mesh.triangles = mesh.triangles.iter().flat_map(turned).collect();
    mesh
}

#[test]
fn hubs_of_rings_and_triangles_over_triangles_follow_the_oracle() {
    let meshes = [cone(400), with_copies(cone(120)), with_copies(grid(5, true)), with_copies(cone(3))];
    for (mesh, seed) in meshes.iter().zip(0..) {
        for (far_percent, base_position_count) in [(0, 1), (50, 1), (10, 40)] {
            let sequence_options = RandomSequenceOptions { far_percent, base_position_count };
            follows_the_oracle_for_any_set(&Case::new(mesh, sequence_options, seed, 11));
            let seams = with_seams_and_groups(mesh.clone());
            follows_the_oracle_for_any_set(&Case::new(&seams, sequence_options, seed, 11));
        }
    }
}

/// Two fragments with the same ring on top of each other: one hub replaces all triangles of another.
#[test]
fn a_hub_can_replace_a_hub() {
    for n in [5, 64, 65, 300] {
        let around = |hub: u32| (0..n).map(move |i| [hub, i, (i + 1) % n]);
        let face = |corners: [u32; 3]| Face { corners, group: 0 };
        let faces = |corners: Vec<[u32; 3]>| corners.into_iter().map(face).collect::<Vec<_>>();
        let base = faces((1..n - 1).map(|i| [0, i, i + 1]).collect());
        let fragment = |floor, hub| Fragment { floor, ceiling: faces(around(hub).collect()), error: 0.0 };
        let first = fragment(base.clone(), n);
        let second = fragment(first.ceiling.clone(), n + 1);
        let positions = PositionIndex::identity(n as usize + 2);
        let fragments = FragmentSequence::from_fragments(positions, base, [first, second].into_iter());
        let mut mesh = cone(n);
        mesh.positions.push([0.0, 0.0, 6.0]);
        mesh.triangles = around(n + 1).collect();
        let fragmented = FragmentedMesh { mesh, fragments: fragments.unwrap() };
        any_set_of_fragments_follows_the_oracle(
            &fragmented,
            &Patterns::build(&fragmented).unwrap(),
            u64::from(n),
        );
    }
}

/// An instance releases memory without changing the remaining triangles.
#[test]
fn removing_fragments_releases_memory() {
    let mesh = with_seams_and_groups(grid(32, true));
    let sequence_options = RandomSequenceOptions { far_percent: 0, base_position_count: 8 };
    let case = Case::new(&mesh, sequence_options, 1, 100);
    let fragmented = FragmentedMesh::from_collapses(&case.refinable);
    let patterns = Patterns::build(&fragmented).unwrap();
    let group_count = fragmented.mesh.groups.len() as u32;
    for percent in [0, 10] {
        let mut instance = PatternInstance::full(&patterns);
        let full = instance.bytes();
        assert!(instance.triangle_count() > 1024);
        instance.adapt(&patterns, &|overlap: Overlap| overlap.upper < percent);
        assert!(instance.bytes() < full / 2, "{} of {full} bytes", instance.bytes());
        shows_its_set(&fragmented.fragments, &instance, group_count);
        instance.adapt(&patterns, &|_: Overlap| true);
        assert_eq!(instance, PatternInstance::full(&patterns));
        shows_its_set(&fragmented.fragments, &instance, group_count);
    }
}

/// Floor errors that vary from step to step, as certified ones do: large errors can lie below small ones.
#[test]
fn errors_that_rise_and_fall_are_found() {
    let mesh = striata::mesh::shapes::terrain(24, 5);
    let built = striata::simplify::build_sequence(&mesh, &Default::default());
    let mut fragmented = FragmentedMesh::from_collapses(&built.unwrap().refinable);
    let mut random = Random::new(11);
    let errors = (0..fragmented.fragments.step_count()).map(|_| random.below(1000) as f32 * 0.001);
    fragmented.fragments = fragmented.fragments.with_floor_errors(errors.collect()).unwrap();
    let patterns = Patterns::build(&fragmented).unwrap();
    let scene = PatternScene::new(&patterns, &fragmented.mesh.positions);
    for error_outside in [0.5, 0.9, 0.99, 0.998] {
        let detail = DetailBox { min: [9e9; 3], max: [9e9; 3], error_outside };
        let instance = check_wanted_set(&fragmented.fragments, scene, &detail);
        let error = scene.error_of(&instance);
        assert!(error <= error_outside && error > 0.0, "{error} of {error_outside}");
    }
}
