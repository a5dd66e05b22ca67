//! Camera, environment and lights as the shader reads them.

use bytemuck::{Pod, Zeroable};
use glam::{DVec3, Vec3};
use striata_scene::drawn::{Light, LightKind};

use crate::camera::Camera;
use crate::environment::Environment;

/// Largest number of lights in a frame.
pub(crate) const MAX_LIGHT_COUNT: usize = 32;

/// Uniform data of a frame, laid out as in `frame.wgsl`.
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
#[repr(C)]
pub(crate) struct FrameData {
    clip_from_eye: [[f32; 4]; 4],
    screen_axes: [[f32; 4]; 3],
    ground: [f32; 4],
    sky: [f32; 4],
    lobe_axes: [[f32; 4]; 3],
    lobe_colors: [[f32; 4]; 3],
    lights: [LightData; MAX_LIGHT_COUNT],
}

/// Uniform data of a light.
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
#[repr(C)]
struct LightData {
    position: [f32; 4],
    toward: [f32; 4],
    color: [f32; 4],
    cone: [f32; 4],
}

impl FrameData {
    pub(crate) fn new(
        camera: &Camera,
        size: [u32; 2],
        near: f64,
        environment: &Environment,
        lights: &[Light],
    ) -> Self {
        let (axes, eye) = (camera.axes(), camera.eye_64());
        let with = |[x, y, z]: [f32; 3], w: f32| [x, y, z, w];
        let mut of_lights = [LightData::zeroed(); MAX_LIGHT_COUNT];
        for (data, light) in of_lights.iter_mut().zip(lights) {
            *data = LightData::new(light, eye);
        }
        let light_count = lights.len().min(MAX_LIGHT_COUNT) as f32;
        let axis = |direction: [f32; 3]| Vec3::from(direction).normalize_or(Vec3::Y).to_array();
        Self {
            clip_from_eye: camera.clip_from(eye, near, size).to_cols_array_2d(),
            screen_axes: axes.map(|axis| with(axis.as_vec3().to_array(), 0.0)),
            ground: with(environment.ground, 0.0),
            sky: with(environment.sky, light_count),
            lobe_axes: environment.lobes.map(|lobe| with(axis(lobe.direction), 0.0)),
            lobe_colors: environment.lobes.map(|lobe| with(lobe.color, 0.0)),
            lights: of_lights,
        }
    }
}

impl LightData {
    fn new(light: &Light, eye: DVec3) -> Self {
        let [x, y, z] = (DVec3::from(light.position.map(f64::from)) - eye).as_vec3().to_array();
        let [red, green, blue] = light.color;
        let [i, j, k] = (-Vec3::from(light.direction)).normalize_or(Vec3::Y).to_array();
        let (kind, outer, inner) = match light.kind {
            LightKind::Directional => (0.0, 0.0, 0.0),
            LightKind::Point => (1.0, 0.0, 0.0),
            // The falloff needs some width.
            LightKind::Spot { inner_cos, outer_cos } => (2.0, outer_cos, inner_cos.max(outer_cos + 1e-4)),
        };
        Self {
            position: [x, y, z, light.range.unwrap_or(0.0)],
            toward: [i, j, k, kind],
            color: [red, green, blue, outer],
            cone: [inner, 0.0, 0.0, 0.0],
        }
    }
}
