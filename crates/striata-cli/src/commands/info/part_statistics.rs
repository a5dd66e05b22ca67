//! Statistics of the connected parts of a mesh: their sizes, and the fewest triangles that show all of them.
//!
//! Parts share no position. A part is closed if an even number of triangles meets along each of its edges. It
//! stays closed whatever is collapsed, since collapses only merge positions. A single triangle is not closed,
//! so a closed part needs at least two triangles, and any other part at least one. Expected time O(n), memory
//! O(n).

use striata::mesh::{Adjacency, DisjointSets, Welded};

/// Sizes of the connected parts of a mesh.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub(crate) struct PartStatistics {
    /// Number of triangles of each part, in ascending order.
    pub triangle_counts: Vec<usize>,
    /// Smallest number of triangles of a level that shows all parts.
    pub least_triangle_count: usize,
}

impl PartStatistics {
    /// Measures the parts of a welded mesh.
    pub(crate) fn of(welded: &Welded) -> Self {
        let positions = &welded.positions;
        let adjacency = Adjacency::of_positions(&welded.mesh, positions);
        let mut sets = DisjointSets::new(positions.position_count());
        adjacency.edges().for_each(|edge| {
            sets.join(edge.ends[0], edge.ends[1]);
        });
        let mut counts = vec![0; positions.position_count()];
        let mut is_closed = vec![true; positions.position_count()];
        for &[corner, ..] in adjacency.triangles() {
            counts[sets.root(corner) as usize] += 1;
        }
        for edge in adjacency.edges().filter(|edge| edge.side_count() % 2 == 1) {
            is_closed[sets.root(edge.ends[0]) as usize] = false;
        }
        let parts = || counts.iter().zip(&is_closed).filter(|&(&count, _)| count > 0);
        let mut triangle_counts: Vec<usize> = parts().map(|(&count, _)| count).collect();
        triangle_counts.sort_unstable();
        let least_triangle_count = parts().map(|(_, &is_closed)| 1 + usize::from(is_closed)).sum();
        Self { triangle_counts, least_triangle_count }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use striata::mesh::{IndexedMesh, shapes, weld};

    fn of(mesh: &IndexedMesh) -> (Vec<usize>, usize) {
        let PartStatistics { triangle_counts, least_triangle_count } =
            PartStatistics::of(&weld(mesh).expect("shapes are consistent"));
        (triangle_counts, least_triangle_count)
    }

    #[test]
    fn parts_are_counted_across_seams() {
        assert_eq!(of(&IndexedMesh::default()), (vec![], 0));
        assert_eq!(of(&shapes::hard_cube()), (vec![12], 2));
        assert_eq!(of(&shapes::many_components(3)), (vec![4, 4, 4], 6));
    }

    #[test]
    fn open_parts_need_only_one_triangle() {
        assert_eq!(of(&shapes::grid(2, 1)), (vec![4], 1));
        // Three triangles at one edge are not closed, and neither is any level of them.
        assert_eq!(of(&shapes::book(3)), (vec![3], 1));
        let mut both = shapes::grid(1, 1);
        let first = both.positions.len() as u32;
        let cube = shapes::cube();
        both.positions.extend(cube.positions.iter().map(|p| p.map(|x| x + 9.0)));
        both.triangles.extend(cube.triangles.iter().map(|t| t.map(|v| v + first)));
        assert_eq!(of(&both), (vec![2, 12], 3));
    }
}
