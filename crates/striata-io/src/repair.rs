//! Values that are no numbers, or infinite: the last step of every reader, in memory and in pieces.
//!
//! A vertex without a usable position is left out, with the triangles that use it. A value of an attribute is
//! replaced by one that changes nothing: normals and tangents follow from the triangles, colors are white,
//! everything else is zero. Generic attributes are kept, because NaN means "no value" in them. All omissions
//! and replacements are counted.
//!
//! Cost: one pass that compares sixteen bytes at a time, about 1 % of reading a binary file.

mod frames;

use striata::mesh::{AttributeLayer, IndexedMesh, LayerData, Semantic};

use crate::ReadError;
use crate::error::Place;
use crate::report::{WarningKind, Warnings, with_commas};

const TRIANGLES: WarningKind = WarningKind("triangle left out", "triangles left out");

/// Leaves out vertices whose positions are not finite, and replaces values of attributes that are not.
pub(crate) fn repair(mesh: &mut IndexedMesh, warnings: &mut Warnings) {
    if has_strange(mesh.positions.as_flattened()) {
        drop_vertices(mesh, warnings);
    }
    if mesh.layers.iter().any(is_strange) {
        repair_layers(mesh, warnings);
    }
}

/// Whether a piece needs any repair.
#[cfg(feature = "pieces")]
pub(crate) fn needs_repair(positions: &[[f32; 3]], layers: &[AttributeLayer]) -> bool {
    has_strange(positions.as_flattened()) || layers.iter().any(is_strange)
}

/// Refuses a file of which nothing can be shown, with its numbers of vertices and triangles as read and the
/// number of triangles that are left. A file without vertices is an empty mesh.
pub(crate) fn check_triangles(
    [vertices, triangles]: [usize; 2],
    left: usize,
    warnings: &Warnings,
) -> Result<(), ReadError> {
    let file = || warnings.file().to_owned();
    if left > 0 || (vertices == 0 && triangles == 0 && warnings.shapes().is_none()) {
        return Ok(());
    }
    if triangles > 0 {
        let mut lost = warnings.first_of(TRIANGLES).map_or(String::new(), |lost| lost.reason.clone());
        // The first value that is no number says more than what became of it.
        if let Some(word) = warnings.first_of(WarningKind::WORDS) {
            lost += &format!(" ({}: {})", word.place, word.reason);
        }
        return Err(ReadError::NothingLeft { file: file(), reason: lost });
    }
    let points = with_commas(vertices as u64);
    let points = format!("{points} {}", if vertices == 1 { "point" } else { "points" });
    let found = match warnings.shapes() {
        Some(shapes) if vertices == 0 => shapes,
        Some(shapes) => format!("{points}, {shapes}"),
        None => points,
    };
    // Triangles may be missing because something could not be read.
    let found = warnings.fault().map_or(found.clone(), |fault| format!("{found} ({fault})"));
    Err(ReadError::NoTriangles { file: file(), found })
}

/// Whether a vertex has a position that is not finite.
pub(crate) fn is_lost(position: &[f32; 3]) -> bool {
    !position.iter().all(|x| x.is_finite())
}

/// Whether some value is not finite. Comparing the largest exponent has no early exit, and is done many
/// values at a time.
fn has_strange(values: &[f32]) -> bool {
    const BLOCK: usize = 1 << 12;
    const EXPONENT: u32 = 0x7f80_0000;
    let is_strange = |x: &f32| x.to_bits() & EXPONENT == EXPONENT;
    values.chunks(BLOCK).any(|block| block.iter().fold(false, |any, x| any | is_strange(x)))
}

fn is_strange(layer: &AttributeLayer) -> bool {
    match (&layer.data, &layer.semantic) {
        (_, Semantic::Generic(_)) => false,
        (LayerData::F32(values), _) => has_strange(values),
        (LayerData::F64(values), _) => values.iter().any(|x| !x.is_finite()),
        _ => false,
    }
}

#[cold]
fn drop_vertices(mesh: &mut IndexedMesh, warnings: &mut Warnings) {
    let is_lost: Vec<bool> = mesh.positions.iter().map(is_lost).collect();
    let lost_corner = |t: &[u32; 3]| t.iter().copied().find(|&v| is_lost.get(v as usize) == Some(&true));
    let mut lost = mesh.triangles.iter().enumerate().filter_map(|(i, t)| Some((i, lost_corner(t)?)));
    if let Some((triangle, vertex)) = lost.next() {
        let count = 1 + lost.count() as u64;
        let value = mesh.positions[vertex as usize].iter().find(|x| !x.is_finite()).copied();
        let reason = format!("its vertex {vertex} has the coordinate {}", value.unwrap_or(f32::NAN));
        warnings.count_many(TRIANGLES, count, || (Place::Triangle(triangle as u64), reason));
    }
    *mesh = mesh.without_vertices(&is_lost);
}

/// Returns the text of a warning about repaired values of a semantic.
fn kind_of(semantic: &Semantic) -> WarningKind {
    match semantic {
        Semantic::Normal => WarningKind("normal computed anew", "normals computed anew"),
        Semantic::Tangent => WarningKind("tangent computed anew", "tangents computed anew"),
        Semantic::Color(_) => WarningKind("color made white", "colors made white"),
        Semantic::TexCoord(_) => WarningKind("texture coordinate set to 0", "texture coordinates set to 0"),
        Semantic::Weights(_) => {
            WarningKind("set of joint weights normalized", "sets of joint weights normalized")
        }
        Semantic::Joints(_) => WarningKind("set of joints set to 0", "sets of joints set to 0"),
        _ => WarningKind("morph displacement set to 0", "morph displacements set to 0"),
    }
}

#[cold]
fn repair_layers(mesh: &mut IndexedMesh, warnings: &mut Warnings) {
    let strange = mesh.layers.iter().enumerate().filter(|(_, layer)| is_strange(layer));
    let strange: Vec<(usize, Vec<usize>)> =
        strange.map(|(index, layer)| (index, strange_vertices(layer))).collect();
    for (index, vertices) in &strange {
        let layer = &mut mesh.layers[*index];
        let reason = format!("the layer {} has a value that is not finite", layer.semantic);
        let first = vertices.first().map_or(Place::File, |&vertex| Place::Vertex(vertex as u64));
        warnings.count_many(kind_of(&layer.semantic), vertices.len() as u64, || (first, reason));
        let replacement = if matches!(layer.semantic, Semantic::Color(_)) { 1.0 } else { 0.0 };
        if let LayerData::F32(values) = &mut layer.data {
            values.iter_mut().filter(|x| !x.is_finite()).for_each(|x| *x = replacement);
        } else if let LayerData::F64(values) = &mut layer.data {
            values.iter_mut().filter(|x| !x.is_finite()).for_each(|x| *x = f64::from(replacement));
        }
    }
    let of_kind = |wanted: fn(&Semantic) -> bool, mesh: &IndexedMesh| -> Vec<(usize, Vec<usize>)> {
        strange.iter().filter(|(index, _)| wanted(&mesh.layers[*index].semantic)).cloned().collect()
    };
    for (index, vertices) in of_kind(|semantic| *semantic == Semantic::Normal, mesh) {
        frames::set_normals(mesh, index, &vertices);
    }
    // These follow from the normals.
    for (index, vertices) in of_kind(|semantic| *semantic == Semantic::Tangent, mesh) {
        frames::set_tangents(mesh, index, &vertices);
    }
    for (_, vertices) in of_kind(|semantic| matches!(semantic, Semantic::Weights(_)), mesh) {
        vertices.iter().for_each(|&vertex| normalize_weights(&mut mesh.layers, vertex));
    }
}

/// Scales the weights of a vertex in all sets to the sum 1; if all are zero, the first joint moves it.
fn normalize_weights(layers: &mut [AttributeLayer], vertex: usize) {
    let total: f32 =
        layers.iter_mut().filter_map(|layer| weights_of(layer, vertex)).flatten().map(|x| *x).sum();
    let mut rows = layers.iter_mut().filter_map(|layer| weights_of(layer, vertex));
    if total > 0.0 && total.is_finite() {
        rows.flatten().for_each(|weight| *weight /= total);
    } else if let Some(first) = rows.next().and_then(<[f32]>::first_mut) {
        *first = 1.0;
    }
}

fn weights_of(layer: &mut AttributeLayer, vertex: usize) -> Option<&mut [f32]> {
    match (&layer.semantic, &mut layer.data) {
        (Semantic::Weights(_), LayerData::F32(values)) => {
            let width = usize::from(layer.component_count);
            values.get_mut(vertex * width..(vertex + 1) * width)
        }
        _ => None,
    }
}

/// Vertices with a value that is not finite, in increasing order.
fn strange_vertices(layer: &AttributeLayer) -> Vec<usize> {
    let width = usize::from(layer.component_count);
    let is_finite = |vertex: usize| (0..width).all(|component| layer.get(vertex, component).is_finite());
    (0..layer.data.len() / width.max(1)).filter(|&vertex| !is_finite(vertex)).collect()
}

#[cfg(test)]
mod tests {
    use striata::mesh::TriangleGroup;

    use super::*;

    const NAN: f32 = f32::NAN;

    fn repaired(mut mesh: IndexedMesh) -> (IndexedMesh, Vec<String>) {
        let mut warnings = Warnings::of_file("a");
        repair(&mut mesh, &mut warnings);
        mesh.check().unwrap();
        (mesh, warnings.into_list().iter().map(ToString::to_string).collect())
    }

    fn square() -> IndexedMesh {
        let positions = vec![[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]];
        IndexedMesh::new(positions, vec![[0, 1, 2], [0, 2, 3]])
    }

    #[test]
    fn triangles_of_lost_vertices_are_left_out_of_their_groups() {
        let mut mesh = square();
        mesh.positions[1][2] = NAN;
        mesh.positions.push([f32::INFINITY; 3]);
        let group = |first| TriangleGroup { first, count: 1, ..TriangleGroup::default() };
        mesh.groups = vec![group(0), group(1)];
        mesh.layers =
            vec![AttributeLayer::from_f32(Semantic::Color(0), 3, (0..15).map(|x| x as f32).collect())];
        let (mesh, warnings) = repaired(mesh);
        assert_eq!((mesh.vertex_count(), &mesh.triangles[..]), (3, &[[0, 1, 2]][..]));
        assert_eq!(mesh.layers[0].get(1, 0), 6.0);
        assert_eq!(mesh.groups.iter().map(|g| (g.first, g.count)).collect::<Vec<_>>(), [(0, 0), (0, 1)]);
        assert_eq!(warnings, ["a: 1 triangle left out, triangle 0: its vertex 1 has the coordinate NaN"]);
    }

    #[test]
    fn values_are_replaced_by_what_changes_nothing() {
        let mut mesh = square();
        let layer = AttributeLayer::from_f32;
        let mut with = |semantic, count: u8, first: &[f32], rest: &[f32]| {
            let values = [first, &rest.repeat(3)].concat();
            mesh.layers.push(layer(semantic, count, values));
        };
        with(Semantic::Normal, 3, &[0.0, NAN, 1.0], &[0.0, 1.0, 0.0]);
        with(Semantic::Tangent, 4, &[NAN; 4], &[0.0, 0.0, 1.0, 1.0]);
        with(Semantic::TexCoord(0), 2, &[NAN, 0.5], &[0.5, 0.25]);
        with(Semantic::Color(0), 4, &[0.5, NAN, 0.5, f32::INFINITY], &[0.5; 4]);
        with(Semantic::Weights(0), 4, &[NAN, 0.25, 0.25, 0.0], &[1.0, 0.0, 0.0, 0.0]);
        with(Semantic::MorphPosition(0), 3, &[1.0, 2.0, f32::NEG_INFINITY], &[1.0; 3]);
        with(Semantic::Generic("heat".to_owned()), 1, &[NAN], &[1.0]);
        let doubles = LayerData::F64(vec![0.5, f64::NAN, 0.5, 1.0, 0.0, 0.0, 0.0, 0.0]);
        mesh.layers.push(AttributeLayer { data: doubles, ..layer(Semantic::TexCoord(1), 2, Vec::new()) });
        let (mesh, warnings) = repaired(mesh);
        let row = |layer: usize| -> Vec<f32> {
            (0..usize::from(mesh.layers[layer].component_count))
                .map(|c| mesh.layers[layer].get(0, c))
                .collect()
        };
        assert_eq!(row(0), [0.0, 0.0, 1.0]);
        let tangent = row(1);
        assert!(tangent[2] == 0.0 && (tangent[0].hypot(tangent[1]) - 1.0).abs() < 1e-6, "{tangent:?}");
        assert_eq!(row(2), [0.0, 0.5]);
        assert_eq!(row(3), [0.5, 1.0, 0.5, 1.0]);
        assert_eq!(row(4), [0.0, 0.5, 0.5, 0.0]);
        assert_eq!(row(5), [1.0, 2.0, 0.0]);
        assert!(row(6)[0].is_nan(), "NaN means no value");
        assert_eq!(row(7), [0.5, 0.0]);
        assert_eq!(warnings.len(), 6, "{warnings:?}");
        assert!(
            warnings
                .iter()
                .any(|w| w.starts_with("a: 2 texture coordinates set to 0, the first is vertex 0"))
        );
        let expected = "a: 1 color made white, vertex 0: the layer color_0 has a value that is not finite";
        assert_eq!(warnings[3], expected);
    }

    #[test]
    fn every_value_is_examined() {
        let mut values = vec![-1e38f32; 10_000];
        assert!(!has_strange(&values));
        for at in [0, 4095, 4096, 9999] {
            for strange in [NAN, -NAN, f32::INFINITY, f32::NEG_INFINITY] {
                let before = std::mem::replace(&mut values[at], strange);
                assert!(has_strange(&values), "{strange} at {at}");
                values[at] = before;
            }
        }
    }
}
