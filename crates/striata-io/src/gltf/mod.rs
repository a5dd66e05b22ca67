//! glTF 2.0, as JSON and as GLB.
//!
//! The reader flattens the default scene into one mesh. Each triangle primitive of each node becomes a
//! group (all fans of one mesh and material become one group), with transforms applied, attribute sets
//! merged, and materials kept as their JSON. Own reader on `serde_json` values: the `gltf` crate rejects
//! scenes without nodes, reports no place for its errors, keeps only those parts of materials that it
//! understands, and leaves the bounds of views to its caller. It serves as the oracle in the tests instead.
//!
//! Primitives that use the same accessors under the same transform share their vertices, and the writer gives
//! all groups one vertex buffer, so files do not grow when they are read and written again. Skeletons and
//! animations are dropped: the vertices have the pose of the nodes (`rest_pose`), and joints and weights are
//! kept as layers, but not the nodes, skins and channels that use them. Cost: one pass over each accessor of
//! each block of vertices.
//!
//! After the writer has finished, `passes` may quantize and compress the file.
//!
//! Compressed geometry is decoded at first use: buffer views of meshoptimizer in `meshopt` (feature
//! `meshopt`), primitives of Draco in `draco` and `draco_mesh` (feature `draco`). `unpacked` keeps the
//! result and limits its size. Quantized attributes need no special care: `accessor` reads every component
//! type, and node transforms restore the scale, or the joints of skinned meshes, whose node transforms glTF
//! ignores.

mod accessor;
mod appearance;
mod assemble;
mod buffers;
mod builder;
mod carry;
mod component_type;
mod compression;
mod container;
mod document;
mod draco;
mod draco_mesh;
mod extensions;
mod far_origin;
mod files;
mod gather;
mod georeference;
mod gpu_instancing;
mod importance;
mod json;
mod layers;
mod meshopt;
mod node_tree;
mod numbering;
#[cfg(all(feature = "pieces", not(target_family = "wasm")))]
mod partial;
mod passes;
mod primitive;
mod read_scene;
mod references;
mod resample;
mod rest_pose;
mod semantics;
mod shading;
mod shapes;
#[cfg_attr(
    not(all(feature = "pieces", not(target_family = "wasm"))),
    expect(dead_code, reason = "only files in pieces are read by several threads")
)]
mod shared_cache;
mod shown_meshes;
mod transform;
mod unpacked;
mod uri;
#[cfg(all(feature = "blocks", not(target_family = "wasm")))]
mod vertex_pieces;
mod vertex_pools;
mod write;
mod write_layers;
mod write_scene;

use striata::mesh::IndexedMesh;

/// Items that readers of parts of a document need.
#[cfg(all(feature = "pieces", not(target_family = "wasm")))]
pub(crate) mod parts {
    pub(crate) use super::accessor::Accessor;
    pub(crate) use super::appearance::appearance;
    pub(crate) use super::buffers::Buffers;
    pub(crate) use super::container::chunk_ranges;
    pub(crate) use super::document::{GltfDocument, check_requirements};
    pub(crate) use super::draco::{DracoKey, DracoLink};
    pub(crate) use super::far_origin::{origin_of_corners, placed_corners};
    pub(crate) use super::json::{JsonNode, parse};
    pub(crate) use super::layers::{LayerFormats, add_vertices, append, fill};
    pub(crate) use super::node_tree::{Instance, visit_instances};
    pub(crate) use super::partial::{TriangleCount, TriangleRuns};
    pub(crate) use super::primitive::{Primitive, document_fault};
    pub(crate) use super::rest_pose::RestPose;
    pub(crate) use super::shapes::{check_triangles, left_out};
    pub(crate) use super::shared_cache::{SharedCache, UnpackedCache};
    pub(crate) use super::transform::Transform;
}

pub(crate) use extensions::are_all_known;
pub use extensions::{ExtensionUse, extension_use, known_extensions};
pub(crate) use files::GltfContainer;
pub(crate) use georeference::{add_georeference, georeference_in, is_terrain, place_node};
pub(crate) use importance::usable as usable_importance;
#[cfg(feature = "draco")]
pub use passes::encode_draco;
pub(crate) use references::{entries, has_triangles, is_blended};
pub(crate) use semantics::target_of;
pub(crate) use shading::is_added;
pub use shading::shaded;
pub(crate) use shown_meshes::shown_meshes;
#[cfg(all(feature = "blocks", not(target_family = "wasm")))]
pub(crate) use vertex_pieces::VertexPieces;
pub(crate) use write::{image_entry, insert, looks, to_bytes};
pub(crate) use write_layers::{attribute_name, is_unstorable};
pub(crate) use write_scene::scene_to_bytes;

use crate::error::Fault;
use crate::report::Warnings;
use crate::{Format, MeshData, Scene, Source};
use buffers::Buffers;
use document::{GltfDocument, check_requirements};
use shapes::{check_triangles, left_out};

/// Reads a mesh from the bytes of a glTF or GLB file.
pub(crate) fn read(
    bytes: &[u8],
    format: Format,
    source: &Source<'_>,
    warnings: &mut Warnings,
) -> Result<IndexedMesh, Fault> {
    with_document(bytes, format, source, warnings, |document, warnings| {
        let mesh = assemble::mesh_of(document, warnings)?;
        check_triangles(document, mesh.triangles.is_empty())?;
        left_out(document, warnings)?;
        Ok(mesh)
    })
}

/// Reads a scene from the bytes of a glTF or GLB file.
pub(crate) fn read_scene(
    bytes: &[u8],
    format: Format,
    source: &Source<'_>,
    warnings: &mut Warnings,
) -> Result<Scene, Fault> {
    with_document(bytes, format, source, warnings, |document, warnings| {
        let scene = read_scene::scene_of(document, warnings)?;
        check_triangles(document, scene.meshes().iter().flatten().next().is_none())?;
        Ok(scene)
    })
}

/// Reads an accessor of a scene's document: the numbers, and how many of them each element has.
pub(crate) fn numbers_of(
    document: &serde_json::Value,
    buffer: &[u8],
    accessor: u64,
) -> Result<(Vec<f32>, usize), Fault> {
    let document = GltfDocument::over(document, buffer)?;
    let found = accessor::accessor(&document, accessor, &document.root)?;
    Ok((found.floats(), found.component_count))
}

/// Returns the data that an extension attaches to each mesh.
pub(crate) fn mesh_data(
    bytes: &[u8],
    format: Format,
    source: &Source<'_>,
    extension: &str,
) -> Result<Vec<Option<MeshData>>, Fault> {
    with_document(bytes, format, source, &mut Warnings::default(), |document, _| {
        let mesh_data = |mesh: &json::JsonNode<'_>| {
            let Some(at) = mesh.get("extensions").and_then(|at| at.get(extension)) else { return Ok(None) };
            let view = at.required_unsigned("bufferView")?;
            let (bytes, _) = document.view(view, &at)?;
            document.unpacked.claim(bytes.len() as u64, document.input_bytes, &at)?;
            Ok(Some(MeshData { extension: at.value.clone(), bytes: bytes.to_vec() }))
        };
        document.root.entries("meshes")?.iter().map(mesh_data).collect()
    })
}

fn with_document<T>(
    bytes: &[u8],
    format: Format,
    source: &Source<'_>,
    warnings: &mut Warnings,
    read: impl FnOnce(&GltfDocument<'_>, &mut Warnings) -> Result<T, Fault>,
) -> Result<T, Fault> {
    let (json, chunk) = match format {
        Format::Glb => container::chunks(bytes, warnings)?,
        _ => (bytes, None),
    };
    let root = json::parse(json)?;
    let at = json::JsonNode { value: &root, path: String::new() };
    check_requirements(&at)?;
    let buffers = Buffers::load(&at, source, read_whole)?;
    let document = GltfDocument::new(&root, json.len(), &buffers, chunk, *source)?;
    read(&document, warnings)
}

/// Reads a file from its beginning to its end.
fn read_whole(mut file: std::fs::File) -> std::io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    std::io::Read::read_to_end(&mut file, &mut bytes)?;
    Ok(bytes)
}
