//! Progressive fans as published \[Cor01\]: a table of rings in machine words, and one bit per vertex.
//!
//! The entry of a vertex has its ring `A` and its dependencies `D`: a mask of the arcs of the full mesh, and one for
//! each step that creates some of the others (section 3.6.1). Crowns are joined to one cyclic ring, whose arcs
//! between them belong to no mask. An instance is a set of simplified vertices; `SimplificaVertex` and
//! `InsertaVertex` (section 3.5.2) follow the dependencies, and `glDrawSelectivePF` (section 3.6.3) turns the runs
//! of each mask into fans. The criterion is that of \[Hop97\], which the paper adopts: a sphere, a cone of normals,
//! and two scalars for the errors across the surface and along it (`criterion.rs`).
//!
//! Differs: stacks replace the recursions. A view is followed in one pass over the bits from coarse to fine, which
//! inserts, and one from fine to coarse, which simplifies; the paper only says that its pass is linear. Vertices
//! have one wedge; [`build`](PublishedFans::build) rejects others.
//!
//! At borders, the published dependencies are too few: a vertex may be simplified while a triangle that uses it is
//! shown. [`Fans`] stores what is missing.

mod build;
mod criterion;
mod deviations;
mod state;

pub use self::build::PublishedFansError;
pub use self::criterion::{PublishedChanges, PublishedView, VertexCriterion};
pub use self::state::PublishedFansState;
use striata::model::{DrawCounts, Fans, LodModel, PartBytes, Topology};

use crate::paper_bytes::{Accounting, PaperBytes};

/// Step of the dependency that has the arcs of the full mesh.
const NONE: u32 = u32::MAX;

/// The static half of the model; see the [module](self).
#[derive(Clone, Debug, PartialEq)]
pub struct PublishedFans {
    base_vertex_count: u32,
    step_count: usize,
    entries: Vec<EntryRanges>,
    rings: Vec<u32>,
    dependencies: Vec<Dependency>,
    masks: Vec<u8>,
    /// Data of the criterion; one per vertex.
    criteria: Vec<VertexCriterion>,
    normals: Vec<[f32; 3]>,
    positions: Vec<[f32; 3]>,
    /// Bytes of the table of [`Fans`] as the paper counts them.
    paper_bytes: [usize; 2],
}

/// First elements of an entry in the flat arrays; it ends where the next one begins.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
struct EntryRanges {
    ring: u32,
    dependency: u32,
}

/// Arcs that exist once a step has been simplified.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Dependency {
    /// The step, or [`NONE`] for the arcs of the full mesh.
    step: u32,
    /// First byte of the mask.
    mask: u32,
}

impl PublishedFans {
    /// Number of vertices of the full mesh.
    pub fn vertex_count(&self) -> usize {
        self.entries.len() - 1
    }

    /// Data of the criterion of a step's vertex.
    ///
    /// # Panics
    /// If the step does not exist.
    pub fn criterion(&self, step: u32) -> &VertexCriterion {
        &self.criteria[(self.base_vertex_count + step) as usize]
    }

    #[inline]
    fn ring(&self, vertex: u32) -> &[u32] {
        let [entry, next] = [self.entries[vertex as usize], self.entries[vertex as usize + 1]];
        &self.rings[entry.ring as usize..next.ring as usize]
    }

    #[inline]
    fn dependencies(&self, vertex: u32) -> &[Dependency] {
        let [entry, next] = [self.entries[vertex as usize], self.entries[vertex as usize + 1]];
        &self.dependencies[entry.dependency as usize..next.dependency as usize]
    }

    #[inline]
    fn mask(&self, dependency: Dependency, byte_count: usize) -> &[u8] {
        &self.masks[dependency.mask as usize..][..byte_count]
    }

    /// The step that removes a vertex, unless it is in the base.
    #[inline]
    fn step_of(&self, vertex: u32) -> Option<u32> {
        vertex.checked_sub(self.base_vertex_count)
    }
}

impl LodModel for PublishedFans {
    type State = PublishedFansState;

    fn step_count(&self) -> usize {
        self.step_count
    }

    fn new_state(&self) -> PublishedFansState {
        PublishedFansState::full(self)
    }

    fn split_count(&self, state: &PublishedFansState) -> usize {
        state.split_count()
    }

    fn move_to(&self, state: &mut PublishedFansState, split_count: usize) {
        assert!(split_count <= self.step_count, "split count {split_count} of {}", self.step_count);
        state.set_level(split_count);
    }

    fn topology(&self) -> Topology {
        Topology::Triangles
    }

    fn draw_counts(&self, state: &PublishedFansState) -> DrawCounts {
        let mut index_count = 0;
        state.for_each_run(self, |_, run| index_count += 3 * (run.count - 1));
        DrawCounts { strip_count: 0, index_count }
    }

    fn indices_into(&self, state: &PublishedFansState, out: &mut Vec<u32>) {
        state.triangles_into(self, out);
    }

    fn bytes(&self) -> Vec<PartBytes> {
        let part = |name, bytes| PartBytes { name, bytes };
        vec![
            part("entries", size_of_val(&self.entries[..])),
            part("rings", size_of_val(&self.rings[..])),
            part("dependencies", size_of_val(&self.dependencies[..])),
            part("masks", self.masks.len()),
            part("criteria", size_of_val(&self.criteria[..]) + size_of_val(&self.normals[..])),
        ]
    }

    fn state_bytes(&self, state: &PublishedFansState) -> usize {
        state.bytes()
    }
}

impl PaperBytes for PublishedFans {
    /// Section 3.6.2 of \[Cor01\]: the table, and four numbers per vertex for the criterion. Positions and normals
    /// are not counted.
    fn paper_bytes(&self, accounting: Accounting) -> usize {
        let table = match accounting {
            Accounting::Words => self.paper_bytes[0],
            Accounting::ShortIntegers => self.paper_bytes[1],
        };
        table + 16 * self.vertex_count()
    }
}

/// Bytes of a table as the paper counts it, with either size of integers.
fn paper_bytes_of(fans: &Fans) -> [usize; 2] {
    [Accounting::Words, Accounting::ShortIntegers].map(|accounting| fans.paper_bytes(accounting))
}
