//! Strips that wait for a later block, found by the sides where one may go on.

use std::collections::{BTreeMap, BTreeSet};

use super::hash::NumberMap;
use super::{Block, BlockTriangle};
use crate::strip::strip_triangles;

/// A strip that touches triangles which are still to come.
#[derive(Clone, Debug)]
pub(super) struct HeldStrip {
    /// Its indices, as numbered in the whole mesh.
    pub(super) indices: Vec<u32>,
    /// For each index the last block that uses its vertex.
    pub(super) last_blocks: Vec<u32>,
    /// The last block that can have a triangle at one of its open sides.
    pub(super) expiry: u32,
    /// Triangles, degenerate ones not counted.
    pub(super) triangle_count: usize,
}

/// All strips that wait.
#[derive(Debug, Default)]
pub(super) struct Held {
    /// By number, which rises in the order in which they came.
    strips: BTreeMap<u32, HeldStrip>,
    by_expiry: BTreeSet<(u32, u32)>,
    /// Which strip has a triangle that runs along this edge in this direction, and may be gone on from there.
    sides: NumberMap<(u32, u32)>,
    next_number: u32,
    triangle_count: usize,
    peak_triangle_count: usize,
}

/// The three sides of a triangle as they run.
pub(super) fn sides_of([a, b, c]: [u32; 3]) -> [(u32, u32); 3] {
    [(a, b), (b, c), (c, a)]
}

impl Held {
    /// Triangles of all strips that wait.
    pub(super) fn triangle_count(&self) -> usize {
        self.triangle_count
    }

    /// The most that ever waited.
    pub(super) fn peak_triangle_count(&self) -> usize {
        self.peak_triangle_count
    }

    /// Lets a strip wait; `open_sides` are those of its sides where it may be gone on from.
    pub(super) fn push(&mut self, strip: HeldStrip, open_sides: impl Iterator<Item = (u32, u32)>) {
        let number = self.next_number;
        self.next_number += 1;
        // Where two triangles run along one edge alike, the later one is found; the other leaves in time.
        self.sides.extend(open_sides.map(|side| (side, number)));
        self.by_expiry.insert((strip.expiry, number));
        self.triangle_count += strip.triangle_count;
        self.peak_triangle_count = self.peak_triangle_count.max(self.triangle_count);
        self.strips.insert(number, strip);
    }

    /// Takes the strips out that a block's triangles lie beside.
    pub(super) fn take_beside(&mut self, block: &Block) -> Vec<HeldStrip> {
        if self.strips.is_empty() {
            return Vec::new();
        }
        let sides = block.triangles.iter().flat_map(|&BlockTriangle { corners, .. }| sides_of(corners));
        let mut found: Vec<u32> = sides.filter_map(|(a, b)| self.sides.get(&(b, a)).copied()).collect();
        found.sort_unstable();
        found.dedup();
        found.into_iter().filter_map(|number| self.take(number)).collect()
    }

    /// Takes out a strip that no block after this one can touch.
    pub(super) fn take_expired(&mut self, block: u32) -> Option<HeldStrip> {
        let &(_, number) = self.by_expiry.first().filter(|&&(expiry, _)| expiry <= block)?;
        self.take(number)
    }

    fn take(&mut self, number: u32) -> Option<HeldStrip> {
        let strip = self.strips.remove(&number)?;
        self.by_expiry.remove(&(strip.expiry, number));
        self.triangle_count -= strip.triangle_count;
        for side in strip_triangles(&strip.indices).flat_map(sides_of) {
            if self.sides.get(&side) == Some(&number) {
                self.sides.remove(&side);
            }
        }
        Some(strip)
    }
}
