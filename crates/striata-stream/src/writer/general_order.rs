//! The order in which the steps of a general batch are coded.
//!
//! Steps that do not depend on each other may be reordered. If they are coded by ascending index of the
//! position that splits, coding that position takes only a few bits. A step that was waiting only for the
//! previous one directly follows it.

use std::collections::BTreeSet;

use crate::topology::surface::NONE;
use crate::writer::general_stage::GeneralStage;

/// Steps of a stage that remain to be coded.
#[derive(Debug, Default)]
pub(crate) struct GeneralOrder {
    /// Steps that depend on each step.
    followers: Vec<Vec<u32>>,
    /// Number of steps that each step still waits for.
    waits_for: Vec<u32>,
    /// Steps that no longer wait, ordered by the position that splits.
    ready: BTreeSet<(u32, u32)>,
    /// Steps that waited only for the last one, in reverse order.
    next: Vec<u32>,
    /// Position of the last step that was taken from `ready`.
    reached: u32,
}

impl GeneralOrder {
    /// Starts with all steps of a stage. `number` returns a reader's index of a position, if it has one.
    pub(crate) fn new(stage: &GeneralStage, triangle_count: usize, number: impl Fn(u32) -> u32) -> Self {
        let count = stage.steps.len();
        let mut order =
            Self { followers: vec![Vec::new(); count], waits_for: vec![0; count], ..Self::default() };
        // The steps that change a triangle keep their order, and a step follows those that create the
        // positions of its new triangles.
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

    /// Returns the next step to code.
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
