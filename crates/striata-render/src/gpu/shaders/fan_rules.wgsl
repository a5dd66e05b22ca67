// The rules of progressive fans: which arcs of a fan are active, and which triangles they make. Passes over one
// instance and over a crowd share them.

// x: vertex, y: index of its first word, z: flags and counts, w: 1 + its own step, 0 in the base.
@group(0) @binding(1) var<storage, read> fans: array<vec4<u32>>;
@group(0) @binding(2) var<storage, read> words: array<u32>;
// One bit per step: set if it is collapsed.
@group(0) @binding(5) var<storage, read> collapsed: array<u32>;
@group(0) @binding(8) var<storage, read_write> indices: array<u32>;

// First word of the instance's bits, the step from which on all are collapsed, and the number of indices that fit.
var<private> first_bits: u32 = 0u;
var<private> step_limit: u32 = 0xffffffffu;
var<private> index_limit: u32 = 0u;

// The fans of a block form four rows; a thread takes one fan of each row, so that reads are coalesced.
const ROW = 64u;
const BLOCK = 256u;

fn node_count(flags: u32) -> u32 { return flags & 63u; }
fn is_closed(flags: u32) -> bool { return (flags & 64u) != 0u; }
fn is_wide(flags: u32) -> bool { return (flags & 128u) != 0u; }
fn has_permanent(flags: u32) -> bool { return (flags & 256u) != 0u; }
fn maker_count(flags: u32) -> u32 { return flags >> 9u; }

fn is_collapsed(step: u32) -> u32 {
    if step >= step_limit {
        return 1u;
    }
    return (collapsed[first_bits + (step >> 5u)] >> (step & 31u)) & 1u;
}

fn active_arcs(fan: vec4<u32>) -> u32 {
    if fan.w > 0u && is_collapsed(fan.w - 1u) == 1u {
        return 0u;
    }
    var at = fan.y + node_count(fan.z);
    var active_mask = 0u;
    if has_permanent(fan.z) {
        active_mask = words[at];
        at += 1u;
    }
    let makers = maker_count(fan.z);
    if is_wide(fan.z) {
        for (var i = 0u; i < makers; i++) {
            active_mask |= words[at + 2u * i + 1u] * is_collapsed(words[at + 2u * i]);
        }
    } else {
        for (var i = 0u; i < makers; i++) {
            let maker = words[at + i];
            active_mask |= (maker & 255u) * is_collapsed((maker >> 8u) + fan.w);
        }
    }
    return active_mask;
}

var<workgroup> scan: array<vec4<u32>, ROW>;

// Exclusive prefix sum over four rows, one row after the other: the sum of all values before this
// thread's, and the total.
struct PrefixSum {
    before: vec4<u32>,
    sum: u32,
}

fn prefix_sum(thread: u32, own: vec4<u32>) -> PrefixSum {
    scan[thread] = own;
    workgroupBarrier();
    for (var reach = 1u; reach < ROW; reach <<= 1u) {
        var below = vec4(0u);
        if thread >= reach {
            below = scan[thread - reach];
        }
        workgroupBarrier();
        scan[thread] += below;
        workgroupBarrier();
    }
    let rows = scan[ROW - 1u];
    let second = rows.x + rows.y;
    let third = second + rows.z;
    return PrefixSum(scan[thread] - own + vec4(0u, rows.x, second, third), third + rows.w);
}

fn write_fan(fan: vec4<u32>, arcs_shown: u32, first: u32) {
    let nodes = node_count(fan.z);
    var active_mask = arcs_shown;
    var at = first;
    while active_mask != 0u && at + 3u <= index_limit {
        let arc = firstTrailingBit(active_mask);
        active_mask &= active_mask - 1u;
        // Only the last arc of a closed fan wraps around to the first node.
        let next = select(arc + 1u, 0u, arc + 1u == nodes);
        indices[at] = fan.x;
        indices[at + 1u] = words[fan.y + arc];
        indices[at + 2u] = words[fan.y + next];
        at += 3u;
    }
}
