//! Reading a stream.
//!
//! | file | what it does |
//! | --- | --- |
//! | `decode.rs` | decodes a stream that arrives in pieces |
//! | `fragments.rs` | the level that fragments refine |
//! | `levels.rs` | a whole stream, or its beginning, as a source of levels |
//! | `prefix.rs` | the mesh that a prefix of a stream defines |

pub(crate) mod decode;
pub(crate) mod fragments;
pub(crate) mod levels;
pub(crate) mod prefix;
