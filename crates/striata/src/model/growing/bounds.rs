//! Bounds of nodes: a sphere around the restored position, a cone of normals, and an error.

use crate::view::{NormalCone, Part, Sphere};

/// What a node's step changes, widened by what the steps below it change.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct NodeBounds {
    radius: f32,
    cone: NormalCone,
    error: f32,
}

impl NodeBounds {
    /// The bounds of the triangles that come or go with a step.
    pub(super) fn of_change(center: [f32; 3], triangles: &[[[f32; 3]; 3]], error: f32) -> Self {
        let corners = triangles.iter().flatten();
        let sphere = corners.fold(Sphere::point(center), |sphere, &corner| sphere.with_point(corner));
        let cone = NormalCone::of_triangles(triangles.iter().copied());
        Self { radius: sphere.radius, cone, error }
    }

    /// Widens the bounds so that they hold those of a descendant; returns whether that changed them.
    pub(super) fn widen(&mut self, center: [f32; 3], below: &Part) -> bool {
        let old = *self;
        self.radius = Sphere { center, radius: self.radius }.with_sphere(&below.sphere).radius;
        self.cone = self.cone.with_cone(&below.cone);
        self.error = self.error.max(below.error);
        *self != old
    }

    #[inline]
    pub(super) fn part(&self, center: [f32; 3]) -> Part {
        Part { sphere: Sphere { center, radius: self.radius }, cone: self.cone, error: self.error }
    }
}
