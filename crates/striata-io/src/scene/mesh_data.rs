//! Data that an extension attaches to meshes of a glTF file.

use std::borrow::Cow;

use serde_json::Value;

use crate::{Format, ReadError, Source, decompressed};

/// An extension of a glTF mesh, with the bytes of the buffer view that its `bufferView` names.
#[derive(Clone, Debug, PartialEq)]
pub struct MeshData {
    /// The extension's object.
    pub extension: Value,
    /// Bytes of the buffer view.
    pub bytes: Vec<u8>,
}

/// Reads the data that an extension attaches to the meshes of a glTF or GLB file: one entry for each mesh,
/// or an empty list if the file has another format.
///
/// # Errors
/// Returns [`ReadError`] if the file is damaged, or a buffer view of the extension does not exist.
pub fn mesh_data(
    bytes: &[u8],
    source: &Source<'_>,
    extension: &str,
) -> Result<Vec<Option<MeshData>>, ReadError> {
    let (unpacked, name) = decompressed(Cow::Borrowed(bytes), source.name)?;
    match Format::detect(&unpacked, &name) {
        Some(format @ (Format::Gltf | Format::Glb)) => {
            let found = crate::gltf::mesh_data(&unpacked, format, source, extension);
            found.map_err(|fault| fault.in_file(source.name))
        }
        _ => Ok(Vec::new()),
    }
}
