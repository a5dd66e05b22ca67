//! Connectivity of splits: which vertices split, and which triangles move to the new vertex.
//!
//! Whether a vertex splits is predicted by mixing many small contexts: whether its neighbors split in this
//! batch and the previous ones, how many of its triangles are still free, and how long its edges and how
//! curved its surroundings are compared with the average. Which run of its triangles moves to the new
//! vertex is chosen among all possible runs by a log-linear model that learns online. If speed matters,
//! flags depend only on numbers stored with a vertex. For the smallest streams, the ring is examined
//! and its runs are scored first, since a vertex that can split well is likely to.
//!
//! | file | what it does |
//! | --- | --- |
//! | `vertex_history.rs` | [`VertexHistories`]: what is stored with each vertex from batch to batch |
//! | `quick.rs` | [`quick::QuickModel`]: flags and cuts for the fast and default efforts |
//! | `chain_cuts.rs` | cuts as sequences of binary decisions |
//! | `ranked_cuts.rs` | cuts as two symbols, by rank |
//! | `split_context.rs` | [`SplitContext`]: what both sides know when a vertex is coded |
//! | `ring.rs` | [`Ring`]: measures of a vertex's ring |
//! | `gather.rs` | gathers a ring from surface, walk and history |
//! | `patch.rs` | features of a run of triangles as a whole |
//! | `cut_model.rs` | [`CutModel`]: scores of runs, and how they are learned |
//! | `learned_cuts.rs` | a faster form of that model, for the default effort |
//! | `softmax.rs` | from scores to probabilities to decisions |
//! | `flags.rs` | [`FlagModel`]: mixes the contexts of a flag |
//!
//! All models use integers only, and depend only on what has been decoded.

mod chain_cuts;
mod cut_model;
mod flags;
mod gather;
mod learned_cuts;
mod patch;
pub(crate) mod quick;
mod ranked_cuts;
mod ring;
mod softmax;
mod split_context;
mod vertex_history;

#[cfg(test)]
mod tests;

use cut_model::{CutModel, MAX_RUN};
use flags::{FlagContext, FlagModel};

use crate::entropy::{AdaptiveBit, Coder, Rate};
use crate::topology::surface::{Cut, Surface, next, triangle_of};
use ring::Ring;
pub(crate) use split_context::SplitContext;
use vertex_history::{VertexHistories, VertexHistory};

/// Number of contexts of the prefilter, and the probability of a split, in 1/65536, below which a ring is
/// not examined.
const PREFILTER_CONTEXTS: usize = 8 * 8 * 4 * 4 * 4;
const MIN_PROBABILITY: u32 = 1500;

/// Adaptive models of flags and cuts that examine rings, for the smallest streams.
#[derive(Clone, Debug)]
pub(super) struct ConnectivityModel {
    history: VertexHistories,
    ring: Ring,
    cuts: CutModel,
    flags: FlagModel,
    prefilter: Vec<AdaptiveBit>,
    is_long: AdaptiveBit,
    /// Running means of length and height around visited vertices.
    length: i32,
    height: i32,
    /// Flags of the last visited vertices, one bit each.
    recent_flags: usize,
}

/// The vertex that is split, and the corners of its star.
pub(super) struct SplitStar<'a> {
    /// The vertex.
    pub vertex: u32,
    /// Corners of its triangles.
    pub corners: &'a [u32],
}

impl ConnectivityModel {
    pub(super) fn new() -> Self {
        Self {
            history: VertexHistories::default(),
            ring: Ring::default(),
            cuts: CutModel::new(),
            flags: FlagModel::new(),
            prefilter: vec![AdaptiveBit::new(Rate::Steady); PREFILTER_CONTEXTS],
            is_long: AdaptiveBit::new(Rate::Steady),
            length: 0,
            height: 0,
            recent_flags: 0,
        }
    }

    /// Starts a batch; all vertices have coordinates.
    pub(super) fn begin_batch(&mut self, surface: &Surface) {
        self.history.begin_batch(surface);
    }

    /// Reserves memory for `vertex_count` vertices in total.
    pub(super) fn reserve(&mut self, vertex_count: usize) {
        self.history.reserve(vertex_count);
    }

    /// Renumbers what is stored per vertex after the surface has been rebuilt; gives the old index of each
    /// vertex, or [`NONE`](crate::topology::surface::NONE) for new ones.
    pub(super) fn renumber(&mut self, old_of_new: &[u32]) {
        self.history.renumber(old_of_new);
    }

    /// Codes whether a vertex splits, and its cut if so; `corners` are those around it, counterclockwise.
    pub(super) fn code<C: Coder>(
        &mut self,
        coder: &mut C,
        split_context: &SplitContext<'_>,
        SplitStar { vertex, corners }: SplitStar<'_>,
        actual: Option<Cut>,
    ) -> Option<Cut> {
        let vertex_history = self.history.of(vertex);
        let filter = self.prefilter_context(vertex, vertex_history);
        let p_one = self.prefilter[filter].p_one();
        if p_one < MIN_PROBABILITY {
            // Too unlikely to split: the flag is coded without examining the ring.
            let splits = coder.bit(actual.is_some(), p_one);
            self.prefilter[filter].update(splits);
            self.recent_flags = self.recent_flags << 1 | usize::from(splits);
            self.history.record_flag(vertex, i32::from(vertex_history.density), splits);
            if !splits {
                return None;
            }
            self.examine(split_context, vertex, corners, vertex_history);
            return self.code_examined_cut(coder, split_context, SplitStar { vertex, corners }, actual);
        }
        self.examine(split_context, vertex, corners, vertex_history);
        let splits =
            self.cuts.run_count() > 0 && self.code_flag(coder, vertex, vertex_history, actual.is_some());
        self.prefilter[filter].update(splits);
        self.history.record_flag(vertex, self.ring.density, splits);
        splits
            .then(|| self.code_examined_cut(coder, split_context, SplitStar { vertex, corners }, actual))
            .flatten()
    }

    /// Returns the prefilter context of a vertex.
    fn prefilter_context(&self, vertex: u32, vertex_history: VertexHistory) -> usize {
        let [free, splits, since_split] =
            [vertex_history.free.min(7), vertex_history.neighbor_splits.min(3), vertex_history.since_split]
                .map(usize::from);
        let age = usize::from(self.history.age(vertex));
        (((usize::from(vertex_history.density >> 5) * 8 + free) * 4 + splits) * 4 + since_split) * 4 + age
    }

    /// Codes the cut of a vertex whose ring has been examined; returns `None` if a damaged stream splits one
    /// that cannot split.
    fn code_examined_cut<C: Coder>(
        &mut self,
        coder: &mut C,
        split_context: &SplitContext<'_>,
        SplitStar { vertex, corners }: SplitStar<'_>,
        actual: Option<Cut>,
    ) -> Option<Cut> {
        let (first, length) = self.code_run(coder, split_context, corners, actual)?;
        let cut = Cut { first: corners[first], length: length as u32 };
        self.history.record_split(vertex, &self.ring, first, length);
        Some(cut)
    }

    /// Gathers and measures the ring of a vertex, and scores its runs.
    fn examine(
        &mut self,
        split_context: &SplitContext<'_>,
        vertex: u32,
        corners: &[u32],
        vertex_history: VertexHistory,
    ) {
        self.ring.gather(split_context, &self.history, vertex, corners);
        if self.ring.free > 0 {
            self.ring.measure();
        }
        self.cuts.score(&self.ring, vertex_history.valence.into(), split_context.max_patch as usize);
    }

    /// Codes a cut as the index of its first corner and its length; returns `None` only for a damaged stream.
    fn code_run<C: Coder>(
        &mut self,
        coder: &mut C,
        split_context: &SplitContext<'_>,
        corners: &[u32],
        actual: Option<Cut>,
    ) -> Option<(usize, usize)> {
        let actual = actual.map(|cut| {
            let first = corners.iter().position(|&corner| corner == cut.first);
            debug_assert!(first.is_some(), "a cut begins with a corner of its vertex");
            (first.unwrap_or(0), cut.length as usize)
        });
        let can_be_long = (split_context.max_patch as usize).min(corners.len().saturating_sub(1)) > MAX_RUN;
        if can_be_long && self.is_long.code(coder, actual.is_some_and(|(_, length)| length > MAX_RUN)) {
            let (first, length) = actual.unwrap_or((0, 0));
            return code_long_run(coder, split_context, corners, first, length);
        }
        (self.cuts.run_count() > 0).then(|| self.cuts.code(coder, &self.ring, actual))
    }

    /// Codes whether a vertex splits from its ring.
    fn code_flag<C: Coder>(
        &mut self,
        coder: &mut C,
        vertex: u32,
        vertex_history: VertexHistory,
        actual: bool,
    ) -> bool {
        let ring = &self.ring;
        let n = ring.spokes.len();
        let claimed = n - ring.free;
        let [open, stays, splits, _] = ring.states;
        let log_sum = self.cuts.log_sum();
        let sum_step = ((log_sum >> 6) + 32).clamp(0, 63) as usize;
        let length_step = ((ring.grid_length() - self.length) / 48 + 16).clamp(0, 31) as usize;
        let height_step = ((ring.height - self.height) / 128 + 16).clamp(0, 31) as usize;
        self.length += (ring.grid_length() - self.length) >> 7;
        self.height += (ring.height - self.height) >> 7;
        let around = (ring.density >> 4).clamp(0, 15) as usize;
        let run = ring.free_run.min(7);
        let age = usize::from(self.history.age(vertex));
        let context = FlagContext {
            contexts: [
                n.min(15) * 64 + claimed.min(7) * 8 + run,
                splits.min(4) * 64 + stays.min(7) * 8 + open.min(7),
                length_step * 16 + around,
                height_step * 16 + around,
                age * 128
                    + usize::from(vertex_history.since_split) * 32
                    + ring.young.min(7) * 4
                    + splits.min(3),
                sum_step * 16 + around,
                length_step * 32 + height_step,
                (self.recent_flags & 31) * 8 + run,
            ],
            log_odds: log_sum,
            weight_set: run * 4 + splits.min(3),
            map_context: around * 4 + claimed.min(3),
        };
        let splits_now = self.flags.code(coder, &context, actual);
        self.recent_flags = self.recent_flags << 1 | usize::from(splits_now);
        splits_now
    }
}

/// Codes a run that is too long for the cut model: rare, and only if the encoder was given such steps.
fn code_long_run<C: Coder>(
    coder: &mut C,
    split_context: &SplitContext<'_>,
    corners: &[u32],
    first: usize,
    length: usize,
) -> Option<(usize, usize)> {
    let n = corners.len();
    let bits = (usize::BITS - n.leading_zeros()).min(24);
    let first = (coder.raw(first as u32, bits) as usize).min(n - 1);
    let length = (coder.raw(length as u32, bits) as usize).min(n - 1).min(split_context.max_patch as usize);
    // A run ends where the free triangles end.
    let is_free = |k: &usize| {
        let corner = corners[(first + k) % n];
        let is_outside = split_context.surface.is_virtual(split_context.surface.vertex(next(corner)));
        !split_context.is_claimed(triangle_of(corner)) && (*k == 0 || !is_outside)
    };
    let length = (0..length).take_while(is_free).count();
    (length > 0).then_some((first, length))
}
