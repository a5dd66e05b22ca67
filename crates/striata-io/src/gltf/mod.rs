//! glTF 2.0, as JSON and as GLB.
//!
//! The reader bakes the default scene into one mesh: one group for each triangle primitive of each node that shows
//! it (fans of one mesh and material are one group), transforms applied, attribute sets united, materials kept as the JSON they are. A reader of our own over `serde_json` values:
//! the `gltf` crate refuses scenes without nodes, knows no place for its errors, keeps materials only as far
//! as it understands them, and does not check buffers. It serves as the oracle in the tests instead.
//! Cost: one pass over each accessor of each block of vertices.

mod accessor;
mod assemble;
mod builder;
mod component_type;
mod container;
mod document;
mod json;
mod layers;
mod looks;
#[cfg(all(feature = "blocks", not(target_family = "wasm")))]
mod pieces;
mod primitive;
mod scene;
mod uri;
mod write;
mod write_layers;

use striata::mesh::IndexedMesh;

#[cfg(all(feature = "blocks", not(target_family = "wasm")))]
pub(crate) use pieces::VertexPieces;
pub(crate) use write::{to_glb_bytes, to_json_bytes};

use crate::error::Fault;
use crate::{Format, Source};
use document::Document;

pub(crate) fn read(bytes: &[u8], format: Format, source: &Source<'_>) -> Result<IndexedMesh, Fault> {
    let (json, blob) = match format {
        Format::Glb => container::chunks(bytes)?,
        _ => (bytes, None),
    };
    let root = json::parse(json)?;
    let document = Document::open(&root, blob, json.len(), source)?;
    assemble::mesh_of(&document)
}
