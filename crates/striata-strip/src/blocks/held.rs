//! Strips that wait for a later block, found by the sides where one may go on.
//!
//! A **loose** strip is taken apart by the block that comes beside it: its triangles are looked at anew. A
//! longer one keeps its triangles but those at its ends: it is a chain that later strips may go on with.

use std::collections::{BTreeMap, BTreeSet};

use super::chain::{Chain, End, sides_of};
use super::hash::NumberMap;
use super::source::{Block, BlockTriangle};

/// Sides of a strip that have no triangle beside them yet, but may get one.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct OpenSides {
    /// As they run, over the vertices of the whole mesh.
    pub(super) sides: Vec<(u32, u32)>,
    /// The last block that can have a triangle beside one of them.
    pub(super) expiry: u32,
}

/// The end of a chain: its triangle, and where that is open.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct OpenEnd {
    pub(super) triangle: BlockTriangle,
    pub(super) open: OpenSides,
}

/// A strip that waits.
#[derive(Clone, Debug)]
pub(super) enum HeldStrip {
    /// Its triangles, free to be taken apart, and all open sides.
    Loose { strip: Vec<u32>, triangles: Vec<BlockTriangle>, open: OpenSides },
    /// Its ends, where they are open.
    Chain { chain: Chain, ends: [Option<OpenEnd>; 2] },
}

impl HeldStrip {
    /// Triangles, as far as they count for memory.
    pub(super) fn triangle_count(&self) -> usize {
        match self {
            Self::Loose { triangles, .. } => triangles.len(),
            Self::Chain { chain, .. } => chain.len() - 2,
        }
    }

    fn open_sides(&self) -> impl Iterator<Item = (&OpenSides, End)> {
        let (loose, ends) = match self {
            Self::Loose { open, .. } => (Some((open, End::Front)), None),
            Self::Chain { ends, .. } => (None, Some(ends)),
        };
        let at_ends = ends.into_iter().flat_map(|ends| ends.iter().zip(End::BOTH));
        loose.into_iter().chain(at_ends.filter_map(|(end, which)| Some((&end.as_ref()?.open, which))))
    }

    fn expiry(&self) -> u32 {
        self.open_sides().map(|(open, _)| open.expiry).max().unwrap_or(0)
    }

    /// As it is written.
    pub(super) fn write(&self, out: &mut Vec<u32>) {
        match self {
            Self::Loose { strip, .. } => out.clone_from(strip),
            Self::Chain { chain, .. } => chain.write(out),
        }
    }
}

/// A strip that a block lies beside.
#[derive(Debug)]
pub(super) struct Reached {
    pub(super) strip: HeldStrip,
    /// For a chain, the sides of its end triangles where that is.
    pub(super) at: [Vec<(u32, u32)>; 2],
}

/// All strips that wait.
#[derive(Debug, Default)]
pub(super) struct Held {
    /// By number, which rises in the order in which they came.
    strips: BTreeMap<u32, HeldStrip>,
    by_expiry: BTreeSet<(u32, u32)>,
    /// Which strip may be gone on with beside this side, and at which end.
    sides: NumberMap<(u32, u32), (u32, End)>,
    next_number: u32,
    triangle_count: usize,
    peak_triangle_count: usize,
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

    /// Lets a strip wait.
    pub(super) fn push(&mut self, strip: HeldStrip) {
        let number = self.next_number;
        self.next_number += 1;
        for (open, end) in strip.open_sides() {
            // Where two triangles run along one edge alike, the later one is found; the other leaves in time.
            self.sides.extend(open.sides.iter().map(|&side| (side, (number, end))));
        }
        self.by_expiry.insert((strip.expiry(), number));
        self.triangle_count += strip.triangle_count();
        self.peak_triangle_count = self.peak_triangle_count.max(self.triangle_count);
        self.strips.insert(number, strip);
    }

    /// Takes the strips out that a block's triangles lie beside.
    pub(super) fn take_beside(&mut self, block: &Block) -> Vec<Reached> {
        if self.strips.is_empty() {
            return Vec::new();
        }
        let mut found: BTreeMap<u32, [Vec<(u32, u32)>; 2]> = BTreeMap::new();
        let sides = block.triangles.iter().flat_map(|&BlockTriangle { corners, .. }| sides_of(corners));
        for side in sides.map(|(a, b)| (b, a)) {
            if let Some(&(number, end)) = self.sides.get(&side) {
                found.entry(number).or_default()[end as usize].push(side);
            }
        }
        let reached = |(number, at)| Some(Reached { strip: self.take(number)?, at });
        found.into_iter().filter_map(reached).collect()
    }

    /// Takes out a strip that no block after this one can touch.
    pub(super) fn take_expired(&mut self, block: u32) -> Option<HeldStrip> {
        let &(_, number) = self.by_expiry.first().filter(|&&(expiry, _)| expiry <= block)?;
        self.take(number)
    }

    fn take(&mut self, number: u32) -> Option<HeldStrip> {
        let strip = self.strips.remove(&number)?;
        self.by_expiry.remove(&(strip.expiry(), number));
        self.triangle_count -= strip.triangle_count();
        for &side in strip.open_sides().flat_map(|(open, _)| &open.sides) {
            if self.sides.get(&side).is_some_and(|&(found, _)| found == number) {
                self.sides.remove(&side);
            }
        }
        Some(strip)
    }
}
