//! Entropy coding: single decisions with probabilities, and the adaptive models that give these probabilities.
//!
//! Everything that is coded is a chain of yes-or-no decisions. A [`Coder`] is either the writer or the reader of
//! such a chain, so that one generic function describes both directions: the writer passes what it means, the
//! reader's argument is ignored, and both go on with the decision that comes back. The models around it (counters,
//! a logistic mixer \[Mah05\], numbers in doubling buckets) hold integers only and take nothing but what was coded
//! before: a stream decodes to the same bits on every machine.
//!
//! | file | what it does |
//! | --- | --- |
//! | `range.rs` | the range coder: [`RangeWriter`], [`RangeReader`] |
//! | `adaptive.rs` | [`AdaptiveBit`]: the probability of one decision, learned quickly at first |
//! | `logistic.rs` | probabilities as log-odds and back, tables made by integer arithmetic |
//! | `mixer.rs` | [`Mixer`]: many opinions about one decision weighted online; [`Refiner`]: what is left to learn |
//! | `wide_mixer.rs` | [`WideMixer`]: the same in 16-bit lanes |
//! | `symbol.rs` | [`AdaptiveSymbol`]: one of sixteen at once |
//! | `quick_symbol.rs` | [`QuickSymbol`]: the same in 16-bit lanes |
//! | `number.rs` | [`AdaptiveNumber`]: integers of any size |

mod adaptive;
mod logistic;
mod mixer;
mod number;
mod quick_symbol;
mod range;
mod symbol;
mod wide_mixer;

pub(crate) use adaptive::{AdaptiveBit, Rate};
pub(crate) use logistic::{log_odds, log2_q8, log2_q16, probability};
pub(crate) use mixer::{Mixer, Refiner};
pub(crate) use number::{AdaptiveNumber, code_uniform};
pub(crate) use quick_symbol::{QuickShares, QuickSymbol, code_by_two, code_shares};
pub(crate) use range::{RangeReader, RangeWriter};
pub(crate) use symbol::{AdaptiveSymbol, Shares, code_symbol};
pub(crate) use wide_mixer::WideMixer;

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
