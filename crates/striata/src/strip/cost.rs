//! What strips cost: indices sent, and vertices transformed.

use super::{RESTART, StripSet, strip_triangles};

/// What a set of strips costs.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct StripCost {
    /// Triangles, degenerate ones not counted.
    pub triangle_count: usize,
    /// Strips.
    pub strip_count: usize,
    /// Degenerate triangles inside strips: turns and parity fixes.
    pub swap_count: usize,
    /// Indices of the buffer with primitive restart: swaps, parity fixes and restarts counted.
    pub index_count: usize,
    /// `index_count / triangle_count`; 0 without triangles.
    pub indices_per_triangle: f64,
    /// Indices of the longest strip.
    pub longest_strip: usize,
}

impl StripSet {
    /// What the strips cost.
    pub fn cost(&self) -> StripCost {
        let mut cost = StripCost { strip_count: self.strip_count(), ..StripCost::default() };
        for strip in self.strips() {
            let triangle_count = strip_triangles(strip).count();
            cost.triangle_count += triangle_count;
            cost.swap_count += strip.len().saturating_sub(2) - triangle_count;
            cost.longest_strip = cost.longest_strip.max(strip.len());
        }
        cost.index_count = self.to_restart_indices().indices.len();
        if cost.triangle_count > 0 {
            cost.indices_per_triangle = cost.index_count as f64 / cost.triangle_count as f64;
        }
        cost
    }
}

/// Vertices that a GPU with a first-in first-out cache transforms.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct CacheCost {
    /// Cache misses.
    pub miss_count: usize,
    /// Misses a triangle.
    pub acmr: f64,
    /// Misses a used vertex; 1 is perfect.
    pub atvr: f64,
}

/// Runs an index buffer (triangles or strips, restarts allowed) through a cache of `cache_size` vertices.
///
/// `triangle_count` is what the buffer draws. Restarts leave the cache as it is.
pub fn fifo_cache_cost(indices: &[u32], triangle_count: usize, cache_size: usize) -> CacheCost {
    let vertex_limit = indices.iter().filter(|&&v| v != RESTART).max().map_or(0, |&v| v as usize + 1);
    // The miss that brought a vertex in, from 1; a vertex is cached while fewer than `cache_size` followed.
    let mut entered = vec![0usize; vertex_limit];
    let mut miss_count = 0;
    let mut used_count = 0;
    for &v in indices.iter().filter(|&&v| v != RESTART) {
        let e = &mut entered[v as usize];
        used_count += usize::from(*e == 0);
        if *e == 0 || miss_count - *e >= cache_size {
            miss_count += 1;
            *e = miss_count;
        }
    }
    let ratio = |n: usize| if n == 0 { 0.0 } else { miss_count as f64 / n as f64 };
    CacheCost { miss_count, acmr: ratio(triangle_count), atvr: ratio(used_count) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn swaps_and_restarts_are_counted() {
        let mut set = StripSet::new();
        set.push(&[0, 1, 2, 3, 2, 4]);
        set.push(&[5, 6, 7]);
        set.end_group();
        let cost = set.cost();
        assert_eq!((cost.triangle_count, cost.strip_count, cost.swap_count), (4, 2, 1));
        assert_eq!((cost.index_count, cost.longest_strip), (10, 6));
        assert_eq!(cost.indices_per_triangle, 2.5);
    }

    #[test]
    fn a_cache_forgets_the_oldest_vertex() {
        let cost = fifo_cache_cost(&[0, 1, 2, RESTART, 0, 1, 3, 0], 2, 3);
        // 3 pushes 0 out.
        assert_eq!(cost.miss_count, 5);
        assert_eq!((cost.acmr, cost.atvr), (2.5, 1.25));
    }
}
