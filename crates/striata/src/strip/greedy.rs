//! Greedy strips: from triangles with few free neighbours, walk both ways, keep the best of three walks.
//!
//! The next strip starts where a triangle is most in danger of being left alone. Through that triangle run
//! three walks, one for each pair of its edges; each goes on straight (no swap) where it can, turns where it
//! must, and the walk that saves most indices becomes the strip. In the spirit of SGI's `tomesh` and of
//! \[ESV96\], but the merit is indices (`swaps + 3 * strips`), not the number of strips.
//! Time and memory are linear: at most three times the triangles of the chosen strip are looked at.

use std::ops::Range;

use super::StripLinks;
use super::links::{next, prev};
use super::stripifier::Task;
use crate::mesh::NO_TWIN as NONE;

/// Joins triangles that stand alone into strips; strips that are there already stay as they are.
pub(super) fn run(task: &Task<'_>, links: &mut StripLinks<'_>) {
    let mut walker = Walker::new(task.triangles, links);
    for group in &task.groups {
        run_group(&mut walker, group.clone(), links);
    }
}

fn run_group(walker: &mut Walker<'_>, group: Range<usize>, links: &mut StripLinks<'_>) {
    let mut seeds = Seeds::new(walker, group);
    let (mut best, mut trial) = (Walk::default(), Walk::default());
    while let Some(seed) = seeds.pop(walker) {
        best.clear();
        for edge in 3 * seed..3 * seed + 3 {
            walker.walk_both_ways(edge, &mut trial);
            if best.is_empty() || trial.merit() > best.merit() {
                std::mem::swap(&mut best, &mut trial);
            }
        }
        for &entered in best.back.iter().chain(&best.front) {
            links.join(entered);
        }
        for &h in best.back.iter().chain(&best.front).chain([&(3 * seed)]) {
            walker.is_free[h as usize / 3] = false;
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
    twins: &'a [u32],
    is_free: Vec<bool>,
    /// The trial that last passed each triangle.
    stamps: Vec<u32>,
    stamp: u32,
}

impl<'a> Walker<'a> {
    fn new(triangles: &[[u32; 3]], links: &StripLinks<'a>) -> Self {
        let is_proper = |t: &[u32; 3]| t[0] != t[1] && t[1] != t[2] && t[2] != t[0];
        let is_free = (0..).zip(triangles).map(|(i, t)| is_proper(t) && links.solid_bits(i) == 0).collect();
        Self { twins: links.twins(), is_free, stamps: vec![0; triangles.len()], stamp: 0 }
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
