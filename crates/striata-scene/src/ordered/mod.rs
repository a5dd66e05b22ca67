//! Levels as engines store them: one vertex buffer for each mesh, with a table of levels and an index range for each.
//!
//! The vertices of a mesh are in refinement order, so that a level uses the first ones, and each vertex has a target, a
//! vertex before it that it collapses to. A level of `n` vertices follows from the triangles of the full mesh alone:
//!
//! ```text
//! map[i] = i                 if i < n
//!          map[target[i]]    otherwise
//! ```
//!
//! Triangles of which two corners have become one vertex are left out. Index ranges are levels that were made in
//! advance, each with its triangles in cache order. [`LodScene::ordered`] makes both, and
//! [`LodScene::to_ordered_glb`] writes them into a glTF file that any viewer opens at full detail: see
//! `docs/STRIATA_order.md`.

mod write;

pub use striata::lod::IndexRange;
pub use write::{ORDER_EXTENSION, OrderedGlb};

use serde_json::{Value, json};
use striata::Lod;
use striata::mesh::{CollapseSequence, IndexedMesh, replay_into};
use striata::strip::cache_order;

use crate::lod_scene::LodScene;

/// A mesh with its vertices in refinement order, and tables of its levels.
#[derive(Clone, Debug, PartialEq)]
pub struct OrderedMesh {
    /// The full mesh: vertices in refinement order, and the triangles of each group in cache order.
    pub mesh: IndexedMesh,
    /// The vertex before it that each vertex collapses to; vertices of the coarsest level have themselves.
    pub targets: Vec<u32>,
    /// Levels of each group of the mesh, which is a triangle primitive of the document.
    pub primitives: Vec<OrderedPrimitive>,
}

/// Levels of a primitive, finest first; each has half of the triangles of the one before, counted over the mesh.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct OrderedPrimitive {
    /// The full primitive and its levels down to the coarsest one. The numbers of vertices and the errors are those of
    /// the mesh: the same for all of its primitives.
    pub levels: Vec<OrderedLevel>,
    /// Vertex indices of all ranges, three per triangle; empty without ranges.
    pub indices: Vec<u32>,
    /// Place of each of the first levels in the indices.
    pub ranges: Vec<IndexRange>,
}

/// Numbers of a level of a primitive.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OrderedLevel {
    /// Vertices that the level uses, from the start of the vertex buffer.
    pub vertex_count: usize,
    /// Triangles of the primitive at this level.
    pub triangle_count: usize,
    /// Largest distance of the full mesh from the level, in mesh units.
    pub error: f32,
}

impl LodScene {
    /// Returns each mesh of the document with its vertices in refinement order and a table of its levels, of which the
    /// first `range_count` are also index ranges; [`None`] for meshes without triangles.
    ///
    /// The triangles of each range are in cache order, except those of blended primitives, which keep their order because
    /// it is the order in which they are drawn over each other. Cost: linear in the number of triangles.
    pub fn ordered(&self, range_count: usize) -> Vec<Option<OrderedMesh>> {
        let meshes = self.full_scene().meshes_in_cache_order();
        let made = |(index, (mesh, lod)): (usize, (Option<IndexedMesh>, &Option<Lod>))| {
            let sequence = lod.as_ref()?.sequence();
            let (mesh, splits) = (mesh?, sequence.halving_split_counts());
            let are_blended = self.scene().are_blended(index);
            let primitives =
                mesh.groups_or_whole().into_iter().zip(are_blended).map(|(group, is_blended)| {
                    let triangles = mesh.triangles[group.range()].to_vec();
                    ordered_primitive(sequence, &splits, triangles, range_count, is_blended)
                });
            let primitives = primitives.collect();
            let targets = (0..mesh.vertex_count() as u32).map(|vertex| sequence.target(vertex)).collect();
            Some(OrderedMesh { mesh, targets, primitives })
        };
        meshes.into_iter().zip(self.lods()).enumerate().map(made).collect()
    }
}

/// Makes the levels of a primitive, each from the triangles of the one before, which keep their order.
fn ordered_primitive(
    sequence: &CollapseSequence,
    splits: &[usize],
    mut triangles: Vec<[u32; 3]>,
    range_count: usize,
    is_blended: bool,
) -> OrderedPrimitive {
    let mut made = OrderedPrimitive::default();
    for (number, &split_count) in splits.iter().enumerate() {
        if number > 0 {
            let mut coarser = Vec::new();
            replay_into(sequence, split_count, &triangles, &mut coarser);
            triangles = coarser;
        }
        let (vertex_count, error) = (sequence.vertex_count_at(split_count), sequence.error_at(split_count));
        made.levels.push(OrderedLevel { vertex_count, triangle_count: triangles.len(), error });
        if number >= range_count {
            continue;
        }
        let (first_index, index_count) = (made.indices.len(), 3 * triangles.len());
        made.ranges.push(IndexRange { first_index, index_count, vertex_count, error });
        if number == 0 || is_blended {
            made.indices.extend(triangles.iter().flatten());
        } else {
            made.indices.extend(cache_order(&triangles).iter().flat_map(|&t| triangles[t as usize]));
        }
    }
    made
}

impl OrderedPrimitive {
    /// Returns the tables as the extension has them: `levels` with rows of vertices, triangles and error, and `ranges`,
    /// if there are any, with rows of first index, index count, vertices and error.
    pub fn to_json(&self) -> Value {
        let level =
            |level: &OrderedLevel| json!([level.vertex_count, level.triangle_count, shortest(level.error)]);
        let range = |range: &IndexRange| {
            json!([range.first_index, range.index_count, range.vertex_count, shortest(range.error)])
        };
        let mut value = json!({ "levels": self.levels.iter().map(level).collect::<Vec<_>>() });
        if !self.ranges.is_empty() {
            value["ranges"] = self.ranges.iter().map(range).collect();
        }
        value
    }
}

/// Returns the number with the fewest digits that is read as this one in single precision.
pub(crate) fn shortest(number: f32) -> f64 {
    number.to_string().parse().unwrap_or_else(|_| f64::from(number))
}
