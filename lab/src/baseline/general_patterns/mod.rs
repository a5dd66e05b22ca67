//! The published pattern model \[KG98\] for ceilings of any kind: a rule consists of two patterns, one for the
//! ceiling and one for the floor (section 3, figure 2).
//!
//! [`LoopPatterns`](super::LoopPatterns) has the record that the paper counts, in which the ceiling is
//! always the fan of the removed vertex. Here a step may restore several vertices, and its floor may have
//! vertices that the ceiling lacks: edges and triangles collapsed to new vertices. The paper gives no record
//! for those. This one extends its record as little as possible:
//!
//! ```text
//! head    | anchor 32 | anchor 32 | rule 16 | down: fragment 32, loop 5 |   117 bits each
//! counts  | loops 5 |                                                         5 bits each
//! links   | fragment 32, loop 5 |                                            37 bits each
//! listed  | vertex 32 |                          for each vertex that ceiling or floor lacks
//! ```
//!
//! A vertex that only the floor has, the new one of a collapse, cannot be found in the ceiling when a
//! fragment is removed, so it is listed; so is a vertex that only the ceiling has, at borders. The vertices
//! that a step restores follow from its number.
//!
//! **Rules.** Both patterns are walked from the edge between the anchors, breadth first; the order in which
//! vertices are met numbers them. Of all common border edges of ceiling and floor, the one with the smallest
//! code becomes the anchors. A pattern is located in the triangulation by the same walk.
//!
//! **Differs:** the form represents oriented surfaces with one group. Ceilings and floors must be connected by
//! edges, and floors share an edge with their ceilings unless they are empty.
//! [`build`](GeneralPatterns::build) reports the first step for which this does not hold. If two triangles of
//! a refined surface have the same anchors, those that covered fragments created are taken.

mod build;
mod records;
mod rule;
mod state;

use striata::model::{
    Condition, DrawCounts, LodModel, Overlap, PartBytes, PatternChange, StepVertices, StoredModel, Topology,
};

use self::records::PatternRecords;
use self::rule::PatternRuleTable;
pub use self::state::GeneralPatternsState;
use crate::paper_bytes::{Accounting, PaperBytes, pattern_bytes};

/// The static half of the model; see the [module](self).
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct GeneralPatterns {
    vertices: StepVertices<'static>,
    base: Vec<[u32; 3]>,
    /// Fragments that replace triangles of the base or have no floor, ascending.
    base_covers: Vec<u32>,
    rules: PatternRuleTable,
    records: PatternRecords,
}

impl GeneralPatterns {
    /// Number of rules, that is, of pairs of patterns.
    pub fn rule_count(&self) -> usize {
        self.rules.len()
    }

    /// Number of pairs of overlapping fragments, without overlaps with the base.
    pub fn overlap_count(&self) -> usize {
        self.records.link_count()
    }

    /// The fragments that a fragment depends on.
    ///
    /// # Panics
    /// If the fragment does not exist.
    pub fn covered(&self, step: u32) -> impl Iterator<Item = u32> + '_ {
        self.records.covered(step)
    }

    /// The fragments that depend on a fragment, each found at the end of a loop.
    ///
    /// # Panics
    /// If the fragment does not exist.
    pub fn covering(&self, step: u32) -> impl Iterator<Item = u32> + '_ {
        self.records.covering(step)
    }

    /// Creates an instance that shows the base.
    pub fn base_state(&self) -> GeneralPatternsState {
        GeneralPatternsState::base(self)
    }

    /// Moves to the smallest closed set of fragments in which no overlap is too coarse, from any current set.
    ///
    /// # Panics
    /// If the state belongs to another model.
    pub fn adapt(&self, state: &mut GeneralPatternsState, condition: &impl Condition) -> PatternChange {
        state.check(self);
        let coarse = |lower, upper| condition.is_too_coarse(Overlap { lower, upper, error: f32::INFINITY });
        let wanted = self.base_covers.iter().copied().filter(|&upper| coarse(None, upper)).collect();
        let change = state.inserted.change_to(wanted, |step, waiting| {
            waiting.extend(self.records.covered(step));
            waiting.extend(self.records.covering(step).filter(|&upper| coarse(Some(step), upper)));
        });
        state.apply(self, &change);
        PatternChange { inserted: change.inserted.len(), removed: change.removed.len() }
    }
}

impl LodModel for GeneralPatterns {
    type State = GeneralPatternsState;

    fn step_count(&self) -> usize {
        self.records.len()
    }

    fn new_state(&self) -> GeneralPatternsState {
        let mut state = self.base_state();
        self.move_to(&mut state, self.step_count());
        state
    }

    /// Number of fragments inserted, in whatever combination.
    fn split_count(&self, state: &GeneralPatternsState) -> usize {
        state.split_count()
    }

    fn move_to(&self, state: &mut GeneralPatternsState, split_count: usize) {
        assert!(split_count <= self.step_count(), "split count {split_count} of {}", self.step_count());
        state.check(self);
        let change = state.inserted.change_to_level(split_count);
        state.apply(self, &change);
    }

    fn topology(&self) -> Topology {
        Topology::Triangles
    }

    fn draw_counts(&self, state: &GeneralPatternsState) -> DrawCounts {
        DrawCounts { strip_count: 0, index_count: 3 * state.triangle_count() }
    }

    fn indices_into(&self, state: &GeneralPatternsState, out: &mut Vec<u32>) {
        state.triangles().for_each(|triangle| out.extend_from_slice(&triangle));
    }

    fn bytes(&self) -> Vec<PartBytes> {
        let part = |name, bytes| PartBytes { name, bytes };
        let [heads, loops, listed] = self.records.bytes();
        vec![
            part("fragments", heads),
            part("loops", loops),
            part("listed vertices", listed),
            part("rules", self.rules.bytes()),
            part("vertices", 4 * self.vertices.word_count()),
            part("base", size_of_val(&self.base[..]) + 4 * self.base_covers.len()),
        ]
    }

    fn state_bytes(&self, state: &GeneralPatternsState) -> usize {
        state.bytes()
    }
}

impl PaperBytes for GeneralPatterns {
    /// The paper's bits per fragment and per overlap, and 32 for each listed vertex.
    fn paper_bytes(&self, _: Accounting) -> usize {
        pattern_bytes(self.step_count(), self.overlap_count()) + 4 * self.records.listed_count()
    }
}

impl StoredModel for GeneralPatterns {
    fn step_vertices(&self) -> &StepVertices<'_> {
        &self.vertices
    }

    fn group_count(&self) -> usize {
        1
    }

    fn group_triangles_into(&self, state: &GeneralPatternsState, group: usize, out: &mut Vec<[u32; 3]>) {
        assert!(group == 0, "group {group} of 1");
        out.extend(state.triangles());
    }
}
