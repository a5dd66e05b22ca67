//! Coordinates scaled to the size of the mesh, in which the simplification works.

use glam::DVec3;

use crate::mesh::{Extent, IndexedMesh};

/// A mesh whose bounds are this many times larger than its middle half has stray parts.
const STRAY: f64 = 1e4;

/// Number of vertices that the middle half is found from.
const SAMPLES: usize = 1 << 10;

/// Space with the center of the mesh's bounds as the origin and their diagonal as the unit.
///
/// A few triangles far from all others, as photogrammetry leaves them, must not take the digits of the rest:
/// squares of costs of a sphere in bounds that are 1e8 times larger vanish in single precision. Then center
/// and unit are those of the middle half of the vertices.
#[derive(Clone, Copy, Debug)]
pub(super) struct ScaledSpace {
    center: DVec3,
    /// The unit, in mesh units; 1 for a mesh without extent.
    pub scale: f64,
}

impl ScaledSpace {
    pub(super) fn of(mesh: &IndexedMesh) -> Self {
        let space = Self::of_bounds(mesh);
        let middle = Extent::of_positions(&mesh.positions, SAMPLES);
        if middle.size > 0.0 && space.scale > STRAY * middle.size {
            return Self { center: DVec3::from(middle.median), scale: middle.size };
        }
        space
    }

    /// A space with the center of the mesh's bounds, whose unit is `scale` mesh units.
    pub(super) fn with_scale(mesh: &IndexedMesh, scale: f64) -> Self {
        Self { scale, ..Self::of_bounds(mesh) }
    }

    fn of_bounds(mesh: &IndexedMesh) -> Self {
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
