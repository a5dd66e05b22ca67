// Refines many instances of several meshes for one camera, without any history: decides every step from its box and
// the camera, within a triangle budget, and writes the triangles. Follows `fan_rules.wgsl`.
//
// The decision repeats `striata::view::GridCamera` in the same integers, so both agree bit by bit.

struct CrowdParameters {
    instance_count: u32,
    // Number of indices that fit.
    capacity: u32,
    triangle_limit: u32,
    // 1 if indirect draws can pass the instance to the shader as the first instance.
    passes_instance: u32,
    // Most workgroups along one dimension of a dispatch.
    row: u32,
    // Number of chunks that fit into the list of work; blocks follow them.
    chunk_capacity: u32,
    unused_x: u32,
    unused_y: u32,
}

struct StepBox {
    // Least and largest coordinate along each axis, 16 bits each.
    sides: array<u32, 3>,
    // Least and largest component of the normals along x and y, 8 bits each.
    normals: u32,
    // The same along z, then 16 bits of the error.
    normals_and_error: u32,
    added: i32,
}

struct GridCamera {
    turn: array<i32, 9>,
    low: array<i32, 3>,
    high: array<i32, 3>,
    shift: u32,
    half: array<i32, 2>,
    stretch_limit: u32,
    scale: i32,
    eye_low: array<i32, 3>,
    eye_high: array<i32, 3>,
    eye_shift: u32,
}

struct CrowdMesh {
    first_step: u32,
    step_count: u32,
    first_range: u32,
    range_count: u32,
    first_block: u32,
    block_count: u32,
    base_vertex: u32,
    base_triangles: u32,
    whole: StepBox,
}

struct CrowdInstance {
    camera: GridCamera,
    mesh: u32,
    first_bits: u32,
}

struct InstanceState {
    // Ranges of 32 steps that have to be evaluated; all later steps are collapsed.
    range_count: u32,
    triangle_count: atomic<i32>,
    first_triangle: u32,
    written: atomic<u32>,
    first_bits: u32,
    step_limit: u32,
}

struct Budget {
    base_triangles: atomic<u32>,
    threshold: i32,
    // Triangles that the steps of each class of weights add.
    classes: array<atomic<i32>, CLASSES>,
}

@group(0) @binding(0) var<uniform> parameters: CrowdParameters;
// First fan and fan count.
@group(0) @binding(3) var<storage, read> blocks: array<vec2<u32>>;
@group(0) @binding(11) var<storage, read> boxes: array<StepBox>;
// Largest error of each range of 32 steps and all steps after it.
@group(0) @binding(12) var<storage, read> range_errors: array<u32>;
@group(0) @binding(13) var<storage, read> meshes: array<CrowdMesh>;
@group(0) @binding(14) var<storage, read> instances: array<CrowdInstance>;
// Writable binding of `collapsed`, for the pass that decides.
@group(0) @binding(15) var<storage, read_write> decided: array<u32>;
@group(0) @binding(16) var<storage, read_write> states: array<InstanceState>;
@group(0) @binding(17) var<storage, read_write> budget: Budget;
// Work of the passes after `plan`: for chunks of steps and for blocks of fans, the size of the dispatch and the number
// of items; then an instance and a chunk for each item, and an instance and a block.
@group(0) @binding(18) var<storage, read_write> listed: array<atomic<u32>>;
// Read-only binding of `listed`.
@group(0) @binding(19) var<storage, read> work: array<u32>;
// Index count, instance count, first index, base vertex, first instance.
@group(0) @binding(9) var<storage, read_write> commands: array<array<u32, 5>>;

const CLASSES = 1024u;
const CLASS_SHIFT = 6u;
const RANGE = 32u;

// Ranges of 32 steps in a chunk, which one workgroup decides.
const CHUNK = 64u;

// Words before the items of the list of work, and the places of the counts.
const HEADER = 8u;
const CHUNK_COUNT = 3u;
const BLOCK_COUNT = 7u;

// Constants of `GridCamera::weigh` and its logarithm.
const MOST = 65535;
const STEEPEST = 16384;
const EXCESS = 8;
const LACK = 10;

var<private> camera: GridCamera;

fn low_half(word: u32) -> i32 { return (bitcast<i32>(word) << 16u) >> 16u; }
fn high_half(word: u32) -> i32 { return bitcast<i32>(word) >> 16u; }
fn signed_byte(word: u32, at: u32) -> i32 { return (bitcast<i32>(word) << (24u - 8u * at)) >> 24u; }

// Approximates 1,024 times the logarithm to base 2; never falls as `x` grows.
fn log_of(x: u32) -> i32 {
    let octave = 31u - countLeadingZeros(max(x, 1u));
    let f = ((x << (31u - octave)) >> 19u) & 4095u;
    let part = f * (4096u * 128u) + 44u * f * (4096u - f);
    return i32((octave << 10u) + (part >> 21u));
}

// Least and largest coordinate of a box in the view.
fn seen(row: u32, sides: array<u32, 3>) -> vec2<i32> {
    let low = vec3(low_half(sides[0]), low_half(sides[1]), low_half(sides[2]));
    let high = vec3(high_half(sides[0]), high_half(sides[1]), high_half(sides[2]));
    let turn = vec3(camera.turn[3u * row], camera.turn[3u * row + 1u], camera.turn[3u * row + 2u]);
    let middles = turn * (low + high);
    let reaches = abs(turn) * (high - low);
    let middle = middles.x + middles.y + middles.z;
    let reach = reaches.x + reaches.y + reaches.z;
    return vec2(
        ((middle - reach) >> camera.shift) + camera.low[row],
        camera.high[row] - ((-(middle + reach)) >> camera.shift),
    );
}

fn is_outside(across: vec2<i32>, half: i32, deepest: i32) -> bool {
    let limit = half * deepest;
    return half < STEEPEST && ((across.x << 10u) > limit || ((-across.y) << 10u) > limit);
}

fn may_see(x: vec2<i32>, y: vec2<i32>, depth: vec2<i32>) -> bool {
    return depth.y > 0 && !is_outside(x, camera.half[0], depth.y) && !is_outside(y, camera.half[1], depth.y);
}

fn least_product(side: u32, eye_low: i32, eye_high: i32, low: i32, high: i32) -> i32 {
    let nearest = (low_half(side) >> camera.eye_shift) - eye_high;
    let farthest = -((-high_half(side)) >> camera.eye_shift) - eye_low;
    return min(min(nearest * low, nearest * high), min(farthest * low, farthest * high));
}

fn is_turned_away(part: StepBox) -> bool {
    let xy = part.normals;
    let z = part.normals_and_error;
    if signed_byte(xy, 0u) > signed_byte(xy, 1u) {
        return true;
    }
    let eye_low = camera.eye_low;
    let eye_high = camera.eye_high;
    let least = least_product(part.sides[0], eye_low[0], eye_high[0], signed_byte(xy, 0u), signed_byte(xy, 1u))
        + least_product(part.sides[1], eye_low[1], eye_high[1], signed_byte(xy, 2u), signed_byte(xy, 3u))
        + least_product(part.sides[2], eye_low[2], eye_high[2], signed_byte(z, 0u), signed_byte(z, 1u));
    return least > 0;
}

fn square(x: i32) -> u32 {
    let length = u32(abs(x));
    return length * length;
}

fn weigh(part: StepBox) -> i32 {
    let error = i32(part.normals_and_error >> 16u);
    if error == 0 {
        return 0;
    }
    let x = seen(0u, part.sides);
    let y = seen(1u, part.sides);
    let depth = seen(2u, part.sides);
    if !may_see(x, y, depth) || is_turned_away(part) {
        return 0;
    }
    if depth.x <= 0 || error == MOST {
        return MOST;
    }
    let across = square(max(abs(x.x), abs(x.y))) + square(max(abs(y.x), abs(y.y)));
    let tangent = min(across / max(square(depth.x) >> 12u, 1u) + 1u, camera.stretch_limit);
    let stretch = (log_of(4096u + tangent) + LACK - 12 * 1024 + 1) >> 1u;
    let weight = error + camera.scale + stretch - (log_of(u32(depth.x)) - EXCESS);
    return clamp(weight, 0, MOST);
}

fn list(item: u32, instance: u32, part: u32) {
    atomicStore(&listed[HEADER + 2u * item], instance);
    atomicStore(&listed[HEADER + 2u * item + 1u], part);
}

// Finds out for each instance whether it can be seen, and the ranges of steps that have to be evaluated: those that
// would be refined if they were the whole mesh.
@compute @workgroup_size(ROW)
fn plan(@builtin(global_invocation_id) id: vec3<u32>) {
    let instance = id.x;
    if instance >= parameters.instance_count {
        return;
    }
    camera = instances[instance].camera;
    let mesh = meshes[instances[instance].mesh];
    var whole = mesh.whole;
    var triangles = 0u;
    if may_see(seen(0u, whole.sides), seen(1u, whole.sides), seen(2u, whole.sides)) {
        triangles = mesh.base_triangles;
    }
    // Errors fall from range to range.
    var found = 0u;
    var end = mesh.range_count;
    while found < end {
        let middle = (found + end) / 2u;
        whole.normals_and_error = (mesh.whole.normals_and_error & 0xffffu)
            | (range_errors[mesh.first_range + middle] << 16u);
        if weigh(whole) > 0 {
            found = middle + 1u;
        } else {
            end = middle;
        }
    }
    states[instance].range_count = found;
    states[instance].first_bits = instances[instance].first_bits;
    let step_end = min(RANGE * found, mesh.step_count);
    states[instance].step_limit = step_end;
    let chunks = (found + CHUNK - 1u) / CHUNK;
    let first_item = atomicAdd(&listed[CHUNK_COUNT], chunks);
    for (var chunk = 0u; chunk < chunks; chunk++) {
        list(first_item + chunk, instance, chunk);
    }
    if triangles != 0u {
        // Fans of a block come by ascending step.
        for (var at = mesh.first_block; at < mesh.first_block + mesh.block_count; at++) {
            if fans[blocks[at].x].w <= step_end {
                list(parameters.chunk_capacity + atomicAdd(&listed[BLOCK_COUNT], 1u), instance, at);
            }
        }
    }
    atomicStore(&states[instance].triangle_count, i32(triangles));
    atomicStore(&states[instance].written, 0u);
    atomicAdd(&budget.base_triangles, triangles);
}

// Sizes the dispatches of the listed work.
@compute @workgroup_size(1)
fn arrange() {
    for (var first = 0u; first < HEADER; first += 4u) {
        let count = atomicLoad(&listed[first + 3u]);
        atomicStore(&listed[first], min(count, parameters.row));
        atomicStore(&listed[first + 1u], (count + parameters.row - 1u) / parameters.row);
        atomicStore(&listed[first + 2u], 1u);
    }
}

// The steps that a thread evaluates, and the box of step 0 of their mesh.
struct StepRange {
    instance: u32,
    first_box: u32,
    first: u32,
    end: u32,
}

// Returns the range of a thread in an item of the list of work, which is empty if there is none, and sets the camera.
fn range_of(item: u32, thread: u32) -> StepRange {
    if item >= work[CHUNK_COUNT] {
        return StepRange();
    }
    let instance = work[HEADER + 2u * item];
    let range = CHUNK * work[HEADER + 2u * item + 1u] + thread;
    if range >= states[instance].range_count {
        return StepRange();
    }
    camera = instances[instance].camera;
    let mesh = meshes[instances[instance].mesh];
    return StepRange(instance, mesh.first_step, RANGE * range, min(RANGE * (range + 1u), mesh.step_count));
}

// Adds up the triangles of all steps by the class of their weight.
@compute @workgroup_size(ROW)
fn classify(
    @builtin(workgroup_id) group: vec3<u32>,
    @builtin(num_workgroups) groups: vec3<u32>,
    @builtin(local_invocation_index) thread: u32,
) {
    let own = range_of(group.x + group.y * groups.x, thread);
    if own.first == own.end {
        return;
    }
    for (var step = own.first; step < own.end; step++) {
        let part = boxes[own.first_box + step];
        let weight = weigh(part);
        if weight > 0 {
            atomicAdd(&budget.classes[u32(weight) >> CLASS_SHIFT], part.added);
        }
    }
}

// Finds the least threshold whose triangles fit.
@compute @workgroup_size(1)
fn choose() {
    var total = i32(atomicLoad(&budget.base_triangles));
    var threshold = 0;
    for (var at = CLASSES; at > 0u; at--) {
        total += atomicLoad(&budget.classes[at - 1u]);
        if total > i32(parameters.triangle_limit) {
            threshold = i32((at << CLASS_SHIFT) - 1u);
            break;
        }
    }
    budget.threshold = threshold;
}

// Decides 32 steps per thread.
@compute @workgroup_size(ROW)
fn decide(
    @builtin(workgroup_id) group: vec3<u32>,
    @builtin(num_workgroups) groups: vec3<u32>,
    @builtin(local_invocation_index) thread: u32,
) {
    let own = range_of(group.x + group.y * groups.x, thread);
    if own.first == own.end {
        return;
    }
    let threshold = budget.threshold;
    var word = 0u;
    var added = 0;
    for (var step = own.first; step < own.end; step++) {
        let part = boxes[own.first_box + step];
        if weigh(part) > threshold {
            added += part.added;
        } else {
            word |= 1u << (step & 31u);
        }
    }
    decided[states[own.instance].first_bits + own.first / RANGE] = word;
    atomicAdd(&states[own.instance].triangle_count, added);
}

// Runs in one workgroup: gives each instance its place among the triangles, and writes its draw.
@compute @workgroup_size(ROW)
fn place(@builtin(local_invocation_index) thread: u32) {
    var carried = 0u;
    for (var first = 0u; first < parameters.instance_count; first += BLOCK) {
        var own = vec4(0u);
        for (var row = 0u; row < 4u; row++) {
            let instance = first + row * ROW + thread;
            if instance < parameters.instance_count {
                own[row] = u32(max(atomicLoad(&states[instance].triangle_count), 0));
            }
        }
        let prefix = prefix_sum(thread, own);
        for (var row = 0u; row < 4u; row++) {
            let instance = first + row * ROW + thread;
            if instance < parameters.instance_count {
                let start = carried + prefix.before[row];
                states[instance].first_triangle = start;
                let first_index = min(3u * start, parameters.capacity);
                let end = min(3u * (start + own[row]), parameters.capacity);
                let base_vertex = meshes[instances[instance].mesh].base_vertex;
                commands[instance] = array<u32, 5>(
                    end - first_index, 1u, first_index, base_vertex, instance * parameters.passes_instance);
            }
        }
        carried += prefix.sum;
        // `scan` is overwritten in the next round.
        workgroupBarrier();
    }
}

var<workgroup> reserved: u32;

// Writes the triangles of a block of fans of one instance.
@compute @workgroup_size(ROW)
fn expand(
    @builtin(workgroup_id) group: vec3<u32>,
    @builtin(num_workgroups) groups: vec3<u32>,
    @builtin(local_invocation_index) thread: u32,
) {
    let item = group.x + group.y * groups.x;
    if item >= work[BLOCK_COUNT] {
        return;
    }
    let place = HEADER + 2u * (parameters.chunk_capacity + item);
    let instance = work[place];
    let block = blocks[work[place + 1u]];
    first_bits = states[instance].first_bits;
    step_limit = states[instance].step_limit;
    index_limit = parameters.capacity;
    var active_mask = vec4(0u);
    for (var row = 0u; row < 4u; row++) {
        if row * ROW + thread < block.y {
            active_mask[row] = active_arcs(fans[block.x + row * ROW + thread]);
        }
    }
    let slots = prefix_sum(thread, countOneBits(active_mask));
    if thread == 0u {
        reserved = states[instance].first_triangle + atomicAdd(&states[instance].written, slots.sum);
    }
    workgroupBarrier();
    for (var row = 0u; row < 4u; row++) {
        if active_mask[row] != 0u {
            write_fan(fans[block.x + row * ROW + thread], active_mask[row], 3u * (reserved + slots.before[row]));
        }
    }
}
