//! Body of a PLY file: vertices as rows of bytes, faces and strips as triangles, with the textures of faces.

use std::borrow::Cow;

use crate::error::Fault;

use super::column::Column;
use super::face_data::FaceData;
use super::face_textures::FaceTextures;
use super::header::{Element, Header, PlyProperty, Scalar};
use super::lists::{index_list, list_length, skip_element, skip_property};
use super::rows::Rows;
use super::texcoords::mark_flipped;
use super::vertices::{PlyVertices, columns_of};

/// Triangles read so far, with what an error about a bad index needs.
#[derive(Default)]
pub(crate) struct ReadFaces {
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
    faces: &mut ReadFaces,
) -> Result<PlyVertices<'a>, Fault> {
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

fn read_vertices<'a, R: Rows<'a>>(element: &Element, rows: &mut R) -> Result<PlyVertices<'a>, Fault> {
    let (mut columns, stride) = columns_of(element);
    let (count, length) = (element.count, stride * element.count);
    let has_lists = element.properties.iter().any(|p| p.list.is_some());
    if stride == 0 && count > 0 {
        return Err(rows.fault("the element `vertex` has no coordinates".to_owned()));
    }
    if !has_lists && let Some(bytes) = rows.little_endian_bytes(length) {
        return Ok(PlyVertices { rows: Cow::Borrowed(bytes), count, stride, columns, of_triangles: false });
    }
    if rows.is_text() {
        mark_flipped(&mut columns);
    }
    let mut bytes = Vec::with_capacity(length);
    for _ in 0..count {
        copy_row(element, &columns, rows, &mut bytes)?;
    }
    Ok(PlyVertices { rows: Cow::Owned(bytes), count, stride, columns, of_triangles: false })
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

pub(crate) fn read_faces<'a, R: Rows<'a>>(
    element: &Element,
    rows: &mut R,
    faces: &mut ReadFaces,
    vertex_count: usize,
) -> Result<(), Fault> {
    let Some(list) = index_list(element) else { return skip_element(element, rows) };
    let mut left = element.count;
    faces.triangles.reserve(left.min(rows.bytes_left() / 6));
    faces.data.begin(element, faces.triangles.len());
    if let Some(textured) = TextureProperties::of(element, faces.data.keeps_texture_numbers) {
        return textured.read_faces(element, list, rows, faces);
    }
    if let [PlyProperty { scalar: Scalar::I32 | Scalar::U32, list: Some(Scalar::U8 | Scalar::I8), .. }] =
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
    faces: &mut ReadFaces,
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
    faces: &mut ReadFaces,
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

fn read_index<'a, R: Rows<'a>>(scalar: Scalar, rows: &mut R, faces: &mut ReadFaces) -> Result<u32, Fault> {
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
fn read_strips<'a, R: Rows<'a>>(element: &Element, rows: &mut R, faces: &mut ReadFaces) -> Result<(), Fault> {
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
    faces: &mut ReadFaces,
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

/// Indices of the properties of a face that describe its texture.
#[derive(Clone, Copy)]
pub(crate) struct TextureProperties {
    texcoord: Option<usize>,
    number: Option<usize>,
}

impl TextureProperties {
    /// Finds the properties; [`None`] if there are none. Numbers of no textures are not among them.
    pub(crate) fn of(element: &Element, has_no_textures: bool) -> Option<Self> {
        let find = |name: &str, is_list: bool| {
            element.properties.iter().position(|p| p.name == name && p.list.is_some() == is_list)
        };
        let texcoord = find("texcoord", true);
        let number = find("texnumber", false).filter(|_| !has_no_textures);
        (texcoord.is_some() || number.is_some()).then_some(Self { texcoord, number })
    }

    /// Reads all rows of a face element; `indices` is the property with the vertices.
    fn read_faces<'a, R: Rows<'a>>(
        self,
        element: &Element,
        indices: usize,
        rows: &mut R,
        faces: &mut ReadFaces,
    ) -> Result<(), Fault> {
        faces.pad_textures();
        if self.number.is_some() {
            faces.textures.expect_numbers();
        }
        let (mut polygon, mut texcoords): (Vec<u32>, Vec<f32>) = (Vec::new(), Vec::new());
        let mut row = Vec::new();
        for _ in 0..element.count {
            polygon.clear();
            texcoords.clear();
            row.clear();
            let (mut number, mut mark) = (-1, 0);
            for (place, property) in element.properties.iter().enumerate() {
                match property.list {
                    Some(length) if place == indices => {
                        for _ in 0..list_length(length, rows)? {
                            polygon.push(read_index(property.scalar, rows, faces)?);
                        }
                    }
                    Some(length) if Some(place) == self.texcoord => {
                        let length = list_length(length, rows)?;
                        mark = rows.mark();
                        for index in 0..length {
                            // `v` counts from the bottom of the image.
                            let is_v = index % 2 == 1;
                            let scalar = property.scalar;
                            let read = if is_v { rows.one_minus(scalar) } else { rows.float(scalar) };
                            texcoords.push(read?);
                        }
                    }
                    None if Some(place) == self.number => number = rows.integer(property.scalar)?,
                    None if faces.data.is_open() => rows.copy(property.scalar, &mut row)?,
                    _ => skip_property(property, rows)?,
                }
            }
            if !texcoords.is_empty() && texcoords.len() != 2 * polygon.len() {
                let (corners, found) = (polygon.len(), texcoords.len());
                let reason =
                    format!("`texcoord` has {found} numbers for {corners} corners; expected {}", 2 * corners);
                return Err(R::fault_at(mark, reason));
            }
            faces.push_textured(&polygon, &texcoords, number);
            faces.data.push(&row, polygon.len().saturating_sub(2));
        }
        Ok(())
    }
}

impl ReadFaces {
    /// Adds missing texture data for the triangles at the end.
    pub(crate) fn pad_textures(&mut self) {
        self.textures.pad(&self.triangles);
    }

    /// Adds a polygon as a fan; there may be no texture coordinates.
    fn push_textured(&mut self, polygon: &[u32], texcoords: &[f32], number: i64) {
        for last in 2..polygon.len() {
            let places = [0, last - 1, last];
            self.triangles.push(places.map(|place| polygon[place]));
            self.textures.push(polygon, places, texcoords, number);
        }
    }

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
