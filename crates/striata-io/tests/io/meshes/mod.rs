//! Meshes and helpers that the tests share.

use striata::mesh::{AttributeLayer, IndexedMesh, LayerData, Semantic, TriangleGroup};
use striata_io::{Format, ReadError, Source, WriteOptions, read_bytes, to_bytes};

pub(crate) fn read(name: &str, bytes: &[u8]) -> Result<IndexedMesh, ReadError> {
    read_bytes(bytes, &Source::new(name))
}

/// Returns the message of the error that reading must give.
pub(crate) fn refused(name: &str, bytes: &[u8]) -> String {
    match read(name, bytes) {
        Err(error) => error.to_string(),
        Ok(mesh) => panic!("{name} was read as {mesh:?}"),
    }
}

pub(crate) fn written(format: Format, mesh: &IndexedMesh) -> Vec<u8> {
    to_bytes(format, mesh, &WriteOptions::default()).unwrap()
}

pub(crate) fn round_trip(format: Format, mesh: &IndexedMesh) -> IndexedMesh {
    read(&format!("x.{}", format.extension()), &written(format, mesh)).unwrap()
}

/// Two triangles that form a unit square.
pub(crate) fn square() -> IndexedMesh {
    IndexedMesh::new(
        vec![[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.1], [0.0, 1.0, 1e-7]],
        vec![[0, 1, 2], [0, 2, 3]],
    )
}

/// The square with a layer of every semantic, in types that both PLY and glTF can store.
pub(crate) fn square_with_everything() -> IndexedMesh {
    let mut mesh = square();
    let f32s = |n: usize, scale: f32| (0..4 * n).map(|i| (i as f32 + 0.3) * scale).collect::<Vec<f32>>();
    let layer = AttributeLayer::from_f32;
    let integers = |semantic, component_count, normalized, data| AttributeLayer {
        semantic,
        component_count,
        normalized,
        data,
    };
    let tangents = [1.0, 0.0, 0.0, -1.0].repeat(4);
    mesh.layers = vec![
        layer(Semantic::Normal, 3, [0.0, 0.6, 0.8].repeat(4)),
        layer(Semantic::Tangent, 4, tangents),
        layer(Semantic::TexCoord(0), 2, f32s(2, 0.1)),
        integers(Semantic::TexCoord(1), 2, true, LayerData::U16((0..8).map(|i| i * 9000).collect())),
        integers(Semantic::Color(0), 3, true, LayerData::U8((0..12).map(|i| i * 20).collect())),
        layer(Semantic::Color(1), 4, f32s(4, 0.05)),
        integers(Semantic::Joints(0), 4, false, LayerData::U8((0..16).collect())),
        layer(Semantic::Weights(0), 4, [0.25; 16].to_vec()),
        layer(Semantic::MorphPosition(0), 3, f32s(3, 0.01)),
        layer(Semantic::MorphPosition(1), 3, f32s(3, -0.01)),
        layer(Semantic::MorphNormal(1), 3, f32s(3, 0.02)),
        layer(Semantic::MorphTangent(1), 3, f32s(3, 0.03)),
        layer(Semantic::Generic("heat".to_owned()), 1, f32s(1, 100.0)),
        integers(Semantic::Generic("ids".to_owned()), 2, false, LayerData::U16((0..8).collect())),
        integers(Semantic::Generic("share".to_owned()), 1, true, LayerData::U8(vec![0, 85, 170, 255])),
    ];
    mesh
}

/// A grid of `n * n` squares on a wavy sheet.
pub(crate) fn sheet(n: u32) -> IndexedMesh {
    let wave = |x: u32, y: u32| ((x * 7 + y * 13) % 11) as f32 / 10.0;
    let positions =
        (0..=n).flat_map(|y| (0..=n).map(move |x| [x as f32, y as f32, wave(x, y)])).collect::<Vec<_>>();
    let corner = |x: u32, y: u32| y * (n + 1) + x;
    let cell = |x: u32, y: u32| {
        let (a, b, c, d) = (corner(x, y), corner(x + 1, y), corner(x + 1, y + 1), corner(x, y + 1));
        [[a, b, c], [a, c, d]]
    };
    let triangles = (0..n).flat_map(|y| (0..n).flat_map(move |x| cell(x, y))).collect();
    IndexedMesh::new(positions, triangles)
}

pub(crate) fn group(name: &str, material: Option<u32>, first: u32, count: u32) -> TriangleGroup {
    TriangleGroup { name: name.to_owned(), material, first, count }
}

/// Returns the positions of all triangle corners, in order: the mesh without its vertex numbering.
pub(crate) fn soup(mesh: &IndexedMesh) -> Vec<[[f32; 3]; 3]> {
    mesh.triangles.iter().map(|t| t.map(|v| mesh.positions[v as usize])).collect()
}
