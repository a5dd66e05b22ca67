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

/// Vertices that a GPU with a cache of transformed vertices transforms.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct CacheCost {
    /// Cache misses.
    pub miss_count: usize,
    /// Misses a triangle.
    pub acmr: f64,
    /// Misses a used vertex; 1 is perfect.
    pub atvr: f64,
}

impl CacheCost {
    fn new(miss_count: usize, triangle_count: usize, used_count: usize) -> Self {
        let ratio = |n: usize| if n == 0 { 0.0 } else { miss_count as f64 / n as f64 };
        Self { miss_count, acmr: ratio(triangle_count), atvr: ratio(used_count) }
    }
}

/// Runs an index buffer (triangles or strips, restarts allowed) through a first-in first-out cache of
/// `cache_size` vertices.
///
/// `triangle_count` is what the buffer draws. Restarts leave the cache as it is.
pub fn fifo_cache_cost(indices: &[u32], triangle_count: usize, cache_size: usize) -> CacheCost {
    let (indices, vertex_limit) = drawn_vertices(indices);
    // The miss that brought a vertex in, from 1; a vertex is cached while fewer than `cache_size` followed.
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

/// Does as [`fifo_cache_cost`] with a cache that lets go of the vertex that was used least recently.
pub fn lru_cache_cost(indices: &[u32], triangle_count: usize, cache_size: usize) -> CacheCost {
    let (indices, vertex_limit) = drawn_vertices(indices);
    let mut recent = Recent::new(vertex_limit);
    let (mut cached_count, mut miss_count, mut used_count) = (0, 0, 0);
    for v in indices {
        match recent.states[v as usize] {
            Residence::Inside => recent.unlink(v),
            residence => {
                used_count += usize::from(residence == Residence::NeverSeen);
                miss_count += 1;
                cached_count += 1;
            }
        }
        recent.push_newest(v);
        if cached_count > cache_size {
            recent.drop_oldest();
            cached_count -= 1;
        }
    }
    CacheCost::new(miss_count, triangle_count, used_count)
}

/// The vertices that a buffer names, restarts left out, and a limit above them.
///
/// Numbers far above what the buffer's length accounts for are replaced by their ranks: tables by vertex
/// never outgrow the buffer.
fn drawn_vertices(indices: &[u32]) -> (Vec<u32>, usize) {
    let mut vertices: Vec<u32> = indices.iter().copied().filter(|&v| v != RESTART).collect();
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

/// Whether a vertex is in a cache.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Residence {
    NeverSeen,
    Inside,
    Outside,
}

/// Vertices from the most to the least recently used: a list threaded through tables by vertex, O(1) a use.
struct Recent {
    states: Vec<Residence>,
    /// The one used next after each and the one used last before it; the last entry closes the ring.
    newer: Vec<u32>,
    older: Vec<u32>,
    ring: u32,
}

impl Recent {
    fn new(vertex_limit: usize) -> Self {
        let links = vec![vertex_limit as u32; vertex_limit + 1];
        let states = vec![Residence::NeverSeen; vertex_limit];
        Self { states, newer: links.clone(), older: links, ring: vertex_limit as u32 }
    }

    fn unlink(&mut self, v: u32) {
        let (newer, older) = (self.newer[v as usize], self.older[v as usize]);
        self.older[newer as usize] = older;
        self.newer[older as usize] = newer;
    }

    fn push_newest(&mut self, v: u32) {
        let newest = self.older[self.ring as usize];
        self.states[v as usize] = Residence::Inside;
        self.newer[v as usize] = self.ring;
        self.older[v as usize] = newest;
        self.newer[newest as usize] = v;
        self.older[self.ring as usize] = v;
    }

    fn drop_oldest(&mut self) {
        let oldest = self.newer[self.ring as usize];
        self.unlink(oldest);
        self.states[oldest as usize] = Residence::Outside;
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
    fn a_cache_forgets_the_oldest_vertex() {
        let cost = fifo_cache_cost(&[0, 1, 2, RESTART, 0, 1, 3, 0], 2, 3);
        // 3 pushes 0 out.
        assert_eq!(cost.miss_count, 5);
        assert_eq!((cost.acmr, cost.atvr), (2.5, 1.25));
    }

    #[test]
    fn recent_use_keeps_a_vertex() {
        // 0 is used again before 3 comes, so 1 goes, then 2.
        let buffer = [0, 1, 2, RESTART, 0, 3, 0, 1, 3, 0, 2];
        let cost = lru_cache_cost(&buffer, 4, 3);
        assert_eq!(cost.miss_count, 6);
        assert_eq!((cost.acmr, cost.atvr), (1.5, 1.5));
        assert_eq!(fifo_cache_cost(&buffer, 4, 3).miss_count, 7);
    }

    #[test]
    fn caches_without_room_or_work() {
        for cost in [fifo_cache_cost, lru_cache_cost] {
            assert_eq!(cost(&[0, 1, 0, 1, 1], 1, 0).miss_count, 5);
            assert_eq!(cost(&[RESTART, RESTART], 0, 16), CacheCost::default());
            // A number far beyond the buffer takes no table of its size.
            assert_eq!(cost(&[RESTART - 1, 7, RESTART - 1, 8], 2, 16).miss_count, 3);
        }
    }
}
