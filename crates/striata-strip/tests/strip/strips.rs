//! Every stripifier on every kind of mesh: each proper triangle once, with its winding and group, and
//! correct costs.

use std::ops::ControlFlow;

use proptest::prelude::*;
use striata::mesh::{DualGraph, IndexedMesh, Random, TriangleGroup, canonical_triangles, shapes};
use striata::strip::{RESTART, StripSet, restart_triangles_into, strip_triangles};
use striata_strip::{
    StripOptions, Stripifier, StripifyError, strip_count_bound, stripify, stripify_from,
    stripify_with_progress,
};
use striata_testing::meshes;

/// One spelling of each stripifier, with relevant parameters.
const SPECS: [&str; 9] = [
    "greedy",
    "stripe",
    "stripe:global:few-swaps",
    "stripe:no-swaps",
    "fewest",
    "cheapest",
    "tunnel:1",
    "tunnel:9",
    "tunnel:40",
];

fn options(spec: &str) -> StripOptions {
    StripOptions::default().with_stripifier(spec.parse().unwrap()).with_effort(0.2)
}

/// Returns a budget of few moves.
fn short_budget() -> impl FnMut(u64) -> f64 {
    |moves| moves as f64 / 20_000.0
}

fn proper(triangles: &[[u32; 3]]) -> Vec<[u32; 3]> {
    canonical_triangles(triangles).into_iter().filter(|[a, b, c]| a != b && b != c && c != a).collect()
}

/// Checks, group by group, that the strips and both index buffers draw the mesh's proper triangles.
fn check(mesh: &IndexedMesh, strips: &StripSet, what: &str) {
    let groups = mesh.groups_or_whole();
    assert_eq!(strips.group_count(), groups.len(), "{what}");
    let (restart, stitched) = (strips.to_restart_indices(), strips.to_stitched_indices());
    for (g, group) in groups.iter().enumerate() {
        let expected = proper(&mesh.triangles[group.range()]);
        let from_strips: Vec<_> =
            strips.group_strips(g).flat_map(|s| strip_triangles(strips.strip(s))).collect();
        assert_eq!(canonical_triangles(&from_strips), expected, "{what}, group {g}");
        for joined in [&restart, &stitched] {
            let range = &joined.group_ranges[g];
            let mut drawn = Vec::new();
            restart_triangles_into(&joined.indices[range.start as usize..range.end as usize], &mut drawn);
            assert_eq!(canonical_triangles(&drawn), expected, "{what}, drawn, group {g}");
        }
    }
    let cost = strips.cost();
    assert_eq!(cost.index_count, restart.indices.len(), "{what}");
    assert!(!stitched.indices.contains(&RESTART), "{what}");
    assert!(strips.strips().all(|strip| strip.len() >= 3), "{what}: an empty strip");
}

/// Random triangles between few vertices: crowded edges, duplicates and degenerate triangles.
fn soup(vertices: u32, triangles: u32, seed: u64) -> IndexedMesh {
    let mut random = Random::new(seed);
    let triangles = (0..triangles).map(|_| [(); 3].map(|()| random.below(vertices))).collect();
    IndexedMesh::new(vec![[0.0; 3]; vertices as usize], triangles)
}

fn check_all(mesh: &IndexedMesh, what: &str) {
    let mut last = StripSet::new();
    for spec in SPECS {
        let strips = stripify(mesh, &options(spec)).unwrap();
        check(mesh, &strips, &format!("{what}, {spec}"));
        let again = stripify(mesh, &options(spec)).unwrap();
        assert_eq!(strips, again, "{what}, {spec}: not the same twice");
        // Starting from the previous stripifier's strips, and from strips that partly do not fit the mesh.
        let from = stripify_from(mesh, &last, &options(spec), &mut short_budget()).unwrap();
        check(mesh, &from, &format!("{what}, {spec} from others"));
        last = strips;
    }
}

#[test]
fn shapes_and_degenerate_meshes_are_covered() {
    for (name, mesh) in meshes::nasty() {
        if mesh.check().is_ok() {
            check_all(&mesh, name);
        }
    }
    check_all(&shapes::torus(12, 9, 1.0, 0.4), "torus");
    check_all(&shapes::grid(9, 7), "grid");
    check_all(&shapes::hard_cube(), "cube");
    check_all(&IndexedMesh::default(), "nothing");
}

#[test]
fn thousands_of_identical_triangles_are_matched_quickly() {
    let mesh = IndexedMesh::new(vec![[0.0; 3]; 3], vec![[0, 1, 2]; 60_000]);
    let start = stripify(&mesh, &options("greedy")).unwrap();
    let strips = stripify_from(&mesh, &start, &options("greedy"), &mut short_budget()).unwrap();
    check(&mesh, &strips, "equal triangles");
}

/// The search estimates costs that the writer cannot always achieve, so the written strips are compared.
#[test]
fn cheapest_strips_cost_no_more_than_their_start() {
    for seed in 0..60 {
        let mesh = soup(40, 90, seed);
        let cost = |strips: &StripSet| strips.cost().index_count;
        let start = stripify(&mesh, &options("greedy")).unwrap();
        let cheapest = stripify_from(&mesh, &start, &options("cheapest"), &mut short_budget()).unwrap();
        assert!(cost(&cheapest) <= cost(&start), "seed {seed}: {} > {}", cost(&cheapest), cost(&start));
    }
}

/// Large meshes are searched in parts.
#[test]
fn strips_of_a_large_mesh_do_not_depend_on_the_number_of_threads() {
    let mut mesh = shapes::icosphere(7, 1.0);
    // The links of a regular mesh would be too good to search, and those of a mesh in order too easy to divide.
    let mut random = Random::new(7);
    let kept: Vec<u32> = (0..mesh.triangle_count() as u32).filter(|_| random.below(8) > 0).collect();
    mesh = mesh.with_triangle_order(&kept);
    let greedy = stripify(&mesh, &options("greedy")).unwrap();
    let few_moves = options("cheapest").with_effort(0.02);
    let strips = [1, 3].map(|count| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(count).build().unwrap();
        pool.install(|| stripify(&mesh, &few_moves).unwrap())
    });
    check(&mesh, &strips[0], "sphere with holes");
    assert!(strips[0] == strips[1]);
    assert!(strips[0].cost().index_count < greedy.cost().index_count);
}

#[test]
fn strips_do_not_cross_groups() {
    let mut mesh = shapes::grid(12, 12);
    let third = mesh.triangle_count() as u32 / 3;
    let group = |first, count| TriangleGroup { first, count, ..TriangleGroup::default() };
    mesh.groups = vec![group(0, third), group(third, 0), group(third, mesh.triangle_count() as u32 - third)];
    check_all(&mesh, "grid in groups");
}

proptest! {
    #![proptest_config(striata_testing::cases(48))]

    #[test]
    fn random_soups_are_covered(seed in any::<u64>(), vertices in 3u32..30, triangles in 0u32..80) {
        check_all(&soup(vertices, triangles, seed), "soup");
    }

    /// Strips of another mesh do not help, but do no harm either.
    #[test]
    fn foreign_strips_do_no_harm(seed in any::<u64>(), indices in prop::collection::vec(0u32..30, 0..40)) {
        let mesh = soup(20, 40, seed);
        let mut start = StripSet::new();
        for strip in indices.chunks(7) {
            start.push(strip);
        }
        start.end_group();
        for spec in SPECS {
            check(&mesh, &stripify_from(&mesh, &start, &options(spec), &mut short_budget()).unwrap(), spec);
        }
    }
}

#[test]
fn longer_tunnels_leave_fewer_strips() {
    let mesh = shapes::torus(60, 40, 1.0, 0.4);
    let count = |spec: &str| stripify(&mesh, &options(spec)).unwrap().strip_count();
    assert!(count("tunnel:21") < count("tunnel:5"), "{} and {}", count("tunnel:21"), count("tunnel:5"));
    assert!(count("tunnel:5") < count("tunnel:1"));
}

#[test]
fn names_are_parsed_and_wrong_ones_refused() {
    for spec in SPECS {
        assert_eq!(spec.parse::<Stripifier>().unwrap().to_string(), spec);
    }
    assert_eq!("tunnel".parse(), Ok(Stripifier::Tunnel { max_length: 17 }));
    for wrong in ["", "tunnel:", "tunnel:0", "tunnel:-1", "greedy:3", "Greedy", "tunnel:99999999999"] {
        let error = wrong.parse::<Stripifier>().unwrap_err().to_string();
        assert!(error.contains("tunnel[:MAX]"), "{error}");
    }
}

/// Finds the fewest possible strips by trying every set of links.
fn fewest_by_exhaustive_search(mesh: &IndexedMesh) -> usize {
    let graph = DualGraph::of_vertices(mesh);
    let mut links = Vec::new();
    for side in 0..3 * mesh.triangle_count() as u32 {
        if let Some(twin) = graph.twin(side).filter(|&twin| side < twin) {
            links.push((side as usize / 3, twin as usize / 3));
        }
    }
    let triangle_count = proper(&mesh.triangles).len();
    let most = (0u32..1 << links.len()).filter(|&set| is_strips(&links, set, mesh.triangle_count()));
    triangle_count - most.map(u32::count_ones).max().unwrap_or(0) as usize
}

/// Whether a set of links has at most two links per triangle and no loop.
fn is_strips(links: &[(usize, usize)], set: u32, triangle_count: usize) -> bool {
    let mut degrees = [0; 32];
    let mut roots: [usize; 32] = std::array::from_fn(|i| i);
    for (i, &(a, b)) in links.iter().enumerate() {
        if set & 1 << i != 0 {
            degrees[a] += 1;
            degrees[b] += 1;
            let (ra, rb) = (roots[a], roots[b]);
            if degrees[a] > 2 || degrees[b] > 2 || ra == rb {
                return false;
            }
            roots[..triangle_count].iter_mut().filter(|r| **r == rb).for_each(|r| *r = ra);
        }
    }
    true
}

fn check_bound(mesh: &IndexedMesh) {
    let fewest = fewest_by_exhaustive_search(mesh);
    let bound = strip_count_bound(mesh);
    assert!(bound <= fewest, "a bound of {bound}, but {fewest} strips will do");
    for spec in SPECS {
        let count = stripify(mesh, &options(spec)).unwrap().strip_count();
        // Strips joined by `cheapest` count as one, because they need no restart.
        assert!(
            count >= fewest || spec == "cheapest",
            "{spec}: {count} strips where {fewest} are the fewest"
        );
    }
}

#[test]
fn bounds_hold_on_small_shapes() {
    // A bound need not be tight.
    assert_eq!(
        (strip_count_bound(&shapes::grid(3, 3)), fewest_by_exhaustive_search(&shapes::grid(3, 3))),
        (2, 3)
    );
    for mesh in
        [shapes::grid(3, 2), shapes::grid(3, 3), shapes::tetrahedron(), shapes::closed_fan(7), shapes::cube()]
    {
        check_bound(&mesh);
    }
}

proptest! {
    #![proptest_config(striata_testing::cases(64))]

    #[test]
    fn bounds_hold_on_random_soups(seed in any::<u64>(), vertices in 5u32..12, triangles in 1u32..13) {
        check_bound(&soup(vertices, triangles, seed));
    }
}

#[test]
fn every_stripifier_can_be_cancelled_at_each_report() {
    let mesh = shapes::terrain(100, 1);
    for (spec, cache_weight) in SPECS.map(|spec| (spec, 0.0)).into_iter().chain([("greedy", 1.0)]) {
        let options = options(spec).with_cache_weight(cache_weight);
        let expected = stripify(&mesh, &options).unwrap();
        let mut reports = 0_usize;
        let strips = stripify_with_progress(&mesh, &options, &mut |now| {
            assert!(now.phase == "strip" && now.done <= now.total, "{now:?}");
            reports += 1;
            ControlFlow::Continue(())
        });
        assert!(reports > 0, "{spec}");
        assert_eq!(strips.unwrap().indices(), expected.indices(), "{spec}");
        for last in [1, reports.div_ceil(2), reports] {
            let mut calls = 0;
            let stopped = stripify_with_progress(&mesh, &options, &mut |_| {
                calls += 1;
                if calls < last { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
            });
            assert!(matches!(stopped, Err(StripifyError::Cancelled(_))), "{spec}, report {last}");
            assert_eq!(calls, last, "{spec} goes on");
        }
    }
}
