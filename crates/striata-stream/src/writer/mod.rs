//! Writing a stream: the way down from the full mesh, then the same way up as a reader goes.
//!
//! | file | what it does |
//! | --- | --- |
//! | `encode.rs` | options, and a stream from a mesh and its batches |
//! | `descent.rs` | the way down |
//! | `level.rs` | the triangles that are there on the way |
//! | `defect.rs` | why it may not be possible |
//! | `surface_stage.rs` | batches of splits of a surface |
//! | `general_stage.rs` | batches of other steps |
//! | `general_order.rs` | in which order those are coded |
//! | `truth.rs` | the way up in the numbers of a reader |
//! | `chunks.rs` | the range-coded chunks |
//! | `order.rs` | the mesh in the order of its stream |

pub(crate) mod chunks;
pub(crate) mod defect;
pub(crate) mod descent;
pub(crate) mod encode;
pub(crate) mod general_order;
pub(crate) mod general_stage;
pub(crate) mod level;
pub(crate) mod order;
pub(crate) mod surface_stage;
pub(crate) mod truth;
