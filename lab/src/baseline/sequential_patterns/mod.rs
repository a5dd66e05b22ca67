//! Patterns in sequential form, for transmission: \[KG98\] section 3.1.
//!
//! Fragments are stored from coarse to fine. Each is described by its position in the triangulation that
//! the previous ones lead to: its rule index, its first anchor, and which neighbor of that vertex is the
//! second anchor. Neighbors are counted counterclockwise from the one with the smallest index. The
//! hierarchy is not stored; a decoder that has read `n` fragments has the level with split count `n`.
//!
//! ```text
//! 4 bytes each  vertices of the base, triangles of the base, fragments, rules
//! 12 bytes      a triangle of the base
//! rules         a byte for the ring's length, a byte (1: open), a byte for each triangle of the floor
//! fragments     rule 8 bits (255: 16 more), anchor 32 bits, neighbor 4 bits (15: 32 more)
//! ```
//!
//! All integers are little-endian, and fragments begin at the lowest bit of the first byte after the
//! rules. Rules are numbered by descending frequency, so only the rarest need the escape. Positions are
//! not included; they follow in refinement order.
//!
//! Differs: the paper limits anchors to 16 neighbors and rules to 256; here escape codes lift both limits
//! at the cost of more bits. The decoder accepts arbitrary input: a fragment that does not fit its level
//! is an error, and memory stays proportional to the input (a fragment takes 44 bits and creates at most
//! 255 triangles).
//!
//! Cost: 44 bits per fragment. Encoding and decoding are linear in the triangles of the fragments and the
//! valences of their anchors.

mod decode;
mod encode;
mod error;

pub use self::decode::SequentialDecoder;
pub use self::error::SequentialPatternsError;
use striata::mesh::FragmentSequence;

use crate::baseline::loop_patterns::{LoopSurface, Side};

/// Bits of a rule index, and of one that needs the escape.
const RULE_BITS: u32 = 8;
const LONG_RULE_BITS: u32 = 16;
/// Bits of a vertex index.
const ANCHOR_BITS: u32 = 32;
/// Bits of the second anchor's rank among the neighbors, and of one that needs the escape.
const NEIGHBOR_BITS: u32 = 4;
const LONG_NEIGHBOR_BITS: u32 = 32;
/// Bits of a fragment without escapes, as the paper counts.
const FRAGMENT_BITS: usize = (RULE_BITS + ANCHOR_BITS + NEIGHBOR_BITS) as usize;
/// Escape values: a wider value follows.
const LONG_RULE: u64 = (1 << RULE_BITS) - 1;
const LONG_NEIGHBOR: u64 = (1 << NEIGHBOR_BITS) - 1;

/// Reason for rejecting a fragment that would make a surface non-manifold.
const OPENS_TWICE: &str = "opens a hole at a vertex that has another border";

/// The connectivity of all levels, encoded as bytes; see the [module](self).
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SequentialPatterns {
    bytes: Vec<u8>,
    step_count: usize,
    fragment_bits: usize,
}

impl SequentialPatterns {
    /// The encoded bytes.
    pub fn as_bytes(&self) -> &[u8] {
        &self.bytes
    }

    /// Number of fragments.
    pub fn step_count(&self) -> usize {
        self.step_count
    }

    /// Bits of the fragments alone, without the base and the rules.
    pub fn fragment_bits(&self) -> usize {
        self.fragment_bits
    }

    /// Bits of the fragments as the paper counts them.
    pub fn paper_fragment_bits(&self) -> usize {
        FRAGMENT_BITS * self.step_count
    }
}

/// Decodes all fragments. Their errors are not transmitted and therefore 0.
///
/// # Errors
/// [`SequentialPatternsError`] if the bytes are not a valid sequence.
pub fn decode_sequential(bytes: &[u8]) -> Result<FragmentSequence, SequentialPatternsError> {
    SequentialDecoder::new(bytes)?.into_sequence()
}

/// The neighbors of a vertex, counterclockwise, derived from the triangles around it.
#[derive(Debug, Default)]
struct OrderedNeighbors {
    star: Vec<Side>,
    is_closed: bool,
    /// Index of the neighbor with the smallest vertex.
    smallest: usize,
}

impl OrderedNeighbors {
    fn find(&mut self, surface: &LoopSurface, vertex: u32) {
        self.is_closed = surface.star_into(vertex, &mut self.star);
        self.smallest = (0..self.count()).min_by_key(|&index| self.vertex(surface, index)).unwrap_or(0);
    }

    /// Number of neighbors; an open star has one more than it has triangles.
    fn count(&self) -> usize {
        self.star.len() + usize::from(!self.is_closed && !self.star.is_empty())
    }

    fn vertex(&self, surface: &LoopSurface, index: usize) -> u32 {
        match self.star.get(index) {
            Some(&(slot, corner)) => surface.corners()[slot as usize][(corner + 1) % 3],
            None => {
                let (slot, corner) = self.star[index - 1];
                surface.corners()[slot as usize][(corner + 2) % 3]
            }
        }
    }

    /// The side from the vertex to a neighbor, with a triangle on its left; `None` for the last neighbor
    /// at a border.
    fn side(&self, index: usize) -> Option<Side> {
        self.star.get(index).copied()
    }

    /// Index of the neighbor with the given rank, counted from the smallest one.
    fn index(&self, rank: usize) -> usize {
        (self.smallest + rank) % self.count()
    }

    /// Rank of the neighbor with the given index, counted from the smallest one.
    fn rank(&self, index: usize) -> usize {
        (index + self.count() - self.smallest) % self.count()
    }
}
