//! How a mesh becomes a sequence of steps: what goes first, which errors hold, and how far it goes.

use std::borrow::Cow;

use striata::ProgressFn;
use striata::mesh::{FragmentedMesh, IndexedMesh, Levels, RefinableMesh, Welded, replay, replay_fragments};
use striata::simplify::{
    BatchOptions, BoundaryRule, BuiltSequence, CollapseCost, RemovalOptions, Retriangulation, SeamRule,
    SequenceOptions, SimplifyError, StopReason, TopologyRule, build_welded_batches_with_progress,
    build_welded_fragments_with_progress, build_welded_sequence_with_progress,
    certify_collapses_in_any_state_with_progress, certify_collapses_with_progress, certify_with_progress,
};

use crate::args::{CostArg, Length, OrderArg, RetriangulationArg, SequenceArgs};
use crate::failure::Failure;
use crate::output::Output;
use crate::texture_contrast::texture_contrasts;

/// How a mesh is simplified.
#[derive(Clone, Debug)]
pub enum SequencePlan {
    /// By half-edge collapses in the order of quadrics.
    Quadric {
        /// How they are ordered and what they must respect.
        options: SequenceOptions,
        /// Which states errors are to hold for.
        promise: Promise,
        /// Where they come in batches, as a stream needs them.
        batches: Option<BatchTerms>,
    },
    /// By removing vertices in the order of the distance that is left.
    Hausdorff(RemovalOptions),
}

/// How far a simplification goes.
#[derive(Clone, Copy, Debug, Default)]
pub struct Limits {
    /// Not below so many triangles.
    pub base_triangle_count: usize,
    /// Never farther than this from the original.
    pub max_error: Option<f64>,
}

impl Default for SequencePlan {
    fn default() -> Self {
        Self::Quadric { options: SequenceOptions::default(), promise: Promise::Estimates, batches: None }
    }
}

/// How steps are chosen, as far as it decides where they end.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StepKind {
    /// One by one, among the vertices of the input.
    Single,
    /// In batches, as a stream needs them.
    Batches,
    /// With vertices placed freely.
    Optimal,
}

/// The steps of a mesh.
#[derive(Debug)]
pub enum Steps {
    /// Each is a half-edge collapse.
    Collapses(RefinableMesh),
    /// Any.
    Fragments(FragmentedMesh),
}

impl Steps {
    /// The mesh in refinement order.
    pub fn mesh(&self) -> &IndexedMesh {
        match self {
            Self::Collapses(refinable) => &refinable.mesh,
            Self::Fragments(fragmented) => &fragmented.mesh,
        }
    }

    /// What is known of each level.
    pub fn levels(&self) -> &Levels {
        match self {
            Self::Collapses(refinable) => refinable.sequence.levels(),
            Self::Fragments(fragmented) => fragmented.fragments.levels(),
        }
    }

    /// The mesh that a level shows.
    pub fn level(&self, split_count: usize) -> IndexedMesh {
        match self {
            Self::Collapses(refinable) => replay(refinable, split_count),
            Self::Fragments(fragmented) => replay_fragments(fragmented, split_count),
        }
    }
}

/// A mesh with its steps.
#[derive(Debug)]
pub struct SimplifiedSteps {
    /// The steps.
    pub steps: Steps,
    /// Why there are no more.
    pub stop_reason: StopReason,
    /// Whether no point of the original is farther from a level than its error.
    pub error_is_guaranteed: bool,
    /// Split counts at which batches begin, closed by the number of steps; where there are batches.
    pub batches: Option<Vec<u32>>,
    /// The same steps as fragments, where they are known beside collapses: with the errors of single floors.
    floors: Option<FragmentedMesh>,
}

impl SimplifiedSteps {
    /// The steps as fragments; where errors are guaranteed, so are those of single floors.
    ///
    /// # Errors
    /// Where the callback asks to stop.
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

/// What batches of collapses are made of.
#[derive(Clone, Copy, Debug, Default)]
pub struct BatchTerms {
    /// The share of vertices that a batch takes from; the usual one where none is named.
    pub share: Option<f64>,
    /// What the shape of what is left should weigh, mesh units.
    pub shape_step: Option<f64>,
}

/// What errors of collapses hold for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Promise {
    /// Nothing: they are estimates.
    Estimates,
    /// Levels that are the same everywhere.
    Levels,
    /// Whatever a view shows too, at the price of larger errors.
    AnyState,
}

impl SequencePlan {
    /// Makes errors that are to hold for levels hold for whatever a view shows.
    pub fn hold_in_any_state(&mut self) {
        if let Self::Quadric { promise, .. } = self
            && *promise == Promise::Levels
        {
            *promise = Promise::AnyState;
        }
    }

    /// Lets collapses come in batches.
    ///
    /// # Errors
    /// Where there are no such collapses.
    pub fn come_in_batches(&mut self, terms: BatchTerms) -> Result<(), Failure> {
        let Self::Quadric { batches, .. } = self else {
            return Err(Failure::user("a stream is made of collapses in quadric order")
                .with_hint("leave --order hausdorff out, or the stream"));
        };
        *batches = Some(terms);
        Ok(())
    }

    /// What goes first.
    pub fn order(&self) -> OrderArg {
        match self {
            Self::Quadric { .. } => OrderArg::Quadric,
            Self::Hausdorff(_) => OrderArg::Hausdorff,
        }
    }

    /// Whether no point of the original will be farther from a level than its error.
    pub fn guarantees_errors(&self) -> bool {
        !matches!(self, Self::Quadric { promise: Promise::Estimates, .. })
    }

    /// Builds the steps of a mesh.
    ///
    /// # Errors
    /// Where an option is out of range.
    pub fn run(
        &self,
        welded: Welded,
        progress: &mut ProgressFn<'_>,
    ) -> Result<SimplifiedSteps, SimplifyError> {
        match self {
            Self::Quadric { options, promise: Promise::Estimates, batches } => {
                let (built, batches) = collapses(welded, options.clone(), *batches, progress)?;
                let (steps, stop_reason) = (Steps::Collapses(built.refinable), built.stop_reason);
                Ok(SimplifiedSteps { steps, stop_reason, error_is_guaranteed: false, batches, floors: None })
            }
            Self::Quadric { options, promise, batches } => {
                // Estimates would stop it elsewhere.
                let mut unlimited = options.clone();
                unlimited.max_error = None;
                let made = collapses(welded, unlimited, *batches, progress)?;
                certified(made, options.max_error, *promise, progress)
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
        }
    }
}

/// Collapses in the order of quadrics, one by one or in batches.
fn collapses(
    welded: Welded,
    options: SequenceOptions,
    batches: Option<BatchTerms>,
    progress: &mut ProgressFn<'_>,
) -> Result<Made, SimplifyError> {
    let Some(BatchTerms { share, shape_step }) = batches else {
        return Ok((build_welded_sequence_with_progress(welded, &options, progress)?, None));
    };
    let mut options = BatchOptions::default().with_sequence(options).with_shape_step(shape_step);
    options.share = share.unwrap_or(options.share);
    let made = build_welded_batches_with_progress(welded, &options, progress)?;
    Ok((made.built, Some(made.batches)))
}

/// A sequence, and its batches where it has any.
type Made = (BuiltSequence, Option<Vec<u32>>);

/// Collapses whose errors hold, as far as they stay within the limit.
fn certified(
    (built, mut batches): Made,
    max_error: Option<f64>,
    promise: Promise,
    progress: &mut ProgressFn<'_>,
) -> Result<SimplifiedSteps, SimplifyError> {
    let refinable = match promise {
        Promise::AnyState => certify_collapses_in_any_state_with_progress(&built.refinable, progress)?,
        _ => certify_collapses_with_progress(&built.refinable, progress)?,
    };
    let first = max_error.map_or(0, |error| refinable.sequence.split_count_for_error(error));
    if let Some(batches) = &mut batches {
        // What is left of the first batch is one, too.
        let later = batches.iter().filter(|&&begin| begin as usize > first).map(|begin| begin - first as u32);
        *batches = std::iter::once(0).chain(later).collect();
    }
    let stop_reason = if first > 0 { StopReason::ErrorLimit } else { built.stop_reason };
    let steps = Steps::Collapses(refinable.without_levels_below(first));
    Ok(SimplifiedSteps { steps, stop_reason, error_is_guaranteed: true, batches, floors: None })
}

impl SequenceArgs {
    /// What was asked for, in mesh units.
    ///
    /// # Errors
    /// Where a flag belongs to the other order.
    pub fn plan_for(
        &self,
        mesh: &IndexedMesh,
        limits: Limits,
        output: &Output,
    ) -> Result<SequencePlan, Failure> {
        let mut plan = self.plan(mesh.diagonal(), limits)?;
        if let SequencePlan::Quadric { options, .. } = &mut plan
            && self.weights.uv_contrast
        {
            let contrasts = texture_contrasts(mesh);
            if contrasts.iter().all(Option::is_none) {
                output.say(
                    "warning: --uv-contrast changes nothing: no material has a readable base color texture",
                );
            }
            options.texcoord_factors =
                contrasts.into_iter().map(|contrast| contrast.unwrap_or(1.0)).collect();
        }
        Ok(plan)
    }

    /// The plan without what depends on the mesh's textures.
    ///
    /// # Errors
    /// If a flag belongs to the other order.
    fn plan(&self, diagonal: f64, limits: Limits) -> Result<SequencePlan, Failure> {
        let Limits { base_triangle_count, max_error } = limits;
        let rule = |is_locked| if is_locked { BoundaryRule::Locked } else { BoundaryRule::Kept };
        let (boundary, group_borders) = (rule(self.lock_boundary), rule(self.lock_groups));
        let seams = if self.keep_seams { SeamRule::Keep } else { SeamRule::Cross };
        let topology = if self.keep_parts { TopologyRule::KeepParts } else { TopologyRule::Change };
        let foreign = match self.order {
            OrderArg::Quadric => self.removal.given(),
            OrderArg::Hausdorff if self.cost.is_some() => Some("--cost"),
            OrderArg::Hausdorff if self.pair_distance.is_some() => Some("--pair-distance"),
            OrderArg::Hausdorff => self.weights.given(),
        };
        if let Some(flag) = foreign {
            let order = self.order.as_str();
            let other = if self.order == OrderArg::Quadric { "hausdorff" } else { "quadric" };
            return Err(Failure::user(format!("{flag} means nothing in {order} order"))
                .with_hint(format!("say --order {other}, or leave {flag} out")));
        }
        match self.order {
            OrderArg::Quadric => {
                let mut options = SequenceOptions::default()
                    .with_boundary(boundary)
                    .with_group_borders(group_borders)
                    .with_seams(seams)
                    .with_topology(topology)
                    .with_attribute_weights(self.weights.weights());
                options.cost = self.cost.map_or_else(CollapseCost::default, CollapseCost::from);
                options.base_triangle_count = base_triangle_count;
                options.max_error = max_error;
                options.pair_distance = self.pair_distance.map(|distance| distance.in_units(diagonal));
                let is_certified = self.certify || max_error.is_some();
                let promise = if is_certified { Promise::Levels } else { Promise::Estimates };
                Ok(SequencePlan::Quadric { options, promise, batches: None })
            }
            OrderArg::Hausdorff => {
                let mut options = RemovalOptions::default()
                    .with_boundary(boundary)
                    .with_group_borders(group_borders)
                    .with_seams(seams)
                    .with_topology(topology);
                options.base_triangle_count = base_triangle_count;
                options.max_error = max_error;
                let removal = &self.removal;
                options.retriangulation = removal.retriangulation.map_or(Retriangulation::Free, Into::into);
                options.criterion = removal.criterion.map_or(options.criterion, Into::into);
                options.degree_limit = removal.degree_limit.map_or(options.degree_limit, |n| n as usize);
                options.feature_angle = removal.feature_angle.map(f64::to_radians);
                Ok(SequencePlan::Hausdorff(options))
            }
        }
    }

    /// Why a mesh cannot be simplified any further, once nothing but the rules forbids it.
    pub fn what_forbids_more(&self, kind: StepKind) -> String {
        let step = match self.order {
            OrderArg::Quadric => "no more edges can be collapsed",
            OrderArg::Hausdorff => "no more vertices can be removed",
        };
        let loss = match kind {
            StepKind::Single | StepKind::Optimal => "losing the last triangles",
            StepKind::Batches => "changing the topology",
        };
        let mut text = format!("{step} without {loss}");
        let flags = [
            ("--lock-boundary", self.lock_boundary),
            ("--lock-groups", self.lock_groups),
            ("--keep-seams", self.keep_seams),
            ("--keep-parts", self.keep_parts),
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
            text.push_str(", and a stream takes whole batches of collapses");
        }
        text
    }

    /// Says so if groups are to be locked and the mesh has no borders between any.
    pub fn remark_on(&self, mesh: &IndexedMesh, output: &Output) {
        if self.lock_groups && mesh.groups.len() < 2 {
            output.say("--lock-groups changes nothing: the mesh has only one group");
        }
    }

    /// Whether holes were asked to be filled in any way.
    pub fn is_free(&self) -> bool {
        self.removal.retriangulation == Some(RetriangulationArg::Free)
    }
}

/// A limit in mesh units.
pub fn limit_in_units(limit: Option<Length>, diagonal: f64) -> Option<f64> {
    limit.map(|error| error.in_units(diagonal))
}

impl From<CostArg> for CollapseCost {
    fn from(cost: CostArg) -> Self {
        match cost {
            CostArg::Memoryless => Self::Memoryless,
            CostArg::Accumulated => Self::Accumulated,
            CostArg::Tracked => Self::Tracked,
        }
    }
}
