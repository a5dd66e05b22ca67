//! Benchmarks of building collapse sequences; ids are `simplify/MESH/full`.
//!
//! Besides generated meshes, it measures the files listed in the environment variable `STRIATA_MESHES`,
//! separated by `:`.

use criterion::{BatchSize, Criterion, Throughput, criterion_group, criterion_main};
use striata::mesh::{IndexedMesh, shapes, weld};
use striata::simplify::{CostFunction, SequenceOptions, build_welded_sequence};

fn meshes() -> Vec<(String, IndexedMesh)> {
    let mut meshes = vec![
        ("sphere".to_owned(), shapes::paper_sphere()),
        ("terrain".to_owned(), shapes::terrain(180, 1)),
        ("two_materials".to_owned(), shapes::two_material_sphere(87, 176)),
    ];
    let files = std::env::var("STRIATA_MESHES").unwrap_or_default();
    for file in files.split(':').filter(|file| !file.is_empty()) {
        match striata_io::read(file) {
            Ok(mesh) => {
                let name = std::path::Path::new(file).file_name().map(|name| name.to_string_lossy());
                meshes.push((name.unwrap_or_default().into_owned(), mesh));
            }
            Err(error) => eprintln!("skipped: {error}"),
        }
    }
    meshes
}

fn simplify(c: &mut Criterion) {
    let mut group = c.benchmark_group("simplify");
    group.sample_size(10);
    for (name, mesh) in meshes() {
        let welded = match weld(&mesh) {
            Ok(welded) => welded,
            Err(error) => {
                eprintln!("skipped: {name}: {error}");
                continue;
            }
        };
        group.throughput(Throughput::Elements(welded.mesh.triangle_count() as u64));
        for &cost in CostFunction::ALL {
            let id = if cost == CostFunction::default() { "full" } else { &format!("full_{}", cost.name()) };
            let options = SequenceOptions::default().with_cost(cost);
            group.bench_function(format!("{name}/{id}"), |b| {
                b.iter_batched(
                    || welded.clone(),
                    |welded| build_welded_sequence(welded, &options),
                    BatchSize::PerIteration,
                );
            });
        }
    }
    group.finish();
}

criterion_group!(benches, simplify);
criterion_main!(benches);
