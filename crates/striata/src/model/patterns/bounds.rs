//! Where each fragment is, how its triangles are turned, and how far off its floor is: eight bytes each.
//!
//! Fragments are nested along a tree: above each (coarser) is the oldest of those that make its floor. A fragment's bounds hold
//! what it changes and the bounds of all below it in the tree, so that a fragment which is wanted is reached over others that
//! are: the one above it weighs no less. The error is that of the fragment's own floor, or of one below where that is
//! larger: what a certified sequence says of a floor holds wherever the floor is shown.

use super::Patterns;
use crate::mesh::FragmentedMesh;
use crate::model::ModelError;
use crate::model::part_record::{Bounded, NO_STEP, PartRecord, bound};
use crate::view::Part;

/// For each fragment a sphere and a cone of normals that hold whatever it and those below it in the tree change, and the error that
/// is there while it is left out.
#[derive(Clone, Debug, PartialEq)]
pub struct PatternBounds {
    records: Vec<PartRecord>,
}

impl PatternBounds {
    /// The bounds of a mesh's fragments.
    pub fn build(mesh: &FragmentedMesh) -> Self {
        Self { records: bound(&mut FragmentSteps { mesh }) }
    }

    /// What a fragment is to a criterion, given the positions of the mesh's vertices.
    ///
    /// # Panics
    /// If there is no such fragment or position.
    #[inline]
    pub fn part(&self, patterns: &Patterns, positions: &[[f32; 3]], step: u32) -> Part {
        self.records[step as usize].part(positions[patterns.vertices.of_step(step as usize).start as usize])
    }

    /// Fragments that there are bounds of.
    pub(crate) fn step_count(&self) -> usize {
        self.records.len()
    }

    /// The records as files hold them.
    pub(crate) fn as_bytes(&self) -> &[u8] {
        bytemuck::must_cast_slice(&self.records)
    }

    /// From the bytes of the records of so many fragments.
    ///
    /// # Errors
    /// Where there are more or fewer records, or one holds what no bounds are.
    pub(crate) fn from_bytes(bytes: &[u8], step_count: usize) -> Result<Self, ModelError> {
        let records = PartRecord::read_all(bytes, step_count)?;
        for (step, record) in records.iter().enumerate() {
            record.check_shape().map_err(|reason| ModelError::Step { step, reason })?;
        }
        Ok(Self { records })
    }

    /// Bytes of the records.
    pub fn bytes(&self) -> usize {
        size_of_val(&self.records[..])
    }
}

/// Patterns with their bounds and the positions that they are around: what is needed to ask a criterion of a fragment.
#[derive(Clone, Copy, Debug)]
pub struct PatternScene<'a> {
    patterns: &'a Patterns,
    bounds: &'a PatternBounds,
    positions: &'a [[f32; 3]],
}

impl<'a> PatternScene<'a> {
    /// Puts the three together.
    ///
    /// # Panics
    /// If they are not of one mesh, by their counts.
    pub fn new(patterns: &'a Patterns, bounds: &'a PatternBounds, positions: &'a [[f32; 3]]) -> Self {
        assert_eq!(bounds.step_count(), patterns.fragment_count(), "the bounds are of another mesh");
        assert_eq!(positions.len(), patterns.vertices.vertex_count, "the positions are of another mesh");
        Self { patterns, bounds, positions }
    }

    /// The patterns.
    pub fn patterns(&self) -> &'a Patterns {
        self.patterns
    }

    /// What a fragment is to a criterion.
    ///
    /// # Panics
    /// If there is no such fragment.
    #[inline]
    pub fn part(&self, step: u32) -> Part {
        self.bounds.part(self.patterns, self.positions, step)
    }
}

/// The fragments of a mesh as what is bounded.
struct FragmentSteps<'a> {
    mesh: &'a FragmentedMesh,
}

impl FragmentSteps<'_> {
    fn corners(&self, face: u32) -> [[f32; 3]; 3] {
        self.mesh.fragments.faces()[face as usize].corners.map(|v| self.mesh.mesh.positions[v as usize])
    }
}

impl Bounded for FragmentSteps<'_> {
    fn parents(&self) -> Vec<u32> {
        let fragments = &self.mesh.fragments;
        let oldest_maker = |step| {
            let makers = fragments.floor(step).iter().map(|&face| fragments.maker(face));
            makers.min().flatten().unwrap_or(NO_STEP)
        };
        (0..fragments.step_count() as u32).map(oldest_maker).collect()
    }

    fn center(&self, step: u32) -> [f32; 3] {
        let vertices = self.mesh.fragments.levels().step_vertices(step as usize);
        self.mesh.mesh.positions[vertices.start as usize]
    }

    fn changed_into(&mut self, step: u32, out: &mut Vec<[[f32; 3]; 3]>) {
        let fragments = &self.mesh.fragments;
        out.extend(fragments.ceiling(step).map(|face| self.corners(face)));
        out.extend(fragments.floor(step).iter().map(|&face| self.corners(face)));
    }

    fn error(&self, step: u32) -> f32 {
        self.mesh.fragments.floor_error(step)
    }
}
