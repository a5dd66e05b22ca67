//! Streams of scenes: round trips, prefixes, precision, and damage of every kind.

use crate::samples;
use proptest::prelude::*;
use serde_json::Value;
use striata::LodOptions;
use striata::mesh::{IndexedMesh, LayerData, Random, Semantic, shapes};
use striata::simplify::BatchOptions;
use striata_io::{Format, Scene, Source, WriteOptions, read_scene_bytes, scene_to_bytes};
use striata_scene::stream::{
    EncodedScene, ImageState, SceneEncodeError, SceneStreamDecoder, SceneStreamError, SceneStreamInfo,
    SceneStreamOptions, encode_scene, encode_scene_with_progress,
};
use striata_scene::{GlbStreamOptions, LodScene, read_glb_with_stream};
use striata_stream::{LayerOptions, Precision, StreamOptions};

fn options() -> SceneStreamOptions {
    SceneStreamOptions::default().with_preview_side(8)
}

fn encoded(scene: &Scene) -> EncodedScene {
    encode_scene(scene, &options()).unwrap()
}

fn decoded(bytes: &[u8]) -> Result<SceneStreamDecoder, SceneStreamError> {
    let mut decoder = SceneStreamDecoder::new();
    decoder.push(bytes)?;
    Ok(decoder)
}

/// Triangles as positions, in an order that does not depend on that of the mesh; -0 counts as 0.
fn sorted_triangles(mesh: &IndexedMesh) -> Vec<[[u32; 3]; 3]> {
    let bits = |vertex: u32| mesh.positions[vertex as usize].map(|x| (x + 0.0).to_bits());
    let mut triangles: Vec<[[u32; 3]; 3]> = mesh.triangles.iter().map(|t| t.map(bits)).collect();
    for triangle in &mut triangles {
        let least = (0..3).min_by_key(|&corner| triangle[corner]).unwrap();
        triangle.rotate_left(least);
    }
    triangles.sort_unstable();
    triangles
}

/// Writes a scene as GLB and reads it again, which checks it as a whole.
fn check_drawable(scene: &Scene) -> Scene {
    let bytes = scene_to_bytes(Format::Glb, scene, &WriteOptions::default()).unwrap();
    read_scene_bytes(&bytes, &Source::new("prefix.glb")).unwrap()
}

/// Streams of meshes that touch still do so: their vertices lie on the same lattice.
#[test]
fn borders_of_meshes_that_touch_still_meet() {
    for (matrix, move_) in [
        ([1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0], 0.0),
        // From z up to y up, in centimeters, far away.
        ([0.01, 0.0, 0.0, 0.0, 0.0, 0.0, -0.01, 0.0, 0.0, 0.01, 0.0, 0.0, 1e3, 0.0, 0.0, 1.0], 0.25),
    ] {
        let mut sample = striata_testing::scenes::empty();
        for (name, [x0, x1], origin) in [("a", [0.0, 1.0], 0.0), ("b", [1.0, 3.7], move_)] {
            let mut tile = shapes::grid(20, 20);
            let side = tile.positions.iter().map(|p| p[0]).fold(0.0, f32::max);
            for point in &mut tile.positions {
                let [x, y] = [point[0], point[1]].map(|x| f64::from(x / side));
                let x = x0 + (x1 - x0) * x;
                let height = 0.1 * (5.0 * x).sin() * (4.0 * y).cos();
                *point = [x - origin, y, height].map(|x| x as f32);
            }
            sample.push_mesh(name, &tile);
        }
        sample.document["nodes"] = serde_json::json!([
            { "matrix": matrix, "children": [1, 2] },
            { "mesh": 0 },
            { "mesh": 1, "translation": [move_, 0, 0] },
        ]);
        sample.document["scenes"] = serde_json::json!([{ "nodes": [0] }]);
        let scene = read_scene_bytes(&sample.to_glb(), &Source::new("x.glb")).unwrap();
        let border = |scene: &Scene| -> [Vec<[i64; 2]>; 2] {
            [(0, 0.0), (1, move_)].map(|(mesh, offset)| {
                let mesh = scene.meshes()[mesh].as_ref().unwrap();
                let points = mesh.positions.iter().map(|p| p.map(f64::from));
                let points = points.filter(|p| (p[0] + offset - 1.0).abs() < 0.01);
                let mut points: Vec<_> =
                    points.map(|p| [p[1], p[2]].map(|x| (x * 1e7).round() as i64)).collect();
                points.sort_unstable();
                points
            })
        };
        let [a, b] = border(&scene);
        assert!(a == b && a.len() == 21);
        let [a, b] = border(&decoded(&encoded(&scene).bytes).unwrap().scene().unwrap());
        assert_eq!(a, b);
        let lods = LodScene::build(&scene, &LodOptions::default()).unwrap();
        let glb = lods.to_glb_with_stream(&GlbStreamOptions::default()).unwrap();
        let again = read_glb_with_stream(&glb, &Source::new("s.glb")).unwrap().unwrap();
        let [a, b] = border(&again.full_scene());
        assert!(a == b && a.len() == 21);
    }
}

/// Meshes that differ in their material only have one stream.
#[test]
fn equal_meshes_have_one_stream() {
    let sample = striata_testing::scenes::shared_accessors();
    let scene = read_scene_bytes(&sample.to_glb(), &Source::new("x.glb")).unwrap();
    let stream = encoded(&scene);
    assert_eq!(stream.bytes[4], 2, "older readers refuse it by its version");
    let without_copies = scene.clone().with_meshes({
        let mut meshes = scene.meshes().to_vec();
        meshes[1..3].fill(None);
        meshes
    });
    let one = encoded(&without_copies.unwrap());
    assert_eq!(one.bytes[4], 1);
    assert!(stream.bytes.len() < one.bytes.len() + 40, "{}, {}", stream.bytes.len(), one.bytes.len());
    let info = SceneStreamInfo::read(&stream.bytes).unwrap().unwrap();
    let bytes: Vec<u64> = info.meshes.iter().map(|mesh| mesh.unwrap().bytes).collect();
    assert!(bytes[0] > 0 && bytes[1] == 0 && bytes[2] == 0 && bytes[3] > 0, "{bytes:?}");
    assert_eq!(info.triangle_count(), 4 * 320);
    let mut decoder = SceneStreamDecoder::new();
    for piece in stream.bytes.chunks(50) {
        let update = decoder.push(piece).unwrap();
        let of = |mesh: usize| update.meshes.iter().filter(|change| change.mesh == mesh).count();
        assert!(of(0) == of(1) && of(1) == of(2));
        if decoder.is_drawable() {
            let shown = decoder.scene().unwrap();
            assert_eq!(shown.meshes()[0], shown.meshes()[2]);
            assert_eq!(
                decoder.lods()[0].as_ref().unwrap().mesh(),
                decoder.lods()[1].as_ref().unwrap().mesh()
            );
        }
    }
    assert!(decoder.is_complete() && decoder.error() == Some(0.0));
    assert_eq!(decoder.scene().unwrap().triangle_count(), scene.triangle_count());
    assert!((0..4).all(|mesh| decoder.mesh(mesh).is_some() && decoder.mesh_scale(mesh) == Some(1.0)));
    // The last numbers of the table name meshes 1 and 2 as copies of mesh 0.
    let mut packets = packets(&stream.bytes);
    let table = inflated(&packets[0].2);
    for (place, value) in [(20, 0), (20, 9), (19, 1), (19, 9), (10, 1)] {
        let mut damaged = table.clone();
        let place = damaged.len() - place;
        damaged[place] = value;
        packets[0].2 = deflated(&damaged);
        let message = decoded(&with_version(joined(&packets), 2)).unwrap_err().to_string();
        assert!(message.contains("has the stream"), "{message}");
    }
    let message = decoded(&with_version(stream.bytes, 3)).unwrap_err().to_string();
    assert!(message.contains('3'), "{message}");
}

fn with_version(mut bytes: Vec<u8>, version: u8) -> Vec<u8> {
    bytes[4] = version;
    bytes
}

#[test]
fn lossless_streams_return_the_scene() {
    let scene = samples::scene(2);
    let stream = StreamOptions::default().with_precision(Precision::Lossless);
    let stream = encode_scene(&scene, &options().with_stream(stream)).unwrap();
    let decoder = decoded(&stream.bytes).unwrap();
    assert!(decoder.is_complete() && decoder.is_drawable());
    let found = decoder.scene().unwrap();
    assert_eq!(found.document(), scene.document());
    assert_eq!(found.buffer(), scene.buffer());
    assert_eq!(found.images(), scene.images());
    for (a, b) in found.meshes().iter().zip(scene.meshes()) {
        let (a, b) = (a.as_ref().unwrap(), b.as_ref().unwrap());
        assert!(sorted_triangles(a) == sorted_triangles(b));
        let semantics =
            |mesh: &IndexedMesh| mesh.layers.iter().map(|l| l.semantic.clone()).collect::<Vec<_>>();
        assert_eq!(semantics(a), semantics(b));
        let groups =
            |mesh: &IndexedMesh| mesh.groups.iter().map(|g| (g.material, g.count)).collect::<Vec<_>>();
        assert_eq!(groups(a), groups(b));
    }
    check_drawable(&found);
    let sizes = stream.sizes;
    let sum = sizes.document_bytes
        + sizes.base_bytes
        + sizes.refinement_bytes
        + sizes.buffer_bytes
        + sizes.preview_bytes
        + sizes.image_bytes
        + sizes.packet_bytes;
    assert_eq!(sum, stream.bytes.len());
}

/// Joints and weights of the vertices at each position, which identify vertices of the sample.
fn by_joints(mesh: &IndexedMesh) -> Vec<(Vec<u32>, [f32; 3])> {
    let layer = mesh.layer(&Semantic::Joints(0)).unwrap();
    assert!(matches!(layer.data, LayerData::U8(_)), "integers keep their type");
    let joints = |vertex: usize| (0..4).map(|component| layer.get(vertex, component) as u32).collect();
    mesh.positions.iter().enumerate().map(|(vertex, &position)| (joints(vertex), position)).collect()
}

#[test]
fn vertices_stay_within_the_tolerance_of_the_scene_when_deformed() {
    let scene = samples::scene(3);
    let tolerance = 0.01;
    let stream = StreamOptions::default()
        .with_precision(Precision::Tolerance(tolerance))
        .with_layers(LayerOptions::default().with_generic_bits(2));
    let stream = encode_scene(&scene, &options().with_stream(stream)).unwrap();
    let decoder = decoded(&stream.bytes).unwrap();
    let found = decoder.scene().unwrap();
    for (index, (a, b)) in found.meshes().iter().zip(scene.meshes()).enumerate() {
        let (a, b) = (a.as_ref().unwrap(), b.as_ref().unwrap());
        let instances = scene.instances().iter().filter(|instance| instance.mesh == index);
        let scale = instances.map(|instance| instance.scale).fold(0.0, f64::max);
        // The animation reaches a weight of 1.33.
        for weight in [0.0f32, 1.0, 1.33] {
            let moved = |mesh: &IndexedMesh, vertex: usize| {
                let morph = mesh.layer(&Semantic::MorphPosition(0));
                [0, 1, 2].map(|axis| {
                    let by = morph.map_or(0.0, |layer| layer.get(vertex, axis));
                    f64::from(mesh.positions[vertex][axis] + weight * by)
                })
            };
            let distance =
                |p: [f64; 3], q: [f64; 3]| (0..3).map(|i| (p[i] - q[i]).powi(2)).sum::<f64>().sqrt();
            for vertex in 0..a.vertex_count() {
                let there = moved(a, vertex);
                let nearest = (0..b.vertex_count()).map(|other| distance(there, moved(b, other)));
                let nearest = nearest.fold(f64::INFINITY, f64::min);
                assert!(nearest * scale <= tolerance * 1.0001, "meshes[{index}]: {nearest} x {scale}");
            }
        }
    }
    let (a, b) = (found.meshes()[1].as_ref().unwrap(), scene.meshes()[1].as_ref().unwrap());
    let weights = a.layer(&Semantic::Weights(0)).unwrap();
    for vertex in 0..a.vertex_count() {
        let sum: f32 = (0..4).map(|joint| weights.get(vertex, joint)).sum();
        assert!((sum - 1.0).abs() < 1e-6, "{sum}");
    }
    let expected = by_joints(b);
    for (joints, position) in by_joints(a) {
        let near = expected.iter().filter(|(_, p)| (0..3).all(|i| (p[i] - position[i]).abs() < 0.011));
        assert!(near.clone().any(|(other, _)| *other == joints), "{position:?} {joints:?}");
    }
}

#[test]
fn small_parts_do_not_get_bits_of_their_own() {
    let decoder = decoded(&encoded(&samples::scene(2)).bytes).unwrap();
    let step = |mesh: usize| decoder.mesh(mesh).unwrap().info().unwrap().grid_step;
    let bits = |mesh: usize| decoder.mesh(mesh).unwrap().info().unwrap().grid_bits;
    assert!(bits(2) < 8 && bits(2) >= 6, "{}", bits(2));
    // The torus is shown at twice its size, so its grid is twice as fine.
    assert!(step(0) < step(2), "{} {}", step(0), step(2));
    // The scene's box is 6.8 wide.
    assert!((step(2) - 6.8 / 16383.0).abs() < 1e-4, "{}", step(2));
}

#[test]
fn every_prefix_is_an_error_or_a_scene() {
    let scene = samples::scene(1);
    let stream = encoded(&scene);
    let mut decoder = SceneStreamDecoder::new();
    let (mut last_error, mut drawable_at) = (f64::INFINITY, None);
    for (length, byte) in stream.bytes.iter().enumerate() {
        assert_eq!(decoder.received(), length as u64);
        if decoder.is_drawable() {
            drawable_at.get_or_insert(length);
            let error = decoder.error().unwrap();
            assert!(error <= last_error);
            last_error = error;
        }
        let mut cut = decoder.clone();
        match cut.finish() {
            Ok(_) => {
                assert!(matches!(cut.push(&[0]), Err(SceneStreamError::Over)));
                if cut.is_drawable() && length % 13 == 0 {
                    let shown = check_drawable(&cut.scene().unwrap());
                    assert!(shown.triangle_count() > 0 && shown.images().len() == 4);
                }
            }
            Err(error) => assert!(cut.document().is_none(), "{length}: {error}"),
        }
        if let Err(error) = cut.check_drawable() {
            let SceneStreamError::NotDrawable { found, needed } = error else { panic!("{length}: {error}") };
            let range = length as u64 + 1..=stream.sizes.drawable_at as u64;
            assert!(found == length as u64 && range.contains(&needed), "{needed} after {found}");
        }
        assert!(!decoder.is_complete());
        decoder.push(&[*byte]).unwrap();
    }
    assert!(decoder.is_complete());
    assert_eq!(decoder.error(), Some(0.0));
    assert_eq!(drawable_at, Some(stream.sizes.drawable_at));
    assert_eq!(decoder.drawable_at(), Some(stream.sizes.drawable_at as u64));
    assert_eq!(decoder.textured_at(), Some(stream.sizes.textured_at as u64));
    let more = decoder.push(&[0]);
    assert!(matches!(more, Err(SceneStreamError::Length { .. })), "{more:?}");
}

#[test]
fn a_flipped_bit_is_noticed_and_what_came_before_remains() {
    let scene = samples::scene(1);
    let stream = encoded(&scene);
    for at in 0..stream.bytes.len() {
        let mut bad = stream.bytes.clone();
        bad[at] ^= 1 << (at % 8);
        let mut decoder = SceneStreamDecoder::new();
        let error = decoder.push(&bad).err();
        // The total length is checked at the end only.
        let is_noticed = error.is_some() || !decoder.is_complete();
        assert!(is_noticed, "byte {at}");
        if decoder.is_drawable() && at % 7 == 0 {
            decoder.scene().unwrap();
        }
    }
}

/// Packets of a stream: kind, index, payload.
fn packets(bytes: &[u8]) -> Vec<(u8, usize, Vec<u8>)> {
    let mut rest = &bytes[16..];
    let mut packets = Vec::new();
    while !rest.is_empty() {
        let kind = rest[0];
        rest = &rest[1..];
        let mut varint = || {
            let mut value = 0usize;
            for shift in (0..).step_by(7) {
                let byte = rest[0];
                rest = &rest[1..];
                value |= usize::from(byte & 0x7f) << shift;
                if byte < 0x80 {
                    break;
                }
            }
            value
        };
        let (index, length) = (varint(), varint());
        let (payload, after) = rest[4..].split_at(length);
        packets.push((kind, index, payload.to_vec()));
        rest = after;
    }
    packets
}

fn joined(packets: &[(u8, usize, Vec<u8>)]) -> Vec<u8> {
    let mut bytes = b"\x89SCN\x01\0\0\0\0\0\0\0\0\0\0\0".to_vec();
    for (kind, index, payload) in packets {
        let mut head = vec![*kind];
        for mut number in [*index, payload.len()] {
            while number >= 0x80 {
                head.push(number as u8 | 0x80);
                number >>= 7;
            }
            head.push(number as u8);
        }
        let mut hasher = crc32fast::Hasher::new();
        hasher.update(&head);
        hasher.update(payload);
        bytes.extend(head);
        bytes.extend(hasher.finalize().to_le_bytes());
        bytes.extend(payload);
    }
    let length = bytes.len() as u64;
    bytes[8..16].copy_from_slice(&length.to_le_bytes());
    bytes
}

fn inflated(bytes: &[u8]) -> Vec<u8> {
    let mut out = Vec::new();
    std::io::Read::read_to_end(&mut flate2::read::DeflateDecoder::new(bytes), &mut out).unwrap();
    out
}

fn deflated(bytes: &[u8]) -> Vec<u8> {
    let mut encoder = flate2::write::DeflateEncoder::new(Vec::new(), flate2::Compression::fast());
    std::io::Write::write_all(&mut encoder, bytes).unwrap();
    encoder.finish().unwrap()
}

/// Decodes anything; whatever happens, it must be an error or a scene.
fn survive(bytes: &[u8]) -> bool {
    let mut decoder = SceneStreamDecoder::new();
    let result = decoder.push(bytes);
    if let Err(error) = &result {
        assert!(!error.to_string().is_empty());
    } else {
        // A stream without its end is complete in no case, but may be cut.
        let _ = decoder.finish();
    }
    if let Ok(scene) = decoder.scene() {
        let _ = scene_to_bytes(Format::Glb, &scene, &WriteOptions::default());
    }
    let _ = SceneStreamInfo::read(bytes);
    result.is_ok()
}

#[test]
fn damaged_payloads_with_valid_checksums_are_errors_or_scenes() {
    let original = packets(&encoded(&samples::scene(1)).bytes);
    assert!(survive(&joined(&original)));
    let mut random = Random::new(5);
    let (mut accepted, mut rejected) = (0, 0);
    for round in 0..1500 {
        let mut packets = original.clone();
        let at = if round % 3 == 0 { 0 } else { random.below(packets.len() as u32) as usize };
        let (kind, index, payload) = &mut packets[at];
        match round % 5 {
            0 => *index = random.below(6) as usize,
            1 => *kind = random.below(7) as u8,
            2 => payload.truncate(random.below(payload.len() as u32 + 1) as usize),
            _ => {
                let is_packed = *kind == 1 || *kind == 3;
                let mut inner = if is_packed { inflated(payload) } else { payload.clone() };
                for _ in 0..1 + random.below(3) {
                    // Near the end is the table of the document, near the beginning the headers of meshes.
                    let place = match random.below(3) {
                        0 => random.below(inner.len() as u32),
                        1 => random.below(inner.len().min(200) as u32),
                        _ => (inner.len() as u32 - 1) - random.below(inner.len().min(300) as u32),
                    };
                    inner[place as usize] = random.next_u64() as u8;
                }
                *payload = if is_packed { deflated(&inner) } else { inner };
            }
        }
        if random.below(6) == 0 {
            let (a, b) = (random.below(packets.len() as u32), random.below(packets.len() as u32));
            packets.swap(a as usize, b as usize);
        }
        if survive(&joined(&packets)) { accepted += 1 } else { rejected += 1 }
    }
    assert!(accepted > 10 && rejected > 500, "{accepted} {rejected}");
}

#[test]
fn huge_claims_do_not_allocate() {
    let original = packets(&encoded(&samples::scene(1)).bytes);
    let table = inflated(&original[0].2);
    // A document that unpacks to far more than its packet.
    let bomb = deflated(&vec![b' '; 200 << 20]);
    let error = decoded(&joined(&[(1, 0, bomb)])).unwrap_err();
    assert!(matches!(error, SceneStreamError::Document(_)), "{error}");
    // Counts in the table that the bytes do not pay for.
    for at in table.len() - 250..table.len() {
        let mut bad = table.clone();
        bad.splice(at..at + 1, [0xff, 0xff, 0xff, 0xff, 0x0f]);
        survive(&joined(&[(1, 0, deflated(&bad))]));
    }
    // A packet that claims four gigabytes.
    let mut bytes = joined(&original);
    bytes.truncate(16);
    bytes[8..16].copy_from_slice(&u64::MAX.to_le_bytes());
    bytes.extend([1, 0, 0xff, 0xff, 0xff, 0xff, 0x0f, 0, 0, 0, 0]);
    let mut decoder = decoded(&bytes).unwrap();
    assert!(decoder.document().is_none() && decoder.finish().is_err());
}

#[test]
fn prefixes_show_previews_placeholders_and_core_textures() {
    let scene = samples::scene(3);
    let stream = encoded(&scene);
    let mut decoder = decoded(&stream.bytes[..stream.sizes.drawable_at]).unwrap();
    let states = |decoder: &SceneStreamDecoder| {
        (0..decoder.image_count()).map(|image| decoder.image(image).unwrap().state).collect::<Vec<_>>()
    };
    assert_eq!(states(&decoder), [ImageState::Placeholder; 4]);
    let first = decoder.scene().unwrap();
    assert!(first.document().get("animations").is_none());
    assert_eq!(first.document()["textures"][2], serde_json::json!({ "source": 2 }));
    assert!(first.document().get("extensionsRequired").is_none());
    assert!(first.images().iter().all(|image| image.mime_type == "image/png" && !image.bytes.is_empty()));
    decoder.push(&stream.bytes[stream.sizes.drawable_at..stream.sizes.textured_at]).unwrap();
    use ImageState::{Full, Placeholder, Preview};
    assert_eq!(states(&decoder), [Preview, Preview, Placeholder, Full]);
    // The color of the first image, measured from its pixels, is about half red.
    let average = decoder.image(0).unwrap().average;
    assert!((90..=170).contains(&average[0]) && average[2] < 60, "{average:?}");
    assert_eq!(decoder.image(2).unwrap().average, [255; 4]);
    decoder.push(&stream.bytes[stream.sizes.textured_at..]).unwrap();
    assert_eq!(states(&decoder), [Full; 4]);
    assert_eq!(decoder.scene().unwrap().images(), scene.images());
    assert!(decoder.scene().unwrap().document().get("animations").is_some());
}

#[test]
fn animations_are_rounded_within_the_precision() {
    let scene = samples::scene(1);
    let found = decoded(&encoded(&scene).bytes).unwrap().scene().unwrap();
    let floats = |buffer: &[u8]| -> Vec<f32> {
        buffer.chunks_exact(4).map(|b| f32::from_le_bytes(b.try_into().unwrap())).collect()
    };
    let (a, b) = (floats(found.buffer()), floats(scene.buffer()));
    assert_eq!(a[..52], b[..52], "matrices and times are exact");
    assert_ne!(a[52..], b[52..]);
    for (a, b) in a[52..].iter().zip(&b[52..]) {
        assert!((a - b).abs() <= 1.0 / 32768.0, "{a} {b}");
    }
}

#[test]
fn levels_of_a_prefix_are_those_of_the_mesh() {
    let stream = encoded(&samples::scene(3));
    let decoder = decoded(&stream.bytes[..stream.bytes.len() / 2]).unwrap();
    for (mesh, lod) in decoder.lods().into_iter().enumerate() {
        let lod = lod.unwrap();
        let decoder = decoder.mesh(mesh).unwrap();
        assert_eq!(lod.step_count(), decoder.split_count());
        assert_eq!(lod.mesh().triangle_count(), decoder.triangles().len());
    }
}

#[test]
fn the_first_packet_tells_what_follows() {
    let scene = samples::scene(2);
    let stream_options = StreamOptions::default().with_metadata("source", "made by hand");
    let stream = encode_scene(&scene, &options().with_stream(stream_options)).unwrap();
    assert_eq!(Format::detect(&stream.bytes, "x.ply"), Some(Format::Stream));
    let info = SceneStreamInfo::read(&stream.bytes).unwrap().unwrap();
    assert_eq!(info.stream_bytes, stream.bytes.len() as u64);
    assert_eq!(info.drawable_at, stream.sizes.drawable_at as u64);
    assert_eq!(info.textured_at, stream.sizes.textured_at as u64);
    assert_eq!(info.metadata, [("source".to_owned(), "made by hand".to_owned())]);
    let triangles: usize = scene.meshes().iter().flatten().map(IndexedMesh::triangle_count).sum();
    assert_eq!(info.triangle_count(), triangles as u64);
    assert_eq!(info.images[0].size, (48, 48));
    for length in 0..info.document_bytes as usize {
        assert_eq!(SceneStreamInfo::read(&stream.bytes[..length]).unwrap(), None);
    }
}

#[test]
fn odd_meshes_and_empty_scenes_are_streamed() {
    let meshes = striata_testing::meshes::all().into_iter().map(|(_, mesh)| mesh);
    let empty = [IndexedMesh::default(), shapes::bow_tie(), shapes::needle()];
    for mesh in meshes.chain(empty) {
        let Ok(scene) = Scene::from_mesh(mesh) else { continue };
        let stream = encoded(&scene);
        let decoder = decoded(&stream.bytes).unwrap();
        assert!(decoder.is_complete());
        decoder.scene().unwrap();
    }
    let nothing = Scene::from_parts(striata_io::SceneParts {
        document: serde_json::json!({ "asset": { "version": "2.0" } }),
        ..Default::default()
    });
    let decoder = decoded(&encoded(&nothing.unwrap()).bytes).unwrap();
    assert!(decoder.is_complete() && decoder.is_drawable());
    assert_eq!(decoder.scene().unwrap().triangle_count(), 0);
}

#[test]
fn encoding_is_deterministic_reports_progress_and_can_be_cancelled() {
    let scene = samples::scene(2);
    let mut last = 0;
    let stream = encode_scene_with_progress(&scene, &options(), &mut |progress| {
        assert!(progress.done >= last && progress.done <= progress.total);
        last = progress.done;
        std::ops::ControlFlow::Continue(())
    });
    assert_eq!(stream.unwrap().bytes, encoded(&scene).bytes);
    assert!(last > 0);
    let mut phases = Vec::new();
    let count = encode_scene_with_progress(&scene, &options(), &mut |now| {
        phases.push(now.phase);
        std::ops::ControlFlow::Continue(())
    });
    assert!(count.is_ok() && phases.contains(&"encode") && phases.contains(&"previews"), "{phases:?}");
    for last in 1..=phases.len() {
        let mut calls = 0;
        let stopped = encode_scene_with_progress(&scene, &options(), &mut |_| {
            calls += 1;
            if calls < last { std::ops::ControlFlow::Continue(()) } else { std::ops::ControlFlow::Break(()) }
        });
        assert!(matches!(stopped, Err(SceneEncodeError::Cancelled)), "report {last}");
        assert_eq!(calls, last);
    }
    let mut bad = BatchOptions::default();
    bad.share = 2.0;
    let error = encode_scene(&scene, &options().with_batches(bad)).unwrap_err();
    assert!(error.to_string().starts_with("meshes[0]: "), "{error}");
}

#[test]
fn a_document_that_contradicts_its_table_is_refused() {
    let original = packets(&encoded(&samples::scene(1)).bytes);
    let table = inflated(&original[0].2);
    let start = table.windows(2).position(|pair| pair == b"{\"").unwrap();
    let mut stream = serde_json::Deserializer::from_slice(&table[start..]).into_iter::<Value>();
    let mut document = stream.next().unwrap().unwrap();
    let rest = &table[start + stream.byte_offset()..];
    document["meshes"].as_array_mut().unwrap().pop();
    let json = document.to_string();
    assert!((128..1 << 14).contains(&json.len()));
    let mut bytes = vec![json.len() as u8 | 0x80, (json.len() >> 7) as u8];
    bytes.extend(json.as_bytes());
    bytes.extend(rest);
    let error = decoded(&joined(&[(1, 0, deflated(&bytes))])).unwrap_err().to_string();
    assert!(error.contains("meshes"), "{error}");
}

proptest! {
    #![proptest_config(striata_testing::cases(24))]

    #[test]
    fn pieces_of_any_size_give_the_same_scene(sizes in prop::collection::vec(1usize..700, 1..40)) {
        let stream = encoded(&samples::scene(1));
        let whole = decoded(&stream.bytes).unwrap();
        let mut decoder = SceneStreamDecoder::new();
        let (mut rest, mut sizes) = (&stream.bytes[..], sizes.iter().cycle());
        let mut improved = Vec::new();
        while !rest.is_empty() {
            let (piece, after) = rest.split_at((*sizes.next().unwrap()).min(rest.len()));
            let update = decoder.push(piece).unwrap();
            improved.extend(update.images);
            rest = after;
        }
        prop_assert!(decoder.is_complete());
        prop_assert_eq!(decoder.scene().unwrap(), whole.scene().unwrap());
        improved.sort_unstable();
        improved.dedup();
        prop_assert_eq!(improved, vec![0, 1, 2, 3]);
    }

    #[test]
    fn bytes_after_the_magic_never_panic(bytes in prop::collection::vec(any::<u8>(), 0..200)) {
        let mut stream = b"\x89SCN\x01\0\0\0".to_vec();
        stream.extend(bytes);
        survive(&stream);
    }
}
