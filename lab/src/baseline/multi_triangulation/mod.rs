//! The explicit Multi-Triangulation \[Pup96\], \[KK97\]: lists of triangles and fragments that refer to
//! each other.
//!
//! Every triangle of every level is stored once, with its vertices and two fragments: the **lower** one,
//! whose ceiling contains it, and the **upper** one, whose floor contains it. Every fragment lists the
//! triangles of its ceiling and of its floor. A fragment's prerequisites and dependents are therefore one
//! lookup away, and any set of fragments is valid that also contains the lower fragments of each member's
//! floor.
//!
//! ```text
//!     ceiling  \ | /      6 triangles created by the fragment; each refers to its upper fragment, if any
//!     --------- (v)       fragment: ceiling, floor, error
//!     floor    | / |      4 triangles that it replaces; each refers to its lower one, unless in the base
//! ```
//!
//! The model never walks from a triangle to its neighbors, so it works for any mesh: borders, seams,
//! groups, non-manifold vertices and edges.
//!
//! Differs: a fragment without a floor (a triangle attached by one edge only, a vertex without triangles)
//! depends on nothing and replaces no triangle that would show that the fragment is missing; the condition
//! is evaluated for it separately. In addition to the two steps of \[KG98\] section 3.4,
//! [`coarsen`](MultiTriangulation::coarsen) and [`refine`](MultiTriangulation::refine), there is
//! [`adapt`](MultiTriangulation::adapt). It also finds the smallest set for conditions that may require a
//! fine triangle although the coarse one below it is accurate enough.
//!
//! Cost: 160 bytes per vertex if each vertex has six triangles when it is removed: 120 for the triangles,
//! of which there are three times as many as in the full mesh, and 40 for their indices in the lists.
//! Quadrics prefer to remove vertices with fewer triangles: 134 to 142 bytes as the paper counts, 146 to
//! 154 with list lengths and errors. Selective refinement evaluates the condition for each triangle shown,
//! and pays for the change itself.

mod refine;
mod state;

pub use self::refine::MtQuery;
pub use self::state::MultiTriangulationState;
use striata::mesh::{Face, Fragment, FragmentSequence, FragmentedMesh};
use striata::model::{
    DrawCounts, LodModel, ModelError, PartBytes, Patterns, StepVertices, StoredModel, Topology,
};

use crate::paper_bytes::{Accounting, PaperBytes};

/// A triangle that some level shows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct MtTriangle {
    /// Its vertices, counterclockwise.
    pub corners: [u32; 3],
    /// The fragment that creates it; [`FragmentSequence::NO_STEP`] if it is in the base.
    pub lower: u32,
    /// The fragment that replaces it; [`FragmentSequence::NO_STEP`] if it is in the full mesh.
    pub upper: u32,
}

/// The static half of the model; see the [module](self).
#[derive(Clone, Debug, PartialEq)]
pub struct MultiTriangulation {
    vertices: StepVertices<'static>,
    /// All triangles, those of the base first.
    triangles: Vec<MtTriangle>,
    base_triangle_count: usize,
    ceilings: Lists,
    floors: Lists,
    /// Error of each fragment's floor, in mesh units.
    errors: Vec<f32>,
    /// Fragments without a floor, ascending.
    floorless: Vec<u32>,
    group_count: usize,
    /// The group of each triangle; empty if there is only one group.
    groups: Vec<u32>,
}

/// A list of triangles for each fragment.
#[derive(Clone, Debug, PartialEq, Eq)]
struct Lists {
    /// First entry of each list, followed by their number.
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
    /// Builds the lists of all triangles and fragments.
    ///
    /// # Panics
    /// If the mesh lacks the group of a triangle of the sequence.
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
        assert!(groups().all(|group| (group as usize) < group_count), "a face belongs to a missing group");
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

    /// All triangles: those of the base, then those of the ceilings by step.
    pub fn triangles(&self) -> &[MtTriangle] {
        &self.triangles
    }

    /// Number of triangles in the base; they come first.
    pub fn base_triangle_count(&self) -> usize {
        self.base_triangle_count
    }

    /// Indices of the triangles that a fragment creates.
    ///
    /// # Panics
    /// If the fragment does not exist.
    #[inline]
    pub fn ceiling(&self, step: u32) -> &[u32] {
        self.ceilings.get(step)
    }

    /// Indices of the triangles that a fragment replaces.
    ///
    /// # Panics
    /// If the fragment does not exist.
    #[inline]
    pub fn floor(&self, step: u32) -> &[u32] {
        self.floors.get(step)
    }

    /// Distance of a fragment's floor from the surface that it approximates, in mesh units.
    ///
    /// # Panics
    /// If the fragment does not exist.
    pub fn error(&self, step: u32) -> f32 {
        self.errors[step as usize]
    }

    /// Number of vertices in the base mesh.
    pub fn base_vertex_count(&self) -> usize {
        self.vertices.base_vertex_count() as usize
    }

    /// Converts the model to patterns.
    ///
    /// # Errors
    /// See [`Patterns::build`].
    pub fn to_patterns(&self) -> Result<Patterns, ModelError> {
        Patterns::from_fragments(&self.to_fragments(), self.group_count)
    }

    /// Reconstructs the fragments from the triangles.
    pub fn to_fragments(&self) -> FragmentSequence {
        let face = |&index: &u32| Face {
            corners: self.triangles[index as usize].corners,
            group: self.groups.get(index as usize).map_or(0, |&group| group),
        };
        let faces = |indices: &[u32]| indices.iter().map(face).collect();
        let fragment = |step| Fragment {
            ceiling: faces(self.ceiling(step)),
            floor: faces(self.floor(step)),
            error: self.error(step),
        };
        let base = (0..self.base_triangle_count as u32).map(|index| face(&index)).collect();
        let fragments = (0..self.errors.len() as u32).map(fragment);
        FragmentSequence::from_fragments(self.vertices.positions(), base, fragments)
            .expect("the triangles were built from fragments")
    }

    /// Creates an instance that shows the base.
    pub fn base_state(&self) -> MultiTriangulationState {
        MultiTriangulationState::base(self)
    }

    fn group_indices_into(&self, state: &MultiTriangulationState, group: usize, out: &mut Vec<u32>) {
        assert!(group < self.group_count, "group {group} of {}", self.group_count);
        if self.groups.is_empty() {
            out.extend_from_slice(state.triangles().as_flattened());
            return;
        }
        for (index, corners) in state.indexed() {
            if self.groups[index as usize] as usize == group {
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

    /// Number of fragments inserted, in whatever combination.
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
    /// The structures of \[KK97\] as \[KG98\] counts them, 32 bits per vertex and pointer: a triangle has
    /// three vertices and two fragments; a fragment has an index per triangle of its ceiling and floor. A
    /// vertex that is removed with six triangles leaves four: 6 * 20 + 10 * 4 = 160 bytes. Errors and list
    /// lengths are not counted.
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
