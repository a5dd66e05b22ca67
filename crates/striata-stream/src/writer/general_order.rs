//! The order in which the steps of a general batch are told.
//!
//! Steps that do not depend on each other may change places. Told by rising numbers of the positions that split, they need a few bits to
//! say which position that is; what has waited for a step alone comes right after it.

use std::collections::BTreeSet;

use crate::topology::surface::NONE;
use crate::writer::general_stage::GeneralStage;

/// The steps of a stage that are still to be told.
#[derive(Debug, Default)]
pub(crate) struct GeneralOrder {
    /// Steps that wait for each one, and for how many others each one waits.
    followers: Vec<Vec<u32>>,
    waits_for: Vec<u32>,
    /// Steps that wait for nothing, by the position that splits.
    ready: BTreeSet<(u32, u32)>,
    /// Those that have waited for the last one, the first of them last.
    next: Vec<u32>,
    /// The position that was reached.
    reached: u32,
}

impl GeneralOrder {
    /// All steps of a stage; `number` is that of a position for the reader, as far as it has one.
    pub(crate) fn new(stage: &GeneralStage, triangle_count: usize, number: impl Fn(u32) -> u32) -> Self {
        let count = stage.steps.len();
        let mut order =
            Self { followers: vec![Vec::new(); count], waits_for: vec![0; count], ..Self::default() };
        // A triangle goes through its steps in turn, and a step needs the positions of what it brings.
        let mut last_at = vec![NONE; triangle_count];
        let mut before = Vec::new();
        for step in 0..count as u32 {
            before.clear();
            before.extend(stage.needs(step));
            before.extend(stage.triangles(step).map(|t| std::mem::replace(&mut last_at[t as usize], step)));
            before.retain(|&other| other != NONE && other != step);
            before.sort_unstable();
            before.dedup();
            order.waits_for[step as usize] = before.len() as u32;
            before.iter().for_each(|&other| order.followers[other as usize].push(step));
            if before.is_empty() {
                order.ready.insert((number(stage.undo(step as usize).target), step));
            }
        }
        order
    }

    /// The step to be told next; those that wait for it alone come after it.
    pub(crate) fn next(&mut self) -> Option<u32> {
        let step = match self.next.pop() {
            Some(step) => step,
            None => {
                let ahead = self.ready.range((self.reached, 0)..).next().or_else(|| self.ready.first());
                let entry = *ahead?;
                self.ready.remove(&entry);
                self.reached = entry.0;
                entry.1
            }
        };
        for &follower in self.followers[step as usize].iter().rev() {
            let waits_for = &mut self.waits_for[follower as usize];
            *waits_for -= 1;
            if *waits_for == 0 {
                self.next.push(follower);
            }
        }
        Some(step)
    }
}
