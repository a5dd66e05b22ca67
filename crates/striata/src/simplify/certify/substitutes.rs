//! Finds substitute faces for a step whose floor is empty, which has no triangle to assign its pieces to.
//!
//! An ear (a triangle attached by only one side) or an island vanishes without a replacement. A
//! triangle `g` nearby takes over its pieces. For the levels of the sequence that is sufficient. But
//! another state that lacks the step may still be finer around `g`: the faces that would get the pieces
//! do not exist there yet. The pieces that `g` had, except for those taken over in this way, are then
//! represented by finer triangles, none of them farther away than the largest bound so far, and each
//! new piece is within some *reach* of one of them. The sum of both distances is a valid bound.
//!
//! ```text
//!    \   /g\          The step removes v with the ear (u, v, w), and g takes over its pieces. If g is an
//!     \ /   \         original triangle, or is replaced in the same step as the ear, g or something coarser
//!  ----u-----w----    is guaranteed to be active. Then its own distance is a valid bound.
//!       \   /
//!         v
//! ```

use glam::{DVec3, Vec3, Vec3A};

use crate::mesh::{AxisBox, BoxTree, FragmentSequence};
use crate::simplify::collapse::fan::distance_squared;

/// Maximum number of points of an island for which the nearest face is searched.
const MAX_POINTS: usize = 24;

/// Finds nearby faces that take over the pieces of a step.
pub(super) struct SubstituteFinder {
    /// For each face, the step that replaces it.
    replaced_by: Vec<u32>,
    /// First entry in `around` of each position, followed by the number of entries; faces of all levels.
    first_around: Vec<u32>,
    around: Vec<u32>,
    /// Created when the first island vanishes.
    face_tree: Option<FaceTree>,
}

/// Box tree over the faces of all levels, in coordinates in which the mesh has an extent of about 1.
struct FaceTree {
    middle: DVec3,
    scale: f64,
    tree: BoxTree,
}

impl SubstituteFinder {
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
        Self { replaced_by: fragments.replacing_steps(), first_around, around, face_tree: None }
    }

    /// Returns the faces that exist just before `step` is applied and touch its ceiling; if there are
    /// none, those nearest to it.
    pub(super) fn find(&mut self, fragments: &FragmentSequence, points: &[[f32; 3]], step: u32) -> Vec<u32> {
        let positions = fragments.levels().positions();
        let mut found = Vec::new();
        for face in fragments.ceiling(step) {
            for corner in fragments.faces()[face as usize].corners {
                let position = positions.position_of(corner) as usize;
                let [first, end] = [position, position + 1].map(|p| self.first_around[p] as usize);
                found.extend(
                    self.around[first..end].iter().filter(|&&face| self.is_present(fragments, face, step)),
                );
            }
        }
        if found.is_empty() {
            found.extend(self.nearest(fragments, points, step));
        }
        found.sort_unstable();
        found.dedup();
        found
    }

    /// Whether every state that lacks `step` contains the face or something coarser.
    pub(super) fn is_guaranteed(&self, fragments: &FragmentSequence, face: u32, step: u32) -> bool {
        let above = self.replaced_by[face as usize];
        let with_it = || fragments.ceiling(step).any(|own| self.replaced_by[own as usize] == above);
        above == FragmentSequence::NO_STEP || with_it()
    }

    fn is_present(&self, fragments: &FragmentSequence, face: u32, step: u32) -> bool {
        let is_made = fragments.creating_step(face).is_none_or(|maker| maker < step);
        // `NO_STEP` is larger than all step indices.
        is_made && self.replaced_by[face as usize] > step
    }

    /// Returns the faces nearest to the corners and centroids of the faces that the step removes.
    fn nearest(&mut self, fragments: &FragmentSequence, points: &[[f32; 3]], step: u32) -> Vec<u32> {
        let face_tree = self.face_tree.take().unwrap_or_else(|| FaceTree::new(fragments, points));
        let to_local = |v: u32| face_tree.to_local(points[v as usize]);
        let mut from = Vec::new();
        for face in fragments.ceiling(step) {
            let [a, b, c] = fragments.faces()[face as usize].corners.map(to_local);
            from.extend([a, b, c, (a + b + c) / 3.0]);
        }
        let stride = from.len().div_ceil(MAX_POINTS).max(1);
        let mut found = Vec::new();
        for at in from.into_iter().step_by(stride) {
            let (mut least, mut best) = (f32::INFINITY, None);
            face_tree.tree.visit_near(Vec3A::from(at), least, |face| {
                if self.is_present(fragments, face as u32, step) {
                    let [a, b, c] = fragments.faces()[face].corners.map(|v| to_local(v) - at);
                    let squared = distance_squared(a, b, c);
                    if squared < least {
                        (least, best) = (squared, Some(face as u32));
                    }
                }
                least
            });
            found.extend(best);
        }
        self.face_tree = Some(face_tree);
        found
    }
}

impl FaceTree {
    fn new(fragments: &FragmentSequence, points: &[[f32; 3]]) -> Self {
        let all = || points.iter().map(|p| DVec3::from_array(p.map(f64::from)));
        let (min, max) =
            (all().fold(DVec3::INFINITY, DVec3::min), all().fold(DVec3::NEG_INFINITY, DVec3::max));
        let extent = (max - min).max_element();
        let scale = if extent > 0.0 { extent.recip() } else { 1.0 };
        let mut face_tree = Self { middle: 0.5 * (min + max), scale, tree: BoxTree::default() };
        let box_of = |corners: [u32; 3]| {
            let [a, b, c] = corners.map(|v| Vec3A::from(face_tree.to_local(points[v as usize])));
            AxisBox { min: a.min(b).min(c), max: a.max(b).max(c) }
        };
        let faces = fragments.faces();
        face_tree.tree = BoxTree::new(faces.len(), |face| box_of(faces[face as usize].corners));
        face_tree
    }

    fn to_local(&self, point: [f32; 3]) -> Vec3 {
        ((DVec3::from_array(point.map(f64::from)) - self.middle) * self.scale).as_vec3()
    }
}
