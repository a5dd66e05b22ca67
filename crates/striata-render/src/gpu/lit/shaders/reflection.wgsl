// Light that a surface reflects: metallic-roughness as in glTF, with GGX, Smith's height-correlated shadowing
// [Hei14], the split sum [Kar13] and compensation for multiple scattering [Fde19], [Tur19].

struct Reflector {
    // Base color without metals, for diffuse light.
    diffuse: vec3<f32>,
    base_color: vec3<f32>,
    metallic: f32,
    roughness: f32,
    normal: vec3<f32>,
    to_eye: vec3<f32>,
    // Scale and offset of the reflectance at normal incidence.
    reflectance: vec2<f32>,
    // Part of the surroundings that is visible, 0 to 1.
    visible: f32,
}

// Reflectance of dielectrics at normal incidence.
const DIELECTRIC: f32 = 0.04;

fn channel_of_table(axis: vec3<f32>, direction: vec3<f32>, row: f32, channel: i32) -> f32 {
    let size = vec2<f32>(textureDimensions(environment_table));
    let at = vec2(0.5 + 0.5 * dot(axis, direction), row);
    let uv = (at * (size - 1.0) + 0.5) / size;
    return textureSampleLevel(environment_table, table_sampler, uv, 0.0)[channel];
}

// Radiance of the environment, averaged over the GGX lobe of a roughness. The environment is a sum of
// functions around an axis each, so a table of two dimensions holds all of it.
fn radiance(direction: vec3<f32>, roughness: f32) -> vec3<f32> {
    let row = roughness * (2.0 - roughness);
    let up = channel_of_table(vec3(0.0, 1.0, 0.0), direction, row, 0);
    var sum = mix(frame.ground.rgb, frame.sky.rgb, up);
    for (var lobe = 0; lobe < 3; lobe++) {
        if all(frame.lobe_colors[lobe].rgb == vec3(0.0)) {
            continue;
        }
        let strength = channel_of_table(frame.lobe_axes[lobe].xyz, direction, row, lobe + 1);
        sum += frame.lobe_colors[lobe].rgb * strength;
    }
    return sum;
}

// Single and multiple scattering of the specular layer under uniform light [Fde19].
struct Scattering {
    once: vec3<f32>,
    more: vec3<f32>,
}

fn scattering(at_normal: vec3<f32>, reflectance: vec2<f32>) -> Scattering {
    let once = at_normal * reflectance.x + reflectance.y;
    let rest = 1.0 - (reflectance.x + reflectance.y);
    let mean = at_normal + (1.0 - at_normal) / 21.0;
    return Scattering(once, once * mean / (1.0 - rest * mean) * rest);
}

// Light of the environment.
fn surrounding(r: Reflector) -> vec3<f32> {
    let mirrored = reflect(-r.to_eye, r.normal);
    let roughness_4 = r.roughness * r.roughness * r.roughness * r.roughness;
    // Rough surfaces reflect around a direction closer to their normal.
    let direction = normalize(mix(mirrored, r.normal, roughness_4));
    let sharp = radiance(direction, r.roughness);
    let diffuse_light = radiance(r.normal, 1.0);
    let dielectric = scattering(vec3(DIELECTRIC), r.reflectance);
    let metal = scattering(r.base_color, r.reflectance);
    let once = mix(dielectric.once, metal.once, r.metallic);
    let more = mix(dielectric.more, metal.more, r.metallic);
    let diffuse = r.diffuse * (1.0 - dielectric.once - dielectric.more) * diffuse_light;
    let specular = sharp * once + more * diffuse_light;
    let cosine = saturate(dot(r.normal, r.to_eye));
    // Specular occlusion by Lagarde and de Rousiers [LdR14].
    let open = pow(cosine + r.visible, exp2(-16.0 * r.roughness - 1.0)) - 1.0 + r.visible;
    return diffuse * r.visible + specular * saturate(open);
}

fn fresnel(at_normal: vec3<f32>, cosine: f32) -> vec3<f32> {
    let grazing = exp2((-5.55473 * cosine - 6.98316) * cosine);
    return at_normal * (1.0 - grazing) + grazing;
}

// Light from one direction that reaches the eye, for light of strength 1.
fn reflected(r: Reflector, to_light: vec3<f32>) -> vec3<f32> {
    let half_way = normalize(to_light + r.to_eye);
    let cosine_light = saturate(dot(r.normal, to_light));
    let cosine_eye = saturate(dot(r.normal, r.to_eye));
    let cosine_half = saturate(dot(r.normal, half_way));
    let cosine_between = saturate(dot(r.to_eye, half_way));
    let alpha = r.roughness * r.roughness;
    let alpha_2 = alpha * alpha;
    let shadowed_eye = cosine_light * sqrt(alpha_2 + (1.0 - alpha_2) * cosine_eye * cosine_eye);
    let shadowed_light = cosine_eye * sqrt(alpha_2 + (1.0 - alpha_2) * cosine_light * cosine_light);
    let visibility = 0.5 / max(shadowed_eye + shadowed_light, 1e-6);
    let spread = cosine_half * cosine_half * (alpha_2 - 1.0) + 1.0;
    let distribution = alpha_2 / (PI * spread * spread);
    let at_normal = mix(vec3(DIELECTRIC), r.base_color, r.metallic);
    // Equation 16 of [Tur19].
    let compensation = 1.0 + at_normal * (1.0 / (r.reflectance.x + r.reflectance.y) - 1.0);
    let specular = fresnel(at_normal, cosine_between) * (visibility * distribution) * compensation;
    let diffuse = r.diffuse / PI * (1.0 - fresnel(vec3(DIELECTRIC), cosine_between));
    return cosine_light * (specular + diffuse);
}

// Light of the punctual lights of the scene.
fn punctual(r: Reflector, position: vec3<f32>) -> vec3<f32> {
    var sum = vec3(0.0);
    for (var index = 0u; index < u32(frame.sky.w); index++) {
        let light = frame.lights[index];
        var to_light = light.toward.xyz;
        var strength = 1.0;
        if light.toward.w > 0.5 {
            let offset = light.position.xyz - position;
            let distance = length(offset);
            to_light = offset / max(distance, 1e-20);
            strength = 1.0 / max(distance * distance, 0.01);
            if light.position.w > 0.0 {
                let part = distance / light.position.w;
                let window = saturate(1.0 - part * part * part * part);
                strength *= window * window;
            }
        }
        if light.toward.w > 1.5 {
            strength *= smoothstep(light.color.w, light.cone.x, dot(to_light, light.toward.xyz));
        }
        sum += strength * light.color.rgb * reflected(r, to_light);
    }
    return sum;
}
