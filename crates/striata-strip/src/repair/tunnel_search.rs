//! Search for tunnels around one triangle, weighted by their cost in indices.
//!
//! A tunnel from the end `t` of a strip is a chain of moves: `t` takes a neighbor `x`, which releases one
//! of its own neighbors `b`, and `b` is the next end; the last move joins the end to another strip's. Every
//! move leaves valid strips, so chains are tried on the links themselves, the cheapest first, and the one
//! with the least `swap weight * swaps + strip weight * strips` is kept. If `x` is in the strip of `t`, it
//! must release the neighbor between them, or a loop would close \[PS03, 3.1\]. Walking the strip finds out
//! which case applies.
//!
//! ```text
//!      t   p===x===q          t===x   p   q        t - x joined, x = p cut: p is the next end;
//!          |       |    ->        |                 or x = q cut, and q is
//! ```
//!
//! Differs: \[PS03\] numbers strips and keeps stacks of numbers to undo; here the links are changed
//! directly, and a walk of limited length replaces the numbers. \[Ste01\] and \[PS03\] only count strips.
//!
//! Cost: at most [`RepairOptions::search_limit`](super::RepairOptions) chains, each with one walk.

use striata::mesh::NO_TWIN;
use striata::strip::{StripLinks, Turn};

use super::options::{RepairGoal, RepairOptions};

/// Weights of a swap and a strip.
///
/// For fewest indices, a strip weighs three swaps (two indices and its restart) and a quarter more, because
/// about every fourth strip needs a parity fix whichever end it begins with.
#[derive(Clone, Copy, Debug)]
struct IndexWeights {
    strip: i32,
    swap: i32,
}

/// Chain of moves, stored as its last move and a reference to the chain before it.
#[derive(Clone, Copy, Debug)]
struct MoveChain {
    parent: u32,
    /// Side of the link that the last move joined, or [`NO_TWIN`].
    joined: u32,
    /// Side of the link that the last move cut, or [`NO_TWIN`].
    cut: u32,
    /// End from which the chain may continue, or [`NO_TWIN`] after a final move.
    end: u32,
    /// Total cost of its moves.
    cost: i32,
    move_count: u32,
    /// Whether the search still has to extend this chain.
    is_open: bool,
}

/// Possible next move of a chain.
#[derive(Clone, Copy, Debug)]
struct ChainMove {
    joined: u32,
    /// Triangle beyond the link that is joined.
    taken: u32,
    /// Side of the link that is cut, or [`NO_TWIN`] if `taken` is an end and this is the final move.
    cut: u32,
    end: u32,
    /// Total cost of the extended chain.
    cost: i32,
    /// Side by which a walk from the moving end enters `taken`, if both are in the same strip.
    entered_by: Option<u32>,
}

/// Changes made by a search.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct TunnelChange {
    /// Whether the strips are cheaper now, and not only different.
    pub is_gain: bool,
    pub joined_count: usize,
    pub cut_count: usize,
}

/// Reusable state of searches.
#[derive(Clone, Debug)]
pub(super) struct TunnelSearch {
    weights: IndexWeights,
    move_limit: u32,
    chain_limit: usize,
    walk_limit: u32,
    chains: Vec<MoveChain>,
    /// Index of the cheapest chain; 0 (the start) until another is at least as cheap as the original strips.
    best: u32,
    /// Chains whose moves are currently applied to the links, in order.
    applied: Vec<u32>,
    path: Vec<u32>,
    /// Possible moves of the current chain.
    moves: Vec<ChainMove>,
}

impl TunnelSearch {
    pub(super) fn new(options: &RepairOptions) -> Self {
        let weights = match options.goal {
            RepairGoal::FewestStrips => IndexWeights { strip: 1_000, swap: 1 },
            RepairGoal::FewestIndices => IndexWeights { strip: 13, swap: 4 },
        };
        Self {
            weights,
            move_limit: options.tunnel_length.div_ceil(2),
            chain_limit: options.search_limit.max(1) as usize,
            walk_limit: options.walk_limit,
            chains: Vec::new(),
            best: 0,
            applied: Vec::new(),
            path: Vec::new(),
            moves: Vec::new(),
        }
    }

    /// Searches for a tunnel from the end of a strip.
    pub(super) fn search_from_end(&mut self, links: &mut StripLinks<'_>, end: u32) -> Option<TunnelChange> {
        debug_assert!(links.solid_degree(end) < 2, "triangle {end} is inside a strip");
        self.search(links, NO_TWIN, end, 0)
    }

    /// Searches for a tunnel from the triangle of a solid side that pays for cutting its link.
    pub(super) fn search_across(&mut self, links: &mut StripLinks<'_>, cut: u32) -> Option<TunnelChange> {
        let cost = self.weights.strip - self.weights.swap * swaps_between(links, cut);
        self.search(links, cut, cut / 3, cost)
    }

    /// Extends the cheapest chain repeatedly, and leaves the links as the best chain has them.
    ///
    /// If none is cheaper than the original strips, the first one of equal cost is applied: strip ends that
    /// keep moving eventually meet others.
    fn search(&mut self, links: &mut StripLinks<'_>, cut: u32, end: u32, cost: i32) -> Option<TunnelChange> {
        self.chains.clear();
        self.applied.clear();
        self.best = 0;
        let is_open = self.move_limit > 0;
        self.chains.push(MoveChain { parent: 0, joined: NO_TWIN, cut, end, cost, move_count: 0, is_open });
        while self.chains[self.best as usize].cost > -self.weights.strip {
            let Some(next) = self.cheapest_open() else { break };
            self.chains[next as usize].is_open = false;
            self.apply(links, next);
            self.extend(links, next);
        }
        let cost = self.chains[self.best as usize].cost;
        if self.best == 0 || cost > 0 {
            self.undo_to(links, 0);
            return None;
        }
        self.apply(links, self.best);
        debug_assert!(self.touched_triangles().all(|t| !is_in_loop(links, t)), "a tunnel closed a loop");
        let mut found = TunnelChange { is_gain: cost < 0, ..TunnelChange::default() };
        for &chain in &self.applied {
            found.joined_count += usize::from(self.chains[chain as usize].joined != NO_TWIN);
            found.cut_count += usize::from(self.chains[chain as usize].cut != NO_TWIN);
        }
        Some(found)
    }

    /// Returns the cheapest chain that has not been extended yet.
    fn cheapest_open(&self) -> Option<u32> {
        let open = (0..).zip(&self.chains).filter(|(_, chain)| chain.is_open);
        open.min_by_key(|(_, chain)| chain.cost).map(|(chain, _)| chain)
    }

    /// Iterates over the triangles from which the last search changed links.
    pub(super) fn touched_triangles(&self) -> impl Iterator<Item = u32> {
        self.touched_sides().map(|side| side / 3)
    }

    /// Iterates over the links that the last search changed, each as one of its sides.
    pub(super) fn touched_sides(&self) -> impl Iterator<Item = u32> {
        self.applied.iter().flat_map(|&chain| {
            let MoveChain { joined, cut, .. } = self.chains[chain as usize];
            [joined, cut].into_iter().filter(|&side| side != NO_TWIN)
        })
    }

    /// Applies the moves of a chain to the links.
    fn apply(&mut self, links: &mut StripLinks<'_>, chain: u32) {
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
        let kept = self.path.iter().zip(&self.applied).take_while(|(a, b)| a == b).count();
        self.undo_to(links, kept);
        for &at in &self.path[kept..] {
            let MoveChain { joined, cut, .. } = self.chains[at as usize];
            if cut != NO_TWIN {
                links.cut(cut);
            }
            if joined != NO_TWIN {
                links.join(joined);
            }
            self.applied.push(at);
        }
    }

    /// Undoes the last applied moves until `kept` are left.
    fn undo_to(&mut self, links: &mut StripLinks<'_>, kept: usize) {
        for at in self.applied.drain(kept..).rev() {
            let MoveChain { joined, cut, .. } = self.chains[at as usize];
            if joined != NO_TWIN {
                links.cut(joined);
            }
            if cut != NO_TWIN {
                links.join(cut);
            }
        }
    }

    /// Adds the chains that extend this one by one move; its moves must be applied.
    fn extend(&mut self, links: &mut StripLinks<'_>, parent: u32) {
        self.list_moves(links, parent);
        if self.moves.is_empty() {
            return;
        }
        let MoveChain { end, move_count, .. } = self.chains[parent as usize];
        let is_whole = self.walk_from(links, end);
        for i in 0..self.moves.len() {
            let ChainMove { joined, cut, end, cost, entered_by, .. } = self.moves[i];
            let has_two_links = links.solid_degree(links.twins()[joined as usize] / 3) == 2;
            let is_proper = match entered_by {
                Some(entered_by) => entered_by == cut,
                None => is_whole && (has_two_links || cut == NO_TWIN),
            };
            if is_proper && self.chains.len() < self.chain_limit {
                if cost < self.chains[self.best as usize].cost || (self.best == 0 && cost == 0) {
                    self.best = self.chains.len() as u32;
                }
                let is_open = end != NO_TWIN;
                self.chains.push(MoveChain {
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

    /// Lists the moves from the end of a chain that are worth checking with a walk.
    fn list_moves(&mut self, links: &mut StripLinks<'_>, parent: u32) {
        self.moves.clear();
        let MoveChain { end, cut: came_from, cost, move_count, .. } = self.chains[parent as usize];
        let best_cost = self.chains[self.best as usize].cost;
        let goes_on = move_count + 1 < self.move_limit;
        for joined in 3 * end..3 * end + 3 {
            let entered = links.twins()[joined as usize];
            if entered == NO_TWIN || links.is_solid(joined) || joined == came_from || entered == came_from {
                continue;
            }
            let taken = entered / 3;
            if links.solid_degree(taken) < 2 {
                let cost = cost + self.cost_of_join(links, joined);
                if cost < best_cost {
                    self.moves.push(ChainMove {
                        joined,
                        taken,
                        cut: NO_TWIN,
                        end: NO_TWIN,
                        cost,
                        entered_by: None,
                    });
                }
            }
            let solid = links.solid_bits(taken);
            for cut in (3 * taken..3 * taken + 3).filter(|side| goes_on && solid & 1 << (side % 3) != 0) {
                let end = links.twins()[cut as usize] / 3;
                let cost = cost + self.cost_of_move(links, joined, cut);
                let is_dominated = |other: &MoveChain| other.end == end && other.cost <= cost;
                if cost < self.weights.strip && !self.chains.iter().any(is_dominated) {
                    self.moves.push(ChainMove { joined, taken, cut, end, cost, entered_by: None });
                }
            }
        }
    }

    /// Walks the strip of an end until it has met all triangles that the moves take, and records the sides
    /// by which it enters them. Returns whether it met all of them or reached the strip's other end.
    fn walk_from(&mut self, links: &StripLinks<'_>, end: u32) -> bool {
        // An end has at most three neighbors.
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
                    other.entered_by = Some(entered);
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

    /// Cost of joining a link between two ends.
    fn cost_of_join(&self, links: &mut StripLinks<'_>, side: u32) -> i32 {
        links.join(side);
        let after = swaps_between(links, side);
        links.cut(side);
        self.weights.swap * after - self.weights.strip
    }

    /// Cost of joining a link from an end to a triangle and cutting another link there.
    fn cost_of_move(&self, links: &mut StripLinks<'_>, joined: u32, cut: u32) -> i32 {
        let before = swaps_between(links, cut);
        links.cut(cut);
        links.join(joined);
        let after = swaps_between(links, joined);
        links.cut(joined);
        links.join(cut);
        self.weights.swap * (after - before)
    }
}

/// Number of swaps across a solid link: 1 if the strip turns differently on its two sides.
#[inline]
pub(super) fn swap_at(links: &StripLinks<'_>, side: u32) -> i32 {
    let (here, there) = (links.turn(side), links.turn(links.twins()[side as usize]));
    i32::from(here != Turn::End && there != Turn::End && here != there)
}

/// Number of swaps across a solid link and the links next to it, all that its triangles take part in.
#[inline]
fn swaps_between(links: &StripLinks<'_>, side: u32) -> i32 {
    let beyond = |side: u32| links.other_solid(side).map_or(0, |other| swap_at(links, other));
    swap_at(links, side) + beyond(side) + beyond(links.twins()[side as usize])
}

/// Whether the strip of a triangle returns to it.
fn is_in_loop(links: &StripLinks<'_>, triangle: u32) -> bool {
    links.first_solid(triangle).is_some_and(|side| links.end_beyond(side) == triangle)
}
