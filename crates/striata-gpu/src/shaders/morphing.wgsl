// Vertices on their way between two levels, as `Geomorph` and `FanMorphs` say. Behind surface.wgsl.

@group(1) @binding(0) var<storage, read> positions: array<f32>;
@group(1) @binding(1) var<storage, read> normals: array<f32>;
@group(1) @binding(2) var<storage, read> colors: array<u32>;
// Of each vertex: where it comes from or goes to, itself where it is at rest; and how far it is at its own place.
@group(1) @binding(3) var<storage, read> places: array<vec2<u32>>;
// x: how far a morph between whole levels is.
@group(1) @binding(4) var<uniform> blend: vec4<f32>;

// Instead of how far a vertex is: as far as the blend, or as the blend is from its end.
const APPEARS = 2.0;
const VANISHES = 3.0;

struct Shown {
    position: vec3<f32>,
    normal: vec3<f32>,
    color: vec4<f32>,
}

fn own(v: u32) -> Shown {
    return Shown(
        vec3(positions[3u * v], positions[3u * v + 1u], positions[3u * v + 2u]),
        vec3(normals[3u * v], normals[3u * v + 1u], normals[3u * v + 2u]),
        unpack4x8unorm(colors[v]),
    );
}

fn mixed(here: Shown, there: Shown, factor: f32) -> Shown {
    var out: Shown;
    out.position = mix(here.position, there.position, factor);
    out.color = mix(here.color, there.color, factor);
    // Normals keep their length; opposite ones meet in nothing.
    let normal = mix(here.normal, there.normal, factor);
    let length = length(normal);
    out.normal = select(here.normal, there.normal, factor >= 0.5);
    if factor > 0.0 && factor < 1.0 && length > 1e-6 {
        out.normal = normal / length;
    }
    return out;
}

fn shown(v: u32) -> Shown {
    let place = places[v];
    if place.x == v {
        return own(v);
    }
    let factor = bitcast<f32>(place.y);
    if factor > 1.0 {
        // Between whole levels a target counts where it stands.
        return mixed(own(place.x), own(v), select(1.0 - blend.x, blend.x, factor == APPEARS));
    }
    // A target may be on its way, too: from the first that stands, each is mixed with the one that comes from it.
    var count = 0u;
    var root = v;
    while places[root].x != root {
        root = places[root].x;
        count += 1u;
    }
    var out = own(root);
    for (; count > 0u; count--) {
        var at = v;
        for (var i = 1u; i < count; i++) {
            at = places[at].x;
        }
        out = mixed(out, own(at), bitcast<f32>(places[at].y));
    }
    return out;
}

@vertex
fn morphing(@builtin(vertex_index) number: u32, @builtin(instance_index) group: u32) -> Corner {
    let at = shown(number);
    return corner(at.position, at.normal, at.color, group);
}
