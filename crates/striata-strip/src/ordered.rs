//! Strips from an order of triangles, for example of another stripifier.

use striata::mesh::{DualGraph, IndexedMesh, MeshError};
use striata::strip::{StripLinks, StripSet, write_strips};

/// Makes strips of triangles that follow each other in an order and share an edge.
///
/// A triangle that the order does not contain, or whose neighbors in the order are no neighbors in the mesh, is a
/// strip of its own. So the triangles of a strip file, in the order of its strips, give these strips again, joined
/// where one ends next to the beginning of the next.
///
/// ```
/// use striata::mesh::shapes;
/// use striata_strip::strips_in_order;
///
/// let square = shapes::grid(1, 1); // two triangles
/// assert_eq!(strips_in_order(&square, &[0, 1])?.strip_count(), 1);
/// assert_eq!(strips_in_order(&square, &[])?.strip_count(), 2);
/// # Ok::<(), striata::mesh::MeshError>(())
/// ```
///
/// # Errors
/// [`MeshError`] if the mesh is inconsistent.
///
/// # Panics
/// If the order names a triangle that the mesh does not have.
pub fn strips_in_order(mesh: &IndexedMesh, order: &[u32]) -> Result<StripSet, MeshError> {
    mesh.check()?;
    let graph = DualGraph::of_vertices(mesh);
    let mut links = StripLinks::new(&graph);
    for pair in order.windows(2) {
        let sides = 3 * pair[0]..3 * pair[0] + 3;
        let mut shared = sides.filter(|&side| graph.twin(side).is_some_and(|twin| twin / 3 == pair[1]));
        if let Some(side) = shared.next().filter(|&side| {
            !links.is_solid(side) && pair.iter().all(|&triangle| links.solid_degree(triangle) < 2)
        }) {
            links.join(side);
        }
    }
    links.cut_loops();
    let groups: Vec<_> = mesh.groups_or_whole().iter().map(|group| group.range()).collect();
    let mut strips = StripSet::new();
    write_strips(&mesh.triangles, &links, groups.iter().cloned(), &mut strips);
    Ok(strips)
}

#[cfg(test)]
mod tests {
    use striata::mesh::{Random, shapes};
    use striata::strip::stripify;

    use super::*;

    #[test]
    fn any_order_covers_each_triangle_once() {
        let mesh = shapes::torus(12, 8, 1.0, 0.4);
        let count = mesh.triangles.len() as u32;
        let mut random = Random::new(7);
        for _ in 0..20 {
            // Some triangles several times, others not at all.
            let order: Vec<u32> = (0..count).map(|_| random.below(count)).collect();
            let cost = strips_in_order(&mesh, &order).unwrap().cost();
            assert_eq!(cost.triangle_count, count as usize);
        }
    }

    #[test]
    fn strips_are_found_again() {
        let mesh = shapes::terrain(20, 3);
        let strips = stripify(&mesh).unwrap();
        let mut shown = Vec::new();
        strips.triangles_into(&mut shown);
        let number = |t: &[u32; 3]| {
            let is_same = |other: &[u32; 3]| (0..3).any(|k| [t[k], t[(k + 1) % 3], t[(k + 2) % 3]] == *other);
            mesh.triangles.iter().position(is_same).unwrap() as u32
        };
        let order: Vec<u32> = shown.iter().map(number).collect();
        assert!(strips_in_order(&mesh, &order).unwrap().strip_count() <= strips.strip_count());
    }
}
