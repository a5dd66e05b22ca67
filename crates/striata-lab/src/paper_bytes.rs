//! Bytes of models as the papers count them, for the library's models; each baseline counts its own.

use striata::model::{Fans, LodModel, LodStrips, Mts, Patterns, StoredModel, StripModel};

/// What a paper takes its numbers to need.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Accounting {
    /// 4 bytes each \[RCRG06\].
    Words,
    /// 2 bytes an integer, 4 a long one or a pointer \[BRR02\].
    ShortIntegers,
}

impl Accounting {
    /// Bytes of so many integers, and of so many long ones or pointers.
    pub(crate) fn bytes(self, integers: usize, longs: usize) -> usize {
        match self {
            Self::Words => 4 * (integers + longs),
            Self::ShortIntegers => 2 * integers + 4 * longs,
        }
    }
}

/// A model whose published structures can be counted.
pub trait PaperBytes: LodModel {
    /// Bytes of the static half as the papers count: their structures, and not ours; positions not counted.
    fn paper_bytes(&self, accounting: Accounting) -> usize;
}

impl PaperBytes for LodStrips<'_> {
    /// The structures of \[RCRG06\], its figure 3: a `Collapse` for each vertex, a pointer for each strip, a
    /// `Change` of two words for each step, a `RecordChange` of four for each strip that it affects, and a word
    /// for each place that is collapsed or resized.
    fn paper_bytes(&self, accounting: Accounting) -> usize {
        let edits = self.edit_counts();
        let records = 3 * edits.strips + edits.places + edits.drops;
        let integers = self.vertex_count() + self.indices().len() + self.step_count() + records;
        accounting.bytes(integers, self.strip_count() + self.step_count() + edits.strips)
    }
}

impl PaperBytes for Mts<'_> {
    /// What \[BRR02\] would list: a vertex and a `res` for each column, a column and a `res` for each break, two pointers for
    /// each strip; a target for each vertex and a strip for each change of one, which coherence needs.
    fn paper_bytes(&self, accounting: Accounting) -> usize {
        let integers = self.break_count() + self.change_count();
        let columns = 2 * self.indices().len() + self.break_count();
        let target_count = self.vertex_count() - self.vertex_count_at(0);
        accounting.bytes(integers, columns + 2 * self.strip_count() + target_count)
    }
}

impl PaperBytes for Fans {
    /// Section 3.6.2 of \[Cor01\] without the data of criteria: a pointer and two counts a vertex, a word for each node of
    /// a ring, a word and as many bytes as its mask needs for each dependency. Arcs that last as long as their vertex
    /// count as one dependency.
    fn paper_bytes(&self, accounting: Accounting) -> usize {
        let (mut nodes, mut dependencies, mut mask_bytes) = (0, 0, 0);
        for fan in self.table_fans() {
            let count = usize::from(fan.lasting_arcs() != 0) + fan.makers().count();
            nodes += fan.node_count();
            dependencies += count;
            mask_bytes += count * fan.node_count().div_ceil(8);
        }
        let longs = self.vertex_count() + nodes + dependencies;
        accounting.bytes(2 * self.vertex_count(), longs) + mask_bytes
    }
}

impl PaperBytes for Patterns {
    /// The paper's bits of each fragment and each overlap, with the overlaps that there are; see `pattern_bytes`.
    fn paper_bytes(&self, _: Accounting) -> usize {
        pattern_bytes(self.fragment_count(), self.overlap_count())
    }
}

/// Bits that \[KG98\] counts for a fragment: two anchors, the rule with the number of loops, and the link down.
const FRAGMENT_BITS: usize = 64 + 16 + 36;

/// Bits that it counts for an overlap: a fragment and one of its loops.
const OVERLAP_BITS: usize = 36;

/// 116 bits a fragment and 36 an overlap: the paper's 206 bits are for 5/2 a fragment. The base and the rules are not
/// counted, nor does the size of integers matter.
pub(crate) fn pattern_bytes(fragment_count: usize, overlap_count: usize) -> usize {
    (fragment_count * FRAGMENT_BITS + overlap_count * OVERLAP_BITS).div_ceil(8)
}
