//! The walk over what is there: vertices of the base, then steps, 64 at a look.

use std::ops::Range;

use super::super::table::FanView;
use super::super::{FanInstance, Fans, FansLevel};

/// Vertices of the base, or steps, that a thread takes at a time.
#[cfg(feature = "parallel")]
const PIECE: usize = 4096;

/// Says which steps are taken.
pub(in super::super) trait Shown {
    /// Whether a step is collapsed.
    fn is_taken(&self, step: u32) -> bool;

    /// Bits of 64 steps, low ones first: those that are there.
    fn there(&self, word: usize) -> u64;

    /// Vertices of the base and steps that are there.
    #[cfg(feature = "parallel")]
    fn there_count(&self, fans: &Fans) -> usize
    where
        Self: Sized,
    {
        Span::whole(fans).there_count(self)
    }
}

impl Shown for FanInstance {
    #[inline]
    fn is_taken(&self, step: u32) -> bool {
        !self.is_refined(step)
    }

    #[inline]
    fn there(&self, word: usize) -> u64 {
        !self.taken.words()[word] & first_bits(self.step_count - 64 * word)
    }
}

impl Shown for FansLevel {
    #[inline]
    fn is_taken(&self, step: u32) -> bool {
        step as usize >= self.split_count
    }

    #[inline]
    fn there(&self, word: usize) -> u64 {
        first_bits(self.split_count.saturating_sub(64 * word))
    }
}

impl FansLevel {
    pub(super) fn check_table(self, fans: &Fans) {
        assert!(self.split_count <= fans.step_count, "the level is of another table");
    }
}

/// The lowest so many bits, at most all.
#[inline]
fn first_bits(count: usize) -> u64 {
    if count < 64 { (1 << count) - 1 } else { u64::MAX }
}

/// A stretch of the walk.
#[derive(Clone, Debug)]
pub(super) struct Span {
    base: Range<u32>,
    words: Range<usize>,
}

impl Span {
    pub(super) fn whole(fans: &Fans) -> Self {
        Self { base: 0..fans.vertices.base_vertex_count, words: 0..fans.step_count.div_ceil(64) }
    }

    /// Vertices of the base and steps that are there.
    #[cfg(feature = "parallel")]
    pub(super) fn there_count(&self, shown: &impl Shown) -> usize {
        let steps = self.words.clone().map(|word| shown.there(word).count_ones() as usize);
        self.base.len() + steps.sum::<usize>()
    }

    /// The whole in stretches, in order.
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

/// Visits the fans of all vertices of a stretch that are there, each with those of its arcs that are.
#[inline]
pub(super) fn for_each_fan(
    fans: &Fans,
    shown: &impl Shown,
    span: Span,
    mut visit: impl FnMut(FanView<'_>, u32),
) {
    let mut visit = |fan: FanView<'_>| {
        let mask = fan.mask(|step| shown.is_taken(step));
        visit(fan, mask);
    };
    for vertex in span.base {
        // Loops, not `for_each`: its closure would be a call for each fan, which is handed over through memory.
        for fan in fans.base_entry(vertex) {
            visit(fan);
        }
    }
    for word in span.words {
        let mut there = shown.there(word);
        while there != 0 {
            let step = 64 * word as u32 + there.trailing_zeros();
            there &= there - 1;
            for vertex in fans.vertices.of_step(step as usize) {
                for fan in fans.step_entry(vertex, step) {
                    visit(fan);
                }
            }
        }
    }
}
