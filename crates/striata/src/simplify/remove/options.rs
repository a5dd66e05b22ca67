//! What a caller may ask of the removal of vertices, and what it gives.

use crate::mesh::{FragmentedMesh, RefinableMesh};
use crate::setters::setters;
use crate::simplify::options::{BoundaryRule, SeamRule, SimplifyError, StopReason, TopologyRule};

/// Which triangulations of a hole are tried.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum Retriangulation {
    /// All of them, where attributes and groups allow; half-edge collapses elsewhere.
    #[default]
    Free,
    /// Those that a half-edge collapse leaves.
    Collapse,
}

/// Which triangulation of a hole is the best one. What is removed next is decided by distances in any case.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum HoleCriterion {
    /// Nearest to the original surface.
    #[default]
    Distance,
    /// Turned least against the triangles before.
    Flatness,
    /// Of the roundest triangles.
    Shape,
}

/// Largest degree that [`RemovalOptions::degree_limit`] may allow.
pub(super) const MAX_DEGREE: usize = 16;

/// Options of [`build_fragments`](crate::simplify::build_fragments).
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct RemovalOptions {
    /// How holes may be filled; default freely.
    pub retriangulation: Retriangulation,
    /// Which filling is the best; default by distance. Half-edge collapses always go by distance.
    pub criterion: HoleCriterion,
    /// Most triangles around a vertex that may be removed, 3 to 16; default 8: more make many more patterns and next to no better
    /// levels. Only collapses that change the topology may exceed it, once nothing else is left.
    pub degree_limit: usize,
    /// Stop once no more triangles than this are left; default 0: as far as it goes.
    pub base_triangle_count: usize,
    /// Remove no vertex after which some point of the original could be farther than this from what takes its place, mesh units;
    /// others go on. Default none.
    pub max_error: Option<f64>,
    /// What may happen to boundaries; default kept.
    pub boundary: BoundaryRule,
    /// Edges whose triangles' normals differ by more than this, radians, stay edges: a vertex on two of them goes only along
    /// them, one on more stays. Default none: distances alone decide.
    pub feature_angle: Option<f64>,
    /// What may happen to borders between triangle groups; default kept. Locked, every vertex whose position is used by more
    /// than one group stays.
    pub group_borders: BoundaryRule,
    /// What collapses may do at seams, where they are the only way to fill a hole; default cross them.
    pub seams: SeamRule,
    /// Whether a vertex without any removal that keeps the topology may be collapsed all the same; default it may. No
    /// part vanishes if [`Self::max_error`] is set, and the topology stays if [`Self::feature_angle`] is.
    pub topology: TopologyRule,
    /// Vertices of the input that must stay.
    pub locked_vertices: Vec<u32>,
}

impl Default for RemovalOptions {
    fn default() -> Self {
        Self {
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
            locked_vertices: Vec::new(),
        }
    }
}

impl RemovalOptions {
    /// Checks that every option is in its range.
    ///
    /// # Errors
    /// [`SimplifyError::Option`] naming the first that is not.
    pub fn check(&self) -> Result<(), SimplifyError> {
        let wrong = |option, value: String, expected| Err(SimplifyError::Option { option, value, expected });
        if !(3..=MAX_DEGREE).contains(&self.degree_limit) {
            return wrong("degree_limit", self.degree_limit.to_string(), "3 to 16");
        }
        let numbers = [("max_error", self.max_error), ("feature_angle", self.feature_angle)];
        for (option, value) in numbers.into_iter().filter_map(|(option, value)| Some((option, value?))) {
            if !(value >= 0.0 && value.is_finite()) {
                return wrong(option, value.to_string(), "a number of at least 0");
            }
        }
        Ok(())
    }

    setters! {
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
        with_locked_vertices, locked_vertices: Vec<u32>;
    }
}

/// What [`build_fragments`](crate::simplify::build_fragments) gives.
#[derive(Clone, Debug)]
pub struct BuiltFragments {
    /// The mesh in refinement order, and its steps.
    pub fragmented: FragmentedMesh,
    /// The same as collapses, where every step is one: with [`Retriangulation::Collapse`].
    pub refinable: Option<RefinableMesh>,
    /// For each vertex, the vertex of the input that it was.
    pub source_vertex: Vec<u32>,
    /// Why the sequence ends where it does.
    pub stop_reason: StopReason,
    /// Triangles of the input dropped since two of their corners are at one position.
    pub degenerate_triangle_count: usize,
    /// Vertices of the input merged into equal ones.
    pub merged_vertex_count: usize,
}
