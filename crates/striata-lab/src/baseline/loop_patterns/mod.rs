//! The pattern model as published \[KG98\]: a rule and two anchors for each fragment, and the hierarchy as loops.
//!
//! No triangles are stored. A fragment is told by its **rule** (how its floor triangulates its ring; the ceiling is always the fan
//! around the removed vertex) and by two vertices of the ring, its **anchors**, from which the rule is laid over the current
//! triangulation. The fragments that one covers are linked in a **loop**: down to the first of them, from each to the
//! next, and from the last one back. So each fragment stores a link for every loop that it is in, and following these to
//! their ends finds all that cover it.
//!
//! ```text
//!        41 --down--> 17 --loop 2--> 30 --loop 0--> 12 --loop 1--> back to 41
//!        41 stands on 17, 30 and 12; 30's loop 0 ends at 41, so 41 covers 30
//! ```
//!
//! **An instance** is the current triangulation with its neighbors. To insert a fragment, its floor is found at the side
//! between the anchors and replaced by a fan; to remove one, the fan of its vertex is found and replaced by a floor. A triangle's
//! youngest corner tells which fragment made it.
//!
//! Differs, since the paper is silent on it: fragments are numbered from coarse to fine, as vertices are. Two triangles of a
//! refined surface may have the same two anchors at the same side; the first fragment of a loop is therefore the one that makes the
//! right one. Fragments that cover the base are listed. A triangle that hangs on one edge has no floor; it
//! is taken to cover the one that it hangs on, or it could come without it. One of the sixteen loop numbers stands for the
//! end of a loop, so a fragment is in at most 15; the rule's number has the other 12 of the paper's 16 bits. Where the links of
//! a fragment begin takes a bit more (`records.rs`).
//!
//! The paper's form holds surfaces only: [`build`](LoopPatterns::build) refuses seams, groups, stars that are not one fan
//! and floors that do not fill their hole, and says where. Borders are open rings, and holes may close.
//!
//! Cost: 116 bits a fragment and 36 an overlap, of which there are 2.3 to 2.5 a fragment. Changes are linear in the fragments that
//! come and go, a condition is asked for each overlap of what is shown.

mod build;
mod records;
mod refine;
mod rule;
mod state;
mod surface;

pub(super) use self::build::check_form;
use self::records::Records;
pub(super) use self::rule::{Rule, RuleTable, Shape};
pub use self::state::LoopPatternsState;
pub(super) use self::surface::{Found, Side, Surface};
use striata::model::{DrawCounts, LodModel, PartBytes, StepVertices, StoredModel, Topology};

use crate::paper_bytes::{Accounting, PaperBytes, pattern_bytes};

/// The static half of the model; see the [module](self).
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LoopPatterns {
    vertices: StepVertices<'static>,
    base: Vec<[u32; 3]>,
    /// Fragments that replace triangles of the base, or hang on them, rising.
    base_covers: Vec<u32>,
    rules: RuleTable,
    records: Records,
}

impl LoopPatterns {
    /// Rules: kinds of fragments, with those of open rings.
    pub fn rule_count(&self) -> usize {
        self.rules.len()
    }

    /// Pairs of fragments that overlap, those with the base not counted; the paper's `u`.
    pub fn overlap_count(&self) -> usize {
        self.records.link_count()
    }

    /// The fragments that a fragment stands on.
    ///
    /// # Panics
    /// If there is no such fragment.
    pub fn covered(&self, step: u32) -> impl Iterator<Item = u32> + '_ {
        self.records.covered(step)
    }

    /// The fragments that stand on a fragment, each found at the end of a loop.
    ///
    /// # Panics
    /// If there is no such fragment.
    pub fn covering(&self, step: u32) -> impl Iterator<Item = u32> + '_ {
        self.records.covering(step)
    }

    /// The fragments that stand on the base, rising.
    pub fn base_covers(&self) -> &[u32] {
        &self.base_covers
    }

    /// A new instance that shows the base.
    pub fn base_state(&self) -> LoopPatternsState {
        LoopPatternsState::base(self)
    }

    /// The fragment that makes a triangle; none for one of the base.
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

    /// Fragments that are inserted, whichever they are.
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
    /// The paper's bits of each fragment and each overlap, with the overlaps that there are.
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
