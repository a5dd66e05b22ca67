//! Bounding spheres that keep their center.

use glam::Vec3;

use super::SLACK;

/// A ball that holds what it has been grown to.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sphere {
    /// Its center, mesh units.
    pub center: [f32; 3],
    /// Its radius, mesh units; not negative.
    pub radius: f32,
}

impl Sphere {
    /// A point.
    pub fn point(center: [f32; 3]) -> Self {
        Self { center, radius: 0.0 }
    }

    /// The sphere of the same center that also holds a point.
    #[must_use]
    pub fn with_point(self, point: [f32; 3]) -> Self {
        self.with_sphere(&Self::point(point))
    }

    /// The sphere of the same center that also holds another.
    #[must_use]
    pub fn with_sphere(self, other: &Self) -> Self {
        let reach = distance(self.center, other.center) + other.radius;
        // What rounding took from the distance is given back.
        Self { radius: self.radius.max(reach * (1.0 + SLACK)), ..self }
    }

    /// Whether a point lies in it.
    pub fn holds(&self, point: [f32; 3]) -> bool {
        distance(self.center, point) <= self.radius
    }
}

/// Distance of two points, also where its square leaves the range of numbers.
fn distance(a: [f32; 3], b: [f32; 3]) -> f32 {
    let d = Vec3::from(a).as_dvec3() - Vec3::from(b).as_dvec3();
    d.length() as f32
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::Random;

    #[test]
    fn a_sphere_holds_all_that_it_was_grown_to() {
        let mut random = Random::new(1);
        let mut point = |scale: f32| [(); 3].map(|()| (random.unit() as f32 - 0.5) * scale);
        for scale in [1e-7, 1.0, 1e7, 1e25] {
            let points: Vec<[f32; 3]> = (0..50).map(|_| point(scale)).collect();
            let inner = points[1..].iter().fold(Sphere::point(points[0]), |s, &p| s.with_point(p));
            assert!(points.iter().all(|&p| inner.holds(p)), "{inner:?}");
            let outer = Sphere::point(point(scale)).with_sphere(&inner);
            assert!(points.iter().all(|&p| outer.holds(p)), "{outer:?}");
            assert!(outer.with_sphere(&inner) == outer, "what it holds changes nothing");
        }
    }
}
