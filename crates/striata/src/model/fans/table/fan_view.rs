//! Decodes fans of any form.

use super::writer::Creator;
use super::{CLOSED, FOLLOWED, HAS_PERMANENT, MAX_ARCS, WIDE};
use crate::model::varint::read_varint;

/// Decodes the fans of a vertex.
#[derive(Clone, Copy, Debug)]
pub(in super::super) struct FanEntry<'t> {
    bytes: &'t [u8],
    vertex: u32,
    own_step: u32,
    has_groups: bool,
}

impl<'t> FanEntry<'t> {
    /// Decodes bytes that begin with the first fan; `own_step` is the step of the vertex plus 1, or 0 in the base.
    #[inline]
    pub(in super::super) fn new(bytes: &'t [u8], vertex: u32, own_step: u32, has_groups: bool) -> Self {
        Self { bytes, vertex, own_step, has_groups }
    }
}

/// A fan in its encoded form.
#[derive(Clone, Copy, Debug)]
pub(in super::super) struct FanView<'t> {
    pub group: u32,
    pub vertex: u32,
    pub own_step: u32,
    pub is_closed: bool,
    pub permanent: u32,
    pub node_count: usize,
    creator_count: usize,
    numbers: NumberWidth,
    masks: NumberWidth,
    /// Bytes from the first node on.
    bytes: &'t [u8],
    /// Offset of the first creator in `bytes`.
    creators_at: usize,
}

/// Width of an encoded number.
#[derive(Clone, Copy, Debug)]
struct NumberWidth {
    bytes: usize,
    mask: u32,
}

impl NumberWidth {
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

impl<'t> Iterator for FanEntry<'t> {
    type Item = FanView<'t>;

    // Forced, because the returned value is large and callers use only a few of its fields.
    #[inline(always)]
    fn next(&mut self) -> Option<FanView<'t>> {
        let [flags, creator_flags, rest @ ..] = self.bytes else { return None };
        let mut bytes = rest;
        let group = if self.has_groups { read_varint(&mut bytes)? } else { 0 };
        let numbers =
            NumberWidth::new(2 + usize::from(flags & WIDE != 0) + usize::from(creator_flags & WIDE != 0));
        let arc_count = usize::from(flags & 0x1f) + 1;
        let masks = NumberWidth::new(arc_count.div_ceil(8));
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
    pub(in super::super) fn nodes(&self) -> impl Iterator<Item = u32> + use<'t> {
        let vertex = self.vertex;
        self.distances().map(move |distance| vertex - distance)
    }

    /// Returns the nodes as stored: as distances before the vertex.
    #[inline]
    pub(in super::super) fn distances(&self) -> impl Iterator<Item = u32> + use<'t> {
        let Self { numbers, bytes, .. } = *self;
        (0..self.node_count).map(move |i| numbers.read(bytes, i * numbers.bytes))
    }

    /// Returns the steps that create some of the arcs, each with the mask of its arcs.
    #[inline]
    pub(in super::super) fn creators(&self) -> impl Iterator<Item = Creator> + use<'t> {
        let own_step = self.own_step;
        self.pairs().map(move |[number, mask]| Creator {
            step: (number >> 1) + own_step - 1,
            mask,
            is_child: number & 1 != 0,
        })
    }

    /// Returns the creators as stored: the relative step with its child flag, and the mask.
    #[inline]
    pub(in super::super) fn pairs(&self) -> impl Iterator<Item = [u32; 2]> + use<'t> {
        let Self { numbers, masks, bytes, creators_at, .. } = *self;
        (0..self.creator_count).map(move |i| {
            let at = creators_at + i * (numbers.bytes + masks.bytes);
            [numbers.read(bytes, at), masks.read(bytes, at + numbers.bytes)]
        })
    }

    /// Number of bytes of the table after the fan; `None` if the fan extends beyond the end.
    pub(in super::super) fn bytes_after(&self) -> Option<usize> {
        let end = self.creators_at + self.creator_count * (self.numbers.bytes + self.masks.bytes);
        self.bytes.len().checked_sub(end)
    }

    /// Returns the mask of the active arcs.
    #[inline]
    pub(in super::super) fn mask(&self, is_collapsed: impl Fn(u32) -> bool) -> u32 {
        // A multiplication, because a branch would be mispredicted half of the time.
        self.creators().fold(self.permanent, |all, c| all | (c.mask * u32::from(is_collapsed(c.step))))
    }

    /// Number of arcs; each connects a node with the next.
    #[inline]
    pub(in super::super) fn arc_count(&self) -> usize {
        self.node_count - usize::from(!self.is_closed)
    }

    /// Writes the nodes, and the first one again if the fan is closed.
    #[inline]
    pub(in super::super) fn ring_into(&self, ring: &mut [u32; MAX_ARCS + 1]) {
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
    pub(in super::super) fn triangles_into(&self, mut mask: u32, out: &mut Vec<u32>) {
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
