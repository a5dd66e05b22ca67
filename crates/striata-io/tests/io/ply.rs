//! PLY: round trips, files written by other programs, and the crate `ply-rs-bw` for comparison.

use crate::meshes::{read, refused, round_trip, sheet, square, square_with_everything, written};
use ply_rs_bw::parser::Parser;
use ply_rs_bw::ply::{DefaultElement, Property};
use striata::mesh::{AttributeLayer, IndexedMesh, LayerData, Semantic};
use striata_io::{Format, Source, WriteOptions, read_bytes_with_report, to_bytes};

#[test]
fn a_round_trip_keeps_every_layer() {
    let mesh = square_with_everything();
    // In binary, `1 - v` is rounded.
    let mut back = round_trip(Format::Ply, &mesh);
    let (LayerData::F32(found), LayerData::F32(expected)) = (&back.layers[2].data, &mesh.layers[2].data)
    else {
        panic!("{back:?}")
    };
    assert!(found.iter().zip(expected).all(|(a, b)| (a - b).abs() < 6e-8), "{found:?}");
    back.layers[2] = mesh.layers[2].clone();
    assert_eq!(back, mesh);
    let ascii = to_bytes(Format::Ply, &mesh, &WriteOptions::default().with_ascii(true)).unwrap();
    assert!(ascii.is_ascii());
    assert_eq!(read("x.ply", &ascii).unwrap(), mesh);
}

#[test]
fn ambiguous_names_survive_a_round_trip() {
    let mut mesh = square();
    for (i, name) in ["x", "nx", "red", "a.0", "generic_b", "s"].into_iter().enumerate() {
        let semantic = Semantic::Generic(name.to_owned());
        mesh.layers.push(AttributeLayer::from_f32(semantic, 1, vec![i as f32; 4]));
    }
    let wide = Semantic::Generic("wide".to_owned());
    mesh.layers.push(AttributeLayer::from_f32(wide, 5, (0..20).map(|i| i as f32).collect()));
    assert_eq!(round_trip(Format::Ply, &mesh), mesh);
    let twice = Semantic::Normal;
    for _ in 0..2 {
        mesh.layers.push(AttributeLayer::from_f32(twice.clone(), 3, vec![0.0; 12]));
    }
    let error = to_bytes(Format::Ply, &mesh, &WriteOptions::default()).unwrap_err();
    assert!(error.to_string().contains("two layers are called normal"), "{error}");
}

#[test]
fn an_independent_reader_agrees() {
    let mesh = sheet(9);
    for ascii in [false, true] {
        let bytes = to_bytes(Format::Ply, &mesh, &WriteOptions::default().with_ascii(ascii)).unwrap();
        let ply = Parser::<DefaultElement>::new().read_ply(&mut &bytes[..]).unwrap();
        let float = |e: &DefaultElement, key: &str| match e[key] {
            Property::Float(x) => x,
            ref other => panic!("{other:?}"),
        };
        let positions: Vec<[f32; 3]> =
            ply.payload["vertex"].iter().map(|e| ["x", "y", "z"].map(|key| float(e, key))).collect();
        assert_eq!(positions, mesh.positions);
        for (element, triangle) in ply.payload["face"].iter().zip(&mesh.triangles) {
            assert!(matches!(&element["vertex_indices"], Property::ListInt(l)
                if l.iter().map(|&v| v as u32).eq(*triangle)));
        }
    }
}

const FOREIGN: &str = "ply\r\nformat ascii 1.0\r\ncomment by hand\r\nobj_info none\r\n\
    element vertex 5\r\nproperty double x\r\nproperty double y\r\nproperty list uchar float weights\r\n\
    property double z\r\nproperty int flags\r\nproperty short depth\r\nproperty uchar red\r\nproperty uchar green\r\n\
    property uchar blue\r\nproperty float u\r\nproperty float v\r\n\
    element edge 1\r\nproperty int vertex1\r\nproperty int vertex2\r\n\
    element face 3\r\nproperty uchar quality\r\nproperty list int short vertex_index\r\nproperty list uchar float texcoord\r\n\
    end_header\r\n\
    0 0 1 0.5 0 7 -3 255 0 0 0.5 0.25\r\n1 0 0 0 7 -3 255 0 0 0.5 0.25\r\n1 1 2 0.5 0.5 0 7 -3 255 0 0 0.5 0.25\r\n\
    0 1 0 0 7 -3 255 0 0 0.5 0.25\r\n.5 2 0 0 4000000000 -3 255 0 0 0.5 0.25\r\n\
    0 1\r\n\
    9 5 0 1 2 4 3 0\r\n9 2 0 1 0\r\n9 3 4 3 2 6 0 0 0 0 0 0\r\n";

#[test]
fn foreign_properties_and_elements_are_tolerated() {
    let text = FOREIGN.replace("4000000000", "12");
    let mesh = read("x.ply", text.as_bytes()).unwrap();
    // The last triangle has texture coordinates of its own, which split its vertices.
    assert_eq!(mesh.triangles, [[0, 1, 2], [0, 2, 3], [0, 3, 4], [5, 6, 7]]);
    assert_eq!((mesh.positions[3], mesh.positions[5]), ([0.5, 2.0, 0.0], [0.5, 2.0, 0.0]));
    let layer = |name: &str| mesh.layer(&Semantic::Generic(name.to_owned())).unwrap();
    assert_eq!(layer("flags").data, LayerData::I32(vec![7, 7, 7, 12, 7, 12, 7, 7]));
    assert_eq!(layer("depth").data, LayerData::I16(vec![-3; 8]));
    let color = mesh.layer(&Semantic::Color(0)).unwrap();
    assert!(color.normalized && color.data == LayerData::U8([255, 0, 0].repeat(8)));
    let texcoords = [[0.5, 0.75].repeat(5), [0.0, 1.0].repeat(3)].concat();
    assert_eq!(mesh.layer(&Semantic::TexCoord(0)).unwrap().data, LayerData::F32(texcoords));
    assert!(mesh.check().is_ok());
    // A number that does not fit its type becomes the nearest one that does.
    let report = read_bytes_with_report(FOREIGN.as_bytes(), &Source::new("x.ply")).unwrap();
    let texts: Vec<String> = report.warnings.iter().map(ToString::to_string).collect();
    let expected =
        "x.ply: 1 value out of range, line 29: 4000000000 does not fit into a int; it becomes 2147483647";
    assert!(texts.iter().any(|text| text == expected), "{texts:?}");
    let flags = report.mesh.layer(&Semantic::Generic("flags".to_owned())).unwrap();
    assert_eq!(flags.data, LayerData::I32(vec![7, 7, 7, i32::MAX, 7, i32::MAX, 7, 7]));
}

/// A binary file with every unusual type, in either byte order.
fn odd_binary(big: bool) -> Vec<u8> {
    let order = if big { "big" } else { "little" };
    let mut out = format!(
        "ply\nformat binary_{order}_endian 1.0\nelement face 2\nproperty list ushort uint vertex_indices\n\
         property uchar flags\nelement vertex 4\nproperty double z\nproperty double y\nproperty float x\n\
         property ushort id\nproperty list uchar short skip\nend_header\n"
    )
    .into_bytes();
    let mut push = |bytes: &[u8]| {
        if big { out.extend(bytes.iter().rev()) } else { out.extend_from_slice(bytes) }
    };
    for polygon in [&[0u32, 1, 2, 3][..], &[3, 2, 1]] {
        push(&(polygon.len() as u16).to_le_bytes());
        polygon.iter().for_each(|v| push(&v.to_le_bytes()));
        push(&[1]);
    }
    for (i, [x, y, z]) in square().positions.into_iter().enumerate() {
        push(&f64::from(z).to_le_bytes());
        push(&f64::from(y).to_le_bytes());
        push(&x.to_le_bytes());
        push(&(i as u16 * 300).to_le_bytes());
        push(&[1]);
        push(&(-5i16).to_le_bytes());
    }
    out
}

#[test]
fn both_byte_orders_agree() {
    for big in [false, true] {
        let mesh = read("x.ply", &odd_binary(big)).unwrap();
        assert_eq!(mesh.positions, square().positions);
        assert_eq!(mesh.triangles, [[0, 1, 2], [0, 2, 3], [3, 2, 1]]);
        let ids = LayerData::U16(vec![0, 300, 600, 900]);
        assert_eq!(mesh.layer(&Semantic::Generic("id".to_owned())).unwrap().data, ids);
    }
}

#[test]
fn strips_with_restarts_are_unrolled() {
    let text = "ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\nproperty float y\nproperty float z\n\
        element tristrips 1\nproperty list int int vertex_indices\nend_header\n\
        0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 2 0\n10 0 1 2 3 4 -1 4 3 3 2\n";
    let mesh = read("x.ply", text.as_bytes()).unwrap();
    assert_eq!(mesh.triangles, [[0, 1, 2], [2, 1, 3], [2, 3, 4]]);
}

#[test]
fn errors_name_the_place() {
    let header = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n\
        element face 1\nproperty list uchar int vertex_indices\nend_header\n";
    let cases = [
        ("0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n", "line 13: vertex 3 does not exist: there are 3"),
        ("0 0 0\n1 0 0\n0 1 0\n3 0 1 -2\n", "line 13: -2 is not a vertex index"),
        ("0 0 0\n1 zero 0\n0 1 0\n3 0 1 2\n", "line 11: expected a number, found `zero`"),
        ("0 0 0\n1 0 0\n0 1 0\n3 0 1", "line 13: expected a whole number, found the end"),
        ("0 0 0\n", "line 10: 3 rows of `vertex` are declared"),
    ];
    for (body, expected) in cases {
        let message = refused("dir/x.ply", format!("{header}{body}").as_bytes());
        assert!(message.starts_with("dir/x.ply: ") && message.contains(expected), "{message}");
    }
    let mut binary = written(Format::Ply, &square());
    let at = binary.len() - 4;
    binary[at] = 200;
    let message = refused("x.ply", &binary);
    assert!(message.contains(&format!("byte {at}: vertex 200 does not exist: there are 4")), "{message}");
    assert!(refused("x.ply", b"a text that is no PLY\n").contains("begins with the line `ply`"));
}

#[test]
fn a_header_that_declares_billions_is_refused_immediately() {
    for encoding in ["ascii", "binary_little_endian", "binary_big_endian"] {
        for (vertices, faces) in [(4_000_000_000u32, 0u32), (0, 4_000_000_000), (u32::MAX, u32::MAX)] {
            let text = format!(
                "ply\nformat {encoding} 1.0\nelement vertex {vertices}\nproperty float x\nproperty float y\n\
                 property float z\nelement face {faces}\nproperty list uchar int vertex_indices\nend_header\n1 2 3\n"
            );
            assert!(refused("x.ply", text.as_bytes()).contains("are declared"), "{encoding} {vertices}");
        }
    }
}

#[test]
fn empty_meshes_and_lost_vertices_are_read() {
    let empty = IndexedMesh::default();
    assert_eq!(round_trip(Format::Ply, &empty), empty);
    let mut mesh = square();
    mesh.positions[1][1] = f32::NAN;
    for ascii in [false, true] {
        let bytes = to_bytes(Format::Ply, &mesh, &WriteOptions::default().with_ascii(ascii)).unwrap();
        let back = read("x.ply", &bytes).unwrap();
        assert_eq!((back.vertex_count(), &back.triangles[..]), (3, &[[0, 1, 2]][..]));
    }
}

/// A square with the texture coordinates and colors of a usual file.
fn textured(encoding: &str, color: &str, colors: [[f32; 3]; 4]) -> Vec<u8> {
    let mut out = format!(
        "ply\nformat {encoding} 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n\
         property float s\nproperty float t\nproperty {color} red\nproperty {color} green\n\
         property {color} blue\nelement face 2\nproperty list uchar int vertex_indices\nend_header\n"
    )
    .into_bytes();
    let texcoords = [[0.1f32, 0.75], [0.9, 0.123456], [0.9, 0.95], [0.1, 3.0 / 10.0]];
    for ((position, texcoord), rgb) in square().positions.iter().zip(texcoords).zip(colors) {
        let numbers = [position.as_slice(), &texcoord].concat();
        if encoding == "ascii" {
            let words: Vec<String> = numbers.iter().chain(&rgb).map(ToString::to_string).collect();
            out.extend_from_slice((words.join(" ").replace("0.0000001", "1e-7") + "\n").as_bytes());
        } else {
            numbers.iter().for_each(|x| out.extend_from_slice(&x.to_le_bytes()));
            match color {
                "uchar" => out.extend(rgb.map(|c| c as u8)),
                _ => rgb.iter().for_each(|c| out.extend_from_slice(&c.to_le_bytes())),
            }
        }
    }
    for triangle in [[0u32, 1, 2], [0, 2, 3]] {
        if encoding == "ascii" {
            out.extend_from_slice(format!("3 {} {} {}\n", triangle[0], triangle[1], triangle[2]).as_bytes());
        } else {
            out.push(3);
            triangle.iter().for_each(|v| out.extend_from_slice(&v.to_le_bytes()));
        }
    }
    out
}

#[test]
fn an_unchanged_file_is_written_as_it_was_read() {
    let colors = [[0.0, 51.0, 255.0], [1.0, 2.0, 3.0], [9.0; 3], [254.0; 3]];
    for (encoding, ascii) in [("ascii", true), ("binary_little_endian", false)] {
        let bytes = textured(encoding, "uchar", colors);
        let mesh = read("x.ply", &bytes).unwrap();
        assert_eq!(mesh.layer(&Semantic::TexCoord(0)).unwrap().get(0, 1), 0.25, "{encoding}");
        let again = to_bytes(Format::Ply, &mesh, &WriteOptions::default().with_ascii(ascii)).unwrap();
        let changed = bytes.iter().zip(&again).position(|(a, b)| a != b);
        assert_eq!((again.len(), changed), (bytes.len(), None), "{encoding}");
    }
}

#[test]
fn colors_are_written_as_bytes() {
    let colors = [[0.0, 0.2, 1.0], [0.5, 0.25, 0.75], [-1.0, 7.0, f32::NAN], [1.0; 3]];
    let mesh = read("x.ply", &textured("binary_little_endian", "float", colors)).unwrap();
    let bytes = LayerData::U8(vec![0, 51, 255, 128, 64, 191, 0, 255, 255, 255, 255, 255]);
    for format in [Format::Ply, Format::Off] {
        let back = round_trip(format, &mesh);
        let color = back.layer(&Semantic::Color(0)).unwrap();
        assert!(color.normalized && color.data == bytes, "{format}: {color:?}");
    }
    let text = String::from_utf8_lossy(&written(Format::Ply, &mesh)).into_owned();
    assert!(text.contains("\nproperty uchar red\n"), "{text}");
    // Integers of 16 bits become bytes, too; other color sets are ours alone and stay as they are.
    let words = LayerData::U16([0, 257, 65535, 128].repeat(4));
    let mut mesh = square();
    for set in [0, 1] {
        let (semantic, data) = (Semantic::Color(set), words.clone());
        mesh.layers.push(AttributeLayer { semantic, component_count: 4, normalized: true, data });
    }
    let back = round_trip(Format::Ply, &mesh);
    assert_eq!(back.layers[0].data, LayerData::U8([0, 1, 255, 0].repeat(4)));
    assert_eq!(back.layers[1], mesh.layers[1]);
}

#[test]
fn ply_off_and_obj_agree_on_the_origin_of_textures() {
    let ply = textured("ascii", "uchar", [[1.0; 3]; 4]);
    let mesh = read("x.ply", &ply).unwrap();
    let obj = String::from_utf8(written(Format::Obj, &mesh)).unwrap();
    let v: Vec<&str> = obj.lines().filter(|l| l.starts_with("vt ")).map(|l| &l[7..]).collect();
    assert_eq!(v, ["0.75", "0.123456", "0.95", "0.3"]);
    let off = String::from_utf8(written(Format::Off, &mesh)).unwrap();
    assert!(off.lines().nth(2).unwrap().ends_with(" 0.1 0.75"), "{off}");
    for (name, bytes) in [("x.obj", obj.as_bytes()), ("x.off", off.as_bytes())] {
        let back = read(name, bytes).unwrap();
        assert_eq!(back.layer(&Semantic::TexCoord(0)), mesh.layer(&Semantic::TexCoord(0)), "{name}");
    }
}
