//! Conversion of solid links to strips: the direction of each strip and the order of the strips.
//!
//! A strip of `n` triangles takes `n + 2` indices plus one for every swap. Depending on its direction, its
//! first turn may not match the winding, which costs one more index; if the other direction avoids that,
//! the strip is reversed. The next strip is one next to the end of the last strip, so that vertices are
//! reused while they are in the cache. Linear time; five bytes per triangle.

use std::ops::Range;

use super::StripSet;
use super::links::{StripLinks, Turn, next_side, prev_side};
use crate::mesh::{NO_TWIN, is_proper};

/// A strip as a path through the dual graph: the sides through which its triangles are left, from one end
/// to the other.
#[derive(Clone, Debug, Default)]
pub struct StripPath {
    /// The first triangle.
    pub first: u32,
    /// The side through which each triangle but the last is left.
    pub exits: Vec<u32>,
}

impl StripPath {
    /// Sets the path to the strip that ends in triangle `end`, followed to its other end.
    ///
    /// # Panics
    /// In debug builds, if `end` is not the end of a strip.
    #[inline]
    pub fn follow(&mut self, links: &StripLinks<'_>, end: u32) {
        debug_assert!(links.solid_degree(end) < 2, "triangle {end} is inside a strip");
        self.first = end;
        self.exits.clear();
        let mut exit = links.first_solid(end);
        while let Some(side) = exit {
            self.exits.push(side);
            exit = links.other_solid(links.twins()[side as usize]);
        }
    }

    /// Reverses the path, so that it starts at its other end.
    #[inline]
    pub fn reverse(&mut self, links: &StripLinks<'_>) {
        if let Some(&last) = self.exits.last() {
            self.first = links.twins()[last as usize] / 3;
            self.exits.reverse();
            for side in &mut self.exits {
                *side = links.twins()[*side as usize];
            }
        }
    }

    /// Whether the first turn needs no extra index if the first triangle is at an even position.
    #[inline]
    pub fn begins_without_parity_fix(&self, links: &StripLinks<'_>) -> bool {
        self.exits.first().is_none_or(|&exit| links.turn(links.twins()[exit as usize]) != Turn::Next)
    }

    /// Whether [`Self::begins_without_parity_fix`] would return true for the reversed path.
    #[inline]
    pub fn ends_without_parity_fix(&self, links: &StripLinks<'_>) -> bool {
        self.exits.last().is_none_or(|&exit| links.turn(exit) != Turn::Next)
    }

    /// Triangles from first to last.
    #[inline]
    pub fn triangles(&self, links: &StripLinks<'_>) -> impl Iterator<Item = u32> {
        let twins = links.twins();
        std::iter::once(self.first).chain(self.exits.iter().map(|&exit| twins[exit as usize] / 3))
    }

    /// Appends the indices of the strip; `is_odd` is whether its first triangle is at an odd position of
    /// its draw call.
    #[inline]
    pub fn write(&self, triangles: &[[u32; 3]], links: &StripLinks<'_>, is_odd: bool, out: &mut Vec<u32>) {
        let corner = |side: u32| triangles[side as usize / 3][side as usize % 3];
        let exit = self.exits.first().map_or(3 * self.first + 1, |&exit| exit);
        let (mut older, mut newer) = (corner(exit), corner(next_side(exit)));
        if is_odd {
            std::mem::swap(&mut older, &mut newer);
        }
        out.extend([corner(prev_side(exit)), older, newer]);
        for (i, &exit) in self.exits.iter().enumerate() {
            let enter = links.twins()[exit as usize];
            let apex = corner(prev_side(enter));
            if let Some(&exit) = self.exits.get(i + 1) {
                if corner(exit) != newer && corner(next_side(exit)) != newer {
                    out.push(older);
                } else {
                    older = newer;
                }
            }
            out.push(apex);
            newer = apex;
        }
    }
}

/// Appends the strips of all groups, each of which is a range of triangles.
///
/// Degenerate triangles are left out. Loops would be left out too; open them with [`StripLinks::cut_loops`]
/// first.
pub fn write_strips(
    triangles: &[[u32; 3]],
    links: &StripLinks<'_>,
    groups: impl IntoIterator<Item = Range<usize>>,
    out: &mut StripSet,
) {
    let (mut order, mut indices) = (StripOrder::new(triangles), Vec::new());
    for group in groups {
        order.visit(group, links, |path| {
            if !path.begins_without_parity_fix(links) && path.ends_without_parity_fix(links) {
                path.reverse(links);
            }
            indices.clear();
            path.write(triangles, links, false, &mut indices);
            out.push(&indices);
        });
        out.end_group();
    }
}

/// Visits every strip once, neighboring strips one after another.
#[derive(Clone, Debug)]
pub struct StripOrder {
    is_done: Vec<bool>,
    /// Triangles next to visited strips, the latest last.
    waiting: Vec<u32>,
    path: StripPath,
}

impl StripOrder {
    /// Starts with no strip visited; degenerate triangles belong to no strip.
    pub fn new(triangles: &[[u32; 3]]) -> Self {
        let is_done = triangles.iter().map(|corners| !is_proper(corners)).collect();
        Self { is_done, waiting: Vec::new(), path: StripPath::default() }
    }

    /// Visits the strips of one group of triangles.
    pub fn visit(
        &mut self,
        group: Range<usize>,
        links: &StripLinks<'_>,
        mut visit: impl FnMut(&mut StripPath),
    ) {
        for seed in group.start as u32..group.end as u32 {
            self.waiting.push(seed);
            while let Some(near) = self.waiting.pop() {
                if self.is_done[near as usize] {
                    continue;
                }
                let end = links.first_solid(near).map_or(near, |side| links.end_beyond(side));
                self.path.follow(links, end);
                visit(&mut self.path);
                for triangle in self.path.triangles(links) {
                    self.is_done[triangle as usize] = true;
                }
                for triangle in self.path.triangles(links) {
                    let sides = 3 * triangle as usize..3 * triangle as usize + 3;
                    let neighbors = links.twins()[sides].iter().filter(|&&twin| twin != NO_TWIN);
                    let is_done = &self.is_done;
                    self.waiting.extend(neighbors.map(|&twin| twin / 3).filter(|&t| !is_done[t as usize]));
                }
            }
        }
    }
}
