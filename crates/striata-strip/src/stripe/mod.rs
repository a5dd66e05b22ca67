//! STRIPE: each strip continues to the neighbor that has the fewest free neighbors left.
//!
//! A strip starts at a free triangle of least degree and grows from both ends, always to the neighbor of
//! least degree. Ties go to the triangle whose own neighbors have the fewest free neighbors, then to the
//! one that needs no swap. Few triangles end up isolated this way; the price is swaps, which
//! [`StripeSwaps`] can avoid. This is the classic baseline for the number of strips.
//!
//! The global algorithm first covers patches of quadrilaterals row by row (`patches`), and leaves the rest to
//! the local one.
//!
//! \[ESV96\]. Differs: strips grow from both ends. The paper chooses the diagonals of quadrilaterals; here they
//! are those of the mesh, because strips have to show its triangles. Linear in time and memory.

mod patches;
mod quads;

use striata::strip::{FreeTriangles, Seeds, StripLinks, next_side, prev_side};
use striata::{Cancelled, Progress, ProgressFn};

use crate::stripifier::StripeSwaps;
use crate::task::StripTask;

/// Number of strips between two calls of the progress callback.
const STRIPS_PER_REPORT: u64 = 1 << 10;

/// Joins isolated triangles into strips; existing strips stay as they are.
///
/// With `has_patches`, patches of quadrilaterals are covered first.
pub(crate) fn run(
    task: &StripTask<'_>,
    links: &mut StripLinks<'_>,
    has_patches: bool,
    swaps: StripeSwaps,
    progress: &mut ProgressFn<'_>,
) -> Result<(), Cancelled> {
    if has_patches {
        patches::cover(task.triangles, links);
    }
    let mut free = FreeTriangles::new(task.triangles, links);
    let mut strip = Vec::new();
    let (mut strip_count, mut done, total) = (0u64, 0, task.triangles.len() as u64);
    for group in task.groups {
        let mut seeds = Seeds::new(&free, group.clone());
        while let Some(seed) = seeds.pop(&free) {
            if strip_count.is_multiple_of(STRIPS_PER_REPORT) {
                Progress { phase: "strip", done, total }.report(progress)?;
            }
            grow(seed, swaps, &mut free, &mut strip, links);
            for &triangle in &strip {
                seeds.push_around(triangle, &free);
            }
            strip_count += 1;
            done += strip.len() as u64;
        }
    }
    Ok(())
}

/// Grows a strip from both ends of a seed and puts its triangles into `strip`, in no particular order.
fn grow(
    seed: u32,
    swaps: StripeSwaps,
    free: &mut FreeTriangles<'_>,
    strip: &mut Vec<u32>,
    links: &mut StripLinks<'_>,
) {
    strip.clear();
    free.mark_used(seed);
    strip.push(seed);
    let any = [3 * seed, 3 * seed + 1, 3 * seed + 2];
    let Some(exit) = most_isolated(free, any, StripeSwaps::Free) else { return };
    let first_turns_next = walk(WalkStart { exit, turns_next: None }, swaps, free, strip, links);
    // The seed has to turn the other way than the triangle after it; seen from behind, that is the same way.
    let (straight, turned) = match first_turns_next {
        Some(false) => (prev_side(exit), next_side(exit)),
        _ => (next_side(exit), prev_side(exit)),
    };
    if let Some(back) = most_isolated(free, [straight, turned], swaps) {
        let start = WalkStart { exit: back, turns_next: Some(back == prev_side(exit)) };
        walk(start, swaps, free, strip, links);
    }
}

/// Start of a walk.
struct WalkStart {
    exit: u32,
    /// Which turn of the first triangle needs no swap; [`None`] if both do not.
    turns_next: Option<bool>,
}

/// Joins triangles from an exit on until none is free. Returns whether the first of them turned to its next
/// side; [`None`] if it did not turn.
fn walk(
    start: WalkStart,
    swaps: StripeSwaps,
    free: &mut FreeTriangles<'_>,
    strip: &mut Vec<u32>,
    links: &mut StripLinks<'_>,
) -> Option<bool> {
    let WalkStart { mut exit, mut turns_next } = start;
    let mut first_turns_next = None;
    while let Some(enter) = free.free_entry_across(exit) {
        links.join(exit);
        free.mark_used(enter / 3);
        strip.push(enter / 3);
        let (straight, turned) = match turns_next {
            Some(true) => (next_side(enter), prev_side(enter)),
            _ => (prev_side(enter), next_side(enter)),
        };
        let swaps = if turns_next.is_none() { StripeSwaps::Free } else { swaps };
        let Some(chosen) = most_isolated(free, [straight, turned], swaps) else { break };
        let has_turned_next = chosen == next_side(enter);
        first_turns_next.get_or_insert(has_turned_next);
        turns_next = Some(!has_turned_next);
        exit = chosen;
    }
    first_turns_next
}

/// Returns the exit to the free triangle with the fewest free neighbors. Ties go to the triangle whose
/// neighbors have the fewest, unless swaps are avoided; then to the first.
///
/// All but the first exit need a swap.
fn most_isolated<const N: usize>(
    free: &FreeTriangles<'_>,
    exits: [u32; N],
    swaps: StripeSwaps,
) -> Option<u32> {
    let without_swap = if swaps == StripeSwaps::Never { 1 } else { N };
    let exits = exits.into_iter().take(without_swap);
    let open = exits.filter_map(|exit| free.free_entry_across(exit).map(|enter| (exit, enter / 3)));
    open.min_by_key(|&(_, triangle)| {
        let beyond = (3 * triangle..3 * triangle + 3).filter_map(|side| free.free_entry_across(side));
        let fewest_beyond = beyond.map(|enter| free.neighbor_count(enter / 3)).min();
        let tie = if swaps == StripeSwaps::Free { fewest_beyond } else { None };
        (free.neighbor_count(triangle), tie)
    })
    .map(|(exit, _)| exit)
}

#[cfg(test)]
mod tests {
    use crate::{StripOptions, stripify};
    use striata::mesh::{IndexedMesh, replay, shapes};
    use striata::simplify::build_sequence;

    fn cost(mesh: &IndexedMesh) -> (usize, usize) {
        cost_of(mesh, "stripe")
    }

    fn cost_of(mesh: &IndexedMesh, spec: &str) -> (usize, usize) {
        let options = StripOptions::default().with_stripifier(spec.parse().unwrap());
        let cost = stripify(mesh, &options).unwrap().cost();
        (cost.strip_count, cost.swap_count)
    }

    #[test]
    fn a_ribbon_is_one_strip_without_swaps() {
        assert_eq!(cost(&shapes::grid(9, 1)), (1, 0));
    }

    #[test]
    fn a_fan_is_one_strip_that_always_swaps() {
        // The first triangle and the last one do not turn; of the ten turns, only the first is free.
        assert_eq!(cost(&shapes::triangle_fan(12)), (1, 9));
    }

    #[test]
    fn the_neighbor_with_fewer_free_neighbors_comes_first() {
        // Left of the seed is a dead end, right of it a ribbon: one strip through the seed covers both.
        let triangles = vec![[0, 1, 2], [2, 1, 3], [2, 3, 4], [1, 0, 5]];
        assert_eq!(cost(&IndexedMesh::new(vec![[0.0; 3]; 6], triangles)).0, 1);
    }

    #[test]
    fn swaps_are_traded_for_strips() {
        let refinable = build_sequence(&shapes::terrain(80, 1), &Default::default()).unwrap().refinable;
        // An irregular mesh: half of the vertices have collapsed.
        let mesh = replay(&refinable, refinable.sequence.step_count() / 2);
        let [free, few, none] =
            ["stripe", "stripe:few-swaps", "stripe:no-swaps"].map(|spec| cost_of(&mesh, spec));
        assert!(free.0 <= few.0 && few.0 < none.0, "{free:?}, {few:?}, {none:?}");
        assert!(free.1 > few.1 && few.1 > none.1, "{free:?}, {few:?}, {none:?}");
        // What remains are strips whose first turn does not match the winding, whichever end comes first.
        assert!(none.1 < none.0 / 2, "{none:?}");
    }

    #[test]
    fn rows_of_a_patch_need_no_swaps() {
        // 30 rows of 50 squares: one strip per row.
        assert_eq!(cost_of(&shapes::grid(50, 30), "stripe:global"), (30, 0));
        let (local, global) =
            (cost(&shapes::terrain(40, 1)), cost_of(&shapes::terrain(40, 1), "stripe:global"));
        assert_eq!(global.0, 40);
        assert!(local.0 + local.1 > global.0 + global.1, "{local:?}, {global:?}");
    }
}
