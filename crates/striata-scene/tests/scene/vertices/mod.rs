//! Data of the vertices of a mesh, for comparing levels with their full mesh.

use std::collections::BTreeMap;

use striata::mesh::IndexedMesh;

/// Everything that is known of each position: one entry for each vertex there.
pub(crate) fn vertex_data(mesh: &IndexedMesh) -> BTreeMap<[u32; 3], Vec<Vec<u32>>> {
    let mut found: BTreeMap<_, Vec<Vec<u32>>> = BTreeMap::new();
    for (vertex, position) in mesh.positions.iter().enumerate() {
        let data = mesh.layers.iter().flat_map(|layer| {
            (0..layer.component_count as usize).map(move |c| layer.get(vertex, c).to_bits())
        });
        found.entry(position.map(|x| (x + 0.0).to_bits())).or_default().push(data.collect());
    }
    found
}
