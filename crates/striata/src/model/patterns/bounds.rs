//! Bounds of each fragment: a sphere, a normal cone and the error of its floor, in eight bytes.
//!
//! Fragments are nested along a tree: the parent of a fragment is the oldest of those that create its
//! floor. The bounds of a fragment enclose what it changes and the bounds of its descendants. Its parent
//! never weighs less, so a wanted fragment is always reached through wanted ones. The error is that of the
//! fragment's own floor or of a descendant's, whichever is larger; the certified error of a floor is valid
//! wherever the floor is shown.

use crate::ignore_progress;
use crate::mesh::FragmentedMesh;
use crate::model::part_record::{Bounded, NO_STEP};
use crate::model::step_bounds::StepBounds;

impl StepBounds {
    /// Computes the bounds of a mesh's fragments.
    pub(super) fn of_fragments(mesh: &FragmentedMesh) -> Self {
        Self::build(&mut FragmentSteps { mesh }, &mut ignore_progress)
            .expect("the default callback never cancels")
    }
}

/// Adapter that provides the fragments of a mesh for bounding.
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
            let makers = fragments.floor(step).iter().map(|&face| fragments.creating_step(face));
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
