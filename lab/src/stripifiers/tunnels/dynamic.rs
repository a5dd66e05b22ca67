//! Tunnels with dynamic identities \[PS03, 4\]: links and identities change with each step of the search.

use striata::mesh::{NO_TWIN, Random};
use striata::strip::{StripLinks, next_side, prev_side};

use super::options::{FindTunnels, TunnelOptions};
use super::path_search::{PathSearch, PathStep};

/// Search that applies each path to the links before it goes on from there.
pub(super) struct DynamicTunnels {
    search: PathSearch,
    /// Identity of each triangle: equal if and only if two triangles are in one strip.
    identities: Vec<u32>,
    /// Changed identities: triangle, and identity before.
    changes: Vec<(u32, u32)>,
    /// Steps that are applied, each with the number of changes before it.
    applied: Vec<(PathStep, usize)>,
}

impl DynamicTunnels {
    pub(super) fn new(links: &StripLinks<'_>, options: &TunnelOptions) -> Self {
        let count = links.triangle_count();
        let mut identities = vec![u32::MAX; count];
        for end in (0..count as u32).filter(|&t| links.solid_degree(t) < 2) {
            identities[end as usize] = end;
            if let Some(side) = links.first_solid(end) {
                walk(side, links, |triangle| identities[triangle as usize] = end);
            }
        }
        Self { search: PathSearch::new(count, options), identities, changes: Vec::new(), applied: Vec::new() }
    }

    fn are_in_one_strip(&self, a: u32, b: u32) -> bool {
        self.identities[a as usize] == self.identities[b as usize]
    }

    /// Undoes steps and applies others, until those of the search's current path are applied.
    fn apply_path(&mut self, links: &mut StripLinks<'_>) {
        let path = self.search.path();
        let kept = self.applied.iter().zip(path).take_while(|((applied, _), step)| applied == *step).count();
        self.undo_to(kept, links);
        for i in kept..self.search.path().len() {
            self.apply(self.search.path()[i], links);
        }
    }

    fn undo_to(&mut self, kept: usize, links: &mut StripLinks<'_>) {
        while self.applied.len() > kept {
            let Some((step, change_count)) = self.applied.pop() else { return };
            for (triangle, before) in self.changes.drain(change_count..).rev() {
                self.identities[triangle as usize] = before;
            }
            links.cut(step.crossed);
            links.join(step.cut);
        }
    }

    /// Takes one step: the strip of the moving end continues into the triangle taken, and beyond it on the
    /// side that is not cut off.
    fn apply(&mut self, step: PathStep, links: &mut StripLinks<'_>) {
        self.applied.push((step, self.changes.len()));
        links.cut(step.cut);
        self.join(step.crossed, links);
    }

    /// Joins the strip of the moving end to the triangle across a side, which takes over the identity.
    fn join(&mut self, crossed: u32, links: &mut StripLinks<'_>) {
        let (end, taken) = (crossed / 3, links.twins()[crossed as usize] / 3);
        let identity = self.identities[end as usize];
        if !self.are_in_one_strip(end, taken) {
            let Self { identities, changes, .. } = self;
            let mut take_over = |triangle: u32| {
                changes.push((triangle, identities[triangle as usize]));
                identities[triangle as usize] = identity;
            };
            take_over(taken);
            if let Some(side) = links.first_solid(taken) {
                walk(side, links, take_over);
            }
        }
        links.join(crossed);
    }

    /// Crosses a link from the moving end of the current node. Returns true if that completes a tunnel;
    /// otherwise adds the next nodes.
    fn cross(&mut self, crossed: u32, node: usize, links: &StripLinks<'_>) -> bool {
        let entered = links.twins()[crossed as usize];
        if entered == NO_TWIN || links.is_solid(crossed) || self.search.is_visited(entered / 3) {
            return false;
        }
        let (end, taken) = (crossed / 3, entered / 3);
        let is_same = self.are_in_one_strip(end, taken);
        // The first rule: the last link leads to another strip.
        if !is_same && links.solid_degree(taken) < 2 {
            return true;
        }
        if !self.search.may_go_on() {
            return false;
        }
        let cuts = [next_side(entered), prev_side(entered)].into_iter().filter(|&side| links.is_solid(side));
        // The second rule: inside a strip, the tunnel goes back toward its moving end.
        let back = if is_same { side_toward(end, taken, links) } else { None };
        for cut in cuts.filter(|&cut| !is_same || back == Some(cut)) {
            let next = links.twins()[cut as usize] / 3;
            if !self.search.is_visited(next) {
                self.search.push(node, PathStep { crossed, taken, cut, end: next });
            }
        }
        false
    }
}

impl FindTunnels for DynamicTunnels {
    fn set_max_length(&mut self, max_length: u32) {
        self.search.set_max_length(max_length);
    }

    fn apply_shortest(&mut self, start: u32, links: &mut StripLinks<'_>, random: &mut Random) -> bool {
        self.search.begin(start);
        self.changes.clear();
        self.applied.clear();
        let mut node = 0;
        while let Some(end) = self.search.enter(node) {
            self.apply_path(links);
            let mut side = 3 * end + random.below(3);
            for _ in 0..3 {
                if self.cross(side, node, links) {
                    self.join(side, links);
                    return true;
                }
                side = next_side(side);
            }
            node += 1;
        }
        self.undo_to(0, links);
        false
    }

    fn loop_count(&self) -> usize {
        0
    }
}

/// Calls `visit` with each triangle of a strip beyond a solid side.
fn walk(side: u32, links: &StripLinks<'_>, mut visit: impl FnMut(u32)) {
    let mut exit = Some(side);
    while let Some(side) = exit {
        let entered = links.twins()[side as usize];
        visit(entered / 3);
        exit = links.other_solid(entered);
    }
}

/// Returns the solid side of `from` through which its strip leads to `end`, one of the strip's ends.
fn side_toward(end: u32, from: u32, links: &StripLinks<'_>) -> Option<u32> {
    let first = links.first_solid(from)?;
    let other = links.other_solid(first);
    // Both ways at once, so that the nearer end decides.
    let mut ways = [Some(first), other];
    loop {
        for (i, way) in ways.iter_mut().enumerate() {
            let Some(exit) = *way else { continue };
            let entered = links.twins()[exit as usize];
            *way = links.other_solid(entered);
            if way.is_none() {
                let is_here = (entered / 3 == end) == (i == 0);
                return if is_here { Some(first) } else { other };
            }
        }
    }
}
