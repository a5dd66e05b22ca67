//! Looks at the multiresolution models of a mesh one by one: what each draws at a level, in how many strips or fans,
//! and what it costs. A page draws them instead of its own way, which is a list.

mod inspected_mesh;
mod instance;
mod models;
mod surface;

pub use inspected_mesh::InspectedMesh;
pub use surface::InspectedLevel;
