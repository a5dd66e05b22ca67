//! State of one MTS instance: its level and current strips, and how it moves between levels.

use super::Mts;
use super::record::MtsRecord;
use crate::model::{StoredModel, StripModel};
use crate::strip::RESTART;

/// If more than this fraction of the strips (1 / divisor) is to be rebuilt, the chains of targets are
/// resolved for all vertices first.
const RESOLVE_ALL_DIVISOR: usize = 8;

/// An instance of the model: its level and its current strips. Created by
/// [`LodModel::new_state`](crate::model::LodModel::new_state).
#[derive(Clone, Debug)]
pub struct MtsState {
    split_count: usize,
    /// Bit of the arena between the records of steps `split_count - 1` and `split_count`.
    cursor: usize,
    /// Current indices of all strips; each strip has room for its full length.
    slots: Vec<u32>,
    strips: Vec<LiveStrip>,
    /// Strips to rebuild at the end of a move; kept so that no move allocates.
    touched: Vec<u32>,
    /// For every vertex, the vertex that represents it at the current level. Empty until many strips are
    /// first rebuilt together.
    representatives: Vec<u32>,
}

/// One strip of an instance.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct LiveStrip {
    /// Index of its first slot.
    first: u32,
    /// Number of current indices, including restarts between its pieces.
    length: u32,
    /// Number of changes since the full mesh.
    change: u8,
    is_touched: bool,
}

/// States are equal if they show the same strips; stale contents of unused slots do not count.
impl PartialEq for MtsState {
    fn eq(&self, other: &Self) -> bool {
        (self.split_count, self.cursor, self.slots.len())
            == (other.split_count, other.cursor, other.slots.len())
            && self.strips == other.strips
            && (0..self.strips.len()).all(|strip| self.live(strip) == other.live(strip))
    }
}

impl Eq for MtsState {}

impl MtsState {
    pub(super) fn new(model: &Mts<'_>) -> Self {
        let strip = |&first: &u32| LiveStrip { first, length: 0, change: 0, is_touched: false };
        let firsts = &model.parts.strips.firsts()[..model.strip_count()];
        let mut state = Self {
            split_count: model.parts.heads.len(),
            cursor: model.record_bits,
            slots: vec![0; model.slot_count()],
            strips: firsts.iter().map(strip).collect(),
            touched: Vec::with_capacity(model.strip_count()),
            representatives: Vec::new(),
        };
        state.recover(model);
        state
    }

    /// Returns the level that the instance shows.
    pub fn split_count(&self) -> usize {
        self.split_count
    }

    /// Number of bytes that the instance owns.
    pub fn bytes(&self) -> usize {
        4 * (self.slots.len() + self.touched.capacity() + self.representatives.capacity())
            + size_of_val(&self.strips[..])
    }

    /// Returns the current indices of a strip.
    pub(super) fn live(&self, strip: usize) -> &[u32] {
        let LiveStrip { first, length, .. } = self.strips[strip];
        &self.slots[first as usize..(first + length) as usize]
    }

    /// Rebuilds all strips at the current level.
    pub(super) fn recover(&mut self, model: &Mts<'_>) {
        self.check_model(model);
        self.touched.clear();
        self.touched.extend(0..self.strips.len() as u32);
        self.rebuild_touched(model);
    }

    fn check_model(&self, model: &Mts<'_>) {
        assert!(
            self.slots.len() == model.slot_count() && self.strips.len() == model.strip_count(),
            "the state belongs to a different model"
        );
    }

    pub(super) fn move_to(&mut self, model: &Mts<'_>, split_count: usize) {
        let step_count = model.parts.heads.len();
        assert!(split_count <= step_count, "split count {split_count} of {step_count}");
        self.check_model(model);
        while self.split_count > split_count {
            let done = self.touch_coarser(model);
            debug_assert!(done.is_some(), "a checked record ended early");
        }
        while self.split_count < split_count {
            let done = self.touch_finer(model);
            debug_assert!(done.is_some(), "a checked record ended early");
        }
        self.rebuild_touched(model);
    }

    /// Rebuilds the touched strips and clears the list.
    fn rebuild_touched(&mut self, model: &Mts<'_>) {
        let vertex_count = model.vertex_count_at(self.split_count) as u32;
        let mut touched = std::mem::take(&mut self.touched);
        let is_full = self.split_count == model.parts.heads.len();
        // Resolving chains of targets slot by slot costs more than resolving every vertex once.
        if !is_full && touched.len() > self.strips.len() / RESOLVE_ALL_DIVISOR {
            self.find_representatives(model, vertex_count);
            touched.iter().for_each(|&strip| self.rebuild_from_representatives(model, strip as usize));
        } else {
            touched.iter().for_each(|&strip| self.rebuild(model, strip as usize, vertex_count));
        }
        touched.clear();
        self.touched = touched;
    }

    /// Finds the representative of every vertex at the level. A target is older than its vertex, so it is
    /// resolved first.
    fn find_representatives(&mut self, model: &Mts<'_>, vertex_count: u32) {
        self.representatives.clear();
        self.representatives.extend(0..vertex_count);
        for vertex in vertex_count..model.vertex_count() as u32 {
            let target = model.target(vertex);
            self.representatives.push(self.representatives[target as usize]);
        }
    }

    /// Passes the record of the step before, touching the strips that it changes.
    fn touch_coarser(&mut self, model: &Mts<'_>) -> Option<()> {
        self.split_count -= 1;
        let head = model.parts.heads[self.split_count];
        let record = model.format.record_before(&model.parts.arena, self.cursor, head)?;
        self.cursor = record.start;
        self.touch(model, record, |change, drops| *change += u8::from(drops))
    }

    /// Passes the record of the next step, touching the strips that it changes.
    fn touch_finer(&mut self, model: &Mts<'_>) -> Option<()> {
        let head = model.parts.heads[self.split_count];
        let record = model.format.record_at(&model.parts.arena, self.cursor, head)?;
        self.split_count += 1;
        self.cursor = record.end;
        self.touch(model, record, |change, drops| *change -= u8::from(drops))
    }

    /// Marks the strips of a record for rebuilding; `count` updates the change count of each.
    #[inline]
    fn touch(&mut self, model: &Mts<'_>, record: MtsRecord, count: impl Fn(&mut u8, bool)) -> Option<()> {
        model.format.for_each_strip(&model.parts.arena, record, |strip, drops| {
            let live = &mut self.strips[strip as usize];
            count(&mut live.change, drops);
            if !std::mem::replace(&mut live.is_touched, true) {
                self.touched.push(strip);
            }
        })
    }

    /// Rebuilds one strip, following the chain of targets of each slot.
    fn rebuild(&mut self, model: &Mts<'_>, strip: usize, vertex_count: u32) {
        let live = &mut self.strips[strip];
        let slots = &mut self.slots[model.parts.strips.slots(strip)];
        let length = model.strip_slots(strip).recover(live.change, slots, |vertex| vertex);
        for vertex in &mut slots[..length] {
            while *vertex >= vertex_count && *vertex != RESTART {
                *vertex = model.target(*vertex);
            }
        }
        live.length = length as u32;
        live.is_touched = false;
    }

    /// Rebuilds one strip from the representatives that `find_representatives` has computed.
    fn rebuild_from_representatives(&mut self, model: &Mts<'_>, strip: usize) {
        let live = &mut self.strips[strip];
        let slots = &mut self.slots[model.parts.strips.slots(strip)];
        let shown = |vertex: u32| self.representatives[vertex as usize];
        live.length = model.strip_slots(strip).recover(live.change, slots, shown) as u32;
        live.is_touched = false;
    }
}
