//! Progressive meshes, ordered meshes and discrete levels against the oracle.

use striata_testing::{meshes, support};

use proptest::prelude::*;
use striata::mesh::{
    CollapseSequence, IndexedMesh, MeshError, PositionIndex, RefinableMesh, SequenceParts, TriangleGroup,
    canonical_triangles, replay, shapes,
};
use striata::model::{LodModel, PartBytes};
use striata::simplify::{SequenceOptions, TopologyRule, build_sequence};
use striata::strip::{restart_triangles_into, stripify};
use striata_lab::baseline::{
    DiscreteLevels, DiscreteLevelsError, HoppeProgressiveMeshes, HoppeProgressiveMeshesError, OrderedMeshes,
    ProgressiveMeshes,
};
use striata_lab::{Accounting, PaperBytes};
use striata_strip::{StripOptions, Stripifier};
use support::{
    Random, RandomSequenceOptions, follows_the_oracle, follows_the_oracle_at, grid, hub_cases, nasty_cases,
    random_refinable, seam_cases, soups, surface_cases, with_seams_and_groups,
};

/// Checks progressive meshes, ordered meshes and discrete levels against the oracle.
fn check_baselines(refinable: &RefinableMesh, stride: usize) {
    follows_the_oracle(refinable, &ProgressiveMeshes::build(refinable), stride);
    follows_the_oracle(refinable, &OrderedMeshes::build(refinable), stride);
    for level_count in [1, 2, 5, 10] {
        let model = DiscreteLevels::build(refinable, level_count, stripify).unwrap();
        assert!((1..=level_count).contains(&model.level_count()));
        let levels: Vec<usize> = model.split_counts().collect();
        assert_eq!(levels[0], refinable.sequence.step_count());
        assert!(levels.windows(2).all(|w| w[1] < w[0]), "levels {levels:?} fall");
        let coarsest = levels[levels.len() - 1];
        let shown = |requested| levels.iter().copied().find(|&level| level <= requested).unwrap_or(coarsest);
        follows_the_oracle_at(refinable, &model, stride, shown);
    }
}

#[test]
fn nasty_meshes_follow_the_oracle_at_every_level() {
    nasty_cases().for_each(|case| check_baselines(&case.refinable, case.stride));
}

#[test]
fn nasty_shapes_follow_the_oracle_at_every_level() {
    for (name, mesh) in meshes::nasty() {
        // Meshes that fail their own check cannot be welded, so they have no sequence.
        if mesh.check().is_err() || mesh.triangle_count() > 1000 {
            continue;
        }
        eprintln!("{name}");
        let sequence_options = RandomSequenceOptions { far_percent: 20, base_position_count: 2 };
        check_baselines(&random_refinable(&mesh, sequence_options, &mut Random::new(5)), 1);
    }
}

#[test]
fn surfaces_follow_the_oracle() {
    surface_cases().for_each(|case| check_baselines(&case.refinable, case.stride));
}

#[test]
fn seams_and_groups_follow_the_oracle() {
    seam_cases().for_each(|case| check_baselines(&case.refinable, case.stride));
}

#[test]
fn hub_vertices_have_long_records() {
    for case in hub_cases() {
        follows_the_oracle(&case.refinable, &ProgressiveMeshes::build(&case.refinable), case.stride);
        follows_the_oracle(&case.refinable, &OrderedMeshes::build(&case.refinable), case.stride);
    }
}

/// Triangles that all share the edge of vertices 0 and 1; the one step collapses 1 to 0.
fn many_on_an_edge(triangle_count: u32) -> RefinableMesh {
    // Vertex 1 of the description is the last one in refinement order.
    let last = triangle_count + 1;
    let positions = (0..=last).map(|i| [i as f32, (i % 5) as f32, 1.0]).collect();
    let triangles = (1..last).map(|i| [0, last, i]).collect();
    let sequence = CollapseSequence::from_parts(SequenceParts {
        positions: PositionIndex::identity(last as usize + 1),
        base_position_count: last as usize,
        targets: vec![0],
        errors: vec![1.0],
        // The largest value that a byte can store; a model must not rely on it.
        removed_triangle_counts: vec![triangle_count.min(255) as u8],
        triangle_count: triangle_count as usize,
    })
    .unwrap();
    RefinableMesh { mesh: IndexedMesh::new(positions, triangles), sequence }
}

#[test]
fn step_may_remove_more_triangles_than_fit_in_a_byte() {
    for triangle_count in [254, 255, 256, 700] {
        let refinable = many_on_an_edge(triangle_count);
        follows_the_oracle(&refinable, &ProgressiveMeshes::build(&refinable), 1);
        follows_the_oracle(&refinable, &OrderedMeshes::build(&refinable), 1);
    }
}

/// Disconnected triangles, each in its own group, and an empty group at the end.
fn groups_of_one(group_count: u32) -> IndexedMesh {
    let n = group_count - 1;
    let positions = (0..3 * n).map(|i| [i as f32, (i * i % 23) as f32, 0.0]).collect();
    let mut mesh = IndexedMesh::new(positions, (0..n).map(|t| [3 * t, 3 * t + 1, 3 * t + 2]).collect());
    let group = |g| TriangleGroup { first: g, count: u32::from(g < n), ..TriangleGroup::default() };
    mesh.groups = (0..group_count).map(group).collect();
    mesh
}

#[test]
fn many_groups_follow_the_oracle() {
    for group_count in [2, 256, 257, 300] {
        let sequence_options = RandomSequenceOptions { far_percent: 40, base_position_count: 1 };
        let refinable = random_refinable(&groups_of_one(group_count), sequence_options, &mut Random::new(2));
        check_baselines(&refinable, 23);
    }
}

#[test]
fn degenerate_triangles_are_not_listed() {
    let mut refinable = random_refinable(
        &grid(3, false),
        RandomSequenceOptions { far_percent: 0, base_position_count: 3 },
        &mut Random::new(8),
    );
    refinable.mesh.triangles.splice(4..4, [[1, 1, 2], [5, 7, 5], [3, 3, 3]]);
    let model = ProgressiveMeshes::build(&refinable);
    follows_the_oracle(&refinable, &model, 1);
    assert_eq!(model.new_state().indices().len(), 3 * 18);
    follows_the_oracle(&refinable, &OrderedMeshes::build(&refinable), 1);
}

/// Checks the ranges of each group that are drawn in place.
#[test]
fn groups_are_drawn_from_the_list_in_place() {
    let mesh = with_seams_and_groups(grid(8, false));
    let refinable = random_refinable(
        &mesh,
        RandomSequenceOptions { far_percent: 5, base_position_count: 3 },
        &mut Random::new(3),
    );
    let meshes = ProgressiveMeshes::build(&refinable);
    let ordered = OrderedMeshes::build(&refinable);
    let levels = DiscreteLevels::build(&refinable, 5, stripify).unwrap();
    let (mut list, mut level) = (meshes.new_state(), levels.new_state());
    for split_count in (0..=meshes.step_count()).rev() {
        meshes.move_to(&mut list, split_count);
        levels.move_to(&mut level, split_count);
        let expected = replay(&refinable, split_count);
        assert_eq!(meshes.group_ranges(&list).count(), 3);
        for (range, group) in meshes.group_ranges(&list).zip(&expected.groups) {
            let found = list.indices()[range.start as usize..range.end as usize].as_chunks().0;
            assert_eq!(canonical_triangles(found), canonical_triangles(&expected.triangles[group.range()]));
        }
        let mut instance = ordered.new_state();
        ordered.move_to(&mut instance, split_count);
        for (g, group) in expected.groups.iter().enumerate() {
            let mut found = Vec::new();
            ordered.group_indices_into(&instance, g, &mut found);
            let expected = canonical_triangles(&expected.triangles[group.range()]);
            assert_eq!(canonical_triangles(found.as_chunks().0), expected);
        }
        let expected = replay(&refinable, levels.split_count(&level));
        let strips = levels.strips(&level);
        assert_eq!(strips.group_ranges.len(), 3);
        for (range, group) in strips.group_ranges.iter().zip(&expected.groups) {
            let mut found = Vec::new();
            restart_triangles_into(&strips.indices[range.start as usize..range.end as usize], &mut found);
            assert_eq!(canonical_triangles(&found), canonical_triangles(&expected.triangles[group.range()]));
        }
    }
}

/// A sequence of this mesh that keeps its topology, and the model with split records.
fn hoppe(mesh: &IndexedMesh) -> (RefinableMesh, HoppeProgressiveMeshes) {
    let options = SequenceOptions::default().with_topology(TopologyRule::Keep);
    let refinable = build_sequence(mesh, &options).unwrap().refinable;
    let model = HoppeProgressiveMeshes::build(&refinable).unwrap();
    (refinable, model)
}

#[test]
fn split_records_follow_the_oracle_on_manifold_surfaces() {
    let several = with_seams_and_groups(grid(12, true));
    let open = with_seams_and_groups(grid(9, false));
    for (name, mesh) in [
        ("torus", shapes::torus(24, 16, 1.0, 0.4)),
        ("sphere", shapes::uv_sphere(12, 24, 1.0)),
        ("terrain", shapes::terrain(20, 3)),
        ("grid", shapes::grid(7, 5)),
        ("closed with seams and groups", several),
        ("open with seams and groups", open),
    ] {
        eprintln!("{name}");
        let (refinable, model) = hoppe(&mesh);
        follows_the_oracle(&refinable, &model, 1);
        let mut state = model.new_state();
        for split_count in [0, model.step_count() / 3, model.step_count(), 1, 0] {
            model.move_to(&mut state, split_count);
            let expected = replay(&refinable, split_count);
            for (range, group) in model.group_ranges(&state).zip(expected.groups_or_whole()) {
                let found = state.indices()[range.start as usize..range.end as usize].as_chunks().0;
                let expected = canonical_triangles(&expected.triangles[group.range()]);
                assert_eq!(canonical_triangles(found), expected, "{name} at {split_count}");
            }
        }
    }
}

#[test]
fn split_records_of_one_group_take_eight_bytes_each() {
    let (refinable, model) = hoppe(&shapes::torus(24, 16, 1.0, 0.4));
    let step_count = refinable.sequence.step_count();
    let part = |name| model.bytes().into_iter().find(|part| part.name == name).unwrap().bytes;
    assert_eq!((part("splits"), part("groups of faces"), part("extras")), (8 * step_count, 0, 0));
    let base = refinable.sequence.triangle_count_at(0);
    assert_eq!(part("base"), 24 * base);
    assert_eq!(model.paper_bytes(Accounting::Words), 12 * step_count + 24 * base);
    // Three corners and three neighbors per face of the full mesh.
    let state = model.new_state();
    assert_eq!(model.state_bytes(&state), 24 * refinable.mesh.triangle_count() + 4);
}

#[test]
fn surfaces_that_are_not_manifold_have_no_split_records() {
    let mut fin = shapes::grid(2, 2);
    fin.positions.push([0.0, 0.0, 9.0]);
    let [a, b, _] = fin.triangles[0];
    fin.triangles.push([a, b, 9]);
    let sequence_options = RandomSequenceOptions { far_percent: 0, base_position_count: 4 };
    let refinable = random_refinable(&fin, sequence_options, &mut Random::new(1));
    let error = HoppeProgressiveMeshes::build(&refinable).unwrap_err();
    assert!(matches!(error, HoppeProgressiveMeshesError::Edge { .. }), "{error}");
    // Random collapses tear the surface apart sooner or later.
    let sequence_options = RandomSequenceOptions { far_percent: 50, base_position_count: 1 };
    let refinable = random_refinable(&shapes::grid(6, 6), sequence_options, &mut Random::new(1));
    let error = HoppeProgressiveMeshes::build(&refinable).unwrap_err();
    assert!(matches!(error, HoppeProgressiveMeshesError::Step { .. }), "{error}");
}

#[test]
fn levels_fall_geometrically() {
    let sequence_options = RandomSequenceOptions { far_percent: 0, base_position_count: 20 };
    let refinable = random_refinable(&grid(40, true), sequence_options, &mut Random::new(1));
    let triangles_of = |level_count| {
        let model = DiscreteLevels::build(&refinable, level_count, stripify).unwrap();
        let counts = model.split_counts().map(|s| refinable.sequence.triangle_count_at(s));
        counts.collect::<Vec<_>>()
    };
    // Most random collapses in a torus remove two triangles.
    let check = |found: Vec<usize>, expected: &[usize]| {
        assert_eq!(found.len(), expected.len());
        for (found, expected) in found.into_iter().zip(expected) {
            assert!(found <= *expected && found + 12 > *expected, "{found} triangles, not {expected}");
        }
    };
    check(triangles_of(5), &[3200, 1600, 800, 400, 200]);
    check(triangles_of(10), &[3200, 2352, 1728, 1270, 933, 686, 504, 370, 272, 200]);
    check(triangles_of(1), &[3200]);
    check(triangles_of(2), &[3200, 200]);
}

#[test]
fn levels_of_any_stripifier_follow_the_oracle() {
    let mesh = with_seams_and_groups(grid(10, true));
    let sequence_options = RandomSequenceOptions { far_percent: 2, base_position_count: 4 };
    let refinable = random_refinable(&mesh, sequence_options, &mut Random::new(6));
    for stripifier in [
        Stripifier::Stripe { has_patches: false, swaps: Default::default() },
        Stripifier::Fewest,
        Stripifier::Cheapest,
    ] {
        let options = StripOptions::default().with_stripifier(stripifier);
        let model =
            DiscreteLevels::build(&refinable, 3, |mesh| striata_strip::stripify(mesh, &options)).unwrap();
        let levels: Vec<usize> = model.split_counts().collect();
        let shown = |requested| levels.iter().copied().find(|&level| level <= requested).unwrap_or(levels[2]);
        follows_the_oracle_at(&refinable, &model, 11, shown);
    }
}

#[test]
fn invalid_inputs_are_rejected() {
    let sequence_options = RandomSequenceOptions { far_percent: 0, base_position_count: 4 };
    let mut refinable = random_refinable(&grid(4, false), sequence_options, &mut Random::new(1));
    let build = |refinable: &RefinableMesh, n| DiscreteLevels::build(refinable, n, stripify);
    assert_eq!(build(&refinable, 0).unwrap_err(), DiscreteLevelsError::NoLevels);
    assert_eq!(build(&refinable, usize::MAX).unwrap().split_counts().last(), {
        let sixteenth = refinable.sequence.split_count_for_triangles(2);
        Some(sixteenth)
    });
    refinable.mesh.triangles[3][1] = 99;
    let error = MeshError::IndexOutOfRange { triangle: 3, vertex: 99, vertex_count: 25 };
    assert_eq!(build(&refinable, 5).unwrap_err(), DiscreteLevelsError::Mesh(error));
}

#[test]
fn bytes_match_the_arrays() {
    // A tetrahedron without its base: vertex 3 collapses to 0, one corner changes, two triangles vanish
    // and one stays.
    let positions = vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    let mesh = IndexedMesh::new(positions, vec![[0, 1, 3], [1, 2, 3], [2, 0, 3]]);
    let sequence = CollapseSequence::from_parts(SequenceParts {
        positions: PositionIndex::identity(4),
        base_position_count: 3,
        targets: vec![0],
        errors: vec![0.5],
        removed_triangle_counts: vec![2],
        triangle_count: 3,
    })
    .unwrap();
    let refinable = RefinableMesh { mesh, sequence };
    check_baselines(&refinable, 1);
    let model = ProgressiveMeshes::build(&refinable);
    let part = |name, bytes| PartBytes { name, bytes };
    let expected = vec![
        part("triangles", 3 * 12),
        part("targets", 4),
        part("corners", 4),
        // One byte for the corners of vertex 3, one for the triangles of the step, and the ends of the one
        // group.
        part("counts", 1 + 1 + 8),
    ];
    assert_eq!(model.bytes(), expected);
    assert_eq!(model.paper_bytes(Accounting::Words), 4 * (9 + 1 + 1 + 1 + 1));
    let mut state = model.new_state();
    // The remaining triangle comes first in the list; the two removed ones keep their last corners.
    assert_eq!(state.indices(), [1, 2, 3, 0, 1, 3, 2, 0, 3]);
    model.move_to(&mut state, 0);
    assert_eq!(state.indices(), [1, 2, 0, 0, 1, 3, 2, 0, 3]);
    assert_eq!(model.group_ranges(&state).next(), Some(0..3));
    let ordered = OrderedMeshes::build(&refinable);
    // One triangle in the base, which the split removes, and the three that it creates.
    assert_eq!(ordered.stored_triangle_count(), 4);
    // The one step that creates triangles, and the ends of the one group in both lists.
    assert_eq!(ordered.bytes(), [part("triangles", 48), part("taken by", 16), part("makers", 8 + 4 * 4)]);
    assert_eq!(ordered.paper_bytes(Accounting::Words), 4 * (4 * 4 + 2));
    let levels = DiscreteLevels::build(&refinable, 5, stripify).unwrap();
    assert_eq!(levels.split_counts().collect::<Vec<_>>(), [1, 0]);
    let [fine, coarse] = [1, 0].map(|split_count| {
        let mut state = levels.new_state();
        levels.move_to(&mut state, split_count);
        levels.draw_counts(&state).index_count
    });
    assert_eq!(coarse, 3);
    assert_eq!(levels.paper_bytes(Accounting::Words), 4 * (fine + coarse) + 12 * 3);
    assert_eq!(levels.bytes()[0], part("strips", 4 * (fine + coarse)));
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 96, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn random_meshes_follow_the_oracle_at_every_level(case in soups()) {
        check_baselines(&case.refinable, case.stride);
    }

    #[test]
    fn any_walk_between_levels_follows_the_oracle(
        seed in any::<u64>(),
        jumps in prop::collection::vec(0.0f64..=1.0, 1..20),
    ) {
        let sequence_options = RandomSequenceOptions { far_percent: 3, base_position_count: 4 };
        let refinable = random_refinable(&grid(16, true), sequence_options, &mut Random::new(seed));
        let model = ProgressiveMeshes::build(&refinable);
        let mut state = model.new_state();
        for jump in jumps {
            let split_count = (jump * model.step_count() as f64) as usize;
            model.move_to(&mut state, split_count);
            let mut found = Vec::new();
            model.triangles_into(&state, &mut found);
            let expected = replay(&refinable, split_count).triangles;
            prop_assert_eq!(canonical_triangles(&found), canonical_triangles(&expected));
        }
    }
}
