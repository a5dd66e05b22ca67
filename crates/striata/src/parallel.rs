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

/// Changes all items of a list; on several threads if the feature `parallel` is enabled.
pub(crate) fn for_each<T: Send>(items: &mut [T], change: impl Fn(&mut T) + Sync) {
    #[cfg(feature = "parallel")]
    {
        use rayon::prelude::*;
        items.par_iter_mut().for_each(&change);
    }
    #[cfg(not(feature = "parallel"))]
    items.iter_mut().for_each(change);
}

/// Results of two functions; on two threads if the feature `parallel` is enabled.
pub(crate) fn join<A: Send, B: Send>(a: impl FnOnce() -> A + Send, b: impl FnOnce() -> B + Send) -> (A, B) {
    #[cfg(feature = "parallel")]
    {
        rayon::join(a, b)
    }
    #[cfg(not(feature = "parallel"))]
    (a(), b())
}
