//! Attribute layers: normals, texture coordinates, colors and any other vertex data.
//!
//! | file | what it does |
//! | --- | --- |
//! | `form.rs` | conversion between a layer's numbers and integers |
//! | `options.rs` | number of bits of each kind of layer |
//! | `header.rs` | binary layout of a layer's description |
//! | `attributes.rs` | all layers of a stream, and the neighborhoods they are coded in |
//! | `model.rs` | the models of all layers |
//! | `history.rs` | which vertices were copies, and how well others were predicted |
//! | `layer_neighborhood.rs` | integers of a layer, and the neighborhood of a vertex |
//! | `ring_fit.rs`, `least_squares.rs` | affine fits and learned sums of predictions |
//! | `octahedral.rs`, `directions.rs`, `direction_model.rs`, `tangents.rs` | normals and tangents |
//! | `residuals.rs`, `number_model.rs` | numbers, and the residuals of predictions |

pub(crate) mod attributes;
pub(crate) mod direction_model;
pub(crate) mod directions;
pub(crate) mod form;
mod header;
pub(crate) mod history;
pub(crate) mod layer_neighborhood;
pub(crate) mod least_squares;
pub(crate) mod model;
pub(crate) mod number_model;
mod octahedral;
pub(crate) mod options;
pub(crate) mod residuals;
pub(crate) mod ring_fit;
pub(crate) mod tangents;
pub(crate) mod triangle_data;
