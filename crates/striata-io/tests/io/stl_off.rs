//! STL and OFF: round trips, files of other programs, and errors.

use crate::meshes::{group, read, refused, round_trip, sheet, soup, square, written};
use striata::mesh::{AttributeLayer, IndexedMesh, LayerData, Semantic};
use striata_io::Format;

#[test]
fn stl_welds_its_corners() {
    let mesh = sheet(20);
    let back = round_trip(Format::Stl, &mesh);
    assert_eq!(back.vertex_count(), mesh.vertex_count());
    assert_eq!(soup(&back), soup(&mesh));
    let empty = IndexedMesh::default();
    assert_eq!(round_trip(Format::Stl, &empty), empty);
}

#[test]
fn stl_normals_are_those_of_the_triangles() {
    let bytes = written(Format::Stl, &sheet(1));
    let floats = |at: usize| [0, 4, 8].map(|i| f32::from_le_bytes(*bytes[at + i..].first_chunk().unwrap()));
    let (normal, corners) = (floats(84), [96, 108, 120].map(floats));
    let edge = |i: usize| [0, 1, 2].map(|a: usize| corners[i][a] - corners[0][a]);
    let dot = |a: [f32; 3], b: [f32; 3]| a.iter().zip(b).map(|(x, y)| x * y).sum::<f32>();
    assert!(dot(normal, edge(1)).abs() < 1e-6 && dot(normal, edge(2)).abs() < 1e-6);
    assert!((dot(normal, normal) - 1.0).abs() < 1e-6 && normal[2] > 0.0);
}

#[test]
fn binary_stl_may_begin_with_solid() {
    let mut bytes = written(Format::Stl, &square());
    bytes[..9].copy_from_slice(b"solid box");
    assert_eq!(soup(&read("x.stl", &bytes).unwrap()), soup(&square()));
    // With bytes after the triangles, only the zeros of the body show that the file is binary.
    bytes.extend_from_slice(b"more");
    assert_eq!(soup(&read("x.stl", &bytes).unwrap()), soup(&square()));
}

#[test]
fn negative_zero_is_welded_with_zero() {
    let mut mesh = IndexedMesh::new(vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]], vec![[0, 1, 2]]);
    mesh.positions.push([-0.0, 0.0, -0.0]);
    mesh.triangles.push([1, 3, 2]);
    assert_eq!(round_trip(Format::Stl, &mesh).triangles, [[0, 1, 2], [1, 0, 2]]);
}

const ASCII: &str = "solid my box
 facet normal 0 0 1
  outer loop
   vertex 0 0 0
   vertex 1.0e0 0 0
   vertex 0 1 0
  endloop
 endfacet
endsolid my box
solid lid
 FACET normal nan nan nan
  outer loop
   vertex 0 1 0
   vertex 1 0 0
   vertex 1 1 0
  endloop
 endfacet
endsolid
";

#[test]
fn ascii_stl_with_two_solids() {
    let mesh = read("x.stl", ASCII.as_bytes()).unwrap();
    assert_eq!(mesh.triangles, [[0, 1, 2], [2, 1, 3]]);
    assert_eq!(mesh.groups, [group("my box", None, 0, 1), group("lid", None, 1, 1)]);
    mesh.check().unwrap();
    assert_eq!(read("x.stl", b"solid\nendsolid\n").unwrap(), IndexedMesh::default());
}

#[test]
fn stl_errors_name_the_place() {
    assert!(refused("x.stl", &ASCII.as_bytes()[..110]).contains("line "));
    assert!(refused("x.stl", b"short").contains("byte 5: a binary STL begins with 84 bytes"));
    let mut bytes = written(Format::Stl, &square());
    bytes[80..84].copy_from_slice(&u32::MAX.to_le_bytes());
    assert!(refused("x.stl", &bytes).contains("byte 80: the header declares 4294967295 triangles"));
}

#[test]
fn an_off_round_trip_changes_nothing() {
    let mut mesh = square();
    assert_eq!(round_trip(Format::Off, &mesh), mesh);
    mesh.layers = vec![
        AttributeLayer::from_f32(Semantic::Normal, 3, [0.0, 0.6, 0.8].repeat(4)),
        AttributeLayer::from_f32(Semantic::TexCoord(0), 2, (0..8).map(|i| i as f32 / 7.0).collect()),
        AttributeLayer {
            semantic: Semantic::Color(0),
            component_count: 4,
            normalized: true,
            data: LayerData::U8((0..16).map(|i| i * 15).collect()),
        },
    ];
    assert!(written(Format::Off, &mesh).starts_with(b"STCNOFF\n"));
    assert_eq!(round_trip(Format::Off, &mesh), mesh);
    assert_eq!(round_trip(Format::Off, &IndexedMesh::default()), IndexedMesh::default());
}

#[test]
fn off_of_other_programs_is_read() {
    let text = "# made by hand\nCOFF # with colors\n5 2 0\n\n0 0 0 0.5 0.5 0.5\n1 0 0 0 0 0 # black\n1 1 0 1 1 1\n\
        0 1 0 1 0 0\n# apart\n2 2 2 0 0 1\n4 0 1 2 3 255 0 0\n2 0 1\n";
    let mesh = read("x.off", text.as_bytes()).unwrap();
    assert_eq!(mesh.triangles, [[0, 1, 2], [0, 2, 3]]);
    let color = mesh.layer(&Semantic::Color(0)).unwrap();
    assert_eq!((color.component_count, color.get(0, 1), color.get(4, 2)), (3, 0.5, 1.0));
    let one_line = read("x.off", b"OFF 3 1 3\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n").unwrap();
    assert_eq!(one_line.triangles, [[0, 1, 2]]);
}

#[test]
fn off_errors_name_the_line() {
    let cases = [
        ("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n", "line 6: polygon 0: vertex 3 of 3 does not exist"),
        ("OFF\n3 1 0\n0 0 0\n1 0\n0 1 0\n3 0 1 2\n", "line 4: vertex 1: expected a number"),
        ("OFF\n4000000000 1 0\n0 0 0\n", "4000000000 rows are declared"),
        ("OFF\n3 4000000000 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", "4000000000 rows are declared"),
        ("OFF\n-3 1 0\n", "-3 is not a valid number of vertices"),
        ("OFF BINARY\n", "binary OFF cannot be read"),
        ("4OFF\n1 0 0\n0 0 0 0\n", "cannot be read"),
        ("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n4000000000 0 1 2\n", "line 6: polygon 0: expected a whole number"),
    ];
    for (text, expected) in cases {
        let message = refused("x.off", text.as_bytes());
        assert!(message.contains(expected), "{text:?} gave {message}");
    }
}
