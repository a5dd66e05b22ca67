//! Work on independent items, on all cores if the feature `parallel` is on.

/// Results of a function for all items, in their order.
#[cfg(feature = "parallel")]
pub(crate) fn map_in_parallel<T: Sync, R: Send>(items: &[T], run: impl Fn(&T) -> R + Sync) -> Vec<R> {
    use rayon::prelude::*;
    items.par_iter().map(&run).collect()
}

/// Results of a function for all items, in their order.
#[cfg(not(feature = "parallel"))]
pub(crate) fn map_in_parallel<T: Sync, R: Send>(items: &[T], run: impl Fn(&T) -> R + Sync) -> Vec<R> {
    items.iter().map(run).collect()
}
