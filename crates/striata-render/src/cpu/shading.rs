//! Light that a point of a surface with a material sends to the eye.
//!
//! glTF's metallic-roughness in the light of the [`STUDIO`]: diffuse irradiance, reflections by the split
//! sum [Kar13] with multiple scattering [Fde19], and the lights of the document. `MeshStandardMaterial` of
//! three.js has the same terms, so that pictures can be compared.

use glam::Vec3;
use striata_scene::drawn::{Light, LightKind};

use crate::environment_table::STUDIO;
use crate::reflectance_table::split_sum;

/// Reflectance of dielectrics at normal incidence.
const DIELECTRIC: Vec3 = Vec3::splat(0.04);
/// Least roughness: perfect mirrors would show single lights as points.
pub(crate) const MIN_ROUGHNESS: f32 = 0.045;

/// A point of a surface, in world space.
#[derive(Clone, Copy, Debug)]
pub(crate) struct SurfacePoint {
    pub position: Vec3,
    /// Unit normal on the side of the eye, with the normal map applied.
    pub normal: Vec3,
    /// Unit vector to the eye.
    pub to_eye: Vec3,
    pub base_color: Vec3,
    pub metallic: f32,
    pub roughness: f32,
    /// Share of the surroundings that reach the point.
    pub occlusion: f32,
    pub emissive: Vec3,
}

/// Light that is reflected in all directions and toward the mirrored one.
struct Reflected {
    diffuse: Vec3,
    specular: Vec3,
}

/// Returns the radiance toward the eye.
pub(crate) fn shade(point: &SurfacePoint, lights: &[Light]) -> Vec3 {
    let view_cos = point.normal.dot(point.to_eye).clamp(0.0, 1.0);
    let scale_offset = split_sum(point.roughness, view_cos);
    let Reflected { diffuse, specular } = studio_light(point, scale_offset);
    let ao = point.occlusion;
    let mut sum = ao * diffuse + specular_occlusion(view_cos, ao, point.roughness) * specular;
    for light in lights {
        sum += punctual_light(point, light, scale_offset);
    }
    sum + point.emissive
}

/// Light of the studio.
fn studio_light(point: &SurfacePoint, scale_offset: [f32; 2]) -> Reflected {
    let SurfacePoint { normal, to_eye, base_color, metallic, roughness, .. } = *point;
    let mirrored = 2.0 * normal.dot(to_eye) * normal - to_eye;
    // Rough surfaces reflect around the normal rather than around the mirrored direction.
    let toward = mirrored.lerp(normal, roughness.powi(4)).normalize_or_zero();
    let radiance = STUDIO.radiance(toward, roughness);
    let irradiance = STUDIO.radiance(normal, 1.0);
    let dielectric = Scattering::of(DIELECTRIC, scale_offset);
    let metal = Scattering::of(base_color, scale_offset);
    let single = dielectric.single.lerp(metal.single, metallic);
    let multiple = dielectric.multiple.lerp(metal.multiple, metallic);
    let left = 1.0 - dielectric.single - dielectric.multiple;
    Reflected {
        diffuse: (1.0 - metallic) * base_color * left * irradiance,
        specular: radiance * single + irradiance * multiple,
    }
}

/// Shares of light that a rough surface reflects once and several times [Fde19].
struct Scattering {
    single: Vec3,
    multiple: Vec3,
}

impl Scattering {
    fn of(reflectance: Vec3, [scale, offset]: [f32; 2]) -> Self {
        let lost = 1.0 - (scale + offset);
        let single = reflectance * scale + offset;
        let average = reflectance + (1.0 - reflectance) / 21.0;
        Self { single, multiple: lost * single * average / (1.0 - lost * average) }
    }
}

/// Share of reflections that reach a point, from its ambient occlusion [LdR14].
fn specular_occlusion(view_cos: f32, occlusion: f32, roughness: f32) -> f32 {
    if occlusion >= 1.0 {
        return 1.0;
    }
    let exponent = (-16.0 * roughness - 1.0).exp2();
    ((view_cos + occlusion).powf(exponent) - 1.0 + occlusion).clamp(0.0, 1.0)
}

/// Light of the document that a point reflects to the eye.
fn punctual_light(point: &SurfacePoint, light: &Light, scale_offset: [f32; 2]) -> Vec3 {
    let Some((towards, color)) = arriving(point.position, light) else { return Vec3::ZERO };
    let SurfacePoint { normal, to_eye, base_color, metallic, .. } = *point;
    let light_cos = normal.dot(towards).clamp(0.0, 1.0);
    if light_cos == 0.0 {
        return Vec3::ZERO;
    }
    let square = point.roughness.max(MIN_ROUGHNESS).powi(4);
    let half = (towards + to_eye).normalize_or_zero();
    let [view_cos, half_cos] = [to_eye, half].map(|v| normal.dot(v).clamp(0.0, 1.0));
    let fresnel = (1.0 - to_eye.dot(half).clamp(0.0, 1.0)).powi(5);
    let reflectance = DIELECTRIC.lerp(base_color, metallic);
    let smith = |a: f32, b: f32| a * (square + (1.0 - square) * b * b).sqrt();
    let visibility = 0.5 / (smith(light_cos, view_cos) + smith(view_cos, light_cos)).max(1e-6);
    let spread = half_cos * half_cos * (square - 1.0) + 1.0;
    let distribution = square / (std::f32::consts::PI * spread * spread);
    let kept = (scale_offset[0] + scale_offset[1]).max(1e-3);
    let specular = (reflectance + (1.0 - reflectance) * fresnel) * visibility * distribution;
    let compensated = specular * (1.0 + reflectance * (1.0 / kept - 1.0));
    let through = 1.0 - (DIELECTRIC + (1.0 - DIELECTRIC) * fresnel);
    let diffuse = (1.0 - metallic) / std::f32::consts::PI * base_color * through;
    light_cos * color * (diffuse + compensated)
}

/// Direction to a light and the color that arrives at a position; [`None`] if none does.
fn arriving(position: Vec3, light: &Light) -> Option<(Vec3, Vec3)> {
    if light.kind == LightKind::Directional {
        return Some((-Vec3::from(light.direction), light.color.into()));
    }
    let offset = Vec3::from(light.position) - position;
    let distance = offset.length();
    let towards = offset.normalize_or_zero();
    let mut strength = 1.0 / (distance * distance).max(0.01);
    if let Some(range) = light.range {
        strength *= (1.0 - (distance / range).powi(4)).clamp(0.0, 1.0).powi(2);
    }
    if let LightKind::Spot { inner_cos, outer_cos } = light.kind {
        let cos = -towards.dot(light.direction.into());
        let t = ((cos - outer_cos) / (inner_cos - outer_cos).max(1e-6)).clamp(0.0, 1.0);
        strength *= t * t * (3.0 - 2.0 * t);
    }
    (strength > 0.0).then(|| (towards, strength * Vec3::from(light.color)))
}

#[cfg(test)]
mod tests {
    use super::*;

    const POINT: SurfacePoint = SurfacePoint {
        position: Vec3::ZERO,
        normal: Vec3::Y,
        to_eye: Vec3::Y,
        base_color: Vec3::splat(0.5),
        metallic: 0.0,
        roughness: 1.0,
        occlusion: 1.0,
        emissive: Vec3::ZERO,
    };

    #[test]
    fn a_rough_white_surface_keeps_nearly_all_light() {
        let irradiance = STUDIO.radiance(POINT.normal, 1.0);
        let white = shade(&SurfacePoint { base_color: Vec3::ONE, ..POINT }, &[]);
        for k in 0..3 {
            assert!((0.85..1.02).contains(&(white[k] / irradiance[k])), "{white:?} of {irradiance:?}");
        }
        let dark = shade(&SurfacePoint { occlusion: 0.0, emissive: Vec3::splat(0.25), ..POINT }, &[]);
        assert_eq!(dark, Vec3::splat(0.25));
    }

    #[test]
    fn a_metal_has_the_color_of_its_reflection() {
        let gold =
            SurfacePoint { base_color: Vec3::new(1.0, 0.7, 0.3), metallic: 1.0, roughness: 0.1, ..POINT };
        let seen = shade(&gold, &[]);
        let radiance = STUDIO.radiance(POINT.normal, 0.1);
        assert!((seen[0] / radiance[0] - 1.0).abs() < 0.03, "{seen:?} of {radiance:?}");
        assert!((seen[2] / radiance[2] - 0.3).abs() < 0.03, "{seen:?} of {radiance:?}");
    }

    #[test]
    fn lights_of_the_document_add_to_the_studio() {
        let light = Light {
            kind: LightKind::Point,
            color: [std::f32::consts::PI; 3],
            range: None,
            position: [0.0, 2.0, 0.0],
            direction: [0.0, -1.0, 0.0],
        };
        let added = |light: Light| shade(&POINT, &[light])[0] - shade(&POINT, &[])[0];
        // A quarter of the light at twice the distance; half of it is absorbed.
        assert!((added(light) - 0.5 * 0.25).abs() < 0.02, "{}", added(light));
        assert_eq!(added(Light { range: Some(1.5), ..light }), 0.0);
        let spot = |direction| Light {
            kind: LightKind::Spot { inner_cos: 0.9, outer_cos: 0.8 },
            direction,
            ..light
        };
        assert_eq!(added(spot([0.0, -1.0, 0.0])), added(light));
        assert_eq!(added(spot([1.0, 0.0, 0.0])), 0.0);
        let sun = Light { kind: LightKind::Directional, direction: [0.0, 1.0, 0.0], ..light };
        assert_eq!(added(sun), 0.0, "the light comes from below");
    }
}
