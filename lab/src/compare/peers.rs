//! Stripifiers of other libraries, for comparison only.

use std::time::Instant;

use striata::mesh::IndexedMesh;
use striata::strip::{RESTART, StripSet};

use striata_command::failure::Failure;
use striata_command::strip_chain::TimedStrips;

type Stripify = fn(&IndexedMesh) -> Result<TimedStrips, Failure>;

/// The stripifiers by name.
pub(super) const PEERS: [(&str, Stripify); 1] = [("meshoptimizer", meshoptimizer)];

/// Stripifies with meshoptimizer, after reordering the triangles as it recommends; the time includes both.
fn meshoptimizer(mesh: &IndexedMesh) -> Result<TimedStrips, Failure> {
    by_group(mesh, |indices, vertex_count| {
        let ordered = meshopt::optimize_vertex_cache_strip(indices, vertex_count);
        meshopt::stripify(&ordered, vertex_count, RESTART)
    })
}

fn by_group(
    mesh: &IndexedMesh,
    stripify: impl Fn(&[u32], usize) -> meshopt::Result<Vec<u32>>,
) -> Result<TimedStrips, Failure> {
    let started = Instant::now();
    let mut joined = Vec::new();
    for group in mesh.groups_or_whole() {
        if group.count == 0 {
            // meshoptimizer asserts that its input is not empty.
            joined.push(Vec::new());
            continue;
        }
        let indices = mesh.triangles[group.range()].as_flattened();
        let stripped = stripify(indices, mesh.vertex_count());
        joined.push(stripped.map_err(|error| Failure::internal(format!("meshoptimizer: {error}")))?);
    }
    let secs = started.elapsed().as_secs_f64();
    let mut strips = StripSet::new();
    for indices in &joined {
        for strip in indices.split(|&index| index == RESTART).filter(|strip| strip.len() >= 3) {
            strips.push(strip);
        }
        strips.end_group();
    }
    Ok(TimedStrips { strips, secs })
}
