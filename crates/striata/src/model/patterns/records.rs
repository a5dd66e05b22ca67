//! The bit-packed record of each step: its rule, the sharing of its ceiling, and its links up and down.
//!
//! Steps are stored in blocks of 16. A block begins with a fixed-width head per step (rule, sharing, and
//! offset of its links in the block), followed by the links. Links up name later steps and links down
//! earlier ones, so each has just the width that the possible steps need. The number of links down follows
//! from the start of the next step's links.

use super::overlaps::OverlapTable;
use crate::model::ModelError;
use crate::model::bits::{Bits, MAX_WIDTH, width_of};

/// Number of steps per block.
const BLOCK: usize = 16;

/// The record of a step before it is packed.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct Draft {
    pub(super) rule: u32,
    pub(super) sharing: u32,
    /// For each link, the step above and the half-edge of its floor where the run begins.
    pub(super) up: Vec<(u32, u32)>,
    /// Steps that must be inserted first, except for those that others in the list need anyway.
    pub(super) down: Vec<u32>,
}

/// The packed records of all steps.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(in crate::model) struct Records {
    pub(super) step_count: usize,
    /// Number of half-edges of the largest floor, at least 1.
    half_edge_count: u32,
    rule_width: u32,
    sharing_width: u32,
    offset_width: u32,
    /// First bit of each block, followed by the total number of bits.
    blocks: Vec<u32>,
    bits: Bits,
}

/// The head of a step, and where its links are.
#[derive(Clone, Copy, Debug)]
pub(super) struct Head {
    pub(super) rule: u32,
    pub(super) sharing: u32,
    /// First bit of the links up.
    at: usize,
    step: u32,
}

/// Counts and widths that determine the packed layout.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::model) struct Widths {
    pub(super) rule_count: usize,
    pub(super) sharing_count: usize,
    pub(super) half_edge_count: u32,
    pub(super) offset_width: u32,
}

impl Records {
    /// Packs the records of all steps.
    ///
    /// # Errors
    /// [`ModelError::TooMany`] if they need more bits than a 32-bit offset can address.
    pub(super) fn pack(drafts: &[Draft], mut widths: Widths) -> Result<Self, ModelError> {
        let mut records = Self::empty(drafts.len(), widths);
        let most =
            (0..drafts.len()).step_by(BLOCK).map(|first| records.link_bits(drafts, first).sum::<usize>());
        widths.offset_width = width_of(most.max().unwrap_or(0) as u64 + 1);
        records.offset_width = widths.offset_width;
        for first in (0..drafts.len()).step_by(BLOCK) {
            records.blocks.push(records.position()?);
            let block = &drafts[first..drafts.len().min(first + BLOCK)];
            let lengths: Vec<usize> = records.link_bits(drafts, first).collect();
            let mut offset = 0;
            for (draft, length) in block.iter().zip(lengths) {
                records.bits.push(u64::from(draft.rule), records.rule_width);
                records.bits.push(u64::from(draft.sharing), records.sharing_width);
                records.bits.push(offset as u64, records.offset_width);
                offset += length;
            }
            let (up_width, down_width) = records.link_widths(first as u32);
            for draft in block {
                for &(above, half_edge) in &draft.up {
                    let above = u64::from(above) - first as u64;
                    let number = above * u64::from(records.half_edge_count) + u64::from(half_edge);
                    records.bits.push(number, up_width);
                }
                for &below in &draft.down {
                    records.bits.push(u64::from(below), down_width);
                }
            }
        }
        records.blocks.push(records.position()?);
        Ok(records)
    }

    /// Returns the size in bits of the links of each step in a block.
    fn link_bits<'d>(&self, drafts: &'d [Draft], first: usize) -> impl Iterator<Item = usize> + use<'d> {
        let (up, down) = self.link_widths(first as u32);
        let block = &drafts[first..drafts.len().min(first + BLOCK)];
        block.iter().map(move |draft| draft.up.len() * up as usize + draft.down.len() * down as usize)
    }

    fn empty(step_count: usize, widths: Widths) -> Self {
        Self {
            step_count,
            half_edge_count: widths.half_edge_count.max(1),
            rule_width: width_of(widths.rule_count as u64),
            sharing_width: width_of(widths.sharing_count as u64),
            offset_width: widths.offset_width,
            blocks: Vec::new(),
            bits: Bits::default(),
        }
    }

    fn position(&self) -> Result<u32, ModelError> {
        let (found, limit) = (self.bits.len() as u64, u64::from(u32::MAX));
        u32::try_from(found).map_err(|_| ModelError::TooMany { what: "bits of records", found, limit })
    }

    /// Returns the widths of a link up and of a link down in the block of a step.
    #[inline]
    fn link_widths(&self, step: u32) -> (u32, u32) {
        let block = step as usize / BLOCK * BLOCK;
        let above = (self.step_count - block) as u64 * u64::from(self.half_edge_count);
        (width_of(above), width_of((block + BLOCK) as u64))
    }

    #[inline]
    fn head_width(&self) -> usize {
        (self.rule_width + self.sharing_width + self.offset_width) as usize
    }

    /// Number of steps in the block of a step.
    #[inline]
    fn block_len(&self, step: u32) -> usize {
        (self.step_count - step as usize / BLOCK * BLOCK).min(BLOCK)
    }

    /// Returns the first bits of a step's head and of the links in its block.
    #[inline]
    fn offsets(&self, step: u32) -> (usize, usize) {
        let block = self.blocks[step as usize / BLOCK] as usize;
        (block + step as usize % BLOCK * self.head_width(), block + self.block_len(step) * self.head_width())
    }

    #[inline]
    pub(super) fn head(&self, step: u32) -> Head {
        let (at, links) = self.offsets(step);
        let rule = self.bits.get(at, self.rule_width) as u32;
        let at = at + self.rule_width as usize;
        let sharing = self.bits.get(at, self.sharing_width) as u32;
        let offset = self.bits.get(at + self.sharing_width as usize, self.offset_width) as usize;
        Head { rule, sharing, at: links + offset, step }
    }

    /// Returns the end of a step's links.
    #[inline]
    fn links_end(&self, step: u32) -> usize {
        let next = step as usize + 1;
        if next.is_multiple_of(BLOCK) || next == self.step_count {
            return self.blocks[step as usize / BLOCK + 1] as usize;
        }
        let (at, links) = self.offsets(next as u32);
        links
            + self.bits.get(at + (self.rule_width + self.sharing_width) as usize, self.offset_width) as usize
    }

    /// Returns the step above that a link leads to, and the half-edge of its floor where the run begins.
    #[inline]
    pub(super) fn up(&self, head: &Head, link: usize) -> (u32, u32) {
        let (width, _) = self.link_widths(head.step);
        let number = self.bits.get(head.at + link * width as usize, width);
        let above = number / u64::from(self.half_edge_count);
        let half_edge = number - above * u64::from(self.half_edge_count);
        (above as u32 + (head.step as usize / BLOCK * BLOCK) as u32, half_edge as u32)
    }

    /// Returns the steps that a step depends on, except for those that others in the list need anyway.
    #[inline]
    pub(super) fn down(&self, head: &Head, link_count: usize) -> impl Iterator<Item = u32> + use<'_> {
        let (up_width, width) = self.link_widths(head.step);
        let begin = head.at + link_count * up_width as usize;
        // The width covers more than one step, so it is never 0.
        let count = (self.links_end(head.step) - begin) / width as usize;
        (0..count).map(move |i| self.bits.get(begin + i * width as usize, width) as u32)
    }

    /// Returns the size in bytes of the bits, and of the block offsets.
    pub(super) fn bytes(&self) -> [usize; 2] {
        [self.bits.bytes(), size_of_val(&self.blocks[..])]
    }

    /// Returns the arrays to store in a file.
    pub(super) fn parts(&self) -> (&[u32], &Bits) {
        (&self.blocks, &self.bits)
    }

    /// Assembles records from stored arrays, checking that every head leads to existing rules, sharings
    /// and links.
    ///
    /// # Errors
    /// [`ModelError`] naming the first mismatch.
    pub(super) fn from_parts(
        step_count: usize,
        widths: Widths,
        (blocks, bits): (Vec<u32>, Bits),
        sharings: &OverlapTable,
    ) -> Result<Self, ModelError> {
        let records = Self { blocks, bits, ..Self::empty(step_count, widths) };
        let (widest, _) = records.link_widths(0);
        for found in [records.rule_width, records.sharing_width, records.offset_width, widest] {
            if found > MAX_WIDTH {
                let (found, limit) = (u64::from(found), u64::from(MAX_WIDTH));
                return Err(ModelError::TooMany { what: "bits of a number", found, limit });
            }
        }
        let (found, expected) = (records.blocks.len(), step_count.div_ceil(BLOCK) + 1);
        if found != expected {
            return Err(ModelError::Length { what: "blocks of records", found, expected });
        }
        let mut end = 0;
        for step in 0..step_count as u32 {
            let reason = "has a rule, a sharing or links that do not exist";
            let wrong = ModelError::Step { step: step as usize, reason };
            let begin = records.blocks[step as usize / BLOCK] as usize;
            let (_, links) = records.offsets(step);
            let block_end = records.blocks[step as usize / BLOCK + 1] as usize;
            if (step as usize).is_multiple_of(BLOCK) {
                // Check that the heads exist before reading them.
                if begin != end || links > block_end || block_end > records.bits.len() {
                    return Err(wrong);
                }
                end = links;
            }
            let head = records.head(step);
            let exists =
                (head.rule as usize) < widths.rule_count && (head.sharing as usize) < widths.sharing_count;
            let (up_width, down_width) = records.link_widths(step);
            let links_end = records.links_end(step);
            let ups = exists.then(|| sharings.link_count(head.sharing).saturating_mul(up_width as usize));
            let downs = ups.and_then(|ups| links_end.checked_sub(head.at)?.checked_sub(ups));
            if head.at != end
                || links_end > block_end
                || downs.is_none_or(|bits| bits % down_width as usize != 0)
            {
                return Err(wrong);
            }
            end = links_end;
        }
        let (found, expected) = (end, records.bits.len());
        if found != expected || records.blocks.last() != Some(&(end as u32)) {
            return Err(ModelError::Length { what: "bits of records", found, expected });
        }
        Ok(records)
    }

    pub(super) fn widths(&self, rule_count: usize, sharing_count: usize) -> Widths {
        Widths {
            rule_count,
            sharing_count,
            half_edge_count: self.half_edge_count,
            offset_width: self.offset_width,
        }
    }
}
