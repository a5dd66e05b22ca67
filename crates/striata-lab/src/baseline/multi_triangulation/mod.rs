//! The explicit Multi-Triangulation \[Pup96\], \[KK97\]: lists of triangles and fragments that name each other.
//!
//! Every triangle of every level is listed once, with its vertices and its two fragments: the **lower** one, whose ceiling it is
//! in, and the **upper** one, whose floor it is in. Every fragment lists the triangles of its ceiling and its floor. So what
//! a fragment stands on and what stands on it are each one look away, and any set of fragments can be inserted that has, for
//! each of them, the lower fragments of its floor.
//!
//! ```text
//!     ceiling  \ | /      6 triangles made by the fragment; each names its upper fragment, if something refines it
//!     --------- (v)       fragment: ceiling, floor, error
//!     floor    | / |      4 triangles that it replaces; each names its lower fragment, or it is the base's
//! ```
//!
//! Nothing here walks from a triangle to its neighbors, so any mesh will do: borders, seams, groups, non-manifold places.
//!
//! Differs: a fragment without a floor (a triangle that hangs on one edge, a vertex without triangles) stands on nothing, so that no
//! triangle tells that it is missing; a condition is asked for it by itself. Beside the two steps of \[KG98\] section 3.4,
//! [`coarsen`](MultiTriangulation::coarsen) and [`refine`](MultiTriangulation::refine), there is
//! [`adapt`](MultiTriangulation::adapt), which comes to the smallest set for conditions too where a fine triangle may be wanted
//! although the coarse one below would do.
//!
//! Cost: 160 bytes a vertex where vertices have six triangles when they go, as three times as many triangles as the full mesh has
//! make 120 and their numbers in the lists 40. Quadrics take vertices of fewer triangles first: 134 to 142 bytes as
//! the paper counts, 146 to 154 with lengths and errors. A condition costs a question for each triangle that is shown and the change
//! itself.

mod refine;
mod state;

pub use self::refine::MtQuestion;
pub use self::state::MultiTriangulationState;
use striata::mesh::{Face, Fragment, FragmentSequence, FragmentedMesh};
use striata::model::{
    DrawCounts, LodModel, ModelError, PartBytes, Patterns, StepVertices, StoredModel, Topology,
};

use crate::paper_bytes::{Accounting, PaperBytes};

/// A triangle of some levels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct MtTriangle {
    /// Its vertices, counterclockwise.
    pub corners: [u32; 3],
    /// The fragment that makes it; [`FragmentSequence::NO_STEP`] for one of the base.
    pub lower: u32,
    /// The fragment that replaces it; [`FragmentSequence::NO_STEP`] for one of the full mesh.
    pub upper: u32,
}

/// The static half of the model; see the [module](self).
#[derive(Clone, Debug, PartialEq)]
pub struct MultiTriangulation {
    vertices: StepVertices<'static>,
    /// The base's first.
    triangles: Vec<MtTriangle>,
    base_triangle_count: usize,
    ceilings: Lists,
    floors: Lists,
    /// How far off each fragment's floor is.
    errors: Vec<f32>,
    /// Fragments without a floor, rising.
    floorless: Vec<u32>,
    group_count: usize,
    /// The group of each triangle; empty where there is one group.
    groups: Vec<u32>,
}

/// A list of triangles for each fragment.
#[derive(Clone, Debug, PartialEq, Eq)]
struct Lists {
    /// First entry of each, closed by their number.
    firsts: Vec<u32>,
    entries: Vec<u32>,
}

impl Lists {
    fn of<'a, I: IntoIterator<Item = u32> + 'a>(lists: impl Iterator<Item = I>) -> Self {
        let mut out = Self { firsts: vec![0], entries: Vec::new() };
        for list in lists {
            out.entries.extend(list);
            out.firsts.push(out.entries.len() as u32);
        }
        out
    }

    #[inline]
    fn get(&self, step: u32) -> &[u32] {
        &self.entries[self.firsts[step as usize] as usize..self.firsts[step as usize + 1] as usize]
    }

    fn bytes(&self) -> usize {
        4 * (self.firsts.len() + self.entries.len())
    }
}

impl MultiTriangulation {
    /// Lists all triangles and fragments.
    ///
    /// # Panics
    /// If the mesh is not the sequence's: it lacks a group that a face is in.
    pub fn build(mesh: &FragmentedMesh) -> Self {
        let fragments = &mesh.fragments;
        let replaced_by = fragments.replacing_steps();
        let triangle = |(face, upper): (u32, &u32)| MtTriangle {
            corners: fragments.faces()[face as usize].corners,
            lower: fragments.creating_step(face).unwrap_or(FragmentSequence::NO_STEP),
            upper: *upper,
        };
        let steps = || 0..fragments.step_count() as u32;
        let group_count = mesh.mesh.groups.len().max(1);
        let groups = || fragments.faces().iter().map(|face| face.group);
        assert!(
            groups().all(|group| (group as usize) < group_count),
            "a face is in a group that is not there"
        );
        Self {
            vertices: StepVertices::of_levels(fragments.levels()),
            triangles: (0..).zip(&replaced_by).map(triangle).collect(),
            base_triangle_count: fragments.base_face_count(),
            ceilings: Lists::of(steps().map(|step| fragments.ceiling(step))),
            floors: Lists::of(steps().map(|step| fragments.floor(step).iter().copied())),
            errors: steps().map(|step| fragments.floor_error(step)).collect(),
            floorless: steps().filter(|&step| fragments.floor(step).is_empty()).collect(),
            group_count,
            groups: if group_count > 1 { groups().collect() } else { Vec::new() },
        }
    }

    /// All triangles: the base's, then the ceilings' by step.
    pub fn triangles(&self) -> &[MtTriangle] {
        &self.triangles
    }

    /// Triangles of the base: the first so many.
    pub fn base_triangle_count(&self) -> usize {
        self.base_triangle_count
    }

    /// Numbers of the triangles that a fragment brings.
    ///
    /// # Panics
    /// If there is no such fragment.
    #[inline]
    pub fn ceiling(&self, step: u32) -> &[u32] {
        self.ceilings.get(step)
    }

    /// Numbers of the triangles that a fragment replaces.
    ///
    /// # Panics
    /// If there is no such fragment.
    #[inline]
    pub fn floor(&self, step: u32) -> &[u32] {
        self.floors.get(step)
    }

    /// How far a fragment's floor is from the surface that it stands for, mesh units.
    ///
    /// # Panics
    /// If there is no such fragment.
    pub fn error(&self, step: u32) -> f32 {
        self.errors[step as usize]
    }

    /// Vertices of the base mesh.
    pub fn base_vertex_count(&self) -> usize {
        self.vertices.base_vertex_count() as usize
    }

    /// The same as patterns.
    ///
    /// # Errors
    /// As [`Patterns::build`].
    pub fn to_patterns(&self) -> Result<Patterns, ModelError> {
        Patterns::from_fragments(&self.to_fragments(), self.group_count)
    }

    /// The fragments that these are the triangles of.
    pub fn to_fragments(&self) -> FragmentSequence {
        let face = |&number: &u32| Face {
            corners: self.triangles[number as usize].corners,
            group: self.groups.get(number as usize).map_or(0, |&group| group),
        };
        let faces = |numbers: &[u32]| numbers.iter().map(face).collect();
        let fragment = |step| Fragment {
            ceiling: faces(self.ceiling(step)),
            floor: faces(self.floor(step)),
            error: self.error(step),
        };
        let base = (0..self.base_triangle_count as u32).map(|number| face(&number)).collect();
        let fragments = (0..self.errors.len() as u32).map(fragment);
        FragmentSequence::from_fragments(self.vertices.positions(), base, fragments)
            .expect("the triangles were those of fragments")
    }

    /// A new instance that shows the base.
    pub fn base_state(&self) -> MultiTriangulationState {
        MultiTriangulationState::base(self)
    }

    fn group_indices_into(&self, state: &MultiTriangulationState, group: usize, out: &mut Vec<u32>) {
        assert!(group < self.group_count, "group {group} of {}", self.group_count);
        if self.groups.is_empty() {
            out.extend_from_slice(state.triangles().as_flattened());
            return;
        }
        for (number, corners) in state.numbered() {
            if self.groups[number as usize] as usize == group {
                out.extend_from_slice(corners);
            }
        }
    }
}

impl LodModel for MultiTriangulation {
    type State = MultiTriangulationState;

    fn step_count(&self) -> usize {
        self.errors.len()
    }

    fn new_state(&self) -> MultiTriangulationState {
        let mut state = self.base_state();
        self.move_to(&mut state, self.step_count());
        state
    }

    /// Fragments that are inserted, whichever they are.
    fn split_count(&self, state: &MultiTriangulationState) -> usize {
        state.split_count()
    }

    fn move_to(&self, state: &mut MultiTriangulationState, split_count: usize) {
        assert!(split_count <= self.step_count(), "split count {split_count} of {}", self.step_count());
        state.check(self);
        state.apply(self, &state.level_change(split_count));
    }

    fn topology(&self) -> Topology {
        Topology::Triangles
    }

    fn draw_counts(&self, state: &MultiTriangulationState) -> DrawCounts {
        DrawCounts { strip_count: 0, index_count: 3 * state.triangles().len() }
    }

    fn indices_into(&self, state: &MultiTriangulationState, out: &mut Vec<u32>) {
        (0..self.group_count).for_each(|group| self.group_indices_into(state, group, out));
    }

    fn bytes(&self) -> Vec<PartBytes> {
        let part = |name, bytes| PartBytes { name, bytes };
        vec![
            part("triangles", size_of_val(&self.triangles[..])),
            part("ceilings", self.ceilings.bytes()),
            part("floors", self.floors.bytes() + 4 * self.floorless.len()),
            part("errors", 4 * self.errors.len()),
            part("vertices", 4 * self.vertices.word_count()),
            part("groups", 4 * self.groups.len()),
        ]
    }

    fn state_bytes(&self, state: &MultiTriangulationState) -> usize {
        state.bytes()
    }
}

impl PaperBytes for MultiTriangulation {
    /// The structures of \[KK97\] as \[KG98\] counts them, 32 bits for each vertex and pointer: a triangle has three vertices and
    /// two fragments, a fragment a number for each triangle of its ceiling and its floor. A vertex that goes with six
    /// triangles leaves four: 6 * 20 + 10 * 4 = 160 bytes. Errors and the lengths of lists are not counted.
    fn paper_bytes(&self, accounting: Accounting) -> usize {
        let listed = self.ceilings.entries.len() + self.floors.entries.len();
        accounting.bytes(0, 5 * self.triangles.len() + listed)
    }
}

impl StoredModel for MultiTriangulation {
    fn step_vertices(&self) -> &StepVertices<'_> {
        &self.vertices
    }

    fn group_count(&self) -> usize {
        self.group_count
    }

    fn group_triangles_into(&self, state: &MultiTriangulationState, group: usize, out: &mut Vec<[u32; 3]>) {
        let mut indices = Vec::new();
        self.group_indices_into(state, group, &mut indices);
        out.extend_from_slice(indices.as_chunks().0);
    }
}
