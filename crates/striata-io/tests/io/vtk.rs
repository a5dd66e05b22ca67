//! VTK: legacy and XML files in all their encodings, and errors.

use crate::meshes::{self, read, refused};
use striata::mesh::{AttributeLayer, IndexedMesh, LayerData, Semantic};
use striata_io::{Format, ReadError, Source, read_bytes_with_report};

/// Returns the mesh of a file and its warnings, without the file's name.
fn with_warnings(name: &str, bytes: &[u8]) -> (IndexedMesh, Vec<String>) {
    let report = read_bytes_with_report(bytes, &Source::new(name)).unwrap();
    (report.mesh, report.warnings.into_iter().map(|warning| warning.reason).collect())
}

/// A quad and a triangle, a line, normals, texture coordinates, colors and two other arrays.
const LEGACY: &str = "# vtk DataFile Version 3.0\nmade by hand\nASCII\nDATASET POLYDATA\nPOINTS 5 double\n\
    0 0 0 1 0 0\n1 1 0 0 1 0\n0.5 2 0.1\nLINES 1 3\n2 0 1\nPOLYGONS 2 9\n4 0 1 2 3\n3 3 2 4\nPOINT_DATA 5\n\
    NORMALS n float\n0 0 1 0 0 1 0 0 1 0 0 1 0 0 1\nTEXTURE_COORDINATES uv 2 float\n0 0 1 0 1 0.25 0 1 0.5 1\n\
    COLOR_SCALARS rgb 3\n1 0 0 0 1 0 0 0 1 1 1 1 0.5 0.5 0.5\nFIELD FieldData 2\nheat%20flow 1 5 float\n1 2 3 4 5\n\
    METADATA\nINFORMATION 0\n\nid 1 5 unsigned_int\n9 8 7 6 123456789\nCELL_DATA 3\nSCALARS part unsigned_char\n\
    LOOKUP_TABLE default\n0 1 2\n";

#[test]
fn legacy_text_is_read_with_its_data() {
    let (mesh, warnings) = with_warnings("a.vtk", LEGACY.as_bytes());
    assert_eq!(mesh.triangles, [[0, 1, 2], [0, 2, 3], [3, 2, 4]]);
    assert_eq!(mesh.positions[4], [0.5, 2.0, 0.1]);
    assert_eq!(mesh.layer(&Semantic::Normal).unwrap().data, LayerData::F32([0.0, 0.0, 1.0].repeat(5)));
    let LayerData::F32(uv) = &mesh.layer(&Semantic::TexCoord(0)).unwrap().data else { panic!("{mesh:?}") };
    assert_eq!(uv[4..6], [1.0, 0.75]);
    let LayerData::U8(colors) = &mesh.layer(&Semantic::Color(0)).unwrap().data else { panic!("{mesh:?}") };
    assert_eq!(colors[9..], [255, 255, 255, 128, 128, 128]);
    let generic = |name: &str| &mesh.layer(&Semantic::Generic(name.to_owned())).unwrap().data;
    assert_eq!(*generic("heat flow"), LayerData::F32(vec![1.0, 2.0, 3.0, 4.0, 5.0]));
    assert_eq!(*generic("id"), LayerData::U32(vec![9, 8, 7, 6, 123_456_789]));
    // The quad is two triangles, and the line, which comes first, is none.
    assert_eq!(mesh.triangle_layers[0].data, LayerData::U8(vec![1, 1, 2]));
    assert!(warnings.iter().any(|text| text.starts_with("1 cells are left out: lines")), "{warnings:?}");
}

/// Appends numbers as big-endian 32-bit integers.
fn push_big(out: &mut Vec<u8>, numbers: &[i32]) {
    out.extend(numbers.iter().flat_map(|n| n.to_be_bytes()));
}

#[test]
fn legacy_bytes_are_big_endian() {
    let mut old = b"# vtk DataFile Version 2.0\n\nBINARY\nDATASET POLYDATA\nPOINTS 4 float\n".to_vec();
    let points = [0.0f32, 0.0, 0.0, 1.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 1.0, 0.0];
    old.extend(points.iter().flat_map(|x| x.to_be_bytes()));
    let mut new = old.clone();
    new[23..26].copy_from_slice(b"5.1");
    old.extend(b"\nTRIANGLE_STRIPS 1 5\n");
    push_big(&mut old, &[4, 0, 1, 3, 2]);
    old.extend(b"\nPOINT_DATA 4\nFIELD FieldData 2\nwords 1 4 string\n\xc1a\xc0\xc2bc\xc1d\nw 1 4 short\n");
    old.extend([0, 1, 0, 2, 0xff, 0xff, 0, 4]);
    let (mesh, warnings) = with_warnings("a.vtk", &old);
    assert_eq!(mesh.triangles, [[0, 1, 3], [3, 1, 2]]);
    assert_eq!(warnings.len(), 1, "{warnings:?}");
    assert_eq!(mesh.layers[0].get(2, 0), -1.0);
    // Version 5.1: offsets and connectivity with 64 bits.
    new.extend(b"\nPOLYGONS 3 6\nOFFSETS vtktypeint64\n");
    new.extend([0i64, 3, 6].iter().flat_map(|n| n.to_be_bytes()));
    new.extend(b"\nCONNECTIVITY vtktypeint64\n");
    new.extend([0i64, 1, 2, 0, 2, 3].iter().flat_map(|n| n.to_be_bytes()));
    assert_eq!(read("a.vtk", &new).unwrap().triangles, [[0, 1, 2], [0, 2, 3]]);
}

#[test]
fn damaged_legacy_files_are_refused_with_their_place() {
    let head = "# vtk DataFile Version 3.0\n\nASCII\nDATASET POLYDATA\nPOINTS 3 float\n0 0 0 1 0 0 0 1 0\n";
    for (rest, expected) in [
        ("POLYGONS 1 4\n3 0 1 3\n", "line 8: cell 0: point 3 of 3 does not exist"),
        ("POLYGONS 1 4\n4 0 1 2\n", "line 8: cell 0 of 1 does not end within the 4 entries"),
        (
            "POLYGONS 1 9000000000\n3 0 1 2\n",
            "line 8: 9000000000 values are declared, but only 8 bytes remain",
        ),
        ("POLYGONS 1 4\n3 0 x 2\n", "line 8: expected a number of the type Int32, found `x`"),
        ("POLYGONS 1 4\n3 0 1 2 7\n", "line 8: unknown keyword `7`"),
        (
            "POINT_DATA 3\nNORMALS n complex\n",
            "line 8: expected the name of a type, such as float, found `complex`",
        ),
    ] {
        let message = refused("a.vtk", format!("{head}{rest}").as_bytes());
        assert!(message.contains(expected), "{message}");
    }
    let message = refused("a.vtk", b"# vtk DataFile Version 3.0\n\nASCII\nDATASET STRUCTURED_GRID\n");
    assert!(message.contains("a structured grid"), "{message}");
}

#[test]
fn grids_of_volumes_are_an_error_with_a_hint() {
    let text = "# vtk DataFile Version 3.0\n\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 4 float\n0 0 0 1 0 0 0 1 0 0 0 1\n";
    let volume = format!("{text}CELLS 1 5\n4 0 1 2 3\nCELL_TYPES 1\n10\n");
    let error = read("a.vtk", volume.as_bytes()).unwrap_err();
    assert_eq!(error.to_string(), "a.vtk: an unstructured grid of 1 volume cells and no triangles");
    assert!(error.hint().unwrap().contains("extract_surface"));
    let mixed = format!("{text}CELLS 2 9\n4 0 1 2 3\n3 0 1 2\nCELL_TYPES 2\n10\n5\n");
    let (mesh, warnings) = with_warnings("a.vtk", mixed.as_bytes());
    assert_eq!((mesh.triangle_count(), warnings.len()), (1, 1));
}

/// Returns an unstructured grid of two pieces; `array` formats the values of an array.
fn vtu(attributes: &str, mut array: impl FnMut(&str, &str, &[f64]) -> String, appended: &str) -> Vec<u8> {
    let piece = [
        array("Float64", "NumberOfComponents=\"3\"", &[0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.25]),
        array("Int64", "Name=\"connectivity\"", &[0.0, 1.0, 2.0]),
        array("Int64", "Name=\"offsets\"", &[3.0]),
        array("UInt8", "Name=\"types\"", &[5.0]),
        array("Float32", "Name=\"t\"", &[0.5, 1.5, 2.5]),
    ];
    let [points, connectivity, offsets, types, t] = piece;
    let piece = format!(
        "<Piece NumberOfPoints=\"3\" NumberOfCells=\"1\"><PointData Scalars=\"t\">{t}</PointData>\n<Points>{points}\
         </Points><Cells>{connectivity}{offsets}{types}</Cells></Piece>\n"
    );
    format!(
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" {attributes}>\n\
         <UnstructuredGrid>{piece}{piece}</UnstructuredGrid>{appended}</VTKFile>\n"
    )
    .into_bytes()
}

fn bytes_of(kind: &str, values: &[f64]) -> Vec<u8> {
    let bytes = |&x: &f64| match kind {
        "Float64" => x.to_le_bytes().to_vec(),
        "Float32" => (x as f32).to_le_bytes().to_vec(),
        "Int64" => (x as i64).to_le_bytes().to_vec(),
        _ => vec![x as u8],
    };
    values.iter().flat_map(bytes).collect()
}

fn base64(bytes: &[u8]) -> String {
    const DIGITS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let group =
        |group: &[u8]| {
            let word =
                group.iter().fold(0u32, |word, &byte| word << 8 | u32::from(byte)) << (8 * (3 - group.len()));
            (0..4)
                .map(move |i| {
                    if i > group.len() {
                        '='
                    } else {
                        char::from(DIGITS[(word >> (18 - 6 * i) & 63) as usize])
                    }
                })
                .collect::<String>()
        };
    bytes.chunks(3).map(group).collect()
}

fn packed(bytes: &[u8]) -> (Vec<u8>, Vec<u8>) {
    use std::io::Write as _;
    let mut encoder = flate2::write::ZlibEncoder::new(Vec::new(), flate2::Compression::default());
    encoder.write_all(bytes).unwrap();
    let data = encoder.finish().unwrap();
    let header = [1, bytes.len() as u32, 0, data.len() as u32];
    (header.iter().flat_map(|n| n.to_le_bytes()).collect(), data)
}

/// All encodings of the same grid, by name.
fn vtu_files() -> Vec<(&'static str, Vec<u8>)> {
    let tag = |kind: &str, more: &str, format: &str, text: &str| {
        format!("<DataArray type=\"{kind}\" {more} format=\"{format}\">{text}</DataArray>")
    };
    let text = |kind: &str, more: &str, values: &[f64]| {
        let words: Vec<String> = values.iter().map(ToString::to_string).collect();
        tag(kind, more, "ascii", &format!("\n{}\n", words.join(" ")))
    };
    let plain = |kind: &str, more: &str, values: &[f64]| {
        let data = bytes_of(kind, values);
        tag(kind, more, "binary", &base64(&[&(data.len() as u32).to_le_bytes()[..], &data].concat()))
    };
    let long = |kind: &str, more: &str, values: &[f64]| {
        let data = bytes_of(kind, values);
        tag(kind, more, "binary", &format!("{}{}", base64(&(data.len() as u64).to_le_bytes()), base64(&data)))
    };
    let zlib = |kind: &str, more: &str, values: &[f64]| {
        let (header, data) = packed(&bytes_of(kind, values));
        tag(kind, more, "binary", &format!("{}{}", base64(&header), base64(&data)))
    };
    let mut data: Vec<u8> = Vec::new();
    let appended = |kind: &str, more: &str, values: &[f64]| {
        let more = format!("{more} offset=\"{}\"", data.len());
        let (header, body) = packed(&bytes_of(kind, values));
        data.extend(header);
        data.extend(body);
        tag(kind, &more, "appended", "")
    };
    let mut raw = vtu("byte_order=\"LittleEndian\" compressor=\"vtkZLibDataCompressor\"", appended, "");
    raw.truncate(raw.len() - "</VTKFile>\n".len());
    raw.extend(b"<AppendedData encoding=\"raw\">\n_");
    raw.extend(data);
    raw.extend(b"</AppendedData></VTKFile>\n");
    vec![
        ("text.vtu", vtu("", text, "")),
        ("base64.vtu", vtu("byte_order=\"LittleEndian\"", plain, "")),
        ("long.vtu", vtu("header_type=\"UInt64\"", long, "")),
        ("zlib.vtu", vtu("compressor=\"vtkZLibDataCompressor\"", zlib, "")),
        ("raw.vtu", raw),
    ]
}

#[test]
fn xml_files_are_read_in_every_encoding() {
    let files = vtu_files();
    for (name, bytes) in &files {
        let (mesh, warnings) = with_warnings(name, bytes);
        assert_eq!(mesh.triangles, [[0, 1, 2], [3, 4, 5]], "{name}");
        assert_eq!(mesh.positions[5], [0.0, 1.0, 0.25], "{name}");
        assert_eq!(mesh.layers[0].data, LayerData::F32(vec![0.5, 1.5, 2.5, 0.5, 1.5, 2.5]), "{name}");
        assert!(warnings.is_empty(), "{name}: {warnings:?}");
    }
}

#[test]
fn damaged_xml_files_are_refused_with_their_line() {
    let (_, text) = vtu_files().swap_remove(0);
    let text = String::from_utf8(text).unwrap();
    for (from, to, expected) in [
        ("1 0.25", "one", "expected a number of the type Float64, found `one`"),
        ("\n0 1 2\n", "\n0 1 3\n", "`Cells`: cell 0: point 3 of 3 does not exist"),
        ("NumberOfPoints=\"3\"", "NumberOfPoints=\"4\"", "`Points` has 3 points instead of 4"),
        ("UInt8", "String", "expected numbers, found the type String"),
        ("</Points>", "", "the XML is malformed"),
        (
            "VTKFile type",
            "VTKFile compressor=\"vtkLZMADataCompressor\" type",
            "vtkLZMADataCompressor cannot be read",
        ),
    ] {
        let message = refused("a.vtu", text.replacen(from, to, 1).as_bytes());
        assert!(message.contains(expected) && message.starts_with("a.vtu: line "), "{message}");
    }
}

#[test]
fn other_data_sets_of_vtk_have_a_hint() {
    let text = b"<?xml version=\"1.0\"?>\n<VTKFile type=\"ImageData\" version=\"0.1\"><ImageData/></VTKFile>";
    let error = read("a.vti", text).unwrap_err();
    assert!(matches!(error, ReadError::NeedsConversion { .. }), "{error}");
}

#[test]
fn every_truncation_is_an_error_or_a_consistent_mesh() {
    let files = vtu_files().into_iter().chain([("a.vtk", LEGACY.as_bytes().to_vec())]);
    for (name, bytes) in files {
        for length in 0..bytes.len() {
            if let Ok(mesh) = read(name, &bytes[..length]) {
                mesh.check().unwrap_or_else(|error| panic!("{name} cut to {length}: {error}"));
            }
        }
    }
}

#[test]
fn meshes_survive_writing_in_all_three_formats() {
    let mut mesh = meshes::square_with_everything();
    let labels = |semantic: &str, data| AttributeLayer {
        semantic: Semantic::Generic(semantic.to_owned()),
        component_count: 1,
        normalized: false,
        data,
    };
    mesh.triangle_layers = vec![
        labels("part id", LayerData::I32(vec![-7, 123_456_789])),
        labels("q", LayerData::F64(vec![0.1, 1e300])),
    ];
    mesh.layers.retain(|layer| !matches!(layer.semantic, Semantic::TexCoord(1) | Semantic::Color(1)));
    for format in [Format::Vtk, Format::Vtp, Format::Vtu] {
        let back = meshes::round_trip(format, &mesh);
        assert_eq!((&back.positions, &back.triangles), (&mesh.positions, &mesh.triangles), "{format}");
        for layer in &mesh.layers {
            let semantic = match &layer.semantic {
                known @ (Semantic::Normal | Semantic::Color(0) | Semantic::Generic(_)) => known.clone(),
                // Flipping twice rounds.
                Semantic::TexCoord(0) => continue,
                other => Semantic::Generic(other.to_string()),
            };
            let found = back.layer(&semantic).unwrap_or_else(|| panic!("{format}: {semantic}"));
            if layer.normalized && semantic != Semantic::Color(0) {
                // VTK has no integers that stand for fractions.
                assert_eq!(found.get(1, 0), layer.get(1, 0), "{format}: {semantic}");
            } else {
                assert_eq!(found.data, layer.data, "{format}: {semantic}");
            }
        }
        assert!(back.layer(&Semantic::TexCoord(0)).is_some());
        assert_eq!(back.triangle_layers, mesh.triangle_layers, "{format}");
    }
}

#[test]
fn doubles_far_from_the_origin_are_kept() {
    let mut mesh = meshes::square();
    let [x, y] = [500_000.05, 5_000_000.7];
    mesh.set_file_positions(vec![[x, y, 0.1], [x + 1.1, y, 0.2], [x + 1.3, y + 1.7, 0.3], [x, y + 2.3, 0.4]]);
    for format in [Format::Vtk, Format::Vtp, Format::Vtu] {
        let back = meshes::round_trip(format, &mesh);
        assert_eq!((&back.exact_positions, back.origin), (&mesh.exact_positions, mesh.origin), "{format}");
    }
}
