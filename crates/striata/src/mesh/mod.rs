//! Indexed triangle meshes, and everything that is true of a mesh before any model is built from it.
//!
//! A **vertex** is what a GPU means by it: a position with its attributes. Vertices that share one
//! position are its **wedges**; [`weld`] finds them and gives each position a number.

mod appearance;
mod attributes;
mod indexed_mesh;
mod positions;
mod replay;
mod sequence;
mod weld;

pub use appearance::{Appearance, Image, Material};
pub use attributes::{AttributeLayer, LayerData, Semantic};
pub use indexed_mesh::{Bounds, IndexedMesh, MeshError, TriangleGroup};
pub use positions::PositionIndex;
pub use replay::{canonical_triangles, replay, replay_into};
pub use sequence::{CollapseSequence, RefinableMesh, SequenceError, SequenceParts};
pub use weld::{Welded, weld};
