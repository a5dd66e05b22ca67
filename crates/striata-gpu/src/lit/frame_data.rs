//! Camera, environment and lights as the shader reads them.

use bytemuck::{Pod, Zeroable};
use glam::{DMat4, DVec3, DVec4, Vec3};

use crate::lit::environment::Environment;
use crate::lit::light::{LitLight, LitLightKind};
use crate::lit::object::LitCamera;

/// Largest number of lights in a frame.
pub(crate) const MAX_LIGHT_COUNT: usize = 32;

/// Distance of the near plane, as a share of the distance to the point that is looked at. Depth is reversed,
/// so a near plane this close costs no precision far away.
const NEAR_SHARE: f64 = 1e-3;

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
        camera: &LitCamera,
        [width, height]: [u32; 2],
        environment: &Environment,
        lights: &[LitLight],
    ) -> Self {
        let axes = screen_axes(camera);
        let aspect = f64::from(width.max(1)) / f64::from(height.max(1));
        let with = |[x, y, z]: [f32; 3], w: f32| [x, y, z, w];
        let mut of_lights = [LightData::zeroed(); MAX_LIGHT_COUNT];
        let eye = DVec3::from(camera.eye);
        for (data, light) in of_lights.iter_mut().zip(lights) {
            *data = LightData::new(light, eye);
        }
        let light_count = lights.len().min(MAX_LIGHT_COUNT) as f32;
        let axis = |direction: [f32; 3]| Vec3::from(direction).normalize_or(Vec3::Y).to_array();
        Self {
            clip_from_eye: clip_from_eye(camera, &axes, aspect).as_mat4().to_cols_array_2d(),
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
    fn new(light: &LitLight, eye: DVec3) -> Self {
        let [x, y, z] = (DVec3::from(light.position) - eye).as_vec3().to_array();
        let [red, green, blue] = light.color;
        let [i, j, k] = (-Vec3::from(light.direction)).normalize_or(Vec3::Y).to_array();
        let (kind, outer, inner) = match light.kind {
            LitLightKind::Directional => (0.0, 0.0, 0.0),
            LitLightKind::Point => (1.0, 0.0, 0.0),
            LitLightKind::Spot { inner_angle, outer_angle } => {
                // The falloff needs some width.
                let outer = outer_angle.cos();
                (2.0, outer, inner_angle.cos().max(outer + 1e-4))
            }
        };
        Self {
            position: [x, y, z, light.range.unwrap_or(0.0)],
            toward: [i, j, k, kind],
            color: [red, green, blue, outer],
            cone: [inner, 0.0, 0.0, 0.0],
        }
    }
}

/// Returns the axes of the screen: right, up, and toward the eye.
pub(crate) fn screen_axes(camera: &LitCamera) -> [DVec3; 3] {
    let back = (DVec3::from(camera.eye) - DVec3::from(camera.look_at)).normalize_or(DVec3::Z);
    let right = DVec3::from(camera.up).cross(back).normalize_or(back.any_orthonormal_vector());
    [right, back.cross(right), back]
}

/// Matrix from world axes around the eye to wgpu's clip space, with reversed depth: near is 1, infinitely far
/// is 0.
fn clip_from_eye(camera: &LitCamera, [right, up, back]: &[DVec3; 3], aspect: f64) -> DMat4 {
    let distance = (DVec3::from(camera.eye) - DVec3::from(camera.look_at)).length();
    let near = NEAR_SHARE * if distance > 0.0 && distance.is_finite() { distance } else { 1.0 };
    let high = 1.0 / (camera.fov.clamp(1e-4, 3.1) / 2.0).tan();
    let row = |axis: &DVec3, scale: f64| (scale * *axis).extend(0.0);
    let depth = DVec4::new(0.0, 0.0, 0.0, near);
    DMat4::from_cols(row(right, high / aspect), row(up, high), depth, row(back, -1.0)).transpose()
}
