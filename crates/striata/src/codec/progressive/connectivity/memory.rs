//! What is remembered of each vertex from one batch to the next.

use super::super::surface::{Cut, Surface, next, previous};
use super::super::walk::Fate;
use super::Scene;

/// One vertex.
#[derive(Clone, Copy, Debug)]
struct Trace {
    /// Triangles around it once all splits known so far are done.
    valence: u8,
    /// Share of the vertices around it that split, those asked first weighing least, in 1/256.
    density: u8,
    /// Batches since it split, up to 3.
    rest: u8,
}

/// All vertices.
#[derive(Clone, Debug, Default)]
pub(super) struct Memory {
    traces: Vec<Trace>,
    /// Where the vertices made in this batch, the last one and the one before begin.
    begins: [u32; 3],
    /// Share of all vertices that split lately, in 1/65536.
    share: i32,
}

impl Memory {
    /// Told when a batch begins.
    pub(super) fn begin_batch(&mut self, surface: &Surface) {
        let count = surface.vertex_count();
        let known = self.traces.len().min(count);
        if self.traces.is_empty() {
            self.share = 8 << 10;
        }
        self.traces.truncate(count);
        for vertex in known..count {
            let valence = surface.ring(vertex as u32).take(255).count() as u8;
            self.traces.push(Trace { valence, density: 32, rest: 3 });
        }
        self.traces.iter_mut().for_each(|trace| trace.rest = (trace.rest + 1).min(3));
        self.begins = [count as u32, self.begins[0], self.begins[1]];
    }

    #[inline]
    pub(super) fn valence(&self, vertex: u32) -> usize {
        self.traces.get(vertex as usize).map_or(6, |t| t.valence as usize)
    }

    #[inline]
    pub(super) fn density(&self, vertex: u32) -> i32 {
        self.traces.get(vertex as usize).map_or(32, |t| i32::from(t.density))
    }

    #[inline]
    pub(super) fn rest(&self, vertex: u32) -> usize {
        self.traces.get(vertex as usize).map_or(3, |t| t.rest as usize)
    }

    /// 0: made in this batch, 1: in the last, 2: in the one before, 3: older.
    #[inline]
    pub(super) fn age(&self, vertex: u32) -> usize {
        self.begins.iter().filter(|&&begin| vertex < begin).count()
    }

    /// Share of vertices that split lately, in 1/65536.
    pub(super) fn share(&self) -> i32 {
        self.share
    }

    /// The share of the neighbours asked before that split, as they themselves saw it.
    #[inline]
    pub(super) fn surroundings(&self, scene: &Scene<'_>, corners: &[u32]) -> i32 {
        let (mut sum, mut count) = (0, 0);
        for &corner in corners {
            let vertex = scene.surface.vertex(next(corner));
            if !scene.surface.is_virtual(vertex)
                && matches!(scene.walk.fate(vertex), Fate::Stays | Fate::Splits)
            {
                sum += self.density(vertex);
                count += 1;
            }
        }
        if count == 0 { self.share >> 8 } else { sum / count }
    }

    /// Notes what became of a vertex.
    pub(super) fn settle(&mut self, scene: &Scene<'_>, corners: &[u32], around: i32, cut: Option<Cut>) {
        let vertex = scene.surface.vertex(corners[0]);
        let goal = if cut.is_some() { 65535 } else { 0 };
        self.share += (goal - self.share) >> 7;
        let density = around + (((goal >> 8) - around) >> 2);
        if let Some(trace) = self.traces.get_mut(vertex as usize) {
            trace.density = density.clamp(0, 255) as u8;
        }
        let Some(cut) = cut else { return };
        if let Some(trace) = self.traces.get_mut(vertex as usize) {
            trace.rest = 0;
            trace.valence = (u32::from(trace.valence) + 2).saturating_sub(cut.length).min(255) as u8;
        }
        let mut last = cut.first;
        for _ in 1..cut.length {
            last = scene.surface.swing(last);
        }
        for end in [next(cut.first), previous(last)] {
            if let Some(trace) = self.traces.get_mut(scene.surface.vertex(end) as usize) {
                trace.valence = trace.valence.saturating_add(1);
            }
        }
        let valence = (cut.length + 2).min(255) as u8;
        self.traces.push(Trace { valence, density: density as u8, rest: 3 });
    }
}
