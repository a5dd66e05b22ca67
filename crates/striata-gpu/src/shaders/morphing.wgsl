// Moves vertices between two levels, as `Geomorph` and `FanMorphs` do on the CPU. Concatenated after
// surface.wgsl.

@group(1) @binding(0) var<storage, read> positions: array<f32>;
@group(1) @binding(1) var<storage, read> normals: array<f32>;
@group(1) @binding(2) var<storage, read> colors: array<u32>;
// Per vertex: x: the vertex it moves from or to, itself if at rest; y: factor, as float bits, 1 at its own
// position.
@group(1) @binding(3) var<storage, read> motions: array<vec2<u32>>;
// x: blend of a morph between two levels, 0 to 1.
@group(1) @binding(4) var<uniform> blend: vec4<f32>;

// Codes instead of a factor: the vertex follows the blend, or one minus the blend.
const APPEARS = 2.0;
const VANISHES = 3.0;

struct VertexState {
    position: vec3<f32>,
    normal: vec3<f32>,
    color: vec3<f32>,
}

fn stored(v: u32) -> VertexState {
    return VertexState(
        vec3(positions[3u * v], positions[3u * v + 1u], positions[3u * v + 2u]),
        vec3(normals[3u * v], normals[3u * v + 1u], normals[3u * v + 2u]),
        light_of(unpack4x8unorm(colors[v]).rgb),
    );
}

fn mixed(here: VertexState, there: VertexState, factor: f32) -> VertexState {
    var out: VertexState;
    out.position = mix(here.position, there.position, factor);
    out.color = mix(here.color, there.color, factor);
    // Normals are renormalized; if opposite ones cancel out, the nearer one is used.
    let normal = mix(here.normal, there.normal, factor);
    let length = length(normal);
    out.normal = select(here.normal, there.normal, factor >= 0.5);
    if factor > 0.0 && factor < 1.0 && length > 1e-6 {
        out.normal = normal / length;
    }
    return out;
}

fn blended(v: u32) -> VertexState {
    let motion = motions[v];
    if motion.x == v {
        return stored(v);
    }
    let factor = bitcast<f32>(motion.y);
    if factor > 1.0 {
        // Between two levels, the target counts at its stored position.
        return mixed(stored(motion.x), stored(v), select(1.0 - blend.x, blend.x, factor == APPEARS));
    }
    // The target may be moving too: start from the first target at rest and blend towards each vertex of
    // the chain in turn.
    var count = 0u;
    var root = v;
    while motions[root].x != root {
        root = motions[root].x;
        count += 1u;
    }
    var out = stored(root);
    for (; count > 0u; count--) {
        var current = v;
        for (var i = 1u; i < count; i++) {
            current = motions[current].x;
        }
        out = mixed(out, stored(current), bitcast<f32>(motions[current].y));
    }
    return out;
}

@vertex
fn morphing(@builtin(vertex_index) index: u32, @builtin(instance_index) group: u32) -> Corner {
    let current = blended(index);
    return corner(current.position, current.normal, current.color, group);
}
