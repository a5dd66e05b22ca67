//! Edges and triangles collapsed to new vertices, as fragments: every set of steps shows the triangles that
//! the oracle shows, errors hold, and patterns and files contain them.

use striata_testing::meshes;
use striata_testing::support;

use striata::file::{FileModel, StriataFile, WriteOptions, write_fragments};
use striata::mesh::{
    AttributeLayer, DistanceOptions, IndexedMesh, Semantic, canonical_triangles, replay, replay_fragments,
    shapes, surface_distance, weld,
};
use striata::model::{LodModel, Overlap, PatternInstance, Patterns};
use striata::simplify::{
    BuiltPlaced, PlacedCollapse, PlacedOptions, SequenceOptions, StopReason, build_placed_fragments,
    build_sequence,
};
use support::{
    Random, assert_shows_set, follows_the_fragments, grid, random_closed_set, with_seams_and_groups,
};

const KINDS: [PlacedCollapse; 2] = [PlacedCollapse::Edge, PlacedCollapse::Triangle];

fn build(mesh: &IndexedMesh, collapse: PlacedCollapse) -> BuiltPlaced {
    build_placed_fragments(mesh, &PlacedOptions::default().with_collapse(collapse)).unwrap()
}

fn surfaces() -> [IndexedMesh; 4] {
    [
        shapes::torus(16, 12, 2.0, 0.7),
        shapes::terrain(14, 6),
        shapes::icosphere(3, 1.0),
        with_seams_and_groups(grid(9, false)),
    ]
}

/// Positions of the corners of all triangles, sorted.
fn shown_positions(mesh: &IndexedMesh) -> Vec<[[u32; 3]; 3]> {
    let at = |t: &[u32; 3]| {
        let mut corners = t.map(|v| mesh.positions[v as usize].map(f32::to_bits));
        let first = (0..3).min_by_key(|&k| corners[k]).unwrap_or(0);
        corners.rotate_left(first);
        corners
    };
    let mut all: Vec<_> = mesh.triangles.iter().map(at).collect();
    all.sort_unstable();
    all
}

#[test]
fn patterns_of_new_vertices_follow_the_oracle() {
    for mesh in surfaces() {
        for collapse in KINDS {
            let built = build(&mesh, collapse);
            let fragments = &built.fragmented.fragments;
            assert!(fragments.step_count() > 20);
            let full = replay_fragments(&built.fragmented, fragments.step_count());
            assert_eq!(shown_positions(&full), shown_positions(&weld(&mesh).unwrap().mesh));
            let patterns = Patterns::build(&built.fragmented).unwrap();
            follows_the_fragments(&built.fragmented, &patterns, 7);
            let mut random = Random::new(5);
            let mut instance = PatternInstance::base(&patterns);
            for percent in [3, 40, 0, 10, 100, 1, 20] {
                let set = random_closed_set(fragments, percent, &mut random);
                instance.adapt(&patterns, &|overlap: Overlap| set[overlap.upper as usize]);
                let mut shown = Vec::new();
                instance.triangles_into(&mut shown);
                assert_shows_set(fragments, &shown, |step| set[step as usize]);
            }
        }
    }
}

#[test]
fn triangles_make_fewer_steps_than_edges() {
    let mesh = shapes::torus(24, 16, 2.0, 0.7);
    let [edges, triangles] = KINDS.map(|collapse| build(&mesh, collapse).fragmented.fragments.step_count());
    assert!(triangles < edges * 3 / 4, "{triangles} steps instead of {edges}");
}

#[test]
fn errors_of_levels_hold() {
    let options = DistanceOptions::default().with_sample_count(3000);
    for mesh in surfaces() {
        for collapse in KINDS {
            let built = build(&mesh, collapse);
            let fragments = &built.fragmented.fragments;
            for split_count in (0..fragments.step_count()).step_by(1 + fragments.step_count() / 9) {
                let level = replay_fragments(&built.fragmented, split_count);
                if level.triangles.is_empty() {
                    continue;
                }
                let found = surface_distance(&mesh, &level, &options).unwrap().a_to_b.max;
                let error = f64::from(fragments.levels().error_at(split_count));
                assert!(found <= error + 1e-12 * mesh.diagonal(), "{found} of at most {error}");
            }
        }
    }
}

#[test]
fn levels_are_closer_than_those_of_half_edge_collapses() {
    let mesh = shapes::torus(40, 24, 2.0, 0.7);
    let half_edges = build_sequence(&mesh, &SequenceOptions::default()).unwrap().refinable;
    let options = DistanceOptions::default().with_sample_count(20_000);
    let rms = |level: &IndexedMesh| surface_distance(&mesh, level, &options).unwrap().rms;
    let placed = build(&mesh, PlacedCollapse::Edge).fragmented;
    for count in [800, 400, 200] {
        let own = replay_fragments(&placed, placed.fragments.levels().split_count_for_triangles(count));
        let other = replay(&half_edges, half_edges.sequence.split_count_for_triangles(count));
        assert!(rms(&own) < 0.9 * rms(&other), "{} instead of {}", rms(&own), rms(&other));
    }
}

#[test]
fn an_error_limit_leaves_out_coarser_levels() {
    let mesh = shapes::torus(24, 16, 2.0, 0.7);
    for collapse in KINDS {
        let sequence = SequenceOptions::default().with_max_error(0.02 * mesh.diagonal());
        let options = PlacedOptions::default().with_collapse(collapse).with_sequence(sequence);
        let built = build_placed_fragments(&mesh, &options).unwrap();
        let levels = built.fragmented.fragments.levels();
        assert_eq!(built.stop_reason, StopReason::ErrorLimit);
        assert!(f64::from(levels.error_at(0)) <= 0.02 * mesh.diagonal());
        assert!(levels.triangle_count_at(0) > 8 && levels.triangle_count_at(0) < 400);
        follows_the_fragments(&built.fragmented, &Patterns::build(&built.fragmented).unwrap(), 11);
    }
}

#[test]
fn nasty_meshes_are_collapsed_or_refused() {
    for (name, mesh) in meshes::nasty() {
        for collapse in KINDS {
            let options = PlacedOptions::default().with_collapse(collapse);
            match build_placed_fragments(&mesh, &options) {
                Ok(built) => {
                    built.fragmented.mesh.check().unwrap_or_else(|error| panic!("{name}: {error}"));
                    let patterns = Patterns::build(&built.fragmented).unwrap();
                    follows_the_fragments(&built.fragmented, &patterns, 5);
                }
                Err(error) => assert!(mesh.check().is_err(), "{name}: {error}"),
            }
        }
    }
}

#[test]
fn new_vertices_have_identifiers_of_the_input() {
    let mut mesh = shapes::torus(16, 12, 2.0, 0.7);
    let ids: Vec<f32> = (0..mesh.vertex_count()).map(|v| (v * 7919 % 300_001) as f32).collect();
    let semantic = Semantic::Generic("FEATURE_ID_0".to_owned());
    mesh.layers.push(AttributeLayer::from_f32(semantic, 1, ids.clone()));
    for collapse in KINDS {
        let fragmented = build(&mesh, collapse).fragmented;
        let base = replay_fragments(&fragmented, 0);
        let layer = &base.layers[0];
        assert!(base.positions.iter().any(|position| !mesh.positions.contains(position)));
        assert!((0..base.vertex_count()).all(|v| ids.contains(&layer.get(v, 0))), "{collapse:?}");
    }
}

#[test]
fn files_contain_new_vertices() {
    for mesh in surfaces() {
        for collapse in KINDS {
            let BuiltPlaced { fragmented, .. } = build(&mesh, collapse);
            let patterns = Patterns::build(&fragmented).unwrap();
            let mut bytes = Vec::new();
            write_fragments(
                &fragmented,
                &[FileModel::Patterns(&patterns)],
                &WriteOptions::default(),
                &mut bytes,
            )
            .unwrap();
            let file = StriataFile::parse(&bytes).unwrap();
            assert!(!file.has_collapses());
            assert_eq!(file.patterns().unwrap().unwrap(), patterns);
            for split_count in (0..=patterns.step_count()).step_by(1 + patterns.step_count() / 7) {
                let (found, expected) =
                    (file.level(split_count).unwrap(), replay_fragments(&fragmented, split_count));
                assert_eq!(canonical_triangles(&found.triangles), canonical_triangles(&expected.triangles));
            }
        }
    }
}
