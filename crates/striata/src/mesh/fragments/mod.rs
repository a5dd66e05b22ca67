//! Refinement sequences whose steps replace a few triangles by others, however those were made.
//!
//! Multi-Triangulations \[Pup96\] and patterns \[KG98\] are built from such sequences. Each step removes
//! one position. The triangles around it are the step's **ceiling**; the triangles that fill the hole are
//! its **floor**. A collapse is one way to fill the hole, but any other triangulation works as well, so a
//! [`CollapseSequence`](super::CollapseSequence) is a special case. Vertex order and levels are the same:
//! vertices are in refinement order, and level `s` contains the base mesh and what the first `s` steps
//! restore.
//!
//! Each triangle that appears in any level is a **face**, identified by its index: first the faces of the
//! base mesh, then those of the ceilings by step. A face belongs to the base mesh or is created by one
//! step; it is removed by at most one step, whose floor contains it. The youngest corner of a face is a
//! vertex that its step restores, so the corners of a face determine the step that creates it.

mod from_collapses;
mod replay_fragments;

pub use replay_fragments::{fragment_faces, replay_fragments};

use super::sequence_error::check_length;
use super::{IndexedMesh, LevelTable, PositionIndex, SequenceError, canonical_triangle};

/// A triangle that appears in some levels.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Face {
    /// Vertices, in counterclockwise order.
    pub corners: [u32; 3],
    /// Index of the triangle group; 0 in a mesh without groups.
    pub group: u32,
}

impl Face {
    /// Rotates the corners so that the smallest one comes first, which makes equal faces compare equal.
    fn canonical(self) -> Self {
        Self { corners: canonical_triangle(self.corners), ..self }
    }
}

/// Why the parts of a fragment sequence are inconsistent.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum FragmentError {
    /// Lengths or errors are inconsistent.
    #[error(transparent)]
    Sequence(#[from] SequenceError),
    /// A face of a ceiling or of the base mesh has corners that are not allowed there.
    #[error(
        "step {step:?} (none: the base) creates the triangle {corners:?}, whose youngest corner belongs to \
         another step"
    )]
    Ceiling {
        /// The step; `None` for the base mesh.
        step: Option<u32>,
        /// Corners of the face.
        corners: [u32; 3],
    },
    /// Two corners of a face of a ceiling or of the base mesh are the same vertex.
    #[error("step {step:?} (none: the base) creates the triangle {corners:?}, which has a repeated corner")]
    Degenerate {
        /// The step; `None` for the base mesh.
        step: Option<u32>,
        /// Corners of the face.
        corners: [u32; 3],
    },
    /// A face of a floor does not exist when its step is applied.
    #[error("step {step} replaces the triangle {corners:?}, which does not exist at that point")]
    Floor {
        /// The step.
        step: u32,
        /// Corners of the face.
        corners: [u32; 3],
    },
}

/// The triangles that one step exchanges.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Fragment {
    /// Triangles around the position that the step restores.
    pub ceiling: Vec<Face>,
    /// Triangles that fill the hole without that position.
    pub floor: Vec<Face>,
    /// Maximum distance between the floor and the original surface that it represents, in mesh units.
    pub error: f32,
}

/// Fragments in refinement order, with an index for every face.
#[derive(Clone, Debug, PartialEq)]
pub struct FragmentSequence {
    levels: LevelTable,
    /// Faces of the base mesh, then those of the ceilings.
    faces: Vec<Face>,
    /// Index of the first face of each step's ceiling, followed by the number of faces.
    first_ceiling: Vec<u32>,
    /// Indices of the faces of all floors.
    floors: Vec<u32>,
    /// Start of each step's floor in `floors`, followed by the length of `floors`.
    first_floor: Vec<u32>,
    floor_errors: Vec<f32>,
}

impl FragmentSequence {
    /// Assigns indices to the faces of fragments in refinement order and resolves the faces of their floors.
    ///
    /// # Errors
    /// [`FragmentError`] for the first step that is inconsistent.
    pub fn from_fragments(
        positions: PositionIndex,
        base: Vec<Face>,
        fragments: impl ExactSizeIterator<Item = Fragment>,
    ) -> Result<Self, FragmentError> {
        let step_count = fragments.len();
        let Some(base_position_count) = positions.position_count().checked_sub(step_count) else {
            let (found, expected) = (step_count, positions.position_count());
            return Err(SequenceError::Length { what: "fragments", found, expected }.into());
        };
        let mut resolver = FaceResolver::new(&positions, base, base_position_count)?;
        for (step, fragment) in fragments.enumerate() {
            resolver.push(step as u32, &fragment)?;
        }
        let FaceResolver { faces, first_ceiling, floors, first_floor, triangle_counts, floor_errors, .. } =
            resolver;
        let mut errors = floor_errors.clone();
        for step in (1..errors.len()).rev() {
            errors[step - 1] = errors[step - 1].max(errors[step]);
        }
        let levels = LevelTable::new(positions, base_position_count, triangle_counts, errors)?;
        Ok(Self { levels, faces, first_ceiling, floors, first_floor, floor_errors })
    }

    /// Sizes and errors of the levels; the error of a level is the largest floor error of the steps that
    /// are not applied.
    pub fn levels(&self) -> &LevelTable {
        &self.levels
    }

    /// Number of steps from the base mesh to the full mesh.
    pub fn step_count(&self) -> usize {
        self.levels.step_count()
    }

    /// All faces: those of the base mesh, then those of the ceilings by step.
    pub fn faces(&self) -> &[Face] {
        &self.faces
    }

    /// Number of faces of the base mesh; they come first.
    pub fn base_face_count(&self) -> usize {
        self.first_ceiling[0] as usize
    }

    /// Indices of the faces that a step creates.
    ///
    /// # Panics
    /// If the step does not exist.
    #[inline]
    pub fn ceiling(&self, step: u32) -> std::ops::Range<u32> {
        self.first_ceiling[step as usize]..self.first_ceiling[step as usize + 1]
    }

    /// Indices of the faces that a step replaces.
    ///
    /// # Panics
    /// If the step does not exist.
    #[inline]
    pub fn floor(&self, step: u32) -> &[u32] {
        &self.floors[self.first_floor[step as usize] as usize..self.first_floor[step as usize + 1] as usize]
    }

    /// Maximum distance between the floor of a step and the original surface that it represents, in mesh
    /// units.
    ///
    /// # Panics
    /// If the step does not exist.
    pub fn floor_error(&self, step: u32) -> f32 {
        self.floor_errors[step as usize]
    }

    /// Returns a copy of the sequence with other floor errors.
    ///
    /// # Errors
    /// [`SequenceError`] if the number of errors is not the step count, or if an error is not finite or is
    /// negative.
    pub fn with_floor_errors(&self, floor_errors: Vec<f32>) -> Result<Self, SequenceError> {
        check_length("errors", floor_errors.len(), self.step_count())?;
        let mut errors = floor_errors.clone();
        for step in (1..errors.len()).rev() {
            errors[step - 1] = errors[step - 1].max(errors[step]);
        }
        let counts = (0..=self.step_count()).map(|s| self.levels.triangle_count_at(s) as u32).collect();
        let (positions, base) = (self.levels.positions().clone(), self.levels.base_position_count());
        Ok(Self { levels: LevelTable::new(positions, base, counts, errors)?, floor_errors, ..self.clone() })
    }

    /// The step that creates a face; `None` for a face of the base mesh.
    #[inline]
    pub fn creating_step(&self, face: u32) -> Option<u32> {
        let [a, b, c] = self.faces[face as usize].corners;
        self.levels.step_of(a.max(b).max(c))
    }

    /// The step that replaces each face; [`NO_STEP`](Self::NO_STEP) for faces of the full mesh.
    pub fn replacing_steps(&self) -> Vec<u32> {
        let mut out = vec![Self::NO_STEP; self.faces.len()];
        for step in 0..self.step_count() as u32 {
            for &face in self.floor(step) {
                out[face as usize] = step;
            }
        }
        out
    }

    /// Marks the absence of a step.
    pub const NO_STEP: u32 = u32::MAX;
}

/// A mesh in refinement order with its fragments, from which every level, uniform or not, can be derived.
#[derive(Clone, Debug, PartialEq)]
pub struct FragmentedMesh {
    /// The full mesh: vertices in refinement order, no unused vertices, no degenerate triangles.
    pub mesh: IndexedMesh,
    /// How the mesh is simplified.
    pub fragments: FragmentSequence,
}

/// Assigns indices to faces step by step, coarse to fine, and resolves the faces of the floors.
struct FaceResolver<'a> {
    positions: &'a PositionIndex,
    base_position_count: u32,
    faces: Vec<Face>,
    /// Face indices: the base mesh and each ceiling form a run that is sorted by the faces' corners and
    /// group.
    sorted: Vec<u32>,
    /// Number of faces already replaced among equal ones, stored at the first of them in `sorted`.
    replaced_counts: Vec<u32>,
    first_ceiling: Vec<u32>,
    floors: Vec<u32>,
    first_floor: Vec<u32>,
    triangle_counts: Vec<u32>,
    floor_errors: Vec<f32>,
}

impl<'a> FaceResolver<'a> {
    fn new(positions: &'a PositionIndex, base: Vec<Face>, base_count: usize) -> Result<Self, FragmentError> {
        let limit = positions.first_vertices()[base_count];
        if let Some(face) = base.iter().find(|face| face.corners.iter().any(|&v| v >= limit)) {
            return Err(FragmentError::Ceiling { step: None, corners: face.corners });
        }
        let mut resolver = Self {
            positions,
            base_position_count: base_count as u32,
            faces: Vec::new(),
            sorted: Vec::new(),
            replaced_counts: Vec::new(),
            first_ceiling: vec![base.len() as u32],
            triangle_counts: vec![base.len() as u32],
            floors: Vec::new(),
            first_floor: vec![0],
            floor_errors: Vec::new(),
        };
        resolver.add(None, &base)?;
        Ok(resolver)
    }

    /// Adds the faces of the base mesh or of a ceiling.
    fn add(&mut self, step: Option<u32>, faces: &[Face]) -> Result<(), FragmentError> {
        let has_repeated_corner = |&[a, b, c]: &[u32; 3]| a == b || b == c || c == a;
        if let Some(corners) = faces.iter().map(|face| face.corners).find(has_repeated_corner) {
            return Err(FragmentError::Degenerate { step, corners });
        }
        let first = self.faces.len();
        self.faces.extend_from_slice(faces);
        self.sorted.extend(first as u32..self.faces.len() as u32);
        self.sorted[first..].sort_unstable_by_key(|&face| (self.faces[face as usize].canonical(), face));
        self.replaced_counts.resize(self.faces.len(), 0);
        Ok(())
    }

    fn push(&mut self, step: u32, fragment: &Fragment) -> Result<(), FragmentError> {
        let own = self.positions.wedges(self.base_position_count + step);
        for face in &fragment.ceiling {
            let [a, b, c] = face.corners;
            if !own.contains(&a.max(b).max(c)) {
                return Err(FragmentError::Ceiling { step: Some(step), corners: face.corners });
            }
        }
        for &face in &fragment.floor {
            let found = self.replace_face(step, face);
            let not_found = FragmentError::Floor { step, corners: face.corners };
            self.floors.push(found.ok_or(not_found)?);
        }
        self.first_floor.push(self.floors.len() as u32);
        self.add(Some(step), &fragment.ceiling)?;
        self.first_ceiling.push(self.faces.len() as u32);
        let count = self.triangle_counts[step as usize] + fragment.ceiling.len() as u32;
        self.triangle_counts.push(count - fragment.floor.len() as u32);
        self.floor_errors.push(fragment.error);
        Ok(())
    }

    /// Finds the first remaining face with these corners, from an earlier step or the base mesh, and marks
    /// it as replaced.
    fn replace_face(&mut self, step: u32, face: Face) -> Option<u32> {
        let [a, b, c] = face.corners;
        let youngest = a.max(b).max(c);
        if youngest as usize >= self.positions.vertex_count() {
            return None;
        }
        let created = match self.positions.position_of(youngest).checked_sub(self.base_position_count) {
            None => 0..self.first_ceiling[0],
            Some(creator) if creator < step => {
                self.first_ceiling[creator as usize]..self.first_ceiling[creator as usize + 1]
            }
            Some(_) => return None,
        };
        let (first, end) = (created.start as usize, created.end as usize);
        let (canonical, faces) = (face.canonical(), &self.faces);
        let candidates = &self.sorted[first..end];
        let at = candidates.partition_point(|&other| faces[other as usize].canonical() < canonical);
        let replaced = self.replaced_counts[first..end].get_mut(at)?;
        let found = *candidates.get(at + *replaced as usize)?;
        if faces[found as usize].canonical() != canonical {
            return None;
        }
        *replaced += 1;
        Some(found)
    }
}
