// Vertex stage: positions become relative to the eye.

struct Object {
    // Origin of the mesh relative to the eye.
    offset: vec4<f32>,
}

@group(2) @binding(0) var<uniform> object: Object;

struct Vertex {
    @location(0) position: vec3<f32>,
    @location(1) normal: vec3<f32>,
    @location(2) color: vec4<f32>,
    @location(3) tangent: vec4<f32>,
    @location(4) uv0: vec2<f32>,
    @location(5) uv1: vec2<f32>,
}

@vertex
fn vertex(in: Vertex) -> Surface {
    var out: Surface;
    out.position = in.position + object.offset.xyz;
    out.clip = frame.clip_from_eye * vec4(out.position, 1.0);
    out.normal = unit_or_zero(in.normal);
    out.tangent = vec4(unit_or_zero(in.tangent.xyz), in.tangent.w);
    out.uv = vec4(in.uv0, in.uv1);
    out.color = in.color;
    return out;
}

// A vector of length 1, or zero. The largest component is divided out first, so that squares neither
// overflow nor vanish.
fn unit_or_zero(v: vec3<f32>) -> vec3<f32> {
    let largest = max(max(abs(v.x), abs(v.y)), abs(v.z));
    if !(largest > 0.0) {
        return vec3(0.0);
    }
    return normalize(v / largest);
}
