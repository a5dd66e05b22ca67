//! OBJ: round trips, all features of the format around triangles, and the crate `tobj` for comparison.

use crate::meshes::{group, read, refused, round_trip, sheet, soup, square, written};
use striata::mesh::{AttributeLayer, IndexedMesh, LayerData, Material, Semantic};
use striata_io::Format;

#[test]
fn a_round_trip_changes_nothing() {
    let mut mesh = square();
    assert_eq!(round_trip(Format::Obj, &mesh), mesh);
    let texcoords = vec![0.1, 0.123_456_7, 0.0, 1.0, -3.25, 17.001, 0.333_333_34, 1e-6];
    mesh.layers = vec![
        AttributeLayer::from_f32(Semantic::Normal, 3, [0.0, 0.6, 0.8].repeat(4)),
        AttributeLayer::from_f32(Semantic::TexCoord(0), 2, texcoords),
        AttributeLayer::from_f32(Semantic::Color(0), 3, (0..12).map(|i| i as f32 / 12.0).collect()),
    ];
    mesh.groups = vec![group("left side", Some(1), 0, 1), group("", None, 1, 1)];
    let material = |name: &str| Material { name: name.to_owned(), ..Material::default() };
    mesh.appearance.materials = vec![material("wood"), material("dark stone")];
    mesh.appearance.material_libraries = vec!["my materials.mtl".to_owned()];
    let back = round_trip(Format::Obj, &mesh);
    assert_eq!(
        (&back.positions, &back.triangles, &back.layers),
        (&mesh.positions, &mesh.triangles, &mesh.layers)
    );
    // OBJ cannot store materials that no group uses.
    assert_eq!(back.groups, [group("left side", Some(0), 0, 1), group("", None, 1, 1)]);
    assert_eq!(back.appearance.materials, [material("dark stone")]);
    assert_eq!(back.appearance.material_libraries, mesh.appearance.material_libraries);
    assert_eq!(round_trip(Format::Obj, &back), back);
}

const CUBE_SIDE: &str = "\
# a comment
mtllib a.mtl
o thing
v 0 0 0 # the origin
v 1 0 0 1.0
v 1 1 0
v 0 1 0
vt 0 0.25
vt 1
vn 0 0 1
g side
usemtl red paint
s off
f 1/1/1 2/2/1 \\
  3/1/1 4/2/1
f -4 -3 -2
usemtl
l 1 2
v 9 9 9
f 5//1 1//1 2
";

#[test]
fn corners_polygons_and_negative_indices() {
    let mesh = read("x.obj", CUBE_SIDE.as_bytes()).unwrap();
    assert_eq!(mesh.triangles, [[0, 1, 2], [0, 2, 3], [4, 5, 6], [7, 8, 5]]);
    assert_eq!(mesh.vertex_count(), 9);
    assert_eq!(mesh.positions[7], [9.0, 9.0, 9.0]);
    let texcoord = mesh.layer(&Semantic::TexCoord(0)).unwrap();
    assert_eq!([texcoord.get(0, 1), texcoord.get(1, 0), texcoord.get(1, 1)], [0.75, 1.0, 1.0]);
    let normal = mesh.layer(&Semantic::Normal).unwrap();
    assert_eq!([normal.get(4, 0), normal.get(4, 1), normal.get(4, 2)], [0.0, 0.0, 1.0], "a computed normal");
    assert_eq!(mesh.groups, [group("side", Some(0), 0, 3), group("side", None, 3, 1)]);
    assert_eq!(mesh.appearance.materials[0].name, "red paint");
    assert_eq!(mesh.appearance.material_libraries, ["a.mtl"]);
    mesh.check().unwrap();
}

#[test]
fn colors_of_some_vertices_leave_the_others_white() {
    let text = "v 0 0 0\nv 1 0 0 0.5 0.25 0\nv 0 1 0\nv 0 0 1 1 2 3 4\nf 1 2 3\n";
    let mesh = read("x.obj", text.as_bytes()).unwrap();
    let colors = vec![1.0, 1.0, 1.0, 0.5, 0.25, 0.0, 1.0, 1.0, 1.0, 1.0, 2.0, 3.0];
    assert_eq!(mesh.layer(&Semantic::Color(0)).unwrap().data, LayerData::F32(colors));
}

#[test]
fn an_independent_reader_agrees() {
    let mesh = sheet(12);
    let bytes = written(Format::Obj, &mesh);
    let (models, _) =
        tobj::load_obj_buf(&mut &bytes[..], &tobj::GPU_LOAD_OPTIONS, |_| Ok(Default::default())).unwrap();
    let [model] = &models[..] else { panic!("{} models", models.len()) };
    let (positions, _) = model.mesh.positions.as_chunks::<3>();
    let triangles = model.mesh.indices.as_chunks::<3>().0.to_vec();
    assert_eq!(soup(&IndexedMesh::new(positions.to_vec(), triangles)), soup(&mesh));
}

#[test]
fn one_vertex_with_many_wedges_is_not_slow() {
    // If the whole chain of wedges were searched linearly, this would take an hour.
    const WEDGES: usize = 1_000_000;
    let mut text = String::from("v 0 0 0\nv 1 0 0\nv 0 1 0\n");
    for i in 0..WEDGES {
        text += &format!("vt {i} 0\n");
    }
    for i in 1..=WEDGES {
        text += &format!("f 1/{i} 2/1 3/1\n");
    }
    let mesh = read("x.obj", text.as_bytes()).unwrap();
    assert_eq!((mesh.vertex_count(), mesh.triangle_count()), (WEDGES + 2, WEDGES));
}

#[test]
fn errors_name_the_line() {
    let cases = [
        ("v 0 0 0\nf 1 2 1\n", "line 2: vertex 2 does not exist: there are 1"),
        ("v 0 0 0\n\nf 1 -2 1\n", "line 3: vertex -2 does not exist"),
        ("v 0 0 0\nf 0 1 1\n", "line 2: vertex 0 does not exist"),
        (
            "v 0 0 0\nf 1 x 1\n",
            "1 polygon left out, line 2: expected a whole number, found `x`) and no triangles",
        ),
        ("v 0 0 0\nf 99999999999999999999 1 1\n", "line 2: the whole number"),
        ("v 0 0 0\nf 4294967297 1 1\n", "line 2: vertex 4294967297 does not exist"),
        ("hello world\n", "line 1: no line of the file is an OBJ statement: unknown statement \"hello\""),
        ("v 0 0 0\nv 1 0 0\n", "the file has 2 points and no triangles"),
        ("v 0 0 0\nv 1 0 0\nl 1 2\n", "the file has 2 points, 1 line or curve and no triangles"),
    ];
    for (text, expected) in cases {
        let message = refused("x.obj", text.as_bytes());
        assert!(message.contains(expected), "{text:?} gave {message}");
    }
}

#[test]
fn empty_files_are_empty_meshes() {
    assert!(refused("x.obj", b"").ends_with("the file is empty"));
    for text in ["# nothing\n", "\n", "o a\n\\\n"] {
        assert_eq!(read("x.obj", text.as_bytes()).unwrap().triangle_count(), 0);
    }
    assert_eq!(round_trip(Format::Obj, &IndexedMesh::default()), IndexedMesh::default());
}
