//! Repaired strips against the oracle: the same triangles at every level, no loop, links as a new dual graph has.

mod support;

use proptest::prelude::*;
use striata::ignore_progress;
use striata::mesh::{DualGraph, RefinableMesh, canonical_triangles, replay, shapes};
use striata::simplify::{SequenceOptions, build_sequence};
use striata::strip::{
    LiveStrips, LiveStripsError, RepairGoal, RepairOptions, RepairReport, StripOptions, StripSet, stripify,
};
use support::{Random, Wildness, grid, nasty, random_refinable, soup, with_seams_and_groups};

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
    // A loop would be cut into a strip of its own when strips are written.
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

/// Down to the base and up again, every level checked, from the full mesh and from the base.
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
fn nasty_meshes_follow_the_oracle_at_every_level() {
    let shapes = shapes::nasty().into_iter().filter(|(_, mesh)| mesh.check().is_ok());
    for (name, mesh) in nasty().into_iter().chain(shapes) {
        for seed in 0..4 {
            let wildness = Wildness { far_percent: (seed as usize % 3) * 30, base_position_count: 1 };
            let refinable = random_refinable(&mesh, wildness, &mut Random::new(seed));
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
            let wildness = Wildness { far_percent: seed as usize * 4, base_position_count: 4 };
            let refinable = random_refinable(&mesh, wildness, &mut Random::new(seed));
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
        let wildness = Wildness { far_percent: 5, base_position_count: 3 };
        let refinable = random_refinable(&mesh, wildness, &mut Random::new(seed));
        for aim in GOALS {
            check_all_levels(&refinable, &goal(aim), 1);
        }
    }
}

fn simplified(mesh: &striata::mesh::IndexedMesh) -> RefinableMesh {
    build_sequence(mesh, &SequenceOptions::default(), &mut ignore_progress).unwrap().refinable
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

proptest! {
    #![proptest_config(ProptestConfig { cases: 96, failure_persistence: None, ..ProptestConfig::default() })]

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
        aim in 0usize..2,
    ) {
        let mut random = Random::new(seed);
        let mut mesh = soup(vertex_count, triangle_count, &mut random);
        if has_seams {
            mesh = with_seams_and_groups(mesh);
        }
        let wildness = Wildness { far_percent, base_position_count: 1 };
        let options = goal(GOALS[aim])
            .with_tunnel_length(tunnel_length)
            .with_walk_limit(walk_limit)
            .with_search_limit(search_limit);
        check_all_levels(&random_refinable(&mesh, wildness, &mut random), &options, 1);
    }

    #[test]
    fn any_walk_between_levels_shows_the_oracle(
        seed in any::<u64>(),
        jumps in prop::collection::vec(0.0f64..=1.0, 1..20),
        aim in 0usize..2,
    ) {
        let wildness = Wildness { far_percent: 3, base_position_count: 4 };
        let refinable = random_refinable(&grid(16, true), wildness, &mut Random::new(seed));
        let step_count = refinable.sequence.step_count();
        let mut live = at_level(&refinable, step_count / 2, &goal(GOALS[aim]));
        for jump in jumps {
            live.move_to((jump * step_count as f64) as usize);
            check_level(&refinable, &live);
        }
    }
}
