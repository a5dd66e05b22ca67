//! The error that a step reports: how far the worst vertices removed so far lie from the surface.
//!
//! Every position carries one **witness**: among the removed vertices whose nearest triangle it touches, the one that
//! was farthest away when last measured. A collapse measures the removed vertex and the witnesses of both ends
//! anew, walking from star to star while that leads nearer, and each witness settles where it ends. This is an
//! estimate from vertices: cheap and close to what sampling finds (docs/results.md has the comparison), not a bound. The
//! engine adds how far each step's new surface sticks out.

use glam::Vec3;

use super::fan::point;
use super::judge::Judge;
use super::links::LinkEdge;
use super::walk::{Standing, walk};

const NONE: u32 = u32::MAX;
/// Most that the surface moves anywhere, in distances of the removed vertex from its fan.
const MOVE_FACTOR: f32 = 1.5;

#[derive(Clone, Copy, Debug)]
struct Witness {
    vertex: u32,
    distance: f32,
}

const NOBODY: Witness = Witness { vertex: NONE, distance: 0.0 };

/// One removed vertex for each position, and scratch.
#[derive(Debug)]
pub(in crate::simplify) struct Witnesses {
    of: Vec<Witness>,
    worst: f32,
    /// Whether witnesses beside a collapse are looked at too; closed scans do without, which saves a quarter of their time.
    follows_rings: bool,
    edges: Vec<LinkEdge>,
}

impl Witnesses {
    pub(in crate::simplify) fn new(position_count: usize, follows_rings: bool) -> Self {
        Self { of: vec![NOBODY; position_count], worst: 0.0, follows_rings, edges: Vec::new() }
    }

    /// Called after `v`, whose neighbors were `ring`, was collapsed to `u`, `own` being the squared distance of v from its new fan.
    /// Returns the largest squared distance among v and the witnesses of all these.
    pub(in crate::simplify) fn collapse(
        &mut self,
        judge: &mut Judge<'_>,
        (v, u): (u32, u32),
        ring: &[u32],
        own: f32,
    ) -> f32 {
        // Both are taken out, and settle anew below.
        let candidates = [v, u].map(|p| std::mem::replace(&mut self.of[p as usize], NOBODY));
        let (mut own, mut place) = (own, u);
        if own > self.worst {
            // What raises the reported error is measured exactly: the cost's distances are good to a few
            // ten-thousandths of the edges only.
            (own, place) = self.find(judge, u, point(&judge.positions, v), f32::INFINITY);
        }
        let moved = MOVE_FACTOR * own.sqrt();
        self.keep(place, Witness { vertex: v, distance: own.sqrt() });
        for candidate in candidates.into_iter().filter(|w| w.vertex != NONE) {
            let (candidate, place) = self.follow(judge, u, candidate, moved);
            self.keep(place, candidate);
        }
        if self.follows_rings {
            self.follow_ring(judge, ring, moved);
        }
        self.worst
    }

    /// The witness of `v` if it may become the worst by a collapse of v that moves v by the squared distance `own`.
    pub(in crate::simplify) fn suspect(&self, v: u32, own: f32) -> Option<u32> {
        let Witness { vertex, distance } = self.of[v as usize];
        let reach = distance + MOVE_FACTOR * own.sqrt();
        (vertex != NONE && reach * reach > self.worst).then_some(vertex)
    }

    /// Lets the witnesses of a ring follow the surface there, which has moved by a distance.
    fn follow_ring(&mut self, judge: &mut Judge<'_>, ring: &[u32], moved: f32) {
        let limit = self.worst.sqrt();
        for &p in ring {
            let there = &mut self.of[p as usize];
            let reach = there.distance + moved;
            if there.vertex == NONE || reach <= limit {
                there.distance = reach;
                continue;
            }
            let candidate = std::mem::replace(there, NOBODY);
            let (candidate, place) = self.follow(judge, p, candidate, moved);
            self.keep(place, candidate);
        }
    }

    /// Where a witness is to be kept once the surface around `p` has moved by a distance, and how far away it is; it is only
    /// measured if it may be the worst.
    fn follow(&mut self, judge: &mut Judge<'_>, p: u32, candidate: Witness, moved: f32) -> (Witness, u32) {
        let reach = candidate.distance + moved;
        let reach_squared = reach * reach;
        if reach_squared <= self.worst {
            return (Witness { distance: reach, ..candidate }, p);
        }
        let from = point(&judge.positions, candidate.vertex);
        let (distance_squared, place) = self.find(judge, p, from, reach_squared);
        (Witness { distance: distance_squared.sqrt(), ..candidate }, place)
    }

    /// Called after a relaxed collapse. Everything that the `lost` positions stood for settles anew from `place`, and so do the
    /// `points` of the triangles that have gone; what that puts above all that was seen before is looked for everywhere.
    /// Returns the largest squared distance seen so far.
    pub(in crate::simplify) fn lose(
        &mut self,
        judge: &mut Judge<'_>,
        (lost, points): (&[u32], &[Vec3]),
        place: u32,
    ) -> f32 {
        for &p in lost {
            let witness = std::mem::replace(&mut self.of[p as usize], NOBODY);
            for vertex in [p, witness.vertex].into_iter().filter(|&vertex| vertex != NONE && vertex != place)
            {
                let (distance_squared, at) =
                    self.find(judge, place, point(&judge.positions, vertex), f32::INFINITY);
                self.keep(at, Witness { vertex, distance: distance_squared.sqrt() });
            }
        }
        for &from in points {
            self.find(judge, place, from, f32::INFINITY);
        }
        self.worst
    }

    /// Settles a point from `place`, verifies what would raise the worst distance, if relaxed collapses may change what is near
    /// what, and raises it. What the walk finds beyond a `limit`, squared, has lost its way.
    fn find(&mut self, judge: &mut Judge<'_>, place: u32, from: Vec3, limit: f32) -> Standing {
        let positions = &judge.positions;
        let settled = walk(&judge.links, &mut self.edges, place, |p| point(positions, p) - from);
        let is_lost = settled.0 > limit;
        let known = if is_lost { (limit, place) } else { settled };
        let found = judge.standing(from, known, self.worst);
        if !is_lost || judge.looks_everywhere() {
            // A limit that nobody has measured must not be reported.
            self.worst = self.worst.max(found.0);
        }
        found
    }

    /// The largest squared distance so far.
    pub(in crate::simplify) fn worst(&self) -> f32 {
        self.worst
    }

    /// Raises the worst squared distance, and gives it.
    pub(in crate::simplify) fn raise(&mut self, distance_squared: f32) -> f32 {
        self.worst = self.worst.max(distance_squared);
        self.worst
    }

    /// Makes `candidate` the witness of `place` if it is worse than the one there.
    fn keep(&mut self, place: u32, candidate: Witness) {
        let there = &mut self.of[place as usize];
        if candidate.distance > there.distance || there.vertex == NONE {
            *there = candidate;
        }
    }
}
