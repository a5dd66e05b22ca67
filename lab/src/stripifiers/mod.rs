//! Published stripifiers, as baselines: each follows its paper to the letter.
//!
//! They mark the same [`StripLinks`] as the stripifiers of the library, so that only the algorithms are
//! compared. [`strips_of`] turns the marks into strips.

pub mod tomesh;
#[cfg(feature = "command")]
mod tunneling;
pub mod tunnels;

use striata::mesh::{DualGraph, IndexedMesh, MeshError};
use striata::strip::{StripLinks, StripSet, write_strips};

pub use tomesh::join_like_tomesh;
#[cfg(feature = "command")]
pub use tunneling::Tunneling;
pub use tunnels::{
    EndOrder, Identities, TunnelOptions, TunnelReport, Visits, join_along_one_tunnel, join_along_tunnels,
};

/// Covers a mesh by strips: calls `join` with links that are all dashed, and writes the strips that it leaves.
///
/// # Errors
/// If the mesh is inconsistent.
pub fn strips_of(
    mesh: &IndexedMesh,
    join: impl FnOnce(&[[u32; 3]], &mut StripLinks<'_>),
) -> Result<StripSet, MeshError> {
    mesh.check()?;
    let graph = DualGraph::of_vertices(mesh);
    let mut links = StripLinks::new(&graph);
    join(&mesh.triangles, &mut links);
    let mut strips = StripSet::new();
    let groups = mesh.groups_or_whole();
    write_strips(&mesh.triangles, &links, groups.iter().map(|group| group.range()), &mut strips);
    Ok(strips)
}
