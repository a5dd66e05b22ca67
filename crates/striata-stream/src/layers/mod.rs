//! Attributes: normals, texture coordinates, colors and everything else that vertices have.
//!
//! | file | what it does |
//! | --- | --- |
//! | `form.rs` | how the numbers of a layer become integers, and back |
//! | `options.rs` | how many bits they get |
//! | `header.rs` | what a stream says of a layer before its numbers |
//! | `attributes.rs` | all layers of a stream |
//! | `model.rs` | one layer: which predictions there are, and which fit |
//! | `history.rs` | how well predictions have fit so far |
//! | `hood.rs` | what is known around a vertex |
//! | `ring_fit.rs`, `least_squares.rs` | planes through what is around a vertex |
//! | `directions.rs`, `direction_model.rs`, `tangents.rs` | normals and tangents |
//! | `residuals.rs`, `number_model.rs` | what predictions leave |

pub(crate) mod attributes;
pub(crate) mod direction_model;
pub(crate) mod directions;
pub(crate) mod form;
mod header;
pub(crate) mod history;
pub(crate) mod hood;
pub(crate) mod least_squares;
pub(crate) mod model;
pub(crate) mod number_model;
pub(crate) mod options;
pub(crate) mod residuals;
pub(crate) mod ring_fit;
pub(crate) mod tangents;
