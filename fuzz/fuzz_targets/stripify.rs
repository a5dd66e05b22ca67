//! Stripifies small meshes of every shape: strips must contain each triangle once, in every form of the
//! index buffer.
#![no_main]

use libfuzzer_sys::fuzz_target;
use striata::mesh::{IndexedMesh, canonical_triangles};
use striata::strip::{RESTART, StripIndices, restart_triangles_into};
use striata_fuzz::Bytes;
use striata_strip::{StripOptions, stripify};

/// All stripifiers; the bytes select one.
const SPECS: [&str; 8] =
    ["greedy", "stripe", "stripe:global", "stripe:no-swaps", "tunnel:1", "tunnel:9", "fewest", "cheapest"];

fuzz_target!(|data: &[u8]| {
    let mut bytes = Bytes(data);
    let max_indices = usize::from(bytes.byte());
    let mesh = bytes.mesh();
    let spec = SPECS[usize::from(bytes.byte()) % SPECS.len()];
    let options =
        StripOptions::default().with_stripifier(spec.parse().expect("a known name")).with_effort(0.1);
    let options = options.with_cache_weight(f64::from(bytes.byte() % 4) / 2.0);
    let strips = stripify(&mesh, &options);
    assert_eq!(strips.is_ok(), mesh.check().is_ok());
    let Ok(strips) = strips else { return };
    let cost = strips.cost();
    let restart = strips.to_restart_indices();
    assert_eq!(
        cost.index_count,
        restart.indices.len(),
        "the cost must equal the length of the restart buffer"
    );
    check(&mesh, &restart);
    let stitched = strips.to_stitched_indices();
    assert!(!stitched.indices.contains(&RESTART));
    check(&mesh, &stitched);
    if max_indices >= 4 {
        check(&mesh, &strips.cut(max_indices).to_restart_indices());
    }
});

fn check(mesh: &IndexedMesh, buffer: &StripIndices) {
    let groups = mesh.groups_or_whole();
    assert_eq!(buffer.group_ranges.len(), groups.len());
    for (group, range) in groups.iter().zip(&buffer.group_ranges) {
        let mut found = Vec::new();
        restart_triangles_into(&buffer.indices[range.start as usize..range.end as usize], &mut found);
        let is_shown = |t: &&[u32; 3]| t[0] != t[1] && t[1] != t[2] && t[2] != t[0];
        let expected: Vec<[u32; 3]> =
            mesh.triangles[group.range()].iter().filter(is_shown).copied().collect();
        assert_eq!(canonical_triangles(&found), canonical_triangles(&expected));
    }
}
