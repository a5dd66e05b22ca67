//! Which slots of a stage have changed since a buffer last synchronized.

use super::stage::Stage;

/// Slots per block, as a shift: 16.
const BLOCK_SHIFT: u32 = 4;
/// Number of flags that are scanned together.
const WORD: usize = 8;

/// Blocks of slots that have changed since the last synchronization, or the whole stage.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct SlotChanges {
    /// A flag for each block of slots of the current stage, rounded up to whole words. A byte each: setting a
    /// bit would have to wait for the last one that was set in the same word.
    blocks: Vec<u8>,
    /// Whether the stage is a different one, so that everything has changed.
    pub is_new_stage: bool,
}

impl SlotChanges {
    /// No changes, with room for the slots of any stage.
    pub(super) fn none(slot_count: usize) -> Self {
        let block_count = (slot_count >> BLOCK_SHIFT) + 1;
        Self { blocks: vec![0; block_count.next_multiple_of(WORD)], is_new_stage: false }
    }

    /// Marks a slot of the current stage.
    #[inline]
    pub(super) fn mark(&mut self, slot: u32) {
        if let Some(block) = self.blocks.get_mut((slot >> BLOCK_SHIFT) as usize) {
            *block = 1;
        }
    }

    /// Notes that the instance has entered another stage.
    pub(super) fn enter_stage(&mut self) {
        self.is_new_stage = true;
    }

    /// Writes the strips of a stage that have a slot in a marked block, ascending, and clears all marks.
    pub(super) fn take_strips_into(&mut self, stage: &Stage<'_>, strips: &mut Vec<u32>) {
        strips.clear();
        let firsts = stage.strips.firsts();
        let mut strip = 0;
        for (index, word) in self.blocks.as_chunks_mut::<WORD>().0.iter_mut().enumerate() {
            let mut rest = u64::from_le_bytes(std::mem::take(word));
            while rest != 0 {
                let block = (WORD * index) as u32 + rest.trailing_zeros() / 8;
                rest &= rest - 1;
                let [start, end] = [block, block + 1].map(|block| block << BLOCK_SHIFT);
                // The first strip that ends behind the start of the block; nearby if the last block was.
                strip += gallop(&firsts[strip + 1..], start);
                while strip + 1 < firsts.len() && firsts[strip] < end {
                    strips.push(strip as u32);
                    strip += 1;
                }
            }
        }
        // A strip in several blocks is listed for the first of them only, because `strip` has passed it.
        self.is_new_stage = false;
    }

    /// Size in bytes.
    pub(super) fn bytes(&self) -> usize {
        self.blocks.len()
    }
}

/// Number of leading elements that are at most `value`, found in time logarithmic in that number.
fn gallop(ascending: &[u32], value: u32) -> usize {
    let mut width = 1;
    while width < ascending.len() && ascending[width - 1] <= value {
        width *= 2;
    }
    let from = width / 2;
    from + ascending[from..ascending.len().min(width)].partition_point(|&element| element <= value)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::stored_strips::StoredStrips;
    use crate::strip::StripSet;

    #[test]
    fn galloping_finds_the_same_as_a_linear_search() {
        let ascending = [1, 1, 4, 7, 7, 7, 9, 30];
        for value in 0..40 {
            let expected = ascending.iter().take_while(|&&element| element <= value).count();
            assert_eq!(gallop(&ascending, value), expected, "{value}");
        }
        assert_eq!(gallop(&[], 3), 0);
    }

    #[test]
    fn strips_with_a_slot_in_a_marked_block_are_listed_once() {
        let mut strips = StripSet::new();
        let lengths = [10, 0, 5, 40, 1, 8, 0, 100, 3];
        lengths.iter().for_each(|&length| strips.push(&vec![0; length]));
        strips.end_group();
        let stage = Stage::new(0, StoredStrips::pack(&strips, 1), Default::default());
        let firsts = stage.strips.firsts();
        for slots in [&[0][..], &[14], &[15], &[16, 63], &[9, 55, 166], &[20, 40, 54, 55, 70], &[]] {
            let mut changes = SlotChanges::none(stage.strips.slot_count());
            slots.iter().for_each(|&slot| changes.mark(slot));
            let mut found = Vec::new();
            changes.take_strips_into(&stage, &mut found);
            let is_marked = |block| slots.iter().any(|slot| slot >> BLOCK_SHIFT == block);
            let overlaps = |strip: &u32| {
                let range = firsts[*strip as usize]..firsts[*strip as usize + 1];
                range.into_iter().any(|slot| is_marked(slot >> BLOCK_SHIFT))
            };
            let expected: Vec<u32> = (0..9).filter(overlaps).collect();
            let found: Vec<u32> = found.into_iter().filter(|&s| lengths[s as usize] > 0).collect();
            assert_eq!(found, expected, "{slots:?}");
            changes.take_strips_into(&stage, &mut Vec::new());
            assert_eq!(changes, SlotChanges::none(stage.strips.slot_count()));
        }
    }
}
