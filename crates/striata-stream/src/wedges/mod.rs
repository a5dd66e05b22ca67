//! Wedges: which vertex each corner refers to if positions have several vertices.
//!
//! | file | what it does |
//! | --- | --- |
//! | `model.rs` | codes which vertices the corners around a new position refer to |
//! | `split.rs` | the result for one split |
//! | `hidden.rs` | vertices that no triangle refers to yet |

pub(crate) mod hidden;
pub(crate) mod model;
pub(crate) mod split;
