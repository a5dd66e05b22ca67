//! The indexed triangle mesh that every stage of the library reads and returns.

use std::hash::{DefaultHasher, Hash, Hasher};
use std::ops::Range;

use super::{Appearance, AttributeLayer, Semantic, gather_layers};

/// A run of consecutive triangles that share a material.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct TriangleGroup {
    /// Name of the group (an OBJ group, a glTF mesh); may be empty.
    pub name: String,
    /// Index into [`Appearance::materials`], or `None` if the triangles have no material.
    pub material: Option<u32>,
    /// Index of the first triangle of the run.
    pub first: u32,
    /// Number of triangles in the run.
    pub count: u32,
}

impl TriangleGroup {
    /// Range of the group's triangle indices.
    pub fn range(&self) -> Range<usize> {
        self.first as usize..self.first as usize + self.count as usize
    }
}

/// Axis-aligned bounding box of positions.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounds {
    /// Smallest coordinates, in mesh units.
    pub min: [f32; 3],
    /// Largest coordinates, in mesh units.
    pub max: [f32; 3],
}

impl Bounds {
    /// Computes the bounds of all finite positions; `None` if there are none.
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

    /// Length of the diagonal, in mesh units.
    pub fn diagonal(&self) -> f64 {
        (0..3).map(|a| f64::from(self.max[a]) - f64::from(self.min[a])).map(|d| d * d).sum::<f64>().sqrt()
    }

    /// Whether the extent along z is less than .3 of the others, as that of a terrain is: pictures then take z as up
    /// unless the file says otherwise.
    pub fn lies_flat(&self) -> bool {
        let size = [0, 1, 2].map(|axis| self.max[axis] - self.min[axis]);
        size[2] < 0.3 * size[0].min(size[1])
    }
}

/// Why a mesh is unusable as it is.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum MeshError {
    /// A triangle refers to a vertex that does not exist.
    #[error("triangle {triangle} uses vertex {vertex}, but there are {vertex_count} vertices")]
    IndexOutOfRange {
        /// Index of the triangle.
        triangle: usize,
        /// The vertex index it contains.
        vertex: u32,
        /// Number of vertices in the mesh.
        vertex_count: usize,
    },
    /// A coordinate is NaN or infinite.
    #[error("vertex {vertex} has the coordinate {value} on axis {axis}")]
    NonFinitePosition {
        /// Index of the vertex.
        vertex: usize,
        /// Axis of the coordinate: 0, 1 or 2.
        axis: usize,
        /// The coordinate found.
        value: f32,
    },
    /// The length of a layer does not match the number of vertices.
    #[error("layer {semantic} has {found} values, but {vertex_count} vertices need {expected}")]
    LayerLength {
        /// Meaning of the layer.
        semantic: Semantic,
        /// Number of values found, over all vertices.
        found: usize,
        /// Number of values needed.
        expected: usize,
        /// Number of vertices in the mesh.
        vertex_count: usize,
    },
    /// The length of a layer of triangles does not match their number.
    #[error(
        "the layer {semantic} of triangles has {found} values, but {triangle_count} triangles need {expected}"
    )]
    TriangleLayerLength {
        /// Meaning of the layer.
        semantic: Semantic,
        /// Number of values found, over all triangles.
        found: usize,
        /// Number of values needed.
        expected: usize,
        /// Number of triangles in the mesh.
        triangle_count: usize,
    },
    /// The groups do not cover all triangles in order, without gaps or overlaps.
    #[error(
        "group {group} covers triangles {first}..{end}, but the groups must cover all {triangle_count} \
         triangles in order and this one must begin at {expected_first}"
    )]
    GroupRange {
        /// Index of the group.
        group: usize,
        /// Its first triangle.
        first: u64,
        /// One past its last triangle.
        end: u64,
        /// The triangle at which it should begin.
        expected_first: u64,
        /// Number of triangles in the mesh.
        triangle_count: usize,
    },
    /// A group refers to a material that does not exist.
    #[error("group {group} uses material {material}, but there are {material_count} materials")]
    MaterialOutOfRange {
        /// Index of the group.
        group: usize,
        /// The material index it contains.
        material: u32,
        /// Number of materials.
        material_count: usize,
    },
    /// The mesh has more vertices or triangles than 32-bit indices can address.
    #[error("the mesh has {count} {what}, but the limit is {limit}")]
    TooLarge {
        /// `vertices` or `triangles`.
        what: &'static str,
        /// Number of them in the mesh.
        count: usize,
        /// Largest number supported.
        limit: usize,
    },
}

/// A triangle mesh: triangles that index into vertices, with attribute layers, groups and materials.
///
/// The fields are public, so that importers can fill them and GPUs and scripts can read them.
/// [`IndexedMesh::check`] reports whether they are consistent; every operation of this crate calls it first.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct IndexedMesh {
    /// Position of each vertex relative to [`origin`](Self::origin), in mesh units.
    pub positions: Vec<[f32; 3]>,
    /// Origin of the positions in the coordinates of the file, in mesh units: zero, unless single precision
    /// would lose digits there, as in survey coordinates. See [`set_file_positions`](Self::set_file_positions).
    pub origin: [f64; 3],
    /// Coordinates of each vertex as its file gives them, for files with more digits than `positions` keep;
    /// otherwise empty. Operations that keep vertices keep these too; operations that move vertices clear
    /// them. They play no part in simplification.
    pub exact_positions: Vec<[f64; 3]>,
    /// Vertex indices of each triangle, counterclockwise when seen from outside.
    pub triangles: Vec<[u32; 3]>,
    /// Attribute layers, each with data for every vertex.
    pub layers: Vec<AttributeLayer>,
    /// Layers with data for every triangle (labels, colors, ids of faces), in the order of `triangles`. At
    /// every level a triangle has the data of the triangle of the full mesh that it stems from.
    pub triangle_layers: Vec<AttributeLayer>,
    /// Consecutive runs that cover all triangles in order; if empty, all triangles form one unnamed group.
    pub groups: Vec<TriangleGroup>,
    /// Materials and images that the groups refer to.
    pub appearance: Appearance,
}

/// Largest number of vertices or triangles in a mesh. Below this limit, three corners plus one link per
/// triangle still fit into 32 bits, and no vertex has the largest index, which means primitive restart.
pub(crate) const MAX_COUNT: usize = u32::MAX as usize / 4;

impl IndexedMesh {
    /// Creates a mesh without attributes, groups or materials.
    pub fn new(positions: Vec<[f32; 3]>, triangles: Vec<[u32; 3]>) -> Self {
        Self { positions, triangles, ..Self::default() }
    }

    /// Number of vertices, whether used or not.
    pub fn vertex_count(&self) -> usize {
        self.positions.len()
    }

    /// Number of triangles.
    pub fn triangle_count(&self) -> usize {
        self.triangles.len()
    }

    /// The first layer with this meaning, if there is one.
    pub fn layer(&self, semantic: &Semantic) -> Option<&AttributeLayer> {
        self.layers.iter().find(|layer| layer.semantic == *semantic)
    }

    /// Red, green, blue and opacity of each vertex in linear light, from the first set of colors; `None` if
    /// there is none. Layers of one or two components are gray.
    pub fn linear_colors(&self) -> Option<Vec<[f32; 4]>> {
        let layer = self.layer(&Semantic::Color(0)).filter(|layer| layer.component_count > 0)?;
        let width = usize::from(layer.component_count);
        let light = |v, k| self.appearance.color_space.light_of(layer.get(v, k));
        let color = |v| {
            let [r, g, b] = if width < 3 { [light(v, 0); 3] } else { [0, 1, 2].map(|k| light(v, k)) };
            [r, g, b, if width > 3 { layer.get(v, 3) } else { 1.0 }]
        };
        Some((0..self.vertex_count()).map(color).collect())
    }

    /// A number that equal meshes share, and others hardly ever do: of the positions and layers of the vertices,
    /// and of the triangles.
    pub fn fingerprints(&self) -> [u64; 2] {
        let mut vertices = DefaultHasher::new();
        vertices.write(bytemuck::cast_slice(&self.positions));
        for layer in &self.layers {
            layer.semantic.hash(&mut vertices);
            vertices.write(layer.data.as_bytes());
        }
        let mut triangles = DefaultHasher::new();
        triangles.write(bytemuck::cast_slice(&self.triangles));
        [vertices.finish(), triangles.finish()]
    }

    /// Bounds of all finite positions; `None` if there are none.
    pub fn bounds(&self) -> Option<Bounds> {
        Bounds::of(&self.positions)
    }

    /// Length of the diagonal of the bounds, in mesh units; 0 for an empty mesh.
    pub fn diagonal(&self) -> f64 {
        self.bounds().map_or(0.0, |b| b.diagonal())
    }

    /// The groups, or a single group of all triangles if the list is empty.
    pub fn groups_or_whole(&self) -> Vec<TriangleGroup> {
        if self.groups.is_empty() {
            vec![TriangleGroup { count: self.triangles.len() as u32, ..TriangleGroup::default() }]
        } else {
            self.groups.clone()
        }
    }

    /// Checks that the mesh is consistent: indices, layer lengths, groups, and finite positions.
    ///
    /// # Errors
    /// The first inconsistency found, as a [`MeshError`].
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
        if !self.exact_positions.is_empty() && self.exact_positions.len() != vertex_count {
            let (semantic, found) =
                (Semantic::Generic("exact position".to_owned()), self.exact_positions.len());
            return Err(MeshError::LayerLength { semantic, found, expected: vertex_count, vertex_count });
        }
        for layer in &self.layers {
            let expected = vertex_count * layer.component_count as usize;
            if layer.data.len() != expected {
                let (semantic, found) = (layer.semantic.clone(), layer.data.len());
                return Err(MeshError::LayerLength { semantic, found, expected, vertex_count });
            }
        }
        let triangle_count = self.triangles.len();
        for layer in &self.triangle_layers {
            let expected = triangle_count * layer.component_count as usize;
            if layer.data.len() != expected {
                let (semantic, found) = (layer.semantic.clone(), layer.data.len());
                return Err(MeshError::TriangleLayerLength { semantic, found, expected, triangle_count });
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

    /// Selects and reorders vertices: vertex `i` of the result is vertex `order[i]` of this mesh.
    ///
    /// `new_index[v]` must be the index of old vertex `v` in `order`; it is applied to the triangles.
    pub(crate) fn gather(&self, order: &[u32], new_index: &[u32]) -> Self {
        Self {
            positions: order.iter().map(|&v| self.positions[v as usize]).collect(),
            origin: self.origin,
            exact_positions: self.gathered_exact_positions(order),
            triangles: self.triangles.iter().map(|t| t.map(|v| new_index[v as usize])).collect(),
            layers: self.layers.iter().map(|layer| layer.gather(order)).collect(),
            triangle_layers: self.triangle_layers.clone(),
            groups: self.groups.clone(),
            appearance: self.appearance.clone(),
        }
    }

    /// A copy of the mesh without some vertices and the triangles that use them; the others keep their order,
    /// and groups may become empty. `is_left_out` has an entry for each vertex.
    pub fn without_vertices(&self, is_left_out: &[bool]) -> Self {
        let is_kept = |t: &[u32; 3]| t.iter().all(|&v| !is_left_out[v as usize]);
        let (mut order, mut new_index) = (Vec::new(), vec![u32::MAX; self.positions.len()]);
        for (vertex, _) in is_left_out.iter().enumerate().filter(|(_, is_left_out)| !**is_left_out) {
            new_index[vertex] = order.len() as u32;
            order.push(vertex as u32);
        }
        self.with_triangles(|t| is_kept(&self.triangles[t])).gather(&order, &new_index)
    }

    /// A copy of the mesh with some of its triangles and all vertices.
    pub(super) fn with_triangles(&self, is_kept: impl Fn(usize) -> bool) -> Self {
        let (mut groups, mut next) = (self.groups.clone(), 0);
        for group in &mut groups {
            group.count = group.range().filter(|&t| is_kept(t)).count() as u32;
            group.first = next;
            next += group.count;
        }
        let kept: Vec<u32> = (0..self.triangles.len() as u32).filter(|&t| is_kept(t as usize)).collect();
        Self { groups, ..self.with_triangle_order(&kept) }
    }

    /// A copy of the mesh whose triangle `i` is triangle `order[i]` of this mesh, with its data. Groups stay as they
    /// are: an order must move triangles within their groups only.
    pub fn with_triangle_order(&self, order: &[u32]) -> Self {
        let triangles = order.iter().map(|&t| self.triangles[t as usize]).collect();
        Self { triangles, triangle_layers: gather_layers(&self.triangle_layers, order), ..self.clone() }
    }

    /// A copy of the mesh whose vertices are in the order in which its triangles use them first, so that a GPU reads
    /// them one after another. Vertices that no triangle uses come last.
    pub fn with_vertices_by_first_use(&self) -> Self {
        let (mut order, mut new_index) = (Vec::new(), vec![u32::MAX; self.positions.len()]);
        let unused = 0..self.positions.len() as u32;
        for v in self.triangles.iter().flatten().copied().chain(unused) {
            let slot = &mut new_index[v as usize];
            if *slot == u32::MAX {
                *slot = order.len() as u32;
                order.push(v);
            }
        }
        self.gather(&order, &new_index)
    }

    /// A copy of the mesh without the vertices that no triangle uses; the other vertices keep their order.
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
