//! The bit-packed record of each step: its kind, its links up and down, and vertices that it lists.
//!
//! Steps are stored in blocks of 16. A block consists of a few words and a run of bits:
//!
//! ```text
//! words   start of the bits | for each step 4 bits: number of links up, and whether its kind is long
//!                           | for each step 2 bits: number of links down
//! bits    width of a link down | low bits of each kind | for each step: high bits of its kind if long,
//!                                                        links up, links down
//! ```
//!
//! The links of a step begin where those of the steps before it end, so their position follows from sums
//! over the counts before its own, a few operations on one word; no step stores an offset. Kinds are
//! numbered by frequency, and most are short. If many steps list vertices or have more than three links
//! down, the counts of links down take 4 bits as well, the highest of which says that a vertex is listed
//! after the links.
//!
//! Links up name later steps, relative to the block, and links down earlier ones, relative to the step;
//! each takes just the bits that the steps of the block need. Blocks with a step that has more links than
//! its counts can express, or a run that begins at an unusual corner, are **wide**: they store an offset
//! and all counts for each step.

use std::convert::Infallible;

use crate::model::ModelError;
use crate::model::bits::{Bits, MAX_WIDTH, width_of};

/// Number of steps per block.
const BLOCK: usize = 16;
/// Number of bits of the width of a link down.
const WIDTH_BITS: u32 = 6;
/// Width of a link down that marks a wide block.
const WIDE: u32 = 63;
/// Number of bits of the corner at which a run begins, in a narrow block.
const CODE_BITS: u32 = 4;
/// Number of bits of the error of an overlap, in models that have them.
pub(super) const ERROR_BITS: u32 = 8;
/// Largest number of links up in a narrow block.
const MAX_UP: usize = 7;
/// Words of a block with counts of links down of 2 bits and of 4 bits.
const SHORT_STRIDE: usize = 4;
const LONG_STRIDE: usize = 5;
/// Counts of 4 bits are used if at least one block in this many needs them.
const LONG_STRIDE_SHARE: usize = 8;

/// A link up: where a run of triangles goes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct UpLink {
    /// The step whose floor contains the triangles.
    pub above: u32,
    /// The corner of its floor where the run begins; see `Rule::starts`.
    pub code: u32,
    /// Packed error of the triangles; 0 if the model has no errors of overlaps.
    pub error: u32,
}

/// The record of a step before it is packed.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct Draft {
    pub kind: u32,
    pub up: Vec<UpLink>,
    /// Steps that must be inserted first, except for those that others in the list need anyway.
    pub down: Vec<u32>,
    /// Listed vertices, as distances from the first vertex of the step.
    pub extras: Vec<u32>,
}

/// The packed records of all steps.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(in crate::model) struct Records {
    pub step_count: usize,
    layout: RecordLayout,
    /// The words of all blocks.
    blocks: Vec<u32>,
    bits: Bits,
}

/// Offsets, counts and widths of the parts of a block.
#[derive(Clone, Copy, Debug)]
struct RecordBlock {
    first: u32,
    /// First bit of the kinds.
    kinds: usize,
    /// First bit of the links of the first step.
    links: usize,
    /// Counts of links up and flags of long kinds.
    ups: u64,
    /// Counts of links down, and flags of listed vertices if they take 4 bits.
    downs: u64,
    up_width: u32,
    down_width: u32,
}

/// Counts and widths that determine the packed layout.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(in crate::model) struct RecordLayout {
    /// Number of kinds.
    pub kind_count: u32,
    /// Number of low bits of a kind, which every step stores.
    pub short_kind_bits: u32,
    /// Number of half-edges of the largest floor.
    pub half_edge_count: u32,
    /// Whether links up have errors.
    pub has_errors: bool,
    /// Whether counts of links down take 4 bits instead of 2.
    pub has_wide_counts: bool,
}

/// Kind of a step, and the place, number and widths of its links.
#[derive(Clone, Copy, Debug)]
pub(super) struct StepHead {
    pub kind: u32,
    pub up_count: u32,
    pub down_count: u32,
    pub extra_count: u32,
    step: u32,
    /// First bit of the links up.
    at: usize,
    up_width: u32,
    code_bits: u32,
    down_width: u32,
}

impl RecordLayout {
    #[inline]
    fn kind_bits(&self) -> u32 {
        width_of(u64::from(self.kind_count))
    }

    #[inline]
    fn long_kind_bits(&self) -> u32 {
        self.kind_bits() - self.short_kind_bits
    }

    #[inline]
    fn error_bits(&self) -> u32 {
        if self.has_errors { ERROR_BITS } else { 0 }
    }

    #[inline]
    fn down_count_bits(&self) -> u32 {
        if self.has_wide_counts { 4 } else { 2 }
    }

    #[inline]
    fn stride(&self) -> usize {
        if self.has_wide_counts { LONG_STRIDE } else { SHORT_STRIDE }
    }

    /// Largest number of links down in a narrow block.
    fn max_down(&self) -> usize {
        if self.has_wide_counts { 7 } else { 3 }
    }

    fn max_extras(&self) -> usize {
        usize::from(self.has_wide_counts)
    }

    fn is_narrow(&self, draft: &Draft) -> bool {
        draft.up.len() <= MAX_UP
            && draft.down.len() <= self.max_down()
            && draft.extras.len() <= self.max_extras()
            && draft.up.iter().all(|up| up.code < 1 << CODE_BITS)
    }

    /// Chooses the free parts of the layout so that the records become small.
    fn fitted(mut self, drafts: &[Draft]) -> Self {
        let mut counts = vec![0usize; self.kind_count as usize];
        drafts.iter().for_each(|draft| counts[draft.kind as usize] += 1);
        let all = self.kind_bits();
        let cost = |short: u32| {
            let long: usize = counts.iter().skip(1 << short).sum();
            drafts.len() * short as usize + long * (all - short) as usize
        };
        self.short_kind_bits = (0..=all).min_by_key(|&short| cost(short)).unwrap_or(0);
        let needs_wide_counts =
            |block: &&[Draft]| block.iter().any(|draft| draft.down.len() > 3 || !draft.extras.is_empty());
        let needing = drafts.chunks(BLOCK).filter(needs_wide_counts).count();
        self.has_wide_counts = needing > 0 && needing * LONG_STRIDE_SHARE >= drafts.len().div_ceil(BLOCK);
        self
    }
}

impl Records {
    /// Packs the records of all steps.
    ///
    /// # Errors
    /// [`ModelError::TooMany`] if they need more bits than a 32-bit offset can address.
    pub(super) fn pack(drafts: &[Draft], layout: RecordLayout) -> Result<Self, ModelError> {
        let layout = layout.fitted(drafts);
        let (blocks, bits) = (Vec::new(), Bits::default());
        let mut records = Self { step_count: drafts.len(), layout, blocks, bits };
        records.check_widths()?;
        for (index, block) in drafts.chunks(BLOCK).enumerate() {
            let first = (index * BLOCK) as u32;
            let start = records.position()?;
            records.blocks.push(start);
            if block.iter().all(|draft| layout.is_narrow(draft)) {
                records.push_narrow(first, block);
            } else {
                records.push_wide(first, block);
            }
        }
        records.position()?;
        Ok(records)
    }

    fn push_narrow(&mut self, first: u32, block: &[Draft]) {
        let Self { layout, blocks, bits, .. } = self;
        let (mut ups, mut downs) = (0u64, 0u64);
        let down_bits = layout.down_count_bits();
        for (k, draft) in (0..).zip(block) {
            let is_long = draft.kind >> layout.short_kind_bits != 0;
            ups |= (draft.up.len() as u64 | u64::from(is_long) << 3) << (4 * k);
            downs |= (draft.down.len() as u64 | (draft.extras.len() as u64) << 3) << (down_bits * k);
        }
        blocks.extend([ups as u32, (ups >> 32) as u32, downs as u32]);
        blocks.extend(layout.has_wide_counts.then_some((downs >> 32) as u32));
        let down_width = width_of(u64::from(farthest(first, block)) + 1);
        bits.push(u64::from(down_width), WIDTH_BITS);
        for draft in block {
            let low = u64::from(draft.kind) & ((1 << layout.short_kind_bits) - 1);
            bits.push(low, layout.short_kind_bits);
        }
        let up_width = step_width(self.step_count, first) + CODE_BITS + layout.error_bits();
        for (step, draft) in (first..).zip(block) {
            let high = draft.kind >> layout.short_kind_bits;
            if high != 0 {
                bits.push(u64::from(high), layout.long_kind_bits());
            }
            for up in &draft.up {
                bits.push(layout.pack_up(up, first, CODE_BITS), up_width);
            }
            let downs = draft.down.iter().map(|below| step - below - 1);
            for number in downs.chain(draft.extras.iter().copied()) {
                bits.push(u64::from(number), down_width);
            }
        }
    }

    fn push_wide(&mut self, first: u32, block: &[Draft]) {
        let Self { layout, blocks, bits, .. } = self;
        blocks.resize(blocks.len() + layout.stride() - 1, 0);
        let widths = WideWidths::of(layout, self.step_count, first);
        let down_width = width_of(u64::from(farthest(first, block)) + 1);
        let links = |draft: &Draft| {
            draft.up.len() * widths.up as usize
                + (draft.down.len() + draft.extras.len()) * down_width as usize
        };
        let all: usize = block.iter().map(links).sum();
        let counts = |draft: &Draft| [draft.up.len(), draft.down.len(), draft.extras.len()];
        let most = block.iter().flat_map(counts).max().unwrap_or(0);
        let offset_width = width_of(all as u64 + 1);
        let count_width = width_of(most as u64 + 1);
        for width in [WIDE, offset_width, count_width, down_width] {
            bits.push(u64::from(width), WIDTH_BITS);
        }
        let mut offset = 0;
        for draft in block {
            bits.push(u64::from(draft.kind), layout.kind_bits());
            bits.push(offset as u64, offset_width);
            counts(draft).into_iter().for_each(|count| bits.push(count as u64, count_width));
            offset += links(draft);
        }
        for (step, draft) in (first..).zip(block) {
            for up in &draft.up {
                bits.push(layout.pack_up(up, first, widths.code), widths.up);
            }
            let downs = draft.down.iter().map(|below| step - below - 1);
            for number in downs.chain(draft.extras.iter().copied()) {
                bits.push(u64::from(number), down_width);
            }
        }
    }

    fn position(&self) -> Result<u32, ModelError> {
        let (found, limit) = (self.bits.len() as u64, u64::from(u32::MAX));
        u32::try_from(found).map_err(|_| ModelError::TooMany { what: "bits of records", found, limit })
    }

    /// Checks that every field fits into a load.
    fn check_widths(&self) -> Result<(), ModelError> {
        let found = u64::from(WideWidths::of(&self.layout, self.step_count, 0).up);
        let limit = u64::from(MAX_WIDTH);
        if found > limit {
            return Err(ModelError::TooMany { what: "bits of a link", found, limit });
        }
        Ok(())
    }

    /// Returns the offsets of the parts of a step's block; `Err` with the start of a wide block.
    #[inline]
    fn block(&self, step: u32) -> Result<RecordBlock, usize> {
        let stride = self.layout.stride();
        let at = step as usize / BLOCK * stride;
        let &[start, ups_low, ups_high, downs_low, ..] = &self.blocks[at..at + stride] else {
            unreachable!("a block has at least four words");
        };
        let start = start as usize;
        let down_width = self.bits.get(start, WIDTH_BITS) as u32;
        if down_width == WIDE {
            return Err(start);
        }
        let downs_high = if self.layout.has_wide_counts { self.blocks[at + SHORT_STRIDE] } else { 0 };
        let first = step & !(BLOCK as u32 - 1);
        let len = (self.step_count as u32 - first).min(BLOCK as u32);
        let kinds = start + WIDTH_BITS as usize;
        Ok(RecordBlock {
            first,
            kinds,
            links: kinds + (len * self.layout.short_kind_bits) as usize,
            ups: u64::from(ups_low) | u64::from(ups_high) << 32,
            downs: u64::from(downs_low) | u64::from(downs_high) << 32,
            up_width: step_width(self.step_count, first) + CODE_BITS + self.layout.error_bits(),
            down_width,
        })
    }

    /// Returns the kind of a step and the place of its links.
    #[inline]
    pub(super) fn head(&self, step: u32) -> StepHead {
        match self.block(step) {
            Ok(block) => {
                let k = step % BLOCK as u32;
                self.narrow_head(&block, k, block.links + self.bits_before(&block, k) as usize)
            }
            Err(start) => self.wide_head(step, start),
        }
    }

    /// Number of bits of the links of the first `k` steps of a block, at most 15.
    #[inline]
    fn bits_before(&self, block: &RecordBlock, k: u32) -> u32 {
        let (up_count, long_count) = sums_of_nibbles(block.ups & ((1 << (4 * k)) - 1));
        let below = block.downs & ((1 << (self.layout.down_count_bits() * k)) - 1);
        let down_count = if self.layout.has_wide_counts {
            let (down_count, extra_count) = sums_of_nibbles(below);
            down_count + extra_count
        } else {
            sum_of_pairs(below as u32)
        };
        up_count * block.up_width + long_count * self.layout.long_kind_bits() + down_count * block.down_width
    }

    /// Returns the head of step `k` of a narrow block, whose links begin at a bit.
    #[inline]
    fn narrow_head(&self, block: &RecordBlock, k: u32, mut at: usize) -> StepHead {
        let RecordLayout { short_kind_bits, .. } = self.layout;
        let ups = (block.ups >> (4 * k)) as u32;
        let downs = (block.downs >> (self.layout.down_count_bits() * k)) as u32;
        let mut kind = self.bits.get(block.kinds + (k * short_kind_bits) as usize, short_kind_bits) as u32;
        if ups & 8 != 0 {
            let long_kind_bits = self.layout.long_kind_bits();
            kind |= (self.bits.get(at, long_kind_bits) as u32) << short_kind_bits;
            at += long_kind_bits as usize;
        }
        let (down_count, extra_count) =
            if self.layout.has_wide_counts { (downs & 7, downs >> 3 & 1) } else { (downs & 3, 0) };
        StepHead {
            kind,
            up_count: ups & 7,
            down_count,
            extra_count,
            step: block.first + k,
            at,
            up_width: block.up_width,
            code_bits: CODE_BITS,
            down_width: block.down_width,
        }
    }

    /// Returns a reader of heads, which is faster for steps in ascending order.
    pub(super) fn cursor(&self) -> HeadCursor<'_> {
        HeadCursor { records: self, block: Err(0), block_index: usize::MAX, next: 0, at: 0 }
    }

    /// Calls `visit` with the heads of all steps in order, which takes less time than single heads.
    ///
    /// # Errors
    /// The first error of `visit`.
    #[inline]
    pub(super) fn try_for_each_head<E>(
        &self,
        mut visit: impl FnMut(u32, &StepHead) -> Result<(), E>,
    ) -> Result<(), E> {
        for first in (0..self.step_count as u32).step_by(BLOCK) {
            let block = self.block(first);
            let len = self.block_len(first) as u32;
            let mut at = block.map_or(0, |block| block.links);
            for k in 0..len {
                let head = match &block {
                    Ok(block) => self.narrow_head(block, k, at),
                    Err(start) => self.wide_head(first + k, *start),
                };
                at = self.end_of(&head) as usize;
                visit(first + k, &head)?;
            }
        }
        Ok(())
    }

    #[cold]
    fn wide_head(&self, step: u32, start: usize) -> StepHead {
        let [offset_width, count_width, down_width] =
            [1, 2, 3].map(|i| self.bits.get(start + i * WIDTH_BITS as usize, WIDTH_BITS) as u32);
        let widths = WideWidths::of(&self.layout, self.step_count, step & !(BLOCK as u32 - 1));
        let kind_bits = self.layout.kind_bits();
        let head_bits = (kind_bits + offset_width + 3 * count_width) as usize;
        let heads = start + 4 * WIDTH_BITS as usize;
        let at = heads + step as usize % BLOCK * head_bits;
        let counts = at + (kind_bits + offset_width) as usize;
        let count = |i: usize| self.bits.get(counts + i * count_width as usize, count_width) as u32;
        let offset = self.bits.get(at + kind_bits as usize, offset_width) as usize;
        StepHead {
            kind: self.bits.get(at, kind_bits) as u32,
            up_count: count(0),
            down_count: count(1),
            extra_count: count(2),
            step,
            at: heads + self.block_len(step) * head_bits + offset,
            up_width: widths.up,
            code_bits: widths.code,
            down_width,
        }
    }

    /// Number of steps in the block of a step.
    #[inline]
    fn block_len(&self, step: u32) -> usize {
        (self.step_count - step as usize / BLOCK * BLOCK).min(BLOCK)
    }

    /// Returns a link up.
    #[inline]
    pub(super) fn up(&self, head: &StepHead, link: u32) -> UpLink {
        let number = self.bits.get(head.at + (link * head.up_width) as usize, head.up_width);
        let error_bits = self.layout.error_bits();
        let above = (number >> (error_bits + head.code_bits)) as u32;
        UpLink {
            above: above.wrapping_add(head.step & !(BLOCK as u32 - 1)),
            code: (number >> error_bits) as u32 & ((1 << head.code_bits) - 1),
            error: number as u32 & ((1 << error_bits) - 1),
        }
    }

    /// Returns all links up of a step.
    #[inline]
    pub(super) fn ups(&self, head: &StepHead) -> impl Iterator<Item = UpLink> + use<'_> {
        let head = *head;
        (0..head.up_count).map(move |link| self.up(&head, link))
    }

    /// Returns the steps that a step depends on, except for those that others in the list need anyway.
    /// Wrapping, because a damaged record may name steps that do not exist.
    #[inline]
    pub(super) fn downs(&self, head: &StepHead) -> impl Iterator<Item = u32> + use<'_> {
        let head = *head;
        let at = head.at + (head.up_count * head.up_width) as usize;
        (0..head.down_count).map(move |i| {
            let number = self.bits.get(at + (i * head.down_width) as usize, head.down_width) as u32;
            head.step.wrapping_sub(number).wrapping_sub(1)
        })
    }

    /// Returns the vertices that a step lists, as distances from its first vertex.
    #[inline]
    pub(super) fn extras(&self, head: &StepHead) -> impl Iterator<Item = u32> + use<'_> {
        let head = *head;
        let at = head.at + (head.up_count * head.up_width + head.down_count * head.down_width) as usize;
        (0..head.extra_count)
            .map(move |i| self.bits.get(at + (i * head.down_width) as usize, head.down_width) as u32)
    }

    /// Returns the first bit after the links of a step.
    #[inline]
    fn end_of(&self, head: &StepHead) -> u64 {
        let ups = u64::from(head.up_count) * u64::from(head.up_width);
        let downs = (u64::from(head.down_count) + u64::from(head.extra_count)) * u64::from(head.down_width);
        head.at as u64 + ups + downs
    }

    /// Returns the size in bytes of the bits, and of the words of the blocks.
    pub(super) fn bytes(&self) -> [usize; 2] {
        [self.bits.bytes(), size_of_val(&self.blocks[..])]
    }

    /// Returns the arrays to store in a file.
    pub(super) fn parts(&self) -> (&[u32], &Bits) {
        (&self.blocks, &self.bits)
    }

    pub(super) fn layout(&self) -> RecordLayout {
        self.layout
    }

    /// Calls `visit` with the heads of all steps in order.
    pub(super) fn for_each_head(&self, mut visit: impl FnMut(u32, &StepHead)) {
        let Ok(()) = self.try_for_each_head(|step, head| {
            visit(step, head);
            Ok::<(), Infallible>(())
        });
    }

    /// Assembles records from stored arrays, checking that every block has its bits. Whether kinds and linked
    /// steps exist remains to be checked.
    ///
    /// # Errors
    /// [`ModelError`] naming the first mismatch.
    pub(super) fn from_parts(
        step_count: usize,
        layout: RecordLayout,
        blocks: Vec<u32>,
        bits: Bits,
    ) -> Result<Self, ModelError> {
        let records = Self { step_count, layout, blocks, bits };
        records.check_widths()?;
        records.position()?;
        if layout.short_kind_bits > layout.kind_bits() {
            let (found, limit) = (u64::from(layout.short_kind_bits), u64::from(layout.kind_bits()));
            return Err(ModelError::TooMany { what: "low bits of a kind", found, limit });
        }
        let (found, expected) = (records.blocks.len(), step_count.div_ceil(BLOCK) * layout.stride());
        if found != expected {
            return Err(ModelError::Length { what: "words of blocks", found, expected });
        }
        let mut end = 0;
        for first in (0..step_count as u32).step_by(BLOCK) {
            end = records.check_block(first, end)?;
        }
        let (found, expected) = (end as usize, records.bits.len());
        if found != expected {
            return Err(ModelError::Length { what: "bits of records", found, expected });
        }
        Ok(records)
    }

    /// Checks that a block begins at `start` and lies within the bits; returns its end.
    fn check_block(&self, first: u32, start: u64) -> Result<u64, ModelError> {
        let wrong = |step: u32, reason| ModelError::Step { step: step as usize, reason };
        let limit = self.bits.len() as u64;
        let words = &self.blocks[first as usize / BLOCK * self.layout.stride()..];
        if u64::from(words[0]) != start || start + u64::from(WIDTH_BITS) > limit {
            return Err(wrong(first, "begins at the wrong bit"));
        }
        let len = self.block_len(first) as u32;
        let block = match self.block(first) {
            Ok(block) => block,
            Err(at) => {
                self.check_wide_heads(first, start).map_err(|reason| wrong(first, reason))?;
                let mut end = self.wide_head(first, at).at as u64;
                for step in first..first + len {
                    let head = self.wide_head(step, at);
                    if head.at as u64 != end {
                        return Err(wrong(step, "has links at the wrong bit"));
                    }
                    end = self.end_of(&head);
                    if end > limit {
                        return Err(wrong(step, "has links beyond the last bit"));
                    }
                }
                return Ok(end);
            }
        };
        let unused = |counts: u64, bits: u32| len < BLOCK as u32 && counts >> (bits * len) != 0;
        if block.down_width > u32::BITS
            || unused(block.ups, 4)
            || unused(block.downs, self.layout.down_count_bits())
        {
            return Err(wrong(first, "has a width or counts that cannot be"));
        }
        // The last step of the block is added separately, because only 15 can be summed up.
        let last = len - 1;
        let links = block.links as u64 + u64::from(self.bits_before(&block, last));
        if links > limit {
            return Err(wrong(first, "has links or a kind beyond the last bit"));
        }
        let end = self.end_of(&self.narrow_head(&block, last, links as usize));
        if end > limit {
            return Err(wrong(first + last, "has links beyond the last bit"));
        }
        Ok(end)
    }

    /// Checks that the heads of a wide block lie within the bits, and that its links follow them.
    fn check_wide_heads(&self, first: u32, start: u64) -> Result<(), &'static str> {
        let limit = self.bits.len() as u64;
        let heads = start + 4 * u64::from(WIDTH_BITS);
        if heads > limit {
            return Err("has no widths");
        }
        let [offset_width, count_width, down_width] =
            [1, 2, 3].map(|i| self.bits.get(start as usize + i * WIDTH_BITS as usize, WIDTH_BITS) as u32);
        if offset_width.max(count_width).max(down_width) > u32::BITS {
            return Err("has numbers of more than 32 bits");
        }
        let head_bits = u64::from(self.layout.kind_bits() + offset_width + 3 * count_width);
        let links = heads + self.block_len(first) as u64 * head_bits;
        if links > limit || self.wide_head(first, start as usize).at as u64 != links {
            return Err("has links at the wrong bit");
        }
        Ok(())
    }
}

/// Reads heads, remembering the block of the last one.
pub(super) struct HeadCursor<'a> {
    records: &'a Records,
    /// The current block, or where it starts if it is wide.
    block: Result<RecordBlock, usize>,
    block_index: usize,
    /// The step after the last one, and the first bit of its links if it is in the same block.
    next: u32,
    at: usize,
}

impl HeadCursor<'_> {
    /// Returns the kind of a step and where its links are.
    #[inline]
    pub(super) fn head(&mut self, step: u32) -> StepHead {
        let block_index = step as usize / BLOCK;
        let is_same_block = block_index == self.block_index;
        if !is_same_block {
            self.block = self.records.block(step);
            self.block_index = block_index;
        }
        match &self.block {
            Ok(block) => {
                let k = step % BLOCK as u32;
                let at = if is_same_block && step == self.next {
                    self.at
                } else {
                    block.links + self.records.bits_before(block, k) as usize
                };
                let head = self.records.narrow_head(block, k, at);
                self.next = step + 1;
                self.at = self.records.end_of(&head) as usize;
                head
            }
            Err(start) => self.records.wide_head(step, *start),
        }
    }
}

/// Widths of a link up of a wide block, and of the corner in it.
struct WideWidths {
    up: u32,
    code: u32,
}

impl WideWidths {
    fn of(layout: &RecordLayout, step_count: usize, first: u32) -> Self {
        let code = width_of(u64::from(layout.half_edge_count));
        Self { up: step_width(step_count, first) + code + layout.error_bits(), code }
    }
}

impl RecordLayout {
    fn pack_up(&self, up: &UpLink, first: u32, code_bits: u32) -> u64 {
        let above = u64::from(up.above - first) << code_bits | u64::from(up.code);
        above << self.error_bits() | u64::from(up.error)
    }
}

/// Returns the largest number that stands for a link down or a listed vertex in a block.
fn farthest(first: u32, block: &[Draft]) -> u32 {
    let of_step = |(step, draft): (u32, &Draft)| {
        let downs = draft.down.iter().map(|below| step - below - 1);
        downs.chain(draft.extras.iter().copied()).max().unwrap_or(0)
    };
    (first..).zip(block).map(of_step).max().unwrap_or(0)
}

/// Number of bits of a step that is not before the first step of a block.
#[inline]
fn step_width(step_count: usize, first: u32) -> u32 {
    width_of((step_count - first as usize) as u64)
}

/// Returns the sums of the lower three bits and of the highest bit of up to 15 numbers of four bits.
#[inline]
fn sums_of_nibbles(nibbles: u64) -> (u32, u32) {
    let numbers = nibbles & 0x7777_7777_7777_7777;
    let pairs = (numbers & 0x0F0F_0F0F_0F0F_0F0F) + (numbers >> 4 & 0x0F0F_0F0F_0F0F_0F0F);
    let flags = nibbles >> 3 & 0x1111_1111_1111_1111;
    let number = pairs.wrapping_mul(0x0101_0101_0101_0101) >> 56;
    let flag = flags.wrapping_mul(0x1111_1111_1111_1111) >> 60;
    (number as u32, flag as u32)
}

/// Returns the sum of sixteen numbers of two bits.
#[inline]
fn sum_of_pairs(pairs: u32) -> u32 {
    let nibbles = (pairs & 0x3333_3333) + (pairs >> 2 & 0x3333_3333);
    let bytes = (nibbles & 0x0F0F_0F0F) + (nibbles >> 4 & 0x0F0F_0F0F);
    bytes.wrapping_mul(0x0101_0101) >> 24
}

#[cfg(test)]
mod tests;
