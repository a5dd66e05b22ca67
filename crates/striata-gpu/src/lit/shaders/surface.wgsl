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

fn output(color: vec3<f32>, opacity: f32) -> vec4<f32> {
    let light = saturate(color);
    if frame.ground.w < 0.5 {
        return vec4(light, opacity);
    }
    let encoded = select(1.055 * pow(light, vec3(1.0 / 2.4)) - 0.055, 12.92 * light, light <= vec3(0.0031308));
    return vec4(encoded, opacity);
}

// The largest change of a normal from pixel to pixel makes a surface rougher, so that highlights do not
// flicker.
fn roughness_of_shape(normal: vec3<f32>) -> f32 {
    let axes = mat3x3(frame.screen_axes[0].xyz, frame.screen_axes[1].xyz, frame.screen_axes[2].xyz);
    let on_screen = normal * axes;
    let change = max(abs(dpdx(on_screen)), abs(dpdy(on_screen)));
    return max(max(change.x, change.y), change.z);
}

@fragment
fn fragment(in: Surface, @builtin(front_facing) is_front: bool) -> @location(0) vec4<f32> {
    // All samples and derivatives come first: they need the neighboring pixels.
    var base = textureSample(base_color_texture, base_color_sampler, coordinates(material.base_color_use, in.uv));
    let metallic_roughness = textureSample(
        metallic_roughness_texture,
        metallic_roughness_sampler,
        coordinates(material.metallic_roughness_use, in.uv),
    );
    let occlusion =
        textureSample(occlusion_texture, occlusion_sampler, coordinates(material.occlusion_use, in.uv)).r;
    let emissive =
        textureSample(emissive_texture, emissive_sampler, coordinates(material.emissive_use, in.uv)).rgb;
    let face = cross(dpdx(in.position), dpdy(in.position));
    let to_eye = unit_or(-in.position, vec3(0.0, 0.0, 1.0));
    let toward_eye = select(face, -face, dot(face, to_eye) < 0.0);
    let side = select(1.0, -1.0, material.flags.y == 1u && !is_front);
    let flat_normal = normalize(toward_eye + vec3(0.0, 0.0, 1e-30));
    let normal = select(flat_normal, side * unit_or(in.normal, flat_normal), dot(in.normal, in.normal) > 0.0);
    let shape_roughness = roughness_of_shape(normal);
    let map_normal = mapped_normal(in, normal, side, coordinates(material.normal_use, in.uv));

    base *= material.base_color * in.color;
    if material.flags.x == MASKED && base.a < material.factors.w {
        discard;
    }
    let opacity = select(1.0, saturate(base.a), material.flags.x == BLENDED);
    if material.flags.z == 1u {
        return output(base.rgb, opacity);
    }
    var r: Reflector;
    r.normal = select(normal, map_normal, material.flags.w == 1u);
    r.to_eye = to_eye;
    r.base_color = base.rgb;
    r.metallic = material.factors.x * metallic_roughness.b;
    // Below this roughness, highlights are smaller than a pixel.
    r.roughness = min(max(material.factors.y * metallic_roughness.g, 0.045) + shape_roughness, 1.0);
    r.diffuse = base.rgb * (1.0 - r.metallic);
    r.visible = 1.0 + material.emissive.w * (occlusion - 1.0);
    let at = vec2(r.roughness, saturate(dot(r.normal, to_eye)));
    r.reflectance = textureSampleLevel(reflectance_table, table_sampler, at, 0.0).xy;
    let light = surrounding(r) + punctual(r, in.position) + material.emissive.rgb * emissive;
    return output(light, opacity);
}
