//! Order of triangles for the vertex cache, and of vertices by first use: nothing is lost, turned over, or detached
//! from its data.

use proptest::prelude::*;
use striata::mesh::{AttributeLayer, IndexedMesh, LayerData, Semantic};
use striata::strip::{cache_order, fifo_cache_cost};
use striata_testing::{meshes, support};
use support::{Random, nasty, soup, with_seams_and_groups};

/// A mesh whose triangles and vertices have numbers.
fn numbered(mut mesh: IndexedMesh) -> IndexedMesh {
    let numbers = |count: usize| AttributeLayer {
        semantic: Semantic::Generic("number".to_owned()),
        component_count: 1,
        normalized: false,
        data: LayerData::U32((0..count as u32).collect()),
    };
    mesh.triangle_layers = vec![numbers(mesh.triangle_count())];
    mesh.layers.push(numbers(mesh.vertex_count()));
    mesh
}

fn check(name: &str, mesh: &IndexedMesh) {
    let order = cache_order(&mesh.triangles);
    let mut sorted = order.clone();
    sorted.sort_unstable();
    assert!(sorted.into_iter().eq(0..mesh.triangle_count() as u32), "{name}");
    let mesh = numbered(mesh.clone());
    let ordered = mesh.with_triangle_order(&order).with_vertices_by_first_use();
    let [of_triangle, of_vertex] = [ordered.triangle_layers.last(), ordered.layers.last()].map(|layer| {
        let Some(AttributeLayer { data: LayerData::U32(numbers), .. }) = layer else { panic!("{name}") };
        numbers
    });
    let mut next = 0;
    for (triangle, &number) in ordered.triangles.iter().zip(of_triangle) {
        assert_eq!(triangle.map(|v| of_vertex[v as usize]), mesh.triangles[number as usize], "{name}");
        for &v in triangle {
            assert!(v <= next, "{name}: vertex {v} comes before {next}");
            next = next.max(v + 1);
        }
    }
    assert_eq!(ordered.vertex_count(), mesh.vertex_count(), "{name}");
    for (v, &number) in of_vertex.iter().enumerate() {
        let bits = |p: [f32; 3]| p.map(f32::to_bits);
        assert_eq!(bits(ordered.positions[v]), bits(mesh.positions[number as usize]), "{name}");
    }
}

#[test]
fn difficult_meshes_keep_their_triangles() {
    let named = |(name, mesh): (&'static str, IndexedMesh)| (name.to_owned(), mesh);
    let all = nasty().into_iter().chain(meshes::nasty()).map(named).chain(meshes::all());
    for (name, mesh) in all {
        // Meshes may be inconsistent, but not have triangles without vertices.
        if mesh.triangles.iter().flatten().all(|&v| (v as usize) < mesh.vertex_count()) {
            check(&name, &IndexedMesh::new(mesh.positions, mesh.triangles));
        }
    }
}

#[test]
fn an_order_never_needs_many_more_misses() {
    for (name, mesh) in meshes::all() {
        let misses = |mesh: &IndexedMesh| {
            fifo_cache_cost(mesh.triangles.as_flattened(), mesh.triangle_count(), 16).miss_count
        };
        let ordered = mesh.with_triangle_order(&cache_order(&mesh.triangles));
        let [before, after] = [&mesh, &ordered].map(misses);
        assert!(after <= before + before / 4, "{name}: {after} misses instead of {before}");
    }
}

proptest! {
    #[test]
    fn random_meshes_keep_their_triangles(seed: u64, vertex_count in 1usize..40, triangle_count in 0usize..200) {
        let mesh = soup(vertex_count, triangle_count, &mut Random::new(seed));
        check("soup", &mesh);
        check("soup with seams", &with_seams_and_groups(mesh));
    }
}
