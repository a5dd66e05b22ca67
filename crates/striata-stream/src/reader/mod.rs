//! Reading a stream.
//!
//! | file | what it does |
//! | --- | --- |
//! | `decode.rs` | a stream that comes in pieces |
//! | `prefix.rs` | the mesh that a prefix of it is |

pub(crate) mod decode;
pub(crate) mod prefix;
