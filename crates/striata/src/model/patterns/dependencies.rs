//! Dependencies between steps, without those that follow from others.
//!
//! A step depends on the steps that create its floor. If one of them depends on another, directly or not,
//! inserting the one inserts the other anyway, so the other needs no link. A short search finds nearly all
//! that can be left out; what it does not find is stored. Readers repeat the search to check the links.

/// Maximum number of steps that a search visits; on average it visits four.
const MAX_VISITED: usize = 24;
/// Maximum number of steps that a search has found but not visited; others are forgotten.
const MAX_PENDING: usize = 16;

/// The links down of all steps so far.
pub(super) struct Dependencies {
    /// First link of each step, followed by their number.
    firsts: Vec<u32>,
    below: Vec<u32>,
}

/// Steps that a search has found but not visited, ascending.
struct PendingSteps {
    steps: [u32; MAX_PENDING],
    len: usize,
}

impl PendingSteps {
    /// Number of steps that are not younger than a step, and whether it is one of them.
    #[inline]
    fn place_of(&self, step: u32) -> (usize, bool) {
        let mut place = self.len;
        // The mask spares a check of the bounds.
        while place > 0 && self.steps[(place - 1) % MAX_PENDING] > step {
            place -= 1;
        }
        (place, place > 0 && self.steps[(place - 1) % MAX_PENDING] == step)
    }

    /// Adds a step unless it is there; returns whether it was.
    #[inline]
    fn add(&mut self, step: u32) -> bool {
        let (place, is_known) = self.place_of(step);
        if is_known || self.len == MAX_PENDING {
            return is_known;
        }
        let mut at = self.len;
        while at > place {
            self.steps[at % MAX_PENDING] = self.steps[(at - 1) % MAX_PENDING];
            at -= 1;
        }
        self.steps[place % MAX_PENDING] = step;
        self.len += 1;
        false
    }
}

impl Dependencies {
    pub(super) fn new(step_count: usize) -> Self {
        let mut firsts = Vec::with_capacity(step_count + 1);
        firsts.push(0);
        Self { firsts, below: Vec::with_capacity(2 * step_count) }
    }

    /// Adds the next step with the different steps that create its floor, ascending. Returns its links down:
    /// those that the search does not reach from younger ones, youngest first.
    #[inline]
    pub(super) fn add(&mut self, makers: &[u32]) -> &[u32] {
        let first = self.below.len();
        if let &[_, .., _] = makers {
            self.add_several(makers);
        } else {
            self.below.extend_from_slice(makers);
        }
        self.firsts.push(self.below.len() as u32);
        &self.below[first..]
    }

    fn add_several(&mut self, makers: &[u32]) {
        let oldest = makers[0];
        let mut pending = PendingSteps { steps: [0; MAX_PENDING], len: 0 };
        let mut visited_count = 0;
        for &candidate in makers.iter().rev() {
            // Youngest first, and no further than the candidate: older steps cannot depend on it.
            while pending.len > 0 && visited_count < MAX_VISITED {
                let step = pending.steps[(pending.len - 1) % MAX_PENDING];
                if step <= candidate {
                    break;
                }
                pending.len -= 1;
                visited_count += 1;
                let [from, to] = [self.firsts[step as usize], self.firsts[step as usize + 1]];
                for &next in &self.below[from as usize..to as usize] {
                    // Everything found is older than what has been visited, so it was not visited before.
                    if next >= oldest {
                        pending.add(next);
                    }
                }
            }
            if !pending.add(candidate) {
                self.below.push(candidate);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn redundant_dependencies_are_not_listed() {
        let mut dependencies = Dependencies::new(6);
        let lists: [(&[u32], &[u32]); 6] = [
            (&[], &[]),
            (&[0], &[0]),
            (&[0], &[0]),
            (&[0, 1], &[1]),
            (&[0, 1, 2, 3], &[3, 2]),
            (&[0, 3, 4], &[4]),
        ];
        for (makers, kept) in lists {
            assert_eq!(dependencies.add(makers), kept, "{makers:?}");
        }
    }

    #[test]
    fn long_searches_are_given_up() {
        let mut dependencies = Dependencies::new(40);
        for step in 0..39 {
            dependencies.add((step > 0).then(|| step - 1).as_slice());
        }
        let near = 38 - MAX_VISITED as u32;
        assert_eq!(dependencies.add(&[near, 38]), [38]);
        assert_eq!(dependencies.add(&[near - 1, 38]), [38, near - 1]);
    }

    #[test]
    fn more_dependencies_than_a_search_can_hold_are_all_listed() {
        let mut dependencies = Dependencies::new(200);
        for _ in 0..100 {
            dependencies.add(&[]);
        }
        let all: Vec<u32> = (0..101).collect();
        let expected: Vec<u32> = (0..100).rev().collect();
        assert_eq!(dependencies.add(&all[..100]), expected);
        // Step 100 depends on all of them; only the youngest of these are remembered.
        let kept = dependencies.add(&all);
        assert_eq!(kept[0], 100);
        assert!(kept.len() < 101);
    }
}
