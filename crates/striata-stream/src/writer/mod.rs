//! Encoding: the full mesh is collapsed to the base, then coded in the order in which a reader refines it.
//!
//! | file | what it does |
//! | --- | --- |
//! | `encode.rs` | options, and the entry point that encodes a mesh |
//! | `descent.rs` | collapses the full mesh down to the base |
//! | `level.rs` | triangles of one level |
//! | `defect.rs` | reasons why a sequence cannot be encoded |
//! | `surface_stage.rs` | batches of collapses on a surface |
//! | `general_stage.rs` | batches of other steps |
//! | `fragments.rs` | encodes fragments |
//! | `general_order.rs` | coding order of general steps |
//! | `reference_mesh.rs` | the data to encode, in a reader's numbering |
//! | `chunks.rs` | the range-coded chunks |
//! | `order.rs` | reorders the mesh to match its stream |

pub(crate) mod chunks;
pub(crate) mod defect;
pub(crate) mod descent;
pub(crate) mod encode;
pub(crate) mod fragments;
pub(crate) mod general_order;
pub(crate) mod general_stage;
pub(crate) mod level;
pub(crate) mod order;
pub(crate) mod reference_mesh;
pub(crate) mod surface_stage;
