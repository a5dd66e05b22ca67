//! The stream of one mesh of a scene.

use striata_stream::{ChunkInfo, StreamInfo};

use super::head::MeshEntry;
use super::schedule::MeshCosts;

/// The stream of a mesh.
#[derive(Clone)]
pub(super) struct MeshStream {
    pub bytes: Vec<u8>,
    pub info: StreamInfo,
    /// Factor from mesh units to scene units, 0 if the mesh is not shown.
    pub scale: f64,
    /// Summed squared error that each chunk of its refinement takes away, mesh units to the fourth power.
    pub gains: Vec<f64>,
    /// Factor from that to units of the scene, for all instances together.
    pub weight: f64,
}

impl MeshStream {
    pub(super) fn entry(&self) -> MeshEntry {
        MeshEntry {
            bytes: self.bytes.len() as u64,
            vertex_count: self.info.vertex_count as u32,
            triangle_count: self.info.triangle_count as u32,
            step_count: self.info.step_count as u32,
            group_count: self.info.group_count as u32,
            error: self.info.error_max,
            scale: self.scale,
        }
    }

    /// Chunks after the one that contains the base.
    pub(super) fn refinement(&self) -> &[ChunkInfo] {
        self.info.chunks.get(1..).unwrap_or(&[])
    }

    /// Returns the bytes of each chunk of its refinement, and what it gains.
    pub(super) fn costs(&self) -> MeshCosts {
        MeshCosts {
            bytes: self.refinement().iter().map(|chunk| chunk.bytes).collect(),
            gains: self.gains.iter().map(|gain| gain * self.weight).collect(),
        }
    }
}
