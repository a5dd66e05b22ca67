//! Strips that are repaired while the detail changes, a few milliseconds per frame.

use std::ops::Range;
use std::time::{Duration, Instant};

use striata_strip::{LiveStripBuffer, LiveStrips};

/// Time that a frame spends on steps. The rest of a longer way is left to the next frames.
const FRAME_TIME: Duration = Duration::from_millis(10);
/// Number of steps between two looks at the clock.
const STEPS_PER_CHECK: usize = 64;

/// Live strips and their index buffer.
#[derive(Debug)]
pub(super) struct ShownLiveStrips {
    strips: LiveStrips<'static>,
    buffer: LiveStripBuffer,
}

impl ShownLiveStrips {
    /// Starts with a copy of strips, which may be at any level.
    pub(super) fn new(strips: &LiveStrips<'static>) -> Self {
        let mut strips = strips.clone();
        let buffer = LiveStripBuffer::new(&mut strips);
        Self { strips, buffer }
    }

    /// Moves toward a level for the time of a frame. Returns whether anything changed.
    pub(super) fn follow(&mut self, split_count: usize) -> bool {
        let before = self.strips.split_count();
        let started = Instant::now();
        while self.strips.split_count() != split_count && started.elapsed() < FRAME_TIME {
            let at = self.strips.split_count();
            let next = split_count.clamp(at.saturating_sub(STEPS_PER_CHECK), at + STEPS_PER_CHECK);
            self.strips.move_to(next);
        }
        let is_changed = self.strips.split_count() != before;
        if is_changed {
            self.buffer.sync(&mut self.strips);
        }
        is_changed
    }

    /// Split count of the level that is shown.
    pub(super) fn split_count(&self) -> usize {
        self.strips.split_count()
    }

    pub(super) fn indices(&self) -> &[u32] {
        self.buffer.indices()
    }

    pub(super) fn group_ranges(&self) -> impl Iterator<Item = Range<u32>> {
        self.buffer.group_ranges()
    }

    /// The ranges of the indices that have changed since the last call.
    pub(super) fn take_changed_ranges(&mut self) -> Vec<Range<u32>> {
        self.buffer.take_changed_ranges()
    }

    /// The strips, each with a number that stays while its beginning does: its first vertex.
    pub(super) fn numbered_strips(&self) -> impl Iterator<Item = (usize, &[u32])> {
        self.buffer.strip_ranges().map(|range| {
            let strip = &self.buffer.indices()[range.start as usize..range.end as usize];
            (strip[0] as usize, strip)
        })
    }
}
