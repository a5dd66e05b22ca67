//! The base mesh: the coarsest level, coded as a whole before any split.
//!
//! | file | what it does |
//! | --- | --- |
//! | `mesh.rs` | [`Base`](mesh::Base): the base mesh and its surface |
//! | `coder.rs` | coding of its triangles and positions |
//! | `wedges.rs` | coding of its wedges and groups |
//! | `neighborhoods.rs` | neighborhoods of its vertices, for predicting attributes |

pub(crate) mod coder;
pub(crate) mod mesh;
pub(crate) mod neighborhoods;
mod wedges;
