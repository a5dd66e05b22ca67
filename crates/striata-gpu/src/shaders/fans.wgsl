// Progressive fans extracted: which arcs are there, where their triangles go, and the triangles.
//
// A workgroup takes a block of fans of one group, a thread four of them. Blocks are numbered along the dispatch's rows.

struct Terms {
    block_count: u32,
    group_count: u32,
    // Indices that fit.
    capacity: u32,
    // 1 where draws may tell the shader their group.
    tells_group: u32,
}

@group(0) @binding(0) var<uniform> terms: Terms;
// x: vertex, y: where its words begin, z: what the words hold, w: 1 + its own step, 0 in the base.
@group(0) @binding(1) var<storage, read> fans: array<vec4<u32>>;
@group(0) @binding(2) var<storage, read> words: array<u32>;
// First fan and number of fans.
@group(0) @binding(3) var<storage, read> blocks: array<vec2<u32>>;
// First block of each group, and one more.
@group(0) @binding(4) var<storage, read> group_blocks: array<u32>;
// A bit a step.
@group(0) @binding(5) var<storage, read> taken: array<u32>;
// Of each fan, the arcs that are there.
@group(0) @binding(6) var<storage, read_write> arcs: array<u32>;
// Of each block, how many; then how many are before it.
@group(0) @binding(7) var<storage, read_write> sums: array<u32>;
// The same, where nothing writes it.
@group(0) @binding(10) var<storage, read> firsts: array<u32>;
@group(0) @binding(8) var<storage, read_write> indices: array<u32>;
// Index count, instance count, first index, base vertex, first instance.
@group(0) @binding(9) var<storage, read_write> commands: array<array<u32, 5>>;

// Fans of a block stand in four rows; a thread takes one of each row, so that threads read side by side.
const ROW = 64u;
const BLOCK = 256u;

fn node_count(kinds: u32) -> u32 { return kinds & 63u; }
fn is_closed(kinds: u32) -> bool { return (kinds & 64u) != 0u; }
fn is_wide(kinds: u32) -> bool { return (kinds & 128u) != 0u; }
fn has_lasting(kinds: u32) -> bool { return (kinds & 256u) != 0u; }
fn maker_count(kinds: u32) -> u32 { return kinds >> 9u; }

fn is_taken(step: u32) -> u32 {
    return (taken[step >> 5u] >> (step & 31u)) & 1u;
}

fn shown_arcs(fan: vec4<u32>) -> u32 {
    if fan.w > 0u && is_taken(fan.w - 1u) == 1u {
        return 0u;
    }
    var at = fan.y + node_count(fan.z);
    var shown = 0u;
    if has_lasting(fan.z) {
        shown = words[at];
        at += 1u;
    }
    let makers = maker_count(fan.z);
    if is_wide(fan.z) {
        for (var i = 0u; i < makers; i++) {
            shown |= words[at + 2u * i + 1u] * is_taken(words[at + 2u * i]);
        }
    } else {
        for (var i = 0u; i < makers; i++) {
            let maker = words[at + i];
            shown |= (maker & 255u) * is_taken((maker >> 8u) + fan.w);
        }
    }
    return shown;
}

fn block_number(group: vec3<u32>, groups: vec3<u32>) -> u32 {
    return group.x + group.y * groups.x;
}

var<workgroup> total: atomic<u32>;

@compute @workgroup_size(ROW)
fn count(
    @builtin(workgroup_id) group: vec3<u32>,
    @builtin(num_workgroups) groups: vec3<u32>,
    @builtin(local_invocation_index) thread: u32,
) {
    let number = block_number(group, groups);
    if number >= terms.block_count {
        return;
    }
    let block = blocks[number];
    var found = 0u;
    for (var at = thread; at < block.y; at += ROW) {
        let shown = shown_arcs(fans[block.x + at]);
        arcs[block.x + at] = shown;
        found += countOneBits(shown);
    }
    if found != 0u {
        atomicAdd(&total, found);
    }
    workgroupBarrier();
    if thread == 0u {
        sums[number] = atomicLoad(&total);
    }
}

var<workgroup> ladder: array<vec4<u32>, ROW>;

// How much comes before what this thread brings to each of four rows, one row after the other; and how much all bring.
struct Before {
    here: vec4<u32>,
    all: u32,
}

fn before(thread: u32, own: vec4<u32>) -> Before {
    ladder[thread] = own;
    workgroupBarrier();
    for (var reach = 1u; reach < ROW; reach <<= 1u) {
        var below = vec4(0u);
        if thread >= reach {
            below = ladder[thread - reach];
        }
        workgroupBarrier();
        ladder[thread] += below;
        workgroupBarrier();
    }
    let rows = ladder[ROW - 1u];
    let second = rows.x + rows.y;
    let third = second + rows.z;
    return Before(ladder[thread] - own + vec4(0u, rows.x, second, third), third + rows.w);
}

// One workgroup: what each block has before it, and the draw of each group.
@compute @workgroup_size(ROW)
fn place(@builtin(local_invocation_index) thread: u32) {
    var carried = 0u;
    for (var first = 0u; first < terms.block_count; first += BLOCK) {
        var own = vec4(0u);
        for (var row = 0u; row < 4u; row++) {
            let number = first + row * ROW + thread;
            if number < terms.block_count {
                own[row] = sums[number];
            }
        }
        let behind = before(thread, own);
        for (var row = 0u; row < 4u; row++) {
            let number = first + row * ROW + thread;
            if number < terms.block_count {
                sums[number] = carried + behind.here[row];
            }
        }
        carried += behind.all;
        // The ladder is written again in the next round.
        workgroupBarrier();
    }
    if thread == 0u {
        sums[terms.block_count] = carried;
    }
    storageBarrier();
    for (var group = thread; group < terms.group_count; group += ROW) {
        let first = min(3u * sums[group_blocks[group]], terms.capacity);
        let end = min(3u * sums[group_blocks[group + 1u]], terms.capacity);
        commands[group] = array<u32, 5>(end - first, 1u, first, 0u, group * terms.tells_group);
    }
}

fn write_fan(fan: vec4<u32>, arcs_shown: u32, first: u32) {
    let nodes = node_count(fan.z);
    var shown = arcs_shown;
    var at = first;
    while shown != 0u && at + 3u <= terms.capacity {
        let arc = firstTrailingBit(shown);
        shown &= shown - 1u;
        // Only the last arc of a closed fan has no node behind it.
        let next = select(arc + 1u, 0u, arc + 1u == nodes);
        indices[at] = fan.x;
        indices[at + 1u] = words[fan.y + arc];
        indices[at + 2u] = words[fan.y + next];
        at += 3u;
    }
}

@compute @workgroup_size(ROW)
fn write(
    @builtin(workgroup_id) group: vec3<u32>,
    @builtin(num_workgroups) groups: vec3<u32>,
    @builtin(local_invocation_index) thread: u32,
) {
    let number = block_number(group, groups);
    if number >= terms.block_count || firsts[number] == firsts[number + 1u] {
        return;
    }
    let block = blocks[number];
    var shown = vec4(0u);
    for (var row = 0u; row < 4u; row++) {
        if row * ROW + thread < block.y {
            shown[row] = arcs[block.x + row * ROW + thread];
        }
    }
    let places = before(thread, countOneBits(shown)).here + firsts[number];
    for (var row = 0u; row < 4u; row++) {
        if shown[row] != 0u {
            write_fan(fans[block.x + row * ROW + thread], shown[row], 3u * places[row]);
        }
    }
}
