//! Body of a PLY file: vertices as rows of bytes, faces and strips as triangles.

use std::borrow::Cow;
use std::collections::BTreeSet;

use striata::mesh::{AttributeLayer, LayerData, Semantic, relative_position};

use crate::error::{Fault, Place};

use super::column::Column;
use super::face_data::FaceData;
use super::face_textures::{FaceTextures, TextureProperties};
use super::header::{Element, Header, Property, Scalar};
use super::names::{ColumnSet, column_sets};
use super::rows::Rows;
use super::texcoords::{flip, mark_flipped};

/// Vertex element without its lists: `count` rows of `stride` little-endian bytes.
pub(crate) struct Vertices<'a> {
    rows: Cow<'a, [u8]>,
    count: usize,
    stride: usize,
    columns: Vec<Column>,
    /// Whether the rows are those of triangles.
    of_triangles: bool,
}

/// Triangles read so far, with what an error about a bad index needs.
#[derive(Default)]
pub(crate) struct Faces {
    pub triangles: Vec<[u32; 3]>,
    /// Texture data of the triangles, as far as there are any.
    pub textures: FaceTextures,
    /// Other numbers of the faces.
    pub data: FaceData,
    /// The largest index, and a fault at its position that is used if it is out of range.
    largest: Option<(i64, Fault)>,
}

/// Reads all elements in order; those that do not describe triangles are skipped.
pub(crate) fn read_elements<'a, R: Rows<'a>>(
    header: &Header,
    rows: &mut R,
    faces: &mut Faces,
) -> Result<Vertices<'a>, Fault> {
    let vertex_count = header.vertex()?.count;
    let mut vertices = None;
    for element in &header.elements {
        check_room(element, rows)?;
        match element.name.as_str() {
            "vertex" if vertices.is_none() => vertices = Some(read_vertices(element, rows)?),
            "face" => read_faces(element, rows, faces, vertex_count)?,
            "tristrips" => read_strips(element, rows, faces)?,
            _ => skip_element(element, rows)?,
        }
    }
    vertices.ok_or_else(|| rows.fault("the element `vertex` is missing".to_owned()))
}

/// Refuses counts that the remaining bytes cannot contain, before anything is allocated for them.
fn check_room<'a>(element: &Element, rows: &impl Rows<'a>) -> Result<(), Fault> {
    let (needed, left) = (rows.least_row_bytes(element) as u64 * element.count as u64, rows.bytes_left());
    if needed > left as u64 {
        let (count, name) = (element.count, &element.name);
        let reason = format!(
            "{count} rows of `{name}` are declared, which take {needed} bytes or more, but only {left} follow"
        );
        return Err(rows.fault(reason));
    }
    Ok(())
}

pub(super) fn columns_of(element: &Element) -> (Vec<Column>, usize) {
    let mut offset = 0;
    let mut columns = Vec::new();
    for property in element.properties.iter().filter(|p| p.list.is_none()) {
        let (name, scalar) = (property.name.clone(), property.scalar);
        columns.push(Column { name, scalar, offset, is_flipped: false });
        offset += property.scalar.bytes();
    }
    (columns, offset)
}

/// Returns the columns, those with texture coordinates marked.
#[cfg(all(feature = "pieces", not(target_family = "wasm")))]
pub(crate) fn flipped_columns_of(element: &Element) -> Vec<Column> {
    let (mut columns, _) = columns_of(element);
    mark_flipped(&mut columns);
    columns
}

fn read_vertices<'a, R: Rows<'a>>(element: &Element, rows: &mut R) -> Result<Vertices<'a>, Fault> {
    let (mut columns, stride) = columns_of(element);
    let (count, length) = (element.count, stride * element.count);
    let has_lists = element.properties.iter().any(|p| p.list.is_some());
    if stride == 0 && count > 0 {
        return Err(rows.fault("the element `vertex` has no coordinates".to_owned()));
    }
    if !has_lists && let Some(bytes) = rows.little_endian_bytes(length) {
        return Ok(Vertices { rows: Cow::Borrowed(bytes), count, stride, columns, of_triangles: false });
    }
    if rows.is_text() {
        mark_flipped(&mut columns);
    }
    let mut bytes = Vec::with_capacity(length);
    for _ in 0..count {
        copy_row(element, &columns, rows, &mut bytes)?;
    }
    Ok(Vertices { rows: Cow::Owned(bytes), count, stride, columns, of_triangles: false })
}

/// Appends the numbers of a row, as little-endian bytes; lists are left out.
fn copy_row<'a>(
    element: &Element,
    columns: &[Column],
    rows: &mut impl Rows<'a>,
    out: &mut Vec<u8>,
) -> Result<(), Fault> {
    let mut columns = columns.iter();
    for property in &element.properties {
        if property.list.is_some() {
            skip_property(property, rows)?;
        } else if columns.next().is_some_and(|column| column.is_flipped) {
            rows.copy_flipped(property.scalar, out)?;
        } else if property.is_coordinate() {
            rows.copy_coordinate(property.scalar, out)?;
        } else {
            rows.copy(property.scalar, out)?;
        }
    }
    Ok(())
}

pub(crate) fn skip_property<'a>(property: &Property, rows: &mut impl Rows<'a>) -> Result<(), Fault> {
    let count = match property.list {
        None => 1,
        Some(scalar) => list_length(scalar, rows)?,
    };
    rows.skip(property.scalar, count)
}

pub(crate) fn list_length<'a>(scalar: Scalar, rows: &mut impl Rows<'a>) -> Result<usize, Fault> {
    let length = rows.integer(scalar)?;
    usize::try_from(length).map_err(|_| rows.fault(format!("a list cannot have {length} entries")))
}

pub(crate) fn skip_element<'a>(element: &Element, rows: &mut impl Rows<'a>) -> Result<(), Fault> {
    if element.properties.iter().all(|p| p.list.is_none()) {
        for property in &element.properties {
            rows.skip(property.scalar, element.count)?;
        }
        return Ok(());
    }
    for _ in 0..element.count {
        for property in &element.properties {
            skip_property(property, rows)?;
        }
    }
    Ok(())
}

/// Returns the index of the vertex list among an element's properties.
pub(crate) fn index_list(element: &Element) -> Option<usize> {
    let is_index_list =
        |p: &Property| p.list.is_some() && matches!(p.name.as_str(), "vertex_indices" | "vertex_index");
    element.properties.iter().position(is_index_list)
}

pub(crate) fn read_faces<'a, R: Rows<'a>>(
    element: &Element,
    rows: &mut R,
    faces: &mut Faces,
    vertex_count: usize,
) -> Result<(), Fault> {
    let Some(list) = index_list(element) else { return skip_element(element, rows) };
    let mut left = element.count;
    faces.triangles.reserve(left.min(rows.bytes_left() / 6));
    faces.data.begin(element, faces.triangles.len());
    if let Some(textured) = TextureProperties::of(element, faces.data.keeps_texture_numbers) {
        return textured.read_faces(element, list, rows, faces);
    }
    if let [Property { scalar: Scalar::I32 | Scalar::U32, list: Some(Scalar::U8 | Scalar::I8), .. }] =
        element.properties[..]
    {
        left -= read_plain_triangles(rows, left, faces, vertex_count);
    }
    let mut row = Vec::new();
    for _ in 0..left {
        row.clear();
        let first = faces.triangles.len();
        for (place, property) in element.properties.iter().enumerate() {
            match property.list {
                Some(length) if place == list => read_polygon(property.scalar, length, rows, faces)?,
                None if faces.data.is_open() => rows.copy(property.scalar, &mut row)?,
                _ => skip_property(property, rows)?,
            }
        }
        faces.data.push(&row, faces.triangles.len() - first);
    }
    Ok(())
}

/// Reads rows of the usual form, three 32-bit indices after one length byte. Stops at the first other row
/// and returns the number of rows read.
fn read_plain_triangles<'a>(
    rows: &mut impl Rows<'a>,
    count: usize,
    faces: &mut Faces,
    vertex_count: usize,
) -> usize {
    const ROW: usize = 13;
    let Some(rest) = rows.little_endian_rest() else { return 0 };
    let mut read = 0;
    for row in rest.chunks_exact(ROW).take(count) {
        let index = |at: usize| u32::from_le_bytes([row[at], row[at + 1], row[at + 2], row[at + 3]]);
        let triangle = [index(1), index(5), index(9)];
        if row[0] != 3 || triangle.iter().any(|&v| v as usize >= vertex_count) {
            break;
        }
        faces.triangles.push(triangle);
        read += 1;
    }
    rows.little_endian_bytes(read * ROW);
    read
}

fn read_polygon<'a, R: Rows<'a>>(
    scalar: Scalar,
    length: Scalar,
    rows: &mut R,
    faces: &mut Faces,
) -> Result<(), Fault> {
    let length = list_length(length, rows)?;
    let (mut first, mut last) = (0, 0);
    for corner in 0..length {
        let vertex = read_index(scalar, rows, faces)?;
        match corner {
            0 => first = vertex,
            1 => {}
            _ => faces.triangles.push([first, last, vertex]),
        }
        last = vertex;
    }
    Ok(())
}

pub(super) fn read_index<'a, R: Rows<'a>>(
    scalar: Scalar,
    rows: &mut R,
    faces: &mut Faces,
) -> Result<u32, Fault> {
    let mark = rows.mark();
    let index = rows.integer(scalar)?;
    let Ok(vertex) = u32::try_from(index) else {
        return Err(R::fault_at(mark, format!("{index} is not a vertex index")));
    };
    if faces.largest.as_ref().is_none_or(|&(largest, _)| index > largest) {
        // Only a new maximum can be the first index out of range.
        faces.largest = Some((index, R::fault_at(mark, String::new())));
    }
    Ok(vertex)
}

/// Reads triangle strips as Stanford writes them: one list, with strips separated by -1.
fn read_strips<'a, R: Rows<'a>>(element: &Element, rows: &mut R, faces: &mut Faces) -> Result<(), Fault> {
    let Some(list) = index_list(element) else { return skip_element(element, rows) };
    for _ in 0..element.count {
        for (place, property) in element.properties.iter().enumerate() {
            match property.list.filter(|_| place == list) {
                Some(length) => read_strip_list(property.scalar, length, rows, faces)?,
                None => skip_property(property, rows)?,
            }
        }
    }
    Ok(())
}

fn read_strip_list<'a, R: Rows<'a>>(
    scalar: Scalar,
    length: Scalar,
    rows: &mut R,
    faces: &mut Faces,
) -> Result<(), Fault> {
    let (mut before_last, mut last, mut seen) = (0, 0, 0usize);
    for _ in 0..list_length(length, rows)? {
        let mark = rows.mark();
        let index = rows.integer(scalar)?;
        if index == -1 {
            seen = 0;
            continue;
        }
        let Ok(vertex) = u32::try_from(index) else {
            return Err(R::fault_at(mark, format!("{index} is not a vertex index")));
        };
        if faces.largest.as_ref().is_none_or(|&(largest, _)| index > largest) {
            faces.largest = Some((index, R::fault_at(mark, String::new())));
        }
        if seen >= 2 && before_last != last && last != vertex && before_last != vertex {
            let is_odd = seen % 2 == 1;
            let (a, b) = if is_odd { (last, before_last) } else { (before_last, last) };
            faces.triangles.push([a, b, vertex]);
        }
        (before_last, last) = (last, vertex);
        seen += 1;
    }
    Ok(())
}

impl Faces {
    /// Checks that all vertex indices are in range.
    pub(crate) fn check_indices(&mut self, vertex_count: usize) -> Result<(), Fault> {
        match self.largest.take() {
            Some((index, Fault::Malformed(place, _))) if index >= vertex_count as i64 => {
                let reason = format!("vertex {index} does not exist: there are {vertex_count}");
                Err(Fault::Malformed(place, reason))
            }
            _ => Ok(()),
        }
    }
}

impl<'a> Vertices<'a> {
    /// Wraps whole rows of little-endian bytes, of any number; their texture coordinates count from the top
    /// of the image if `has_top_origin` is set.
    #[cfg(all(any(feature = "blocks", feature = "pieces"), not(target_family = "wasm")))]
    pub(crate) fn of_rows(element: &Element, rows: Cow<'a, [u8]>, has_top_origin: bool) -> Self {
        let (mut columns, stride) = columns_of(element);
        if has_top_origin {
            mark_flipped(&mut columns);
        }
        Self { count: rows.len() / stride.max(1), rows, stride, columns, of_triangles: false }
    }
}

impl<'a> Vertices<'a> {
    /// Wraps whole rows of triangles.
    pub(super) fn of_triangles(rows: Cow<'a, [u8]>, (columns, stride): (Vec<Column>, usize)) -> Self {
        Self { count: rows.len() / stride.max(1), rows, stride, columns, of_triangles: true }
    }
}

impl Vertices<'_> {
    /// Returns the columns of x, y and z; [`None`] if there are no vertices and no such columns.
    fn axes(&self, header: &Header) -> Result<Option<[&Column; 3]>, Fault> {
        let mut axes = Vec::with_capacity(3);
        for name in ["x", "y", "z"] {
            let Some(column) = self.columns.iter().find(|c| c.name == name) else {
                if header.vertex()?.count == 0 {
                    return Ok(None);
                }
                let reason = format!("the element `vertex` has no property `{name}`");
                return Err(Fault::Malformed(Place::File, reason));
            };
            axes.push(column);
        }
        Ok(Some([axes[0], axes[1], axes[2]]))
    }

    /// Returns the positions of all vertices relative to an origin.
    pub(crate) fn positions(&self, header: &Header, origin: [f64; 3]) -> Result<Vec<[f32; 3]>, Fault> {
        let Some(axes) = self.axes(header)? else { return Ok(Vec::new()) };
        let [x, y, z] = axes.map(|column| column.offset);
        let are_floats = axes.iter().all(|c| c.scalar == Scalar::F32);
        if are_floats && y == x + 4 && z == x + 8 && origin == [0.0; 3] {
            let position = |row: &[u8]| [f32_at(row, 0), f32_at(row, 4), f32_at(row, 8)];
            return Ok(self.rows().map(|row| position(&row[x..x + 12])).collect());
        }
        Ok(self.rows().map(|row| relative_position(axes.map(|column| to_f64(row, column)), origin)).collect())
    }

    /// Returns the coordinates of all vertices in doubles, if single precision cannot hold their type.
    pub(crate) fn file_positions(&self, header: &Header) -> Result<Option<Vec<[f64; 3]>>, Fault> {
        let Some(axes) = self.axes(header)? else { return Ok(None) };
        if !axes.iter().any(|column| matches!(column.scalar, Scalar::F64 | Scalar::I32 | Scalar::U32)) {
            return Ok(None);
        }
        Ok(Some(self.rows().map(|row| axes.map(|column| to_f64(row, column))).collect()))
    }

    fn rows(&self) -> impl ExactSizeIterator<Item = &[u8]> {
        debug_assert_eq!(self.rows.len(), self.count * self.stride, "rows are whole");
        self.rows.chunks_exact(self.stride.max(1))
    }

    /// Returns the attribute layers of all vertices.
    pub(crate) fn layers(&self, header: &Header) -> Vec<AttributeLayer> {
        let mut seen = BTreeSet::new();
        let sets = column_sets(&self.columns, self.of_triangles);
        let first_of_its_name = |set: &&ColumnSet<'_>| seen.insert(set.semantic.clone());
        sets.iter().filter(first_of_its_name).map(|set| self.layer(set, header)).collect()
    }

    fn layer(&self, set: &ColumnSet<'_>, header: &Header) -> AttributeLayer {
        let semantic = set.semantic.clone();
        let component_count = set.columns.len() as u8;
        let (data, normalized) = match (&semantic, set.columns[0].scalar) {
            (Semantic::Normal | Semantic::Tangent, _) => (self.floats(set), false),
            (Semantic::MorphPosition(_) | Semantic::MorphNormal(_) | Semantic::MorphTangent(_), _) => {
                (self.floats(set), false)
            }
            (Semantic::Color(_), Scalar::I16 | Scalar::I32 | Scalar::U32) => {
                (self.gathered(set, |row, c| (to_f64(row, c) / 255.0) as f32, LayerData::F32), false)
            }
            (Semantic::Color(_) | Semantic::TexCoord(_) | Semantic::Weights(_), scalar) => {
                (self.typed(set), matches!(scalar, Scalar::U8 | Scalar::U16))
            }
            (Semantic::Generic(name), _) => {
                let names = if self.of_triangles { &header.normalized_faces } else { &header.normalized };
                (self.typed(set), names.contains(name))
            }
            (Semantic::Joints(_), _) => (self.typed(set), false),
        };
        let mut layer = AttributeLayer { semantic, component_count, normalized, data };
        if !self.of_triangles && !set.columns.iter().any(|column| column.is_flipped) {
            flip(&mut layer);
        }
        layer
    }

    /// Returns the columns in their own type.
    fn typed(&self, set: &ColumnSet<'_>) -> LayerData {
        match set.columns[0].scalar {
            Scalar::U8 => self.gathered(set, |row, c| row[c.offset], LayerData::U8),
            Scalar::U16 => self.gathered(set, |row, c| to_f64(row, c) as u16, LayerData::U16),
            Scalar::U32 => self.gathered(set, |row, c| to_f64(row, c) as u32, LayerData::U32),
            Scalar::I8 => self.gathered(set, |row, c| row[c.offset] as i8, LayerData::I8),
            Scalar::I16 => self.gathered(set, |row, c| to_f64(row, c) as i16, LayerData::I16),
            Scalar::I32 => self.gathered(set, |row, c| to_f64(row, c) as i32, LayerData::I32),
            Scalar::F32 | Scalar::F64 => self.floats(set),
        }
    }

    fn floats(&self, set: &ColumnSet<'_>) -> LayerData {
        if set.columns.iter().all(|c| c.scalar == Scalar::F32) {
            return self.gathered(set, |row, c| f32_at(row, c.offset), LayerData::F32);
        }
        if set.columns.iter().all(|c| c.scalar == Scalar::F64) {
            return self.gathered(set, to_f64, LayerData::F64);
        }
        self.gathered(set, |row, c| to_f64(row, c) as f32, LayerData::F32)
    }

    fn gathered<T>(
        &self,
        set: &ColumnSet<'_>,
        number: impl Fn(&[u8], &Column) -> T,
        data: impl Fn(Vec<T>) -> LayerData,
    ) -> LayerData {
        let mut out = Vec::with_capacity(self.count * set.columns.len());
        for row in self.rows() {
            out.extend(set.columns.iter().map(|&column| number(row, column)));
        }
        data(out)
    }
}

#[inline]
fn f32_at(row: &[u8], offset: usize) -> f32 {
    f32::from_le_bytes([row[offset], row[offset + 1], row[offset + 2], row[offset + 3]])
}

/// Converts any number of a row; every type fits into an `f64` exactly.
fn to_f64(row: &[u8], column: &Column) -> f64 {
    let mut word = [0u8; 8];
    let length = column.scalar.bytes();
    word[..length].copy_from_slice(&row[column.offset..column.offset + length]);
    let value = u64::from_le_bytes(word);
    match column.scalar {
        Scalar::I8 => f64::from(value as i8),
        Scalar::I16 => f64::from(value as i16),
        Scalar::I32 => f64::from(value as i32),
        Scalar::U8 | Scalar::U16 | Scalar::U32 => value as f64,
        Scalar::F32 => f64::from(f32::from_bits(value as u32)),
        Scalar::F64 => f64::from_bits(value),
    }
}
