//! Repaired strips compared with the oracle: same triangles at every level, no loops, links as in a new
//! dual graph.

use striata_testing::{meshes, support};

use proptest::prelude::*;
use striata::mesh::{DualGraph, RefinableMesh, canonical_triangles, replay, shapes};
use striata::simplify::{SequenceOptions, build_sequence};
use striata::strip::StripSet;
use striata_strip::{LiveStrips, LiveStripsError, RepairGoal, RepairOptions, StripOptions, stripify};
use support::{Random, RandomSequenceOptions, grid, nasty, random_refinable, soup, with_seams_and_groups};

const GOALS: [RepairGoal; 2] = [RepairGoal::FewestIndices, RepairGoal::FewestStrips];

fn goal(goal: RepairGoal) -> RepairOptions {
    RepairOptions::default().with_goal(goal)
}

fn at_level<'a>(refinable: &'a RefinableMesh, split_count: usize, options: &RepairOptions) -> LiveStrips<'a> {
    let strips = stripify(&replay(refinable, split_count), &StripOptions::default()).unwrap();
    LiveStrips::new(refinable, split_count, &strips, options).unwrap()
}

fn check_level(refinable: &RefinableMesh, live: &LiveStrips<'_>) {
    let level = replay(refinable, live.split_count());
    let strips = live.to_strip_set();
    assert_eq!(live.triangle_count(), level.triangle_count());
    assert_eq!(strips.group_count(), level.groups_or_whole().len());
    for (g, group) in level.groups_or_whole().into_iter().enumerate() {
        let mut found = Vec::new();
        for strip in strips.group_strips(g) {
            found.extend(striata::strip::strip_triangles(strips.strip(strip)));
        }
        let expected = canonical_triangles(&level.triangles[group.range()]);
        assert_eq!(canonical_triangles(&found), expected, "group {g} at {}", live.split_count());
    }
    // A loop would be cut into an additional strip when strips are written.
    assert_eq!(live.strip_count(), strips.strip_count());
    let mut triangles = Vec::new();
    live.triangles_into(&mut triangles);
    assert_eq!(canonical_triangles(&triangles), canonical_triangles(&level.triangles));
    assert_eq!(
        live.link_count(),
        DualGraph::of_vertices(&level).link_count(),
        "links at {}",
        live.split_count()
    );
}

/// Moves down to the base and up again, from the full mesh and from the base, and checks every level.
fn check_all_levels(refinable: &RefinableMesh, options: &RepairOptions, stride: usize) {
    let step_count = refinable.sequence.step_count();
    let mut live = at_level(refinable, step_count, options);
    check_level(refinable, &live);
    let down = (0..step_count).rev().step_by(stride);
    for split_count in down.clone() {
        let report = live.move_to(split_count);
        assert!(report.collapse_count <= stride && report.split_count == 0);
        check_level(refinable, &live);
    }
    for split_count in down.rev().chain([step_count]) {
        live.move_to(split_count);
        check_level(refinable, &live);
    }
    let mut live = at_level(refinable, 0, options);
    check_level(refinable, &live);
    live.move_to(step_count);
    check_level(refinable, &live);
}

#[test]
fn degenerate_meshes_follow_the_oracle_at_every_level() {
    let shapes = meshes::nasty().into_iter().filter(|(_, mesh)| mesh.check().is_ok());
    for (name, mesh) in nasty().into_iter().chain(shapes) {
        for seed in 0..4 {
            let sequence_options =
                RandomSequenceOptions { far_percent: (seed as usize % 3) * 30, base_position_count: 1 };
            let refinable = random_refinable(&mesh, sequence_options, &mut Random::new(seed));
            eprintln!("{name}, seed {seed}");
            let stride = 1 + refinable.sequence.step_count() / 200;
            for aim in GOALS {
                check_all_levels(&refinable, &goal(aim), stride);
            }
        }
    }
}

#[test]
fn surfaces_follow_the_oracle() {
    for (mesh, stride) in [(grid(12, false), 1), (grid(14, true), 1), (grid(60, true), 97)] {
        for seed in 0..3 {
            let sequence_options =
                RandomSequenceOptions { far_percent: seed as usize * 4, base_position_count: 4 };
            let refinable = random_refinable(&mesh, sequence_options, &mut Random::new(seed));
            for aim in GOALS {
                check_all_levels(&refinable, &goal(aim), stride);
            }
        }
    }
}

#[test]
fn seams_and_groups_follow_the_oracle() {
    for seed in 0..4 {
        let mesh = with_seams_and_groups(grid(9, seed % 2 == 0));
        let sequence_options = RandomSequenceOptions { far_percent: 5, base_position_count: 3 };
        let refinable = random_refinable(&mesh, sequence_options, &mut Random::new(seed));
        for aim in GOALS {
            check_all_levels(&refinable, &goal(aim), 1);
        }
    }
}

fn simplified(mesh: &striata::mesh::IndexedMesh) -> RefinableMesh {
    build_sequence(mesh, &SequenceOptions::default()).unwrap().refinable
}

#[test]
fn simplified_shapes_follow_the_oracle() {
    let meshes = [
        shapes::icosphere(3, 1.0),
        shapes::torus(18, 11, 2.0, 1.0),
        shapes::klein_bottle(12, 9),
        shapes::two_material_sphere(10, 16),
        shapes::uv_cylinder(20, 9),
    ];
    for mesh in meshes {
        let refinable = simplified(&mesh);
        for aim in GOALS {
            check_all_levels(&refinable, &goal(aim), 7);
        }
    }
}

/// Number of indices of the current level, including restarts.
fn index_count(live: &LiveStrips<'_>) -> usize {
    live.to_strip_set().cost().index_count
}

#[test]
fn repaired_strips_cost_little_more_than_new_ones() {
    for mesh in [shapes::terrain(40, 3), shapes::icosphere(4, 1.0), shapes::torus(40, 30, 2.0, 1.0)] {
        let refinable = simplified(&mesh);
        let step_count = refinable.sequence.step_count();
        let mut indices = at_level(&refinable, step_count, &goal(RepairGoal::FewestIndices));
        let mut strips = at_level(&refinable, step_count, &goal(RepairGoal::FewestStrips));
        let mut carried = at_level(&refinable, step_count, &RepairOptions::default().with_tunnel_length(0));
        for percent in [50, 25, 10] {
            let triangle_count = mesh.triangle_count() * percent / 100;
            let split_count = refinable.sequence.split_count_for_triangles(triangle_count);
            let anew = at_level(&refinable, split_count, &RepairOptions::default());
            let reports = [&mut indices, &mut strips, &mut carried].map(|live| live.move_to(split_count));
            assert!(index_count(&indices) < index_count(&anew), "{percent} %");
            assert!(index_count(&indices) < index_count(&strips), "{percent} %");
            assert!(strips.strip_count() < indices.strip_count(), "{percent} %");
            assert!(strips.strip_count() < anew.strip_count(), "{percent} %");
            assert!(20 * index_count(&indices) < 19 * index_count(&carried), "{percent} %");
            assert!(reports[0].tunnel_count > 0 && reports[1].tunnel_count > 0);
            assert_eq!(reports[2].tunnel_count, 0);
        }
    }
}

#[test]
fn links_and_steps_are_reported() {
    let refinable = simplified(&shapes::torus(18, 11, 2.0, 1.0));
    let step_count = refinable.sequence.step_count();
    for aim in GOALS {
        let mut live = at_level(&refinable, step_count, &goal(aim));
        for split_count in [step_count / 2, 0, step_count / 3, step_count] {
            let (from, solid) = (live.split_count(), live.triangle_count() - live.strip_count());
            let report = live.move_to(split_count);
            assert_eq!(report.collapse_count, from.saturating_sub(split_count));
            assert_eq!(report.split_count, split_count.saturating_sub(from));
            assert_eq!(
                live.triangle_count() - live.strip_count(),
                solid + report.joined_count - report.cut_count
            );
            // The star of a position and the triangles around it, not the whole mesh.
            let limit = 40 * (report.collapse_count + report.split_count);
            assert!(report.touched_count > 0 && report.touched_count < limit);
        }
        assert_eq!(live.move_to(step_count), Default::default());
    }
}

#[test]
fn equal_paths_give_equal_strips() {
    let refinable = simplified(&shapes::terrain(20, 5));
    let step_count = refinable.sequence.step_count();
    let way = |levels: &[usize]| {
        let mut live = at_level(&refinable, step_count, &RepairOptions::default());
        levels.iter().for_each(|&split_count| {
            live.move_to(split_count);
        });
        live.to_strip_set()
    };
    assert_eq!(way(&[0, step_count / 2]), way(&[step_count / 3, 0, step_count / 2]));
}

#[test]
fn mismatched_strips_and_meshes_are_refused() {
    let refinable = simplified(&with_seams_and_groups(grid(4, false)));
    let step_count = refinable.sequence.step_count();
    let options = RepairOptions::default();
    let error = |split_count, strips: &StripSet| {
        LiveStrips::new(&refinable, split_count, strips, &options).unwrap_err()
    };
    let strips = stripify(&refinable.mesh, &StripOptions::default()).unwrap();
    let found = step_count + 1;
    assert_eq!(error(found, &strips), LiveStripsError::SplitCount { found, step_count });
    assert_eq!(error(step_count, &StripSet::new()), LiveStripsError::GroupCount { found: 0, expected: 3 });
    assert!(matches!(error(0, &strips), LiveStripsError::Triangle { split_count: 0, .. }));

    let one = canonical_triangles(&refinable.mesh.triangles[..1])[0];
    let mut twice = StripSet::new();
    twice.push(&refinable.mesh.triangles[0]);
    twice.push(&refinable.mesh.triangles[0]);
    (0..3).for_each(|_| twice.end_group());
    let expected = LiveStripsError::Triangle { strip: 1, triangle: one, split_count: step_count };
    assert_eq!(error(step_count, &twice), expected);
    let mut lacking = StripSet::new();
    lacking.push(&refinable.mesh.triangles[0]);
    (0..3).for_each(|_| lacking.end_group());
    let expected = refinable.mesh.groups[0].count as usize;
    let expected = LiveStripsError::TriangleCount { group: 0, found: 1, expected, split_count: step_count };
    assert_eq!(error(step_count, &lacking), expected);
    let mut unknown = StripSet::new();
    unknown.push(&[0, 1, u32::MAX]);
    (0..3).for_each(|_| unknown.end_group());
    assert!(matches!(error(step_count, &unknown), LiveStripsError::Triangle { strip: 0, .. }));

    let mut longer = refinable.clone();
    longer.mesh.positions.push([0.0; 3]);
    let error = LiveStrips::new(&longer, 0, &strips, &options).unwrap_err();
    assert!(matches!(error, LiveStripsError::Mesh(_) | LiveStripsError::VertexCount { .. }), "{error}");
    let mut broken = refinable.clone();
    broken.mesh.triangles[0][0] = u32::MAX;
    let error = LiveStrips::new(&broken, 0, &strips, &options).unwrap_err();
    assert!(matches!(error, LiveStripsError::Mesh(_)), "{error}");
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..striata_testing::cases(96) })]

    #[test]
    fn random_meshes_follow_the_oracle_at_every_level(
        seed in any::<u64>(),
        vertex_count in 3usize..30,
        triangle_count in 0usize..60,
        far_percent in 0usize..60,
        has_seams in any::<bool>(),
        tunnel_length in 0u32..12,
        walk_limit in 0u32..20,
        search_limit in 0u32..40,
        reach in 0u32..3,
        aim in 0usize..2,
    ) {
        let mut random = Random::new(seed);
        let mut mesh = soup(vertex_count, triangle_count, &mut random);
        if has_seams {
            mesh = with_seams_and_groups(mesh);
        }
        let sequence_options = RandomSequenceOptions { far_percent, base_position_count: 1 };
        let options = goal(GOALS[aim])
            .with_tunnel_length(tunnel_length)
            .with_walk_limit(walk_limit)
            .with_search_limit(search_limit)
            .with_reach(reach);
        check_all_levels(&random_refinable(&mesh, sequence_options, &mut random), &options, 1);
    }

    #[test]
    fn any_walk_between_levels_matches_the_oracle(
        seed in any::<u64>(),
        jumps in prop::collection::vec(0.0f64..=1.0, 1..20),
        aim in 0usize..2,
    ) {
        let sequence_options = RandomSequenceOptions { far_percent: 3, base_position_count: 4 };
        let refinable = random_refinable(&grid(16, true), sequence_options, &mut Random::new(seed));
        let step_count = refinable.sequence.step_count();
        let mut live = at_level(&refinable, step_count / 2, &goal(GOALS[aim]));
        for jump in jumps {
            live.move_to((jump * step_count as f64) as usize);
            check_level(&refinable, &live);
        }
    }
}
