//! Wavefront OBJ.
//!
//! The parser is our own: the errors of `tobj` give no line numbers, it knows materials only through an MTL
//! file that it can open (otherwise their names are lost), drops the names of groups and libraries, and is
//! slower. Polygons are triangulated as fans. Each distinct triple of position, texture coordinate and normal
//! becomes a vertex, in the order of first occurrence. If the three indices always agree, vertices are the
//! positions themselves in the order of the file, so a file from our own writer is read back vertex for
//! vertex. Cost: one pass, 12 bytes per corner while reading.
//!
//! OBJ's texture coordinates grow upward, those of a mesh downward: `v` becomes `1 - v`, subtracted in
//! decimal (`0.1` becomes `0.9`), so that a round trip changes no digit.
//!
//! Lines that mean nothing are skipped, normals and texture coordinates that do not exist are absent, and words
//! that are no numbers count as not finite; `remarks` counts them. A position that does not exist is an error.
//!
//! If the folder of the file is known, `libraries` reads the material libraries in it; `mtl` parses them, and
//! `materials` converts them to glTF materials. Whatever goes wrong there is a warning, never an error.

#[cfg(all(feature = "pieces", not(target_family = "wasm")))]
mod batches;
mod corners;
mod libraries;
mod materials;
mod mtl;
mod mtl_write;
mod remarks;
mod texture_statement;
mod write;

#[cfg(all(feature = "pieces", not(target_family = "wasm")))]
pub(crate) use batches::{ObjOutline, StatementBatch, read_batches};
#[cfg(all(feature = "pieces", not(target_family = "wasm")))]
pub(crate) use remarks::{is_missing, warn_of_missing};
pub(crate) use write::to_bytes;

use std::collections::BTreeMap;

use striata::mesh::{Appearance, IndexedMesh, Material, TriangleGroup};

use crate::Source;
use crate::error::Fault;
use crate::report::Warnings;
use crate::text::{Cursor, plain};
use corners::{Corner, CornerTables, NONE, assemble};
use libraries::LibraryStatement;

/// State of the reader after some statements.
#[derive(Default)]
struct ObjReader {
    tables: CornerTables,
    /// Three corners per triangle.
    corners: Vec<Corner>,
    /// Corners of the current polygon.
    polygon: Vec<Corner>,
    groups: Vec<TriangleGroup>,
    materials: Vec<Material>,
    material_of_name: BTreeMap<String, u32>,
    libraries: Vec<LibraryStatement>,
    name: String,
    material: Option<u32>,
    /// Whether the last group has the current name and material.
    group_is_open: bool,
    /// Number of positions, texture coordinates and normals that were taken out of the tables.
    taken: [usize; 3],
    /// Number of triangles that were taken out of the corners.
    taken_triangles: usize,
    /// Indices of each kind that were used before they were defined, and their lines: each is larger than
    /// those before it, so that the first one that is never defined is among them.
    forward: [Vec<(u32, u64)>; 3],
    /// JSON object of `# georeference JSON`, a note of our own writer; may be empty.
    georeference: String,
    /// Whether a corner of the current polygon has no index of a position.
    has_bad_corner: bool,
    warnings: Warnings,
    /// Number of statements of the format.
    known_count: u64,
}

/// Reads a mesh from the bytes of an OBJ file, and its materials from the libraries next to it.
pub(crate) fn read(bytes: &[u8], source: &Source<'_>, warnings: &mut Warnings) -> Result<IndexedMesh, Fault> {
    let bytes = &*plain(bytes);
    let mut cursor = Cursor::new(bytes).with_continuation();
    let mut reader = ObjReader::of_file(source.name);
    while !cursor.at_end() {
        reader.statement(&mut cursor)?;
        cursor.next_line();
    }
    reader.check_end()?;
    if cursor.has_long_coordinates() {
        visit_coordinates(bytes, |position| reader.tables.file_positions.push(position));
    }
    reader.drop_missing();
    warnings.append(std::mem::take(&mut reader.warnings));
    let libraries = std::mem::take(&mut reader.libraries);
    let mut mesh = reader.into_mesh();
    mesh.appearance.material_libraries = libraries.iter().map(|library| library.names.clone()).collect();
    libraries::attach(&mut mesh, &libraries, bytes.len() as u64, source, warnings);
    Ok(mesh)
}

/// Passes the coordinates of all vertices to `visit`, in doubles; words that are no numbers are NaN. Only files
/// that have more digits than single precision keeps are read again for this.
pub(crate) fn visit_coordinates(bytes: &[u8], mut visit: impl FnMut([f64; 3])) {
    let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
    let mut cursor = Cursor::new(bytes).with_continuation();
    while !cursor.at_end() {
        if cursor.word().eq_ignore_ascii_case(b"v") {
            visit([(); 3].map(|()| cursor.f64().unwrap_or(f64::NAN)));
        }
        cursor.next_line();
    }
}

impl ObjReader {
    fn of_file(name: &str) -> Self {
        Self { warnings: Warnings::of_file(name), ..Self::default() }
    }

    /// Number of positions, texture coordinates and normals so far.
    #[inline]
    fn counts(&self) -> [usize; 3] {
        let CornerTables { positions, texcoords, normals, .. } = &self.tables;
        let [a, b, c] = self.taken;
        [a + positions.len(), b + texcoords.len(), c + normals.len()]
    }

    /// Reads one statement.
    fn statement(&mut self, cursor: &mut Cursor<'_>) -> Result<(), Fault> {
        if cursor.at_line_end() {
            return Ok(());
        }
        if cursor.peek() == Some(b'#') {
            self.remark(cursor);
            return Ok(());
        }
        // Single-byte patterns are compared in registers, string patterns by calls; the difference is
        // measurable.
        self.known_count += 1;
        let word = cursor.word();
        self.words(word, cursor)
    }

    /// Reads the words of a statement after the first one.
    fn words(&mut self, word: &[u8], cursor: &mut Cursor<'_>) -> Result<(), Fault> {
        match word {
            [b'v'] => {
                self.position(cursor);
                Ok(())
            }
            [b'v', b't'] => {
                self.texcoord(cursor);
                Ok(())
            }
            [b'v', b'n'] => {
                let normal = match three_numbers(cursor) {
                    Ok(normal) => normal,
                    Err(fault) => self.no_number(fault),
                };
                self.tables.normals.push(normal);
                Ok(())
            }
            // `fo` is an older spelling.
            [b'f'] | [b'f', b'o'] => self.face(cursor),
            [b'o'] | [b'g'] => {
                self.name = name_at(cursor);
                self.group_is_open = false;
                Ok(())
            }
            b"usemtl" => {
                self.use_material(&name_at(cursor));
                Ok(())
            }
            b"mtllib" => {
                let line = cursor.line();
                self.libraries.push(LibraryStatement { names: name_at(cursor), line });
                Ok(())
            }
            _ => match in_lower_case(word) {
                Some(known) => self.words(known, cursor),
                None => {
                    self.other_statement(word, cursor);
                    Ok(())
                }
            },
        }
    }

    /// Reads `v x y z`, optionally followed by a weight, a color, or a color and alpha.
    fn position(&mut self, cursor: &mut Cursor<'_>) {
        let position = match three_coordinates(cursor) {
            Ok(position) => position,
            Err(fault) => self.no_number(fault),
        };
        self.tables.positions.push(position);
        if ends(cursor) {
            return;
        }
        let (mut extra, mut count) = ([0.0f32; 5], 0);
        while !ends(cursor) {
            if count == extra.len() {
                self.surplus(cursor);
                break;
            }
            extra[count] = match cursor.f32() {
                Ok(number) => number,
                Err(fault) => self.no_number::<1>(fault)[0],
            };
            count += 1;
        }
        if count >= 3 {
            let tables = &mut self.tables;
            // Vertices without a color are white, before the first color and after it.
            tables.colors.resize((tables.positions.len() - 1) * 3, 1.0);
            tables.colors.extend_from_slice(&extra[..3]);
        }
    }

    fn texcoord(&mut self, cursor: &mut Cursor<'_>) {
        let texcoord = match texcoord_at(cursor) {
            Ok(texcoord) => texcoord,
            Err(fault) => self.no_number(fault),
        };
        self.tables.texcoords.push(texcoord);
    }

    fn face(&mut self, cursor: &mut Cursor<'_>) -> Result<(), Fault> {
        let mut polygon = std::mem::take(&mut self.polygon);
        polygon.clear();
        while !ends(cursor) {
            polygon.push(self.corner(cursor)?);
        }
        if self.has_bad_corner {
            self.has_bad_corner = false;
        } else if polygon.len() >= 3 {
            self.open_group();
            for pair in polygon[1..].windows(2) {
                self.corners.extend_from_slice(&[polygon[0], pair[0], pair[1]]);
            }
        } else {
            self.no_polygon(polygon.len(), cursor);
        }
        self.polygon = polygon;
        Ok(())
    }

    /// Reads a corner: `v`, `v/vt`, `v//vn` or `v/vt/vn`.
    #[inline]
    fn corner(&mut self, cursor: &mut Cursor<'_>) -> Result<Corner, Fault> {
        let counts = self.counts();
        let mut corner = [self.index(cursor, 0, counts[0])?, NONE, NONE];
        for kind in 1..3 {
            if cursor.peek() != Some(b'/') {
                break;
            }
            cursor.skip_byte();
            let is_there = !matches!(cursor.peek(), None | Some(b'/' | b' ' | b'\t' | b'\r' | b'\n'));
            if is_there {
                corner[kind] = self.index(cursor, kind, counts[kind])?;
            }
        }
        Ok(corner)
    }

    /// Reads an index that counts from 1, or backward from the end if negative.
    #[inline]
    fn index(&mut self, cursor: &mut Cursor<'_>, kind: usize, count: usize) -> Result<u32, Fault> {
        let index = match cursor.integer() {
            Ok(index) => index,
            Err(fault) if kind == 0 && cursor.is_after_digits() => return Err(fault),
            Err(fault) => return Ok(self.no_index(kind, fault)),
        };
        let found = match index {
            0 => None,
            1.. => u32::try_from(index - 1).ok().filter(|&i| i != NONE),
            _ => count.checked_add_signed(index as isize).map(|i| i as u32),
        };
        match found {
            Some(found) if (found as usize) < count => Ok(found),
            found => self.unusual_index(cursor, kind, index, found),
        }
    }

    /// Selects the material of the following triangles.
    fn use_material(&mut self, name: &str) {
        self.group_is_open = false;
        if name.is_empty() {
            self.material = None;
            return;
        }
        let next = self.materials.len() as u32;
        let material = *self.material_of_name.entry(name.to_owned()).or_insert(next);
        if material == next {
            self.materials.push(Material { name: name.to_owned(), ..Material::default() });
        }
        self.material = Some(material);
    }

    /// Appends a group for the next triangle if the last group does not match.
    fn open_group(&mut self) {
        if self.group_is_open {
            return;
        }
        self.group_is_open = true;
        let fits = |group: &TriangleGroup| group.material == self.material && group.name == self.name;
        if !self.groups.last().is_some_and(fits) {
            let first = (self.taken_triangles + self.corners.len() / 3) as u32;
            let (name, material) = (self.name.clone(), self.material);
            self.groups.push(TriangleGroup { name, material, first, count: 0 });
        }
    }

    fn into_mesh(mut self) -> IndexedMesh {
        let triangle_count = (self.corners.len() / 3) as u32;
        let mut end = triangle_count;
        for group in self.groups.iter_mut().rev() {
            group.count = end - group.first;
            end = group.first;
        }
        if matches!(&self.groups[..], [only] if only.name.is_empty() && only.material.is_none()) {
            self.groups.clear();
        }
        let appearance = Appearance {
            materials: self.materials,
            georeference: self.georeference,
            ..Appearance::default()
        };
        IndexedMesh { groups: self.groups, appearance, ..assemble(self.tables, &self.corners) }
    }
}

/// Returns a statement as it should be written, if it is one in capitals.
#[cold]
fn in_lower_case(word: &[u8]) -> Option<&'static [u8]> {
    const STATEMENTS: [&[u8]; 9] = [b"v", b"vt", b"vn", b"f", b"fo", b"o", b"g", b"usemtl", b"mtllib"];
    let is_same = |known: &&[u8]| known.eq_ignore_ascii_case(word) && *known != word;
    STATEMENTS.into_iter().find(|known| is_same(known))
}

#[inline]
fn three_numbers(cursor: &mut Cursor<'_>) -> Result<[f32; 3], Fault> {
    Ok([cursor.f32()?, cursor.f32()?, cursor.f32()?])
}

#[inline]
fn three_coordinates(cursor: &mut Cursor<'_>) -> Result<[f32; 3], Fault> {
    Ok([cursor.coordinate()?, cursor.coordinate()?, cursor.coordinate()?])
}

#[inline]
fn texcoord_at(cursor: &mut Cursor<'_>) -> Result<[f32; 2], Fault> {
    let u = cursor.f32()?;
    let v = if ends(cursor) { 1.0 } else { cursor.number()?.one_minus_f32() };
    Ok([u, v])
}

/// Whether the statement has no more words.
#[inline]
fn ends(cursor: &mut Cursor<'_>) -> bool {
    cursor.at_line_end() || cursor.peek() == Some(b'#')
}

/// Returns the rest of the line: names may contain blanks.
fn name_at(cursor: &mut Cursor<'_>) -> String {
    String::from_utf8_lossy(cursor.rest_of_line()).into_owned()
}
