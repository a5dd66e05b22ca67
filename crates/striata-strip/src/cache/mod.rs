//! Strips for a vertex cache: minimizes `indices + weight * misses`.
//!
//! Few indices alone do not make a mesh cheap to draw: when a long strip comes back along its other side,
//! the cache has forgotten the vertices, and the GPU transforms them again. There are two remedies.
//! `reorder` puts existing strips into a better order; it hardly changes the number of indices and takes
//! milliseconds. `grow` makes new strips in rows that turn back before the cache forgets, as in \[Hop99b\];
//! it trades indices for misses. Which one pays off depends on the weight, so both are tried, and the
//! cheapest set of strips is returned.

mod adjacency;
mod beam_cache;
mod beam_state;
mod drawn_sets;
mod fifo;
mod grow;
mod reorder;
mod step_tree;

use striata::Cancelled;
use striata::strip::{StripLinks, StripSet, fifo_cache_cost};

use crate::task::{SearchLimits, StripTask};

/// Lowest weight for which new strips are tried; below it they were never cheaper than reordered strips.
const LEAST_WEIGHT_TO_GROW: f64 = 0.1;

/// Returns the cheapest strips for the cache in the options: the given strips, the same strips reordered,
/// or new ones.
///
/// A cache of fewer than three vertices cannot contain a triangle, so the strips stay as they are.
pub(crate) fn cheapest_for_cache(
    task: &StripTask<'_>,
    links: &StripLinks<'_>,
    strips: StripSet,
    limits: &mut dyn SearchLimits,
) -> Result<StripSet, Cancelled> {
    let options = task.options;
    if options.cache_size < 3 {
        return Ok(strips);
    }
    let ordered = reorder::reorder(&strips, options.cache_weight, options.cache_size);
    let grown = match options.cache_weight >= LEAST_WEIGHT_TO_GROW {
        true => Some(grow::grow(task, links, &mut |now| limits.report(now))?),
        false => None,
    };
    let price = |strips: &StripSet| {
        let indices = strips.to_restart_indices().indices;
        let misses = fifo_cache_cost(&indices, 1, options.cache_size).miss_count;
        indices.len() as f64 + options.cache_weight * misses as f64
    };
    let mut best = (price(&strips), strips);
    for other in [Some(ordered), grown].into_iter().flatten() {
        let price = price(&other);
        if price < best.0 {
            best = (price, other);
        }
    }
    Ok(best.1)
}
