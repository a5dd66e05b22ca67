//! STRIPE: each strip continues to the neighbor that has the fewest free neighbors left.
//!
//! A strip starts at a free triangle of least degree and grows from both ends, always to the neighbor of
//! least degree. Ties go to the triangle whose own neighbors have the fewest free neighbors, then to the
//! one that needs no swap. Few triangles end up isolated this way; the price is swaps. This is the classic
//! baseline for the number of strips.
//!
//! \[ESV96, the local algorithm\]. Differs: strips grow from both ends, and the global step before it, which
//! cuts patches of quadrilaterals out of the mesh, is left out, because triangulated scans have none.
//! Linear in time and memory.

use striata::strip::{FreeTriangles, Seeds, StripLinks, next_side, prev_side};
use striata::{Cancelled, Progress, ProgressFn};

use crate::task::Task;

/// Number of strips between two calls of the progress callback.
const STRIPS_PER_REPORT: u64 = 1 << 10;

/// Joins isolated triangles into strips; existing strips stay as they are.
pub(crate) fn run(
    task: &Task<'_>,
    links: &mut StripLinks<'_>,
    progress: &mut ProgressFn<'_>,
) -> Result<(), Cancelled> {
    let mut free = FreeTriangles::new(task.triangles, links);
    let mut strip = Vec::new();
    let (mut strip_count, mut done, total) = (0u64, 0, task.triangles.len() as u64);
    for group in task.groups {
        let mut seeds = Seeds::new(&free, group.clone());
        while let Some(seed) = seeds.pop(&free) {
            if strip_count.is_multiple_of(STRIPS_PER_REPORT) {
                Progress { phase: "strip", done, total }.report(progress)?;
            }
            grow(seed, &mut free, &mut strip, links);
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
fn grow(seed: u32, free: &mut FreeTriangles<'_>, strip: &mut Vec<u32>, links: &mut StripLinks<'_>) {
    strip.clear();
    free.mark_used(seed);
    strip.push(seed);
    let Some(exit) = most_isolated(free, [3 * seed, 3 * seed + 1, 3 * seed + 2]) else { return };
    let first_turns_next = walk(exit, false, free, strip, links);
    // The seed has to turn the other way than the triangle after it; seen from behind, that is the same way.
    let (straight, turned) = if first_turns_next {
        (next_side(exit), prev_side(exit))
    } else {
        (prev_side(exit), next_side(exit))
    };
    if let Some(back) = most_isolated(free, [straight, turned]) {
        walk(back, back == prev_side(exit), free, strip, links);
    }
}

/// Joins triangles from `exit` on until none is free. Returns whether the first of them turned to its next
/// side.
///
/// `turns_next` says which turn of the first triangle needs no swap.
fn walk(
    mut exit: u32,
    mut turns_next: bool,
    free: &mut FreeTriangles<'_>,
    strip: &mut Vec<u32>,
    links: &mut StripLinks<'_>,
) -> bool {
    let mut first_turns_next = None;
    while let Some(enter) = free.free_entry_across(exit) {
        links.join(exit);
        free.mark_used(enter / 3);
        strip.push(enter / 3);
        let (straight, turned) = if turns_next {
            (next_side(enter), prev_side(enter))
        } else {
            (prev_side(enter), next_side(enter))
        };
        let Some(chosen) = most_isolated(free, [straight, turned]) else { break };
        turns_next = chosen != next_side(enter);
        first_turns_next.get_or_insert(!turns_next);
        exit = chosen;
    }
    first_turns_next.unwrap_or(turns_next)
}

/// Returns the exit to the free triangle with the fewest free neighbors; the first one wins a tie.
fn most_isolated<const N: usize>(free: &FreeTriangles<'_>, exits: [u32; N]) -> Option<u32> {
    let open =
        exits.into_iter().filter_map(|exit| free.free_entry_across(exit).map(|enter| (exit, enter / 3)));
    open.min_by_key(|&(_, triangle)| {
        let free_entry_across =
            (3 * triangle..3 * triangle + 3).filter_map(|side| free.free_entry_across(side));
        (free.neighbor_count(triangle), free_entry_across.map(|enter| free.neighbor_count(enter / 3)).min())
    })
    .map(|(exit, _)| exit)
}

#[cfg(test)]
mod tests {
    use crate::{StripOptions, Stripifier, stripify};
    use striata::mesh::{IndexedMesh, shapes};

    fn cost(mesh: &IndexedMesh) -> (usize, usize) {
        let options = StripOptions::default().with_stripifier(Stripifier::Stripe);
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
}
