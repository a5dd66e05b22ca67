//! Errors of levels in the poses of a mesh.
//!
//! Some levels are measured: for each pose, the largest distance of a vertex of the full mesh from the
//! surface of the level. The ratio of this distance to the error in the bind pose then applies to all levels
//! between two measured ones, whichever of both is larger.

use striata::mesh::{CollapseSequence, IndexedMesh, RefinableMesh, SequenceParts, TriangleTree, replay};
use striata_io::SceneInstance;

use crate::pose::{Pose, Poser};

/// Ratio of the steps of one measured level to those of the next finer one.
const LEVEL_RATIO: f64 = 0.7;

/// Returns the mesh with errors that hold in all poses, as far as they were measured.
pub(super) fn with_raised_errors(
    refinable: RefinableMesh,
    poser: &Poser,
    poses: &[(Pose, &SceneInstance)],
) -> RefinableMesh {
    let posed: Vec<PosedMesh> = poses
        .iter()
        .map(|(pose, instance)| PosedMesh {
            positions: poser.positions(pose, instance, &refinable.mesh),
            scale: instance.scale,
        })
        .collect();
    let step_count = refinable.sequence.step_count();
    let mut measured = Vec::new();
    let mut split_count = step_count;
    while split_count > 0 {
        split_count = ((split_count as f64 * LEVEL_RATIO) as usize).min(split_count - 1);
        measured.push((split_count, worst_distance(&refinable, split_count, &posed)));
    }
    let errors = raised(refinable.sequence.errors(), &measured);
    let RefinableMesh { mesh, sequence } = refinable;
    let parts = SequenceParts {
        positions: sequence.positions().clone(),
        base_position_count: sequence.base_position_count(),
        targets: sequence.targets().to_vec(),
        errors,
        removed_triangle_counts: sequence.removed_triangle_counts().to_vec(),
        triangle_count: mesh.triangle_count(),
    };
    match CollapseSequence::from_parts(parts) {
        Ok(sequence) => RefinableMesh { mesh, sequence },
        Err(_) => RefinableMesh { mesh, sequence },
    }
}

/// Positions of all vertices in a pose.
struct PosedMesh {
    positions: Vec<[f32; 3]>,
    /// Scene units per mesh unit.
    scale: f64,
}

/// Returns the largest distance of a vertex from a level in any pose, mesh units; at least the error of the
/// level.
fn worst_distance(refinable: &RefinableMesh, split_count: usize, posed: &[PosedMesh]) -> f64 {
    let sequence = &refinable.sequence;
    let mut worst = f64::from(sequence.error_at(split_count));
    let mut level = replay(refinable, split_count);
    level.layers.clear();
    let hints = nearby_triangles(sequence, split_count, &level);
    for PosedMesh { positions, scale } in posed.iter().filter(|posed| posed.scale > 0.0) {
        let triangles = std::mem::take(&mut level.triangles);
        let shown = IndexedMesh::new(positions.clone(), triangles);
        let tree = TriangleTree::new(&shown);
        level.triangles = shown.triangles;
        let Ok(tree) = tree else { continue };
        for (vertex, &hint) in hints.iter().enumerate() {
            let mut triangle = hint;
            let enough = worst * scale;
            let distance = tree.distance_within(positions[vertex].map(f64::from), enough, &mut triangle);
            if distance.is_finite() {
                worst = worst.max(distance / scale);
            }
        }
    }
    worst
}

/// Returns for each vertex a triangle of a level near the vertex that it has collapsed to.
fn nearby_triangles(sequence: &CollapseSequence, split_count: usize, level: &IndexedMesh) -> Vec<usize> {
    let mut triangle_of = vec![usize::MAX; sequence.positions().vertex_count()];
    for (index, triangle) in level.triangles.iter().enumerate() {
        for &vertex in triangle {
            triangle_of[vertex as usize] = index;
        }
    }
    for vertex in sequence.vertex_count_at(split_count)..triangle_of.len() {
        triangle_of[vertex] = triangle_of[sequence.target(vertex as u32) as usize];
    }
    triangle_of
}

/// Returns the errors of all levels, raised by the ratios at the measured ones (finest first).
fn raised(errors: &[f32], measured: &[(usize, f64)]) -> Vec<f32> {
    let ratio = |&(split_count, distance): &(usize, f64)| {
        let error = f64::from(errors[split_count]);
        if error > 0.0 { (distance / error).max(1.0) } else { 1.0 }
    };
    let mut raised = errors.to_vec();
    let mut end = errors.len();
    let mut finer = 1.0;
    for level in measured {
        let coarser = ratio(level);
        for error in &mut raised[level.0..end] {
            *error = (f64::from(*error) * coarser.max(finer)) as f32;
        }
        // A level without an error in the bind pose may have one in a pose.
        raised[level.0] = raised[level.0].max(level.1 as f32);
        (end, finer) = (level.0, coarser);
    }
    // The error of a level never falls as detail falls.
    for step in (1..raised.len()).rev() {
        raised[step - 1] = raised[step - 1].max(raised[step]);
    }
    raised
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn levels_between_measured_ones_take_the_larger_ratio() {
        let errors = [8.0, 4.0, 2.0, 1.0, 0.5, 0.25];
        assert_eq!(raised(&errors, &[(4, 0.5), (2, 4.0), (0, 8.0)]), [8.0, 8.0, 4.0, 2.0, 0.5, 0.25]);
        assert_eq!(raised(&[0.0, 0.0], &[(1, 0.0), (0, 3.0)]), [3.0, 0.0]);
    }
}
