//! Extracts the current level of an instance as a mesh.

use super::{FanInstance, FanSource, Fans};
use crate::mesh::{IndexedMesh, TriangleGroup, level_sources};

impl FanInstance {
    /// Returns the mesh that the instance shows, with its triangles sorted by group. It contains only
    /// vertices in use, in their original order. `source` is what the table was built from. With collapses, a
    /// triangle has the data of the triangle that it stems from; otherwise, of the nearest one.
    ///
    /// # Panics
    /// If the instance or the table belongs to a different mesh.
    pub fn level<'m>(&self, fans: &Fans, source: impl Into<FanSource<'m>>) -> IndexedMesh {
        let source = source.into();
        let full = source.mesh();
        let (mut indices, mut groups) = (Vec::new(), Vec::new());
        for (group, whole) in full.groups_or_whole().into_iter().enumerate() {
            let first = indices.len() as u32 / 3;
            self.group_indices_into(fans, group, &mut indices);
            groups.push(TriangleGroup { first, count: indices.len() as u32 / 3 - first, ..whole });
        }
        let mut order = indices.clone();
        order.sort_unstable();
        order.dedup();
        let mut new_index = vec![0; full.vertex_count()];
        (0..).zip(&order).for_each(|(new, &old)| new_index[old as usize] = new);
        let mut level = IndexedMesh {
            positions: order.iter().map(|&v| full.positions[v as usize]).collect(),
            origin: full.origin,
            exact_positions: full.gathered_exact_positions(&order),
            triangles: indices
                .as_chunks()
                .0
                .iter()
                .map(|t: &[u32; 3]| t.map(|v| new_index[v as usize]))
                .collect(),
            layers: full.layers.iter().map(|layer| layer.gather(&order)).collect(),
            groups: if full.groups.is_empty() { Vec::new() } else { groups },
            appearance: full.appearance.clone(),
            triangle_layers: Vec::new(),
        };
        match source {
            FanSource::Collapses(refinable) if !full.triangle_layers.is_empty() => {
                let shown = |v| new_index[self.vertex_shown_for(&refinable.sequence, v) as usize];
                let sources = level_sources(full, &level, shown);
                level.take_triangle_layers(full, &sources);
            }
            _ => level.take_nearest_triangle_layers(full),
        }
        level
    }
}
