//! Models of the wedges of the corners around a general step's new position, and of the groups of its
//! triangles.
//!
//! As in surface splits (`wedges/model.rs`), most decisions are whether a guess is right.

use std::collections::HashMap;
use std::ops::Range;

use super::complex::Complex;
use super::step::{CodedStep, ReferenceStep, ReferenceTriangle};
use crate::entropy::{AdaptiveBit, Coder, Rate, code_uniform};
use crate::refine::growth::GrowingMesh;
use crate::topology::surface::NONE;
use crate::wedges::model::WedgeModel;

/// Number of guesses per choice.
const GUESSES: usize = 3;
/// Number of wedges with the same target that are coded one by one.
const CODED_SINGLY: usize = 3;

/// The level before a step.
#[derive(Clone, Copy)]
pub(super) struct LevelBefore<'a> {
    /// The triangles over positions.
    pub complex: &'a Complex,
    /// The triangles over vertices.
    pub growth: &'a GrowingMesh,
    /// Maximum number of wedges of the new position beyond the first.
    pub max_extra_wedges: u64,
}

/// Models of wedges and groups in general steps.
#[derive(Clone, Debug)]
pub(super) struct GeneralWedgeModel {
    /// Whether a corner uses the same wedge as the previous corner, a recent one with the same target, or
    /// an older one.
    repeats_previous: [AdaptiveBit; 2],
    is_recent: AdaptiveBit,
    is_older: AdaptiveBit,
    /// Whether a guess is right, by kind of choice and index of the guess.
    is_guess_right: [[AdaptiveBit; GUESSES]; 4],
    has_more: [AdaptiveBit; 2],
    /// Wedges of the new position by collapse target.
    by_target: HashMap<u32, Vec<u32>>,
}

#[derive(Clone, Copy)]
enum ChoiceKind {
    Split,
    Third,
    Group,
    Target,
}

/// The wedge of a corner.
struct CodedWedge {
    /// Its number in the mesh of the encoder.
    actual_wedge: u32,
    /// The vertex that it collapses to.
    target: u32,
}

impl GeneralWedgeModel {
    /// Creates an untrained model.
    pub(super) fn new() -> Self {
        let bit = AdaptiveBit::new(Rate::Steady);
        Self {
            repeats_previous: [bit; 2],
            is_recent: bit,
            is_older: bit,
            is_guess_right: [[bit; GUESSES]; 4],
            has_more: [bit; 2],
            by_target: HashMap::new(),
        }
    }

    /// Codes a number of the range `all`: one of the guesses, or any other.
    fn choose<C: Coder>(
        &mut self,
        coder: &mut C,
        kind: ChoiceKind,
        (guesses, all): ([Option<u32>; GUESSES], Range<u32>),
        actual: u32,
    ) -> u32 {
        if all.len() == 1 {
            return all.start;
        }
        for (at, guess) in guesses.into_iter().enumerate() {
            let is_new = !guesses[..at].contains(&guess);
            let Some(guess) = guess.filter(|guess| is_new && all.contains(guess)) else { continue };
            if self.is_guess_right[kind as usize][at].code(coder, guess == actual) {
                return guess;
            }
        }
        all.start + code_uniform(coder, all.len() as u32, actual.wrapping_sub(all.start))
    }

    /// Codes all wedges and groups of a step, for meshes with seams or groups.
    pub(super) fn code<C: Coder>(
        &mut self,
        coder: &mut C,
        level_before: LevelBefore<'_>,
        (actual, out): (Option<&ReferenceStep>, &mut CodedStep),
        wedges: &mut WedgeModel,
    ) {
        let LevelBefore { complex, growth, .. } = level_before;
        out.targets.clear();
        out.reference_wedges.clear();
        out.wedges.clear();
        out.others.clear();
        out.groups.clear();
        self.by_target.clear();
        let mut previous = NONE;
        for at in 0..out.fan.len() {
            let corner = out.fan[at];
            let target = growth.triangles[corner as usize / 3][corner as usize % 3];
            let actual_wedge = actual.and_then(|step| step.wedge_at(corner)).unwrap_or(NONE);
            previous = self.code_wedge(coder, CodedWedge { actual_wedge, target }, previous, out);
            out.wedges.push(previous);
        }
        for at in 0..out.new_triangles.len() {
            let actual_triangle = actual.map(|step| step.new_triangles[out.reference_triangles[at]]);
            self.code_triangle(coder, (complex, growth), (actual_triangle, at), (out, wedges));
        }
        self.code_unused_wedges(coder, level_before, actual, out);
    }

    /// Codes the wedge of a corner whose vertex is `target` before the step: the wedge of the previous
    /// corner, another one with this target, or a new one.
    fn code_wedge<C: Coder>(
        &mut self,
        coder: &mut C,
        CodedWedge { actual_wedge, target }: CodedWedge,
        previous: u32,
        out: &mut CodedStep,
    ) -> u32 {
        let is_actual = |wedge: u32| out.reference_wedges[wedge as usize] == actual_wedge;
        let repeats_previous = &mut self.repeats_previous[usize::from(out.fan.is_empty())];
        let can_repeat = previous != NONE && out.targets[previous as usize] == target;
        if can_repeat && repeats_previous.code(coder, is_actual(previous)) {
            return previous;
        }
        let others = self.by_target.entry(target).or_default();
        for &other in others.iter().rev().filter(|&&wedge| wedge != previous).take(CODED_SINGLY) {
            if self.is_recent.code(coder, is_actual(other)) {
                return other;
            }
        }
        if others.len() > CODED_SINGLY + usize::from(can_repeat) {
            let index = others.iter().position(|&wedge| is_actual(wedge));
            if self.is_older.code(coder, index.is_some()) {
                let index = code_uniform(coder, others.len() as u32, index.unwrap_or(0) as u32);
                return others[index as usize];
            }
        }
        let new = out.targets.len() as u32;
        others.push(new);
        out.targets.push(target);
        out.reference_wedges.push(actual_wedge);
        new
    }

    /// Codes the vertices of the corners of a new triangle, and its group.
    fn code_triangle<C: Coder>(
        &mut self,
        coder: &mut C,
        (complex, growth): (&Complex, &GrowingMesh),
        (actual_triangle, at): (Option<ReferenceTriangle>, usize),
        (out, wedges): (&mut CodedStep, &mut WedgeModel),
    ) {
        let third = out.new_triangles[at].third;
        let [mut by_split, mut by_third] = [None; 2];
        let mut group = None;
        // Neighbors across the edge to the third position. The last one found counts: one that stays, if any.
        let moved = out.fan.iter().copied();
        let has_third = |corner: &u32| complex.edge(*corner).contains(&third);
        for corner in moved.chain(complex.corners(out.split).take(64)).filter(has_third) {
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
        let actual = actual_triangle.map_or([NONE; 2], |triangle| triangle.others);
        let last = out.others.last().map(|others| others[0]);
        let mut unused = |all: &Range<u32>, near: Option<u32>| {
            let hidden = wedges.hidden(all, near.unwrap_or(all.start));
            hidden.first().copied()
        };
        let all = of_position(out.split);
        let choices = ([by_split, last, unused(&all, by_split)], all);
        let split = self.choose(coder, ChoiceKind::Split, choices, actual[0]);
        let all = of_position(third);
        let choices = ([by_third, unused(&all, by_third), Some(all.start)], all);
        let third = self.choose(coder, ChoiceKind::Third, choices, actual[1]);
        out.others.push([split, third]);
        let previous = out.wedges.last().copied().unwrap_or(NONE);
        let actual_wedge = actual_triangle.map_or(NONE, |triangle| triangle.wedge);
        let wedge = self.code_wedge(coder, CodedWedge { actual_wedge, target: split }, previous, out);
        out.wedges.push(wedge);
        let last = out.groups.last().copied().or(growth.groups.last().copied());
        let choices = ([group, last, None], 0..growth.group_count.max(1));
        out.groups.push(self.choose(
            coder,
            ChoiceKind::Group,
            choices,
            actual_triangle.map_or(0, |triangle| triangle.group),
        ));
    }

    /// Codes the wedges of the new position that no corner uses.
    fn code_unused_wedges<C: Coder>(
        &mut self,
        coder: &mut C,
        LevelBefore { growth, max_extra_wedges, .. }: LevelBefore<'_>,
        actual: Option<&ReferenceStep>,
        out: &mut CodedStep,
    ) {
        let mut used = out.reference_wedges.clone();
        used.sort_unstable();
        let wedges = actual.map_or(0..0, |step| step.wedges.clone());
        let mut unused = wedges.filter(|wedge| used.binary_search(wedge).is_err());
        let split = out.split as usize;
        let all = growth.first_vertex[split]..growth.first_vertex[split + 1];
        loop {
            let next = unused.next();
            let count = out.targets.len() as u64;
            let is_full = count > max_extra_wedges;
            if count > 0 && (is_full || !self.has_more[usize::from(count > 1)].code(coder, next.is_some())) {
                return;
            }
            let target = next.and_then(|wedge| actual?.target_of(wedge)).unwrap_or(NONE);
            let guesses = [out.targets.last().copied(), Some(all.start), None];
            out.targets.push(self.choose(coder, ChoiceKind::Target, (guesses, all.clone()), target));
            out.reference_wedges.push(next.unwrap_or(NONE));
        }
    }
}
