//! Reorders a mesh to match its stream, so that other models of the mesh number vertices and levels in
//! the same way.

use striata::mesh::{CollapseSequence, IndexedMesh, PositionIndex, RefinableMesh, SequenceParts};

use crate::writer::encode::EncodedStream;

impl EncodedStream {
    /// Returns the encoded mesh with its vertices and steps in stream order. Positions keep their
    /// original values instead of snapping to the grid.
    ///
    /// Steps are reordered only within batches. If a level of the stream is not a level of the mesh, its
    /// error is that of the nearest coarser level that is.
    ///
    /// # Panics
    /// If the stream was made from another mesh.
    pub fn reorder(&self, refinable: &RefinableMesh) -> RefinableMesh {
        let RefinableMesh { mesh, sequence } = refinable;
        let order = &self.source_vertex;
        assert_eq!(order.len(), mesh.vertex_count(), "the stream must have been made from this mesh");
        let mut vertex_of = vec![u32::MAX; order.len()];
        for (vertex, &source) in order.iter().enumerate() {
            vertex_of[source as usize] = vertex as u32;
        }
        let moved = |v: u32| vertex_of[v as usize];
        let reordered = IndexedMesh {
            positions: order.iter().map(|&v| mesh.positions[v as usize]).collect(),
            origin: mesh.origin,
            exact_positions: Vec::new(),
            triangles: mesh.triangles.iter().map(|t| t.map(moved)).collect(),
            layers: mesh.layers.iter().map(|layer| layer.gather(order)).collect(),
            triangle_layers: mesh.triangle_layers.clone(),
            groups: mesh.groups.clone(),
            appearance: mesh.appearance.clone(),
        };
        let steps = steps_in_order(order, sequence);
        let base = sequence.base_vertex_count();
        let parts = SequenceParts {
            positions: positions_in_order(order, sequence),
            base_position_count: sequence.base_position_count(),
            targets: order[base..].iter().map(|&v| moved(sequence.target(v))).collect(),
            errors: errors_in_order(&steps, sequence),
            removed_triangle_counts: steps
                .iter()
                .map(|&step| sequence.removed_triangle_counts()[step as usize])
                .collect(),
            triangle_count: mesh.triangle_count(),
        };
        let sequence =
            CollapseSequence::from_parts(parts).expect("the order keeps each vertex after its target");
        RefinableMesh { mesh: reordered, sequence }
    }
}

/// Numbers the positions in stream order.
fn positions_in_order(order: &[u32], sequence: &CollapseSequence) -> PositionIndex {
    let positions = sequence.positions();
    if positions.is_identity() {
        return PositionIndex::identity(order.len());
    }
    let mut firsts = Vec::with_capacity(positions.position_count() + 1);
    let mut last = None;
    for (vertex, &source) in order.iter().enumerate() {
        let position = positions.position_of(source);
        if last != Some(position) {
            firsts.push(vertex as u32);
        }
        last = Some(position);
    }
    firsts.push(order.len() as u32);
    PositionIndex::from_first(firsts)
}

/// Returns the steps of the sequence in stream order.
fn steps_in_order(order: &[u32], sequence: &CollapseSequence) -> Vec<u32> {
    let positions = sequence.positions();
    let base = sequence.base_position_count() as u32;
    let mut steps: Vec<u32> =
        order[sequence.base_vertex_count()..].iter().map(|&v| positions.position_of(v) - base).collect();
    steps.dedup();
    steps
}

/// Returns the errors of the steps. Levels with the same steps have the same error, and levels in between
/// that of the next coarser one.
fn errors_in_order(steps: &[u32], sequence: &CollapseSequence) -> Vec<f32> {
    let mut errors = Vec::with_capacity(steps.len());
    let (mut error, mut highest) = (0.0, None);
    for (split_count, &step) in steps.iter().enumerate() {
        if highest.is_none_or(|highest: u32| highest as usize + 1 == split_count) {
            error = sequence.error_at(split_count);
        }
        errors.push(error);
        highest = highest.max(Some(step));
    }
    errors
}

#[cfg(test)]
mod tests {
    use striata::mesh::{canonical_triangles, replay, shapes};
    use striata::simplify::{SequenceOptions, build_sequence};

    use super::*;
    use crate::writer::encode::StreamSizes;

    #[test]
    fn levels_with_the_same_steps_have_the_same_triangles() {
        let mesh = shapes::torus(16, 8, 1.0, 0.4);
        let built = build_sequence(&mesh, &SequenceOptions::default()).unwrap();
        let refinable = built.refinable;
        let sequence = &refinable.sequence;
        let base = sequence.base_vertex_count();
        // Swaps consecutive steps whose vertices share no triangle. The result has some batches of two
        // steps and some of one.
        let mut order: Vec<u32> = (0..mesh.vertex_count() as u32).collect();
        let mut swapped = Vec::new();
        let mut vertex = base;
        while vertex + 1 < order.len() {
            let shown = replay(&refinable, vertex + 2 - base);
            let [a, b] = [vertex as u32, vertex as u32 + 1];
            if !shown.triangles.iter().any(|t| t.contains(&a) && t.contains(&b)) {
                order.swap(vertex, vertex + 1);
                swapped.push(vertex + 1 - base);
                vertex += 1;
            }
            vertex += 1;
        }
        assert!(swapped.len() > 10, "{swapped:?}");
        let sizes = StreamSizes::default();
        let stream = EncodedStream { bytes: Vec::new(), sizes, source_vertex: order.clone() };
        let reordered = stream.reorder(&refinable);
        for split_count in 0..=sequence.step_count() {
            if swapped.contains(&split_count) {
                let coarser = reordered.sequence.error_at(split_count - 1);
                assert_eq!(reordered.sequence.error_at(split_count), coarser);
                continue;
            }
            assert_eq!(reordered.sequence.error_at(split_count), sequence.error_at(split_count));
            let shown = replay(&reordered, split_count).triangles;
            let back: Vec<_> = shown.iter().map(|t| t.map(|v| order[v as usize])).collect();
            let expected = replay(&refinable, split_count).triangles;
            assert_eq!(canonical_triangles(&back), canonical_triangles(&expected), "{split_count}");
        }
    }
}
