//! Carrying out a collapse: links, wedges and what the cost remembers follow it, and it is written down with its error.

use crate::mesh::Welded;

use super::finish::Record;
use super::judge::{Choice, Judge, Memory};
use super::links::LinkKind;
use super::witness::Witnesses;

/// Squared protrusions under this share of the squared edge are what single precision leaves of flat places.
const PROTRUSION_NOISE: f32 = 1e-5;

/// The collapses so far.
#[derive(Debug)]
pub(super) struct Course {
    /// Mesh units of one scaled unit.
    scale: f64,
    witnesses: Witnesses,
    /// The neighbours that the position removed last had, each once.
    pub(super) ring: Vec<u32>,
    /// Triangles that are left.
    pub(super) triangle_count: usize,
    /// What was collapsed; errors are the caller's to add.
    pub(super) record: Record,
}

impl Course {
    pub(super) fn new(welded: &Welded, scale: f64) -> Self {
        Self {
            scale,
            witnesses: Witnesses::new(welded.positions.position_count()),
            ring: Vec::new(),
            triangle_count: welded.mesh.triangle_count(),
            record: Record { targets: vec![0; welded.mesh.vertex_count()], ..Record::default() },
        }
    }

    /// Removes `v` as `choice` says; returns the error after it, mesh units.
    pub(super) fn collapse(&mut self, judge: &mut Judge<'_>, v: u32, choice: &Choice) -> f64 {
        let u = choice.target;
        let tracked = self.leave(judge, v, u);
        let links = &mut judge.links;
        self.ring.clear();
        self.ring.extend_from_slice(links.entries(v));
        if links.kind(v) == LinkKind::Edges {
            self.ring.sort_unstable();
            self.ring.dedup();
        }
        let before = links.triangle_count(v) + links.triangle_count(u);
        links.collapse(v, u);
        // Each vanished triangle stood in both links.
        let removed = (before - links.triangle_count(u)) / 2;
        self.triangle_count -= removed;
        self.record.removed.push(v);
        self.record.removed_triangle_counts.push(removed as u8);
        let worst = tracked.unwrap_or_else(|| {
            let own = choice.distance_squared;
            let worst = self.witnesses.collapse(&judge.links, &judge.positions, (v, u), own);
            worst.max(reported_protrusion(&judge.positions, v, choice))
        });
        f64::from(worst).sqrt() * self.scale
    }

    /// Takes the last collapse off the record; links and wedges stay as they are.
    pub(super) fn forget_last(&mut self) {
        self.record.removed.pop();
        self.record.removed_triangle_counts.pop();
    }

    /// Does what must be done while the star of `v` still stands: targets of its wedges, memory of the cost function.
    /// Returns the largest squared distance of tracked vertices, where they are tracked between neighbours.
    fn leave(&mut self, judge: &mut Judge<'_>, v: u32, u: u32) -> Option<f32> {
        let Judge { wedges, memory, pairs, .. } = judge;
        if let Some(pairs) = pairs {
            pairs.collapse(v, u);
        }
        if let Memory::Accumulated(quadrics) = memory {
            let own = quadrics[v as usize];
            quadrics[u as usize].add(&own);
        }
        let is_tracked = matches!(memory, Memory::Tracked(_));
        if wedges.is_none() && !is_tracked {
            self.record.targets[v as usize] = u;
            return None;
        }
        let neighbour = judge.gather_and_pair(v, u);
        if neighbour.is_none() {
            judge.pair_wedges(v, u);
        }
        let Judge { star, positions, wedges, memory, .. } = judge;
        match wedges {
            Some(wedges) => {
                wedges.write_targets(v, u, &mut self.record.targets);
                wedges.substitute(star, v, &self.record.targets);
            }
            None => self.record.targets[v as usize] = u,
        }
        let (Memory::Tracked(tracker), Some(k)) = (memory, neighbour) else { return None };
        star.mark_vanishing(Some(k));
        tracker.load(star, positions, v);
        Some(tracker.collapse(star, v, k))
    }
}

/// How far the surface that replaces the star of `v` sticks out, squared, unless that may be rounding.
fn reported_protrusion(positions: &[[f32; 4]], v: u32, choice: &Choice) -> f32 {
    let [from, to] = [v, choice.target].map(|p| positions[p as usize]);
    let edge_squared: f32 = (0..3).map(|a| (from[a] - to[a]) * (from[a] - to[a])).sum();
    let protrusion = choice.protrusion_squared;
    if protrusion > PROTRUSION_NOISE * edge_squared { protrusion } else { 0.0 }
}
