//! A first-in first-out cache that can be asked what a strip would find in it.

/// Which vertices are cached, by the misses that brought them in.
pub(super) struct Fifo {
    /// Misses up to and with the one that brought each vertex in; 0 where none did.
    entered: Vec<u32>,
    /// The vertex of each miss, in a ring.
    ring: Vec<u32>,
    miss_count: u32,
}

impl Fifo {
    /// An empty cache; one that holds all vertices is as good as any larger one.
    pub(super) fn new(vertex_limit: usize, cache_size: usize) -> Self {
        Self { entered: vec![0; vertex_limit], ring: vec![0; cache_size.min(vertex_limit)], miss_count: 0 }
    }

    /// Cached vertices.
    pub(super) fn len(&self) -> usize {
        self.ring.len().min(self.miss_count as usize)
    }

    /// A cached vertex, below [`Self::len`]; the order is no promise.
    pub(super) fn vertex(&self, slot: usize) -> u32 {
        self.ring[slot]
    }

    /// Whether a vertex would still be cached after some further misses.
    fn outlives(&self, v: u32, further: u32) -> bool {
        let entered = self.entered[v as usize];
        entered != 0 && self.miss_count - entered + further < self.ring.len() as u32
    }

    pub(super) fn touch(&mut self, v: u32) {
        if !self.outlives(v, 0) {
            let slot = self.miss_count as usize % self.ring.len().max(1);
            if let Some(entry) = self.ring.get_mut(slot) {
                *entry = v;
            }
            self.miss_count += 1;
            self.entered[v as usize] = self.miss_count;
        }
    }

    /// Misses that a strip is spared by what is cached before it.
    pub(super) fn found_by(&self, indices: impl Iterator<Item = u32>) -> u32 {
        let size = self.ring.len();
        let mut missed: Vec<u32> = Vec::with_capacity(size);
        let mut found: Vec<u32> = Vec::with_capacity(size);
        for v in indices {
            if missed.contains(&v) || found.contains(&v) {
                continue;
            }
            if self.outlives(v, missed.len() as u32) {
                found.push(v);
            } else {
                missed.push(v);
                if missed.len() >= size {
                    break;
                }
            }
        }
        found.len() as u32
    }
}
