//! Correspondence between the vertices of a [`Lod`](striata::Lod) and those of the mesh it was built from.
//!
//! Per-vertex data of any kind can follow a level only if each vertex of the level knows its input vertex, and
//! each input vertex knows its representative. Simplification merges equal vertices, drops unused ones and
//! sorts the rest in refinement order; [`VertexSources`] keeps track of all three. Time and memory O(vertices).

use striata::mesh::{AttributeLayer, CollapseSequence, IndexedMesh, LayerData};

/// Marks an input vertex that no level contains, because no triangle uses its position.
pub const UNUSED: u32 = u32::MAX;

/// Which input vertex each vertex comes from, and which vertex each input vertex became.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct VertexSources {
    /// For each vertex in refinement order, its input vertex: the first of several equal ones.
    pub input_of_vertex: Vec<u32>,
    /// For each input vertex, its vertex in refinement order, or [`UNUSED`].
    pub vertex_of_input: Vec<u32>,
    /// For each triangle of the full mesh, its input triangle.
    pub input_of_triangle: Vec<u32>,
}

impl VertexSources {
    /// Derives the correspondence from a mesh, `position_of_source` of its welded form, and the sequence built
    /// from that form.
    pub fn new(
        input: &IndexedMesh,
        position_of_source: &[u32],
        sequence: &CollapseSequence,
        source_vertex: Vec<u32>,
    ) -> Self {
        let positions = sequence.positions();
        let mut position_of_welded = vec![UNUSED; positions.position_count()];
        for position in 0..positions.position_count() as u32 {
            let source = source_vertex[positions.first_vertex(position) as usize];
            position_of_welded[position_of_source[source as usize] as usize] = position;
        }
        let vertex_of = |(vertex, &welded): (usize, &u32)| match welded {
            UNUSED => UNUSED,
            welded => {
                let mut wedges = positions.wedges(position_of_welded[welded as usize]);
                let first = wedges.start;
                if wedges.len() == 1 {
                    return first;
                }
                let is_same = |&wedge: &u32| {
                    let source = source_vertex[wedge as usize] as usize;
                    source == vertex || input.layers.iter().all(|layer| are_equal(layer, source, vertex))
                };
                wedges.find(is_same).unwrap_or(first)
            }
        };
        let vertex_of_input = position_of_source.iter().enumerate().map(vertex_of).collect();
        let input_of_triangle = kept_triangles(input, position_of_source);
        Self { input_of_vertex: source_vertex, vertex_of_input, input_of_triangle }
    }
}

/// Whether two vertices have the same bits in a layer.
fn are_equal(layer: &AttributeLayer, a: usize, b: usize) -> bool {
    let count = layer.component_count as usize;
    fn same<T: PartialEq>(values: &[T], [a, b]: [usize; 2], count: usize) -> bool {
        values[a * count..(a + 1) * count] == values[b * count..(b + 1) * count]
    }
    match &layer.data {
        LayerData::F32(values) => {
            (0..count).all(|i| values[a * count + i].to_bits() == values[b * count + i].to_bits())
        }
        LayerData::U8(values) => same(values, [a, b], count),
        LayerData::U16(values) => same(values, [a, b], count),
        LayerData::U32(values) => same(values, [a, b], count),
        LayerData::I8(values) => same(values, [a, b], count),
        LayerData::I16(values) => same(values, [a, b], count),
        LayerData::I32(values) => same(values, [a, b], count),
        LayerData::F64(values) => {
            (0..count).all(|i| values[a * count + i].to_bits() == values[b * count + i].to_bits())
        }
    }
}

/// Input triangles that welding keeps: those with corners at three positions.
fn kept_triangles(input: &IndexedMesh, position_of_source: &[u32]) -> Vec<u32> {
    let position = |v: u32| position_of_source[v as usize];
    let is_kept = |&t: &u32| {
        let [a, b, c] = input.triangles[t as usize].map(position);
        a != b && b != c && c != a
    };
    (0..input.triangles.len() as u32).filter(is_kept).collect()
}

/// For each vertex of the full mesh, the vertex that represents it at a level.
///
/// # Panics
/// If `split_count` exceeds the step count.
pub fn representatives(sequence: &CollapseSequence, split_count: usize) -> Vec<u32> {
    let vertex_count = sequence.vertex_count_at(split_count);
    let mut representative: Vec<u32> = (0..vertex_count as u32).collect();
    representative.reserve_exact(sequence.positions().vertex_count() - vertex_count);
    // Targets have smaller indices, so their representatives are known already.
    for vertex in vertex_count..sequence.positions().vertex_count() {
        representative.push(representative[sequence.target(vertex as u32) as usize]);
    }
    representative
}

/// Triangles of a level, in the order of the full mesh's triangles, and the index of each in that mesh.
pub fn level_triangles(mesh: &IndexedMesh, representative: &[u32]) -> (Vec<[u32; 3]>, Vec<u32>) {
    let (mut triangles, mut origins) = (Vec::new(), Vec::new());
    for (index, corners) in mesh.triangles.iter().enumerate() {
        let [a, b, c] = corners.map(|v| representative[v as usize]);
        if a != b && b != c && c != a {
            triangles.push([a, b, c]);
            origins.push(index as u32);
        }
    }
    (triangles, origins)
}

#[cfg(test)]
mod tests {
    use striata::mesh::{Semantic, replay, shapes, weld};
    use striata::simplify::{SequenceOptions, build_welded_sequence};

    use super::*;

    fn check(mesh: &IndexedMesh) {
        let welded = weld(mesh).expect("a consistent mesh");
        let position_of_source = welded.position_of_source.clone();
        let built = build_welded_sequence(welded, &SequenceOptions::default()).expect("a sequence");
        let sequence = &built.refinable.sequence;
        let sources = VertexSources::new(mesh, &position_of_source, sequence, built.source_vertex);
        let full = &built.refinable.mesh;
        assert_eq!(sources.input_of_triangle.len(), full.triangle_count());
        let kept = sources.input_of_triangle.iter().flat_map(|&t| mesh.triangles[t as usize]);
        let kept: std::collections::BTreeSet<u32> = kept.collect();
        for (input, &vertex) in sources.vertex_of_input.iter().enumerate().filter(|(_, v)| **v != UNUSED) {
            assert_eq!(mesh.positions[input], full.positions[vertex as usize]);
            // A vertex without triangles is represented by any other at its position.
            if !kept.contains(&(input as u32)) {
                continue;
            }
            for (ours, theirs) in mesh.layers.iter().zip(&full.layers) {
                let count = ours.component_count as usize;
                (0..count).for_each(|c| assert_eq!(ours.get(input, c), theirs.get(vertex as usize, c)));
            }
        }
        for split_count in [0, sequence.step_count() / 2, sequence.step_count()] {
            let representative = representatives(sequence, split_count);
            let (triangles, origins) = level_triangles(full, &representative);
            assert_eq!(triangles, replay(&built.refinable, split_count).triangles);
            for (triangle, &origin) in triangles.iter().zip(&origins) {
                let input = mesh.triangles[sources.input_of_triangle[origin as usize] as usize];
                let follow = |v: u32| representative[sources.vertex_of_input[v as usize] as usize];
                assert_eq!(*triangle, input.map(follow));
            }
        }
    }

    #[test]
    fn vertices_and_triangles_are_found_again() {
        check(&shapes::torus(16, 8, 1.0, 0.4));
        check(&shapes::moebius_strip(24));
        check(&shapes::random_soup(60, 3));
        check(&shapes::uv_cylinder(12, 4));
    }

    #[test]
    fn repeated_unused_and_degenerate_parts_do_not_confuse() {
        let mut mesh = shapes::grid(6, 6);
        let copies = mesh.positions.clone();
        let offset = copies.len() as u32;
        mesh.positions.insert(0, [9.0, 9.0, 9.0]);
        mesh.positions.extend(copies);
        mesh.triangles.iter_mut().for_each(|t| *t = t.map(|v| v + 1));
        for triangle in mesh.triangles.iter_mut().step_by(3) {
            *triangle = triangle.map(|v| v + offset);
        }
        mesh.triangles.insert(1, [1, 1, 2]);
        mesh.triangles.insert(4, [1, 1 + offset, 3]);
        let labels = (0..mesh.positions.len() as u32).map(|v| v % 2).collect();
        let data = LayerData::U32(labels);
        let semantic = Semantic::Generic("label".to_owned());
        mesh.layers.push(AttributeLayer { semantic, component_count: 1, normalized: false, data });
        check(&mesh);
    }
}
