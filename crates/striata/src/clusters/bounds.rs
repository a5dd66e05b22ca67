//! Small spheres around points and other spheres.

use glam::Vec3;

use crate::view::Sphere;

/// Steps towards the farthest sphere; the radius is then within a few per cent of the smallest one.
const STEPS: usize = 24;

/// A sphere that contains all others [Badoiu and Clarkson 2003]; a point at the origin if there are none.
pub(super) fn enclosing(spheres: &[Sphere]) -> Sphere {
    let Some(first) = spheres.first() else { return Sphere::point([0.0; 3]) };
    let sum = spheres.iter().fold(glam::DVec3::ZERO, |sum, s| sum + Vec3::from(s.center).as_dvec3());
    let mut center = (sum / spheres.len() as f64).as_vec3();
    if !center.is_finite() {
        center = Vec3::from(first.center);
    }
    for step in 1..=STEPS {
        let reach = |s: &Sphere| center.distance(Vec3::from(s.center)) + s.radius;
        let mut farthest = (0.0, first);
        for sphere in spheres {
            let reach = reach(sphere);
            if reach > farthest.0 {
                farthest = (reach, sphere);
            }
        }
        let (reach, sphere) = farthest;
        let away = Vec3::from(sphere.center) - center;
        // The far side of the sphere, as a point.
        let target = away * (reach / away.length().max(f32::MIN_POSITIVE)).min(f32::MAX);
        let moved = center + target / (step as f32 + 1.0);
        if !moved.is_finite() || away == Vec3::ZERO {
            break;
        }
        center = moved;
    }
    spheres.iter().fold(Sphere::point(center.to_array()), |sphere, other| sphere.with_sphere(other))
}
