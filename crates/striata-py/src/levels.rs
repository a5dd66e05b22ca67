//! The levels of a mesh, whose models are built when they are first needed.
//!
//! A level is found by following collapse targets, which needs nothing but the sequence. Views and files need
//! progressive fans, which take about half as long to build as the sequence itself; many callers want only
//! levels.

use std::sync::{Arc, OnceLock};

use striata::mesh::{CollapseSequence, IndexedMesh, RefinableMesh, replay};
use striata::{Lod, Target};

use crate::sources::representatives;

/// Every level of a mesh; clones share their data.
#[derive(Clone, Debug)]
pub struct Levels {
    shared: Arc<Shared>,
}

#[derive(Debug)]
enum Shared {
    /// Built here; the models follow if they are needed.
    Built { refinable: Box<RefinableMesh>, has_guaranteed_errors: bool, lod: OnceLock<Lod> },
    /// Came with its models.
    Opened(Lod),
}

impl Levels {
    /// Wraps a mesh with its sequence.
    pub fn new(refinable: RefinableMesh, has_guaranteed_errors: bool) -> Self {
        let refinable = Box::new(refinable);
        Self { shared: Arc::new(Shared::Built { refinable, has_guaranteed_errors, lod: OnceLock::new() }) }
    }

    /// Levels with models for views and files, which are built by the first call.
    pub fn lod(&self) -> &Lod {
        match &*self.shared {
            Shared::Opened(lod) => lod,
            Shared::Built { refinable, has_guaranteed_errors, lod } => {
                lod.get_or_init(|| match has_guaranteed_errors {
                    true => Lod::from_certified(RefinableMesh::clone(refinable)),
                    false => Lod::from_refinable(RefinableMesh::clone(refinable)),
                })
            }
        }
    }

    /// The full mesh, in refinement order.
    pub fn mesh(&self) -> &IndexedMesh {
        match &*self.shared {
            Shared::Built { refinable, .. } => &refinable.mesh,
            Shared::Opened(lod) => lod.mesh(),
        }
    }

    /// The collapses.
    pub fn sequence(&self) -> &CollapseSequence {
        match &*self.shared {
            Shared::Built { refinable, .. } => &refinable.sequence,
            Shared::Opened(lod) => lod.sequence(),
        }
    }

    /// Whether errors are bounds rather than estimates.
    pub fn has_guaranteed_errors(&self) -> bool {
        match &*self.shared {
            Shared::Built { has_guaranteed_errors, .. } => *has_guaranteed_errors,
            Shared::Opened(lod) => lod.has_guaranteed_errors(),
        }
    }

    /// For each vertex of the full mesh, the vertex that represents it at a level. Split counts above the full
    /// mesh mean the full mesh.
    pub fn representatives(&self, split_count: usize) -> Vec<u32> {
        representatives(self.sequence(), split_count.min(self.sequence().step_count()))
    }

    /// A level as a mesh of its own, with only the vertices that it uses.
    pub fn level_mesh(&self, split_count: usize) -> IndexedMesh {
        match &*self.shared {
            Shared::Built { refinable, .. } => {
                replay(refinable, split_count.min(self.sequence().step_count())).without_unused_vertices()
            }
            Shared::Opened(lod) => lod.level(Target::SplitCount(split_count)).to_mesh(),
        }
    }

    /// A level as strips with restart indices, over the vertices of the full mesh.
    pub fn level_strips(&self, split_count: usize) -> Vec<u32> {
        self.lod().level(Target::SplitCount(split_count)).strips().indices
    }
}

impl From<Lod> for Levels {
    fn from(lod: Lod) -> Self {
        Self { shared: Arc::new(Shared::Opened(lod)) }
    }
}

#[cfg(test)]
mod tests {
    use striata::mesh::{canonical_triangles, shapes};
    use striata::simplify::{SequenceOptions, build_sequence};

    use super::*;

    #[test]
    fn built_and_opened_levels_are_the_same() {
        let built = build_sequence(&shapes::terrain(16, 3), &SequenceOptions::default()).unwrap();
        let opened = Levels::from(Lod::from_refinable(built.refinable.clone()));
        let built = Levels::new(built.refinable, false);
        for split_count in [0, 20, usize::MAX] {
            let [ours, theirs] = [&built, &opened].map(|levels| levels.level_mesh(split_count));
            assert_eq!(canonical_triangles(&ours.triangles), canonical_triangles(&theirs.triangles));
            assert_eq!(ours.positions, theirs.positions);
            assert_eq!(built.level_strips(split_count), opened.level_strips(split_count));
            assert_eq!(built.representatives(split_count), opened.representatives(split_count));
        }
        assert!(!built.has_guaranteed_errors() && !opened.has_guaranteed_errors());
    }
}
