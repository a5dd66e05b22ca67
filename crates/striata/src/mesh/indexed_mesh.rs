//! The indexed triangle mesh that every stage takes and gives.

use std::ops::Range;

use super::{Appearance, AttributeLayer, Semantic};

/// A run of triangles that share a material.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct TriangleGroup {
    /// The group's own name (an OBJ group, a glTF mesh); may be empty.
    pub name: String,
    /// Index into [`Appearance::materials`], if the triangles have one.
    pub material: Option<u32>,
    /// First triangle of the run.
    pub first: u32,
    /// Triangles in the run.
    pub count: u32,
}

impl TriangleGroup {
    /// The triangles of the group, as a range of indices.
    pub fn range(&self) -> Range<usize> {
        self.first as usize..self.first as usize + self.count as usize
    }
}

/// Axis-aligned bounds of positions.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounds {
    /// Smallest coordinates, mesh units.
    pub min: [f32; 3],
    /// Largest coordinates, mesh units.
    pub max: [f32; 3],
}

impl Bounds {
    /// Bounds of the finite positions; `None` where there is none.
    pub fn of(positions: &[[f32; 3]]) -> Option<Self> {
        let mut finite = positions.iter().filter(|p| p.iter().all(|x| x.is_finite()));
        let first = *finite.next()?;
        let mut bounds = Self { min: first, max: first };
        for p in finite {
            for (axis, &x) in p.iter().enumerate() {
                bounds.min[axis] = bounds.min[axis].min(x);
                bounds.max[axis] = bounds.max[axis].max(x);
            }
        }
        Some(bounds)
    }

    /// Length of the diagonal, mesh units.
    pub fn diagonal(&self) -> f64 {
        (0..3).map(|a| f64::from(self.max[a]) - f64::from(self.min[a])).map(|d| d * d).sum::<f64>().sqrt()
    }
}

/// What makes a mesh unusable as it stands; each names the place.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum MeshError {
    /// A triangle names a vertex that is not there.
    #[error("triangle {triangle} uses vertex {vertex}, but there are {vertex_count} vertices")]
    IndexOutOfRange {
        /// The triangle.
        triangle: usize,
        /// The vertex it names.
        vertex: u32,
        /// Vertices that exist.
        vertex_count: usize,
    },
    /// A coordinate is NaN or infinite.
    #[error("vertex {vertex} has the coordinate {value} on axis {axis}")]
    NonFinitePosition {
        /// The vertex.
        vertex: usize,
        /// 0, 1 or 2.
        axis: usize,
        /// What stands there.
        value: f32,
    },
    /// A layer's length does not fit the vertices.
    #[error("layer {semantic} holds {found} numbers, but {vertex_count} vertices need {expected}")]
    LayerLength {
        /// The layer.
        semantic: Semantic,
        /// Numbers found.
        found: usize,
        /// Numbers needed.
        expected: usize,
        /// Vertices of the mesh.
        vertex_count: usize,
    },
    /// Groups do not tile the triangles in order.
    #[error(
        "group {group} covers triangles {first}..{end}, but {expected_first} was next of {triangle_count}"
    )]
    GroupRange {
        /// The group.
        group: usize,
        /// Its first triangle.
        first: u64,
        /// One past its last triangle.
        end: u64,
        /// Where it should begin.
        expected_first: u64,
        /// Triangles of the mesh.
        triangle_count: usize,
    },
    /// A group names a material that is not there.
    #[error("group {group} uses material {material}, but there are {material_count}")]
    MaterialOutOfRange {
        /// The group.
        group: usize,
        /// The material it names.
        material: u32,
        /// Materials that exist.
        material_count: usize,
    },
    /// More vertices or triangles than 32-bit indices can name.
    #[error("{what} number {count}, but at most {limit} can be handled")]
    TooLarge {
        /// `vertices` or `triangles`.
        what: &'static str,
        /// How many there are.
        count: usize,
        /// How many can be.
        limit: usize,
    },
}

/// Triangles over vertices; a vertex is a position with one value of every layer.
///
/// Fields are public: files fill them, GPUs and scripts read them. [`IndexedMesh::check`] says
/// whether they fit together; every operation of this crate checks before it trusts.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct IndexedMesh {
    /// One position a vertex, mesh units.
    pub positions: Vec<[f32; 3]>,
    /// Three vertex indices a triangle, counter-clockwise seen from outside.
    pub triangles: Vec<[u32; 3]>,
    /// Attribute layers, each as long as `positions`.
    pub layers: Vec<AttributeLayer>,
    /// Consecutive runs that cover all triangles in order; empty means one unnamed group.
    pub groups: Vec<TriangleGroup>,
    /// Materials and images that groups refer to.
    pub appearance: Appearance,
}

/// Most vertices or triangles that a mesh may have: three corners and a link for each triangle can then be counted in 32 bits, and the
/// largest index, which means primitive restart, is that of no vertex.
pub(crate) const MAX_COUNT: usize = u32::MAX as usize / 4;

impl IndexedMesh {
    /// A mesh of positions and triangles alone.
    pub fn new(positions: Vec<[f32; 3]>, triangles: Vec<[u32; 3]>) -> Self {
        Self { positions, triangles, ..Self::default() }
    }

    /// Vertices, used or not.
    pub fn vertex_count(&self) -> usize {
        self.positions.len()
    }

    /// Triangles.
    pub fn triangle_count(&self) -> usize {
        self.triangles.len()
    }

    /// The layer with this meaning, if there is one.
    pub fn layer(&self, semantic: &Semantic) -> Option<&AttributeLayer> {
        self.layers.iter().find(|layer| layer.semantic == *semantic)
    }

    /// Bounds of the positions; `None` for a mesh without finite positions.
    pub fn bounds(&self) -> Option<Bounds> {
        Bounds::of(&self.positions)
    }

    /// Length of the bounds' diagonal, mesh units; 0 for an empty mesh.
    pub fn diagonal(&self) -> f64 {
        self.bounds().map_or(0.0, |b| b.diagonal())
    }

    /// The groups, with the one implied group spelled out where the list is empty.
    pub fn groups_or_whole(&self) -> Vec<TriangleGroup> {
        if self.groups.is_empty() {
            vec![TriangleGroup { count: self.triangles.len() as u32, ..TriangleGroup::default() }]
        } else {
            self.groups.clone()
        }
    }

    /// Checks that all parts fit together: indices, lengths, groups, finite positions.
    ///
    /// # Errors
    /// The first misfit, with its place.
    pub fn check(&self) -> Result<(), MeshError> {
        self.check_sizes()?;
        let vertex_count = self.positions.len();
        for (triangle, corners) in self.triangles.iter().enumerate() {
            for &vertex in corners {
                if vertex as usize >= vertex_count {
                    return Err(MeshError::IndexOutOfRange { triangle, vertex, vertex_count });
                }
            }
        }
        for (vertex, p) in self.positions.iter().enumerate() {
            for (axis, &value) in p.iter().enumerate() {
                if !value.is_finite() {
                    return Err(MeshError::NonFinitePosition { vertex, axis, value });
                }
            }
        }
        self.check_groups()
    }

    pub(super) fn check_sizes(&self) -> Result<(), MeshError> {
        for (what, count) in [("vertices", self.positions.len()), ("triangles", self.triangles.len())] {
            if count > MAX_COUNT {
                return Err(MeshError::TooLarge { what, count, limit: MAX_COUNT });
            }
        }
        let vertex_count = self.positions.len();
        for layer in &self.layers {
            let expected = vertex_count * layer.component_count as usize;
            if layer.data.len() != expected {
                let (semantic, found) = (layer.semantic.clone(), layer.data.len());
                return Err(MeshError::LayerLength { semantic, found, expected, vertex_count });
            }
        }
        Ok(())
    }

    pub(super) fn check_groups(&self) -> Result<(), MeshError> {
        let triangle_count = self.triangles.len();
        let mut expected_first = 0u64;
        for (group, g) in self.groups.iter().enumerate() {
            let (first, end) = (u64::from(g.first), u64::from(g.first) + u64::from(g.count));
            let is_last = group + 1 == self.groups.len();
            if first != expected_first
                || end > triangle_count as u64
                || (is_last && end != triangle_count as u64)
            {
                return Err(MeshError::GroupRange { group, first, end, expected_first, triangle_count });
            }
            let material_count = self.appearance.materials.len();
            if let Some(material) = g.material.filter(|&m| m as usize >= material_count) {
                return Err(MeshError::MaterialOutOfRange { group, material, material_count });
            }
            expected_first = end;
        }
        Ok(())
    }

    /// The mesh with its vertices picked and reordered: vertex `i` of the result is `order[i]` here.
    ///
    /// `new_index[v]` must say where old vertex `v` went; triangles are renamed by it.
    pub(crate) fn gather(&self, order: &[u32], new_index: &[u32]) -> Self {
        Self {
            positions: order.iter().map(|&v| self.positions[v as usize]).collect(),
            triangles: self.triangles.iter().map(|t| t.map(|v| new_index[v as usize])).collect(),
            layers: self.layers.iter().map(|layer| layer.gather(order)).collect(),
            groups: self.groups.clone(),
            appearance: self.appearance.clone(),
        }
    }

    /// The mesh without vertices that no triangle uses; kept vertices stay in order.
    pub fn without_unused_vertices(&self) -> Self {
        let mut new_index = vec![u32::MAX; self.positions.len()];
        for &v in self.triangles.iter().flatten() {
            new_index[v as usize] = 0;
        }
        let mut order = Vec::new();
        for (v, slot) in new_index.iter_mut().enumerate() {
            if *slot == 0 {
                *slot = order.len() as u32;
                order.push(v as u32);
            }
        }
        self.gather(&order, &new_index)
    }
}
