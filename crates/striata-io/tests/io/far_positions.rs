//! Coordinates with more digits than single precision keeps: read and written exactly by formats with doubles
//! or text, and to a ten-millionth of the diagonal by all others.

use striata::mesh::IndexedMesh;
use striata_io::{Format, Source, WriteOptions, read_bytes, to_bytes};

/// A wavy sheet of points 5 cm apart, as texts with millimeters, at an offset.
fn survey(scale: f64, offset: [f64; 3]) -> Vec<[String; 3]> {
    let point = |i: u32, j: u32| {
        let local = [0.05 * f64::from(i), 0.05 * f64::from(j), 0.3 * f64::from((i * j) % 7)];
        [0, 1, 2].map(|axis| format!("{:.9e}", (local[axis] * scale) + offset[axis] * scale))
    };
    (0..20).flat_map(|i| (0..20).map(move |j| point(i, j))).collect()
}

fn triangles() -> Vec<[u32; 3]> {
    let cells = (0..19u32).flat_map(|i| (0..19).map(move |j| 20 * i + j));
    cells.flat_map(|a| [[a, a + 1, a + 21], [a, a + 21, a + 20]]).collect()
}

fn doubles(points: &[[String; 3]]) -> Vec<[f64; 3]> {
    points.iter().map(|p| [0, 1, 2].map(|axis| p[axis].parse().unwrap())).collect()
}

fn ply(points: &[[String; 3]], encoding: &str, scalar: &str) -> Vec<u8> {
    let faces = triangles();
    let mut out = format!("ply\nformat {encoding} 1.0\nelement vertex {}\n", points.len()).into_bytes();
    for axis in ["x", "y", "z"] {
        out.extend(format!("property {scalar} {axis}\n").bytes());
    }
    let list = "property list uchar int vertex_indices\nend_header\n";
    out.extend(format!("element face {}\n{list}", faces.len()).bytes());
    for (point, values) in points.iter().zip(doubles(points)) {
        match encoding {
            "ascii" => out.extend(format!("{}\n", point.join(" ")).bytes()),
            "binary_big_endian" => values.iter().for_each(|x| out.extend(x.to_be_bytes())),
            _ => values.iter().for_each(|x| out.extend(x.to_le_bytes())),
        }
    }
    for face in faces {
        match encoding {
            "ascii" => out.extend(format!("3 {} {} {}\n", face[0], face[1], face[2]).bytes()),
            _ => {
                out.push(3);
                let is_big = encoding == "binary_big_endian";
                let bytes = |v: u32| if is_big { v.to_be_bytes() } else { v.to_le_bytes() };
                face.iter().for_each(|&v| out.extend(bytes(v)));
            }
        }
    }
    out
}

fn obj(points: &[[String; 3]]) -> Vec<u8> {
    let vertices = points.iter().map(|p| format!("v {}\n", p.join(" ")));
    let faces = triangles().into_iter().map(|[a, b, c]| format!("f {} {} {}\n", a + 1, b + 1, c + 1));
    vertices.chain(faces).collect::<String>().into_bytes()
}

fn off(points: &[[String; 3]]) -> Vec<u8> {
    let vertices = points.iter().map(|p| format!("{}\n", p.join(" ")));
    let faces = triangles().into_iter().map(|[a, b, c]| format!("3 {a} {b} {c}\n"));
    let counts = format!("OFF\n{} {} 0\n", points.len(), triangles().len());
    std::iter::once(counts).chain(vertices).chain(faces).collect::<String>().into_bytes()
}

fn stl(points: &[[String; 3]]) -> Vec<u8> {
    let corner = |v: u32| format!("vertex {}\n", points[v as usize].join(" "));
    let facet = |t: [u32; 3]| {
        let corners: String = t.map(corner).concat();
        format!("facet normal 0 0 0\nouter loop\n{corners}endloop\nendfacet\n")
    };
    let facets: String = triangles().into_iter().map(facet).collect();
    format!("solid\n{facets}endsolid\n").into_bytes()
}

fn inputs(points: &[[String; 3]]) -> Vec<(&'static str, Vec<u8>)> {
    vec![
        ("little.ply", ply(points, "binary_little_endian", "double")),
        ("big.ply", ply(points, "binary_big_endian", "double")),
        ("text.ply", ply(points, "ascii", "double")),
        ("text_of_floats.ply", ply(points, "ascii", "float")),
        ("text.obj", obj(points)),
        ("text.off", off(points)),
    ]
}

fn file_positions(mesh: &IndexedMesh) -> Vec<[f64; 3]> {
    (0..mesh.vertex_count()).map(|vertex| mesh.file_position(vertex)).collect()
}

fn largest_difference(a: &[[f64; 3]], b: &[[f64; 3]]) -> f64 {
    assert_eq!(a.len(), b.len());
    let axes = a.iter().flatten().zip(b.iter().flatten());
    axes.map(|(x, y)| (x - y).abs()).fold(0.0, f64::max)
}

const OFFSETS: [[f64; 3]; 3] = [[0.0; 3], [5e5, 5e6, 100.0], [6.4e6, -1.0, -6.4e6]];

#[test]
fn doubles_and_digits_survive_reading_and_writing() {
    for scale in [1e-6, 1.0, 1e6] {
        for offset in OFFSETS {
            let points = survey(scale, offset);
            let expected = doubles(&points);
            for (name, bytes) in inputs(&points) {
                let mesh = read_bytes(&bytes, &Source::new(name)).unwrap();
                let context = format!("{name} at {offset:?} times {scale}");
                assert!(file_positions(&mesh) == expected, "{context}");
                assert_eq!(mesh.triangles, triangles(), "{context}");
                let diagonal = mesh.diagonal();
                assert!(mesh.rounding() <= 1e-7 * diagonal, "{context}: {}", mesh.rounding() / diagonal);
                for format in [Format::Ply, Format::Obj, Format::Off] {
                    for ascii in [false, true] {
                        let options = WriteOptions::default().with_ascii(ascii);
                        let written = to_bytes(format, &mesh, &options).unwrap();
                        let again = read_bytes(&written, &Source::new("again")).unwrap();
                        let difference = largest_difference(&file_positions(&again), &expected);
                        // Short texts near zero are single precision, which prints them again.
                        let is_short = format != Format::Ply && again.exact_positions.is_empty();
                        let allowed = if is_short { 6e-8 * diagonal } else { 0.0 };
                        assert!(difference <= allowed, "{context} as {format}: {difference}");
                    }
                }
                let written = to_bytes(Format::Glb, &mesh, &WriteOptions::default()).unwrap();
                let again = read_bytes(&written, &Source::new("again")).unwrap();
                let difference = largest_difference(&file_positions(&again), &expected);
                assert!(difference <= 1e-7 * diagonal, "{context} as GLB: {}", difference / diagonal);
            }
        }
    }
}

#[test]
fn text_of_stl_is_exact_and_binary_stl_says_what_it_loses() {
    let points = survey(1.0, OFFSETS[1]);
    let mesh = read_bytes(&stl(&points), &Source::new("a.stl")).unwrap();
    let (mut found, mut expected) = (file_positions(&mesh), doubles(&points));
    found.sort_by(|a, b| a.partial_cmp(b).unwrap());
    expected.sort_by(|a, b| a.partial_cmp(b).unwrap());
    assert!(found == expected && mesh.rounding() <= 1e-7 * mesh.diagonal());
    let written = to_bytes(Format::Stl, &mesh, &WriteOptions::default()).unwrap();
    let again = read_bytes(&written, &Source::new("b.stl")).unwrap();
    // Half a unit in the last place at 5e6, and not moved by more.
    let bounds = [mesh.file_bounds().unwrap(), again.file_bounds().unwrap()];
    assert!(largest_difference(&bounds[0], &bounds[1]) <= 0.25, "{bounds:?}");
}

#[test]
fn doubles_stay_doubles() {
    let points = survey(1.0, OFFSETS[1]);
    let mesh = read_bytes(&ply(&points, "binary_little_endian", "double"), &Source::new("a")).unwrap();
    let written = to_bytes(Format::Ply, &mesh, &WriteOptions::default()).unwrap();
    assert!(String::from_utf8_lossy(&written).contains("property double x"));
    // Levels keep the type; the coordinates of single-precision programs stay floats.
    let plain: Vec<[String; 3]> =
        points.iter().map(|_| ["0.5", "123.456787", "-7"].map(str::to_owned)).collect();
    let mesh = read_bytes(&obj(&plain), &Source::new("a.obj")).unwrap();
    assert!(mesh.exact_positions.is_empty() && mesh.origin == [0.0; 3]);
}

#[test]
#[cfg(all(feature = "pieces", not(target_family = "wasm")))]
fn pieces_share_an_origin() {
    use striata_io::pieces::{PieceOptions, open_all};
    let folder = tempfile::tempdir().unwrap();
    let points = survey(1.0, OFFSETS[1]);
    let expected = doubles(&points);
    let mut paths = Vec::new();
    for (name, bytes) in inputs(&points) {
        let path = folder.path().join(name);
        std::fs::write(&path, bytes).unwrap();
        paths.push(path);
    }
    let path = folder.path().join("text.stl");
    std::fs::write(&path, stl(&points)).unwrap();
    let solid = open_all(&[path], &PieceOptions::default()).unwrap();
    let piece = solid.read_piece(0).unwrap();
    assert_eq!((piece.positions.len(), piece.triangles.len()), (points.len(), triangles().len()));
    let source = open_all(&paths, &PieceOptions::default()).unwrap();
    let origin = source.summary().origin;
    assert!(origin[0] != 0.0 && origin[1] != 0.0, "{origin:?}");
    for index in 0..source.piece_count() {
        let piece = source.read_piece(index).unwrap();
        let first = source.read_piece(0).unwrap();
        assert_eq!(piece.positions.len(), expected.len());
        assert!(piece.positions == first.positions, "all formats round alike");
        for (position, expected) in piece.positions.iter().zip(&expected) {
            let near = [0, 1, 2].map(|axis| origin[axis] + f64::from(position[axis]));
            assert!(largest_difference(&[near], &[*expected]) < 1e-6);
        }
    }
}
