//! The things that can be wrong with a mesh, each with its place and a line that says so.

use std::fmt;

use super::{MeshError, Semantic};

/// Something wrong with a mesh, and where.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Defect {
    /// The parts do not fit together: indices, lengths, groups, coordinates.
    Inconsistent(MeshError),
    /// A layer has another number of components than its meaning asks for.
    LayerShape {
        /// The layer.
        semantic: Semantic,
        /// Components it has.
        found: u8,
        /// Components it should have, in words.
        expected: &'static str,
    },
    /// Two layers mean the same.
    RepeatedLayer {
        /// The layer.
        semantic: Semantic,
    },
    /// A triangle names one vertex twice.
    RepeatedVertex {
        /// The triangle.
        triangle: usize,
        /// The vertex.
        vertex: u32,
    },
    /// Two vertices of a triangle are at one position.
    RepeatedPosition {
        /// The triangle.
        triangle: usize,
        /// The two vertices.
        vertices: [u32; 2],
    },
    /// The corners of a triangle are different, but on a line.
    NoArea {
        /// The triangle.
        triangle: usize,
    },
    /// A triangle has the positions of an earlier one.
    DuplicateTriangle {
        /// The triangle.
        triangle: usize,
        /// The first with these positions.
        first: usize,
        /// It faces the other way.
        is_opposite: bool,
    },
    /// More than two triangles meet in an edge.
    NonManifoldEdge {
        /// A vertex at each end.
        vertices: [u32; 2],
        /// Triangles on the edge.
        triangle_count: usize,
    },
    /// Two neighbors face opposite ways.
    InconsistentEdge {
        /// A vertex at each end.
        vertices: [u32; 2],
        /// The two triangles.
        triangles: [usize; 2],
    },
    /// Pieces of surface meet in a position and share no edge there.
    BowTie {
        /// A vertex at the position.
        vertex: u32,
        /// How many pieces.
        piece_count: usize,
    },
    /// No triangle names the vertex.
    UnusedVertex {
        /// The vertex.
        vertex: usize,
    },
    /// A number of a layer is NaN or infinite.
    NonFiniteAttribute {
        /// The layer.
        semantic: Semantic,
        /// The vertex.
        vertex: usize,
        /// The component.
        component: usize,
        /// What stands there.
        value: f32,
    },
    /// A normal or tangent is more than a hundredth longer or shorter than 1.
    NonUnitVector {
        /// The layer.
        semantic: Semantic,
        /// The vertex.
        vertex: usize,
        /// The length found.
        length: f64,
    },
    /// The weights of a vertex's joints, over all sets, sum to something a hundredth or more off 1.
    WeightSum {
        /// The vertex.
        vertex: usize,
        /// The sum found.
        sum: f64,
    },
}

/// The kinds of [`Defect`], in the order of reports.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
#[non_exhaustive]
pub enum DefectKind {
    /// [`Defect::Inconsistent`].
    Inconsistent,
    /// [`Defect::LayerShape`].
    LayerShape,
    /// [`Defect::RepeatedLayer`].
    RepeatedLayer,
    /// [`Defect::RepeatedVertex`].
    RepeatedVertex,
    /// [`Defect::RepeatedPosition`].
    RepeatedPosition,
    /// [`Defect::NoArea`].
    NoArea,
    /// [`Defect::DuplicateTriangle`].
    DuplicateTriangle,
    /// [`Defect::NonManifoldEdge`].
    NonManifoldEdge,
    /// [`Defect::InconsistentEdge`].
    InconsistentEdge,
    /// [`Defect::BowTie`].
    BowTie,
    /// [`Defect::UnusedVertex`].
    UnusedVertex,
    /// [`Defect::NonFiniteAttribute`].
    NonFiniteAttribute,
    /// [`Defect::NonUnitVector`].
    NonUnitVector,
    /// [`Defect::WeightSum`].
    WeightSum,
}

impl DefectKind {
    /// The kind in words that can follow a number.
    pub fn as_str(self) -> &'static str {
        match self {
            Self::Inconsistent => "parts that do not fit together",
            Self::LayerShape => "layers of the wrong shape",
            Self::RepeatedLayer => "repeated layers",
            Self::RepeatedVertex => "triangles with a repeated vertex",
            Self::RepeatedPosition => "triangles with a repeated position",
            Self::NoArea => "triangles without area",
            Self::DuplicateTriangle => "duplicate triangles",
            Self::NonManifoldEdge => "edges with more than two triangles",
            Self::InconsistentEdge => "edges between triangles that face opposite ways",
            Self::BowTie => "bow-tie vertices",
            Self::UnusedVertex => "unused vertices",
            Self::NonFiniteAttribute => "attributes that are not finite",
            Self::NonUnitVector => "normals or tangents that are not of length 1",
            Self::WeightSum => "vertices whose joint weights do not sum to 1",
        }
    }
}

impl Defect {
    /// The kind, without its place.
    pub fn kind(&self) -> DefectKind {
        match self {
            Self::Inconsistent(_) => DefectKind::Inconsistent,
            Self::LayerShape { .. } => DefectKind::LayerShape,
            Self::RepeatedLayer { .. } => DefectKind::RepeatedLayer,
            Self::RepeatedVertex { .. } => DefectKind::RepeatedVertex,
            Self::RepeatedPosition { .. } => DefectKind::RepeatedPosition,
            Self::NoArea { .. } => DefectKind::NoArea,
            Self::DuplicateTriangle { .. } => DefectKind::DuplicateTriangle,
            Self::NonManifoldEdge { .. } => DefectKind::NonManifoldEdge,
            Self::InconsistentEdge { .. } => DefectKind::InconsistentEdge,
            Self::BowTie { .. } => DefectKind::BowTie,
            Self::UnusedVertex { .. } => DefectKind::UnusedVertex,
            Self::NonFiniteAttribute { .. } => DefectKind::NonFiniteAttribute,
            Self::NonUnitVector { .. } => DefectKind::NonUnitVector,
            Self::WeightSum { .. } => DefectKind::WeightSum,
        }
    }
}

impl fmt::Display for Defect {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Inconsistent(error) => error.fmt(f),
            Self::LayerShape { semantic, found, expected } => {
                write!(f, "layer {semantic} has {found} components a vertex, but needs {expected}")
            }
            Self::RepeatedLayer { semantic } => write!(f, "layer {semantic} is there twice"),
            Self::RepeatedVertex { triangle, vertex } => {
                write!(f, "triangle {triangle} uses vertex {vertex} twice")
            }
            Self::RepeatedPosition { triangle, vertices: [a, b] } => {
                write!(f, "triangle {triangle} uses vertices {a} and {b}, which are at one position")
            }
            Self::NoArea { triangle } => write!(f, "triangle {triangle} has its corners on a line"),
            Self::DuplicateTriangle { triangle, first, is_opposite: false } => {
                write!(f, "triangle {triangle} repeats triangle {first}")
            }
            Self::DuplicateTriangle { triangle, first, is_opposite: true } => {
                write!(f, "triangle {triangle} repeats triangle {first} facing the other way")
            }
            Self::NonManifoldEdge { vertices: [a, b], triangle_count } => {
                write!(f, "the edge between vertices {a} and {b} has {triangle_count} triangles")
            }
            Self::InconsistentEdge { vertices: [a, b], triangles: [s, t] } => {
                write!(f, "triangles {s} and {t} face opposite ways along the edge of vertices {a} and {b}")
            }
            Self::BowTie { vertex, piece_count } => {
                write!(f, "{piece_count} pieces of surface meet in vertex {vertex} alone")
            }
            Self::UnusedVertex { vertex } => write!(f, "vertex {vertex} is used by no triangle"),
            Self::NonFiniteAttribute { semantic, vertex, component, value } => {
                write!(f, "layer {semantic} has {value} as component {component} of vertex {vertex}")
            }
            Self::NonUnitVector { semantic, vertex, length } => {
                write!(
                    f,
                    "layer {semantic} has a vector of length {length:.4} at vertex {vertex}, expected 1"
                )
            }
            Self::WeightSum { vertex, sum } => {
                write!(f, "the joint weights of vertex {vertex} sum to {sum:.4}, expected 1")
            }
        }
    }
}
