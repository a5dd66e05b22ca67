//! Damaged and hostile files: errors with the place and the reason, no panics, no huge allocations.

use std::path::Path;

use proptest::prelude::*;
use serde_json::{Value, json};
use striata::mesh::shapes;
use striata_io::pieces::open_pieces;
use striata_io::{ReadError, read_with_report};
use striata_testing::scenes::{self, TestScene};
use striata_testing::support::Random;
use tempfile::TempDir;

use super::scene::{Numbers, with_files};
use super::{Triangles, of_mesh, of_source, options, random};

fn in_pieces(path: &Path) -> Result<Triangles, ReadError> {
    open_pieces(path, &options(10)).and_then(|source| of_source(&*source))
}

/// Reads a damaged file in pieces: whatever the reader of whole files accepts has the same triangles.
fn survive(path: &Path) -> bool {
    let found = in_pieces(path);
    if let Ok(report) = read_with_report(path)
        && report.mesh.check().is_ok()
    {
        // Values that are repaired may differ at the borders of pieces.
        assert!(!report.warnings.is_empty() || found.unwrap() == of_mesh(&report.mesh));
        return true;
    }
    if let Err(error) = &found {
        assert!(error.to_string().starts_with(&path.display().to_string()), "{error}");
    }
    found.is_ok()
}

#[test]
fn every_truncation_is_survived() {
    let folder = TempDir::new().unwrap();
    let path = folder.path().join("cut.glb");
    let scene = scenes::morphed();
    let bytes = scene.to_glb();
    for length in (0..bytes.len()).step_by(97) {
        std::fs::write(&path, &bytes[..length]).unwrap();
        assert!(!survive(&path), "{length}");
        // The header says that the file ends there.
        let mut ends = bytes[..length.max(12)].to_vec();
        ends[8..12].copy_from_slice(&(length as u32).to_le_bytes());
        std::fs::write(&path, ends).unwrap();
        assert!(!survive(&path), "{length}");
    }
    let path = with_files(&scene, folder.path());
    let buffer = folder.path().join("odd.bin");
    let bytes = std::fs::read(&buffer).unwrap();
    for length in [0, 1, bytes.len() / 2, bytes.len() - 1] {
        std::fs::write(&buffer, &bytes[..length]).unwrap();
        let message = in_pieces(&path).unwrap_err().to_string();
        let expected = format!("buffers[1]: {} bytes are declared, found {length}", bytes.len());
        assert!(message.contains(&expected), "{message}");
    }
    std::fs::remove_file(buffer).unwrap();
    let message = in_pieces(&path).unwrap_err().to_string();
    assert!(message.contains("buffers[1]: `odd.bin`: "), "{message}");
}

proptest! {
    #![proptest_config(striata_testing::cases(600))]

    #[test]
    fn changed_bytes_are_survived(
        seed in any::<u64>(),
        changes in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>(), any::<bool>()), 1..6),
    ) {
        let mut bytes = random::scene(&mut Random::new(seed)).to_glb();
        let json_end = 20 + u32::from_le_bytes(*bytes[12..].first_chunk().unwrap()) as usize;
        for (place, value, in_json) in changes {
            if in_json {
                let digits: Vec<usize> = (20..json_end).filter(|&i| bytes[i].is_ascii_digit()).collect();
                bytes[digits[place.index(digits.len())]] = b'0' + value % 10;
            } else {
                let place = place.index(bytes.len());
                bytes[place] = value;
            }
        }
        let folder = TempDir::new().unwrap();
        let path = folder.path().join("changed.glb");
        std::fs::write(&path, bytes).unwrap();
        survive(&path);
    }
}

/// A square as one indexed primitive: accessor 0 has the positions, accessor 1 the indices.
fn square() -> TestScene {
    let mut scene = TestScene::named("square");
    let corners = [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 1.0, 0.0];
    let position = Numbers::new(5126, "VEC3").push(&mut scene, &corners);
    let indices = Numbers::new(5121, "SCALAR").push(&mut scene, &[0.0, 1.0, 2.0, 0.0, 2.0, 3.0]);
    let primitive = json!({ "attributes": { "POSITION": position }, "indices": indices });
    scene.push("meshes", json!({ "name": "m", "primitives": [primitive] }));
    scene
}

fn refused(scene: &TestScene, texts: &[(&str, String)]) -> String {
    let folder = TempDir::new().unwrap();
    let path = folder.path().join("bad.glb");
    std::fs::write(&path, scene.to_glb_with(texts)).unwrap();
    let message = in_pieces(&path).unwrap_err().to_string();
    assert!(message.contains("bad.glb: "), "{message}");
    message
}

#[test]
fn mistakes_have_a_place_and_a_reason() {
    type Case = (fn(&mut TestScene), &'static str);
    let cases: [Case; 13] = [
        (|s| s.buffer[48] = 4, "accessors[1]: index 0 is vertex 4, but there are 4"),
        (|s| s.buffer[53] = 9, "accessors[1]: index 5 is vertex 9, but there are 4"),
        (
            |s| s.document["accessors"][0]["count"] = json!(5),
            "accessors[0]: 5 elements from byte 0 on take 60",
        ),
        (|s| s.document["accessors"][0]["count"] = json!(1u64 << 60), "more than can be handled"),
        (|s| s.document["accessors"][0]["type"] = json!("VEC2"), "accessors[0]: POSITION must be VEC3"),
        (|s| s.document["accessors"][1]["componentType"] = json!(5120), "must be unsigned integers"),
        (|s| s.document["accessors"][1]["type"] = json!("VEC2"), "accessors[1]"),
        (|s| s.document["bufferViews"][1]["byteLength"] = json!(1u64 << 40), "bufferViews[1]: bytes 48 + "),
        (|s| s.document["bufferViews"][1]["buffer"] = json!(7), "buffers[7] does not exist: there are 1"),
        (|s| s.document["bufferViews"][0]["byteStride"] = json!(4), "overlap at a stride of 4"),
        (|s| s.document["meshes"][0]["primitives"][0]["mode"] = json!(7), "no primitive mode is numbered 7"),
        (|s| s.document["asset"]["version"] = json!("1.0"), "glTF version `1.0`"),
        (|s| s.document["extensionsRequired"] = json!(["VENDOR_x"]), "requires the glTF extension VENDOR_x"),
    ];
    for (change, expected) in cases {
        let mut scene = square();
        change(&mut scene);
        let message = refused(&scene, &[]);
        assert!(message.contains(expected), "expected {expected}, found {message}");
    }
    let folder = TempDir::new().unwrap();
    let path = folder.path().join("good.glb");
    std::fs::write(&path, square().to_glb()).unwrap();
    let source = open_pieces(&path, &options(1)).unwrap();
    let message = source.read_piece(2).unwrap_err().to_string();
    assert!(message.contains("piece 2 does not exist"), "{message}");
}

/// Zeros take no bytes in a file.
fn zeros(count: u64, kind: &str, component: u32) -> Value {
    json!({ "componentType": component, "count": count, "type": kind })
}

#[test]
fn small_files_do_not_become_huge() {
    let started = std::time::Instant::now();
    let mut many = square();
    many.document["accessors"][0] = zeros(1 << 30, "VEC3", 5126);
    assert!(refused(&many, &[]).contains("1073741824 zeros in a file of"));
    // Instances by the extension, by nodes, and as primitives of a mesh that many nodes show.
    let mut instanced = square();
    let places = instanced.push("accessors", zeros(1 << 20, "VEC3", 5126));
    let extension = json!({ "EXT_mesh_gpu_instancing": { "attributes": { "TRANSLATION": places } } });
    instanced.push("nodes", json!({ "mesh": 0, "extensions": extension }));
    instanced.document["extras"] = json!("PADDING");
    let padding = format!("\"{}\"", "x".repeat(1 << 20));
    let message = refused(&instanced, &[("PADDING", padding)]);
    assert!(message.contains("1048576 instances are too many for a file of"), "{message}");
    let mut product = square();
    let primitive = product.document["meshes"][0]["primitives"][0].clone();
    product.document["meshes"][0]["primitives"] = json!(vec![primitive; 2000]);
    product.document["nodes"] = json!(vec![json!({ "mesh": 0, "translation": [1, 0, 0] }); 2000]);
    let message = refused(&product, &[]);
    assert!(message.contains("the scene shows 1050000 primitives, too many for"), "{message}");
    let mut zero = product.clone();
    zero.document["accessors"][0] = zeros(300_000, "VEC3", 5126);
    let bare = json!({ "attributes": { "POSITION": 0 } });
    zero.document["meshes"][0]["primitives"] = json!(vec![bare; 1000]);
    zero.document["nodes"] = json!(vec![json!({ "mesh": 0 }); 1000]);
    zero.document["extras"] = json!("PADDING");
    let message = refused(&zero, &[("PADDING", format!("\"{}\"", "x".repeat(1 << 20)))]);
    assert!(message.contains("the scene shows 100000000000 triangles, too many for"), "{message}");
    // The name of a mesh is that of every group.
    product.document["nodes"] = json!(vec![json!({ "mesh": 0 }); 500]);
    product.document["meshes"][0]["name"] = json!("n".repeat(1000));
    let message = refused(&product, &[]);
    assert!(message.contains("the names of all groups take"), "{message}");
    // A piece of a few vertices with a million attributes.
    let mut attributes = square();
    let names: Vec<String> = (0..3000).map(|i| format!("\"_{i}\":0")).collect();
    let names = format!("{{\"POSITION\":0,{}}}", names.join(","));
    attributes.document["meshes"][0]["primitives"] =
        json!([{ "attributes": "NAMES" }, { "attributes": { "POSITION": 2 }, "indices": 3 }]);
    attributes.push("accessors", zeros(60_000, "VEC3", 5126));
    let indices: Vec<f64> = (0..60_000).map(f64::from).collect();
    Numbers::new(5123, "SCALAR").push(&mut attributes, &indices);
    let folder = TempDir::new().unwrap();
    let path = folder.path().join("bad.glb");
    std::fs::write(&path, attributes.to_glb_with(&[("NAMES", names)])).unwrap();
    let source = open_pieces(&path, &options(100_000)).unwrap();
    let message = source.read_piece(0).unwrap_err().to_string();
    assert!(message.contains("a piece has 60003 vertices of 36012 bytes, too many for"), "{message}");
    assert!(started.elapsed().as_secs() < 60, "{:?}", started.elapsed());
}

#[test]
fn what_is_read_in_full_is_limited() {
    let started = std::time::Instant::now();
    // Many strips with the same indices.
    let mut strips = square();
    let indices = strips.push("accessors", zeros(60_000, "SCALAR", 5123));
    let strip = json!({ "attributes": { "POSITION": 0 }, "indices": indices, "mode": 5 });
    strips.document["meshes"][0]["primitives"] = json!(vec![strip; 2000]);
    let message = refused(&strips, &[]);
    assert!(message.contains("meshes[0].primitives[1118]: 67140000 indices of strips and fans"), "{message}");
    // Many triangles without normals at the same place.
    let mut bare = square();
    let many = bare.push("accessors", zeros(30_000, "VEC3", 5126));
    let normals = Numbers::new(5126, "VEC3").push(&mut bare, &[0.6; 12]);
    bare.document["meshes"] = json!([
        { "primitives": [{ "attributes": { "POSITION": many } }] },
        { "primitives": [{ "attributes": { "POSITION": 0, "NORMAL": normals }, "indices": 1 }] },
    ]);
    bare.document["nodes"] = json!([vec![json!({ "mesh": 0 }); 8000], vec![json!({ "mesh": 1 })]].concat());
    let message = refused(&bare, &[]);
    assert!(message.contains("80000000 triangles share vertices without normals"), "{message}");
    assert!(started.elapsed().as_secs() < 60, "{:?}", started.elapsed());
}

/// Weights of morph targets are shared by all instances of a node.
#[test]
fn many_weights_of_many_instances_are_kept_once() {
    let mut scene = square();
    let places = scene.push("accessors", zeros(100_000, "VEC3", 5126));
    let extension = json!({ "EXT_mesh_gpu_instancing": { "attributes": { "TRANSLATION": places } } });
    let node = json!({ "mesh": 0, "extensions": extension, "weights": vec![1; 60_000] });
    scene.push("nodes", node);
    let folder = TempDir::new().unwrap();
    let path = folder.path().join("weights.glb");
    std::fs::write(&path, scene.to_glb()).unwrap();
    let source = open_pieces(&path, &options(1000)).unwrap();
    assert_eq!((source.summary().triangle_count, source.piece_count()), (200_000, 200));
    assert_eq!(source.read_piece(199).unwrap().triangles.len(), 1000);
}

#[cfg(feature = "meshopt")]
#[test]
fn damaged_compressed_data_are_found_in_their_piece() {
    use striata_io::{Format, WriteOptions, to_bytes};

    let mesh = shapes::torus(30, 20, 2.0, 0.5);
    let bytes = to_bytes(Format::Glb, &mesh, &WriteOptions::default().with_meshopt(true)).unwrap();
    let folder = TempDir::new().unwrap();
    let path = folder.path().join("bad.glb");
    let json_end = 20 + u32::from_le_bytes(*bytes[12..].first_chunk().unwrap()) as usize;
    let mut refused_count = 0;
    for place in (json_end + 8..bytes.len()).step_by(61) {
        let mut damaged = bytes.clone();
        damaged[place] ^= 0xFF;
        std::fs::write(&path, damaged).unwrap();
        // Opening decompresses nothing.
        let source = open_pieces(&path, &options(100)).unwrap();
        assert_eq!(source.summary().triangle_count, mesh.triangle_count() as u64);
        refused_count += usize::from(!survive(&path));
    }
    assert!(refused_count > 10, "{refused_count}");
}
