//! Generated meshes: known shapes, shapes with attributes, and everything that breaks algorithms.
//!
//! Examples, tests and benchmarks need meshes that no file has to be found for and whose counts, areas and
//! topology are known in advance. All shapes are deterministic, noise is seeded; counts below what a shape
//! needs are raised to it. [`nasty`] lists one small mesh per thing that can be wrong with a mesh.

mod attributed;
mod nasty;
mod solids;
mod surfaces;
mod turn;

pub use attributed::{hard_cube, two_material_sphere, uv_cylinder};
pub use nasty::{book, bow_tie, many_components, nasty, needle, random_soup};
pub use solids::{cube, icosphere, paper_sphere, tetrahedron, torus, uv_sphere};
pub use surfaces::{closed_fan, grid, height_field, klein_bottle, moebius_strip, terrain, triangle_fan};
