//! Steps that replace a few triangles by fewer, whatever made them: the sequence that fragments of a
//! Multi-Triangulation \[Pup96\] and patterns \[KG98\] are built from.
//!
//! Each step removes one position. The triangles around it are the step's **ceiling**; what fills the hole is its
//! **floor**. A collapse is one way to fill a hole, any other triangulation will do as well, so a
//! [`CollapseSequence`](super::CollapseSequence) is a special case. Numbering and levels are the same: vertices in refinement
//! order, level `s` shows the base and what the first `s` steps restore.
//!
//! Each triangle that any level shows is a **face** with a number of its own: the base's first, then the ceilings' by step. A
//! face is made by one step (or is of the base) and leaves by at most one, whose floor names it. As the youngest of its corners is
//! what its step restores, the corners of a face tell which step makes it.

mod from_collapses;
mod replay;

pub use replay::{fragment_faces, replay_fragments};

use super::sequence_error::check_length;
use super::{IndexedMesh, Levels, PositionIndex, SequenceError, canonical_triangle};

/// A triangle that some levels show.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Face {
    /// Its vertices, counterclockwise.
    pub corners: [u32; 3],
    /// The group of triangles that it belongs to; 0 in a mesh without groups.
    pub group: u32,
}

impl Face {
    /// Turned so that the smallest corner comes first: equal faces are then equal.
    fn canonical(self) -> Self {
        Self { corners: canonical_triangle(self.corners), ..self }
    }
}

/// What makes the parts of a fragment sequence inconsistent.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum FragmentError {
    /// Lengths or errors do not fit.
    #[error(transparent)]
    Sequence(#[from] SequenceError),
    /// A face of a ceiling or of the base has corners that it cannot have.
    #[error(
        "step {step:?} (none: the base) makes the triangle {corners:?}, whose youngest corner is not its own"
    )]
    Ceiling {
        /// The step; none for the base.
        step: Option<u32>,
        /// The face's corners.
        corners: [u32; 3],
    },
    /// A face of a ceiling or of the base has a corner twice.
    #[error("step {step:?} (none: the base) makes the triangle {corners:?}, which has a corner twice")]
    Degenerate {
        /// The step; none for the base.
        step: Option<u32>,
        /// The face's corners.
        corners: [u32; 3],
    },
    /// A face of a floor is not there when its step is taken.
    #[error("step {step} replaces the triangle {corners:?}, which is not there")]
    Floor {
        /// The step.
        step: u32,
        /// The face's corners.
        corners: [u32; 3],
    },
}

/// What one step replaces; see the module.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Fragment {
    /// Triangles around the position that the step restores.
    pub ceiling: Vec<Face>,
    /// Triangles that fill the hole without it.
    pub floor: Vec<Face>,
    /// How far the surface that the floor's triangles stand for may be from them, mesh units.
    pub error: f32,
}

/// Fragments in refinement order, with all faces numbered.
#[derive(Clone, Debug, PartialEq)]
pub struct FragmentSequence {
    levels: Levels,
    /// The base's, then the ceilings'.
    faces: Vec<Face>,
    /// First face of each step's ceiling, closed by the number of faces.
    first_ceiling: Vec<u32>,
    /// Faces of the floors.
    floors: Vec<u32>,
    /// First entry of each step's floor, closed by their number.
    first_floor: Vec<u32>,
    floor_errors: Vec<f32>,
}

impl FragmentSequence {
    /// Numbers the faces of fragments in refinement order and checks that each floor finds its faces.
    ///
    /// # Errors
    /// [`FragmentError`] naming the first step that does not fit.
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
        let mut builder = Builder::new(&positions, base, base_position_count)?;
        for (step, fragment) in fragments.enumerate() {
            builder.push(step as u32, &fragment)?;
        }
        let Builder { faces, first_ceiling, floors, first_floor, triangle_counts, floor_errors, .. } =
            builder;
        let mut errors = floor_errors.clone();
        for step in (1..errors.len()).rev() {
            errors[step - 1] = errors[step - 1].max(errors[step]);
        }
        let levels = Levels::new(positions, base_position_count, triangle_counts, errors)?;
        Ok(Self { levels, faces, first_ceiling, floors, first_floor, floor_errors })
    }

    /// How large each level is, and how far off: the error of a level is the largest of the steps that it lacks.
    pub fn levels(&self) -> &Levels {
        &self.levels
    }

    /// Steps from the base mesh to the full mesh.
    pub fn step_count(&self) -> usize {
        self.levels.step_count()
    }

    /// All faces: the base's, then the ceilings' by step.
    pub fn faces(&self) -> &[Face] {
        &self.faces
    }

    /// Faces of the base: the first so many.
    pub fn base_face_count(&self) -> usize {
        self.first_ceiling[0] as usize
    }

    /// Numbers of the faces that a step makes.
    ///
    /// # Panics
    /// If there is no such step.
    #[inline]
    pub fn ceiling(&self, step: u32) -> std::ops::Range<u32> {
        self.first_ceiling[step as usize]..self.first_ceiling[step as usize + 1]
    }

    /// Numbers of the faces that a step replaces.
    ///
    /// # Panics
    /// If there is no such step.
    #[inline]
    pub fn floor(&self, step: u32) -> &[u32] {
        &self.floors[self.first_floor[step as usize] as usize..self.first_floor[step as usize + 1] as usize]
    }

    /// How far the surface that a step's floor stands for may be from it, mesh units.
    ///
    /// # Panics
    /// If there is no such step.
    pub fn floor_error(&self, step: u32) -> f32 {
        self.floor_errors[step as usize]
    }

    /// The same steps with other errors of their floors.
    ///
    /// # Errors
    /// [`SequenceError`] where there are more or fewer, or one is no number or negative.
    pub fn with_floor_errors(&self, floor_errors: Vec<f32>) -> Result<Self, SequenceError> {
        check_length("errors", floor_errors.len(), self.step_count())?;
        let mut errors = floor_errors.clone();
        for step in (1..errors.len()).rev() {
            errors[step - 1] = errors[step - 1].max(errors[step]);
        }
        let counts = (0..=self.step_count()).map(|s| self.levels.triangle_count_at(s) as u32).collect();
        let (positions, base) = (self.levels.positions().clone(), self.levels.base_position_count());
        Ok(Self { levels: Levels::new(positions, base, counts, errors)?, floor_errors, ..self.clone() })
    }

    /// The step that makes a face; none for one of the base.
    #[inline]
    pub fn maker(&self, face: u32) -> Option<u32> {
        let [a, b, c] = self.faces[face as usize].corners;
        self.levels.step_of(a.max(b).max(c))
    }

    /// For each face the step that replaces it; [`NO_STEP`](Self::NO_STEP) where the full mesh shows it.
    pub fn replaced_by(&self) -> Vec<u32> {
        let mut out = vec![Self::NO_STEP; self.faces.len()];
        for step in 0..self.step_count() as u32 {
            for &face in self.floor(step) {
                out[face as usize] = step;
            }
        }
        out
    }

    /// Stands for no step.
    pub const NO_STEP: u32 = u32::MAX;
}

/// A mesh in refinement order with fragments: all levels of detail at once, uniform or not.
#[derive(Clone, Debug, PartialEq)]
pub struct FragmentedMesh {
    /// The full mesh, vertices in refinement order, no unused vertices, no degenerate triangles.
    pub mesh: IndexedMesh,
    /// How it is simplified.
    pub fragments: FragmentSequence,
}

/// Numbers faces step by step, coarse to fine, and finds those of the floors.
struct Builder<'a> {
    positions: &'a PositionIndex,
    base_position_count: u32,
    faces: Vec<Face>,
    /// Numbers of faces, those of the base and those of each ceiling sorted by what they are.
    sorted: Vec<u32>,
    /// Faces that are replaced, at the first among `sorted` of those that are equal.
    replaced_counts: Vec<u32>,
    first_ceiling: Vec<u32>,
    floors: Vec<u32>,
    first_floor: Vec<u32>,
    triangle_counts: Vec<u32>,
    floor_errors: Vec<f32>,
}

impl<'a> Builder<'a> {
    fn new(positions: &'a PositionIndex, base: Vec<Face>, base_count: usize) -> Result<Self, FragmentError> {
        let limit = positions.first_vertices()[base_count];
        if let Some(face) = base.iter().find(|face| face.corners.iter().any(|&v| v >= limit)) {
            return Err(FragmentError::Ceiling { step: None, corners: face.corners });
        }
        let mut builder = Self {
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
        builder.add(None, &base)?;
        Ok(builder)
    }

    /// Numbers the faces of the base or of a ceiling.
    fn add(&mut self, step: Option<u32>, faces: &[Face]) -> Result<(), FragmentError> {
        let has_equal = |&[a, b, c]: &[u32; 3]| a == b || b == c || c == a;
        if let Some(corners) = faces.iter().map(|face| face.corners).find(has_equal) {
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
            let found = self.take(step, face);
            let missing = FragmentError::Floor { step, corners: face.corners };
            self.floors.push(found.ok_or(missing)?);
        }
        self.first_floor.push(self.floors.len() as u32);
        self.add(Some(step), &fragment.ceiling)?;
        self.first_ceiling.push(self.faces.len() as u32);
        let count = self.triangle_counts[step as usize] + fragment.ceiling.len() as u32;
        self.triangle_counts.push(count - fragment.floor.len() as u32);
        self.floor_errors.push(fragment.error);
        Ok(())
    }

    /// The first face of an earlier step, or of the base, with these corners that is still there; replaces it.
    fn take(&mut self, step: u32, face: Face) -> Option<u32> {
        let [a, b, c] = face.corners;
        let youngest = a.max(b).max(c);
        if youngest as usize >= self.positions.vertex_count() {
            return None;
        }
        let made = match self.positions.position_of(youngest).checked_sub(self.base_position_count) {
            None => 0..self.first_ceiling[0],
            Some(maker) if maker < step => {
                self.first_ceiling[maker as usize]..self.first_ceiling[maker as usize + 1]
            }
            Some(_) => return None,
        };
        let (first, end) = (made.start as usize, made.end as usize);
        let (wanted, faces) = (face.canonical(), &self.faces);
        let made = &self.sorted[first..end];
        let at = made.partition_point(|&other| faces[other as usize].canonical() < wanted);
        let replaced = self.replaced_counts[first..end].get_mut(at)?;
        let found = *made.get(at + *replaced as usize)?;
        if faces[found as usize].canonical() != wanted {
            return None;
        }
        *replaced += 1;
        Some(found)
    }
}
