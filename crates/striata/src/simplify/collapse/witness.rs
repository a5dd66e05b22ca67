//! Error reported by each step: the distance of the worst removed vertex from the surface.
//!
//! Every position has at most one **witness**: among the removed vertices whose nearest triangle it
//! touches, the one that was farthest away when last measured. A collapse measures the removed vertex
//! and the witnesses of both ends again, walking from star to star while that leads nearer, and stores
//! each witness where its walk ends. This is an estimate from vertices, not a bound: cheap, and close
//! to the error found by sampling (docs/results/simplification.md). The executor adds how far each
//! step's new surface sticks out.

use glam::Vec3;

use super::cost_evaluator::CostEvaluator;
use super::fan::point;
use super::links::LinkEdge;
use super::lost_positions::HalfEdge;
use super::walk::{NearestStar, walk_to_nearest};

const NONE: u32 = u32::MAX;
/// Marks a vertex of finer levels, by its index in `carried`.
const CARRIED: u32 = 1 << 31;
/// Upper bound on how far the surface moves anywhere, in distances of the removed vertex from its fan.
const MOVE_FACTOR: f32 = 1.5;

#[derive(Clone, Copy, Debug)]
struct Witness {
    vertex: u32,
    distance: f32,
}

const NO_WITNESS: Witness = Witness { vertex: NONE, distance: 0.0 };

/// The witness of each position, and scratch.
#[derive(Debug)]
pub(in crate::simplify) struct Witnesses {
    by_position: Vec<Witness>,
    worst: f32,
    /// Whether witnesses next to a collapse are measured too; scans skip them, which saves a quarter of their time.
    follows_rings: bool,
    edges: Vec<LinkEdge>,
    /// Places of removed vertices that the mesh does not contain: finer levels have removed them.
    carried: Vec<Vec3>,
}

/// A removed vertex and the position that it is measured from.
#[derive(Clone, Copy, Debug)]
pub(in crate::simplify) struct StoredWitness {
    pub position: u32,
    pub vertex: WitnessVertex,
    /// Distance when it was last measured, scaled units.
    pub distance: f32,
}

/// A removed vertex: one of the mesh, or one of those that were [carried](Witnesses::carry) over.
#[derive(Clone, Copy, Debug)]
pub(in crate::simplify) enum WitnessVertex {
    Own(u32),
    Carried(u32),
}

impl Witnesses {
    pub(in crate::simplify) fn new(position_count: usize, follows_rings: bool) -> Self {
        Self {
            by_position: vec![NO_WITNESS; position_count],
            worst: 0.0,
            follows_rings,
            edges: Vec::new(),
            carried: Vec::new(),
        }
    }

    /// Adds a witness at a position: a vertex at this place that a finer level has removed.
    pub(in crate::simplify) fn carry(&mut self, position: u32, place: Vec3, distance: f32) {
        self.by_position[position as usize] =
            Witness { vertex: CARRIED | self.carried.len() as u32, distance };
        self.carried.push(place);
    }

    /// All witnesses, by position.
    pub(in crate::simplify) fn stored(&self) -> impl Iterator<Item = StoredWitness> {
        let stored = |(position, witness): (u32, &Witness)| StoredWitness {
            position,
            vertex: if witness.vertex & CARRIED == 0 {
                WitnessVertex::Own(witness.vertex)
            } else {
                WitnessVertex::Carried(witness.vertex & !CARRIED)
            },
            distance: witness.distance,
        };
        (0..).zip(&self.by_position).filter(|(_, witness)| witness.vertex != NONE).map(stored)
    }

    /// The place of a removed vertex.
    fn place(&self, positions: &[[f32; 4]], vertex: u32) -> Vec3 {
        if vertex & CARRIED == 0 {
            point(positions, vertex)
        } else {
            self.carried[(vertex & !CARRIED) as usize]
        }
    }

    /// Updates witnesses after `v`, whose neighbors were `ring`, was collapsed to `u`; `own` is the
    /// squared distance of `v` from its new fan. Returns the largest squared distance seen so far.
    pub(in crate::simplify) fn collapse(
        &mut self,
        evaluator: &mut CostEvaluator<'_>,
        HalfEdge { v, u }: HalfEdge,
        ring: &[u32],
        own: f32,
    ) -> f32 {
        // Both are removed here and stored again below.
        let candidates = [v, u].map(|p| std::mem::replace(&mut self.by_position[p as usize], NO_WITNESS));
        let (mut own, mut position) = (own, u);
        if own > self.worst {
            // Distances that raise the reported error are measured exactly: those in the cost are only
            // accurate to a few ten-thousandths of the edges.
            (own, position) = self.measure(evaluator, u, point(&evaluator.positions, v), f32::INFINITY);
        }
        let moved = MOVE_FACTOR * own.sqrt();
        self.store(position, Witness { vertex: v, distance: own.sqrt() });
        for candidate in candidates.into_iter().filter(|w| w.vertex != NONE) {
            let (candidate, position) = self.update(evaluator, u, candidate, moved);
            self.store(position, candidate);
        }
        if self.follows_rings {
            self.update_ring(evaluator, ring, moved);
        }
        self.worst
    }

    /// Returns the place of the witness of `v` if collapsing `v` may make it the worst; `own` is the squared
    /// distance by which the collapse moves the surface at `v`.
    pub(in crate::simplify) fn possible_worst(
        &self,
        positions: &[[f32; 4]],
        v: u32,
        own: f32,
    ) -> Option<Vec3> {
        let Witness { vertex, distance } = self.by_position[v as usize];
        let reach = distance + MOVE_FACTOR * own.sqrt();
        (vertex != NONE && reach * reach > self.worst).then(|| self.place(positions, vertex))
    }

    /// Updates the witnesses of a ring around which the surface has moved by a distance.
    fn update_ring(&mut self, evaluator: &mut CostEvaluator<'_>, ring: &[u32], moved: f32) {
        let limit = self.worst.sqrt();
        for &p in ring {
            let current = &mut self.by_position[p as usize];
            let reach = current.distance + moved;
            if current.vertex == NONE || reach <= limit {
                current.distance = reach;
                continue;
            }
            let candidate = std::mem::replace(current, NO_WITNESS);
            let (candidate, position) = self.update(evaluator, p, candidate, moved);
            self.store(position, candidate);
        }
    }

    /// Updates a witness after the surface around `p` has moved by a distance; returns it with its new
    /// distance, and the position to store it at. It is measured only if it may be the worst.
    fn update(
        &mut self,
        evaluator: &mut CostEvaluator<'_>,
        p: u32,
        candidate: Witness,
        moved: f32,
    ) -> (Witness, u32) {
        let reach = candidate.distance + moved;
        let reach_squared = reach * reach;
        if reach_squared <= self.worst {
            return (Witness { distance: reach, ..candidate }, p);
        }
        let from = self.place(&evaluator.positions, candidate.vertex);
        let (distance_squared, position) = self.measure(evaluator, p, from, reach_squared);
        (Witness { distance: distance_squared.sqrt(), ..candidate }, position)
    }

    /// Updates witnesses after a relaxed collapse. The `lost` positions, their witnesses and the `points` of
    /// removed triangles are measured again, starting at `position`; distances above the largest so far are
    /// verified by a search of the whole mesh. Returns the largest squared distance seen so far.
    pub(in crate::simplify) fn remeasure(
        &mut self,
        evaluator: &mut CostEvaluator<'_>,
        lost: &[u32],
        points: &[Vec3],
        position: u32,
    ) -> f32 {
        for &p in lost {
            let witness = std::mem::replace(&mut self.by_position[p as usize], NO_WITNESS);
            for vertex in
                [p, witness.vertex].into_iter().filter(|&vertex| vertex != NONE && vertex != position)
            {
                let from = self.place(&evaluator.positions, vertex);
                let (distance_squared, at) = self.measure(evaluator, position, from, f32::INFINITY);
                self.store(at, Witness { vertex, distance: distance_squared.sqrt() });
            }
        }
        for &from in points {
            self.measure(evaluator, position, from, f32::INFINITY);
        }
        self.worst
    }

    /// Measures a point by a walk that starts at `position`. If relaxed collapses may have changed what is
    /// near, a result that would raise the worst distance is verified in the whole mesh. A walk that
    /// ends beyond the squared distance `limit` has lost its way.
    fn measure(
        &mut self,
        evaluator: &mut CostEvaluator<'_>,
        position: u32,
        from: Vec3,
        limit: f32,
    ) -> NearestStar {
        let positions = &evaluator.positions;
        let walked =
            walk_to_nearest(&evaluator.links, &mut self.edges, position, |p| point(positions, p) - from);
        let is_lost = walked.0 > limit;
        let known = if is_lost { (limit, position) } else { walked };
        let found = evaluator.nearest_star(from, known, self.worst);
        if !is_lost || evaluator.searches_whole_mesh() {
            // A limit that was never measured must not be reported.
            self.worst = self.worst.max(found.0);
        }
        found
    }

    /// Largest squared distance so far.
    pub(in crate::simplify) fn worst_squared(&self) -> f32 {
        self.worst
    }

    /// Raises the worst squared distance to at least this, and returns it.
    pub(in crate::simplify) fn raise(&mut self, distance_squared: f32) -> f32 {
        self.worst = self.worst.max(distance_squared);
        self.worst
    }

    /// Stores `candidate` at `position` if it is farther away than the witness there.
    fn store(&mut self, position: u32, candidate: Witness) {
        let current = &mut self.by_position[position as usize];
        if candidate.distance > current.distance || current.vertex == NONE {
            *current = candidate;
        }
    }
}
