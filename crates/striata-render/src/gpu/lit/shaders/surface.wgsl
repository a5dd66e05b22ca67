// Fragment stage: normals, textures, and the color of a surface.

// The map's normal, turned from the frame of the texture coordinates into world axes.
fn mapped_normal(in: Surface, normal: vec3<f32>, side: f32, uv: vec2<f32>) -> vec3<f32> {
    let across = dpdx(in.position);
    let along = dpdy(in.position);
    let uv_across = dpdx(uv);
    let uv_along = dpdy(uv);
    var map = textureSample(normal_texture, normal_sampler, uv).xyz * 2.0 - 1.0;
    map = vec3(map.xy * material.factors.z, map.z);
    if in.tangent.w != 0.0 {
        let tangent = normalize(in.tangent.xyz);
        let smooth_normal = normalize(in.normal);
        let bitangent = cross(smooth_normal, tangent) * sign(in.tangent.w);
        return unit_or(side * (map.x * tangent + map.y * bitangent) + map.z * normal, normal);
    }
    // Gradients of the texture coordinates on the surface [Sch13]. Their sign must not depend on whether
    // rows of pixels count up or down.
    let facing = select(1.0, -1.0, dot(cross(across, along), -in.position) < 0.0);
    let for_across = cross(along, normal);
    let for_along = cross(normal, across);
    let tangent = for_across * uv_across.x + for_along * uv_along.x;
    let bitangent = for_across * uv_across.y + for_along * uv_along.y;
    let largest = max(dot(tangent, tangent), dot(bitangent, bitangent));
    let scale = select(facing * inverseSqrt(largest), 0.0, largest == 0.0);
    // Green points up in the image, against the direction of v.
    return unit_or(side * scale * (map.x * tangent - map.y * bitangent) + map.z * normal, normal);
}

fn unit_or(v: vec3<f32>, otherwise: vec3<f32>) -> vec3<f32> {
    let length_2 = dot(v, v);
    if !(length_2 > 1e-30) {
        return otherwise;
    }
    return v * inverseSqrt(length_2);
}

// The largest change of a normal from pixel to pixel makes a surface rougher, so that highlights do not
// flicker.
fn roughness_of_shape(normal: vec3<f32>) -> f32 {
    let axes = mat3x3(frame.screen_axes[0].xyz, frame.screen_axes[1].xyz, frame.screen_axes[2].xyz);
    let on_screen = normal * axes;
    let change = max(abs(dpdx(on_screen)), abs(dpdy(on_screen)));
    return max(max(change.x, change.y), change.z);
}

// Color and opacity of the surface before any light.
fn base_color(in: Surface) -> vec4<f32> {
    let color = material.base_color * in.color;
    if !has(HAS_BASE_COLOR) {
        return color;
    }
    let uv = coordinates(material.base_color_use, in.uv);
    return color * textureSample(base_color_texture, base_color_sampler, uv);
}

// Metallic and roughness.
fn metallic_roughness(uv: vec4<f32>) -> vec2<f32> {
    if !has(HAS_METALLIC_ROUGHNESS) {
        return material.factors.xy;
    }
    let at = coordinates(material.metallic_roughness_use, uv);
    return material.factors.xy * textureSample(metallic_roughness_texture, metallic_roughness_sampler, at).bg;
}

// Visible part of the surroundings.
fn visible_part(uv: vec4<f32>) -> f32 {
    if !has(HAS_OCCLUSION) {
        return 1.0;
    }
    let at = coordinates(material.occlusion_use, uv);
    return 1.0 + material.emissive.w * (textureSample(occlusion_texture, occlusion_sampler, at).r - 1.0);
}

fn emitted(uv: vec4<f32>) -> vec3<f32> {
    if !has(HAS_EMISSIVE) {
        return material.emissive.rgb;
    }
    let at = coordinates(material.emissive_use, uv);
    return material.emissive.rgb * textureSample(emissive_texture, emissive_sampler, at).rgb;
}

// The normal of the surface without its map, toward the viewer if the material is double-sided.
fn surface_normal(in: Surface, side: f32, to_eye: vec3<f32>) -> vec3<f32> {
    let face = cross(dpdx(in.position), dpdy(in.position));
    let toward_eye = select(face, -face, dot(face, to_eye) < 0.0);
    let length = max(max(abs(face.x), abs(face.y)), abs(face.z));
    let flat_normal = unit_or(toward_eye / max(length, 1e-37), to_eye);
    return select(flat_normal, side * unit_or(in.normal, flat_normal), dot(in.normal, in.normal) > 0.0);
}

@fragment
fn fragment(in: Surface, @builtin(front_facing) is_front: bool) -> @location(0) vec4<f32> {
    // All samples and derivatives come before anything that differs from pixel to pixel.
    let base = base_color(in);
    var r: Reflector;
    var light = base.rgb;
    if material.flags.z == 0u {
        let side = select(1.0, -1.0, material.flags.y == 1u && !is_front);
        r.to_eye = unit_or(-in.position, vec3(0.0, 0.0, 1.0));
        r.normal = surface_normal(in, side, r.to_eye);
        let shape_roughness = roughness_of_shape(r.normal);
        if has(HAS_NORMAL) {
            r.normal = mapped_normal(in, r.normal, side, coordinates(material.normal_use, in.uv));
        }
        let factors = metallic_roughness(in.uv);
        r.base_color = base.rgb;
        r.metallic = factors.x;
        r.diffuse = base.rgb * (1.0 - factors.x);
        // Below this roughness, highlights are smaller than a pixel.
        r.roughness = min(max(factors.y, 0.045) + shape_roughness, 1.0);
        r.visible = visible_part(in.uv);
        let at = vec2(r.roughness, saturate(dot(r.normal, r.to_eye)));
        r.reflectance = textureSampleLevel(reflectance_table, table_sampler, at, 0.0).xy;
        light = surrounding(r) + punctual(r, in.position) + emitted(in.uv);
    }
    if material.flags.x == MASKED && base.a < material.factors.w {
        discard;
    }
    return vec4(saturate(light), select(1.0, saturate(base.a), material.flags.x == BLENDED));
}
