//! Progressive meshes as Hoppe stores them \[Hop96\], \[Hop98\]: a base mesh and a record per vertex split.
//!
//! The static half contains no triangles except those of the base. Each record refers to one face next to
//! the split, and says how many faces around the vertex pass to the new vertex and which faces the split
//! adds. Each instance owns its faces, with three corners and three neighbors each, and finds everything
//! else by walking around the vertex.
//!
//! ```text
//!            l                          l
//!          / | \        split         / | \ \           A1 .. Ak: the run of faces that pass from
//!         /  |  \      ------->      /  |  \ \          the target u to the restored vertex v
//!      ..    u   A1                ..   u -- v  A1      left face v u l, right face v r u
//!         \  |  /      <-------      \  |  / /
//!          \ | /       collapse       \ | / /
//!            r                          r
//! ```
//!
//! New faces are appended to the list of their group, so a level is the first part of every list, and a
//! collapse removes the last faces.
//!
//! Differs: \[Hop98\] has 12 bytes per record, 4 of them for the materials of the new faces; these are
//! stored apart here and only if there are several groups. Corners with several wedges are listed instead
//! of being coded relative to their neighbors. Collapses are half-edge collapses over one vertex buffer.
//! Half-edges replace neighbors and rotation by corner, so that faces that share two edges are no problem.
//!
//! The surface has to be an oriented manifold at every level; borders are allowed.
//!
//! [`ProgressiveMeshes`](super::ProgressiveMeshes) lists corners instead of walking, which is faster and
//! takes more memory.
//!
//! Cost: a step visits about four faces and their neighbors. Building is linear in the stars that change.

mod build;
mod error;
mod faces;
mod star;
mod state;

use std::ops::Range;

pub use self::error::HoppeProgressiveMeshesError;
pub use self::state::HoppeProgressiveMeshesState;
use striata::model::{DrawCounts, LodModel, PartBytes, StepVertices, Topology};

use crate::paper_bytes::{Accounting, PaperBytes};

/// Bytes of a record in \[Hop98\] without the attributes of its vertices: `flclw`, `vlr_rot`, `code`,
/// `fl_matid` and `fr_matid`.
const PUBLISHED_RECORD_BYTES: usize = 12;

/// Code: the split adds the face on the left.
const HAS_LEFT: u16 = 1;
/// Code: the split adds the face on the right.
const HAS_RIGHT: u16 = 2;
/// Code: a border interrupts the run. `extras` has the half-edge and the number of faces of its other part.
const HAS_SECOND_RUN: u16 = 4;
/// Code: `extras` has the vertices of all corners, before and after the split.
const HAS_CORNERS: u16 = 8;

/// The record of a vertex split.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Split {
    /// The half-edge that leaves the target in the first face of the run. If the run is empty, the
    /// half-edge outside the left face, or outside the right one if there is no left one.
    half_edge: u32,
    /// Number of faces of the run.
    run: u16,
    code: u16,
}

/// The static half of the model; see the [module](self).
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct HoppeProgressiveMeshes {
    /// The vertices of each step, without targets.
    vertices: StepVertices<'static>,
    /// First face of each group in the list of the full mesh, followed by the number of faces.
    group_offsets: Vec<u32>,
    /// For each group, the number of its faces in the base.
    base_counts: Vec<u32>,
    /// Corners of the faces of the base, group after group.
    base_corners: Vec<[u32; 3]>,
    /// Opposite half-edges of these corners.
    base_twins: Vec<[u32; 3]>,
    splits: Vec<Split>,
    /// Groups of the left and the right face of each split; empty if there is only one group.
    face_groups: Vec<[u16; 2]>,
    /// Further words of some splits.
    extras: Vec<u32>,
}

impl HoppeProgressiveMeshes {
    /// Number of groups of triangles.
    pub fn group_count(&self) -> usize {
        self.base_counts.len()
    }

    /// For each group (material), the range of [`HoppeProgressiveMeshesState::indices`] to draw as triangles.
    ///
    /// # Panics
    /// If the state belongs to a model with another number of groups.
    pub fn group_ranges(&self, state: &HoppeProgressiveMeshesState) -> impl Iterator<Item = Range<u32>> {
        assert_eq!(state.live_counts().len(), self.group_count(), "the state belongs to another model");
        let live = self.group_offsets.iter().zip(state.live_counts());
        live.map(|(&first, &count)| 3 * first..3 * (first + count))
    }

    fn face_count(&self) -> usize {
        self.group_offsets[self.group_count()] as usize
    }

    /// Groups of the left and the right face of a split.
    #[inline]
    fn groups_of(&self, step: usize) -> [usize; 2] {
        self.face_groups.get(step).map_or([0; 2], |groups| groups.map(usize::from))
    }

    /// Number of words of a split in `extras`.
    #[inline]
    fn extra_count(&self, split: Split, second_run: usize) -> usize {
        let second = if split.code & HAS_SECOND_RUN == 0 { 0 } else { 2 };
        let faces = (split.code & (HAS_LEFT | HAS_RIGHT)).count_ones() as usize;
        let corners = if split.code & HAS_CORNERS == 0 {
            0
        } else {
            2 * (usize::from(split.run) + second_run) + 3 * faces
        };
        second + corners
    }
}

impl LodModel for HoppeProgressiveMeshes {
    type State = HoppeProgressiveMeshesState;

    fn step_count(&self) -> usize {
        self.splits.len()
    }

    fn new_state(&self) -> HoppeProgressiveMeshesState {
        HoppeProgressiveMeshesState::new(self)
    }

    fn split_count(&self, state: &HoppeProgressiveMeshesState) -> usize {
        state.split_count()
    }

    fn move_to(&self, state: &mut HoppeProgressiveMeshesState, split_count: usize) {
        state.move_to(self, split_count);
    }

    fn topology(&self) -> Topology {
        Topology::Triangles
    }

    fn draw_counts(&self, state: &HoppeProgressiveMeshesState) -> DrawCounts {
        let triangle_count: usize = state.live_counts().iter().map(|&n| n as usize).sum();
        DrawCounts { strip_count: 0, index_count: 3 * triangle_count }
    }

    fn indices_into(&self, state: &HoppeProgressiveMeshesState, out: &mut Vec<u32>) {
        for range in self.group_ranges(state) {
            out.extend_from_slice(&state.indices()[range.start as usize..range.end as usize]);
        }
    }

    fn bytes(&self) -> Vec<PartBytes> {
        let part = |name, bytes| PartBytes { name, bytes };
        vec![
            part("base", size_of_val(&self.base_corners[..]) + size_of_val(&self.base_twins[..])),
            part("groups", 4 * (self.group_offsets.len() + self.base_counts.len())),
            part("splits", size_of_val(&self.splits[..])),
            part("groups of faces", size_of_val(&self.face_groups[..])),
            part("extras", 4 * (self.extras.len() + self.vertices.word_count())),
        ]
    }

    fn state_bytes(&self, state: &HoppeProgressiveMeshesState) -> usize {
        state.bytes()
    }
}

impl PaperBytes for HoppeProgressiveMeshes {
    /// The record of \[Hop98\], 12 bytes, whatever the accounting; three long integers and three pointers
    /// per face of the base, and a long integer per further word.
    fn paper_bytes(&self, accounting: Accounting) -> usize {
        let longs = 6 * self.base_corners.len() + self.extras.len();
        accounting.bytes(0, longs) + PUBLISHED_RECORD_BYTES * self.splits.len()
    }
}
