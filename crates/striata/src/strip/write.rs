//! From solid links to strips: which end a strip begins at, and in which order strips come.
//!
//! A strip of `n` triangles takes `n + 2` indices and one more for every swap. Written from one end, its
//! first turn may fall on the wrong winding, which costs one index again; it is written from the
//! other end where that one is free. The next strip is one that touches where the last one ended, so that
//! vertices are used again while a cache holds them. Linear in time; five bytes a triangle.

use std::ops::Range;

use super::StripSet;
use super::links::{StripLinks, Turn, next_side, prev_side};
use crate::mesh::{NO_TWIN, is_proper};

/// A strip that is not yet indices: the sides by which its triangles are left, from one end to the other.
#[derive(Clone, Debug, Default)]
pub struct StripPath {
    /// The triangle that it begins with.
    pub first: u32,
    /// The side by which each triangle but the last is left.
    pub exits: Vec<u32>,
}

impl StripPath {
    /// Becomes the strip that ends in this triangle, followed to its other end.
    ///
    /// # Panics
    /// In debug builds, if no strip ends there.
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

    /// The same strip from its other end.
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

    /// Whether its first turn needs no index more when the first triangle stands at an even place.
    #[inline]
    pub fn begins_well(&self, links: &StripLinks<'_>) -> bool {
        self.exits.first().is_none_or(|&exit| links.turn(links.twins()[exit as usize]) != Turn::Next)
    }

    /// What [`Self::begins_well`] says, seen from the other end.
    #[inline]
    pub fn ends_well(&self, links: &StripLinks<'_>) -> bool {
        self.exits.last().is_none_or(|&exit| links.turn(exit) != Turn::Next)
    }

    /// Triangles from the first to the last.
    #[inline]
    pub fn triangles(&self, links: &StripLinks<'_>) -> impl Iterator<Item = u32> {
        let twins = links.twins();
        std::iter::once(self.first).chain(self.exits.iter().map(|&exit| twins[exit as usize] / 3))
    }

    /// Appends its indices; the first triangle stands at an even place of its draw unless `is_odd`.
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
            let entered = links.twins()[exit as usize];
            let apex = corner(prev_side(entered));
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

/// Appends the strips of all groups, each group a range of triangles.
///
/// Degenerate triangles are left out; a loop would be too: [`StripLinks::cut_loops`] opens them.
pub fn write_strips(
    triangles: &[[u32; 3]],
    links: &StripLinks<'_>,
    groups: impl IntoIterator<Item = Range<usize>>,
    out: &mut StripSet,
) {
    let (mut order, mut indices) = (StripOrder::new(triangles), Vec::new());
    for group in groups {
        order.visit(group, links, |path| {
            if !path.begins_well(links) && path.ends_well(links) {
                path.reverse(links);
            }
            indices.clear();
            path.write(triangles, links, false, &mut indices);
            out.push(&indices);
        });
        out.end_group();
    }
}

/// Visits every strip once, neighbors after each other.
#[derive(Clone, Debug)]
pub struct StripOrder {
    is_done: Vec<bool>,
    /// Triangles beside strips that were visited, the last ones first.
    waiting: Vec<u32>,
    path: StripPath,
}

impl StripOrder {
    /// No strip visited yet; degenerate triangles belong to none.
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
                    let beside = links.twins()[sides].iter().filter(|&&twin| twin != NO_TWIN);
                    let is_done = &self.is_done;
                    self.waiting.extend(beside.map(|&twin| twin / 3).filter(|&t| !is_done[t as usize]));
                }
            }
        }
    }
}
