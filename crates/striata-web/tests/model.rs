//! The model as a page uses it: bytes in, levels out, and a clean error for any damaged bytes.

use striata::file::{FileModel, WriteOptions, to_striata, write_fragments};
use striata::ignore_progress;
use striata::mesh::{
    AttributeLayer, IndexedMesh, Random, Semantic, TriangleGroup, canonical_triangles, replay,
    replay_fragments, shapes,
};
use striata::model::Fans;
use striata::simplify::{
    BatchOptions, RemovalOptions, SequenceOptions, build_batches, build_fragments, build_sequence,
};
use striata_io::{Format, to_bytes};
use striata_stream::{StreamDecoder, StreamOptions, encode_stream, file_model};
use striata_web::{Model, StreamPlace, View};

/// A torus with colors and two groups.
fn torus() -> IndexedMesh {
    let mut mesh = shapes::torus(48, 24, 1.0, 0.4);
    let colors = mesh.positions.iter().flat_map(|p| p.map(|x| x.mul_add(0.25, 0.5))).collect();
    mesh.layers.push(AttributeLayer::from_f32(Semantic::Color(0), 3, colors));
    let half = mesh.triangle_count() as u32 / 2;
    for (name, first) in [("a", 0), ("b", half)] {
        mesh.groups.push(TriangleGroup { name: name.to_owned(), material: None, first, count: half });
    }
    mesh
}

fn stream_of(mesh: &IndexedMesh) -> Vec<u8> {
    let built = build_batches(mesh, &BatchOptions::default()).unwrap();
    encode_stream(&built.built.refinable, &built.batches, &StreamOptions::default()).unwrap().bytes
}

fn decoded(bytes: &[u8]) -> Model {
    let mut model = Model::new();
    bytes.chunks(700).for_each(|chunk| model.push(chunk).unwrap());
    model.reveal();
    model
}

fn triangles(model: &Model) -> Vec<[u32; 3]> {
    let indices = model.indices();
    let (triangles, rest) = indices.as_chunks::<3>();
    assert!(rest.is_empty());
    assert_eq!(model.group_counts().iter().sum::<u32>() as usize, triangles.len());
    assert!(triangles.iter().flatten().all(|&v| (v as usize) < model.vertex_count()));
    canonical_triangles(triangles)
}

fn camera(eye: [f64; 3], pixels: f32, limit: u32) -> View {
    let numbers = [eye[0], eye[1], eye[2], 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.5, 800.0, 600.0];
    View::new(&numbers, pixels, limit).unwrap()
}

#[test]
fn levels_of_a_stream_keep_their_groups() {
    let bytes = stream_of(&torus());
    let mut model = decoded(&bytes);
    assert!(model.is_complete() && model.kind() == "stream");
    assert_eq!(model.group_count(), 2);
    let mut decoder = StreamDecoder::new();
    decoder.push(&bytes).unwrap();
    let refinable = decoder.refinable_mesh().unwrap();
    for detail in [0.0, 0.2, 0.7, 1.0] {
        model.show_detail(detail);
        let expected = replay(&refinable, model.shown_split_count());
        assert_eq!(triangles(&model), canonical_triangles(&expected.triangles), "detail {detail}");
        let counts: Vec<u32> = expected.groups.iter().map(|group| group.count).collect();
        assert_eq!(model.group_counts(), counts);
        let error = refinable.sequence.error_at(model.shown_split_count());
        assert_eq!(model.shown_error(), error);
    }
    assert!(Model::read(bytes, "torus.stri", &mut ignore_progress).unwrap().is_complete());
}

#[test]
fn views_are_shown_while_a_stream_loads() {
    let mut model = Model::new();
    let (mut full_counts, mut near_counts) = (Vec::new(), Vec::new());
    for (at, chunk) in stream_of(&torus()).chunks(200).enumerate() {
        let before = (model.vertex_count(), model.triangle_count());
        model.push(chunk).unwrap();
        model.grow();
        assert_eq!((model.vertex_count(), model.triangle_count()), before, "nothing new is shown yet");
        if model.is_ready() {
            model.show_view(&camera([1.6, 0.1, 0.1], 0.001, 0)).unwrap();
            triangles(&model);
        }
        if at % 3 == 0 {
            model.reveal();
        }
        if !model.is_ready() {
            continue;
        }
        // From so close that everything is refined: at least all that has arrived on this side is shown.
        assert!(model.show_view(&camera([1.6, 0.1, 0.1], 0.001, 0)).unwrap());
        near_counts.push(triangles(&model).len());
        full_counts.push(model.triangle_count());
        model.show_view(&camera([60.0, 1.0, 1.0], 5.0, 0)).unwrap();
        assert!(triangles(&model).len() <= model.triangle_count());
        assert_eq!(model.group_counts().len(), 2);
    }
    assert!(triangles(&model).len() < near_counts[near_counts.len() - 1] / 2);
    let pairs = near_counts.iter().zip(&full_counts);
    assert!(
        pairs.clone().all(|(near, full)| near <= full && near * 4 > *full),
        "{near_counts:?} of {full_counts:?}"
    );
    assert!(near_counts.is_sorted() && near_counts.len() > 3);
}

#[test]
fn requests_are_respected_while_a_stream_loads() {
    let bytes = stream_of(&torus());
    let mut model = Model::new();
    let (mut last, mut seen) = (0, 0);
    for chunk in bytes.chunks(200) {
        model.push(chunk).unwrap();
        model.reveal();
        if !model.is_ready() {
            continue;
        }
        model.show_detail(1.0);
        assert_eq!(model.indices().len(), 3 * model.triangle_count());
        model.show_triangles(600);
        let base_count = {
            let count = triangles(&model).len();
            model.show_detail(0.0);
            let base = triangles(&model).len();
            assert!(count <= 600.max(base), "{count} triangles");
            base
        };
        assert!(base_count <= model.triangle_count());
        model.show_error(0.05);
        assert!(model.shown_error() <= 0.05 || model.shown_split_count() * 2 < model.step_count());
        let vertices = model.vertices(last).take_positions();
        assert_eq!(vertices.len(), 3 * (model.vertex_count() - last));
        last = model.vertex_count();
        seen += 1;
    }
    assert!(seen > 3 && model.is_complete());
    assert_eq!(model.vertices(0).take_colors().unwrap().len(), 4 * model.vertex_count());
    assert!(model.vertices(0).take_normals().is_none());
    assert_eq!(model.smooth_normals().len(), 3 * model.vertex_count());
    assert!((model.diagonal() - torus().diagonal()).abs() < 0.01);
}

#[test]
fn distant_views_show_fewer_triangles_and_respect_their_limit() {
    let mut model = decoded(&stream_of(&torus()));
    let mut counts = Vec::new();
    for distance in [2.0, 8.0, 100.0] {
        assert!(model.show_view(&camera([distance, 0.3, 0.3], 1.0, 0)).unwrap());
        counts.push(triangles(&model).len());
    }
    assert!(counts[0] > counts[1] && counts[1] > counts[2], "{counts:?}");
    model.show_view(&camera([2.0, 0.3, 0.3], 0.01, 500)).unwrap();
    assert!(triangles(&model).len() <= 500);
    assert!(model.shown_error() > 0.0);
    assert!(model.show_view(&camera([0.0; 3], 1.0, 0)).is_err(), "the camera has no direction");
    assert!(View::new(&[0.0; 5], 1.0, 0).is_err());
}

#[test]
fn strips_and_fans_contain_the_shown_triangles() {
    let mut model = decoded(&stream_of(&torus()));
    let file = to_bytes(Format::Ply, &torus(), &Default::default()).unwrap();
    let mut file = Model::read(file, "torus.ply", &mut ignore_progress).unwrap();
    for model in [&mut model, &mut file] {
        model.show_detail(0.6);
        let shown = triangles(model);
        let groups = model.group_counts();
        let strips = model.color_strips().unwrap();
        assert_eq!((triangles(model), model.group_counts()), (shown.clone(), groups.clone()));
        let strip_count = strips.iter().max().unwrap() + 1;
        assert!(
            strips.len() == shown.len() && (strip_count as usize) < shown.len() / 4,
            "{strip_count} strips"
        );
        model.show_detail(0.6);
        let fans = model.color_fans();
        assert_eq!((triangles(model), model.group_counts()), (shown.clone(), groups));
        assert_eq!(fans.len(), shown.len());
    }
}

#[test]
fn a_truncated_stream_shows_what_was_decoded() {
    let bytes = stream_of(&torus());
    let mut model = decoded(&bytes[..bytes.len() / 2]);
    model.finish().unwrap();
    model.reveal();
    assert!(!model.is_complete() && model.is_ready());
    model.show_detail(1.0);
    assert_eq!(triangles(&model).len(), model.triangle_count());
    assert!(model.shown_error() > 0.0, "something is missing");
    model.show_view(&camera([2.0, 0.3, 0.3], 0.001, 0)).unwrap();
    assert!(model.shown_error() > 0.0 && !model.indices().is_empty());
    let mut nothing = decoded(&bytes[..20]);
    assert_eq!(nothing.finish().unwrap_err().code(), "corrupt");
    assert!(!nothing.is_ready());
}

#[test]
fn bytes_after_the_end_of_a_stream_are_rejected() {
    let bytes = stream_of(&torus());
    let longer = [&bytes[..], b"more"].concat();
    let mut model = Model::new();
    assert_eq!(model.push(&longer).unwrap_err().code(), "corrupt");
    // The part before the damage stays, for levels and for views.
    model.reveal();
    assert!(model.is_complete());
    model.show_view(&camera([1.6, 0.1, 0.1], 0.001, 0)).unwrap();
    let shown = triangles(&model);
    let mut whole = decoded(&bytes);
    whole.show_view(&camera([1.6, 0.1, 0.1], 0.001, 0)).unwrap();
    assert!(!shown.is_empty() && shown.len().abs_diff(triangles(&whole).len()) < shown.len() / 10);
    assert_eq!(Model::read(longer, "x.stri", &mut ignore_progress).unwrap_err().code(), "corrupt");
}

#[test]
fn damage_is_reported_and_never_panics() {
    let bytes = stream_of(&shapes::torus(24, 12, 1.0, 0.4));
    let mut random = Random::new(7);
    let mut failures = 0;
    for _ in 0..300 {
        let mut damaged = bytes.clone();
        for _ in 0..1 + random.below(3) {
            let at = random.below(damaged.len() as u32) as usize;
            damaged[at] ^= 1 << random.below(8);
        }
        let mut model = Model::new();
        let result = damaged.chunks(300).try_for_each(|chunk| model.push(chunk));
        if let Err(failure) = result {
            failures += 1;
            assert!(!failure.message().is_empty());
            assert!(["format", "corrupt", "unsupported", "too-large"].contains(&failure.code().as_str()));
        }
        model.reveal();
        if model.is_ready() {
            model.show_detail(0.5);
            triangles(&model);
            model.show_view(&camera([2.0, 0.3, 0.3], 1.0, 0)).unwrap();
            triangles(&model);
        }
    }
    assert!(failures > 290, "only {failures} of 300 are noticed");
}

#[test]
fn files_are_read_completely() {
    let large = shapes::torus(200, 100, 1.0, 0.4);
    let ply = to_bytes(Format::Ply, &large, &Default::default()).unwrap();
    let mut calls = 0;
    let mut progress = |_| {
        calls += 1;
        std::ops::ControlFlow::Continue(())
    };
    let mut model = Model::read(ply, "torus.ply", &mut progress).unwrap();
    assert!(calls > 0 && model.is_complete() && model.kind() == "mesh");
    assert_eq!(triangles(&model).len(), large.triangle_count());
    model.show_triangles(300);
    assert!(triangles(&model).len() <= 300);

    let refinable = build_sequence(&torus(), &SequenceOptions::default()).unwrap().refinable;
    let fans = Fans::build(&refinable);
    for models in [vec![], vec![FileModel::Fans(&fans)]] {
        let bytes = to_striata(&refinable, &models, &WriteOptions::default()).unwrap();
        assert_eq!(StreamPlace::find(&bytes).unwrap().length, 0.0);
        let mut model = Model::read(bytes.clone(), "torus.striata", &mut ignore_progress).unwrap();
        assert_eq!((model.kind().as_str(), model.step_count()), ("striata", refinable.sequence.step_count()));
        model.show_detail(0.3);
        let expected = replay(&refinable, model.shown_split_count()).triangles;
        assert_eq!(triangles(&model), canonical_triangles(&expected));
        let cut = bytes[..bytes.len() - 1].to_vec();
        assert_eq!(Model::read(cut, "torus.striata", &mut ignore_progress).unwrap_err().code(), "corrupt");
    }
}

#[test]
fn files_that_are_not_meshes_are_rejected() {
    let read =
        |bytes: &[u8], name: &str| Model::read(bytes.to_vec(), name, &mut ignore_progress).unwrap_err();
    assert_eq!(read(b"hello", "hello.txt").code(), "format");
    assert!(read(b"hello", "hello.txt").hint().unwrap().contains(".ply"));
    assert_eq!(read(b"ply\nformat ascii 1.0\nelement vertex x\n", "x.ply").code(), "corrupt");
    assert_eq!(read(b"v 0 0 0\n", "points.obj").code(), "unsupported");
    let mut model = Model::new();
    assert_eq!(model.push(b"hello, world").unwrap_err().code(), "format");
}

#[test]
fn the_header_locates_the_stream() {
    assert!(StreamPlace::find(b"STRIATA\0").unwrap().needed > 64.0);
    assert_eq!(StreamPlace::find(&[b'x'; 64]).unwrap_err().code(), "format");
    let mesh = torus();
    let built = build_batches(&mesh, &BatchOptions::default()).unwrap();
    let stream = encode_stream(&built.built.refinable, &built.batches, &StreamOptions::default()).unwrap();
    let models = [file_model(&stream.bytes).unwrap()];
    let bytes = to_striata(&built.built.refinable, &models, &WriteOptions::default()).unwrap();
    let mut length = 0;
    let place = loop {
        let place = StreamPlace::find(&bytes[..length]).unwrap();
        if place.needed as usize <= length {
            break place;
        }
        length = (place.needed as usize).min(bytes.len());
    };
    let start = place.offset as usize;
    assert_eq!(bytes[start..start + place.length as usize], stream.bytes);
    let mut damaged = bytes[..length].to_vec();
    damaged[70] ^= 1;
    assert_eq!(StreamPlace::find(&damaged).unwrap_err().code(), "corrupt");
    // A whole file is decoded from its stream, too.
    let model = Model::read(bytes, "torus.striata", &mut ignore_progress).unwrap();
    assert_eq!((model.kind().as_str(), model.triangle_count()), ("striata", mesh.triangle_count()));
}

#[test]
fn fans_of_removals_show_every_level() {
    let built = build_fragments(&torus(), &RemovalOptions::default()).unwrap();
    let fans = Fans::build(&built.fragmented);
    let mut bytes = Vec::new();
    let options = WriteOptions::default();
    write_fragments(&built.fragmented, &[FileModel::Fans(&fans)], &options, &mut bytes).unwrap();
    let mut model = Model::read(bytes, "torus.striata", &mut ignore_progress).unwrap();
    assert_eq!((model.kind().as_str(), model.group_count()), ("striata", 2));
    let step_count = built.fragmented.fragments.levels().step_count();
    for split_count in [0, step_count / 3, step_count] {
        model.show_detail(split_count as f64 / step_count as f64);
        let expected = replay_fragments(&built.fragmented, split_count);
        assert_eq!(triangles(&model), canonical_triangles(&expected.triangles), "split {split_count}");
    }
    model.show_view(&camera([3.0, 0.0, 1.0], 4.0, 0)).unwrap();
    let count = triangles(&model).len();
    assert!(0 < count && count < torus().triangle_count(), "{count}");
}
