//! Options of scene streams.

use striata::simplify::BatchOptions;
use striata_io::Scene;
use striata_stream::StreamOptions;

use super::precision::mesh_precisions;

/// Options of [`encode_scene`](super::encode_scene).
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct SceneStreamOptions {
    /// How meshes are encoded. Bits of the positions refer to the longest side of the scene's box, and a
    /// tolerance is in units of the scene; each mesh gets the precision that this requires. Metadata are
    /// those of the scene.
    pub stream: StreamOptions,
    /// How meshes are simplified, as by [`LodScene::build`](crate::LodScene::build): lengths of the sequence
    /// are in units of the scene, and poses count. `shape_step` is in units of each mesh; if it is none, it
    /// follows from the grid of each mesh.
    pub batches: BatchOptions,
    /// Longest side of the previews of color images, pixels; default 128. Those of other maps, such as
    /// normals, are half as long. With 0, images have no previews.
    pub preview_side: u32,
}

impl Default for SceneStreamOptions {
    fn default() -> Self {
        Self { stream: StreamOptions::default(), batches: BatchOptions::default(), preview_side: 128 }
    }
}

impl SceneStreamOptions {
    /// Returns how many positions of all meshes fall on those of others when they are rounded. Cost: sorts all positions.
    pub fn merged_position_count(&self, scene: &Scene) -> usize {
        let precisions = mesh_precisions(scene, &self.stream);
        let precise = scene.meshes().iter().zip(precisions).filter_map(|(mesh, own)| mesh.as_ref().zip(own));
        precise.map(|(mesh, own)| own.options.merged_position_count(mesh).unwrap_or(0)).sum()
    }

    /// Sets [`Self::stream`].
    pub fn with_stream(self, stream: StreamOptions) -> Self {
        Self { stream, ..self }
    }

    /// Sets [`Self::batches`].
    pub fn with_batches(self, batches: BatchOptions) -> Self {
        Self { batches, ..self }
    }

    /// Sets [`Self::preview_side`].
    pub fn with_preview_side(self, preview_side: u32) -> Self {
        Self { preview_side, ..self }
    }
}
