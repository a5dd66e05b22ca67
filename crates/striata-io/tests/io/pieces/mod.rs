//! Files that are read in pieces have the triangles that the readers of whole files find.

mod damaged;
mod gltf;
mod text;

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
    assert!(summary.warnings.iter().all(|warning| warning.reason.contains("is left out")));
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
