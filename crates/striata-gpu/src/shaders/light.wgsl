// What all shaders of surfaces share: the scene, and how light falls.

struct Scene {
    clip_from_model: mat4x4<f32>,
    // The eye, model space; w: how much light counts.
    eye: vec4<f32>,
    // Directions towards two lights, model space; w: their strengths.
    key: vec4<f32>,
    fill: vec4<f32>,
    // Which way is up, for light from the sky.
    up: vec4<f32>,
    // Color of what has no other.
    base: vec4<f32>,
    edges: vec4<f32>,
    // x: 1 where normals are the triangles', y: 1 where vertex colors count, z: 1 where groups do, w: 1 where
    // triangles have colors of their own.
    flags: vec4<u32>,
    // x: width of edges in pixels.
    numbers: vec4<f32>,
}

@group(0) @binding(0) var<uniform> scene: Scene;

// Hues along the golden ratio in two shades, as `palette_color` on the processor.
fn palette(number: u32) -> vec3<f32> {
    // Whole numbers keep the fraction exact for any number.
    let hue = f32((number * 2654435769u) >> 8u) / 16777216.0 * 6.0;
    let shade = select(0.60, 0.85, number % 2u == 0u);
    let place = (vec3(hue) + vec3(3.0, 1.0, 5.0)) % vec3(6.0);
    let amount = clamp(2.0 - abs(place - 3.0), vec3(0.0), vec3(1.0));
    return shade * (0.24 + 0.60 * amount);
}

fn lit(color: vec3<f32>, place: vec3<f32>, smooth_normal: vec3<f32>) -> vec3<f32> {
    let to_eye = scene.eye.xyz - place;
    let across = cross(dpdx(place), dpdy(place));
    var normal = smooth_normal;
    if scene.flags.x == 1u || dot(normal, normal) < 1e-12 {
        normal = across;
    }
    normal = normalize(normal + vec3(0.0, 0.0, 1e-30));
    // Both sides of a surface are lit: what looks away is turned around.
    let side = sign(dot(across, to_eye)) * sign(dot(across, normal));
    normal *= select(1.0, -1.0, side < 0.0);
    let key = max(dot(normal, scene.key.xyz), 0.0) * scene.key.w;
    let fill = max(dot(normal, scene.fill.xyz), 0.0) * scene.fill.w;
    let sky = 0.5 + 0.5 * dot(normal, scene.up.xyz);
    let half_way = normalize(normalize(to_eye) + scene.key.xyz);
    let gloss = 0.06 * pow(max(dot(normal, half_way), 0.0), 40.0);
    let light = 0.05 + 0.13 * sky + key + fill;
    return mix(color, color * light + gloss, scene.eye.w);
}
