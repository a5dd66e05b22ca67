//! Which vertices split, and which triangles go to the new vertex.

mod cuts;
mod flags;
mod memory;
mod patch;
mod ring;
mod softmax;

use super::super::entropy::{AdaptiveBit, Coder, Rate};
use super::Effort;
use super::surface::{Cut, Surface};
use super::walk::Walk;
use cuts::CutModel;
use flags::FlagModel;
use memory::{Memory, Trace};
use ring::Ring;

/// What both sides know when a vertex is asked whether it splits.
pub(super) struct Scene<'a> {
    /// The surface, with the splits of earlier stretches done. Triangles that no other split of the batch may have are
    /// marked with the batch.
    pub(super) surface: &'a Surface,
    /// Grid coordinates of all vertices but virtual ones.
    pub(super) places: &'a [[i32; 3]],
    /// What has become of other vertices in this batch.
    pub(super) walk: &'a Walk,
    /// Most triangles that a new vertex takes over.
    pub(super) max_patch: u32,
}

impl Scene<'_> {
    /// True where a triangle cannot go to a new vertex any more in this batch.
    #[inline]
    pub(super) fn is_taken(&self, triangle: u32) -> bool {
        self.surface.mark(triangle) == self.walk.batch()
    }
}

/// Adaptive models of flags and cuts.
#[derive(Clone, Debug)]
pub(super) struct ConnectivityModel {
    effort: Effort,
    memory: Memory,
    ring: Ring,
    cuts: CutModel,
    /// Flags by effort: counters alone, mixed, mixed with what the ring tells.
    counters: Vec<AdaptiveBit>,
    mixed: FlagModel<7>,
    seen: FlagModel<9>,
    /// Mean length and height of rings that were asked.
    length: i32,
    height: i32,
    /// Whether the last vertices split.
    last: usize,
}

impl ConnectivityModel {
    pub(super) fn new(effort: Effort) -> Self {
        Self {
            effort,
            memory: Memory::default(),
            ring: Ring::default(),
            cuts: CutModel::new(),
            counters: vec![AdaptiveBit::new(Rate::Steady); 1 << 13],
            mixed: FlagModel::new(),
            seen: FlagModel::new(),
            length: 0,
            height: 0,
            last: 0,
        }
    }

    /// Told when a batch begins; `end` is the number of vertices, all with places.
    pub(super) fn begin_batch(&mut self, surface: &Surface, _end: u32) {
        self.memory.begin_batch(surface);
    }

    /// Codes whether a vertex splits, and how. `corners` are filled with those around the vertex, counter-clockwise, where it
    /// splits or they are looked at.
    pub(super) fn code<C: Coder>(
        &mut self,
        coder: &mut C,
        scene: &Scene<'_>,
        (vertex, corners): (u32, &mut Vec<u32>),
        actual: Option<Cut>,
    ) -> Option<Cut> {
        let trace = self.memory.trace(vertex);
        let is_small = self.effort == Effort::Small;
        let (mut density, mut splits) = (i32::from(trace.density), false);
        let context = self.context(vertex, trace);
        let t: u32 = { static T: std::sync::OnceLock<u32> = std::sync::OnceLock::new(); *T.get_or_init(|| std::env::var("T").map_or(0, |v| v.parse().unwrap())) };
        if is_small && self.counters[context].p_one() < t {
            corners.clear();
            corners.extend(scene.surface.ring(vertex));
            splits = self.counters[context].code(coder, actual.is_some());
            if splits { self.look(scene, vertex, corners, trace); }
        } else if is_small {
            self.look(scene, vertex, corners, trace);
            density = self.ring.density;
            if self.cuts.run_count() > 0 {
                splits = self.flag_of_ring(coder, vertex, trace, actual.is_some());
                self.counters[context].update(splits);
            }
        } else if self.effort == Effort::Fast {
            splits = self.counters[context].code(coder, actual.is_some());
        } else {
            splits = self.flag_of_trace(coder, vertex, trace, actual.is_some());
        }
        self.memory.settle(vertex, density, splits);
        if !splits {
            return None;
        }
        if !is_small {
            self.look(scene, vertex, corners, trace);
        }
        // A reader of a damaged stream may find no run at all.
        if self.cuts.run_count() == 0 {
            return None;
        }
        coder.part(super::super::entropy::Part::Attributes);
        let cut = self.cuts.code(coder, &self.ring, corners, (actual, self.effort));
        coder.part(super::super::entropy::Part::Connectivity);
        let first = corners.iter().position(|&c| c == cut.first).unwrap_or(0);
        self.memory.split(vertex, &self.ring, first, cut);
        Some(cut)
    }

    /// Walks around a vertex and scores its runs.
    fn look(&mut self, scene: &Scene<'_>, vertex: u32, corners: &mut Vec<u32>, trace: Trace) {
        corners.clear();
        corners.extend(scene.surface.ring(vertex));
        self.ring.gather(scene, &self.memory, corners);
        if self.ring.free > 0 {
            self.ring.measure(scene, vertex, self.effort != Effort::Fast);
        }
        self.cuts.score(&self.ring, trace.valence.into(), scene.max_patch as usize);
    }

    /// The counter of a vertex.
    fn context(&self, vertex: u32, trace: Trace) -> usize {
        let valence = usize::from(trace.valence.clamp(3, 10) - 3);
        let free = usize::from(trace.free.min(7));
        let splits = usize::from(trace.splits.min(3));
        let age = usize::from(self.memory.age(vertex) & 3);
        let last = usize::from(trace.last_splits.min(3));
        (((valence * 8 + free) * 4 + splits) * 4 + age) * 4 + last
    }

    fn flag_of_trace<C: Coder>(&mut self, coder: &mut C, vertex: u32, trace: Trace, actual: bool) -> bool {
        let valence = i32::from(trace.valence.min(15));
        let free = i32::from(trace.free.min(7));
        let splits = i32::from(trace.splits.min(7));
        let last_splits = i32::from(trace.last_splits.min(7));
        let age = i32::from(self.memory.age(vertex) & 3);
        let rest = i32::from(trace.rest);
        let around = i32::from(trace.density >> 4);
        let (length, height) = (i32::from(trace.length), i32::from(trace.height));
        let length_key = ((length - (self.length >> 8)) / 4 + 16).clamp(0, 31);
        let height_key = ((height - (self.height >> 8)) / 10 + 16).clamp(0, 31);
        let keys = [
            valence * 64 + free * 8 + splits.min(7),
            around * 64 + last_splits * 8 + splits,
            age * 256 + rest * 64 + last_splits * 8 + free,
            length_key * 32 + height_key,
            length_key * 32 + valence.min(7) * 4 + splits.min(3),
            (self.last & 31) as i32 * 32 + free * 4 + age,
            256,
        ];
        let selectors = [(free * 4 + splits.min(3)) as usize, (around * 4 + age) as usize];
        let did = self.mixed.code(coder, &keys, selectors, actual);
        self.last = self.last << 1 | usize::from(did);
        self.length += ((length << 8) - self.length) >> 7;
        self.height += ((height << 8) - self.height) >> 7;
        did
    }

    fn flag_of_ring<C: Coder>(&mut self, coder: &mut C, vertex: u32, trace: Trace, actual: bool) -> bool {
        let ring = &self.ring;
        let n = ring.spokes.len();
        let [open, stays, splits, _] = ring.fates;
        let log_sum = self.cuts.log_sum();
        let length = ((ring.grid_length() - self.length) / 48 + 16).clamp(0, 31) as usize;
        let height = ((ring.height - self.height) / 128 + 16).clamp(0, 31) as usize;
        let around = (ring.density >> 4).clamp(0, 15) as usize;
        let sum = ((log_sum >> 6) + 32).clamp(0, 63) as usize;
        let run = ring.free_run.min(7);
        let age = usize::from(self.memory.age(vertex) & 3);
        let keys = [
            n.min(15) * 64 + (n - ring.free).min(7) * 8 + run,
            splits.min(4) * 64 + stays.min(7) * 8 + open.min(7),
            length * 16 + around,
            height * 16 + around,
            age * 128 + usize::from(trace.rest) * 32 + ring.young.min(7) * 4 + splits.min(3),
            sum * 16 + around,
            length * 32 + height,
            (self.last & 31) * 8 + run,
            0,
        ];
        let mut keys = keys.map(|key| key as i32);
        keys[8] = log_sum;
        let selectors = [run * 4 + splits.min(3), around * 4 + (n - ring.free).min(3)];
        let did = self.seen.code(coder, &keys, selectors, actual);
        self.last = self.last << 1 | usize::from(did);
        self.length += (self.ring.grid_length() - self.length) >> 7;
        self.height += (self.ring.height - self.height) >> 7;
        did
    }
}
