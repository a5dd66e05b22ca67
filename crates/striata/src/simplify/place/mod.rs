//! One level with vertices placed freely: edge collapses whose new vertex lies where it costs least.
//!
//! An edge costs the squared distances of its new vertex from the planes of the *current* triangles around both ends,
//! weighted by area; the place is the least of them that keeps the volume [LT98], [Hop99]. Nothing is remembered, so
//! errors do not add up to a bias, and the volume keeps the surface from shrinking. Levels are not nested: vertices
//! move at every step, so this gives one mesh and no sequence.
//!
//! ```text
//!     r1 --- r2                r1 --- r2
//!    /  \   /  \              /   \  /   \      A half-edge collapse v -> u in the links,
//!   s -- u v -- r3     ->    s --- x --- r3     then u moves to x. Links are those of the
//!    \  /   \  /              \   /  \   /      subset mode, and so is what they allow.
//!     r5 --- r4                r5 --- r4
//! ```
//!
//! The queue holds a position's cheapest edge, by the form alone; flips, links, seams and the distance of the old
//! vertices from the new triangles are looked at when it reaches the top. An edge that has changed is known to the end that
//! was looked at last, so the order is strict though the other end may hold an older cost.
//!
//! Borders (boundaries, edges with three triangles, seams that must stay) keep their course: a vertex on one merges along it only,
//! an inner vertex merges into it without moving it, and where borders meet or end, the vertex stays in place. Seams that may be
//! crossed are no borders; leaving their course and crossing them has a price (`seams`).
//!
//! A position without any such collapse gets a **relaxed** one, unless the topology must stay: the half-edge collapse that the
//! subset mode would choose there, with its target in place, so that every target is reached. Both kinds share one queue, since
//! their costs are squared distances over areas alike.
//!
//! The links, wedges and positions are those of a [`Judge`], which sees the current mesh in single precision.
//!
//! The loop stops at a limit of the error by an estimate from followed vertices (`drift`). The error of the finished level is measured against
//! the original, both ways; if it exceeds the limit, everything is done again with a smaller one.
//!
//! Differs: always memoryless; attributes count only at seams and in relaxed collapses, and pairs without an edge are never merged.
//! Time O(n log n), about 400 bytes a vertex.

mod blend;
mod course;
mod drift;
mod form;
mod frame;
mod goal;
mod hood;
mod measure;
mod merger;
mod seams;

use crate::ProgressFn;
use crate::mesh::Welded;
use crate::simplify::options::{Simplified, SimplifyError, SimplifyOptions};
use goal::Goal;
use measure::measured_error;
use merger::Merger;

/// Times that a level beyond the error limit is made again, each time with a smaller limit.
const MAX_RETRIES: usize = 8;
/// Share of the diagonal that single precision leaves of a distance of 0.
const NOISE: f64 = 1e-6;

/// Simplifies to one level with vertices anywhere; the options must be in range.
///
/// # Errors
/// [`SimplifyError`] where the callback cancels, or vertices without a common edge are to be merged.
pub(super) fn simplify_optimal(
    welded: &Welded,
    options: &SimplifyOptions,
    progress: &mut ProgressFn<'_>,
) -> Result<Simplified, SimplifyError> {
    if let Some(distance) = options.sequence.pair_distance {
        let expected = "none where vertices are placed freely";
        return Err(SimplifyError::Option { option: "pair_distance", value: distance.to_string(), expected });
    }
    let mut merger = Merger::new(welded, &options.sequence);
    let mut goal = Goal::new(options, merger.counts());
    let limit = goal.limit;
    for retry in 0.. {
        let stop_reason = merger.run(&goal, progress)?;
        let (estimated, scale, removed_count) = (merger.error, merger.frame.scale, merger.removed_count);
        let mesh = merger.finish();
        let error = if removed_count > 0 { measured_error(&welded.mesh, &mesh) } else { 0.0 };
        if error <= limit + NOISE * scale {
            return Ok(Simplified { mesh, error: error.min(limit), stop_reason });
        }
        if goal.limit == 0.0 {
            break;
        }
        let smaller = estimated.min(goal.limit) * (0.9 * limit / error);
        goal.limit = if retry < MAX_RETRIES { smaller } else { 0.0 };
        merger = Merger::new(welded, &options.sequence);
    }
    Ok(Simplified { mesh: welded.mesh.clone(), error: 0.0, stop_reason: goal.at_limit })
}
