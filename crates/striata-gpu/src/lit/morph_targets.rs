//! Displacements of morph targets, in a texture that the vertex stage reads.

use striata::mesh::{IndexedMesh, Semantic};

use crate::gpu::Gpu;
use crate::gpu_error::GpuError;
use crate::lit::data_texture::DataTexture;

/// Displacements of all vertices, target by target: positions, then normals and tangents if any target has
/// them.
#[derive(Debug)]
pub(crate) struct MorphTargets {
    pub texture: DataTexture,
    /// Targets that move anything, ascending.
    targets: Vec<u16>,
    /// Displacements per vertex and target, 1 to 3.
    pub channel_count: u32,
}

/// Layers of a target in the order of the channels.
const CHANNELS: [fn(u16) -> Semantic; 3] =
    [Semantic::MorphPosition, Semantic::MorphNormal, Semantic::MorphTangent];

impl MorphTargets {
    pub(crate) fn upload(gpu: &Gpu, mesh: &IndexedMesh) -> Result<Self, GpuError> {
        let target_and_channel = |semantic: &Semantic| match *semantic {
            Semantic::MorphPosition(target) => Some((target, 1)),
            Semantic::MorphNormal(target) => Some((target, 2)),
            Semantic::MorphTangent(target) => Some((target, 3)),
            _ => None,
        };
        let layers = || mesh.layers.iter().filter_map(|layer| target_and_channel(&layer.semantic));
        let channel_count = layers().map(|(_, channel)| channel).max().unwrap_or(1);
        let mut targets: Vec<u16> = layers().map(|(target, _)| target).collect();
        targets.sort_unstable();
        targets.dedup();
        let per_target = u64::from(channel_count) * mesh.vertex_count() as u64;
        let texture = DataTexture::new(gpu, "morph targets", per_target * targets.len() as u64)?;
        let mut texels = Vec::with_capacity(per_target as usize * targets.len());
        for &target in &targets {
            for semantic in &CHANNELS[..channel_count as usize] {
                let layer = mesh.layer(&semantic(target)).filter(|layer| layer.component_count >= 3);
                texels.extend((0..mesh.vertex_count()).map(|vertex| {
                    layer.map_or([0.0; 4], |layer| {
                        [layer.get(vertex, 0), layer.get(vertex, 1), layer.get(vertex, 2), 0.0]
                    })
                }));
            }
        }
        texture.write(gpu, &texels);
        Ok(Self { texture, targets, channel_count })
    }

    /// Returns the targets with a weight: their place in the texture, and the weight.
    pub(crate) fn active<'a>(&'a self, weights: &'a [f32]) -> impl Iterator<Item = [f32; 4]> + 'a {
        self.targets.iter().enumerate().filter_map(|(at, &target)| {
            let weight = weights.get(usize::from(target)).copied().filter(|&weight| weight != 0.0)?;
            Some([at as f32, weight, 0.0, 0.0])
        })
    }
}
