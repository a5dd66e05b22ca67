//! Writes what an instance shows for a GPU: as a triangle list, as fans or as strips.
//!
//! Each active vertex reads from its own entry which of its arcs are active, and writes them; this does
//! not depend on any other vertex. So a single pass over the vertices serves all groups, and sections of
//! the pass can run in parallel with separate output buffers. Concatenated in order, these are byte for
//! byte the output of a sequential pass.
//!
//! A connected run of arcs is a triangle fan (`glDrawFanL` in \[Cor01\], section 3.6.3); on a closed ring,
//! a run across the end of the mask is one fan rather than two. Current GPUs do not draw fans, so a run
//! can also be written as a strip; see `fan_form.rs`.
//!
//! Cost: linear in the number of active vertices, plus a scan of one 64-bit word per 64 steps. On the bunny,
//! at any level, the average run has 3.1 triangles, and a triangle takes 3 indices in a list, 2.24 in strips
//! and 1.97 in fans. With several groups, the indices of all groups but the first are copied once.

mod fan_form;
mod index_sink;
mod walk;

pub use fan_form::{FanForm, fan_triangles_into};

use std::ops::Range;

use self::fan_form::{write_fans, write_strips};
pub(super) use self::index_sink::IndexSink;
pub(super) use self::walk::Span;
use self::walk::{Collapsed, CollapsedSteps, for_each_fan, for_each_step};
use super::quick_table::{FanRecord, FanRecords, RecordNumber};
use super::{FanInstance, Fans, FansLevel};
use crate::model::DrawCounts;

/// With fewer active vertices and steps than this, a single thread is faster.
#[cfg(feature = "parallel")]
const MIN_PARALLEL_COUNT: usize = 8192;

/// Indices of an instance and the range that draws each group. Reuse it from frame to frame to avoid
/// allocation.
#[derive(Clone, Debug, Default)]
pub struct FanIndices {
    /// All indices. In the forms with restarts, a [`RESTART`](crate::strip::RESTART) separates the ranges
    /// of two groups, so that all groups can be drawn with one call.
    pub indices: Vec<u32>,
    /// For each group, its range of `indices`.
    pub group_ranges: Vec<Range<u32>>,
    /// Scratch for the indices of all groups but the first.
    others: Vec<IndexSink>,
}

impl FanInstance {
    /// Appends the triangles of one group.
    ///
    /// # Panics
    /// If the instance belongs to a different table, or the group does not exist.
    pub fn group_indices_into(&self, fans: &Fans, group: usize, out: &mut Vec<u32>) {
        self.check_table(fans);
        assert!(group < fans.group_count, "group {group} of {}", fans.group_count);
        for_each_fan(fans, self, Span::whole(fans), |fan, mask| {
            if fan.group as usize == group {
                fan.triangles_into(mask, out);
            }
        });
    }

    /// Writes what the instance shows in the given form, group by group, replacing the contents of `out`.
    ///
    /// # Panics
    /// If the instance belongs to a different table.
    pub fn emit_into(&self, fans: &Fans, form: FanForm, out: &mut FanIndices) {
        self.check_table(fans);
        out.replace(fans, self, form);
    }

    /// Writes the same indices as [`emit_into`](Self::emit_into), using all threads.
    ///
    /// # Panics
    /// If the instance belongs to a different table.
    #[cfg(feature = "parallel")]
    pub fn emit_parallel_into(&self, fans: &Fans, form: FanForm, out: &mut FanIndices) {
        self.check_table(fans);
        out.replace_parallel(fans, self, form);
    }

    /// Appends the triangles that the instance shows, three indices each, group by group.
    ///
    /// # Panics
    /// If the instance belongs to a different table.
    pub fn indices_into(&self, fans: &Fans, out: &mut Vec<u32>) {
        self.check_table(fans);
        append_all(fans, self, FanForm::Triangles, out);
    }

    /// Appends the fans that the instance shows: a pivot and nodes of its ring each, separated by
    /// [`RESTART`](crate::strip::RESTART).
    ///
    /// # Panics
    /// If the instance belongs to a different table.
    pub fn fans_into(&self, fans: &Fans, out: &mut Vec<u32>) {
        self.check_table(fans);
        append_all(fans, self, FanForm::Fans, out);
    }

    /// Appends the fans that the instance shows as strips, separated by [`RESTART`](crate::strip::RESTART).
    ///
    /// # Panics
    /// If the instance belongs to a different table.
    pub fn strips_into(&self, fans: &Fans, out: &mut Vec<u32>) {
        self.check_table(fans);
        append_all(fans, self, FanForm::Strips, out);
    }

    /// Counts what is needed to draw all groups in a form, without writing the indices.
    ///
    /// # Panics
    /// If the instance belongs to a different table.
    pub fn draw_counts(&self, fans: &Fans, form: FanForm) -> DrawCounts {
        self.check_table(fans);
        counts(fans, self, form)
    }
}

impl Fans {
    /// Writes a uniform level in the given form, group by group, replacing the contents of `out`.
    ///
    /// # Panics
    /// If the level belongs to a different table.
    pub fn emit_level_into(&self, level: &FansLevel, form: FanForm, out: &mut FanIndices) {
        level.check_table(self);
        out.replace(self, level, form);
    }

    /// Writes the same indices as [`emit_level_into`](Self::emit_level_into), using all threads.
    ///
    /// # Panics
    /// If the level belongs to a different table.
    #[cfg(feature = "parallel")]
    pub fn emit_level_parallel_into(&self, level: &FansLevel, form: FanForm, out: &mut FanIndices) {
        level.check_table(self);
        out.replace_parallel(self, level, form);
    }

    /// Counts what is needed to draw a uniform level in a form.
    ///
    /// # Panics
    /// If the level belongs to a different table.
    pub fn level_draw_counts(&self, level: &FansLevel, form: FanForm) -> DrawCounts {
        level.check_table(self);
        counts(self, level, form)
    }
}

/// Appends what is shown to the caller's indices.
pub(super) fn append_all(fans: &Fans, shown: &impl CollapsedSteps, form: FanForm, out: &mut Vec<u32>) {
    let start = out.len();
    let mut all = FanIndices { indices: std::mem::take(out), ..FanIndices::default() };
    all.append(fans, shown, form, start);
    *out = all.indices;
}

/// Compares the output only, not the scratch memory.
impl PartialEq for FanIndices {
    fn eq(&self, other: &Self) -> bool {
        self.indices == other.indices && self.group_ranges == other.group_ranges
    }
}

impl Eq for FanIndices {}

impl FanIndices {
    /// Replaces the contents by what is shown, in one sequential pass.
    fn replace(&mut self, fans: &Fans, shown: &impl CollapsedSteps, form: FanForm) {
        self.group_ranges.clear();
        self.append(fans, shown, form, 0);
    }

    /// Writes what is shown behind the first `start` indices, in one sequential pass.
    fn append(&mut self, fans: &Fans, shown: &impl CollapsedSteps, form: FanForm, start: usize) {
        let mut first = IndexSink::new(std::mem::take(&mut self.indices), start);
        let mut others = std::mem::take(&mut self.others);
        others.resize_with(fans.group_count - 1, IndexSink::default);
        others.iter_mut().for_each(IndexSink::restart);
        let outputs = &mut GroupOutputs { first: &mut first, others: &mut others };
        write(fans, shown, form, Span::whole(fans), outputs);
        self.indices = first.into_indices();
        self.close_group(start..self.indices.len(), form);
        for group in &others {
            let first = self.indices.len();
            self.indices.extend_from_slice(group.indices());
            self.close_group(first..self.indices.len(), form);
        }
        self.others = others;
        self.finish(start, form);
    }

    /// Replaces the contents by what is shown, running sections of the pass on all threads. The old
    /// indices are kept until overwritten, which saves clearing the memory.
    #[cfg(feature = "parallel")]
    fn replace_parallel(&mut self, fans: &Fans, shown: &(impl CollapsedSteps + Sync), form: FanForm) {
        use rayon::prelude::*;
        if shown.active_count(fans) < MIN_PARALLEL_COUNT {
            return self.replace(fans, shown, form);
        }
        let spans = Span::pieces(fans).into_par_iter();
        let pieces: Vec<Vec<IndexSink>> = spans.map(|span| groups_of(fans, shown, form, span)).collect();
        let total = pieces.iter().flatten().map(IndexSink::len).sum();
        self.group_ranges.clear();
        self.indices.resize(total, 0);
        let (mut copies, mut rest, mut at) = (Vec::new(), &mut self.indices[..], 0);
        let mut firsts = Vec::with_capacity(fans.group_count);
        for group in 0..fans.group_count {
            firsts.push(at);
            for piece in pieces.iter().map(|groups| groups[group].indices()) {
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

    /// Adds the range of a group that has been written, without the restart behind it.
    fn close_group(&mut self, written: Range<usize>, form: FanForm) {
        let has_restart = form != FanForm::Triangles && !written.is_empty();
        self.group_ranges.push(written.start as u32..(written.end - usize::from(has_restart)) as u32);
    }

    /// Removes the restart after the last fan, unless nothing has been written since `start`.
    fn finish(&mut self, start: usize, form: FanForm) {
        if form != FanForm::Triangles && self.indices.len() > start {
            self.indices.pop();
        }
        let end = self.indices.len() as u32;
        // Empty groups at the end began behind that restart.
        self.group_ranges.iter_mut().for_each(|range| range.start = range.start.min(end));
        self.group_ranges.iter_mut().for_each(|range| range.end = range.end.min(end));
    }
}

fn counts(fans: &Fans, shown: &impl CollapsedSteps, form: FanForm) -> DrawCounts {
    let mut counts = DrawCounts::default();
    for_each_fan(fans, shown, Span::whole(fans), |fan, mask| form.count(&fan, mask, &mut counts));
    if form != FanForm::Triangles {
        counts.index_count = counts.index_count.saturating_sub(1);
    }
    counts
}

/// Returns the indices of a section of the pass, group by group.
#[cfg(feature = "parallel")]
fn groups_of(fans: &Fans, shown: &impl CollapsedSteps, form: FanForm, span: Span) -> Vec<IndexSink> {
    let mut groups = vec![IndexSink::default(); fans.group_count];
    if let [first, others @ ..] = &mut groups[..] {
        // A vertex has about two triangles.
        *first = IndexSink::new(Vec::with_capacity(7 * span.active_count(shown)), 0);
        write(fans, shown, form, span, &mut GroupOutputs { first, others });
    }
    groups
}

/// Output buffers of all groups.
pub(super) struct GroupOutputs<'a> {
    first: &'a mut IndexSink,
    others: &'a mut [IndexSink],
}

impl<'a> GroupOutputs<'a> {
    /// Outputs to one buffer for each group.
    ///
    /// # Panics
    /// If there are none.
    pub(super) fn new(sinks: &'a mut [IndexSink]) -> Self {
        let (first, others) = sinks.split_first_mut().expect("a mesh has a group");
        Self { first, others }
    }

    #[inline(always)]
    fn of(&mut self, group: u32) -> &mut IndexSink {
        if group == 0 { self.first } else { &mut self.others[group as usize - 1] }
    }
}

/// Writes a section of the pass, with a restart after each fan or strip.
fn write(
    fans: &Fans,
    shown: &impl CollapsedSteps,
    form: FanForm,
    span: Span,
    outputs: &mut GroupOutputs<'_>,
) {
    // Each arm instantiates its own loop, so that the code for a fan is inlined.
    match form {
        FanForm::Triangles => write_triangles(fans, shown, span, outputs),
        FanForm::Fans => for_each_fan(fans, shown, span, |fan, mask| {
            outputs.of(fan.group).append(|out| write_fans(&fan, mask, out));
        }),
        FanForm::Strips => for_each_fan(fans, shown, span, |fan, mask| {
            outputs.of(fan.group).append(|out| write_strips(&fan, mask, out));
        }),
    }
}

/// Writes the triangles of a section of the pass.
pub(super) fn write_triangles(
    fans: &Fans,
    shown: &impl CollapsedSteps,
    span: Span,
    outputs: &mut GroupOutputs<'_>,
) {
    let shown = shown.collapsed();
    match &fans.quick().records {
        FanRecords::Small(records) => write_records(fans, records, shown, span, outputs),
        FanRecords::Medium(records) => write_records(fans, records, shown, span, outputs),
        FanRecords::Large(records) => write_records(fans, records, shown, span, outputs),
    }
}

/// Writes the triangles of a section of the pass, with records for most vertices.
fn write_records<N: RecordNumber>(
    fans: &Fans,
    records: &[FanRecord<N>],
    shown: impl Collapsed,
    span: Span,
    outputs: &mut GroupOutputs<'_>,
) {
    for vertex in span.base {
        write_vertex((fans, records), shown, (vertex, 0), outputs);
    }
    if fans.vertices.firsts.is_empty() && fans.group_count == 1 {
        let base = fans.vertices.base_vertex_count;
        for_each_step(shown, &span.steps, |step| {
            let (record, vertex) = (&records[(base + step) as usize], base + step);
            if record.is_complete() {
                let mask = record.mask(step + 1, |step| shown.bit(step));
                outputs.first.push_record(record, vertex, mask);
            } else {
                write_entry(fans, shown, vertex, step + 1, outputs);
            }
        });
    } else {
        for_each_step(shown, &span.steps, |step| {
            for vertex in fans.vertices.of_step(step as usize) {
                write_vertex((fans, records), shown, (vertex, step + 1), outputs);
            }
        });
    }
}

/// Writes the triangles of a vertex, given with its step plus 1, or 0 in the base.
#[inline(never)]
fn write_vertex<N: RecordNumber>(
    (fans, records): (&Fans, &[FanRecord<N>]),
    shown: impl Collapsed,
    (vertex, own_step): (u32, u32),
    outputs: &mut GroupOutputs<'_>,
) {
    let record = &records[vertex as usize];
    if record.is_complete() {
        let mask = record.mask(own_step, |step| shown.bit(step));
        outputs.of(fans.quick().group(vertex)).push_record(record, vertex, mask);
    } else {
        write_entry(fans, shown, vertex, own_step, outputs);
    }
}

/// Writes the triangles of a vertex of any kind.
#[inline(never)]
fn write_entry(
    fans: &Fans,
    shown: impl Collapsed,
    vertex: u32,
    own_step: u32,
    outputs: &mut GroupOutputs<'_>,
) {
    for fan in fans.table.entry(vertex, own_step) {
        let mask = fan.mask(|step| shown.has(step));
        outputs.of(fan.group).push(&fan, mask);
    }
}
