//! Stripification by tunnelling \[PS03\]: `tunnel`, and its forerunner `tunnel-static` \[Ste01\].
//!
//! Two strips become one along a tunnel, a path of alternately dashed and solid links between their
//! ends whose links change places. Ends are tried in random order, each with the shortest tunnel that it
//! has within the longest length allowed, until no end has one: that length is the only parameter. It begins with
//! any strips, or with none, where every link is a tunnel of length one.
//!
//! Differs: identities are not pushed along strips but found from the tunnel's own steps (`trace`); the first
//! tunnels, of length one, are taken without a search and where they are most urgent (`growth`); a triangle counts as
//! visited along one path and not in the whole search; and ends without a tunnel are moved and tried again, once.
//! The static variant has all of this but the last, so that it shows what identities are worth.
//! Cost: a search sees at most about `2^(length / 2)` ends, usually a few dozen; a tunnel found renumbers the strips
//! that it crosses. 30 bytes a triangle.

mod growth;
mod places;
mod search;
mod trace;

pub(crate) use growth::join_ends;
pub(crate) use search::Identity;

use striata::mesh::Random;
use striata::strip::StripLinks;

use crate::task::{SpentFn, Task};
use places::PlaceTable;
use search::Search;
use trace::Step;

/// How often all ends that have no tunnel are moved at random before the search for tunnels is given up.
///
/// On the bunny, tunnels of 17 links leave 165 strips without such a move, 99 with one, 87 with two.
const MOVE_ROUNDS: usize = 1;

/// Tunnels until no end has one of at most `max_length` links, or the budget is spent.
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
    let move_rounds = if identity == Identity::Dynamic { MOVE_ROUNDS } else { 0 };
    let places = PlaceTable::new(links);
    let search = Search::new(links.triangle_count(), max_length, identity);
    let mut digger = Digger { links, places, search, random, search_count: 0 };
    for moves_left in (0..=move_rounds).rev() {
        loop {
            let Some(found_count) = digger.dig(&ends, spent) else { return };
            if found_count == 0 {
                break;
            }
            ends = shuffled_ends(task, digger.links, &mut digger.random);
        }
        if moves_left > 0 {
            digger.move_all(&ends);
            ends = shuffled_ends(task, digger.links, &mut digger.random);
        }
    }
}

/// The triangles at which strips end.
pub(crate) fn ends_of(task: &Task<'_>, links: &StripLinks<'_>) -> Vec<u32> {
    let is_end = |&t: &u32| links.solid_degree(t) < 2 && task.is_proper(t);
    (0..links.triangle_count() as u32).filter(is_end).collect()
}

/// The triangles at which strips end, in random order.
pub(crate) fn shuffled_ends(task: &Task<'_>, links: &StripLinks<'_>, random: &mut Random) -> Vec<u32> {
    let mut ends = ends_of(task, links);
    for i in (1..ends.len()).rev() {
        ends.swap(i, random.below(i as u32 + 1) as usize);
    }
    ends
}

/// Strips under change and what a search needs.
struct Digger<'a, 'g> {
    links: &'a mut StripLinks<'g>,
    places: PlaceTable,
    search: Search,
    random: Random,
    search_count: u64,
}

impl Digger<'_, '_> {
    /// Gives every end the tunnels that it has: how many were found, or none when the budget is spent.
    fn dig(&mut self, ends: &[u32], spent: &mut SpentFn<'_>) -> Option<usize> {
        let mut found_count = 0;
        for &end in ends {
            while self.links.solid_degree(end) < 2 {
                self.search_count += 1;
                if self.search_count.is_multiple_of(256) && spent(self.search_count) >= 1.0 {
                    return None;
                }
                let Some(last) = self.search.find(end, self.links, &self.places, &mut self.random) else {
                    break;
                };
                complement(self.search.steps(), Some(last), self.links);
                self.places.renumber(self.search.steps(), Some(last), self.links);
                found_count += 1;
            }
        }
        Some(found_count)
    }

    /// Moves every end that has no tunnel somewhere that a search from it comes to: as many strips as before, but
    /// other ones.
    fn move_all(&mut self, ends: &[u32]) {
        for &end in ends {
            let is_end = self.links.solid_degree(end) < 2;
            if is_end && self.search.find(end, self.links, &self.places, &mut self.random).is_none() {
                self.search.pick_move(&mut self.random);
                complement(self.search.steps(), None, self.links);
                self.places.renumber(self.search.steps(), None, self.links);
            }
        }
    }
}

/// Changes the links of a tunnel: dashed ones become solid, solid ones dashed.
///
/// Without a last link it moves an end instead of joining two strips.
fn complement(steps: &[Step], last: Option<u32>, links: &mut StripLinks<'_>) {
    for step in steps {
        links.cut(step.cut);
    }
    for side in steps.iter().map(|step| step.crossed).chain(last) {
        links.join(side);
    }
}
