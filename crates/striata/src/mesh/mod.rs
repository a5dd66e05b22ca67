//! Indexed triangle meshes: attributes, welding, validation, measurement, and the collapse sequence.
//!
//! This module contains everything that is known about a mesh before a model is built from it. A **vertex**
//! is what a GPU means by it: a position together with its attributes. Vertices that share one position are
//! its **wedges**; [`weld`] finds them and assigns an index to each distinct position.

mod adjacency;
mod appearance;
mod attributes;
mod axis_box;
mod box_tree;
mod defect;
mod disjoint_sets;
mod distance;
mod dual_graph;
mod fragments;
mod indexed_mesh;
pub(crate) mod lanes;
mod level_table;
mod origin;
mod point_packet;
mod positions;
mod random;
mod replay;
mod sequence;
mod sequence_error;
pub mod shapes;
mod smooth_normals;
mod statistics;
mod steps;
mod surface_samples;
mod triangle_data;
mod triangle_tree;
mod validate;
mod weld;

pub use adjacency::{Adjacency, Edge, is_proper};
pub use appearance::{Appearance, ColorSpace, Image, Material};
pub(crate) use attributes::gather_layers;
pub use attributes::{AttributeLayer, LayerData, Semantic};
pub(crate) use axis_box::AxisBox;
pub(crate) use box_tree::BoxTree;
pub use defect::{Defect, DefectKind};
pub use disjoint_sets::DisjointSets;
pub use distance::{
    DistanceError, DistanceOptions, OneSidedDistance, SurfaceDistance, surface_distance,
    surface_distance_with_progress,
};
pub use dual_graph::{DualGraph, NO_TWIN};
pub use fragments::{
    Face, Fragment, FragmentError, FragmentSequence, FragmentedMesh, fragment_faces, replay_fragments,
};
pub use indexed_mesh::{Bounds, IndexedMesh, MeshError, TriangleGroup};
pub use level_table::{LevelTable, steps_for_detail};
pub(crate) use origin::Extent;
pub use origin::{origin_of, relative_position};
pub(crate) use point_packet::{PACKET, PointPacket};
pub use positions::PositionIndex;
pub use random::Random;
pub(crate) use replay::canonical_triangle;
pub use replay::{canonical_triangles, replay, replay_into};
pub use sequence::{CollapseSequence, RefinableMesh, SequenceParts};
pub use sequence_error::SequenceError;
pub use smooth_normals::PositionEdges;
pub use statistics::{Statistics, without_copies};
pub use steps::Steps;
pub use surface_samples::{SurfaceSample, SurfaceSamples};
pub use triangle_data::{layers_from_sorted, level_sources, nearest_sources, sorted_triangle_order};
pub(crate) use triangle_tree::TriangleSearch;
pub use triangle_tree::{Nearest, TriangleTree};
pub use validate::{MAX_LISTED_PER_KIND, Report, validate};
pub(crate) use weld::ZOrderCurve;
pub use weld::{Welded, index_positions, weld};
