//! ASCII PLY, converted to a temporary binary file with triangles only.

use super::PieceOptions;
use super::input::PieceInput;
use super::spool::Spool;
use crate::ReadError;
use crate::error::Fault;
use crate::ply::georeference_comment;
use crate::ply::header::{Element, Header, PlyProperty, Scalar};
use crate::ply::lists::{index_list, list_length, skip_element, skip_property};
use crate::ply::rows::{AsciiRows, Rows as _};
use crate::ply::vertices::flipped_columns_of;
use crate::ply::warn_of_rest;
use crate::report::Warnings;

/// Number of digits that are left for the number of triangles.
const DIGITS: usize = 10;

/// Replaces the bytes of a text file by those of a binary one.
pub(super) fn convert(
    input: &mut PieceInput,
    header: &Header,
    options: &PieceOptions,
    warnings: &mut Warnings,
) -> Result<(), ReadError> {
    input.bytes = converted(input, header, options, warnings)?.finish(options)?;
    Ok(())
}

/// Converts a text file to a binary one, whose texture coordinates count from the top of the image.
pub(crate) fn converted(
    input: &PieceInput,
    header: &Header,
    options: &PieceOptions,
    warnings: &mut Warnings,
) -> Result<Spool, ReadError> {
    let mut spool = Spool::new(options)?;
    let mut rows = AsciiRows::new(&input.bytes, header, &input.name);
    let written = write_head(header, &mut spool).and_then(|count_at| {
        let count = write_body(&mut rows, header, &mut spool)?;
        spool.replace(count_at, format!("{count:0DIGITS$}").as_bytes());
        Ok(())
    });
    written.map_err(|fault| fault.in_file(&input.name))?;
    if rows.cursor.has_long_coordinates() {
        // Doubles in a text that declares floats.
        let mut wider = header.clone();
        wider.widen_coordinates();
        return converted(input, &wider, options, warnings);
    }
    warnings.append(rows.warnings);
    warn_of_rest(&input.bytes, rows.cursor.bytes_left(), warnings);
    Ok(spool)
}

/// Writes the header; returns where the number of triangles belongs.
fn write_head(header: &Header, spool: &mut Spool) -> Result<u64, Fault> {
    let mut head = "ply\nformat binary_little_endian 1.0\n".to_owned();
    for name in &header.normalized {
        head += &format!("comment normalized {name}\n");
    }
    for name in &header.normalized_faces {
        head += &format!("comment normalized_face {name}\n");
    }
    head += &georeference_comment(&header.georeference);
    for texture in &header.texture_files {
        head += &format!("comment TextureFile {}\n", texture.name);
    }
    let vertex = header.vertex()?;
    head += &format!("element vertex {}\n", vertex.count);
    for property in &vertex.properties {
        head += &format!("property {} {}\n", property.scalar.name(), property.name);
    }
    head += "element face ";
    let count_at = head.len() as u64;
    head += &format!("{:0DIGITS$}\nproperty list uchar uint vertex_indices\n", 0);
    let faces =
        header.elements.iter().find(|element| element.name == "face" && index_list(element).is_some());
    for property in faces.iter().flat_map(|face| &face.properties).filter(|p| p.list.is_none()) {
        head += &format!("property {} {}\n", property.scalar.name(), property.name);
    }
    head += "end_header\n";
    spool.write(head.as_bytes());
    Ok(count_at)
}

/// Writes vertices and triangles; returns the number of triangles.
fn write_body(rows: &mut AsciiRows<'_>, header: &Header, spool: &mut Spool) -> Result<u32, Fault> {
    let vertex_count = header.vertex()?.count;
    let mut triangle_count = 0u32;
    for element in &header.elements {
        let needed = rows.least_row_bytes(element) as u64 * element.count as u64;
        if needed > rows.bytes_left() as u64 {
            let (count, name, left) = (element.count, &element.name, rows.bytes_left());
            let reason = format!(
                "{count} rows of `{name}` are declared, which take {needed} bytes or more, but only {left} \
                 follow"
            );
            return Err(rows.fault(reason));
        }
        match (element.name.as_str(), index_list(element)) {
            ("vertex", _) => write_vertices(element, rows, spool)?,
            ("face", Some(list)) => {
                let mut face = TextFace::default();
                for _ in 0..element.count {
                    face.read(element, list, vertex_count, rows)?;
                    let count = face.write(spool);
                    triangle_count = triangle_count
                        .checked_add(count)
                        .ok_or_else(|| rows.fault("there are too many triangles".to_owned()))?;
                }
            }
            _ => skip_element(element, rows)?,
        }
    }
    Ok(triangle_count)
}

fn write_vertices(element: &Element, rows: &mut AsciiRows<'_>, spool: &mut Spool) -> Result<(), Fault> {
    let mut row = Vec::new();
    let columns = flipped_columns_of(element);
    for _ in 0..element.count {
        row.clear();
        for (property, column) in element.properties.iter().zip(&columns) {
            if column.is_flipped {
                rows.copy_flipped(property.scalar, &mut row)?;
            } else if property.is_coordinate() {
                rows.copy_coordinate(property.scalar, &mut row)?;
            } else {
                rows.copy(property.scalar, &mut row)?;
            }
        }
        spool.write(&row);
    }
    Ok(())
}

/// A face; the lists are kept only for their memory.
#[derive(Default)]
struct TextFace {
    /// Rows of indices of its triangles.
    triangles: Vec<[u8; 13]>,
    /// Its other numbers.
    values: Vec<u8>,
}

impl TextFace {
    fn read(
        &mut self,
        element: &Element,
        list: usize,
        vertex_count: usize,
        rows: &mut AsciiRows<'_>,
    ) -> Result<(), Fault> {
        self.triangles.clear();
        self.values.clear();
        for (place, property) in element.properties.iter().enumerate() {
            match property.list {
                Some(length) if place == list => self.read_polygon(property, length, vertex_count, rows)?,
                Some(_) => skip_property(property, rows)?,
                None => rows.copy(property.scalar, &mut self.values)?,
            }
        }
        Ok(())
    }

    fn read_polygon(
        &mut self,
        property: &PlyProperty,
        length: Scalar,
        vertex_count: usize,
        rows: &mut AsciiRows<'_>,
    ) -> Result<(), Fault> {
        let length = list_length(length, rows)?;
        let (mut first, mut last) = (0, 0);
        for corner in 0..length {
            let index = rows.integer(property.scalar)?;
            let Some(vertex) = u32::try_from(index).ok().filter(|&v| (v as usize) < vertex_count) else {
                return Err(rows.fault(format!("vertex {index} does not exist: there are {vertex_count}")));
            };
            match corner {
                0 => first = vertex,
                1 => {}
                _ => {
                    let mut row = [3; 13];
                    for (bytes, vertex) in row[1..].chunks_exact_mut(4).zip([first, last, vertex]) {
                        bytes.copy_from_slice(&vertex.to_le_bytes());
                    }
                    self.triangles.push(row);
                }
            }
            last = vertex;
        }
        Ok(())
    }

    /// Writes the triangles, each with the numbers of the face; returns their count.
    fn write(&self, spool: &mut Spool) -> u32 {
        for row in &self.triangles {
            spool.write(row);
            spool.write(&self.values);
        }
        self.triangles.len() as u32
    }
}
