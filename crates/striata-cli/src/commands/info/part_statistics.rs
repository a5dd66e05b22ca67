//! The connected parts of a mesh: how large they are, and how few triangles can show all of them.
//!
//! Parts are pieces that share no position. A part along whose edges an even number of triangles meet
//! everywhere is closed, and stays so whatever is collapsed, since a collapse only lets positions become one.
//! A single triangle is not closed; so a closed part has two triangles at least, and any other part has one.
//! Time O(n) expected, memory O(n).

use striata::mesh::{Adjacency, DisjointSets, Welded};

/// Sizes of the connected parts of a mesh.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub(crate) struct PartStatistics {
    /// Triangles of each part, the smallest first.
    pub(crate) triangle_counts: Vec<usize>,
    /// No level that shows all parts can have fewer triangles.
    pub(crate) least_triangle_count: usize,
}

impl PartStatistics {
    /// Finds the parts of a welded mesh.
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
            PartStatistics::of(&weld(mesh).expect("shapes are sound"));
        (triangle_counts, least_triangle_count)
    }

    #[test]
    fn parts_are_counted_across_seams() {
        assert_eq!(of(&IndexedMesh::default()), (vec![], 0));
        assert_eq!(of(&shapes::hard_cube()), (vec![12], 2));
        assert_eq!(of(&shapes::many_components(3)), (vec![4, 4, 4], 6));
    }

    #[test]
    fn open_parts_need_one_triangle() {
        assert_eq!(of(&shapes::grid(2, 1)), (vec![4], 1));
        // Three triangles at one edge are not closed, and neither is what they end in.
        assert_eq!(of(&shapes::book(3)), (vec![3], 1));
        let mut both = shapes::grid(1, 1);
        let first = both.positions.len() as u32;
        let cube = shapes::cube();
        both.positions.extend(cube.positions.iter().map(|p| p.map(|x| x + 9.0)));
        both.triangles.extend(cube.triangles.iter().map(|t| t.map(|v| v + first)));
        assert_eq!(of(&both), (vec![2, 12], 3));
    }
}
