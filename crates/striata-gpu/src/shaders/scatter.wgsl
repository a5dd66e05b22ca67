// Puts the places of vertices that move where the vertex shader finds them.

// How many; then of each: the vertex, where it comes from, how far it is.
@group(0) @binding(0) var<storage, read> moves: array<u32>;
@group(0) @binding(1) var<storage, read_write> places: array<vec2<u32>>;

@compute @workgroup_size(64)
fn scatter(
    @builtin(workgroup_id) group: vec3<u32>,
    @builtin(num_workgroups) groups: vec3<u32>,
    @builtin(local_invocation_index) thread: u32,
) {
    let number = (group.x + group.y * groups.x) * 64u + thread;
    if number < moves[0] {
        let at = 1u + 3u * number;
        places[moves[at]] = vec2(moves[at + 1u], moves[at + 2u]);
    }
}
