//! The surface of a shot, and which point of a triangle a sample shows.

use glam::{DVec3, Vec3};
use striata::mesh::{AttributeLayer, IndexedMesh, Semantic};

use super::view::View;
use crate::shot::Shot;

/// The triangles of a shot with the attributes of its vertices.
pub(crate) struct Surface<'a> {
    pub mesh: &'a IndexedMesh,
    pub triangles: &'a [[u32; 3]],
    /// Positions in camera space.
    pub positions: Vec<Vec3>,
    /// [`None`] for flat shading.
    pub normals: Option<&'a AttributeLayer>,
}

impl<'a> Surface<'a> {
    pub(crate) fn new(shot: &'a Shot<'_>, view: &View) -> Self {
        let mesh = shot.vertices;
        let normals = mesh.layer(&Semantic::Normal).filter(|layer| layer.component_count >= 3);
        Self {
            mesh,
            triangles: &shot.triangles,
            positions: mesh.positions.iter().map(|&p| view.to_camera_space(p)).collect(),
            normals: normals.filter(|_| !shot.is_flat),
        }
    }

    /// Whether a triangle shows its front to the eye.
    pub(crate) fn is_front(&self, triangle: usize) -> bool {
        let [a, b, c] = self.corners(triangle);
        b.cross(c).dot(a) < 0.0
    }

    /// The corners of a triangle in camera space.
    pub(crate) fn corners(&self, triangle: usize) -> [DVec3; 3] {
        self.triangles[triangle].map(|v| self.positions[v as usize].as_dvec3())
    }

    /// Mean of an attribute of the corners; components that the layer lacks are 1.
    pub(crate) fn attribute<const N: usize>(
        &self,
        layer: &AttributeLayer,
        triangle: usize,
        shares: [f32; 3],
    ) -> [f32; N] {
        let corners = self.triangles[triangle];
        let width = usize::from(layer.component_count);
        std::array::from_fn(|k| {
            if k >= width {
                return 1.0;
            }
            (0..3).map(|i| shares[i] * layer.get(corners[i] as usize, k)).sum()
        })
    }

    /// The mean of the normals of the corners, if it has a direction.
    pub(crate) fn smooth_normal(&self, triangle: usize, shares: [f32; 3]) -> Option<Vec3> {
        Vec3::from(self.attribute::<3>(self.normals?, triangle, shares)).try_normalize()
    }
}

/// The sides of a triangle as planes through the eye: the product with a ray is 0 on the side, and the share of
/// the opposite corner up to a common factor elsewhere. This is exact in perspective, also for triangles that
/// reach behind the eye.
pub(crate) fn sides([a, b, c]: [DVec3; 3]) -> [DVec3; 3] {
    [b.cross(c), c.cross(a), a.cross(b)]
}

/// Shares of the corners where a ray meets a triangle with these sides.
pub(crate) fn shares(sides: &[DVec3; 3], ray: DVec3) -> [f32; 3] {
    let volumes = sides.map(|side| side.dot(ray));
    let total = volumes[0] + volumes[1] + volumes[2];
    let shares = volumes.map(|volume| (volume / total) as f32);
    if shares.iter().all(|share| share.is_finite()) { shares } else { [1.0, 0.0, 0.0] }
}

/// Normal of a triangle in camera space.
pub(crate) fn flat_normal([a, b, c]: [DVec3; 3]) -> DVec3 {
    (b - a).cross(c - a).normalize_or_zero()
}
