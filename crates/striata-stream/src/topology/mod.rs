//! Triangles and how they are joined.
//!
//! | file | what it does |
//! | --- | --- |
//! | `surface.rs` | a closed surface under refinement |
//! | `cutting.rs` | any triangles, cut into such a surface |
//! | `rings.rs` | the corners around many vertices at once |
//! | `hood.rs` | what lies around a new vertex |

pub(crate) mod cutting;
pub(crate) mod hood;
pub(crate) mod rings;
pub(crate) mod surface;
