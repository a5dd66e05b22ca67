//! One entry for all stripifiers.

use super::{StripSet, greedy};
use crate::mesh::{DualGraph, IndexedMesh, MeshError};

/// Which algorithm makes the strips.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum Stripifier {
    /// Best of three walks from triangles with few free neighbours: fast, few indices.
    #[default]
    Greedy,
}

/// Options of [`stripify`].
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct StripOptions {
    /// The algorithm; default [`Stripifier::Greedy`].
    pub stripifier: Stripifier,
}

impl StripOptions {
    /// Sets [`StripOptions::stripifier`].
    pub fn with_stripifier(mut self, stripifier: Stripifier) -> Self {
        self.stripifier = stripifier;
        self
    }
}

/// Covers each triangle of a mesh by exactly one strip; degenerate triangles (two equal corners) are left out.
///
/// The groups of the set are those of the mesh (one where it has none).
///
/// # Errors
/// [`MeshError`] where the mesh's parts do not fit together.
pub fn stripify(mesh: &IndexedMesh, options: &StripOptions) -> Result<StripSet, MeshError> {
    mesh.check()?;
    let mut out = StripSet::new();
    let graph = DualGraph::of_vertices(mesh);
    let groups = mesh.groups_or_whole();
    let ranges = groups.iter().map(|group| group.range());
    match options.stripifier {
        Stripifier::Greedy => greedy::stripify(&mesh.triangles, &graph, ranges, &mut out),
    }
    Ok(out)
}
