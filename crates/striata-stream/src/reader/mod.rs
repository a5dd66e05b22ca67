//! Reading a stream.
//!
//! | file | what it does |
//! | --- | --- |
//! | `decode.rs` | decodes a stream that arrives in pieces |
//! | `fragments.rs` | the level that fragments refine |
//! | `prefix.rs` | the mesh that a prefix of a stream defines |

pub(crate) mod decode;
pub(crate) mod fragments;
pub(crate) mod prefix;
