//! OFF, ASCII: `[ST][C][N]OFF`, with normals, colors and texture coordinates at the vertices.
//!
//! The parser is our own and uses the cursor that OBJ needs anyway: the available crates read plain OFF only,
//! and their errors give no line numbers. Polygons are triangulated as fans; colors of polygons are ignored.
//! Texture coordinates count from the bottom of the image, as in OBJ: `v` is flipped, in decimal. Colors are
//! written as bytes. Cost: one pass.

use striata::mesh::{AttributeLayer, IndexedMesh, LayerData, Semantic};

use crate::color_space::byte_colors;
use crate::error::{Fault, Place};
use crate::report::Warnings;
use crate::text::{Cursor, push_f32, push_one_minus_f32, quoted};

/// Attributes of each vertex after its position, in this order.
#[derive(Clone, Copy, Default)]
pub(crate) struct Layout {
    has_normal: bool,
    has_color: bool,
    /// Number of color components: 3 or 4; 0 before the first vertex, which shows how many there are.
    color_count: usize,
    has_texcoord: bool,
    colors_are_bytes: bool,
}

/// Numbers of some vertices, by attribute.
#[derive(Default)]
pub(crate) struct Columns {
    positions: Vec<[f32; 3]>,
    normals: Vec<f32>,
    colors: Vec<f32>,
    texcoords: Vec<f32>,
}

/// Reads a mesh from the bytes of an OFF file.
pub(crate) fn read(bytes: &[u8]) -> Result<IndexedMesh, Fault> {
    let (mut columns, mut triangles) = (Columns::default(), Vec::new());
    let vertex = |layout: &Layout, row: &[f32]| {
        columns.push(layout, row);
        Ok(())
    };
    let layout = read_rows(bytes, vertex, |triangle| triangles.push(triangle))?;
    let (positions, layers) = columns.into_mesh(&layout);
    Ok(IndexedMesh { positions, layers, triangles, ..IndexedMesh::default() })
}

/// Reads a file row by row: `vertex` gets the numbers of each vertex and may refuse them, `triangle` the
/// triangles of each polygon. Whether colors are bytes is only known at the end.
pub(crate) fn read_rows(
    bytes: &[u8],
    mut vertex: impl FnMut(&Layout, &[f32]) -> Result<(), String>,
    mut triangle: impl FnMut([u32; 3]),
) -> Result<Layout, Fault> {
    let mut cursor = Cursor::new(bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes));
    cursor.skip_lines(Some(b'#'));
    let mut layout = read_keyword(&mut cursor)?;
    cursor.skip_lines(Some(b'#'));
    let vertex_count = read_count(&mut cursor, "vertices")?;
    let polygon_count = read_count(&mut cursor, "polygons")?;
    // The edge count is not used; some writers omit it.
    cursor.next_line();
    check_room(&cursor, vertex_count, 6)?;
    let (mut row, mut has_large_color) = (Vec::new(), false);
    for number in 0..vertex_count {
        cursor.skip_lines(Some(b'#'));
        let line = cursor.line();
        let read = read_vertex(&mut cursor, &mut layout, &mut row);
        let read = read.and_then(|()| vertex(&layout, &row).map_err(|reason| Fault::at_line(line, reason)));
        read.map_err(|fault| in_row(fault, "vertex", number))?;
        let color = layout.color_in(&row);
        layout.colors_are_bytes &= color.iter().all(|c| c.fract() == 0.0 && (0.0..=255.0).contains(c));
        has_large_color |= color.iter().any(|&c| c > 1.0);
    }
    // If there are only zeros and ones, they are fractions, as in a white mesh.
    layout.colors_are_bytes &= has_large_color;
    check_room(&cursor, polygon_count, 2)?;
    for polygon in 0..polygon_count {
        cursor.skip_lines(Some(b'#'));
        read_polygon(&mut cursor, vertex_count, &mut triangle)
            .map_err(|fault| in_row(fault, "polygon", polygon))?;
    }
    Ok(layout)
}

fn in_row(fault: Fault, what: &str, row: usize) -> Fault {
    match fault {
        Fault::Malformed(place, reason) => Fault::Malformed(place, format!("{what} {row}: {reason}")),
        other => other,
    }
}

fn read_keyword(cursor: &mut Cursor<'_>) -> Result<Layout, Fault> {
    let word = cursor.word();
    let Some(mut prefix) = word.strip_suffix(b"OFF") else {
        return Err(cursor.fault(format!("expected the word OFF, found {}", quoted(word))));
    };
    let mut take = |part: &[u8]| match prefix.strip_prefix(part) {
        Some(rest) => {
            prefix = rest;
            true
        }
        None => false,
    };
    let (has_texcoord, has_color, has_normal) = (take(b"ST"), take(b"C"), take(b"N"));
    if !prefix.is_empty() {
        let what = format!("the OFF variant {}", quoted(word));
        return Err(Fault::Unsupported(Place::Line(cursor.line()), what));
    }
    if cursor.clone().word() == b"BINARY" {
        return Err(Fault::Unsupported(Place::Line(cursor.line()), "binary OFF".to_owned()));
    }
    Ok(Layout { has_normal, has_color, color_count: 0, has_texcoord, colors_are_bytes: true })
}

fn read_count(cursor: &mut Cursor<'_>, what: &str) -> Result<usize, Fault> {
    let count = cursor.integer()?;
    usize::try_from(count).map_err(|_| cursor.fault(format!("{count} is not a valid number of {what}")))
}

/// Refuses counts that the remaining bytes cannot contain, before anything is allocated for them.
fn check_room(cursor: &Cursor<'_>, count: usize, least_bytes: usize) -> Result<(), Fault> {
    let left = cursor.bytes_left();
    if count > left / least_bytes + 1 {
        return Err(cursor.fault(format!("{count} rows are declared, but only {left} bytes follow")));
    }
    Ok(())
}

/// Reads the numbers of a vertex.
fn read_vertex(cursor: &mut Cursor<'_>, layout: &mut Layout, row: &mut Vec<f32>) -> Result<(), Fault> {
    row.clear();
    for _ in 0..layout.color_start() {
        row.push(cursor.f32()?);
    }
    if layout.has_color && layout.color_count == 0 {
        layout.color_count = count_color_words(cursor, layout.has_texcoord);
    }
    for _ in 0..layout.color_count {
        row.push(cursor.f32()?);
    }
    if layout.has_texcoord {
        row.push(cursor.f32()?);
        row.push(cursor.number()?.one_minus_f32());
    }
    cursor.next_line();
    Ok(())
}

/// Returns how many numbers the color has that follows: 3 or 4.
fn count_color_words(cursor: &Cursor<'_>, has_texcoord: bool) -> usize {
    let mut ahead = cursor.clone();
    let mut word_count = 0;
    while !ahead.at_line_end() && ahead.peek() != Some(b'#') {
        ahead.word();
        word_count += 1;
    }
    let color_words = if has_texcoord { word_count.max(2) - 2 } else { word_count };
    if color_words >= 4 { 4 } else { 3 }
}

fn read_polygon(
    cursor: &mut Cursor<'_>,
    vertex_count: usize,
    triangle: &mut impl FnMut([u32; 3]),
) -> Result<(), Fault> {
    let corner_count = cursor.integer()?;
    if corner_count < 0 {
        return Err(cursor.fault(format!("{corner_count} is not a valid number of corners")));
    }
    let (mut first, mut last) = (0, 0);
    for corner in 0..corner_count {
        let index = cursor.integer()?;
        let Some(vertex) = u32::try_from(index).ok().filter(|&v| (v as usize) < vertex_count) else {
            return Err(cursor.fault(format!("vertex {index} of {vertex_count} does not exist")));
        };
        match corner {
            0 => first = vertex,
            1 => {}
            _ => triangle([first, last, vertex]),
        }
        last = vertex;
    }
    cursor.next_line();
    Ok(())
}

impl Layout {
    /// Returns how many numbers a vertex has.
    #[cfg(all(feature = "pieces", not(target_family = "wasm")))]
    pub(crate) fn width(&self) -> usize {
        self.color_start() + self.color_count + if self.has_texcoord { 2 } else { 0 }
    }

    fn color_start(&self) -> usize {
        if self.has_normal { 6 } else { 3 }
    }

    fn color_in<'r>(&self, row: &'r [f32]) -> &'r [f32] {
        &row[self.color_start()..self.color_start() + self.color_count]
    }
}

impl Columns {
    /// Appends the numbers of a vertex.
    pub(crate) fn push(&mut self, layout: &Layout, row: &[f32]) {
        let (color_start, color) = (layout.color_start(), layout.color_in(row));
        self.positions.push([row[0], row[1], row[2]]);
        self.normals.extend_from_slice(&row[3..color_start]);
        self.colors.extend_from_slice(color);
        self.texcoords.extend_from_slice(&row[color_start + color.len()..]);
    }

    /// Returns positions and layers.
    pub(crate) fn into_mesh(self, layout: &Layout) -> (Vec<[f32; 3]>, Vec<AttributeLayer>) {
        let mut layers = Vec::new();
        if layout.has_normal {
            layers.push(AttributeLayer::from_f32(Semantic::Normal, 3, self.normals));
        }
        if layout.has_texcoord {
            layers.push(AttributeLayer::from_f32(Semantic::TexCoord(0), 2, self.texcoords));
        }
        if layout.has_color {
            let component_count = layout.color_count.max(3) as u8;
            layers.push(if layout.colors_are_bytes {
                let data = LayerData::U8(self.colors.iter().map(|&c| c as u8).collect());
                AttributeLayer { semantic: Semantic::Color(0), component_count, normalized: true, data }
            } else {
                AttributeLayer::from_f32(Semantic::Color(0), component_count, self.colors)
            });
        }
        (self.positions, layers)
    }
}

/// Encodes a mesh; normals, the first colors and the first texture coordinates are kept, other layers and
/// groups are not.
pub(crate) fn to_bytes(mesh: &IndexedMesh, warnings: &mut Warnings) -> Vec<u8> {
    let fitting = |semantic: &Semantic, counts: &[u8]| {
        mesh.layer(semantic).filter(|layer| counts.contains(&layer.component_count))
    };
    let normal = fitting(&Semantic::Normal, &[3]);
    let color = fitting(&Semantic::Color(0), &[3, 4]).map(|layer| byte_colors(layer, warnings));
    let color = color.as_deref();
    let texcoord = fitting(&Semantic::TexCoord(0), &[2]);
    let mut out = Vec::with_capacity(mesh.positions.len() * 32 + mesh.triangles.len() * 24);
    let prefix = |there: bool, name: &'static str| if there { name } else { "" };
    let counts = format!(
        "{}{}{}OFF\n{} {} 0\n",
        prefix(texcoord.is_some(), "ST"),
        prefix(color.is_some(), "C"),
        prefix(normal.is_some(), "N"),
        mesh.positions.len(),
        mesh.triangles.len()
    );
    out.extend_from_slice(counts.as_bytes());
    for (vertex, position) in mesh.positions.iter().enumerate() {
        for (axis, &x) in position.iter().enumerate() {
            if axis > 0 {
                out.push(b' ');
            }
            push_f32(&mut out, x);
        }
        for layer in [normal, color, texcoord].into_iter().flatten() {
            push_values(&mut out, layer, vertex);
        }
        out.push(b'\n');
    }
    for [a, b, c] in &mesh.triangles {
        out.extend_from_slice(format!("3 {a} {b} {c}\n").as_bytes());
    }
    out
}

fn push_values(out: &mut Vec<u8>, layer: &AttributeLayer, vertex: usize) {
    let count = layer.component_count as usize;
    for component in 0..count {
        out.push(b' ');
        match &layer.data {
            LayerData::U8(bytes) if layer.semantic == Semantic::Color(0) && layer.normalized => {
                out.extend_from_slice(bytes[vertex * count + component].to_string().as_bytes());
            }
            _ if component == 1 && layer.semantic == Semantic::TexCoord(0) => {
                push_one_minus_f32(out, layer.get(vertex, component));
            }
            _ => push_f32(out, layer.get(vertex, component)),
        }
    }
}
