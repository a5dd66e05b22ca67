//! Connectivity of triangle meshes: closed surfaces and the neighborhood of a vertex.
//!
//! | file | what it does |
//! | --- | --- |
//! | `surface.rs` | a closed surface that splits refine |
//! | `cutting.rs` | cuts any triangles into such a surface |
//! | `rings.rs` | the corners around many vertices in parallel |
//! | `neighborhood.rs` | the neighborhood of a new vertex |

pub(crate) mod cutting;
pub(crate) mod neighborhood;
pub(crate) mod rings;
pub(crate) mod surface;
