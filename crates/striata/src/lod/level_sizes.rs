//! Choosing a level without listing its triangles.

use super::Lod;
use crate::simplify::{StopReason, Target};
use crate::view::Camera;

/// Sizes and error of a uniform level, known without its triangles.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LevelSizes {
    /// Number of vertex splits between the base mesh and the level, for [`Target::SplitCount`].
    pub split_count: usize,
    /// Number of vertices, from the start of the vertex buffer.
    pub vertex_count: usize,
    /// Number of triangles.
    pub triangle_count: usize,
    /// Largest distance of the full mesh from the level, in mesh units.
    pub error: f32,
    /// Whether the level meets the target, and if not, why.
    pub stop_reason: StopReason,
}

impl Lod {
    /// Returns the sizes and the error of the level that [`level`](Self::level) would make of a target.
    ///
    /// Cost: at most a search in a table, so that a frame can choose a level and make it only if it is another one.
    pub fn resolve(&self, target: Target) -> LevelSizes {
        let sequence = self.sequence();
        let (split_count, stop_reason) = target.resolve(sequence);
        LevelSizes {
            split_count,
            vertex_count: sequence.vertex_count_at(split_count),
            triangle_count: sequence.triangle_count_at(split_count),
            error: sequence.error_at(split_count),
            stop_reason,
        }
    }

    /// Returns a target for the coarsest level whose error covers at most `pixels` pixels of a camera's screen, wherever
    /// the mesh is on it; for the base mesh, if the mesh is off the screen.
    ///
    /// The distance is that of the bounding sphere. If the camera is inside of it, the target is the full mesh: a
    /// [`view`](Self::view) needs fewer triangles there.
    pub fn target_for_view(&self, camera: &Camera, pixels: f32) -> Target {
        let sphere = self.tables.sphere();
        if !camera.may_see(&sphere) {
            return Target::SplitCount(0);
        }
        // Errors on the screen are proportional to those of the mesh.
        Target::Error(f64::from(pixels.max(0.0)) / f64::from(camera.error_px(1.0, &sphere)))
    }
}
