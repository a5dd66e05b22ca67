//! Cones of normals: the directions in which a part of a surface faces, as an axis and an angle.

use glam::DVec3;

use super::{Camera, Sphere};

/// Upper bound on the rounding error of cosines when a cone is built and stored as `f32`.
const SLACK: f64 = 1e-6;

/// All directions within some angle of an axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NormalCone {
    /// Axis, of length at most 1; arbitrary if the cone contains every direction.
    pub axis: [f32; 3],
    /// Cosine of the angle between the axis and the farthest direction; -1 if the cone contains every
    /// direction.
    pub cos: f32,
}

impl NormalCone {
    /// The cone of all directions.
    pub const ALL: Self = Self { axis: [0.0, 0.0, 1.0], cos: -1.0 };

    /// The cone of a single direction, of any length; [`ALL`](Self::ALL) if the direction is zero.
    pub fn around(direction: [f64; 3]) -> Self {
        DVec3::from(direction).try_normalize().map_or(Self::ALL, |axis| Self::rounded(axis, 1.0))
    }

    /// The cone of the normals of triangles, whose corners are in counterclockwise order.
    ///
    /// Triangles without area are ignored; if no others exist, the result is [`ALL`](Self::ALL).
    pub fn of_triangles(triangles: impl Iterator<Item = [[f32; 3]; 3]> + Clone) -> Self {
        let normals = || triangles.clone().filter_map(|corners| normal(&corners));
        let sum: DVec3 = normals().sum();
        let Some(axis) = sum.try_normalize() else { return Self::ALL };
        let cos = normals().map(|normal| normal.dot(axis)).fold(1.0, f64::min);
        Self::rounded(axis, cos)
    }

    /// The cone of unit normals; [`ALL`](Self::ALL) if there are none.
    pub fn of_normals(normals: impl Iterator<Item = [f64; 3]> + Clone) -> Self {
        let normals = || normals.clone().map(DVec3::from);
        let Some(axis) = normals().sum::<DVec3>().try_normalize() else { return Self::ALL };
        Self::rounded(axis, normals().map(|normal| normal.dot(axis)).fold(1.0, f64::min))
    }

    /// Enlarges the cone to contain another cone, keeping its axis.
    #[must_use]
    pub fn with_cone(self, other: &Self) -> Self {
        if self.cos <= -1.0 || other.cos <= -1.0 {
            return Self::ALL;
        }
        let between = angle_between_f32(self.axis, other.axis);
        match between.plus(Angle::of_cos(f64::from(other.cos))) {
            Some(reach) if reach.cos >= f64::from(self.cos) => self,
            Some(reach) => Self::rounded(direction(self.axis), reach.cos),
            None => Self::ALL,
        }
    }

    /// Whether the cone contains a direction, which may have any length.
    pub fn contains(&self, towards: [f32; 3]) -> bool {
        let Some(towards) = direction_of(towards) else { return false };
        self.cos <= -1.0 || towards.dot(direction(self.axis)) >= f64::from(self.cos)
    }

    /// Whether every triangle inside the sphere with a normal in the cone shows its back to the camera.
    pub fn is_turned_away(&self, sphere: &Sphere, camera: &Camera) -> bool {
        if self.cos <= 0.0 {
            return false;
        }
        // Seen from the eye, the part can extend this far from its center, and its normals this far from
        // the axis.
        let (sight, spread) = if camera.is_orthographic {
            (camera.forward, Angle::of_sin(0.0))
        } else {
            let eye_to_center = direction_f64(sphere.center) - camera.eye;
            let (distance, radius) = (eye_to_center.length(), f64::from(sphere.radius));
            if distance <= radius {
                return false;
            }
            (eye_to_center / distance, Angle::of_sin(radius / distance))
        };
        let facing = angle_between(sight, direction(self.axis));
        let turned = facing.plus(Angle::of_cos(f64::from(self.cos))).and_then(|angle| angle.plus(spread));
        turned.is_some_and(|angle| angle.cos > SLACK)
    }

    /// Rounds the cone to its stored form, which is never smaller.
    fn rounded(axis: DVec3, cos: f64) -> Self {
        let cos = (cos - SLACK).max(-1.0) as f32;
        Self { axis: axis.as_vec3().into(), cos }
    }
}

/// An angle from 0 to 180 degrees, given by its cosine and sine.
#[derive(Clone, Copy, Debug)]
struct Angle {
    cos: f64,
    sin: f64,
}

impl Angle {
    fn of_cos(cos: f64) -> Self {
        let cos = cos.clamp(-1.0, 1.0);
        Self { cos, sin: (1.0 - cos * cos).sqrt() }
    }

    /// The angle with this sine, up to 90 degrees.
    fn of_sin(sin: f64) -> Self {
        let sin = sin.clamp(0.0, 1.0);
        Self { cos: (1.0 - sin * sin).sqrt(), sin }
    }

    /// Sum of both angles; `None` above 180 degrees.
    fn plus(self, other: Self) -> Option<Self> {
        let sin = self.sin * other.cos + self.cos * other.sin;
        let cos = self.cos * other.cos - self.sin * other.sin;
        // The sine of more than 180 degrees is negative.
        (sin >= 0.0).then_some(Self { cos, sin })
    }
}

fn angle_between_f32(a: [f32; 3], b: [f32; 3]) -> Angle {
    angle_between(direction(a), direction(b))
}

fn angle_between(a: DVec3, b: DVec3) -> Angle {
    Angle::of_cos(a.dot(b))
}

/// Normalizes a direction that has been rounded.
fn direction(towards: [f32; 3]) -> DVec3 {
    direction_of(towards).unwrap_or(DVec3::Z)
}

fn direction_of(towards: [f32; 3]) -> Option<DVec3> {
    direction_f64(towards).try_normalize()
}

fn direction_f64([x, y, z]: [f32; 3]) -> DVec3 {
    DVec3::new(x.into(), y.into(), z.into())
}

/// Unit normal of a triangle; `None` if it has no area.
fn normal(corners: &[[f32; 3]; 3]) -> Option<DVec3> {
    let [a, b, c] = corners.map(direction_f64);
    (b - a).cross(c - a).try_normalize()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::Random;

    fn point(random: &mut Random, spread: f32) -> [f32; 3] {
        [(); 3].map(|()| (random.unit() as f32 - 0.5) * spread)
    }

    fn triangles(random: &mut Random, bend: f32) -> Vec<[[f32; 3]; 3]> {
        let corner = |random: &mut Random| {
            let [x, y, z] = point(random, 2.0);
            [x, y, z * bend]
        };
        (0..12)
            .map(|_| [(); 3].map(|()| corner(random)))
            .map(|[a, b, c]| {
                let faces_up = (b[0] - a[0]) * (c[1] - a[1]) > (b[1] - a[1]) * (c[0] - a[0]);
                if faces_up { [a, b, c] } else { [a, c, b] }
            })
            .collect()
    }

    fn normal_of(corners: &[[f32; 3]; 3]) -> [f32; 3] {
        normal(corners).map_or([0.0; 3], |n| n.as_vec3().into())
    }

    #[test]
    fn cones_contain_the_normals_of_their_triangles_and_of_added_cones() {
        let mut random = Random::new(2);
        for round in 0..200 {
            let bend = [0.01, 0.2, 1.0][round % 3];
            let [first, second] = [(); 2].map(|()| triangles(&mut random, bend));
            let [a, b] = [&first, &second].map(|t| NormalCone::of_triangles(t.iter().copied()));
            let both = a.with_cone(&b);
            for triangle in &first {
                assert!(a.contains(normal_of(triangle)) && both.contains(normal_of(triangle)));
            }
            assert!(
                second.iter().all(|triangle| both.contains(normal_of(triangle))),
                "{a:?} and {b:?}: {both:?}"
            );
        }
        assert_eq!(NormalCone::of_triangles(std::iter::empty()), NormalCone::ALL);
        let flat = [[0.0; 3], [1.0, 0.0, 0.0], [2.0, 0.0, 0.0]];
        assert_eq!(NormalCone::of_triangles([flat].into_iter()), NormalCone::ALL);
    }

    #[test]
    fn parts_turned_away_show_no_front_face() {
        let mut random = Random::new(3);
        let mut away = [0; 2];
        for round in 0..3000 {
            let surface = triangles(&mut random, [0.01, 0.1, 0.4][round % 3]);
            let cone = NormalCone::of_triangles(surface.iter().copied());
            let corners = surface.iter().flatten();
            let sphere = corners.fold(Sphere::point([0.0; 3]), |sphere, &corner| sphere.with_point(corner));
            let eye = point(&mut random, 20.0);
            let camera = Camera::new(eye, [0.1, 0.2, 0.3], [0.3, 1.0, 0.2], 0.5, [9, 9]).unwrap();
            let is_orthographic = round % 2 == 0;
            let camera = Camera { is_orthographic, ..camera };
            if !cone.is_turned_away(&sphere, &camera) {
                continue;
            }
            away[round % 2] += 1;
            for triangle in &surface {
                let [front, from] = [normal(triangle).unwrap_or(DVec3::ZERO), direction_f64(triangle[0])];
                let sight = if is_orthographic { camera.forward } else { from - direction_f64(eye) };
                assert!(front.dot(sight) >= 0.0, "seen from {eye:?}: {triangle:?}");
            }
        }
        assert!(away.iter().all(|count| *count > 150), "only {away:?} of 1,500 are turned away");
    }

    #[test]
    fn angles_above_180_degrees_give_the_cone_of_all_directions() {
        let cone = |cos: f32| NormalCone { axis: [0.0, 0.0, 1.0], cos };
        let down = NormalCone { axis: [0.0, 0.0, -1.0], cos: 0.5 };
        assert_eq!(cone(0.9).with_cone(&down), NormalCone::ALL);
        assert_eq!(cone(0.9).with_cone(&NormalCone::ALL), NormalCone::ALL);
        assert_eq!(cone(0.5).with_cone(&cone(0.9)), cone(0.5));
    }
}
