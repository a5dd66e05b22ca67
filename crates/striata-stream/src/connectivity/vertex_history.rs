//! Data stored with each vertex: a summary of its ring, so that flags can be coded without visiting the ring.
//!
//! Splits are about seven times rarer than visited vertices. So each split updates all vertices around it,
//! and a visit reads only the few bytes of its vertex.

use super::ring::Ring;
use crate::topology::surface::Surface;

/// History of a vertex.
#[derive(Clone, Copy, Debug)]
pub(super) struct VertexHistory {
    /// Number of triangles around it after all splits known so far.
    pub valence: u8,
    /// Number of them that may still move to a new vertex in this batch.
    pub free: u8,
    /// Number of neighbors that split in this batch.
    pub neighbor_splits: u8,
    /// Number of batches since it last split, up to 3.
    pub since_split: u8,
    /// Share of splits among recent flags around it, in 1/256; earlier flags weigh less.
    pub density: u8,
}

impl VertexHistory {
    const NEW: Self = Self { valence: 6, free: 6, neighbor_splits: 0, since_split: 3, density: 40 };

    fn begin_batch(&mut self) {
        self.free = self.valence;
        self.neighbor_splits = 0;
        self.since_split = (self.since_split + 1).min(3);
    }
}

/// Histories of all vertices.
#[derive(Clone, Debug, Default)]
pub(super) struct VertexHistories {
    vertices: Vec<VertexHistory>,
    /// First vertex created in the current batch, in the previous one, and in the one before that.
    batch_begins: [u32; 3],
    /// Whether vertices have been renumbered, so that the triangles around each have to be counted again.
    is_renumbered: bool,
    /// Recent share of splits among all flags, in 1/65536.
    recent_share: i32,
}

impl VertexHistories {
    /// Reserves memory for `vertex_count` vertices in total.
    pub(super) fn reserve(&mut self, vertex_count: usize) {
        self.vertices.reserve_exact(vertex_count);
    }

    /// Starts a batch.
    pub(super) fn begin_batch(&mut self, surface: &Surface) {
        let count = surface.vertex_count();
        if self.vertices.is_empty() {
            self.recent_share = 8 << 10;
        }
        self.vertices.truncate(count);
        self.vertices.iter_mut().for_each(VertexHistory::begin_batch);
        let first = if std::mem::take(&mut self.is_renumbered) { 0 } else { self.vertices.len() };
        for (vertex, vertex_history) in self.vertices.iter_mut().enumerate().skip(first) {
            vertex_history.valence = surface.ring(vertex as u32).take(255).count() as u8;
            vertex_history.free = vertex_history.valence;
        }
        for vertex in self.vertices.len()..count {
            let valence = surface.ring(vertex as u32).take(255).count() as u8;
            self.vertices.push(VertexHistory { valence, free: valence, ..VertexHistory::NEW });
        }
        self.batch_begins = [count as u32, self.batch_begins[0], self.batch_begins[1]];
    }

    /// Renumbers the histories after the surface has been rebuilt; gives the old index of each vertex, or
    /// [`NONE`](crate::topology::surface::NONE) for new ones. The ages of vertices, which depend on their
    /// indices, are lost.
    pub(super) fn renumber(&mut self, old_of_new: &[u32]) {
        self.vertices = old_of_new.iter().map(|&old| self.of(old)).collect();
        self.batch_begins = [old_of_new.len() as u32; 3];
        self.is_renumbered = true;
    }

    /// Returns the history of a vertex.
    #[inline]
    pub(super) fn of(&self, vertex: u32) -> VertexHistory {
        self.vertices.get(vertex as usize).copied().unwrap_or(VertexHistory::NEW)
    }

    /// Returns the age of a vertex: 0 if it was created in this batch, 1 in the previous one, 2 in the one
    /// before, 3 earlier.
    #[inline]
    pub(super) fn age(&self, vertex: u32) -> u8 {
        self.batch_begins.map(|begin| u8::from(vertex < begin)).iter().sum()
    }

    /// Returns the recent share of splits among all flags, in 1/256.
    #[inline]
    pub(super) fn split_share(&self) -> i32 {
        self.recent_share >> 8
    }

    /// Records the flag of a vertex; `density` is the share of splits around it.
    #[inline]
    pub(super) fn record_flag(&mut self, vertex: u32, density: i32, splits: bool) {
        let target = if splits { 65535 } else { 0 };
        self.recent_share += (target - self.recent_share) >> 7;
        if let Some(vertex_history) = self.vertices.get_mut(vertex as usize) {
            vertex_history.density = (density + (((target >> 8) - density) >> 2)).clamp(0, 255) as u8;
        }
    }

    /// Records the cut of a vertex, given by the index of its first corner and its length, and updates the
    /// vertices around it.
    pub(super) fn record_split(&mut self, vertex: u32, ring: &Ring, first: usize, cut_length: usize) {
        let n = ring.spokes.len();
        for spoke in ring.spokes.iter().filter(|spoke| !spoke.is_virtual) {
            let Some(vertex_history) = self.vertices.get_mut(spoke.vertex as usize) else { continue };
            vertex_history.neighbor_splits = vertex_history.neighbor_splits.saturating_add(1);
            vertex_history.density =
                vertex_history.density.saturating_add((255 - vertex_history.density) / 4);
        }
        for k in 0..=cut_length {
            let spoke = &ring.spokes[(first + k) % n];
            let Some(vertex_history) = self.vertices.get_mut(spoke.vertex as usize) else { continue };
            if k == 0 || k == cut_length {
                vertex_history.free = vertex_history.free.saturating_sub(1);
                vertex_history.valence = vertex_history.valence.saturating_add(1);
            } else {
                vertex_history.free = vertex_history.free.saturating_sub(2);
            }
        }
        let mut density = 40;
        if let Some(vertex_history) = self.vertices.get_mut(vertex as usize) {
            vertex_history.since_split = 0;
            vertex_history.valence =
                (usize::from(vertex_history.valence) + 2).saturating_sub(cut_length).min(255) as u8;
            density = vertex_history.density;
        }
        let valence = (cut_length + 2).min(255) as u8;
        self.vertices.push(VertexHistory { valence, free: 0, density, ..VertexHistory::NEW });
    }
}
