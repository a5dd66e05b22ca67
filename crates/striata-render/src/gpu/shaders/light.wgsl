// Shared by all surface shaders: the scene uniforms and the lighting.

struct Scene {
    clip_from_model: mat4x4<f32>,
    // Eye position, model space; w: strength of the lighting.
    eye: vec4<f32>,
    // Directions towards the key and fill lights, model space; w: their intensities.
    key: vec4<f32>,
    fill: vec4<f32>,
    // Up direction, for light from the sky; w: edge width in pixels.
    up: vec4<f32>,
    // Color of surfaces without colors of their own.
    base: vec4<f32>,
    edges: vec4<f32>,
    // x: 1 to show vertex colors, y: 1 to show groups.
    flags: vec4<u32>,
}

@group(0) @binding(0) var<uniform> scene: Scene;

// Hues spaced by the golden ratio in two shades, matching `palette_color` on the CPU.
fn palette(index: u32) -> vec3<f32> {
    // Integer arithmetic keeps the fraction exact for any index.
    let hue = f32((index * 2654435769u) >> 8u) / 16777216.0 * 6.0;
    let shade = select(0.60, 0.85, index % 2u == 0u);
    let hues = (vec3(hue) + vec3(3.0, 1.0, 5.0)) % vec3(6.0);
    let amount = clamp(2.0 - abs(hues - 3.0), vec3(0.0), vec3(1.0));
    return shade * (0.24 + 0.60 * amount);
}

fn lit(color: vec3<f32>, position: vec3<f32>, smooth_normal: vec3<f32>) -> vec3<f32> {
    let to_eye = scene.eye.xyz - position;
    let across = cross(dpdx(position), dpdy(position));
    var normal = smooth_normal;
    if dot(normal, normal) < 1e-12 {
        normal = across;
    }
    normal = normalize(normal + vec3(0.0, 0.0, 1e-30));
    // Both sides of a surface are lit: normals that face away are flipped.
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
