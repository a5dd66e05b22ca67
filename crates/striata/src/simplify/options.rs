//! What a caller may ask of the simplifier, and what it answers besides the mesh.

use crate::mesh::{FragmentError, IndexedMesh, MeshError, RefinableMesh, SequenceError};
use crate::setters::setters;

/// Which level is wanted.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Target {
    /// At most so many triangles.
    Triangles(usize),
    /// At most so many vertices.
    Vertices(usize),
    /// `split_count / step_count`: 0 the base, 1 the full mesh.
    Detail(f64),
    /// The coarsest level with at most this error, mesh units.
    Error(f64),
    /// Exactly so many vertex splits above the base.
    SplitCount(usize),
}

/// Why a simplification ended, or how near a level came to what was asked.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum StopReason {
    /// The target is met exactly, or undercut by less than one step.
    TargetReached,
    /// No further collapse is possible; the target lies below the base mesh.
    BaseReached,
    /// The next collapse would exceed the error limit.
    ErrorLimit,
    /// The target asks for more than the full mesh holds.
    FullMesh,
}

impl StopReason {
    /// The reason as the command's JSON spells it.
    pub fn as_str(self) -> &'static str {
        match self {
            Self::TargetReached => "target_reached",
            Self::BaseReached => "base_reached",
            Self::ErrorLimit => "error_limit",
            Self::FullMesh => "full_mesh",
        }
    }
}

/// What decides which vertex goes next.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum CollapseCost {
    /// Memoryless quadrics with volume and distance terms over the current mesh: fast, the best at mild levels.
    #[default]
    Memoryless,
    /// Accumulated quadrics \[GH97\], the classic.
    Accumulated,
    /// Distances of all removed vertices to the current mesh: slower, the best at coarse levels.
    Tracked,
}

/// What may happen to boundary edges, or to edges between triangle groups.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum BoundaryRule {
    /// Boundary vertices move along the boundary, with their distance from it in the cost.
    #[default]
    Kept,
    /// Boundary vertices stay at every level.
    Locked,
}

/// What collapses may do at seams: edges where the wedges of a position differ, and borders between materials.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum SeamRule {
    /// A wedge without a partner takes the most similar wedge of the target, at a price, so that seams stop nothing.
    #[default]
    Cross,
    /// Vertices on a seam move along the seam only; every wedge needs a partner on its own side.
    Keep,
}

/// What happens once no collapse is left that keeps the topology.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum TopologyRule {
    /// Handles close, thin parts fold flat and small parts vanish, in the order of cost, so that every target is reached.
    #[default]
    Change,
    /// The topology may change, but each connected part keeps at least one triangle.
    KeepParts,
    /// Collapses that would change the topology are refused.
    Keep,
}

/// How much attributes count against distance, per kind of layer.
///
/// A weight is the distance, as a share of the bounding box's diagonal, that weighs as much as a
/// difference of 1.0 in the attribute over the same area. 0 ignores the layer.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AttributeWeights {
    /// Normals (difference of unit vectors); default 0.007.
    pub normal: f32,
    /// Every UV set; default 0.02.
    pub texcoord: f32,
    /// Every color set; default 0.003.
    pub color: f32,
}

impl Default for AttributeWeights {
    fn default() -> Self {
        // Normals: less, and the faces of thin parts take the normals of their rims; more, and the shape pays for it.
        Self { normal: 0.007, texcoord: 0.02, color: 0.003 }
    }
}

impl AttributeWeights {
    /// Geometry alone decides.
    pub const NONE: Self = Self { normal: 0.0, texcoord: 0.0, color: 0.0 };
}

/// Options of [`build_sequence`](super::build_sequence).
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct SequenceOptions {
    /// What orders the collapses; default [`CollapseCost::Memoryless`].
    pub cost: CollapseCost,
    /// Stop once no more triangles than this are left; default 0: as far as it goes.
    pub base_triangle_count: usize,
    /// Stop before a step's error exceeds this, mesh units; default none.
    pub max_error: Option<f64>,
    /// How much attributes count; see [`AttributeWeights`].
    pub attribute_weights: AttributeWeights,
    /// For each material, a factor on the weight of texture coordinates, at least 0; default 1 for every material.
    ///
    /// Indices are those of [`TriangleGroup::material`](crate::mesh::TriangleGroup). Materials beyond the end of the list and
    /// groups without a material have factor 1. Small factors suit textures of low contrast, on which sliding is hardly visible.
    pub texcoord_factors: Vec<f32>,
    /// What may happen to boundaries; default kept.
    pub boundary: BoundaryRule,
    /// What may happen to borders between triangle groups; default kept. Locked, every vertex whose position is used by more
    /// than one group stays.
    pub group_borders: BoundaryRule,
    /// What collapses may do at seams; default cross them.
    pub seams: SeamRule,
    /// Whether collapses may change the topology once no others are left; default they may.
    pub topology: TopologyRule,
    /// Vertices of the input that must stay.
    pub locked_vertices: Vec<u32>,
    /// Vertices without a common edge may contract when nearer than this, mesh units; default never.
    pub pair_distance: Option<f64>,
}

impl SequenceOptions {
    /// Checks that every option is in its range.
    ///
    /// # Errors
    /// [`SimplifyError::Option`] naming the first that is not.
    pub fn check(&self) -> Result<(), SimplifyError> {
        let expected = "a number of at least 0";
        let limits = [("max_error", self.max_error), ("pair_distance", self.pair_distance)];
        let weights = &self.attribute_weights;
        let weights = [
            ("attribute_weights.normal", weights.normal),
            ("attribute_weights.texcoord", weights.texcoord),
            ("attribute_weights.color", weights.color),
        ];
        let numbers = limits
            .into_iter()
            .filter_map(|(option, value)| Some((option, value?)))
            .chain(weights.map(|(option, value)| (option, f64::from(value))))
            .chain(self.texcoord_factors.iter().map(|&factor| ("texcoord_factors", f64::from(factor))));
        for (option, value) in numbers {
            if !(value >= 0.0 && value.is_finite()) {
                return Err(SimplifyError::Option { option, value: value.to_string(), expected });
            }
        }
        Ok(())
    }
    /// Checks that the locked vertices are vertices of the mesh.
    pub(super) fn check_locked(&self, vertex_count: usize) -> Result<(), SimplifyError> {
        check_locked(&self.locked_vertices, vertex_count)
    }

    setters! {
        with_cost, cost: CollapseCost;
        with_base_triangle_count, base_triangle_count: usize;
        with_max_error, max_error: some f64;
        with_attribute_weights, attribute_weights: AttributeWeights;
        with_texcoord_factors, texcoord_factors: Vec<f32>;
        with_boundary, boundary: BoundaryRule;
        with_group_borders, group_borders: BoundaryRule;
        with_seams, seams: SeamRule;
        with_topology, topology: TopologyRule;
        with_locked_vertices, locked_vertices: Vec<u32>;
        with_pair_distance, pair_distance: some f64;
    }
}

/// Checks that locked vertices are vertices of the mesh.
pub(super) fn check_locked(locked_vertices: &[u32], vertex_count: usize) -> Result<(), SimplifyError> {
    match locked_vertices.iter().find(|&&v| v as usize >= vertex_count) {
        None => Ok(()),
        Some(vertex) => Err(SimplifyError::Option {
            option: "locked_vertices",
            value: format!("vertex {vertex} of {vertex_count}"),
            expected: "a vertex of the mesh",
        }),
    }
}

/// Where the vertices of a simplified mesh lie.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum Placement {
    /// A subset of the input's vertices, attributes untouched.
    #[default]
    Subset,
    /// Anywhere; attributes are interpolated. Nearer to the surface, but one level only. The cost is always memoryless and counts
    /// attributes at seams only; [`Target::Detail`] and [`Target::SplitCount`] count all vertices that are not locked as
    /// removable. Collapses that cross a seam or change the topology follow the same rules as in a sequence. The error is
    /// the largest distance between sampled points of one mesh and the other, both ways.
    Optimal,
}

/// Options of [`simplify`](super::simplify): one level, without keeping the sequence.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct SimplifyOptions {
    /// The level that is wanted; default half the detail.
    pub target: Target,
    /// Never exceed this error, mesh units, whatever the target; default none.
    pub tolerance: Option<f64>,
    /// Where vertices may lie; default a subset of the input's.
    pub placement: Placement,
    /// How collapses are ordered and what they must respect.
    pub sequence: SequenceOptions,
}

impl Default for SimplifyOptions {
    fn default() -> Self {
        Self {
            target: Target::Detail(0.5),
            tolerance: None,
            placement: Placement::default(),
            sequence: SequenceOptions::default(),
        }
    }
}

impl SimplifyOptions {
    /// Checks that every option is in its range.
    ///
    /// # Errors
    /// [`SimplifyError::Option`] naming the first that is not.
    pub fn check(&self) -> Result<(), SimplifyError> {
        self.sequence.check()?;
        let number = match self.target {
            Target::Detail(value) => Some(("target", value, "a share from 0 to 1")),
            Target::Error(value) => Some(("target", value, "a number of at least 0")),
            _ => None,
        };
        let tolerance = self.tolerance.map(|value| ("tolerance", value, "a number of at least 0"));
        for (option, value, expected) in number.into_iter().chain(tolerance) {
            let is_share = matches!(self.target, Target::Detail(_)) && option == "target";
            if !(value >= 0.0 && value.is_finite()) || (is_share && value > 1.0) {
                return Err(SimplifyError::Option { option, value: value.to_string(), expected });
            }
        }
        Ok(())
    }

    setters! {
        with_target, target: Target;
        with_tolerance, tolerance: some f64;
        with_placement, placement: Placement;
        with_sequence, sequence: SequenceOptions;
    }
}

/// What [`build_sequence`](super::build_sequence) gives.
#[derive(Clone, Debug)]
pub struct BuiltSequence {
    /// The mesh in refinement order, and its steps.
    pub refinable: RefinableMesh,
    /// For each vertex, the vertex of the input that it was.
    pub source_vertex: Vec<u32>,
    /// Why the sequence ends where it does.
    pub stop_reason: StopReason,
    /// Triangles of the input dropped since two of their corners are at one position.
    pub degenerate_triangle_count: usize,
    /// Vertices of the input merged into equal ones.
    pub merged_vertex_count: usize,
}

/// What [`simplify`](super::simplify) gives.
#[derive(Clone, Debug)]
pub struct Simplified {
    /// The level.
    pub mesh: IndexedMesh,
    /// Its error, mesh units.
    pub error: f64,
    /// How near it came to the target.
    pub stop_reason: StopReason,
}

/// Why a simplification gave nothing.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum SimplifyError {
    /// The input does not hang together.
    #[error(transparent)]
    Mesh(#[from] MeshError),
    /// An option is out of its range.
    #[error("option {option} is {value}, but must be {expected}")]
    Option {
        /// Which option.
        option: &'static str,
        /// What it is.
        value: String,
        /// What it may be.
        expected: &'static str,
    },
    /// The caller's callback asked to stop.
    #[error(transparent)]
    Cancelled(#[from] crate::Cancelled),
    /// The simplifier broke its own invariant.
    #[error("internal error: the sequence is inconsistent: {0}")]
    Sequence(#[from] SequenceError),
    /// The simplifier broke its own invariant.
    #[error("internal error: the fragments are inconsistent: {0}")]
    Fragments(#[from] FragmentError),
}
