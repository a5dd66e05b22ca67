//! Content of a frame: objects, lights, and the camera.

use std::ops::Range;

use striata_scene::drawn::Light;

use crate::camera::Camera;
use crate::gpu::indices::GpuIndices;
use crate::gpu::lit::materials::LitMaterials;
use crate::gpu::lit::vertices::LitVertices;

/// Triangles that share a material.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct LitPart {
    /// Range of the indices, three per triangle.
    pub range: Range<u32>,
    /// Material; [`None`] is glTF's default material.
    pub material: Option<usize>,
}

/// A mesh at some level.
#[derive(Clone, Copy, Debug)]
pub struct LitObject<'a> {
    /// The vertices of all levels.
    pub vertices: &'a LitVertices,
    /// The indices of a level.
    pub indices: &'a GpuIndices,
    /// The parts of the level.
    pub parts: &'a [LitPart],
}

/// Everything that a frame shows.
#[derive(Clone, Copy, Debug)]
pub struct LitScene<'a> {
    /// The camera.
    pub camera: &'a Camera,
    /// Width and height of the picture, pixels.
    pub size: [u32; 2],
    /// Lights besides the environment.
    pub lights: &'a [Light],
    /// The materials.
    pub materials: &'a LitMaterials,
    /// The objects.
    pub objects: &'a [LitObject<'a>],
}
