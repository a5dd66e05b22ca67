//! A single uniform level of detail.

use std::ops::Range;
use std::sync::Arc;

use super::tables::LodTables;
use crate::mesh::{IndexedMesh, replay};
use crate::model::{FanForm, FanIndices, LodModel as _};
use crate::simplify::{StopReason, Target};
use crate::strip::{StripIndices, stripify};

/// Room behind the indices of a level, so that the triangles of its last vertex can be written like all others.
const SLACK: usize = 64;

/// A uniform level of detail of a [`Lod`](super::Lod): a triangle list over a prefix of its vertices.
#[derive(Clone, Debug)]
pub struct Level {
    tables: Arc<LodTables>,
    split_count: usize,
    stop_reason: StopReason,
    indices: FanIndices,
}

impl Level {
    pub(super) fn empty(tables: Arc<LodTables>) -> Self {
        Self {
            tables,
            split_count: 0,
            stop_reason: StopReason::TargetReached,
            indices: FanIndices::default(),
        }
    }

    pub(super) fn tables(&self) -> &Arc<LodTables> {
        &self.tables
    }

    /// Moves to another level of the same mesh, reusing memory.
    pub fn move_to(&mut self, target: Target) {
        let (fans, sequence) = (self.tables.fans(), &self.tables.refinable().sequence);
        (self.split_count, self.stop_reason) = target.resolve(sequence);
        let needed = 3 * sequence.triangle_count_at(self.split_count) + SLACK;
        if self.indices.indices.capacity() < needed {
            // Growing step by step would copy everything several times; the operating system clears memory on first use.
            self.indices.indices = vec![0; needed];
        }
        let mut state = fans.new_state();
        fans.move_to(&mut state, self.split_count);
        fans.emit_level_into(&state, FanForm::Triangles, &mut self.indices);
    }

    /// Vertex indices of the triangles, three per triangle, sorted by group.
    pub fn indices(&self) -> &[u32] {
        &self.indices.indices
    }

    /// Triangles of the level, sorted by group.
    pub fn triangles(&self) -> &[[u32; 3]] {
        self.indices().as_chunks().0
    }

    /// Number of triangles in the level.
    pub fn triangle_count(&self) -> usize {
        self.indices().len() / 3
    }

    /// Number of vertices in the level: its indices refer to this many vertices from the start of the
    /// vertex buffer.
    pub fn vertex_count(&self) -> usize {
        self.tables.refinable().sequence.vertex_count_at(self.split_count)
    }

    /// Number of vertex splits between the base mesh and this level.
    pub fn split_count(&self) -> usize {
        self.split_count
    }

    /// Largest distance of the full mesh from the level, in mesh units: a guaranteed bound for every point of
    /// the full mesh if
    /// [`Lod::has_guaranteed_errors`](super::Lod::has_guaranteed_errors) is true, otherwise an estimate.
    pub fn error(&self) -> f32 {
        self.tables.refinable().sequence.error_at(self.split_count)
    }

    /// Whether the level meets the target, and if not, why.
    pub fn stop_reason(&self) -> StopReason {
        self.stop_reason
    }

    /// Range of [`indices`](Self::indices) that belongs to each group of the mesh; each group has one
    /// material. A mesh without groups has a single range that covers all indices.
    pub fn groups(&self) -> &[Range<u32>] {
        &self.indices.group_ranges
    }

    /// Builds triangle strips with restart indices for the level; no strip crosses from one group into
    /// another.
    ///
    /// The fast stripifier builds them from scratch on every call. Cost: linear in the number of triangles
    /// of the level. To keep strips from level to level, use [`Lod::strip_level`](super::Lod::strip_level).
    pub fn strips(&self) -> StripIndices {
        let level = replay(self.tables.refinable(), self.split_count);
        stripify(&level).expect("a level of a mesh that was checked").to_restart_indices()
    }

    /// Copies the level into a separate mesh for export, with only the vertices that its triangles use and
    /// all of their attributes.
    pub fn to_mesh(&self) -> IndexedMesh {
        replay(self.tables.refinable(), self.split_count).without_unused_vertices()
    }
}
