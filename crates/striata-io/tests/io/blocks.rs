//! Meshes that are read from files in blocks, and written strip by strip.

use std::fs;
use std::path::{Path, PathBuf};

use striata::mesh::{AttributeLayer, IndexedMesh, LayerData, Semantic, canonical_triangles, shapes};
use striata::strip::{restart_triangles_into, strip_triangles};
use striata_io::{
    Format, ReadError, Source, StripSpool, TriangleBlocks, WriteOptions, read, read_bytes, to_bytes,
};
use striata_strip::{Block, BlockOptions, BlockSource, BlocksReport, MeshBlocks, stripify_blocks};
use striata_testing::meshes;

/// A folder with one file in it, and a folder for temporary files.
struct TestFolder {
    _folder: tempfile::TempDir,
    file: PathBuf,
    scratch: PathBuf,
}

fn test_folder(name: &str, bytes: &[u8]) -> TestFolder {
    let folder = tempfile::tempdir().unwrap();
    let (file, scratch) = (folder.path().join(name), folder.path().join("scratch"));
    fs::write(&file, bytes).unwrap();
    fs::create_dir(&scratch).unwrap();
    TestFolder { _folder: folder, file, scratch }
}

impl TestFolder {
    fn open(&self, block_triangles: usize) -> Result<TriangleBlocks, ReadError> {
        TriangleBlocks::open(&self.file, block_triangles, &self.scratch)
    }

    /// Returns the error message for bytes that cannot be read.
    fn error_message(name: &str, bytes: &[u8]) -> String {
        let input = test_folder(name, bytes);
        let message = input.open(10).unwrap_err().to_string();
        assert_eq!(fs::read_dir(&input.scratch).unwrap().count(), 0);
        message.replace(&input.file.display().to_string(), name)
    }
}

fn ply(mesh: &IndexedMesh) -> Vec<u8> {
    to_bytes(Format::Ply, mesh, &WriteOptions::default()).unwrap()
}

/// Converts a file to big-endian; elements other than faces must be rows of floats.
fn big_endian(mesh: &IndexedMesh) -> Vec<u8> {
    let mut out =
        format!("ply\nformat binary_big_endian 1.0\nelement vertex {}\n", mesh.vertex_count()).into_bytes();
    out.extend(b"property double x\nproperty float y\nproperty float z\nproperty short w\n");
    out.extend(format!("element face {}\n", mesh.triangle_count()).bytes());
    out.extend(b"property uchar mark\nproperty list int uint vertex_index\nend_header\n");
    for (v, &[x, y, z]) in mesh.positions.iter().enumerate() {
        out.extend(f64::from(x).to_be_bytes());
        out.extend([y, z].iter().flat_map(|x| x.to_be_bytes()));
        out.extend((v as i16 - 50).to_be_bytes());
    }
    for triangle in &mesh.triangles {
        out.push(9);
        out.extend([3].iter().chain(triangle).flat_map(|x| x.to_be_bytes()));
    }
    out
}

/// Stripifies the file in blocks and writes the strips to a file in this format.
fn strip_to(input: &TestFolder, block_triangles: usize, format: Format, out: &Path) -> BlocksReport {
    let mut blocks = input.open(block_triangles).unwrap();
    let mut spool = StripSpool::new(format, &input.scratch).unwrap();
    let options = BlockOptions::default();
    let report = stripify_blocks(&mut blocks, &options, &mut |_, strip| spool.push(strip));
    spool.write(out, &blocks).unwrap();
    assert_eq!(fs::read_dir(&input.scratch).unwrap().count(), 0);
    report.unwrap()
}

fn proper(mesh: &IndexedMesh) -> Vec<[u32; 3]> {
    let is_proper = |t: &&[u32; 3]| t[0] != t[1] && t[1] != t[2] && t[2] != t[0];
    canonical_triangles(&mesh.triangles.iter().filter(is_proper).copied().collect::<Vec<_>>())
}

fn with_layers(mut mesh: IndexedMesh) -> IndexedMesh {
    let count = mesh.vertex_count();
    let floats = |width: usize| (0..count * width).map(|i| (i % 7) as f32 * 0.125).collect::<Vec<_>>();
    mesh.layers.push(AttributeLayer::from_f32(Semantic::TexCoord(0), 2, floats(2)));
    mesh.layers.push(AttributeLayer::from_f32(Semantic::Generic("heat".to_owned()), 1, floats(1)));
    mesh
}

#[test]
fn blocks_of_a_file_match_blocks_of_the_mesh() {
    let mesh = shapes::terrain(60, 4);
    let input = test_folder("terrain.ply", &ply(&mesh));
    let mut from_file = input.open(500).unwrap();
    let mut from_mesh = MeshBlocks::new(&mesh, 500).unwrap();
    assert_eq!(from_file.block_count(), from_mesh.block_count());
    assert_eq!((from_file.vertex_count(), from_file.triangle_count()), (3721, 7200));
    assert_eq!(from_file.bounds(), mesh.bounds());
    let (mut a, mut b) = (Block::default(), Block::default());
    for number in (0..from_file.block_count()).rev() {
        from_file.read_block(number, &mut a).unwrap();
        from_mesh.read_block(number, &mut b).unwrap();
        assert_eq!(a, b, "block {number}");
    }
}

#[test]
fn strips_written_in_blocks_keep_the_mesh_and_its_layers() {
    let small = with_layers(shapes::torus(20, 30, 3.0, 1.0));
    // More vertices than 16-bit indices can address.
    let large = with_layers(shapes::grid(260, 255));
    for (mesh, block_triangles) in [(&small, 1), (&small, 100), (&small, usize::MAX), (&large, 20_000)] {
        let input = test_folder("mesh.ply", &ply(mesh));
        for format in [Format::Ply, Format::Glb] {
            let out = input.scratch.with_extension(format.extension());
            let report = strip_to(&input, block_triangles, format, &out);
            assert_eq!(report.cost.triangle_count, mesh.triangle_count());
            if format == Format::Glb {
                // The independent reader's own checks: accessors within views, views within the buffer,
                // bounds of positions.
                let glb = gltf::Gltf::open(&out).unwrap();
                let primitive = glb.meshes().next().unwrap().primitives().next().unwrap();
                assert_eq!(primitive.mode(), gltf::mesh::Mode::TriangleStrip);
                let bounds = mesh.bounds().unwrap();
                assert_eq!(
                    (primitive.bounding_box().min, primitive.bounding_box().max),
                    (bounds.min, bounds.max)
                );
            }
            let back = read(&out).unwrap();
            assert_eq!(back.positions, mesh.positions, "{format}");
            assert_eq!(proper(&back), proper(mesh), "{format}, blocks of {block_triangles}");
            for layer in &mesh.layers {
                let found = back.layers.iter().find(|found| found.component_count == layer.component_count);
                assert_eq!(found.map(|found| &found.data), Some(&layer.data), "{format}: {}", layer.semantic);
            }
        }
    }
}

/// Triangles as the bits of their corner positions, sorted: independent of how vertices are numbered.
fn corners(mesh: &IndexedMesh) -> Vec<[[u32; 3]; 3]> {
    let corner = |v: u32| mesh.positions[v as usize].map(|x| (x + 0.0).to_bits());
    let mut all: Vec<[[u32; 3]; 3]> = proper(mesh)
        .into_iter()
        .map(|triangle| {
            let mut corners = triangle.map(corner);
            let least = (0..3).min_by_key(|&k| corners[k]).unwrap();
            corners.rotate_left(least);
            corners
        })
        .collect();
    all.sort_unstable();
    all
}

/// A georeference stays with the strips, and turns the node of a GLB file.
#[test]
fn strips_in_blocks_keep_the_georeference() {
    let mut mesh = shapes::grid(9, 7);
    mesh.appearance.georeference = r#"{"epsg":32632}"#.to_owned();
    let text = to_bytes(Format::Ply, &mesh, &WriteOptions::default().with_ascii(true)).unwrap();
    let glb = to_bytes(Format::Glb, &mesh, &WriteOptions::default()).unwrap();
    for (name, bytes) in [("a.ply", ply(&mesh)), ("b.ply", text), ("c.glb", glb)] {
        let input = test_folder(name, &bytes);
        for format in [Format::Ply, Format::Glb] {
            let out = input.scratch.parent().unwrap().join(format!("out.{format}"));
            strip_to(&input, 20, format, &out);
            let back = read(&out).unwrap();
            assert_eq!(back.appearance.georeference, mesh.appearance.georeference, "{name} to {format}");
            assert_eq!(back.bounds(), mesh.bounds(), "{name} to {format}");
            if format == Format::Glb {
                let scene = striata_io::read_scene(&out).unwrap();
                assert_eq!(scene.bounds().unwrap().max[1], mesh.bounds().unwrap().max[2]);
            }
        }
    }
}

/// A file in blocks has the vertices, the layers and the triangles that the reader for meshes in memory
/// gives, as far as PLY stores them.
fn assert_same_as_in_memory(name: &str, bytes: &[u8], block_triangles: usize) -> BlocksReport {
    let input = test_folder(name, bytes);
    let whole = to_bytes(Format::Ply, &read(&input.file).unwrap(), &WriteOptions::default()).unwrap();
    let whole = read_bytes(&whole, &Source::new("whole.ply")).unwrap();
    let out = input.scratch.with_extension("out.ply");
    let report = strip_to(&input, block_triangles, Format::Ply, &out);
    let back = read(&out).unwrap();
    assert_eq!(back.vertex_count(), whole.vertex_count(), "{name}");
    assert_eq!(corners(&back), corners(&whole), "{name}");
    let kinds = |mesh: &IndexedMesh| -> Vec<String> {
        mesh.layers.iter().map(|l| format!("{} {}", l.semantic, l.component_count)).collect()
    };
    assert_eq!(kinds(&back), kinds(&whole), "{name}");
    // The layers of corners in the order of their positions.
    for (found, expected) in back.layers.iter().zip(&whole.layers) {
        let values = |mesh: &IndexedMesh, layer: &AttributeLayer| {
            let width = layer.vertex_bytes();
            let row = |v: usize| layer.data.as_bytes()[v * width..][..width].to_vec();
            let position = |v: usize| mesh.positions[v].map(|x| (x + 0.0).to_bits());
            let mut all: Vec<_> = (0..mesh.vertex_count()).map(|v| (position(v), row(v))).collect();
            all.sort();
            all
        };
        assert!(values(&back, found) == values(&whole, expected), "{name}: {}", found.semantic);
    }
    report
}

/// Every way to write a mesh that can be streamed.
fn streamed_files(mesh: &IndexedMesh) -> Vec<(&'static str, Vec<u8>)> {
    let ascii = WriteOptions::default().with_ascii(true);
    let bytes = |format, options: &WriteOptions| to_bytes(format, mesh, options).unwrap();
    let plain = WriteOptions::default();
    vec![
        ("text.ply", bytes(Format::Ply, &ascii)),
        ("binary.ply", bytes(Format::Ply, &plain)),
        ("big.ply", big_endian(mesh)),
        ("mesh.obj", bytes(Format::Obj, &plain)),
        ("binary.stl", bytes(Format::Stl, &plain)),
        ("text.stl", text_stl(mesh)),
        ("mesh.off", bytes(Format::Off, &plain)),
        ("mesh.gltf", bytes(Format::Gltf, &plain)),
        ("mesh.glb", bytes(Format::Glb, &plain)),
    ]
}

fn text_stl(mesh: &IndexedMesh) -> Vec<u8> {
    let mut out = "solid part\n".to_owned();
    for triangle in &mesh.triangles {
        out += "facet normal 0 0 0\nouter loop\n";
        for &v in triangle {
            let [x, y, z] = mesh.positions[v as usize];
            out += &format!("vertex {x} {y} {z}\n");
        }
        out += "endloop\nendfacet\n";
    }
    (out + "endsolid part\n").into_bytes()
}

#[test]
fn every_format_that_can_be_streamed_is_read_in_blocks() {
    let mesh = shapes::torus(40, 30, 3.0, 1.0);
    for (name, bytes) in streamed_files(&mesh) {
        let reports = [100, usize::MAX].map(|count| assert_same_as_in_memory(name, &bytes, count));
        assert!(reports[0].block_count > 10 && reports[1].block_count == 1, "{name}");
        assert_eq!(reports[0].cost.triangle_count, mesh.triangle_count(), "{name}");
        // Strips continue over the borders of blocks: the vertices are shared.
        assert!(reports[0].cost.indices_per_triangle < 1.4, "{name}: {:?}", reports[0].cost);
        let packed = zstd::encode_all(&bytes[..], 1).unwrap();
        assert_same_as_in_memory(&format!("{name}.zst"), &packed, 500);
    }
}

#[test]
fn corners_of_an_obj_share_vertices_as_in_memory() {
    let mut mesh = with_layers(shapes::torus(20, 12, 3.0, 1.0));
    mesh.layers.pop();
    let obj = to_bytes(Format::Obj, &mesh, &WriteOptions::default()).unwrap();
    assert_same_as_in_memory("uv.obj", &obj, 100);
    let seams = "v 0 0 0 1 0 0\nv 1 0 0 0 1 0\nv 1 1 0 0 0 1\nv 0 1 0 1 1 0\nv 9 9 9\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n\
        vt .5 .5\nvn 0 0 1\nvn 0 1 0\ng a\nf 1/1/1 2/2/1 3/3/1\ng b\nf 1/5/1 3/3/2 4/4/1\n";
    assert_same_as_in_memory("seams.obj", seams.as_bytes(), 1);
    let input = test_folder("seams.obj", seams.as_bytes());
    let warnings = input.open(5).unwrap().warnings().to_vec();
    assert!(
        warnings.iter().any(|warning| warning.to_string().contains("groups and materials")),
        "{warnings:?}"
    );
    let colored = "v 0 0 0 1 0 0\nv 1 0 0 0 1 0\nv 1 1 0 0 0 1\nv 5 5 5 1 1 1\nf 1 2 3\n";
    assert_same_as_in_memory("colored.obj", colored.as_bytes(), 1);
}

#[test]
fn generated_pieces_are_cut_into_blocks() {
    use striata_io::pieces::{FractalTerrain, MeshPieces, PieceSource};
    let terrain = FractalTerrain::new(460, 3);
    assert!(terrain.piece_count() > 4);
    let folder = tempfile::tempdir().unwrap();
    let mut blocks = TriangleBlocks::of_pieces(&terrain, 20_000, folder.path()).unwrap();
    // Pieces repeat the vertices of their borders; here each occurs once.
    assert_eq!((blocks.vertex_count(), blocks.triangle_count()), (460 * 460, 2 * 459 * 459));
    let write = &mut |_: u32, _: &[u32]| Ok::<(), ()>(());
    let report = stripify_blocks(&mut blocks, &BlockOptions::default(), write).unwrap();
    assert!(report.cost.indices_per_triangle < 1.1, "{:?}", report.cost);
    let mesh = with_layers(shapes::grid(30, 30));
    let layered = MeshPieces::new(mesh.clone()).with_piece_triangle_count(100);
    assert!(layered.piece_count() > 4);
    let blocks = TriangleBlocks::of_pieces(&layered, 50, folder.path()).unwrap();
    assert_eq!(blocks.vertex_count() as usize, mesh.vertex_count());
}

#[test]
fn layers_of_off_and_gltf_are_kept() {
    let mut mesh = shapes::torus(20, 12, 3.0, 1.0);
    let normals = mesh.positions.iter().flat_map(|&[x, y, z]| [y, z, x]).collect();
    let colors = (0..mesh.vertex_count() * 4).map(|i| (i * 7 % 256) as u8).collect();
    let texcoords = mesh.positions.iter().flat_map(|&[x, _, z]| [z, x]).collect();
    let data = LayerData::U8(colors);
    mesh.layers = vec![
        AttributeLayer::from_f32(Semantic::Normal, 3, normals),
        AttributeLayer::from_f32(Semantic::TexCoord(0), 2, texcoords),
        AttributeLayer { semantic: Semantic::Color(0), component_count: 4, normalized: true, data },
    ];
    for format in [Format::Off, Format::Gltf, Format::Glb] {
        let bytes = to_bytes(format, &mesh, &WriteOptions::default()).unwrap();
        let report = assert_same_as_in_memory(&format!("mesh.{}", format.extension()), &bytes, 100);
        assert!(report.cost.indices_per_triangle < 1.4, "{format}: {:?}", report.cost);
    }
}

#[test]
fn damaged_text_is_reported_or_another_mesh() {
    for (name, whole) in streamed_files(&shapes::tetrahedron()) {
        for length in 0..whole.len() {
            let input = test_folder(name, &whole[..length]);
            match input.open(2) {
                Err(error) => assert!(error.to_string().contains(name), "{length} bytes of {name}: {error}"),
                Ok(mut blocks) => {
                    let write = &mut |_: u32, _: &[u32]| Ok::<(), ()>(());
                    stripify_blocks(&mut blocks, &BlockOptions::default(), write).unwrap();
                }
            }
            assert_eq!(fs::read_dir(&input.scratch).unwrap().count(), 0);
        }
    }
}

#[test]
fn unusual_meshes_are_kept() {
    for (name, mesh) in meshes::nasty() {
        if mesh.check().is_err() || !mesh.layers.is_empty() || proper(&mesh).is_empty() {
            continue;
        }
        for bytes in [ply(&mesh), big_endian(&mesh)] {
            let input = test_folder("mesh.ply", &bytes);
            let out = input.scratch.with_extension("out.ply");
            strip_to(&input, 7, Format::Ply, &out);
            let back = read(&out).unwrap();
            let is_in_place =
                |(vertex, p): (usize, &[f32; 3])| back.file_position(vertex) == p.map(f64::from);
            let are_in_place = mesh.positions.iter().enumerate().all(is_in_place);
            assert_eq!((are_in_place, proper(&back)), (true, proper(&mesh)), "{name}");
            let out = input.scratch.with_extension("glb");
            strip_to(&input, 7, Format::Glb, &out);
            assert_eq!(proper(&read(&out).unwrap()), proper(&mesh), "{name}");
        }
    }
}

#[test]
fn polygons_are_fanned_and_other_elements_skipped() {
    let head =
        b"ply\nformat binary_little_endian 1.0\nelement camera 2\nproperty float f\nelement vertex 5\n\
        property float x\nproperty float y\nproperty float z\nelement face 2\n\
        property list uchar ushort vertex_indices\nproperty list uchar float uv\nelement edge 1\n\
        property list uchar uchar rest\nend_header\n";
    let mut bytes = head.to_vec();
    bytes.extend([7.0f32; 2].iter().flat_map(|x| x.to_le_bytes()));
    let points = [[0.0f32, 0., 0.], [1., 0., 0.], [1., 1., 0.], [0., 1., 0.], [-1., 0.5, 0.]];
    bytes.extend(points.as_flattened().iter().flat_map(|x| x.to_le_bytes()));
    for polygon in [&[0u16, 1, 2, 3, 4][..], &[3, 2]] {
        bytes.push(polygon.len() as u8);
        bytes.extend(polygon.iter().flat_map(|v| v.to_le_bytes()));
        bytes.push(1);
        bytes.extend(0.5f32.to_le_bytes());
    }
    bytes.extend([2, 1, 1]);
    let input = test_folder("mesh.ply", &bytes);
    let mut found = Vec::new();
    let mut take = |_, strip: &[u32]| -> Result<(), ()> {
        found.extend(strip_triangles(strip));
        Ok(())
    };
    stripify_blocks(&mut input.open(2).unwrap(), &BlockOptions::default(), &mut take).unwrap();
    assert_eq!(canonical_triangles(&found), canonical_triangles(&[[0, 1, 2], [0, 2, 3], [0, 3, 4]]));
}

#[test]
fn textures_keep_their_names_and_origin() {
    let mut mesh = shapes::icosphere(1, 1.0);
    let pixels = |[x, y, _]: [f32; 3]| [x, y].map(|x| (x * 256.0).round() / 256.0);
    let texcoords = mesh.positions.iter().flat_map(|&position| pixels(position)).collect();
    mesh.layers = vec![AttributeLayer::from_f32(Semantic::TexCoord(0), 2, texcoords)];
    let plain = String::from_utf8_lossy(&ply(&mesh)).find("element").unwrap();
    let bytes = ply(&mesh);
    let textured = [&bytes[..plain], b"comment TextureFile a b.png\n", &bytes[plain..]].concat();
    let input = test_folder("mesh.ply", &textured);
    let whole = read(&input.file).unwrap();
    assert_eq!(whole.layers, mesh.layers, "the origin does not depend on the comment");
    for format in [Format::Ply, Format::Glb] {
        let out = input.scratch.parent().unwrap().join(format!("out.{}", format.extension()));
        strip_to(&input, 10, format, &out);
        let back = read(&out).unwrap();
        assert_eq!(back.layers, whole.layers, "{format}");
        let names: Vec<&str> = back.appearance.images.iter().map(|image| image.uri.as_str()).collect();
        assert_eq!(names, if format == Format::Ply { vec!["a%20b.png"] } else { Vec::new() });
    }
}

#[test]
fn every_truncation_is_reported() {
    let whole = ply(&shapes::icosphere(1, 1.0));
    for length in 0..whole.len() {
        let input = test_folder("cut.ply", &whole[..length]);
        let error = input.open(8).unwrap_err();
        assert!(error.to_string().contains("cut.ply"), "{length} bytes: {error}");
    }
}

#[test]
fn a_flipped_bit_is_an_error_or_another_mesh() {
    let whole = ply(&shapes::tetrahedron());
    for bit in 0..whole.len() * 8 {
        let mut bytes = whole.clone();
        bytes[bit / 8] ^= 1 << (bit % 8);
        let input = test_folder("flipped.ply", &bytes);
        let Ok(mut blocks) = input.open(2) else { continue };
        let write = &mut |_: u32, _: &[u32]| Ok::<(), ()>(());
        stripify_blocks(&mut blocks, &BlockOptions::default(), write).unwrap();
    }
}

#[test]
fn files_that_cannot_be_read_in_blocks_are_refused() {
    let mesh = shapes::tetrahedron();
    let message = TestFolder::error_message("a.striata", b"STRIATA\0 and more");
    assert_eq!(message, format!("a.striata: the format {} cannot be read block by block", Format::Striata));
    assert!(TestFolder::error_message("a.txt", b"no mesh").starts_with("a.txt: neither the content nor"));
    let strips = b"ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n\
        property float z\nelement tristrips 1\nproperty list int int vertex_indices\nend_header\n0 0 0\n0\n";
    assert!(TestFolder::error_message("a.ply", strips).contains("element `tristrips` cannot be read block"));
    let folder = tempfile::tempdir().unwrap();
    let message = TriangleBlocks::open(folder.path(), 5, folder.path()).unwrap_err().to_string();
    assert!(message.contains("not a regular file"), "{message}");
    let mut outside = mesh.clone();
    outside.triangles[2][1] = 3;
    let mut bytes = ply(&outside);
    let place_of_index = bytes.len() - 2 * 13 + 5;
    bytes[place_of_index] = 4;
    assert_eq!(
        TestFolder::error_message("a.ply", &bytes),
        format!("a.ply: byte {place_of_index}: vertex 4 does not exist: there are 4")
    );
    let mut bytes = ply(&mesh);
    let second_y = bytes.len() - 4 * 13 - 3 * 12 + 4;
    bytes[second_y..second_y + 4].copy_from_slice(&f32::NAN.to_le_bytes());
    let input = test_folder("a.ply", &bytes);
    let blocks = input.open(5).unwrap();
    assert_eq!((blocks.vertex_count(), blocks.triangle_count()), (3, 1));
    assert_eq!(blocks.warnings().iter().map(|w| w.count).collect::<Vec<_>>(), [3]);
    let head = "ply\nformat binary_little_endian 1.0\nelement vertex 4000000000\nproperty float x\n\
        property float y\nproperty float z\nelement face 4294967295\n\
        property list uchar int vertex_indices\nend_header\n";
    let message = TestFolder::error_message("a.ply", head.as_bytes());
    assert!(
        message.contains("4000000000 rows of `vertex` are declared, which take 48000000000 bytes"),
        "{message}"
    );
    let strips = "ply\nformat binary_little_endian 1.0\nelement vertex 0\nproperty float x\n\
        element tristrips 1\nproperty list int int vertex_indices\nend_header\n\0\0\0\0";
    assert!(TestFolder::error_message("a.ply", strips.as_bytes()).contains("`tristrips`"));
}

#[test]
fn a_missing_folder_and_another_format_are_refused() {
    let input = test_folder("mesh.ply", &ply(&shapes::tetrahedron()));
    let missing = input.scratch.join("no");
    let message = TriangleBlocks::open(&input.file, 5, &missing).unwrap_err().to_string();
    assert!(message.starts_with("temporary file in"), "{message}");
    assert!(StripSpool::new(Format::Ply, &missing).is_err());
    let message = StripSpool::new(Format::Obj, &input.scratch).unwrap_err().to_string();
    assert!(message.contains("PLY or GLB"), "{message}");
}

#[test]
fn a_failed_write_leaves_the_old_file() {
    let input = test_folder("mesh.ply", &ply(&shapes::tetrahedron()));
    let blocks = input.open(5).unwrap();
    let out = input.scratch.with_extension("glb");
    fs::write(&out, b"old").unwrap();
    // The input file is cut off before its vertices are copied.
    fs::OpenOptions::new().write(true).open(&input.file).unwrap().set_len(100).unwrap();
    let mut spool = StripSpool::new(Format::Glb, &input.scratch).unwrap();
    spool.push(&[0, 1, 2]).unwrap();
    assert!(spool.write(&out, &blocks).is_err());
    assert_eq!(fs::read(&out).unwrap(), b"old");
}

#[test]
fn restarts_separate_the_strips_of_a_ply() {
    let input = test_folder("mesh.ply", &ply(&shapes::many_components(5)));
    let out = input.scratch.with_extension("out.ply");
    let report = strip_to(&input, 1, Format::Ply, &out);
    let bytes = fs::read(&out).unwrap();
    let list = bytes.windows(11).position(|w| w == b"end_header\n").unwrap() + 11 + 20 * 12;
    let words: Vec<u32> =
        bytes[list..].chunks_exact(4).map(|w| u32::from_le_bytes(w.try_into().unwrap())).collect();
    assert_eq!(words[0] as usize, words.len() - 1);
    let mut triangles = Vec::new();
    restart_triangles_into(&words[1..], &mut triangles);
    assert_eq!((words.len() - 1, triangles.len()), (report.cost.index_count, 20));
}

/// Sorted coordinates in the file, in micrometers if they are meters.
fn sorted_coordinates(mesh: &IndexedMesh) -> Vec<[i64; 3]> {
    let round = |vertex: usize| mesh.file_position(vertex).map(|x| (x * 1e6).round() as i64);
    let mut all: Vec<_> = (0..mesh.vertex_count()).map(round).collect();
    all.sort_unstable();
    all
}

#[test]
fn positions_far_from_the_origin_stay_and_lost_data_is_named() {
    let mut mesh = with_layers(shapes::terrain(12, 3));
    mesh.origin = [500_000.0, 5_000_000.0, 100.0];
    mesh.positions.iter_mut().for_each(|p| *p = p.map(|x| (x * 256.0).round() / 256.0));
    let LayerData::F32(heat) = &mut mesh.layers[1].data else { unreachable!() };
    heat[3] = f32::NAN;
    let labels = LayerData::I32((0..mesh.triangle_count() as i32).collect());
    let label = AttributeLayer::from_f32(Semantic::Generic("label".to_owned()), 1, Vec::new());
    mesh.triangle_layers.push(AttributeLayer { data: labels, ..label });
    let text = to_bytes(Format::Ply, &mesh, &WriteOptions::default().with_ascii(true)).unwrap();
    let inputs = [
        ("mesh.ply", ply(&mesh), true),
        ("text.ply", text, true),
        ("mesh.off", to_bytes(Format::Off, &mesh, &WriteOptions::default()).unwrap(), false),
        ("mesh.obj", to_bytes(Format::Obj, &mesh, &WriteOptions::default()).unwrap(), false),
        ("mesh.glb", to_bytes(Format::Glb, &mesh, &WriteOptions::default()).unwrap(), false),
    ];
    for (name, bytes, has_labels) in inputs {
        let input = test_folder(name, &bytes);
        for format in [Format::Ply, Format::Glb] {
            let out = input.scratch.with_extension(format.extension());
            strip_to(&input, 50, format, &out);
            let back = read(&out).unwrap();
            assert_eq!(sorted_coordinates(&back), sorted_coordinates(&mesh), "{name} to {format}");
            let losses = input.open(50).unwrap().losses(format).unwrap();
            let losses: Vec<String> = losses.iter().map(|loss| loss.reason.clone()).collect();
            assert_eq!(losses.iter().any(|loss| loss.contains("`label`")), has_labels, "{name}: {losses:?}");
            let has_gaps = has_labels && format == Format::Glb;
            assert_eq!(losses.iter().any(|loss| loss.contains("`heat`")), has_gaps, "{name}: {losses:?}");
        }
    }
}
