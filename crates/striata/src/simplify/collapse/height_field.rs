//! Whether a triangle turns over in plan: seen along the z axis, as maps show terrain.
//!
//! The general test of flips compares normals in space, so on a steep slope a triangle may turn over in plan without
//! turning far in space. A height field must not have such a triangle: it would have two heights at one place.
//!
//! ```text
//!   from the side:     u          v moves to u: the normal of the right triangle turns by less than a
//!                     /            right angle, but seen from above the triangle then lies on its back
//!              v --- /
//!                   b
//! ```
//!
//! Areas are computed from the positions of the input. The scaled positions of the simplifier are rounded, which
//! can give samples of a raster that lie in one line an area.

use crate::mesh::Welded;

use super::star::Star;

/// Area of a triangle in plan, doubled; negative if it faces down.
pub(in crate::simplify) fn area(corners: [[f32; 2]; 3]) -> f64 {
    let [a, b, c] = corners.map(|p| p.map(f64::from));
    (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
}

/// Positions in plan, and the test of triangles.
#[derive(Debug)]
pub(in crate::simplify) struct HeightField {
    plan: Vec<[f32; 2]>,
}

impl HeightField {
    /// Returns the test if the mesh must stay a height field.
    pub(in crate::simplify) fn of(welded: &Welded, is_height_field: Option<bool>) -> Option<Self> {
        let is_terrain = || !welded.mesh.appearance.georeference.is_empty();
        let plan = |p: u32| {
            let [x, y, _] = welded.mesh.positions[welded.positions.first_vertex(p) as usize];
            [x, y]
        };
        let positions = 0..welded.positions.position_count() as u32;
        is_height_field.unwrap_or_else(is_terrain).then(|| Self { plan: positions.map(plan).collect() })
    }

    /// A position in plan.
    pub(in crate::simplify) fn at(&self, p: u32) -> [f32; 2] {
        self.plan[p as usize]
    }

    /// Moves a position to a place in plan.
    pub(in crate::simplify) fn move_to(&mut self, p: u32, place: [f32; 2]) {
        self.plan[p as usize] = place;
    }

    /// Whether a triangle `(v, a, b)` keeps facing up, or down, when `v` moves to a place in plan. A vertical one may
    /// face any way.
    pub(in crate::simplify) fn keeps_facing(&self, v: u32, [a, b]: [u32; 2], place: [f32; 2]) -> bool {
        let (old, new) = (self.area([v, a, b]), area([place, self.at(a), self.at(b)]));
        old == 0.0 || (new != 0.0 && (old > 0.0) == (new > 0.0))
    }

    fn area(&self, corners: [u32; 3]) -> f64 {
        area(corners.map(|p| self.at(p)))
    }

    /// 1 if all triangles of the star of `v` face up, -1 if all face down, otherwise 0.
    pub(in crate::simplify) fn facing(&self, star: &Star, v: u32) -> f64 {
        let areas = || {
            let triangles =
                (0..star.ring.triangle_count()).map(|t| star.ring.triangle(t).map(|i| star.ring.ids[i]));
            triangles.map(|[a, b]| self.area([v, a, b]))
        };
        if areas().all(|area| area > 0.0) {
            1.0
        } else if areas().all(|area| area < 0.0) {
            -1.0
        } else {
            0.0
        }
    }

    /// Whether all triangles of the star of `v` that stay when `v` moves to `u` keep facing up, or down.
    pub(in crate::simplify) fn allows(&self, star: &Star, v: u32, u: u32) -> bool {
        (0..star.ring.triangle_count())
            .map(|t| star.ring.triangle(t).map(|i| star.ring.ids[i]))
            .all(|[a, b]| a == u || b == u || self.keeps_facing(v, [a, b], self.at(u)))
    }
}
