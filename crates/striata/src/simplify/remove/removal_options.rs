//! Options and result of simplification by vertex removal.

use crate::mesh::{FragmentedMesh, RefinableMesh};
use crate::setters::setters;
use crate::simplify::options::{BoundaryRule, SeamRule, SimplifyError, StopReason, TopologyRule};

/// Triangulations of a hole that are tried.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum Retriangulation {
    /// All triangulations if attributes and groups allow it; otherwise half-edge collapses.
    #[default]
    Free,
    /// Only triangulations that a half-edge collapse leaves.
    Collapse,
}

/// Order in which vertices are removed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum RemovalOrder {
    /// Least increase of squared distances over the surface, of the gap between the old and the new surface,
    /// and of the largest distance. Surface that sticks out counts.
    #[default]
    Mixed,
    /// Smallest one-sided Hausdorff distance, as published \[KLS96\], \[KG98\]: the largest distance of a
    /// point of the original from the surface that replaces it. Maxima are smaller, mean distances larger,
    /// and surface that sticks out is not noticed.
    Hausdorff,
}

/// Criterion that selects the triangulation of a hole. The order of removals depends on distances whichever
/// criterion is used.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum HoleCriterion {
    /// Nearest to the original surface.
    #[default]
    Distance,
    /// Smallest largest distance from the original surface; among equal ones, nearest to it.
    Maximum,
    /// Least change of direction relative to the old triangles.
    Flatness,
    /// Roundest triangles.
    Shape,
}

/// Largest value allowed for [`RemovalOptions::degree_limit`].
pub(super) const MAX_DEGREE: usize = 16;

/// Options of [`build_fragments`](crate::simplify::build_fragments).
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct RemovalOptions {
    /// Order of the removals; default [`RemovalOrder::Mixed`].
    pub order: RemovalOrder,
    /// How holes may be filled; default [`Retriangulation::Free`].
    pub retriangulation: Retriangulation,
    /// Criterion for the best triangulation; default [`HoleCriterion::Distance`]. Half-edge collapses are
    /// always compared by distance.
    pub criterion: HoleCriterion,
    /// Maximum number of triangles around a removed vertex, 3 to 16; default 8: larger limits give many
    /// more patterns and hardly better levels. The two sides of a sheet that is modeled from both sides count
    /// once. Only collapses that change the topology may exceed it, once nothing else is left.
    pub degree_limit: usize,
    /// Stop once no more triangles than this are left; default 0, which simplifies as far as possible.
    pub base_triangle_count: usize,
    /// Reject any removal after which some point of the original could be farther than this from the
    /// surface that replaces it, in mesh units; other removals go on. Default none.
    pub max_error: Option<f64>,
    /// How boundaries are treated; default kept.
    pub boundary: BoundaryRule,
    /// Preserve edges at which the triangles' normals differ by more than this angle, in radians: a
    /// vertex with two such edges moves only along them, and a vertex with one or with more than two
    /// stays. Default none: only distances count.
    pub feature_angle: Option<f64>,
    /// How borders between triangle groups are treated; default kept. If they are locked, every vertex
    /// whose position is used by more than one group stays.
    pub group_borders: BoundaryRule,
    /// How collapses treat seams, at which they are the only way to fill a hole; default [`SeamRule::Cross`].
    pub seams: SeamRule,
    /// Whether a vertex may be collapsed if every removal of it would change the topology; by default it may.
    /// No part vanishes if [`Self::max_error`] is set, and the topology stays if [`Self::feature_angle`] is
    /// set.
    pub topology: TopologyRule,
    /// Whether no triangle may turn over in plan, seen along the z axis; default if the mesh has a
    /// [georeference](crate::mesh::Appearance::georeference), as rasters of heights do.
    pub height_field: Option<bool>,
    /// Vertices of the input that must stay.
    pub locked_vertices: Vec<u32>,
}

impl Default for RemovalOptions {
    fn default() -> Self {
        Self {
            order: RemovalOrder::default(),
            retriangulation: Retriangulation::default(),
            criterion: HoleCriterion::default(),
            degree_limit: 8,
            base_triangle_count: 0,
            max_error: None,
            boundary: BoundaryRule::default(),
            feature_angle: None,
            group_borders: BoundaryRule::default(),
            seams: SeamRule::default(),
            topology: TopologyRule::default(),
            height_field: None,
            locked_vertices: Vec::new(),
        }
    }
}

impl RemovalOptions {
    /// Checks that every option is within its range.
    ///
    /// # Errors
    /// [`SimplifyError::Option`] with the first option that is out of range.
    pub fn check(&self) -> Result<(), SimplifyError> {
        let wrong = |option, value: String, expected| Err(SimplifyError::Option { option, value, expected });
        if !(3..=MAX_DEGREE).contains(&self.degree_limit) {
            return wrong("degree_limit", self.degree_limit.to_string(), "from 3 to 16");
        }
        let numbers = [("max_error", self.max_error), ("feature_angle", self.feature_angle)];
        for (option, value) in numbers.into_iter().filter_map(|(option, value)| Some((option, value?))) {
            if !(value >= 0.0 && value.is_finite()) {
                return wrong(option, value.to_string(), "a finite number of at least 0");
            }
        }
        Ok(())
    }

    setters! {
        with_order, order: RemovalOrder;
        with_retriangulation, retriangulation: Retriangulation;
        with_criterion, criterion: HoleCriterion;
        with_degree_limit, degree_limit: usize;
        with_base_triangle_count, base_triangle_count: usize;
        with_max_error, max_error: some f64;
        with_boundary, boundary: BoundaryRule;
        with_feature_angle, feature_angle: some f64;
        with_group_borders, group_borders: BoundaryRule;
        with_seams, seams: SeamRule;
        with_topology, topology: TopologyRule;
        with_height_field, height_field: some bool;
        with_locked_vertices, locked_vertices: Vec<u32>;
    }
}

/// Result of [`build_fragments`](crate::simplify::build_fragments).
#[derive(Clone, Debug)]
pub struct BuiltFragments {
    /// The mesh in refinement order, with its steps.
    pub fragmented: FragmentedMesh,
    /// The sequence as half-edge collapses; only with [`Retriangulation::Collapse`].
    pub refinable: Option<RefinableMesh>,
    /// For each vertex, the vertex of the input that it came from.
    pub source_vertex: Vec<u32>,
    /// Why the sequence stops at its base mesh.
    pub stop_reason: StopReason,
    /// Number of input triangles that were dropped because two of their corners share a position.
    pub degenerate_triangle_count: usize,
    /// Number of input vertices that were merged into equal ones.
    pub merged_vertex_count: usize,
}
