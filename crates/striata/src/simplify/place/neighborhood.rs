//! The star of one position, gathered in double precision.

use glam::DVec3;

use super::quadratic_form::{BORDER_WEIGHT, SharedTriangles, StarForm};
use crate::simplify::collapse::flat_fold::{NOISE, TriangleNormal, turns_over};
use crate::simplify::collapse::height_field::HeightField;
use crate::simplify::collapse::links::{LinkKind, Links};
use crate::simplify::collapse::star::{EdgeSides, StarRing};

/// Least squared cosine between the normals of an old triangle and its replacement.
const FLIP_COSINE_SQUARED: f64 = 0.04;
/// A new triangle must have at least this quality (1 is equilateral), unless the one it replaces was worse.
const SLIVER_QUALITY: f64 = 0.01;
/// Below this quality, the normal of a triangle is noise.
const NEEDLE_QUALITY: f64 = 0.02;
/// Factor that makes the quality of an equilateral triangle 1.
const TWICE_ROOT_3: f64 = 3.464_101_615_137_754_6;

/// Function that returns the weight of leaving the path of a seam, from the two triangles and the edge
/// vector between them.
type SeamWeight<'a> = &'a dyn Fn([u32; 2], DVec3) -> Option<f64>;

/// Scratch for the star of one position at a time; vectors are relative to its center.
#[derive(Debug, Default)]
pub(super) struct PositionStar {
    pub center: DVec3,
    pub ring: StarRing,
    /// Neighbors relative to the center.
    pub offsets: Vec<DVec3>,
    /// Unscaled normals of the triangles.
    normals: Vec<DVec3>,
    /// Indices of neighbors along a border of any kind: boundary, seam that must stay, edge with three
    /// triangles.
    pub borders: Vec<u32>,
    /// Indices of neighbors along a seam that may be crossed, and the weight of leaving its path.
    seams: Vec<(u32, f64)>,
}

impl PositionStar {
    /// Gathers the star of `v`. `seam_weight(triangles, along)` returns the weight of leaving the edge
    /// `along` if the two triangles at it use different wedges of `v`; infinite for seams that must stay.
    pub(super) fn gather(
        &mut self,
        links: &Links,
        positions: &[DVec3],
        v: u32,
        seam_weight: Option<SeamWeight<'_>>,
    ) {
        self.ring.gather(links, v);
        self.center = positions[v as usize];
        self.offsets.clear();
        self.offsets.extend(self.ring.ids.iter().map(|&id| positions[id as usize] - self.center));
        let mut normals = std::mem::take(&mut self.normals);
        normals.clear();
        normals.extend((0..self.ring.triangle_count()).map(|t| {
            let [a, b] = self.corners(t);
            a.cross(b)
        }));
        self.normals = normals;
        self.borders.clear();
        self.seams.clear();
        match links.kind(v) {
            LinkKind::Empty => {}
            LinkKind::Closed if seam_weight.is_none() => {}
            LinkKind::Open if seam_weight.is_none() => {
                self.borders.extend([0, self.offsets.len() as u32 - 1])
            }
            _ => self.find_borders(seam_weight),
        }
    }

    fn find_borders(&mut self, seam_weight: Option<SeamWeight<'_>>) {
        for (i, &along) in (0..).zip(&self.offsets) {
            let triangles = &self.ring.triangles;
            let weight_of = |[t, s]: [usize; 2]| seam_weight?([triangles[s], triangles[t]], along);
            let weight = match self.ring.sides(i as usize) {
                EdgeSides::Boundary | EdgeSides::Branch => Some(f64::INFINITY),
                EdgeSides::Inner(sides) => sides.into_iter().flatten().filter_map(weight_of).reduce(f64::max),
            };
            match weight {
                None => {}
                Some(weight) if weight.is_finite() => self.seams.push((i, weight)),
                Some(_) => self.borders.push(i),
            }
        }
    }

    /// Returns the corners of triangle `t` besides the center.
    fn corners(&self, t: usize) -> [DVec3; 2] {
        self.ring.triangle(t).map(|i| self.offsets[i])
    }

    /// Returns the quadratic form of the whole star.
    pub(super) fn form(&self) -> StarForm {
        let mut form = StarForm::default();
        self.normals.iter().for_each(|&normal| form.add_triangle(normal));
        self.borders.iter().for_each(|&i| form.add_border(self.offsets[i as usize], BORDER_WEIGHT));
        for &(i, weight) in &self.seams {
            form.add_border(self.offsets[i as usize], weight.min(BORDER_WEIGHT));
        }
        form
    }

    /// Returns the triangles that the star shares with that of neighbor `i`.
    pub(super) fn shared(&self, i: usize) -> SharedTriangles {
        let mut shared = SharedTriangles::default();
        for (t, &normal) in self.normals.iter().enumerate() {
            if self.ring.triangle(t).contains(&i) {
                shared.add_triangle(normal);
            }
        }
        shared
    }

    /// Whether the edge to neighbor `i` is a border.
    pub(super) fn is_border(&self, i: usize) -> bool {
        self.borders.contains(&(i as u32))
    }

    /// Returns the triangles that are kept when the center moves and `other` is merged with it.
    fn kept_triangles(&self, other: u32) -> impl Iterator<Item = KeptTriangle> {
        let gone = self.ring.index_of(other);
        let stays = move |t: &usize| gone.is_none_or(|gone| !self.ring.triangle(*t).contains(&gone));
        (0..self.normals.len()).filter(stays).map(|index| {
            let [a, b] = self.corners(index);
            KeptTriangle { index, a, b, normal: self.normals[index] }
        })
    }

    /// Whether all kept triangles stay unflipped and do not become slivers with the center at `position`.
    ///
    /// `mean` is the summed normal of both stars. The normal of a needle is unreliable, so its replacement
    /// must agree with the mean, or stay as small; a triangle that was folded over may unfold. Neither may
    /// turn over within a flat surface.
    pub(super) fn may_move(&self, position: DVec3, other: u32, mean: DVec3) -> bool {
        let x = position - self.center;
        self.kept_triangles(other).all(|triangle| match triangle.verdict_at(x, mean) {
            MoveVerdict::Refused => false,
            MoveVerdict::Allowed => true,
            MoveVerdict::MayTurn => !self.turns_over(triangle, x),
        })
    }

    /// Whether all kept triangles keep facing up, or down, when the center, `v`, moves to a place in plan.
    pub(super) fn keeps_height_field(
        &self,
        field: &HeightField,
        v: u32,
        other: u32,
        place: [f32; 2],
    ) -> bool {
        let corners = (0..self.normals.len()).map(|t| self.ring.triangle(t).map(|i| self.ring.ids[i]));
        corners.filter(|corners| !corners.contains(&other)).all(|ab| field.keeps_facing(v, ab, place))
    }

    /// Whether a kept triangle turns over within a flat surface if the center moves by `x`.
    #[cold]
    fn turns_over(&self, KeptTriangle { index, a, b, .. }: KeptTriangle, x: DVec3) -> bool {
        let others = (0..self.normals.len()).filter(|&t| t != index).map(|t| {
            let [a, b] = self.corners(t);
            TriangleNormal::new([DVec3::ZERO, a, b])
        });
        turns_over(TriangleNormal::new([DVec3::ZERO, a, b]), TriangleNormal::new([x, a, b]), others)
    }

    /// Squared distance of the center from the kept triangles after it has moved to `position`.
    pub(super) fn distance_squared(&self, position: DVec3, other: u32) -> f64 {
        let x = (position - self.center).as_vec3();
        let distances = self.kept_triangles(other).map(|KeptTriangle { a, b, .. }| {
            crate::simplify::collapse::fan::distance_squared(x, a.as_vec3(), b.as_vec3())
        });
        f64::from(distances.fold(x.length_squared(), f32::min))
    }
}

/// A kept triangle: its index, its corners besides the center, and its old normal.
#[derive(Clone, Copy)]
struct KeptTriangle {
    index: usize,
    a: DVec3,
    b: DVec3,
    normal: DVec3,
}

/// Verdict on a moved triangle, from its normals.
enum MoveVerdict {
    /// It would be flipped, or a sliver.
    Refused,
    Allowed,
    /// Allowed unless it turns over within a flat surface.
    MayTurn,
}

impl KeptTriangle {
    /// Tests the triangle with its center moved by `x`; `mean` is the summed normal of both stars.
    fn verdict_at(self, x: DVec3, mean: DVec3) -> MoveVerdict {
        let Self { a, b, normal: old, .. } = self;
        let new = (a - x).cross(b - x);
        let side = (b - a).length_squared();
        let old_sides = a.length_squared() + b.length_squared() + side;
        let new_sides = (a - x).length_squared() + (b - x).length_squared() + side;
        let (old_length, new_length) = (old.length(), new.length());
        let was_noise = old_length * old_length <= NOISE * NOISE * old_sides;
        let flips = !faces(new, old);
        let is_allowed = if TWICE_ROOT_3 * old_length <= NEEDLE_QUALITY * old_sides {
            new.dot(mean) > 0.0 || new_length <= 2.0 * old_length
        } else if flips {
            old.dot(mean) <= 0.0 && faces(new, mean)
        } else {
            TWICE_ROOT_3 * new_length >= SLIVER_QUALITY * new_sides
                || new_length * old_sides >= old_length * new_sides
        };
        match is_allowed {
            false => MoveVerdict::Refused,
            true if flips || was_noise => MoveVerdict::MayTurn,
            true => MoveVerdict::Allowed,
        }
    }
}

/// Whether two normals of any length clearly point the same way.
fn faces(a: DVec3, b: DVec3) -> bool {
    let along = a.dot(b);
    along > 0.0 && along * along > FLIP_COSINE_SQUARED * a.length_squared() * b.length_squared()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::shapes;

    fn neighborhood_of(v: u32) -> PositionStar {
        let mesh = shapes::grid(2, 2);
        let positions: Vec<DVec3> = mesh.positions.iter().map(|p| DVec3::from(p.map(f64::from))).collect();
        let mut neighborhood = PositionStar::default();
        neighborhood.gather(&Links::new(9, &mesh.triangles, false), &positions, v, None);
        neighborhood
    }

    #[test]
    fn borders_of_a_grid() {
        assert!(neighborhood_of(4).borders.is_empty());
        let edge = neighborhood_of(1);
        let mut across: Vec<u32> = edge.borders.iter().map(|&i| edge.ring.ids[i as usize]).collect();
        across.sort_unstable();
        assert_eq!(across, [0, 2]);
    }

    #[test]
    fn center_may_move_inside_its_ring_only() {
        let neighborhood = neighborhood_of(4);
        let at = |x: f64, y: f64| neighborhood.may_move(DVec3::new(x, y, 0.0), u32::MAX, DVec3::Z);
        assert!(at(1.0, 1.0) && at(1.2, 0.9));
        assert!(!at(2.5, 1.0) && !at(1.0, -0.5));
    }

    #[test]
    fn distance_is_from_the_new_triangles() {
        let neighborhood = neighborhood_of(4);
        let squared = neighborhood.distance_squared(DVec3::new(1.0, 1.0, 0.5), u32::MAX);
        assert!(squared > 0.1 && squared < 0.25, "{squared}");
        assert!(neighborhood.distance_squared(DVec3::new(1.1, 0.9, 0.0), u32::MAX) < 1e-12);
    }
}
