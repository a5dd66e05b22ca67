//! Certified errors are bounds: no point of the original surface is farther from a level than the error
//! states.

use striata_testing::meshes;

use striata_testing::support;

use proptest::prelude::*;
use striata::Cancelled;
use striata::mesh::{
    DistanceOptions, FragmentSequence, FragmentedMesh, IndexedMesh, Random, RefinableMesh, fragment_faces,
    replay, replay_fragments, shapes, surface_distance,
};
use striata::simplify::{
    CertifiedFaces, CostFunction, SequenceOptions, build_sequence, certify, certify_collapses,
    certify_collapses_in_any_state, certify_faces, certify_with_progress, flat_folds,
};
use support::{
    Case, RandomSequenceOptions, hub_cases, nasty_cases, random_refinable, seam_cases, soups, surface_cases,
};

#[test]
fn flat_folds_are_noticed() {
    let folds_of = |refinable: &RefinableMesh| flat_folds(&FragmentedMesh::from_collapses(refinable));
    let options = RandomSequenceOptions { far_percent: 0, base_position_count: 1 };
    let collapsed = |mesh: &IndexedMesh| random_refinable(mesh, options, &mut support::Random::new(5));
    let plane = shapes::grid(12, 12);
    assert!(folds_of(&collapsed(&plane)) > 0, "collapses at random fold a plane over");
    let built = build_sequence(&plane, &SequenceOptions::default()).unwrap().refinable;
    assert_eq!(folds_of(&built), 0);
    // A curved surface has no plane to fold over in.
    assert_eq!(folds_of(&collapsed(&shapes::icosphere(2, 1.0))), 0);
}

/// Distance of samples of `full` from `state`; 0 if there is nothing to measure.
fn measured(full: &IndexedMesh, state: &IndexedMesh, sample_count: usize) -> f64 {
    if state.triangles.is_empty() {
        return 0.0;
    }
    let options = DistanceOptions::default().with_sample_count(sample_count);
    surface_distance(full, state, &options).expect("both have triangles").a_to_b.max
}

/// Adds a margin for the rounding of the measurement itself.
fn above(error: f32, mesh: &IndexedMesh) -> f64 {
    f64::from(error) + 1e-14 * mesh.diagonal()
}

fn errors_hold_at_levels(refinable: &RefinableMesh, stride: usize, sample_count: usize) {
    let certain = certify_collapses(refinable);
    assert_eq!(certain.mesh, refinable.mesh);
    assert_eq!(certain.sequence.targets(), refinable.sequence.targets());
    for split_count in (0..refinable.sequence.step_count()).step_by(stride) {
        let found = measured(&refinable.mesh, &replay(refinable, split_count), sample_count);
        let error = certain.sequence.error_at(split_count);
        assert!(found <= above(error, &refinable.mesh), "level {split_count}: {found} of at most {error}");
    }
}

/// Checks random sets of steps, each with everything that it depends on.
fn errors_hold_for_random_sets(refinable: &RefinableMesh, count: usize, sample_count: usize) {
    let fragmented = FragmentedMesh::from_collapses(refinable);
    let CertifiedFaces { fragmented: certain, face_errors } = certify_faces(&fragmented);
    assert!(certain == certify(&fragmented));
    let fragments = &certain.fragments;
    for step in 0..fragments.step_count() as u32 {
        let of_faces = fragments.floor(step).iter().map(|&face| face_errors[face as usize]);
        assert!(
            fragments.floor(step).is_empty() || of_faces.fold(0.0, f32::max) == fragments.floor_error(step)
        );
    }
    let collapses = certify_collapses_in_any_state(refinable);
    assert_eq!(collapses.sequence.errors(), fragments.levels().errors());
    let replaced_by = fragments.replacing_steps();
    let mut random = Random::new(7);
    for i in 0..count {
        let selected = random_selection(fragments, &mut random, 5 + 90 * i as u32 / count as u32);
        let faces = fragment_faces(fragments, |step| selected[step as usize]);
        // The errors of single faces are not larger than those of floors.
        let mut error = 0f32;
        for &face in &faces {
            let step = replaced_by[face as usize];
            if step != FragmentSequence::NO_STEP {
                assert!(face_errors[face as usize] <= fragments.floor_error(step));
            }
            error = error.max(face_errors[face as usize]);
        }
        for step in (0..selected.len() as u32).filter(|&step| !selected[step as usize]) {
            // A surface that vanishes leaves no face that could carry its error.
            if fragments.floor(step).is_empty() {
                error = error.max(fragments.floor_error(step));
            }
        }
        let triangles = faces.iter().map(|&face| fragments.faces()[face as usize].corners).collect();
        let state = IndexedMesh::new(certain.mesh.positions.clone(), triangles);
        let found = measured(&certain.mesh, &state, sample_count);
        assert!(found <= above(error, &certain.mesh), "selection {i}: {found} of at most {error}");
    }
}

/// Selects about `percent` of 100 steps, and everything that they depend on.
fn random_selection(fragments: &FragmentSequence, random: &mut Random, percent: u32) -> Vec<bool> {
    let mut selected = vec![false; fragments.step_count()];
    // Selects whole regions instead of single steps: a step is wanted if the index of its vertex says so.
    let block = 1 + random.below(40);
    let salt = random.next_u64();
    for step in (0..selected.len() as u32).rev() {
        let wanted = Random::new(salt ^ u64::from(step / block)).below(100) < percent;
        if wanted || selected[step as usize] {
            selected[step as usize] = true;
            for &face in fragments.floor(step) {
                if let Some(creating_step) = fragments.creating_step(face) {
                    selected[creating_step as usize] = true;
                }
            }
        }
    }
    selected
}

fn all_errors_hold(case: &Case) {
    let levels = case.refinable.sequence.step_count().div_ceil(12).max(1);
    errors_hold_at_levels(&case.refinable, case.stride.max(levels), 300);
    errors_hold_for_random_sets(&case.refinable, 4, 300);
}

#[test]
fn errors_hold_for_all_kinds_of_meshes_in_random_order() {
    let cases = nasty_cases().chain(surface_cases()).chain(seam_cases()).chain(hub_cases().take(3));
    cases.for_each(|case| all_errors_hold(&case));
}

proptest! {
    #![proptest_config(striata_testing::cases(100))]

    #[test]
    fn errors_hold_for_soups(case in soups()) {
        all_errors_hold(&case);
    }

    #[test]
    fn errors_hold_for_assets(pieces in 1usize..4, seed: u64, cost in 0..CostFunction::ALL.len()) {
        let mesh = meshes::asset(pieces, seed);
        let options = meshes::random_options(&mesh, seed, cost);
        let refinable = build_sequence(&mesh, &options).unwrap().refinable;
        all_errors_hold(&Case { stride: 1, seed, refinable });
    }

    #[test]
    fn errors_hold_for_random_triangles(count in 1u32..60, seed in any::<u64>(), far_percent in 0usize..60) {
        let mesh = shapes::random_soup(count, seed);
        let sequence_options = RandomSequenceOptions { far_percent, base_position_count: 1 };
        let refinable = random_refinable(&mesh, sequence_options, &mut support::Random::new(seed));
        errors_hold_at_levels(&refinable, 1 + count as usize / 10, 500);
    }
}

/// A sphere with dents and noise, like a scan.
fn rough_sphere() -> IndexedMesh {
    let mut mesh = shapes::icosphere(4, 1.0);
    let mut random = Random::new(11);
    for p in &mut mesh.positions {
        let [x, y, z] = *p;
        let height = 1.0 + 0.1 * (5.0 * x).min(1.0) * (4.0 * y).max(-1.0) * z + random.between(-0.01, 0.01);
        *p = [x * height, y * height, z * height];
    }
    mesh
}

fn surfaces() -> Vec<(&'static str, IndexedMesh)> {
    vec![
        ("torus", shapes::torus(48, 24, 1.0, 0.4)),
        ("terrain", shapes::terrain(33, 3)),
        ("rough sphere", rough_sphere()),
        ("Klein bottle", shapes::klein_bottle(40, 24)),
        ("seams", shapes::uv_cylinder(24, 12)),
        ("hard edges", shapes::hard_cube()),
    ]
}

fn quadric_sequence(mesh: &IndexedMesh) -> RefinableMesh {
    build_sequence(mesh, &SequenceOptions::default()).unwrap().refinable
}

#[test]
fn errors_hold_for_surfaces_in_cost_order() {
    for (name, mesh) in surfaces() {
        eprintln!("{name}");
        let refinable = quadric_sequence(&mesh);
        errors_hold_at_levels(&refinable, 1 + refinable.sequence.step_count() / 12, 20_000);
        errors_hold_for_random_sets(&refinable, 8, 20_000);
    }
}

#[test]
fn errors_hold_for_surfaces_in_random_order() {
    for (name, mesh) in surfaces() {
        eprintln!("{name}");
        for far_percent in [0, 2] {
            let sequence_options = RandomSequenceOptions { far_percent, base_position_count: 4 };
            let refinable = random_refinable(&mesh, sequence_options, &mut support::Random::new(3));
            errors_hold_at_levels(&refinable, 1 + refinable.sequence.step_count() / 8, 10_000);
        }
    }
}

/// Far from the origin, and at scales where squares in f32 would become 0 or infinite.
#[test]
fn errors_hold_at_any_scale_and_position() {
    for (scale, shift) in [(1e-25f32, 0.0), (1e25, 0.0), (1.0, 1e5)] {
        let mut mesh = rough_sphere();
        for x in mesh.positions.iter_mut().flatten() {
            *x = *x * scale + shift;
        }
        let sequence_options = RandomSequenceOptions { far_percent: 0, base_position_count: 4 };
        let refinable = random_refinable(&mesh, sequence_options, &mut support::Random::new(1));
        errors_hold_at_levels(&refinable, 1 + refinable.sequence.step_count() / 8, 5_000);
    }
}

#[test]
fn flat_surfaces_have_exact_errors() {
    let mut cube = shapes::cube();
    for _ in 0..3 {
        cube = split_in_four(&cube);
    }
    for (name, mesh, triangle_count) in [("grid", shapes::grid(24, 24), 2), ("cube", cube, 12)] {
        let refinable = quadric_sequence(&mesh);
        let certain = certify_collapses(&refinable);
        let level = certain.sequence.split_count_for_triangles(triangle_count);
        assert!(certain.sequence.triangle_count_at(level) <= triangle_count, "{name}");
        let error = f64::from(certain.sequence.error_at(level)) / mesh.diagonal();
        assert!(error <= 1e-9, "{name}: {error} of the diagonal");
    }
}

/// Subdivides each triangle into four.
fn split_in_four(mesh: &IndexedMesh) -> IndexedMesh {
    let mut positions = Vec::new();
    let mut triangles = Vec::new();
    for t in &mesh.triangles {
        let [a, b, c] = t.map(|v| mesh.positions[v as usize]);
        let middle = |p: [f32; 3], q: [f32; 3]| [0, 1, 2].map(|axis| 0.5 * (p[axis] + q[axis]));
        let [d, e, f] = [middle(a, b), middle(b, c), middle(c, a)];
        for corners in [[a, d, f], [d, b, e], [f, e, c], [d, e, f]] {
            let first = positions.len() as u32;
            positions.extend(corners);
            triangles.push([first, first + 1, first + 2]);
        }
    }
    IndexedMesh::new(positions, triangles)
}

/// Bounds that are valid but loose would pass all other tests.
#[test]
fn bounds_are_tight() {
    let mut ratios = Vec::new();
    for (name, mesh) in surfaces().into_iter().take(4) {
        let refinable = quadric_sequence(&mesh);
        let certain = certify_collapses(&refinable);
        for percent in [75, 50, 25, 10, 5] {
            let level = certain.sequence.split_count_for_triangles(mesh.triangle_count() * percent / 100);
            let found = measured(&refinable.mesh, &replay(&refinable, level), 100_000);
            let ratio = f64::from(certain.sequence.error_at(level)) / found;
            assert!(ratio < 2.0, "{name} at {percent} %: {ratio}");
            ratios.push(ratio);
        }
    }
    ratios.sort_by(f64::total_cmp);
    assert!(ratios[ratios.len() / 2] < 1.15, "{ratios:?}");
}

#[test]
fn certifying_can_be_cancelled() {
    let fragmented = FragmentedMesh::from_collapses(&quadric_sequence(&shapes::torus(64, 32, 1.0, 0.4)));
    let mut calls = 0;
    let result = certify_with_progress(&fragmented, &mut |progress| {
        calls += 1;
        assert_eq!(progress.phase, "certify");
        if progress.done > 0 { std::ops::ControlFlow::Break(()) } else { std::ops::ControlFlow::Continue(()) }
    });
    assert_eq!((result, calls), (Err(Cancelled), 2));
    let whole = certify(&fragmented);
    let level = fragmented.fragments.step_count() / 2;
    assert_eq!(replay_fragments(&whole, level), replay_fragments(&fragmented, level));
}
