//! Build, load and move times of LodStrips, MTS, fans and patterns, and the cost of an MTS step compared
//! with a full recovery.

use std::hint::black_box;

use criterion::measurement::WallTime;
use criterion::{BatchSize, BenchmarkGroup, Criterion, Throughput, criterion_group, criterion_main};
use striata::file::{FileModel, StriataFile, WriteOptions, to_striata};
use striata::mesh::{FragmentedMesh, IndexedMesh, RefinableMesh, shapes};
use striata::model::{
    FanForm, FanIndices, FanInstance, FanMorphs, Fans, LodModel, LodStrips, Mts, Overlap, PatternInstance,
    Patterns, StripBuffer,
};
use striata::simplify::{SequenceOptions, build_sequence};
use striata::strip::stripify;

/// A sphere with about `2 * ring_count * ring_count` vertices.
fn sphere(ring_count: u32) -> IndexedMesh {
    let side_count = 2 * ring_count;
    let mut positions = Vec::new();
    for ring in 0..=ring_count {
        let polar = std::f32::consts::PI * ring as f32 / ring_count as f32;
        for side in 0..side_count {
            let turn = std::f32::consts::TAU * side as f32 / side_count as f32;
            positions.push([polar.sin() * turn.cos(), polar.sin() * turn.sin(), polar.cos()]);
        }
    }
    let mut triangles = Vec::new();
    for ring in 0..ring_count {
        for side in 0..side_count {
            let at = |r: u32, s: u32| r * side_count + s % side_count;
            let [a, b] = [at(ring, side), at(ring + 1, side)];
            let [c, d] = [at(ring + 1, side + 1), at(ring, side + 1)];
            triangles.extend([[a, b, c], [a, c, d]]);
        }
    }
    IndexedMesh::new(positions, triangles)
}

fn refinable(mesh: &IndexedMesh) -> RefinableMesh {
    build_sequence(mesh, &SequenceOptions::default()).expect("the mesh is sound").refinable
}

fn lod_strips(c: &mut Criterion) {
    let mut group = c.benchmark_group("lod_strips");
    group.sample_size(20);
    for (name, mesh) in [("sphere", sphere(132)), ("sphere_large", sphere(374))] {
        let refinable = refinable(&mesh);
        group.bench_function(format!("stripify/{name}"), |b| b.iter(|| stripify(&refinable.mesh)));
        let strips = stripify(&refinable.mesh).expect("the mesh is sound");
        group.bench_function(format!("build/{name}"), |b| b.iter(|| LodStrips::build(&refinable, &strips)));
        let model = LodStrips::build(&refinable, &strips).expect("the strips are those of the mesh");
        let step_count = model.step_count();
        let mut state = model.new_state();
        group.bench_function(format!("sweep/{name}"), |b| {
            b.iter(|| {
                model.move_to(&mut state, 0);
                model.move_to(&mut state, step_count);
            })
        });
        let mut buffer = StripBuffer::new(&model, &mut state);
        group.bench_function(format!("sweep_with_buffer/{name}"), |b| {
            b.iter(|| {
                for percent in (0..100).rev().chain(0..=100) {
                    model.move_to(&mut state, step_count * percent / 100);
                    buffer.sync(&model, &mut state);
                    black_box(buffer.take_changed_ranges());
                }
            })
        });
        let models = [FileModel::LodStrips(&model)];
        let bytes = to_striata(&refinable, &models, &WriteOptions::default()).expect("memory does not fail");
        group.bench_function(format!("load/{name}"), |b| {
            b.iter_batched(
                || StriataFile::parse(&bytes).expect("written just now"),
                |file| file.lod_strips().map(|model| model.is_ok()),
                BatchSize::SmallInput,
            )
        });
    }
    group.finish();
}

fn mts(c: &mut Criterion) {
    let mut group = c.benchmark_group("mts");
    group.sample_size(20);
    for (name, mesh) in [("sphere", sphere(132)), ("sphere_large", sphere(374))] {
        let refinable = refinable(&mesh);
        let strips = stripify(&refinable.mesh).expect("the mesh is sound");
        group.bench_function(format!("build/{name}"), |b| b.iter(|| Mts::build(&refinable, &strips)));
        let model = Mts::build(&refinable, &strips).expect("the strips are those of the mesh");
        let mut state = model.new_state();
        for percent in [100, 50, 10] {
            let split_count = model.step_count() * percent / 100;
            model.move_to(&mut state, split_count);
            group.bench_function(format!("recover/{name}/{percent}"), |b| {
                b.iter(|| model.recover(&mut state))
            });
            group.bench_function(format!("steps_200/{name}/{percent}"), |b| {
                b.iter(|| {
                    let steps = split_count.saturating_sub(100)..split_count;
                    steps.clone().rev().for_each(|at| model.move_to(&mut state, at));
                    steps.for_each(|at| model.move_to(&mut state, at + 1));
                })
            });
        }
        let models = [FileModel::Mts(&model)];
        let bytes = to_striata(&refinable, &models, &WriteOptions::default()).expect("memory does not fail");
        group.bench_function(format!("load/{name}"), |b| {
            b.iter_batched(
                || StriataFile::parse(&bytes).expect("written just now"),
                |file| file.mts().map(|model| model.is_ok()),
                BatchSize::SmallInput,
            )
        });
    }
    group.finish();
}

fn fans(c: &mut Criterion) {
    let mut group = c.benchmark_group("fans");
    group.sample_size(20);
    for (name, mesh) in [("sphere", sphere(132)), ("sphere_large", sphere(374))] {
        let refinable = refinable(&mesh);
        group.bench_function(format!("build/{name}"), |b| b.iter(|| Fans::build_without_bounds(&refinable)));
        let table = Fans::build(&refinable);
        let steps = 0..table.step_count() as u32;
        let mut out = Vec::new();
        for percent in [100, 50, 10] {
            let instance = FanInstance::uniform(&table, table.step_count() * percent / 100);
            instance.indices_into(&table, &mut out);
            group.throughput(Throughput::Elements(out.len() as u64 / 3));
            group.bench_function(format!("emit/{name}/{percent}"), |b| {
                b.iter(|| {
                    out.clear();
                    instance.indices_into(&table, &mut out);
                })
            });
            out.clear();
            emit_forms(&mut group, name, percent, &table, &instance);
        }
        let [coarse, fine] =
            [10, 12].map(|percent| FanInstance::uniform(&table, table.step_count() * percent / 100));
        group.throughput(Throughput::Elements(1));
        let mut morphs = FanMorphs::new(&coarse, 60);
        let mut positions = refinable.mesh.positions.clone();
        let mut frame = 0;
        // The direction reverses every 30 frames, so vertices always move.
        group.bench_function(format!("morph_frame/{name}"), |b| {
            b.iter(|| {
                frame += 1;
                morphs.advance(&table, if frame / 30 % 2 == 0 { &fine } else { &coarse });
                morphs.positions_into(&refinable.sequence, &refinable.mesh.positions, &mut positions);
            })
        });
        let mut instance = FanInstance::full(&table);
        group.throughput(Throughput::Elements(2 * table.step_count() as u64));
        group.bench_function(format!("change_all/{name}"), |b| {
            b.iter(|| {
                let collapsed: usize = steps.clone().map(|step| instance.collapse(&table, step)).sum();
                let split: usize = steps.clone().rev().map(|step| instance.split(&table, step)).sum();
                (collapsed, split)
            })
        });
        group.throughput(Throughput::Elements(table.vertex_count() as u64));
        group.bench_function(format!("build_with_bounds/{name}"), |b| b.iter(|| Fans::build(&refinable)));
        let models = [FileModel::Fans(&table)];
        let bytes = to_striata(&refinable, &models, &WriteOptions::default()).expect("memory does not fail");
        group.bench_function(format!("load/{name}"), |b| {
            b.iter_batched(
                || StriataFile::parse(&bytes).expect("written just now"),
                |file| file.fans().map(|model| model.is_ok()),
                BatchSize::SmallInput,
            )
        });
    }
    group.finish();
}

/// Benches the other output forms, and triangles on all threads.
fn emit_forms(
    group: &mut BenchmarkGroup<'_, WallTime>,
    name: &str,
    percent: usize,
    table: &Fans,
    instance: &FanInstance,
) {
    let mut out = FanIndices::default();
    for (form, verb) in [(FanForm::Fans, "emit_fans"), (FanForm::Strips, "emit_strips")] {
        group.bench_function(format!("{verb}/{name}/{percent}"), |b| {
            b.iter(|| instance.emit_into(table, form, &mut out))
        });
    }
    group.bench_function(format!("emit_parallel/{name}/{percent}"), |b| {
        b.iter(|| instance.emit_parallel_into(table, FanForm::Triangles, &mut out))
    });
}

/// Extracts patterns from the base by a condition, from a thousand triangles to a whole large sphere: time
/// is linear in the output.
fn patterns(c: &mut Criterion) {
    let mut group = c.benchmark_group("patterns");
    group.sample_size(10);
    let mesh = shapes::uv_sphere(448, 896, 1.0);
    let fragmented = FragmentedMesh::from_collapses(&refinable(&mesh));
    group.bench_function("build", |b| b.iter(|| Patterns::build_without_bounds(&fragmented)));
    let patterns = Patterns::build(&fragmented).expect("the mesh is not too large");
    let levels = fragmented.fragments.levels();
    let sizes = std::iter::successors(Some(1_000), |size| Some(4 * size));
    let sizes = sizes.take_while(|&size| size < mesh.triangle_count()).chain([mesh.triangle_count()]);
    let mut out = Vec::new();
    for size in sizes {
        let split_count = levels.split_count_for_triangles(size) as u32;
        group.throughput(Throughput::Elements(size as u64));
        group.bench_function(format!("extract/{size}"), |b| {
            b.iter(|| {
                let mut instance = PatternInstance::base(&patterns);
                instance.adapt(&patterns, &|overlap: Overlap| overlap.upper < split_count);
                out.clear();
                instance.triangles_into(&mut out);
                out.len()
            });
        });
    }
    group.finish();
}

criterion_group!(benches, lod_strips, mts, fans, patterns);
criterion_main!(benches);
