//! Benchmarks of surface distance: building the tree, single queries, and whole measurements.

use std::hint::black_box;

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use striata::mesh::{DistanceOptions, IndexedMesh, Random, TriangleTree, shapes, surface_distance};

const QUERIES: usize = 10_000;

/// Points near the surface, in the order of its triangles: the access pattern of sampling.
fn points_near(mesh: &IndexedMesh) -> Vec<[f64; 3]> {
    let mut random = Random::new(1);
    let offset = 1e-3 * mesh.diagonal() as f32;
    let stride = (mesh.triangle_count() / QUERIES).max(1);
    let near = |t: &[u32; 3], random: &mut Random| {
        mesh.positions[t[0] as usize].map(|x| f64::from(x + random.between(-offset, offset)))
    };
    mesh.triangles.iter().step_by(stride).cycle().take(QUERIES).map(|t| near(t, &mut random)).collect()
}

fn meshes() -> Vec<(&'static str, IndexedMesh)> {
    vec![
        ("sphere_30k", shapes::paper_sphere()),
        ("terrain_10k", shapes::terrain(71, 1)),
        ("terrain_100k", shapes::terrain(224, 1)),
        ("terrain_1M", shapes::terrain(707, 1)),
    ]
}

fn query(c: &mut Criterion) {
    let mut group = c.benchmark_group("distance_query");
    group.sample_size(10).throughput(Throughput::Elements(QUERIES as u64));
    for (name, mesh) in meshes() {
        let points = points_near(&mesh);
        let tree = TriangleTree::new(&mesh).expect("generated meshes are consistent");
        group.bench_with_input(BenchmarkId::new("striata", name), &points, |b, points| {
            b.iter(|| points.iter().map(|&p| tree.distance_to(p)).sum::<f64>());
        });
    }
}

fn build(c: &mut Criterion) {
    let mut group = c.benchmark_group("distance_tree");
    group.sample_size(10);
    for (name, mesh) in meshes() {
        group.throughput(Throughput::Elements(mesh.triangle_count() as u64));
        group.bench_with_input(BenchmarkId::new("striata", name), &mesh, |b, mesh| {
            b.iter(|| TriangleTree::new(black_box(mesh)));
        });
    }
}

fn measure(c: &mut Criterion) {
    let mut group = c.benchmark_group("distance");
    let options = DistanceOptions::default().with_sample_count(100_000);
    group.sample_size(10);
    for (name, mesh) in meshes() {
        let mut moved = mesh.clone();
        let offset = 1e-3 * mesh.diagonal() as f32;
        moved.positions.iter_mut().for_each(|p| *p = p.map(|x| x + offset));
        group.bench_with_input(
            BenchmarkId::new("both_ways_100k", name),
            &(mesh, moved),
            |b, (mesh, moved)| {
                b.iter(|| surface_distance(mesh, moved, &options));
            },
        );
    }
}

criterion_group!(benches, query, build, measure);
criterion_main!(benches);
