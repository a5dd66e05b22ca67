//! Certified errors: a proven bound on the distance of the original surface from the simplified one.
//!
//! **Idea.** The original surface is covered by *pieces*: convex polygons, each inside one original
//! triangle, each assigned to one current triangle. The distance to a triangle is a convex function, so
//! no point of a piece is farther from its triangle than the farthest of the piece's corners: a few
//! distances bound infinitely many. A step assigns the pieces of its ceiling to its floor. If no single
//! triangle of the floor is close enough to a piece, the piece is cut along the boundary between the
//! regions of the nearest ones; parts of one original triangle that meet again are joined.
//!
//! **Theorem.** Let the pieces of each face be those that were assigned to it when it was created,
//! regardless of later steps. In every state of selective refinement (every set of steps that contains,
//! with each step, all steps on which its floor depends) the pieces of the active faces cover the
//! original surface. *Proof*: by induction over the unapplied steps, finest first. If all steps are
//! applied, each original triangle is its own piece. Undoing a step replaces its ceiling by its floor,
//! and the pieces of the floor cover everything that those of the ceiling cover, since they are made
//! from them. So the distance of the original surface from the state never exceeds the largest bound of
//! the floors whose faces are active, in every state and not only in the levels of the sequence. The
//! surface may be non-manifold, unoriented or degenerate.
//!
//! The one-sided Hausdorff distance that orders the steps of \[KLS96\] and \[KG98\] is the same
//! distance, measured at samples or under assumptions on the surface. Differs: the bound is proven.
//! Nothing can be assigned to a floor without triangles: the pieces of its ceiling are then dropped,
//! with a bound of the diagonal of the mesh's bounds, which is the largest possible distance of two
//! vertices; `substitutes` finds better bounds for finished sequences.
//!
//! Pieces never leave the fragment, so if a new triangle folds over its neighbor, the bound is the
//! distance to that triangle and not to the neighbor that hides the hole. Within the fragment the bound
//! is tight: at most 3 % above the distance of some point from the floor, provided that the cuts
//! succeed, which they nearly always do.
//!
//! Cost: a step visits each piece around it, so all steps together visit O(n log n) pieces for n
//! triangles; half a second for the 69,451 triangles of the bunny.

mod assign;
mod certified_errors;
mod flat_folds;
mod floor;
mod pieces;
mod polygon;
mod substitutes;

pub use certified_errors::{
    CertifiedFaces, certify, certify_collapses, certify_collapses_in_any_state,
    certify_collapses_in_any_state_with_progress, certify_collapses_with_progress, certify_faces,
    certify_faces_with_progress, certify_with_progress,
};
pub use flat_folds::flat_folds;

use glam::DVec3;

use assign::{CutPiece, MAX_DISTANCES, MeasuredPoints, PieceAssigner, TrianglePlane};
use floor::Floor;
use pieces::{NONE, Pieces};
use polygon::{Polygon, WHOLE};

/// Share of the diagonal by which every bound is raised, to account for all rounding in f64.
const ROUNDING: f64 = 1e-11;

/// Share of the diagonal below which a distance does not justify a cut.
const NEGLIGIBLE: f64 = 1e-11;

/// Maximum number of triangles of a face's pieces that are searched for the one nearest to another piece.
const MAX_ASSIGNED_TRIANGLES: usize = 1 << 10;

/// Assignment of pieces of the original surface to the faces of the current one.
pub(crate) struct Cover {
    positions: Vec<[f32; 3]>,
    triangles: Vec<[u32; 3]>,
    /// Corner of the bounds, relative to which distances are measured.
    origin: DVec3,
    diagonal: f64,
    pieces: Pieces,
    assigner: PieceAssigner,
    /// For each original vertex, its point in the current step, or `NONE`.
    point_of_vertex: Vec<u32>,
    /// For each original triangle, its piece in the current step, or `NONE`.
    piece_of_triangle: Vec<u32>,
    proposal: Proposal,
    /// Original triangles whose pieces may cover more in a face than in its ceiling: parts left without
    /// a floor, and the area between parts that were joined.
    is_displaced: Vec<bool>,
}

/// Pieces that a step takes from its ceiling and assigns to its floor, until it is committed.
#[derive(Default)]
struct Proposal {
    ceiling: Vec<u32>,
    floor: Vec<u32>,
    gathered: Vec<Gathered>,
    polygons: Vec<Polygon>,
    /// Points of the corners of all pieces.
    corner_points: Vec<u32>,
    touched_vertices: Vec<u32>,
    /// Whole triangles: the original triangle and the index of its face in the floor.
    wholes: Vec<(u32, u32)>,
    parts: Vec<(u32, u32, Polygon)>,
    /// Largest squared bound of the pieces of each face of the floor.
    squared_bounds: Vec<f64>,
}

/// A piece of the ceiling, after parts of the same triangle have been joined where possible.
#[derive(Clone, Copy)]
struct Gathered {
    triangle: u32,
    /// Index of its polygon, or `NONE` for the whole triangle.
    polygon: u32,
    /// Index of its first entry in the corner points.
    first_corner: u32,
}

impl Cover {
    /// Assigns each triangle of the original mesh to itself, as the face with the same index.
    pub(crate) fn new(positions: &[[f32; 3]], triangles: &[[u32; 3]]) -> Self {
        let at = |&v: &u32| DVec3::from_array(positions[v as usize].map(f64::from));
        let points = || triangles.iter().flatten().map(at);
        let (low, high) = (points().reduce(DVec3::min), points().reduce(DVec3::max));
        let origin = low.unwrap_or_default();
        let diagonal = (high.unwrap_or_default() - origin).length();
        let negligible = (NEGLIGIBLE * diagonal) * (NEGLIGIBLE * diagonal);
        Self {
            origin,
            diagonal,
            pieces: Pieces::new(triangles.len()),
            assigner: PieceAssigner::new(negligible),
            point_of_vertex: vec![NONE; positions.len()],
            piece_of_triangle: vec![NONE; triangles.len()],
            proposal: Proposal::default(),
            is_displaced: vec![false; triangles.len()],
            positions: positions.to_vec(),
            triangles: triangles.to_vec(),
        }
    }

    /// Assigns the pieces of the faces `ceiling` to the faces `floor` (index and corners); returns a
    /// bound on the distance of any piece from its face, mesh units. Face indices may be reused.
    pub(crate) fn replace(&mut self, ceiling: &[u32], floor: &[(u32, [[f64; 3]; 3])]) -> f64 {
        let bound = self.propose(ceiling, floor);
        self.commit();
        bound
    }

    /// Computes what [`replace`](Self::replace) would do and returns its bound;
    /// [`commit`](Self::commit) applies it.
    pub(crate) fn propose(&mut self, ceiling: &[u32], floor: &[(u32, [[f64; 3]; 3])]) -> f64 {
        self.gather(ceiling);
        let proposal = &mut self.proposal;
        proposal.floor.clear();
        proposal.floor.extend(floor.iter().map(|face| face.0));
        proposal.wholes.clear();
        proposal.parts.clear();
        proposal.squared_bounds.clear();
        proposal.squared_bounds.resize(floor.len(), 0.0);
        if proposal.gathered.is_empty() {
            return 0.0;
        }
        if floor.is_empty() {
            return self.diagonal;
        }
        let origin = self.origin;
        let corners = |face: &(u32, [[f64; 3]; 3])| face.1.map(|p| DVec3::from_array(p) - origin);
        self.assigner.floor.set(floor.iter().map(corners));
        self.assign_all();
        let largest = self.proposal.squared_bounds.iter().copied().fold(0.0, f64::max);
        largest.sqrt() + ROUNDING * self.diagonal
    }

    /// Returns a bound on the distance of the last proposed pieces from a face of the floor, given by its
    /// index in it, that they were assigned to.
    fn face_bound(&self, index: usize) -> f64 {
        if self.proposal.gathered.is_empty() {
            return 0.0;
        }
        self.proposal.squared_bounds[index].sqrt() + ROUNDING * self.diagonal
    }

    /// Returns the largest distance between the proposed pieces and the pieces that their new faces
    /// have already, ignoring displaced triangles and faces that are `exempt` (by index in the floor).
    /// `None` if every face is exempt.
    fn reach(&self, exempt: impl Fn(usize) -> bool) -> Option<f64> {
        let Proposal { floor, wholes, parts, .. } = &self.proposal;
        let mut reach: Option<f64> = None;
        for (index, &face) in floor.iter().enumerate().filter(|&(index, _)| !exempt(index)) {
            let mut known = Floor::default();
            known.set(self.assigned_triangles(face).into_iter());
            let mut points = MeasuredPoints::default();
            let mut look = |triangle: u32, corners: &[[f64; 2]]| {
                let plane = plane(&self.positions, self.origin, self.triangles[triangle as usize]);
                points.clear();
                let ids: Vec<u32> =
                    corners.iter().map(|&corner| points.push(&known, plane.at(corner))).collect();
                let (_, least) = points.best(&ids, known.count());
                let raised = least.sqrt().min(self.diagonal) + ROUNDING * self.diagonal;
                reach = Some(reach.map_or(raised, |reach| reach.max(raised)));
            };
            wholes.iter().filter(|whole| whole.1 as usize == index).for_each(|whole| look(whole.0, &WHOLE));
            let own_parts = parts.iter().filter(|part| part.1 as usize == index);
            own_parts.for_each(|part| look(part.0, part.2.corners()));
        }
        reach
    }

    /// Returns some of the pieces assigned to a face, as triangles; displaced triangles are left out.
    fn assigned_triangles(&self, face: u32) -> Vec<[DVec3; 3]> {
        let mut known = Vec::new();
        let mut add = |triangle: u32, corners: &[[f64; 2]]| {
            if self.is_displaced[triangle as usize] {
                return;
            }
            let plane = plane(&self.positions, self.origin, self.triangles[triangle as usize]);
            for pair in corners.windows(2).skip(1) {
                known.push([corners[0], pair[0], pair[1]].map(|corner| plane.at(corner)));
            }
        };
        self.pieces.for_each_whole(face, |triangle| add(triangle, &WHOLE));
        self.pieces.for_each_part(face, |triangle, polygon| add(triangle, polygon.corners()));
        let stride = known.len().div_ceil(MAX_ASSIGNED_TRIANGLES).max(1);
        known.into_iter().step_by(stride).collect()
    }

    /// Marks the proposed pieces as left without a floor.
    fn mark_orphans(&mut self) {
        for piece in &self.proposal.gathered {
            self.is_displaced[piece.triangle as usize] = true;
        }
    }

    /// Diagonal of the bounds of the original mesh: no two points of the mesh are farther apart.
    fn diagonal(&self) -> f64 {
        self.diagonal
    }

    /// Applies the last proposal.
    pub(crate) fn commit(&mut self) {
        let Proposal { ceiling, floor, wholes, parts, .. } = &mut self.proposal;
        for face in ceiling.drain(..) {
            self.pieces.clear(face);
        }
        for (triangle, index) in wholes.drain(..) {
            self.pieces.push_whole(floor[index as usize], triangle);
        }
        for (triangle, index, polygon) in parts.drain(..) {
            self.pieces.push_part(floor[index as usize], triangle, polygon);
        }
    }

    /// Collects the pieces of some faces.
    fn gather(&mut self, ceiling: &[u32]) {
        let Self { proposal, pieces, piece_of_triangle, is_displaced, .. } = self;
        proposal.ceiling.clear();
        proposal.ceiling.extend_from_slice(ceiling);
        let Proposal { gathered, polygons, .. } = proposal;
        gathered.clear();
        polygons.clear();
        for &face in ceiling {
            pieces.for_each_whole(face, |triangle| {
                let known = &mut piece_of_triangle[triangle as usize];
                if *known == NONE {
                    *known = gathered.len() as u32;
                    gathered.push(Gathered { triangle, polygon: NONE, first_corner: 0 });
                } else {
                    gathered[*known as usize].polygon = NONE;
                }
            });
            pieces.for_each_part(face, |triangle, part| {
                let known = &mut piece_of_triangle[triangle as usize];
                if *known == NONE {
                    *known = gathered.len() as u32;
                } else {
                    let Gathered { polygon, .. } = &mut gathered[*known as usize];
                    if *polygon == NONE {
                        return;
                    }
                    if let Some(hull) = polygons[*polygon as usize].hull(part) {
                        let parts = polygons[*polygon as usize].area() + part.area();
                        is_displaced[triangle as usize] |= hull.area() > parts + ROUNDING;
                        polygons[*polygon as usize] = hull;
                        if hull.is_whole() {
                            *polygon = NONE;
                        }
                        return;
                    }
                }
                gathered.push(Gathered { triangle, polygon: polygons.len() as u32, first_corner: 0 });
                polygons.push(*part);
            });
        }
        gathered.iter().for_each(|piece| piece_of_triangle[piece.triangle as usize] = NONE);
    }

    /// Measures and assigns all gathered pieces.
    fn assign_all(&mut self) {
        if self.proposal.gathered.len().saturating_mul(self.proposal.floor.len()) > MAX_DISTANCES {
            return self.assign_wholes();
        }
        self.measure();
        let Proposal { gathered, polygons, corner_points, wholes, parts, squared_bounds, .. } =
            &mut self.proposal;
        for piece in gathered {
            let corners = match polygons.get(piece.polygon as usize) {
                Some(polygon) => polygon.corners(),
                None => &WHOLE,
            };
            let points = &corner_points[piece.first_corner as usize..][..corners.len()];
            if let Some((face, squared)) = self.assigner.single_face(points) {
                squared_bounds[face] = squared_bounds[face].max(squared);
                match polygons.get(piece.polygon as usize) {
                    Some(&polygon) => parts.push((piece.triangle, face as u32, polygon)),
                    None => wholes.push((piece.triangle, face as u32)),
                }
                continue;
            }
            let mut shape = CutPiece::new();
            corners.iter().zip(points).for_each(|(&corner, &point)| shape.push(corner, point));
            let plane = plane(&self.positions, self.origin, self.triangles[piece.triangle as usize]);
            self.assigner.assign(shape, &plane, |face, squared, shape| {
                squared_bounds[face] = squared_bounds[face].max(squared);
                match shape.polygon() {
                    polygon if polygon.is_whole() => wholes.push((piece.triangle, face as u32)),
                    polygon => parts.push((piece.triangle, face as u32, polygon)),
                }
            });
        }
    }

    /// Assigns each piece to the face of the floor that is nearest to all of it, without cutting any: a star of ten
    /// thousand triangles has too many distances to keep.
    fn assign_wholes(&mut self) {
        let Proposal { gathered, polygons, wholes, parts, squared_bounds, .. } = &mut self.proposal;
        for piece in gathered {
            let polygon = polygons.get(piece.polygon as usize);
            let corners = polygon.map_or(&WHOLE[..], |polygon| polygon.corners());
            let plane = plane(&self.positions, self.origin, self.triangles[piece.triangle as usize]);
            let points: Vec<DVec3> = corners.iter().map(|&corner| plane.at(corner)).collect();
            let (face, squared) = self.assigner.floor.best(&points);
            squared_bounds[face] = squared_bounds[face].max(squared);
            match polygon {
                Some(&polygon) => parts.push((piece.triangle, face as u32, polygon)),
                None => wholes.push((piece.triangle, face as u32)),
            }
        }
    }

    /// Measures the corners of all pieces, those at original vertices only once.
    fn measure(&mut self) {
        let Self { proposal, assigner: PieceAssigner { floor, points, .. }, point_of_vertex, .. } = self;
        let Proposal { gathered, polygons, corner_points, touched_vertices, .. } = proposal;
        points.clear();
        corner_points.clear();
        for piece in gathered {
            piece.first_corner = corner_points.len() as u32;
            let triangle = self.triangles[piece.triangle as usize];
            let plane = plane(&self.positions, self.origin, triangle);
            let mut put = |corner: [f64; 2]| {
                let Some(i) = WHOLE.iter().position(|&whole| whole == corner) else {
                    return corner_points.push(points.push(floor, plane.at(corner)));
                };
                let known = &mut point_of_vertex[triangle[i] as usize];
                if *known == NONE {
                    *known = points.push(floor, plane.at(corner));
                    touched_vertices.push(triangle[i]);
                }
                corner_points.push(*known);
            };
            match polygons.get(piece.polygon as usize) {
                None => WHOLE.into_iter().for_each(&mut put),
                Some(polygon) => polygon.corners().iter().copied().for_each(&mut put),
            }
        }
        for v in touched_vertices.drain(..) {
            point_of_vertex[v as usize] = NONE;
        }
    }
}

#[inline]
fn plane(positions: &[[f32; 3]], origin: DVec3, triangle: [u32; 3]) -> TrianglePlane {
    let [a, b, c] = triangle.map(|v| DVec3::from_array(positions[v as usize].map(f64::from)));
    TrianglePlane { first: a - origin, to_second: b - a, to_third: c - a }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Index and corners of a face.
    type IndexedFace = (u32, [[f64; 3]; 3]);

    /// A square with a raised center, as four triangles, and the two triangles that remain without the
    /// center.
    fn tent(height: f32) -> (Cover, [IndexedFace; 2]) {
        let points =
            [[-1.0, -1.0, 0.0], [1.0, -1.0, 0.0], [1.0, 1.0, 0.0], [-1.0, 1.0, 0.0], [0.25, 0.0, height]];
        let cover = Cover::new(&points, &[[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]]);
        let face = |corners: [usize; 3]| corners.map(|v| points[v].map(f64::from));
        (cover, [(0, face([0, 1, 2])), (9, face([0, 2, 3]))])
    }

    #[test]
    fn bound_is_the_height_of_the_raised_center() {
        for height in [0.0, 0.001, 0.1, 2.0] {
            let (mut cover, floor) = tent(height);
            let bound = cover.replace(&[0, 1, 2, 3], &floor);
            let height = f64::from(height);
            assert!(bound >= height && bound <= (1.0 + assign::SLACK) * height + 1e-9, "{height}: {bound}");
        }
    }

    #[test]
    fn proposals_change_nothing_and_face_indices_may_be_reused() {
        let (mut cover, floor) = tent(0.5);
        let upright = floor.map(|(face, corners)| (face, corners.map(|[x, y, z]| [x, y, z + 3.0])));
        let far = cover.propose(&[0, 1, 2, 3], &upright);
        assert!(far > 2.99 && far < 3.2, "{far}");
        let bound = cover.replace(&[0, 1, 2, 3], &floor);
        assert!(bound < 0.52, "{bound}");
        // All pieces are on the two faces 0 and 9 now.
        assert_eq!(cover.replace(&[1, 2, 3], &[]), 0.0);
        let back = cover.replace(&[0, 9], &upright);
        assert!(back > 2.99 && back < 3.2, "{back}");
    }

    #[test]
    fn pieces_without_a_floor_are_dropped_once() {
        let (mut cover, floor) = tent(0.5);
        let bound = cover.replace(&[0, 1], &[]);
        assert!(bound >= 8f64.sqrt() && bound < 2.9, "the diagonal: {bound}");
        assert!(cover.replace(&[2, 3], &floor) < 0.52);
        assert_eq!(cover.replace(&[0, 9], &[]), bound);
        assert_eq!(cover.replace(&[0, 9], &[]), 0.0);
    }

    #[test]
    fn parts_that_meet_again_are_joined() {
        let (mut cover, floor) = tent(0.0);
        cover.replace(&[0, 1, 2, 3], &floor);
        assert!(cover.pieces.peak()[1] > 0, "the cut along the diagonal goes through two triangles");
        let one = floor[0].1.map(|[x, y, z]| [3.0 * x, 3.0 * y, z]);
        cover.replace(&[0, 9], &[(5, one)]);
        let mut wholes = 0;
        cover.pieces.for_each_whole(5, |_| wholes += 1);
        assert_eq!(wholes, 4);
    }
}
