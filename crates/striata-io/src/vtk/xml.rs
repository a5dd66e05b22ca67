//! XML files: `.vtp` (poly data) and `.vtu` (unstructured grids), with arrays as text, as base64, or appended.
//!
//! Bytes that are appended raw are not XML: the parser gets the file up to them.

use quick_xml::events::{BytesStart, Event};
use quick_xml::{Reader, XmlVersion};

use super::array::{Array, Role, Values, VtkScalar};
use super::blocks::{BlockCompression, Storage, VtkBytes};
use super::cells::{LINES, POINTS, POLYGON, STRIP};
use super::grid::VtkGrid;
use crate::error::{Fault, Place};
use crate::report::Warnings;

/// Start of the element with appended data.
const APPENDED: &[u8] = b"<AppendedData";

/// Lists of cells of poly data, in the order of their data.
const POLY_LISTS: [(&str, u8); 4] =
    [("Verts", POINTS), ("Lines", LINES), ("Polys", POLYGON), ("Strips", STRIP)];

/// Reader of a file, element by element.
struct XmlReader<'a, 'w> {
    bytes: &'a [u8],
    storage: Storage,
    /// Bytes after the underscore of the appended data, and whether they are base64.
    appended: Option<(&'a [u8], bool)>,
    grid: VtkGrid,
    piece: PieceArrays,
    piece_count: usize,
    warnings: &'w mut Warnings,
}

/// Arrays of a piece.
#[derive(Default)]
struct PieceArrays {
    points: Option<(Values, usize)>,
    point_count: usize,
    /// Arrays of the elements with cells: the element, the name of the array, and the numbers.
    lists: Vec<(String, String, Vec<i64>, usize)>,
    /// Arrays of points and of cells.
    data: [Vec<Array>; 2],
    /// Names of the arrays that are normals and texture coordinates.
    roles: [String; 2],
}

/// Reads the points, cells and data of a file.
pub(super) fn read(bytes: &[u8], warnings: &mut Warnings) -> Result<VtkGrid, Fault> {
    let start = bytes.windows(APPENDED.len()).position(|window| window == APPENDED);
    let (head, appended) = match start {
        Some(start) => (&bytes[..start], Some(appended_data(bytes, start)?)),
        None => (bytes, None),
    };
    let mut reader = XmlReader {
        bytes: head,
        storage: Storage::default(),
        appended,
        grid: VtkGrid::default(),
        piece: PieceArrays::default(),
        piece_count: 0,
        warnings,
    };
    reader.elements()?;
    Ok(reader.grid)
}

/// Returns the bytes after the underscore, and whether they are base64.
fn appended_data(bytes: &[u8], start: usize) -> Result<(&[u8], bool), Fault> {
    let after = &bytes[start..];
    let end = after.iter().position(|&byte| byte == b'>');
    let data = end.and_then(|end| {
        let underscore = after[end..].iter().position(|&byte| byte == b'_')?;
        Some((&after[end + underscore + 1..], after[..end].windows(6).any(|word| word == b"base64")))
    });
    data.ok_or_else(|| Fault::at_byte(start, "the appended data do not begin with an underscore"))
}

impl<'a> XmlReader<'a, '_> {
    /// Returns the line of a byte; not used often.
    #[cold]
    fn line_of(&self, at: usize) -> Place {
        Place::Line(1 + self.bytes[..at].iter().filter(|&&byte| byte == b'\n').count() as u64)
    }

    fn fault(&self, at: usize, reason: impl Into<String>) -> Fault {
        Fault::Malformed(self.line_of(at), reason.into())
    }

    /// Reads all elements.
    fn elements(&mut self) -> Result<(), Fault> {
        let mut xml = Reader::from_reader(self.bytes);
        let mut open: Vec<String> = Vec::new();
        loop {
            let at = xml.buffer_position() as usize;
            let event = xml.read_event();
            match event {
                Err(error) => {
                    let at = xml.error_position() as usize;
                    return Err(
                        self.fault(at.min(self.bytes.len()), format!("the XML is malformed: {error}"))
                    );
                }
                Ok(Event::Start(start)) => {
                    let end = xml.buffer_position() as usize;
                    self.start(&start, at, end, &open)?;
                    open.push(local_name(&start));
                }
                Ok(Event::Empty(start)) => {
                    let end = self.bytes.len();
                    self.start(&start, at, end, &open)?;
                    if start.name().as_ref() == b"Piece" {
                        self.finish_piece(at)?;
                    }
                }
                Ok(Event::End(_)) => {
                    if open.pop().as_deref() == Some("Piece") {
                        self.finish_piece(at)?;
                    }
                }
                Ok(Event::Eof) => break,
                Ok(_) => {}
            }
        }
        let is_complete = open.is_empty() || (self.appended.is_some() && open == ["VTKFile"]);
        if self.piece_count == 0 || !is_complete {
            return Err(self.fault(self.bytes.len(), "the file ends before the last piece does"));
        }
        Ok(())
    }

    /// Reads the start of an element, and for arrays the values. The tag is at the bytes `at..end`.
    fn start(&mut self, start: &BytesStart<'_>, at: usize, end: usize, open: &[String]) -> Result<(), Fault> {
        let attribute = |name: &str| attribute(start, name);
        match start.name().as_ref() {
            b"VTKFile" => self.storage = self.storage_of(start, at)?,
            b"Piece" => {
                let count =
                    |name: &str| attribute(name).and_then(|text| text.trim().parse().ok()).unwrap_or(0);
                self.piece = PieceArrays { point_count: count("NumberOfPoints"), ..PieceArrays::default() };
            }
            b"PointData" => {
                self.piece.roles = ["Normals", "TCoords"].map(|name| attribute(name).unwrap_or_default());
            }
            b"DataArray" | b"Array" => {
                let section = open.last().map_or("", String::as_str).to_owned();
                self.array(start, at, end, &section)?;
            }
            _ => {}
        }
        Ok(())
    }

    fn storage_of(&self, start: &BytesStart<'_>, at: usize) -> Result<Storage, Fault> {
        let compression = match attribute(start, "compressor").as_deref() {
            None | Some("") => None,
            Some("vtkZLibDataCompressor") => Some(BlockCompression::Zlib),
            Some("vtkLZ4DataCompressor") => Some(BlockCompression::Lz4),
            Some(other) => {
                let what = format!("the compression {}", shortened(other));
                return Err(Fault::Unsupported(self.line_of(at), what));
            }
        };
        Ok(Storage {
            is_big_endian: attribute(start, "byte_order").as_deref() == Some("BigEndian"),
            has_long_headers: attribute(start, "header_type").as_deref() == Some("UInt64"),
            compression,
        })
    }

    fn array(&mut self, start: &BytesStart<'_>, at: usize, end: usize, section: &str) -> Result<(), Fault> {
        let name = attribute(start, "Name").unwrap_or_default();
        let type_name = attribute(start, "type").unwrap_or_default();
        let is_cells = section == "Cells" || POLY_LISTS.iter().any(|(list, _)| *list == section);
        if !is_cells && !matches!(section, "Points" | "PointData" | "CellData") {
            let reason = format!("data `{}` of the whole file are left out", shortened(&name));
            self.warnings.push(self.line_of(at), reason);
            return Ok(());
        }
        let Some(scalar) = VtkScalar::from_xml(&type_name) else {
            if is_cells || section == "Points" {
                return Err(
                    self.fault(at, format!("expected numbers, found the type {}", shortened(&type_name)))
                );
            }
            let reason =
                format!("data `{}` are not numbers ({}); left out", shortened(&name), shortened(&type_name));
            self.warnings.push(self.line_of(at), reason);
            return Ok(());
        };
        let values = self.values(start, scalar, end);
        let values =
            values.map_err(|reason| self.fault(at, format!("array `{}`: {reason}", shortened(&name))))?;
        let component_count =
            attribute(start, "NumberOfComponents").and_then(|text| text.trim().parse().ok()).unwrap_or(1);
        let piece = &mut self.piece;
        match section {
            "Points" => piece.points = Some((values, at)),
            "PointData" | "CellData" => {
                let role = role_of(&name, component_count, &values, &piece.roles);
                let array = Array { name, role, component_count, values };
                piece.data[usize::from(section == "CellData")].push(array);
            }
            _ => {
                piece.lists.push((section.to_owned(), name, values.integers(), at));
            }
        }
        Ok(())
    }

    /// Reads the values of an array whose tag ends at byte `end`.
    fn values(&self, start: &BytesStart<'_>, scalar: VtkScalar, end: usize) -> Result<Values, String> {
        let text = || {
            let text = &self.bytes[end..];
            &text[..text.iter().position(|&byte| byte == b'<').unwrap_or(text.len())]
        };
        let bytes = match attribute(start, "format").as_deref() {
            None | Some("ascii") => {
                let words = &mut text().split(u8::is_ascii_whitespace).filter(|word| !word.is_empty());
                return Values::from_words(scalar, || words.next());
            }
            Some("binary") if text().trim_ascii().is_empty() => {
                return Ok(Values::from_bytes(scalar, &[], false));
            }
            Some("binary") => self.storage.read(VtkBytes::base64(text()))?,
            Some("appended") => {
                let (appended, is_base64) = self.appended.ok_or("there are no appended data")?;
                let offset = attribute(start, "offset").and_then(|text| text.trim().parse().ok());
                let offset: usize = offset.ok_or("expected an offset in the appended data")?;
                let bytes = appended.get(offset..);
                let bytes = bytes.ok_or_else(|| format!("the offset {offset} lies outside the file"))?;
                self.storage.read(if is_base64 { VtkBytes::base64(bytes) } else { VtkBytes::Raw(bytes) })?
            }
            Some(other) => return Err(format!("unknown format {}", shortened(other))),
        };
        if bytes.len() % scalar.bytes() != 0 {
            return Err(format!("{} bytes are not values of {} bytes each", bytes.len(), scalar.bytes()));
        }
        Ok(Values::from_bytes(scalar, &bytes, self.storage.is_big_endian))
    }

    /// Adds the arrays of a piece to the grid.
    fn finish_piece(&mut self, at: usize) -> Result<(), Fault> {
        let piece = std::mem::take(&mut self.piece);
        let first_point = self.grid.point_count();
        let found = piece.points.as_ref().map_or(0, |(points, _)| points.len() / 3);
        if found != piece.point_count {
            let reason = format!("`Points` has {found} points instead of {}", piece.point_count);
            return Err(self.fault(at, reason));
        }
        if let Some((points, place)) = piece.points {
            let pushed = self.grid.push_points(points);
            pushed.map_err(|reason| self.fault(place, reason))?;
        }
        let points = first_point..first_point.saturating_add(piece.point_count);
        let list = |section: &str, name: &str| {
            piece
                .lists
                .iter()
                .find(|(of, known, ..)| of == section && known == name)
                .map(|(_, _, v, place)| (v.as_slice(), *place))
        };
        let kinds = list("Cells", "types").map_or(&[][..], |(kinds, _)| kinds);
        let kind_of = |cell: usize| kinds.get(cell).map(|&kind| u8::try_from(kind).unwrap_or(u8::MAX));
        let poly_lists = POLY_LISTS.iter().map(|&(section, kind)| (section, Some(kind)));
        for (section, kind) in poly_lists.chain([("Cells", None)]) {
            let Some((ends, place)) = list(section, "offsets") else { continue };
            let connectivity = list(section, "connectivity").map_or(&[][..], |(list, _)| list);
            let kind_of = |cell: usize| kind.or_else(|| kind_of(cell));
            let pushed = self.grid.cells.push_list(kind_of, connectivity, ends, points.clone());
            pushed.map_err(|reason| self.fault(place, format!("`{section}`: {reason}")))?;
        }
        self.grid.push_data(piece.data, self.piece_count == 0, self.warnings);
        self.piece_count += 1;
        Ok(())
    }
}

/// Returns the meaning of an array of the points, by the attributes of `PointData` or by its name.
fn role_of(name: &str, component_count: usize, values: &Values, roles: &[String; 2]) -> Role {
    let is_float = matches!(values, Values::F32(_) | Values::F64(_));
    let is = |role: &String, usual: &[&str]| role == name || (role.is_empty() && usual.contains(&name));
    if is_float && component_count == 3 && is(&roles[0], &["Normals", "normals"]) {
        Role::Normals
    } else if is_float
        && component_count == 2
        && is(&roles[1], &["TCoords", "TextureCoordinates", "Texture Coordinates"])
    {
        Role::TexCoords
    } else {
        Role::Other
    }
}

fn local_name(start: &BytesStart<'_>) -> String {
    String::from_utf8_lossy(start.name().as_ref()).into_owned()
}

/// Returns the value of an attribute.
fn attribute(start: &BytesStart<'_>, name: &str) -> Option<String> {
    let found = start.try_get_attribute(name).ok()??;
    Some(found.normalized_value(XmlVersion::Implicit1_0).ok()?.into_owned())
}

/// Shortens a text for a message.
fn shortened(text: &str) -> String {
    text.chars().filter(|c| !c.is_control()).take(60).collect()
}
