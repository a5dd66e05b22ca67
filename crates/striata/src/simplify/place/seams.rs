//! Wedges across an edge whose both ends may go: who merges with whom, and what crossing a seam costs.
//!
//! If seams may be crossed, they are no borders, only places where it costs something to leave their course. A wedge without a
//! partner takes the most similar wedge of the other end, as with half-edge collapses; it keeps its attributes while its
//! vertex moves, and so does a wedge of the end that stays and has no partner either.

use glam::DVec3;

use crate::simplify::collapse::judge::Judge;
use crate::simplify::options::SeamRule;

/// What happens to the vertices of an edge.
#[derive(Clone, Copy, Debug)]
pub(super) struct Merge {
    pub(super) removed: u32,
    pub(super) kept: u32,
    /// How far along the edge from `kept` to `removed` the new place lies, 0 to 1.
    pub(super) share: f64,
}

/// What it costs that the wedges of an edge's ends cross seams, as far as it has been asked for.
#[derive(Debug, Default)]
pub(super) struct Crossings {
    /// Those of the first end, and those of the second; `None` within where a conflict forbids it.
    known: [Option<Option<f64>>; 2],
}

impl Crossings {
    /// What a merge costs, `first` being the first end of the edge; `None` if the rule for seams or a conflict forbids it.
    pub(super) fn cost(
        &mut self,
        (judge, rule): (&mut Judge<'_>, SeamRule),
        (merge, first): (Merge, u32),
        both_move: bool,
    ) -> Option<f64> {
        let Merge { removed, kept, share } = merge;
        let is_split = |p| judge.wedges.as_ref().is_some_and(|wedges| wedges.is_split(p));
        if !is_split(removed) && !is_split(kept) {
            return Some(0.0);
        }
        let mut of = |from: u32, to: u32| {
            *self.known[usize::from(from != first)].get_or_insert_with(|| one_way(judge, from, to))
        };
        let there = of(removed, kept)?;
        let is_whole = match rule {
            SeamRule::Keep => !both_move,
            SeamRule::Cross => share == 0.0,
        };
        if is_whole {
            return Some(there);
        }
        Some(there + share * share * of(kept, removed)?)
    }
}

/// What it costs that the wedges of one end cross seams to those of the other.
fn one_way(judge: &mut Judge<'_>, from: u32, to: u32) -> Option<f64> {
    let k = judge.gather_and_pair(from, to)?;
    if !judge.pair(from, k) {
        return None;
    }
    Some(f64::from(judge.crossing_cost(k)))
}

/// Finds the partners of the wedges of `removed` that triangles show, and makes the triangles show those of `kept`; `targets`
/// gets the partners of all. The attributes of the pairs (removed, kept) in `pairs` mix.
pub(super) fn merge_wedges(
    judge: &mut Judge<'_>,
    (removed, kept): (u32, u32),
    targets: &mut [u32],
    pairs: &mut Vec<(u32, u32)>,
) {
    pairs.clear();
    if judge.wedges.is_none() {
        targets[removed as usize] = kept;
        return pairs.push((removed, kept));
    }
    judge.gather_and_pair(removed, kept);
    let Judge { star, wedges: Some(wedges), .. } = judge else { return };
    for &shown in &star.shown {
        let to = wedges.paired(shown, kept);
        if !wedges.crosses(shown) && pairs.iter().all(|&(from, other)| from != shown && other != to) {
            pairs.push((shown, to));
        }
    }
    wedges.write_targets(removed, kept, targets);
    wedges.substitute(star, removed, targets);
}

/// What leaving the course of a seam weighs between two triangles that show `v`: infinite for a border, `None` if there is no
/// seam. `along` is the edge between them.
pub(super) fn seam_weight(
    judge: &Judge<'_>,
    rule: SeamRule,
    (v, triangles): (u32, [u32; 2]),
    along: DVec3,
) -> Option<f64> {
    let wedges = judge.wedges.as_ref().filter(|wedges| wedges.is_split(v))?;
    let [a, b] = triangles.map(|t| wedges.shown(t, v));
    if a == b {
        return None;
    }
    match rule {
        SeamRule::Keep => Some(f64::INFINITY),
        SeamRule::Cross => {
            let space = judge.attributes.as_ref()?;
            // As much as the strip between the old and the new course costs in attributes if it is half as wide as long.
            Some(f64::from(space.difference_squared(a, b)) / along.length_squared().max(f64::MIN_POSITIVE))
        }
    }
}
