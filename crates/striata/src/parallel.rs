//! Spreads work over threads.

/// Results of a function for all numbers of a range, in their order; on several threads if the feature `parallel` is
/// enabled.
pub(crate) fn map<T: Send>(numbers: std::ops::Range<usize>, run: impl Fn(usize) -> T + Sync) -> Vec<T> {
    #[cfg(feature = "parallel")]
    {
        use rayon::prelude::*;
        numbers.into_par_iter().map(&run).collect()
    }
    #[cfg(not(feature = "parallel"))]
    numbers.map(run).collect()
}
