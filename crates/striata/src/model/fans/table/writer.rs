//! Encodes the table.

use super::{BLOCK, CLOSED, FOLLOWED, FanTable, HAS_PERMANENT, PADDING, WIDE};
use crate::model::varint::write_varint;

/// A fan before it is encoded: its nodes, its permanent arcs, and its other arcs by the step that creates
/// them.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(in super::super) struct Fan {
    pub group: u32,
    pub arc_count: usize,
    /// One node per arc and, unless the fan is closed, one more.
    pub nodes: Vec<u32>,
    pub permanent: u32,
    pub creators: Vec<Creator>,
}

/// A step that creates some arcs of a fan.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in super::super) struct Creator {
    pub step: u32,
    pub mask: u32,
    /// Whether this entry lists the step as a child in the tree; only one entry does so for each step.
    pub is_child: bool,
}

/// Encodes entries, vertex by vertex.
#[derive(Debug)]
pub(in super::super) struct TableWriter {
    bytes: Vec<u8>,
    starts: Vec<u32>,
    has_groups: bool,
}

impl TableWriter {
    pub(in super::super) fn new(has_groups: bool) -> Self {
        Self { bytes: Vec::new(), starts: vec![0], has_groups }
    }

    /// Appends the entry of the next vertex; `own_step` is its step plus 1, or 0 for a base vertex.
    pub(in super::super) fn push(&mut self, own_step: u32, fans: &[Fan]) {
        let vertex = self.starts.len() as u32 - 1;
        for (i, fan) in fans.iter().enumerate() {
            self.push_fan(vertex, own_step, fan, i + 1 < fans.len());
        }
        self.starts.push(self.bytes.len() as u32);
    }

    fn push_fan(&mut self, vertex: u32, own_step: u32, fan: &Fan, is_followed: bool) {
        let nodes = || fan.nodes.iter().map(|&node| vertex - node);
        let steps = || fan.creators.iter().map(|c| (c.step + 1 - own_step) << 1 | u32::from(c.is_child));
        let largest = nodes().chain(steps()).max().unwrap_or(0);
        let number_bytes = (4 - largest.leading_zeros() as usize / 8).max(2);
        let flag = |is_set: bool, bit: u8| if is_set { bit } else { 0 };
        let is_closed = fan.nodes.len() == fan.arc_count;
        self.bytes.push(
            (fan.arc_count - 1) as u8
                | flag(is_closed, CLOSED)
                | flag(number_bytes > 2, WIDE)
                | flag(is_followed, FOLLOWED),
        );
        self.bytes.push(
            fan.creators.len() as u8 | flag(number_bytes > 3, WIDE) | flag(fan.permanent != 0, HAS_PERMANENT),
        );
        if self.has_groups {
            write_varint(fan.group, &mut self.bytes);
        }
        for number in nodes() {
            self.bytes.extend_from_slice(&number.to_le_bytes()[..number_bytes]);
        }
        let mask_bytes = fan.arc_count.div_ceil(8);
        if fan.permanent != 0 {
            self.bytes.extend_from_slice(&fan.permanent.to_le_bytes()[..mask_bytes]);
        }
        for (number, Creator { mask, .. }) in steps().zip(&fan.creators) {
            self.bytes.extend_from_slice(&number.to_le_bytes()[..number_bytes]);
            self.bytes.extend_from_slice(&mask.to_le_bytes()[..mask_bytes]);
        }
    }

    pub(in super::super) fn finish(self) -> FanTable {
        let Self { mut bytes, starts, has_groups } = self;
        bytes.extend_from_slice(&[0; PADDING]);
        let blocks: Vec<u32> = starts.iter().copied().step_by(BLOCK).collect();
        let within = starts.iter().enumerate().map(|(i, &start)| u16::try_from(start - blocks[i / BLOCK]));
        match within.collect::<Result<Vec<u16>, _>>() {
            Ok(within) => FanTable { bytes, blocks, starts: within, wide_starts: Vec::new(), has_groups },
            Err(_) => {
                FanTable { bytes, blocks: Vec::new(), starts: Vec::new(), wide_starts: starts, has_groups }
            }
        }
    }
}
