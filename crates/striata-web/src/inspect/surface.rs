//! Triangles of a level by strip or fan, and the figures of a page about them.

use wasm_bindgen::prelude::wasm_bindgen;

/// Triangles, each with the number of its strip, fan or fragment, or of itself.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct NumberedTriangles {
    pub triangles: Vec<[u32; 3]>,
    pub numbers: Vec<u32>,
}

impl NumberedTriangles {
    /// Gives all triangles that have no number yet this one.
    pub(super) fn number(&mut self, number: u32) {
        self.numbers.resize(self.triangles.len(), number);
    }

    /// Triangles, each with a number of its own.
    pub(super) fn of_list(triangles: Vec<[u32; 3]>) -> Self {
        let numbers = (0..triangles.len() as u32).collect();
        Self { triangles, numbers }
    }
}

/// A way from the level that was shown before, on which vertices move.
#[derive(Debug, Default)]
pub(super) struct Morph {
    /// Triangles of both levels.
    pub drawn: NumberedTriangles,
    /// Vertices that the first level lacks, then those that the second lacks.
    pub vertices: Vec<u32>,
    /// For each of them, the vertex in whose place it begins or ends.
    pub targets: Vec<u32>,
    pub appearing_count: usize,
}

/// A level as one model draws it.
#[wasm_bindgen]
#[derive(Debug, Default)]
pub struct InspectedLevel {
    pub(super) surface: NumberedTriangles,
    pub(super) morph: Option<Morph>,
    /// Number of strips, fans or fragments; 0 for a list.
    pub primitive_count: usize,
    /// Number of indices that are drawn, with restarts.
    pub index_count: usize,
    /// Number of indices that are written on the way from the level before.
    pub changed_count: usize,
    /// Number of refined steps.
    pub split_count: usize,
    /// Largest distance of the full mesh from the level, in its units.
    pub error: f32,
    /// Size of the model, bytes, without positions and attributes.
    pub model_bytes: usize,
    /// Size of one instance, bytes.
    pub instance_bytes: usize,
}

#[wasm_bindgen]
impl InspectedLevel {
    /// Corners of the triangles.
    pub fn indices(&self) -> Vec<u32> {
        self.surface.triangles.as_flattened().to_vec()
    }

    /// Number of the strip, fan or fragment of each triangle.
    pub fn numbers(&self) -> Vec<u32> {
        self.surface.numbers.clone()
    }

    /// Whether vertices move from the level before to this one.
    #[wasm_bindgen(getter)]
    pub fn has_morph(&self) -> bool {
        self.morph.is_some()
    }

    /// Corners of the triangles that are drawn while vertices move.
    pub fn morph_indices(&self) -> Vec<u32> {
        self.morph.as_ref().map_or_else(Vec::new, |morph| morph.drawn.triangles.as_flattened().to_vec())
    }

    /// Numbers of the triangles that are drawn while vertices move.
    pub fn morph_numbers(&self) -> Vec<u32> {
        self.morph.as_ref().map_or_else(Vec::new, |morph| morph.drawn.numbers.clone())
    }

    /// Vertices that move: those that appear first.
    pub fn moving(&self) -> Vec<u32> {
        self.morph.as_ref().map_or_else(Vec::new, |morph| morph.vertices.clone())
    }

    /// For each moving vertex, the one from which it comes or to which it goes.
    pub fn moving_targets(&self) -> Vec<u32> {
        self.morph.as_ref().map_or_else(Vec::new, |morph| morph.targets.clone())
    }

    /// Number of moving vertices that appear.
    #[wasm_bindgen(getter)]
    pub fn appearing_count(&self) -> usize {
        self.morph.as_ref().map_or(0, |morph| morph.appearing_count)
    }
}
