//! The mesh that the splits begin with.
//!
//! | file | what it does |
//! | --- | --- |
//! | `mesh.rs` | the base, and the surface that it is |
//! | `coder.rs` | its triangles, one across an edge of another |
//! | `shown.rs` | what its corners show |
//! | `hoods.rs` | what lies around its positions, for attributes |

pub(crate) mod coder;
pub(crate) mod hoods;
pub(crate) mod mesh;
mod shown;
