//! Content of a frame: objects, lights, and the camera.

use std::ops::Range;

use crate::indices::GpuIndices;
use crate::lit::light::LitLight;
use crate::lit::materials::LitMaterials;
use crate::lit::vertices::LitVertices;
use crate::viewpoint::Viewpoint;

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

/// Position and direction of a camera in the world.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LitCamera {
    /// Position of the eye.
    pub eye: [f64; 3],
    /// Point in the middle of the picture.
    pub look_at: [f64; 3],
    /// Direction that points up in the picture.
    pub up: [f64; 3],
    /// Vertical field of view, radians.
    pub fov: f64,
}

impl From<&Viewpoint> for LitCamera {
    fn from(view: &Viewpoint) -> Self {
        let [eye, look_at, up] = [view.eye, view.look_at, view.up].map(|point| point.map(f64::from));
        Self { eye, look_at, up, fov: f64::from(view.fov) }
    }
}

/// Everything that a frame shows.
#[derive(Clone, Copy, Debug)]
pub struct LitScene<'a> {
    /// The camera.
    pub camera: LitCamera,
    /// Width and height of the picture, pixels.
    pub size: [u32; 2],
    /// Lights besides the environment.
    pub lights: &'a [LitLight],
    /// The materials.
    pub materials: &'a LitMaterials,
    /// The objects.
    pub objects: &'a [LitObject<'a>],
}
