//! Generated meshes: known shapes, shapes with attributes, and meshes that break algorithms.
//!
//! Examples, tests and benchmarks need meshes that require no files and whose counts, areas and topology
//! are known in advance. All shapes are deterministic, and noise is seeded. Parameters below the minimum of
//! a shape are raised to that minimum.

mod attributed;
mod difficult;
mod sin_cos;
mod solids;
mod surfaces;

pub use attributed::{hard_cube, two_material_sphere, uv_cylinder};
pub use difficult::{book, bow_tie, many_components, needle, random_soup};
pub use solids::{cube, icosphere, paper_sphere, tetrahedron, torus, uv_sphere};
pub use surfaces::{closed_fan, grid, height_field, klein_bottle, moebius_strip, terrain, triangle_fan};
