//! Options of GLB files with streams.

use striata::Target;
use striata::simplify::BatchOptions;
use striata_stream::StreamOptions;

/// Share of the full scene's triangles in its coarse level, and limits of their number.
const COARSE_SHARE: usize = 50;
const COARSE_TRIANGLES: (usize, usize) = (512, 20_000);

/// Options of [`LodScene::to_glb_with_stream`](crate::LodScene::to_glb_with_stream).
#[derive(Clone, Debug, Default)]
#[non_exhaustive]
pub struct GlbStreamOptions {
    /// Level that the primitives hold, which viewers without the extension show; errors are in units of
    /// the scene. Default: 2 % of the triangles, but at least 512 and at most 20,000.
    pub coarse: Option<Target>,
    /// How the streams are encoded; a tolerance is in units of the scene, and bits refer to the box of each
    /// mesh. Default: [`StreamOptions::default`].
    pub stream: StreamOptions,
    /// How the meshes of the streams are simplified, with lengths in units of the scene. If `shape_step` is
    /// none, it follows from the grid of each mesh.
    pub batches: BatchOptions,
}

impl GlbStreamOptions {
    /// Sets [`GlbStreamOptions::coarse`].
    #[must_use]
    pub fn with_coarse(self, coarse: Target) -> Self {
        Self { coarse: Some(coarse), ..self }
    }

    /// Sets [`GlbStreamOptions::stream`].
    #[must_use]
    pub fn with_stream(self, stream: StreamOptions) -> Self {
        Self { stream, ..self }
    }

    /// Sets [`GlbStreamOptions::batches`].
    #[must_use]
    pub fn with_batches(self, batches: BatchOptions) -> Self {
        Self { batches, ..self }
    }

    /// Returns the level of the primitives, for a scene with this many triangles.
    pub(super) fn coarse_target(&self, triangle_count: usize) -> Target {
        let (least, most) = COARSE_TRIANGLES;
        self.coarse.unwrap_or(Target::Triangles((triangle_count / COARSE_SHARE).clamp(least, most)))
    }
}
