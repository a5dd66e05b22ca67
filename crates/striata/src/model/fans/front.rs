//! An instance that follows a view from frame to frame and re-evaluates only steps whose verdict may have
//! changed.
//!
//! The list of candidates contains the children of all wanted steps: the wanted steps themselves, and the
//! unwanted ones directly below them in the tree. A verdict states for how much camera motion it remains
//! valid. That margin is compared with the accumulated motion, so most steps are not evaluated for many
//! frames. Wanted steps are split together with everything that they need. An unwanted step is collapsed once
//! no active step needs it; whenever such a step is collapsed, those that it needed are reconsidered. The
//! instance therefore always shows what is wanted and what that needs, regardless of the path that led there
//! \[Hop97\].
//!
//! Differs: \[Hop97\] maintains the active mesh with its adjacency; here the table provides it. In
//! addition to its instance, a front stores three bits per step, and twelve bytes per step in the list.

use wide::f32x8;

use super::{FanInstance, FanScene, Fans};
use crate::model::step_bits::StepBits;
use crate::view::{Criterion, Part, Verdict};

/// Parent of the children of the base.
const BASE: u32 = u32::MAX;

/// Number of views after which the accumulated motion is rebased to zero.
const VIEWS_PER_SUM: u32 = 256;

/// The accumulated motion is also rebased when it exceeds this multiple of the last motion: after a jump,
/// small validity spans would be lost to rounding.
const MAX_MOTION_RATIO: f64 = 1e4;

/// Number of list entries that are tested together for being due.
const DUE_BLOCK: usize = 8;

/// Number of steps evaluated per batch, which takes a few hundred CPU cycles.
const BATCH_SIZE: usize = 32;

/// Verdicts are re-evaluated early by this fraction of their validity span, as a safety margin.
const SLACK: f32 = 1e-4;

/// An instance that follows a view at a cost proportional to what changes; `C` is the type of the view
/// criterion.
#[derive(Clone, Debug)]
pub struct FanFront<C> {
    pub(super) instance: FanInstance,
    pub(super) triangle_count: usize,
    /// Steps that were wanted by their last verdict.
    pub(super) wanted: StepBits,
    /// Steps that are in the list.
    known: StepBits,
    /// The list, as parallel arrays: the steps, their parents, and the accumulated motion up to which
    /// their verdicts are valid.
    pub(super) steps: Vec<u32>,
    parents: Vec<u32>,
    due: Vec<f32>,
    elapsed: f64,
    view_count: u32,
    last: Option<C>,
    /// Steps that are wanted but still collapsed.
    pending_splits: Vec<u32>,
    /// Refined steps that may no longer be wanted or needed.
    pub(super) unneeded: StepBits,
    split_steps: Vec<u32>,
    /// Indices of list entries that are to be removed, ascending.
    stale: Vec<u32>,
    batch: Batch,
}

/// Summary of what an update changed.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct FanUpdate {
    /// Number of steps whose weight was evaluated.
    pub evaluated_count: usize,
    /// Number of steps that were split.
    pub split_count: usize,
    /// Number of steps that were collapsed.
    pub collapse_count: usize,
    /// Whether nothing is left to do for this view.
    pub is_complete: bool,
    /// Weight above which parts are refined: 1, or more if a triangle budget required it.
    pub threshold: f32,
}

impl<C: Criterion + Clone> FanFront<C> {
    /// Creates a front that shows the base mesh.
    pub fn new(scene: &FanScene<'_>) -> Self {
        let fans = scene.fans;
        let step_count = fans.step_count;
        let mut front = Self {
            instance: FanInstance::uniform(fans, 0),
            triangle_count: fans.base_triangle_count(),
            wanted: StepBits::none(step_count),
            known: StepBits::none(step_count),
            steps: Vec::new(),
            parents: Vec::new(),
            due: Vec::new(),
            elapsed: 0.0,
            view_count: 0,
            last: None,
            pending_splits: Vec::new(),
            unneeded: StepBits::none(step_count),
            split_steps: Vec::new(),
            stale: Vec::new(),
            batch: Batch::default(),
        };
        front.list_children(fans, BASE);
        front
    }

    /// Returns the instance that is shown.
    pub fn instance(&self) -> &FanInstance {
        &self.instance
    }

    /// Number of triangles shown.
    pub fn triangle_count(&self) -> usize {
        self.triangle_count
    }

    /// Number of bytes owned by the front and its instance.
    pub fn bytes(&self) -> usize {
        let bits = self.instance.bytes() + self.wanted.bytes() + self.known.bytes() + self.unneeded.bytes();
        let words = [&self.steps, &self.parents, &self.pending_splits, &self.split_steps, &self.stale];
        let words = words.iter().map(|list| list.capacity()).sum::<usize>() + self.due.capacity();
        bits + 4 * words + self.batch.bytes()
    }

    /// Moves to what a criterion wants and what that needs. At most `change_limit` steps change; the
    /// remaining ones follow in later updates, even with an unchanged criterion. Use `usize::MAX` for no
    /// limit.
    ///
    /// # Panics
    /// If the front belongs to a different model.
    pub fn update(&mut self, scene: &FanScene<'_>, criterion: &C, change_limit: usize) -> FanUpdate {
        let motion = self.last.as_ref().map_or(f32::INFINITY, |last| criterion.motion_since(last));
        self.last = Some(criterion.clone());
        self.move_by(motion);
        let mut update = self.begin(scene, 1.0);
        self.pending_splits.retain(|&step| self.wanted.has(step) && !self.instance.is_refined(step));
        let is_whole = self.split_pending(scene.fans, change_limit, &mut update);
        let elapsed = (self.elapsed as f32).next_up();
        let mut at = 0;
        while self.gather_due(scene, elapsed, &mut at) {
            update.evaluated_count += self.batch.parts.len();
            let mut batch = std::mem::take(&mut self.batch);
            batch.verdicts.clear();
            criterion.weigh_all(&batch.parts, &mut batch.verdicts);
            for (&at, verdict) in batch.entries.iter().zip(&batch.verdicts) {
                let step = self.steps[at as usize];
                // A NaN validity span becomes 0, so the step is evaluated again in the next update.
                self.due[at as usize] = self.due_after(verdict.motion_margin.max(0.0));
                let was_wanted = self.wanted.has(step);
                self.set_wanted(scene.fans, step, verdict.should_refine());
                // A step that was wanted before is already waiting.
                if verdict.should_refine() && !was_wanted && !self.instance.is_refined(step) {
                    self.pending_splits.push(step);
                    if is_whole {
                        self.split_pending(scene.fans, change_limit, &mut update);
                    }
                }
            }
            self.batch = batch;
        }
        self.drop_stale();
        if self.pending_splits.is_empty() || update.changes() < change_limit {
            self.collapse_unneeded(scene.fans, change_limit, &mut update);
        }
        update.is_complete = self.pending_splits.is_empty()
            && self.unneeded.last_before(self.instance.step_count as u32).is_none();
        update
    }
}

/// A batch of steps that are evaluated together.
#[derive(Clone, Debug, Default)]
struct Batch {
    /// Indices in the list.
    entries: Vec<u32>,
    parts: Vec<Part>,
    verdicts: Vec<Verdict>,
}

impl Batch {
    fn bytes(&self) -> usize {
        4 * self.entries.capacity()
            + size_of::<Part>() * self.parts.capacity()
            + size_of::<Verdict>() * self.verdicts.capacity()
    }
}

impl<C> FanFront<C> {
    /// Invalidates all verdicts, and removes stale entries from the list.
    pub(super) fn forget_views(&mut self) {
        self.last = None;
        self.move_by(f32::INFINITY);
        // Steps that are waiting to be split are not active, and may no longer be wanted.
        for step in std::mem::take(&mut self.pending_splits) {
            if !self.instance.is_refined(step) {
                self.wanted.remove(step);
            }
        }
        for at in 0..self.steps.len() {
            if self.is_stale(at) {
                self.mark_stale(at);
            }
        }
        self.drop_stale();
    }

    /// Adds to the accumulated motion. Verdicts whose validity has been exceeded become due.
    fn move_by(&mut self, motion: f32) {
        if !motion.is_finite() {
            self.due.fill(f32::NEG_INFINITY);
            (self.elapsed, self.view_count) = (0.0, 0);
            return;
        }
        self.elapsed += f64::from(motion);
        self.view_count += u32::from(motion > 0.0);
        let is_large = motion > 0.0 && self.elapsed > MAX_MOTION_RATIO * f64::from(motion);
        if is_large || self.view_count > VIEWS_PER_SUM {
            // Large sums are imprecise, so start again at zero. Verdicts that remain valid for more than a
            // thousand sums are evaluated early.
            let elapsed = self.elapsed;
            let since = |due: f32| below(f64::from(due) - elapsed);
            self.due.iter_mut().for_each(|due| *due = since(*due).min(1000.0 * elapsed as f32));
            (self.elapsed, self.view_count) = (0.0, 0);
        }
    }

    /// Returns the accumulated motion at which a verdict given now expires, rounded down.
    fn due_after(&self, lasts: f32) -> f32 {
        below(self.elapsed + f64::from(lasts * (1.0 - SLACK)))
    }

    /// Gathers the next batch of due steps from the list. Returns whether there are any.
    fn gather_due(&mut self, scene: &FanScene<'_>, elapsed: f32, at: &mut usize) -> bool {
        self.batch.entries.clear();
        self.batch.parts.clear();
        while *at < self.due.len() && self.batch.parts.len() < BATCH_SIZE {
            let (first, ahead) = (*at, &self.due[*at..]);
            *at += ahead.len().min(DUE_BLOCK);
            let mut is_due = match ahead.first_chunk::<DUE_BLOCK>() {
                Some(&block) => f32x8::from(block).simd_le(f32x8::splat(elapsed)).to_bitmask(),
                None => (0..).zip(ahead).fold(0, |mask, (i, &due)| mask | u32::from(due <= elapsed) << i),
            };
            while is_due != 0 {
                let entry = first + is_due.trailing_zeros() as usize;
                is_due &= is_due - 1;
                if self.is_stale(entry) {
                    self.mark_stale(entry);
                } else {
                    self.batch.entries.push(entry as u32);
                    self.batch.parts.push(scene.part(self.steps[entry]));
                }
            }
        }
        !self.batch.parts.is_empty()
    }

    pub(super) fn begin(&self, scene: &FanScene<'_>, threshold: f32) -> FanUpdate {
        assert_eq!(self.instance.step_count, scene.fans.step_count, "the front belongs to a different model");
        FanUpdate { threshold, ..FanUpdate::default() }
    }

    /// Whether the parent of a list entry is unwanted: then its step is unwanted too and need not be
    /// evaluated.
    fn is_stale(&self, at: usize) -> bool {
        let parent = self.parents[at];
        parent != BASE && !self.wanted.has(parent)
    }

    /// Marks a list entry as stale; its step may be listed again later.
    fn mark_stale(&mut self, at: usize) {
        let step = self.steps[at];
        self.known.remove(step);
        self.unwant(step);
        self.due[at] = f32::INFINITY;
        self.stale.push(at as u32);
    }

    /// Removes stale entries from the list. Their steps are no longer listed, or have a newer entry.
    fn drop_stale(&mut self) {
        // From the end, so that the entry that fills a gap is not stale itself.
        while let Some(at) = self.stale.pop() {
            let at = at as usize;
            self.steps.swap_remove(at);
            self.parents.swap_remove(at);
            self.due.swap_remove(at);
        }
    }

    /// Records whether a step is wanted.
    pub(super) fn set_wanted(&mut self, fans: &Fans, step: u32, is_wanted: bool) {
        if !is_wanted {
            self.unwant(step);
        } else if !self.wanted.has(step) {
            self.wanted.insert(step);
            if self.instance.is_refined(step) {
                self.list_children(fans, step);
            }
        }
    }

    fn unwant(&mut self, step: u32) {
        // A step that was already unwanted is active because another step needs it; it is reconsidered
        // when that one collapses.
        if self.wanted.has(step) {
            self.wanted.remove(step);
            self.unneeded.insert(step);
        }
    }

    /// Splits steps that are wanted but collapsed, as far as the limit allows. Returns whether all were
    /// split.
    fn split_pending(&mut self, fans: &Fans, change_limit: usize, update: &mut FanUpdate) -> bool {
        while let Some(&step) = self.pending_splits.last() {
            if self.wanted.has(step) && !self.instance.is_refined(step) {
                let left = change_limit.saturating_sub(update.changes());
                if left == 0 {
                    return false;
                }
                update.split_count += self.split(fans, step, left);
                if !self.instance.is_refined(step) {
                    return false;
                }
            }
            self.pending_splits.pop();
        }
        true
    }

    /// Splits a step and what it needs, but at most `limit` steps, coarsest first. Returns the number of
    /// steps split.
    pub(super) fn split(&mut self, fans: &Fans, step: u32, limit: usize) -> usize {
        let mut split_steps = std::mem::take(&mut self.split_steps);
        split_steps.clear();
        self.instance.split_into(fans, step, &mut split_steps);
        if split_steps.len() > limit {
            // The steps that a step needs are coarser, so they come first.
            split_steps.sort_unstable();
            split_steps.drain(limit..).for_each(|step| self.instance.collapsed.insert(step));
            // The steps that need them are not active yet, and may never be.
            split_steps.iter().for_each(|&step| self.unneeded.insert(step));
        }
        for &step in &split_steps {
            self.triangle_count = self.triangle_count.saturating_add_signed(fans.added.of(step));
            if self.wanted.has(step) {
                self.list_children(fans, step);
            }
        }
        let count = split_steps.len();
        self.split_steps = split_steps;
        count
    }

    fn list_children(&mut self, fans: &Fans, parent: u32) {
        fans.for_each_child((parent != BASE).then_some(parent), |step| {
            if !self.known.has(step) {
                self.known.insert(step);
                self.steps.push(step);
                self.parents.push(parent);
                self.due.push(f32::NEG_INFINITY);
            }
        });
    }

    /// Collapses steps that are neither wanted nor needed, and then those that only they needed.
    pub(super) fn collapse_unneeded(&mut self, fans: &Fans, change_limit: usize, update: &mut FanUpdate) {
        // What a step needs is coarser than the step, so a single pass from fine to coarse reaches all of
        // them.
        let mut end = self.instance.step_count as u32;
        while let Some(step) = self.unneeded.last_before(end) {
            if update.changes() >= change_limit {
                return;
            }
            end = step;
            self.unneeded.remove(step);
            if !self.instance.is_refined(step) || self.wanted.has(step) {
                continue;
            }
            if fans.is_free(step, &self.instance.collapsed) {
                self.instance.collapsed.insert(step);
                self.triangle_count = self.triangle_count.saturating_add_signed(-fans.added.of(step));
                update.collapse_count += 1;
                fans.for_each_needed_by_split(step, |coarser| {
                    if !self.wanted.has(coarser) {
                        self.unneeded.insert(coarser);
                    }
                });
            }
        }
    }
}

/// Returns the next `f32` below a number, so that rounding never exceeds it.
fn below(number: f64) -> f32 {
    (number as f32).next_down()
}

impl FanUpdate {
    /// Number of steps that were split or collapsed.
    pub fn changes(&self) -> usize {
        self.split_count + self.collapse_count
    }
}
