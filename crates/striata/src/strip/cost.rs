//! Cost of strips: number of indices, and vertices transformed with a vertex cache.

use super::{RESTART, StripSet, strip_triangles};

/// Cost of a set of strips.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct StripCost {
    /// Number of triangles, without degenerate ones.
    pub triangle_count: usize,
    /// Number of strips.
    pub strip_count: usize,
    /// Number of degenerate triangles inside strips: swaps and parity fixes.
    pub swap_count: usize,
    /// Length of the index buffer with primitive restart, including swaps, parity fixes and restarts.
    pub index_count: usize,
    /// `index_count / triangle_count`; 0 if there are no triangles.
    pub indices_per_triangle: f64,
    /// Number of indices in the longest strip.
    pub longest_strip: usize,
}

impl StripSet {
    /// Computes the cost of the strips.
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

/// Number of vertices that a GPU with a post-transform cache has to transform.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct CacheCost {
    /// Number of cache misses.
    pub miss_count: usize,
    /// Average cache miss ratio: misses per triangle.
    pub acmr: f64,
    /// Average transform to vertex ratio: misses per used vertex; 1 is optimal.
    pub atvr: f64,
}

impl CacheCost {
    fn new(miss_count: usize, triangle_count: usize, used_count: usize) -> Self {
        let ratio = |n: usize| if n == 0 { 0.0 } else { miss_count as f64 / n as f64 };
        Self { miss_count, acmr: ratio(triangle_count), atvr: ratio(used_count) }
    }
}

/// Simulates a first-in first-out cache of `cache_size` vertices on an index buffer of triangles or strips,
/// which may contain restarts.
///
/// `triangle_count` is the number of triangles that the buffer draws. Restarts do not affect the cache.
pub fn fifo_cache_cost(indices: &[u32], triangle_count: usize, cache_size: usize) -> CacheCost {
    let (indices, vertex_limit) = drawn_vertices(indices);
    // The miss that loaded a vertex, counted from 1; the vertex stays cached until `cache_size` more misses.
    let mut entered = vec![0usize; vertex_limit];
    let mut miss_count = 0;
    let mut used_count = 0;
    for v in indices {
        let e = &mut entered[v as usize];
        used_count += usize::from(*e == 0);
        if *e == 0 || miss_count - *e >= cache_size {
            miss_count += 1;
            *e = miss_count;
        }
    }
    CacheCost::new(miss_count, triangle_count, used_count)
}

/// Simulates a least-recently-used cache, like [`fifo_cache_cost`] in all other respects.
pub fn lru_cache_cost(indices: &[u32], triangle_count: usize, cache_size: usize) -> CacheCost {
    let (indices, vertex_limit) = drawn_vertices(indices);
    let mut list = LruList::new(vertex_limit);
    let (mut cached_count, mut miss_count, mut used_count) = (0, 0, 0);
    for v in indices {
        match list.states[v as usize] {
            CacheState::Cached => list.unlink(v),
            state => {
                used_count += usize::from(state == CacheState::NeverSeen);
                miss_count += 1;
                cached_count += 1;
            }
        }
        list.push_newest(v);
        if cached_count > cache_size {
            list.evict_oldest();
            cached_count -= 1;
        }
    }
    CacheCost::new(miss_count, triangle_count, used_count)
}

/// The vertices in a buffer, without restarts, and a bound above them.
fn drawn_vertices(indices: &[u32]) -> (Vec<u32>, usize) {
    ranked(indices.iter().copied().filter(|&v| v != RESTART).collect())
}

/// Numbers of vertices, and a bound above them.
///
/// If indices are much larger than the length of the buffer, they are replaced by their ranks, so that
/// tables indexed by vertex never outgrow the buffer.
pub(super) fn ranked(mut vertices: Vec<u32>) -> (Vec<u32>, usize) {
    let limit = vertices.iter().max().map_or(0, |&v| v as usize + 1);
    if limit / 8 <= vertices.len() {
        return (vertices, limit);
    }
    let mut sorted = vertices.clone();
    sorted.sort_unstable();
    sorted.dedup();
    for v in &mut vertices {
        *v = sorted.partition_point(|other| other < v) as u32;
    }
    (vertices, sorted.len())
}

/// Whether a vertex is in the cache.
#[derive(Clone, Copy, PartialEq, Eq)]
enum CacheState {
    NeverSeen,
    Cached,
    Evicted,
}

/// A doubly linked list of vertices in order of use, stored in tables by vertex; each operation is O(1).
struct LruList {
    states: Vec<CacheState>,
    /// The next more recently and the next less recently used vertex; the last entry closes the ring.
    newer: Vec<u32>,
    older: Vec<u32>,
    sentinel: u32,
}

impl LruList {
    fn new(vertex_limit: usize) -> Self {
        let links = vec![vertex_limit as u32; vertex_limit + 1];
        let states = vec![CacheState::NeverSeen; vertex_limit];
        Self { states, newer: links.clone(), older: links, sentinel: vertex_limit as u32 }
    }

    fn unlink(&mut self, v: u32) {
        let (newer, older) = (self.newer[v as usize], self.older[v as usize]);
        self.older[newer as usize] = older;
        self.newer[older as usize] = newer;
    }

    fn push_newest(&mut self, v: u32) {
        let newest = self.older[self.sentinel as usize];
        self.states[v as usize] = CacheState::Cached;
        self.newer[v as usize] = self.sentinel;
        self.older[v as usize] = newest;
        self.newer[newest as usize] = v;
        self.older[self.sentinel as usize] = v;
    }

    fn evict_oldest(&mut self) {
        let oldest = self.newer[self.sentinel as usize];
        self.unlink(oldest);
        self.states[oldest as usize] = CacheState::Evicted;
    }
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
    fn a_fifo_cache_evicts_the_oldest_vertex() {
        let cost = fifo_cache_cost(&[0, 1, 2, RESTART, 0, 1, 3, 0], 2, 3);
        // Vertex 3 replaces vertex 0.
        assert_eq!(cost.miss_count, 5);
        assert_eq!((cost.acmr, cost.atvr), (2.5, 1.25));
    }

    #[test]
    fn an_lru_cache_keeps_recently_used_vertices() {
        // Vertex 0 is used again before 3 is loaded, so 1 is replaced, then 2.
        let buffer = [0, 1, 2, RESTART, 0, 3, 0, 1, 3, 0, 2];
        let cost = lru_cache_cost(&buffer, 4, 3);
        assert_eq!(cost.miss_count, 6);
        assert_eq!((cost.acmr, cost.atvr), (1.5, 1.5));
        assert_eq!(fifo_cache_cost(&buffer, 4, 3).miss_count, 7);
    }

    #[test]
    fn caches_of_size_zero_and_empty_buffers() {
        for cost in [fifo_cache_cost, lru_cache_cost] {
            assert_eq!(cost(&[0, 1, 0, 1, 1], 1, 0).miss_count, 5);
            assert_eq!(cost(&[RESTART, RESTART], 0, 16), CacheCost::default());
            // An index far beyond the buffer's length must not allocate a table of that size.
            assert_eq!(cost(&[RESTART - 1, 7, RESTART - 1, 8], 2, 16).miss_count, 3);
        }
    }
}
