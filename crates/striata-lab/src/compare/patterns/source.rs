//! Where fragments come from.

use striata::mesh::{FragmentedMesh, IndexedMesh, RefinableMesh};
use striata::simplify::{RemovalOptions, Retriangulation, build_fragments_with_progress};

use striata_command::failure::Failure;
use striata_command::output::Bar;

/// Where fragments come from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Source {
    /// Half-edge collapses in the order of quadrics.
    Quadric,
    /// Removed vertices, holes filled in any way.
    Removal,
    /// Removed vertices, holes filled as collapses do.
    RemovalCollapse,
}

impl Source {
    /// All; times are those of the paper's, in the middle.
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
            Self::Quadric => "half-edge collapses in the order of quadrics",
            Self::Removal => {
                "vertices removed by summed squared distances, gaps and the largest distance, holes filled in any way"
            }
            Self::RemovalCollapse => "the same, holes filled as half-edge collapses do",
        }
    }

    /// # Errors
    /// Where the mesh does not hang together.
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
