//! An instance that follows a view from frame to frame: only what may have changed its mind is asked again.
//!
//! What is asked are the steps that are wanted and those right below them in the tree: the front between what is wanted and what
//! is not, and what lies above it. A verdict says how much motion it lasts for; the sum of all motion is compared with it, and
//! most steps wait for many frames. Steps that are wanted are undone with all that they need. Those that are not are taken
//! once nothing is there that needs them, and when the last such thing is taken, they are looked at again. So the
//! instance shows what is wanted and what that needs, whatever the way it came \[Hop97\].
//!
//! Differs: \[Hop97\] keeps the active mesh with its neighborhoods; here the table tells them: a front adds to its
//! instance three bits a step, and twelve bytes for each step that it may ask for.

use wide::f32x8;

use super::{FanInstance, FanScene, Fans};
use crate::model::step_bits::StepBits;
use crate::view::{Criterion, Part, Verdict};

/// Parent of the steps below the base.
const BASE: u32 = u32::MAX;

/// Motion is summed up for so many views before it is taken off what verdicts last.
const VIEWS_A_SUM: u32 = 256;

/// And no longer than until the sum is so many times the last motion: after a jump, what lasts for little is lost in it.
const FAR: f64 = 1e4;

/// Places of the list that are looked at together.
const DUE_BLOCK: usize = 8;

/// As many as the parts of a few hundred cycles.
const ASKED_TOGETHER: usize = 32;

/// Verdicts are asked again by so large a part of what they last before they have to be.
const SLACK: f32 = 1e-4;

/// An instance with what it needs to follow a view at the cost of what changes; `C` is the criterion of the last view.
#[derive(Clone, Debug)]
pub struct FanFront<C> {
    pub(super) instance: FanInstance,
    pub(super) triangle_count: usize,
    /// Steps that were wanted when they were last asked.
    pub(super) wanted: StepBits,
    /// Steps that are in the list.
    known: StepBits,
    /// The list: steps, what they are below, and how much motion since `elapsed` began their verdicts last for.
    pub(super) steps: Vec<u32>,
    parents: Vec<u32>,
    due: Vec<f32>,
    elapsed: f64,
    view_count: u32,
    last: Option<C>,
    /// Steps that are wanted and taken.
    late_splits: Vec<u32>,
    /// Steps that may be undone, unwanted, and needed by nothing.
    pub(super) unneeded: StepBits,
    undone: Vec<u32>,
    /// Places of the list that are struck out, rising.
    stale: Vec<u32>,
    asked: Asked,
}

/// What a view changed.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct FanUpdate {
    /// Steps whose weight was asked for.
    pub asked_count: usize,
    /// Steps that were undone.
    pub split_count: usize,
    /// Steps that were taken.
    pub collapse_count: usize,
    /// Whether nothing is left to do for this view.
    pub is_settled: bool,
    /// Parts that weigh more are refined: 1, or more where a budget of triangles asked for it.
    pub threshold: f32,
}

impl<C: Criterion + Clone> FanFront<C> {
    /// A front around the base of a model.
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
            late_splits: Vec::new(),
            unneeded: StepBits::none(step_count),
            undone: Vec::new(),
            stale: Vec::new(),
            asked: Asked::default(),
        };
        front.list_children(fans, BASE);
        front
    }

    /// What is shown.
    pub fn instance(&self) -> &FanInstance {
        &self.instance
    }

    /// Triangles that are shown.
    pub fn triangle_count(&self) -> usize {
        self.triangle_count
    }

    /// Bytes that the front and its instance own.
    pub fn bytes(&self) -> usize {
        let bits = self.instance.bytes() + self.wanted.bytes() + self.known.bytes() + self.unneeded.bytes();
        let words = [&self.steps, &self.parents, &self.late_splits, &self.undone, &self.stale];
        let words = words.iter().map(|list| list.capacity()).sum::<usize>() + self.due.capacity();
        bits + 4 * words + self.asked.bytes()
    }

    /// Goes to what a criterion wants and what that needs. No more than `change_limit` steps change; what is left is done with
    /// later views, even of the same criterion. `usize::MAX` is no limit.
    ///
    /// # Panics
    /// If the front is of another model.
    pub fn update(&mut self, scene: &FanScene<'_>, criterion: &C, change_limit: usize) -> FanUpdate {
        let motion = self.last.as_ref().map_or(f32::INFINITY, |last| criterion.motion_since(last));
        self.last = Some(criterion.clone());
        self.move_by(motion);
        let mut update = self.begin(scene, 1.0);
        self.late_splits.retain(|&step| self.wanted.has(step) && !self.instance.is_refined(step));
        let is_whole = self.split_late(scene.fans, change_limit, &mut update);
        let elapsed = (self.elapsed as f32).next_up();
        let mut at = 0;
        while self.gather_due(scene, elapsed, &mut at) {
            update.asked_count += self.asked.parts.len();
            let mut asked = std::mem::take(&mut self.asked);
            asked.verdicts.clear();
            criterion.weigh_all(&asked.parts, &mut asked.verdicts);
            for (&at, verdict) in asked.places.iter().zip(&asked.verdicts) {
                let step = self.steps[at as usize];
                // What lasts for no number is asked again at once.
                self.due[at as usize] = self.due_after(verdict.motion_margin.max(0.0));
                let was_wanted = self.wanted.has(step);
                self.hear(scene.fans, step, verdict.should_refine());
                // One that was wanted before waits already.
                if verdict.should_refine() && !was_wanted && !self.instance.is_refined(step) {
                    self.late_splits.push(step);
                    if is_whole {
                        self.split_late(scene.fans, change_limit, &mut update);
                    }
                }
            }
            self.asked = asked;
        }
        self.drop_stale();
        if self.late_splits.is_empty() || update.changes() < change_limit {
            self.take_unneeded(scene.fans, change_limit, &mut update);
        }
        update.is_settled = self.late_splits.is_empty()
            && self.unneeded.last_before(self.instance.step_count as u32).is_none();
        update
    }
}

/// Steps that are asked for together.
#[derive(Clone, Debug, Default)]
struct Asked {
    /// Places in the list.
    places: Vec<u32>,
    parts: Vec<Part>,
    verdicts: Vec<Verdict>,
}

impl Asked {
    fn bytes(&self) -> usize {
        4 * self.places.capacity()
            + size_of::<Part>() * self.parts.capacity()
            + size_of::<Verdict>() * self.verdicts.capacity()
    }
}

impl<C> FanFront<C> {
    /// Has everything asked again at the next view, and drops from the list what nobody asks for.
    pub(super) fn forget_views(&mut self) {
        self.last = None;
        self.move_by(f32::INFINITY);
        // What waits for its turn is not there, and may not be wanted any more.
        for step in std::mem::take(&mut self.late_splits) {
            if !self.instance.is_refined(step) {
                self.wanted.remove(step);
            }
        }
        for at in 0..self.steps.len() {
            if self.is_stale(at) {
                self.strike(at);
            }
        }
        self.drop_stale();
    }

    /// Adds motion to what has been; verdicts that may not last any more are due.
    fn move_by(&mut self, motion: f32) {
        if !motion.is_finite() {
            self.due.fill(f32::NEG_INFINITY);
            (self.elapsed, self.view_count) = (0.0, 0);
            return;
        }
        self.elapsed += f64::from(motion);
        self.view_count += u32::from(motion > 0.0);
        let is_far = motion > 0.0 && self.elapsed > FAR * f64::from(motion);
        if is_far || self.view_count > VIEWS_A_SUM {
            // Far from now numbers are coarse; verdicts that last longer than a thousand sums may as well be asked before.
            let elapsed = self.elapsed;
            let since = |due: f32| below(f64::from(due) - elapsed);
            self.due.iter_mut().for_each(|due| *due = since(*due).min(1000.0 * elapsed as f32));
            (self.elapsed, self.view_count) = (0.0, 0);
        }
    }

    /// How much motion there will have been when a verdict of now has lasted; where sums are coarse, rather less.
    fn due_after(&self, lasts: f32) -> f32 {
        below(self.elapsed + f64::from(lasts * (1.0 - SLACK)))
    }

    /// Gathers the next steps of the list whose verdicts may not last any more; whether there are any.
    fn gather_due(&mut self, scene: &FanScene<'_>, elapsed: f32, at: &mut usize) -> bool {
        self.asked.places.clear();
        self.asked.parts.clear();
        while *at < self.due.len() && self.asked.parts.len() < ASKED_TOGETHER {
            let (first, ahead) = (*at, &self.due[*at..]);
            *at += ahead.len().min(DUE_BLOCK);
            let mut is_due = match ahead.first_chunk::<DUE_BLOCK>() {
                Some(&block) => f32x8::from(block).simd_le(f32x8::splat(elapsed)).to_bitmask(),
                None => (0..).zip(ahead).fold(0, |mask, (i, &due)| mask | u32::from(due <= elapsed) << i),
            };
            while is_due != 0 {
                let place = first + is_due.trailing_zeros() as usize;
                is_due &= is_due - 1;
                if self.is_stale(place) {
                    self.strike(place);
                } else {
                    self.asked.places.push(place as u32);
                    self.asked.parts.push(scene.part(self.steps[place]));
                }
            }
        }
        !self.asked.parts.is_empty()
    }

    pub(super) fn begin(&self, scene: &FanScene<'_>, threshold: f32) -> FanUpdate {
        assert_eq!(self.instance.step_count, scene.fans.step_count, "the front is of another model");
        FanUpdate { threshold, ..FanUpdate::default() }
    }

    /// Whether what a place of the list is below is not wanted: then neither is the step, and nobody asks for it.
    fn is_stale(&self, at: usize) -> bool {
        let parent = self.parents[at];
        parent != BASE && !self.wanted.has(parent)
    }

    /// Marks a place as stale; its step may come to the list again.
    fn strike(&mut self, at: usize) {
        let step = self.steps[at];
        self.known.remove(step);
        self.unwant(step);
        self.due[at] = f32::INFINITY;
        self.stale.push(at as u32);
    }

    /// Takes stale places out of the list. Their steps are not in it any more, or are by another place.
    fn drop_stale(&mut self) {
        // From the end, where what fills a gap is not stale itself.
        while let Some(at) = self.stale.pop() {
            let at = at as usize;
            self.steps.swap_remove(at);
            self.parents.swap_remove(at);
            self.due.swap_remove(at);
        }
    }

    /// Notes whether a step is wanted.
    pub(super) fn hear(&mut self, fans: &Fans, step: u32, is_wanted: bool) {
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
        // One that was unwanted before is there because something needs it, and looked at when that goes.
        if self.wanted.has(step) {
            self.wanted.remove(step);
            self.unneeded.insert(step);
        }
    }

    /// Undoes what is wanted and taken, as far as the limit goes; whether that was all.
    fn split_late(&mut self, fans: &Fans, change_limit: usize, update: &mut FanUpdate) -> bool {
        while let Some(&step) = self.late_splits.last() {
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
            self.late_splits.pop();
        }
        true
    }

    /// Undoes a step, and before it what it needs; of these no more than so many, coarsest first. Returns how many.
    pub(super) fn split(&mut self, fans: &Fans, step: u32, limit: usize) -> usize {
        let mut undone = std::mem::take(&mut self.undone);
        undone.clear();
        self.instance.split_into(fans, step, &mut undone);
        if undone.len() > limit {
            // What a step needs is coarser.
            undone.sort_unstable();
            undone.drain(limit..).for_each(|step| self.instance.taken.insert(step));
            // What needs them is not there yet, and may never be.
            undone.iter().for_each(|&step| self.unneeded.insert(step));
        }
        for &step in &undone {
            self.triangle_count += usize::from(fans.removed[step as usize]);
            if self.wanted.has(step) {
                self.list_children(fans, step);
            }
        }
        let count = undone.len();
        self.undone = undone;
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

    /// Takes what is unwanted and needed by nothing, and then what only that needed.
    pub(super) fn take_unneeded(&mut self, fans: &Fans, change_limit: usize, update: &mut FanUpdate) {
        // What only a step needed is coarser than the step, so one walk from the finest down meets all of them.
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
            if fans.is_free(step, &self.instance.taken) {
                self.instance.taken.insert(step);
                self.triangle_count -= usize::from(fans.removed[step as usize]);
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

/// A number that is no larger, by as little as can be.
fn below(number: f64) -> f32 {
    (number as f32).next_down()
}

impl FanUpdate {
    /// Steps that were undone or taken.
    pub fn changes(&self) -> usize {
        self.split_count + self.collapse_count
    }
}
