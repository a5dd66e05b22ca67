//! Simplification of a mesh into a sequence of steps: its order, limits and error guarantees.

use std::borrow::Cow;

use striata::ProgressFn;
use striata::mesh::{Appearance, FragmentedMesh, IndexedMesh, Material, Steps, Welded};
use striata::simplify::{
    BatchOptions, BoundaryRule, BuiltSequence, HoleCriterion, PlacedOptions, RemovalOptions, RemovalOrder,
    Retriangulation, SeamRule, SequenceOptions, SimplifyError, StopReason, TopologyRule,
    build_welded_batches_with_progress, build_welded_fragments_with_progress,
    build_welded_placed_fragments_with_progress, build_welded_sequence_with_progress,
    certify_collapses_in_any_state_with_progress, certify_collapses_with_progress, certify_with_progress,
    flat_folds,
};
use striata_io::texcoord_scale;
use striata_scene::drawn::base_colors_of_mesh;

use crate::args::{Length, OrderArg, RetriangulationArg, SequenceArgs};
use crate::failure::Failure;
use crate::output::{Output, format_noun_count};

/// How a mesh is simplified.
#[derive(Clone, Debug)]
pub enum SequencePlan {
    /// Half-edge collapses in the order of their quadric cost.
    Quadric {
        /// Cost function and constraints.
        options: SequenceOptions,
        /// Whether errors are guaranteed, and for which states of the mesh.
        guarantee: ErrorGuarantee,
        /// Settings of batches, if collapses are grouped in batches as a stream needs them.
        batches: Option<BatchSettings>,
    },
    /// Vertex removals in the order of the distance that remains.
    Hausdorff(RemovalOptions),
    /// Collapses of edges or triangles to new vertices, in the order of their quadric cost.
    Placed(PlacedOptions),
}

/// How far a simplification goes.
#[derive(Clone, Copy, Debug, Default)]
pub struct Limits {
    /// Number of triangles at which simplification stops.
    pub base_triangle_count: usize,
    /// Largest distance from the original, mesh units.
    pub max_error: Option<f64>,
}

impl Default for SequencePlan {
    fn default() -> Self {
        Self::Quadric { options: SequenceOptions::default(), guarantee: ErrorGuarantee::None, batches: None }
    }
}

/// How steps are chosen, as far as this affects how coarse a mesh can get.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StepKind {
    /// One by one, keeping vertices of the input.
    Single,
    /// In batches, as a stream needs them.
    Batches,
}

/// A mesh with its simplification steps.
#[derive(Debug)]
pub struct SimplifiedSteps {
    /// The steps.
    pub steps: Steps,
    /// Why simplification stopped.
    pub stop_reason: StopReason,
    /// Whether no point of the original is farther from a level than its error.
    pub error_is_guaranteed: bool,
    /// Split counts at which batches begin, followed by the number of steps; `None` without batches.
    pub batches: Option<Vec<u32>>,
    /// The steps as fragments with an error for each floor, if they are known in addition to collapses.
    floors: Option<FragmentedMesh>,
}

impl SimplifiedSteps {
    /// Returns the steps as fragments; if errors are guaranteed, the errors of single floors are, too.
    ///
    /// # Errors
    /// If the callback cancels.
    pub fn fragments(&self, progress: &mut ProgressFn<'_>) -> Result<Cow<'_, FragmentedMesh>, SimplifyError> {
        Ok(match (&self.steps, &self.floors) {
            (Steps::Fragments(fragmented), _) | (_, Some(fragmented)) => Cow::Borrowed(fragmented),
            (Steps::Collapses(refinable), None) => {
                let fragmented = FragmentedMesh::from_collapses(refinable);
                Cow::Owned(if self.error_is_guaranteed {
                    certify_with_progress(&fragmented, progress)?
                } else {
                    fragmented
                })
            }
        })
    }
}

/// Settings for batches of collapses.
#[derive(Clone, Copy, Debug, Default)]
pub struct BatchSettings {
    /// Fraction of the vertices, cheapest first, that each batch may use; `None` for the default.
    pub share: Option<f64>,
    /// Weight of triangle shape in the cost, as a length in mesh units.
    pub shape_step: Option<f64>,
}

/// States of a mesh for which the errors of its collapses are guaranteed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ErrorGuarantee {
    /// Errors are estimates.
    None,
    /// Levels of uniform detail.
    Levels,
    /// View-dependent states too, at the price of larger errors.
    AnyState,
}

impl SequencePlan {
    /// Extends a guarantee for levels to every view-dependent state.
    pub fn guarantee_any_state(&mut self) {
        if let Self::Quadric { guarantee, .. } = self
            && *guarantee == ErrorGuarantee::Levels
        {
            *guarantee = ErrorGuarantee::AnyState;
        }
    }

    /// Groups collapses in batches.
    ///
    /// # Errors
    /// If the plan is not in quadric order.
    pub fn use_batches(&mut self, terms: BatchSettings) -> Result<(), Failure> {
        let Self::Quadric { batches, .. } = self else {
            return Err(Failure::usage(
                "a stream with other models requires collapses in quadric order, to existing vertices",
            )
            .with_hint("remove --order and --new-vertices, or make the stream alone with `striata encode`"));
        };
        *batches = Some(terms);
        Ok(())
    }

    /// Returns the order of the steps.
    pub fn order(&self) -> OrderArg {
        match self {
            Self::Quadric { .. } | Self::Placed(_) => OrderArg::Quadric,
            Self::Hausdorff(options) if options.order == RemovalOrder::Hausdorff => OrderArg::HausdorffStrict,
            Self::Hausdorff(_) => OrderArg::Hausdorff,
        }
    }

    /// Whether errors will be guaranteed: no point of the original is farther from a level than its error.
    pub fn guarantees_errors(&self) -> bool {
        !matches!(self, Self::Quadric { guarantee: ErrorGuarantee::None, .. })
    }

    /// Simplifies a mesh.
    ///
    /// # Errors
    /// If an option is out of range, or the callback cancels.
    pub fn run(
        &self,
        welded: Welded,
        progress: &mut ProgressFn<'_>,
    ) -> Result<SimplifiedSteps, SimplifyError> {
        match self {
            Self::Quadric { options, guarantee: ErrorGuarantee::None, batches } => {
                let (built, batches) = collapses(welded, options.clone(), *batches, progress)?;
                let (steps, stop_reason) = (Steps::Collapses(built.refinable), built.stop_reason);
                Ok(SimplifiedSteps { steps, stop_reason, error_is_guaranteed: false, batches, floors: None })
            }
            Self::Quadric { options, guarantee, batches } => {
                // Applied to estimates, the limit would stop simplification at a different step.
                let mut unlimited = options.clone();
                unlimited.max_error = None;
                let unlimited = collapses(welded, unlimited, *batches, progress)?;
                certified(unlimited, options.max_error, *guarantee, progress)
            }
            Self::Hausdorff(options) => {
                let built = build_welded_fragments_with_progress(welded, options, progress)?;
                let (steps, floors) = match built.refinable {
                    Some(refinable) => (Steps::Collapses(refinable), Some(built.fragmented)),
                    None => (Steps::Fragments(built.fragmented), None),
                };
                let stop_reason = built.stop_reason;
                Ok(SimplifiedSteps { steps, stop_reason, error_is_guaranteed: true, batches: None, floors })
            }
            Self::Placed(options) => {
                let built = build_welded_placed_fragments_with_progress(welded, options, progress)?;
                Ok(SimplifiedSteps {
                    steps: Steps::Fragments(built.fragmented),
                    stop_reason: built.stop_reason,
                    error_is_guaranteed: true,
                    batches: None,
                    floors: None,
                })
            }
        }
    }
}

/// Runs collapses in quadric order, one by one or in batches.
fn collapses(
    welded: Welded,
    options: SequenceOptions,
    batches: Option<BatchSettings>,
    progress: &mut ProgressFn<'_>,
) -> Result<CollapsesAndBatches, SimplifyError> {
    let Some(BatchSettings { share, shape_step }) = batches else {
        return Ok((build_welded_sequence_with_progress(welded, &options, progress)?, None));
    };
    let mut options = BatchOptions::default().with_sequence(options).with_shape_step(shape_step);
    options.share = share.unwrap_or(options.share);
    let made = build_welded_batches_with_progress(welded, &options, progress)?;
    Ok((made.built, Some(made.batches)))
}

/// A sequence of collapses, and where its batches begin, if it has batches.
type CollapsesAndBatches = (BuiltSequence, Option<Vec<u32>>);

/// Computes guaranteed errors of collapses, and drops the levels whose error exceeds the limit.
fn certified(
    (built, mut batches): CollapsesAndBatches,
    max_error: Option<f64>,
    guarantee: ErrorGuarantee,
    progress: &mut ProgressFn<'_>,
) -> Result<SimplifiedSteps, SimplifyError> {
    let refinable = match guarantee {
        ErrorGuarantee::AnyState => certify_collapses_in_any_state_with_progress(&built.refinable, progress)?,
        _ => certify_collapses_with_progress(&built.refinable, progress)?,
    };
    let first = max_error.map_or(0, |error| refinable.sequence.split_count_for_error(error));
    if let Some(batches) = &mut batches {
        // The rest of a batch that is cut by the limit is a batch, too.
        let later = batches.iter().filter(|&&begin| begin as usize > first).map(|begin| begin - first as u32);
        *batches = std::iter::once(0).chain(later).collect();
    }
    let stop_reason = if first > 0 { StopReason::ErrorLimit } else { built.stop_reason };
    let steps = Steps::Collapses(refinable.without_levels_below(first));
    Ok(SimplifiedSteps { steps, stop_reason, error_is_guaranteed: true, batches, floors: None })
}

impl SequenceArgs {
    /// Returns the plan for a mesh.
    ///
    /// # Errors
    /// If a flag belongs to the other order.
    pub fn plan_for(&self, mesh: &IndexedMesh, limits: Limits) -> Result<SequencePlan, Failure> {
        let mut plan = self.plan(mesh.diagonal(), limits)?;
        if let SequencePlan::Quadric { options, .. } = &mut plan {
            options.texcoord_scales = texcoord_scales(&mesh.appearance);
            if options.attribute_weights.texcoord > 0.0 {
                options.base_colors = base_colors_of_mesh(mesh);
            }
        }
        Ok(plan)
    }

    /// Returns the plan without the parts that depend on textures.
    ///
    /// # Errors
    /// If a flag belongs to the other order.
    pub(crate) fn plan(&self, diagonal: f64, limits: Limits) -> Result<SequencePlan, Failure> {
        let Limits { base_triangle_count, max_error } = limits;
        let rule = |is_locked| if is_locked { BoundaryRule::Locked } else { BoundaryRule::Kept };
        let (boundary, group_borders) = (rule(self.lock_boundary), rule(self.lock_groups));
        let seams = if self.keep_seams { SeamRule::Keep } else { SeamRule::Cross };
        let topology = if self.keep_parts { TopologyRule::KeepParts } else { TopologyRule::Change };
        let removal_order = self.order.of_removals();
        let misplaced = match removal_order {
            None => self.removal.first_given_flag(),
            Some(_) if self.new_vertices.is_some() => Some("--new-vertices"),
            Some(_) if self.cost.is_some() => Some("--cost"),
            Some(_) if self.pair_distance.is_some() => Some("--pair-distance"),
            Some(_) => self.weights.first_given_flag(),
        };
        if let Some(flag) = misplaced {
            let order = self.order.as_str();
            let other = if removal_order.is_none() { "hausdorff" } else { "quadric" };
            return Err(Failure::usage(format!("{flag} has no meaning in {order} order"))
                .with_hint(format!("use --order {other}, or remove {flag}")));
        }
        self.check_new_vertices()?;
        match removal_order {
            None => {
                let mut options = SequenceOptions::default()
                    .with_boundary(boundary)
                    .with_group_borders(group_borders)
                    .with_seams(seams)
                    .with_topology(topology)
                    .with_attribute_weights(self.weights.weights());
                options.height_field = self.keep_height_field.then_some(true);
                options.cost = self.cost.unwrap_or_default();
                options.base_triangle_count = base_triangle_count;
                options.max_error = max_error;
                options.pair_distance = self.pair_distance.map(|distance| distance.in_units(diagonal));
                if let Some(collapse) = self.new_vertices {
                    let placed = PlacedOptions::default().with_collapse(collapse.into());
                    return Ok(SequencePlan::Placed(placed.with_sequence(options)));
                }
                let is_certified = self.certify || max_error.is_some();
                let guarantee = if is_certified { ErrorGuarantee::Levels } else { ErrorGuarantee::None };
                Ok(SequencePlan::Quadric { options, guarantee, batches: None })
            }
            Some(order) => {
                let mut options = RemovalOptions::default()
                    .with_order(order)
                    .with_boundary(boundary)
                    .with_group_borders(group_borders)
                    .with_seams(seams)
                    .with_topology(topology);
                options.height_field = self.keep_height_field.then_some(true);
                options.base_triangle_count = base_triangle_count;
                options.max_error = max_error;
                let removal = &self.removal;
                options.retriangulation = removal.retriangulation.map_or(Retriangulation::Free, Into::into);
                let criterion = match order {
                    RemovalOrder::Hausdorff => HoleCriterion::Maximum,
                    _ => options.criterion,
                };
                options.criterion = removal.criterion.map_or(criterion, Into::into);
                options.degree_limit = removal.degree_limit.map_or(options.degree_limit, |n| n as usize);
                options.feature_angle = removal.feature_angle.map(f64::to_radians);
                Ok(SequencePlan::Hausdorff(options))
            }
        }
    }

    /// Checks that no flag is given that does not work with new vertices.
    ///
    /// # Errors
    /// If there is such a flag.
    fn check_new_vertices(&self) -> Result<(), Failure> {
        let flags = [("--cost", self.cost.is_some()), ("--pair-distance", self.pair_distance.is_some())];
        match flags.into_iter().find(|&(_, is_given)| is_given && self.new_vertices.is_some()) {
            None => Ok(()),
            Some((flag, _)) => Err(Failure::usage(format!("{flag} does not work with --new-vertices"))
                .with_hint(format!("remove --new-vertices or {flag}"))),
        }
    }

    /// Explains why a mesh cannot be simplified further, if only the constraints prevent it.
    pub fn describe_limit(&self, kind: StepKind) -> String {
        let step = match self.order {
            OrderArg::Quadric => "no more edges can be collapsed",
            OrderArg::Hausdorff | OrderArg::HausdorffStrict => "no more vertices can be removed",
        };
        let loss = match kind {
            StepKind::Single => "removing the last triangles",
            StepKind::Batches => "changing the topology",
        };
        let mut text = format!("{step} without {loss}");
        let flags = [
            ("--lock-boundary", self.lock_boundary),
            ("--lock-groups", self.lock_groups),
            ("--keep-seams", self.keep_seams),
            ("--keep-parts", self.keep_parts),
            ("--keep-height-field", self.keep_height_field),
            ("--feature-angle", self.removal.feature_angle.is_some()),
        ];
        let given: Vec<&str> = flags.into_iter().filter(|flag| flag.1).map(|flag| flag.0).collect();
        if let [all @ .., last] = &given[..] {
            let all =
                if all.is_empty() { (*last).to_owned() } else { format!("{} and {last}", all.join(", ")) };
            let verb = if given.len() == 1 { "protects" } else { "protect" };
            text.push_str(&format!(" or changing what {all} {verb}"));
        }
        if matches!(kind, StepKind::Batches) {
            text.push_str("; a stream only uses whole batches of collapses");
        }
        text
    }

    /// Warns if groups should be locked but the mesh has no borders between groups.
    pub fn warn_about_groups(&self, mesh: &IndexedMesh, output: &Output) {
        if self.lock_groups && mesh.groups.len() < 2 {
            output.say("warning: --lock-groups has no effect: the mesh has only one group");
        }
    }

    /// If errors are to be certified, warns of steps that turn a triangle over within a flat part of the surface:
    /// errors do not show them.
    pub fn warn_about_flat_folds(&self, steps: &Steps, output: &Output) {
        let count = if self.certify { flat_folds(&steps.fragments()) } else { 0 };
        if count > 0 {
            let steps = format_noun_count(count, "step turns", "steps turn");
            output.say(&format!("warning: {steps} a triangle over within a flat part of the surface"));
        }
    }

    /// Whether the user requested free retriangulation.
    pub fn wants_free_retriangulation(&self) -> bool {
        self.removal.retriangulation == Some(RetriangulationArg::Free)
    }
}

/// Converts an optional limit to mesh units.
pub fn limit_in_units(limit: Option<Length>, diagonal: f64) -> Option<f64> {
    limit.map(|error| error.in_units(diagonal))
}

/// Returns the scales of the texture coordinates of each material.
fn texcoord_scales(appearance: &Appearance) -> Vec<[f32; 2]> {
    let scale = |material: &Material| {
        serde_json::from_str(&material.gltf_json).map_or([1.0; 2], |json| texcoord_scale(&json))
    };
    appearance.materials.iter().map(scale).collect()
}
