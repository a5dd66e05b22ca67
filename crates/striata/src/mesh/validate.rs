//! Finds everything that is wrong with a mesh and reports where.
//!
//! [`IndexedMesh::check`] stops at the first thing that makes a mesh unusable. [`validate`] looks at the
//! whole mesh, broken or not, and also finds what is legal but rarely intended: degenerate and duplicate
//! triangles, non-manifold edges and vertices, bad attributes. A boundary is not a defect.
//!
//! Cost: O(n log n) time, about 150 bytes per triangle; the report lists at most a fixed number of defects
//! of each kind.

use std::collections::BTreeMap;
use std::fmt;

use super::defect::{Defect, DefectKind};
use super::statistics::{area_of, duplicate_triangles, unused_vertices};
use super::weld::index_positions;
use super::{Adjacency, AttributeLayer, IndexedMesh, LayerData, MeshError, Semantic};

/// Number of defects of each kind that a [`Report`] lists; further ones are only counted.
pub const MAX_LISTED_PER_KIND: usize = 16;

/// Defects found by [`validate`].
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Report {
    defects: Vec<Defect>,
    counts: BTreeMap<DefectKind, usize>,
}

impl Report {
    /// The first [`MAX_LISTED_PER_KIND`] defects of each kind, sorted by kind.
    pub fn defects(&self) -> &[Defect] {
        &self.defects
    }

    /// Number of defects of a kind, listed or not.
    pub fn count(&self, kind: DefectKind) -> usize {
        self.counts.get(&kind).copied().unwrap_or(0)
    }

    /// Kinds of defects found, with the number of each.
    pub fn counts(&self) -> impl Iterator<Item = (DefectKind, usize)> + '_ {
        self.counts.iter().map(|(&kind, &count)| (kind, count))
    }

    /// Whether no defect was found.
    pub fn is_clean(&self) -> bool {
        self.counts.is_empty()
    }

    fn add(&mut self, defect: Defect) {
        let count = self.counts.entry(defect.kind()).or_insert(0);
        *count += 1;
        if *count <= MAX_LISTED_PER_KIND {
            self.defects.push(defect);
        }
    }
}

/// Prints a line for each listed defect, and one for each kind that has more defects than are listed.
impl fmt::Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for run in self.defects.chunk_by(|a, b| a.kind() == b.kind()) {
            for defect in run {
                writeln!(f, "{defect}")?;
            }
            let (kind, unlisted) = (run[0].kind(), self.count(run[0].kind()) - run.len());
            if unlisted > 0 {
                writeln!(f, "… and {unlisted} more {}", kind.as_str())?;
            }
        }
        Ok(())
    }
}

/// Checks a mesh for every kind of [`Defect`].
///
/// ```
/// use striata::mesh::{IndexedMesh, validate};
/// let mesh = IndexedMesh::new(vec![[0., 0., 0.], [1., 0., 0.]], vec![[0, 1, 1], [0, 1, 7]]);
/// let lines = validate(&mesh).to_string();
/// assert!(lines.contains("triangle 1 uses vertex 7, but there are 2 vertices"));
/// assert!(lines.contains("triangle 0 uses vertex 1 twice"));
/// ```
pub fn validate(mesh: &IndexedMesh) -> Report {
    let mut report = Report::default();
    let sizes = mesh.check_sizes();
    if let Err(error @ MeshError::TooLarge { .. }) = sizes {
        report.add(Defect::Inconsistent(error));
        return report;
    }
    for error in [sizes.err(), mesh.check_groups().err()].into_iter().flatten() {
        report.add(Defect::Inconsistent(error));
    }
    find_bad_numbers(mesh, &mut report);
    let triangles = find_bad_triangles(mesh, &mut report);
    find_bad_topology(mesh, &triangles, &mut report);
    unused_vertices(mesh).for_each(|vertex| report.add(Defect::UnusedVertex { vertex }));
    find_bad_layers(mesh, &mut report);
    find_bad_weights(mesh, &mut report);
    report.defects.sort_by_key(Defect::kind);
    report
}

fn find_bad_numbers(mesh: &IndexedMesh, report: &mut Report) {
    let vertex_count = mesh.vertex_count();
    for (triangle, corners) in mesh.triangles.iter().enumerate() {
        for &vertex in corners.iter().filter(|&&v| v as usize >= vertex_count) {
            let error = MeshError::IndexOutOfRange { triangle, vertex, vertex_count };
            report.add(Defect::Inconsistent(error));
        }
    }
    for (vertex, p) in mesh.positions.iter().enumerate() {
        for (axis, &value) in p.iter().enumerate().filter(|(_, x)| !x.is_finite()) {
            report.add(Defect::Inconsistent(MeshError::NonFinitePosition { vertex, axis, value }));
        }
    }
}

/// Reports degenerate and duplicate triangles; returns all triangles with their positions as corners, those
/// with an index out of range as degenerate ones.
fn find_bad_triangles(mesh: &IndexedMesh, report: &mut Report) -> Vec<[u32; 3]> {
    let position_of = index_positions(&mesh.positions);
    let mut triangles = Vec::with_capacity(mesh.triangles.len());
    for (triangle, &corners) in mesh.triangles.iter().enumerate() {
        if corners.iter().any(|&v| v as usize >= position_of.len()) {
            triangles.push([0; 3]);
            continue;
        }
        triangles.push(corners.map(|v| position_of[v as usize]));
        let [a, b, c] = corners;
        let pairs = || [[a, b], [b, c], [c, a]].into_iter();
        if let Some([vertex, _]) = pairs().find(|[v, w]| v == w) {
            report.add(Defect::RepeatedVertex { triangle, vertex });
        } else if let Some(vertices) =
            pairs().find(|[v, w]| position_of[*v as usize] == position_of[*w as usize])
        {
            report.add(Defect::RepeatedPosition { triangle, vertices });
        } else if area_of(mesh, triangle) == 0.0 {
            report.add(Defect::NoArea { triangle });
        }
    }
    for duplicate in duplicate_triangles(&triangles) {
        let (triangle, first) = (duplicate.triangle as usize, duplicate.first as usize);
        report.add(Defect::DuplicateTriangle { triangle, first, is_opposite: duplicate.is_opposite });
    }
    triangles
}

fn find_bad_topology(mesh: &IndexedMesh, triangles: &[[u32; 3]], report: &mut Report) {
    // There are never more positions than vertices.
    let adjacency = Adjacency::of_triangles(triangles.to_vec(), mesh.vertex_count());
    let vertex_at = |corner: u32| mesh.triangles[corner as usize / 3][corner as usize % 3];
    for edge in adjacency.edges().filter(|edge| edge.is_non_manifold() || edge.is_inconsistent()) {
        let mut sides = edge.sides();
        let side = sides.next().unwrap_or_default();
        let next_corner = if side % 3 == 2 { side - 2 } else { side + 1 };
        let mut vertices = [vertex_at(side), vertex_at(next_corner)];
        vertices.sort_unstable();
        report.add(if edge.is_non_manifold() {
            Defect::NonManifoldEdge { vertices, triangle_count: edge.side_count() }
        } else {
            let triangles = [side, sides.next().unwrap_or_default()].map(|side| side as usize / 3);
            Defect::InconsistentEdge { vertices, triangles }
        });
    }
    for position in adjacency.bow_ties() {
        let pieces = adjacency.link_components(position);
        report.add(Defect::BowTie { vertex: vertex_at(pieces[0]), piece_count: pieces.len() });
    }
}

fn find_bad_layers(mesh: &IndexedMesh, report: &mut Report) {
    for (index, layer) in mesh.layers.iter().enumerate() {
        if mesh.layers[..index].iter().any(|earlier| earlier.semantic == layer.semantic) {
            report.add(Defect::RepeatedLayer { semantic: layer.semantic.clone() });
        }
        let (found, expected) = (layer.component_count, expected_components(&layer.semantic));
        if !expected.counts.contains(&found) {
            let (semantic, expected) = (layer.semantic.clone(), expected.words);
            report.add(Defect::LayerShape { semantic, found, expected });
        }
        find_bad_attributes(layer, report);
    }
}

struct Components {
    counts: std::ops::RangeInclusive<u8>,
    words: &'static str,
}

fn expected_components(semantic: &Semantic) -> Components {
    let (counts, words) = match semantic {
        Semantic::Normal
        | Semantic::MorphPosition(_)
        | Semantic::MorphNormal(_)
        | Semantic::MorphTangent(_) => (3..=3, "3"),
        Semantic::Tangent | Semantic::Joints(_) | Semantic::Weights(_) => (4..=4, "4"),
        Semantic::TexCoord(_) => (2..=2, "2"),
        Semantic::Color(_) => (3..=4, "3 or 4"),
        Semantic::Generic(_) => (1..=255, "1 to 255"),
    };
    Components { counts, words }
}

fn find_bad_attributes(layer: &AttributeLayer, report: &mut Report) {
    // Integers are always finite, and their vectors have unit length up to quantization.
    let LayerData::F32(data) = &layer.data else { return };
    let is_unit = matches!(layer.semantic, Semantic::Normal | Semantic::Tangent);
    for (vertex, numbers) in data.chunks(usize::from(layer.component_count).max(1)).enumerate() {
        let semantic = || layer.semantic.clone();
        let mut is_finite = true;
        for (component, &value) in numbers.iter().enumerate().filter(|(_, x)| !x.is_finite()) {
            is_finite = false;
            report.add(Defect::NonFiniteAttribute { semantic: semantic(), vertex, component, value });
        }
        if is_unit && is_finite {
            let squares = numbers.iter().take(3).map(|&x| f64::from(x) * f64::from(x));
            let length = squares.sum::<f64>().sqrt();
            if (length - 1.0).abs() > 0.01 {
                report.add(Defect::NonUnitVector { semantic: semantic(), vertex, length });
            }
        }
    }
}

/// Reports joint weights that do not sum to 1. The tolerance of 0.01 allows for rounding: eight-bit weights
/// are off by up to 4 / 510 in total.
fn find_bad_weights(mesh: &IndexedMesh, report: &mut Report) {
    let vertex_count = mesh.vertex_count();
    let fits = |layer: &&AttributeLayer| {
        matches!(layer.semantic, Semantic::Weights(_))
            && layer.data.len() == vertex_count * usize::from(layer.component_count)
    };
    let sets: Vec<&AttributeLayer> = mesh.layers.iter().filter(fits).collect();
    if sets.is_empty() {
        return;
    }
    for vertex in 0..vertex_count {
        let weights = sets
            .iter()
            .flat_map(|set| (0..usize::from(set.component_count)).map(|c| f64::from(set.get(vertex, c))));
        let sum: f64 = weights.sum();
        // Weights that are not finite have been reported already.
        if sum.is_finite() && (sum - 1.0).abs() > 0.01 {
            report.add(Defect::WeightSum { vertex, sum });
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::shapes;

    fn lines(mesh: &IndexedMesh) -> Vec<String> {
        validate(mesh).to_string().lines().map(str::to_string).collect()
    }

    const SQUARE: [[f32; 3]; 4] = [[0., 0., 0.], [1., 0., 0.], [1., 1., 0.], [0., 1., 0.]];

    #[test]
    fn sound_meshes_have_no_defects() {
        for mesh in [shapes::hard_cube(), shapes::uv_cylinder(7, 2), shapes::two_material_sphere(4, 5)] {
            assert_eq!(lines(&mesh), Vec::<String>::new());
            assert!(validate(&mesh).is_clean());
        }
    }

    #[test]
    fn triangle_defects_are_reported() {
        let mut mesh = IndexedMesh::new(SQUARE.to_vec(), vec![[0, 1, 1], [0, 1, 4], [0, 1, 2], [2, 0, 1]]);
        mesh.positions.push([-0.0, 0.0, 0.0]);
        mesh.positions.push([2.0, 0.0, 0.0]);
        mesh.triangles.extend([[2, 1, 4], [0, 1, 5], [1, 9, 0]]);
        let expected = [
            "triangle 6 uses vertex 9, but there are 6 vertices",
            "triangle 0 uses vertex 1 twice",
            "triangle 1 uses vertices 4 and 0, which have the same position",
            "triangle 5 has collinear corners",
            "triangle 3 repeats triangle 2",
            "triangle 4 repeats triangle 2 facing the other way",
            "the edge between vertices 0 and 1 has 4 triangles",
            "the edge between vertices 2 and 4 has 3 triangles",
            "the edge between vertices 1 and 2 has 3 triangles",
            "vertex 3 is not used by any triangle",
        ];
        assert_eq!(lines(&mesh), expected);
    }

    #[test]
    fn topological_defects_are_reported() {
        assert_eq!(lines(&shapes::bow_tie()), ["2 pieces of surface meet only in vertex 0"]);
        let turned = IndexedMesh::new(SQUARE.to_vec(), vec![[0, 1, 2], [2, 0, 3]]);
        assert_eq!(
            lines(&turned),
            ["triangles 0 and 1 face opposite ways along the edge of vertices 0 and 2"]
        );
    }

    #[test]
    fn attribute_defects_are_reported() {
        let mut mesh = IndexedMesh::new(SQUARE.to_vec(), vec![[0, 1, 2], [0, 2, 3]]);
        let normals = vec![0., 0., 1., 0., 0., 2., 0., f32::NAN, 0., 0., 0., 0.995];
        mesh.layers = vec![
            AttributeLayer::from_f32(Semantic::Normal, 3, normals),
            AttributeLayer::from_f32(Semantic::Weights(0), 4, [[1.0, 0., 0., 0.]; 4].concat()),
            AttributeLayer::from_f32(
                Semantic::Weights(1),
                4,
                [[0.; 4], [0.; 4], [0.25; 4], [0.; 4]].concat(),
            ),
            AttributeLayer::from_f32(Semantic::Normal, 2, vec![1.0; 7]),
        ];
        let expected = [
            "layer normal has 7 values, but 4 vertices need 8",
            "layer normal has 2 components per vertex, but needs 3",
            "layer normal appears twice",
            "layer normal has NaN as component 1 of vertex 2",
            "layer normal has a vector of length 2.0000 at vertex 1, expected 1",
            "layer normal has a vector of length 1.4142 at vertex 0, expected 1",
            "layer normal has a vector of length 1.4142 at vertex 1, expected 1",
            "layer normal has a vector of length 1.4142 at vertex 2, expected 1",
            "the joint weights of vertex 2 sum to 2.0000, expected 1",
        ];
        assert_eq!(lines(&mesh), expected);
    }

    #[test]
    fn defects_beyond_the_listed_ones_are_counted() {
        let mesh = IndexedMesh::new(SQUARE.to_vec(), vec![[7, 8, 9]; 100]);
        let report = validate(&mesh);
        assert_eq!(report.count(DefectKind::Inconsistent), 300);
        assert_eq!(report.defects().len(), MAX_LISTED_PER_KIND + 4);
        let text = report.to_string();
        assert!(text.contains("… and 284 more inconsistencies"), "{text}");
        assert_eq!(report.counts().map(|(_, count)| count).collect::<Vec<_>>(), vec![300, 4]);
    }
}
