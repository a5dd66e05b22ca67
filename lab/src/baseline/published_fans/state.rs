//! An instance: one bit per vertex that can be simplified, and the published operations on it.

use striata::model::StepBits;

use super::{NONE, PublishedFans};

/// The set of simplified vertices (`I` in the paper).
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PublishedFansState {
    simplified: StepBits,
    step_count: u32,
}

/// A run of arcs of a ring: a triangle fan.
#[derive(Clone, Copy, Debug)]
pub(super) struct FanRun {
    /// First node.
    first: usize,
    /// Number of nodes, one more than triangles; the ring is cyclic.
    pub count: usize,
}

/// The bits of a mask of up to 255 arcs.
type Mask = [u8; 32];

impl PublishedFansState {
    pub(super) fn full(model: &PublishedFans) -> Self {
        Self { simplified: StepBits::none(model.step_count), step_count: model.step_count as u32 }
    }

    /// Creates an instance that shows the base.
    pub fn base(model: &PublishedFans) -> Self {
        let mut state = Self::full(model);
        state.set_level(0);
        state
    }

    pub(super) fn set_level(&mut self, split_count: usize) {
        for step in 0..self.step_count {
            if (step as usize) < split_count {
                self.simplified.remove(step);
            } else {
                self.simplified.insert(step);
            }
        }
    }

    /// Whether the vertex of a step is shown.
    ///
    /// # Panics
    /// If the step does not exist.
    #[inline]
    pub fn is_refined(&self, step: u32) -> bool {
        !self.simplified.has(step)
    }

    /// Number of vertices shown in addition to those of the base.
    pub fn split_count(&self) -> usize {
        (0..self.step_count).filter(|&step| self.is_refined(step)).count()
    }

    /// Bytes owned by the instance.
    pub fn bytes(&self) -> usize {
        8 * (self.step_count as usize).div_ceil(64)
    }

    /// Simplifies the vertex of a step and all that depend on it (`SimplificaVertex`). Returns their number.
    ///
    /// # Panics
    /// If the step does not exist, or the state belongs to another model.
    pub fn simplify(&mut self, model: &PublishedFans, step: u32) -> usize {
        let mut waiting = vec![step];
        let mut count = 0;
        while let Some(step) = waiting.pop() {
            if !self.is_refined(step) {
                continue;
            }
            self.simplified.insert(step);
            count += 1;
            let dependencies = model.dependencies(model.base_vertex_count + step);
            waiting.extend(dependencies.iter().map(|d| d.step).filter(|&finer| finer != NONE));
        }
        count
    }

    /// Inserts the vertex of a step and all that it needs (`InsertaVertex`). Returns their number.
    ///
    /// # Panics
    /// If the step does not exist, or the state belongs to another model.
    pub fn insert(&mut self, model: &PublishedFans, step: u32) -> usize {
        let mut waiting = vec![step];
        let mut count = 0;
        while let Some(step) = waiting.pop() {
            if self.is_refined(step) {
                continue;
            }
            self.simplified.remove(step);
            count += 1;
            let vertex = model.base_vertex_count + step;
            let (ring, mask) = (model.ring(vertex), self.mask(model, vertex));
            for arc in (0..ring.len()).filter(|arc| mask[arc / 8] >> (arc % 8) & 1 != 0) {
                let nodes = [ring[arc], ring[(arc + 1) % ring.len()]];
                waiting.extend(nodes.into_iter().filter_map(|node| model.step_of(node)));
            }
        }
        count
    }

    /// Whether everything that depends on a vertex is simplified.
    pub(super) fn is_free(&self, model: &PublishedFans, step: u32) -> bool {
        let mut dependencies = model.dependencies(model.base_vertex_count + step).iter();
        dependencies.all(|d| d.step == NONE || !self.is_refined(d.step))
    }

    /// Arcs of a vertex whose triangles are shown while it is.
    #[inline]
    fn mask(&self, model: &PublishedFans, vertex: u32) -> Mask {
        let byte_count = model.ring(vertex).len().div_ceil(8);
        let mut all = [0; 32];
        for &dependency in model.dependencies(vertex) {
            if dependency.step == NONE || !self.is_refined(dependency.step) {
                let mask = model.mask(dependency, byte_count);
                all.iter_mut().zip(mask).for_each(|(all, mask)| *all |= mask);
            }
        }
        all
    }

    /// Visits the fans of all vertices that are shown (`glDrawSelectivePF`).
    pub(super) fn for_each_run(&self, model: &PublishedFans, mut visit: impl FnMut(u32, FanRun)) {
        for vertex in 0..model.vertex_count() as u32 {
            if model.step_of(vertex).is_some_and(|step| !self.is_refined(step)) {
                continue;
            }
            let (arc_count, mask) = (model.ring(vertex).len(), self.mask(model, vertex));
            let is_set = |arc: usize| mask[arc / 8] >> (arc % 8) & 1 != 0;
            let mut arc = 0;
            while arc < arc_count {
                if !is_set(arc) {
                    arc += 1;
                    continue;
                }
                let first = arc;
                while arc < arc_count && is_set(arc) {
                    arc += 1;
                }
                visit(vertex, FanRun { first, count: arc - first + 1 });
            }
        }
    }

    /// Appends the triangles of all fans (`glDrawFanL`).
    pub fn triangles_into(&self, model: &PublishedFans, out: &mut Vec<u32>) {
        self.for_each_run(model, |vertex, run| {
            let ring = model.ring(vertex);
            let node = |i: usize| ring[(run.first + i) % ring.len()];
            for i in 1..run.count {
                out.extend_from_slice(&[vertex, node(i - 1), node(i)]);
            }
        });
    }
}
