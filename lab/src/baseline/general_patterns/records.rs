//! Records of fragments with rules for any ceiling, packed bit by bit; see the [module above](super).

use striata::model::Bits;

/// Number of loops that 5 bits can address; one value marks the end of a loop.
pub(super) const MAX_LOOPS: usize = 31;

/// Replaces the loop index in the link that leads back to the covering fragment.
const END: u32 = MAX_LOOPS as u32;

const RULE_BITS: u32 = 16;
const LOOP_BITS: u32 = 5;
const LINK_BITS: u32 = 32 + LOOP_BITS;
const HEAD_BITS: u32 = 64 + RULE_BITS + LINK_BITS;
/// Fragments between two stored offsets.
const BLOCK: usize = 32;

/// An element of a loop: the next fragment, and which of its loops continues this one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct PatternLink {
    step: u32,
    loop_index: u32,
}

impl PatternLink {
    pub(super) fn to(step: u32, loop_index: usize) -> Self {
        Self { step, loop_index: loop_index as u32 }
    }

    /// A link back to the fragment that owns the loop.
    pub(super) fn back_to(step: u32) -> Self {
        Self { step, loop_index: END }
    }

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
pub(super) struct PatternHead {
    pub anchors: [u32; 2],
    pub rule: u32,
    pub down: PatternLink,
}

/// The records of all fragments of a model.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct PatternRecords {
    count: usize,
    heads: Bits,
    /// Number of loops through each fragment.
    counts: Bits,
    links: Bits,
    link_count: usize,
    /// Vertices that fragments list.
    listed: Vec<u32>,
    /// First link and first listed vertex of each block.
    firsts: Vec<[u32; 2]>,
}

impl PatternRecords {
    /// Appends the record of a fragment.
    pub(super) fn push(&mut self, head: &PatternHead, links: &[PatternLink], listed: &[u32]) {
        if self.count.is_multiple_of(BLOCK) {
            self.firsts.push([self.link_count as u32, self.listed.len() as u32]);
        }
        head.anchors.iter().for_each(|&anchor| self.heads.push(u64::from(anchor), 32));
        self.heads.push(u64::from(head.rule), RULE_BITS);
        self.heads.push(head.down.bits(), LINK_BITS);
        self.counts.push(links.len() as u64, LOOP_BITS);
        links.iter().for_each(|link| self.links.push(link.bits(), LINK_BITS));
        self.listed.extend_from_slice(listed);
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

    /// Number of vertices that fragments list.
    pub(super) fn listed_count(&self) -> usize {
        self.listed.len()
    }

    pub(super) fn head(&self, step: u32) -> PatternHead {
        let at = step as usize * HEAD_BITS as usize;
        let anchors = [0, 32].map(|behind| self.heads.get(at + behind, 32) as u32);
        let rule = self.heads.get(at + 64, RULE_BITS) as u32;
        PatternHead { anchors, rule, down: self.down(step) }
    }

    /// The vertices that a fragment lists. `count_of` gives their number for each rule.
    pub(super) fn listed(&self, step: u32, count_of: impl Fn(u32) -> usize) -> &[u32] {
        let block = step as usize / BLOCK;
        let before: usize = ((block * BLOCK) as u32..step).map(|step| count_of(self.head(step).rule)).sum();
        let first = self.firsts[block][1] as usize + before;
        &self.listed[first..first + count_of(self.head(step).rule)]
    }

    fn down(&self, step: u32) -> PatternLink {
        let at = step as usize * HEAD_BITS as usize + 64 + RULE_BITS as usize;
        PatternLink::of_bits(self.heads.get(at, LINK_BITS))
    }

    fn loop_count(&self, step: u32) -> usize {
        self.counts.get(step as usize * LOOP_BITS as usize, LOOP_BITS) as usize
    }

    fn link(&self, step: u32, loop_index: u32) -> PatternLink {
        let block = step as usize / BLOCK;
        let before: usize = ((block * BLOCK) as u32..step).map(|step| self.loop_count(step)).sum();
        let at = self.firsts[block][0] as usize + before + loop_index as usize;
        PatternLink::of_bits(self.links.get(at * LINK_BITS as usize, LINK_BITS))
    }

    /// The fragments that a fragment covers, in the order of its loop.
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
    pub(super) fn covering(&self, step: u32) -> impl Iterator<Item = u32> + '_ {
        (0..self.loop_count(step) as u32).map(move |loop_index| {
            let mut at = self.link(step, loop_index);
            while !at.is_back() {
                at = self.link(at.step, at.loop_index);
            }
            at.step
        })
    }

    /// Bytes of the heads; of the loops with their counts and offsets; and of listed vertices.
    pub(super) fn bytes(&self) -> [usize; 3] {
        let loops = self.links.bytes() + self.counts.bytes() + size_of_val(&self.firsts[..]);
        [self.heads.bytes(), loops, 4 * self.listed.len()]
    }
}
