//! The loop that both sides run.
//!
//! | file | what it does |
//! | --- | --- |
//! | `refiner.rs` | the loop: which vertices split, the splits, what the new vertices are |
//! | `asking.rs` | its first half: which vertices split, and how |
//! | `values.rs` | its second half: what the new vertices are |
//! | `terms.rs` | what both sides agree on before |
//! | `parts.rs`, `models.rs` | what the loop keeps |
//! | `source.rs` | what a writer knows of what is to come |
//! | `walk.rs` | which vertex is asked next |
//! | `growth.rs` | the mesh so far |

mod asking;
pub(crate) mod growth;
pub(crate) mod models;
pub(crate) mod parts;
pub(crate) mod refiner;
pub(crate) mod source;
pub(crate) mod terms;
mod values;
pub(crate) mod walk;
