//! What the writer and the reader have in common.

/// Symbols of an alphabet.
pub(crate) const SYMBOLS: usize = 16;
/// Where each symbol's share begins, of 65536; the first at 0.
pub(crate) type Shares = [i32; SYMBOLS];
/// Where each symbol's share begins, of 32768; the first at 0.
pub(crate) type QuickShares = [i16; SYMBOLS];

/// What a bit belongs to, for statistics of the writer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Part {
    /// Which vertices split, and where.
    Connectivity,
    /// Coordinates of new vertices.
    Positions,
    /// Which vertices corners show, and groups.
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

/// How many kinds of [`Part`] there are.
pub(crate) const PART_COUNT: usize = Part::Base as usize + 1;

/// The writer or the reader of a chain of decisions.
pub(crate) trait Coder {
    /// Whether decisions come from a stream; a writer's come from the caller.
    const READS: bool;

    /// Codes one decision whose probability of being true is `p_one` / 65536 (1 to 65535). The writer passes what
    /// it means; a reader ignores `bit`. Returns the decision.
    fn bit(&mut self, bit: bool, p_one: u32) -> bool;

    /// Codes `bits` (at most 24) equally likely bits, the lowest of `value`.
    fn raw(&mut self, value: u32, bits: u32) -> u32;

    /// Codes one of sixteen symbols by where their shares begin, in rising order.
    fn symbol(&mut self, meant: usize, begins: &Shares) -> usize;

    /// Codes one of sixteen symbols by where their shares begin, in rising order.
    fn quick_symbol(&mut self, meant: usize, begins: &QuickShares) -> usize;

    /// True where a reader needed bytes beyond the end: what it returned last means nothing.
    fn overran(&self) -> bool;

    /// What the next bits belong to: for the statistics of a writer, nothing to a reader.
    fn part(&mut self, part: Part);
}
