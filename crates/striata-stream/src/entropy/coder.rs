//! [`Coder`]: the interface that the range writer and the range reader share.

/// Number of symbols in an alphabet.
pub const SYMBOLS: usize = 16;
/// Cumulative shares of the symbols, in 1/32768: entry `i` is where the share of symbol `i` begins; the
/// first is 0.
pub type Shares = [i16; SYMBOLS];

/// Kind of data that a bit describes, for the writer's statistics.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Part {
    /// Flags and cuts: which vertices split, and where.
    Connectivity,
    /// Coordinates of new vertices.
    Positions,
    /// Wedges of corners, and groups of triangles.
    Wedges,
    /// Normals of vertices.
    Normals,
    /// Texture coordinates of vertices.
    TexCoords,
    /// All other attribute layers.
    OtherLayers,
    /// The base mesh and everything else.
    Base,
}

/// Number of kinds of [`Part`].
pub const PART_COUNT: usize = Part::Base as usize + 1;

/// A writer or a reader of a sequence of decisions.
pub trait Coder {
    /// Whether this is a reader. Readers ignore the values that callers pass.
    const READS: bool;

    /// Codes and returns one decision; its probability of being true is `p_one` / 65536 (`p_one` from 1 to
    /// 65535).
    fn bit(&mut self, bit: bool, p_one: u32) -> bool;

    /// Codes and returns the lowest `bits` (at most 24) bits of `value`, each with even odds.
    fn raw(&mut self, value: u32, bits: u32) -> u32;

    /// Codes and returns one of sixteen symbols; `begins` are the cumulative shares.
    fn symbol(&mut self, actual: usize, begins: &Shares) -> usize;

    /// Whether a reader needed bytes beyond the end, so that the value returned last is meaningless.
    fn overran(&self) -> bool;

    /// Attributes the following bits to a part, for the writer's statistics; a reader ignores it.
    fn part(&mut self, part: Part);
}
