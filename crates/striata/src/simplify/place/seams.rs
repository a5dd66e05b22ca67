//! Wedges at an edge of which either end may be removed: their pairing, and the cost of crossing a seam.
//!
//! Seams that may be crossed do not count as borders; leaving their path only adds to the cost. A wedge
//! without a partner goes to the most similar wedge of the other end, as with half-edge collapses. It keeps
//! its attributes while its vertex moves, and so does a wedge of the kept end that has no partner either.

use glam::DVec3;

use crate::simplify::collapse::cost_evaluator::CostEvaluator;
use crate::simplify::options::SeamRule;

/// Merge of the two ends of an edge.
#[derive(Clone, Copy, Debug)]
pub(super) struct Merge {
    pub removed: u32,
    pub kept: u32,
    /// Place of the new position along the edge, from 0 at `kept` to 1 at `removed`.
    pub share: f64,
}

/// Costs of crossing seams at an edge, evaluated when needed.
#[derive(Debug, Default)]
pub(super) struct SeamCosts {
    /// Costs for the wedges of the first end and of the second, if evaluated; the inner value is `None`
    /// if a conflict forbids it.
    costs: [Option<Option<f64>>; 2],
}

impl SeamCosts {
    /// Cost of a merge; `None` if the seam rule or a conflict forbids it. `first` is the first end of
    /// the edge.
    pub(super) fn cost(
        &mut self,
        (evaluator, rule): (&mut CostEvaluator<'_>, SeamRule),
        (merge, first): (Merge, u32),
        both_move: bool,
    ) -> Option<f64> {
        let Merge { removed, kept, share } = merge;
        let is_split = |p| evaluator.wedges.as_ref().is_some_and(|wedges| wedges.is_split(p));
        if !is_split(removed) && !is_split(kept) {
            return Some(0.0);
        }
        let mut cost_of = |from: u32, to: u32| {
            *self.costs[usize::from(from != first)].get_or_insert_with(|| one_way(evaluator, from, to))
        };
        let there = cost_of(removed, kept)?;
        let is_whole = match rule {
            SeamRule::Keep => !both_move,
            SeamRule::Cross => share == 0.0,
        };
        if is_whole {
            return Some(there);
        }
        Some(there + share * share * cost_of(kept, removed)?)
    }
}

/// Cost of wedges of one end that cross seams to wedges of the other.
fn one_way(evaluator: &mut CostEvaluator<'_>, from: u32, to: u32) -> Option<f64> {
    let k = evaluator.gather_and_pair(from, to)?;
    if !evaluator.pair(from, k) {
        return None;
    }
    Some(f64::from(evaluator.crossing_cost(k)))
}

/// Pairs the wedges of `removed` with those of `kept` and substitutes them in the triangles. The
/// targets of all wedges are written to `targets`; `pairs` gets the pairs (removed, kept) whose
/// attributes are to be interpolated.
pub(super) fn merge_wedges(
    evaluator: &mut CostEvaluator<'_>,
    removed: u32,
    kept: u32,
    targets: &mut [u32],
    pairs: &mut Vec<(u32, u32)>,
) {
    pairs.clear();
    if evaluator.wedges.is_none() {
        targets[removed as usize] = kept;
        return pairs.push((removed, kept));
    }
    evaluator.gather_and_pair(removed, kept);
    let CostEvaluator { star, wedges: Some(wedges), .. } = evaluator else { return };
    for &wedge in &star.center_wedges {
        let to = wedges.paired(wedge, kept);
        if !wedges.crosses(wedge) && pairs.iter().all(|&(from, other)| from != wedge && other != to) {
            pairs.push((wedge, to));
        }
    }
    wedges.write_targets(removed, kept, targets);
    wedges.substitute(star, removed, targets);
}

/// Weight of leaving the path of the seam between two triangles around `v`: infinite for a border,
/// `None` if there is no seam. `along` is the vector of the edge between them.
pub(super) fn seam_weight(
    evaluator: &CostEvaluator<'_>,
    rule: SeamRule,
    v: u32,
    triangles: [u32; 2],
    along: DVec3,
) -> Option<f64> {
    let wedges = evaluator.wedges.as_ref().filter(|wedges| wedges.is_split(v))?;
    let [a, b] = triangles.map(|t| wedges.vertex_at(t, v));
    if a == b {
        return None;
    }
    match rule {
        SeamRule::Keep => Some(f64::INFINITY),
        SeamRule::Cross => {
            let space = evaluator.attributes.as_ref()?;
            // The attribute cost of the strip between the old and the new path, if the strip is half as
            // wide as long.
            Some(f64::from(space.difference_squared(a, b)) / along.length_squared().max(f64::MIN_POSITIVE))
        }
    }
}
