//! The pass over everything that is active: base vertices first, then steps, 64 per word.

use std::ops::Range;

use super::super::table::FanView;
use super::super::{FanInstance, Fans, FansLevel};

/// Number of base vertices, or of steps, in one section of a parallel pass.
#[cfg(feature = "parallel")]
const PIECE: usize = 4096;

/// A set of collapsed steps.
pub(in super::super) trait Shown {
    /// Whether a step is collapsed.
    fn is_collapsed(&self, step: u32) -> bool;

    /// Returns a word of 64 steps, low bits first, with the bits of the refined ones set.
    fn active_word(&self, word: usize) -> u64;

    /// Number of base vertices plus refined steps.
    #[cfg(feature = "parallel")]
    fn active_count(&self, fans: &Fans) -> usize
    where
        Self: Sized,
    {
        Span::whole(fans).active_count(self)
    }
}

impl Shown for FanInstance {
    #[inline]
    fn is_collapsed(&self, step: u32) -> bool {
        !self.is_refined(step)
    }

    #[inline]
    fn active_word(&self, word: usize) -> u64 {
        !self.collapsed.words()[word] & first_bits(self.step_count - 64 * word)
    }
}

impl Shown for FansLevel {
    #[inline]
    fn is_collapsed(&self, step: u32) -> bool {
        step as usize >= self.split_count
    }

    #[inline]
    fn active_word(&self, word: usize) -> u64 {
        first_bits(self.split_count.saturating_sub(64 * word))
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
pub(super) struct Span {
    base: Range<u32>,
    words: Range<usize>,
}

impl Span {
    pub(super) fn whole(fans: &Fans) -> Self {
        Self { base: 0..fans.vertices.base_vertex_count, words: 0..fans.step_count.div_ceil(64) }
    }

    /// Number of base vertices plus refined steps in the section.
    #[cfg(feature = "parallel")]
    pub(super) fn active_count(&self, shown: &impl Shown) -> usize {
        let steps = self.words.clone().map(|word| shown.active_word(word).count_ones() as usize);
        self.base.len() + steps.sum::<usize>()
    }

    /// Splits the whole pass into sections, in order.
    #[cfg(feature = "parallel")]
    pub(super) fn pieces(fans: &Fans) -> Vec<Self> {
        let Self { base, words } = Self::whole(fans);
        let cut = |end: usize, piece: usize| {
            (0..end).step_by(piece).map(move |first| first..end.min(first + piece)).collect::<Vec<_>>()
        };
        let bases = cut(base.end as usize, PIECE).into_iter();
        let of_base = bases.map(|base| Self { base: base.start as u32..base.end as u32, words: 0..0 });
        of_base
            .chain(cut(words.end, PIECE / 64).into_iter().map(|words| Self { base: 0..0, words }))
            .collect()
    }
}

/// Visits the fans of all active vertices of a section, each with the mask of its active arcs.
#[inline]
pub(super) fn for_each_fan(
    fans: &Fans,
    shown: &impl Shown,
    span: Span,
    mut visit: impl FnMut(FanView<'_>, u32),
) {
    let mut visit = |fan: FanView<'_>| {
        let mask = fan.mask(|step| shown.is_collapsed(step));
        visit(fan, mask);
    };
    for vertex in span.base {
        // A loop rather than `for_each`, whose closure would be called for each fan with a copy of it in
        // memory.
        for fan in fans.base_entry(vertex) {
            visit(fan);
        }
    }
    for word in span.words {
        let mut active = shown.active_word(word);
        while active != 0 {
            let step = 64 * word as u32 + active.trailing_zeros();
            active &= active - 1;
            for vertex in fans.vertices.of_step(step as usize) {
                for fan in fans.step_entry(vertex, step) {
                    visit(fan);
                }
            }
        }
    }
}
