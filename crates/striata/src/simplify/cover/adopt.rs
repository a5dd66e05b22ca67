//! Who answers for what vanishes: a step whose floor is empty has no triangle to give its pieces to.
//!
//! An ear (a triangle that hangs on by one side) or an island goes, and nothing comes. A triangle `g` nearby takes its pieces. In the
//! levels that the steps lead through that is all. But a state that lacks the step may still show more than `g`: those who would
//! answer for the pieces are not there yet. Then what `g` answers for, orphans like these apart, is served by triangles from before
//! `g`, none farther off than the largest bound by now, and each piece is within some *reach* of a part of it: the sum of both holds.
//!
//! ```text
//!    \   /g\          The step removes v with the ear (u, v, w), and g takes its pieces. It is sure to be there, or something
//!     \ /   \         coarser, where it is an original triangle or was made together with the ear. Then its own distance holds.
//!  ----u-----w----
//!       \   /
//!         v
//! ```

use crate::mesh::FragmentSequence;

/// Faces that are looked at in all while islands look for the nearest face.
const MAX_LOOKS: usize = 1 << 28;

/// Finds the faces nearby that take over.
pub(super) struct Adopters {
    /// For each face the step that replaces it.
    replaced_by: Vec<u32>,
    /// Faces of all levels by position: first entry of each, closed by the number of entries.
    first_around: Vec<u32>,
    around: Vec<u32>,
    looks_left: usize,
}

impl Adopters {
    pub(super) fn new(fragments: &FragmentSequence) -> Self {
        let positions = fragments.levels().positions();
        let corners = || (0..).zip(fragments.faces()).flat_map(|(face, f)| f.corners.map(|v| (face, v)));
        let mut first_around = vec![0; positions.position_count() + 2];
        for (_, v) in corners() {
            first_around[positions.position_of(v) as usize + 2] += 1;
        }
        for p in 2..first_around.len() {
            first_around[p] += first_around[p - 1];
        }
        let mut around = vec![0; 3 * fragments.faces().len()];
        for (face, v) in corners() {
            let at = &mut first_around[positions.position_of(v) as usize + 1];
            around[*at as usize] = face;
            *at += 1;
        }
        Self { replaced_by: fragments.replaced_by(), first_around, around, looks_left: MAX_LOOKS }
    }

    /// Faces that are there without `step` and touch its ceiling; the nearest one where none does.
    pub(super) fn find(&mut self, mesh: (&FragmentSequence, &[[f32; 3]]), step: u32) -> Vec<u32> {
        let fragments = mesh.0;
        let positions = fragments.levels().positions();
        let mut found = Vec::new();
        for face in fragments.ceiling(step) {
            for corner in fragments.faces()[face as usize].corners {
                let position = positions.position_of(corner) as usize;
                let [first, end] = [position, position + 1].map(|p| self.first_around[p] as usize);
                found.extend(
                    self.around[first..end].iter().filter(|&&face| self.is_there(fragments, face, step)),
                );
            }
        }
        if found.is_empty() {
            found.extend(self.nearest(mesh, step));
        }
        found.sort_unstable();
        found.dedup();
        found
    }

    /// True where each state that lacks `step` shows the face or something coarser.
    pub(super) fn is_sure(&self, fragments: &FragmentSequence, face: u32, step: u32) -> bool {
        let above = self.replaced_by[face as usize];
        let with_it = || fragments.ceiling(step).any(|own| self.replaced_by[own as usize] == above);
        above == FragmentSequence::NO_STEP || with_it()
    }

    fn is_there(&self, fragments: &FragmentSequence, face: u32, step: u32) -> bool {
        let is_made = fragments.maker(face).is_none_or(|maker| maker < step);
        // `NO_STEP` is larger than all steps.
        is_made && self.replaced_by[face as usize] > step
    }

    /// The face with the corner nearest to one that the step takes away.
    fn nearest(&mut self, (fragments, points): (&FragmentSequence, &[[f32; 3]]), step: u32) -> Option<u32> {
        self.looks_left = self.looks_left.checked_sub(fragments.faces().len())?;
        let own = fragments.faces()[fragments.ceiling(step).next()? as usize].corners[0];
        let squared = |v: u32| -> f64 {
            let [p, q] = [v, own].map(|v| points[v as usize].map(f64::from));
            (0..3).map(|axis| (p[axis] - q[axis]) * (p[axis] - q[axis])).sum()
        };
        let there = (0..fragments.faces().len() as u32).filter(|&face| self.is_there(fragments, face, step));
        let farness = |face: u32| {
            fragments.faces()[face as usize].corners.map(squared).into_iter().fold(f64::MAX, f64::min)
        };
        there.map(|face| (farness(face), face)).min_by(|a, b| a.0.total_cmp(&b.0)).map(|best| best.1)
    }
}
