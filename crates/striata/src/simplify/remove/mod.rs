//! Vertex removal with optimal retriangulation: the simplifier behind every fragment sequence.
//!
//! A removal takes away the triangles around a vertex and fills the hole with triangles of its ring, one or
//! two fewer than before. Of all triangulations, the one nearest to all vertices removed so far is chosen
//! (`hole::search`), and of all removals the cheapest is applied. Costs combine two measures of distance:
//! squared distances over the surface, and the largest distance alone (`removal_evaluator`). Before a removal
//! is applied, its true effect on the distance from the original surface is bounded (`Cover`), so that the
//! error of each step, and the caller's error limit, hold for every point of the original.
//!
//! ```text
//!       r1 ---- r2             r1 ---- r2
//!      /  \   /  \            /  \ __/  \        ceiling: the triangles around v
//!    r0 --- v --- r3   ->    r0 ---'----- r3      floor: any triangulation of the ring
//!      \  /   \  /            \   `--.  /
//!       r5 ---- r4             r5 ---- r4
//! ```
//!
//! After \[KLS96\] and \[KK97\], as \[KG98\] uses them: strict order, one-sided Hausdorff distance, and
//! retriangulation of holes up to a size limit. Differs: by default the order is not by that distance
//! alone ([`RemovalOrder::Hausdorff`] is); surface that sticks out adds to the cost, although one-sided
//! distances do not detect it. The error is a proven bound, not a sample. A collapse is one way to fill a hole, and the only one at seams, between groups
//! of triangles and where sheets meet; crossing a seam adds to the cost.
//!
//! A vertex without any such removal gets a **relaxed** collapse, as in the collapse simplifier:
//! handles close, thin parts fold flat and small parts vanish, in order of cost, so that every triangle
//! count can be reached. A part that vanishes leaves a floor without triangles; the bounds of all steps
//! are then computed again by [`certify`](super::certify), which finds the triangles that replace the
//! part. On closed surfaces of a few large parts, relaxed collapses begin when nothing else is left.
//!
//! Order and triangulations depend on distances rounded to single precision, so that they are the same
//! on every machine. Time O(n log n), most of it for distances of tracked vertices; 22 µs per triangle
//! on the bunny, including the bound.

mod collapse_candidates;
mod fragment_builder;
mod hole;
mod removal_evaluator;
mod removal_options;
mod removal_record;

pub use removal_options::{BuiltFragments, HoleCriterion, RemovalOptions, RemovalOrder, Retriangulation};

use crate::mesh::{IndexedMesh, Welded, weld};
use crate::{ProgressFn, ignore_progress};

use crate::simplify::options::{SimplifyError, check_locked};

/// Removes vertices as far as the options allow and returns the sequence of all levels on the way.
///
/// Compared with [`build_sequence`](super::build_sequence), levels are closer to the original, especially in
/// their maximum error, for twenty times the time; the steps are not collapses in general.
///
/// # Errors
/// [`SimplifyError`] if the mesh is invalid or an option is out of range.
///
/// # Example
/// ```
/// use striata::mesh::{replay_fragments, shapes};
/// use striata::simplify::{RemovalOptions, build_fragments};
///
/// let torus = shapes::torus(32, 16, 1.0, 0.4);
/// let options = RemovalOptions::default().with_max_error(0.05);
/// let built = build_fragments(&torus, &options)?;
/// let level = replay_fragments(&built.fragmented, 0);
/// // No point of the torus is farther from the level.
/// let error = built.fragmented.fragments.levels().error_at(0);
/// assert!(error <= 0.05 && level.triangle_count() < torus.triangle_count() / 4);
/// # Ok::<(), striata::simplify::SimplifyError>(())
/// ```
pub fn build_fragments(
    mesh: &IndexedMesh,
    options: &RemovalOptions,
) -> Result<BuiltFragments, SimplifyError> {
    build_fragments_with_progress(mesh, options, &mut ignore_progress)
}

/// Runs [`build_fragments`] and reports progress; the callback can cancel.
///
/// # Errors
/// See [`build_fragments`]; also [`SimplifyError::Cancelled`] if the callback cancels.
pub fn build_fragments_with_progress(
    mesh: &IndexedMesh,
    options: &RemovalOptions,
    progress: &mut ProgressFn<'_>,
) -> Result<BuiltFragments, SimplifyError> {
    options.check()?;
    check_locked(&options.locked_vertices, mesh.vertex_count())?;
    build_welded_fragments_with_progress(weld(mesh)?, options, progress)
}

/// Removes vertices of a mesh that is already welded and returns the sequence of all levels.
///
/// # Errors
/// See [`build_fragments`].
pub fn build_welded_fragments(
    welded: Welded,
    options: &RemovalOptions,
) -> Result<BuiltFragments, SimplifyError> {
    build_welded_fragments_with_progress(welded, options, &mut ignore_progress)
}

/// Runs [`build_welded_fragments`] and reports progress; the callback can cancel.
///
/// # Errors
/// See [`build_welded_fragments`]; also [`SimplifyError::Cancelled`] if the callback cancels.
pub fn build_welded_fragments_with_progress(
    welded: Welded,
    options: &RemovalOptions,
    progress: &mut ProgressFn<'_>,
) -> Result<BuiltFragments, SimplifyError> {
    options.check()?;
    fragment_builder::FragmentBuilder::new(&welded, options).run(progress)?.into_fragments(welded, progress)
}
