//! The container of a stream: everything except its range-coded bits.
//!
//! | file | what it does |
//! | --- | --- |
//! | `header.rs` | the header of a stream |
//! | `effort.rs` | [`Effort`](effort::Effort) |
//! | `grid.rs` | the grid of positions |
//! | `byte_reader.rs` | reading and writing header fields |
//! | `info.rs` | properties of a stream, read from its header |
//! | `error.rs` | errors of decoding |
//! | `files.rs` | streams in `.striata` files |

pub(crate) mod byte_reader;
pub(crate) mod effort;
pub(crate) mod error;
pub(crate) mod files;
pub(crate) mod grid;
pub(crate) mod header;
pub(crate) mod info;
