// Writes the uploaded motions of vertices to where the vertex shader reads them.

// Count, followed by three words per move: the vertex, its target, its factor.
@group(0) @binding(0) var<storage, read> moves: array<u32>;
@group(0) @binding(1) var<storage, read_write> motions: array<vec2<u32>>;

@compute @workgroup_size(64)
fn scatter(
    @builtin(workgroup_id) group: vec3<u32>,
    @builtin(num_workgroups) groups: vec3<u32>,
    @builtin(local_invocation_index) thread: u32,
) {
    let index = (group.x + group.y * groups.x) * 64u + thread;
    if index < moves[0] {
        let at = 1u + 3u * index;
        motions[moves[at]] = vec2(moves[at + 1u], moves[at + 2u]);
    }
}
