//! Places where the vertices of an instance can be, and the level that suits all of them.

use glam::{DMat3, DMat4};
use striata::Lod;
use striata::mesh::IndexedMesh;
use striata::view::{Criterion, NormalCone, Part, ScreenError, Sphere};

use crate::drawn::DrawnInstance;

/// A sphere in the scene that contains a mesh as a matrix shows it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct PlacedSphere {
    sphere: Sphere,
    /// Largest factor by which errors grow, or a little more.
    scale: f64,
    /// Factor by which errors count more.
    importance: f64,
}

impl PlacedSphere {
    /// Returns the places of an instance. A skinned vertex is between the places where its joints would move
    /// the whole mesh, so there is one for each joint.
    pub(crate) fn of(drawn: &DrawnInstance, sphere: &Sphere) -> Vec<Self> {
        let matrices: &[[f64; 16]] =
            if drawn.joints.is_empty() { std::slice::from_ref(&drawn.world) } else { &drawn.joints };
        let at = |matrix| {
            let matrix = DMat4::from_cols_array(matrix);
            Self::new(&matrix, largest_scale(&matrix), sphere)
        };
        matrices.iter().map(at).collect()
    }

    /// Places a mesh within `sphere` with a matrix that enlarges lengths by at most `scale`.
    pub(crate) fn new(matrix: &DMat4, scale: f64, sphere: &Sphere) -> Self {
        let center = matrix.transform_point3(sphere.center.map(f64::from).into());
        let radius = (f64::from(sphere.radius) * scale) as f32;
        Self { sphere: Sphere { center: center.as_vec3().into(), radius }, scale, importance: 1.0 }
    }

    /// Sets how much errors count.
    pub(crate) fn with_importance(self, importance: f64) -> Self {
        Self { importance, ..self }
    }

    fn allows(&self, length: f32, error: &ScreenError) -> bool {
        // With cone -1, the part may face any direction.
        let cone = NormalCone { axis: [0.0; 3], cos: -1.0 };
        let length = (f64::from(length) * self.scale * self.importance) as f32;
        error.weigh(&Part { sphere: self.sphere, cone, error: length }).weight <= 1.0
    }
}

/// Returns a sphere around the vertices of a mesh.
pub(crate) fn sphere_around(mesh: &IndexedMesh) -> Sphere {
    mesh.bounds().map_or(Sphere::point([0.0; 3]), |bounds| {
        let center = std::array::from_fn(|k| f32::midpoint(bounds.min[k], bounds.max[k]));
        Sphere { center, radius: (bounds.diagonal() / 2.0) as f32 }
    })
}

/// Returns the split count of the coarsest level whose error is allowed in all places.
pub(crate) fn split_count(lod: &Lod, places: &[PlacedSphere], error: &ScreenError) -> usize {
    let is_allowed = |length: f32| places.iter().all(|place| place.allows(length, error));
    // Errors fall as the split count grows.
    lod.sequence().errors().partition_point(|&length| !is_allowed(length)).min(lod.step_count())
}

/// Returns an upper bound of the factor by which a matrix enlarges lengths; exact for rotations with scales
/// along the axes.
fn largest_scale(matrix: &DMat4) -> f64 {
    let linear = DMat3::from_mat4(*matrix);
    let squares = linear.transpose() * linear;
    let rows = [squares.x_axis, squares.y_axis, squares.z_axis];
    // No eigenvalue exceeds the largest sum of a row.
    rows.map(|row| row.abs().element_sum()).into_iter().fold(0.0, f64::max).sqrt()
}
