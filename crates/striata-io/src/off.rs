//! OFF, ASCII: `[ST][C][N]OFF`, with normals, colors and texture coordinates at the vertices.
//!
//! The parser is our own and uses the cursor that OBJ needs anyway: the available crates read plain OFF only,
//! and their errors give no line numbers. Polygons are triangulated as fans, and each triangle gets the color of
//! its polygon.
//! Texture coordinates count from the bottom of the image, as in OBJ: `v` is flipped, in decimal. Colors are
//! written as bytes. Cost: one pass.

use striata::mesh::{AttributeLayer, IndexedMesh, LayerData, Semantic};

use crate::color_space::byte_colors;
use crate::error::{Fault, Place};
use crate::report::{WarningKind, Warnings};
use crate::text::{Cursor, plain, push_coordinates, push_f32, push_one_minus_f32, quoted};
use crate::{Format, losses};

/// Longest keyword with all its prefixes.
const MAX_KEYWORD: usize = 16;

/// Attributes of each vertex after its position, in this order.
#[derive(Clone, Copy, Default)]
pub(crate) struct OffLayout {
    has_normal: bool,
    has_color: bool,
    /// Number of color components: 3 or 4; 0 before the first vertex, which shows how many there are.
    color_count: usize,
    has_texcoord: bool,
    colors_are_bytes: bool,
    /// Whether single precision does not keep all digits of the positions.
    pub has_long_coordinates: bool,
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
pub(crate) fn read(bytes: &[u8], warnings: &mut Warnings) -> Result<IndexedMesh, Fault> {
    let (mut columns, mut triangles) = (Columns::default(), Vec::new());
    let (mut colors, mut color_values) = (PolygonColors::default(), Vec::new());
    let vertex = |layout: &OffLayout, row: &[f32]| columns.push(layout, row);
    let text = plain(bytes);
    let layout = read_rows(&text, warnings, vertex, |triangle, color| {
        triangles.push(triangle);
        colors.push(color, triangles.len(), |values| color_values.push(values));
    })?;
    let (positions, layers) = columns.into_mesh(&layout);
    colors.warn(triangles.len(), warnings);
    let has_colors = !color_values.is_empty();
    let triangle_layers = has_colors.then(|| colors.layer(color_values.into_iter())).into_iter().collect();
    let mut mesh = IndexedMesh { positions, layers, triangles, triangle_layers, ..IndexedMesh::default() };
    if layout.has_long_coordinates {
        let mut positions = Vec::with_capacity(mesh.positions.len());
        visit_coordinates(&text, |position| positions.push(position))?;
        mesh.set_file_positions(positions);
    }
    Ok(mesh)
}

/// Passes the coordinates of all vertices of a plain text to `visit`, in doubles. Only files that have more
/// digits than single precision keeps are read again for this.
pub(crate) fn visit_coordinates(text: &[u8], mut visit: impl FnMut([f64; 3])) -> Result<(), Fault> {
    let mut cursor = Cursor::new(text);
    cursor.skip_lines(Some(b'#'));
    read_keyword(&mut cursor)?;
    let vertex_count = read_count(&mut cursor, "vertices")?;
    read_count(&mut cursor, "polygons")?;
    skip_edge_count(&mut cursor);
    check_room(&cursor, vertex_count, 6)?;
    for _ in 0..vertex_count {
        cursor.skip_lines(Some(b'#'));
        visit([cursor.f64()?, cursor.f64()?, cursor.f64()?]);
        cursor.next_line();
    }
    Ok(())
}

/// Reads a plain text row by row: `vertex` gets the numbers of each vertex, `triangle` the triangles of each
/// polygon and the numbers of its color. Whether colors are bytes is only known at the end.
pub(crate) fn read_rows(
    text: &[u8],
    warnings: &mut Warnings,
    mut vertex: impl FnMut(&OffLayout, &[f32]),
    mut triangle: impl FnMut([u32; 3], &[f32]),
) -> Result<OffLayout, Fault> {
    let mut cursor = Cursor::new(text);
    cursor.skip_lines(Some(b'#'));
    let mut layout = read_keyword(&mut cursor)?;
    let vertex_count = read_count(&mut cursor, "vertices")?;
    let polygon_count = read_count(&mut cursor, "polygons")?;
    skip_edge_count(&mut cursor);
    check_room(&cursor, vertex_count, 6)?;
    let (mut row, mut has_large_color) = (Vec::new(), false);
    for number in 0..vertex_count {
        cursor.skip_lines(Some(b'#'));
        let read = read_vertex(&mut cursor, &mut layout, &mut row, warnings);
        read.map_err(|fault| in_row(fault, "vertex", number))?;
        vertex(&layout, &row);
        let color = layout.color_in(&row);
        layout.colors_are_bytes &=
            color.iter().all(|c| c.is_nan() || c.fract() == 0.0 && (0.0..=255.0).contains(c));
        has_large_color |= color.iter().any(|&c| c > 1.0);
    }
    layout.has_long_coordinates = cursor.has_long_coordinates();
    // If there are only zeros and ones, they are fractions, as in a white mesh.
    layout.colors_are_bytes &= has_large_color;
    check_room(&cursor, polygon_count, 2)?;
    let mut polygons = Polygons { vertex_count, ..Polygons::default() };
    for polygon in 0..polygon_count {
        cursor.skip_lines(Some(b'#'));
        polygons
            .read(&mut cursor, warnings, &mut triangle)
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

/// Reads the keyword, which may be in any case, have its counts attached (`OFF8 12 0`), or be missing.
fn read_keyword(cursor: &mut Cursor<'_>) -> Result<OffLayout, Fault> {
    let mut layout = OffLayout { colors_are_bytes: true, ..OffLayout::default() };
    let mut ahead = cursor.clone();
    let word = ahead.word();
    if word.strip_prefix(b"-").unwrap_or(word).iter().all(u8::is_ascii_digit) {
        return Ok(layout);
    }
    let Some((prefix, length)) = split_keyword(word) else {
        return Err(cursor.fault(format!("expected the word OFF, found {}", quoted(word))));
    };
    let mut rest = &prefix[..];
    while !rest.is_empty() {
        let (part, after) = match rest {
            [b's', b't', after @ ..] => (&mut layout.has_texcoord, after),
            [b'c', after @ ..] => (&mut layout.has_color, after),
            [b'n', after @ ..] => (&mut layout.has_normal, after),
            _ => {
                let what = format!("the OFF variant {}", quoted(word));
                return Err(Fault::Unsupported(Place::Line(cursor.line()), what));
            }
        };
        (*part, rest) = (true, after);
    }
    cursor.skip_bytes(length);
    let mut ahead = cursor.clone();
    if ahead.word().eq_ignore_ascii_case(b"BINARY") {
        return Err(Fault::Unsupported(Place::Line(cursor.line()), "binary OFF".to_owned()));
    }
    Ok(layout)
}

/// Splits a word such as `STCOFF` or `off8`: the lower-case prefix, and the length without attached counts.
/// [`None`] if it does not contain `OFF` in this way.
fn split_keyword(word: &[u8]) -> Option<(Vec<u8>, usize)> {
    let lower = word.get(..word.len().min(MAX_KEYWORD))?.to_ascii_lowercase();
    let at = lower.windows(3).position(|window| window == b"off")?;
    let counts = &word[at + 3..];
    counts.iter().all(u8::is_ascii_digit).then(|| (lower[..at].to_vec(), at + 3))
}

fn read_count(cursor: &mut Cursor<'_>, what: &str) -> Result<usize, Fault> {
    cursor.skip_lines(Some(b'#'));
    let count = cursor.integer()?;
    usize::try_from(count).map_err(|_| cursor.fault(format!("{count} is not a valid number of {what}")))
}

/// Skips the number of edges, which is not used: some writers omit it, others put it in a line of its own.
fn skip_edge_count(cursor: &mut Cursor<'_>) {
    let is_in_next_line = ends(cursor);
    cursor.next_line();
    if is_in_next_line {
        let mut ahead = cursor.clone();
        ahead.skip_lines(Some(b'#'));
        if ahead.integer().is_ok() && ends(&mut ahead) {
            ahead.next_line();
            *cursor = ahead;
        }
    }
}

/// Whether the row has no more numbers.
#[inline]
fn ends(cursor: &mut Cursor<'_>) -> bool {
    cursor.at_line_end() || cursor.peek() == Some(b'#')
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
fn read_vertex(
    cursor: &mut Cursor<'_>,
    layout: &mut OffLayout,
    row: &mut Vec<f32>,
    warnings: &mut Warnings,
) -> Result<(), Fault> {
    row.clear();
    for _ in 0..3 {
        // Numbers that are missing may be in the next line, so that all later rows are in doubt.
        let is_missing = ends(cursor);
        row.push(match cursor.coordinate() {
            Ok(coordinate) => coordinate,
            Err(fault) if is_missing => return Err(fault),
            Err(fault) => no_number(fault, warnings),
        });
    }
    if layout.has_color && layout.color_count == 0 {
        layout.color_count = count_color_words(cursor, layout);
    }
    let last = layout.row_length() - 1;
    for place in 3..layout.row_length() {
        if ends(cursor) {
            fill_row(cursor, layout, row, warnings);
            break;
        }
        let is_flipped = layout.has_texcoord && place == last;
        row.push(match cursor.number() {
            Ok(number) if is_flipped => number.one_minus_f32(),
            Ok(number) => number.to_f32(),
            Err(fault) => no_number(fault, warnings),
        });
    }
    if !ends(cursor) {
        let reason = || format!("{} follows a vertex", quoted(cursor.clone().word()));
        warnings.count(SURPLUS, || Place::Line(cursor.line()), reason);
    }
    cursor.next_line();
    Ok(())
}

const SURPLUS: WarningKind = WarningKind("vertex with surplus numbers", "vertices with surplus numbers");

/// Counts a word that is no number; the value is repaired like others that are not finite.
#[cold]
fn no_number(fault: Fault, warnings: &mut Warnings) -> f32 {
    warnings.count_fault(WarningKind::WORDS, fault);
    f32::NAN
}

/// Completes the row of a vertex that lacks attributes with NaN, which is repaired like other values that are
/// no numbers.
#[cold]
fn fill_row(cursor: &Cursor<'_>, layout: &OffLayout, row: &mut Vec<f32>, warnings: &mut Warnings) {
    let kind = WarningKind("vertex without some attributes", "vertices without some attributes");
    let reason = || format!("{} numbers instead of {}", row.len(), layout.row_length());
    warnings.count(kind, || Place::Line(cursor.line()), reason);
    row.resize(layout.row_length(), f32::NAN);
}

/// Returns how many numbers the color has: 3 or 4. The cursor is after the position.
fn count_color_words(cursor: &Cursor<'_>, layout: &OffLayout) -> usize {
    let mut ahead = cursor.clone();
    let mut word_count = 0;
    while !ahead.at_line_end() && ahead.peek() != Some(b'#') {
        ahead.word();
        word_count += 1;
    }
    let other_words = if layout.has_normal { 3 } else { 0 } + if layout.has_texcoord { 2 } else { 0 };
    if word_count >= other_words + 4 { 4 } else { 3 }
}

/// Reads polygons; the lists are kept only for their memory.
#[derive(Default)]
struct Polygons {
    vertex_count: usize,
    corners: Vec<u32>,
    color: Vec<f32>,
}

impl Polygons {
    fn read(
        &mut self,
        cursor: &mut Cursor<'_>,
        warnings: &mut Warnings,
        triangle: &mut impl FnMut([u32; 3], &[f32]),
    ) -> Result<(), Fault> {
        let corner_count = cursor.integer()?;
        if corner_count < 0 {
            return Err(cursor.fault(format!("{corner_count} is not a valid number of corners")));
        }
        self.corners.clear();
        for _ in 0..corner_count {
            let index = cursor.integer()?;
            let vertex = u32::try_from(index).ok().filter(|&v| (v as usize) < self.vertex_count);
            let missing = || format!("vertex {index} of {} does not exist", self.vertex_count);
            self.corners.push(vertex.ok_or_else(|| cursor.fault(missing()))?);
        }
        self.color.clear();
        if !ends(cursor) {
            self.read_color(cursor, warnings);
        }
        if let [first, rest @ ..] = &self.corners[..] {
            for pair in rest.windows(2) {
                triangle([*first, pair[0], pair[1]], &self.color);
            }
        }
        if corner_count < 3 {
            let reason = || format!("a polygon with {corner_count} corners");
            warnings.count(WarningKind::POLYGONS, || Place::Line(cursor.line()), reason);
        }
        cursor.next_line();
        Ok(())
    }

    /// Reads the rest of the line, which is a color if it has three or four numbers.
    fn read_color(&mut self, cursor: &mut Cursor<'_>, warnings: &mut Warnings) {
        while self.color.len() <= 4 && !ends(cursor) {
            match cursor.f32() {
                Ok(number) => self.color.push(number),
                Err(_) => self.color.resize(5, f32::NAN),
            }
        }
        if !matches!(self.color.len(), 3 | 4) {
            self.color.clear();
            let kind = WarningKind("color of a polygon left out", "colors of polygons left out");
            let reason = || "not three or four numbers".to_owned();
            warnings.count(kind, || Place::Line(cursor.line()), reason);
        }
    }
}

/// Colors of the triangles read so far: four numbers for each, which somebody else keeps.
#[derive(Debug, Default)]
pub(crate) struct PolygonColors {
    /// Number of triangles with four numbers.
    pub count: usize,
    bare_count: usize,
    has_alpha: bool,
    has_fractions: bool,
    has_large: bool,
}

impl PolygonColors {
    /// Number of values of a triangle that are kept.
    pub(crate) const WIDTH: usize = 4;

    /// Passes the color of the last of `count` triangles to `keep`, and white for those before it without one;
    /// nothing before the first color.
    pub(crate) fn push(&mut self, color: &[f32], count: usize, mut keep: impl FnMut([f32; Self::WIDTH])) {
        if color.is_empty() && self.count == 0 {
            return;
        }
        // White, in both forms of numbers.
        let white = [f32::INFINITY; Self::WIDTH];
        let before = count - 1 - self.count;
        (0..before).for_each(|_| keep(white));
        self.bare_count += before + usize::from(color.is_empty());
        keep(std::array::from_fn(|i| color.get(i).copied().unwrap_or(f32::INFINITY)));
        self.count = count;
        self.has_alpha |= color.len() == 4;
        self.has_fractions |= color.iter().any(|x| x.is_finite() && x.fract() != 0.0);
        self.has_large |= color.iter().any(|&x| x.is_finite() && x > 1.0);
    }

    /// Warns of triangles without a color.
    pub(crate) fn warn(&self, triangle_count: usize, warnings: &mut Warnings) {
        if self.bare_count > 0 {
            let reason =
                format!("{} of {triangle_count} faces have no color; they become white", self.bare_count);
            warnings.push(Place::File, reason);
        }
    }

    /// Returns the layer of some triangles.
    pub(crate) fn layer(&self, values: impl Iterator<Item = [f32; Self::WIDTH]>) -> AttributeLayer {
        let scale = if self.has_large && !self.has_fractions { 1.0 } else { 255.0 };
        let byte = |x: f32| (x * scale).clamp(0.0, 255.0).round() as u8;
        let width = if self.has_alpha { 4 } else { 3 };
        let data = LayerData::U8(values.flat_map(|color| color.into_iter().take(width).map(byte)).collect());
        let (semantic, component_count) = (Semantic::Color(0), width as u8);
        AttributeLayer { semantic, component_count, normalized: true, data }
    }
}

impl OffLayout {
    /// Returns how many numbers a vertex has.
    pub(crate) fn row_length(&self) -> usize {
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
    pub(crate) fn push(&mut self, layout: &OffLayout, row: &[f32]) {
        let (color_start, color) = (layout.color_start(), layout.color_in(row));
        self.positions.push([row[0], row[1], row[2]]);
        self.normals.extend_from_slice(&row[3..color_start]);
        self.colors.extend_from_slice(color);
        self.texcoords.extend_from_slice(&row[color_start + color.len()..]);
    }

    /// Returns positions and layers.
    pub(crate) fn into_mesh(self, layout: &OffLayout) -> (Vec<[f32; 3]>, Vec<AttributeLayer>) {
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
                let byte = |&c: &f32| if c.is_nan() { u8::MAX } else { c as u8 };
                let data = LayerData::U8(self.colors.iter().map(byte).collect());
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
    let kept: Vec<Semantic> =
        [normal, color, texcoord].into_iter().flatten().map(|layer| layer.semantic.clone()).collect();
    losses::of_layers(mesh, Format::Off, |layer| kept.contains(&layer.semantic), warnings);
    losses::of_materials(mesh, Format::Off, warnings);
    losses::of_group_names(mesh, Format::Off, warnings);
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
    for vertex in 0..mesh.positions.len() {
        push_coordinates(&mut out, mesh, vertex);
        for layer in [normal, color, texcoord].into_iter().flatten() {
            push_values(&mut out, layer, vertex);
        }
        out.push(b'\n');
    }
    let is_color = |layer: &&AttributeLayer| {
        layer.semantic == Semantic::Color(0) && matches!(layer.component_count, 3 | 4)
    };
    let face_color = mesh.triangle_layers.iter().find(is_color).map(|layer| byte_colors(layer, warnings));
    for (index, [a, b, c]) in mesh.triangles.iter().enumerate() {
        out.extend_from_slice(format!("3 {a} {b} {c}").as_bytes());
        if let Some(color) = &face_color {
            push_values(&mut out, color, index);
        }
        out.push(b'\n');
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
