//! A uniform level as triangle strips that follow it.

use std::ops::Range;
use std::sync::Arc;

use super::tables::LodTables;
use crate::model::{LodModel as _, LodStrips, LodStripsState, ModelError, StripBuffer};
use crate::simplify::{StopReason, Target};

/// A uniform level of a [`Lod`](super::Lod) as triangle strips, for one instance that changes its level often.
///
/// The strips of [`Lod::strips`](super::Lod::strips) are edited in place, so a move costs about as much as what it
/// changes \[RCRG06\]. Memory: four bytes for each index of the strips of the full mesh, twice.
///
/// ```
/// use striata::mesh::shapes;
/// use striata::{Lod, LodOptions, Target};
///
/// let lod = Lod::build(&shapes::icosphere(4, 1.0), &LodOptions::default())?;
/// let mut level = lod.strip_level(Target::Triangles(500))?;
/// level.move_to(Target::Triangles(400));
/// for range in level.take_changed_ranges() {
///     let changed = &level.indices()[range.start as usize..range.end as usize];
///     // Write them to the same place of the index buffer.
///     # let _ = changed;
/// }
/// // Draw each of level.groups() of the index buffer as strips with primitive restart.
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct StripLevel {
    tables: Arc<LodTables>,
    state: LodStripsState,
    buffer: StripBuffer,
    stop_reason: StopReason,
}

impl StripLevel {
    /// Shows the full mesh.
    pub(super) fn full(tables: Arc<LodTables>) -> Result<Self, ModelError> {
        let model = tables.strips()?;
        let mut state = model.new_state();
        let buffer = StripBuffer::new(model, &mut state);
        Ok(Self { tables, state, buffer, stop_reason: StopReason::FullMesh })
    }

    fn model(&self) -> &LodStrips<'static> {
        self.tables.strips().expect("strips that were there when the level was made")
    }

    /// Moves to the most detailed level that does not exceed the target.
    pub fn move_to(&mut self, target: Target) {
        let model = self.tables.strips().expect("strips that were there when the level was made");
        let (split_count, stop_reason) = target.resolve(&self.tables.refinable().sequence);
        model.move_to(&mut self.state, split_count);
        self.buffer.sync(model, &mut self.state);
        self.stop_reason = stop_reason;
    }

    /// The index buffer, whose length never changes: strips with [`RESTART`](crate::strip::RESTART) between them.
    /// Draw the ranges of [`groups`](Self::groups).
    pub fn indices(&self) -> &[u32] {
        self.buffer.indices()
    }

    /// For each group of the mesh, the range of [`indices`](Self::indices) to draw; a single range if the mesh has no
    /// groups.
    pub fn groups(&self) -> impl Iterator<Item = Range<u32>> {
        self.buffer.group_ranges()
    }

    /// Returns the ranges of [`indices`](Self::indices) that changed since the last call, sorted and disjoint.
    pub fn take_changed_ranges(&mut self) -> Vec<Range<u32>> {
        self.buffer.take_changed_ranges()
    }

    /// Number of strips.
    pub fn strip_count(&self) -> usize {
        self.model().draw_counts(&self.state).strip_count
    }

    /// Number of indices that the strips and the restarts between them need, without room to grow.
    pub fn index_count(&self) -> usize {
        self.model().draw_counts(&self.state).index_count
    }

    /// Number of triangles.
    pub fn triangle_count(&self) -> usize {
        self.tables.refinable().sequence.triangle_count_at(self.split_count())
    }

    /// Number of vertices: indices refer to this many vertices from the start of the vertex buffer.
    pub fn vertex_count(&self) -> usize {
        self.tables.refinable().sequence.vertex_count_at(self.split_count())
    }

    /// Number of vertex splits between the base mesh and this level.
    pub fn split_count(&self) -> usize {
        self.state.split_count()
    }

    /// Largest distance of the full mesh from the level, as in [`Level::error`](super::Level::error).
    pub fn error(&self) -> f32 {
        self.tables.refinable().sequence.error_at(self.split_count())
    }

    /// Whether the level meets the target, and if not, why.
    pub fn stop_reason(&self) -> StopReason {
        self.stop_reason
    }
}
