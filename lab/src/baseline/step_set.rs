//! The set of steps that an instance has refined, closed under dependency: a step's prerequisites are also
//! in it.

/// Marks a step that is not in the set.
const NONE: u32 = u32::MAX;

/// A set of steps with constant-time lookup, insertion and removal, whose members can be listed.
#[derive(Clone, Debug)]
pub(super) struct StepSet {
    /// The steps, unordered.
    steps: Vec<u32>,
    /// Index of each step in `steps`, or [`NONE`].
    index_of: Vec<u32>,
    /// Every step before this one is in the set.
    lowest: u32,
    /// Neither this step nor any later one is in the set.
    highest: u32,
    /// Scratch for [`change_to`](Self::change_to): the requested steps. All false between calls.
    is_wanted: Vec<bool>,
}

/// The steps to remove and insert to get from one set to another, in a valid order.
#[derive(Clone, Debug, Default)]
pub(super) struct StepSetChange {
    /// Finest first.
    pub removed: Vec<u32>,
    /// Coarsest first.
    pub inserted: Vec<u32>,
}

impl StepSet {
    pub(super) fn new(step_count: usize) -> Self {
        Self {
            steps: Vec::new(),
            index_of: vec![NONE; step_count],
            lowest: 0,
            highest: 0,
            is_wanted: vec![false; step_count],
        }
    }

    /// Upper bound of the steps that can be in the set.
    pub(super) fn limit(&self) -> usize {
        self.index_of.len()
    }

    pub(super) fn len(&self) -> usize {
        self.steps.len()
    }

    pub(super) fn steps(&self) -> &[u32] {
        &self.steps
    }

    #[inline]
    pub(super) fn has(&self, step: u32) -> bool {
        self.index_of[step as usize] != NONE
    }

    pub(super) fn insert(&mut self, step: u32) {
        debug_assert!(!self.has(step), "step {step} is inserted twice");
        self.index_of[step as usize] = self.steps.len() as u32;
        self.steps.push(step);
        self.highest = self.highest.max(step + 1);
        if self.lowest == step {
            self.lowest += 1;
        }
    }

    pub(super) fn remove(&mut self, step: u32) {
        debug_assert!(self.has(step), "step {step} is removed and not there");
        let index = std::mem::replace(&mut self.index_of[step as usize], NONE) as usize;
        self.steps.swap_remove(index);
        if let Some(&moved) = self.steps.get(index) {
            self.index_of[moved as usize] = index as u32;
        }
        self.lowest = self.lowest.min(step);
        if self.highest == step + 1 {
            self.highest = step;
        }
    }

    /// The change that leads to the first `split_count` steps.
    pub(super) fn change_to_level(&self, split_count: usize) -> StepSetChange {
        let is_in = |&step: &u32| self.has(step);
        StepSetChange {
            removed: (split_count as u32..self.highest).rev().filter(is_in).collect(),
            inserted: (self.lowest..split_count as u32).filter(|step| !is_in(step)).collect(),
        }
    }

    /// The change to the smallest set that contains `wanted` and, for each of its steps, those that
    /// `needs_into` appends.
    pub(super) fn change_to(
        &mut self,
        wanted: Vec<u32>,
        mut needs_into: impl FnMut(u32, &mut Vec<u32>),
    ) -> StepSetChange {
        let (mut waiting, mut found) = (wanted, Vec::new());
        while let Some(step) = waiting.pop() {
            if !std::mem::replace(&mut self.is_wanted[step as usize], true) {
                found.push(step);
                needs_into(step, &mut waiting);
            }
        }
        let is_wanted = &self.is_wanted;
        let mut change = StepSetChange {
            removed: self.steps.iter().copied().filter(|&step| !is_wanted[step as usize]).collect(),
            inserted: found.iter().copied().filter(|&step| !self.has(step)).collect(),
        };
        change.removed.sort_unstable_by(|a, b| b.cmp(a));
        change.inserted.sort_unstable();
        found.iter().for_each(|&step| self.is_wanted[step as usize] = false);
        change
    }

    pub(super) fn bytes(&self) -> usize {
        4 * (self.steps.len() + self.index_of.len()) + self.is_wanted.len()
    }
}

impl PartialEq for StepSet {
    fn eq(&self, other: &Self) -> bool {
        self.limit() == other.limit()
            && self.len() == other.len()
            && self.steps.iter().all(|&step| other.has(step))
    }
}

impl Eq for StepSet {}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn changes_lead_from_any_set_to_any_other() {
        let mut set = StepSet::new(6);
        // Each step except 0 needs the one with half its index.
        let needs = |step: u32, out: &mut Vec<u32>| out.extend((step > 1).then_some(step / 2));
        let change = set.change_to(vec![5, 3, 5], needs);
        assert_eq!((change.removed, change.inserted), (vec![], vec![1, 2, 3, 5]));
        [1, 2, 3, 5].into_iter().for_each(|step| set.insert(step));
        let change = set.change_to(vec![4, 2], needs);
        assert_eq!((change.removed, change.inserted), (vec![5, 3], vec![4]));
        let change = set.change_to_level(3);
        assert_eq!((change.removed, change.inserted), (vec![5, 3], vec![0]));
        set.remove(5);
        set.insert(0);
        assert_eq!((set.lowest, set.highest, set.len()), (1, 5, 4));
        let mut other = StepSet::new(6);
        [3, 0, 1, 2].into_iter().for_each(|step| other.insert(step));
        assert!(set == other && !other.has(5) && other.has(3));
        assert_eq!(other.change_to_level(4).inserted, [] as [u32; 0]);
    }
}
