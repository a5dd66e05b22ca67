//! What a stream is made of, beside its range-coded bits.
//!
//! | file | what it does |
//! | --- | --- |
//! | `form.rs` | versions and efforts |
//! | `head.rs` | the head of a stream |
//! | `grid.rs` | the grid of positions |
//! | `byte_reader.rs` | numbers in bytes |
//! | `facts.rs` | what a head says |
//! | `error.rs` | what is wrong with a stream |
//! | `files.rs` | streams in `.striata` files |

pub(crate) mod byte_reader;
pub(crate) mod error;
pub(crate) mod facts;
pub(crate) mod files;
pub(crate) mod form;
pub(crate) mod grid;
pub(crate) mod head;
