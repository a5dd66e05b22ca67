//! Reference extraction of a level: every corner follows its collapse targets. The tests' oracle.
//!
//! Every model must show the same oriented triangles as [`replay`] at every split count. This code is
//! deliberately simple and slow, so that it is easy to see that it is right.

use super::{
    AttributeLayer, CollapseSequence, IndexedMesh, PositionIndex, RefinableMesh, SequenceParts,
    TriangleGroup, gather_layers,
};

/// Extracts the level of `refinable` after `split_count` vertex splits as a separate mesh.
///
/// Its vertices are a prefix of those of the full mesh; triangles keep their order and their groups.
/// Triangles that have become degenerate are left out.
///
/// # Panics
/// If `split_count` exceeds the step count.
pub fn replay(refinable: &RefinableMesh, split_count: usize) -> IndexedMesh {
    let vertex_count = refinable.sequence.vertex_count_at(split_count);
    let order: Vec<u32> = (0..vertex_count as u32).collect();
    let full = &refinable.mesh;
    let mut level = IndexedMesh {
        positions: full.positions[..vertex_count].to_vec(),
        origin: full.origin,
        exact_positions: full.exact_positions.iter().take(vertex_count).copied().collect(),
        triangles: Vec::new(),
        layers: full.layers.iter().map(|layer| layer.gather(&order)).collect(),
        triangle_layers: replay_triangle_layers(refinable, split_count),
        groups: Vec::new(),
        appearance: full.appearance.clone(),
    };
    if full.groups.is_empty() {
        replay_into(&refinable.sequence, split_count, &full.triangles, &mut level.triangles);
        return level;
    }
    for group in &full.groups {
        let first = level.triangles.len() as u32;
        replay_into(&refinable.sequence, split_count, &full.triangles[group.range()], &mut level.triangles);
        level.groups.push(TriangleGroup {
            first,
            count: level.triangles.len() as u32 - first,
            ..group.clone()
        });
    }
    level
}

impl RefinableMesh {
    /// The level at `split_count` as a full mesh of its own, with all coarser levels. Errors remain distances
    /// from the mesh that it was taken from, except that its own counts as 0.
    ///
    /// # Panics
    /// If `split_count` exceeds the step count.
    pub fn without_levels_above(&self, split_count: usize) -> Self {
        let sequence = &self.sequence;
        let position_count = sequence.base_position_count() + split_count;
        let first_vertices = sequence.positions().first_vertices()[..=position_count].to_vec();
        let above_base = sequence.vertex_count_at(split_count) - sequence.base_vertex_count();
        let level = replay(self, split_count);
        let parts = SequenceParts {
            positions: match first_vertices[position_count] as usize == position_count {
                true => PositionIndex::identity(position_count),
                false => PositionIndex::from_first(first_vertices),
            },
            base_position_count: sequence.base_position_count(),
            targets: sequence.targets()[..above_base].to_vec(),
            errors: sequence.errors()[..split_count].to_vec(),
            removed_triangle_counts: sequence.removed_triangle_counts()[..split_count].to_vec(),
            triangle_count: level.triangle_count(),
        };
        let sequence = CollapseSequence::from_parts(parts).expect("the first steps of a sequence are one");
        Self { mesh: level, sequence }
    }
}

/// Data of the triangles that remain at `split_count`, in the order of the full mesh.
fn replay_triangle_layers(refinable: &RefinableMesh, split_count: usize) -> Vec<AttributeLayer> {
    let full = &refinable.mesh;
    if full.triangle_layers.is_empty() {
        return Vec::new();
    }
    let substitute = |v| refinable.sequence.target_at(v, split_count);
    let remains = |t: &u32| {
        let [a, b, c] = full.triangles[*t as usize].map(substitute);
        a != b && b != c && c != a
    };
    let kept: Vec<u32> = (0..full.triangle_count() as u32).filter(remains).collect();
    gather_layers(&full.triangle_layers, &kept)
}

/// Extracts the level of the given triangles at `split_count`, appending those that remain to `out`.
///
/// # Panics
/// If `split_count` exceeds the step count.
pub fn replay_into(
    sequence: &CollapseSequence,
    split_count: usize,
    triangles: &[[u32; 3]],
    out: &mut Vec<[u32; 3]>,
) {
    let vertex_count = sequence.vertex_count_at(split_count) as u32;
    let substitute = |mut v: u32| {
        while v >= vertex_count {
            v = sequence.target(v);
        }
        v
    };
    out.extend(triangles.iter().map(|t| t.map(substitute)).filter(|&[a, b, c]| a != b && b != c && c != a));
}

/// Rotates a triangle so that its smallest index comes first; the winding stays the same.
pub(crate) fn canonical_triangle([a, b, c]: [u32; 3]) -> [u32; 3] {
    if a <= b && a <= c {
        [a, b, c]
    } else if b <= a && b <= c {
        [b, c, a]
    } else {
        [c, a, b]
    }
}

/// Rotates every triangle so that its smallest index comes first, then sorts them: equal results mean equal
/// multisets of oriented triangles.
pub fn canonical_triangles(triangles: &[[u32; 3]]) -> Vec<[u32; 3]> {
    let mut out: Vec<_> = triangles.iter().map(|&t| canonical_triangle(t)).collect();
    out.sort_unstable();
    out
}
