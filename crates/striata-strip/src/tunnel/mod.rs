//! Stripification by tunneling \[PS03\].
//!
//! Two strips become one along a tunnel: a path between their ends on which dashed and solid links alternate.
//! Swapping dashed and solid on the path joins the strips. Ends are tried in random order, each with its
//! shortest tunnel up to the maximum length, until no end has one; that length is the only parameter. The
//! search starts from any strips, or from none, in which case every link is a tunnel of length one.
//!
//! Differs: strip identities are not pushed along strips but derived from the steps of the tunnel
//! (`trace`), with the same results. The first tunnels, of length one, are made without a search, the most urgent
//! first (`growth`). A triangle counts as visited along one path, not in the whole search. Beyond the paper, an
//! end without a tunnel is moved to the end of a random longest path that its search has seen, and searched from
//! again at once; this takes no more time and halves the number of strips, because other strips meet the end on
//! its way. `striata-lab/stripifiers` has the algorithm to the letter, and its predecessor with static identities
//! \[Ste01\].
//!
//! Cost: a search sees at most about `2^(length / 2)` ends, usually a few dozen; a tunnel renumbers the
//! strips that it crosses. 30 bytes per triangle.

mod growth;
mod location_table;
mod search;
#[cfg(test)]
mod tests;
mod trace;

pub(crate) use growth::join_ends;

use striata::mesh::Random;
use striata::strip::StripLinks;

use crate::task::{SpentFn, StripTask};
use location_table::LocationTable;
use search::TunnelPathSearch;
use trace::TunnelStep;

/// How often an end without a tunnel is moved before the next end gets its turn, in the first pass.
///
/// Strips that 17 links leave on the bunny, over ten seeds: 165 without moves, 84 with two, 61 with four, 52
/// with six, which take longer.
const MOVE_COUNT: u32 = 4;

/// Number of searches between two looks at the budget.
const SEARCHES_PER_CHECK: u64 = 256;

/// Applies tunnels until no end has one of at most `max_length` links, or the budget is spent.
pub(crate) fn run(
    task: &StripTask<'_>,
    links: &mut StripLinks<'_>,
    max_length: u32,
    spent: &mut SpentFn<'_>,
) {
    let mut random = Random::new(task.options.seed);
    join_ends(&ends_of(task, links), links, &mut random);
    let mut ends = shuffled_ends(task, links, &mut random);
    let locations = LocationTable::new(links);
    let search = TunnelPathSearch::new(links.triangle_count(), max_length);
    let mut joiner = TunnelJoiner { links, locations, search, random, search_count: 0 };
    let mut moves = MOVE_COUNT;
    while let Some(1..) = joiner.dig_from(&ends, moves, spent) {
        ends = shuffled_ends(task, joiner.links, &mut joiner.random);
        moves = 0;
    }
}

/// Returns the triangles at which strips end.
pub(crate) fn ends_of(task: &StripTask<'_>, links: &StripLinks<'_>) -> Vec<u32> {
    let is_end = |&t: &u32| links.solid_degree(t) < 2 && task.is_proper(t);
    (0..links.triangle_count() as u32).filter(is_end).collect()
}

/// Returns the triangles at which strips end, in random order.
fn shuffled_ends(task: &StripTask<'_>, links: &StripLinks<'_>, random: &mut Random) -> Vec<u32> {
    let mut ends = ends_of(task, links);
    for i in (1..ends.len()).rev() {
        ends.swap(i, random.below(i as u32 + 1) as usize);
    }
    ends
}

/// Strips being joined, and the state of the search.
struct TunnelJoiner<'a, 'g> {
    links: &'a mut StripLinks<'g>,
    locations: LocationTable,
    search: TunnelPathSearch,
    random: Random,
    search_count: u64,
}

impl TunnelJoiner<'_, '_> {
    /// Digs from each of these ends. Returns the number of tunnels, or [`None`] when the budget is spent.
    fn dig_from(&mut self, ends: &[u32], moves: u32, spent: &mut SpentFn<'_>) -> Option<usize> {
        let mut tunnel_count = 0;
        for &end in ends {
            tunnel_count += self.dig(end, moves, spent)?;
        }
        Some(tunnel_count)
    }

    /// Joins a strip at one of its ends, as long as there are tunnels.
    ///
    /// An end without a tunnel is moved and searched from again, up to `moves` times. A move leaves the
    /// number of strips as it is.
    fn dig(&mut self, mut end: u32, mut moves: u32, spent: &mut SpentFn<'_>) -> Option<usize> {
        let mut tunnel_count = 0;
        while self.links.solid_degree(end) < 2 {
            self.search_count += 1;
            if self.search_count.is_multiple_of(SEARCHES_PER_CHECK) && spent(self.search_count) >= 1.0 {
                return None;
            }
            let last = self.search.find(end, self.links, &self.locations, &mut self.random);
            if last.is_some() {
                tunnel_count += 1;
            } else if moves > 0
                && let Some(moved) = self.search.pick_move(&mut self.random)
            {
                moves -= 1;
                end = moved;
            } else {
                break;
            }
            swap_links(self.search.steps(), last, self.links);
            self.locations.renumber(self.search.steps(), last, self.links);
        }
        Some(tunnel_count)
    }
}

/// Swaps dashed and solid links along a tunnel.
///
/// Without a last link, this moves an end instead of joining two strips.
fn swap_links(steps: &[TunnelStep], last: Option<u32>, links: &mut StripLinks<'_>) {
    for step in steps {
        links.cut(step.cut);
    }
    for side in steps.iter().map(|step| step.crossed).chain(last) {
        links.join(side);
    }
}
