//! Index lists of the shown level, group by group, and which of them have changed.

use std::ops::Range;

use striata::model::{PatternInstance, StripModel};
use striata::strip::RESTART;

use crate::window::mesh_subject::MeshSubject;

/// Indices that must be uploaded.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(in crate::window) enum Changes {
    /// Nothing has changed.
    None,
    /// Only these ranges have changed.
    Ranges(Vec<Range<u32>>),
    /// Everything may have changed.
    All,
}

/// Indices to draw.
#[derive(Clone, Copy, Debug)]
pub(in crate::window) struct DrawIndices<'a> {
    pub indices: &'a [u32],
    /// Index range of each group.
    pub groups: &'a [Range<u32>],
    /// Whether these are strips with restart indices, rather than a triangle list.
    pub is_strips: bool,
}

/// Writes the triangles of patterns, group by group.
pub(super) fn patterns_into(
    instance: &PatternInstance,
    group_count: usize,
    indices: &mut Vec<u32>,
    groups: &mut Vec<Range<u32>>,
) {
    let mut triangles = Vec::with_capacity(instance.triangle_count());
    ranges_of_groups(group_count, groups, |group| {
        instance.group_triangles_into(group as u32, &mut triangles);
        3 * triangles.len()
    });
    indices.clear();
    indices.extend_from_slice(triangles.as_flattened());
}

/// Writes the triangles of a level, computed by direct substitution.
pub(super) fn list_into(
    subject: &MeshSubject,
    split_count: usize,
    indices: &mut Vec<u32>,
    groups: &mut Vec<Range<u32>>,
) {
    let level = subject.steps.level(split_count);
    indices.clear();
    indices.extend_from_slice(level.triangles.as_flattened());
    groups.clear();
    groups.extend(level.groups_or_whole().iter().map(|group| {
        let range = group.range();
        3 * range.start as u32..3 * range.end as u32
    }));
}

/// Writes all strips with restart indices, group by group.
pub(super) fn strips_into<M: StripModel>(
    model: &M,
    state: &M::State,
    indices: &mut Vec<u32>,
    groups: &mut Vec<Range<u32>>,
) {
    indices.clear();
    ranges_of_groups(model.group_count(), groups, |group| {
        for strip in model.group_strips(group) {
            let strip = model.strip(state, strip);
            if !strip.is_empty() {
                indices.extend_from_slice(strip);
                indices.push(RESTART);
            }
        }
        indices.len()
    });
}

/// Computes the consecutive ranges of the groups; `end` writes a group and returns where it ends.
fn ranges_of_groups(group_count: usize, groups: &mut Vec<Range<u32>>, mut end: impl FnMut(usize) -> usize) {
    groups.clear();
    let mut first = 0;
    for group in 0..group_count {
        let end = end(group) as u32;
        groups.push(first..end);
        first = end;
    }
}

/// Adds changed ranges to those that must be uploaded.
pub(super) fn add_ranges(changes: &mut Changes, mut ranges: Vec<Range<u32>>) {
    match changes {
        Changes::All => {}
        _ if ranges.is_empty() => {}
        Changes::None => *changes = Changes::Ranges(ranges),
        Changes::Ranges(before) => {
            before.append(&mut ranges);
            before.sort_unstable_by_key(|range| range.start);
        }
    }
}
