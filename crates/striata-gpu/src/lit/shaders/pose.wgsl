// Vertex stage: morph targets, then the skin or the transform of the node.

struct Instance {
    // Rows of the matrix from the mesh to the eye; of vertices without joints if there is a skin.
    rows: array<vec4<f32>, 3>,
    // First texel of the joint matrices, number of joints, first texel of the morph weights, their number.
    poses: vec4<u32>,
    // x: number of vertices, y: displacements per vertex and target (position, normal, tangent),
    // z: 1 if the mesh has normals, w: 1 if it has tangents.
    mesh: vec4<u32>,
}

@group(2) @binding(0) var<uniform> instance: Instance;
// Joint matrices, 3 rows each, and pairs of target and weight; of all instances of the frame.
@group(2) @binding(1) var pose_texels: texture_2d<f32>;
// Displacements of all vertices: target by target, then position, normal, tangent.
@group(3) @binding(0) var morph_texels: texture_2d<f32>;

struct Vertex {
    @location(0) position: vec3<f32>,
    @location(1) normal: vec3<f32>,
    @location(2) tangent: vec4<f32>,
    @location(3) uv0: vec2<f32>,
    @location(4) uv1: vec2<f32>,
    @location(5) color: vec4<f32>,
    @location(6) joints0: vec4<u32>,
    @location(7) weights0: vec4<f32>,
    @location(8) joints1: vec4<u32>,
    @location(9) weights1: vec4<f32>,
    @builtin(vertex_index) index: u32,
}

fn pose_texel(index: u32) -> vec4<f32> {
    let width = textureDimensions(pose_texels).x;
    return textureLoad(pose_texels, vec2<u32>(index % width, index / width), 0);
}

fn morph_texel(index: u32) -> vec3<f32> {
    let width = textureDimensions(morph_texels).x;
    return textureLoad(morph_texels, vec2<u32>(index % width, index / width), 0).xyz;
}

// Sum of the joint matrices of a vertex, and of their weights.
struct Skin {
    rows: array<vec4<f32>, 3>,
    weight: f32,
}

fn with_joint(skin: Skin, joint: u32, weight: f32) -> Skin {
    // Joints that the skin does not have move nothing.
    if weight == 0.0 || joint >= instance.poses.y {
        return skin;
    }
    let first = instance.poses.x + 3u * joint;
    var out = skin;
    out.rows[0] += weight * pose_texel(first);
    out.rows[1] += weight * pose_texel(first + 1u);
    out.rows[2] += weight * pose_texel(first + 2u);
    out.weight += weight;
    return out;
}

fn with_joints(skin: Skin, joints: vec4<u32>, weights: vec4<f32>) -> Skin {
    var out = with_joint(skin, joints.x, weights.x);
    out = with_joint(out, joints.y, weights.y);
    out = with_joint(out, joints.z, weights.z);
    return with_joint(out, joints.w, weights.w);
}

// Rows of the matrix that moves a vertex.
fn rows_of(in: Vertex) -> array<vec4<f32>, 3> {
    if instance.poses.y == 0u {
        return instance.rows;
    }
    var skin: Skin;
    skin = with_joints(skin, in.joints0, in.weights0);
    skin = with_joints(skin, in.joints1, in.weights1);
    if skin.weight == 0.0 {
        return instance.rows;
    }
    for (var row = 0; row < 3; row++) {
        skin.rows[row] /= skin.weight;
    }
    return skin.rows;
}

@vertex
fn vertex(in: Vertex) -> Surface {
    var position = in.position;
    var normal = in.normal;
    var tangent = in.tangent.xyz;
    for (var entry = 0u; entry < instance.poses.w; entry++) {
        let target_weight = pose_texel(instance.poses.z + entry);
        let first = u32(target_weight.x) * instance.mesh.y * instance.mesh.x + in.index;
        position += target_weight.y * morph_texel(first);
        if instance.mesh.y > 1u {
            normal += target_weight.y * morph_texel(first + instance.mesh.x);
        }
        if instance.mesh.y > 2u {
            tangent += target_weight.y * morph_texel(first + 2u * instance.mesh.x);
        }
    }
    let rows = rows_of(in);
    let moved = vec4(position, 1.0);
    // Normals are transformed by the cofactors, which also exist if a scale is zero.
    let cofactors = array<vec3<f32>, 3>(
        cross(rows[1].xyz, rows[2].xyz),
        cross(rows[2].xyz, rows[0].xyz),
        cross(rows[0].xyz, rows[1].xyz),
    );
    let side = select(1.0, -1.0, dot(rows[0].xyz, cofactors[0]) < 0.0);
    var out: Surface;
    out.position = vec3(dot(rows[0], moved), dot(rows[1], moved), dot(rows[2], moved));
    out.clip = frame.clip_from_eye * vec4(out.position, 1.0);
    if instance.mesh.z == 1u {
        let turned = vec3(dot(cofactors[0], normal), dot(cofactors[1], normal), dot(cofactors[2], normal));
        out.normal = unit_or_zero(side * turned);
    }
    if instance.mesh.w == 1u {
        let along = vec3(dot(rows[0].xyz, tangent), dot(rows[1].xyz, tangent), dot(rows[2].xyz, tangent));
        out.tangent = vec4(unit_or_zero(along), select(-side, side, in.tangent.w > 0.0));
    }
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
