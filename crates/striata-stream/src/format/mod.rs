//! The container of a stream: everything except its range-coded bits.
//!
//! | file | what it does |
//! | --- | --- |
//! | `form.rs` | [`Effort`](form::Effort) and [`StreamVersion`](form::StreamVersion) |
//! | `head.rs` | the header of a stream |
//! | `grid.rs` | the grid of positions |
//! | `byte_reader.rs` | reading and writing header fields |
//! | `facts.rs` | properties of a stream, read from its header |
//! | `error.rs` | errors of decoding |
//! | `files.rs` | streams in `.striata` files |

pub(crate) mod byte_reader;
pub(crate) mod error;
pub(crate) mod facts;
pub(crate) mod files;
pub(crate) mod form;
pub(crate) mod grid;
pub(crate) mod head;
