//! Simplification: turns a mesh into one coarser mesh or into a whole sequence of levels.
//!
//! [`simplify`] returns a single level. [`build_sequence`] returns every level, as half-edge collapses
//! in order of cost. [`build_batches`] groups independent collapses for progressive coding, and
//! [`build_fragments`] removes vertices and retriangulates the holes, for selective refinement.
//! [`certify`] replaces estimated errors by proven bounds.
//!
//! ```
//! use striata::mesh::shapes;
//! use striata::simplify::{SimplifyOptions, Target, simplify};
//!
//! let options = SimplifyOptions::default().with_target(Target::Triangles(200));
//! let level = simplify(&shapes::torus(32, 16, 1.0, 0.4), &options)?;
//! println!("{} triangles, error {}: {:?}", level.mesh.triangle_count(), level.error, level.stop_reason);
//! # Ok::<(), striata::simplify::SimplifyError>(())
//! ```

mod base_color;
pub mod cells;
mod certify;
mod collapse;
mod fit;
mod level;
mod options;
mod patch;
mod place;
mod remove;
mod scaled_space;

pub use base_color::{BaseColor, TextureLevels, Wrap};
pub use certify::{
    CertifiedFaces, certify, certify_collapses, certify_collapses_in_any_state,
    certify_collapses_in_any_state_with_progress, certify_collapses_with_progress, certify_faces,
    certify_faces_with_progress, certify_with_progress, flat_folds,
};
pub use collapse::batches::{
    BatchOptions, BuiltBatches, build_batches, build_batches_with_progress, build_welded_batches,
    build_welded_batches_with_progress,
};
pub(crate) use collapse::cost_evaluator::{is_scan, locked_positions};
pub use collapse::costs::CostFunction;
pub use fit::{fit_level, fit_level_with_progress, fit_within};
pub use options::{
    AttributeWeights, BoundaryRule, BuiltSequence, Placement, SeamRule, SequenceOptions, Simplified,
    SimplifyError, SimplifyOptions, StopReason, Target, TopologyRule,
};
pub(crate) use patch::{CarriedWitness, LockedPatch, SimplifiedPatch};
pub use place::{
    BuiltPlaced, PlacedCollapse, PlacedOptions, build_placed_fragments, build_placed_fragments_with_progress,
    build_welded_placed_fragments_with_progress,
};
pub use remove::{
    BuiltFragments, HoleCriterion, RemovalOptions, RemovalOrder, Retriangulation, build_fragments,
    build_fragments_with_progress, build_welded_fragments, build_welded_fragments_with_progress,
};

use crate::mesh::{IndexedMesh, Welded, replay, weld};
use crate::{ProgressFn, ignore_progress};

/// Simplifies a mesh as far as the options allow and returns the sequence of all levels on the way.
///
/// # Errors
/// [`SimplifyError`] if the mesh is invalid or an option is out of range.
///
/// # Example
/// ```
/// use striata::mesh::shapes;
/// use striata::simplify::{SequenceOptions, Target, build_sequence};
///
/// let torus = shapes::torus(32, 16, 1.0, 0.4);
/// let built = build_sequence(&torus, &SequenceOptions::default())?;
/// let sequence = &built.refinable.sequence;
/// let (split_count, _) = Target::Triangles(200).resolve(sequence);
/// let level = striata::mesh::replay(&built.refinable, split_count);
/// assert!(level.triangle_count() <= 200);
/// println!("{} triangles, error {}", level.triangle_count(), sequence.error_at(split_count));
/// # Ok::<(), striata::simplify::SimplifyError>(())
/// ```
pub fn build_sequence(mesh: &IndexedMesh, options: &SequenceOptions) -> Result<BuiltSequence, SimplifyError> {
    build_sequence_with_progress(mesh, options, &mut ignore_progress)
}

/// Runs [`build_sequence`] and reports progress; the callback can cancel.
///
/// # Errors
/// See [`build_sequence`]; also [`SimplifyError::Cancelled`] if the callback cancels.
pub fn build_sequence_with_progress(
    mesh: &IndexedMesh,
    options: &SequenceOptions,
    progress: &mut ProgressFn<'_>,
) -> Result<BuiltSequence, SimplifyError> {
    options.check()?;
    options.check_locked(mesh.vertex_count())?;
    build_welded_sequence_with_progress(weld(mesh)?, options, progress)
}

/// Simplifies a mesh that is already welded and returns the sequence of all levels.
///
/// # Errors
/// See [`build_sequence`].
pub fn build_welded_sequence(
    welded: Welded,
    options: &SequenceOptions,
) -> Result<BuiltSequence, SimplifyError> {
    build_welded_sequence_with_progress(welded, options, &mut ignore_progress)
}

/// Runs [`build_welded_sequence`] and reports progress; the callback can cancel.
///
/// # Errors
/// See [`build_welded_sequence`]; also [`SimplifyError::Cancelled`] if the callback cancels.
pub fn build_welded_sequence_with_progress(
    welded: Welded,
    options: &SequenceOptions,
    progress: &mut ProgressFn<'_>,
) -> Result<BuiltSequence, SimplifyError> {
    options.check()?;
    let (record, stop_reason) = if cells::is_worth_dividing(&welded, options) {
        cells::simplify_in_cells(&welded, options, cells::CELL_TRIANGLES, progress)?
    } else {
        collapse::simplifier::Simplifier::new(&welded, options).run(progress)?
    };
    let degenerate_triangle_count = welded.degenerate_triangle_count;
    let merged_vertex_count = welded.merged_vertex_count;
    let (refinable, source_vertex) = collapse::refinement_order::build_refinable(welded, record)?;
    Ok(BuiltSequence {
        refinable,
        source_vertex,
        stop_reason,
        degenerate_triangle_count,
        merged_vertex_count,
    })
}

/// Simplifies a mesh to one level and discards the sequence.
///
/// # Errors
/// See [`build_sequence`].
pub fn simplify(mesh: &IndexedMesh, options: &SimplifyOptions) -> Result<Simplified, SimplifyError> {
    simplify_with_progress(mesh, options, &mut ignore_progress)
}

/// Runs [`simplify`] and reports progress; the callback can cancel.
///
/// # Errors
/// See [`simplify`]; also [`SimplifyError::Cancelled`] if the callback cancels.
pub fn simplify_with_progress(
    mesh: &IndexedMesh,
    options: &SimplifyOptions,
    progress: &mut ProgressFn<'_>,
) -> Result<Simplified, SimplifyError> {
    options.check()?;
    options.sequence.check_locked(mesh.vertex_count())?;
    let welded = weld(mesh)?;
    let mut sequence_options = options.sequence.clone();
    if let Target::Triangles(n) = options.target {
        // Steps beyond the target are not needed.
        sequence_options.base_triangle_count = sequence_options.base_triangle_count.max(n);
    }
    let least = |a: Option<f64>, b: Option<f64>| a.into_iter().chain(b).reduce(f64::min);
    let limit = least(options.sequence.max_error, options.tolerance);
    let target_error = if let Target::Error(error) = options.target { Some(error) } else { None };
    sequence_options.max_error = least(limit, target_error);
    let mut built = build_welded_sequence_with_progress(welded, &sequence_options, progress)?;
    if built.stop_reason == StopReason::ErrorLimit && sequence_options.max_error != limit {
        // The limit is the target itself.
        built.stop_reason = StopReason::TargetReached;
    }
    let sequence = &built.refinable.sequence;
    let (mut split_count, mut stop_reason) = options.target.resolve(sequence);
    if let Some(error) = options.tolerance {
        let nearest = sequence.split_count_for_error(error);
        if nearest > split_count {
            (split_count, stop_reason) = (nearest, StopReason::ErrorLimit);
        }
    }
    if stop_reason == StopReason::BaseReached {
        stop_reason = built.stop_reason;
    }
    let level_at = |split_count: usize| {
        let error = f64::from(sequence.error_at(split_count));
        let mesh = replay(&built.refinable, split_count).without_unused_vertices();
        Simplified { mesh, error, stop_reason }
    };
    if options.placement == Placement::Subset {
        return Ok(level_at(split_count));
    }
    let max_error = least(limit, target_error).unwrap_or(f64::INFINITY);
    let level_within = |limit| level_at(split_count.max(sequence.split_count_for_error(limit)));
    fit_within(mesh, level_within, &options.sequence, max_error, progress)
}
