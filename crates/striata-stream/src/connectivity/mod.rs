//! Which vertices split, and which triangles go to the new vertex.
//!
//! Whether a vertex splits is mixed from many small contexts: what became of its neighbors in this batch and the last ones,
//! how many of its triangles are left, how long its edges are and how bent it is against the others. Which run of its triangles
//! goes to the new vertex is chosen among all that can, by a log-linear model that learns as it goes. Where
//! time matters more, a vertex that does not split is told by what is remembered of it; for the smallest streams its ring is
//! looked at and its runs are scored, since a vertex that can split well is likely to.
//!
//! | file | what it does |
//! | --- | --- |
//! | `memory.rs` | [`Memory`]: what is kept with a vertex from batch to batch |
//! | `quick.rs` | [`quick::QuickModel`]: flags and cuts where time matters most |
//! | `chain_cuts.rs` | cuts as chains of decisions |
//! | `quick_cuts.rs` | cuts as two symbols |
//! | `scene.rs` | [`Scene`]: what both sides know when a vertex is asked |
//! | `ring.rs` | [`Ring`]: what is measured around a vertex |
//! | `gather.rs` | who is around it |
//! | `patch.rs` | what is seen of a run of triangles as a whole |
//! | `cuts.rs` | [`CutModel`]: scores of runs, and how they are learned |
//! | `learned.rs` | [`LearnedCuts`]: the same in less time, for effort default of the second version |
//! | `softmax.rs` | from scores to probabilities to decisions |
//! | `flags.rs` | [`FlagModel`]: contexts, mixed |
//!
//! All models hold integers, and look only at what has been decoded.

mod chain_cuts;
mod cuts;
mod flags;
mod gather;
mod learned;
mod memory;
mod patch;
pub(crate) mod quick;
mod quick_cuts;
mod ring;
mod scene;
mod softmax;

#[cfg(test)]
mod tests;

use cuts::{CutModel, LONGEST};
use flags::{FlagModel, Question};

use crate::entropy::{AdaptiveBit, Coder, Rate};
use crate::format::form::Effort;
use crate::topology::surface::{Cut, Surface, next, triangle_of};
use memory::{Memory, Trace};
use ring::Ring;
pub(crate) use scene::Scene;

/// Contexts of flags that are read off what is remembered, and off the ring; one more input is no context.
const REMEMBERED: usize = 7;
const SEEN: usize = 9;

/// Contexts of whether a vertex is worth a look, and the probability, in 1/65536, of a split below which it is not.
const GATES: usize = 8 * 8 * 4 * 4 * 4;
const HARDLY: u32 = 1500;

/// Adaptive models of flags and cuts.
#[derive(Clone, Debug)]
pub(super) struct ConnectivityModel {
    /// Every ring is looked at, and runs are judged as wholes.
    is_thorough: bool,
    memory: Memory,
    ring: Ring,
    cuts: CutModel,
    remembered: FlagModel<REMEMBERED>,
    seen: FlagModel<SEEN>,
    gates: Vec<AdaptiveBit>,
    is_long: AdaptiveBit,
    /// Mean length and height around vertices that were asked, on the scale of what is looked at.
    length: i32,
    height: i32,
    /// Whether the last vertices split, a bit each.
    history: usize,
}

impl ConnectivityModel {
    pub(super) fn new(effort: Effort) -> Self {
        Self {
            is_thorough: effort == Effort::Small,
            memory: Memory::default(),
            ring: Ring::default(),
            cuts: CutModel::new(),
            remembered: FlagModel::new(),
            seen: FlagModel::new(),
            gates: vec![AdaptiveBit::new(Rate::Steady); GATES],
            is_long: AdaptiveBit::new(Rate::Steady),
            length: 0,
            height: 0,
            history: 0,
        }
    }

    /// A batch begins; all vertices have places.
    pub(super) fn begin_batch(&mut self, surface: &Surface) {
        self.memory.begin_batch(surface);
    }

    /// Makes room for so many vertices in all.
    pub(super) fn reserve(&mut self, vertex_count: usize) {
        self.memory.reserve(vertex_count);
    }

    /// The surface has been built anew between two batches: here is the old number of each vertex, or
    /// [`NONE`](crate::topology::surface::NONE).
    pub(super) fn renumber(&mut self, old_of_new: &[u32]) {
        self.memory.renumber(old_of_new);
    }

    /// Whether every ring is looked at: then [`code`](Self::code) tells all of a vertex at once; else flags come first,
    /// by [`flag`](Self::flag), and [`cut`](Self::cut) tells how those vertices split.
    pub(super) fn is_thorough(&self) -> bool {
        self.is_thorough
    }

    /// Codes whether a vertex splits, and how; `corners` are those around it, counter-clockwise.
    pub(super) fn code<C: Coder>(
        &mut self,
        coder: &mut C,
        scene: &Scene<'_>,
        (vertex, corners): (u32, &[u32]),
        actual: Option<Cut>,
    ) -> Option<Cut> {
        let trace = self.memory.trace(vertex);
        let gate = self.gate_of(vertex, trace);
        let p_one = self.gates[gate].p_one();
        if p_one < HARDLY {
            // Not worth a look.
            let splits = coder.bit(actual.is_some(), p_one);
            self.gates[gate].update(splits);
            self.history = self.history << 1 | usize::from(splits);
            self.memory.settle(vertex, i32::from(trace.density), splits);
            return if splits { self.cut(coder, scene, (vertex, corners), actual) } else { None };
        }
        self.look(scene, vertex, corners, trace);
        let splits = self.cuts.run_count() > 0 && self.flag_seen(coder, vertex, trace, actual.is_some());
        self.gates[gate].update(splits);
        self.memory.settle(vertex, self.ring.density, splits);
        splits.then(|| self.told(coder, scene, (vertex, corners), actual)).flatten()
    }

    /// Codes whether a vertex splits by what is remembered of it.
    pub(super) fn flag<C: Coder>(&mut self, coder: &mut C, vertex: u32, actual: bool) -> bool {
        let trace = self.memory.trace(vertex);
        let splits = self.flag_remembered(coder, vertex, trace, actual);
        self.memory.settle(vertex, i32::from(trace.density), splits);
        splits
    }

    /// The context of whether a vertex is worth a look.
    fn gate_of(&self, vertex: u32, trace: Trace) -> usize {
        let [free, splits, rest] = [trace.free.min(7), trace.splits.min(3), trace.rest].map(usize::from);
        let age = usize::from(self.memory.age(vertex));
        (((usize::from(trace.density >> 5) * 8 + free) * 4 + splits) * 4 + rest) * 4 + age
    }

    /// Codes how a vertex splits that is said to; none where a damaged stream says so of one that cannot.
    pub(super) fn cut<C: Coder>(
        &mut self,
        coder: &mut C,
        scene: &Scene<'_>,
        (vertex, corners): (u32, &[u32]),
        actual: Option<Cut>,
    ) -> Option<Cut> {
        self.look(scene, vertex, corners, self.memory.trace(vertex));
        self.told(coder, scene, (vertex, corners), actual)
    }

    /// Codes how a vertex splits that has been looked at.
    fn told<C: Coder>(
        &mut self,
        coder: &mut C,
        scene: &Scene<'_>,
        (vertex, corners): (u32, &[u32]),
        actual: Option<Cut>,
    ) -> Option<Cut> {
        let (first, length) = self.run(coder, scene, corners, actual)?;
        let cut = Cut { first: corners[first], length: length as u32 };
        self.memory.split(vertex, &self.ring, (first, length));
        Some(cut)
    }

    /// Looks around a vertex and scores its runs.
    fn look(&mut self, scene: &Scene<'_>, vertex: u32, corners: &[u32], trace: Trace) {
        self.ring.gather(scene, &self.memory, (vertex, corners));
        if self.ring.free > 0 {
            self.ring.measure();
        }
        self.cuts.score(&self.ring, trace.valence.into(), scene.max_patch as usize);
    }

    /// Codes the first corner, by index, and the length of a cut; a reader of a damaged stream may find none.
    fn run<C: Coder>(
        &mut self,
        coder: &mut C,
        scene: &Scene<'_>,
        corners: &[u32],
        actual: Option<Cut>,
    ) -> Option<(usize, usize)> {
        let actual = actual.map(|cut| {
            let first = corners.iter().position(|&corner| corner == cut.first);
            debug_assert!(first.is_some(), "a cut begins with a corner of its vertex");
            (first.unwrap_or(0), cut.length as usize)
        });
        let may_be_long = (scene.max_patch as usize).min(corners.len().saturating_sub(1)) > LONGEST;
        if may_be_long && self.is_long.code(coder, actual.is_some_and(|(_, length)| length > LONGEST)) {
            return long_run(coder, scene, corners, actual.unwrap_or((0, 0)));
        }
        (self.cuts.run_count() > 0).then(|| self.cuts.code(coder, &self.ring, actual, self.is_thorough))
    }

    /// Codes whether a vertex splits by what is remembered of it.
    fn flag_remembered<C: Coder>(&mut self, coder: &mut C, vertex: u32, trace: Trace, actual: bool) -> bool {
        let [valence, free, splits, last_splits, rest] = [
            trace.valence.min(15),
            trace.free.min(7),
            trace.splits.min(7),
            trace.last_splits.min(7),
            trace.rest,
        ]
        .map(usize::from);
        let age = usize::from(self.memory.age(vertex));
        let around = usize::from(trace.density >> 4);
        let [length, height] = [trace.length, trace.height].map(i32::from);
        let length_step = ((length - (self.length >> 8)) / 4 + 16).clamp(0, 31) as usize;
        let height_step = ((height - (self.height >> 8)) / 10 + 16).clamp(0, 31) as usize;
        self.length += ((length << 8) - self.length) >> 7;
        self.height += ((height << 8) - self.height) >> 7;
        let question = Question {
            contexts: [
                valence * 64 + free * 8 + splits,
                around * 64 + last_splits * 8 + splits,
                age * 256 + rest * 64 + last_splits * 8 + free,
                length_step * 32 + height_step,
                length_step * 32 + valence.min(7) * 4 + splits.min(3),
                (self.history & 31) * 32 + free * 4 + age,
                0,
            ],
            log_odds: 256,
            weights: free * 4 + splits.min(3),
            refined: around * 4 + age,
        };
        let does = self.remembered.code(coder, &question, actual);
        self.history = self.history << 1 | usize::from(does);
        does
    }

    /// Codes whether a vertex splits by what is seen around it.
    fn flag_seen<C: Coder>(&mut self, coder: &mut C, vertex: u32, trace: Trace, actual: bool) -> bool {
        let ring = &self.ring;
        let n = ring.spokes.len();
        let taken = n - ring.free;
        let [open, stays, splits, _] = ring.fates;
        let log_sum = self.cuts.log_sum();
        let sum_step = ((log_sum >> 6) + 32).clamp(0, 63) as usize;
        let length_step = ((ring.grid_length() - self.length) / 48 + 16).clamp(0, 31) as usize;
        let height_step = ((ring.height - self.height) / 128 + 16).clamp(0, 31) as usize;
        self.length += (ring.grid_length() - self.length) >> 7;
        self.height += (ring.height - self.height) >> 7;
        let around = (ring.density >> 4).clamp(0, 15) as usize;
        let run = ring.free_run.min(7);
        let age = usize::from(self.memory.age(vertex));
        let question = Question {
            contexts: [
                n.min(15) * 64 + taken.min(7) * 8 + run,
                splits.min(4) * 64 + stays.min(7) * 8 + open.min(7),
                length_step * 16 + around,
                height_step * 16 + around,
                age * 128 + usize::from(trace.rest) * 32 + ring.young.min(7) * 4 + splits.min(3),
                sum_step * 16 + around,
                length_step * 32 + height_step,
                (self.history & 31) * 8 + run,
                0,
            ],
            log_odds: log_sum,
            weights: run * 4 + splits.min(3),
            refined: around * 4 + taken.min(3),
        };
        let does = self.seen.code(coder, &question, actual);
        self.history = self.history << 1 | usize::from(does);
        does
    }
}

/// Codes a run of more triangles than the model of cuts knows: rare, and only where the encoder was given such steps.
fn long_run<C: Coder>(
    coder: &mut C,
    scene: &Scene<'_>,
    corners: &[u32],
    (first, length): (usize, usize),
) -> Option<(usize, usize)> {
    let n = corners.len();
    let bits = (usize::BITS - n.leading_zeros()).min(24);
    let first = (coder.raw(first as u32, bits) as usize).min(n - 1);
    let length = (coder.raw(length as u32, bits) as usize).min(n - 1).min(scene.max_patch as usize);
    // A run ends at the latest where the vertex has no free triangle more.
    let is_free = |k: &usize| {
        let corner = corners[(first + k) % n];
        let is_outside = scene.surface.is_virtual(scene.surface.vertex(next(corner)));
        !scene.is_taken(triangle_of(corner)) && (*k == 0 || !is_outside)
    };
    let length = (0..length).take_while(is_free).count();
    (length > 0).then_some((first, length))
}
