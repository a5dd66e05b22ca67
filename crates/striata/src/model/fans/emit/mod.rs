//! What is shown, written for a GPU: as a list of triangles, as fans or as strips.
//!
//! Each vertex that is there asks its entry which arcs are there and writes them: nothing depends on any other vertex. So one
//! walk over the vertices does for all groups, and stretches of the walk may run beside each other, each into memory of its
//! own; their pieces in order are the same bytes that one walk makes.
//!
//! A connected run of arcs is a triangle fan (`glDrawFanL` of \[Cor01\], section 3.6.3); on a closed ring a run that passes the
//! end of its masks is one fan and not two. GPUs of today draw no fans, so a run may also be a strip, see `form.rs`.
//!
//! Cost: linear in the vertices that are there, beside a look at each 64 steps. On the bunny, at any level, a run is 3.1
//! triangles long, and a triangle takes 3 indices in a list, 2.24 in strips and 1.97 in fans. Several groups take a copy of what all but the
//! first show.

mod form;
mod walk;

pub use form::{FanForm, fan_triangles_into};

use std::ops::Range;

use self::form::{write_fans, write_strips};
use self::walk::{Shown, Span, for_each_fan};
use super::{FanInstance, Fans, FansLevel};
use crate::model::DrawCounts;

/// Fewer vertices than this are written sooner by one thread.
#[cfg(feature = "parallel")]
const WORTH_THREADS: usize = 8192;

/// Indices of an instance and the range that draws each group; kept from frame to frame, it needs no new memory.
#[derive(Clone, Debug, Default)]
pub struct FanIndices {
    /// All indices. Between the ranges of two groups of fans or strips stands a
    /// [`RESTART`](crate::strip::RESTART), so that all may be drawn at once.
    pub indices: Vec<u32>,
    /// For each group, what to draw of `indices`.
    pub group_ranges: Vec<Range<u32>>,
    /// What all groups but the first show, until it is appended.
    others: Vec<Vec<u32>>,
}

impl FanInstance {
    /// Appends the triangles of one group.
    ///
    /// # Panics
    /// If the instance is of another table, or there is no such group.
    pub fn group_indices_into(&self, fans: &Fans, group: usize, out: &mut Vec<u32>) {
        self.check_table(fans);
        assert!(group < fans.group_count, "group {group} of {}", fans.group_count);
        for_each_fan(fans, self, Span::whole(fans), |fan, mask| {
            if fan.group as usize == group {
                fan.triangles_into(mask, out);
            }
        });
    }

    /// Writes what the instance shows in the given form, group by group; replaces what `out` held.
    ///
    /// # Panics
    /// If the instance is of another table.
    pub fn emit_into(&self, fans: &Fans, form: FanForm, out: &mut FanIndices) {
        self.check_table(fans);
        out.clear();
        out.append(fans, self, form);
    }

    /// Does as [`emit_into`](Self::emit_into) on all threads; the same indices come out.
    ///
    /// # Panics
    /// If the instance is of another table.
    #[cfg(feature = "parallel")]
    pub fn emit_parallel_into(&self, fans: &Fans, form: FanForm, out: &mut FanIndices) {
        self.check_table(fans);
        out.replace_parallel(fans, self, form);
    }

    /// Appends the triangles that the instance shows, three indices each, group after group.
    ///
    /// # Panics
    /// If the instance is of another table.
    pub fn indices_into(&self, fans: &Fans, out: &mut Vec<u32>) {
        self.check_table(fans);
        append_all(fans, self, FanForm::Triangles, out);
    }

    /// Appends the fans that the instance shows, a pivot and nodes of its ring each, with a
    /// [`RESTART`](crate::strip::RESTART) between two.
    ///
    /// # Panics
    /// If the instance is of another table.
    pub fn fans_into(&self, fans: &Fans, out: &mut Vec<u32>) {
        self.check_table(fans);
        append_all(fans, self, FanForm::Fans, out);
    }

    /// Appends the fans that the instance shows as strips, with a [`RESTART`](crate::strip::RESTART) between two.
    ///
    /// # Panics
    /// If the instance is of another table.
    pub fn strips_into(&self, fans: &Fans, out: &mut Vec<u32>) {
        self.check_table(fans);
        append_all(fans, self, FanForm::Strips, out);
    }

    /// What drawing all groups in a form takes, without making the indices.
    ///
    /// # Panics
    /// If the instance is of another table.
    pub fn draw_counts(&self, fans: &Fans, form: FanForm) -> DrawCounts {
        self.check_table(fans);
        counts(fans, self, form)
    }
}

impl Fans {
    /// Writes a uniform level in the given form, group by group; replaces what `out` held.
    ///
    /// # Panics
    /// If the level is of another table.
    pub fn emit_level_into(&self, level: &FansLevel, form: FanForm, out: &mut FanIndices) {
        level.check_table(self);
        out.clear();
        out.append(self, level, form);
    }

    /// Does as [`emit_level_into`](Self::emit_level_into) on all threads; the same indices come out.
    ///
    /// # Panics
    /// If the level is of another table.
    #[cfg(feature = "parallel")]
    pub fn emit_level_parallel_into(&self, level: &FansLevel, form: FanForm, out: &mut FanIndices) {
        level.check_table(self);
        out.replace_parallel(self, level, form);
    }

    /// What drawing a uniform level in a form takes.
    ///
    /// # Panics
    /// If the level is of another table.
    pub fn level_draw_counts(&self, level: &FansLevel, form: FanForm) -> DrawCounts {
        level.check_table(self);
        counts(self, level, form)
    }
}

/// Appends what is shown to indices of the caller.
pub(super) fn append_all(fans: &Fans, shown: &impl Shown, form: FanForm, out: &mut Vec<u32>) {
    let mut all = FanIndices { indices: std::mem::take(out), ..FanIndices::default() };
    all.append(fans, shown, form);
    *out = all.indices;
}

/// What has been written is the same, however it was.
impl PartialEq for FanIndices {
    fn eq(&self, other: &Self) -> bool {
        self.indices == other.indices && self.group_ranges == other.group_ranges
    }
}

impl Eq for FanIndices {}

impl FanIndices {
    fn clear(&mut self) {
        self.indices.clear();
        self.group_ranges.clear();
    }

    /// Appends what is shown, in one walk.
    fn append(&mut self, fans: &Fans, shown: &impl Shown, form: FanForm) {
        let start = self.indices.len();
        let mut others = std::mem::take(&mut self.others);
        others.resize_with(fans.group_count - 1, Vec::new);
        others.iter_mut().for_each(Vec::clear);
        write(
            fans,
            shown,
            form,
            Span::whole(fans),
            &mut Sinks { first: &mut self.indices, others: &mut others },
        );
        self.close_group(start..self.indices.len(), form);
        for group in &others {
            let first = self.indices.len();
            self.indices.extend_from_slice(group);
            self.close_group(first..self.indices.len(), form);
        }
        self.others = others;
        self.finish(start, form);
    }

    /// Writes what is shown: stretches of the walk on all threads, their pieces in order. What the indices were before only
    /// spares making room for them.
    #[cfg(feature = "parallel")]
    fn replace_parallel(&mut self, fans: &Fans, shown: &(impl Shown + Sync), form: FanForm) {
        use rayon::prelude::*;
        if shown.there_count(fans) < WORTH_THREADS {
            self.clear();
            return self.append(fans, shown, form);
        }
        let spans = Span::pieces(fans).into_par_iter();
        let pieces: Vec<Vec<Vec<u32>>> = spans.map(|span| groups_of(fans, shown, form, span)).collect();
        let total = pieces.iter().flatten().map(Vec::len).sum();
        self.group_ranges.clear();
        self.indices.resize(total, 0);
        let (mut copies, mut rest, mut at) = (Vec::new(), &mut self.indices[..], 0);
        let mut firsts = Vec::with_capacity(fans.group_count);
        for group in 0..fans.group_count {
            firsts.push(at);
            for piece in pieces.iter().map(|groups| &groups[group]) {
                let (to, behind) = rest.split_at_mut(piece.len());
                (rest, at) = (behind, at + piece.len());
                copies.push((to, piece));
            }
        }
        copies.into_par_iter().for_each(|(to, piece)| to.copy_from_slice(piece));
        let ends = firsts.iter().skip(1).copied().chain([total]);
        firsts.iter().zip(ends).for_each(|(&first, end)| self.close_group(first..end, form));
        self.finish(0, form);
    }

    /// Notes the range of a group that has been written, without the restart behind it.
    fn close_group(&mut self, written: Range<usize>, form: FanForm) {
        let has_restart = form != FanForm::Triangles && !written.is_empty();
        self.group_ranges.push(written.start as u32..(written.end - usize::from(has_restart)) as u32);
    }

    /// Takes away the restart behind the last fan, unless nothing has been written from `start` on.
    fn finish(&mut self, start: usize, form: FanForm) {
        if form != FanForm::Triangles && self.indices.len() > start {
            self.indices.pop();
        }
        let end = self.indices.len() as u32;
        // Empty groups at the end stood behind it.
        self.group_ranges.iter_mut().for_each(|range| range.start = range.start.min(end));
        self.group_ranges.iter_mut().for_each(|range| range.end = range.end.min(end));
    }
}

fn counts(fans: &Fans, shown: &impl Shown, form: FanForm) -> DrawCounts {
    let mut counts = DrawCounts::default();
    for_each_fan(fans, shown, Span::whole(fans), |fan, mask| form.count(&fan, mask, &mut counts));
    if form != FanForm::Triangles {
        counts.index_count = counts.index_count.saturating_sub(1);
    }
    counts
}

/// What a stretch of the walk shows, group by group.
#[cfg(feature = "parallel")]
fn groups_of(fans: &Fans, shown: &impl Shown, form: FanForm, span: Span) -> Vec<Vec<u32>> {
    let mut groups = vec![Vec::new(); fans.group_count];
    if let [first, others @ ..] = &mut groups[..] {
        // A vertex has two triangles, more or less.
        first.reserve(7 * span.there_count(shown));
        write(fans, shown, form, span, &mut Sinks { first, others });
    }
    groups
}

/// Where the triangles of each group go.
struct Sinks<'a> {
    first: &'a mut Vec<u32>,
    others: &'a mut [Vec<u32>],
}

impl Sinks<'_> {
    #[inline]
    fn of(&mut self, group: u32) -> &mut Vec<u32> {
        if group == 0 { self.first } else { &mut self.others[group as usize - 1] }
    }
}

/// Writes a stretch of the walk; behind each fan and strip stands a restart.
fn write(fans: &Fans, shown: &impl Shown, form: FanForm, span: Span, sinks: &mut Sinks<'_>) {
    // Each arm is a walk of its own, with what it does to a fan compiled into it.
    match form {
        FanForm::Triangles => {
            for_each_fan(fans, shown, span, |fan, mask| fan.triangles_into(mask, sinks.of(fan.group)));
        }
        FanForm::Fans => {
            for_each_fan(fans, shown, span, |fan, mask| write_fans(&fan, mask, sinks.of(fan.group)));
        }
        FanForm::Strips => {
            for_each_fan(fans, shown, span, |fan, mask| write_strips(&fan, mask, sinks.of(fan.group)));
        }
    }
}
