//! SGI's `tomesh`, as \[ESV96, 2\] describes it: greedy strips that leave few triangles isolated.
//!
//! A strip begins at the triangle with the fewest free neighbors, and continues to the neighbor that has the
//! fewest free neighbors itself. A tie is broken by looking one triangle further; the first neighbor wins the
//! ties that remain. The strip ends when no neighbor is free. Swaps cost nothing here, because the graphics
//! library that it was written for had a command for them. Linear in time.

use striata::strip::{FreeTriangles, Seeds, StripLinks};

/// Joins the isolated triangles of a mesh into strips.
///
/// # Panics
/// If `triangles` are not those of the links' graph.
pub fn join_like_tomesh(triangles: &[[u32; 3]], links: &mut StripLinks<'_>) {
    let mut free = FreeTriangles::new(triangles, links);
    let mut seeds = Seeds::new(&free, 0..triangles.len());
    while let Some(seed) = seeds.pop(&free) {
        let mut last = seed;
        free.mark_used(last);
        seeds.push_around(last, &free);
        while let Some(exit) = exit_to_most_isolated(last, &free) {
            last = links.twins()[exit as usize] / 3;
            links.join(exit);
            free.mark_used(last);
            seeds.push_around(last, &free);
        }
    }
}

/// Returns the side that leads to the free neighbor with the fewest free neighbors, then with the neighbor
/// that has the fewest.
fn exit_to_most_isolated(triangle: u32, free: &FreeTriangles<'_>) -> Option<u32> {
    let sides = |of: u32| 3 * of..3 * of + 3;
    let fewest_beyond = |of: u32| {
        let beyond = sides(of).filter_map(|side| free.free_entry_across(side));
        beyond.map(|enter| free.neighbor_count(enter / 3)).min()
    };
    let exits = sides(triangle).filter_map(|exit| Some((exit, free.free_entry_across(exit)? / 3)));
    exits.min_by_key(|&(_, next)| (free.neighbor_count(next), fewest_beyond(next))).map(|(exit, _)| exit)
}
