//! The published pattern model against the oracle: uniform levels, closed sets, the smallest set for any
//! condition, and meshes that its form rejects.

use striata_testing::support;

use std::collections::BTreeSet;

use striata::mesh::{
    Face, Fragment, FragmentSequence, FragmentedMesh, IndexedMesh, PositionIndex, fragment_faces, shapes,
};
use striata::model::{LodModel, Overlap, PatternChange, Patterns, StoredModel};
use striata::simplify::{SequenceOptions, TopologyRule, build_sequence};
use striata_lab::baseline::{
    LoopPatterns, LoopPatternsState, MultiTriangulation, SequentialPatterns, decode_sequential,
};
use striata_lab::{Accounting, PaperBytes};
use support::{
    Random, assert_shows_set, closed_sets, follows_the_fragments, fragment_cases, grid, hub_cases,
    nasty_cases, random_closed_set, random_removals, seam_cases, smallest_set,
};

/// Surfaces with collapses in cost order; most have borders, whose last triangles are attached by one edge
/// only.
fn collapsed_cases() -> impl Iterator<Item = FragmentedMesh> {
    let mut holed = grid(13, false);
    holed.triangles.retain(|t| !(t.contains(&34) && t.contains(&35) || t.contains(&66) && t.contains(&80)));
    let meshes = [
        holed,
        grid(9, false),
        shapes::icosphere(3, 1.0),
        shapes::terrain(16, 5),
        shapes::torus(11, 9, 2.0, 1.0),
    ];
    meshes.into_iter().map(|mesh| {
        // The model supports manifolds only.
        let options = SequenceOptions::default().with_topology(TopologyRule::Keep);
        let simplified = build_sequence(&mesh, &options).unwrap();
        FragmentedMesh::from_collapses(&simplified.refinable)
    })
}

/// A pseudorandom number that depends only on an overlap and a seed.
fn chance(overlap: Overlap, seed: u64) -> u64 {
    let lower = overlap.lower.map_or(1 << 30, u64::from);
    let mixed = (lower << 24 ^ u64::from(overlap.upper) ^ seed << 45).wrapping_mul(0x9E37_79B9_7F4A_7C15);
    (mixed ^ mixed >> 29).wrapping_mul(0xBF58_476D_1CE4_E5B9) >> 40
}

/// A condition that considers some percentage of all overlaps too coarse, independently of their position.
fn scattered(percent: u64, seed: u64) -> impl Fn(Overlap) -> bool {
    move |overlap| chance(overlap, seed) % 100 < percent
}

fn inserted(model: &LoopPatterns, state: &LoopPatternsState) -> Vec<u32> {
    (0..model.step_count() as u32).filter(|&step| state.is_refined(step)).collect()
}

fn shows_what_is_inserted(mesh: &FragmentedMesh, state: &LoopPatternsState) {
    assert_shows_set(&mesh.fragments, state.triangles(), |step| state.is_refined(step));
    let shown: BTreeSet<u32> = state.triangles().iter().flatten().copied().collect();
    assert!((0..mesh.mesh.vertex_count() as u32).all(|v| state.is_active(v) == shown.contains(&v)));
}

#[test]
fn removals_with_any_triangulation_follow_the_oracle() {
    for (_, mesh) in fragment_cases() {
        follows_the_fragments(&mesh, &LoopPatterns::build(&mesh).unwrap(), 1);
    }
}

#[test]
fn collapses_follow_the_oracle() {
    let mut floorless = 0;
    for mesh in collapsed_cases() {
        let fragments = &mesh.fragments;
        floorless += (0..fragments.step_count() as u32).filter(|&s| fragments.floor(s).is_empty()).count();
        follows_the_fragments(&mesh, &LoopPatterns::build(&mesh).unwrap(), 3);
    }
    assert!(floorless > 0, "no triangle is attached by one edge only");
}

#[test]
fn both_ways_of_building_give_equal_models() {
    for mesh in fragment_cases().map(|case| case.1).chain(collapsed_cases()) {
        let model = LoopPatterns::build(&mesh).unwrap();
        let explicit = MultiTriangulation::build(&mesh);
        assert!(LoopPatterns::from_multi_triangulation(&explicit).unwrap() == model);
    }
}

/// If a floor closes a hole, the side that closes the ring has another triangle across it, and is a border
/// again after the split.
#[test]
fn cases_include_closing_holes() {
    let mut count = 0;
    for mesh in fragment_cases().map(|case| case.1).chain(collapsed_cases()) {
        let fragments = &mesh.fragments;
        let sides_of = |face: u32| {
            let [a, b, c] = fragments.faces()[face as usize].corners;
            [[a, b], [b, c], [c, a]]
        };
        for step in 0..fragments.step_count() as u32 {
            let ceiling: BTreeSet<[u32; 2]> = fragments.ceiling(step).flat_map(sides_of).collect();
            let floor: BTreeSet<[u32; 2]> = fragments.floor(step).iter().flat_map(|&f| sides_of(f)).collect();
            let is_inner = |side: &[u32; 2]| floor.contains(&[side[1], side[0]]);
            let Some(new) = floor.iter().find(|side| !ceiling.contains(*side) && !is_inner(side)) else {
                continue;
            };
            let level = fragment_faces(fragments, |other| other < step);
            count += usize::from(level.into_iter().flat_map(sides_of).any(|side| side == [new[1], new[0]]));
        }
    }
    assert!(count > 0);
}

/// Loops contain exactly the fragments that share triangles of floors and ceilings.
#[test]
fn loops_contain_the_overlapping_fragments() {
    for (_, mesh) in fragment_cases() {
        let fragments = &mesh.fragments;
        let model = LoopPatterns::build(&mesh).unwrap();
        let replaced_by = fragments.replacing_steps();
        let mut count = 0;
        for step in 0..fragments.step_count() as u32 {
            let mut below: Vec<u32> = model.covered(step).collect();
            below.sort_unstable();
            let makers = fragments.floor(step).iter().filter_map(|&face| fragments.creating_step(face));
            assert_eq!(below, makers.collect::<BTreeSet<_>>().into_iter().collect::<Vec<_>>());
            let mut above: Vec<u32> = model.covering(step).collect();
            above.sort_unstable();
            let covers = fragments.ceiling(step).map(|face| replaced_by[face as usize]);
            let covers: BTreeSet<u32> = covers.filter(|&cover| cover != FragmentSequence::NO_STEP).collect();
            assert_eq!(above, covers.into_iter().collect::<Vec<_>>());
            count += above.len();
        }
        assert_eq!(model.overlap_count(), count);
        let base = replaced_by[..fragments.base_face_count()].iter().copied();
        let base: BTreeSet<u32> = base.filter(|&cover| cover != FragmentSequence::NO_STEP).collect();
        assert_eq!(model.base_covers(), base.into_iter().collect::<Vec<_>>());
    }
}

#[test]
fn closed_sets_are_shown_from_any_previous_set() {
    for (seed, mesh) in fragment_cases() {
        let model = LoopPatterns::build(&mesh).unwrap();
        let mut random = Random::new(seed);
        let (mut adapted, mut walked) = (model.base_state(), model.new_state());
        for percent in [2, 30, 8, 70, 0, 15, 100, 4, 1, 50] {
            let set = random_closed_set(&mesh.fragments, percent, &mut random);
            let condition = |overlap: Overlap| set[overlap.upper as usize];
            let before = adapted.split_count();
            let change = model.adapt(&mut adapted, &condition);
            assert_eq!(before + change.inserted - change.removed, adapted.split_count());
            assert!((0..set.len()).all(|step| adapted.is_refined(step as u32) == set[step]));
            shows_what_is_inserted(&mesh, &adapted);
            // No fine overlap is too coarse unless the one below it is too, so the two steps of the paper
            // reach the same set.
            let before = walked.split_count();
            let removed = model.coarsen(&mut walked, &condition);
            let added = model.refine(&mut walked, &condition);
            assert_eq!(before + added - removed, walked.split_count());
            assert!(walked == adapted);
        }
        model.move_to(&mut walked, model.step_count() / 3);
        let mut level = model.base_state();
        model.move_to(&mut level, model.step_count() / 3);
        assert!(walked == level);
    }
}

#[test]
fn scattered_conditions_leave_nothing_too_coarse() {
    for mesh in collapsed_cases().chain(fragment_cases().step_by(3).map(|case| case.1)) {
        let model = LoopPatterns::build(&mesh).unwrap();
        let (mut state, mut smallest) = (model.new_state(), model.base_state());
        for round in 0..12 {
            let condition = scattered([1, 40, 10, 4][round % 4], round as u64);
            model.coarsen(&mut state, &condition);
            model.refine(&mut state, &condition);
            model.adapt(&mut smallest, &condition);
            assert_eq!(model.adapt(&mut smallest, &condition), PatternChange::default());
            for shown in [&state, &smallest] {
                shows_what_is_inserted(&mesh, shown);
                let is_fine = |lower, upper| {
                    shown.is_refined(upper) || !condition(Overlap { lower, upper, error: f32::INFINITY })
                };
                assert!(model.base_covers().iter().all(|&upper| is_fine(None, upper)));
                for step in inserted(&model, shown) {
                    assert!(model.covering(step).all(|upper| is_fine(Some(step), upper)));
                }
            }
            assert!(inserted(&model, &smallest).iter().all(|&step| state.is_refined(step)));
        }
        assert_eq!(model.adapt(&mut state, &|_: Overlap| true).removed, 0);
        assert!(state == model.new_state());
        assert_eq!(model.adapt(&mut state, &|_: Overlap| false).removed, model.step_count());
        assert!(state == model.base_state());
    }
}

#[test]
fn any_condition_leads_to_the_smallest_set_from_anywhere() {
    let mut sizes = [0; 13];
    for seed in 0..60u64 {
        let surface = grid(3 + seed as usize % 2, seed % 3 == 0);
        let mesh = random_removals(&surface, 12, &mut Random::new(seed + 1));
        let fragments = &mesh.fragments;
        let model = LoopPatterns::build(&mesh).unwrap();
        let sets = closed_sets(fragments);
        let mut state = model.new_state();
        for round in 0..60 {
            let condition = scattered([5, 20, 50, 80][round % 4], seed * 100 + round as u64);
            let evaluate = |face: Option<u32>, upper| {
                let lower = face.and_then(|face| fragments.creating_step(face));
                condition(Overlap { lower, upper, error: f32::INFINITY })
            };
            let expected = smallest_set(fragments, &sets, evaluate);
            model.adapt(&mut state, &condition);
            let found = inserted(&model, &state).iter().fold(0, |set, step| set | 1 << step);
            assert_eq!(found, expected, "mesh {seed}, round {round}");
            shows_what_is_inserted(&mesh, &state);
            sizes[expected.count_ones() as usize] += 1;
        }
    }
    assert!(sizes[1..11].iter().all(|&count| count > 10), "sets of each size {sizes:?}");
}

#[test]
fn library_patterns_reach_the_same_sets() {
    for (seed, mesh) in fragment_cases() {
        let (model, library) = (LoopPatterns::build(&mesh).unwrap(), Patterns::build(&mesh).unwrap());
        assert_eq!(model.overlap_count(), library.overlap_count());
        let mut state = model.new_state();
        let mut instance = striata::model::PatternInstance::base(&library);
        for round in 0..8 {
            let condition = scattered([2, 30, 10][round % 3], seed * 50 + round as u64);
            model.adapt(&mut state, &condition);
            instance.adapt(&library, &condition);
            let steps = 0..model.step_count() as u32;
            assert!(steps.clone().all(|step| state.is_refined(step) == instance.is_refined(step)));
        }
    }
}

#[test]
fn inserting_a_fragment_inserts_its_prerequisites() {
    for mesh in fragment_cases().step_by(3).map(|case| case.1).chain(collapsed_cases()) {
        let model = LoopPatterns::build(&mesh).unwrap();
        for step in (0..model.step_count() as u32).step_by(11) {
            let mut state = model.base_state();
            let count = model.insert(&mut state, step);
            assert_eq!((count, model.insert(&mut state, step)), (state.split_count(), 0));
            assert_eq!(inserted(&model, &state).last(), Some(&step), "nothing finer is needed");
            shows_what_is_inserted(&mesh, &state);
        }
    }
}

/// Every level of a model that is not rejected is right.
#[test]
fn non_surfaces_are_rejected() {
    let mut rejected = 0;
    for case in nasty_cases().chain(seam_cases()).chain(hub_cases()) {
        let mesh = FragmentedMesh::from_collapses(&case.refinable);
        let explicit = LoopPatterns::from_multi_triangulation(&MultiTriangulation::build(&mesh));
        match LoopPatterns::build(&mesh) {
            Ok(model) => {
                follows_the_fragments(&mesh, &model, case.stride);
                assert!(explicit.unwrap() == model);
            }
            Err(error) => {
                assert_eq!(explicit.unwrap_err(), error);
                rejected += 1;
            }
        }
    }
    assert!(rejected > 60, "{rejected} of them are rejected");
}

/// A grid with random holes, some of which touch at vertices.
fn ragged(seed: u64) -> IndexedMesh {
    let mut random = Random::new(seed);
    let mut mesh = grid(5, seed.is_multiple_of(2));
    mesh.triangles.retain(|_| random.below(100) > seed as usize % 14);
    let used: BTreeSet<u32> = mesh.triangles.iter().flatten().copied().collect();
    let used: Vec<u32> = used.into_iter().collect();
    mesh.positions = used.iter().map(|&v| mesh.positions[v as usize]).collect();
    let new_index = |v: u32| used.binary_search(&v).unwrap() as u32;
    mesh.triangles.iter_mut().for_each(|t| *t = t.map(new_index));
    mesh
}

/// If holes close or borders touch, both forms reject the same meshes, and every set of the others is right.
#[test]
fn ragged_surfaces_are_right_or_rejected() {
    let (mut right, mut rejected) = (0, 0);
    for seed in 0..400 {
        let mesh = random_removals(&ragged(seed), usize::MAX, &mut Random::new(seed + 1));
        let Ok(model) = LoopPatterns::build(&mesh) else {
            assert!(SequentialPatterns::encode(&mesh).is_err(), "seed {seed}: only one form rejects it");
            rejected += 1;
            continue;
        };
        right += 1;
        follows_the_fragments(&mesh, &model, 1);
        let written = SequentialPatterns::encode(&mesh).unwrap();
        assert!(decode_sequential(written.as_bytes()).is_ok());
        let mut state = model.new_state();
        for round in 0..10 {
            model.adapt(&mut state, &scattered([3, 30, 10, 60][round % 4], seed + round as u64));
            shows_what_is_inserted(&mesh, &state);
        }
    }
    assert!(right > 100 && rejected > 50, "{right} are right, {rejected} rejected");
}

fn face(corners: [u32; 3]) -> Face {
    Face { corners, group: 0 }
}

fn faces(list: &[[u32; 3]]) -> Vec<Face> {
    list.iter().map(|&t| face(t)).collect()
}

/// A ceiling and the floor that it replaces.
type Exchange<'a> = (&'a [[u32; 3]], &'a [[u32; 3]]);

/// Builds a mesh from its base and the exchanges of its steps.
fn mesh_of(base: &[[u32; 3]], steps: &[Exchange], vertex_count: usize) -> FragmentedMesh {
    let fragments = steps.iter().map(|(ceiling, floor)| Fragment {
        ceiling: faces(ceiling),
        floor: faces(floor),
        error: 1.0,
    });
    let positions = PositionIndex::identity(vertex_count);
    let fragments = FragmentSequence::from_fragments(positions, faces(base), fragments).unwrap();
    let present = fragment_faces(&fragments, |_| true);
    let triangles = present.iter().map(|&f| fragments.faces()[f as usize].corners).collect();
    let positions = (0..vertex_count).map(|i| [i as f32, (i * i % 5) as f32, 0.5]).collect();
    FragmentedMesh { mesh: IndexedMesh::new(positions, triangles), fragments }
}

fn rejection(mesh: &FragmentedMesh) -> String {
    LoopPatterns::build(mesh).unwrap_err().to_string()
}

#[test]
fn rejections_name_the_step_and_the_reason() {
    let bow_tie = mesh_of(&[[0, 1, 2], [2, 3, 4]], &[(&[[0, 1, 5], [1, 2, 5], [2, 0, 5]], &[[0, 1, 2]])], 6);
    assert_eq!(rejection(&bow_tie), "triangle of the base 1 has a vertex whose triangles are not one fan");
    let two_fans = mesh_of(&[[0, 1, 2]], &[(&[[1, 0, 5], [3, 4, 5]], &[])], 6);
    assert_eq!(rejection(&two_fans), "step 0 removes a vertex whose triangles are not one fan");
    let unfilled = mesh_of(&[[0, 1, 2]], &[(&[[1, 0, 4], [0, 3, 4]], &[])], 5);
    assert_eq!(rejection(&unfilled), "step 0 has a floor that does not fill the hole");
    let twice = mesh_of(&[[0, 1, 2]], &[(&[[0, 1, 3]], &[])], 4);
    assert_eq!(rejection(&twice), "triangle 1 has an edge in the same direction as another triangle");
    let alone = mesh_of(&[[0, 1, 2]], &[(&[[3, 4, 5]], &[])], 6);
    assert_eq!(rejection(&alone), "step 0 removes the last triangle of a component");
    let ring = [[0, 1, 5], [1, 2, 5], [2, 3, 5], [3, 0, 5]];
    let floor = [[0, 1, 2], [0, 2, 3]];
    let doubled = mesh_of(&[[0, 1, 2], [0, 2, 3], [0, 2, 4]], &[(&ring, &floor)], 6);
    assert_eq!(rejection(&doubled), "step 0 creates an edge that two triangles use in the same direction");
    // A triangle that touches two others at two vertices, until a floor fills the hole between them.
    let touching = mesh_of(&[[0, 2, 1], [3, 0, 1]], &[(&[[4, 0, 2], [4, 2, 1]], &[[0, 2, 1]])], 5);
    assert_eq!(rejection(&touching), "step 0 closes a hole at a vertex that has another border");
    let error = SequentialPatterns::encode(&touching).unwrap_err();
    assert_eq!(error.to_string(), "step 0 opens a hole at a vertex that has another border");
    let mut groups = mesh_of(&floor, &[(&[[0, 1, 4], [1, 2, 4], [2, 0, 4]], &floor[..1])], 5);
    assert!(LoopPatterns::build(&groups).is_ok());
    groups.mesh.groups = support::with_seams_and_groups(grid(2, false)).groups;
    assert_eq!(rejection(&groups), "the published form holds at most 1 group of triangles, and there are 3");
    let mut seams = FragmentedMesh::from_collapses(&seam_cases().next().unwrap().refinable);
    seams.mesh.groups.clear();
    assert!(rejection(&seams).contains("vertices (one a position), and there are"), "{}", rejection(&seams));
}

/// A vertex with `degree` triangles, each of which is then split.
fn crowded(degree: u32) -> FragmentedMesh {
    let hub = degree;
    let base: Vec<[u32; 3]> = (1..degree - 1).map(|i| [0, i, i + 1]).collect();
    let fan: Vec<[u32; 3]> = (0..degree).map(|i| [i, (i + 1) % degree, hub]).collect();
    let splits: Vec<[[u32; 3]; 3]> =
        fan.iter().zip(hub + 1..).map(|(&[a, b, c], new)| [[a, b, new], [b, c, new], [c, a, new]]).collect();
    let mut steps: Vec<Exchange> = vec![(&fan, &base)];
    steps.extend(splits.iter().zip(fan.chunks(1)).map(|(ceiling, floor)| (&ceiling[..], floor)));
    mesh_of(&base, &steps, 2 * degree as usize + 1)
}

#[test]
fn fragment_is_in_at_most_fifteen_loops() {
    let mesh = crowded(15);
    let model = LoopPatterns::build(&mesh).unwrap();
    assert_eq!((model.covering(0).count(), model.rule_count()), (15, 2));
    follows_the_fragments(&mesh, &model, 1);
    assert_eq!(
        rejection(&crowded(16)),
        "the published form holds at most 15 loops through one fragment, and there are 16"
    );
    let wide = mesh_of(
        &(1..299).map(|i| [0, i, i + 1]).collect::<Vec<_>>(),
        &[(
            &(0..300).map(|i| [i, (i + 1) % 300, 300]).collect::<Vec<_>>(),
            &(1..299).map(|i| [0, i, i + 1]).collect::<Vec<_>>(),
        )],
        301,
    );
    assert_eq!(rejection(&wide), "step 0 removes a vertex with more than 255 triangles");
}

#[test]
fn bytes_match_the_packed_arrays_and_the_paper() {
    let mesh = collapsed_cases().nth(2).unwrap();
    let model = LoopPatterns::build(&mesh).unwrap();
    let (steps, overlaps) = (model.step_count(), model.overlap_count());
    let bytes: Vec<usize> = model.bytes().iter().map(|part| part.bytes).collect();
    let padding = 8;
    assert_eq!(bytes[0], 14 * steps + padding);
    assert_eq!(bytes[1], (36 * overlaps).div_ceil(8) + padding + 8 * steps.div_ceil(16));
    assert_eq!(bytes[2], 4 * steps.div_ceil(32));
    assert_eq!(bytes[4], 12 * mesh.fragments.base_face_count() + 4 * model.base_covers().len());
    let paper = (116 * steps + 36 * overlaps).div_ceil(8);
    assert_eq!(model.paper_bytes(Accounting::Words), paper);
    assert!(bytes.iter().sum::<usize>() < paper + steps / 8 + 400, "{bytes:?}, paper {paper}");
    assert!(model.rule_count() < 40 && model.vertex_count() == mesh.mesh.vertex_count());
    assert_eq!(model.vertex_count_at(7), mesh.fragments.levels().vertex_count_at(7));
}
