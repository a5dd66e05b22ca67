//! Builds patterns from fragments.

use std::collections::BinaryHeap;

use super::overlaps::{MAX_RUN, OverlapTableBuilder, Share};
use super::records::{Draft, Records, Widths};
use super::rule::{Rule, first_corner};
use super::rule_table::RuleTable;
use super::rulebook::{Matched, Rulebook};
use super::{BaseFace, Patterns};
use crate::mesh::{Face, FragmentSequence, FragmentedMesh};
use crate::model::step_bounds::StepBounds;
use crate::model::{ModelError, StepVertices};

/// Limit of the search for redundant links down. A dependency that is not recognized as redundant is stored.
const MAX_VISITED: usize = 24;

impl Patterns {
    /// Builds the patterns of a mesh with fragments of any origin, including the bounds of the fragments.
    ///
    /// # Errors
    /// [`ModelError::TooMany`] if the links would take more than 512 MB.
    pub fn build(mesh: &FragmentedMesh) -> Result<Self, ModelError> {
        let patterns = Self::build_without_bounds(mesh)?;
        Ok(Self { bounds: Some(StepBounds::of_fragments(mesh)), ..patterns })
    }

    /// Builds the patterns without bounds; see [`from_fragments`](Self::from_fragments).
    ///
    /// # Errors
    /// Fails under the same conditions as [`build`](Self::build).
    pub fn build_without_bounds(mesh: &FragmentedMesh) -> Result<Self, ModelError> {
        Self::from_fragments(&mesh.fragments, mesh.mesh.groups.len().max(1))
    }

    /// Removes the bounds.
    pub fn without_bounds(self) -> Self {
        Self { bounds: None, ..self }
    }

    /// Builds the patterns from fragments alone, without positions and therefore without bounds. That is
    /// sufficient for uniform levels and for conditions that do not evaluate bounds; a
    /// [`PatternScene`](super::PatternScene) and a file need them.
    ///
    /// # Errors
    /// Fails under the same conditions as [`build`](Self::build).
    pub fn from_fragments(fragments: &FragmentSequence, group_count: usize) -> Result<Self, ModelError> {
        let mut rulebook = Rulebook::new(fragments, group_count);
        let mut locations = FaceLocations::new(fragments);
        let mut extras = Vec::new();
        let mut rules_of = Vec::with_capacity(fragments.step_count());
        for step in 0..fragments.step_count() as u32 {
            let matched = rulebook.find(step);
            locations.record(&matched, rulebook.rule(matched.rule));
            rules_of.push(matched.rule);
            extras.push(matched.locals);
        }
        let rules = rulebook.into_table();
        let extras = Extras::of(&rules, &rules_of, extras);
        let mut sharings = OverlapTableBuilder::default();
        let mut drafts: Vec<Draft> = Vec::with_capacity(fragments.step_count());
        let mut ancestry = Ancestry::new(fragments.step_count());
        for step in 0..fragments.step_count() as u32 {
            let (sharing, up) = locations.share(step, &rules, &rules_of);
            let below =
                fragments.floor(step).iter().filter_map(|&face| fragments.creating_step(face)).collect();
            let down = ancestry.add(below);
            drafts.push(Draft { rule: rules_of[step as usize], sharing: sharings.find(sharing), up, down });
        }
        let sharings = sharings.into_table();
        let base = (0..fragments.base_face_count() as u32).map(|face| locations.base_face(face)).collect();
        let half_edge_count = rules.iter().map(|rule| 3 * rule.floor_count()).max().unwrap_or(0) as u32;
        let widths = Widths {
            rule_count: rules.len(),
            sharing_count: sharings.len(),
            half_edge_count,
            offset_width: 0,
        };
        Ok(Self {
            vertices: StepVertices::of_levels(fragments.levels()),
            group_count,
            base,
            floorless: (0..fragments.step_count() as u32)
                .filter(|&s| fragments.floor(s).is_empty())
                .collect(),
            records: Records::pack(&drafts, widths)?,
            rules,
            sharings,
            extras,
            bounds: None,
        })
    }
}

/// Vertices that a fragment must list explicitly, because they do not follow from its triangles.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(in crate::model) struct Extras {
    /// Steps that have extra vertices, ascending.
    pub(super) steps: Vec<u32>,
    /// Index of the first extra vertex of each of these steps, followed by the number of extra vertices.
    pub(super) firsts: Vec<u32>,
    pub(super) vertices: Vec<u32>,
}

impl Extras {
    fn of(rules: &RuleTable, rules_of: &[u32], locals: Vec<Vec<u32>>) -> Self {
        let mut extras = Self { firsts: vec![0], ..Self::default() };
        for (step, (locals, &rule)) in locals.iter().zip(rules_of).enumerate() {
            let known = extras.vertices.len();
            extras.vertices.extend(rules.rule(rule).extras().map(|local| locals[local as usize]));
            if extras.vertices.len() > known {
                extras.steps.push(step as u32);
                extras.firsts.push(extras.vertices.len() as u32);
            }
        }
        extras
    }

    /// Returns the extra vertices of a step.
    pub(super) fn of_step(&self, step: u32) -> &[u32] {
        match self.steps.binary_search(&step) {
            Ok(i) => &self.vertices[self.firsts[i] as usize..self.firsts[i + 1] as usize],
            Err(_) => &[],
        }
    }

    pub(super) fn bytes(&self) -> usize {
        size_of::<u32>() * (self.steps.len() + self.firsts.len() + self.vertices.len())
    }
}

/// Location of each face in the ceiling of its creator and in the floor of the fragment that replaces it.
struct FaceLocations<'a> {
    fragments: &'a FragmentSequence,
    replaced_by: Vec<u32>,
    /// Faces of all ceilings, in the order of their rules.
    ceilings: Vec<u32>,
    /// For each face, the corner of its youngest vertex in the floor that contains it, as a half-edge of
    /// the rule.
    half_edges: Vec<u32>,
}

impl<'a> FaceLocations<'a> {
    fn new(fragments: &'a FragmentSequence) -> Self {
        Self {
            fragments,
            replaced_by: fragments.replacing_steps(),
            ceilings: Vec::with_capacity(fragments.faces().len() - fragments.base_face_count()),
            half_edges: vec![0; fragments.faces().len()],
        }
    }

    /// Records the locations of the faces of the next step.
    fn record(&mut self, matched: &Matched, rule: &Rule) {
        self.ceilings.extend_from_slice(&matched.ceiling);
        for (j, (&face, triangle)) in matched.floor.iter().zip(&rule.floor).enumerate() {
            let corners = triangle.map(|local| matched.locals[local as usize]);
            let youngest = (0..3).max_by_key(|&c| corners[c]).expect("a triangle has corners");
            self.half_edges[face as usize] = (3 * j + youngest) as u32;
        }
    }

    fn base_face(&self, face: u32) -> BaseFace {
        let Face { corners: [a, b, c], group } = self.fragments.faces()[face as usize];
        let above = self.replaced_by[face as usize];
        let half_edge = if above == FragmentSequence::NO_STEP { 0 } else { self.half_edges[face as usize] };
        BaseFace { corners: first_corner([a, b, c], a.max(b).max(c)), group, above, half_edge }
    }

    /// Returns how the ceiling of a step is shared, and its links up.
    fn share(&self, step: u32, rules: &RuleTable, rules_of: &[u32]) -> (Vec<Share>, Vec<(u32, u32)>) {
        let base = self.fragments.base_face_count();
        let range = self.fragments.ceiling(step);
        let faces = &self.ceilings[range.start as usize - base..range.end as usize - base];
        let above = |s: usize| self.replaced_by[faces[s] as usize];
        let half_edge = |s: usize| self.half_edges[faces[s] as usize];
        let follows = |s: usize, before: usize| {
            let is_same = above(s) == above(before) && above(s) != FragmentSequence::NO_STEP;
            is_same && {
                let rule = rules.rule(rules_of[above(s) as usize]);
                rule.next_around(half_edge(before)) == Some(half_edge(s))
            }
        };
        let count = faces.len();
        let mut sharing = vec![Share { link: Share::FULL, offset: 0 }; count];
        let mut up = Vec::new();
        // Starting at the beginning of a run ensures that no run is split at an arbitrary point of the ring.
        let start = (0..count).find(|&s| !follows(s, (s + count - 1) % count)).unwrap_or(0);
        let mut offset = 0;
        for i in 0..count {
            let s = (start + i) % count;
            if above(s) == FragmentSequence::NO_STEP {
                continue;
            }
            offset += 1;
            if i == 0 || offset == MAX_RUN || !follows(s, (s + count - 1) % count) {
                offset = 0;
                up.push((above(s), half_edge(s)));
            }
            sharing[s] = Share { link: up.len() as u32 - 1, offset };
        }
        renumber(&mut sharing, &mut up);
        (sharing, up)
    }
}

/// Renumbers links by first use in the ceiling, so that equivalent sharings become equal.
fn renumber(sharing: &mut [Share], up: &mut Vec<(u32, u32)>) {
    let mut fresh = vec![u32::MAX; up.len()];
    let mut order = Vec::with_capacity(up.len());
    for share in sharing.iter_mut().filter(|share| share.link != Share::FULL) {
        let index = &mut fresh[share.link as usize];
        if *index == u32::MAX {
            *index = order.len() as u32;
            order.push(up[share.link as usize]);
        }
        share.link = *index;
    }
    *up = order;
}

/// The dependencies between steps, used to remove those that follow from others.
struct Ancestry {
    below: Vec<Vec<u32>>,
    /// For each step, the last step whose dependencies included it.
    seen: Vec<u32>,
    waiting: BinaryHeap<u32>,
}

impl Ancestry {
    fn new(step_count: usize) -> Self {
        Self {
            below: Vec::with_capacity(step_count),
            seen: vec![u32::MAX; step_count],
            waiting: BinaryHeap::new(),
        }
    }

    /// Adds a step and the steps that it depends on. Returns those that none of the others depends on,
    /// youngest first.
    fn add(&mut self, mut below: Vec<u32>) -> Vec<u32> {
        below.sort_unstable_by(|a, b| b.cmp(a));
        below.dedup();
        let step = self.below.len() as u32;
        let Some(&oldest) = below.last() else {
            self.below.push(Vec::new());
            return Vec::new();
        };
        let mut kept: Vec<u32> = Vec::new();
        self.waiting.clear();
        let mut visited_count = 0;
        for &candidate in &below {
            // Youngest first, and no further than the candidate: older steps cannot depend on it.
            while self.waiting.peek().is_some_and(|&at| at > candidate) && visited_count < MAX_VISITED {
                let Some(younger) = self.waiting.pop() else { break };
                visited_count += 1;
                for &next in &self.below[younger as usize] {
                    if next >= oldest && self.seen[next as usize] != step {
                        self.seen[next as usize] = step;
                        self.waiting.push(next);
                    }
                }
            }
            if self.seen[candidate as usize] != step {
                self.seen[candidate as usize] = step;
                kept.push(candidate);
                self.waiting.push(candidate);
            }
        }
        self.below.push(kept.clone());
        kept
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn redundant_dependencies_are_not_listed() {
        let mut ancestry = Ancestry::new(6);
        let lists: [(&[u32], &[u32]); 6] = [
            (&[], &[]),
            (&[0], &[0]),
            (&[0], &[0]),
            (&[0, 1, 1], &[1]),
            (&[0, 2, 3, 1], &[3, 2]),
            (&[0, 4, 3], &[4]),
        ];
        for (below, kept) in lists {
            assert_eq!(ancestry.add(below.to_vec()), kept, "{below:?}");
        }
    }

    #[test]
    fn links_are_numbered_by_first_use() {
        let share = |link| Share { link, offset: 0 };
        let mut sharing = [2, Share::FULL, 0, 2, 1].map(share);
        let mut up = vec![(7, 0), (8, 1), (9, 2)];
        renumber(&mut sharing, &mut up);
        assert_eq!(sharing, [0, Share::FULL, 1, 0, 2].map(share));
        assert_eq!(up, [(9, 2), (7, 0), (8, 1)]);
    }
}
