//! Stripification by tunneling \[PS03\]: `tunnel`, and its predecessor `tunnel-static` \[Ste01\].
//!
//! Two strips become one along a tunnel: a path between their ends on which dashed and solid links alternate.
//! Swapping dashed and solid on the path joins the strips. Ends are tried in random order, each with its
//! shortest tunnel up to the maximum length, until no end has one; that length is the only parameter. The
//! search starts from any strips, or from none, in which case every link is a tunnel of length one.
//!
//! Differs: strip identities are not pushed along strips but derived from the steps of the tunnel
//! (`trace`). The first tunnels, of length one, are made without a search, the most urgent first
//! (`growth`). A triangle counts as visited along one path, not in the whole search. Ends without a tunnel
//! are moved and tried again, once. The static variant has all of this except the last, so that it shows
//! what dynamic identities are worth.
//!
//! Cost: a search sees at most about `2^(length / 2)` ends, usually a few dozen; a tunnel renumbers the
//! strips that it crosses. 30 bytes per triangle.

mod growth;
mod location_table;
mod search;
mod trace;

pub(crate) use growth::join_ends;
pub(crate) use search::Identity;

use striata::mesh::Random;
use striata::strip::StripLinks;

use crate::task::{SpentFn, Task};
use location_table::LocationTable;
use search::Search;
use trace::Step;

/// How often the ends without a tunnel are moved at random before the search is given up.
///
/// On the bunny, tunnels of 17 links leave 165 strips without such a round, 99 with one, and 87 with two.
const MOVE_ROUND_COUNT: usize = 1;

/// Number of searches between two looks at the budget.
const SEARCHES_PER_CHECK: u64 = 256;

/// Applies tunnels until no end has one of at most `max_length` links, or the budget is spent.
pub(crate) fn run(
    task: &Task<'_>,
    links: &mut StripLinks<'_>,
    max_length: u32,
    identity: Identity,
    spent: &mut SpentFn<'_>,
) {
    let mut random = Random::new(task.options.seed);
    join_ends(&ends_of(task, links), links, &mut random);
    let mut ends = shuffled_ends(task, links, &mut random);
    let move_rounds = if identity == Identity::Dynamic { MOVE_ROUND_COUNT } else { 0 };
    let locations = LocationTable::new(links);
    let search = Search::new(links.triangle_count(), max_length, identity);
    let mut joiner = TunnelJoiner { links, locations, search, random, search_count: 0 };
    for moves_left in (0..=move_rounds).rev() {
        loop {
            let Some(found_count) = joiner.apply_tunnels(&ends, spent) else { return };
            if found_count == 0 {
                break;
            }
            ends = shuffled_ends(task, joiner.links, &mut joiner.random);
        }
        if moves_left > 0 {
            if !joiner.move_ends(&ends, spent) {
                return;
            }
            ends = shuffled_ends(task, joiner.links, &mut joiner.random);
        }
    }
}

/// Returns the triangles at which strips end.
pub(crate) fn ends_of(task: &Task<'_>, links: &StripLinks<'_>) -> Vec<u32> {
    let is_end = |&t: &u32| links.solid_degree(t) < 2 && task.is_proper(t);
    (0..links.triangle_count() as u32).filter(is_end).collect()
}

/// Returns the triangles at which strips end, in random order.
pub(crate) fn shuffled_ends(task: &Task<'_>, links: &StripLinks<'_>, random: &mut Random) -> Vec<u32> {
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
    search: Search,
    random: Random,
    search_count: u64,
}

impl TunnelJoiner<'_, '_> {
    /// Applies all tunnels found from these ends. Returns their number, or [`None`] when the budget is spent.
    fn apply_tunnels(&mut self, ends: &[u32], spent: &mut SpentFn<'_>) -> Option<usize> {
        let mut found_count = 0;
        for &end in ends {
            while self.links.solid_degree(end) < 2 {
                self.search_count += 1;
                if self.search_count.is_multiple_of(SEARCHES_PER_CHECK) && spent(self.search_count) >= 1.0 {
                    return None;
                }
                let Some(last) = self.search.find(end, self.links, &self.locations, &mut self.random) else {
                    break;
                };
                swap_links(self.search.steps(), Some(last), self.links);
                self.locations.renumber(self.search.steps(), Some(last), self.links);
                found_count += 1;
            }
        }
        Some(found_count)
    }

    /// Moves every end that has no tunnel to a random triangle that a search from it reaches. The number of
    /// strips stays the same. Returns whether some of the budget is left.
    fn move_ends(&mut self, ends: &[u32], spent: &mut SpentFn<'_>) -> bool {
        for (index, &end) in ends.iter().enumerate() {
            if index % SEARCHES_PER_CHECK as usize == 0 && spent(self.search_count) >= 1.0 {
                return false;
            }
            let is_end = self.links.solid_degree(end) < 2;
            if is_end && self.search.find(end, self.links, &self.locations, &mut self.random).is_none() {
                self.search.pick_move(&mut self.random);
                swap_links(self.search.steps(), None, self.links);
                self.locations.renumber(self.search.steps(), None, self.links);
            }
        }
        true
    }
}

/// Swaps dashed and solid links along a tunnel.
///
/// Without a last link, this moves an end instead of joining two strips.
fn swap_links(steps: &[Step], last: Option<u32>, links: &mut StripLinks<'_>) {
    for step in steps {
        links.cut(step.cut);
    }
    for side in steps.iter().map(|step| step.crossed).chain(last) {
        links.join(side);
    }
}
