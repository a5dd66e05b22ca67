//! Takes over a mesh that another module has simplified.

use striata::mesh::LayerData;
use wasm_bindgen::prelude::wasm_bindgen;

use crate::layer_name::layer_of;
use crate::model::Model;
use crate::prefix_model::PrefixModel;
use crate::{Failure, limits};

/// Collects the arrays of a simplified mesh.
#[wasm_bindgen]
#[derive(Debug)]
pub struct PrefixParts(PrefixModel);

#[wasm_bindgen]
impl PrefixParts {
    /// Starts with positions, three numbers per vertex, and the steps: the first vertex of each position,
    /// what vertices collapse to, the triangles that each step adds, and the errors of the levels.
    ///
    /// # Errors
    /// If the arrays do not fit each other.
    #[wasm_bindgen(constructor)]
    pub fn new(
        positions: &[f32],
        first_vertices: Vec<u32>,
        targets: Vec<u32>,
        added_counts: Vec<u8>,
        errors: Vec<f32>,
    ) -> Result<Self, Failure> {
        let positions = positions.as_chunks().0.to_vec();
        limits::check_counts(positions.len(), 0)?;
        PrefixModel::new(positions, first_vertices, targets, added_counts, errors).map(Self)
    }

    /// Adds an attribute with floats; names are those of glTF.
    ///
    /// # Errors
    /// If the number of values does not fit the number of vertices.
    pub fn add_floats(&mut self, name: &str, component_count: u8, values: &[f32]) -> Result<(), Failure> {
        self.add(name, component_count, LayerData::F32(values.to_vec()))
    }

    /// Adds an attribute with 16-bit integers.
    ///
    /// # Errors
    /// As for [`add_floats`](Self::add_floats).
    pub fn add_shorts(&mut self, name: &str, component_count: u8, values: &[u16]) -> Result<(), Failure> {
        self.add(name, component_count, LayerData::U16(values.to_vec()))
    }

    /// Makes the model from these parts and the triangles: their corners and groups.
    ///
    /// # Errors
    /// If a corner is not a vertex, or the steps add another number of triangles.
    pub fn build(self, corners: &[u32], groups: Vec<u32>, group_count: usize) -> Result<Model, Failure> {
        let triangles = corners.as_chunks().0.to_vec();
        limits::check_counts(0, triangles.len())?;
        Ok(Model::of_prefixes(self.0.with_triangles(triangles, groups, group_count)?))
    }
}

impl PrefixParts {
    fn add(&mut self, name: &str, component_count: u8, data: LayerData) -> Result<(), Failure> {
        let layer = layer_of(name, component_count, data, self.0.positions.len())?;
        self.0.layers.push(layer);
        Ok(())
    }
}
