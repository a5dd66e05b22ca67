//! Poses of objects as the shader reads them, relative to the eye.

use bytemuck::{Pod, Zeroable};
use glam::{DMat3, DMat4, DVec3};

use crate::lit::object::LitObject;

/// Uniform data of an object, laid out as in `pose.wgsl`.
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
#[repr(C)]
pub(crate) struct InstanceData {
    rows: [[f32; 4]; 3],
    poses: [u32; 4],
    mesh: [u32; 4],
}

pub(crate) const INSTANCE_BYTES: u64 = size_of::<InstanceData>() as u64;

/// An object seen from the eye.
pub(crate) struct PosedObject {
    pub data: InstanceData,
    /// Whether the pose mirrors the mesh.
    pub is_mirrored: bool,
    /// Center of the mesh relative to the eye.
    pub center: DVec3,
}

impl PosedObject {
    /// Poses an object, and appends its joints and morph weights to the texels of the frame.
    pub(crate) fn new(object: &LitObject<'_>, eye: DVec3, texels: &mut Vec<[f32; 4]>) -> Self {
        let origin = DVec3::from(object.vertices.origin.map(f64::from));
        let is_skinned = !object.joints.is_empty() && object.vertices.has_joints();
        let world_from_mesh = if is_skinned { DMat4::IDENTITY } else { object.world_from_mesh };
        let joints = if is_skinned { object.joints } else { &[] };
        let joint_start = texels.len() as u32;
        texels.extend(joints.iter().flat_map(|joint| rows(joint, origin, eye)));
        let weight_start = texels.len() as u32;
        texels.extend(object.vertices.morph_targets.active(object.morph_weights));
        let vertices = object.vertices;
        let mesh = [
            vertices.vertex_count() as u32,
            vertices.morph_targets.channel_count,
            u32::from(vertices.has_normals()),
            u32::from(vertices.has_tangents()),
        ];
        let poses = [joint_start, joints.len() as u32, weight_start, texels.len() as u32 - weight_start];
        let data = InstanceData { rows: rows(&world_from_mesh, origin, eye), poses, mesh };
        let mirrors = |matrix: &DMat4| DMat3::from_mat4(*matrix).determinant() < 0.0;
        let mirrored_count = joints.iter().filter(|joint| mirrors(joint)).count();
        let center = if joints.is_empty() {
            world_from_mesh.transform_point3(origin)
        } else {
            let sum: DVec3 = joints.iter().map(|joint| joint.transform_point3(origin)).sum();
            sum / joints.len() as f64
        };
        Self {
            data,
            is_mirrored: if joints.is_empty() {
                mirrors(&world_from_mesh)
            } else {
                2 * mirrored_count > joints.len()
            },
            center: center - eye,
        }
    }
}

/// Rows of the matrix from positions relative to `origin` to the world relative to the eye.
fn rows(matrix: &DMat4, origin: DVec3, eye: DVec3) -> [[f32; 4]; 3] {
    let offset = matrix.transform_point3(origin) - eye;
    std::array::from_fn(|row| {
        let axis = |column: usize| matrix.col(column)[row] as f32;
        [axis(0), axis(1), axis(2), offset[row] as f32]
    })
}
