//! Accessors of all types, and scenes in several files.

use std::path::{Path, PathBuf};

use serde_json::{Value, json};
use striata_testing::scenes::TestScene;

/// How an accessor is stored.
#[derive(Clone, Debug)]
pub(super) struct Numbers {
    component: u32,
    kind: &'static str,
    normalized: bool,
    /// Unused bytes after each element.
    gap: usize,
    /// Elements that are replaced; the view has other numbers for them.
    replaced: Vec<usize>,
}

pub(super) fn width(kind: &str) -> usize {
    match kind {
        "SCALAR" => 1,
        "VEC2" => 2,
        "VEC3" => 3,
        _ => 4,
    }
}

fn bytes_of(component: u32, value: f64) -> Vec<u8> {
    match component {
        5120 => (value as i8).to_le_bytes().to_vec(),
        5121 => (value as u8).to_le_bytes().to_vec(),
        5122 => (value as i16).to_le_bytes().to_vec(),
        5123 => (value as u16).to_le_bytes().to_vec(),
        5125 => (value as u32).to_le_bytes().to_vec(),
        _ => (value as f32).to_le_bytes().to_vec(),
    }
}

impl Numbers {
    pub(super) fn new(component: u32, kind: &'static str) -> Self {
        Self { component, kind, normalized: false, gap: 0, replaced: Vec::new() }
    }

    pub(super) fn normalized(self) -> Self {
        Self { normalized: true, ..self }
    }

    pub(super) fn with_gap(self, gap: usize) -> Self {
        Self { gap, ..self }
    }

    pub(super) fn sparse(self, replaced: &[usize]) -> Self {
        Self { replaced: replaced.to_vec(), ..self }
    }

    /// Adds an accessor of these values; returns its index.
    pub(super) fn push(&self, scene: &mut TestScene, values: &[f64]) -> usize {
        let width = width(self.kind);
        let element = |values: &[f64]| -> Vec<u8> {
            values.iter().flat_map(|&value| bytes_of(self.component, value)).collect()
        };
        let mut bytes = Vec::new();
        for (index, values) in values.chunks(width).enumerate() {
            let is_replaced = self.replaced.contains(&index);
            bytes.extend(if is_replaced { element(&vec![1.0; width]) } else { element(values) });
            bytes.resize(bytes.len() + self.gap, 0xAA);
        }
        let view = scene.push_view(&bytes);
        if self.gap > 0 {
            scene.document["bufferViews"][view]["byteStride"] =
                json!(width * bytes_of(self.component, 0.0).len() + self.gap);
        }
        let mut accessor = json!({
            "bufferView": view,
            "componentType": self.component,
            "count": values.len() / width,
            "type": self.kind,
            "normalized": self.normalized,
        });
        if !self.replaced.is_empty() {
            let indices: Vec<u8> = self.replaced.iter().flat_map(|&i| (i as u16).to_le_bytes()).collect();
            let replacements: Vec<u8> =
                self.replaced.iter().flat_map(|&i| element(&values[width * i..width * (i + 1)])).collect();
            accessor["sparse"] = json!({
                "count": self.replaced.len(),
                "indices": { "bufferView": scene.push_view(&indices), "componentType": 5123 },
                "values": { "bufferView": scene.push_view(&replacements) },
            });
        }
        scene.push("accessors", accessor)
    }
}

/// Writes a scene as glTF with two files, each of which has every other view.
pub(super) fn with_files(scene: &TestScene, folder: &Path) -> PathBuf {
    let mut document = scene.document.clone();
    let views = document.get_mut("bufferViews").and_then(Value::as_array_mut).into_iter().flatten();
    for (index, view) in views.enumerate() {
        view["buffer"] = json!(index % 2);
    }
    if !scene.buffer.is_empty() {
        let length = scene.buffer.len();
        document["buffers"] = json!([
            { "byteLength": length, "uri": "even%20views.bin" },
            { "byteLength": length, "uri": "odd.bin" },
        ]);
        // Bytes of the other file's views are wrong.
        let views: Vec<Value> = document["bufferViews"].as_array().unwrap().clone();
        for (number, name) in ["even views.bin", "odd.bin"].into_iter().enumerate() {
            let mut bytes = vec![0xEE; length];
            for view in views.iter().filter(|view| view["buffer"] == json!(number)) {
                let start = view["byteOffset"].as_u64().unwrap() as usize;
                let range = start..start + view["byteLength"].as_u64().unwrap() as usize;
                bytes[range.clone()].copy_from_slice(&scene.buffer[range]);
            }
            std::fs::write(folder.join(name), bytes).unwrap();
        }
    }
    let path = folder.join("scene.gltf");
    std::fs::write(&path, document.to_string()).unwrap();
    path
}
