//! A mesh with the steps of any simplifier.

use std::borrow::Cow;

use super::{FragmentedMesh, IndexedMesh, LevelTable, RefinableMesh, replay, replay_fragments};

/// A mesh in refinement order, with the steps that lead to it from its base mesh.
#[derive(Clone, Debug, PartialEq)]
pub enum Steps {
    /// Half-edge collapses only.
    Collapses(RefinableMesh),
    /// Steps that fill holes freely, or have vertices of their own.
    Fragments(FragmentedMesh),
}

impl Steps {
    /// The full mesh in refinement order.
    pub fn mesh(&self) -> &IndexedMesh {
        match self {
            Self::Collapses(refinable) => &refinable.mesh,
            Self::Fragments(fragmented) => &fragmented.mesh,
        }
    }

    /// Takes the full mesh.
    pub fn into_mesh(self) -> IndexedMesh {
        match self {
            Self::Collapses(refinable) => refinable.mesh,
            Self::Fragments(fragmented) => fragmented.mesh,
        }
    }

    /// Counts and errors of all levels.
    pub fn levels(&self) -> &LevelTable {
        match self {
            Self::Collapses(refinable) => refinable.sequence.levels(),
            Self::Fragments(fragmented) => fragmented.fragments.levels(),
        }
    }

    /// The collapses; [`None`] if the steps are others.
    pub fn collapses(&self) -> Option<&RefinableMesh> {
        match self {
            Self::Collapses(refinable) => Some(refinable),
            Self::Fragments(_) => None,
        }
    }

    /// The steps as fragments.
    pub fn fragments(&self) -> Cow<'_, FragmentedMesh> {
        match self {
            Self::Collapses(refinable) => Cow::Owned(FragmentedMesh::from_collapses(refinable)),
            Self::Fragments(fragmented) => Cow::Borrowed(fragmented),
        }
    }

    /// Returns the mesh of a level.
    ///
    /// # Panics
    /// If there are fewer steps than `split_count`.
    pub fn level(&self, split_count: usize) -> IndexedMesh {
        match self {
            Self::Collapses(refinable) => replay(refinable, split_count),
            Self::Fragments(fragmented) => replay_fragments(fragmented, split_count),
        }
    }
}
