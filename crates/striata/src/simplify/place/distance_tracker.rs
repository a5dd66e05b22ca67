//! Estimates the error of a step: the distance of the worst original vertices from the surface.
//!
//! Every position has one original vertex as its witness, at first its own: of those that came to be
//! nearest to one of its triangles, the one that was farthest away when last measured. A collapse
//! measures the witnesses of both ends again, walking from star to star while that leads nearer. This
//! is an estimate from vertices in one direction, not a bound.

use glam::DVec3;

use crate::simplify::collapse::cost_evaluator::CostEvaluator;
use crate::simplify::collapse::links::LinkEdge;
use crate::simplify::collapse::walk::walk_to_nearest;

const NONE: u32 = u32::MAX;
#[derive(Clone, Copy, Debug)]
struct Witness {
    /// Index of the original position.
    original: u32,
    distance_squared: f32,
}

/// The witness of each position, and scratch.
#[derive(Debug)]
pub(super) struct DistanceTracker {
    witnesses: Vec<Witness>,
    originals: Vec<DVec3>,
    edges: Vec<LinkEdge>,
}

impl DistanceTracker {
    pub(super) fn new(originals: Vec<DVec3>) -> Self {
        let own = |p| Witness { original: p, distance_squared: 0.0 };
        Self { witnesses: (0..originals.len() as u32).map(own).collect(), originals, edges: Vec::new() }
    }

    /// Updates witnesses after the triangles of some positions have changed or vanished: measures those
    /// of all positions in `gone` and the originals in `others` again, by walks that start at `position`.
    /// Returns the largest squared distance among them; distances above `worst` are verified by a
    /// search of the whole mesh.
    pub(super) fn remeasure(
        &mut self,
        (evaluator, positions): (&mut CostEvaluator<'_>, &[DVec3]),
        (gone, others): (&[u32], &[u32]),
        position: u32,
        worst: f32,
    ) -> f32 {
        let no_witness = Witness { original: NONE, distance_squared: 0.0 };
        let mut found = 0.0f32;
        for i in 0..gone.len() + others.len() {
            let original = match gone.get(i) {
                Some(&p) => std::mem::replace(&mut self.witnesses[p as usize], no_witness).original,
                None => others[i - gone.len()],
            };
            if original == NONE {
                continue;
            }
            let from = self.originals[original as usize];
            let offset = |p: u32| (positions[p as usize] - from).as_vec3();
            let (mut distance_squared, mut at) =
                walk_to_nearest(&evaluator.links, &mut self.edges, position, offset);
            if distance_squared > worst.max(found) && evaluator.has_relaxed() {
                (distance_squared, at) =
                    evaluator.nearest_star(from.as_vec3(), (distance_squared, at), worst.max(found));
            }
            found = found.max(distance_squared);
            let current = &mut self.witnesses[at as usize];
            if distance_squared >= current.distance_squared || current.original == NONE {
                *current = Witness { original, distance_squared };
            }
        }
        found
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::{shapes, weld};
    use crate::simplify::SequenceOptions;

    #[test]
    fn witness_of_a_flattened_tip_is_found() {
        // A closed fan with a raised center: when the center is merged into a rim vertex, its height is
        // the error.
        let welded = weld(&shapes::closed_fan(8)).expect("shapes are valid");
        let index_of =
            |v| welded.source_vertex.iter().position(|&source| source == v).map_or(0, |v| v as u32);
        let (tip, rim) = (index_of(0), index_of(1));
        let positions: Vec<DVec3> =
            welded.mesh.positions.iter().map(|p| DVec3::from(p.map(f64::from))).collect();
        let scaled = positions.iter().map(|p| [p.x as f32, p.y as f32, p.z as f32, 0.0]).collect();
        let mut evaluator = CostEvaluator::new(&welded, &SequenceOptions::default());
        evaluator.positions = scaled;
        let mut tracker = DistanceTracker::new(positions.clone());
        evaluator.links.collapse(tip, rim);
        let worst = tracker.remeasure((&mut evaluator, &positions), (&[tip, rim], &[]), rim, 0.0);
        let height = (positions[tip as usize].z - positions[rim as usize].z).abs() as f32;
        assert!(height > 0.0 && (worst - height * height).abs() < 1e-5, "{worst} {height}");
    }
}
