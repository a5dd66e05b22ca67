//! What is stored of each step, packed: rule, sharing of the ceiling, links up and down.
//!
//! Steps come in blocks of 16. A block's links stand together in one stream of bits, as wide as the steps that they can name
//! need: links up name later steps, links down earlier ones. Each step has a head of fixed width: rule, way of sharing, and where in
//! the block's links its own begin. Where the next step's begin says how many links down there are.

use super::bits::{Bits, MAX_WIDTH, width_of};
use super::overlaps::OverlapTable;
use crate::model::ModelError;

/// Steps whose links stand together.
const BLOCK: usize = 16;

/// What a step has before it is packed.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct Draft {
    pub(super) rule: u32,
    pub(super) way: u32,
    /// For each link the step above, and the half-edge of its floor where the run begins.
    pub(super) up: Vec<(u32, u32)>,
    /// Steps that must be there before, without those that they need themselves.
    pub(super) down: Vec<u32>,
}

/// All steps, packed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(in crate::model) struct Records {
    pub(super) step_count: usize,
    /// Half-edges of the largest floor, at least 1.
    pub(super) half_edge_count: u32,
    rule_width: u32,
    way_width: u32,
    offset_width: u32,
    heads: Bits,
    /// Where in `links` each block begins, closed by their end.
    blocks: Vec<u32>,
    links: Bits,
}

/// The head of a step and where its links are.
#[derive(Clone, Copy, Debug)]
pub(super) struct Head {
    pub(super) rule: u32,
    pub(super) way: u32,
    /// First bit of the links up.
    at: usize,
    step: u32,
}

/// The numbers that tell how records are packed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::model) struct Widths {
    pub(super) rule_count: usize,
    pub(super) way_count: usize,
    pub(super) half_edge_count: u32,
    pub(super) offset_width: u32,
}

impl Records {
    /// Packs the records of all steps.
    ///
    /// # Errors
    /// [`ModelError::TooMany`] if the links need more bits than 32-bit numbers reach.
    pub(super) fn pack(drafts: &[Draft], widths: Widths) -> Result<Self, ModelError> {
        let step_count = drafts.len();
        let mut records = Self::empty(step_count, widths);
        let mut offsets = Vec::with_capacity(step_count);
        let mut most = 0;
        for (step, draft) in drafts.iter().enumerate() {
            if step % BLOCK == 0 {
                records.blocks.push(records.link_position()?);
            }
            let offset = records.links.len() - records.blocks[step / BLOCK] as usize;
            most = most.max(offset);
            offsets.push(offset as u64);
            let (up_width, down_width) = records.link_widths(step as u32);
            let block = (step / BLOCK * BLOCK) as u64;
            for &(above, half_edge) in &draft.up {
                let number =
                    (u64::from(above) - block) * u64::from(records.half_edge_count) + u64::from(half_edge);
                records.links.push(number, up_width);
            }
            for &below in &draft.down {
                records.links.push(u64::from(below), down_width);
            }
        }
        records.blocks.push(records.link_position()?);
        records.offset_width = width_of(most as u64 + 1);
        for (draft, offset) in drafts.iter().zip(offsets) {
            records.heads.push(u64::from(draft.rule), records.rule_width);
            records.heads.push(u64::from(draft.way), records.way_width);
            records.heads.push(offset, records.offset_width);
        }
        Ok(records)
    }

    fn empty(step_count: usize, widths: Widths) -> Self {
        Self {
            step_count,
            half_edge_count: widths.half_edge_count.max(1),
            rule_width: width_of(widths.rule_count as u64),
            way_width: width_of(widths.way_count as u64),
            offset_width: widths.offset_width,
            heads: Bits::default(),
            blocks: Vec::new(),
            links: Bits::default(),
        }
    }

    fn link_position(&self) -> Result<u32, ModelError> {
        let (found, limit) = (self.links.len() as u64, u64::from(u32::MAX));
        u32::try_from(found).map_err(|_| ModelError::TooMany { what: "bits of links", found, limit })
    }

    /// Bits of a link up and of a link down in a step's block.
    #[inline]
    fn link_widths(&self, step: u32) -> (u32, u32) {
        let block = step as usize / BLOCK * BLOCK;
        let above = (self.step_count - block) as u64 * u64::from(self.half_edge_count);
        (width_of(above), width_of((block + BLOCK) as u64))
    }

    #[inline]
    fn head_width(&self) -> u32 {
        self.rule_width + self.way_width + self.offset_width
    }

    #[inline]
    pub(super) fn head(&self, step: u32) -> Head {
        let at = step as usize * self.head_width() as usize;
        let rule = self.heads.get(at, self.rule_width) as u32;
        let at = at + self.rule_width as usize;
        let way = self.heads.get(at, self.way_width) as u32;
        let offset = self.heads.get(at + self.way_width as usize, self.offset_width) as usize;
        Head { rule, way, at: self.blocks[step as usize / BLOCK] as usize + offset, step }
    }

    #[inline]
    fn links_begin(&self, step: u32) -> usize {
        let at = step as usize * self.head_width() as usize + (self.rule_width + self.way_width) as usize;
        self.blocks[step as usize / BLOCK] as usize + self.heads.get(at, self.offset_width) as usize
    }

    /// The step above that a link leads to, and the half-edge of its floor where the run begins.
    #[inline]
    pub(super) fn up(&self, head: &Head, link: usize) -> (u32, u32) {
        let (width, _) = self.link_widths(head.step);
        let number = self.links.get(head.at + link * width as usize, width);
        let above = number / u64::from(self.half_edge_count);
        let half_edge = number - above * u64::from(self.half_edge_count);
        (above as u32 + (head.step as usize / BLOCK * BLOCK) as u32, half_edge as u32)
    }

    /// The steps that a step stands on, without those that these need themselves.
    #[inline]
    pub(super) fn down(&self, head: &Head, link_count: usize) -> impl Iterator<Item = u32> + use<'_> {
        let (up_width, width) = self.link_widths(head.step);
        let begin = head.at + link_count * up_width as usize;
        let next = head.step as usize + 1;
        let end = if next % BLOCK == 0 || next == self.step_count {
            self.blocks[head.step as usize / BLOCK + 1] as usize
        } else {
            self.links_begin(next as u32)
        };
        // A link down of the very first block can be 0 bits wide nowhere: a block has more than one step.
        let count = (end - begin) / width as usize;
        (0..count).map(move |i| self.links.get(begin + i * width as usize, width) as u32)
    }

    pub(super) fn bytes(&self) -> [usize; 3] {
        [self.heads.bytes(), self.links.bytes(), size_of_val(&self.blocks[..])]
    }

    /// The parts as a file holds them: heads, blocks, links.
    pub(super) fn parts(&self) -> (&Bits, &[u32], &Bits) {
        (&self.heads, &self.blocks, &self.links)
    }

    pub(super) fn widths(&self, rules: usize, overlaps: &OverlapTable) -> Widths {
        Widths {
            rule_count: rules,
            way_count: overlaps.len(),
            half_edge_count: self.half_edge_count,
            offset_width: self.offset_width,
        }
    }

    /// From the parts that a file holds; checks that every head leads to links that are there.
    ///
    /// # Errors
    /// [`ModelError`] naming what does not fit.
    pub(super) fn from_parts(
        step_count: usize,
        widths: Widths,
        (heads, blocks, links): (Bits, Vec<u32>, Bits),
        overlaps: &OverlapTable,
    ) -> Result<Self, ModelError> {
        let records = Self { heads, blocks, links, ..Self::empty(step_count, widths) };
        let length = |what, found, expected| {
            if found == expected { Ok(()) } else { Err(ModelError::Length { what, found, expected }) }
        };
        for width in [records.rule_width, records.way_width, records.offset_width] {
            if width > MAX_WIDTH / 2 + 4 {
                return Err(ModelError::TooMany {
                    what: "bits of a number",
                    found: u64::from(width),
                    limit: 32,
                });
            }
        }
        let (widest, _) = records.link_widths(0);
        if widest > MAX_WIDTH {
            let (found, limit) = (u64::from(widest), u64::from(MAX_WIDTH));
            return Err(ModelError::TooMany { what: "bits of a link", found, limit });
        }
        length("bits of heads", records.heads.len(), step_count * records.head_width() as usize)?;
        length("blocks of links", records.blocks.len(), step_count.div_ceil(BLOCK) + 1)?;
        length("bits of links", records.blocks[records.blocks.len() - 1] as usize, records.links.len())?;
        let mut end = 0;
        for step in 0..step_count as u32 {
            let head = records.head(step);
            let reason = "has a rule, a way or links that are not there";
            let wrong = ModelError::Step { step: step as usize, reason };
            let is_there = (head.rule as usize) < widths.rule_count && (head.way as usize) < widths.way_count;
            if !is_there || head.at != end {
                return Err(wrong);
            }
            let (up_width, down_width) = records.link_widths(step);
            let next = step as usize + 1;
            let is_last = next % BLOCK == 0 || next == step_count;
            let block_end = records.blocks[step as usize / BLOCK + 1] as usize;
            end = if is_last { block_end } else { records.links_begin(next as u32) };
            let ups = overlaps.link_count(head.way).saturating_mul(up_width as usize);
            let is_fit = end <= records.links.len()
                && end
                    .checked_sub(head.at)
                    .and_then(|bits| bits.checked_sub(ups))
                    .is_some_and(|bits| bits % down_width as usize == 0);
            if !is_fit {
                return Err(wrong);
            }
        }
        length("bits of links", end, records.links.len())?;
        Ok(records)
    }
}
