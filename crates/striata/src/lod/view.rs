//! One instance that follows a camera.

use std::ops::Range;
use std::sync::Arc;

use super::tables::LodTables;
use crate::model::{FanFront, FanTriangles, FanUpdate};
use crate::view::{Camera, ScreenError};

/// An instance of a [`Lod`](super::Lod) that follows a camera: refined where errors would be visible,
/// coarse elsewhere.
///
/// Memory: four bytes per vertex of the mesh (0.13 MB for the bunny), and the indices. Engines that need only one
/// bit per step can use [`FanInstance`](crate::model::FanInstance).
#[derive(Clone, Debug)]
pub struct View {
    tables: Arc<LodTables>,
    front: FanFront<ScreenError>,
    triangles: FanTriangles,
}

impl View {
    pub(super) fn new(tables: Arc<LodTables>) -> Self {
        let front = FanFront::new(&tables.scene());
        let triangles = FanTriangles::new(tables.fans(), front.instance());
        Self { tables, front, triangles }
    }

    /// Refines whatever the camera sees until no error covers more than `pixels` pixels of its screen, and
    /// coarsens the rest.
    ///
    /// Whether these errors are bounds or estimates depends on
    /// [`Lod::has_guaranteed_errors`](super::Lod::has_guaranteed_errors). Cost: proportional to the number
    /// of steps that change since the last update and to the number of triangles shown.
    pub fn update(&mut self, camera: &Camera, pixels: f32) -> FanUpdate {
        self.update_by(ScreenError::new(*camera, pixels))
    }

    /// Updates the view like [`update`](Self::update), but with a custom screen error, which can weight
    /// silhouettes, a region of interest or the gaze direction.
    pub fn update_by(&mut self, error: ScreenError) -> FanUpdate {
        let error = error.with_model_bounds(self.tables.sphere());
        let update = self.front.update(&self.tables.scene(), &error, usize::MAX);
        self.follow();
        update
    }

    /// Spends at most `triangle_limit` triangles on what looks best to the camera; parts whose error is
    /// already below `pixels` are not refined further.
    ///
    /// If even the base mesh exceeds the limit, the base mesh is shown.
    pub fn update_to_budget(&mut self, camera: &Camera, pixels: f32, triangle_limit: usize) -> FanUpdate {
        let error = ScreenError::new(*camera, pixels).with_model_bounds(self.tables.sphere());
        let update = self.front.update_to_budget(&self.tables.scene(), &error, triangle_limit);
        self.follow();
        update
    }

    /// Vertex indices into [`Lod::mesh`](super::Lod::mesh), three per triangle, sorted by group.
    pub fn indices(&self) -> &[u32] {
        self.triangles.indices()
    }

    /// Triangles shown, sorted by group.
    pub fn triangles(&self) -> &[[u32; 3]] {
        self.indices().as_chunks().0
    }

    /// Number of triangles shown.
    pub fn triangle_count(&self) -> usize {
        self.front.triangle_count()
    }

    /// Range of [`indices`](Self::indices) that belongs to each group of the mesh; a single range if the
    /// mesh has no groups.
    pub fn groups(&self) -> &[Range<u32>] {
        self.triangles.group_ranges()
    }

    fn follow(&mut self) {
        self.triangles.follow(self.tables.fans(), self.front.instance());
    }
}
