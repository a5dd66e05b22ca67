//! The published record of a fragment, packed bit by bit.
//!
//! ```text
//! heads   | anchor 32 | anchor 32 | rule 12 | down: fragment 32, loop 4 |   112 bits each
//! counts  | loops 4 |                                                         4 bits each
//! links   | fragment 32, loop 4 |                                            36 bits each, by fragment
//! ```
//!
//! The paper does not say how a fragment's links are found. Here the first link of every 32nd fragment is
//! stored, which takes one bit per fragment, and the counts in between are summed, sixteen at a time.

use striata::model::Bits;

/// Number of loops that 4 bits can address; one value marks the end of a loop.
pub(super) const MAX_LOOPS: usize = 15;

/// Replaces the loop index in the link that leads back to the covering fragment.
const END: u32 = MAX_LOOPS as u32;

const RULE_BITS: u32 = 12;
const LOOP_BITS: u32 = 4;
const LINK_BITS: u32 = 32 + LOOP_BITS;
const HEAD_BITS: u32 = 64 + RULE_BITS + LINK_BITS;
/// Counts per word.
const COUNTS_PER_WORD: usize = 16;
/// Words of counts between two stored offsets.
const WORDS_PER_BLOCK: usize = 2;

/// An element of a loop: the next fragment, and which of its loops continues this one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct LoopLink {
    pub step: u32,
    loop_index: u32,
}

impl LoopLink {
    /// Returns the index of the loop that continues this one, among the loops of its fragment.
    pub(super) fn loop_index(self) -> usize {
        self.loop_index as usize
    }

    pub(super) fn to(step: u32, loop_index: usize) -> Self {
        Self { step, loop_index: loop_index as u32 }
    }

    /// A link back to the fragment that owns the loop.
    pub(super) fn back_to(step: u32) -> Self {
        Self { step, loop_index: END }
    }

    #[inline]
    fn is_back(self) -> bool {
        self.loop_index == END
    }

    fn bits(self) -> u64 {
        u64::from(self.step) | u64::from(self.loop_index) << 32
    }

    fn of_bits(bits: u64) -> Self {
        Self { step: bits as u32, loop_index: (bits >> 32) as u32 }
    }
}

/// The part of a fragment's record that precedes its links.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct LoopHead {
    pub anchors: [u32; 2],
    pub rule: u32,
    pub down: LoopLink,
}

/// The records of all fragments of a model.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct LoopRecords {
    count: usize,
    heads: Bits,
    /// Number of loops through each fragment, sixteen per word.
    counts: Vec<u64>,
    links: Bits,
    link_count: usize,
    /// First link of each block.
    firsts: Vec<u32>,
}

impl LoopRecords {
    /// Appends the record of a fragment.
    pub(super) fn push(&mut self, head: &LoopHead, links: &[LoopLink]) {
        if self.count.is_multiple_of(COUNTS_PER_WORD) {
            if self.counts.len().is_multiple_of(WORDS_PER_BLOCK) {
                self.firsts.push(self.link_count as u32);
            }
            self.counts.push(0);
        }
        self.counts[self.count / COUNTS_PER_WORD] |=
            (links.len() as u64) << (4 * (self.count % COUNTS_PER_WORD));
        head.anchors.iter().for_each(|&anchor| self.heads.push(u64::from(anchor), 32));
        self.heads.push(u64::from(head.rule), RULE_BITS);
        self.heads.push(head.down.bits(), LINK_BITS);
        links.iter().for_each(|link| self.links.push(link.bits(), LINK_BITS));
        self.count += 1;
        self.link_count += links.len();
    }

    pub(super) fn len(&self) -> usize {
        self.count
    }

    /// Number of links in all loops, without those down: one per overlap.
    pub(super) fn link_count(&self) -> usize {
        self.link_count
    }

    #[inline]
    pub(super) fn head(&self, step: u32) -> LoopHead {
        let at = step as usize * HEAD_BITS as usize;
        let anchors = [0, 32].map(|behind| self.heads.get(at + behind, 32) as u32);
        let rule = self.heads.get(at + 64, RULE_BITS) as u32;
        LoopHead { anchors, rule, down: self.down(step) }
    }

    #[inline]
    pub(super) fn down(&self, step: u32) -> LoopLink {
        let at = step as usize * HEAD_BITS as usize + 64 + RULE_BITS as usize;
        LoopLink::of_bits(self.heads.get(at, LINK_BITS))
    }

    #[inline]
    pub(super) fn loop_count(&self, step: u32) -> usize {
        let step = step as usize;
        (self.counts[step / COUNTS_PER_WORD] >> (4 * (step % COUNTS_PER_WORD)) & 15) as usize
    }

    #[inline]
    fn link(&self, step: u32, loop_index: u32) -> LoopLink {
        let word = step as usize / COUNTS_PER_WORD;
        let block = word / WORDS_PER_BLOCK;
        let mut at = self.firsts[block] as usize + loop_index as usize;
        at += self.counts[block * WORDS_PER_BLOCK..word].iter().map(|&counts| sum(counts)).sum::<usize>();
        let before = (1u64 << (4 * (step as usize % COUNTS_PER_WORD))) - 1;
        at += sum(self.counts[word] & before);
        LoopLink::of_bits(self.links.get(at * LINK_BITS as usize, LINK_BITS))
    }

    /// The fragments that a fragment covers, in the order of its loop.
    #[inline]
    pub(super) fn covered(&self, step: u32) -> impl Iterator<Item = u32> + '_ {
        let mut at = self.down(step);
        std::iter::from_fn(move || {
            let here = at;
            (!here.is_back()).then(|| {
                at = self.link(here.step, here.loop_index);
                here.step
            })
        })
    }

    /// The fragments that cover a fragment, each found at the end of a loop.
    #[inline]
    pub(super) fn covering(&self, step: u32) -> impl Iterator<Item = u32> + '_ {
        (0..self.loop_count(step) as u32).map(move |loop_index| {
            let mut at = self.link(step, loop_index);
            while !at.is_back() {
                at = self.link(at.step, at.loop_index);
            }
            at.step
        })
    }

    /// Bytes of the heads, of the loops with their counts, and of the offsets of links.
    pub(super) fn bytes(&self) -> [usize; 3] {
        [self.heads.bytes(), self.links.bytes() + size_of_val(&self.counts[..]), 4 * self.firsts.len()]
    }
}

/// Sum of sixteen 4-bit integers.
#[inline]
fn sum(counts: u64) -> usize {
    const EVEN: u64 = 0x0F0F_0F0F_0F0F_0F0F;
    let pairs = (counts & EVEN) + (counts >> 4 & EVEN);
    // Eight sums of at most 30 fit in one byte together.
    (pairs.wrapping_mul(0x0101_0101_0101_0101) >> 56) as usize
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn loops_are_followed_both_ways() {
        let head = |down| LoopHead { anchors: [u32::MAX, 7], rule: 4095, down };
        let mut records = LoopRecords::default();
        // 70 covers 68 and 3, 69 covers 3; all others cover nothing.
        for step in 0..71 {
            let (down, links) = match step {
                3 => (LoopLink::back_to(3), vec![LoopLink::back_to(70), LoopLink::back_to(69)]),
                68 => (LoopLink::back_to(68), vec![LoopLink::to(3, 0)]),
                69 => (LoopLink::to(3, 1), vec![]),
                70 => (LoopLink::to(68, 0), vec![]),
                other => (LoopLink::back_to(other), vec![]),
            };
            records.push(&head(down), &links);
        }
        let covered = |step| records.covered(step).collect::<Vec<_>>();
        let covering = |step| records.covering(step).collect::<Vec<_>>();
        assert_eq!((covered(70), covered(69), covered(68)), (vec![68, 3], vec![3], vec![]));
        assert_eq!((covering(3), covering(68), covering(70)), (vec![70, 69], vec![70], vec![]));
        assert_eq!(records.head(70), head(LoopLink::to(68, 0)));
        assert_eq!((records.len(), records.link_count()), (71, 3));
    }

    #[test]
    fn sixteen_counts_are_summed_in_one_word() {
        assert_eq!(sum(u64::MAX), 240);
        assert_eq!(sum(0x1234_5678_9ABC_DEF0), 120);
    }
}
