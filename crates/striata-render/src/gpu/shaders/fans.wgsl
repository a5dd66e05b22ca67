// Extracts progressive fans: counts the active arcs, computes where their triangles go, and writes the
// triangles. Follows `fan_rules.wgsl`.
//
// A workgroup processes one block of fans of one group, each thread up to four fans. Blocks are numbered
// along the rows of the dispatch.

struct ExtractionParameters {
    block_count: u32,
    group_count: u32,
    // Number of indices that fit.
    capacity: u32,
    // 1 if indirect draws can pass their group to the shader as the first instance.
    passes_group: u32,
}

@group(0) @binding(0) var<uniform> parameters: ExtractionParameters;
// First fan and fan count.
@group(0) @binding(3) var<storage, read> blocks: array<vec2<u32>>;
// First block of each group, followed by the block count.
@group(0) @binding(4) var<storage, read> group_blocks: array<u32>;
// Active arcs of each fan, as a bit mask.
@group(0) @binding(6) var<storage, read_write> arcs: array<u32>;
// Number of active arcs in each block; after `allocate`, in all blocks before it.
@group(0) @binding(7) var<storage, read_write> sums: array<u32>;
// Read-only binding of `sums`, for the pass that does not write it.
@group(0) @binding(10) var<storage, read> firsts: array<u32>;
// Index count, instance count, first index, base vertex, first instance.
@group(0) @binding(9) var<storage, read_write> commands: array<array<u32, 5>>;

fn block_index(group: vec3<u32>, groups: vec3<u32>) -> u32 {
    return group.x + group.y * groups.x;
}

var<workgroup> total: atomic<u32>;

@compute @workgroup_size(ROW)
fn count(
    @builtin(workgroup_id) group: vec3<u32>,
    @builtin(num_workgroups) groups: vec3<u32>,
    @builtin(local_invocation_index) thread: u32,
) {
    let block_id = block_index(group, groups);
    if block_id >= parameters.block_count {
        return;
    }
    let block = blocks[block_id];
    var found = 0u;
    for (var at = thread; at < block.y; at += ROW) {
        let active_mask = active_arcs(fans[block.x + at]);
        arcs[block.x + at] = active_mask;
        found += countOneBits(active_mask);
    }
    if found != 0u {
        atomicAdd(&total, found);
    }
    workgroupBarrier();
    if thread == 0u {
        sums[block_id] = atomicLoad(&total);
    }
}

// Runs in one workgroup: turns the counts of the blocks into prefix sums and writes the draw of each group.
@compute @workgroup_size(ROW)
fn allocate(@builtin(local_invocation_index) thread: u32) {
    var carried = 0u;
    for (var first = 0u; first < parameters.block_count; first += BLOCK) {
        var own = vec4(0u);
        for (var row = 0u; row < 4u; row++) {
            let block_id = first + row * ROW + thread;
            if block_id < parameters.block_count {
                own[row] = sums[block_id];
            }
        }
        let prefix = prefix_sum(thread, own);
        for (var row = 0u; row < 4u; row++) {
            let block_id = first + row * ROW + thread;
            if block_id < parameters.block_count {
                sums[block_id] = carried + prefix.before[row];
            }
        }
        carried += prefix.sum;
        // `scan` is overwritten in the next round.
        workgroupBarrier();
    }
    if thread == 0u {
        sums[parameters.block_count] = carried;
    }
    storageBarrier();
    for (var group = thread; group < parameters.group_count; group += ROW) {
        let first = min(3u * sums[group_blocks[group]], parameters.capacity);
        let end = min(3u * sums[group_blocks[group + 1u]], parameters.capacity);
        commands[group] = array<u32, 5>(end - first, 1u, first, 0u, group * parameters.passes_group);
    }
}

@compute @workgroup_size(ROW)
fn write(
    @builtin(workgroup_id) group: vec3<u32>,
    @builtin(num_workgroups) groups: vec3<u32>,
    @builtin(local_invocation_index) thread: u32,
) {
    let block_id = block_index(group, groups);
    if block_id >= parameters.block_count || firsts[block_id] == firsts[block_id + 1u] {
        return;
    }
    index_limit = parameters.capacity;
    let block = blocks[block_id];
    var active_mask = vec4(0u);
    for (var row = 0u; row < 4u; row++) {
        if row * ROW + thread < block.y {
            active_mask[row] = arcs[block.x + row * ROW + thread];
        }
    }
    let slots = prefix_sum(thread, countOneBits(active_mask)).before + firsts[block_id];
    for (var row = 0u; row < 4u; row++) {
        if active_mask[row] != 0u {
            write_fan(fans[block.x + row * ROW + thread], active_mask[row], 3u * slots[row]);
        }
    }
}
