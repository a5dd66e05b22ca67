//! An instance that follows a view from frame to frame and re-evaluates only steps whose verdict may have
//! changed.
//!
//! Known are the children of all wanted steps: the wanted steps themselves, and the unwanted ones directly below
//! them in the tree. A verdict states for how much camera motion it remains valid; most steps are not evaluated for
//! many frames (`expiries.rs`). Wanted steps are split together with everything that they need. An unwanted step
//! is collapsed once no active step needs it; whenever such a step is collapsed, those that it needed are
//! reconsidered. The instance therefore always shows what is wanted and what that needs, regardless of the path
//! that led there \[Hop97\].
//!
//! Differs: \[Hop97\] maintains the active mesh with its adjacency; here the table provides it. In addition to its
//! instance, a front stores two bits and two bytes per step.

use super::expiries::{CHUNK, Expiries};
use super::{FanInstance, FanScene, Fans};
use crate::model::step_bits::StepBits;
use crate::view::{Criterion, Part, Verdict};

/// Number of due steps at which a batch is evaluated; up to 63 more may be in the last chunk.
const BATCH_SIZE: usize = 32;

/// An instance that follows a view at a cost proportional to what changes; `C` is the type of the view
/// criterion.
#[derive(Clone, Debug)]
pub struct FanFront<C> {
    pub(super) instance: FanInstance,
    pub(super) triangle_count: usize,
    /// Steps that were wanted by their last verdict.
    pub(super) wanted: StepBits,
    /// The known steps, and when their verdicts expire.
    pub(super) expiries: Expiries,
    last: Option<C>,
    /// Refined steps that may no longer be wanted or needed.
    unneeded: StepBits,
    /// Steps that have become known and were not evaluated since.
    pub(super) listed: Vec<u32>,
    split_steps: Vec<u32>,
    unwanted: Vec<u32>,
    batch: StepBatch,
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

/// A batch of steps that are evaluated together.
#[derive(Clone, Debug, Default)]
struct StepBatch {
    steps: Vec<u32>,
    parts: Vec<Part>,
    verdicts: Vec<Verdict>,
}

/// How many steps may change, and whether all changes were possible.
struct ChangeLimit<'a> {
    /// Most steps that may change.
    pub change_limit: usize,
    /// Set to false if more would have to change.
    pub is_whole: &'a mut bool,
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
            expiries: Expiries::new(step_count),
            last: None,
            unneeded: StepBits::none(step_count),
            listed: Vec::new(),
            split_steps: Vec::new(),
            unwanted: Vec::new(),
            batch: StepBatch::default(),
        };
        fans.for_each_child(None, |child| front.expiries.add(child));
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
        let bits = self.instance.bytes() + self.wanted.bytes() + self.unneeded.bytes();
        let lists = [&self.listed, &self.split_steps, &self.unwanted, &self.batch.steps];
        bits + self.expiries.bytes()
            + 4 * lists.iter().map(|list| list.capacity()).sum::<usize>()
            + size_of::<Part>() * self.batch.parts.capacity()
            + size_of::<Verdict>() * self.batch.verdicts.capacity()
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
        self.expiries.advance(motion);
        let mut update = self.begin(scene, 1.0);
        let mut is_whole = self.split_pending(scene.fans, change_limit, &mut update);
        let mut start = 0;
        loop {
            while let Some(next) = self.gather_due(scene, start) {
                self.evaluate(
                    scene.fans,
                    criterion,
                    ChangeLimit { change_limit, is_whole: &mut is_whole },
                    &mut update,
                );
                // Children of wanted steps are finer, but may be in a chunk that has been scanned.
                let first_listed = self.listed.drain(..).min();
                start = first_listed.map_or(next, |step| next.min(step / CHUNK as u32));
            }
            // With a limit, some steps are split only now, and their children have to be evaluated.
            is_whole = self.split_pending(scene.fans, change_limit, &mut update);
            match self.listed.drain(..).min() {
                Some(step) => start = step / CHUNK as u32,
                None => break,
            }
        }
        if is_whole || update.changes() < change_limit {
            self.collapse_unneeded(scene.fans, change_limit, &mut update);
        }
        update.is_complete = is_whole && self.unneeded.first_from(0).is_none();
        update
    }

    /// Evaluates the batch. Steps that become wanted are split, as long as the limit allows.
    fn evaluate(
        &mut self,
        fans: &Fans,
        criterion: &C,
        ChangeLimit { change_limit, is_whole }: ChangeLimit<'_>,
        update: &mut FanUpdate,
    ) {
        let mut batch = std::mem::take(&mut self.batch);
        update.evaluated_count += batch.parts.len();
        batch.verdicts.clear();
        criterion.weigh_all(&batch.parts, &mut batch.verdicts);
        self.expiries.calibrate(batch.verdicts.iter().map(|verdict| verdict.motion_margin));
        for (&step, verdict) in batch.steps.iter().zip(&batch.verdicts) {
            if !self.expiries.is_known(step) {
                // An ancestor in the same batch has become unwanted.
                continue;
            }
            // A NaN margin counts as 0, so the step is evaluated again in the next update.
            self.expiries.set(step, verdict.motion_margin.max(0.0));
            // First of all, because most verdicts stay the same, which is easy to predict.
            if verdict.should_refine() == self.wanted.has(step) {
                continue;
            }
            self.set_wanted(fans, step, verdict.should_refine());
            if verdict.should_refine() && *is_whole && !self.instance.is_refined(step) {
                *is_whole = self.split_one(fans, step, change_limit, update);
            }
        }
        self.batch = batch;
    }
}

impl<C> FanFront<C> {
    /// Makes all verdicts due. Steps that are waiting to be split are not wanted any more.
    pub(super) fn forget_views(&mut self) {
        self.last = None;
        self.expiries.expire_all();
        let mut next = 0;
        while let Some(step) = self.pending_from(next) {
            self.wanted.remove(step);
            next = step + 1;
        }
    }

    /// Gathers the next batch of due steps, beginning with a chunk of steps. Returns the chunk with which to
    /// continue, or `None` if no step is due.
    fn gather_due(&mut self, scene: &FanScene<'_>, mut start: u32) -> Option<u32> {
        let StepBatch { steps, parts, .. } = &mut self.batch;
        steps.clear();
        while let Some(chunk) = self.expiries.next_chunk(start) {
            let mut due = self.expiries.due(chunk);
            while due != 0 {
                steps.push(CHUNK as u32 * chunk + due.trailing_zeros());
                due &= due - 1;
            }
            start = chunk + 1;
            if steps.len() >= BATCH_SIZE {
                break;
            }
        }
        parts.clear();
        parts.extend(steps.iter().map(|&step| scene.part(step)));
        (!steps.is_empty()).then_some(start)
    }

    pub(super) fn begin(&self, scene: &FanScene<'_>, threshold: f32) -> FanUpdate {
        assert_eq!(self.instance.step_count, scene.fans.step_count, "the front belongs to a different model");
        FanUpdate { threshold, ..FanUpdate::default() }
    }

    /// Records whether a known step is wanted.
    pub(super) fn set_wanted(&mut self, fans: &Fans, step: u32, is_wanted: bool) {
        if is_wanted == self.wanted.has(step) {
            // A step that was already unwanted is active because another step needs it; it is reconsidered when
            // that one collapses.
        } else if is_wanted {
            self.wanted.insert(step);
            if self.instance.is_refined(step) {
                self.list_children(fans, step);
            }
        } else {
            self.unwant(fans, step);
        }
    }

    /// Records that a wanted step is not wanted any more, nor is anything below it in the tree.
    fn unwant(&mut self, fans: &Fans, step: u32) {
        let mut unwanted = std::mem::take(&mut self.unwanted);
        unwanted.push(step);
        while let Some(step) = unwanted.pop() {
            self.wanted.remove(step);
            self.unneeded.insert(step);
            fans.for_each_child(Some(step), |child| {
                self.expiries.forget(child);
                if self.wanted.has(child) {
                    unwanted.push(child);
                }
            });
        }
        self.unwanted = unwanted;
    }

    /// Returns the first step from `start` on that is wanted but collapsed.
    fn pending_from(&self, start: u32) -> Option<u32> {
        self.wanted.first_common_from(&self.instance.collapsed, start)
    }

    /// Splits steps that are wanted but collapsed, as far as the limit allows. Returns whether all were
    /// split.
    fn split_pending(&mut self, fans: &Fans, change_limit: usize, update: &mut FanUpdate) -> bool {
        let mut next = 0;
        while let Some(step) = self.pending_from(next) {
            if !self.split_one(fans, step, change_limit, update) {
                return false;
            }
            next = step + 1;
        }
        true
    }

    /// Splits a collapsed step, as far as the limit allows. Returns whether it was split.
    fn split_one(&mut self, fans: &Fans, step: u32, change_limit: usize, update: &mut FanUpdate) -> bool {
        let left = change_limit.saturating_sub(update.changes());
        if left > 0 {
            update.split_count += self.split(fans, step, left);
        }
        self.instance.is_refined(step)
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
        fans.for_each_child(Some(parent), |step| {
            if !self.expiries.is_known(step) {
                self.expiries.add(step);
                self.listed.push(step);
            }
        });
    }

    /// Collapses steps that are neither wanted nor needed, and then those that only they needed.
    pub(super) fn collapse_unneeded(&mut self, fans: &Fans, change_limit: usize, update: &mut FanUpdate) {
        // A step needs only coarser steps, so a single pass from fine to coarse reaches all of them.
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

impl FanUpdate {
    /// Number of steps that were split or collapsed.
    pub fn changes(&self) -> usize {
        self.split_count + self.collapse_count
    }
}
