//! What is remembered of each vertex: what its ring would tell, without walking around it.
//!
//! Splits are some seven times rarer than vertices that are asked. So each split tells all around it, and a vertex that is
//! asked has a few bytes to look at.

use super::ring::Ring;
use crate::topology::surface::Surface;

/// One vertex.
#[derive(Clone, Copy, Debug)]
pub(super) struct Trace {
    /// Triangles around it once all splits known so far are done.
    pub(super) valence: u8,
    /// Those of them that may go to a new vertex in this batch.
    pub(super) free: u8,
    /// Neighbors that split in this batch, and in the last one.
    pub(super) splits: u8,
    /// See [`Self::splits`].
    pub(super) last_splits: u8,
    /// Batches since it split, up to 3.
    pub(super) rest: u8,
    /// Share of the vertices around it that split, those asked first weighing least, in 1/256.
    pub(super) density: u8,
    /// Lengths and heights around it when they were seen last, in 1/16 of a doubling of their squares.
    pub(super) length: u8,
    /// See [`Self::length`].
    pub(super) height: u8,
}

impl Trace {
    const NEW: Self =
        Self { valence: 6, free: 6, splits: 0, last_splits: 0, rest: 3, density: 40, length: 0, height: 0 };

    fn begin_batch(&mut self) {
        self.free = self.valence;
        self.last_splits = self.splits;
        self.splits = 0;
        self.rest = (self.rest + 1).min(3);
    }
}

/// All vertices.
#[derive(Clone, Debug, Default)]
pub(super) struct Memory {
    traces: Vec<Trace>,
    /// Where the vertices made in this batch, the last one and the one before begin.
    begins: [u32; 3],
    /// How many triangles lie around each vertex has to be counted again.
    is_renumbered: bool,
    /// Share of all vertices that split lately, in 1/65536.
    share: i32,
}

/// Logarithms as bytes.
#[inline]
fn byte(logarithm: i32) -> u8 {
    ((logarithm + 512) >> 4).clamp(0, 255) as u8
}

#[inline]
fn middle(a: u8, b: u8) -> u8 {
    (u16::from(a) + u16::from(b)).div_ceil(2) as u8
}

impl Memory {
    /// Makes room for so many vertices in all.
    pub(super) fn reserve(&mut self, vertex_count: usize) {
        self.traces.reserve_exact(vertex_count);
    }

    /// Told when a batch begins.
    pub(super) fn begin_batch(&mut self, surface: &Surface) {
        let count = surface.vertex_count();
        if self.traces.is_empty() {
            self.share = 8 << 10;
        }
        self.traces.truncate(count);
        self.traces.iter_mut().for_each(Trace::begin_batch);
        let first = if std::mem::take(&mut self.is_renumbered) { 0 } else { self.traces.len() };
        for (vertex, trace) in self.traces.iter_mut().enumerate().skip(first) {
            trace.valence = surface.ring(vertex as u32).take(255).count() as u8;
            trace.free = trace.valence;
        }
        for vertex in self.traces.len()..count {
            let valence = surface.ring(vertex as u32).take(255).count() as u8;
            self.traces.push(Trace { valence, free: valence, ..Trace::NEW });
        }
        self.begins = [count as u32, self.begins[0], self.begins[1]];
    }

    /// The surface has been built anew between two batches: here is the old number of each vertex, or
    /// [`NONE`](crate::topology::surface::NONE). How old vertices are is forgotten: that is told by their numbers.
    pub(super) fn renumber(&mut self, old_of_new: &[u32]) {
        self.traces = old_of_new.iter().map(|&old| self.trace(old)).collect();
        self.begins = [old_of_new.len() as u32; 3];
        self.is_renumbered = true;
    }

    /// What is remembered of a vertex.
    #[inline]
    pub(super) fn trace(&self, vertex: u32) -> Trace {
        self.traces.get(vertex as usize).copied().unwrap_or(Trace::NEW)
    }

    /// 0: made in this batch, 1: in the last, 2: in the one before, 3: older.
    #[inline]
    pub(super) fn age(&self, vertex: u32) -> u8 {
        self.begins.map(|begin| u8::from(vertex < begin)).iter().sum()
    }

    /// Share of vertices that split lately, in 1/256.
    #[inline]
    pub(super) fn share(&self) -> i32 {
        self.share >> 8
    }

    /// Notes whether a vertex splits whose neighbors saw so many splits.
    #[inline]
    pub(super) fn settle(&mut self, vertex: u32, around: i32, splits: bool) {
        let goal = if splits { 65535 } else { 0 };
        self.share += (goal - self.share) >> 7;
        if let Some(trace) = self.traces.get_mut(vertex as usize) {
            trace.density = (around + (((goal >> 8) - around) >> 2)).clamp(0, 255) as u8;
        }
    }

    /// Notes how a vertex splits, by the index of the cut's first corner and its length, and tells all around it.
    pub(super) fn split(&mut self, vertex: u32, ring: &Ring, (first, cut_length): (usize, usize)) {
        let n = ring.spokes.len();
        let (length, height) = (byte(ring.grid_length()), byte(ring.height));
        for spoke in ring.spokes.iter().filter(|spoke| !spoke.is_virtual) {
            let Some(trace) = self.traces.get_mut(spoke.vertex as usize) else { continue };
            trace.splits = trace.splits.saturating_add(1);
            trace.density = trace.density.saturating_add((255 - trace.density) / 4);
            trace.length = if trace.length == 0 { length } else { middle(trace.length, length) };
            trace.height = if trace.height == 0 { height } else { middle(trace.height, height) };
        }
        for k in 0..=cut_length {
            let spoke = &ring.spokes[(first + k) % n];
            let Some(trace) = self.traces.get_mut(spoke.vertex as usize) else { continue };
            if k == 0 || k == cut_length {
                trace.free = trace.free.saturating_sub(1);
                trace.valence = trace.valence.saturating_add(1);
            } else {
                trace.free = trace.free.saturating_sub(2);
            }
        }
        let mut density = 40;
        if let Some(trace) = self.traces.get_mut(vertex as usize) {
            trace.rest = 0;
            trace.valence = (usize::from(trace.valence) + 2).saturating_sub(cut_length).min(255) as u8;
            (trace.length, trace.height) = (length, height);
            density = trace.density;
        }
        let valence = (cut_length + 2).min(255) as u8;
        self.traces.push(Trace { valence, free: 0, density, length, height, ..Trace::NEW });
    }
}
