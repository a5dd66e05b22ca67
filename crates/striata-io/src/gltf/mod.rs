//! glTF 2.0, as JSON and as GLB.
//!
//! The reader flattens the default scene into one mesh. Each triangle primitive of each node becomes a
//! group (all fans of one mesh and material become one group), with transforms applied, attribute sets
//! merged, and materials kept as their JSON. Own reader on `serde_json` values: the `gltf` crate rejects
//! scenes without nodes, reports no place for its errors, keeps only those parts of materials that it
//! understands, and leaves the bounds of views to its caller. It serves as the oracle in the tests instead.
//!
//! Primitives that use the same accessors under the same transform share their vertices, and the writer
//! gives all groups one vertex buffer, so files do not grow when they are read and written again. Skeletons
//! and animations are dropped: joints and weights are kept as layers, but not the nodes, skins and channels
//! that use them. Cost: one pass over each accessor of each block of vertices.
//!
//! What the writer has finished, `passes` may quantize and compress.
//!
//! Compressed geometry is decoded at first use: buffer views of meshoptimizer in `meshopt` (feature
//! `meshopt`), primitives of Draco in `draco` and `draco_mesh` (feature `draco`). `unpacked` keeps the
//! result and limits its size. Quantized attributes need no special care: `accessor` reads every component
//! type, and node transforms restore the scale. Skinned meshes are the exception: glTF ignores the
//! transforms of their nodes, so a quantized one keeps the scale of its integers.

mod accessor;
mod appearance;
mod assemble;
mod builder;
mod component_type;
mod compression;
mod container;
mod document;
mod draco;
mod draco_mesh;
mod json;
mod layers;
mod meshopt;
mod passes;
mod primitive;
mod scene;
mod unpacked;
mod uri;
#[cfg(all(feature = "blocks", not(target_family = "wasm")))]
mod vertex_pieces;
mod write;
mod write_layers;

use striata::mesh::IndexedMesh;

#[cfg(all(feature = "blocks", not(target_family = "wasm")))]
pub(crate) use vertex_pieces::VertexPieces;
pub(crate) use write::{to_glb_bytes, to_json_bytes};

use crate::error::Fault;
use crate::{Format, Source};
use document::Document;

/// Reads a mesh from the bytes of a glTF or GLB file.
pub(crate) fn read(bytes: &[u8], format: Format, source: &Source<'_>) -> Result<IndexedMesh, Fault> {
    let (json, blob) = match format {
        Format::Glb => container::chunks(bytes)?,
        _ => (bytes, None),
    };
    let root = json::parse(json)?;
    let document = Document::open(&root, blob, json.len(), source)?;
    assemble::mesh_of(&document)
}
