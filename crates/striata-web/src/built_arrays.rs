//! A simplified mesh as arrays, which the module that decodes streams shows.
//!
//! Vertices are in refinement order, and triangles in the order in which steps add them, so that every level
//! uses a prefix of both.

use striata::mesh::RefinableMesh;
use wasm_bindgen::prelude::wasm_bindgen;

use crate::Failure;
use crate::step_order::StepOrder;
use crate::vertices::Vertices;

/// The vertices, triangles and steps of a mesh that has been simplified.
#[wasm_bindgen]
#[derive(Debug)]
pub struct BuiltArrays {
    refinable: RefinableMesh,
    /// Group of each triangle.
    groups: Vec<u32>,
    added_counts: Vec<u8>,
}

#[wasm_bindgen]
impl BuiltArrays {
    /// Positions and layers of all vertices.
    pub fn vertices(&self) -> Vertices {
        let mesh = &self.refinable.mesh;
        Vertices::new(&mesh.positions, &mesh.layers, 0, mesh.appearance.color_space)
    }

    /// First vertex of each position, followed by the number of vertices.
    pub fn first_vertices(&self) -> Vec<u32> {
        self.refinable.sequence.positions().first_vertices().to_vec()
    }

    /// The vertex that each vertex beyond the base collapses to.
    pub fn targets(&self) -> Vec<u32> {
        self.refinable.sequence.targets().to_vec()
    }

    /// Error of the level at each split count below the step count, mesh units.
    pub fn errors(&self) -> Vec<f32> {
        self.refinable.sequence.errors().to_vec()
    }

    /// Number of triangles that each step adds.
    pub fn added_counts(&self) -> Vec<u8> {
        self.added_counts.clone()
    }

    /// Corners of the triangles.
    pub fn triangles(&self) -> Vec<u32> {
        self.refinable.mesh.triangles.as_flattened().to_vec()
    }

    /// Group of each triangle.
    pub fn groups(&self) -> Vec<u32> {
        self.groups.clone()
    }
}

impl BuiltArrays {
    /// Orders the triangles of a mesh by the step that adds them.
    ///
    /// # Errors
    /// If a step adds too many.
    pub(crate) fn new(mut refinable: RefinableMesh) -> Result<Self, Failure> {
        let order = StepOrder::of(&refinable);
        let order = order.ok_or_else(|| Failure::unsupported("more than 255 triangles share an edge"))?;
        let StepOrder { triangles, groups, added_counts } = order;
        refinable.mesh.triangles = triangles;
        Ok(Self { refinable, groups, added_counts })
    }
}
