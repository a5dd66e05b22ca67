// Individual triangles read from storage buffers, each with a color and with edges found per pixel.

@group(1) @binding(0) var<storage, read> positions: array<f32>;
@group(1) @binding(1) var<storage, read> normals: array<f32>;
@group(1) @binding(2) var<storage, read> colors: array<vec2<u32>>;
@group(1) @binding(3) var<storage, read> indices: array<u32>;
@group(1) @binding(4) var<storage, read> triangle_colors: array<u32>;

struct Corner {
    @builtin(position) clip: vec4<f32>,
    @location(0) position: vec3<f32>,
    @location(1) normal: vec3<f32>,
    @location(2) color: vec3<f32>,
    @location(3) weights: vec3<f32>,
}

@vertex
fn vertex(@builtin(vertex_index) index: u32) -> Corner {
    let v = indices[index];
    let point = vec3(positions[3u * v], positions[3u * v + 1u], positions[3u * v + 2u]);
    var out: Corner;
    out.clip = scene.clip_from_model * vec4(point, 1.0);
    out.position = point;
    out.normal = vec3(normals[3u * v], normals[3u * v + 1u], normals[3u * v + 2u]);
    out.color = scene.base.rgb;
    if scene.flags.x == 1u {
        out.color = min(vec3(unpack2x16float(colors[v].x), unpack2x16float(colors[v].y).x), vec3(1.0));
    }
    let own = unpack4x8unorm(triangle_colors[index / 3u]);
    out.color = mix(out.color, own.rgb, own.a);
    let corner = index % 3u;
    out.weights = vec3(f32(corner == 0u), f32(corner == 1u), f32(corner == 2u));
    return out;
}

@fragment
fn fragment(in: Corner) -> @location(0) vec4<f32> {
    let color = lit(in.color, in.position, in.normal);
    // Distance to each edge in pixels; a line extends half its width to each side of an edge.
    let distance = in.weights / max(fwidth(in.weights), vec3(1e-12));
    let nearest = min(distance.x, min(distance.y, distance.z));
    let line = 1.0 - smoothstep(0.0, 1.0, nearest - 0.5 * scene.up.w + 0.5);
    return vec4(mix(color, scene.edges.rgb, line * scene.edges.a), 1.0);
}
