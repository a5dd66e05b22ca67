//! The search for tunnels around one triangle, priced.
//!
//! A tunnel from the end `t` of a strip is a chain of moves: `t` takes a neighbour `x`, which lets one of its own
//! neighbours `b` go, and `b` is the next end; a last move joins the end to another strip's. Each move leaves proper
//! strips, so chains are tried on the links themselves, breadth first, and the cheapest that lowers
//! `swaps * swap weight + strips * strip weight` stays. Where `x` is in the strip of `t`, the neighbour
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

use super::options::{RepairGoal, RepairOptions};
use crate::mesh::NO_TWIN;
use crate::strip::StripLinks;
use crate::strip::links::Turn;

/// What an index and a strip weigh.
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
}

/// A neighbour of an end, and how the end's strip comes to it.
#[derive(Clone, Copy, Debug)]
struct Beside {
    exit: u32,
    triangle: u32,
    /// The side by which a walk from the end enters it, where it is in the same strip.
    facing: Option<u32>,
}

/// What a search changed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Found {
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
    /// Chains whose moves the links show now, from the first move on.
    shown: Vec<u32>,
    path: Vec<u32>,
}

impl TunnelSearch {
    pub(super) fn new(options: &RepairOptions) -> Self {
        let weights = match options.goal {
            RepairGoal::FewestStrips => Weights { strip: 1_000, swap: 1 },
            RepairGoal::FewestIndices => Weights { strip: 3, swap: 1 },
        };
        Self {
            weights,
            move_limit: options.tunnel_length.div_ceil(2),
            chain_limit: options.search_limit.max(1) as usize,
            walk_limit: options.walk_limit,
            chains: Vec::new(),
            shown: Vec::new(),
            path: Vec::new(),
        }
    }

    /// Looks for a tunnel from the end of a strip.
    pub(super) fn from_end(&mut self, links: &mut StripLinks<'_>, end: u32) -> Option<Found> {
        debug_assert!(links.solid_degree(end) < 2, "triangle {end} is inside a strip");
        self.search(links, Chain { parent: 0, joined: NO_TWIN, cut: NO_TWIN, end, cost: 0, move_count: 0 })
    }

    /// Cuts a solid link and looks for a tunnel from the triangle of its side that pays for it.
    pub(super) fn through_cut(&mut self, links: &mut StripLinks<'_>, cut: u32) -> Option<Found> {
        let cost = self.price_of_cut(links, cut);
        links.join(cut);
        self.search(links, Chain { parent: 0, joined: NO_TWIN, cut, end: cut / 3, cost, move_count: 0 })
    }

    fn search(&mut self, links: &mut StripLinks<'_>, start: Chain) -> Option<Found> {
        self.chains.clear();
        self.shown.clear();
        self.chains.push(start);
        let mut best = 0;
        let mut next = 0;
        while next < self.chains.len() {
            if self.chains[next].end != NO_TWIN && self.chains[next].move_count < self.move_limit {
                self.show(links, next as u32);
                self.extend(links, next as u32);
            }
            let cheapest = (best..self.chains.len()).min_by_key(|&i| self.chains[i].cost);
            best = cheapest.unwrap_or(best);
            if self.chains[best].cost <= -self.weights.strip {
                break;
            }
            next += 1;
        }
        if self.chains[best].cost >= 0 {
            self.hide_from(links, 0);
            return None;
        }
        self.show(links, best as u32);
        let mut found = Found::default();
        for &chain in &self.shown {
            found.joined_count += usize::from(self.chains[chain as usize].joined != NO_TWIN);
            found.cut_count += usize::from(self.chains[chain as usize].cut != NO_TWIN);
        }
        Some(found)
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
        let Chain { end, cut: came_from, .. } = self.chains[parent as usize];
        let (beside, count, is_whole) = self.beside(links, end);
        for Beside { exit, triangle, facing } in beside.into_iter().take(count) {
            let entered = links.twins()[exit as usize];
            if exit == came_from || entered == came_from || (facing.is_none() && !is_whole) {
                continue;
            }
            if links.solid_degree(triangle) < 2 && facing.is_none() {
                self.add(links, parent, exit, NO_TWIN);
                continue;
            }
            let solid = links.solid_bits(triangle);
            for cut in (3 * triangle..3 * triangle + 3).filter(|side| solid & 1 << (side % 3) != 0) {
                if facing.is_none_or(|facing| facing == cut) {
                    self.add(links, parent, exit, cut);
                }
            }
        }
    }

    /// The neighbours of an end across dashed links, and whether its whole strip was walked for them.
    fn beside(&self, links: &StripLinks<'_>, end: u32) -> ([Beside; 3], usize, bool) {
        let mut beside = [Beside { exit: NO_TWIN, triangle: NO_TWIN, facing: None }; 3];
        let mut count = 0;
        for exit in 3 * end..3 * end + 3 {
            let twin = links.twins()[exit as usize];
            if twin != NO_TWIN && !links.is_solid(exit) {
                beside[count] = Beside { exit, triangle: twin / 3, facing: None };
                count += 1;
            }
        }
        let mut exit = links.first_solid(end);
        let mut unmet_count = count;
        for _ in 0..self.walk_limit {
            let Some(side) = exit.filter(|_| unmet_count > 0) else { return (beside, count, true) };
            let entered = links.twins()[side as usize];
            for met in beside[..count].iter_mut().filter(|met| met.triangle == entered / 3) {
                met.facing = Some(entered);
                unmet_count -= 1;
            }
            exit = links.other_solid(entered);
        }
        (beside, count, exit.is_none())
    }

    /// Adds the chain that joins across `joined` and cuts `cut`, unless one as cheap leads to the same end.
    fn add(&mut self, links: &mut StripLinks<'_>, parent: u32, joined: u32, cut: u32) {
        let before = self.chains[parent as usize];
        let mut cost = before.cost;
        let mut end = NO_TWIN;
        if cut != NO_TWIN {
            cost += self.price_of_cut(links, cut);
            end = links.twins()[cut as usize] / 3;
        }
        cost += self.price_of_join(links, joined);
        links.cut(joined);
        if cut != NO_TWIN {
            links.join(cut);
        }
        let is_known = |other: &Chain| other.end == end && other.cost <= cost;
        if self.chains.len() < self.chain_limit && (end == NO_TWIN || !self.chains.iter().any(is_known)) {
            self.chains.push(Chain { parent, joined, cut, end, cost, move_count: before.move_count + 1 });
        }
    }

    /// Joins a link; what that costs.
    fn price_of_join(&self, links: &mut StripLinks<'_>, side: u32) -> i32 {
        let twin = links.twins()[side as usize];
        let before = swaps_at(links, side / 3) + swaps_at(links, twin / 3);
        links.join(side);
        let after = swaps_at(links, side / 3) + swaps_at(links, twin / 3) - swap_at(links, side);
        self.weights.swap * (after - before) - self.weights.strip
    }

    /// Cuts a link; what that costs.
    fn price_of_cut(&self, links: &mut StripLinks<'_>, side: u32) -> i32 {
        let twin = links.twins()[side as usize];
        let before = swaps_at(links, side / 3) + swaps_at(links, twin / 3) - swap_at(links, side);
        links.cut(side);
        let after = swaps_at(links, side / 3) + swaps_at(links, twin / 3);
        self.weights.swap * (after - before) + self.weights.strip
    }
}

/// Swaps of a solid link: 1 where its two sides turn differently.
pub(super) fn swap_at(links: &StripLinks<'_>, side: u32) -> i32 {
    let (here, there) = (links.turn(side), links.turn(links.twins()[side as usize]));
    i32::from(here != Turn::End && there != Turn::End && here != there)
}

/// Swaps of the solid links of a triangle.
fn swaps_at(links: &StripLinks<'_>, triangle: u32) -> i32 {
    let solid = links.solid_bits(triangle);
    let sides = (3 * triangle..3 * triangle + 3).filter(|side| solid & 1 << (side % 3) != 0);
    sides.map(|side| swap_at(links, side)).sum()
}
