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

use glam::{DVec3, Vec3, Vec3A};

use crate::mesh::{AxisBox, BoxTree, FragmentSequence};
use crate::simplify::collapse::fan::distance_squared;

/// Points of an island that look for the nearest face, at most.
const MAX_POINTS: usize = 24;

/// Finds the faces nearby that take over.
pub(super) struct Adopters {
    /// For each face the step that replaces it.
    replaced_by: Vec<u32>,
    /// Faces of all levels by position: first entry of each, closed by the number of entries.
    first_around: Vec<u32>,
    around: Vec<u32>,
    /// Made when the first island vanishes.
    nearby: Option<Nearby>,
}

/// The faces of all levels in a tree of boxes, in a frame where the mesh spans about 1.
struct Nearby {
    middle: DVec3,
    scale: f64,
    tree: BoxTree,
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
        Self { replaced_by: fragments.replaced_by(), first_around, around, nearby: None }
    }

    /// Faces that are there without `step` and touch its ceiling; those nearest to it if none does.
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

    /// The faces nearest to corners and middles of those that the step takes away.
    fn nearest(&mut self, (fragments, points): (&FragmentSequence, &[[f32; 3]]), step: u32) -> Vec<u32> {
        let nearby = self.nearby.take().unwrap_or_else(|| Nearby::new(fragments, points));
        let place = |v: u32| nearby.place(points[v as usize]);
        let mut from = Vec::new();
        for face in fragments.ceiling(step) {
            let [a, b, c] = fragments.faces()[face as usize].corners.map(place);
            from.extend([a, b, c, (a + b + c) / 3.0]);
        }
        let stride = from.len().div_ceil(MAX_POINTS).max(1);
        let mut found = Vec::new();
        for at in from.into_iter().step_by(stride) {
            let (mut least, mut best) = (f32::INFINITY, None);
            nearby.tree.visit_near(Vec3A::from(at), least, |face| {
                if self.is_there(fragments, face as u32, step) {
                    let [a, b, c] = fragments.faces()[face].corners.map(|v| place(v) - at);
                    let squared = distance_squared(a, b, c);
                    if squared < least {
                        (least, best) = (squared, Some(face as u32));
                    }
                }
                least
            });
            found.extend(best);
        }
        self.nearby = Some(nearby);
        found
    }
}

impl Nearby {
    fn new(fragments: &FragmentSequence, points: &[[f32; 3]]) -> Self {
        let all = || points.iter().map(|p| DVec3::from_array(p.map(f64::from)));
        let (min, max) =
            (all().fold(DVec3::INFINITY, DVec3::min), all().fold(DVec3::NEG_INFINITY, DVec3::max));
        let extent = (max - min).max_element();
        let scale = if extent > 0.0 { extent.recip() } else { 1.0 };
        let mut nearby = Self { middle: 0.5 * (min + max), scale, tree: BoxTree::default() };
        let box_of = |corners: [u32; 3]| {
            let [a, b, c] = corners.map(|v| Vec3A::from(nearby.place(points[v as usize])));
            AxisBox { min: a.min(b).min(c), max: a.max(b).max(c) }
        };
        let boxes: Vec<AxisBox> = fragments.faces().iter().map(|face| box_of(face.corners)).collect();
        nearby.tree = BoxTree::new(&boxes);
        nearby
    }

    fn place(&self, point: [f32; 3]) -> Vec3 {
        ((DVec3::from_array(point.map(f64::from)) - self.middle) * self.scale).as_vec3()
    }
}
