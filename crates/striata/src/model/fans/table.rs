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

use crate::model::ModelError;
use crate::model::varint::{read_varint, write_varint};

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

/// A fan before it is encoded: its nodes, its permanent arcs, and its other arcs by the step that creates
/// them.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct Fan {
    pub(super) group: u32,
    pub(super) arc_count: usize,
    /// One node per arc and, unless the fan is closed, one more.
    pub(super) nodes: Vec<u32>,
    pub(super) permanent: u32,
    pub(super) creators: Vec<Creator>,
}

/// A step that creates some arcs of a fan.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Creator {
    pub(super) step: u32,
    pub(super) mask: u32,
    /// Whether this entry lists the step as a child in the tree; only one entry does so for each step.
    pub(super) is_child: bool,
}

/// The encoded entries of all vertices; see the [module](self).
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct Table {
    bytes: Vec<u8>,
    /// Offset of each block of vertices in `bytes`.
    blocks: Vec<u32>,
    /// Offset of each vertex from the start of its block, followed by the offset of the end.
    starts: Vec<u16>,
    /// Offset of each vertex in `bytes`, if two bytes are too few for some; `starts` is then empty.
    wide_starts: Vec<u32>,
    has_groups: bool,
}

/// Encodes entries, vertex by vertex.
#[derive(Debug)]
pub(super) struct TableWriter {
    bytes: Vec<u8>,
    starts: Vec<u32>,
    has_groups: bool,
}

impl TableWriter {
    pub(super) fn new(has_groups: bool) -> Self {
        Self { bytes: Vec::new(), starts: vec![0], has_groups }
    }

    /// Appends the entry of the next vertex; `own_step` is its step plus 1, or 0 for a base vertex.
    pub(super) fn push(&mut self, own_step: u32, fans: &[Fan]) {
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

    pub(super) fn finish(self) -> Table {
        let Self { mut bytes, starts, has_groups } = self;
        bytes.extend_from_slice(&[0; PADDING]);
        let blocks: Vec<u32> = starts.iter().copied().step_by(BLOCK).collect();
        let within = starts.iter().enumerate().map(|(i, &start)| u16::try_from(start - blocks[i / BLOCK]));
        match within.collect::<Result<Vec<u16>, _>>() {
            Ok(within) => Table { bytes, blocks, starts: within, wide_starts: Vec::new(), has_groups },
            Err(_) => {
                Table { bytes, blocks: Vec::new(), starts: Vec::new(), wide_starts: starts, has_groups }
            }
        }
    }
}

/// The arrays of a table in the layout of the file format.
#[derive(Clone, Copy, Debug)]
pub(super) struct TableArrays<'a> {
    /// Encoded entries of all vertices.
    pub(super) entries: &'a [u8],
    /// Offset of each block of vertices, or of each vertex if `starts` is empty.
    pub(super) blocks: &'a [u32],
    /// Offset of each vertex from the start of its block.
    pub(super) starts: &'a [u16],
}

impl Table {
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
        if let Some(place) = blocks.iter().position(|&start| start as usize > bytes.len()) {
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
        length("bytes of entries", table.bytes.len(), end + PADDING)?;
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
    pub(super) fn entry(&self, vertex: u32, own_step: u32) -> Entry<'_> {
        let start = self.start(vertex as usize);
        let is_empty = start == self.start(vertex as usize + 1);
        let bytes = if is_empty { &[][..] } else { &self.bytes[start..] };
        Entry { bytes, vertex, own_step, has_groups: self.has_groups }
    }
}

/// Decodes the fans of a vertex.
#[derive(Clone, Copy, Debug)]
pub(super) struct Entry<'t> {
    bytes: &'t [u8],
    vertex: u32,
    own_step: u32,
    has_groups: bool,
}

/// A fan in its encoded form.
#[derive(Clone, Copy, Debug)]
pub(super) struct FanView<'t> {
    pub(super) group: u32,
    pub(super) vertex: u32,
    own_step: u32,
    pub(super) is_closed: bool,
    pub(super) permanent: u32,
    pub(super) node_count: usize,
    creator_count: usize,
    numbers: Width,
    masks: Width,
    /// Bytes from the first node on.
    bytes: &'t [u8],
    /// Offset of the first creator in `bytes`.
    creators_at: usize,
}

/// Width of an encoded number.
#[derive(Clone, Copy, Debug)]
struct Width {
    bytes: usize,
    mask: u32,
}

impl Width {
    #[inline]
    fn new(bytes: usize) -> Self {
        Self { bytes, mask: u32::MAX >> (32 - 8 * bytes) }
    }

    /// Reads the number at an offset.
    #[inline]
    fn read(self, bytes: &[u8], at: usize) -> u32 {
        let word = bytes.get(at..).and_then(|rest| rest.first_chunk());
        u32::from_le_bytes(*word.unwrap_or(&[0; 4])) & self.mask
    }
}

impl<'t> Iterator for Entry<'t> {
    type Item = FanView<'t>;

    // Forced, because the returned value is large and callers use only a few of its fields.
    #[inline(always)]
    fn next(&mut self) -> Option<FanView<'t>> {
        let [flags, creator_flags, rest @ ..] = self.bytes else { return None };
        let mut bytes = rest;
        let group = if self.has_groups { read_varint(&mut bytes)? } else { 0 };
        let numbers = Width::new(2 + usize::from(flags & WIDE != 0) + usize::from(creator_flags & WIDE != 0));
        let arc_count = usize::from(flags & 0x1f) + 1;
        let masks = Width::new(arc_count.div_ceil(8));
        let is_closed = flags & CLOSED != 0;
        let node_count = arc_count + usize::from(!is_closed);
        let permanent_at = numbers.bytes * node_count;
        let has_permanent = creator_flags & HAS_PERMANENT != 0;
        let permanent = if has_permanent { masks.read(bytes, permanent_at) } else { 0 };
        let creators_at = permanent_at + if has_permanent { masks.bytes } else { 0 };
        let creator_count = usize::from(creator_flags & 0x3f);
        let end = creators_at + creator_count * (numbers.bytes + masks.bytes);
        self.bytes = if flags & FOLLOWED == 0 { &[] } else { bytes.get(end..)? };
        let (vertex, own_step) = (self.vertex, self.own_step);
        Some(FanView {
            group,
            vertex,
            own_step,
            is_closed,
            permanent,
            node_count,
            creator_count,
            numbers,
            masks,
            bytes,
            creators_at,
        })
    }
}

impl<'t> FanView<'t> {
    /// Returns the vertices around the center, in order.
    #[inline]
    pub(super) fn nodes(&self) -> impl Iterator<Item = u32> + use<'t> {
        let vertex = self.vertex;
        self.distances().map(move |distance| vertex - distance)
    }

    /// Returns the nodes as stored: as distances before the vertex.
    #[inline]
    pub(super) fn distances(&self) -> impl Iterator<Item = u32> + use<'t> {
        let Self { numbers, bytes, .. } = *self;
        (0..self.node_count).map(move |i| numbers.read(bytes, i * numbers.bytes))
    }

    /// Returns the steps that create some of the arcs, each with the mask of its arcs.
    #[inline]
    pub(super) fn creators(&self) -> impl Iterator<Item = Creator> + use<'t> {
        let own_step = self.own_step;
        self.pairs().map(move |[number, mask]| Creator {
            step: (number >> 1) + own_step - 1,
            mask,
            is_child: number & 1 != 0,
        })
    }

    /// Returns the creators as stored: the relative step with its child flag, and the mask.
    #[inline]
    pub(super) fn pairs(&self) -> impl Iterator<Item = [u32; 2]> + use<'t> {
        let Self { numbers, masks, bytes, creators_at, .. } = *self;
        (0..self.creator_count).map(move |i| {
            let at = creators_at + i * (numbers.bytes + masks.bytes);
            [numbers.read(bytes, at), masks.read(bytes, at + numbers.bytes)]
        })
    }

    /// Number of bytes of the table after the fan; `None` if the fan extends beyond the end.
    pub(super) fn bytes_after(&self) -> Option<usize> {
        let end = self.creators_at + self.creator_count * (self.numbers.bytes + self.masks.bytes);
        self.bytes.len().checked_sub(end)
    }

    /// Returns the mask of the active arcs.
    #[inline]
    pub(super) fn mask(&self, is_collapsed: impl Fn(u32) -> bool) -> u32 {
        // A multiplication, because a branch would be mispredicted half of the time.
        self.creators().fold(self.permanent, |all, c| all | (c.mask * u32::from(is_collapsed(c.step))))
    }

    /// Number of arcs; each connects a node with the next.
    #[inline]
    pub(super) fn arc_count(&self) -> usize {
        self.node_count - usize::from(!self.is_closed)
    }

    /// Writes the nodes, and the first one again if the fan is closed.
    #[inline]
    pub(super) fn ring_into(&self, ring: &mut [u32; MAX_ARCS + 1]) {
        for (slot, node) in ring.iter_mut().zip(self.nodes()) {
            *slot = node;
        }
        if self.is_closed {
            // Room for one more node, because a closed fan can have `MAX_ARCS` nodes.
            ring[self.node_count] = ring[0];
        }
    }

    /// Appends the triangles of the arcs in a mask.
    #[inline]
    pub(super) fn triangles_into(&self, mut mask: u32, out: &mut Vec<u32>) {
        if mask == 0 {
            return;
        }
        let mut ring = [0; MAX_ARCS + 1];
        self.ring_into(&mut ring);
        while mask != 0 {
            let at = mask.trailing_zeros() as usize;
            mask &= mask - 1;
            out.extend_from_slice(&[self.vertex, ring[at], ring[at + 1]]);
        }
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
            Table::from_arrays(TableArrays { entries: &bytes, blocks: &blocks, starts: &starts }, 200, false)
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
                Table::from_arrays(TableArrays { entries, blocks: &blocks, starts: &starts }, 200, false);
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
