//! The model as a page uses it: bytes in, levels out, and a clean error for any damaged bytes.

use striata::file::{FileModel, WriteOptions, to_striata, write_fragments};
use striata::mesh::{
    AttributeLayer, FragmentedMesh, IndexedMesh, Material, Random, Semantic, TriangleGroup,
    canonical_triangles, replay, replay_fragments, shapes,
};
use striata::model::{Fans, LodStrips, Patterns};
use striata::simplify::{
    BatchOptions, RemovalOptions, SequenceOptions, build_batches, build_fragments, build_sequence,
};
use striata::strip::stripify;
use striata::{LodOptions, Target};
use striata_io::Scene;
use striata_scene::LodScene;
use striata_stream::{StreamDecoder, StreamOptions, encode_stream, file_model};
use striata_web::{Model, StoredFile, StreamPlace, View};

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

/// The only mesh of a file.
fn stored(bytes: &[u8]) -> Model {
    StoredFile::read(bytes).unwrap().take_mesh(0).unwrap()
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
    let refinable = build_sequence(&torus(), &SequenceOptions::default()).unwrap().refinable;
    let mut file = stored(&to_striata(&refinable, &[], &WriteOptions::default()).unwrap());
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
    let refinable = build_sequence(&torus(), &SequenceOptions::default()).unwrap().refinable;
    let fans = Fans::build(&refinable);
    let lod_strips = LodStrips::build(&refinable, &stripify(&refinable.mesh).unwrap()).unwrap();
    let patterns = Patterns::build(&FragmentedMesh::from_collapses(&refinable)).unwrap();
    let models = [
        vec![],
        vec![FileModel::Fans(&fans)],
        vec![FileModel::LodStrips(&lod_strips)],
        vec![FileModel::Patterns(&patterns)],
    ];
    for models in models {
        let bytes = to_striata(&refinable, &models, &WriteOptions::default()).unwrap();
        assert_eq!(StreamPlace::find(&bytes).unwrap().length, 0.0);
        let mut model = stored(&bytes);
        assert_eq!((model.kind().as_str(), model.step_count()), ("striata", refinable.sequence.step_count()));
        for detail in [0.0, 0.3, 1.0] {
            model.show_detail(detail);
            let expected = replay(&refinable, model.shown_split_count()).triangles;
            assert_eq!(triangles(&model), canonical_triangles(&expected));
        }
        model.show_triangles(300);
        assert!(triangles(&model).len() <= 300);
        let failure = StoredFile::read(&bytes[..bytes.len() - 1]).unwrap_err();
        assert_eq!((failure.code().as_str(), failure.hint().is_some()), ("corrupt", true));
    }
}

#[test]
fn stored_meshes_have_documents_with_their_attributes_and_materials() {
    let mut mesh = torus();
    mesh.appearance.materials.push(Material { name: "paint".to_owned(), ..Material::default() });
    mesh.groups[1].material = Some(0);
    let refinable = build_sequence(&mesh, &SequenceOptions::default()).unwrap().refinable;
    let bytes = to_striata(&refinable, &[], &WriteOptions::default()).unwrap();
    let mut file = StoredFile::read(&bytes).unwrap();
    let json = file.take_document().unwrap().take_json();
    for part in ["\"POSITION\":null", "\"NORMAL\":null", "\"COLOR_0\":null", "\"material\":0", "paint"] {
        assert!(json.contains(part), "{part} of {json}");
    }
    let mut vertices = file.take_mesh(0).unwrap().vertices(0);
    let mut names = Vec::new();
    while let Some(layer) = vertices.take_layer() {
        assert_eq!(layer.bytes().is_empty(), layer.component_count() == 0);
        names.push(format!("{} {}", layer.name(), layer.component_type()));
    }
    // Colors of files are sRGB, and those of pages are light.
    assert_eq!(names, ["COLOR_0 u16", "NORMAL f32"]);
}

#[test]
fn files_with_many_triangles_at_an_edge_are_read() {
    let mut fins = IndexedMesh::new(vec![[0.0; 3], [0.0, 0.0, 1.0]], Vec::new());
    for fin in 0..300u32 {
        let angle = fin as f32 * 0.02;
        fins.positions.push([angle.cos(), angle.sin(), 0.5]);
        fins.triangles.push([0, 1, fin + 2]);
    }
    let refinable = build_sequence(&fins, &SequenceOptions::default()).unwrap().refinable;
    let mut model = stored(&to_striata(&refinable, &[], &WriteOptions::default()).unwrap());
    for detail in [1.0, 0.5] {
        model.show_detail(detail);
        let expected = replay(&refinable, model.shown_split_count()).triangles;
        assert_eq!(triangles(&model), canonical_triangles(&expected), "detail {detail}");
    }
}

#[test]
fn stored_scenes_have_the_levels_of_their_meshes() {
    let scene = Scene::from_mesh(torus()).unwrap();
    let lods = LodScene::build(&scene, &LodOptions::default()).unwrap();
    let mut file = StoredFile::read(&lods.to_striata(&WriteOptions::default()).unwrap()).unwrap();
    assert_eq!(file.mesh_count(), 1);
    let mut model = file.take_mesh(0).unwrap();
    let lod = lods.lods()[0].as_ref().unwrap();
    for detail in [0.1, 0.6] {
        model.show_detail(detail);
        let expected = lod.level_mesh(Target::SplitCount(model.shown_split_count()));
        assert_eq!(triangles(&model), canonical_triangles(&expected.triangles));
    }
    assert!(file.take_mesh(0).is_none() && file.take_mesh(1).is_none(), "each is taken once");
}

#[test]
fn large_stored_files_show_their_first_levels_before_the_others() {
    let mesh = shapes::torus(520, 200, 1.0, 0.4);
    let refinable = build_sequence(&mesh, &SequenceOptions::default()).unwrap().refinable;
    let bytes = to_striata(&refinable, &[], &WriteOptions::default()).unwrap();
    let mut file = StoredFile::read(&bytes).unwrap();
    let mut first = file.first_levels(0).unwrap();
    let whole = file.take_mesh(0).unwrap();
    assert!(!first.is_complete() && whole.is_complete());
    assert_eq!(first.full_triangle_count(), mesh.triangle_count());
    assert_eq!(first.step_count(), whole.step_count());
    assert!(first.triangle_count() <= 50_000 && first.triangle_count() > 49_000);
    for error in [0.1f64, 0.01] {
        let split_count = refinable.sequence.split_count_for_error(error);
        first.show_error(error);
        assert_eq!(first.shown_split_count(), split_count);
        assert_eq!(first.shown_error(), refinable.sequence.error_at(split_count));
        assert_eq!(triangles(&first), canonical_triangles(&replay(&refinable, split_count).triangles));
    }
    // More than there is shows everything that there is.
    first.show_detail(1.0);
    assert_eq!(triangles(&first).len(), first.triangle_count());
    assert!(first.shown_error() > 0.0);
    first.show_view(&camera([9.0, 0.0, 0.0], 1.0, 0)).unwrap();
    assert!(first.shown_split_count() > 0);
    let layers =
        [first.vertices(0), whole.vertices(0)].map(|mut vertices| vertices.take_layer().unwrap().name());
    assert_eq!(layers, ["NORMAL", "NORMAL"]);
}

#[test]
fn damaged_stored_files_are_refused() {
    let lods = LodScene::build(&Scene::from_mesh(torus()).unwrap(), &LodOptions::default()).unwrap();
    let bytes = lods.to_striata(&WriteOptions::default()).unwrap();
    assert_eq!(StoredFile::read(b"hello, world").unwrap_err().code(), "format");
    let mut random = Random::new(11);
    for _ in 0..100 {
        let mut damaged = bytes.clone();
        let at = random.below(damaged.len() as u32) as usize;
        damaged[at] ^= 1 << random.below(8);
        // Bytes between the sections mean nothing.
        if let Err(failure) = StoredFile::read(&damaged) {
            assert!(["format", "corrupt", "unsupported", "too-large"].contains(&failure.code().as_str()));
        }
        assert!(StoredFile::read(&bytes[..at]).is_err(), "{at} bytes");
    }
}

#[test]
fn the_header_locates_the_stream() {
    assert!(StreamPlace::find(b"STRIATA\0").unwrap().needed > 64.0);
    assert_eq!(StreamPlace::find(&[b'x'; 64]).unwrap_err().code(), "format");
    let mesh = torus();
    let built = build_batches(&mesh, &BatchOptions::default()).unwrap();
    let stream = encode_stream(&built.built.refinable, &built.batches, &StreamOptions::default()).unwrap();
    let fans = Fans::build(&built.built.refinable);
    let models = [file_model(&stream.bytes).unwrap(), FileModel::Fans(&fans)];
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
    // Models that a file has besides its stream can be read, too.
    assert_eq!(stored(&bytes).triangle_count(), mesh.triangle_count());
}

#[test]
fn fans_of_removals_show_every_level() {
    let built = build_fragments(&torus(), &RemovalOptions::default()).unwrap();
    let fans = Fans::build(&built.fragmented);
    let mut bytes = Vec::new();
    let options = WriteOptions::default();
    write_fragments(&built.fragmented, &[FileModel::Fans(&fans)], &options, &mut bytes).unwrap();
    let mut model = stored(&bytes);
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
