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
    entries: Vec<Entry>,
    /// Shares of ways with few links: the link times 16, and the place.
    narrow: Vec<u8>,
    wide: Vec<u32>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Entry {
    first: u32,
    /// Triangles that are shared.
    count: u16,
    /// Links; [`WIDE`] where the shares are words, the first of which tells both numbers.
    link_count: u16,
}

const WIDE: u16 = u16::MAX;
/// Links that a narrow way may have.
const MAX_NARROW: u32 = 15;
/// A narrow share of the full mesh.
const NARROW_FULL: u8 = u8::MAX;

impl OverlapTable {
    /// From the shares of each way.
    pub(super) fn pack(ways: impl IntoIterator<Item = Vec<Share>>) -> Self {
        let mut table = Self::default();
        for way in ways {
            table.push(&way);
        }
        table
    }

    fn push(&mut self, way: &[Share]) {
        let links = way.iter().filter(|share| share.link != Share::FULL).map(|share| share.link + 1);
        let link_count = links.max().unwrap_or(0);
        let is_narrow = link_count <= MAX_NARROW && way.len() < usize::from(WIDE);
        if is_narrow {
            let first = self.narrow.len() as u32;
            self.entries.push(Entry { first, count: way.len() as u16, link_count: link_count as u16 });
            self.narrow.extend(way.iter().map(|share| match share.link {
                Share::FULL => NARROW_FULL,
                link => (link * MAX_RUN + share.place) as u8,
            }));
        } else {
            self.entries.push(Entry { first: self.wide.len() as u32, count: 0, link_count: WIDE });
            self.wide.extend([way.len() as u32, link_count]);
            self.wide.extend(way.iter().map(|share| match share.link {
                Share::FULL => Share::FULL,
                link => link * MAX_RUN + share.place,
            }));
        }
    }

    /// Ways in all.
    pub(super) fn len(&self) -> usize {
        self.entries.len()
    }

    /// Triangles of the ceilings that a way shares.
    pub(super) fn count(&self, way: u32) -> usize {
        let entry = self.entries[way as usize];
        if entry.link_count == WIDE {
            self.wide[entry.first as usize] as usize
        } else {
            usize::from(entry.count)
        }
    }

    /// Where a triangle of a ceiling goes.
    #[inline]
    pub(super) fn share(&self, way: u32, triangle: usize) -> Share {
        let entry = self.entries[way as usize];
        let packed = if entry.link_count == WIDE {
            self.wide[entry.first as usize + 2 + triangle]
        } else {
            match self.narrow[entry.first as usize + triangle] {
                NARROW_FULL => Share::FULL,
                packed => u32::from(packed),
            }
        };
        match packed {
            Share::FULL => Share { link: Share::FULL, place: 0 },
            packed => Share { link: packed / MAX_RUN, place: packed % MAX_RUN },
        }
    }

    /// Where each triangle of a ceiling goes.
    pub(super) fn shares(&self, way: u32) -> impl Iterator<Item = Share> + '_ {
        (0..self.count(way)).map(move |triangle| self.share(way, triangle))
    }

    /// Links that a step with this way has.
    #[inline]
    pub(super) fn link_count(&self, way: u32) -> usize {
        let entry = self.entries[way as usize];
        match entry.link_count {
            WIDE => self.wide[entry.first as usize + 1] as usize,
            count => usize::from(count),
        }
    }

    pub(super) fn bytes(&self) -> usize {
        size_of_val(&self.entries[..]) + size_of_val(&self.narrow[..]) + size_of_val(&self.wide[..])
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
        OverlapTable::pack(self.ways)
    }
}
