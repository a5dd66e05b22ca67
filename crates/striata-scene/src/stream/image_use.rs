//! How much of a picture each image decides.

use striata::mesh::{IndexedMesh, TriangleGroup};
use striata_io::Scene;

use super::json::triangle_primitives;
use crate::document::index;
use crate::textures::{TextureTransfer, images_of_material};

/// Returns for each image the area that it is seen on, in square units of the scene, weighted by the role of
/// the image.
pub(super) fn image_areas(scene: &Scene) -> Vec<f64> {
    let document = scene.document();
    let mut areas = vec![0.0; scene.images().len()];
    let mut mesh_scale = vec![0.0; scene.meshes().len()];
    for instance in scene.instances() {
        if instance.scale.is_finite() {
            mesh_scale[instance.mesh] += instance.scale * instance.scale;
        }
    }
    for (index_of_mesh, (mesh, scale)) in scene.meshes().iter().zip(mesh_scale).enumerate() {
        let Some(mesh) = mesh else { continue };
        for (group, primitive) in
            mesh.groups_or_whole().iter().zip(triangle_primitives(document, index_of_mesh))
        {
            let Some(material) = index(primitive, "material") else { continue };
            let area = scale * area_of(mesh, group);
            for (image, role) in images_of_material(document, material) {
                let weight = match role.transfer {
                    TextureTransfer::Srgb => 1.0,
                    TextureTransfer::Normal => 0.5,
                    TextureTransfer::Linear => 0.25,
                };
                if let Some(sum) = areas.get_mut(image) {
                    *sum += weight * area;
                }
            }
        }
    }
    areas
}

/// Area of a group of triangles, square mesh units.
fn area_of(mesh: &IndexedMesh, group: &TriangleGroup) -> f64 {
    let triangle = |triangle: &[u32; 3]| {
        let [a, b, c] = triangle.map(|vertex| glam::Vec3::from(mesh.positions[vertex as usize]).as_dvec3());
        (b - a).cross(c - a).length() * 0.5
    };
    mesh.triangles[group.range()].iter().map(triangle).sum()
}
