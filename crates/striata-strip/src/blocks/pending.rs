//! Strips that wait for a later block, found by their open sides.
//!
//! A **loose** strip is taken apart by the block that reaches it, and its triangles are stripified again. A
//! **chain** is longer; it keeps its triangles except those at its ends, and later strips may continue it.

use std::collections::{BTreeMap, BTreeSet};

use super::chain::{BlockChain, ChainEnd, sides_of};
use super::integer_map::IntegerMap;
use super::source::{Block, BlockTriangle};

/// Sides of a strip that have no neighbor yet but may get one.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct OpenSides {
    /// Directed sides, with the vertex indices of the whole mesh.
    pub sides: Vec<(u32, u32)>,
    /// Last block that can contain a triangle next to one of them.
    pub expiry: u32,
}

/// Open end of a chain: its triangle and the open sides of that triangle.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct OpenEnd {
    pub triangle: BlockTriangle,
    pub open: OpenSides,
}

/// Strip that waits for a later block.
#[derive(Clone, Debug)]
pub(super) enum PendingStrip {
    /// A short strip that may be taken apart: its triangles, and all its open sides.
    Loose { strip: Vec<u32>, triangles: Vec<BlockTriangle>, open: OpenSides },
    /// A long strip, and those of its ends that are open.
    Chain { chain: BlockChain, ends: [Option<OpenEnd>; 2] },
}

impl PendingStrip {
    /// Number of triangles, as counted for the memory limit.
    pub(super) fn triangle_count(&self) -> usize {
        match self {
            Self::Loose { triangles, .. } => triangles.len(),
            Self::Chain { chain, .. } => chain.len() - 2,
        }
    }

    /// Iterates over the open sides of the strip, with the end they are at.
    fn open_sides(&self) -> impl Iterator<Item = (&OpenSides, ChainEnd)> {
        let (loose, ends) = match self {
            Self::Loose { open, .. } => (Some((open, ChainEnd::Front)), None),
            Self::Chain { ends, .. } => (None, Some(ends)),
        };
        let at_ends = ends.into_iter().flat_map(|ends| ends.iter().zip(ChainEnd::BOTH));
        loose.into_iter().chain(at_ends.filter_map(|(end, which)| Some((&end.as_ref()?.open, which))))
    }

    /// Returns the last block that can touch the strip.
    fn expiry(&self) -> u32 {
        self.open_sides().map(|(open, _)| open.expiry).max().unwrap_or(0)
    }

    /// Writes the indices of the strip.
    pub(super) fn write(&self, out: &mut Vec<u32>) {
        match self {
            Self::Loose { strip, .. } => out.clone_from(strip),
            Self::Chain { chain, .. } => chain.write(out),
        }
    }
}

/// Strip that is adjacent to a block.
#[derive(Debug)]
pub(super) struct TouchedStrip {
    pub strip: PendingStrip,
    /// For a chain, the sides of its end triangles that the block touches.
    pub touched_sides: [Vec<(u32, u32)>; 2],
}

/// All strips that wait.
#[derive(Debug, Default)]
pub(super) struct PendingStrips {
    /// Strips by id; ids rise in order of arrival.
    strips: BTreeMap<u32, PendingStrip>,
    by_expiry: BTreeSet<(u32, u32)>,
    /// For each open side, the strip it belongs to and the end it is at.
    sides: IntegerMap<(u32, u32), (u32, ChainEnd)>,
    next_id: u32,
    triangle_count: usize,
    peak_triangle_count: usize,
}

impl PendingStrips {
    /// Number of triangles of all strips that wait.
    pub(super) fn triangle_count(&self) -> usize {
        self.triangle_count
    }

    /// Largest number of triangles that ever waited.
    pub(super) fn peak_triangle_count(&self) -> usize {
        self.peak_triangle_count
    }

    /// Adds a strip.
    pub(super) fn push(&mut self, strip: PendingStrip) {
        let id = self.next_id;
        self.next_id += 1;
        for (open, end) in strip.open_sides() {
            // If two triangles have the same directed side, the later one is found; the other expires in
            // time.
            self.sides.extend(open.sides.iter().map(|&side| (side, (id, end))));
        }
        self.by_expiry.insert((strip.expiry(), id));
        self.triangle_count += strip.triangle_count();
        self.peak_triangle_count = self.peak_triangle_count.max(self.triangle_count);
        self.strips.insert(id, strip);
    }

    /// Removes and returns the strips that are adjacent to a block's triangles.
    pub(super) fn take_adjacent(&mut self, block: &Block) -> Vec<TouchedStrip> {
        if self.strips.is_empty() {
            return Vec::new();
        }
        let mut found: BTreeMap<u32, [Vec<(u32, u32)>; 2]> = BTreeMap::new();
        let sides = block.triangles.iter().flat_map(|&BlockTriangle { corners, .. }| sides_of(corners));
        for side in sides.map(|(a, b)| (b, a)) {
            if let Some(&(id, end)) = self.sides.get(&side) {
                found.entry(id).or_default()[end as usize].push(side);
            }
        }
        let touched = |(id, touched_sides)| Some(TouchedStrip { strip: self.take(id)?, touched_sides });
        found.into_iter().filter_map(touched).collect()
    }

    /// Removes and returns a strip that no block after this one can touch.
    pub(super) fn take_expired(&mut self, block: u32) -> Option<PendingStrip> {
        let &(_, id) = self.by_expiry.first().filter(|&&(expiry, _)| expiry <= block)?;
        self.take(id)
    }

    /// Removes and returns a strip.
    fn take(&mut self, id: u32) -> Option<PendingStrip> {
        let strip = self.strips.remove(&id)?;
        self.by_expiry.remove(&(strip.expiry(), id));
        self.triangle_count -= strip.triangle_count();
        for &side in strip.open_sides().flat_map(|(open, _)| &open.sides) {
            if self.sides.get(&side).is_some_and(|&(found, _)| found == id) {
                self.sides.remove(&side);
            }
        }
        Some(strip)
    }
}
