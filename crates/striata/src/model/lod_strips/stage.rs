//! One set of strips and the levels that it serves.

use std::borrow::Cow;

use super::record::RecordFormat;
use crate::model::stored_strips::StoredStrips;

/// A set of strips and the finest level that it serves.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Stage<'a> {
    pub split_count: usize,
    /// The strips at that level.
    pub strips: StoredStrips<'a>,
    /// The strips as [`walks`](super::walks) over the triangles of that level; empty for the full mesh.
    pub walks: Cow<'a, [u8]>,
    /// Widths of the numbers in its records.
    pub format: RecordFormat,
}

impl<'a> Stage<'a> {
    pub(super) fn new(split_count: usize, strips: StoredStrips<'a>, walks: Cow<'a, [u8]>) -> Self {
        let format = RecordFormat::new(strips.slot_count(), strips.strip_count());
        Self { split_count, strips, walks, format }
    }

    /// How a file announces the stage.
    pub(super) fn head(&self) -> StageHead {
        let strip_counts = self.strips.group_offsets.windows(2).map(|w| w[1] - w[0]).collect();
        StageHead { split_count: self.split_count, strip_counts }
    }

    pub(super) fn into_owned(self) -> Stage<'static> {
        let (strips, walks) = (self.strips.into_owned(), self.walks.into_owned().into());
        Stage { split_count: self.split_count, strips, walks, format: self.format }
    }
}

/// Split count and numbers of strips of a stage, which are known before its strips are read.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct StageHead {
    pub split_count: usize,
    /// Number of strips in each group.
    pub strip_counts: Vec<u32>,
}

/// First strip of each group, followed by the number of strips, where the strips of all stages count. The
/// strips of a group are numbered stage by stage.
pub(super) fn group_offsets(stages: &[Stage<'_>]) -> Vec<u32> {
    let group_count = stages[0].strips.group_offsets.len().saturating_sub(1);
    let mut offsets = vec![0; group_count + 1];
    for group in 0..group_count {
        let count: usize = stages.iter().map(|stage| strip_count(stage, group)).sum();
        offsets[group + 1] = offsets[group] + count as u32;
    }
    offsets
}

/// Number of strips that a stage has in a group; 0 if the stage has no such group, which is refused later.
fn strip_count(stage: &Stage<'_>, group: usize) -> usize {
    let offsets = &stage.strips.group_offsets;
    offsets.get(group + 1).map_or(0, |&end| (end - offsets[group]) as usize)
}

/// The stage of a strip, and its index among the strips of that stage.
///
/// # Panics
/// If the strip does not exist.
pub(super) fn place_of(stages: &[Stage<'_>], group_offsets: &[u32], strip: usize) -> (usize, usize) {
    if let [only] = stages {
        assert!(strip < only.strips.strip_count(), "strip {strip} of {}", only.strips.strip_count());
        return (0, strip);
    }
    let group = group_offsets.partition_point(|&first| first as usize <= strip) - 1;
    let mut rest = strip - group_offsets[group] as usize;
    for (index, stage) in stages.iter().enumerate() {
        let strips = stage.strips.group_strips(group);
        if rest < strips.len() {
            return (index, strips.start + rest);
        }
        rest -= strips.len();
    }
    panic!("there is no strip {strip}");
}
