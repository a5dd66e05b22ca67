//! Primitives of Draco must give an error, or a consistent mesh.
#![no_main]

use libfuzzer_sys::fuzz_target;
use serde_json::json;
use striata_fuzz::allow_contained_panics;
use striata_io::{Source, read_bytes, read_scene_bytes};
use striata_testing::strange::StrangeParts;

fuzz_target!(|data: &[u8]| {
    allow_contained_panics();
    let accessor =
        |kind: &str, component: u64| json!({ "componentType": component, "type": kind, "count": 3 });
    let primitive = json!({
        "attributes": { "POSITION": 0, "NORMAL": 1, "TEXCOORD_0": 2 },
        "indices": 3,
        "extensions": { "KHR_draco_mesh_compression": {
            "bufferView": 0, "attributes": { "POSITION": 0, "NORMAL": 1, "TEXCOORD_0": 2 },
        } },
    });
    let mut bare = primitive.clone();
    bare["attributes"] = json!({ "POSITION": 0 });
    let document = json!({
        "asset": { "version": "2.0" },
        "extensionsRequired": ["KHR_draco_mesh_compression"],
        "buffers": [{ "byteLength": data.len() }],
        "bufferViews": [{ "buffer": 0, "byteLength": data.len() }],
        "accessors": [
            accessor("VEC3", 5126), accessor("VEC3", 5126), accessor("VEC2", 5126), accessor("SCALAR", 5125),
        ],
        "meshes": [{ "primitives": [primitive] }],
    });
    let mut parts = StrangeParts { document, buffer: data.to_vec() };
    check(&parts.to_glb());
    parts.document["meshes"][0]["primitives"][0] = bare;
    check(&parts.to_glb());
});

fn check(glb: &[u8]) {
    let source = Source::new("x.glb");
    if let Ok(mesh) = read_bytes(glb, &source) {
        assert_eq!(mesh.check().is_ok(), mesh.positions.as_flattened().iter().all(|x| x.is_finite()));
    }
    let _ = read_scene_bytes(glb, &source);
}
