//! Zarr stores, read by a reader of their own: every level is the one that the library makes.

use std::fs;
use std::io::Read as _;
use std::path::Path;

use serde_json::Value;
use striata::ignore_progress;
use striata::mesh::{
    AttributeLayer, IndexedMesh, LayerData, RefinableMesh, Semantic, canonical_triangles, replay, shapes,
};
use striata::simplify::{SequenceOptions, build_sequence};
use striata_tiles::{TilesError, ZarrReport, write_zarr};

fn json(path: &Path) -> Value {
    serde_json::from_slice(&fs::read(path).unwrap()).unwrap()
}

/// The first rows of an array as bytes, from no more chunks than these are in; also its type.
fn rows(store: &Path, path: &str, count: u64) -> (Vec<u8>, String) {
    let folder = store.join(path);
    let node = json(&folder.join("zarr.json"));
    let configuration = &node["codecs"][0]["configuration"];
    let shape: Vec<u64> = node["shape"].as_array().unwrap().iter().map(|x| x.as_u64().unwrap()).collect();
    let chunk_rows = configuration["chunk_shape"][0].as_u64().unwrap();
    let shard_rows = node["chunk_grid"]["configuration"]["chunk_shape"][0].as_u64().unwrap();
    assert!(shard_rows >= shape[0] && shard_rows.is_multiple_of(chunk_rows) && count <= shape[0]);
    let name = if shape.len() == 2 { "c/0/0" } else { "c/0" };
    let shard = fs::read(folder.join(name)).unwrap();
    let index = &shard[shard.len() - 4 - 16 * (shard_rows / chunk_rows) as usize..];
    let mut bytes = Vec::new();
    for chunk in 0..count.div_ceil(chunk_rows) as usize {
        let word =
            |i: usize| u64::from_le_bytes(index[chunk * 16 + i * 8..][..8].try_into().unwrap()) as usize;
        flate2::read::GzDecoder::new(&shard[word(0)..word(0) + word(1)]).read_to_end(&mut bytes).unwrap();
    }
    let data_type = node["data_type"].as_str().unwrap().to_owned();
    let size: u64 = data_type.trim_start_matches(char::is_alphabetic).parse::<u64>().unwrap() / 8;
    let row_bytes = shape[1..].iter().product::<u64>() * size;
    assert_eq!(
        bytes.len() as u64,
        count.div_ceil(chunk_rows) * chunk_rows * row_bytes,
        "chunks are complete"
    );
    bytes.truncate((count * row_bytes) as usize);
    (bytes, data_type)
}

fn integers(store: &Path, path: &str, count: u64) -> Vec<u32> {
    let (bytes, data_type) = rows(store, path, count);
    assert_eq!(data_type, "uint32");
    bytes.as_chunks::<4>().0.iter().map(|word| u32::from_le_bytes(*word)).collect()
}

/// Triangles of the level with a number of vertices.
fn level(store: &Path, vertices: u64) -> Vec<[u32; 3]> {
    let root = json(&store.join("zarr.json"));
    let levels = root["attributes"]["striata"]["levels"].as_array().unwrap();
    let number = |level: &Value, name: &str| level[name].as_u64().unwrap();
    let finer = levels.iter().rfind(|level| number(level, "vertices") >= vertices).unwrap();
    let path = format!("{}/triangles", finer["path"].as_str().unwrap());
    let targets = integers(store, "targets", number(finer, "vertices"));
    let triangles = integers(store, &path, number(finer, "triangles"));
    let moved = |&vertex: &u32| {
        let mut vertex = vertex;
        while u64::from(vertex) >= vertices {
            vertex = targets[vertex as usize];
        }
        vertex
    };
    let corners = |c: &[u32; 3]| [0, 1, 2].map(|i| moved(&c[i]));
    let is_left = |c: &[u32; 3]| c[0] != c[1] && c[1] != c[2] && c[2] != c[0];
    triangles.as_chunks::<3>().0.iter().map(corners).filter(is_left).collect()
}

fn refinable(mesh: &IndexedMesh) -> RefinableMesh {
    build_sequence(mesh, &SequenceOptions::default()).unwrap().refinable
}

/// A torus with data of vertices and faces.
fn decorated() -> IndexedMesh {
    let mut mesh = shapes::torus(120, 90, 1.0, 0.4);
    let count = mesh.positions.len();
    let heights = mesh.positions.iter().map(|p| p[2]).collect();
    mesh.layers.push(AttributeLayer::from_f32(Semantic::Generic("a/b".into()), 1, heights));
    let bytes = mesh.positions.iter().flat_map(|p| p.map(|x| (100.0 + 50.0 * x) as u8)).collect();
    mesh.layers.push(AttributeLayer {
        semantic: Semantic::Color(0),
        component_count: 3,
        normalized: true,
        data: LayerData::U8(bytes),
    });
    assert_eq!(count, 120 * 90);
    let labels = (0..mesh.triangles.len() as u32).map(|t| (t / 500) as u16).collect();
    mesh.triangle_layers.push(AttributeLayer {
        semantic: Semantic::Generic("label".into()),
        component_count: 1,
        normalized: false,
        data: LayerData::U16(labels),
    });
    mesh
}

fn written(refinable: &RefinableMesh) -> (tempfile::TempDir, ZarrReport) {
    let folder = tempfile::tempdir().unwrap();
    let report =
        write_zarr(refinable, false, &folder.path().join("mesh.zarr"), &mut ignore_progress).unwrap();
    (folder, report)
}

#[test]
fn every_level_is_that_of_the_library() {
    for mesh in [decorated(), shapes::terrain(40, 3), shapes::tetrahedron()] {
        let refinable = refinable(&mesh);
        let (folder, report) = written(&refinable);
        let store = folder.path().join("mesh.zarr");
        let sequence = &refinable.sequence;
        let steps = sequence.step_count();
        assert_eq!((report.level_count, report.left_out.len()), (steps as u64 + 1, 0));
        let level_count = report.level_count;
        let (errors, data_type) = rows(&store, "errors", level_count);
        assert_eq!(data_type, "float32");
        let vertex_counts = integers(&store, "vertex_counts", level_count);
        let triangle_counts = integers(&store, "triangle_counts", level_count);
        for split_count in (0..=steps).step_by(steps / 37 + 1).chain([steps]) {
            let expected = replay(&refinable, split_count);
            let vertices = expected.positions.len() as u64;
            assert_eq!(u64::from(vertex_counts[split_count]), vertices);
            assert_eq!(triangle_counts[split_count] as usize, expected.triangles.len());
            let error = f32::from_le_bytes(errors[split_count * 4..][..4].try_into().unwrap());
            assert_eq!(error, sequence.error_at(split_count));
            let read = level(&store, vertices);
            assert_eq!(canonical_triangles(&read), canonical_triangles(&expected.triangles));
            let (positions, _) = rows(&store, "positions", vertices);
            let expected_bytes = LayerData::F32(expected.positions.as_flattened().to_vec());
            assert_eq!(positions, expected_bytes.as_bytes());
            for (layer, name) in expected.layers.iter().zip(["generic_a_b", "color_0"]) {
                let (values, _) = rows(&store, &format!("vertices/{name}"), vertices);
                assert_eq!(values, layer.data.as_bytes(), "{name}");
            }
        }
    }
}

#[test]
fn stored_levels_have_the_data_of_their_faces() {
    let refinable = refinable(&decorated());
    let (folder, report) = written(&refinable);
    let store = folder.path().join("mesh.zarr");
    assert!(report.levels.len() >= 4, "{report:?}");
    for (level, next) in report.levels.iter().zip(&report.levels[1..]) {
        assert!(next.vertices <= level.vertices / 4 || next == report.levels.last().unwrap());
        assert!(next.error >= level.error);
    }
    for level in &report.levels {
        let expected =
            replay(&refinable, refinable.sequence.split_count_for_vertices(level.vertices as usize));
        let (labels, data_type) =
            rows(&store, &format!("{}/faces/generic_label", level.path), level.triangles);
        assert_eq!(
            (labels.as_slice(), data_type.as_str()),
            (expected.triangle_layers[0].data.as_bytes(), "uint16")
        );
    }
    let node = json(&store.join("vertices/generic_a_b/zarr.json"));
    assert_eq!(node["attributes"]["name"], "generic_a/b");
    assert_eq!(json(&store.join("vertices/color_0/zarr.json"))["attributes"]["normalized"], true);
}

#[test]
fn exact_positions_are_doubles() {
    let mut mesh = shapes::torus(12, 9, 1.0, 0.4);
    let exact: Vec<[f64; 3]> = mesh.positions.iter().map(|p| p.map(|x| 5e6 + f64::from(x) + 1e-9)).collect();
    mesh.set_file_positions(exact);
    let refinable = refinable(&mesh);
    let (folder, _) = written(&refinable);
    let store = folder.path().join("mesh.zarr");
    let (bytes, data_type) = rows(&store, "positions", refinable.mesh.positions.len() as u64);
    let expected = LayerData::F64(refinable.mesh.exact_positions.as_flattened().to_vec());
    assert_eq!((bytes.as_slice(), data_type.as_str()), (expected.as_bytes(), "float64"));
    assert_eq!(json(&store.join("zarr.json"))["attributes"]["striata"]["origin"][0], 0.0);
}

#[test]
fn only_its_own_store_is_replaced() {
    let refinable = refinable(&shapes::torus(12, 9, 1.0, 0.4));
    let (folder, _) = written(&refinable);
    let store = folder.path().join("mesh.zarr");
    fs::write(store.join("old"), "").unwrap();
    write_zarr(&refinable, true, &store, &mut ignore_progress).unwrap();
    assert!(!store.join("old").exists());
    assert_eq!(json(&store.join("zarr.json"))["attributes"]["striata"]["guaranteed_errors"], true);
    let stopped =
        write_zarr(&refinable, true, &folder.path().join("no"), &mut |_| std::ops::ControlFlow::Break(()));
    assert!(matches!(stopped, Err(TilesError::Cancelled(_))));
    fs::write(store.join("zarr.json"), "{}").unwrap();
    let refused = write_zarr(&refinable, true, &store, &mut ignore_progress);
    assert!(matches!(refused, Err(TilesError::Place { .. })));
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1);
}
