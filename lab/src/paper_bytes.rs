//! Memory sizes of the library's models as the papers count them; each baseline counts its own.

use striata::model::{Fans, LodModel, LodStrips, Mts, Patterns, StoredModel, StripModel};

/// Integer sizes that a paper assumes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Accounting {
    /// 4 bytes for every number \[RCRG06\].
    Words,
    /// 2 bytes per integer, 4 bytes per long integer or pointer \[BRR02\].
    ShortIntegers,
}

impl Accounting {
    /// Bytes of `integers` integers and `longs` long integers or pointers.
    pub(crate) fn bytes(self, integers: usize, longs: usize) -> usize {
        match self {
            Self::Words => 4 * (integers + longs),
            Self::ShortIntegers => 2 * integers + 4 * longs,
        }
    }
}

/// A model whose structures can be counted as in its paper.
pub trait PaperBytes: LodModel {
    /// Bytes of the static half as its paper counts them: the published structures instead of ours,
    /// without positions.
    fn paper_bytes(&self, accounting: Accounting) -> usize;
}

impl PaperBytes for LodStrips<'_> {
    /// As \[RCRG06\] would count this model: a word per index of any stage and a pointer per strip; for each
    /// vertex that collapses its target, two counts and a pointer to its record; a word per replaced slot,
    /// and three per dropped run (strip, first index, count).
    fn paper_bytes(&self, accounting: Accounting) -> usize {
        let edits = self.edit_counts();
        let target_count = self.vertex_count() - self.vertex_count_at(0);
        let slot_count: usize = self.stage_index_counts().sum();
        let records = 3 * target_count + edits.substitutions + 3 * edits.drops;
        accounting.bytes(slot_count + records, self.strip_count() + target_count)
    }
}

impl PaperBytes for Mts<'_> {
    /// As \[BRR02\] would count this model: a vertex and a `res` per column, a column and a `res` per break,
    /// two pointers per strip; and for coherence a target per vertex and a strip index per change.
    fn paper_bytes(&self, accounting: Accounting) -> usize {
        let integers = self.break_count() + self.change_count();
        let columns = 2 * self.slot_count() + self.break_count();
        let target_count = self.vertex_count() - self.vertex_count_at(0);
        accounting.bytes(integers, columns + 2 * self.strip_count() + target_count)
    }
}

impl PaperBytes for Fans {
    /// Section 3.6.2 of \[Cor01\] without the data of criteria: a pointer and two counts per vertex, a
    /// word per node of a ring, a word and a byte-aligned mask per dependency. Arcs that last as long as
    /// their vertex count as one dependency.
    fn paper_bytes(&self, accounting: Accounting) -> usize {
        let (mut nodes, mut dependencies, mut mask_bytes) = (0, 0, 0);
        for fan in self.table_fans() {
            let count = usize::from(fan.permanent_arcs() != 0) + fan.makers().count();
            nodes += fan.node_count();
            dependencies += count;
            mask_bytes += count * fan.node_count().div_ceil(8);
        }
        let longs = self.vertex_count() + nodes + dependencies;
        accounting.bytes(2 * self.vertex_count(), longs) + mask_bytes
    }
}

impl PaperBytes for Patterns {
    /// The paper's bits per fragment and per overlap, with the actual number of overlaps; see
    /// `pattern_bytes`.
    fn paper_bytes(&self, _: Accounting) -> usize {
        pattern_bytes(self.fragment_count(), self.overlap_count())
    }
}

/// Bits that \[KG98\] counts per fragment: two anchors, the rule with the number of loops, and the link down.
const FRAGMENT_BITS: usize = 64 + 16 + 36;

/// Bits that \[KG98\] counts per overlap: a fragment and one of its loops.
const OVERLAP_BITS: usize = 36;

/// 116 bits per fragment and 36 per overlap: the paper's 206 bits assume 5/2 overlaps per fragment. The
/// base and the rules are not counted, and the size of integers does not matter.
pub(crate) fn pattern_bytes(fragment_count: usize, overlap_count: usize) -> usize {
    (fragment_count * FRAGMENT_BITS + overlap_count * OVERLAP_BITS).div_ceil(8)
}
