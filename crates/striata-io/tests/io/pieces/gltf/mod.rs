//! Pieces of glTF files, put together, are the mesh that the reader of whole files makes: the same triangles
//! with the same numbers in the same order.

mod damaged;
mod large;
mod random;
mod scene;

use std::path::Path;

use serde_json::json;
use striata::mesh::{AttributeLayer, IndexedMesh, shapes};
use striata_io::pieces::{LayerKind, Piece, PieceGroup, PieceOptions, PieceSource, open_pieces};
use striata_io::{Format, QuantizeOptions, ReadError, WriteOptions, read_with_report, to_bytes};
use striata_testing::scenes::{self, TestScene};
use tempfile::TempDir;

use self::scene::{Numbers, with_files};
use super::corner;

/// Group and corners of each triangle, as bits of positions and layers.
type Triangles = Vec<(u32, [Vec<u32>; 3])>;

fn add(
    all: &mut Triangles,
    mesh: (&[[f32; 3]], &[AttributeLayer], &[[u32; 3]]),
    group: impl Fn(usize) -> u32,
) {
    let (positions, layers, triangles) = mesh;
    for (index, triangle) in triangles.iter().enumerate() {
        all.push((group(index), triangle.map(|v| corner(positions, layers, v))));
    }
}

fn of_mesh(mesh: &IndexedMesh) -> Triangles {
    let mut all = Triangles::new();
    for (number, group) in (0..).zip(mesh.groups_or_whole()) {
        let triangles = &mesh.triangles[group.range()];
        add(&mut all, (&mesh.positions, &mesh.layers, triangles), |_| number);
    }
    all
}

fn of_piece(all: &mut Triangles, piece: &Piece) {
    let group = |triangle: usize| piece.groups.get(triangle).map_or(0, |&group| group);
    add(all, (&piece.positions, &piece.layers, &piece.triangles), group);
}

fn of_source(source: &dyn PieceSource) -> Result<Triangles, ReadError> {
    let mut all = Triangles::new();
    for index in 0..source.piece_count() {
        let piece = source.read_piece(index)?;
        let kinds: Vec<LayerKind> = piece.layers.iter().map(LayerKind::of).collect();
        assert_eq!(kinds, source.summary().layers);
        assert!(!piece.triangles.is_empty(), "no piece is empty");
        assert_eq!(piece.groups.is_empty(), source.summary().groups.len() < 2);
        of_piece(&mut all, &piece);
    }
    Ok(all)
}

fn options(piece_triangle_count: u32) -> PieceOptions {
    PieceOptions::default().with_piece_triangle_count(piece_triangle_count)
}

/// Compares all pieces of a file, in several sizes, with the whole; returns the whole.
fn check_file(path: &Path, sizes: &[u32]) -> IndexedMesh {
    let report = match read_with_report(path) {
        Err(ReadError::NoTriangles { .. }) => {
            let found = open_pieces(path, &options(sizes[0]));
            assert!(matches!(found, Err(ReadError::NoTriangles { .. })));
            return IndexedMesh::default();
        }
        report => report.unwrap(),
    };
    let mesh = report.mesh;
    mesh.check().unwrap();
    let warnings = report.warnings.clone();
    let groups = mesh.groups_or_whole().into_iter();
    let groups: Vec<PieceGroup> =
        groups.map(|group| PieceGroup { name: group.name, material: group.material }).collect();
    let whole = of_mesh(&mesh);
    for &size in sizes {
        let source = open_pieces(path, &options(size)).unwrap();
        let summary = source.summary();
        assert_eq!(summary.layers, mesh.layers.iter().map(LayerKind::of).collect::<Vec<_>>());
        assert_eq!(summary.groups, groups);
        assert_eq!(summary.appearance, mesh.appearance);
        assert_eq!(summary.warnings, warnings);
        assert_eq!(summary.triangle_count, whole.len() as u64);
        let most = 4 * (whole.len() as u64).div_ceil(u64::from(size)) + 1;
        assert!(source.piece_count() <= most, "{} pieces of {size}", source.piece_count());
        assert!(of_source(&*source).unwrap() == whole, "{} in pieces of {size}", path.display());
    }
    mesh
}

const SIZES: [u32; 5] = [1, 7, 60, 1000, u32::MAX];

/// Checks a scene as GLB, and as glTF with two buffers in files.
fn check(scene: &TestScene) -> IndexedMesh {
    let folder = TempDir::new().unwrap();
    let path = folder.path().join("scene.glb");
    std::fs::write(&path, scene.to_glb()).unwrap();
    let mesh = check_file(&path, &SIZES);
    let path = with_files(scene, folder.path());
    assert_eq!(check_file(&path, &SIZES[2..]), mesh);
    mesh
}

fn check_bytes(bytes: &[u8], sizes: &[u32]) -> IndexedMesh {
    let folder = TempDir::new().unwrap();
    let path = folder.path().join("scene.glb");
    std::fs::write(&path, bytes).unwrap();
    check_file(&path, sizes)
}

#[test]
fn scenes_of_all_kinds() {
    for scene in scenes::all() {
        check(&scene);
    }
}

#[test]
fn sizes_of_files_are_added_up() {
    let folder = TempDir::new().unwrap();
    let path = with_files(&scenes::hierarchy(), folder.path());
    let files =
        std::fs::read_dir(folder.path()).unwrap().map(|entry| entry.unwrap().metadata().unwrap().len());
    let source = open_pieces(&path, &options(100)).unwrap();
    assert_eq!(source.summary().byte_count, files.sum::<u64>());
}

/// A sheet as compressed, quantized and plain glTF, with strips and fans.
#[test]
fn files_of_the_writer() {
    let mut mesh = shapes::two_material_sphere(24, 36);
    let (count, half) = (mesh.triangle_count(), mesh.groups[0].count as usize);
    let fan = |triangles: &[[u32; 3]]| triangles.iter().map(|triangle| triangle.to_vec()).collect::<Vec<_>>();
    let fans = vec![fan(&mesh.triangles[..half]), fan(&mesh.triangles[half..])];
    let stitched = |triangles: &[[u32; 3]]| {
        let mut strip: Vec<u32> = Vec::new();
        for &[a, b, c] in triangles {
            if let Some(&last) = strip.last() {
                strip.extend([last, a]);
                if strip.len() % 2 == 1 {
                    strip.push(a);
                }
            }
            strip.extend([a, b, c]);
        }
        strip
    };
    let strips = vec![stitched(&mesh.triangles[..half]), stitched(&mesh.triangles[half..])];
    mesh.groups[1].name = "another".to_owned();
    let plain = WriteOptions::default();
    let quantized = plain.clone().with_quantize(QuantizeOptions::default());
    for options in [
        plain.clone(),
        quantized.clone(),
        plain.clone().with_fans(fans),
        plain.clone().with_strips(strips),
        plain.clone().with_meshopt(cfg!(feature = "meshopt")),
        quantized.clone().with_meshopt(cfg!(feature = "meshopt")),
        plain.with_draco(cfg!(feature = "draco")),
        quantized.with_draco(cfg!(feature = "draco")),
    ] {
        let bytes = to_bytes(Format::Glb, &mesh, &options).unwrap();
        let found = check_bytes(&bytes, &SIZES);
        assert_eq!((found.triangle_count(), found.groups.len()), (count, 2), "{options:?}");
        let path = TempDir::new().unwrap();
        let path = path.path().join("scene.gltf.gz");
        std::fs::create_dir_all(path.parent().unwrap()).unwrap();
        let text = to_bytes(Format::Gltf, &mesh, &options).unwrap();
        let mut gzip = flate2::write::GzEncoder::new(Vec::new(), flate2::Compression::fast());
        std::io::Write::write_all(&mut gzip, &text).unwrap();
        std::fs::write(&path, gzip.finish().unwrap()).unwrap();
        check_file(&path, &[60]);
    }
}

/// A primitive for each mode and type of indices, over interleaved and quantized vertices.
#[test]
fn every_mode_and_type() {
    let mut scene = TestScene::named("modes");
    let corners: Vec<f64> = (0..90).map(f64::from).collect();
    let position = Numbers::new(5122, "VEC3").with_gap(2).push(&mut scene, &corners);
    let color = Numbers::new(5121, "VEC3").normalized().with_gap(1).push(&mut scene, &corners);
    let attributes = json!({ "POSITION": position, "COLOR_0": color });
    let numbers: Vec<f64> = [0, 1, 2, 3, 3, 4, 5, 4, 29, 29, 7, 8, 9, 1, 0, 12, 13].map(f64::from).to_vec();
    let mut primitives = Vec::new();
    for mode in 0..=6 {
        primitives.push(json!({ "attributes": attributes, "mode": mode }));
        for component in [5121, 5123, 5125] {
            let indices = Numbers::new(component, "SCALAR").push(&mut scene, &numbers);
            primitives.push(json!({ "attributes": attributes, "indices": indices, "mode": mode }));
            let indices = Numbers::new(component, "SCALAR").sparse(&[3, 4, 16]).push(&mut scene, &numbers);
            primitives.push(json!({ "attributes": attributes, "indices": indices, "mode": mode }));
        }
    }
    scene.push("meshes", json!({ "name": "all", "primitives": primitives }));
    let mesh = check(&scene);
    // 30 vertices in order, and 17 indices in six ways; strips lose degenerate triangles, and fans are one
    // group.
    let [lists, strips, fans] = [10 + 6 * 5, 28 + 6 * 10, 28 + 6 * 11];
    assert_eq!(mesh.triangle_count(), lists + strips + fans);
    assert_eq!(mesh.groups.len(), 7 + 7 + 1);
}

/// Several objects, of which some lack normals: those of vertices that primitives share depend on all of
/// these.
#[test]
fn missing_normals_are_computed_from_all_primitives_of_the_vertices() {
    let mut scene = TestScene::named("normals");
    let bare = shapes::two_material_sphere(12, 16);
    let bare = IndexedMesh { layers: Vec::new(), ..bare };
    let with = shapes::torus(12, 9, 2.0, 0.5);
    let with = IndexedMesh { layers: Vec::new(), ..with };
    let both = scene.push_mesh("both", &bare);
    let ring = scene.push_mesh("ring", &with);
    let normals = [0.0, 0.6, 0.8].repeat(with.vertex_count());
    let normals = scene.push_floats("VEC3", 3, &normals);
    scene.document["meshes"][ring]["primitives"][0]["attributes"]["NORMAL"] = json!(normals);
    scene.document["materials"] = json!([{}, {}]);
    scene.document["nodes"] = json!([
        { "mesh": both }, { "mesh": ring }, { "mesh": both },
        { "mesh": both, "scale": [-1, 2, 3], "translation": [5, 0, 0] },
    ]);
    scene.document["scenes"] = json!([{ "nodes": [0, 1, 2, 3] }]);
    let mesh = check(&scene);
    assert_eq!(mesh.layers.len(), 1);
}

#[test]
fn threads_read_pieces_in_any_order() {
    let folder = TempDir::new().unwrap();
    let mesh = shapes::two_material_sphere(48, 60);
    let options = WriteOptions::default().with_meshopt(cfg!(feature = "meshopt"));
    let path = folder.path().join("sphere.glb");
    std::fs::write(&path, to_bytes(Format::Glb, &mesh, &options).unwrap()).unwrap();
    let source = open_pieces(&path, &self::options(50)).unwrap();
    let pieces: Vec<Piece> = (0..source.piece_count()).map(|i| source.read_piece(i).unwrap()).collect();
    let (source, pieces) = (&source, &pieces);
    std::thread::scope(|scope| {
        for thread in 0..4 {
            scope.spawn(move || {
                let count = pieces.len();
                for step in 0..3 * count {
                    // Steps that no number of pieces below 100 divides.
                    let index = (step * 101 + thread * 7) % count;
                    assert!(source.read_piece(index as u64).unwrap() == pieces[index]);
                }
            });
        }
    });
}

#[test]
fn many_small_primitives_share_pieces() {
    let count = 20_000;
    let mut scene = TestScene::named("many");
    let corners: Vec<f64> = (0..30).map(f64::from).collect();
    let position = Numbers::new(5121, "VEC3").push(&mut scene, &corners);
    let indices = Numbers::new(5121, "SCALAR").push(&mut scene, &[0.0, 1.0, 2.0, 2.0, 1.0, 3.0]);
    scene.document["meshes"] = json!("MESHES");
    let mesh = json!({ "primitives": [{ "attributes": { "POSITION": position }, "indices": indices }] });
    let meshes = vec![mesh.to_string(); count].join(",");
    let bytes = scene.to_glb_with(&[("MESHES", format!("[{meshes}]"))]);
    let folder = TempDir::new().unwrap();
    let path = folder.path().join("many.glb");
    std::fs::write(&path, bytes).unwrap();
    let source = open_pieces(&path, &options(1000)).unwrap();
    assert_eq!(source.summary().groups.len(), count);
    assert_eq!(source.piece_count(), 2 * count as u64 / 1000);
    let piece = source.read_piece(7).unwrap();
    assert_eq!((piece.positions.len(), piece.triangles.len()), (4, 1000), "the primitives share vertices");
    assert_eq!(piece.groups[..3], [3500, 3500, 3501]);
}
