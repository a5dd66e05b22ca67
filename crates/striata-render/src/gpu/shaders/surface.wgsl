// Draws surfaces from vertex and index buffers. The instance index is the group of triangles.

struct Corner {
    @builtin(position) clip: vec4<f32>,
    @location(0) position: vec3<f32>,
    @location(1) normal: vec3<f32>,
    @location(2) color: vec3<f32>,
}

fn corner(position: vec3<f32>, normal: vec3<f32>, color: vec3<f32>, group: u32) -> Corner {
    var out: Corner;
    out.clip = scene.clip_from_model * vec4(position, 1.0);
    out.position = position;
    out.normal = normal;
    out.color = scene.base.rgb;
    if scene.flags.x == 1u {
        out.color = color;
    }
    if scene.flags.y == 1u {
        out.color = palette(group);
    }
    return out;
}

@vertex
fn vertex(
    @location(0) position: vec3<f32>,
    @location(1) normal: vec3<f32>,
    @location(2) color: vec4<f32>,
    @builtin(instance_index) group: u32,
) -> Corner {
    return corner(position, normal, min(color.rgb, vec3(1.0)), group);
}

@fragment
fn fragment(in: Corner) -> @location(0) vec4<f32> {
    return vec4(lit(in.color, in.position, in.normal), 1.0);
}
