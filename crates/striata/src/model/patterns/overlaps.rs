//! How a ceiling is shared among the fragments above, independent of which fragments these are.
//!
//! Each triangle of a ceiling is either replaced by one fragment above or part of the full mesh. Triangles
//! that are consecutive around the restored vertex and go to the same fragment form a **run**: they are
//! also consecutive in the floor of that fragment, so one link serves all of them. Few different sharings
//! exist, so they are indexed like rules.
//!
//! A sharing of at most 8 triangles takes 32 bits, one of at most 16 triangles 64 bits: four bits for each
//! run, in the order of the triangles. They contain its length and whether it is part of the full mesh;
//! the others take the links of the step one after the other. If the last run continues at the first
//! triangle, so that both parts have the same link, the sharing **wraps**.

use std::collections::HashMap;
use std::convert::Infallible;
use std::ops::Range;

/// Length of the longest run; longer ones are split.
pub(super) const MAX_RUN: u32 = 16;

/// Location of a triangle in a floor: where its run begins, and how many triangles further around its
/// vertex it is. The half-edge follows when the floor is replaced, because only then the rule is known.
#[inline]
pub(super) fn run_location(code: u32, offset: u32) -> u32 {
    code * MAX_RUN + offset
}

/// Destination of a ceiling triangle: a link of its step, and the offset along the run.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(in crate::model) struct CeilingShare {
    /// Index of the link, or [`CeilingShare::FULL`] for a triangle of the full mesh.
    pub link: u32,
    /// Index of the triangle in the run.
    pub offset: u32,
}

impl CeilingShare {
    /// Link index of triangles that no fragment replaces.
    pub(super) const FULL: u32 = u32::MAX;

    /// A triangle that no fragment replaces.
    const NOWHERE: Self = Self { link: Self::FULL, offset: 0 };

    /// The destination of the triangle `count` places further along the run.
    fn after(self, count: u32) -> Self {
        if self.link == Self::FULL { self } else { Self { offset: self.offset + count, ..self } }
    }
}

/// All different sharings of a model: first short ones, those that wrap last, then long ones in the same
/// order, then wide ones.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(in crate::model) struct OverlapTable {
    /// Sharings of at most 8 triangles.
    short: Vec<u32>,
    /// Number of short sharings that do not wrap.
    plain_short_count: u32,
    /// Sharings of at most 16 triangles.
    long: Vec<u64>,
    plain_long_count: u32,
    wide: Vec<WideEntry>,
    /// Shares of wide sharings: `link * MAX_RUN + offset`.
    wide_shares: Vec<u32>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct WideEntry {
    first: u32,
    count: u32,
}

/// Number of triangles of a short sharing, and of a long one.
const SHORT_TRIANGLES: usize = 8;
const LONG_TRIANGLES: usize = 16;
/// Marks a run of triangles of the full mesh. The lower bits are the length, where 0 stands for 8; a run
/// with a link has at most 7 triangles, so that no run is 0.
const FULL_RUN: u64 = 8;

/// One sharing.
#[derive(Clone, Copy, Debug)]
pub(super) enum Sharing<'a> {
    /// Four bits for each run, and whether the last one continues at the first triangle.
    Packed { runs: u64, wraps: bool },
    /// A packed share for each triangle.
    Wide(&'a [u32]),
}

impl OverlapTable {
    fn push_wide(&mut self, sharing: &[CeilingShare]) {
        let (first, count) = (self.wide_shares.len() as u32, sharing.len() as u32);
        self.wide.push(WideEntry { first, count });
        self.wide_shares.extend(sharing.iter().map(|share| match share.link {
            CeilingShare::FULL => CeilingShare::FULL,
            link => link * MAX_RUN + share.offset,
        }));
    }

    /// Number of sharings.
    pub(super) fn len(&self) -> usize {
        self.short.len() + self.long.len() + self.wide.len()
    }

    /// Returns a sharing.
    #[inline]
    pub(super) fn get(&self, sharing: u32) -> Sharing<'_> {
        if let Some(&runs) = self.short.get(sharing as usize) {
            return Sharing::Packed { runs: u64::from(runs), wraps: sharing >= self.plain_short_count };
        }
        self.get_large(sharing - self.short.len() as u32)
    }

    fn get_large(&self, index: u32) -> Sharing<'_> {
        if let Some(&runs) = self.long.get(index as usize) {
            return Sharing::Packed { runs, wraps: index >= self.plain_long_count };
        }
        let WideEntry { first, count } = self.wide[index as usize - self.long.len()];
        Sharing::Wide(&self.wide_shares[first as usize..(first + count) as usize])
    }

    /// Number of triangles of a ceiling with this sharing.
    pub(super) fn count(&self, sharing: u32) -> usize {
        match self.get(sharing) {
            Sharing::Packed { runs, .. } => packed_count(runs),
            Sharing::Wide(shares) => shares.len(),
        }
    }

    /// Returns the destinations of the triangles of a ceiling.
    pub(super) fn shares(&self, sharing: u32) -> Vec<CeilingShare> {
        let mut out = Vec::new();
        self.get(sharing).for_each_run(self.count(sharing), |run, share| {
            out.extend(run.zip(0..).map(|(_, i)| share.after(i)));
        });
        out
    }

    pub(super) fn bytes(&self) -> usize {
        size_of_val(&self.short[..])
            + size_of_val(&self.long[..])
            + size_of_val(&self.wide[..])
            + size_of_val(&self.wide_shares[..])
    }
}

impl Sharing<'_> {
    /// Calls `visit` with each range of consecutive triangles that have the same link, and the destination
    /// of the first; the following ones have the next offsets.
    ///
    /// # Errors
    /// The first error of `visit`.
    #[inline(always)]
    pub(super) fn try_for_each_run<E>(
        self,
        count: usize,
        mut visit: impl FnMut(Range<usize>, CeilingShare) -> Result<(), E>,
    ) -> Result<(), E> {
        let (mut left, wraps) = match self {
            Self::Packed { runs, wraps } => (runs, wraps),
            Self::Wide(_) => (0, false),
        };
        let mut offset = if wraps { last_length(left) } else { 0 };
        let mut link = 0;
        let mut triangle = 0;
        while triangle < count {
            let (length, share) = match self {
                Self::Packed { .. } => {
                    let run = left & 15;
                    left >>= 4;
                    let length = run_length(run);
                    if run >= FULL_RUN {
                        (length, CeilingShare::NOWHERE)
                    } else {
                        let is_continued = wraps && left == 0;
                        let share = CeilingShare { link: if is_continued { 0 } else { link }, offset };
                        link += 1;
                        offset = 0;
                        (length, share)
                    }
                }
                Self::Wide(shares) => (1, unpack(shares[triangle])),
            };
            visit(triangle..triangle + length, share)?;
            triangle += length;
        }
        Ok(())
    }

    /// Calls `visit` with each range of consecutive triangles that have the same link, and the destination
    /// of the first; the following ones have the next offsets.
    #[inline(always)]
    pub(super) fn for_each_run(self, count: usize, mut visit: impl FnMut(Range<usize>, CeilingShare)) {
        let Ok(()) = self.try_for_each_run(count, |run, share| {
            visit(run, share);
            Ok::<(), Infallible>(())
        });
    }
}

/// Number of triangles of a run in a short or long sharing.
#[inline]
fn run_length(run: u64) -> usize {
    ((run + 7) % 8 + 1) as usize
}

/// Number of triangles of the last run.
#[inline]
fn last_length(runs: u64) -> u32 {
    let count = 16 - runs.leading_zeros() / 4;
    run_length(runs >> (4 * count.saturating_sub(1)) & 15) as u32
}

/// Number of triangles of all runs.
fn packed_count(runs: u64) -> usize {
    let all = (0..16).map(|i| runs >> (4 * i) & 15);
    all.take_while(|&run| run != 0).map(run_length).sum()
}

fn unpack(packed: u32) -> CeilingShare {
    match packed {
        CeilingShare::FULL => CeilingShare::NOWHERE,
        packed => CeilingShare { link: packed / MAX_RUN, offset: packed % MAX_RUN },
    }
}

/// Packs a sharing into 64 bits, and returns whether it wraps. `None` if it has too many triangles, too long
/// runs, or links in another order than that of the triangles.
fn to_packed(sharing: &[CeilingShare]) -> Option<(u64, bool)> {
    if sharing.len() > LONG_TRIANGLES {
        return None;
    }
    let mut runs = 0;
    let is_start = |i: usize| {
        let (before, here) = (sharing[i - 1], sharing[i]);
        // A run of the full mesh ends after 8 triangles.
        let continues =
            before.link == here.link && (here.link == CeilingShare::FULL || here.offset == before.offset + 1);
        !continues
    };
    let mut triangle = 0;
    let mut count = 0;
    while triangle < sharing.len() {
        let is_full = sharing[triangle].link == CeilingShare::FULL;
        let limit = sharing.len().min(triangle + if is_full { 8 } else { 7 });
        let end = (triangle + 1..limit).find(|&i| is_start(i)).unwrap_or(limit);
        let length = (end - triangle) as u64 % 8;
        runs |= (if is_full { FULL_RUN | length } else { length }) << (4 * count);
        count += 1;
        triangle = end;
    }
    let wraps = sharing.first().is_some_and(|first| first.link != CeilingShare::FULL && first.offset > 0);
    let mut found = Vec::with_capacity(sharing.len());
    Sharing::Packed { runs, wraps }.for_each_run(sharing.len(), |run, share| {
        found.extend(run.zip(0..).map(|(_, i)| share.after(i)));
    });
    (found == sharing).then_some((runs, wraps))
}

/// Collects different sharings in order of first use.
#[derive(Default)]
pub(super) struct OverlapTableBuilder {
    /// Short sharings without and with a run that wraps, then long ones.
    packed: [Vec<u64>; 4],
    table: OverlapTable,
    indices: HashMap<Vec<CeilingShare>, FoundSharing>,
}

/// A sharing that has been found: its class and its index in it, until all sharings are known.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct FoundSharing {
    class: usize,
    index: u32,
}

/// Class of sharings that are not packed.
const WIDE_CLASS: usize = 4;

impl OverlapTableBuilder {
    /// Returns a sharing, adding it if it is new.
    pub(super) fn find(&mut self, sharing: &[CeilingShare]) -> FoundSharing {
        if let Some(&found) = self.indices.get(sharing) {
            return found;
        }
        let found = match to_packed(sharing) {
            Some((runs, wraps)) => {
                let class = usize::from(wraps) + if sharing.len() > SHORT_TRIANGLES { 2 } else { 0 };
                self.packed[class].push(runs);
                FoundSharing { class, index: self.packed[class].len() as u32 - 1 }
            }
            None => {
                self.table.push_wide(sharing);
                FoundSharing { class: WIDE_CLASS, index: self.table.wide.len() as u32 - 1 }
            }
        };
        self.indices.insert(sharing.to_vec(), found);
        found
    }

    /// Adds a sharing with the next index. Returns false if it is not new, or if it belongs before others.
    pub(super) fn push_next(&mut self, sharing: &[CeilingShare]) -> bool {
        let count = self.indices.len();
        let last = (0..WIDE_CLASS).rev().find(|&class| !self.packed[class].is_empty());
        let last = if self.table.wide.is_empty() { last.unwrap_or(0) } else { WIDE_CLASS };
        let found = self.find(sharing);
        self.indices.len() > count && found.class >= last
    }

    pub(super) fn into_table(self) -> OverlapTable {
        let [plain_short, wrapped_short, plain_long, wrapped_long] = self.packed;
        let (plain_short_count, plain_long_count) = (plain_short.len() as u32, plain_long.len() as u32);
        let short = plain_short.into_iter().chain(wrapped_short).map(|runs| runs as u32).collect();
        let long = plain_long.into_iter().chain(wrapped_long).collect();
        OverlapTable { short, plain_short_count, long, plain_long_count, ..self.table }
    }
}

impl OverlapTable {
    /// Returns the index of a sharing that a builder has found.
    pub(super) fn index_of(&self, found: FoundSharing) -> u32 {
        let (short, long) = (self.short.len() as u32, self.long.len() as u32);
        let firsts = [0, self.plain_short_count, short, short + self.plain_long_count, short + long];
        firsts[found.class] + found.index
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::Random;

    fn share(link: u32, offset: u32) -> CeilingShare {
        CeilingShare { link, offset }
    }

    #[test]
    fn sharings_are_read_as_they_were_packed() {
        let full = CeilingShare::NOWHERE;
        let cases = [
            (vec![], 0),
            (vec![full; 8], 0),
            // A run that continues at the beginning.
            (vec![share(0, 2), share(0, 3), share(1, 0), full, share(0, 0), share(0, 1)], 1),
            // One run for the whole ring.
            (vec![share(0, 0), share(0, 1), share(0, 2)], 0),
            ((0..8).map(|i| share(i, 0)).collect(), 0),
            (vec![full; 9], 2),
            (vec![full; 16], 2),
            ((0..16).map(|i| share(i, 0)).collect(), 2),
            (vec![full; 17], WIDE_CLASS),
            // The runs of a ring of 20 triangles, a run that is too long, and one that is not consecutive.
            ((0..20).map(|i| share(i / 16, i % 16)).collect(), WIDE_CLASS),
            ((0..8).map(|i| share(0, i)).collect(), WIDE_CLASS),
            (vec![share(0, 0), full, share(0, 1)], WIDE_CLASS),
            (vec![share(1, 0), share(0, 0)], WIDE_CLASS),
        ];
        let mut builder = OverlapTableBuilder::default();
        let found: Vec<FoundSharing> = cases.iter().map(|case| builder.find(&case.0)).collect();
        let table = builder.into_table();
        assert_eq!(table.len(), cases.len());
        for ((sharing, class), found) in cases.iter().zip(found) {
            assert_eq!(found.class, *class, "{sharing:?}");
            let index = table.index_of(found);
            assert_eq!(&table.shares(index), sharing);
            assert_eq!(table.count(index), sharing.len());
        }
    }

    #[test]
    fn random_runs_are_packed() {
        let mut random = Random::new(4);
        for _ in 0..2000 {
            let count = 1 + random.below(16) as usize;
            // Where runs begin, on a ring that is then turned.
            let mut runs: Vec<Option<usize>> = Vec::new();
            let mut link = 0;
            while runs.len() < count {
                let length = (1 + random.below(4) as usize).min(count - runs.len());
                let is_full = random.below(4) == 0;
                runs.extend((0..length).map(|i| (!is_full).then_some(link * 16 + i)));
                link += 1;
            }
            runs.rotate_left(if link == 1 { 0 } else { random.below(count as u32) as usize });
            // Links are numbered in the order of their first triangle.
            let mut order: Vec<usize> = Vec::new();
            let mut sharing = Vec::new();
            for run in runs {
                sharing.push(run.map_or(CeilingShare::NOWHERE, |run| {
                    let known = order.iter().position(|&link| link == run / 16);
                    let link = known.unwrap_or_else(|| {
                        order.push(run / 16);
                        order.len() - 1
                    });
                    share(link as u32, run as u32 % 16)
                }));
            }
            let (runs, wraps) = to_packed(&sharing).unwrap_or_else(|| panic!("{sharing:?}"));
            assert_eq!(packed_count(runs), count);
            assert_eq!(wraps, sharing[0].link != CeilingShare::FULL && sharing[0].offset > 0);
        }
    }
}
