//! The pattern model as published \[KG98\]: each fragment is a rule with two anchors, and the hierarchy
//! consists of loops.
//!
//! No triangles are stored. A fragment is described by its **rule** (how its floor triangulates its ring;
//! the ceiling is always the fan around the removed vertex) and by two vertices of the ring, its
//! **anchors**, which position the rule on the current triangulation. The fragments covered by one
//! fragment are linked in a **loop**: down to the first of them, from each to the next, and from the last
//! one back. A fragment therefore stores a link for every loop it is part of, and following these loops to
//! their ends finds all fragments that cover it.
//!
//! ```text
//!        41 --down--> 17 --loop 2--> 30 --loop 0--> 12 --loop 1--> back to 41
//!        41 depends on 17, 30 and 12; loop 0 of 30 ends at 41, so 41 covers 30
//! ```
//!
//! **An instance** is the current triangulation with adjacency. To insert a fragment, its floor is located
//! at the edge between the anchors and replaced by a fan. To remove one, the fan of its vertex is replaced
//! by the floor. The youngest corner of a triangle identifies the fragment that created it.
//!
//! Differs, since the paper does not specify it: fragments are numbered from coarse to fine, like
//! vertices. Two triangles of a refined surface may have the same anchors on the same edge; therefore the
//! first fragment of a loop is the one that creates the right triangle. Fragments that cover the base are
//! listed. A triangle attached by one edge has no floor; it counts as covering the triangle it is attached
//! to, since it could otherwise appear without it. One of the sixteen loop indices marks the end of a
//! loop, so a fragment is in at most 15 loops; the other 12 of the paper's 16 bits are the rule index.
//! Finding the links of a fragment takes slightly more memory (`records.rs`).
//!
//! The paper's form represents surfaces only: [`build`](LoopPatterns::build) rejects seams, groups, stars
//! that are not one fan, and floors that do not fill their hole, and reports where they are. Borders are
//! open rings, and holes may close.
//!
//! Cost: 116 bits per fragment and 36 per overlap, of which there are 2.3 to 2.5 per fragment. Changes are
//! linear in the fragments inserted and removed; a condition is evaluated for each overlap shown.

mod build;
mod records;
mod refine;
mod rule;
mod state;
mod surface;

pub(super) use self::build::check_form;
use self::records::LoopRecords;
pub(super) use self::rule::{LoopRule, LoopRuleTable, LoopShape};
pub use self::state::LoopPatternsState;
pub(super) use self::surface::{LoopRegion, LoopSurface, Side};
use striata::model::{DrawCounts, LodModel, PartBytes, StepVertices, StoredModel, Topology};

use crate::paper_bytes::{Accounting, PaperBytes, pattern_bytes};

/// The static half of the model; see the [module](self).
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LoopPatterns {
    vertices: StepVertices<'static>,
    base: Vec<[u32; 3]>,
    /// Fragments that replace triangles of the base or are attached to them, ascending.
    base_covers: Vec<u32>,
    rules: LoopRuleTable,
    records: LoopRecords,
}

impl LoopPatterns {
    /// Number of rules (kinds of fragments), including those with open rings.
    pub fn rule_count(&self) -> usize {
        self.rules.len()
    }

    /// Number of pairs of overlapping fragments, without overlaps with the base; the paper's `u`.
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

    /// The two vertices of a fragment's ring that position its rule.
    ///
    /// # Panics
    /// If the fragment does not exist.
    pub fn anchors(&self, step: u32) -> [u32; 2] {
        self.records.head(step).anchors
    }

    /// The fragments that depend on a fragment, each found at the end of a loop.
    ///
    /// # Panics
    /// If the fragment does not exist.
    pub fn covering(&self, step: u32) -> impl Iterator<Item = u32> + '_ {
        self.records.covering(step)
    }

    /// The fragments that depend on the base, ascending.
    pub fn base_covers(&self) -> &[u32] {
        &self.base_covers
    }

    /// Creates an instance that shows the base.
    pub fn base_state(&self) -> LoopPatternsState {
        LoopPatternsState::base(self)
    }

    /// The fragment that creates a triangle, or `None` if it is in the base.
    #[inline]
    fn maker(&self, &[a, b, c]: &[u32; 3]) -> Option<u32> {
        a.max(b).max(c).checked_sub(self.vertices.base_vertex_count())
    }
}

impl LodModel for LoopPatterns {
    type State = LoopPatternsState;

    fn step_count(&self) -> usize {
        self.records.len()
    }

    fn new_state(&self) -> LoopPatternsState {
        let mut state = self.base_state();
        self.move_to(&mut state, self.step_count());
        state
    }

    /// Number of fragments inserted, in whatever combination.
    fn split_count(&self, state: &LoopPatternsState) -> usize {
        state.split_count()
    }

    fn move_to(&self, state: &mut LoopPatternsState, split_count: usize) {
        assert!(split_count <= self.step_count(), "split count {split_count} of {}", self.step_count());
        state.check(self);
        let change = state.inserted.change_to_level(split_count);
        state.apply(self, &change);
    }

    fn topology(&self) -> Topology {
        Topology::Triangles
    }

    fn draw_counts(&self, state: &LoopPatternsState) -> DrawCounts {
        DrawCounts { strip_count: 0, index_count: 3 * state.triangles().len() }
    }

    fn indices_into(&self, state: &LoopPatternsState, out: &mut Vec<u32>) {
        out.extend_from_slice(state.triangles().as_flattened());
    }

    fn bytes(&self) -> Vec<PartBytes> {
        let part = |name, bytes| PartBytes { name, bytes };
        let [heads, loops, places] = self.records.bytes();
        vec![
            part("fragments", heads),
            part("loops", loops),
            part("places of loops", places),
            part("rules", self.rules.bytes()),
            part("base", size_of_val(&self.base[..]) + 4 * self.base_covers.len()),
        ]
    }

    fn state_bytes(&self, state: &LoopPatternsState) -> usize {
        state.bytes()
    }
}

impl PaperBytes for LoopPatterns {
    /// The paper's bits per fragment and per overlap, with the actual number of overlaps.
    fn paper_bytes(&self, _: Accounting) -> usize {
        pattern_bytes(self.step_count(), self.overlap_count())
    }
}

impl StoredModel for LoopPatterns {
    fn step_vertices(&self) -> &StepVertices<'_> {
        &self.vertices
    }

    fn group_count(&self) -> usize {
        1
    }

    fn group_triangles_into(&self, state: &LoopPatternsState, group: usize, out: &mut Vec<[u32; 3]>) {
        assert!(group == 0, "group {group} of 1");
        out.extend_from_slice(state.triangles());
    }
}
