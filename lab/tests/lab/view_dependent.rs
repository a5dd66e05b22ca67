//! View-dependent progressive meshes against the oracle: uniform levels, and fronts chosen by criteria.

use striata_testing::support;

use std::cell::Cell;

use striata::mesh::{
    CollapseSequence, IndexedMesh, PositionIndex, RefinableMesh, SequenceParts, canonical_triangles, shapes,
};
use striata::model::{LodModel, PartRecord};
use striata::simplify::{SequenceOptions, TopologyRule, build_sequence};
use striata::view::{Camera, Criterion, NormalCone, Part, ScreenError, Sphere, Verdict};
use striata_lab::baseline::{ViewDependentError, ViewDependentMeshes, ViewDependentState};
use striata_lab::{Accounting, PaperBytes};
use support::{Random, follows_the_oracle, grid, nasty_cases, seam_cases, with_seams_and_groups};

/// Collapses random edges as long as the surface stays manifold, by brute force over all triangles.
fn random_manifold(mesh: &IndexedMesh, random: &mut Random) -> RefinableMesh {
    let vertex_count = mesh.vertex_count();
    let mut triangles = mesh.triangles.clone();
    let mut is_active = vec![true; vertex_count];
    let (mut removed, mut removed_counts) = (Vec::new(), Vec::new());
    let mut misses = 0;
    while misses < 400 && !triangles.is_empty() {
        let triangle = triangles[random.below(triangles.len())];
        let turn = random.below(3);
        let [target, vertex] = [triangle[turn], triangle[(turn + 1 + random.below(2)) % 3]];
        if !can_collapse(&triangles, vertex, target) {
            misses += 1;
            continue;
        }
        misses = 0;
        let before = triangles.len();
        triangles.retain(|t| !(t.contains(&vertex) && t.contains(&target)));
        triangles.as_flattened_mut().iter_mut().filter(|v| **v == vertex).for_each(|v| *v = target);
        removed.push((vertex, target));
        removed_counts.push((before - triangles.len()) as u8);
        is_active[vertex as usize] = false;
    }
    removed.reverse();
    removed_counts.reverse();
    let base = (0..vertex_count as u32).filter(|&v| is_active[v as usize]);
    let order: Vec<u32> = base.chain(removed.iter().map(|r| r.0)).collect();
    let mut new_index = vec![0; vertex_count];
    (0..).zip(&order).for_each(|(new, &old)| new_index[old as usize] = new);
    let step_count = removed.len();
    let sequence = CollapseSequence::from_parts(SequenceParts {
        positions: PositionIndex::identity(vertex_count),
        base_position_count: vertex_count - step_count,
        targets: removed.iter().map(|r| new_index[r.1 as usize]).collect(),
        errors: (0..step_count).map(|s| (step_count - s) as f32 * 0.25).collect(),
        removed_triangle_counts: removed_counts,
        triangle_count: mesh.triangle_count(),
    })
    .unwrap();
    let mut full = mesh.clone();
    full.positions = order.iter().map(|&v| mesh.positions[v as usize]).collect();
    full.triangles = mesh.triangles.iter().map(|t| t.map(|v| new_index[v as usize])).collect();
    RefinableMesh { mesh: full, sequence }
}

/// Checks the link condition, and that no triangle remains attached by one edge or has a duplicate.
fn can_collapse(triangles: &[[u32; 3]], vertex: u32, target: u32) -> bool {
    let neighbors = |v: u32| {
        let of_v = triangles.iter().filter(|t| t.contains(&v));
        let mut all: Vec<u32> = of_v.flatten().copied().filter(|&other| other != v).collect();
        all.sort_unstable();
        all
    };
    // An inner neighbor is in two triangles, one along a border is in one.
    let is_border = |all: &[u32]| all.chunk_by(|a, b| a == b).any(|same| same.len() == 1);
    let [mut around, mut around_target] = [vertex, target].map(neighbors);
    let shared_count = around.iter().filter(|&&v| v == target).count();
    if shared_count == 2 && is_border(&around) && is_border(&around_target) {
        return false;
    }
    around.dedup();
    around_target.dedup();
    let common: Vec<u32> = around.into_iter().filter(|v| around_target.contains(v)).collect();
    let valence = |v: u32| triangles.iter().filter(|t| t.contains(&v)).count();
    common.len() == shared_count && common.iter().all(|&tip| valence(tip) > shared_count.max(2))
}

/// Surfaces without and with borders, one of them with holes, with random and with error-driven sequences.
fn cases() -> impl Iterator<Item = (u64, RefinableMesh)> {
    let mut holed = grid(9, false);
    holed.triangles.retain(|t| !t.contains(&34) && !t.contains(&66));
    let meshes = [
        grid(8, true),
        grid(9, false),
        holed,
        shapes::icosphere(2, 1.0),
        shapes::terrain(12, 3),
        shapes::torus(9, 7, 2.0, 1.0),
    ];
    meshes.into_iter().flat_map(|mesh| {
        // The model supports manifolds only.
        let options = SequenceOptions::default().with_topology(TopologyRule::Keep);
        let tame = build_sequence(&mesh, &options).unwrap();
        let wild = (1..6).map(move |seed| (seed, random_manifold(&mesh, &mut Random::new(seed))));
        wild.chain([(0, tame.refinable)])
    })
}

/// Checks that every corner follows its targets to the first active vertex.
fn shows_its_front(refinable: &RefinableMesh, state: &ViewDependentState) {
    let shown = |mut v: u32| {
        while !state.is_active(v) {
            v = refinable.sequence.target(v);
        }
        v
    };
    let proper = |t: &[u32; 3]| t[0] != t[1] && t[1] != t[2] && t[2] != t[0];
    let expected: Vec<[u32; 3]> =
        refinable.mesh.triangles.iter().map(|t| t.map(shown)).filter(proper).collect();
    assert_eq!(canonical_triangles(state.triangles()), canonical_triangles(&expected));
}

fn hash(part: &Part, seed: u64) -> u64 {
    let [x, y, z] = part.sphere.center.map(|x| u64::from(x.to_bits()));
    let mixed = (x ^ y.rotate_left(21) ^ z.rotate_left(42) ^ u64::from(part.error.to_bits()) << 7 ^ seed)
        .wrapping_mul(0x9E37_79B9_7F4A_7C15);
    (mixed ^ mixed >> 29).wrapping_mul(0xBF58_476D_1CE4_E5B9) >> 40
}

/// A criterion that requires some percentage of all parts, independently of their position.
fn scattered(percent: u64, seed: u64) -> impl Fn(&Part) -> f32 {
    move |part| if hash(part, seed) % 100 < percent { 2.0 } else { 0.0 }
}

/// A criterion that requires parts that are near an eye and have large errors; a part weighs at least as
/// much as any part within it.
fn near(eye: [f32; 3], strength: f32) -> impl Fn(&Part) -> f32 {
    move |part| {
        let to = [0, 1, 2].map(|i| part.sphere.center[i] - eye[i]);
        let distance = to.iter().map(|d| d * d).sum::<f32>().sqrt() - part.sphere.radius;
        strength * part.error / distance.max(1e-6)
    }
}

#[test]
fn surfaces_follow_the_oracle() {
    for (_, refinable) in cases() {
        let model = ViewDependentMeshes::build(&refinable).unwrap();
        assert!(model.step_count() > 20, "only {} steps", model.step_count());
        follows_the_oracle(&refinable, &model, 1);
    }
}

#[test]
fn fronts_of_criteria_follow_the_oracle() {
    let mut changes = 0;
    for (seed, refinable) in cases() {
        let model = ViewDependentMeshes::build(&refinable).unwrap();
        let mut random = Random::new(seed + 70);
        let mut state = model.base_state();
        for round in 0..40 {
            let adapted = if round % 2 == 0 {
                let criterion = scattered([3, 20, 60, 97][random.below(4)], random.below(1 << 20) as u64);
                let adapted = model.adapt(&mut state, &criterion);
                assert_eq!(model.adapt(&mut state, &criterion).change_count(), 0, "something was left to do");
                adapted
            } else {
                let eye = refinable.mesh.positions[random.below(refinable.mesh.vertex_count())];
                let criterion = near(eye, [0.02, 0.1, 0.5, 3.0][random.below(4)]);
                let adapted = model.adapt(&mut state, &criterion);
                assert_eq!(model.adapt(&mut state, &criterion).change_count(), 0, "something was left to do");
                adapted
            };
            changes += adapted.change_count();
            shows_its_front(&refinable, &state);
            let mut indices = vec![7];
            model.indices_into(&state, &mut indices);
            assert_eq!(indices[1..], *state.triangles().as_flattened());
            assert_eq!(model.draw_counts(&state).index_count, indices.len() - 1);
        }
    }
    assert!(changes > 10_000, "only {changes} changes were tried");
}

#[test]
fn requiring_all_or_nothing_gives_the_full_mesh_or_the_base() {
    for (seed, refinable) in cases() {
        let model = ViewDependentMeshes::build(&refinable).unwrap();
        let mut state = model.base_state();
        for round in 0..4 {
            model.adapt(&mut state, &scattered(40, seed + round));
            let adapted = model.adapt(&mut state, &|_: &Part| 2.0);
            assert!(adapted.collapse_count == 0 && state == model.new_state());
            model.adapt(&mut state, &scattered(40, seed + 9 + round));
            let before = model.split_count(&state);
            let adapted = model.adapt(&mut state, &|_: &Part| 0.0);
            assert_eq!([adapted.split_count, adapted.collapse_count], [0, before]);
            assert!(state == model.base_state());
        }
    }
}

/// The front does not depend on previous views: only required vertices and their prerequisites are refined.
#[test]
fn fronts_do_not_depend_on_previous_views() {
    for (seed, refinable) in cases() {
        let model = ViewDependentMeshes::build(&refinable).unwrap();
        let mut random = Random::new(seed + 5);
        let mut walked = model.new_state();
        for _ in 0..12 {
            let eye = refinable.mesh.positions[random.below(refinable.mesh.vertex_count())];
            let criterion = near(eye, [0.02, 0.1, 0.5][random.below(3)]);
            model.adapt(&mut walked, &criterion);
            let mut fresh = model.base_state();
            model.adapt(&mut fresh, &criterion);
            assert!(walked == fresh);
        }
    }
}

/// Verdicts that are still valid are not evaluated again, which does not change the result.
#[test]
fn incremental_adaptation_agrees_with_full_adaptation() {
    for (_, refinable) in cases() {
        let model = ViewDependentMeshes::build(&refinable).unwrap();
        let mesh = &refinable.mesh;
        let far = mesh.positions.iter().flatten().fold(0.0f32, |far, &x| far.max(x.abs()));
        let whole = Sphere { center: [0.0; 3], radius: 4.0 * far };
        let (mut followed, mut fresh) = (model.base_state(), model.base_state());
        let mut last: Option<ScreenError> = None;
        let (evaluation_count, fresh_evaluation_count) = (Cell::new(0), Cell::new(0));
        for frame in 0..150 {
            let (turn, near) = (frame as f32 * 0.02, 1.2 + (frame as f32 * 0.05).sin());
            let eye = [turn.cos() * near * far, 0.4 * far, turn.sin() * near * far];
            let camera = Camera::new(eye, [0.0; 3], [0.0, 1.0, 0.0], 0.577, [600, 600]).unwrap();
            let criterion = ScreenError::new(camera, 40.0).with_model_bounds(whole);
            if frame % 50 == 40 {
                model.move_to(&mut followed, model.step_count() / 3);
                model.move_to(&mut fresh, model.step_count() / 3);
            }
            let motion = last.as_ref().map_or(f32::INFINITY, |last| criterion.motion_since(last));
            model.adapt_after(&mut followed, &Counted(&criterion, &evaluation_count), motion);
            model.adapt(&mut fresh, &Counted(&criterion, &fresh_evaluation_count));
            assert!(followed == fresh, "another front in frame {frame}");
            shows_its_front(&refinable, &followed);
            last = Some(criterion);
        }
        let (evaluation_count, fresh_evaluation_count) =
            (evaluation_count.get(), fresh_evaluation_count.get());
        assert!(
            4 * evaluation_count < 3 * fresh_evaluation_count,
            "{evaluation_count} evaluations instead of {fresh_evaluation_count}"
        );
    }
}

/// Sums of motion lose precision after a long journey; later verdicts must still be exact.
#[test]
fn long_journeys_do_not_extend_verdicts() {
    let mesh = shapes::icosphere(4, 1.0);
    let options = SequenceOptions::default().with_topology(TopologyRule::Keep);
    let refinable = build_sequence(&mesh, &options).unwrap().refinable;
    let model = ViewDependentMeshes::build(&refinable).unwrap();
    let see = |eye: [f32; 3]| {
        let camera = Camera::new(eye, [0.0; 3], [0.0, 1.0, 0.0], 0.5, [1000, 1000]).unwrap();
        ScreenError::new(camera, 1.0).with_model_bounds(Sphere { center: [0.0; 3], radius: 1.1 })
    };
    let (mut followed, mut fresh) = (model.base_state(), model.base_state());
    for far in [10.0, 1e4, 1e6, 1e8] {
        let mut last = see([far, 0.5, 1.0]);
        model.adapt(&mut followed, &last);
        for frame in 0..100 {
            let criterion = see([3.0 - frame as f32 * 0.01, 0.5, 1.0]);
            model.adapt_after(&mut followed, &criterion, criterion.motion_since(&last));
            model.adapt(&mut fresh, &criterion);
            assert!(followed == fresh, "another front in frame {frame} after {far}");
            last = criterion;
        }
    }
}

/// A criterion that counts its evaluations.
struct Counted<'a>(&'a ScreenError, &'a Cell<usize>);

impl Criterion for Counted<'_> {
    fn weigh(&self, part: &Part) -> Verdict {
        self.1.set(self.1.get() + 1);
        self.0.weigh(part)
    }
}

#[test]
fn uniform_levels_can_be_reached_from_any_front() {
    for (seed, refinable) in cases() {
        let model = ViewDependentMeshes::build(&refinable).unwrap();
        let mut random = Random::new(seed);
        let mut state = model.new_state();
        for _ in 0..12 {
            model.adapt(&mut state, &scattered(30, random.below(1 << 20) as u64));
            let split_count = random.below(model.step_count() + 1);
            model.move_to(&mut state, split_count);
            let mut expected = model.new_state();
            model.move_to(&mut expected, split_count);
            assert!(state == expected, "another level at {split_count}");
        }
    }
}

#[test]
fn parts_enclose_everything_below() {
    let mut narrow_count = 0;
    for (_, refinable) in cases() {
        let model = ViewDependentMeshes::build(&refinable).unwrap();
        let sequence = &refinable.sequence;
        let base = sequence.base_vertex_count();
        for step in 0..model.step_count() {
            let part = model.part(step);
            // Packing rounds up.
            let error = sequence.error_at(step);
            assert!(part.error >= error && part.error <= 1.005 * error + 1e-30);
            // Below a step are all vertices that collapse into the restored one, and the triangles around
            // them.
            let restored = (base + step) as u32;
            let is_below = |&&v: &&u32| {
                let mut v = v;
                while v > restored {
                    v = sequence.target(v);
                }
                v == restored
            };
            for triangle in refinable.mesh.triangles.iter().filter(|t| t.iter().any(|v| is_below(&v))) {
                let corners = triangle.map(|v| refinable.mesh.positions[v as usize]);
                assert!(corners.iter().all(|&p| part.sphere.contains(p)), "step {step}");
                let normal = NormalCone::of_triangles([corners].into_iter());
                assert!(normal == NormalCone::ALL || part.cone.contains(normal.axis), "step {step}");
                narrow_count += usize::from(part.cone.cos > 0.5);
            }
        }
    }
    assert!(narrow_count > 1000, "only {narrow_count} cones are narrow");
}

#[test]
fn groups_are_separated() {
    let mut mesh = grid(8, true);
    let groups = with_seams_and_groups(grid(8, true)).groups;
    mesh.groups = groups;
    let refinable = random_manifold(&mesh, &mut Random::new(4));
    let model = ViewDependentMeshes::build(&refinable).unwrap();
    follows_the_oracle(&refinable, &model, 1);
}

#[test]
fn non_manifold_meshes_are_rejected() {
    let mut rejected = 0;
    for case in nasty_cases().chain(seam_cases()) {
        // Models that are not rejected must be right.
        match ViewDependentMeshes::build(&case.refinable) {
            Ok(model) => follows_the_oracle(&case.refinable, &model, 1),
            Err(_) => rejected += 1,
        }
    }
    assert!(rejected > 40, "{rejected} of them are rejected");
    let one_step = |triangles: &[[u32; 3]], vertex_count: usize, removed: u8| {
        let positions = (0..vertex_count).map(|i| [i as f32, (i * i % 5) as f32, 0.5]).collect();
        let sequence = CollapseSequence::from_parts(SequenceParts {
            positions: PositionIndex::identity(vertex_count),
            base_position_count: vertex_count - 1,
            targets: vec![0],
            errors: vec![1.0],
            removed_triangle_counts: vec![removed],
            triangle_count: triangles.len(),
        });
        let mesh = IndexedMesh::new(positions, triangles.to_vec());
        ViewDependentMeshes::build(&RefinableMesh { mesh, sequence: sequence.unwrap() }).unwrap_err()
    };
    assert_eq!(
        one_step(&[[0, 1, 2], [1, 0, 3], [0, 1, 4]], 5, 0),
        ViewDependentError::Edge { ends: [0, 1], triangle_count: 3 }
    );
    assert_eq!(
        one_step(&[[0, 1, 2], [0, 1, 3]], 4, 1).to_string(),
        "the edge of vertices 0 and 1 has 2 triangles that do not form a manifold surface"
    );
    let reason_of = |error: ViewDependentError| match error {
        ViewDependentError::Step { step: 0, target: 0, reason, .. } => reason,
        other => panic!("{other:?}"),
    };
    let bow_tie = [[0, 1, 4], [4, 2, 3]];
    assert_eq!(reason_of(one_step(&bow_tie, 5, 1)), "the triangles of the vertex are not one fan");
    let far = [[0, 1, 2], [3, 4, 5]];
    assert_eq!(reason_of(one_step(&far, 6, 0)), "no triangle contains both");
    let bridge = [[0, 5, 1], [5, 0, 2], [2, 0, 3], [1, 5, 4]];
    assert_eq!(reason_of(one_step(&bridge, 6, 2)), "both are on borders but their edge is not");
    let tube = [[0, 5, 2], [5, 3, 2], [5, 1, 3], [1, 4, 3], [1, 0, 4], [0, 2, 4]];
    assert_eq!(reason_of(one_step(&tube, 6, 1)), "they have further neighbors in common");
    assert_eq!(reason_of(one_step(&[[0, 1, 2]], 3, 1)), "a triangle vanishes that has no neighbor");
    let seamed = seam_cases().next().unwrap();
    let error = ViewDependentMeshes::build(&seamed.refinable).unwrap_err();
    assert!(matches!(error, ViewDependentError::Seam { vertex_count: 2.., .. }), "{error}");
}

#[test]
fn bytes_match_the_arrays() {
    let refinable = random_manifold(&shapes::icosphere(2, 1.0), &mut Random::new(2));
    let model = ViewDependentMeshes::build(&refinable).unwrap();
    let (steps, base) = (model.step_count(), refinable.sequence.base_vertex_count());
    let base_triangles = refinable.sequence.triangle_count_at(0);
    let bytes: Vec<usize> = model.bytes().iter().map(|part| part.bytes).collect();
    assert_eq!(bytes, [32 * steps, size_of::<PartRecord>() * steps, 28 * base_triangles + 4 * base, 0]);
    // Every step of a closed surface creates two triangles; [Hop97] counts 52 bytes per node and 36 per
    // triangle.
    let expected = 52 * (base + 2 * steps) + 36 * (base_triangles + 2 * steps);
    assert_eq!(model.paper_bytes(Accounting::Words), expected);
    let mut state = model.new_state();
    let maps = 4 * (base + steps) + 4 * (base_triangles + 2 * steps);
    assert_eq!(model.state_bytes(&state), 20 * (base + steps) + 28 * 320 + maps);
    model.move_to(&mut state, 0);
    assert_eq!(model.state_bytes(&state), 20 * base + 28 * base_triangles + maps);
    assert_eq!(model.paper_state_bytes(&state), 112 * base);
}

#[test]
fn empty_meshes_have_nothing_to_adapt() {
    let nothing = support::random_refinable(
        &IndexedMesh::default(),
        support::RandomSequenceOptions { far_percent: 0, base_position_count: 1 },
        &mut Random::new(1),
    );
    let model = ViewDependentMeshes::build(&nothing).unwrap();
    let mut state = model.new_state();
    assert_eq!(model.adapt(&mut state, &|_: &Part| 2.0).change_count(), 0);
    assert!(state.triangles().is_empty() && state == model.base_state());
}
