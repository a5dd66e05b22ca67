//! The kinds of defects that a mesh can have, each with its location and a one-line description.

use std::fmt;

use super::{MeshError, Semantic};

/// A defect of a mesh, with its location.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Defect {
    /// The mesh is inconsistent: indices, lengths, groups or coordinates.
    Inconsistent(MeshError),
    /// A layer has the wrong number of components for its meaning.
    LayerShape {
        /// Meaning of the layer.
        semantic: Semantic,
        /// Number of components it has.
        found: u8,
        /// Number of components it should have, in words.
        expected: &'static str,
    },
    /// Two layers have the same meaning.
    RepeatedLayer {
        /// Meaning of the layers.
        semantic: Semantic,
    },
    /// Two corners of a triangle are the same vertex.
    RepeatedVertex {
        /// Index of the triangle.
        triangle: usize,
        /// The repeated vertex.
        vertex: u32,
    },
    /// Two vertices of a triangle have the same position.
    RepeatedPosition {
        /// Index of the triangle.
        triangle: usize,
        /// The two vertices.
        vertices: [u32; 2],
    },
    /// The corners of a triangle are distinct but collinear.
    NoArea {
        /// Index of the triangle.
        triangle: usize,
    },
    /// A triangle has the same three positions as an earlier one.
    DuplicateTriangle {
        /// Index of the triangle.
        triangle: usize,
        /// First triangle with these positions.
        first: usize,
        /// Whether the two triangles face opposite ways.
        is_opposite: bool,
    },
    /// More than two triangles share an edge.
    NonManifoldEdge {
        /// One vertex at each end of the edge.
        vertices: [u32; 2],
        /// Number of triangles on the edge.
        triangle_count: usize,
    },
    /// Two triangles that share an edge face opposite ways.
    InconsistentEdge {
        /// One vertex at each end of the edge.
        vertices: [u32; 2],
        /// The two triangles.
        triangles: [usize; 2],
    },
    /// Several pieces of surface meet at a position without sharing an edge there.
    BowTie {
        /// A vertex at the position.
        vertex: u32,
        /// Number of pieces.
        piece_count: usize,
    },
    /// No triangle uses the vertex.
    UnusedVertex {
        /// Index of the vertex.
        vertex: usize,
    },
    /// A value of a layer is NaN or infinite.
    NonFiniteAttribute {
        /// Meaning of the layer.
        semantic: Semantic,
        /// Index of the vertex.
        vertex: usize,
        /// Index of the component.
        component: usize,
        /// The value found.
        value: f32,
    },
    /// The length of a normal or tangent differs from 1 by more than 0.01.
    NonUnitVector {
        /// Meaning of the layer.
        semantic: Semantic,
        /// Index of the vertex.
        vertex: usize,
        /// The length found.
        length: f64,
    },
    /// The joint weights of a vertex, summed over all sets, differ from 1 by more than 0.01.
    WeightSum {
        /// Index of the vertex.
        vertex: usize,
        /// The sum found.
        sum: f64,
    },
}

/// Kind of a [`Defect`], in the order in which reports list them.
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
    /// Description of the kind, in words that can follow a count.
    pub fn as_str(self) -> &'static str {
        match self {
            Self::Inconsistent => "inconsistencies",
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
    /// The kind of the defect, without its location.
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
                write!(f, "layer {semantic} has {found} components per vertex, but needs {expected}")
            }
            Self::RepeatedLayer { semantic } => write!(f, "layer {semantic} appears twice"),
            Self::RepeatedVertex { triangle, vertex } => {
                write!(f, "triangle {triangle} uses vertex {vertex} twice")
            }
            Self::RepeatedPosition { triangle, vertices: [a, b] } => {
                write!(f, "triangle {triangle} uses vertices {a} and {b}, which have the same position")
            }
            Self::NoArea { triangle } => write!(f, "triangle {triangle} has collinear corners"),
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
                write!(f, "{piece_count} pieces of surface meet only in vertex {vertex}")
            }
            Self::UnusedVertex { vertex } => write!(f, "vertex {vertex} is not used by any triangle"),
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
