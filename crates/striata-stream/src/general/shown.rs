//! Which vertices the corners around a general step's new position show, and which groups its triangles are in.
//!
//! As at a split of the surface (`wedges/model.rs`), all is asked as "is it the one that one would expect?".

use std::collections::HashMap;
use std::ops::Range;

use super::complex::Complex;
use super::step::{CodedStep, KnownBorn, KnownStep};
use crate::entropy::{AdaptiveBit, Coder, Rate, code_uniform};
use crate::refine::growth::Growth;
use crate::topology::surface::NONE;
use crate::wedges::model::WedgeModel;

/// Guesses for one corner.
const GUESSES: usize = 3;
/// Wedges of one target that are asked for one by one.
const ASKED_ALONE: usize = 3;

/// What is there before a step.
pub(super) struct Before<'a> {
    /// The triangles.
    pub(super) complex: &'a Complex,
    /// The mesh.
    pub(super) growth: &'a Growth,
    /// How many vertices more than one the new position may have.
    pub(super) most_beyond: u64,
}

/// Models of wedges and groups at general steps.
#[derive(Clone, Debug)]
pub(super) struct ShownModel {
    /// Whether a corner shows the wedge of the corner before, another one that is there.
    goes_on: [AdaptiveBit; 2],
    is_other: AdaptiveBit,
    is_older: AdaptiveBit,
    /// Whether a guess is right, by what is asked and which guess it is.
    is_guess: [[AdaptiveBit; GUESSES]; 4],
    has_more: [AdaptiveBit; 2],
    /// The wedges of the new position by what they collapse to.
    by_target: HashMap<u32, Vec<u32>>,
}

#[derive(Clone, Copy)]
enum Asked {
    Split,
    Third,
    Group,
    Target,
}

impl ShownModel {
    /// Nothing learned.
    pub(super) fn new() -> Self {
        let bit = AdaptiveBit::new(Rate::Steady);
        Self {
            goes_on: [bit; 2],
            is_other: bit,
            is_older: bit,
            is_guess: [[bit; GUESSES]; 4],
            has_more: [bit; 2],
            by_target: HashMap::new(),
        }
    }

    /// Codes a number of a range: one of the guesses, or any.
    fn choose<C: Coder>(
        &mut self,
        coder: &mut C,
        asked: Asked,
        (guesses, all): ([Option<u32>; GUESSES], Range<u32>),
        meant: u32,
    ) -> u32 {
        if all.len() == 1 {
            return all.start;
        }
        for (at, guess) in guesses.into_iter().enumerate() {
            let is_new = !guesses[..at].contains(&guess);
            let Some(guess) = guess.filter(|guess| is_new && all.contains(guess)) else { continue };
            if self.is_guess[asked as usize][at].code(coder, guess == meant) {
                return guess;
            }
        }
        all.start + code_uniform(coder, all.len() as u32, meant.wrapping_sub(all.start))
    }

    /// Codes all that corners show, where it is not one vertex for each position.
    pub(super) fn code<C: Coder>(
        &mut self,
        coder: &mut C,
        Before { complex, growth, most_beyond }: Before<'_>,
        (meant, out): (Option<&KnownStep>, &mut CodedStep),
        wedges: &mut WedgeModel,
    ) {
        out.targets.clear();
        out.named.clear();
        out.wedges.clear();
        out.others.clear();
        out.groups.clear();
        self.by_target.clear();
        let mut before = NONE;
        for at in 0..out.fan.len() {
            let corner = out.fan[at];
            let target = growth.triangles[corner as usize / 3][corner as usize % 3];
            let name = meant.and_then(|step| step.shown(corner)).unwrap_or(NONE);
            before = self.wedge(coder, (name, target), before, out);
            out.wedges.push(before);
        }
        for at in 0..out.born.len() {
            let known = meant.map(|step| step.born[out.known[at]]);
            self.born(coder, (complex, growth), (known, at), (out, wedges));
        }
        self.rest(coder, (growth, most_beyond), meant, out);
    }

    /// The wedge at a corner that shows `target` without the step: that of the corner before, another one, or a new one.
    fn wedge<C: Coder>(
        &mut self,
        coder: &mut C,
        (name, target): (u32, u32),
        before: u32,
        out: &mut CodedStep,
    ) -> u32 {
        let is_known = |wedge: u32| out.named[wedge as usize] == name;
        let goes_on = &mut self.goes_on[usize::from(out.fan.is_empty())];
        let may_go_on = before != NONE && out.targets[before as usize] == target;
        if may_go_on && goes_on.code(coder, is_known(before)) {
            return before;
        }
        let others = self.by_target.entry(target).or_default();
        for &other in others.iter().rev().filter(|&&wedge| wedge != before).take(ASKED_ALONE) {
            if self.is_other.code(coder, is_known(other)) {
                return other;
            }
        }
        if others.len() > ASKED_ALONE + usize::from(may_go_on) {
            let place = others.iter().position(|&wedge| is_known(wedge));
            if self.is_older.code(coder, place.is_some()) {
                let place = code_uniform(coder, others.len() as u32, place.unwrap_or(0) as u32);
                return others[place as usize];
            }
        }
        let new = out.targets.len() as u32;
        others.push(new);
        out.targets.push(target);
        out.named.push(name);
        new
    }

    /// What the corners of a new triangle show, and its group.
    fn born<C: Coder>(
        &mut self,
        coder: &mut C,
        (complex, growth): (&Complex, &Growth),
        (known, at): (Option<KnownBorn>, usize),
        (out, wedges): (&mut CodedStep, &mut WedgeModel),
    ) {
        let third = out.born[at].third;
        let [mut by_split, mut by_third] = [None; 2];
        let mut group = None;
        // Neighbors across the edge to the third position: those that stay come last, and count.
        let moved = out.fan.iter().copied();
        let is_beside = |corner: &u32| complex.edge(*corner).contains(&third);
        for corner in moved.chain(complex.corners(out.split).take(64)).filter(is_beside) {
            let triangle = &growth.triangles[corner as usize / 3];
            let of_third = complex.triangle(corner / 3).iter().position(|&p| p == third);
            by_split = Some(triangle[corner as usize % 3]);
            by_third = of_third.map(|i| triangle[i]);
            group = growth.groups.get(corner as usize / 3).copied();
        }
        let of_position = |position: u32| {
            let position = position as usize;
            growth.first_vertex[position]..growth.first_vertex[position + 1]
        };
        let meant = known.map_or([NONE; 2], |known| known.others);
        let last = out.others.last().map(|others| others[0]);
        let mut unshown = |all: &Range<u32>, near: Option<u32>| {
            let found = wedges.hidden(all, near.unwrap_or(all.start));
            found.first().copied()
        };
        let all = of_position(out.split);
        let offer = ([by_split, last, unshown(&all, by_split)], all);
        let split = self.choose(coder, Asked::Split, offer, meant[0]);
        let all = of_position(third);
        let offer = ([by_third, unshown(&all, by_third), Some(all.start)], all);
        let third = self.choose(coder, Asked::Third, offer, meant[1]);
        out.others.push([split, third]);
        let before = out.wedges.last().copied().unwrap_or(NONE);
        let name = known.map_or(NONE, |known| known.own);
        let wedge = self.wedge(coder, (name, split), before, out);
        out.wedges.push(wedge);
        let last = out.groups.last().copied().or(growth.groups.last().copied());
        let offer = ([group, last, None], 0..growth.group_count.max(1));
        out.groups.push(self.choose(coder, Asked::Group, offer, known.map_or(0, |known| known.group)));
    }

    /// Vertices of the new position that no corner shows.
    fn rest<C: Coder>(
        &mut self,
        coder: &mut C,
        (growth, most_beyond): (&Growth, u64),
        meant: Option<&KnownStep>,
        out: &mut CodedStep,
    ) {
        let mut names = out.named.clone();
        names.sort_unstable();
        let wedges = meant.map_or(0..0, |step| step.wedges.clone());
        let mut left = wedges.filter(|wedge| names.binary_search(wedge).is_err());
        let split = out.split as usize;
        let all = growth.first_vertex[split]..growth.first_vertex[split + 1];
        loop {
            let more = left.next();
            let count = out.targets.len() as u64;
            let is_full = count > most_beyond;
            if count > 0 && (is_full || !self.has_more[usize::from(count > 1)].code(coder, more.is_some())) {
                return;
            }
            let target = more.and_then(|wedge| meant?.target_of(wedge)).unwrap_or(NONE);
            let guesses = [out.targets.last().copied(), Some(all.start), None];
            out.targets.push(self.choose(coder, Asked::Target, (guesses, all.clone()), target));
            out.named.push(more.unwrap_or(NONE));
        }
    }
}
