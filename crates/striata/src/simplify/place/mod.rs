//! Free placement: simplifies to one level by edge collapses with optimal positions of the new vertices.
//!
//! The cost of an edge is the squared distance of its new vertex from the planes of the *current*
//! triangles around both ends, weighted by area; the new position minimizes it while preserving the
//! volume [LT98], [Hop99]. No history is kept, so errors do not add up to a bias, and preserving the
//! volume keeps the surface from shrinking. Levels are not nested: vertices move at every step, so the
//! result is one mesh and not a sequence.
//!
//! ```text
//!     r1 --- r2                r1 --- r2
//!    /  \   /  \              /   \  /   \      A half-edge collapse v -> u in the links,
//!   s -- u v -- r3     ->    s --- x --- r3     then u moves to x. Links and legality tests
//!    \  /   \  /              \   /  \   /      are those of placement on a subset.
//!     r5 --- r4                r5 --- r4
//! ```
//!
//! The queue contains the cheapest edge of each position, by the quadratic form alone; flips, links,
//! seams and the distance of the old vertices from the new triangles are tested when it reaches the
//! top. If an edge has changed, the end that was evaluated last has its current cost, so the order is
//! strictly by cost although the other end may still have an older one.
//!
//! Borders (boundaries, edges with three triangles, seams that must stay) are preserved: a vertex on a
//! border is merged only along it, an inner vertex is merged into it without moving it, and vertices at
//! which borders meet or end stay in place. Seams that may be crossed do not count as borders; leaving
//! their path and crossing them adds to the cost (`seams`).
//!
//! A position without any such collapse gets a **relaxed** one, unless the topology must be preserved:
//! the half-edge collapse that subset placement would choose, with its target unmoved, so that every
//! target is reached. Both kinds share one queue, since both costs are squared distances over areas.
//!
//! Links, wedges and positions are those of a `CostEvaluator`, which represents the current mesh in
//! single precision.
//!
//! The loop stops at an error limit by an estimate from tracked vertices (`distance_tracker`). The
//! error of the finished level is measured against the original, both ways; if it exceeds the limit,
//! the simplification is repeated with a smaller one.
//!
//! Differs: the cost is always memoryless, attributes count only at seams and in relaxed collapses, and
//! pairs without an edge are never merged. Time O(n log n), about 400 bytes per vertex.

mod blend;
mod distance_tracker;
mod edge_placement;
mod measure;
mod merger;
mod neighborhood;
mod quadratic_form;
mod scaled_space;
mod seams;
mod stop_criteria;

use crate::ProgressFn;
use crate::mesh::Welded;
use crate::simplify::options::{Simplified, SimplifyError, SimplifyOptions};
use measure::measured_error;
use merger::Merger;
use stop_criteria::StopCriteria;

/// Number of times that a level beyond the error limit is simplified again, each time with a smaller limit.
const MAX_RETRIES: usize = 8;
/// Share of the diagonal that rounding to single precision may add to a distance.
const NOISE: f64 = 1e-6;

/// Simplifies to one level with freely placed vertices; the options must be in range.
///
/// # Errors
/// [`SimplifyError`] if the callback cancels, or if vertices without a common edge should be merged.
pub(super) fn simplify_optimal(
    welded: &Welded,
    options: &SimplifyOptions,
    progress: &mut ProgressFn<'_>,
) -> Result<Simplified, SimplifyError> {
    if let Some(distance) = options.sequence.pair_distance {
        let expected = "none with optimal placement";
        return Err(SimplifyError::Option { option: "pair_distance", value: distance.to_string(), expected });
    }
    let mut merger = Merger::new(welded, &options.sequence);
    let mut criteria = StopCriteria::new(options, merger.counts());
    let limit = criteria.limit;
    for retry in 0.. {
        let stop_reason = merger.run(&criteria, progress)?;
        let (estimated, scale, removed_count) = (merger.error, merger.space.scale, merger.removed_count);
        let mesh = merger.finish();
        let error = if removed_count > 0 { measured_error(&welded.mesh, &mesh) } else { 0.0 };
        if error <= limit + NOISE * scale {
            return Ok(Simplified { mesh, error: error.min(limit), stop_reason });
        }
        if criteria.limit == 0.0 {
            break;
        }
        let smaller = estimated.min(criteria.limit) * (0.9 * limit / error);
        criteria.limit = if retry < MAX_RETRIES { smaller } else { 0.0 };
        merger = Merger::new(welded, &options.sequence);
    }
    Ok(Simplified { mesh: welded.mesh.clone(), error: 0.0, stop_reason: criteria.at_limit })
}
