//! The second simplifier: vertices are removed one by one, and each hole is filled in the best of all ways.
//!
//! A removal takes away the triangles around a vertex and fills the hole with triangles of its ring, one or two
//! fewer than there were. Of all fillings the one is chosen that comes nearest to all vertices removed so far (`hole::search`), and of
//! all removals the cheapest is made, by distances of two kinds: their squares over the surface, and the largest one alone
//! (`judge`). What a removal really does to the distance of the original surface is then bounded before it is made (`cover`), so
//! that the error of each step, and the limit that a caller sets, hold for every point of the original.
//!
//! ```text
//!       r1 ---- r2             r1 ---- r2
//!      /  \   /  \            /  \ __/  \        ceiling: the triangles around v
//!    r0 --- v --- r3   ->    r0 ---'----- r3      floor: any triangulation of the ring
//!      \  /   \  /            \   `--.  /
//!       r5 ---- r4             r5 ---- r4
//! ```
//!
//! After \[KLS96\] and \[KK97\], as \[KG98\] uses them: strict order, one-sided Hausdorff distance, retriangulation of the
//! hole with an upper limit on its size. Differs: the order is not by that distance alone, which made the RMS of
//! levels 5 to 30 % larger for maxima that were 10 to 40 % smaller; and what sticks out of the surface counts, which one-sided
//! distances do not see. The bound is certain, not a sample. A collapse
//! is one way to fill a hole, and the only one at seams, between groups of triangles and where sheets meet; crossing a seam has a price.
//!
//! A vertex that has no such removal gets a **relaxed** collapse, as in the first simplifier: handles close, thin parts fold flat and small
//! parts vanish, in the order of cost, so that every number of triangles is reached. A part that vanishes leaves a floor without
//! triangles; the bounds of all steps are then found again by [`certify`](super::certify), which knows what stands in for it. On
//! closed surfaces of a few large parts relaxed collapses begin when nothing else is left.
//!
//! Order and holes follow rounded distances in single precision, so that they are the same on every machine. Time
//! O(n log n), most of it distances of followed vertices; 22 µs a triangle on the bunny with the bound.

mod collapses;
mod engine;
mod hole;
mod judge;
mod options;
mod points;
mod record;

pub use options::{BuiltFragments, HoleCriterion, RemovalOptions, Retriangulation};

use crate::mesh::{IndexedMesh, Welded, weld};
use crate::{ProgressFn, ignore_progress};

use crate::simplify::options::{SimplifyError, check_locked};

/// Removes vertices as far as it goes, and gives every level on the way.
///
/// Compared with [`build_sequence`](super::build_sequence): levels nearer to the original, the maximum above all, for twenty
/// times the time; steps that are no collapses.
///
/// # Errors
/// [`SimplifyError`] where the mesh does not hang together or an option is out of range.
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

/// Does as [`build_fragments`] and reports its progress; the callback can cancel.
///
/// # Errors
/// As [`build_fragments`], and if the callback cancels.
pub fn build_fragments_with_progress(
    mesh: &IndexedMesh,
    options: &RemovalOptions,
    progress: &mut ProgressFn<'_>,
) -> Result<BuiltFragments, SimplifyError> {
    options.check()?;
    check_locked(&options.locked_vertices, mesh.vertex_count())?;
    build_welded_fragments_with_progress(weld(mesh)?, options, progress)
}

/// The same for a mesh that is welded already.
///
/// # Errors
/// As [`build_fragments`].
pub fn build_welded_fragments(
    welded: Welded,
    options: &RemovalOptions,
) -> Result<BuiltFragments, SimplifyError> {
    build_welded_fragments_with_progress(welded, options, &mut ignore_progress)
}

/// Does as [`build_welded_fragments`] and reports its progress; the callback can cancel.
///
/// # Errors
/// As [`build_welded_fragments`], and if the callback cancels.
pub fn build_welded_fragments_with_progress(
    welded: Welded,
    options: &RemovalOptions,
    progress: &mut ProgressFn<'_>,
) -> Result<BuiltFragments, SimplifyError> {
    options.check()?;
    engine::Engine::new(&welded, options).run(progress)?.finish(welded, progress)
}
