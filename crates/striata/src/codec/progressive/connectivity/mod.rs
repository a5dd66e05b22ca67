//! Which vertices split, and which triangles go to the new vertex.

mod cuts;
mod flags;
mod memory;
mod ring;
mod softmax;

use super::super::entropy::Coder;
use super::Effort;
use super::surface::{Cut, Surface};
use super::walk::Walk;
use cuts::CutModel;
use flags::FlagModel;
use memory::Memory;
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
    memory: Memory,
    ring: Ring,
    cuts: CutModel,
    flags: FlagModel,
    length: i32,
    height: i32,
    last: usize,
}

pub static STATS: std::sync::Mutex<[f64; 4]> = std::sync::Mutex::new([0.0; 4]);
pub fn stats() -> String {
    let mut s = STATS.lock().unwrap();
    let r = format!("{:?}", *s);
    *s = [0.0; 4];
    r
}

impl ConnectivityModel {
    pub(super) fn new(_effort: Effort) -> Self {
        Self {
            memory: Memory::default(),
            ring: Ring::default(),
            cuts: CutModel::new(),
            flags: FlagModel::new(),
            length: 0,
            height: 0,
            last: 0,
        }
    }

    /// Told when a batch begins; `end` is the number of vertices, all with places.
    pub(super) fn begin_batch(&mut self, surface: &Surface, _end: u32) {
        self.memory.begin_batch(surface);
    }

    /// Codes whether the vertex of `corners` (all corners around it, counter-clockwise) splits, and how.
    pub(super) fn code<C: Coder>(
        &mut self,
        coder: &mut C,
        scene: &Scene<'_>,
        corners: &[u32],
        actual: Option<Cut>,
    ) -> Option<Cut> {
        let vertex = scene.surface.vertex(corners[0]);
        self.ring.survey(scene, &self.memory, corners);
        self.cuts.score(&self.ring, self.memory.valence(vertex), scene.max_patch);
        let around = self.memory.surroundings(scene, corners);
        if self.cuts.run_count() == 0 {
            self.memory.settle(scene, corners, around, None);
            return None;
        }
        let ring = &self.ring;
        let n = corners.len();
        let taken = n - ring.free;
        let count = |fate: usize| ring.spokes.iter().filter(|s| s.fate == fate).count();
        let (open, stays, splits) = (count(0), count(1), count(2));
        let young = ring.spokes.iter().filter(|s| s.age == 1).count();
        let log_sum = self.cuts.log_sum();
        let length = ((ring.length + 512 * ring.shift - self.length) / 48 + 16).clamp(0, 31) as usize;
        let height = ((ring.height - self.height) / 128 + 16).clamp(0, 31) as usize;
        let density = (around >> 4).clamp(0, 15) as usize;
        let lse = ((log_sum >> 6) + 32).clamp(0, 63) as usize;
        let run = ring.free_run.min(7);
        let keys = [
            n.min(15) * 64 + taken.min(7) * 8 + run,
            splits.min(4) * 64 + stays.min(7) * 8 + open.min(7),
            density * 16 + n.min(15),
            length * 16 + density,
            height * 16 + density,
            self.memory.age(vertex) * 128 + self.memory.rest(vertex) * 32 + young.min(7) * 4 + splits.min(3),
            lse * 8 + run,
            lse * 16 + density,
            length * 32 + height,
            (self.last & 31) * 8 + run,
        ];
        let did = self.flags.code(coder, &keys, log_sum, [run * 4 + splits.min(3), density * 4 + taken.min(3)], actual.is_some());
        self.last = self.last << 1 | usize::from(did);
        self.length += (ring.length + 512 * ring.shift - self.length) >> 7;
        self.height += (ring.height - self.height) >> 7;
        coder.part(super::super::entropy::Part::Attributes);
        let cut = did.then(|| self.cuts.code(coder, &self.ring, corners, actual));
        coder.part(super::super::entropy::Part::Connectivity);
        self.memory.settle(scene, corners, around, cut);
        cut
    }
}
