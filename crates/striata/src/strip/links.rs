//! Solid and dashed links: a set of strips, represented by marked links of the dual graph.
//!
//! A link of the [`DualGraph`] is **solid** if its two triangles are consecutive in a strip, and **dashed**
//! otherwise \[PS03, 3.1\]. A set of strips is thus a set of solid links in which no node has more than two
//! and which contains no loop. All stripifiers edit these marks, and [`write_strips`](super::write_strips)
//! converts them to indices.
//!
//! ```text
//!     o===o---o===o===o      === solid, --- dashed: two strips, of two and of three triangles
//! ```
//!
//! Memory: one byte per triangle. Joining, cutting and lookups take a few loads each.

use super::StripSet;
use super::strip_set::strip_triangles;
use crate::mesh::{DualGraph, NO_TWIN, canonical_triangle};

/// The solid links of a dual graph.
///
/// A link is identified by either of its sides: side `3 * triangle + k` runs from corner `k` of its
/// triangle to the next corner, and its twin is the same link seen from the other triangle.
///
/// ```
/// use striata::mesh::{DualGraph, shapes};
/// use striata::strip::{StripLinks, StripSet, write_strips};
///
/// let mesh = shapes::grid(1, 1);
/// let graph = DualGraph::of_vertices(&mesh);
/// let mut links = StripLinks::new(&graph);
/// let shared = (0..3).find(|&side| graph.twin(side).is_some()).expect("two triangles share an edge");
/// links.join(shared);
/// let mut strips = StripSet::new();
/// write_strips(&mesh.triangles, &links, std::iter::once(0..2), &mut strips);
/// assert_eq!(strips.strip(0).len(), 4);
/// ```
#[derive(Clone, Debug)]
pub struct StripLinks<'a> {
    twins: &'a [u32],
    /// Bit `k` of each triangle: whether the link across its side `k` is solid.
    solid: Vec<u8>,
}

/// The direction in which a strip that crosses a side of a triangle continues.
///
/// Seen from a solid side, the other solid side of the triangle is either the next side around the
/// triangle, or the previous one, or missing. No swap is needed across a link if the turns at both of its
/// sides are equal.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u8)]
pub enum Turn {
    /// The strip ends in this triangle.
    End = 0,
    /// The other solid side is the next one around the triangle.
    Next = 1,
    /// The other solid side is the previous one around the triangle.
    Prev = 2,
}

/// Turn for each combination of solid bits and side.
const TURNS: [[Turn; 3]; 8] = {
    use Turn::{End as E, Next as N, Prev as P};
    [[E, E, E], [E, E, E], [E, E, E], [N, P, E], [E, E, E], [P, E, N], [E, N, P], [E, E, E]]
};

/// The next side around the triangle.
#[inline]
pub fn next_side(side: u32) -> u32 {
    if side % 3 == 2 { side - 2 } else { side + 1 }
}

/// The previous side around the triangle.
#[inline]
pub fn prev_side(side: u32) -> u32 {
    if side.is_multiple_of(3) { side + 2 } else { side - 1 }
}

impl<'a> StripLinks<'a> {
    /// Creates links that are all dashed: every triangle is a separate strip.
    pub fn new(graph: &'a DualGraph) -> Self {
        Self { twins: graph.twins(), solid: vec![0; graph.triangle_count()] }
    }

    /// Marks the links along the strips of a mesh.
    ///
    /// A strip is cut if it crosses an edge without a link (possible if an edge has more than two sides) or
    /// repeats a triangle. Triangles that the mesh does not contain are ignored.
    pub fn from_strips(graph: &'a DualGraph, triangles: &[[u32; 3]], strips: &StripSet) -> Self {
        let mut links = Self::new(graph);
        links.join_along(triangles, strips);
        links
    }

    /// Creates links from solid bits and from the twins of all sides, which the caller stores; for graphs
    /// that change.
    ///
    /// Bit `k` of a triangle is set if the link across its side `k` is solid. [`Self::into_bits`] returns
    /// the bits.
    ///
    /// # Panics
    /// In debug builds, if there are not three twins for each triangle.
    pub fn from_bits(twins: &'a [u32], solid: Vec<u8>) -> Self {
        debug_assert_eq!(twins.len(), 3 * solid.len(), "three sides a triangle");
        Self { twins, solid }
    }

    /// Returns the solid bits, for use with [`Self::from_bits`].
    pub fn into_bits(self) -> Vec<u8> {
        self.solid
    }

    /// Marks the links along strips of these triangles as solid.
    ///
    /// Returns the first triangle of a strip that the mesh does not contain (or not as often), together
    /// with the index of the strip.
    ///
    /// # Panics
    /// If `triangles` are not those of the graph.
    pub fn join_along(&mut self, triangles: &[[u32; 3]], strips: &StripSet) -> Option<(usize, [u32; 3])> {
        let mut missing = None;
        let mut by_corners: Vec<([u32; 3], u32)> =
            triangles.iter().enumerate().map(|(i, &t)| (canonical_triangle(t), i as u32)).collect();
        by_corners.sort_unstable();
        let mut is_used = vec![false; triangles.len()];
        // At the first of equal triangles: how many of them are known to be used.
        let mut used_counts = vec![0; triangles.len()];
        for (strip, indices) in strips.strips().enumerate() {
            let mut last: Option<u32> = None;
            for corners in strip_triangles(indices).map(canonical_triangle) {
                // Among equal triangles, prefer a linked one: it continues the strip.
                let fits =
                    |t: u32| !is_used[t as usize] && canonical_triangle(triangles[t as usize]) == corners;
                let side = last.and_then(|last| self.dashed_side_to(last, fits));
                let found = side.map(|side| self.twins[side as usize] / 3).or_else(|| {
                    let first = by_corners.partition_point(|&(other, _)| other < corners);
                    let count = used_counts.get_mut(first)?;
                    loop {
                        let &(other, triangle) = by_corners.get(first + *count)?;
                        if other != corners {
                            return None;
                        }
                        if !is_used[triangle as usize] {
                            return Some(triangle);
                        }
                        *count += 1;
                    }
                });
                match found {
                    Some(triangle) => is_used[triangle as usize] = true,
                    None => missing = missing.or(Some((strip, corners))),
                }
                if let Some(side) = side {
                    self.join(side);
                }
                last = found;
            }
        }
        missing
    }

    /// A dashed side of a triangle that leads to a matching triangle, if both can have another solid link.
    fn dashed_side_to(&self, from: u32, fits: impl Fn(u32) -> bool) -> Option<u32> {
        if self.solid_degree(from) == 2 {
            return None;
        }
        (3 * from..3 * from + 3).find(|&side| {
            let twin = self.twins[side as usize];
            twin != NO_TWIN && !self.is_solid(side) && self.solid_degree(twin / 3) < 2 && fits(twin / 3)
        })
    }

    /// Number of triangles in the graph.
    pub fn triangle_count(&self) -> usize {
        self.solid.len()
    }

    /// The twin of every side; [`NO_TWIN`] for sides without a link.
    #[inline]
    pub fn twins(&self) -> &'a [u32] {
        self.twins
    }

    /// Makes all links dashed.
    pub fn clear(&mut self) {
        self.solid.fill(0);
    }

    /// Solid bits of a triangle; bit `k` is set if the link across its side `k` is solid.
    #[inline]
    pub fn solid_bits(&self, triangle: u32) -> u8 {
        self.solid[triangle as usize]
    }

    /// Whether the link across this side is solid.
    #[inline]
    pub fn is_solid(&self, side: u32) -> bool {
        self.solid[side as usize / 3] & bit(side) != 0
    }

    /// Number of solid links of a triangle, 0 to 2.
    #[inline]
    pub fn solid_degree(&self, triangle: u32) -> u32 {
        self.solid[triangle as usize].count_ones()
    }

    /// Number of solid links; the number of non-degenerate triangles minus this is the number of strips.
    pub fn solid_count(&self) -> usize {
        self.solid.iter().map(|bits| bits.count_ones() as usize).sum::<usize>() / 2
    }

    /// Direction in which the strip that crosses this side continues in the side's triangle.
    #[inline]
    pub fn turn(&self, side: u32) -> Turn {
        TURNS[usize::from(self.solid[side as usize / 3] & 7)][side as usize % 3]
    }

    /// The other solid side of the same triangle.
    #[inline]
    pub fn other_solid(&self, side: u32) -> Option<u32> {
        match self.turn(side) {
            Turn::End => None,
            Turn::Next => Some(next_side(side)),
            Turn::Prev => Some(prev_side(side)),
        }
    }

    /// The first solid side of a triangle.
    #[inline]
    pub fn first_solid(&self, triangle: u32) -> Option<u32> {
        let bits = self.solid[triangle as usize];
        (bits != 0).then(|| 3 * triangle + bits.trailing_zeros())
    }

    /// Makes a dashed link solid.
    ///
    /// The caller must make sure that this does not close a loop, since a loop has no end at which it could
    /// be written.
    ///
    /// # Panics
    /// If there is no link across this side; in debug builds also if it is solid, or if a triangle already
    /// has two solid links.
    #[inline]
    pub fn join(&mut self, side: u32) {
        let twin = self.twins[side as usize];
        debug_assert!(!self.is_solid(side), "side {side} is solid already");
        self.solid[side as usize / 3] |= bit(side);
        self.solid[twin as usize / 3] |= bit(twin);
        debug_assert!(self.solid_degree(side / 3) <= 2, "triangle {} has three solid links", side / 3);
        debug_assert!(self.solid_degree(twin / 3) <= 2, "triangle {} has three solid links", twin / 3);
    }

    /// Makes a solid link dashed.
    ///
    /// # Panics
    /// If there is no link across this side; in debug builds also if it is dashed.
    #[inline]
    pub fn cut(&mut self, side: u32) {
        let twin = self.twins[side as usize];
        debug_assert!(self.is_solid(side), "side {side} is dashed already");
        self.solid[side as usize / 3] &= !bit(side);
        self.solid[twin as usize / 3] &= !bit(twin);
    }

    /// Follows the strip from a triangle through one of its solid sides, and returns the last triangle.
    ///
    /// On a loop, this is the triangle of `side` itself.
    #[inline]
    pub fn end_beyond(&self, side: u32) -> u32 {
        let first = side / 3;
        let mut exit = side;
        loop {
            let entered = self.twins[exit as usize];
            match self.other_solid(entered) {
                Some(other) if entered / 3 != first => exit = other,
                _ => return entered / 3,
            }
        }
    }

    /// Cuts one link of every loop, so that every strip has ends; returns the number of loops.
    pub fn cut_loops(&mut self) -> usize {
        let mut is_seen = vec![false; self.solid.len()];
        for end in 0..self.solid.len() as u32 {
            if self.solid_degree(end) == 1 && !is_seen[end as usize] {
                self.mark(end, &mut is_seen);
            }
        }
        let mut loop_count = 0;
        for triangle in 0..self.solid.len() as u32 {
            if self.solid_degree(triangle) == 2 && !is_seen[triangle as usize] {
                if let Some(side) = self.first_solid(triangle) {
                    self.cut(side);
                }
                self.mark(triangle, &mut is_seen);
                loop_count += 1;
            }
        }
        loop_count
    }

    /// Marks the triangles of the strip that ends in `end`.
    fn mark(&self, end: u32, is_seen: &mut [bool]) {
        is_seen[end as usize] = true;
        let mut exit = self.first_solid(end);
        while let Some(side) = exit {
            let entered = self.twins[side as usize];
            is_seen[entered as usize / 3] = true;
            exit = self.other_solid(entered);
        }
    }
}

#[inline]
fn bit(side: u32) -> u8 {
    1 << (side % 3)
}
