//! GLB of one mesh in strips whose vertices arrive piece by piece, for meshes that do not fit into memory.
//!
//! All pieces are read once to find counts, bounds and types, then again for each attribute, because a GLB
//! stores one attribute after another. The document is written in between.

use std::io::{self, Write};

use serde_json::{Map, Value, json};
use striata::mesh::{Appearance, IndexedMesh};

use super::builder::{ELEMENT_ARRAY_BUFFER, GltfBuilder, TRIANGLE_STRIP};
use super::component_type::GltfComponentType;
use super::georeference::{add_georeference, is_terrain, place_node};
use super::write_layers::attributes;
use crate::error::Refusal;

/// Attributes that all pieces of a mesh's vertices have in common.
#[derive(Debug, Default)]
pub(crate) struct VertexPieces {
    attributes: Map<String, Value>,
    targets: Vec<Value>,
    views: Vec<Value>,
    accessors: Vec<Value>,
    vertex_count: u64,
    origin: [f64; 3],
    appearance: Appearance,
}

impl VertexPieces {
    /// Adds the next piece.
    pub(crate) fn add(&mut self, piece: &IndexedMesh) -> Result<(), Refusal> {
        let mut builder = GltfBuilder::default();
        let found = attributes(&mut builder, piece)?;
        if self.vertex_count == 0 {
            (self.attributes, self.targets) = (found.attributes, found.targets);
            (self.views, self.accessors) = (builder.views, builder.accessors);
            (self.origin, self.appearance) = (piece.origin, piece.appearance.clone());
        } else {
            let is_alike = self.attributes == found.attributes && self.targets == found.targets;
            if !is_alike || self.accessors.len() != builder.accessors.len() {
                return Err(Refusal::Unsupported("its layers are not of one type throughout".to_owned()));
            }
            for (all, piece) in self.accessors.iter_mut().zip(&builder.accessors) {
                add_accessor(all, piece)?;
            }
            for (all, piece) in self.views.iter_mut().zip(&builder.views) {
                all["byteLength"] = json!(number(all, "byteLength") + number(piece, "byteLength"));
            }
        }
        self.vertex_count += piece.vertex_count() as u64;
        Ok(())
    }

    /// Returns the number of attributes, each of which has a view of its own.
    pub(crate) fn view_count(&self) -> usize {
        self.views.len()
    }

    /// Returns the bytes of a piece in one of the views.
    pub(crate) fn view_of(piece: &IndexedMesh, view: usize) -> Result<Vec<u8>, Refusal> {
        let mut builder = GltfBuilder::default();
        attributes(&mut builder, piece)?;
        let bytes = |key| builder.views.get(view).map_or(0, |view| number(view, key)) as usize;
        let (start, length) = (bytes("byteOffset"), bytes("byteLength"));
        Ok(builder.binary[start..start + length].to_vec())
    }

    /// Whether indices take two bytes each; the largest 16-bit value is left for primitive restart.
    pub(crate) fn has_short_indices(&self) -> bool {
        self.vertex_count <= u64::from(u16::MAX)
    }

    /// Writes everything before the first vertex: headers and the document.
    pub(crate) fn write_head(&mut self, index_count: u64, out: &mut dyn Write) -> io::Result<()> {
        let (mut json, binary_bytes) = self.document(index_count);
        json.resize(json.len().next_multiple_of(4), b' ');
        let total = 12 + 8 + json.len() as u64 + if binary_bytes > 0 { 8 + binary_bytes } else { 0 };
        let too_large = |_| io::Error::other("the file would be larger than 4 GiB, which no GLB can be");
        let total = u32::try_from(total).map_err(too_large)?;
        out.write_all(b"glTF")?;
        for word in [2, total, json.len() as u32] {
            out.write_all(&word.to_le_bytes())?;
        }
        out.write_all(b"JSON")?;
        out.write_all(&json)?;
        if binary_bytes > 0 {
            out.write_all(&(binary_bytes as u32).to_le_bytes())?;
            out.write_all(b"BIN\0")?;
        }
        Ok(())
    }

    /// Returns the document and the size in bytes of the buffer that it describes, a multiple of four.
    fn document(&mut self, index_count: u64) -> (Vec<u8>, u64) {
        let mut root = json!({ "asset": { "version": "2.0", "generator": "striata" }, "scene": 0 });
        if index_count == 0 {
            root["scenes"] = json!([{}]);
            return (root.to_string().into_bytes(), 0);
        }
        let mut at = 0;
        for view in &mut self.views {
            view["byteOffset"] = json!(at);
            at += number(view, "byteLength").next_multiple_of(4);
        }
        let (component, bytes) =
            if self.has_short_indices() { (GltfComponentType::U16, 2) } else { (GltfComponentType::U32, 4) };
        let (mut views, mut accessors) = (self.views.clone(), self.accessors.clone());
        accessors.push(json!({
            "bufferView": views.len(),
            "componentType": component.number(),
            "count": index_count,
            "type": "SCALAR",
        }));
        views.push(json!({
            "buffer": 0,
            "byteOffset": at,
            "byteLength": index_count * bytes,
            "target": ELEMENT_ARRAY_BUFFER,
        }));
        at += (index_count * bytes).next_multiple_of(4);
        let mut primitive = json!({
            "attributes": self.attributes,
            "indices": accessors.len() - 1,
            "mode": TRIANGLE_STRIP,
        });
        if !self.targets.is_empty() {
            primitive["targets"] = json!(self.targets);
        }
        root["scenes"] = json!([{ "nodes": [0] }]);
        root["nodes"] = json!([{ "mesh": 0 }]);
        place_node(&mut root["nodes"][0], self.origin, is_terrain(&self.appearance));
        add_georeference(&mut root["scenes"][0], &self.appearance);
        root["meshes"] = json!([{ "primitives": [primitive] }]);
        root["accessors"] = json!(accessors);
        root["bufferViews"] = json!(views);
        root["buffers"] = json!([{ "byteLength": at }]);
        (root.to_string().into_bytes(), at)
    }
}

fn number(value: &Value, key: &str) -> u64 {
    value.get(key).and_then(Value::as_u64).unwrap_or(0)
}

/// Merges a piece's accessor into that of the previous pieces.
fn add_accessor(all: &mut Value, piece: &Value) -> Result<(), Refusal> {
    let is_alike = ["componentType", "type", "normalized"].iter().all(|&key| all.get(key) == piece.get(key));
    if !is_alike {
        return Err(Refusal::Unsupported("its layers are not of one type throughout".to_owned()));
    }
    all["count"] = json!(number(all, "count") + number(piece, "count"));
    for (key, choose) in [("min", f64::min as fn(f64, f64) -> f64), ("max", f64::max)] {
        let (Some(Value::Array(all)), Some(Value::Array(piece))) = (all.get_mut(key), piece.get(key)) else {
            continue;
        };
        for (all, piece) in all.iter_mut().zip(piece) {
            if let (Some(a), Some(b)) = (all.as_f64(), piece.as_f64()) {
                *all = json!(choose(a, b));
            }
        }
    }
    Ok(())
}
