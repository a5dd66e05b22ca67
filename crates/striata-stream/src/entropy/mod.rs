//! Entropy coding: a range coder for binary decisions and symbols, and the adaptive models that predict them.
//!
//! Nearly everything is coded as a sequence of binary decisions. A [`Coder`] is either a writer or a
//! reader, so one generic function describes both directions: the writer passes the actual value, the
//! reader's argument is ignored, and both continue with the value that is returned. The models (adaptive
//! bits, a logistic mixer \[Mah05\], integers in doubling buckets) use integer arithmetic only and depend
//! on nothing but earlier values, so a stream decodes to the same bits on every machine.
//!
//! | file | what it does |
//! | --- | --- |
//! | `coder.rs` | [`Coder`]: what writer and reader have in common |
//! | `range.rs` | the range coder: [`RangeWriter`], [`RangeReader`] |
//! | `adaptive.rs` | [`AdaptiveBit`]: the probability of one decision, learned quickly at first |
//! | `logistic.rs` | conversion between probabilities and log-odds, by integer tables |
//! | `mixer.rs` | `Mixer`: online mixing of predictions |
//! | `symbol.rs` | [`AdaptiveSymbol`]: one of sixteen symbols |
//! | `number.rs` | [`AdaptiveNumber`]: integers of any size |
//! | `quick_number.rs` | [`QuickNumber`]: integers of any size, with few operations |
//! | `mixed_number.rs` | `MixedNumber`: integers predicted by several contexts |

mod adaptive;
mod coder;
mod logistic;
mod mixed_number;
mod mixer;
mod number;
mod quick_number;
mod range;
mod symbol;

pub use adaptive::{AdaptiveBit, Rate};
pub use coder::{Coder, PART_COUNT, Part, SYMBOLS, Shares};
pub(crate) use logistic::{log2_q8, log2_q16};
pub(crate) use mixed_number::MixedNumber;
pub use number::{AdaptiveNumber, code_uniform};
pub use quick_number::QuickNumber;
pub use range::{RangeReader, RangeWriter};
pub use symbol::AdaptiveSymbol;
pub(crate) use symbol::{code_by_two, code_shares};
