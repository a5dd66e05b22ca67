//! How the fragments above share a ceiling among them, whatever fragments they are.
//!
//! Each triangle of a ceiling is replaced by one fragment above, or is of the full mesh. Triangles that follow each other around
//! the restored vertex and go to the same fragment are a **run**: they also follow each other in that fragment's floor, so one
//! link serves all. Few ways to share a ceiling exist, so they are numbered as rules are.

use std::collections::HashMap;

/// Longest run; a longer one is cut.
pub(super) const MAX_RUN: u32 = 16;

/// Where a triangle of a ceiling goes: to which link of its step, and how far along the run.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(in crate::model) struct Share {
    /// Number of the link; [`Share::FULL`] for a triangle of the full mesh.
    pub(super) link: u32,
    /// Its place in the run.
    pub(super) place: u32,
}

impl Share {
    /// The link of triangles that nothing replaces.
    pub(super) const FULL: u32 = u32::MAX;
}

/// All ways to share a ceiling that a model has.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(in crate::model) struct OverlapTable {
    shares: Vec<Share>,
    /// First share of each way, closed by their number.
    firsts: Vec<u32>,
    /// Links of each way.
    link_counts: Vec<u32>,
}

impl OverlapTable {
    /// From the shares of each way.
    pub(super) fn from_ways(ways: impl Iterator<Item = Vec<Share>>) -> Self {
        let mut table = Self { firsts: vec![0], ..Self::default() };
        for way in ways {
            let links = way.iter().filter(|share| share.link != Share::FULL).map(|share| share.link + 1);
            table.link_counts.push(links.max().unwrap_or(0));
            table.shares.extend(way);
            table.firsts.push(table.shares.len() as u32);
        }
        table
    }

    /// Ways in all.
    pub(super) fn len(&self) -> usize {
        self.link_counts.len()
    }

    /// Where each triangle of a ceiling goes.
    #[inline]
    pub(super) fn shares(&self, way: u32) -> &[Share] {
        &self.shares[self.firsts[way as usize] as usize..self.firsts[way as usize + 1] as usize]
    }

    /// Links that a step with this way has.
    #[inline]
    pub(super) fn link_count(&self, way: u32) -> usize {
        self.link_counts[way as usize] as usize
    }

    pub(super) fn bytes(&self) -> usize {
        size_of_val(&self.shares[..]) + size_of_val(&self.firsts[..]) + size_of_val(&self.link_counts[..])
    }
}

/// Numbers ways as they come.
#[derive(Default)]
pub(super) struct OverlapBook {
    ways: Vec<Vec<Share>>,
    numbers: HashMap<Vec<Share>, u32>,
}

impl OverlapBook {
    pub(super) fn find(&mut self, way: Vec<Share>) -> u32 {
        let fresh = self.ways.len() as u32;
        *self.numbers.entry(way).or_insert_with_key(|way| {
            self.ways.push(way.clone());
            fresh
        })
    }

    pub(super) fn into_table(self) -> OverlapTable {
        OverlapTable::from_ways(self.ways.into_iter())
    }
}
