//! The search for tunnels around one triangle, priced.
//!
//! A tunnel from the end `t` of a strip is a chain of moves: `t` takes a neighbor `x`, which lets one of its own
//! neighbors `b` go, and `b` is the next end; a last move joins the end to another strip's. Each move leaves proper
//! strips, so chains are tried on the links themselves, the cheapest first, and the one that leaves least of
//! `swap weight * swaps + strip weight * strips` stays. Where `x` is in the strip of `t`, the neighbor
//! between them must go, or a loop would close \[PS03, 3.1\]; who is in whose strip is found by walking it.
//!
//! ```text
//!      t   p===x===q          t===x   p   q        t - x joined, x = p cut: p is the next end;
//!          |       |    ->        |                 or x = q cut, and q is
//! ```
//!
//! Differs: \[PS03\] numbers strips and keeps stacks of numbers to undo; here links are what they are, and a walk of
//! bounded length answers. \[Ste01\] and \[PS03\] count strips only.
//!
//! Cost: at most [`RepairOptions::search_limit`](super::RepairOptions) chains, each with one walk.

use striata::mesh::NO_TWIN;
use striata::strip::{StripLinks, Turn};

use super::options::{RepairGoal, RepairOptions};

/// What a swap and a strip weigh.
///
/// For fewest indices a strip weighs three swaps, two indices and its restart, and a quarter more: about every
/// fourth strip can begin at neither end without a parity fix.
#[derive(Clone, Copy, Debug)]
struct Weights {
    strip: i32,
    swap: i32,
}

/// The state after a chain of moves: the last move, and the one before it.
#[derive(Clone, Copy, Debug)]
struct Chain {
    parent: u32,
    /// Side of the link that the last move joined, [`NO_TWIN`] for none.
    joined: u32,
    /// Side of the link that it cut, [`NO_TWIN`] for none.
    cut: u32,
    /// The end that the chain may go on from, [`NO_TWIN`] after a last move.
    end: u32,
    /// What all its moves cost.
    cost: i32,
    move_count: u32,
    /// Whether the search may go on from it and has not yet.
    is_open: bool,
}

/// A move that a chain may make next.
#[derive(Clone, Copy, Debug)]
struct Move {
    joined: u32,
    /// The triangle beyond the link that is joined.
    taken: u32,
    /// [`NO_TWIN`] where `taken` is an end, and the move the last.
    cut: u32,
    end: u32,
    /// Of the whole chain.
    cost: i32,
    /// The side by which a walk from the moving end enters `taken`, where it is in the same strip.
    facing: Option<u32>,
}

/// What a search changed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Found {
    /// Whether the strips are cheaper now, and not only other.
    pub(super) is_gain: bool,
    pub(super) joined_count: usize,
    pub(super) cut_count: usize,
}

/// Scratch memory of searches.
#[derive(Clone, Debug)]
pub(super) struct TunnelSearch {
    weights: Weights,
    move_limit: u32,
    chain_limit: usize,
    walk_limit: u32,
    chains: Vec<Chain>,
    /// The cheapest chain; 0, the beginning, until another is as cheap as what was there.
    best: u32,
    /// Chains whose moves the links show now, from the first move on.
    shown: Vec<u32>,
    path: Vec<u32>,
    /// Moves that the chain at hand may go on with.
    moves: Vec<Move>,
}

impl TunnelSearch {
    pub(super) fn new(options: &RepairOptions) -> Self {
        let weights = match options.goal {
            RepairGoal::FewestStrips => Weights { strip: 1_000, swap: 1 },
            RepairGoal::FewestIndices => Weights { strip: 13, swap: 4 },
        };
        Self {
            weights,
            move_limit: options.tunnel_length.div_ceil(2),
            chain_limit: options.search_limit.max(1) as usize,
            walk_limit: options.walk_limit,
            chains: Vec::new(),
            best: 0,
            shown: Vec::new(),
            path: Vec::new(),
            moves: Vec::new(),
        }
    }

    /// Looks for a tunnel from the end of a strip.
    pub(super) fn dig_from(&mut self, links: &mut StripLinks<'_>, end: u32) -> Option<Found> {
        debug_assert!(links.solid_degree(end) < 2, "triangle {end} is inside a strip");
        self.search(links, NO_TWIN, end, 0)
    }

    /// Looks for a tunnel from the triangle of a solid side that pays for cutting its link.
    pub(super) fn dig_through(&mut self, links: &mut StripLinks<'_>, cut: u32) -> Option<Found> {
        let cost = self.weights.strip - self.weights.swap * swaps_between(links, cut);
        self.search(links, cut, cut / 3, cost)
    }

    /// Begins with one chain, goes on with the cheapest that there is, leaves the links as the best chain has them.
    ///
    /// Where none is cheaper than what is there, the first that is as cheap is taken: ends that wander meet.
    fn search(&mut self, links: &mut StripLinks<'_>, cut: u32, end: u32, cost: i32) -> Option<Found> {
        self.chains.clear();
        self.shown.clear();
        self.best = 0;
        let is_open = self.move_limit > 0;
        self.chains.push(Chain { parent: 0, joined: NO_TWIN, cut, end, cost, move_count: 0, is_open });
        while self.chains[self.best as usize].cost > -self.weights.strip {
            let Some(next) = self.cheapest_open() else { break };
            self.chains[next as usize].is_open = false;
            self.show(links, next);
            self.extend(links, next);
        }
        let cost = self.chains[self.best as usize].cost;
        if self.best == 0 || cost > 0 {
            self.hide_from(links, 0);
            return None;
        }
        self.show(links, self.best);
        debug_assert!(self.passed().all(|t| !is_in_loop(links, t)), "a tunnel closed a loop");
        let mut found = Found { is_gain: cost < 0, ..Found::default() };
        for &chain in &self.shown {
            found.joined_count += usize::from(self.chains[chain as usize].joined != NO_TWIN);
            found.cut_count += usize::from(self.chains[chain as usize].cut != NO_TWIN);
        }
        Some(found)
    }

    fn cheapest_open(&self) -> Option<u32> {
        let open = (0..).zip(&self.chains).filter(|(_, chain)| chain.is_open);
        open.min_by_key(|(_, chain)| chain.cost).map(|(chain, _)| chain)
    }

    /// The triangles that the chain of the last search ends at and passes.
    pub(super) fn passed(&self) -> impl Iterator<Item = u32> {
        self.shown.iter().flat_map(|&chain| {
            let Chain { joined, cut, .. } = self.chains[chain as usize];
            [joined, cut].into_iter().filter(|&side| side != NO_TWIN).map(|side| side / 3)
        })
    }

    /// Brings the links to what they are after a chain.
    fn show(&mut self, links: &mut StripLinks<'_>, chain: u32) {
        self.path.clear();
        let mut at = chain;
        loop {
            self.path.push(at);
            if at == 0 {
                break;
            }
            at = self.chains[at as usize].parent;
        }
        self.path.reverse();
        let kept = self.path.iter().zip(&self.shown).take_while(|(a, b)| a == b).count();
        self.hide_from(links, kept);
        for &at in &self.path[kept..] {
            let Chain { joined, cut, .. } = self.chains[at as usize];
            if cut != NO_TWIN {
                links.cut(cut);
            }
            if joined != NO_TWIN {
                links.join(joined);
            }
            self.shown.push(at);
        }
    }

    /// Undoes the last moves that are shown, so that `kept` stay.
    fn hide_from(&mut self, links: &mut StripLinks<'_>, kept: usize) {
        for at in self.shown.drain(kept..).rev() {
            let Chain { joined, cut, .. } = self.chains[at as usize];
            if joined != NO_TWIN {
                links.cut(joined);
            }
            if cut != NO_TWIN {
                links.join(cut);
            }
        }
    }

    /// Adds the chains that go one move further than this one, which is shown.
    fn extend(&mut self, links: &mut StripLinks<'_>, parent: u32) {
        self.propose(links, parent);
        if self.moves.is_empty() {
            return;
        }
        let Chain { end, move_count, .. } = self.chains[parent as usize];
        let is_whole = self.walk_from(links, end);
        for i in 0..self.moves.len() {
            let Move { joined, cut, end, cost, facing, .. } = self.moves[i];
            let is_loose = links.solid_degree(links.twins()[joined as usize] / 3) == 2;
            let is_proper = match facing {
                Some(facing) => facing == cut,
                None => is_whole && (is_loose || cut == NO_TWIN),
            };
            if is_proper && self.chains.len() < self.chain_limit {
                if cost < self.chains[self.best as usize].cost || (self.best == 0 && cost == 0) {
                    self.best = self.chains.len() as u32;
                }
                let is_open = end != NO_TWIN;
                self.chains.push(Chain {
                    parent,
                    joined,
                    cut,
                    end,
                    cost,
                    move_count: move_count + 1,
                    is_open,
                });
            }
        }
    }

    /// Lists the moves from the end of a chain that are worth a walk.
    fn propose(&mut self, links: &mut StripLinks<'_>, parent: u32) {
        self.moves.clear();
        let Chain { end, cut: came_from, cost, move_count, .. } = self.chains[parent as usize];
        let best_cost = self.chains[self.best as usize].cost;
        let goes_on = move_count + 1 < self.move_limit;
        for joined in 3 * end..3 * end + 3 {
            let entered = links.twins()[joined as usize];
            if entered == NO_TWIN || links.is_solid(joined) || joined == came_from || entered == came_from {
                continue;
            }
            let taken = entered / 3;
            if links.solid_degree(taken) < 2 {
                let cost = cost + self.price_of_join(links, joined);
                if cost < best_cost {
                    self.moves.push(Move { joined, taken, cut: NO_TWIN, end: NO_TWIN, cost, facing: None });
                }
            }
            let solid = links.solid_bits(taken);
            for cut in (3 * taken..3 * taken + 3).filter(|side| goes_on && solid & 1 << (side % 3) != 0) {
                let end = links.twins()[cut as usize] / 3;
                let cost = cost + self.price_of_slide(links, joined, cut);
                let is_known = |other: &Chain| other.end == end && other.cost <= cost;
                if cost < self.weights.strip && !self.chains.iter().any(is_known) {
                    self.moves.push(Move { joined, taken, cut, end, cost, facing: None });
                }
            }
        }
    }

    /// Walks the strip of an end until it has met all triangles that the moves take, and notes where it enters
    /// them; whether it met all or came to the strip's other end.
    fn walk_from(&mut self, links: &StripLinks<'_>, end: u32) -> bool {
        // An end has three neighbors at most.
        let mut sought = [NO_TWIN; 3];
        let mut sought_count = 0;
        for taken in self.moves.iter().map(|other| other.taken) {
            if !sought[..sought_count].contains(&taken) {
                sought[sought_count] = taken;
                sought_count += 1;
            }
        }
        let [a, b, c] = sought;
        let mut exit = links.first_solid(end);
        for _ in 0..self.walk_limit {
            let Some(side) = exit else { return true };
            let entered = links.twins()[side as usize];
            let triangle = entered / 3;
            if triangle == a || triangle == b || triangle == c {
                self.moves.iter_mut().filter(|other| other.taken == triangle).for_each(|other| {
                    other.facing = Some(entered);
                });
                sought_count -= 1;
                if sought_count == 0 {
                    return true;
                }
            }
            let others = links.solid_bits(triangle) & !(1 << (entered - 3 * triangle));
            exit = (others != 0).then(|| 3 * triangle + others.trailing_zeros());
        }
        exit.is_none()
    }

    /// What it costs to join a link between two ends.
    fn price_of_join(&self, links: &mut StripLinks<'_>, side: u32) -> i32 {
        links.join(side);
        let after = swaps_between(links, side);
        links.cut(side);
        self.weights.swap * after - self.weights.strip
    }

    /// What it costs to join a link from an end to a triangle and to cut another one there.
    fn price_of_slide(&self, links: &mut StripLinks<'_>, joined: u32, cut: u32) -> i32 {
        let before = swaps_between(links, cut);
        links.cut(cut);
        links.join(joined);
        let after = swaps_between(links, joined);
        links.cut(joined);
        links.join(cut);
        self.weights.swap * (after - before)
    }
}

/// Swaps of a solid link: 1 where its two sides turn differently.
#[inline]
pub(super) fn swap_at(links: &StripLinks<'_>, side: u32) -> i32 {
    let (here, there) = (links.turn(side), links.turn(links.twins()[side as usize]));
    i32::from(here != Turn::End && there != Turn::End && here != there)
}

/// Swaps of a solid link and of those next to it, all that its triangles take part in.
#[inline]
fn swaps_between(links: &StripLinks<'_>, side: u32) -> i32 {
    let beyond = |side: u32| links.other_solid(side).map_or(0, |other| swap_at(links, other));
    swap_at(links, side) + beyond(side) + beyond(links.twins()[side as usize])
}

/// Whether the strip of a triangle comes back to it.
fn is_in_loop(links: &StripLinks<'_>, triangle: u32) -> bool {
    links.first_solid(triangle).is_some_and(|side| links.end_beyond(side) == triangle)
}
