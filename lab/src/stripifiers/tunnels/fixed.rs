//! Tunnels with static identities \[Ste01\]: the strips that a search sees are those of its beginning.

use striata::mesh::{NO_TWIN, Random};
use striata::strip::{StripLinks, next_side, prev_side};

use super::options::{FindTunnels, TunnelOptions};
use super::path_search::{PathSearch, PathStep};

/// Search that changes nothing until it has found a tunnel.
pub(super) struct StaticTunnels {
    search: PathSearch,
    /// For each triangle: the identity of its strip, and its index within the strip.
    places: Vec<(u32, u32)>,
    next_identity: u32,
    loop_count: usize,
}

impl StaticTunnels {
    pub(super) fn new(links: &StripLinks<'_>, options: &TunnelOptions) -> Self {
        let count = links.triangle_count();
        let search = PathSearch::new(count, options);
        let mut tunnels =
            Self { search, places: vec![(u32::MAX, 0); count], next_identity: 0, loop_count: 0 };
        for end in 0..count as u32 {
            if links.solid_degree(end) < 2 && tunnels.places[end as usize].0 == u32::MAX {
                tunnels.number_strip(end, links);
            }
        }
        tunnels
    }

    /// Gives the strip of an end a new identity.
    fn number_strip(&mut self, end: u32, links: &StripLinks<'_>) {
        let identity = self.next_identity;
        self.next_identity += 1;
        let mut index = 0;
        self.places[end as usize] = (identity, index);
        let mut exit = links.first_solid(end);
        while let Some(side) = exit {
            let entered = links.twins()[side as usize];
            index += 1;
            self.places[entered as usize / 3] = (identity, index);
            exit = links.other_solid(entered);
        }
    }

    /// Crosses a link from the moving end of the current node. Returns true if that completes a tunnel;
    /// otherwise adds the next nodes.
    fn cross(&mut self, crossed: u32, node: usize, links: &StripLinks<'_>) -> bool {
        let entered = links.twins()[crossed as usize];
        if entered == NO_TWIN || links.is_solid(crossed) || self.search.is_visited(entered / 3) {
            return false;
        }
        let (end, taken) = (crossed / 3, entered / 3);
        let [(end_identity, end_index), (identity, index)] = [end, taken].map(|t| self.places[t as usize]);
        let is_same = end_identity == identity;
        if !is_same && links.solid_degree(taken) < 2 {
            return true;
        }
        if !self.search.may_go_on() {
            return false;
        }
        for cut in [next_side(entered), prev_side(entered)].into_iter().filter(|&side| links.is_solid(side)) {
            let next = links.twins()[cut as usize] / 3;
            let is_toward_end = (self.places[next as usize].1 > index) == (end_index > index);
            if (!is_same || is_toward_end) && !self.search.is_visited(next) {
                self.search.push(node, PathStep { crossed, taken, cut, end: next });
            }
        }
        false
    }

    /// Complements the current path and its last link, unless that closes a loop. Returns whether it did.
    fn complement(&mut self, last: u32, links: &mut StripLinks<'_>) -> bool {
        let path = self.search.path();
        path.iter().for_each(|step| links.cut(step.cut));
        path.iter().for_each(|step| links.join(step.crossed));
        links.join(last);
        let joined = || path.iter().map(|step| step.crossed).chain([last]);
        if joined().any(|side| is_in_loop(side, links)) {
            joined().for_each(|side| links.cut(side));
            path.iter().for_each(|step| links.join(step.cut));
            self.loop_count += 1;
            return false;
        }
        let first_new = self.next_identity;
        let changed: Vec<u32> =
            joined().map(|side| side / 3).chain(path.iter().map(|step| step.taken)).collect();
        for triangle in changed {
            if self.places[triangle as usize].0 < first_new {
                let end = links.first_solid(triangle).map_or(triangle, |side| links.end_beyond(side));
                self.number_strip(end, links);
            }
        }
        true
    }
}

impl FindTunnels for StaticTunnels {
    fn set_max_length(&mut self, max_length: u32) {
        self.search.set_max_length(max_length);
    }

    fn apply_shortest(&mut self, start: u32, links: &mut StripLinks<'_>, random: &mut Random) -> bool {
        self.search.begin(start);
        let mut node = 0;
        while let Some(end) = self.search.enter(node) {
            let mut side = 3 * end + random.below(3);
            for _ in 0..3 {
                if self.cross(side, node, links) && self.complement(side, links) {
                    return true;
                }
                side = next_side(side);
            }
            node += 1;
        }
        false
    }

    fn loop_count(&self) -> usize {
        self.loop_count
    }
}

/// Whether the strip that crosses a solid side returns to it.
fn is_in_loop(side: u32, links: &StripLinks<'_>) -> bool {
    links.end_beyond(side) == side / 3
}
