//! Lower bound of the strip count from counting links.
//!
//! A triangle of a strip has at most two solid links, so each triangle with three links has a dashed one.
//! An island of `k` connected triangles with three links needs at least `k / 2` dashed links, rounded up,
//! as a link serves two triangles. The number of strips without loops is the number of triangles minus that
//! of solid links, so every odd island costs half a strip more. (This is Berge's bound for matchings with
//! the empty set removed.)
//!
//! ```text
//!     o---o---o      the middle triangle has three links, its neighbors two: one of them stays dashed,
//!         |          and a strip ends at that neighbor
//!         o
//! ```
//!
//! Linear in time, 5 bytes a triangle.

use striata::mesh::{DualGraph, NO_TWIN};

/// Raises the bound of each component if counting gives a higher one; `component` lists each triangle's
/// component, if any.
pub(super) fn raise(least: &mut [u32], component: &[u32], graph: &DualGraph) {
    // Sum of twice the triangles, minus twice the links, plus twice the dashed links that are needed.
    let mut doubled = vec![0i64; least.len()];
    let mut is_seen = vec![false; component.len()];
    let mut island = Vec::new();
    for triangle in 0..component.len() as u32 {
        let Some(doubled) = doubled.get_mut(component[triangle as usize] as usize) else { continue };
        *doubled += 2 - graph.degree(triangle) as i64;
        if is_seen[triangle as usize] || graph.degree(triangle) < 3 {
            continue;
        }
        is_seen[triangle as usize] = true;
        island.push(triangle);
        let mut size = 0;
        while let Some(inner) = island.pop() {
            size += 1;
            for neighbor in graph.neighbors(inner) {
                let is_new =
                    neighbor != NO_TWIN && !is_seen[neighbor as usize] && graph.degree(neighbor) == 3;
                if is_new {
                    is_seen[neighbor as usize] = true;
                    island.push(neighbor);
                }
            }
        }
        *doubled += size + size % 2;
    }
    for (least, doubled) in least.iter_mut().zip(doubled) {
        *least = (*least).max(u32::try_from(doubled / 2).unwrap_or(0));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use striata::mesh::{IndexedMesh, shapes};

    #[test]
    fn an_island_of_one_costs_an_end() {
        // 18 triangles, 21 links, and islands of odd size between the boundary triangles.
        let mut least = vec![1];
        let grid = DualGraph::of_vertices(&shapes::grid(3, 3));
        raise(&mut least, &[0; 18], &grid);
        assert_eq!(least, [2]);
        let mut least = vec![1];
        raise(&mut least, &[0; 4], &DualGraph::of_vertices(&shapes::tetrahedron()));
        assert_eq!(least, [1]);

        // Three arms of two triangles around a middle one; bridges are ignored: 7 triangles, 6 links, one
        // island of one.
        let arms = [[0, 1, 2], [1, 0, 3], [3, 0, 6], [2, 1, 4], [4, 1, 7], [0, 2, 5], [5, 2, 8]];
        let mesh = IndexedMesh::new(vec![[0.0; 3]; 9], arms.to_vec());
        let mut least = vec![0];
        raise(&mut least, &[0; 7], &DualGraph::of_vertices(&mesh));
        assert_eq!(least, [2]);
    }
}
