//! Buffer views of meshoptimizer in every mode, with every filter, must give an error or a consistent mesh.
#![no_main]

use libfuzzer_sys::fuzz_target;
use serde_json::{Value, json};
use striata_fuzz::{Bytes, allow_contained_panics};
use striata_io::{Source, read_bytes, read_scene_bytes};
use striata_testing::strange::StrangeParts;

const MODES: [&str; 3] = ["ATTRIBUTES", "TRIANGLES", "INDICES"];
const FILTERS: [&str; 5] = ["NONE", "OCTAHEDRAL", "QUATERNION", "EXPONENTIAL", "COLOR"];
const STRIDES: [u64; 8] = [2, 4, 8, 12, 16, 20, 128, 256];

fuzz_target!(|data: &[u8]| {
    allow_contained_panics();
    let mut input = Bytes(data);
    let (kind, stride, count) = (usize::from(input.byte()), input.byte(), input.short());
    // Counts up to four million, with all small ones.
    let count = if count < 1 << 15 { count } else { (count - (1 << 15)) << 7 };
    let (mode, filter) = (MODES[kind % 3], FILTERS[kind / 3 % 5]);
    let stride = STRIDES[usize::from(stride) % STRIDES.len()];
    let extension = if kind / 15 % 2 == 0 { "EXT_meshopt_compression" } else { "KHR_meshopt_compression" };
    let glb = file(extension, &MeshoptView { mode, filter, count: count as u64, stride }, input.0);
    let source = Source::new("x.glb");
    if let Ok(mesh) = read_bytes(&glb, &source) {
        assert_eq!(mesh.check().is_ok(), mesh.positions.as_flattened().iter().all(|x| x.is_finite()));
    }
    let _ = read_scene_bytes(&glb, &source);
});

/// A compressed view: how it is coded, and its elements.
struct MeshoptView<'a> {
    mode: &'a str,
    filter: &'a str,
    count: u64,
    stride: u64,
}

/// Builds a file in which the view is read as indices of a triangle list, or as positions and joints.
fn file(extension: &str, coded: &MeshoptView<'_>, packed: &[u8]) -> Vec<u8> {
    let &MeshoptView { mode, filter, count, stride } = coded;
    let plain: Vec<u8> =
        (0..256u32).flat_map(|i| [i as f32, (i * i % 7) as f32, 0.5]).flat_map(f32::to_le_bytes).collect();
    let length = count * stride;
    let mut compression = json!({
        "buffer": 0, "byteOffset": 0, "byteLength": packed.len(),
        "byteStride": stride, "count": count, "mode": mode,
    });
    if filter != "NONE" {
        compression["filter"] = json!(filter);
    }
    let mut view = json!({ "buffer": 1, "byteLength": length, "extensions": { extension: compression } });
    let accessor = |component: u64, kind: &str, count: u64| -> Value {
        json!({ "bufferView": 0, "componentType": component, "type": kind, "count": count })
    };
    let (primitive, accessors) = if mode == "ATTRIBUTES" {
        view["byteStride"] = json!(stride.min(252));
        let primitive = if stride < 12 {
            json!({ "attributes": { "POSITION": 1, "JOINTS_0": 0 } })
        } else {
            json!({ "attributes": { "POSITION": 0 } })
        };
        let first =
            if stride < 12 { accessor(5121, "VEC4", count.min(256)) } else { accessor(5126, "VEC3", count) };
        (primitive, [first, accessor(5126, "VEC3", count.min(256))])
    } else {
        let component = if stride == 2 { 5123 } else { 5125 };
        let primitive = json!({ "attributes": { "POSITION": 1 }, "indices": 0 });
        (primitive, [accessor(component, "SCALAR", count), accessor(5126, "VEC3", 256)])
    };
    let mut accessors = accessors.to_vec();
    accessors[1]["bufferView"] = json!(1);
    let document = json!({
        "asset": { "version": "2.0" },
        "extensionsUsed": [extension],
        "extensionsRequired": [extension],
        "buffers": [{ "byteLength": packed.len() + plain.len() }, { "byteLength": length }],
        "bufferViews": [view, { "buffer": 0, "byteOffset": packed.len(), "byteLength": plain.len() }],
        "accessors": accessors,
        "meshes": [{ "primitives": [primitive] }],
    });
    StrangeParts { document, buffer: [packed, &plain].concat() }.to_glb()
}
