//! Strips for a vertex cache, and the miss counts by which they are rated.

use striata_testing::{meshes, support};

use proptest::prelude::*;
use striata::mesh::{IndexedMesh, canonical_triangles, shapes};
use striata::strip::{RESTART, StripSet, fifo_cache_cost, lru_cache_cost};
use striata_strip::{StripOptions, Stripifier, stripify};
use support::{Random, grid, nasty, soup, with_seams_and_groups};

fn options(weight: f64) -> StripOptions {
    StripOptions::default().with_cache_weight(weight)
}

/// Counts indices, including restarts, and misses of a first-in first-out cache.
fn counts(strips: &StripSet, cache_size: usize) -> (usize, usize) {
    let indices = strips.to_restart_indices().indices;
    (indices.len(), fifo_cache_cost(&indices, 1, cache_size).miss_count)
}

fn price(strips: &StripSet, options: &StripOptions) -> f64 {
    let (index_count, miss_count) = counts(strips, options.cache_size);
    index_count as f64 + options.cache_weight * miss_count as f64
}

/// Checks that each group of strips draws the triangles of the mesh's group exactly once, with their winding.
fn assert_covers(name: &str, mesh: &IndexedMesh, strips: &StripSet) {
    assert_eq!(strips.group_count(), mesh.groups_or_whole().len(), "{name}");
    for (g, group) in mesh.groups_or_whole().iter().enumerate() {
        let mut expected = mesh.triangles[group.range()].to_vec();
        expected.retain(|t| t[0] != t[1] && t[1] != t[2] && t[2] != t[0]);
        let mut found = Vec::new();
        for strip in strips.group_strips(g) {
            found.extend(striata::strip::strip_triangles(strips.strip(strip)));
        }
        assert_eq!(canonical_triangles(&found), canonical_triangles(&expected), "{name}, group {g}");
    }
}

fn assert_improves(name: &str, mesh: &IndexedMesh, options: &StripOptions) {
    let plain = stripify(mesh, &options.clone().with_cache_weight(0.0)).unwrap();
    let strips = stripify(mesh, options).unwrap();
    assert_covers(name, mesh, &strips);
    assert!(price(&strips, options) <= price(&plain, options), "{name}: {options:?}");
}

#[test]
fn degenerate_meshes_are_covered() {
    let mut meshes = nasty();
    meshes.extend(meshes::nasty().into_iter().filter(|(_, mesh)| mesh.check().is_ok()));
    for (name, mesh) in meshes {
        for (weight, size) in [(0.05, 16), (1.0, 16), (3.0, 3), (1.0, 0), (1.0, 2), (0.5, usize::MAX)] {
            assert_improves(name, &mesh, &options(weight).with_cache_size(size));
        }
    }
}

#[test]
fn groups_are_not_crossed() {
    let mesh = with_seams_and_groups(grid(9, true));
    let mesh = striata::mesh::weld(&mesh).unwrap().mesh;
    for weight in [0.05, 1.0] {
        assert_improves("patches", &mesh, &options(weight));
    }
}

#[test]
fn a_grid_is_drawn_in_rows_that_the_cache_remembers() {
    let mesh = grid(60, false);
    let triangle_count = mesh.triangle_count() as f64;
    let strips = stripify(&mesh, &options(1.0)).unwrap();
    assert_covers("grid", &mesh, &strips);
    let (index_count, miss_count) = counts(&strips, 16);
    // Rows of 14 squares would take 31 indices and 15 misses per 28 triangles.
    assert!((index_count as f64) < 1.2 * triangle_count, "{index_count} indices");
    assert!((miss_count as f64) < 0.62 * triangle_count, "{miss_count} misses");
}

#[test]
fn higher_weights_give_fewer_misses() {
    let mesh = shapes::icosphere(4, 1.0);
    let misses: Vec<usize> =
        [0.0, 0.05, 1.0].map(|weight| counts(&stripify(&mesh, &options(weight)).unwrap(), 16).1).to_vec();
    assert!(misses[0] >= misses[1] && misses[1] > misses[2], "{misses:?}");
    let larger = stripify(&mesh, &options(1.0).with_cache_size(32)).unwrap();
    assert!(counts(&larger, 32).1 < misses[2]);
}

#[test]
fn small_weights_keep_the_indices() {
    let mesh = shapes::terrain(64, 3);
    let plain = stripify(&mesh, &options(0.0)).unwrap();
    let ordered = stripify(&mesh, &options(0.01)).unwrap();
    assert_eq!(counts(&ordered, 16).0, counts(&plain, 16).0);
    assert!(counts(&ordered, 16).1 <= counts(&plain, 16).1);
}

#[test]
fn any_stripifier_works_and_equal_options_agree() {
    let mesh = shapes::torus(24, 16, 2.0, 0.7);
    for spelling in ["greedy", "stripe", "tunnel:5", "cheapest"] {
        let options = options(1.0).with_stripifier(spelling.parse::<Stripifier>().unwrap());
        assert_improves(spelling, &mesh, &options);
        assert_eq!(stripify(&mesh, &options), stripify(&mesh, &options));
    }
}

#[test]
fn stripe_covers_degenerate_meshes() {
    for (name, mesh) in nasty() {
        let options = StripOptions::default().with_stripifier("stripe".parse().unwrap());
        assert_covers(name, &mesh, &stripify(&mesh, &options).unwrap());
    }
}

#[test]
fn a_hub_of_many_triangles_is_not_slow() {
    // Quadratic work around the hub would take minutes.
    let mesh = shapes::closed_fan(200_000);
    let strips = stripify(&mesh, &options(1.0)).unwrap();
    assert_covers("hub", &mesh, &strips);
}

/// Counts misses with a plain list of the cached vertices, the newest last.
fn naive_misses(indices: &[u32], cache_size: usize, is_lru: bool) -> usize {
    let mut cached: Vec<u32> = Vec::new();
    let mut miss_count = 0;
    for &v in indices.iter().filter(|&&v| v != RESTART) {
        match cached.iter().position(|&other| other == v) {
            Some(place) if is_lru => {
                cached.remove(place);
                cached.push(v);
            }
            Some(_) => {}
            None => {
                miss_count += 1;
                cached.push(v);
                if cached.len() > cache_size {
                    cached.remove(0);
                }
            }
        }
    }
    miss_count
}

proptest! {
    #![proptest_config(striata_testing::cases(64))]

    #[test]
    fn miss_counts_match_plain_lists(
        indices in prop::collection::vec(prop_oneof![8 => 0u32..40, 1 => Just(RESTART), 1 => Just(4_000_000_000)], 0..300),
        cache_size in 0usize..24,
    ) {
        let fifo = fifo_cache_cost(&indices, 7, cache_size);
        let lru = lru_cache_cost(&indices, 7, cache_size);
        prop_assert_eq!(fifo.miss_count, naive_misses(&indices, cache_size, false));
        prop_assert_eq!(lru.miss_count, naive_misses(&indices, cache_size, true));
        prop_assert_eq!(lru.acmr, lru.miss_count as f64 / 7.0);
    }

    #[test]
    fn random_meshes_are_covered_at_no_higher_cost(
        seed in any::<u64>(),
        vertex_count in 3usize..60,
        triangle_count in 0usize..200,
        weight in prop_oneof![Just(0.03), 0.1f64..4.0],
        cache_size in 0usize..40,
        effort in prop_oneof![Just(0.1), Just(1.0)],
    ) {
        let mesh = soup(vertex_count, triangle_count, &mut Random::new(seed));
        assert_improves("soup", &mesh, &options(weight).with_cache_size(cache_size).with_effort(effort));
    }
}
