// Material of a draw: factors, and textures with their coordinates.

// Rows of the transform of texture coordinates; the first row's w is the set of coordinates.
struct TextureUse {
    u: vec4<f32>,
    v: vec4<f32>,
}

struct Material {
    base_color: vec4<f32>,
    // w: occlusion strength.
    emissive: vec4<f32>,
    // Metallic, roughness, scale of the normal map, alpha cutoff.
    factors: vec4<f32>,
    // x: 1 if opaque, 2 if masked, 3 if blended; y: 1 if double-sided; z: 1 if unlit; w: one bit per texture
    // that there is, in the order of their bindings.
    flags: vec4<u32>,
    base_color_use: TextureUse,
    metallic_roughness_use: TextureUse,
    normal_use: TextureUse,
    occlusion_use: TextureUse,
    emissive_use: TextureUse,
}

const MASKED: u32 = 2u;
const BLENDED: u32 = 3u;

const HAS_BASE_COLOR: u32 = 1u;
const HAS_METALLIC_ROUGHNESS: u32 = 2u;
const HAS_NORMAL: u32 = 4u;
const HAS_OCCLUSION: u32 = 8u;
const HAS_EMISSIVE: u32 = 16u;

@group(1) @binding(0) var<uniform> material: Material;
@group(1) @binding(1) var base_color_texture: texture_2d<f32>;
@group(1) @binding(2) var metallic_roughness_texture: texture_2d<f32>;
@group(1) @binding(3) var normal_texture: texture_2d<f32>;
@group(1) @binding(4) var occlusion_texture: texture_2d<f32>;
@group(1) @binding(5) var emissive_texture: texture_2d<f32>;
@group(1) @binding(6) var base_color_sampler: sampler;
@group(1) @binding(7) var metallic_roughness_sampler: sampler;
@group(1) @binding(8) var normal_sampler: sampler;
@group(1) @binding(9) var occlusion_sampler: sampler;
@group(1) @binding(10) var emissive_sampler: sampler;

fn coordinates(used: TextureUse, uv: vec4<f32>) -> vec2<f32> {
    let at = select(uv.xy, uv.zw, used.u.w > 0.5);
    return vec2(dot(used.u.xy, at) + used.u.z, dot(used.v.xy, at) + used.v.z);
}

fn has(texture: u32) -> bool {
    return (material.flags.w & texture) != 0u;
}
