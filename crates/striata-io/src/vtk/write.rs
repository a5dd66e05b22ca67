//! Writer: legacy binary files, and XML files with base64, which every reader of VTK understands.

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use striata::mesh::{AttributeLayer, IndexedMesh, LayerData, Semantic};

use crate::Format;
use crate::error::Refusal;
use crate::losses;
use crate::report::Warnings;

/// An array of a file, with big- or little-endian bytes.
struct NamedArray {
    name: String,
    role: ArrayRole,
    component_count: u8,
    data: Data,
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum ArrayRole {
    Normals,
    TexCoords,
    Colors,
    Other,
}

/// Values in the type in which they are written.
enum Data {
    Floats(Vec<f32>),
    Layer(LayerData),
    /// Indices, which VTK wants signed.
    Integers(Vec<i32>),
}

impl Data {
    /// Returns the name of the type in XML and in legacy files.
    fn type_names(&self) -> [&'static str; 2] {
        match self {
            Self::Floats(_) | Self::Layer(LayerData::F32(_)) => ["Float32", "float"],
            Self::Layer(LayerData::U8(_)) => ["UInt8", "unsigned_char"],
            Self::Layer(LayerData::U16(_)) => ["UInt16", "unsigned_short"],
            Self::Layer(LayerData::U32(_)) => ["UInt32", "unsigned_int"],
            Self::Layer(LayerData::I8(_)) => ["Int8", "char"],
            Self::Layer(LayerData::I16(_)) => ["Int16", "short"],
            Self::Layer(LayerData::I32(_)) | Self::Integers(_) => ["Int32", "int"],
            Self::Layer(LayerData::F64(_)) => ["Float64", "double"],
        }
    }

    fn little_endian(&self) -> Vec<u8> {
        match self {
            Self::Floats(v) => v.iter().flat_map(|x| x.to_le_bytes()).collect(),
            Self::Layer(data) => data.as_bytes().to_vec(),
            Self::Integers(v) => v.iter().flat_map(|x| x.to_le_bytes()).collect(),
        }
    }

    fn big_endian(&self) -> Vec<u8> {
        let mut bytes = self.little_endian();
        let width = match self {
            Self::Layer(data) => data.component_bytes(),
            Self::Floats(_) | Self::Integers(_) => 4,
        };
        bytes.chunks_exact_mut(width).for_each(<[u8]>::reverse);
        bytes
    }
}

/// Encodes a mesh with all its layers.
pub(crate) fn to_bytes(
    format: Format,
    mesh: &IndexedMesh,
    warnings: &mut Warnings,
) -> Result<Vec<u8>, Refusal> {
    losses::of_materials(mesh, format, warnings);
    losses::of_group_names(mesh, format, warnings);
    let count = mesh.positions.len().max(3 * mesh.triangles.len());
    if i32::try_from(count).is_err() {
        return Err(Refusal::Unsupported(
            "it has more vertices or corners than 32-bit numbers count".to_owned(),
        ));
    }
    let arrays_of = |layers: &[AttributeLayer]| layers.iter().map(array_of).collect::<Vec<_>>();
    let data = [arrays_of(&mesh.layers), arrays_of(&mesh.triangle_layers)];
    Ok(match format {
        Format::Vtk => legacy(mesh, &data),
        Format::Vtu => xml(mesh, &data, "UnstructuredGrid"),
        _ => xml(mesh, &data, "PolyData"),
    })
}

/// Returns the coordinates of all vertices, as doubles if single precision cannot hold them.
fn points_of(mesh: &IndexedMesh) -> Data {
    if mesh.needs_doubles() {
        let points = (0..mesh.positions.len()).flat_map(|vertex| mesh.file_position(vertex));
        Data::Layer(LayerData::F64(points.collect()))
    } else {
        Data::Floats(mesh.positions.as_flattened().to_vec())
    }
}

fn array_of(layer: &AttributeLayer) -> NamedArray {
    let width = layer.component_count as usize;
    let vertex_count = layer.data.len() / width.max(1);
    let values = || (0..layer.data.len()).map(|i| layer.get(i / width, i % width));
    let (name, role, data) = match &layer.semantic {
        Semantic::Normal if width == 3 => {
            ("Normals".to_owned(), ArrayRole::Normals, Data::Floats(values().collect()))
        }
        Semantic::TexCoord(0) if width == 2 => {
            // The origin of VTK's texture coordinates is at the bottom left.
            let flipped = (0..vertex_count).flat_map(|v| [layer.get(v, 0), 1.0 - layer.get(v, 1)]);
            ("TCoords".to_owned(), ArrayRole::TexCoords, Data::Floats(flipped.collect()))
        }
        Semantic::Color(0) if matches!(width, 3 | 4) => {
            let name = if width == 3 { "RGB" } else { "RGBA" };
            let bytes = values().map(|x| (x.clamp(0.0, 1.0) * 255.0).round() as u8);
            (name.to_owned(), ArrayRole::Colors, Data::Layer(LayerData::U8(bytes.collect())))
        }
        semantic => {
            let name = match semantic {
                Semantic::Generic(name) => name.clone(),
                other => other.to_string(),
            };
            let data = if layer.normalized {
                Data::Floats(values().collect())
            } else {
                Data::Layer(layer.data.clone())
            };
            (name, ArrayRole::Other, data)
        }
    };
    NamedArray { name, role, component_count: layer.component_count, data }
}

fn legacy(mesh: &IndexedMesh, [of_points, of_cells]: &[Vec<NamedArray>; 2]) -> Vec<u8> {
    let mut out = b"# vtk DataFile Version 3.0\nwritten by striata\nBINARY\nDATASET POLYDATA\n".to_vec();
    let (vertex_count, triangle_count) = (mesh.positions.len(), mesh.triangles.len());
    let points = points_of(mesh);
    push(&mut out, &format!("POINTS {vertex_count} {}\n", points.type_names()[1]), &points);
    let cells = mesh.triangles.iter().flat_map(|&[a, b, c]| [3, a as i32, b as i32, c as i32]).collect();
    push(&mut out, &format!("POLYGONS {triangle_count} {}\n", 4 * triangle_count), &Data::Integers(cells));
    for (section, count, arrays) in
        [("POINT_DATA", vertex_count, of_points), ("CELL_DATA", triangle_count, of_cells)]
    {
        if !arrays.is_empty() {
            out.extend_from_slice(format!("{section} {count}\n").as_bytes());
            legacy_data(&mut out, arrays, count);
        }
    }
    out
}

/// Appends a line and the values that follow it.
fn push(out: &mut Vec<u8>, head: &str, data: &Data) {
    out.extend_from_slice(head.as_bytes());
    out.extend(data.big_endian());
    out.push(b'\n');
}

/// Appends the arrays of the points or the cells: attributes, then a field with the others.
fn legacy_data(out: &mut Vec<u8>, arrays: &[NamedArray], count: usize) {
    let mut others = Vec::new();
    for array in arrays {
        let NamedArray { name, role, component_count, data } = array;
        let name = encoded_name(name);
        match role {
            ArrayRole::Normals => push(out, &format!("NORMALS {name} float\n"), data),
            ArrayRole::TexCoords => push(out, &format!("TEXTURE_COORDINATES {name} 2 float\n"), data),
            ArrayRole::Colors => push(out, &format!("COLOR_SCALARS {name} {component_count}\n"), data),
            ArrayRole::Other => {
                let [_, kind] = data.type_names();
                others.push((format!("{name} {component_count} {count} {kind}\n"), data));
            }
        }
    }
    if !others.is_empty() {
        out.extend_from_slice(format!("FIELD FieldData {}\n", others.len()).as_bytes());
    }
    for (head, data) in others {
        push(out, &head, data);
    }
}

fn xml(mesh: &IndexedMesh, [arrays, of_cells]: &[Vec<NamedArray>; 2], kind: &str) -> Vec<u8> {
    let (vertex_count, triangle_count) = (mesh.positions.len(), mesh.triangles.len());
    let corners: Vec<i32> = mesh.triangles.as_flattened().iter().map(|&vertex| vertex as i32).collect();
    let ends = (1..=triangle_count).map(|number| 3 * number as i32).collect();
    let is_poly = kind == "PolyData";
    let count_name = if is_poly { "NumberOfPolys" } else { "NumberOfCells" };
    let mut out = format!(
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"{kind}\" version=\"1.0\" byte_order=\"LittleEndian\" \
         header_type=\"UInt64\">\n<{kind}>\n<Piece NumberOfPoints=\"{vertex_count}\" {count_name}=\"{triangle_count}\">\n<PointData"
    );
    for (attribute, role) in
        [("Normals", ArrayRole::Normals), ("TCoords", ArrayRole::TexCoords), ("Scalars", ArrayRole::Colors)]
    {
        if let Some(array) = arrays.iter().find(|array| array.role == role) {
            out += &format!(" {attribute}=\"{}\"", escaped(&array.name));
        }
    }
    out += ">\n";
    for array in arrays {
        push_array(&mut out, &array.name, array.component_count, &array.data);
    }
    out += "</PointData>\n<CellData>\n";
    for array in of_cells {
        push_array(&mut out, &array.name, array.component_count, &array.data);
    }
    out += "</CellData>\n<Points>\n";
    push_array(&mut out, "Points", 3, &points_of(mesh));
    let cells = if is_poly { "Polys" } else { "Cells" };
    out += &format!("</Points>\n<{cells}>\n");
    push_array(&mut out, "connectivity", 1, &Data::Integers(corners));
    push_array(&mut out, "offsets", 1, &Data::Integers(ends));
    if !is_poly {
        let types = vec![super::cells::TRIANGLE; triangle_count];
        push_array(&mut out, "types", 1, &Data::Layer(LayerData::U8(types)));
    }
    out += &format!("</{cells}>\n</Piece>\n</{kind}>\n</VTKFile>\n");
    out.into_bytes()
}

fn push_array(out: &mut String, name: &str, component_count: u8, data: &Data) {
    let [kind, _] = data.type_names();
    let bytes = data.little_endian();
    let bytes = [&(bytes.len() as u64).to_le_bytes()[..], &bytes].concat();
    *out += &format!(
        "<DataArray type=\"{kind}\" Name=\"{}\" NumberOfComponents=\"{component_count}\" format=\"binary\">\n{}\n</DataArray>\n",
        escaped(name),
        STANDARD.encode(&bytes)
    );
}

/// Replaces what XML reserves; control characters, which it forbids, become blanks.
fn escaped(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '"' => out.push_str("&quot;"),
            c if c.is_control() => out.push(' '),
            c => out.push(c),
        }
    }
    out
}

/// Replaces blanks and other bytes that end a word of legacy files.
fn encoded_name(name: &str) -> String {
    let mut out = String::with_capacity(name.len());
    for byte in name.bytes() {
        if byte.is_ascii_graphic() && byte != b'%' && byte != b'"' {
            out.push(char::from(byte));
        } else {
            out += &format!("%{byte:02X}");
        }
    }
    if out.is_empty() { "data".to_owned() } else { out }
}
