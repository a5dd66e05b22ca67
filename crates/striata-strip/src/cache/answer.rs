//! One partial answer of the search: what is drawn, what the cache holds, and what a further triangle would cost.
//!
//! Every vertex has to come in once; what can be saved are its returns. So a miss is paid for when a vertex is
//! **lost**: pushed out of the cache while triangles around it are undrawn. Answers are compared when they have drawn
//! equally many triangles, by what they have paid and by what they are likely to pay:
//!
//! * an **open** vertex in the cache is the likelier to be lost the older it is;
//! * an undrawn triangle is the likelier to end a strip the fewer undrawn neighbors it has. Since each link
//!   between drawn and undrawn counts, answers with short borders win, which keeps the rows of strips compact.

use striata::mesh::Random;
use striata::strip::{next_side, prev_side};

use super::cached::Cached;
use super::covered::{Covered, Drawn};
use super::surface::Surface;

/// In place of the last step: there is none yet.
pub(super) const ROOT: u32 = u32::MAX;

/// What the search weighs, in indices.
pub(super) struct Prices {
    /// A vertex that is lost.
    pub(super) loss: f64,
    /// An open vertex in the cache, by its age.
    pub(super) risks: Vec<f64>,
    /// An undrawn triangle, by its undrawn neighbors.
    pub(super) poverty: [f64; 4],
}

/// Indices that a new strip takes beyond one a triangle: two, and the restart.
const START_PRICE: f64 = 3.0;
/// Cached vertices around which strips may start, the oldest first.
const START_VERTEX_COUNT: usize = 4;
/// Undrawn triangles that are tried around one of them: hubs of large fans have any number.
const START_TRY_COUNT: usize = 12;
/// Triangles that are looked at for that.
const START_LOOK_COUNT: usize = 64;

/// What all answers share.
pub(super) struct Scene<'a> {
    pub(super) surface: Surface<'a>,
    pub(super) covered: Covered,
    pub(super) prices: Prices,
    /// Triangles that may be drawn now.
    pub(super) group: std::ops::Range<u32>,
}

/// One more triangle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Step {
    /// A new strip begins with it.
    Start(u32),
    /// The strip goes on across a side.
    Cross(u32),
}

impl Step {
    /// The triangle that the step draws.
    #[inline]
    pub(super) fn triangle(self, surface: &Surface<'_>) -> u32 {
        match self {
            Self::Start(triangle) => triangle,
            Self::Cross(side) => surface.twin(side).expect("strips cross links") / 3,
        }
    }
}

/// A step and what it sends.
#[derive(Clone, Copy, Debug)]
struct Way {
    step: Step,
    /// Vertices that the step sends, the first so many of the three.
    sent: ([u32; 3], usize),
    /// Indices beyond one.
    index_price: f64,
}

impl Way {
    fn sent(&self) -> &[u32] {
        &self.sent.0[..self.sent.1]
    }
}

/// A way on, and what the answer would be worth after it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Judgment {
    pub(super) step: Step,
    way: Way,
    cost: f64,
    poverty: f64,
    /// Paid and likely to be paid; less is better.
    pub(super) score: f64,
}

/// Where the last strip of an answer ends.
#[derive(Clone, Copy, Debug)]
enum Head {
    Nothing,
    /// A strip of one triangle: it may go on across any side.
    Single(u32),
    /// The side by which the last triangle was entered; whether leaving by the next side takes no swap.
    Entered(u32, bool),
}

/// One partial answer.
#[derive(Clone)]
pub(super) struct Answer {
    pub(super) drawn: Drawn,
    /// Of the set of drawn triangles.
    pub(super) hash: u64,
    /// The step with which the last strip began.
    pub(super) strip_start: u32,
    /// The last step, in the tree of all steps.
    pub(super) leaf: u32,
    cached: Cached,
    head: Head,
    cost: f64,
    poverty: f64,
    pub(super) score: f64,
    /// No triangle of the group before this one is undrawn.
    first_undrawn: u32,
}

impl Answer {
    pub(super) fn new(cache_size: usize) -> Self {
        Self {
            drawn: Drawn::default(),
            hash: 0,
            strip_start: 0,
            leaf: ROOT,
            cached: Cached::new(cache_size),
            head: Head::Nothing,
            cost: 0.0,
            poverty: 0.0,
            score: 0.0,
            first_undrawn: 0,
        }
    }

    /// Ends the strip and turns to the triangles from `first` on; the cache stays.
    pub(super) fn begin_group(&mut self, first: u32) {
        let cached = std::mem::replace(&mut self.cached, Cached::new(0));
        *self = Self { cached, first_undrawn: first, ..Self::new(0) };
    }

    pub(super) fn copy_from(&mut self, other: &Self) {
        self.cached.copy_from(&other.cached);
        (self.drawn, self.hash, self.head) = (other.drawn, other.hash, other.head);
        (self.strip_start, self.leaf) = (other.strip_start, other.leaf);
        (self.cost, self.poverty, self.score) = (other.cost, other.poverty, other.score);
        self.first_undrawn = other.first_undrawn;
    }

    /// Counts what is paid from another answer's account on, so that numbers stay small.
    pub(super) fn pay_from(&mut self, (cost, poverty): (f64, f64)) {
        self.cost -= cost;
        self.poverty -= poverty;
        self.score -= cost + poverty;
    }

    /// What has been paid, and the poverty that is left.
    pub(super) fn account(&self) -> (f64, f64) {
        (self.cost, self.poverty)
    }

    /// The undrawn triangle beyond a side.
    #[inline]
    fn beyond(&self, scene: &Scene<'_>, side: u32) -> Option<u32> {
        let triangle = scene.surface.twin(side)? / 3;
        (!scene.covered.is_drawn(&self.drawn, triangle)).then_some(triangle)
    }

    /// The undrawn triangles beside a triangle.
    #[inline]
    fn beside(&self, scene: &Scene<'_>, triangle: u32) -> impl Iterator<Item = u32> {
        (3 * triangle..3 * triangle + 3).filter_map(|side| self.beyond(scene, side))
    }

    /// Appends the ways on for the last strip.
    pub(super) fn judge_crossings(&self, scene: &Scene<'_>, out: &mut Vec<Judgment>) {
        let outlook = self.outlook(scene);
        let mut judge = |side: u32, is_swap: bool| {
            if self.beyond(scene, side).is_some() {
                out.push(self.judge(scene, &outlook, self.crossing(scene, side, is_swap)));
            }
        };
        match self.head {
            Head::Nothing => {}
            Head::Single(triangle) => (3 * triangle..3 * triangle + 3).for_each(|side| judge(side, false)),
            Head::Entered(side, turns_next) => {
                judge(next_side(side), !turns_next);
                judge(prev_side(side), turns_next);
            }
        }
    }

    /// Appends the `count` best starts of a new strip at triangles around cached vertices.
    pub(super) fn judge_starts(&self, scene: &Scene<'_>, count: usize, out: &mut Vec<Judgment>) {
        let first = out.len();
        let outlook = self.outlook(scene);
        for (v, _) in self.cached.open_vertices().take(START_VERTEX_COUNT) {
            let around = scene.covered.unsettled_around(&scene.surface, v).iter().take(START_LOOK_COUNT);
            let is_open = |t: &u32| scene.group.contains(t) && !scene.covered.is_drawn(&self.drawn, *t);
            for t in around.copied().filter(is_open).take(START_TRY_COUNT) {
                if out[first..].iter().all(|other| other.step != Step::Start(t)) {
                    out.push(self.judge_start(scene, &outlook, t));
                }
            }
        }
        out[first..].sort_by(|a, b| a.score.total_cmp(&b.score));
        out.truncate(first + count);
    }

    /// Appends a start far from what is cached: beside what was drawn last, or at the first undrawn triangle.
    pub(super) fn judge_far_start(&mut self, scene: &Scene<'_>, trail: &[u32], out: &mut Vec<Judgment>) {
        let near = trail.iter().rev().find_map(|&t| self.beside(scene, t).next());
        let found = near.or_else(|| {
            let open = (self.first_undrawn..scene.group.end)
                .find(|&t| scene.surface.is_proper(t) && !scene.covered.is_drawn(&self.drawn, t));
            self.first_undrawn = open.unwrap_or(scene.group.end);
            open
        });
        if let Some(t) = found {
            out.push(self.judge_start(scene, &self.outlook(scene), t));
        }
    }

    fn judge_start(&self, scene: &Scene<'_>, outlook: &Outlook, triangle: u32) -> Judgment {
        let sent = (scene.surface.triangles[triangle as usize], 3);
        self.judge(scene, outlook, Way { step: Step::Start(triangle), sent, index_price: START_PRICE })
    }

    /// Crossing a side sends the new corner, and before it what a swap repeats.
    fn crossing(&self, scene: &Scene<'_>, side: u32, is_swap: bool) -> Way {
        let surface = &scene.surface;
        let apex = surface.twin(side).map_or(0, |entered| surface.apex(entered));
        let mut way = Way { step: Step::Cross(side), sent: ([apex; 3], 1), index_price: 0.0 };
        if let (Head::Entered(entered, _), true) = (self.head, is_swap) {
            // Of the side's ends the swap repeats the older: not the corner that came with this triangle.
            let is_newer = surface.corner(side) == surface.apex(entered);
            let older = surface.corner(if is_newer { next_side(side) } else { side });
            (way.sent, way.index_price) = (([older, apex, apex], 2), 1.0);
        }
        way
    }

    /// What the cached vertices cost after none to three misses.
    fn outlook(&self, scene: &Scene<'_>) -> Outlook {
        let mut outlook = Outlook::default();
        for (_, age) in self.cached.open_vertices() {
            for (misses, (paid, likely)) in outlook.0.iter_mut().enumerate() {
                match scene.prices.risks.get(age + misses) {
                    Some(risk) => *likely += risk,
                    None => *paid += scene.prices.loss,
                }
            }
        }
        outlook
    }

    fn judge(&self, scene: &Scene<'_>, outlook: &Outlook, way: Way) -> Judgment {
        let step = way.step;
        let triangle = step.triangle(&scene.surface);
        let poverty = self.poverty + self.poverty_change(scene, triangle);
        let slots = scene.surface.triangles[triangle as usize].map(|v| (v, self.cached.slot(v)));
        // All that is sent are corners of the triangle, what a swap repeats too.
        let is_cached = |v: u32| slots.iter().any(|&(corner, slot)| corner == v && slot.is_some());
        let misses = way.sent().iter().filter(|&&v| !is_cached(v)).count();
        let (mut paid, mut likely) = outlook.0[misses];
        // What this triangle closes can neither be lost nor in danger.
        for slot in slots.iter().filter_map(|&(_, slot)| slot).filter(|&slot| self.cached.open(slot) == 1) {
            match scene.prices.risks.get(self.cached.age(slot) + misses) {
                Some(risk) => likely -= risk,
                None => paid -= scene.prices.loss,
            }
        }
        let cost = self.cost + way.index_price + paid;
        Judgment { step, way, cost, poverty, score: cost + poverty + likely }
    }

    /// How drawing a triangle changes what is undrawn around it.
    fn poverty_change(&self, scene: &Scene<'_>, triangle: u32) -> f64 {
        let price = |count: usize| scene.prices.poverty[count];
        let mut change = 0.0;
        let mut count = 0;
        for beside in self.beside(scene, triangle) {
            count += 1;
            let others = self.beside(scene, beside).count();
            change += price(others - 1) - price(others);
        }
        change - price(count)
    }

    /// Takes a step that was judged on this answer.
    pub(super) fn take(&mut self, scene: &mut Scene<'_>, judgment: &Judgment, step_index: u32) {
        let triangle = judgment.step.triangle(&scene.surface);
        self.head = match (judgment.step, self.head) {
            (Step::Start(_), _) => {
                self.strip_start = step_index;
                Head::Single(triangle)
            }
            // Turns alternate where nothing is swapped.
            (Step::Cross(side), Head::Entered(before, _)) => {
                Head::Entered(scene.surface.twin(side).unwrap_or(side), side != next_side(before))
            }
            // The first turn of a strip is free to the side before.
            (Step::Cross(side), _) => Head::Entered(scene.surface.twin(side).unwrap_or(side), false),
        };
        (self.cost, self.poverty, self.score) = (judgment.cost, judgment.poverty, judgment.score);
        self.hash ^= mixed(triangle.into());
        scene.covered.draw(&mut self.drawn, triangle);
        self.cached.draw(scene.surface.triangles[triangle as usize]);
        for &v in judgment.way.sent() {
            if self.cached.slot(v).is_none() {
                self.cached.push(v, scene.covered.open_count(&scene.surface, &self.drawn, v));
            }
        }
    }
}

/// Losses and risks of the cached vertices after none to three misses.
#[derive(Default)]
struct Outlook([(f64, f64); 4]);

/// Well mixed bits of a number (splitmix64).
pub(super) fn mixed(number: u64) -> u64 {
    Random::new(number).next_u64()
}
