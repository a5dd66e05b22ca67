//! Greedy strips: from triangles with few free neighbours, walk both ways, keep the best of three walks.
//!
//! The next strip starts where a triangle is most in danger of being left alone. Through that triangle run
//! three walks, one for each pair of its edges; each goes on straight (no swap) where it can, turns where it
//! must, and the walk that saves most indices becomes the strip. In the spirit of SGI's `tomesh` and of
//! \[ESV96\], but the merit is indices (`swaps + 3 * strips`), not the number of strips.
//! Time and memory are linear: at most three times the triangles of the chosen strip are looked at.

use std::ops::Range;

use super::StripSet;
use crate::mesh::{DualGraph, NO_TWIN as NONE};

/// Appends strips that hold each proper triangle of each group once; links of the graph stay within a group.
pub(super) fn stripify(
    triangles: &[[u32; 3]],
    graph: &DualGraph,
    groups: impl Iterator<Item = Range<usize>>,
    out: &mut StripSet,
) {
    let mut walker = Walker::new(triangles, graph);
    for group in groups {
        stripify_group(&mut walker, group, out);
        out.end_group();
    }
}

fn stripify_group(walker: &mut Walker<'_>, group: Range<usize>, out: &mut StripSet) {
    let mut seeds = Seeds::new(walker, group);
    let (mut best, mut trial, mut strip) = (Walk::default(), Walk::default(), Vec::new());
    while let Some(seed) = seeds.pop(walker) {
        best.clear();
        for edge in 3 * seed..3 * seed + 3 {
            walker.walk_both_ways(edge, &mut trial);
            if best.is_empty() || trial.merit() > best.merit() {
                std::mem::swap(&mut best, &mut trial);
            }
        }
        strip.clear();
        walker.write_strip(&best, &mut strip);
        out.push(&strip);
        for &triangle in best.back.iter().chain(&best.front).chain([&(3 * seed)]) {
            walker.is_free[triangle as usize / 3] = false;
        }
        for &h in best.back.iter().chain(&best.front).chain([&(3 * seed)]) {
            let first = h - h % 3;
            for neighbour in (first..first + 3).map(|e| walker.twins[e as usize]) {
                if neighbour != NONE && walker.is_free[neighbour as usize / 3] {
                    seeds.push(neighbour / 3, walker);
                }
            }
        }
    }
}

#[inline]
fn next(h: u32) -> u32 {
    if h % 3 == 2 { h - 2 } else { h + 1 }
}

#[inline]
fn prev(h: u32) -> u32 {
    if h.is_multiple_of(3) { h + 2 } else { h - 1 }
}

/// A walk through a seed: the half-edges by which the triangles after and before it are entered.
#[derive(Default)]
struct Walk {
    seed: u32,
    front: Vec<u32>,
    back: Vec<u32>,
    swap_count: usize,
}

impl Walk {
    fn clear(&mut self) {
        self.front.clear();
        self.back.clear();
        self.seed = NONE;
        self.swap_count = 0;
    }

    fn is_empty(&self) -> bool {
        self.seed == NONE
    }

    /// Indices saved against a strip for every triangle.
    fn merit(&self) -> i64 {
        3 * (self.front.len() + self.back.len()) as i64 - self.swap_count as i64
    }
}

struct Walker<'a> {
    triangles: &'a [[u32; 3]],
    twins: &'a [u32],
    is_free: Vec<bool>,
    /// The trial that last passed each triangle.
    stamps: Vec<u32>,
    stamp: u32,
}

impl<'a> Walker<'a> {
    fn new(triangles: &'a [[u32; 3]], graph: &'a DualGraph) -> Self {
        let is_free = triangles.iter().map(|t| t[0] != t[1] && t[1] != t[2] && t[2] != t[0]).collect();
        Self { triangles, twins: graph.twins(), is_free, stamps: vec![0; triangles.len()], stamp: 0 }
    }

    fn free_neighbour_count(&self, triangle: u32) -> usize {
        (3 * triangle..3 * triangle + 3).filter(|&e| self.is_open(e)).count()
    }

    /// Whether a walk may leave a triangle by this half-edge.
    #[inline]
    fn is_open(&self, exit: u32) -> bool {
        let enter = self.twins[exit as usize];
        enter != NONE && self.is_free[enter as usize / 3] && self.stamps[enter as usize / 3] != self.stamp
    }

    /// Walks from the triangle of `exit` forward through `exit` and backward through the edge before it.
    fn walk_both_ways(&mut self, exit: u32, walk: &mut Walk) {
        self.stamp += 1;
        walk.clear();
        walk.seed = exit;
        self.stamps[exit as usize / 3] = self.stamp;
        // Entered by the edge before `exit`, the seed turns to the next edge; seen from behind, to the one before.
        walk.swap_count = self.walk(exit, false, &mut walk.front);
        walk.swap_count += self.walk(prev(exit), true, &mut walk.back);
    }

    /// Appends the half-edges by which triangles are entered; `turns_next` is the turn that needs no swap.
    fn walk(&mut self, mut exit: u32, mut turns_next: bool, entered: &mut Vec<u32>) -> usize {
        let mut swap_count = 0;
        while self.is_open(exit) {
            let enter = self.twins[exit as usize];
            self.stamps[enter as usize / 3] = self.stamp;
            entered.push(enter);
            let (mut straight, mut turned) = (next(enter), prev(enter));
            if !turns_next {
                (straight, turned) = (turned, straight);
            }
            exit = straight;
            if self.is_open(turned) && (!self.is_open(straight) || self.strands(turned, straight)) {
                exit = turned;
                swap_count += 1;
            } else {
                turns_next = !turns_next;
            }
        }
        swap_count
    }

    /// Whether going straight would leave a triangle alone that a swap picks up without ending the walk.
    fn strands(&self, turned: u32, straight: u32) -> bool {
        let ways_on = |exit: u32| {
            let enter = self.twins[exit as usize];
            usize::from(self.is_open(next(enter))) + usize::from(self.is_open(prev(enter)))
        };
        ways_on(turned) == 1 && ways_on(straight) == 2
    }

    /// Writes the walk as a strip that starts at whichever end needs fewer indices.
    fn write_strip(&self, walk: &Walk, strip: &mut Vec<u32>) {
        // The half-edges by which triangles are left, from the one end to the other.
        let mut exits: Vec<u32> = walk.back.iter().rev().copied().collect();
        exits.extend(walk.front.iter().map(|&enter| self.twins[enter as usize]));
        if exits.is_empty() {
            strip.extend(self.triangles[walk.seed as usize / 3]);
            return;
        }
        self.write_path(&exits, strip);
        let reversed: Vec<u32> = exits.iter().rev().map(|&exit| self.twins[exit as usize]).collect();
        let mut other = Vec::with_capacity(strip.len());
        self.write_path(&reversed, &mut other);
        if other.len() < strip.len() {
            std::mem::swap(strip, &mut other);
        }
    }

    fn write_path(&self, exits: &[u32], strip: &mut Vec<u32>) {
        let corner = |h: u32| self.triangles[h as usize / 3][h as usize % 3];
        let first = exits[0];
        strip.extend([corner(prev(first)), corner(first), corner(next(first))]);
        for (i, &exit) in exits.iter().enumerate() {
            let enter = self.twins[exit as usize];
            let apex = corner(prev(enter));
            let &[.., older, newer] = strip.as_slice() else { return };
            if let Some(&exit) = exits.get(i + 1) {
                let ends = [corner(exit), corner(next(exit))];
                if !ends.contains(&newer) {
                    strip.push(older);
                }
            }
            strip.push(apex);
        }
    }
}

/// Triangles that wait to start a strip, those with the fewest free neighbours first, the last added first.
struct Seeds {
    by_count: [Vec<u32>; 4],
}

impl Seeds {
    fn new(walker: &Walker<'_>, group: Range<usize>) -> Self {
        let mut seeds = Self { by_count: Default::default() };
        for triangle in (group.start as u32..group.end as u32).rev().filter(|&t| walker.is_free[t as usize]) {
            seeds.push(triangle, walker);
        }
        seeds
    }

    fn push(&mut self, triangle: u32, walker: &Walker<'_>) {
        self.by_count[walker.free_neighbour_count(triangle)].push(triangle);
    }

    fn pop(&mut self, walker: &Walker<'_>) -> Option<u32> {
        for stack in &mut self.by_count {
            while let Some(triangle) = stack.pop() {
                // Entries that have moved to a lower stack or are covered stay behind: skipped here.
                if walker.is_free[triangle as usize] {
                    return Some(triangle);
                }
            }
        }
        None
    }
}
