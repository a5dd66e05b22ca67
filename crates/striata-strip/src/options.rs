//! Which stripifier, and how long and for what it searches.

use crate::stripifier::Stripifier;

/// The most that [`StripOptions::effort`] counts as.
const MAX_EFFORT: f64 = 1e6;

/// Options of [`stripify`](crate::stripify).
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct StripOptions {
    /// The algorithm; default [`Stripifier::Greedy`].
    pub stripifier: Stripifier,
    /// Seed of those that choose at random; equal seeds give equal strips. Default 0.
    pub seed: u64,
    /// How long those that search go on, as a factor of their usual number of moves, 0 to 1,000,000; default 1.
    pub effort: f64,
    /// Indices that one miss of a vertex cache is worth; default 0: misses do not count. Over 0, the strips of any
    /// stripifier are put in a better order, and from 0.1 on they give way to strips grown for the cache where
    /// these make `indices + cache_weight * misses` less. Between 0.5 and 3 these are compact rows.
    pub cache_weight: f64,
    /// Entries of that first-in first-out cache; default 16. With fewer than 3 misses do not count; strips are
    /// grown for at most 64.
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

    /// The moves that [`stripify`](crate::stripify) allows a search on so many triangles; infinite for those that end by themselves.
    pub fn allowed_moves(&self, triangle_count: usize) -> f64 {
        let effort = if self.effort.is_nan() { 0.0 } else { self.effort.clamp(0.0, MAX_EFFORT) };
        self.stripifier.moves_per_triangle() * effort * triangle_count.max(1) as f64
    }
}
