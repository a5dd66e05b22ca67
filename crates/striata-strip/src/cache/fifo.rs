//! First-in first-out cache that predicts how many hits a strip would have.

/// Cached vertices, identified by the miss that loaded them.
pub(super) struct Fifo {
    /// Number of misses up to and including the one that loaded each vertex; 0 if it was never loaded.
    entered: Vec<u32>,
    /// Vertex of each recent miss, as a ring buffer.
    ring: Vec<u32>,
    miss_count: u32,
}

impl Fifo {
    /// Creates an empty cache. Its size is limited to the vertex count; a larger cache would make no
    /// difference.
    pub(super) fn new(vertex_limit: usize, cache_size: usize) -> Self {
        Self { entered: vec![0; vertex_limit], ring: vec![0; cache_size.min(vertex_limit)], miss_count: 0 }
    }

    /// Number of cached vertices.
    pub(super) fn len(&self) -> usize {
        self.ring.len().min(self.miss_count as usize)
    }

    /// Returns a cached vertex by its slot, below [`Self::len`]; slots are in no particular order.
    pub(super) fn vertex(&self, slot: usize) -> u32 {
        self.ring[slot]
    }

    /// Whether a vertex would still be cached after some further misses.
    fn stays_cached(&self, v: u32, further: u32) -> bool {
        let entered = self.entered[v as usize];
        entered != 0 && self.miss_count - entered + further < self.ring.len() as u32
    }

    /// Accesses a vertex; a miss loads it into the cache.
    pub(super) fn touch(&mut self, v: u32) {
        if !self.stays_cached(v, 0) {
            let slot = self.miss_count as usize % self.ring.len().max(1);
            if let Some(entry) = self.ring.get_mut(slot) {
                *entry = v;
            }
            self.miss_count += 1;
            self.entered[v as usize] = self.miss_count;
        }
    }

    /// Number of misses that the current contents of the cache save a strip.
    pub(super) fn hit_count(&self, indices: impl Iterator<Item = u32>) -> u32 {
        let size = self.ring.len();
        let mut missed: Vec<u32> = Vec::with_capacity(size);
        let mut found: Vec<u32> = Vec::with_capacity(size);
        for v in indices {
            if missed.contains(&v) || found.contains(&v) {
                continue;
            }
            if self.stays_cached(v, missed.len() as u32) {
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
