//! Where each fragment is, how its triangles are turned, and how far off its floor is: eight bytes each.
//!
//! Fragments are nested along a tree: above each (coarser) is the oldest of those that make its floor. A fragment's bounds hold
//! what it changes and the bounds of all below it in the tree, so that a fragment which is wanted is reached over others that
//! are: the one above it weighs no less. The error is that of the fragment's own floor, or of one below where that is
//! larger: what a certified sequence says of a floor holds wherever the floor is shown.

use crate::mesh::FragmentedMesh;
use crate::model::part_record::{Bounded, NO_STEP};
use crate::model::step_bounds::StepBounds;

impl StepBounds {
    /// The bounds of a mesh's fragments.
    pub(super) fn of_fragments(mesh: &FragmentedMesh) -> Self {
        Self::build(&mut FragmentSteps { mesh })
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
