//! The loop that both sides run.
//!
//! | file | what it does |
//! | --- | --- |
//! | `refiner.rs` | the loop: which vertices split, the splits, what the new vertices are |
//! | `source.rs` | what a writer knows of what is to come |
//! | `walk.rs` | which vertex is asked next |
//! | `growth.rs` | the mesh so far |

pub(crate) mod growth;
pub(crate) mod refiner;
pub(crate) mod source;
pub(crate) mod walk;
