//! Statistics of steps that do more than remove triangles: they cross seams, or make whole parts disappear.
//!
//! A sequence stores only targets; what a step does follows from the triangles. Each triangle is traced from
//! the full mesh down, always through its youngest corner, until two of its corners coincide or the base mesh
//! is reached. A wedge that is used by a triangle when its position is collapsed, but by none of the
//! triangles that vanish, has no partner at the target: it crosses a seam. Time is proportional to the number
//! of corners that change, about n log n; memory O(n).

use striata::mesh::{DisjointSets, RefinableMesh};

/// Number of special steps of a sequence, and the levels that show all parts.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub(crate) struct StepStatistics {
    /// Number of steps that remove triangles and move a wedge to the other side of a seam.
    pub crossing_count: usize,
    /// Number of steps that remove no triangle: they contract two parts, or remove a position that has no
    /// triangle left.
    pub empty_count: usize,
    /// Number of connected parts of the full mesh.
    pub part_count: usize,
    /// Number of parts that have no triangle in the base mesh.
    pub vanished_part_count: usize,
    /// Split count of the coarsest level that has triangles of every part.
    pub all_parts_split_count: usize,
}

impl StepStatistics {
    /// Examines every step.
    pub(crate) fn of(refinable: &RefinableMesh) -> Self {
        let RefinableMesh { mesh, sequence } = refinable;
        let mut wedges = vec![Wedge::default(); mesh.vertex_count()];
        let least_split_counts: Vec<usize> =
            mesh.triangles.iter().map(|&corners| trace_triangle(refinable, corners, &mut wedges)).collect();
        let removed = sequence.removed_triangle_counts();
        let crosses = |step: &usize| {
            let mut vertices = sequence.step_vertices(*step);
            removed[*step] > 0
                && vertices.any(|v| wedges[v as usize].is_used && !wedges[v as usize].is_paired)
        };
        let parts = least_by_part(refinable, &least_split_counts);
        Self {
            crossing_count: (0..sequence.step_count()).filter(crosses).count(),
            empty_count: removed.iter().filter(|&&count| count == 0).count(),
            part_count: parts.len(),
            vanished_part_count: parts.iter().filter(|&&split_count| split_count > 0).count(),
            all_parts_split_count: parts.into_iter().max().unwrap_or(0),
        }
    }
}

/// State of a vertex when its position is collapsed.
#[derive(Clone, Copy, Debug, Default)]
struct Wedge {
    /// Whether a triangle uses it.
    is_used: bool,
    /// Whether a triangle that vanishes uses it.
    is_paired: bool,
}

/// Traces a triangle of the full mesh down; returns the smallest split count at which it exists.
fn trace_triangle(refinable: &RefinableMesh, mut corners: [u32; 3], wedges: &mut [Wedge]) -> usize {
    let sequence = &refinable.sequence;
    let (positions, base) = (sequence.positions(), sequence.base_vertex_count() as u32);
    loop {
        let [a, b, c] = corners;
        let youngest = a.max(b).max(c);
        if youngest < base {
            return 0;
        }
        let target = sequence.target(youngest);
        let position = positions.position_of(target);
        let vanishes = corners.iter().any(|&v| positions.position_of(v) == position);
        let wedge = &mut wedges[youngest as usize];
        wedge.is_used = true;
        wedge.is_paired |= vanishes;
        if vanishes {
            return positions.position_of(youngest) as usize - sequence.base_position_count() + 1;
        }
        corners = corners.map(|v| if v == youngest { target } else { v });
    }
}

/// Returns the smallest split count at which each connected part of the full mesh has a triangle.
fn least_by_part(refinable: &RefinableMesh, least_split_counts: &[usize]) -> Vec<usize> {
    let (mesh, positions) = (&refinable.mesh, refinable.sequence.positions());
    let mut sets = DisjointSets::new(positions.position_count());
    for [a, b, c] in mesh.triangles.iter().map(|t| t.map(|v| positions.position_of(v))) {
        sets.join(a, b);
        sets.join(a, c);
    }
    let mut least = vec![usize::MAX; positions.position_count()];
    for (t, &split_count) in mesh.triangles.iter().zip(least_split_counts) {
        let slot = &mut least[sets.root(positions.position_of(t[0])) as usize];
        *slot = split_count.min(*slot);
    }
    // Only the root position of each part with triangles has a value.
    least.into_iter().filter(|&split_count| split_count < usize::MAX).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use striata::mesh::{CollapseSequence, IndexedMesh, PositionIndex, SequenceParts};

    /// A square of four triangles around `V`, with a seam from `A` over `V` to `C`, and a triangle apart.
    ///
    /// ```text
    ///    D---C    A: vertices 0, 1   B: 2   C: 3, 4   D: 5
    ///    |\ /|    E, F, G: 6, 7, 8 (apart)
    ///    | V |    V: 9 (on the side of B), 10 (on the side of D)
    ///    |/ \|
    ///    A---B
    /// ```
    fn square(targets_of_v: [u32; 2]) -> RefinableMesh {
        let triangles = vec![[0, 2, 9], [2, 3, 9], [4, 5, 10], [5, 1, 10], [6, 7, 8]];
        let parts = SequenceParts {
            positions: PositionIndex::from_first(vec![0, 2, 3, 5, 6, 7, 8, 9, 11]),
            base_position_count: 4,
            // The separate part vanishes: G collapses to E, then F and E, which have no triangle left, to A.
            targets: [&[0, 0, 6][..], &targets_of_v].concat(),
            errors: vec![1.0; 4],
            removed_triangle_counts: vec![0, 0, 1, 2],
            triangle_count: 5,
        };
        let sequence = CollapseSequence::from_parts(parts).expect("the parts are consistent");
        RefinableMesh { mesh: IndexedMesh::new(vec![[0.0; 3]; 11], triangles), sequence }
    }

    #[test]
    fn a_wedge_without_a_partner_crosses() {
        let along = StepStatistics::of(&square([0, 1]));
        assert_eq!((along.crossing_count, along.empty_count), (0, 2));
        let across = StepStatistics::of(&square([2, 2]));
        assert_eq!((across.crossing_count, across.empty_count), (1, 2));
    }

    #[test]
    fn parts_vanish_with_their_last_triangle() {
        let found = StepStatistics::of(&square([0, 1]));
        assert_eq!((found.part_count, found.vanished_part_count), (2, 1));
        // Step 2 restores G, and with it the triangle.
        assert_eq!(found.all_parts_split_count, 3);
        let kept = StepStatistics::of(&square([0, 1]).without_levels_below(3));
        assert_eq!((kept.vanished_part_count, kept.all_parts_split_count), (0, 0));
    }
}
