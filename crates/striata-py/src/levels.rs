//! The levels of a mesh, whose models are built when they are first needed.
//!
//! A level is found by following collapse targets, which needs nothing but the sequence. Views and files need
//! progressive fans, which take about half as long to build as the sequence itself; many callers want only
//! levels.

use std::sync::{Arc, Mutex, OnceLock, PoisonError};

use striata::mesh::{CollapseSequence, IndexedMesh, RefinableMesh, replay};
use striata::{Cancelled, Lod, ProgressFn, Target};

use crate::sources::representatives;

/// Every level of a mesh; clones share their data.
#[derive(Clone, Debug)]
pub struct Levels {
    shared: Arc<Shared>,
}

#[derive(Debug)]
enum Shared {
    /// Built here; the models follow if they are needed.
    Built(Built),
    /// Came with its models.
    Opened(Lod),
}

#[derive(Debug)]
struct Built {
    refinable: Box<RefinableMesh>,
    has_guaranteed_errors: bool,
    lod: OnceLock<Lod>,
    /// Held by the call that builds the models, so that others wait for it.
    building: Mutex<()>,
}

impl Built {
    fn lod(&self, progress: &mut ProgressFn<'_>) -> Result<&Lod, Cancelled> {
        if let Some(lod) = self.lod.get() {
            return Ok(lod);
        }
        let _guard = self.building.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(lod) = self.lod.get() {
            return Ok(lod);
        }
        let refinable = RefinableMesh::clone(&self.refinable);
        let lod = match self.has_guaranteed_errors {
            true => Lod::from_certified_with_progress(refinable, progress)?,
            false => Lod::from_refinable_with_progress(refinable, progress)?,
        };
        Ok(self.lod.get_or_init(|| lod))
    }
}

impl Levels {
    /// Wraps a mesh with its sequence.
    pub fn new(refinable: RefinableMesh, has_guaranteed_errors: bool) -> Self {
        let refinable = Box::new(refinable);
        let (lod, building) = (OnceLock::new(), Mutex::new(()));
        Self { shared: Arc::new(Shared::Built(Built { refinable, has_guaranteed_errors, lod, building })) }
    }

    /// Levels with models for views and files, which are built by the first call.
    ///
    /// # Errors
    /// [`Cancelled`] if the callback cancels.
    pub fn lod(&self, progress: &mut ProgressFn<'_>) -> Result<&Lod, Cancelled> {
        match &*self.shared {
            Shared::Opened(lod) => Ok(lod),
            Shared::Built(built) => built.lod(progress),
        }
    }

    /// The full mesh, in refinement order.
    pub fn mesh(&self) -> &IndexedMesh {
        match &*self.shared {
            Shared::Built(built) => &built.refinable.mesh,
            Shared::Opened(lod) => lod.mesh(),
        }
    }

    /// The collapses.
    pub fn sequence(&self) -> &CollapseSequence {
        match &*self.shared {
            Shared::Built(built) => &built.refinable.sequence,
            Shared::Opened(lod) => lod.sequence(),
        }
    }

    /// Whether errors are bounds rather than estimates.
    pub fn has_guaranteed_errors(&self) -> bool {
        match &*self.shared {
            Shared::Built(built) => built.has_guaranteed_errors,
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
            Shared::Built(built) => {
                let split_count = split_count.min(self.sequence().step_count());
                replay(&built.refinable, split_count).without_unused_vertices()
            }
            Shared::Opened(lod) => lod.level_mesh(Target::SplitCount(split_count)),
        }
    }

    /// A level as strips with restart indices, over the vertices of the full mesh.
    ///
    /// # Errors
    /// [`Cancelled`] if the callback cancels.
    pub fn level_strips(
        &self,
        split_count: usize,
        progress: &mut ProgressFn<'_>,
    ) -> Result<Vec<u32>, Cancelled> {
        Ok(self.lod(progress)?.level(Target::SplitCount(split_count)).strips().indices)
    }
}

impl From<Lod> for Levels {
    fn from(lod: Lod) -> Self {
        Self { shared: Arc::new(Shared::Opened(lod)) }
    }
}

#[cfg(test)]
mod tests {
    use std::ops::ControlFlow;

    use striata::ignore_progress;
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
            let strips =
                [&built, &opened].map(|levels| levels.level_strips(split_count, &mut ignore_progress));
            assert_eq!(strips[0], strips[1]);
            assert_eq!(built.representatives(split_count), opened.representatives(split_count));
        }
        assert!(!built.has_guaranteed_errors() && !opened.has_guaranteed_errors());
    }

    #[test]
    fn models_that_were_cancelled_are_built_by_the_next_call() {
        let built = build_sequence(&shapes::terrain(16, 3), &SequenceOptions::default()).unwrap();
        let levels = Levels::new(built.refinable, true);
        assert_eq!(levels.lod(&mut |_| ControlFlow::Break(())).map(drop), Err(Cancelled));
        assert!(levels.lod(&mut ignore_progress).unwrap().has_guaranteed_errors());
        assert!(levels.lod(&mut |_| ControlFlow::Break(())).is_ok());
    }
}
