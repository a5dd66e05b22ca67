//! Sources of fragments.

use striata::mesh::{FragmentedMesh, IndexedMesh, RefinableMesh};
use striata::simplify::{RemovalOptions, Retriangulation, build_fragments_with_progress};

use striata_command::failure::Failure;
use striata_command::output::Bar;

/// A source of fragments.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Source {
    /// Half-edge collapses in quadric order.
    Quadric,
    /// Removed vertices, with holes filled freely.
    Removal,
    /// Removed vertices, with holes filled as by collapses.
    RemovalCollapse,
}

impl Source {
    /// All sources; extraction is timed for the one in the middle, which is the paper's.
    pub(super) const ALL: [Self; 3] = [Self::Quadric, Self::Removal, Self::RemovalCollapse];

    pub(super) const fn as_str(self) -> &'static str {
        match self {
            Self::Quadric => "quadric",
            Self::Removal => "removal",
            Self::RemovalCollapse => "removal-collapse",
        }
    }

    pub(super) const fn about(self) -> &'static str {
        match self {
            Self::Quadric => "half-edge collapses in quadric order",
            Self::Removal => {
                "vertices removed by summed squared distances, gaps and the largest distance, \
                 holes filled freely"
            }
            Self::RemovalCollapse => "same removal, holes filled as by half-edge collapses",
        }
    }

    /// Builds the fragments.
    ///
    /// # Errors
    /// If the mesh is inconsistent.
    pub(super) fn fragments(
        self,
        mesh: &IndexedMesh,
        refinable: &RefinableMesh,
        bar: &mut Bar,
    ) -> Result<FragmentedMesh, Failure> {
        let how = match self {
            Self::Quadric => return Ok(FragmentedMesh::from_collapses(refinable)),
            Self::Removal => Retriangulation::Free,
            Self::RemovalCollapse => Retriangulation::Collapse,
        };
        let options = RemovalOptions::default().with_retriangulation(how);
        Ok(build_fragments_with_progress(mesh, &options, &mut |progress| bar.show(progress))?.fragmented)
    }
}
