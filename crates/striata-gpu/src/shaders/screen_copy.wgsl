// Encodes a picture in linear light as sRGB.

@group(0) @binding(0) var picture: texture_2d<f32>;

@vertex
fn vertex(@builtin(vertex_index) index: u32) -> @builtin(position) vec4<f32> {
    // One triangle that covers the whole picture.
    let corner = vec2(f32(index & 1u), f32(index >> 1u));
    return vec4(4.0 * corner - 1.0, 0.0, 1.0);
}

fn encoded(light: f32) -> f32 {
    let x = clamp(light, 0.0, 1.0);
    return select(1.055 * pow(x, 1.0 / 2.4) - 0.055, 12.92 * x, x <= 0.0031308);
}

@fragment
fn fragment(@builtin(position) position: vec4<f32>) -> @location(0) vec4<f32> {
    let light = textureLoad(picture, vec2<u32>(position.xy), 0);
    return vec4(encoded(light.r), encoded(light.g), encoded(light.b), light.a);
}
