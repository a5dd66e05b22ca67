//! Meshes that do not fit into memory, read in independent pieces.
//!
//! A source says at once how many pieces there are, and any thread may read any piece at any time, as often
//! as it likes. Pieces have their own vertices: a vertex at the border of two pieces occurs in both.

mod appearances;
mod fractal_terrain;
pub(crate) mod gltf;
pub(crate) mod input;
mod kinds;
mod local;
mod mesh_pieces;
pub(crate) mod obj;
pub(crate) mod off;
mod open;
mod options;
pub(crate) mod ply;
mod ply_faces;
pub(crate) mod ply_text;
pub(crate) mod repaired;
pub(crate) mod scratch;
mod several;
pub(crate) mod spool;
pub(crate) mod stl;
mod stl_text;
#[cfg(feature = "terrain")]
mod terrain;
mod tiles;

pub use fractal_terrain::FractalTerrain;
pub use mesh_pieces::MeshPieces;
pub use open::{open_all, open_pieces};
pub use options::PieceOptions;
pub use several::{Several, open_several};
#[cfg(feature = "terrain")]
pub use terrain::{Terrain, is_raster};
pub use tiles::Tiles;

use std::path::PathBuf;

use serde::{Deserialize, Serialize};
use striata::mesh::{Appearance, AttributeLayer, Semantic};

use crate::{ReadError, Warning};

/// Type of the values of an attribute layer.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum ComponentType {
    /// 32-bit floats.
    F32,
    /// Bytes.
    U8,
    /// 16-bit integers.
    U16,
    /// 32-bit integers.
    U32,
    /// Signed bytes.
    I8,
    /// Signed 16-bit integers.
    I16,
    /// Signed 32-bit integers.
    I32,
    /// 64-bit floats.
    F64,
}

/// An attribute layer without its values.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LayerKind {
    /// Meaning of the values.
    pub semantic: Semantic,
    /// Number of values per vertex.
    pub component_count: u8,
    /// Whether integers stand for fractions.
    pub normalized: bool,
    /// Type of the values.
    pub component_type: ComponentType,
}

/// A group of triangles, possibly in many pieces.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct PieceGroup {
    /// Name of the group; may be empty.
    pub name: String,
    /// Index into [`Appearance::materials`], or `None` if the triangles have no material.
    pub material: Option<u32>,
}

/// Counts, layers, groups and appearance of an input, which are known before any piece is read.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PieceSummary {
    /// Name for messages: the file, or the first file and the number of the others.
    pub name: String,
    /// Origin of the positions of all pieces in the coordinates of the input, in mesh units.
    pub origin: [f64; 3],
    /// Layers of every piece, in this order.
    pub layers: Vec<LayerKind>,
    /// Layers of the triangles of every piece, in this order.
    pub triangle_layers: Vec<LayerKind>,
    /// Groups, which triangles refer to by index; at least one.
    pub groups: Vec<PieceGroup>,
    /// Materials and images.
    pub appearance: Appearance,
    /// Number of triangles; an estimate if the format does not say.
    pub triangle_count: u64,
    /// Total size of the files, in bytes.
    pub byte_count: u64,
    /// Other files that the input refers to: buffers, images, material libraries.
    pub companions: Vec<PathBuf>,
    /// Georeference of a raster: a JSON object, stored as it is. That of a mesh file is in its appearance.
    pub georeference: Option<serde_json::Value>,
    /// Remarks on what was left out, such as missing textures.
    pub warnings: Vec<Warning>,
}

/// Part of an input.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Piece {
    /// Position of each vertex relative to the summary's origin, in mesh units.
    pub positions: Vec<[f32; 3]>,
    /// The layers of the summary, with values for every vertex.
    pub layers: Vec<AttributeLayer>,
    /// Vertex indices of each triangle, all valid.
    pub triangles: Vec<[u32; 3]>,
    /// Group of each triangle, an index into the summary's groups; empty if all belong to group 0.
    pub groups: Vec<u32>,
    /// The layers of triangles of the summary, with a row for every triangle.
    pub triangle_layers: Vec<AttributeLayer>,
}

/// An input that is read piece by piece.
pub trait PieceSource: Send + Sync {
    /// Summary of the whole input.
    fn summary(&self) -> &PieceSummary;

    /// Number of pieces, of about 100,000 triangles each.
    fn piece_count(&self) -> u64;

    /// Remarks on what was left out so far: those of the summary, and those on the pieces that have been read.
    fn warnings(&self) -> Vec<Warning> {
        self.summary().warnings.clone()
    }

    /// Reads one piece. The same piece has the same content, whenever and wherever it is read.
    ///
    /// # Errors
    /// [`ReadError`] with the file, the place and the reason.
    fn read_piece(&self, index: u64) -> Result<Piece, ReadError>;
}
