//! One uniform level.

use std::ops::Range;
use std::sync::Arc;

use super::tables::Tables;
use crate::mesh::{IndexedMesh, replay};
use crate::model::{FanForm, FanIndices, LodModel as _};
use crate::simplify::{StopReason, Target};
use crate::strip::{StripIndices, stripify};

/// One uniform level of a [`Lod`](super::Lod): triangles over the first few vertices of its mesh.
#[derive(Clone, Debug)]
pub struct Level {
    tables: Arc<Tables>,
    split_count: usize,
    stop_reason: StopReason,
    indices: FanIndices,
}

impl Level {
    pub(super) fn empty(tables: Arc<Tables>) -> Self {
        Self {
            tables,
            split_count: 0,
            stop_reason: StopReason::TargetReached,
            indices: FanIndices::default(),
        }
    }

    /// Goes to another level of the same mesh; memory is reused.
    pub fn move_to(&mut self, target: Target) {
        let fans = self.tables.fans();
        (self.split_count, self.stop_reason) = target.resolve(&self.tables.refinable().sequence);
        let mut state = fans.new_state();
        fans.move_to(&mut state, self.split_count);
        fans.emit_level_into(&state, FanForm::Triangles, &mut self.indices);
    }

    /// The triangles, three indices each, group after group.
    pub fn indices(&self) -> &[u32] {
        &self.indices.indices
    }

    /// The triangles, group after group.
    pub fn triangles(&self) -> &[[u32; 3]] {
        self.indices().as_chunks().0
    }

    /// Triangles of the level.
    pub fn triangle_count(&self) -> usize {
        self.indices().len() / 3
    }

    /// Vertices that the level uses: the first so many of the mesh.
    pub fn vertex_count(&self) -> usize {
        self.tables.refinable().sequence.vertex_count_at(self.split_count)
    }

    /// Vertex splits between the base mesh and this level.
    pub fn split_count(&self) -> usize {
        self.split_count
    }

    /// Distance between the level and the full mesh, in mesh units: an estimate, or a bound if
    /// [`Lod::has_guaranteed_errors`](super::Lod::has_guaranteed_errors).
    pub fn error(&self) -> f32 {
        self.tables.refinable().sequence.error_at(self.split_count)
    }

    /// How near the level comes to the target.
    pub fn stop_reason(&self) -> StopReason {
        self.stop_reason
    }

    /// Which part of the indices belongs to each group of the mesh, which has one material. If the mesh has no groups, one
    /// range holds all indices.
    pub fn groups(&self) -> &[Range<u32>] {
        &self.indices.group_ranges
    }

    /// The level as triangle strips with restart indices, made anew by the quick stripifier; each group is drawn by itself.
    ///
    /// Cost: linear in the triangles of the level. Models that keep strips from level to level are
    /// [`LodStrips`](crate::model::LodStrips) and [`Mts`](crate::model::Mts).
    pub fn strips(&self) -> StripIndices {
        let level = replay(self.tables.refinable(), self.split_count);
        stripify(&level).expect("a level of a mesh that was checked").to_restart_indices()
    }

    /// The level as a mesh of its own, for export: only the vertices that its triangles use, with all their attributes.
    pub fn to_mesh(&self) -> IndexedMesh {
        replay(self.tables.refinable(), self.split_count).without_unused_vertices()
    }
}
