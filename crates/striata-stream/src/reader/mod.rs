//! Reading a stream.
//!
//! | file | what it does |
//! | --- | --- |
//! | `decode.rs` | decodes a stream that arrives in pieces |
//! | `prefix.rs` | the mesh that a prefix of a stream defines |

pub(crate) mod decode;
pub(crate) mod prefix;
