//! The refinement loop that writer and reader both run.
//!
//! | file | what it does |
//! | --- | --- |
//! | `refiner.rs` | the loop: selects vertices, splits them, codes the new vertices |
//! | `split_selection.rs` | its first half: which vertices split, and how |
//! | `vertex_values.rs` | its second half: positions, wedges and attributes of new vertices |
//! | `parameters.rs` | what both sides know before the first bit |
//! | `parts.rs`, `models.rs` | the state of the loop |
//! | `source.rs` | what a writer knows about the splits to come |
//! | `walk.rs` | the order in which vertices are visited |
//! | `growth.rs` | the mesh built so far |

pub(crate) mod growth;
pub(crate) mod models;
pub(crate) mod parameters;
pub(crate) mod parts;
pub(crate) mod refiner;
pub(crate) mod source;
mod split_selection;
mod vertex_values;
pub(crate) mod walk;
