//! A simplified mesh as arrays, which the module that decodes streams shows.
//!
//! Vertices are in refinement order, and triangles in the order in which steps add them, so that every level
//! uses a prefix of both.

use striata::mesh::RefinableMesh;
use wasm_bindgen::prelude::wasm_bindgen;

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
    pub(crate) fn new(mut refinable: RefinableMesh) -> Self {
        let RefinableMesh { mesh, sequence } = &refinable;
        let mut group_of = vec![0; mesh.triangles.len()];
        for (number, group) in (0u32..).zip(&mesh.groups) {
            let range = group.first as usize..(group.first + group.count) as usize;
            if let Some(triangles) = group_of.get_mut(range) {
                triangles.fill(number);
            }
        }
        // Counting sort by split count: the base first.
        let steps: Vec<usize> =
            mesh.triangles.iter().map(|&corners| split_count_of(&refinable, corners)).collect();
        let mut counts = vec![0u32; sequence.step_count() + 1];
        steps.iter().for_each(|&step| counts[step] += 1);
        let added_counts = counts[1..].iter().map(|&count| count as u8).collect();
        let mut next = 0;
        let mut places: Vec<u32> = counts
            .iter()
            .map(|&count| {
                next += count;
                next - count
            })
            .collect();
        let mut triangles = vec![[0; 3]; mesh.triangles.len()];
        let mut groups = vec![0; triangles.len()];
        for (triangle, &step) in steps.iter().enumerate() {
            let place = places[step] as usize;
            places[step] += 1;
            triangles[place] = mesh.triangles[triangle];
            groups[place] = group_of[triangle];
        }
        refinable.mesh.triangles = triangles;
        Self { refinable, groups, added_counts }
    }
}

/// Split count of the coarsest level that contains a triangle: at coarser ones, two of its corners share a
/// position.
fn split_count_of(RefinableMesh { sequence, .. }: &RefinableMesh, corners: [u32; 3]) -> usize {
    let index = sequence.positions();
    let base_count = sequence.base_position_count() as u32;
    let mut corners = corners;
    loop {
        let positions = corners.map(|corner| index.position_of(corner));
        let last = (0..3).max_by_key(|&i| positions[i]).unwrap_or(0);
        if positions[last] < base_count {
            return 0;
        }
        let target = sequence.target(corners[last]);
        let position = index.position_of(target);
        if (0..3).any(|i| i != last && positions[i] == position) {
            return (positions[last] - base_count) as usize + 1;
        }
        corners[last] = target;
    }
}
