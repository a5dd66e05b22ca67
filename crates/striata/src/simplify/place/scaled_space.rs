//! Coordinates scaled to the unit diagonal, in which the simplification works.

use glam::DVec3;

use crate::mesh::IndexedMesh;

/// Space with the center of the mesh's bounds as the origin and their diagonal as the unit.
#[derive(Clone, Copy, Debug)]
pub(super) struct ScaledSpace {
    center: DVec3,
    pub(super) scale: f64,
}

impl ScaledSpace {
    pub(super) fn of(mesh: &IndexedMesh) -> Self {
        let Some(bounds) = mesh.bounds() else { return Self { center: DVec3::ZERO, scale: 1.0 } };
        let [min, max] = [bounds.min, bounds.max].map(|p| DVec3::from(p.map(f64::from)));
        let scale = if bounds.diagonal() > 0.0 { bounds.diagonal() } else { 1.0 };
        Self { center: 0.5 * (min + max), scale }
    }

    pub(super) fn scaled(&self, p: [f32; 3]) -> DVec3 {
        (DVec3::from(p.map(f64::from)) - self.center) / self.scale
    }

    pub(super) fn unscaled(&self, p: DVec3) -> [f32; 3] {
        let limit = f64::from(f32::MAX);
        (p * self.scale + self.center).to_array().map(|x| x.clamp(-limit, limit) as f32)
    }
}
