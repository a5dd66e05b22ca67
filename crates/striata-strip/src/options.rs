//! Options of the stripifiers: algorithm, seed, effort and vertex cache.

use crate::stripifier::Stripifier;

/// Upper limit of [`StripOptions::effort`].
const MAX_EFFORT: f64 = 1e6;

/// Options of [`stripify`](crate::stripify).
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct StripOptions {
    /// The algorithm; default [`Stripifier::Greedy`].
    pub stripifier: Stripifier,
    /// Seed of the stripifiers that make random choices; equal seeds give equal strips. Default 0.
    pub seed: u64,
    /// Search duration as a factor of the usual number of moves, 0 to 1,000,000. Default 1.
    pub effort: f64,
    /// Number of indices that one vertex cache miss is worth. Default 0: misses do not count. Above 0, the
    /// strips of any stripifier are reordered for the cache. From 0.1 on, they are also replaced by strips
    /// grown for the cache if that lowers `indices + cache_weight * misses`. Weights between 0.5 and 3 give
    /// compact rows.
    pub cache_weight: f64,
    /// Number of entries of that first-in first-out cache. Default 16. Below 3, misses do not count; strips
    /// are grown for at most 64 entries.
    pub cache_size: usize,
}

impl Default for StripOptions {
    fn default() -> Self {
        Self { stripifier: Stripifier::default(), seed: 0, effort: 1.0, cache_weight: 0.0, cache_size: 16 }
    }
}

impl StripOptions {
    /// Sets [`StripOptions::stripifier`].
    pub fn with_stripifier(mut self, stripifier: Stripifier) -> Self {
        self.stripifier = stripifier;
        self
    }

    /// Sets [`StripOptions::seed`].
    pub fn with_seed(mut self, seed: u64) -> Self {
        self.seed = seed;
        self
    }

    /// Sets [`StripOptions::effort`].
    pub fn with_effort(mut self, effort: f64) -> Self {
        self.effort = effort;
        self
    }

    /// Sets [`StripOptions::cache_weight`].
    pub fn with_cache_weight(mut self, weight: f64) -> Self {
        self.cache_weight = weight;
        self
    }

    /// Sets [`StripOptions::cache_size`].
    pub fn with_cache_size(mut self, size: usize) -> Self {
        self.cache_size = size;
        self
    }

    /// Number of moves that [`stripify`](crate::stripify) allows a search on a mesh of `triangle_count`
    /// triangles.
    ///
    /// Infinite for stripifiers that end by themselves.
    pub fn allowed_moves(&self, triangle_count: usize) -> f64 {
        let effort = if self.effort.is_nan() { 0.0 } else { self.effort.clamp(0.0, MAX_EFFORT) };
        self.stripifier.moves_per_triangle() * effort * triangle_count.max(1) as f64
    }
}
