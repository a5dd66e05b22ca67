//! Files that are read in pieces have the triangles that the readers of whole files find.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use striata::mesh::{AttributeLayer, IndexedMesh, LayerData, Semantic, shapes};
use striata_io::pieces::{MeshPieces, Piece, PieceOptions, PieceSource, Tiles, open_pieces, open_several};
use striata_io::{Format, ReadError, WriteOptions, read, to_bytes};

/// Corners of a triangle from the smallest on, as bits of positions and layers, and its group's name.
type Triangles = BTreeMap<(Vec<Vec<u32>>, String), usize>;

fn values(layer: &AttributeLayer, vertex: usize) -> Vec<u32> {
    (0..layer.component_count as usize).map(|c| layer.get(vertex, c).to_bits()).collect()
}

fn corner(positions: &[[f32; 3]], layers: &[AttributeLayer], vertex: u32) -> Vec<u32> {
    let vertex = vertex as usize;
    let mut bits: Vec<u32> = positions[vertex].iter().map(|x| (x + 0.0).to_bits()).collect();
    layers.iter().for_each(|layer| bits.extend(values(layer, vertex)));
    bits
}

fn add(all: &mut Triangles, mut corners: [Vec<u32>; 3], group: &str) {
    let first = (0..3).min_by_key(|&i| corners[i].clone()).unwrap();
    corners.rotate_left(first);
    *all.entry((corners.to_vec(), group.to_owned())).or_default() += 1;
}

fn of_mesh(mesh: &IndexedMesh) -> Triangles {
    let mut all = Triangles::new();
    for group in mesh.groups_or_whole() {
        for triangle in &mesh.triangles[group.range()] {
            let corners = triangle.map(|v| corner(&mesh.positions, &mesh.layers, v));
            add(&mut all, corners, &group.name);
        }
    }
    all
}

fn of_piece(all: &mut Triangles, piece: &Piece, source: &dyn PieceSource) {
    let summary = source.summary();
    assert_eq!(piece.layers.len(), summary.layers.len());
    for (layer, kind) in piece.layers.iter().zip(&summary.layers) {
        assert_eq!(&striata_io::pieces::LayerKind::of(layer), kind);
        assert_eq!(layer.data.len(), piece.positions.len() * kind.component_count as usize);
    }
    assert!(piece.groups.is_empty() || piece.groups.len() == piece.triangles.len());
    for (index, triangle) in piece.triangles.iter().enumerate() {
        let group = piece.groups.get(index).map_or(0, |&g| g as usize);
        let corners = triangle.map(|v| corner(&piece.positions, &piece.layers, v));
        add(all, corners, &summary.groups[group].name);
    }
}

fn of_source(source: &dyn PieceSource) -> Triangles {
    let mut all = Triangles::new();
    // From the last piece on: no piece depends on another.
    for index in (0..source.piece_count()).rev() {
        of_piece(&mut all, &source.read_piece(index).unwrap(), source);
    }
    assert_eq!(all.values().sum::<usize>() as u64, source.summary().triangle_count);
    assert!(source.read_piece(source.piece_count()).is_err());
    all
}

struct Folder(tempfile::TempDir);

impl Folder {
    fn new() -> Self {
        Self(tempfile::tempdir().unwrap())
    }

    fn file(&self, name: &str, bytes: &[u8]) -> PathBuf {
        let path = self.0.path().join(name);
        fs::write(&path, bytes).unwrap();
        path
    }

    fn options(&self) -> PieceOptions {
        let scratch = self.0.path().join("scratch");
        fs::create_dir_all(&scratch).unwrap();
        PieceOptions::default().with_piece_triangle_count(37).with_scratch(scratch)
    }

    fn open(&self, path: &Path) -> Result<Box<dyn PieceSource>, ReadError> {
        open_pieces(path, &self.options())
    }

    /// Checks that pieces and the whole file agree.
    fn check(&self, name: &str, bytes: &[u8]) {
        let path = self.file(name, bytes);
        let whole = read(&path).unwrap();
        let source = self.open(&path).unwrap();
        assert_eq!(source.summary().appearance, whole.appearance, "{name}");
        assert_eq!(source.summary().byte_count, bytes.len() as u64, "{name}");
        assert!(source.piece_count() > 1, "{name}");
        assert!(of_source(&*source) == of_mesh(&whole), "{name}");
        drop(source);
        assert_eq!(fs::read_dir(self.0.path().join("scratch")).unwrap().count(), 0, "{name}");
    }

    /// The error of opening a file or of reading all of its pieces.
    fn error(&self, name: &str, bytes: &[u8]) -> String {
        let path = self.file(name, bytes);
        let outcome = self
            .open(&path)
            .and_then(|source| (0..source.piece_count()).try_for_each(|i| source.read_piece(i).map(drop)));
        let message = outcome.expect_err(name).to_string();
        assert!(message.contains(name), "{message}");
        message
    }
}

/// Meshes with and without layers and groups.
fn meshes() -> Vec<(&'static str, IndexedMesh)> {
    let mut marked = shapes::torus(12, 9, 2.0, 0.5);
    let count = marked.vertex_count() as u32;
    let layer = |name: &str, data| AttributeLayer {
        semantic: Semantic::Generic(name.to_owned()),
        component_count: 1,
        normalized: false,
        data,
    };
    marked.layers.push(layer("number", LayerData::U32((0..count).collect())));
    marked.layers.push(layer("mark", LayerData::U8((0..count).map(|v| v as u8).collect())));
    vec![
        ("torus", shapes::torus(15, 10, 2.0, 0.5)),
        ("marked", marked),
        ("cylinder", shapes::uv_cylinder(12, 9)),
        ("sphere", shapes::two_material_sphere(12, 16)),
    ]
}

fn bytes_of(format: Format, mesh: &IndexedMesh, ascii: bool) -> Vec<u8> {
    to_bytes(format, mesh, &WriteOptions::default().with_ascii(ascii)).unwrap()
}

#[test]
fn pieces_are_the_whole() {
    let folder = Folder::new();
    for (name, mesh) in meshes() {
        for format in [Format::Ply, Format::Obj, Format::Stl, Format::Off, Format::Gltf, Format::Glb] {
            let name = format!("{name}.{}", format.extension());
            folder.check(&name, &bytes_of(format, &mesh, false));
        }
        folder.check(&format!("{name}-text.ply"), &bytes_of(Format::Ply, &mesh, true));
    }
}

#[test]
fn compressed_files_are_unpacked() {
    let folder = Folder::new();
    let mesh = shapes::uv_cylinder(12, 9);
    for format in [Format::Ply, Format::Stl, Format::Obj] {
        let bytes = bytes_of(format, &mesh, false);
        let packed = zstd::bulk::compress(&bytes, 3).unwrap();
        folder.check(&format!("a.{}.zst", format.extension()), &packed);
        let message = folder.error(&format!("b.{}.zst", format.extension()), &packed[..packed.len() / 2]);
        assert!(message.contains("damaged or truncated"), "{message}");
    }
}

/// A big-endian file with polygons, other properties, a negative number and elements around the faces.
fn mixed_ply() -> Vec<u8> {
    let mesh = shapes::grid(12, 12);
    let mut out =
        b"ply\nformat binary_big_endian 1.0\nelement other 2\nproperty list uchar short n\n".to_vec();
    out.extend(format!("element face {}\n", mesh.triangle_count() / 2).bytes());
    out.extend(b"property uchar mark\nproperty list int uint vertex_index\n");
    out.extend(format!("element vertex {}\n", mesh.vertex_count()).bytes());
    out.extend(b"property double x\nproperty float y\nproperty float z\nproperty int w\nproperty int u8\n");
    out.extend(b"end_header\n\x01\x00\x05\x00");
    for pair in mesh.triangles.chunks_exact(2) {
        let is_quad = pair[0][0] % 3 == 0;
        let corners =
            if is_quad { vec![pair[0][0], pair[0][1], pair[0][2], pair[1][2]] } else { pair[0].to_vec() };
        out.push(7);
        out.extend((corners.len() as u32).to_be_bytes());
        out.extend(corners.iter().flat_map(|v| v.to_be_bytes()));
    }
    for (v, &[x, y, z]) in mesh.positions.iter().enumerate() {
        out.extend(f64::from(x).to_be_bytes());
        out.extend([y, z].iter().flat_map(|x| x.to_be_bytes()));
        out.extend((if v == 5 { -1 } else { v as i32 }).to_be_bytes());
        out.extend((v as i32).to_be_bytes());
    }
    out
}

#[test]
fn polygons_in_big_endian_are_found() {
    Folder::new().check("mixed.ply", &mixed_ply());
}

#[test]
fn damaged_ply_files_are_refused() {
    let folder = Folder::new();
    let mesh = shapes::torus(15, 10, 2.0, 0.5);
    let bytes = bytes_of(Format::Ply, &mesh, false);
    for length in [bytes.len() - 1, bytes.len() / 2, 40] {
        folder.error("cut.ply", &bytes[..length]);
    }
    let mut bad = bytes.clone();
    let last = bad.len() - 4;
    bad[last..].copy_from_slice(&9999u32.to_le_bytes());
    let message = folder.error("index.ply", &bad);
    assert!(message.contains("vertex 9999 does not exist: there are 150"), "{message}");
    assert!(message.contains(&format!("byte {last}")), "{message}");
    let mut bad = bytes.clone();
    let body = bytes.windows(11).position(|w| w == b"end_header\n").unwrap() + 11;
    bad[body + 4..body + 8].copy_from_slice(&f32::NAN.to_le_bytes());
    assert!(folder.error("nan.ply", &bad).contains(&format!("byte {body}: the vertex has")));
    let text = String::from_utf8_lossy(&bytes[..body]).replace("vertex 150", "vertex 4000000000");
    let giant = [text.as_bytes(), &bytes[body..]].concat();
    assert!(folder.error("giant.ply", &giant).contains("4000000000 rows of `vertex` are declared"));
    let mut long = mixed_ply();
    let body = long.windows(11).position(|w| w == b"end_header\n").unwrap() + 11 + 5;
    long[body..body + 4].copy_from_slice(&u32::MAX.to_be_bytes());
    folder.error("long.ply", &long);
}

#[test]
fn damaged_stl_files_are_refused() {
    let folder = Folder::new();
    let bytes = bytes_of(Format::Stl, &shapes::torus(15, 10, 2.0, 0.5), false);
    assert!(folder.error("cut.stl", &bytes[..bytes.len() - 1]).contains("the header declares 300 triangles"));
    let mut bad = bytes.clone();
    bad[84 + 50 * 100 + 12..][..4].copy_from_slice(&f32::INFINITY.to_le_bytes());
    assert!(folder.error("infinite.stl", &bad).contains(&format!("byte {}", 84 + 50 * 100 + 12)));
    assert!(folder.error("unknown.xyz", b"hello").contains("neither the content nor the extension"));
}

#[test]
fn several_files_are_one() {
    let folder = Folder::new();
    let [first, second] = [shapes::uv_cylinder(12, 9), shapes::two_material_sphere(12, 16)];
    let mut paths = vec![folder.file("first.ply", &bytes_of(Format::Ply, &first, false))];
    paths.push(folder.file("second.glb", &bytes_of(Format::Glb, &second, false)));
    let source = open_several(&paths, &folder.options()).unwrap();
    let summary = source.summary();
    assert_eq!(summary.groups[0].name, "first");
    assert_eq!(summary.groups.len(), 1 + second.groups.len());
    assert_eq!(summary.appearance.materials.len(), second.appearance.materials.len());
    assert!(summary.warnings.iter().all(|warning| warning.contains("is left out")));
    let found = of_source(&source);
    assert_eq!(found.len(), first.triangle_count() + second.triangle_count());
    assert!(open_several(&[], &folder.options()).is_err());
}

#[test]
fn tiles_are_copies_side_by_side() {
    let mesh = shapes::two_material_sphere(12, 16);
    let pieces = MeshPieces::new(mesh.clone()).with_piece_triangle_count(50);
    let count = pieces.piece_count();
    let tiles = Tiles::new(Box::new(pieces), 3, 2).unwrap();
    assert_eq!(tiles.piece_count(), 6 * count);
    assert_eq!(of_source(&tiles).values().sum::<usize>(), 6 * mesh.triangle_count());
    let lowest = |index: u64, axis: usize| {
        let piece = tiles.read_piece(index).unwrap();
        piece.positions.iter().map(|p| p[axis]).fold(f32::INFINITY, f32::min)
    };
    let extent = mesh.bounds().unwrap();
    let step = (extent.max[1] - extent.min[1]) * 1.02;
    assert!((lowest(3 * count, 1) - lowest(0, 1) - step).abs() < 1e-4);
    assert_eq!(lowest(3 * count, 0), lowest(0, 0));
}

#[test]
fn inconsistent_meshes_are_refused() {
    let broken = IndexedMesh::new(vec![[0.0; 3]], vec![[0, 0, 1]]);
    assert!(MeshPieces::new(broken).read_piece(0).is_err());
}

#[test]
fn solids_of_text_are_groups() {
    let mesh = shapes::torus(15, 10, 2.0, 0.5);
    let mut text = String::new();
    for (solid, triangles) in mesh.triangles.chunks(110).enumerate() {
        text += &format!("solid part {solid}\n");
        for triangle in triangles {
            text += "facet normal 0 0 0\nouter loop\n";
            for &v in triangle {
                let [x, y, z] = mesh.positions[v as usize];
                text += &format!("vertex {x} {y} {z}\n");
            }
            text += "endloop\nendfacet\n";
        }
        text += "endsolid\n";
    }
    let folder = Folder::new();
    folder.check("text.stl", text.as_bytes());
    let message = folder.error("nan.stl", text.replacen("vertex ", "vertex nan ", 1).as_bytes());
    assert!(message.contains("line "), "{message}");
    folder.error("cut.stl", &text.as_bytes()[..text.len() / 2]);
}

#[test]
fn damaged_text_is_refused_with_the_line() {
    let folder = Folder::new();
    let text = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty double z\n\
                element face 1\nproperty list uchar int vertex_indices\nend_header\n\
                0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
    let found = folder.open(&folder.file("good.ply", text.as_bytes())).unwrap();
    assert_eq!(of_source(&*found).len(), 1);
    for (from, to, expected) in [
        ("3 0 1 2", "3 0 1 3", "line 13: vertex 3 does not exist"),
        ("3 0 1 2", "3 0 1", "line 14"),
        ("1 0 0", "1 nan 0", "line 11: `y` is not a usable coordinate"),
        ("vertex 3", "vertex 3000000", "3000000 rows of `vertex` are declared"),
    ] {
        let message = folder.error("bad.ply", text.replace(from, to).as_bytes());
        assert!(message.contains(expected), "{message}");
    }
    for (text, expected) in [
        ("v 0 0 0\nv 1 0 0\nv 0 inf 0\nf 1 2 3\n", "line 3: inf is not a usable coordinate"),
        ("v 0 0 0\nf 1 1 2\n", "line 2: vertex 2 does not exist"),
        ("v 0 0 0\nf 1 1 -2\n", "line 2: vertex -2 does not exist"),
    ] {
        let message = folder.error("bad.obj", text.as_bytes());
        assert!(message.contains(expected), "{message}");
    }
}

/// More statements than a batch has: quads with colors from the middle on, negative indices and materials.
#[test]
fn large_texts_are_read_in_batches() {
    let (columns, mut text) = (200, String::new());
    for row in 0..200 {
        text += &format!("usemtl stripe {}\n", row % 3);
        for column in 0..columns {
            text += &format!("v {column} {row} 0{}\n", if row > 170 { " 0.5 0.25 1" } else { "" });
            text += &format!("vt {} {}\n", column as f32 / 256.0, row as f32 / 256.0);
            if row > 0 && column > 0 {
                let corner = |back: i32| format!(" -{back}/-{back}");
                let below = columns + 1;
                text += &["f", &corner(below + 1), &corner(below), &corner(1), &corner(2), "\n"].concat();
            }
        }
    }
    let folder = Folder::new();
    let path = folder.file("large.obj", text.as_bytes());
    let (whole, source) = (read(&path).unwrap(), folder.open(&path).unwrap());
    assert_eq!(source.summary().groups.len(), 3);
    let unnamed = |all: Triangles| -> BTreeMap<Vec<Vec<u32>>, usize> {
        all.into_iter().map(|((corners, _), count)| (corners, count)).collect()
    };
    assert!(unnamed(of_source(&*source)) == unnamed(of_mesh(&whole)));
    let counts = |materials: Vec<Option<u32>>| {
        (0..3).map(move |m| materials.iter().filter(|&&x| x == Some(m)).count())
    };
    let mut of_pieces = Vec::new();
    for index in 0..source.piece_count() {
        let piece = source.read_piece(index).unwrap();
        of_pieces.extend(piece.groups.iter().map(|&g| source.summary().groups[g as usize].material));
    }
    let whole = whole.groups.iter().flat_map(|g| g.range().map(|_| g.material)).collect();
    assert!(counts(of_pieces).eq(counts(whole)));
}
