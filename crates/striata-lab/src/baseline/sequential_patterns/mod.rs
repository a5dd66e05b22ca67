//! Patterns in sequential form, for transmission: \[KG98\] section 3.1.
//!
//! Fragments follow each other from coarse to fine, and each is told by where it goes in the triangulation that the ones before it
//! made: the number of its rule, its first anchor, and which neighbor of that is the second. Neighbors are counted
//! counterclockwise from the one with the smallest number. The hierarchy is not stored; whoever has read so many fragments has that
//! level.
//!
//! ```text
//! 4 bytes each  vertices of the base, triangles of the base, fragments, rules
//! 12 bytes      a triangle of the base
//! rules         a byte for the ring's length, a byte (1: open), a byte for each triangle of the floor
//! fragments     rule 8 bits (255: 16 more), anchor 32 bits, neighbor 4 bits (15: 32 more)
//! ```
//!
//! All numbers are little-endian, fragments begin at the lowest bit of the first byte after the rules. Rules are numbered by
//! how often they are met, so that the escape is for the rarest. Positions are not part of it: they follow in the order of refinement.
//!
//! Differs: the paper limits anchors to 16 neighbors and rules to 256; here either may be more, for more bits. What
//! is read may be anything: a fragment that has no place is an error, and nothing is allocated that the bytes do not
//! pay for (a fragment takes 44 bits and brings at most 255 triangles).
//!
//! Cost: 44 bits a fragment. Writing and reading are linear in the triangles of the fragments and the valences of their anchors.

mod decode;
mod encode;
mod error;

pub use self::decode::SequentialDecoder;
pub use self::error::SequentialPatternsError;
use striata::mesh::FragmentSequence;

use crate::baseline::loop_patterns::{Side, Surface};

/// Bits of a rule's number, and of one that does not fit.
const RULE_BITS: u32 = 8;
const LONG_RULE_BITS: u32 = 16;
/// Bits of a vertex.
const ANCHOR_BITS: u32 = 32;
/// Bits of the second anchor's place among the neighbors, and of one that does not fit.
const NEIGHBOR_BITS: u32 = 4;
const LONG_NEIGHBOR_BITS: u32 = 32;
/// Bits of a fragment without escapes: what the paper counts.
const FRAGMENT_BITS: usize = (RULE_BITS + ANCHOR_BITS + NEIGHBOR_BITS) as usize;
/// Instead of a number: it stands behind, longer.
const LONG_RULE: u64 = (1 << RULE_BITS) - 1;
const LONG_NEIGHBOR: u64 = (1 << NEIGHBOR_BITS) - 1;

/// What a fragment must not do.
const OPENS_TWICE: &str = "opens a hole at a vertex that has another border";

/// The connectivity of all levels as bytes; see the [module](self).
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SequentialPatterns {
    bytes: Vec<u8>,
    step_count: usize,
    fragment_bits: usize,
}

impl SequentialPatterns {
    /// The bytes.
    pub fn as_bytes(&self) -> &[u8] {
        &self.bytes
    }

    /// Fragments.
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

/// Reads all fragments. Their errors are not known, and 0.
///
/// # Errors
/// [`SequentialPatternsError`] where the bytes are none that a sequence can have.
pub fn decode_sequential(bytes: &[u8]) -> Result<FragmentSequence, SequentialPatternsError> {
    SequentialDecoder::new(bytes)?.into_sequence()
}

/// The neighbors of a vertex, counterclockwise, told by the triangles around it.
#[derive(Debug, Default)]
struct Neighbors {
    star: Vec<Side>,
    is_closed: bool,
    /// Place of the neighbor with the smallest number.
    smallest: usize,
}

impl Neighbors {
    fn find(&mut self, surface: &Surface, vertex: u32) {
        self.is_closed = surface.star_into(vertex, &mut self.star);
        self.smallest = (0..self.count()).min_by_key(|&place| self.vertex(surface, place)).unwrap_or(0);
    }

    /// An open star has one more than it has triangles.
    fn count(&self) -> usize {
        self.star.len() + usize::from(!self.is_closed && !self.star.is_empty())
    }

    fn vertex(&self, surface: &Surface, place: usize) -> u32 {
        match self.star.get(place) {
            Some(&(slot, corner)) => surface.corners()[slot as usize][(corner + 1) % 3],
            None => {
                let (slot, corner) = self.star[place - 1];
                surface.corners()[slot as usize][(corner + 2) % 3]
            }
        }
    }

    /// The side from the vertex to a neighbor, with a triangle on its left; none for the last neighbor at a border.
    fn side(&self, place: usize) -> Option<Side> {
        self.star.get(place).copied()
    }

    /// Place of the neighbor that is counted as so manieth, and the other way round.
    fn place(&self, counted: usize) -> usize {
        (self.smallest + counted) % self.count()
    }

    fn counted(&self, place: usize) -> usize {
        (place + self.count() - self.smallest) % self.count()
    }
}
