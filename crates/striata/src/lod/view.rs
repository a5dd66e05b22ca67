//! One instance that follows a camera.

use std::ops::Range;
use std::sync::Arc;

use super::tables::Tables;
use crate::model::{FanForm, FanFront, FanIndices, FanUpdate};
use crate::view::{Camera, ScreenError};

/// One instance of a [`Lod`](super::Lod): from frame to frame it shows what its camera needs, fine where an error would be seen
/// and coarse elsewhere.
///
/// Memory: one bit for each step, and about 12 bytes for each vertex that it shows, besides the indices. Engines that want
/// an instance to be the bits alone use [`FanInstance`](crate::model::FanInstance).
#[derive(Clone, Debug)]
pub struct View {
    tables: Arc<Tables>,
    front: FanFront<ScreenError>,
    indices: FanIndices,
}

impl View {
    pub(super) fn new(tables: Arc<Tables>) -> Self {
        let front = FanFront::new(&tables.scene());
        let mut view = Self { tables, front, indices: FanIndices::default() };
        view.emit();
        view
    }

    /// Refines what the camera sees until no error takes more than so many pixels of its screen, and coarsens the rest.
    ///
    /// What the errors are is said at [`Lod::has_guaranteed_errors`](super::Lod::has_guaranteed_errors). Cost: proportional to what
    /// changes since the last update, and to the triangles that are shown.
    pub fn update(&mut self, camera: &Camera, pixels: f32) -> FanUpdate {
        self.update_by(ScreenError::new(*camera, pixels))
    }

    /// Does as [`update`](Self::update), but by a screen error with more terms: silhouettes, a region of interest, a gaze.
    pub fn update_by(&mut self, error: ScreenError) -> FanUpdate {
        let error = error.of_model(self.tables.sphere());
        let update = self.front.update(&self.tables.scene(), &error, usize::MAX);
        self.emit_changes(&update);
        update
    }

    /// Shows what looks best to the camera with at most so many triangles; no error is made smaller than `pixels`.
    ///
    /// If even the base mesh has more triangles, that is shown.
    pub fn update_to_budget(&mut self, camera: &Camera, pixels: f32, triangle_limit: usize) -> FanUpdate {
        let error = ScreenError::new(*camera, pixels).of_model(self.tables.sphere());
        let update = self.front.update_to_budget(&self.tables.scene(), &error, triangle_limit);
        self.emit_changes(&update);
        update
    }

    /// The triangles, three indices each over the vertices of [`Lod::mesh`](super::Lod::mesh), group after group.
    pub fn indices(&self) -> &[u32] {
        &self.indices.indices
    }

    /// The triangles, group after group.
    pub fn triangles(&self) -> &[[u32; 3]] {
        self.indices().as_chunks().0
    }

    /// Triangles that are shown.
    pub fn triangle_count(&self) -> usize {
        self.front.triangle_count()
    }

    /// Which part of the indices belongs to each group of the mesh; one range if the mesh has no groups.
    pub fn groups(&self) -> &[Range<u32>] {
        &self.indices.group_ranges
    }

    fn emit_changes(&mut self, update: &FanUpdate) {
        if update.split_count + update.collapse_count > 0 {
            self.emit();
        }
    }

    fn emit(&mut self) {
        self.front.instance().emit_into(self.tables.fans(), FanForm::Triangles, &mut self.indices);
    }
}
