//! The tree of steps along which bounds are nested.

use super::history::FanHistory;
use crate::mesh::LevelTable;
use crate::model::fans::table::Fan;

/// The parent of each step, which is the coarsest position whose entry names it, and whether an entry lists the
/// step as its child.
pub(super) struct Tree {
    /// Step of the parent plus 1, 0 for the base, or `u32::MAX` if no entry names the step.
    parents: Vec<u32>,
    is_listed: Vec<bool>,
}

impl Tree {
    /// Finds the parents of all steps.
    pub(super) fn of_history(history: &FanHistory, levels: &LevelTable) -> Self {
        let step_count = levels.step_count();
        let mut tree = Self { parents: vec![u32::MAX; step_count], is_listed: vec![false; step_count] };
        for vertex in 0..history.vertex_count() as u32 {
            let own_step = levels.step_of(vertex).map_or(0, |step| step + 1);
            for &triangle in history.entry(vertex) {
                if let Some(parent) = tree.parents.get_mut(history.creator(triangle) as usize) {
                    *parent = own_step.min(*parent);
                }
            }
        }
        tree
    }

    /// Marks the children of a position in the fans of one of its vertices, each only once; `own_step` is the
    /// step of the position plus 1, or 0 for the base.
    pub(super) fn mark_children(&mut self, own_step: u32, fans: &mut [Fan]) {
        for creator in fans.iter_mut().flat_map(|fan| &mut fan.creators) {
            let step = creator.step as usize;
            if self.parents[step] == own_step {
                creator.is_child = !std::mem::replace(&mut self.is_listed[step], true);
            }
        }
    }

    /// Returns the steps that no entry lists as a child.
    pub(super) fn orphans(self) -> Vec<u32> {
        (0..).zip(&self.is_listed).filter(|(_, is_listed)| !**is_listed).map(|(step, _)| step).collect()
    }
}
