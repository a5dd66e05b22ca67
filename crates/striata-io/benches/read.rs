//! Reading speed in bytes per second.
//!
//! Files come from the environment variable `STRIATA_MESHES`, separated by `:`. Benchmark ids are
//! `read/NAME`, plus `tobj/NAME` for every OBJ. The bytes are in memory before the clock starts.

use std::hint::black_box;
use std::path::Path;

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use striata_io::{Source, read_bytes};

fn read_files(criterion: &mut Criterion) {
    let files = std::env::var("STRIATA_MESHES").unwrap_or_default();
    for file in files.split(':').filter(|file| !file.is_empty()) {
        let path = Path::new(file);
        let Ok(bytes) = std::fs::read(path) else {
            eprintln!("skipped: {file} cannot be read");
            continue;
        };
        let name = path.file_name().map_or(file.into(), |name| name.to_string_lossy());
        let mut source = Source::new(file);
        source.folder = path.parent();
        let mut group = criterion.benchmark_group("read");
        group.throughput(Throughput::Bytes(bytes.len() as u64));
        group.bench_function(name.as_ref(), |b| b.iter(|| read_bytes(black_box(&bytes), &source)));
        group.finish();
        if name.ends_with(".obj") {
            bench_tobj(criterion, &name, &bytes);
        }
    }
}

/// Measures `tobj` for comparison, with triangulation and a single index per corner.
fn bench_tobj(criterion: &mut Criterion, name: &str, bytes: &[u8]) {
    let mut group = criterion.benchmark_group("tobj");
    group.throughput(Throughput::Bytes(bytes.len() as u64));
    group.bench_function(name, |b| {
        b.iter(|| {
            let mut reader = black_box(bytes);
            tobj::load_obj_buf(&mut reader, &tobj::GPU_LOAD_OPTIONS, |_| Ok(Default::default()))
        });
    });
    group.finish();
}

criterion_group! {
    name = benches;
    config = Criterion::default().sample_size(20);
    targets = read_files
}
criterion_main!(benches);
