//! Quantized and compressed glTF that this crate writes is read back.

use crate::meshes::{read, sheet, square_with_everything};
use striata::mesh::{AttributeLayer, Image, IndexedMesh, Semantic, TriangleGroup};
use striata_io::{Format, QuantizeOptions, WriteOptions, to_bytes};

/// A wavy sheet with normals and texture coordinates, in two groups.
fn model() -> IndexedMesh {
    let mut mesh = sheet(24);
    let direction = |i: usize| {
        let (sin, cos) = (i as f32 * 0.37).sin_cos();
        [sin * 0.6, cos * 0.6, if i.is_multiple_of(3) { 0.8 } else { -0.8 }]
    };
    let normals = (0..mesh.vertex_count()).flat_map(direction).collect();
    let texcoords = mesh.positions.iter().flat_map(|[x, y, _]| [x / 24.0, y / 24.0]).collect();
    mesh.layers = vec![
        AttributeLayer::from_f32(Semantic::Normal, 3, normals),
        AttributeLayer::from_f32(Semantic::TexCoord(0), 2, texcoords),
    ];
    let group = |name: &str, start: u32, count: u32| TriangleGroup {
        name: name.to_owned(),
        first: start,
        count,
        material: None,
    };
    let triangle_count = mesh.triangle_count() as u32;
    mesh.groups = vec![group("a", 0, 100), group("b", 100, triangle_count - 100)];
    mesh
}

/// Position, normal and texture coordinates of the corners of all triangles of a group. Triangles are sorted
/// by the texture coordinates of their corners, which are far apart.
fn corners(mesh: &IndexedMesh, group: usize) -> Vec<[[f32; 8]; 3]> {
    let [normals, texcoords] =
        [Semantic::Normal, Semantic::TexCoord(0)].map(|semantic| mesh.layer(&semantic).unwrap());
    let corner = |v: u32| {
        let (v, [x, y, z]) = (v as usize, mesh.positions[v as usize]);
        let n = |c: usize| normals.get(v, c);
        [x, y, z, n(0), n(1), n(2), texcoords.get(v, 0), texcoords.get(v, 1)]
    };
    let cell = |corner: &[f32; 8]| [corner[6], corner[7]].map(|x| (x * 24.0).round() as i32);
    let mut triangles: Vec<[[f32; 8]; 3]> = mesh.triangles[mesh.groups[group].range()]
        .iter()
        .map(|&[a, b, c]| {
            let turns = [[a, b, c], [b, c, a], [c, a, b]].map(|turn| turn.map(corner));
            turns.into_iter().min_by_key(|turn| turn.each_ref().map(cell)).unwrap()
        })
        .collect();
    triangles.sort_by_key(|triangle| triangle.each_ref().map(cell));
    triangles
}

/// Asserts that a mesh is read back, up to tolerances of positions, normals and texture coordinates.
fn assert_near(options: &WriteOptions, tolerances: [f32; 3]) {
    let mesh = model();
    for format in [Format::Glb, Format::Gltf] {
        let bytes = to_bytes(format, &mesh, options).unwrap();
        let found = read(&format!("x.{}", format.extension()), &bytes).unwrap();
        for group in [0, 1] {
            assert_eq!(found.groups[group].name, mesh.groups[group].name);
            let (found, expected) = (corners(&found, group), corners(&mesh, group));
            assert_eq!(found.len(), expected.len());
            for (found, expected) in found.as_flattened().iter().zip(expected.as_flattened()) {
                for (place, (a, b)) in found.iter().zip(expected).enumerate() {
                    let tolerance = tolerances[[0, 0, 0, 1, 1, 1, 2, 2][place]];
                    assert!((a - b).abs() <= tolerance, "{found:?} is not {expected:?}");
                }
            }
        }
    }
}

fn quantized() -> WriteOptions {
    WriteOptions::default().with_quantize(QuantizeOptions::default())
}

/// Half a step of the default precision, and a rounding error; the reader normalizes normals again.
const HALF_STEPS: [f32; 3] = [0.5 * 24.0 / 16383.0 + 2e-6, 1.0 / 127.0, 0.5 / 4095.0 + 1e-5];

#[test]
fn quantized_meshes_are_read_within_half_a_step() {
    assert_near(&quantized(), HALF_STEPS);
    let finest =
        QuantizeOptions::default().with_position_bits(16).with_normal_bits(16).with_texcoord_bits(16);
    assert_near(&WriteOptions::default().with_quantize(finest), [2e-4, 2e-5, 1e-5]);
}

#[test]
fn every_layer_survives_quantization() {
    let mesh = square_with_everything();
    let found = read("x.glb", &to_bytes(Format::Glb, &mesh, &quantized()).unwrap()).unwrap();
    for layer in &mesh.layers {
        let own = found.layer(&layer.semantic).unwrap();
        assert_eq!(own.component_count, layer.component_count, "{}", layer.semantic);
        for vertex in 0..4 {
            for c in 0..layer.component_count.into() {
                let (a, b) = (own.get(vertex, c), layer.get(vertex, c));
                assert!((a - b).abs() <= 0.005 * b.abs().max(1.0), "{}: {a} is not {b}", layer.semantic);
            }
        }
    }
}

#[cfg(feature = "meshopt")]
#[test]
fn meshoptimizer_is_exact_without_quantization() {
    assert_near(&WriteOptions::default().with_meshopt(true), [0.0; 3]);
    // The octahedral filter rounds normals once more.
    assert_near(&quantized().with_meshopt(true), [HALF_STEPS[0], 0.02, HALF_STEPS[2]]);
}

#[cfg(feature = "draco")]
#[test]
fn draco_is_exact_without_quantization() {
    assert_near(&WriteOptions::default().with_draco(true), [0.0; 3]);
    assert_near(&quantized().with_draco(true), [HALF_STEPS[0], 0.02, HALF_STEPS[2]]);
}

#[cfg(all(feature = "meshopt", feature = "draco"))]
#[test]
fn compression_makes_files_smaller() {
    let mesh = model();
    let size = |options: &WriteOptions| to_bytes(Format::Glb, &mesh, options).unwrap().len();
    let plain = size(&WriteOptions::default());
    let quantized_size = size(&quantized());
    assert!(quantized_size * 10 < plain * 7, "{quantized_size} of {plain}");
    assert!(size(&quantized().with_meshopt(true)) * 10 < plain * 4);
    assert!(size(&quantized().with_draco(true)) * 10 < plain * 3);
}

#[cfg(feature = "meshopt")]
#[test]
fn strips_are_compressed() {
    let mesh = sheet(3);
    let row = |y: u32| (0..4).flat_map(move |x| [y * 4 + 4 + x, y * 4 + x]);
    let strip: Vec<u32> = (0..3).flat_map(|y| row(y).chain([y * 4 + 3, y * 4 + 8])).collect();
    let options = WriteOptions::default().with_strips(vec![strip[..28].to_vec()]);
    let triangles = |options: &WriteOptions| {
        let found = read("x.glb", &to_bytes(Format::Glb, &mesh, options).unwrap()).unwrap();
        let points = |&[a, b, c]: &[u32; 3]| {
            let turns = [[a, b, c], [b, c, a], [c, a, b]];
            turns.map(|turn| turn.map(|v| found.positions[v as usize].map(f32::to_bits))).into_iter().min()
        };
        let mut triangles: Vec<_> = found.triangles.iter().map(points).collect();
        triangles.sort();
        triangles
    };
    assert_eq!(triangles(&options.clone().with_meshopt(true)), triangles(&options));
}

#[test]
fn two_compressions_are_refused() {
    let both = WriteOptions::default().with_meshopt(true).with_draco(true);
    let message = to_bytes(Format::Glb, &model(), &both).unwrap_err().to_string();
    assert!(message.contains("both Draco and meshoptimizer"), "{message}");
}

#[test]
fn empty_meshes_are_written() {
    for options in [
        quantized(),
        quantized().with_meshopt(cfg!(feature = "meshopt")),
        quantized().with_draco(cfg!(feature = "draco")),
    ] {
        let bytes = to_bytes(Format::Glb, &IndexedMesh::default(), &options).unwrap();
        assert_eq!(read("x.glb", &bytes).unwrap().triangle_count(), 0);
    }
}

/// A `.gltf` has its buffer and images next to it, unless they are to be embedded.
#[test]
fn gltf_files_have_files_next_to_them() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name);
    let (mut mesh, plain) = (square_with_everything(), WriteOptions::default());
    let png = b"\x89PNG\r\n\x1a\n and more".to_vec();
    let image = |name: &str| Image { name: name.into(), mime_type: "image/png".into(), ..Image::default() };
    mesh.appearance.images =
        ["wood", "stone"].map(|name| Image { bytes: [&png, name.as_bytes()].concat(), ..image(name) }).into();
    let images = mesh.appearance.images.len();
    let names = || {
        let entries = std::fs::read_dir(folder.path()).unwrap();
        let mut names: Vec<_> =
            entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
        names.sort();
        names
    };
    let expected = read("x.glb", &to_bytes(Format::Glb, &mesh, &plain).unwrap()).unwrap();
    let matches = |name: &str| {
        let found = striata_io::read(path(name)).unwrap();
        assert_eq!((&found.positions, &found.triangles), (&expected.positions, &expected.triangles));
        let bytes = |mesh: &IndexedMesh| -> Vec<Vec<u8>> {
            mesh.appearance.images.iter().map(|image| image.bytes.clone()).collect()
        };
        assert_eq!(bytes(&found), bytes(&expected));
    };
    for _ in 0..2 {
        striata_io::write(path("a b.gltf"), &mesh, &plain).unwrap();
        assert_eq!(names().len(), 2 + images, "{:?}", names());
        matches("a b.gltf");
    }
    let document = std::fs::read_to_string(path("a b.gltf")).unwrap();
    assert!(document.contains("\"a%20b.bin\"") && !document.contains("data:"));
    // A buffer of somebody else stays; equal images are shared.
    std::fs::write(path("c.bin"), b"mine").unwrap();
    let warnings = striata_io::write_with_report(path("c.gltf"), &mesh, &plain).unwrap();
    assert!(warnings.iter().any(|warning| warning.to_string().contains("c.bin")), "{warnings:?}");
    assert_eq!(std::fs::read(path("c.bin")).unwrap(), b"mine");
    assert!(names().contains(&"c-2.bin".to_owned()));
    assert_eq!(names().len(), 5 + images);
    matches("c.gltf");
    striata_io::write(path("d.gltf"), &mesh, &plain.with_embed(true)).unwrap();
    assert_eq!(names().len(), 6 + images);
    matches("d.gltf");
}
