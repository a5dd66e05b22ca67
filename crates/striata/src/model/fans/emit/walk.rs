//! The pass over everything that is active: base vertices first, then steps, 64 per word.

use std::ops::Range;

use super::super::table::FanView;
use super::super::{FanInstance, Fans, FansLevel};

/// Number of base vertices, or of steps, in one section of a parallel pass.
#[cfg(feature = "parallel")]
const PIECE: usize = 4096;

/// The set of collapsed steps; small, so that it stays in registers.
pub(in super::super) trait Collapsed: Copy {
    /// Whether a step is collapsed.
    fn has(self, step: u32) -> bool;

    /// Returns 1 if a step is collapsed, otherwise 0.
    fn bit(self, step: u32) -> u64;

    /// Returns a word of 64 steps, low bits first, with the bits of the refined ones set.
    fn active_word(self, word: usize) -> u64;
}

/// The steps that an instance has collapsed.
#[derive(Clone, Copy)]
pub(in super::super) struct CollapsedBits<'a> {
    words: &'a [u64],
    step_count: usize,
}

impl Collapsed for CollapsedBits<'_> {
    #[inline(always)]
    fn has(self, step: u32) -> bool {
        self.bit(step) != 0
    }

    #[inline(always)]
    fn bit(self, step: u32) -> u64 {
        self.words[step as usize / 64] >> (step % 64) & 1
    }

    #[inline(always)]
    fn active_word(self, word: usize) -> u64 {
        !self.words[word] & first_bits(self.step_count - 64 * word)
    }
}

impl Collapsed for FansLevel {
    #[inline(always)]
    fn has(self, step: u32) -> bool {
        step as usize >= self.split_count
    }

    #[inline(always)]
    fn bit(self, step: u32) -> u64 {
        u64::from(self.has(step))
    }

    #[inline(always)]
    fn active_word(self, word: usize) -> u64 {
        first_bits(self.split_count.saturating_sub(64 * word))
    }
}

/// Something with a set of collapsed steps.
pub(in super::super) trait CollapsedSteps {
    /// The set.
    type Collapsed<'a>: Collapsed
    where
        Self: 'a;

    /// Returns the set.
    fn collapsed(&self) -> Self::Collapsed<'_>;

    /// Number of base vertices plus refined steps.
    #[cfg(feature = "parallel")]
    fn active_count(&self, fans: &Fans) -> usize
    where
        Self: Sized,
    {
        Span::whole(fans).active_count(self)
    }
}

impl CollapsedSteps for FanInstance {
    type Collapsed<'a> = CollapsedBits<'a>;

    #[inline]
    fn collapsed(&self) -> CollapsedBits<'_> {
        CollapsedBits { words: self.collapsed.words(), step_count: self.step_count }
    }
}

impl CollapsedSteps for FansLevel {
    type Collapsed<'a> = Self;

    #[inline]
    fn collapsed(&self) -> Self {
        *self
    }
}

impl FansLevel {
    pub(super) fn check_table(self, fans: &Fans) {
        assert!(self.split_count <= fans.step_count, "the level belongs to a different table");
    }
}

/// Returns a word with its lowest `count` bits set, at most 64.
#[inline]
fn first_bits(count: usize) -> u64 {
    if count < 64 { (1 << count) - 1 } else { u64::MAX }
}

/// A section of the pass.
#[derive(Clone, Debug)]
pub(in super::super) struct Span {
    pub base: Range<u32>,
    pub steps: Range<u32>,
}

impl Span {
    pub(super) fn whole(fans: &Fans) -> Self {
        Self { base: 0..fans.vertices.base_vertex_count, steps: 0..fans.step_count as u32 }
    }

    /// Number of base vertices plus refined steps in the section.
    #[cfg(feature = "parallel")]
    pub(super) fn active_count(&self, shown: &impl CollapsedSteps) -> usize {
        let shown = shown.collapsed();
        let words = words_of(&self.steps).map(|(word, mask)| shown.active_word(word) & mask);
        self.base.len() + words.map(|word| word.count_ones() as usize).sum::<usize>()
    }

    /// Splits the whole pass into sections, in order.
    #[cfg(feature = "parallel")]
    pub(super) fn pieces(fans: &Fans) -> Vec<Self> {
        let Self { base, steps } = Self::whole(fans);
        let cut = |end: u32| (0..end).step_by(PIECE).map(move |first| first..end.min(first + PIECE as u32));
        let bases = cut(base.end).map(|base| Self { base, steps: 0..0 });
        bases.chain(cut(steps.end).map(|steps| Self { base: 0..0, steps })).collect()
    }
}

/// Returns the words of a range of steps, each with a mask of the bits in the range.
#[inline(always)]
fn words_of(steps: &Range<u32>) -> impl Iterator<Item = (usize, u64)> + use<> {
    let Range { start, end } = *steps;
    (start / 64..end.div_ceil(64)).map(move |word| {
        let first = 64 * word;
        let below = |step: u32| first_bits(step.saturating_sub(first) as usize);
        (word as usize, below(end) & !below(start))
    })
}

/// Visits the fans of all active vertices of a section, each with the mask of its active arcs.
#[inline]
pub(super) fn for_each_fan(
    fans: &Fans,
    shown: &impl CollapsedSteps,
    span: Span,
    mut visit: impl FnMut(FanView<'_>, u32),
) {
    let shown = shown.collapsed();
    let mut visit_vertex = |vertex: u32, own_step: u32| {
        // A loop rather than `for_each`, whose closure would be called for each fan with a copy of it in
        // memory.
        for fan in fans.table.entry(vertex, own_step) {
            let mask = fan.mask(|step| shown.has(step));
            visit(fan, mask);
        }
    };
    for vertex in span.base {
        visit_vertex(vertex, 0);
    }
    for_each_step(shown, &span.steps, |step| {
        for vertex in fans.vertices.of_step(step as usize) {
            visit_vertex(vertex, step + 1);
        }
    });
}

/// Visits all refined steps of a range.
#[inline(always)]
pub(super) fn for_each_step(shown: impl Collapsed, steps: &Range<u32>, mut visit: impl FnMut(u32)) {
    for (word, mask) in words_of(steps) {
        let mut active = shown.active_word(word) & mask;
        while active != 0 {
            let step = 64 * word as u32 + active.trailing_zeros();
            active &= active - 1;
            visit(step);
        }
    }
}
