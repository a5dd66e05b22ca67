//! How a ceiling is shared among the fragments above, independent of which fragments these are.
//!
//! Each triangle of a ceiling is either replaced by one fragment above or part of the full mesh. Triangles
//! that are consecutive around the restored vertex and go to the same fragment form a **run**: they are
//! also consecutive in the floor of that fragment, so one link serves all of them. Few different sharings
//! exist, so they are indexed like rules.

use std::collections::HashMap;

/// Length of the longest run; longer ones are split.
pub(super) const MAX_RUN: u32 = 16;

/// Destination of a ceiling triangle: a link of its step, and the offset along the run.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(in crate::model) struct Share {
    /// Index of the link, or [`Share::FULL`] for a triangle of the full mesh.
    pub(super) link: u32,
    /// Index of the triangle in the run.
    pub(super) offset: u32,
}

impl Share {
    /// Link index of triangles that no fragment replaces.
    pub(super) const FULL: u32 = u32::MAX;
}

/// All different sharings of a model.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(in crate::model) struct OverlapTable {
    entries: Vec<Entry>,
    /// Shares of sharings with few links: `link * MAX_RUN + offset`.
    narrow: Vec<u8>,
    wide: Vec<u32>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Entry {
    first: u32,
    /// Number of ceiling triangles.
    count: u16,
    /// Number of links, or [`WIDE`] if the shares are in `wide`, preceded by both counts.
    link_count: u16,
}

const WIDE: u16 = u16::MAX;
/// Largest number of links of a narrow sharing.
const MAX_NARROW: u32 = 15;
/// Narrow share of a triangle of the full mesh.
const NARROW_FULL: u8 = u8::MAX;

impl OverlapTable {
    /// Packs a list of sharings.
    pub(super) fn pack(sharings: impl IntoIterator<Item = Vec<Share>>) -> Self {
        let mut table = Self::default();
        for sharing in sharings {
            table.push(&sharing);
        }
        table
    }

    fn push(&mut self, sharing: &[Share]) {
        let links = sharing.iter().filter(|share| share.link != Share::FULL).map(|share| share.link + 1);
        let link_count = links.max().unwrap_or(0);
        let is_narrow = link_count <= MAX_NARROW && sharing.len() < usize::from(WIDE);
        if is_narrow {
            let first = self.narrow.len() as u32;
            self.entries.push(Entry { first, count: sharing.len() as u16, link_count: link_count as u16 });
            self.narrow.extend(sharing.iter().map(|share| match share.link {
                Share::FULL => NARROW_FULL,
                link => (link * MAX_RUN + share.offset) as u8,
            }));
        } else {
            self.entries.push(Entry { first: self.wide.len() as u32, count: 0, link_count: WIDE });
            self.wide.extend([sharing.len() as u32, link_count]);
            self.wide.extend(sharing.iter().map(|share| match share.link {
                Share::FULL => Share::FULL,
                link => link * MAX_RUN + share.offset,
            }));
        }
    }

    /// Number of sharings.
    pub(super) fn len(&self) -> usize {
        self.entries.len()
    }

    /// Number of ceiling triangles of a sharing.
    pub(super) fn count(&self, sharing: u32) -> usize {
        let entry = self.entries[sharing as usize];
        if entry.link_count == WIDE {
            self.wide[entry.first as usize] as usize
        } else {
            usize::from(entry.count)
        }
    }

    /// Returns the destination of a ceiling triangle.
    #[inline]
    pub(super) fn share(&self, sharing: u32, triangle: usize) -> Share {
        let entry = self.entries[sharing as usize];
        let packed = if entry.link_count == WIDE {
            self.wide[entry.first as usize + 2 + triangle]
        } else {
            match self.narrow[entry.first as usize + triangle] {
                NARROW_FULL => Share::FULL,
                packed => u32::from(packed),
            }
        };
        match packed {
            Share::FULL => Share { link: Share::FULL, offset: 0 },
            packed => Share { link: packed / MAX_RUN, offset: packed % MAX_RUN },
        }
    }

    /// Returns the destination of each ceiling triangle.
    pub(super) fn shares(&self, sharing: u32) -> impl Iterator<Item = Share> + '_ {
        (0..self.count(sharing)).map(move |triangle| self.share(sharing, triangle))
    }

    /// Number of links of a step with this sharing.
    #[inline]
    pub(super) fn link_count(&self, sharing: u32) -> usize {
        let entry = self.entries[sharing as usize];
        match entry.link_count {
            WIDE => self.wide[entry.first as usize + 1] as usize,
            count => usize::from(count),
        }
    }

    pub(super) fn bytes(&self) -> usize {
        size_of_val(&self.entries[..]) + size_of_val(&self.narrow[..]) + size_of_val(&self.wide[..])
    }
}

/// Collects different sharings in order of first use.
#[derive(Default)]
pub(super) struct OverlapTableBuilder {
    sharings: Vec<Vec<Share>>,
    indices: HashMap<Vec<Share>, u32>,
}

impl OverlapTableBuilder {
    /// Returns the index of a sharing, adding it if it is new.
    pub(super) fn find(&mut self, sharing: Vec<Share>) -> u32 {
        let fresh = self.sharings.len() as u32;
        *self.indices.entry(sharing).or_insert_with_key(|sharing| {
            self.sharings.push(sharing.clone());
            fresh
        })
    }

    pub(super) fn into_table(self) -> OverlapTable {
        OverlapTable::pack(self.sharings)
    }
}
