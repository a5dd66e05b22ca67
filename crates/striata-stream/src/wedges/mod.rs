//! Which vertices corners show: one position may have several.
//!
//! | file | what it does |
//! | --- | --- |
//! | `model.rs` | what the corners around a new position show |
//! | `split.rs` | the answer |
//! | `hidden.rs` | vertices that no triangle shows yet |

pub(crate) mod hidden;
pub(crate) mod model;
pub(crate) mod split;
