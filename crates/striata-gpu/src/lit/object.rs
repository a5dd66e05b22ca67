//! Content of a frame: objects in their poses, lights, and the camera.

use std::ops::Range;

use glam::DMat4;

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

/// A mesh at some level in a pose.
#[derive(Clone, Copy, Debug)]
pub struct LitObject<'a> {
    /// The vertices of all levels.
    pub vertices: &'a LitVertices,
    /// The indices of a level.
    pub indices: &'a GpuIndices,
    /// The parts of the level.
    pub parts: &'a [LitPart],
    /// Matrix from the mesh to the world; ignored if there are joints.
    pub world_from_mesh: DMat4,
    /// For each joint of the skin, the matrix from the mesh in its bind pose to the world; empty without a
    /// skin. Vertices that belong to no joint stay where they are in the mesh.
    pub joints: &'a [DMat4],
    /// Weights of the morph targets; missing ones are 0.
    pub morph_weights: &'a [f32],
}

impl<'a> LitObject<'a> {
    /// An object at the origin of the world, in its own pose.
    pub fn new(vertices: &'a LitVertices, indices: &'a GpuIndices, parts: &'a [LitPart]) -> Self {
        let world_from_mesh = DMat4::IDENTITY;
        Self { vertices, indices, parts, world_from_mesh, joints: &[], morph_weights: &[] }
    }
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
