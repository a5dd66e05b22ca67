//! Bounding spheres that grow around a fixed center.

use glam::Vec3;

use super::SLACK;

/// A bounding sphere.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sphere {
    /// Center, in mesh units.
    pub center: [f32; 3],
    /// Radius, in mesh units; not negative.
    pub radius: f32,
}

impl Sphere {
    /// Creates a sphere of radius 0.
    pub fn point(center: [f32; 3]) -> Self {
        Self { center, radius: 0.0 }
    }

    /// Enlarges the sphere to contain a point, keeping its center.
    #[must_use]
    pub fn with_point(self, point: [f32; 3]) -> Self {
        self.with_sphere(&Self::point(point))
    }

    /// Enlarges the sphere to contain another sphere, keeping its center.
    #[must_use]
    pub fn with_sphere(self, other: &Self) -> Self {
        let reach = distance(self.center, other.center) + other.radius;
        // Compensates for the rounding of the distance.
        Self { radius: self.radius.max(reach * (1.0 + SLACK)), ..self }
    }

    /// Whether the sphere contains a point.
    pub fn contains(&self, point: [f32; 3]) -> bool {
        distance(self.center, point) <= self.radius
    }
}

/// Distance between two points, computed in f64 so that its square cannot overflow.
fn distance(a: [f32; 3], b: [f32; 3]) -> f32 {
    let d = Vec3::from(a).as_dvec3() - Vec3::from(b).as_dvec3();
    d.length() as f32
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::Random;

    #[test]
    fn spheres_contain_everything_added_to_them() {
        let mut random = Random::new(1);
        let mut point = |scale: f32| [(); 3].map(|()| (random.unit() as f32 - 0.5) * scale);
        for scale in [1e-7, 1.0, 1e7, 1e25] {
            let points: Vec<[f32; 3]> = (0..50).map(|_| point(scale)).collect();
            let inner = points[1..].iter().fold(Sphere::point(points[0]), |s, &p| s.with_point(p));
            assert!(points.iter().all(|&p| inner.contains(p)), "{inner:?}");
            let outer = Sphere::point(point(scale)).with_sphere(&inner);
            assert!(points.iter().all(|&p| outer.contains(p)), "{outer:?}");
            assert!(outer.with_sphere(&inner) == outer, "adding a contained sphere changes nothing");
        }
    }
}
