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
//! | `coder.rs` | [`Coder`]: the writer or the reader of a chain of decisions |
//! | `range.rs` | the range coder: [`RangeWriter`], [`RangeReader`] |
//! | `adaptive.rs` | [`AdaptiveBit`]: the probability of one decision, learned quickly at first |
//! | `logistic.rs` | probabilities as log-odds and back, tables made by integer arithmetic |
//! | `mixer.rs` | [`Mixer`]: many opinions about one decision weighted online; [`Refiner`]: what is left to learn |
//! | `wide_mixer.rs` | [`WideMixer`]: the same in 16-bit lanes |
//! | `symbol.rs` | [`AdaptiveSymbol`]: one of sixteen at once |
//! | `quick_symbol.rs` | [`QuickSymbol`]: the same in 16-bit lanes |
//! | `number.rs` | [`AdaptiveNumber`]: integers of any size |
//! | `mixed_number.rs` | [`MixedNumber`]: the same under several contexts at once |

mod adaptive;
mod coder;
mod logistic;
mod mixed_number;
mod mixer;
mod number;
mod quick_symbol;
mod range;
mod symbol;
mod wide_mixer;

pub(crate) use adaptive::{AdaptiveBit, Rate};
pub(crate) use coder::{Coder, PART_COUNT, Part, QuickShares};
pub(crate) use logistic::{log_odds, log2_q8, log2_q16, probability};
pub(crate) use mixed_number::MixedNumber;
pub(crate) use mixer::{Mixer, Refiner};
pub(crate) use number::{AdaptiveNumber, code_uniform};
pub(crate) use quick_symbol::{QuickSymbol, code_by_two, code_shares};
pub(crate) use range::{RangeReader, RangeWriter};
pub(crate) use symbol::{AdaptiveSymbol, code_symbol};
pub(crate) use wide_mixer::WideMixer;
