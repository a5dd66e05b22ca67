//! The order in which both sides of a stream ask the vertices of a surface whether they split: breadth first, or in the order of
//! their numbers, for which nobody has to walk around a vertex that does not split.
//!
//! Vertices made within the batch are passed over. A vertex is asked once a batch; its neighbours wait in a queue. Since
//! a vertex's own split happens after it was asked, all that was around it before the batch is found, whatever has
//! been split elsewhere.

use super::surface::{Surface, next};

/// What has become of a vertex in the current batch.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Fate {
    /// Not asked yet.
    Open,
    /// Asked; it does not split.
    Stays,
    /// Asked; it splits.
    Splits,
    /// Made in this batch.
    New,
}

/// Where a batch stands.
#[derive(Clone, Debug, Default)]
pub(super) struct Walk {
    /// For each vertex: four times the batch in which it was seen last, and what became of it.
    seen: Vec<u32>,
    batch: u32,
    queue: Vec<u32>,
    head: usize,
    /// The next vertex to begin a component with.
    seed: u32,
    /// Vertices at the beginning of the batch.
    end: u32,
    /// Whether vertices are asked breadth first, not in the order of their numbers.
    is_near: bool,
}

const QUEUED: u32 = 0;
const STAYS: u32 = 1;
const SPLITS: u32 = 2;

impl Walk {
    /// No batch yet. `is_near` says whether vertices are asked breadth first, not in the order of their numbers.
    pub(super) fn new(is_near: bool) -> Self {
        Self { is_near, ..Self::default() }
    }

    /// Begins a batch.
    pub(super) fn begin(&mut self, surface: &Surface) {
        self.batch += 1;
        self.end = surface.vertex_count() as u32;
        self.seed = surface.virtual_count();
        self.queue.clear();
        self.head = 0;
        self.seen.resize(self.end as usize, 0);
    }

    /// The surface was built anew; entry `i` is what its vertex `i` was called before, or none.
    pub(super) fn renumber(&mut self, old_of_new: &[u32]) {
        let seen = |&old: &u32| self.seen.get(old as usize).copied().unwrap_or(0);
        self.seen = old_of_new.iter().map(seen).collect();
    }

    /// The number of the batch, from 1.
    pub(super) fn batch(&self) -> u32 {
        self.batch
    }

    /// Vertices that were there when the batch began.
    pub(super) fn end(&self) -> u32 {
        self.end
    }

    /// What has become of a vertex that is not virtual.
    #[inline]
    pub(super) fn fate(&self, vertex: u32) -> Fate {
        if vertex >= self.end {
            return Fate::New;
        }
        match self.seen[vertex as usize].wrapping_sub(4 * self.batch) {
            STAYS => Fate::Stays,
            SPLITS => Fate::Splits,
            _ => Fate::Open,
        }
    }

    /// The next vertex to ask; none when all were.
    pub(super) fn next_vertex(&mut self) -> Option<u32> {
        if let Some(&vertex) = self.queue.get(self.head) {
            self.head += 1;
            return Some(vertex);
        }
        while self.seed < self.end && self.seen[self.seed as usize] >= 4 * self.batch {
            self.seed += 1;
        }
        if self.seed == self.end {
            return None;
        }
        self.seen[self.seed as usize] = 4 * self.batch + QUEUED;
        self.queue.clear();
        self.head = 0;
        self.seed += 1;
        Some(self.seed - 1)
    }

    /// Notes what became of a vertex, and queues its neighbours: the vertices after the corners around it.
    pub(super) fn settle(&mut self, surface: &Surface, vertex: u32, corners: &[u32], splits: bool) {
        self.seen[vertex as usize] = 4 * self.batch + if splits { SPLITS } else { STAYS };
        if !self.is_near {
            return;
        }
        for &corner in corners {
            let neighbour = surface.vertex(next(corner));
            if neighbour < self.end
                && !surface.is_virtual(neighbour)
                && self.seen[neighbour as usize] < 4 * self.batch
            {
                self.seen[neighbour as usize] = 4 * self.batch + QUEUED;
                self.queue.push(neighbour);
            }
        }
    }
}
