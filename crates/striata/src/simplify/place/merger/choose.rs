//! Evaluates the edges of a position: their order, and the position of the new vertex.

use glam::DVec3;

use super::Merger;
use super::choice::{Choice, NO_CHOICE};
use crate::simplify::collapse::choice::Choice as JudgedChoice;
use crate::simplify::collapse::judge::Judge;
use crate::simplify::options::SeamRule;
use crate::simplify::place::course::{Course, first_cost, places};
use crate::simplify::place::form::EdgeForm;
use crate::simplify::place::hood::Hood;
use crate::simplify::place::seams::{Crossings, Merge, seam_weight};

/// Weight of the squared distances of both ends from the new triangles, times the area. It costs 1 % of
/// RMS and reduces maxima by a fifth, since planes alone do not detect the loss of a thin spike.
const DISTANCE_WEIGHT: f64 = 0.1;
/// Area, as a multiple of the squared distance, that lost ends count for in addition to the area of
/// their stars. On meshes of thin parts, it reduces RMS by a fifth down to 10 % of the triangles; on
/// scans it changes almost nothing.
const SPIKE_WEIGHT: f64 = 32.0;

impl Merger<'_> {
    pub(super) fn gather(&mut self, v: u32) {
        gather_into(&mut self.hood, &self.judge, &self.positions, self.seams, v);
    }

    /// Lower bound of the cost of collapsing an edge of `v`; infinite if no edge may be collapsed.
    pub(super) fn lower_bound(&mut self, v: u32) -> f32 {
        self.gather(v);
        self.fill_costs(v);
        let least = self.costs.iter().copied().fold(f32::INFINITY, f32::min);
        if least < f32::INFINITY || !self.relaxation.is_possible() || self.judge.is_fixed(v) {
            return least;
        }
        self.judge.gather(v);
        self.judge.fill_costs(v);
        self.judge.star.costs.iter().copied().fold(f32::INFINITY, f32::min)
    }

    /// Computes the costs of all edges of the gathered `v` from the quadratic forms alone.
    fn fill_costs(&mut self, v: u32) {
        self.costs.clear();
        for i in 0..self.hood.ids.len() {
            let cost = match self.course(v, i) {
                Course::Nowhere => f64::INFINITY,
                course => first_cost(&self.edge_form(v, i), course, self.hood.offsets[i]),
            };
            self.costs.push(cost as f32);
        }
    }

    fn edge_form(&self, v: u32, i: usize) -> EdgeForm {
        let other = &self.known[self.hood.ids[i] as usize].form;
        EdgeForm::new(&self.known[v as usize].form, other, self.hood.shared(i), self.hood.offsets[i])
    }

    /// Returns where the edge from the gathered `v` to its neighbor `i` may place its new vertex.
    fn course(&self, v: u32, i: usize) -> Course {
        let u = self.hood.ids[i];
        let borders = [v, u].map(|p| self.known[p as usize].border_count);
        let locked = [v, u].map(|p| self.judge.is_locked[p as usize]);
        let stays = if self.hood.is_border(i) {
            // A vertex at which borders meet or end must stay in place.
            [0, 1].map(|end| locked[end] || borders[end] != 2)
        } else {
            if borders[0] > 0 && borders[1] > 0 {
                return Course::Nowhere;
            }
            [0, 1].map(|end| locked[end] || borders[end] > 0)
        };
        match (stays, locked) {
            (_, [true, true]) => Course::Nowhere,
            ([false, false], _) => Course::Free,
            ([true, false], _) => Course::Here,
            ([false, true], _) => Course::There,
            // On a border, only a locked end must be the one that stays.
            ([true, true], [true, false]) if self.hood.is_border(i) => Course::Here,
            ([true, true], [false, true]) if self.hood.is_border(i) => Course::There,
            ([true, true], [false, false]) => Course::Ends,
            _ => Course::Nowhere,
        }
    }

    /// Evaluates the edges of `v` in full and updates its key to the true cost, or removes `v` from the
    /// heap if no collapse is allowed.
    pub(super) fn decide(&mut self, v: u32, bound: f32) {
        self.gather(v);
        self.fill_costs(v);
        let mut best: Option<(f32, Choice)> = None;
        loop {
            let limit = best.map_or(f32::INFINITY, |(cost, _)| cost);
            let least = self.costs.iter().enumerate().min_by(|a, b| a.1.total_cmp(b.1));
            let Some(i) = least.filter(|(_, cost)| **cost < limit).map(|(i, _)| i) else { break };
            self.costs[i] = f32::INFINITY;
            if let Some(found) = self.judge(v, i, limit).filter(|(cost, _)| *cost < limit) {
                best = Some(found);
            }
        }
        match best.or_else(|| self.relaxed(v)) {
            None => self.heap.remove(v),
            Some((cost, choice)) => {
                self.choices[v as usize] = choice;
                if cost > bound {
                    self.heap.set(v, cost);
                }
            }
        }
    }

    /// Returns the relaxed collapse of `v` and its cost, if `v` may have one now.
    fn relaxed(&mut self, v: u32) -> Option<(f32, Choice)> {
        if self.judge.is_fixed(v) {
            return None;
        }
        self.relaxation.consider(&mut self.judge, (&self.removed, &self.targets));
        self.judge.gather(v);
        let JudgedChoice { tier, cost, target, distance_squared, .. } = self.judge.relaxed_choice(v)?;
        let (place, other_version) = (self.positions[target as usize], self.known[target as usize].version);
        Some((cost, Choice { other: target, other_version, is_kept: false, place, tier, distance_squared }))
    }

    /// Returns the first position for the new vertex that passes all tests, or the cheapest one if
    /// seams are crossed, and its cost.
    fn judge(&mut self, v: u32, i: usize, limit: f32) -> Option<(f32, Choice)> {
        let course = self.course(v, i);
        let u = self.hood.ids[i];
        let edge = self.edge_form(v, i);
        let offset = self.hood.offsets[i];
        gather_into(&mut self.other_hood, &self.judge, &self.positions, self.seams, u);
        let both_move = course == Course::Free;
        let mut crossings = Crossings::default();
        let mut best: Option<(f32, Choice)> = None;
        for (local, is_kept) in places(&edge, course, offset).into_iter().flatten() {
            let (removed, kept) = if is_kept { (u, v) } else { (v, u) };
            // Ends stay exactly where they are, without rounding.
            let is_end = local == if is_kept { DVec3::ZERO } else { offset };
            let place = if is_end { self.positions[kept as usize] } else { self.hood.center + local };
            let merge = Merge { removed, kept, share: self.share_of(removed, kept, place) };
            if edge.cost(local) as f32 >= best.map_or(limit, |(least, _)| least) {
                continue;
            }
            let Judge { legality, links, .. } = &mut self.judge;
            let is_allowed = legality.allows(links, removed, kept);
            if !is_allowed && both_move {
                break;
            }
            let seams = (&mut self.judge, self.seams);
            let crossing = if is_allowed { crossings.cost(seams, (merge, v), both_move) } else { None };
            let Some(crossing) = crossing else {
                if both_move && self.seams == SeamRule::Keep {
                    break;
                }
                continue;
            };
            let mean = edge.normal();
            if self.hood.may_move(place, u, mean) && self.other_hood.may_move(place, v, mean) {
                let left = self.hood.distance_squared(place, u) + self.other_hood.distance_squared(place, v);
                let distance_cost = DISTANCE_WEIGHT * (edge.area() + SPIKE_WEIGHT * left) * left;
                let cost = (edge.cost(local) + distance_cost + crossing) as f32;
                if best.is_none_or(|(least, _)| cost < least) {
                    let other_version = self.known[u as usize].version;
                    best = Some((cost, Choice { other: u, other_version, is_kept, place, ..NO_CHOICE }));
                }
                if crossing == 0.0 {
                    break;
                }
            }
        }
        best
    }

    /// Returns where `place` lies along the edge, from 0 at `kept` to 1 at `removed`.
    pub(super) fn share_of(&self, removed: u32, kept: u32, place: DVec3) -> f64 {
        let from = self.positions[kept as usize];
        let along = self.positions[removed as usize] - from;
        let share = (place - from).dot(along) / along.length_squared().max(f64::MIN_POSITIVE);
        share.clamp(0.0, 1.0)
    }
}

/// Gathers the star of `v` with its seams.
fn gather_into(hood: &mut Hood, judge: &Judge<'_>, positions: &[DVec3], seams: SeamRule, v: u32) {
    if judge.wedges.as_ref().is_some_and(|wedges| wedges.is_split(v)) {
        let weight = |triangles: [u32; 2], along: DVec3| seam_weight(judge, seams, (v, triangles), along);
        hood.gather(&judge.links, positions, v, Some(&weight));
    } else {
        hood.gather(&judge.links, positions, v, None);
    }
}
