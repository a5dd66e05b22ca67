//! Patterns \[KG98\]: a Multi-Triangulation without its triangles, and the coarsest surface that satisfies a condition.
//!
//! Each step is a **fragment**: a few triangles around a position, the **ceiling**, which can replace the coarser
//! **floor**. Few kinds of fragments exist, so what a fragment looks like is stored once, as a **rule**; of the fragment itself there
//! remain the rule's number and how it hangs together with others: where a triangle of its ceiling is in a floor, the two
//! **overlap**.
//!
//! ```text
//!    floor of f          ceiling of f         its links up
//!    +-------+           +-------+            v a b, v b c -> fragment 41, from corner 2 of its floor on
//!    |\      |           |\  |  /|            v c d        -> none: the full mesh shows it
//!    |  \    |    <-->   |  \| / |            v d e, v e a -> fragment 97, from corner 7
//!    |    \  |           |---v---|            links down: 12 (what else f stands on, 12 needs itself)
//!    +-------+           +-------+
//! ```
//!
//! **What differs.** The paper stores two anchor vertices a fragment, and the hierarchy as closed loops of links. Here a link up names
//! the step above *and the corner of its floor* where the triangles go. So whoever makes a triangle knows its place in the
//! floor above, a floor is assembled by those who make it, and no anchor, no search and no adjacency is needed; edges of many
//! triangles, seams and groups are no exception. A link serves a run of triangles, and how runs share a ceiling is numbered
//! like rules are (`overlaps.rs`). Links down leave out what other links down need anyway. Everything is packed to the bit
//! (`records.rs`).
//!
//! **Which sets stand.** A fragment can be inserted once all that make its floor are. [`PatternInstance::adapt`] finds the smallest
//! such set that satisfies a [`Condition`], whatever was there before.
//!
//! Cost: building is linear but for the search of rules; inserting and removing a fragment touches its own triangles and a few list
//! heads, so extraction is linear in what it shows.

mod bounds;
mod build;
mod condition;
mod instance;
mod level;
mod overlaps;
mod parts;
mod records;
mod rule;
mod rule_table;
mod rulebook;
mod scene;
mod unpack;

pub use condition::{Condition, Overlap, PatternChange, Wanted};
pub use instance::PatternInstance;
pub use level::PatternsState;
pub(crate) use parts::PatternsParts;
pub use scene::PatternScene;

use self::build::Extras;
use self::overlaps::OverlapTable;
use self::records::{Head, Records};
use self::rule_table::RuleTable;
use super::StepVertices;
use super::step_bounds::StepBounds;

/// The static half of the model; see the [module](self).
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Patterns {
    vertices: StepVertices<'static>,
    group_count: usize,
    base: Vec<BaseFace>,
    /// Fragments whose floor is empty: nothing that is there calls for them.
    unfounded: Vec<u32>,
    rules: RuleTable,
    ways: OverlapTable,
    records: Records,
    extras: Extras,
    /// What views ask of each fragment; none of fragments alone.
    bounds: Option<StepBounds>,
}

/// A triangle of the base and where it goes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct BaseFace {
    /// The youngest first.
    corners: [u32; 3],
    group: u32,
    /// The step that replaces it; [`rule::NONE`] if the full mesh shows it.
    above: u32,
    /// The corner, in that step's floor, of its youngest vertex.
    half_edge: u32,
}

/// A place in a floor: the half-edge where a run begins, and how many triangles further around the vertex.
#[inline]
fn place_tag(half_edge: u32, along: u32) -> u32 {
    half_edge * overlaps::MAX_RUN + along
}

#[inline]
fn place_of(tag: u32) -> (u32, u32) {
    (tag / overlaps::MAX_RUN, tag % overlaps::MAX_RUN)
}

impl Patterns {
    /// Fragments: one for each step from the base mesh to the full mesh.
    pub fn fragment_count(&self) -> usize {
        self.records.step_count
    }

    /// Rules: kinds of fragments, with those of open rings.
    pub fn rule_count(&self) -> usize {
        self.rules.len()
    }

    /// Triangles of each level, coarse to fine.
    pub fn triangle_counts(&self) -> Vec<u32> {
        let mut count = self.base.len() as u32;
        let mut counts = vec![count];
        for step in 0..self.records.step_count as u32 {
            let rule = self.rules.rule(self.records.head(step).rule);
            count = (count + rule.ceiling_count() as u32).saturating_sub(rule.floor_count() as u32);
            counts.push(count);
        }
        counts
    }

    /// Pairs of fragments that overlap, those with the base not counted.
    pub fn overlap_count(&self) -> usize {
        let mut count = 0;
        let mut above = Vec::new();
        for step in 0..self.records.step_count as u32 {
            above.clear();
            self.for_each_above(step, |step| above.push(step));
            above.sort_unstable();
            above.dedup();
            count += above.len();
        }
        count
    }

    /// Calls `visit` with each fragment whose floor has triangles of a fragment's ceiling, once for each run of them.
    ///
    /// # Panics
    /// If there is no such fragment.
    #[inline]
    pub fn for_each_above(&self, step: u32, mut visit: impl FnMut(u32)) {
        let head = self.records.head(step);
        for link in 0..self.ways.link_count(head.way) {
            visit(self.records.up(&head, link).0);
        }
    }

    /// Calls `visit` with fragments that a fragment stands on: all that those do not need themselves, and maybe others.
    ///
    /// # Panics
    /// If there is no such fragment.
    pub fn for_each_below(&self, step: u32, visit: impl FnMut(u32)) {
        let head = self.records.head(step);
        self.down(&head).for_each(visit);
    }

    /// Appends the links up of a step.
    #[inline]
    fn links_into(&self, head: &Head, out: &mut Vec<(u32, u32)>) {
        out.extend((0..self.ways.link_count(head.way)).map(|link| self.records.up(head, link)));
    }

    #[inline]
    fn down(&self, head: &Head) -> impl Iterator<Item = u32> + use<'_> {
        self.records.down(head, self.ways.link_count(head.way))
    }
}
