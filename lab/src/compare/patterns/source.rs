//! Sources of fragments.

use striata::mesh::{FragmentedMesh, IndexedMesh, RefinableMesh};
use striata::simplify::{
    HoleCriterion, PlacedCollapse, PlacedOptions, RemovalOptions, RemovalOrder, Retriangulation,
    SequenceOptions, TopologyRule, build_fragments_with_progress, build_placed_fragments_with_progress,
};

use striata_command::failure::Failure;
use striata_command::output::Bar;

/// A source of fragments.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum FragmentSource {
    /// Half-edge collapses in quadric order.
    Quadric,
    /// Removed vertices, with holes filled freely.
    Removal,
    /// Removed vertices, with holes filled as by collapses.
    RemovalCollapse,
    /// Removed vertices in the order of the one-sided Hausdorff distance, as published.
    RemovalStrict,
    /// Edges collapsed to new vertices.
    Edges,
    /// Triangles collapsed to new vertices.
    Triangles,
}

impl FragmentSource {
    /// All sources; extraction is timed for [`Self::Removal`], the paper's kind of fragments.
    pub(super) const ALL: [Self; 6] = [
        Self::Quadric,
        Self::Removal,
        Self::RemovalCollapse,
        Self::RemovalStrict,
        Self::Edges,
        Self::Triangles,
    ];

    pub(super) const fn as_str(self) -> &'static str {
        match self {
            Self::Quadric => "quadric",
            Self::Removal => "removal",
            Self::RemovalCollapse => "removal-collapse",
            Self::RemovalStrict => "removal-strict",
            Self::Edges => "edges",
            Self::Triangles => "triangles",
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
            Self::RemovalStrict => "vertices removed by the one-sided Hausdorff distance alone",
            Self::Edges => "edges collapsed to new vertices, which count as vertices too",
            Self::Triangles => "triangles collapsed to new vertices, which count as vertices too",
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
        let placed = |collapse, bar: &mut Bar| {
            let sequence = SequenceOptions::default().with_topology(TopologyRule::Keep);
            let options = PlacedOptions::default().with_collapse(collapse).with_sequence(sequence);
            build_placed_fragments_with_progress(mesh, &options, &mut |progress| bar.show(progress))
        };
        // Published forms require steps that preserve the topology, so all forms get what all can represent.
        let free = RemovalOptions::default().with_topology(TopologyRule::Keep);
        let options = match self {
            Self::Quadric => return Ok(FragmentedMesh::from_collapses(refinable)),
            Self::Edges => return Ok(placed(PlacedCollapse::Edge, bar)?.fragmented),
            Self::Triangles => return Ok(placed(PlacedCollapse::Triangle, bar)?.fragmented),
            Self::Removal => free,
            Self::RemovalCollapse => free.with_retriangulation(Retriangulation::Collapse),
            Self::RemovalStrict => {
                free.with_order(RemovalOrder::Hausdorff).with_criterion(HoleCriterion::Maximum)
            }
        };
        Ok(build_fragments_with_progress(mesh, &options, &mut |progress| bar.show(progress))?.fragmented)
    }
}
