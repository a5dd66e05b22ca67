//! Patterns \[KG98\]: a Multi-Triangulation stored without its triangles, and the coarsest surface that
//! satisfies a condition.
//!
//! Each step is a **fragment**: a few triangles around a position, the **ceiling**, which can replace the
//! coarser **floor**. Only a few kinds of fragments exist, so the shape of a fragment is stored once, as a
//! **rule**. The fragment itself stores only the index of its rule and how it is connected to other
//! fragments: if a triangle of its ceiling belongs to the floor of another fragment, the two **overlap**.
//!
//! ```text
//!    floor of f          ceiling of f         its links up
//!    +-------+           +-------+            v a b, v b c -> fragment 41, from corner 2 of its floor on
//!    |\      |           |\  |  /|            v c d        -> none: the triangle is part of the full mesh
//!    |  \    |    <-->   |  \| / |            v d e, v e a -> fragment 97, from corner 7
//!    |    \  |           |---v---|            links down: 12 (f also depends on others that 12 needs anyway)
//!    +-------+           +-------+
//! ```
//!
//! **Differs:** the paper stores two anchor vertices per fragment, and the hierarchy as closed loops of
//! links. Here, a link up names the step above *and the corner of its floor* where the triangles go. The
//! fragment that creates a triangle therefore knows where it belongs in the floor above, and a floor is
//! assembled by its creators. No anchor, search or adjacency is needed, and non-manifold edges, seams and
//! groups need no special treatment. One link serves a run of triangles. How runs share a ceiling is
//! called its sharing (`overlaps.rs`); the pairs of a rule and a sharing that occur are indexed by
//! frequency (`kinds.rs`). Links down omit most of what other links down need anyway (`dependencies.rs`).
//! All records are bit-packed (`records.rs`).
//!
//! **Valid sets.** A fragment can be inserted once all fragments that create its floor are inserted.
//! [`PatternInstance::adapt`] finds the smallest valid set that satisfies a [`Condition`], regardless of
//! the current one.
//!
//! Cost: building is linear except for the search for rules. Inserting or removing a fragment touches its
//! own triangles and a few list heads. Extraction is linear in the number of triangles.

mod bounds;
mod build;
mod condition;
mod dependencies;
mod exchange;
mod instance;
mod kinds;
mod level;
mod overlaps;
mod parts;
mod records;
mod rule;
mod rule_table;
mod rulebook;
mod scene;
mod unpack;
mod walk;

pub use condition::{Condition, CriterionCondition, Overlap, PatternChange};
pub use instance::PatternInstance;
pub use level::PatternsState;
pub(crate) use parts::{HEADER_LEN, PatternsParts};
pub use scene::PatternScene;

use self::bounds::{BoundScale, PackedBounds};
use self::kinds::KindTable;
use self::overlaps::OverlapTable;
use self::records::{Records, StepHead, UpLink};
use self::rule_table::{RuleRef, RuleTable};
use super::StepVertices;

/// The static half of the model, shared by all instances; see the [module](self).
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Patterns {
    vertices: StepVertices<'static>,
    group_count: usize,
    base: Vec<BaseFace>,
    /// Fragments with an empty floor, which no existing triangle leads to.
    floorless: Vec<u32>,
    rules: RuleTable,
    sharings: OverlapTable,
    kinds: KindTable,
    records: Records,
    /// How errors of overlaps are packed, if the model has them.
    overlap_errors: Option<BoundScale>,
    /// Bounds of each fragment for view-dependent refinement, unless the model was built without them.
    bounds: Option<PackedBounds>,
}

/// A triangle of the base mesh and the fragment that replaces it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct BaseFace {
    /// Vertices, youngest first.
    corners: [u32; 3],
    group: u32,
    /// Step that replaces it, or [`rule::NONE`] if it is part of the full mesh.
    above: u32,
    /// Corner of its youngest vertex in the floor of that step.
    code: u32,
    /// Packed error; 0 if the model has no errors of overlaps.
    error: u32,
}

impl Patterns {
    /// Number of fragments; there is one per step from the base mesh to the full mesh.
    pub fn fragment_count(&self) -> usize {
        self.records.step_count
    }

    /// Number of rules, that is, of different kinds of fragments.
    pub fn rule_count(&self) -> usize {
        self.rules.len()
    }

    /// Whether the model has an error for each overlap, not only for each fragment.
    pub fn has_overlap_errors(&self) -> bool {
        self.overlap_errors.is_some()
    }

    /// Returns the triangle count of each level, from coarse to fine.
    pub fn triangle_counts(&self) -> Vec<u32> {
        let of_kinds = self.kind_counts();
        let mut count = self.base.len() as u32;
        let mut counts = Vec::with_capacity(self.records.step_count + 1);
        counts.push(count);
        self.records.for_each_head(|_, head| {
            let [ceiling, floor] = of_kinds[head.kind as usize];
            count = (count + ceiling).saturating_sub(floor);
            counts.push(count);
        });
        counts
    }

    /// Returns the number of triangles of the ceiling and of the floor of each kind.
    fn kind_counts(&self) -> Vec<[u32; 2]> {
        let counts = |kind: u32| {
            let rule = self.rules.rule(self.kinds.get(kind).0);
            [rule.ceiling_count() as u32, rule.floor_count() as u32]
        };
        (0..self.kinds.len()).map(counts).collect()
    }

    /// Number of pairs of fragments that overlap, not counting overlaps with the base mesh.
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

    /// Calls `visit` with each fragment whose floor contains triangles of this fragment's ceiling, once
    /// per run of triangles.
    ///
    /// # Panics
    /// If the fragment does not exist.
    #[inline]
    pub fn for_each_above(&self, step: u32, mut visit: impl FnMut(u32)) {
        let head = self.records.head(step);
        self.records.ups(&head).for_each(|up| visit(up.above));
    }

    /// Calls `visit` with fragments on which a fragment depends. Dependencies of the visited
    /// fragments may be omitted.
    ///
    /// # Panics
    /// If the fragment does not exist.
    pub fn for_each_below(&self, step: u32, visit: impl FnMut(u32)) {
        let head = self.records.head(step);
        self.records.downs(&head).for_each(visit);
    }

    #[inline]
    fn rule_of(&self, head: &StepHead) -> RuleRef<'_> {
        self.rules.rule(self.kinds.get(head.kind).0)
    }

    /// Returns the error of the triangles that a link leads from.
    #[inline]
    fn error_of(&self, above: u32, code: u32) -> f32 {
        match (&self.overlap_errors, &self.bounds) {
            (Some(scale), _) => scale.error(code),
            (None, Some(bounds)) => bounds.error(above),
            (None, None) => f32::INFINITY,
        }
    }

    /// Returns the overlap of a step that a link leads from; `None` for the base mesh.
    #[inline]
    fn overlap(&self, lower: Option<u32>, up: UpLink) -> Overlap {
        Overlap { lower, upper: up.above, error: self.error_of(up.above, up.error) }
    }
}
