//! Order of outputs for the caches of a GPU: triangles by `striata::strip::cache_order`, vertices by first use.

use striata::mesh::IndexedMesh;
use striata::strip::cache_order;

/// Returns a mesh whose triangles are in cache order, group by group; groups that are blended keep theirs, because
/// it is the order in which they are drawn over each other.
pub(crate) fn with_triangles_in_cache_order(
    mesh: &IndexedMesh,
    is_blended: impl Fn(usize) -> bool,
) -> IndexedMesh {
    let mut order = Vec::with_capacity(mesh.triangle_count());
    for (number, group) in mesh.groups_or_whole().iter().enumerate() {
        if is_blended(number) {
            order.extend(group.first..group.first + group.count);
        } else {
            order.extend(cache_order(&mesh.triangles[group.range()]).iter().map(|t| group.first + t));
        }
    }
    mesh.with_triangle_order(&order)
}

/// Returns a mesh with its own materials whose triangles and vertices are in cache order.
pub(crate) fn in_cache_order(mesh: &IndexedMesh) -> IndexedMesh {
    let is_blended = |group: usize| {
        let material = mesh.groups.get(group).and_then(|group| group.material);
        let material = material.and_then(|material| mesh.appearance.materials.get(material as usize));
        material.is_some_and(|material| material.gltf_json.contains("\"BLEND\""))
    };
    with_triangles_in_cache_order(mesh, is_blended).with_vertices_by_first_use()
}
