//! The loop: take the cheapest collapse, do it, look again at what it touched.
//!
//! The queue holds one entry a position, the cost of its best target. After a collapse only the ring of the removed
//! position changes cost, and each of its members gets a **lower bound** first: the quadratic form alone, without
//! flip, link and distance tests. Those are made when a position reaches the top; if its true cost is higher it
//! goes back. The order is therefore strict, for a fraction of the work.
//!
//! Time O(n log n); about 30 bytes a triangle besides the mesh.

use std::ops::ControlFlow;

use crate::mesh::Welded;
use crate::{Cancelled, Progress, ProgressFn};

use super::finish::Record;
use super::heap::IndexedHeap;
use super::legality::Legality;
use super::links::{LinkKind, Links};
use super::options::{BoundaryRule, SequenceOptions, SimplifyError, StopReason};
use super::star::Star;
use super::wedges::Wedges;
use super::witness::Witnesses;

/// No target chosen yet: the key is a lower bound.
const UNDECIDED: u32 = u32::MAX;

/// A collapse that was judged in full.
#[derive(Clone, Copy, Debug)]
struct Choice {
    cost: f32,
    /// Index of the target among the star's neighbours.
    neighbour: usize,
    /// Squared distance of the vertex from its new fan.
    distance_squared: f32,
}

/// All state of one simplification.
pub(super) struct Engine<'a> {
    options: &'a SequenceOptions,
    /// Positions about the bounds' centre, diagonal 1, padded to a vector register.
    positions: Vec<[f32; 4]>,
    /// Mesh units of one scaled unit.
    scale: f64,
    links: Links,
    wedges: Option<Wedges<'a>>,
    is_locked: Vec<bool>,
    heap: IndexedHeap,
    target: Vec<u32>,
    distance_squared: Vec<f32>,
    witnesses: Witnesses,
    star: Star,
    legality: Legality,
    ring: Vec<u32>,
    triangle_count: usize,
    record: Record,
}

impl<'a> Engine<'a> {
    pub(super) fn new(welded: &'a Welded, options: &'a SequenceOptions) -> Self {
        let (positions, scale) = scaled_positions(welded);
        let position_count = positions.len();
        let has_wedges = !welded.positions.is_identity();
        let links = if has_wedges {
            let of = |t: &[u32; 3]| t.map(|v| welded.positions.position_of(v));
            let triangles: Vec<[u32; 3]> = welded.mesh.triangles.iter().map(of).collect();
            Links::new(position_count, &triangles, true)
        } else {
            Links::new(position_count, &welded.mesh.triangles, false)
        };
        let wedges = has_wedges.then(|| Wedges::new(&welded.positions, welded.mesh.triangles.clone()));
        Self {
            options,
            positions,
            scale,
            links,
            wedges,
            is_locked: locked_positions(welded, &options.locked_vertices),
            heap: IndexedHeap::new(&[]),
            target: vec![UNDECIDED; position_count],
            distance_squared: vec![0.0; position_count],
            witnesses: Witnesses::new(position_count),
            star: Star::default(),
            legality: Legality::default(),
            ring: Vec::new(),
            triangle_count: welded.mesh.triangle_count(),
            record: Record { targets: vec![0; welded.mesh.vertex_count()], ..Record::default() },
        }
    }

    /// Collapses until nothing can be, the base is reached or an error limit forbids to go on.
    pub(super) fn run(
        mut self,
        progress: &mut ProgressFn<'_>,
    ) -> Result<(Record, StopReason), SimplifyError> {
        let keys: Vec<f32> = (0..self.positions.len() as u32).map(|v| self.lower_bound(v)).collect();
        self.heap = IndexedHeap::new(&keys);
        drop(keys);
        let total = self.positions.len() as u64;
        let limit = self.options.max_error.unwrap_or(f64::INFINITY);
        let mut error = 0.0f64;
        let mut stop_reason = StopReason::BaseReached;
        while let Some((key, v)) = self.heap.first() {
            if self.triangle_count <= self.options.base_triangle_count {
                stop_reason = StopReason::TargetReached;
                break;
            }
            if self.target[v as usize] == UNDECIDED {
                self.decide(v, key);
                continue;
            }
            let u = self.target[v as usize];
            if !self.legality.allows(&self.links, v, u) {
                // The target's surroundings have changed: look for another one.
                self.target[v as usize] = UNDECIDED;
                continue;
            }
            let collapse_error = self.collapse(v, u);
            if collapse_error > limit {
                self.record.removed.pop();
                self.record.removed_triangle_counts.pop();
                stop_reason = StopReason::ErrorLimit;
                break;
            }
            error = error.max(collapse_error);
            self.record.errors.push(error as f32);
            let done = self.record.removed.len() as u64;
            if done % 4096 == 0
                && progress(Progress { phase: "simplify", done, total }) == ControlFlow::Break(())
            {
                return Err(Cancelled.into());
            }
        }
        Ok((self.record, stop_reason))
    }

    /// Fills the star of `v` with the quadratic costs of its candidates.
    fn load_star(&mut self, v: u32) {
        self.star.gather(&self.links, &self.positions, v);
        self.star.compute_costs();
        let kind = self.links.kind(v);
        match &self.wedges {
            Some(wedges) if wedges.is_split(v) => {
                let triangles = std::mem::take(&mut self.star.triangles);
                let is_seam =
                    |s: usize, t: usize| wedges.shown(triangles[s], v) != wedges.shown(triangles[t], v);
                self.star.apply_borders(kind, Some(&is_seam));
                self.star.triangles = triangles;
            }
            _ => self.star.apply_borders(kind, None),
        }
    }

    /// The least that collapsing `v` can cost; infinite where it may not be collapsed at all.
    fn lower_bound(&mut self, v: u32) -> f32 {
        if self.is_locked[v as usize] || self.links.kind(v) == LinkKind::Empty {
            return f32::INFINITY;
        }
        if self.options.boundary == BoundaryRule::Locked && self.is_boundary(v) {
            return f32::INFINITY;
        }
        self.load_star(v);
        self.star.costs.iter().copied().fold(f32::INFINITY, f32::min)
    }

    fn is_boundary(&self, v: u32) -> bool {
        match self.links.kind(v) {
            LinkKind::Open => true,
            LinkKind::Edges => {
                let entries = self.links.entries(v);
                entries.iter().any(|w| entries.iter().filter(|x| *x == w).count() == 1)
            }
            _ => false,
        }
    }

    /// Judges `v` in full and puts it back with its true cost, or takes it out where no target is allowed.
    fn decide(&mut self, v: u32, bound: f32) {
        self.load_star(v);
        match self.best_choice(v) {
            None => self.heap.remove(v),
            Some(choice) => {
                self.target[v as usize] = self.star.ids[choice.neighbour];
                self.distance_squared[v as usize] = choice.distance_squared;
                if choice.cost > bound {
                    self.heap.set(v, choice.cost);
                }
            }
        }
    }

    /// The cheapest allowed target of the loaded star.
    fn best_choice(&mut self, v: u32) -> Option<Choice> {
        let mut best: Option<Choice> = None;
        loop {
            let least = self.star.costs.iter().enumerate().min_by(|a, b| a.1.total_cmp(b.1));
            let (neighbour, cost) = least.map(|(k, &cost)| (k, cost))?;
            if cost >= best.map_or(f32::INFINITY, |b| b.cost) {
                return best;
            }
            self.star.costs[neighbour] = f32::INFINITY;
            let u = self.star.ids[neighbour];
            if !self.legality.allows(&self.links, v, u) {
                continue;
            }
            if self.wedges.as_mut().is_some_and(|wedges| !wedges.pair(&self.star, v, neighbour)) {
                continue;
            }
            let limit = best.map_or(f32::INFINITY, |b| b.cost - cost);
            let Some(fan) = self.star.fan(neighbour, limit) else { continue };
            let cost = cost + fan.cost;
            if cost < best.map_or(f32::INFINITY, |b| b.cost) {
                best = Some(Choice { cost, neighbour, distance_squared: fan.distance_squared });
            }
        }
    }

    /// Removes `v` into `u` and gives the neighbours new bounds; returns the error after it, mesh units.
    fn collapse(&mut self, v: u32, u: u32) -> f64 {
        self.write_targets(v, u);
        self.ring.clear();
        self.ring.extend_from_slice(self.links.entries(v));
        if self.links.kind(v) == LinkKind::Edges {
            self.ring.sort_unstable();
            self.ring.dedup();
        }
        let before = self.links.triangle_count(v) + self.links.triangle_count(u);
        self.links.collapse(v, u);
        // Each vanished triangle stood in both links.
        let removed = (before - self.links.triangle_count(u)) / 2;
        self.triangle_count -= removed;
        self.heap.remove(v);
        self.record.removed.push(v);
        self.record.removed_triangle_counts.push(removed as u8);
        let own = self.distance_squared[v as usize];
        let worst = self.witnesses.collapse(&self.links, &self.positions, (v, u), own);
        let ring = std::mem::take(&mut self.ring);
        for &w in &ring {
            self.target[w as usize] = UNDECIDED;
            let bound = self.lower_bound(w);
            self.heap.set(w, bound);
        }
        self.ring = ring;
        f64::from(worst).sqrt() * self.scale
    }

    fn write_targets(&mut self, v: u32, u: u32) {
        let Some(wedges) = &mut self.wedges else {
            self.record.targets[v as usize] = u;
            return;
        };
        self.star.gather(&self.links, &self.positions, v);
        if let Some(k) = self.star.ids.iter().position(|&w| w == u) {
            wedges.pair(&self.star, v, k);
        }
        wedges.write_targets(v, u, &mut self.record.targets);
        wedges.substitute(&self.star, v, &self.record.targets);
    }
}

/// One entry a position, about the centre of the bounds and with their diagonal as unit.
fn scaled_positions(welded: &Welded) -> (Vec<[f32; 4]>, f64) {
    let Some(bounds) = welded.mesh.bounds() else { return (Vec::new(), 1.0) };
    let scale = if bounds.diagonal() > 0.0 { bounds.diagonal() } else { 1.0 };
    let centre: [f64; 3] =
        std::array::from_fn(|a| 0.5 * (f64::from(bounds.min[a]) + f64::from(bounds.max[a])));
    let place = |p: u32| {
        let [x, y, z] = welded.mesh.positions[welded.positions.first_vertex(p) as usize];
        let on = |x: f32, a: usize| ((f64::from(x) - centre[a]) / scale) as f32;
        [on(x, 0), on(y, 1), on(z, 2), 0.0]
    };
    ((0..welded.positions.position_count() as u32).map(place).collect(), scale)
}

fn locked_positions(welded: &Welded, locked_vertices: &[u32]) -> Vec<bool> {
    let mut is_locked = vec![false; welded.positions.position_count()];
    if locked_vertices.is_empty() {
        return is_locked;
    }
    let wanted: std::collections::BTreeSet<u32> = locked_vertices.iter().copied().collect();
    for (v, source) in welded.source_vertex.iter().enumerate() {
        if wanted.contains(source) {
            is_locked[welded.positions.position_of(v as u32) as usize] = true;
        }
    }
    is_locked
}
