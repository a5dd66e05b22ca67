//! Quadratic cost of moving a vertex, and the optimal position of an edge's new vertex.
//!
//! The planes of a star all pass through its center, so six coefficients represent the squared
//! distances from them, weighted by area, and the sum of the normals gives the change of volume. The
//! forms of two stars that share an edge are added. With the first end as the origin, the second at
//! `d`, and `s` for the triangles at the edge, which belong to both stars:
//!
//! ```text
//! cost(x)   = x^T A x - 2 b.x + c        A = Av + Au,       b = Au d,  c = d^T Au d
//! volume(x) = N.x - h                    N = Nv + Nu - Ns,  h = Nu.d      (6 times the change)
//! ```
//!
//! (`Ns.d` is zero, since the planes at the edge contain both ends.) The new position has the least
//! cost among those that preserve the volume; if the normals cancel out, so that the volume determines
//! nothing, its change becomes a penalty. Planes at the edge count twice, as in [Hop99]: counting them
//! once is 2 to 4 % worse in RMS.

use glam::DVec3;

/// Weight of the squared area between the old and the new path of a border.
pub(super) const BORDER_WEIGHT: f64 = 4.0;
/// Pull toward the edge's midpoint, as a share of the form's trace, for directions that the planes
/// leave open.
const MIDDLE_WEIGHT: f64 = 1e-5;
/// Length of the summed normals, as a share of the summed lengths, below which the volume condition is
/// ignored.
const MIN_FLATNESS: f64 = 0.1;
/// Limit on the distance of the new position from the edge's midpoint, in square roots of the area.
const MAX_MIDPOINT_DISTANCE: f64 = 2.0;

/// Quadratic form of a star around its center; its values have the unit length to the fourth power.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct StarForm {
    /// Coefficients xx, yy, zz, xy, xz, yz.
    form: [f64; 6],
    /// Sum of the triangles' normals, each as long as twice the triangle's area.
    normal: DVec3,
    /// Twice the area.
    area_doubled: f64,
}

impl StarForm {
    /// Adds a triangle, given by its unscaled normal.
    pub(super) fn add_triangle(&mut self, normal: DVec3) {
        let length = normal.length();
        self.normal += normal;
        self.area_doubled += length;
        if length > 0.0 {
            self.add_square(normal, 0.5 / length);
        }
    }

    /// Adds the squared area that is swept by moving off the border edge `along`, times a weight.
    pub(super) fn add_border(&mut self, along: DVec3, weight: f64) {
        let squared = weight * along.length_squared();
        for i in 0..3 {
            self.form[i] += squared;
        }
        self.add_square(along, -weight);
    }

    fn add_square(&mut self, v: DVec3, weight: f64) {
        let w = weight * v;
        let terms = [w.x * v.x, w.y * v.y, w.z * v.z, w.x * v.y, w.x * v.z, w.y * v.z];
        for (sum, term) in self.form.iter_mut().zip(terms) {
            *sum += term;
        }
    }

    /// Returns the product of the matrix and `x`.
    fn times(&self, x: DVec3) -> DVec3 {
        let [xx, yy, zz, xy, xz, yz] = self.form;
        DVec3::new(
            xx * x.x + xy * x.y + xz * x.z,
            xy * x.x + yy * x.y + yz * x.z,
            xz * x.x + yz * x.y + zz * x.z,
        )
    }

    fn trace(&self) -> f64 {
        self.form[0] + self.form[1] + self.form[2]
    }

    /// Returns the sum of two stars; triangles in both count once for the volume and twice for the planes.
    fn united(&self, other: &Self, shared: SharedTriangles) -> Self {
        Self {
            form: std::array::from_fn(|i| self.form[i] + other.form[i]),
            normal: self.normal + other.normal - shared.normal,
            area_doubled: (self.area_doubled + other.area_doubled - shared.area_doubled).max(0.0),
        }
    }

    /// Returns the inverse of a positive definite form; `None` if it is singular.
    fn inverse(&self) -> Option<Self> {
        let [xx, yy, zz, xy, xz, yz] = self.form;
        let (cxx, cxy, cxz) = (yy * zz - yz * yz, xz * yz - xy * zz, xy * yz - xz * yy);
        let determinant = xx * cxx + xy * cxy + xz * cxz;
        // Also false if the determinant is NaN.
        if !(determinant > 0.0 && (1.0 / determinant).is_finite()) {
            return None;
        }
        let adjugate = [cxx, xx * zz - xz * xz, xx * yy - xy * xy, cxy, cxz, xy * xz - xx * yz];
        Some(Self { form: adjugate.map(|x| x / determinant), ..Self::default() })
    }
}

/// The triangles that two stars share.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct SharedTriangles {
    normal: DVec3,
    area_doubled: f64,
}

impl SharedTriangles {
    /// Adds a triangle, given by its unscaled normal.
    pub(super) fn add_triangle(&mut self, normal: DVec3) {
        self.normal += normal;
        self.area_doubled += normal.length();
    }
}

/// Quadratic form of an edge collapse, with the first end as the origin.
#[derive(Clone, Copy, Debug)]
pub(super) struct EdgeForm {
    united: StarForm,
    /// Position of the second end.
    tip: DVec3,
    linear: DVec3,
    constant: f64,
    volume: f64,
}

impl EdgeForm {
    /// Combines the forms of both ends; `tip` is the second end relative to the first.
    pub(super) fn new(first: &StarForm, second: &StarForm, shared: SharedTriangles, tip: DVec3) -> Self {
        let linear = second.times(tip);
        Self {
            united: first.united(second, shared),
            tip,
            linear,
            constant: linear.dot(tip),
            volume: second.normal.dot(tip),
        }
    }

    /// Sum of the normals of both stars.
    pub(super) fn normal(&self) -> DVec3 {
        self.united.normal
    }

    /// Area of both stars.
    pub(super) fn area(&self) -> f64 {
        0.5 * self.united.area_doubled
    }

    /// Cost of placing the vertex at `x`; never negative.
    pub(super) fn cost(&self, x: DVec3) -> f64 {
        let planes = x.dot(self.united.times(x)) - 2.0 * self.linear.dot(x) + self.constant;
        let change = self.united.normal.dot(x) - self.volume;
        let swept = change * change * self.volume_weight();
        (planes + swept).max(0.0)
    }

    /// Factor that turns the doubled change of volume into its square over the area; normals and area
    /// are doubled.
    fn volume_weight(&self) -> f64 {
        0.5 / self.united.area_doubled.max(f64::MIN_POSITIVE)
    }

    /// Returns the cheapest position that preserves the volume; `None` if volume or planes do not
    /// determine one.
    pub(super) fn volume_preserving(&self) -> Option<DVec3> {
        let normal = self.united.normal;
        if normal.length() <= MIN_FLATNESS * self.united.area_doubled {
            return None;
        }
        let (inverse, linear) = self.regular(self.united)?;
        let free = inverse.times(linear);
        let step = inverse.times(normal);
        let along = normal.dot(step);
        if along <= 0.0 {
            return None;
        }
        self.accept_if_near(free + step * ((self.volume - normal.dot(free)) / along))
    }

    /// Returns the cheapest position with the change of volume as a penalty; `None` if it is too far away.
    pub(super) fn cheapest(&self) -> Option<DVec3> {
        let mut form = self.united;
        form.add_square(self.united.normal, self.volume_weight());
        let (inverse, linear) = self.regular(form)?;
        self.accept_if_near(inverse.times(linear + self.united.normal * (self.volume * self.volume_weight())))
    }

    /// Returns the inverse of a form with the pull toward the midpoint, and the linear part with that pull.
    fn regular(&self, mut form: StarForm) -> Option<(StarForm, DVec3)> {
        let pull = MIDDLE_WEIGHT * form.trace();
        for i in 0..3 {
            form.form[i] += pull;
        }
        Some((form.inverse()?, self.linear + self.tip * (0.5 * pull)))
    }

    fn accept_if_near(&self, x: DVec3) -> Option<DVec3> {
        let away = (x - 0.5 * self.tip).length_squared();
        // Also false if `x` is NaN.
        (away <= MAX_MIDPOINT_DISTANCE * MAX_MIDPOINT_DISTANCE * self.area()).then_some(x)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The form of a closed fan around `center`.
    fn star(center: DVec3, ring: &[DVec3]) -> StarForm {
        let mut form = StarForm::default();
        for (i, a) in ring.iter().enumerate() {
            form.add_triangle((*a - center).cross(ring[(i + 1) % ring.len()] - center));
        }
        form
    }

    #[test]
    fn form_is_the_squared_distance_times_area() {
        let mut form = StarForm::default();
        form.add_triangle(DVec3::new(0.0, 0.0, 3.0));
        let edge = EdgeForm::new(&form, &StarForm::default(), SharedTriangles::default(), DVec3::X);
        // Area 1.5, squared distance 4, and the same again for the volume.
        assert_eq!(edge.cost(DVec3::new(7.0, 5.0, 2.0)), 12.0);
    }

    #[test]
    fn border_sweeps_area() {
        let mut form = StarForm::default();
        form.add_border(DVec3::new(0.0, 2.0, 0.0), BORDER_WEIGHT);
        let edge = EdgeForm::new(&form, &StarForm::default(), SharedTriangles::default(), DVec3::X);
        assert_eq!(edge.cost(DVec3::new(3.0, 9.0, 0.0)), BORDER_WEIGHT * 36.0);
    }

    #[test]
    fn flat_stars_meet_in_the_middle() {
        let p = |x: f64, y: f64| DVec3::new(x, y, 0.0);
        let (v, u) = (p(0.0, 0.0), p(1.0, 0.0));
        let (top, low) = (p(0.5, 1.0), p(0.5, -1.0));
        let first = star(v, &[u, top, p(-1.0, 0.0), low]);
        let second = star(u, &[v, low, p(2.0, 0.0), top]);
        let mut shared = SharedTriangles::default();
        shared.add_triangle(u.cross(top));
        shared.add_triangle(low.cross(u));
        let edge = EdgeForm::new(&first, &second, shared, u);
        let position = edge.volume_preserving().unwrap();
        assert!((position - p(0.5, 0.0)).length() < 1e-12, "{position}");
        assert_eq!(edge.cost(position), 0.0);
    }

    #[test]
    fn ridge_is_raised_to_keep_the_volume() {
        // A roof whose ridge runs along the edge: rings at height 0 around ends at height 1.
        let (v, u) = (DVec3::new(0.0, 0.0, 1.0), DVec3::new(1.0, 0.0, 1.0));
        let (left, right) = (DVec3::new(0.5, 1.0, 0.0), DVec3::new(0.5, -1.0, 0.0));
        let first = star(v, &[u, left, DVec3::new(-1.0, 0.0, 0.0), right]);
        let second = star(u, &[v, right, DVec3::new(2.0, 0.0, 0.0), left]);
        let mut shared = SharedTriangles::default();
        shared.add_triangle((u - v).cross(left - v));
        shared.add_triangle((right - v).cross(u - v));
        let edge = EdgeForm::new(&first, &second, shared, u - v);
        let position = edge.volume_preserving().unwrap();
        // The volume above the ground consists of two end pyramids and the wedge between them, so a
        // single apex must be higher.
        assert!(position.z > 0.1 && (position.x - 0.5).abs() < 1e-9 && position.y.abs() < 1e-9, "{position}");
        let change = edge.united.normal.dot(position) - edge.volume;
        assert!(change.abs() < 1e-12, "{change}");
    }
}
