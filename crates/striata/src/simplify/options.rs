//! Options of the simplifier, the results it returns, and its error type.

use crate::mesh::{AttributeLayer, FragmentError, IndexedMesh, MeshError, RefinableMesh, SequenceError};
use crate::setters::setters;

use super::base_color::BaseColor;
use super::collapse::costs::CostFunction;

/// The level of detail to simplify to.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Target {
    /// At most this many triangles; for a share, multiply the triangle count of the full mesh.
    Triangles(usize),
    /// At most this many vertices.
    Vertices(usize),
    /// Share of the vertex splits that are applied, `split_count / step_count`: 0 is the base mesh, 1
    /// the full mesh. This is not a share of the triangles.
    Detail(f64),
    /// The coarsest level whose error does not exceed this, in mesh units.
    Error(f64),
    /// Exactly this many vertex splits above the base mesh.
    SplitCount(usize),
}

/// Why a simplification stopped, or how well a level meets its target.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum StopReason {
    /// The target is met exactly, or undercut by less than one step.
    TargetReached,
    /// No further collapse is possible: the target lies below the base mesh.
    BaseReached,
    /// The next collapse would exceed the error limit.
    ErrorLimit,
    /// The target asks for more detail than the full mesh has.
    FullMesh,
    /// The input is cut off before the level.
    InputEnded,
}

impl StopReason {
    /// Returns the name of the reason in the command's JSON output.
    pub fn as_str(self) -> &'static str {
        match self {
            Self::TargetReached => "target_reached",
            Self::BaseReached => "base_reached",
            Self::ErrorLimit => "error_limit",
            Self::FullMesh => "full_mesh",
            Self::InputEnded => "input_ended",
        }
    }
}

/// How boundary edges, or edges between triangle groups, are treated.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum BoundaryRule {
    /// Boundary vertices move along the boundary, and the cost includes their distance from it.
    #[default]
    Kept,
    /// Boundary vertices stay at every level.
    Locked,
}

/// How collapses treat seams: edges at which the wedges of a position differ, and borders between materials.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum SeamRule {
    /// A wedge without a partner goes to the most similar wedge of the target, at a cost, so that seams
    /// never block collapses.
    #[default]
    Cross,
    /// Vertices on a seam move only along the seam; every wedge needs a partner on its own side.
    Keep,
}

/// Behavior once no collapse is left that preserves the topology.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum TopologyRule {
    /// Handles close, thin parts fold flat and small parts vanish, in order of cost, so that every
    /// target is reached.
    #[default]
    Change,
    /// The topology may change, but each connected part keeps at least one triangle.
    KeepParts,
    /// Collapses that would change the topology are rejected.
    Keep,
}

/// Weights of attribute differences relative to distance, one for each kind of layer.
///
/// A weight is a distance, as a share of the bounding box's diagonal. Over equal areas, a difference of
/// 1.0 in the attribute costs as much as this distance. A weight of 0 ignores the layer.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AttributeWeights {
    /// Weight of normals (difference of unit vectors); default 0.007. On smooth parts of the surface, a
    /// difference counts the more the larger the triangles are that show it.
    pub normal: f32,
    /// Weight of every UV set; default 0.02. A difference of 1 between [base
    /// colors](SequenceOptions::base_colors) counts four times as much.
    pub texcoord: f32,
    /// Weight of every color set; default 0.003.
    pub color: f32,
    /// Weight of the displacements of all morph targets together, relative to a distance of the same
    /// length; default 1.
    pub displacement: f32,
}

impl Default for AttributeWeights {
    fn default() -> Self {
        // With a lower weight for normals, the faces of thin parts take the normals of their rims; with
        // a higher one, the shape suffers.
        Self { normal: 0.007, texcoord: 0.02, color: 0.003, displacement: 1.0 }
    }
}

impl AttributeWeights {
    /// All weights 0: only geometry counts.
    pub const NONE: Self = Self { normal: 0.0, texcoord: 0.0, color: 0.0, displacement: 0.0 };
}

/// Options of [`build_sequence`](super::build_sequence).
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct SequenceOptions {
    /// Cost function that orders the collapses; default [`CostFunction::Memoryless`].
    pub cost: CostFunction,
    /// Stop once no more triangles than this are left; default 0, which simplifies as far as possible.
    pub base_triangle_count: usize,
    /// Stop before a step's error exceeds this, in mesh units; default none.
    pub max_error: Option<f64>,
    /// Weights of the attributes; see [`AttributeWeights`].
    pub attribute_weights: AttributeWeights,
    /// Parts of the texture per unit of the texture coordinates, along each axis, for each material; default 1.
    ///
    /// The list is indexed by [`TriangleGroup::material`](crate::mesh::TriangleGroup); materials beyond its end
    /// have the default. It is the scale of the texture transform of a glTF material
    /// (`KHR_texture_transform`): coordinates from 0 to 4095 with a scale of 1/4095 count as much as those
    /// from 0 to 1.
    pub texcoord_scales: Vec<[f32; 2]>,
    /// Base color of each material; default unknown.
    ///
    /// The list is indexed like [`texcoord_scales`](Self::texcoord_scales). If the color is known, what a
    /// collapse changes in it counts, and differences of the texture coordinates themselves count less.
    pub base_colors: Vec<Option<BaseColor>>,
    /// How boundaries are treated; default kept.
    pub boundary: BoundaryRule,
    /// How borders between triangle groups are treated; default kept. If they are locked, every vertex
    /// whose position is used by more than one group stays.
    pub group_borders: BoundaryRule,
    /// How collapses treat seams; default [`SeamRule::Cross`].
    pub seams: SeamRule,
    /// Whether collapses may change the topology once no others are left; default [`TopologyRule::Change`].
    pub topology: TopologyRule,
    /// Whether no triangle may turn over in plan, seen along the z axis; default if the mesh has a
    /// [georeference](crate::mesh::Appearance::georeference), as rasters of heights do.
    pub height_field: Option<bool>,
    /// Vertices of the input that must stay.
    pub locked_vertices: Vec<u32>,
    /// Also contract pairs of vertices that share no edge but are closer than this, in mesh units;
    /// default never.
    pub pair_distance: Option<f64>,
}

impl SequenceOptions {
    /// Checks that every option is within its range.
    ///
    /// # Errors
    /// [`SimplifyError::Option`] with the first option that is out of range.
    pub fn check(&self) -> Result<(), SimplifyError> {
        let expected = "a finite number of at least 0";
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
            .chain(self.texcoord_scales.iter().flatten().map(|&scale| ("texcoord_scales", f64::from(scale))));
        for (option, value) in numbers {
            if !(value >= 0.0 && value.is_finite()) {
                return Err(SimplifyError::Option { option, value: value.to_string(), expected });
            }
        }
        Ok(())
    }
    /// Checks that all locked vertices are vertices of the mesh.
    pub(crate) fn check_locked(&self, vertex_count: usize) -> Result<(), SimplifyError> {
        check_locked(&self.locked_vertices, vertex_count)
    }

    setters! {
        with_cost, cost: CostFunction;
        with_base_triangle_count, base_triangle_count: usize;
        with_max_error, max_error: some f64;
        with_attribute_weights, attribute_weights: AttributeWeights;
        with_texcoord_scales, texcoord_scales: Vec<[f32; 2]>;
        with_base_colors, base_colors: Vec<Option<BaseColor>>;
        with_boundary, boundary: BoundaryRule;
        with_group_borders, group_borders: BoundaryRule;
        with_seams, seams: SeamRule;
        with_topology, topology: TopologyRule;
        with_height_field, height_field: some bool;
        with_locked_vertices, locked_vertices: Vec<u32>;
        with_pair_distance, pair_distance: some f64;
    }
}

/// Checks that all locked vertices are vertices of a mesh with `vertex_count` vertices.
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

/// Positions that the vertices of a simplified mesh may have.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum Placement {
    /// The vertices are a subset of the input's, with their attributes unchanged.
    #[default]
    Subset,
    /// The level is [fitted](super::fit_level) to the original: positions and attributes other than joints,
    /// weights, morph targets and identifiers change. About half the error, but for one level only.
    Optimal,
}

impl Placement {
    /// Returns the placement that suits a single level of a mesh.
    ///
    /// It is [`Subset`](Self::Subset) if something refers to vertices of the input: double precision, an origin or
    /// a georeference, data of triangles, identifiers, skins and morph targets.
    pub fn for_one_level(mesh: &IndexedMesh) -> Self {
        let refers_to_vertices =
            |layer: &AttributeLayer| layer.semantic.is_of_poses() || layer.has_identifiers();
        let must_stay = !mesh.exact_positions.is_empty()
            || mesh.origin != [0.0; 3]
            || !mesh.appearance.georeference.is_empty()
            || !mesh.triangle_layers.is_empty()
            || mesh.layers.iter().any(refers_to_vertices);
        if must_stay { Self::Subset } else { Self::Optimal }
    }
}

/// Options of [`simplify`](super::simplify), which returns one level without the sequence.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct SimplifyOptions {
    /// Level to simplify to; default half the detail.
    pub target: Target,
    /// Upper limit of the error, in mesh units, whatever the target; default none.
    pub tolerance: Option<f64>,
    /// Positions that vertices may have; default [`Placement::Subset`].
    pub placement: Placement,
    /// How collapses are ordered, and what they must respect.
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
    /// Checks that every option is within its range.
    ///
    /// # Errors
    /// [`SimplifyError::Option`] with the first option that is out of range.
    pub fn check(&self) -> Result<(), SimplifyError> {
        self.sequence.check()?;
        let number = match self.target {
            Target::Detail(value) => Some(("target", value, "a share from 0 to 1")),
            Target::Error(value) => Some(("target", value, "a finite number of at least 0")),
            _ => None,
        };
        let tolerance = self.tolerance.map(|value| ("tolerance", value, "a finite number of at least 0"));
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

/// Result of [`build_sequence`](super::build_sequence).
#[derive(Clone, Debug)]
pub struct BuiltSequence {
    /// The mesh in refinement order, with its steps.
    pub refinable: RefinableMesh,
    /// For each vertex, the vertex of the input that it came from.
    pub source_vertex: Vec<u32>,
    /// Why the sequence stops at its base mesh.
    pub stop_reason: StopReason,
    /// Number of input triangles that were dropped because two of their corners share a position.
    pub degenerate_triangle_count: usize,
    /// Number of input vertices that were merged into equal ones.
    pub merged_vertex_count: usize,
}

/// Result of [`simplify`](super::simplify).
#[derive(Clone, Debug)]
pub struct Simplified {
    /// The simplified mesh.
    pub mesh: IndexedMesh,
    /// Error of the level, in mesh units.
    pub error: f64,
    /// Why the simplification stopped, or how well the level meets the target.
    pub stop_reason: StopReason,
}

/// Why a simplification failed.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum SimplifyError {
    /// The input mesh is invalid.
    #[error(transparent)]
    Mesh(#[from] MeshError),
    /// An option is out of range.
    #[error("option {option} is {value}, but must be {expected}")]
    Option {
        /// Name of the option.
        option: &'static str,
        /// Value that was passed.
        value: String,
        /// Description of the valid values.
        expected: &'static str,
    },
    /// The progress callback cancelled the operation.
    #[error(transparent)]
    Cancelled(#[from] crate::Cancelled),
    /// The simplifier broke its own invariant: the sequence is inconsistent.
    #[error("internal error: the simplifier built an inconsistent sequence: {0}")]
    Sequence(#[from] SequenceError),
    /// The simplifier broke its own invariant: the fragments are inconsistent.
    #[error("internal error: the simplifier built inconsistent fragments: {0}")]
    Fragments(#[from] FragmentError),
}
