//! Strips for a vertex cache: fewest `indices + weight * misses`.
//!
//! A GPU that sends few indices may still transform vertices twice: a long strip comes back to its other side when the
//! cache has forgotten it. Two ways to do better: put the strips that there are in a better order (`order`), or
//! grow new ones in rows that turn back before the cache forgets, as in \[Hop99b\] (`grow`). The first leaves the
//! indices alone and takes milliseconds; the second trades indices for misses. Which one pays depends on the
//! weight, so both are tried, and the cheaper set of strips is given.

mod answer;
mod cached;
mod covered;
mod fifo;
mod grow;
mod order;
mod steps;
mod surface;

use striata::strip::{StripLinks, StripSet, fifo_cache_cost};

use crate::task::Task;

/// Under this weight new strips have never been cheaper than those of any stripifier in a better order.
const LEAST_WEIGHT_TO_GROW: f64 = 0.1;

/// The cheapest set of strips for the cache of the options: these, these in another order, or new ones.
///
/// A cache of fewer than three vertices holds no triangle: strips stay as they are.
pub(crate) fn cheapest_for_cache(task: &Task<'_>, links: &StripLinks<'_>, strips: StripSet) -> StripSet {
    let options = task.options;
    if options.cache_size < 3 {
        return strips;
    }
    let ordered = order::reorder(&strips, options.cache_weight, options.cache_size);
    let grown = (options.cache_weight >= LEAST_WEIGHT_TO_GROW).then(|| grow::grow(task, links));
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
    best.1
}
