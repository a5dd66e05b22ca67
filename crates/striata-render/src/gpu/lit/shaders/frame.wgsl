// Bindings shared by the vertex and the fragment stage. Directions and positions are in world axes relative
// to the eye, so that scenes far from the origin keep their precision.

const PI: f32 = 3.14159265;

struct Light {
    // Position; w: range, or 0 if there is none.
    position: vec4<f32>,
    // Direction from the lit scene to the light; w: 0 directional, 1 point, 2 spot.
    toward: vec4<f32>,
    // Color times intensity; w: cosine of the outer cone angle.
    color: vec4<f32>,
    // x: cosine of the inner cone angle.
    cone: vec4<f32>,
}

struct Frame {
    clip_from_eye: mat4x4<f32>,
    // Rotation from world axes to those of the screen, row by row.
    screen_axes: array<vec4<f32>, 3>,
    // Radiance from below.
    ground: vec4<f32>,
    // Radiance from above; w: number of lights.
    sky: vec4<f32>,
    lobe_axes: array<vec4<f32>, 3>,
    lobe_colors: array<vec4<f32>, 3>,
    lights: array<Light, 32>,
}

@group(0) @binding(0) var<uniform> frame: Frame;
@group(0) @binding(1) var environment_table: texture_2d<f32>;
@group(0) @binding(2) var reflectance_table: texture_2d<f32>;
@group(0) @binding(3) var table_sampler: sampler;

struct Surface {
    @builtin(position) clip: vec4<f32>,
    // Relative to the eye.
    @location(0) position: vec3<f32>,
    // Zero if the mesh has no normals.
    @location(1) normal: vec3<f32>,
    // w: handedness, or 0 if the mesh has no tangents.
    @location(2) tangent: vec4<f32>,
    // Both sets of texture coordinates.
    @location(3) uv: vec4<f32>,
    @location(4) color: vec4<f32>,
}
