//! Counts steps that turn a triangle over within a flat part of the surface.

use glam::DVec3;

use super::super::collapse::flat_fold::{TriangleNormal, folds_over};
use crate::mesh::FragmentedMesh;

/// Number of steps after which a triangle lies folded over its neighbors in a flat part of the surface.
///
/// A step counts if all triangles that it replaces lie in one plane and face the same way, and one that it leaves faces
/// the other way; triangles below the noise of single precision have no orientation. Such a fold has no distance from
/// the surface, so no bound of an error shows it. Linear time.
pub fn flat_folds(mesh: &FragmentedMesh) -> usize {
    let FragmentedMesh { mesh, fragments } = mesh;
    let scale = mesh.diagonal().max(f64::MIN_POSITIVE).recip();
    let normal_of = |face: u32| {
        let positions = fragments.faces()[face as usize].corners.map(|v| mesh.positions[v as usize]);
        TriangleNormal::new(positions.map(|p| scale * DVec3::from(p.map(f64::from))))
    };
    let (mut before, mut after) = (Vec::new(), Vec::new());
    let folds = |step: &u32| {
        before.clear();
        before.extend(fragments.ceiling(*step).map(normal_of));
        after.clear();
        after.extend(fragments.floor(*step).iter().map(|&face| normal_of(face)));
        folds_over(&before, &after)
    };
    (0..fragments.step_count() as u32).filter(folds).count()
}
