//! Byte layout of the table: the fans of all vertices one after the other, with indices relative to the
//! vertex.
//!
//! Nodes of a ring are older than the vertex in its center, and steps that create its triangles come later
//! than its own step, so all numbers are small non-negative differences. All numbers of a fan have the
//! same width, at least two bytes and wide enough for the largest. The layout of a fan is:
//!
//! ```text
//! byte    bits 0..4 arc count - 1, bit 5 closed, bit 6 one more byte per number, bit 7 another fan follows
//! byte    bits 0..5 creator count, bit 6 one more byte per number, bit 7 some arcs are permanent
//! group   varint, only if there are several groups
//! nodes   vertex - node, one per arc and, unless the fan is closed, one more
//! mask    of the permanent arcs, if there are any; one byte per 8 arcs
//! pairs   for each creator: 2 (step - own step), plus 1 if it is a child of this step; then its arc mask.
//!         The own step of a base vertex counts as -1.
//! ```
//!
//! The start of a vertex's fans is stored as a two-byte offset from the start of its block of vertices.

mod fan_view;
mod writer;

pub(super) use self::fan_view::{FanEntry, FanView};
pub(super) use self::writer::{Creator, Fan, TableWriter};
use crate::model::ModelError;

/// Largest number of arcs of a fan, limited by the width of its masks.
pub const MAX_ARCS: usize = 32;

/// Number of vertices per block.
const BLOCK: usize = 64;

/// Padding after the last entry, so that four bytes can be read wherever a number begins.
const PADDING: usize = 4;

const CLOSED: u8 = 1 << 5;
/// Numbers are one byte wider; the flag can be set in either of the two header bytes.
const WIDE: u8 = 1 << 6;
const FOLLOWED: u8 = 1 << 7;
const HAS_PERMANENT: u8 = 1 << 7;

/// The encoded entries of all vertices; see the [module](self).
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct FanTable {
    bytes: Vec<u8>,
    /// Offset of each block of vertices in `bytes`.
    blocks: Vec<u32>,
    /// Offset of each vertex from the start of its block, followed by the offset of the end.
    starts: Vec<u16>,
    /// Offset of each vertex in `bytes`, if two bytes are too few for some; `starts` is then empty.
    wide_starts: Vec<u32>,
    has_groups: bool,
}

/// The arrays of a table in the layout of the file format.
#[derive(Clone, Copy, Debug)]
pub(super) struct TableArrays<'a> {
    /// Encoded entries of all vertices.
    pub entries: &'a [u8],
    /// Offset of each block of vertices, or of each vertex if `starts` is empty.
    pub blocks: &'a [u32],
    /// Offset of each vertex from the start of its block.
    pub starts: &'a [u16],
}

impl FanTable {
    /// Returns the size in bytes of the entries, and of the arrays that locate them.
    pub(super) fn sizes(&self) -> [usize; 2] {
        let starts = 4 * (self.blocks.len() + self.wide_starts.len()) + 2 * self.starts.len();
        [self.bytes.len(), starts]
    }

    /// Returns the arrays to store in a file.
    pub(super) fn arrays(&self) -> TableArrays<'_> {
        let blocks = if self.starts.is_empty() { &self.wide_starts } else { &self.blocks };
        TableArrays { entries: &self.bytes, blocks, starts: &self.starts }
    }

    /// Creates a table from stored arrays.
    ///
    /// # Errors
    /// If the arrays do not give an ascending sequence of starts for `vertex_count` vertices, up to the
    /// end of the entries.
    pub(super) fn from_arrays(
        arrays: TableArrays<'_>,
        vertex_count: usize,
        has_groups: bool,
    ) -> Result<Self, ModelError> {
        let TableArrays { entries, blocks, starts } = arrays;
        let (bytes, blocks, starts) = (entries.to_vec(), blocks.to_vec(), starts.to_vec());
        let length = |what, found, expected| {
            if found == expected { Ok(()) } else { Err(ModelError::Length { what, found, expected }) }
        };
        let is_wide = starts.is_empty();
        let start_count = vertex_count + 1;
        if is_wide {
            length("wide starts", blocks.len(), start_count)?;
        } else {
            length("starts", starts.len(), start_count)?;
            length("starts of blocks", blocks.len(), start_count.div_ceil(BLOCK))?;
        }
        if let Some(place) = blocks.iter().position(|&start| start as usize > entries.len()) {
            return Err(ModelError::Listed { what: "start", place, reason: "lies beyond the entries" });
        }
        let (blocks, wide_starts) = if is_wide { (Vec::new(), blocks) } else { (blocks, Vec::new()) };
        let table = Self { bytes, blocks, starts, wide_starts, has_groups };
        let mut end = 0;
        for vertex in 0..start_count {
            let start = table.start(vertex);
            if start < end || (vertex == 0 && start > 0) {
                let reason = "does not begin at the end of the previous one";
                return Err(ModelError::Entry { vertex, reason });
            }
            end = start;
        }
        length("bytes of entries", entries.len(), end + PADDING)?;
        Ok(table)
    }

    /// Returns the offset of a vertex's entry.
    #[inline]
    pub(super) fn start(&self, vertex: usize) -> usize {
        if self.starts.is_empty() {
            self.wide_starts[vertex] as usize
        } else {
            self.blocks[vertex / BLOCK] as usize + usize::from(self.starts[vertex])
        }
    }

    /// Returns the fans of a vertex; `own_step` is its step plus 1, or 0 for a base vertex.
    #[inline]
    pub(super) fn entry(&self, vertex: u32, own_step: u32) -> FanEntry<'_> {
        let start = self.start(vertex as usize);
        let is_empty = start == self.start(vertex as usize + 1);
        let bytes = if is_empty { &[][..] } else { &self.bytes[start..] };
        FanEntry::new(bytes, vertex, own_step, self.has_groups)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn fan(nodes: &[u32], arc_count: usize, permanent: u32, creators: &[(u32, u32)]) -> Fan {
        let creators = creators.iter().map(|&(step, mask)| Creator { step, mask, is_child: step % 2 == 0 });
        Fan { group: 0, arc_count, nodes: nodes.to_vec(), permanent, creators: creators.collect() }
    }

    #[test]
    fn arrays_rebuild_the_table_or_are_rejected() {
        let mut writer = TableWriter::new(false);
        for vertex in 0..200 {
            let fans = [fan(&[0, vertex / 2], 1, 1, &[])];
            writer.push(0, if vertex > 2 { &fans } else { &[] });
        }
        let table = writer.finish();
        let rebuilt = |damage: fn(&mut Vec<u8>, &mut Vec<u32>, &mut Vec<u16>)| {
            let TableArrays { entries, blocks, starts } = table.arrays();
            let (mut bytes, mut blocks, mut starts) = (entries.to_vec(), blocks.to_vec(), starts.to_vec());
            damage(&mut bytes, &mut blocks, &mut starts);
            FanTable::from_arrays(
                TableArrays { entries: &bytes, blocks: &blocks, starts: &starts },
                200,
                false,
            )
        };
        assert_eq!(rebuilt(|_, _, _| ()), Ok(table.clone()));
        let wide = rebuilt(|_, blocks, starts| {
            let all = starts.iter().enumerate().map(|(i, &start)| blocks[i / BLOCK] + u32::from(start));
            (*blocks, *starts) = (all.collect(), Vec::new());
        });
        assert_eq!(wide.unwrap().entry(150, 0).count(), 1);
        for vertex in [0, 3, 64, 199] {
            let reason = "does not begin at the end of the previous one";
            let TableArrays { entries, blocks, starts } = table.arrays();
            let (mut blocks, mut starts) = (blocks.to_vec(), starts.to_vec());
            starts[vertex] += 700;
            blocks[vertex / BLOCK] += 40;
            let found =
                FanTable::from_arrays(TableArrays { entries, blocks: &blocks, starts: &starts }, 200, false);
            assert!(matches!(found, Err(ModelError::Entry { reason: r, .. }) if r == reason), "{vertex}");
        }
        let behind = rebuilt(|_, blocks, _| blocks[2] = u32::MAX);
        assert!(matches!(behind, Err(ModelError::Listed { what: "start", place: 2, .. })));
        let too_few = [
            rebuilt(|bytes, _, _| bytes.truncate(bytes.len() - 9)),
            rebuilt(|_, blocks, _| blocks.truncate(2)),
            rebuilt(|_, _, starts| starts.truncate(9)),
            rebuilt(|_, _, starts| starts.clear()),
        ];
        for (found, what) in
            too_few.into_iter().zip(["bytes of entries", "starts of blocks", "starts", "wide starts"])
        {
            assert!(matches!(found, Err(ModelError::Length { what: w, .. }) if w == what), "{what}");
        }
    }

    #[test]
    fn fans_survive_encoding() {
        let wide: Vec<u32> = (0..33).map(|i| 5 * i).collect();
        let small =
            vec![fan(&[0, 1], 1, 1, &[]), fan(&[1, 0, 1], 3, 0b100, &[(70_000, 0b001), (20_000_000, 0b010)])];
        let mut writer = TableWriter::new(false);
        writer.push(0, &[]);
        writer.push(0, &[]);
        writer.push(1, &small);
        for _ in 3..200 {
            writer.push(1, &[]);
        }
        let big = vec![fan(&wide, 32, 1 << 31, &[(7, 0xff), (9, 0x7fff_ff00)])];
        writer.push(5, &big);
        let table = writer.finish();
        let read = |vertex: u32, own_step: u32| -> Vec<Fan> {
            let entry = table.entry(vertex, own_step);
            entry
                .map(|view| Fan {
                    group: view.group,
                    arc_count: view.node_count - usize::from(!view.is_closed),
                    nodes: view.nodes().collect(),
                    permanent: view.permanent,
                    creators: view.creators().collect(),
                })
                .collect()
        };
        assert!(read(0, 0).is_empty() && read(1, 0).is_empty() && read(199, 1).is_empty());
        assert_eq!(read(2, 1), small);
        assert_eq!(read(200, 5), big);
        let mut out = Vec::new();
        table.entry(2, 1).for_each(|view| view.triangles_into(view.mask(|step| step >= 70_000), &mut out));
        assert_eq!(out, [2, 0, 1, 2, 1, 0, 2, 0, 1, 2, 1, 1]);
    }
}
