//! Legacy files: keywords as text, values as text or as big-endian bytes.

use super::array::{Array, Role, Values, VtkScalar};
use super::cells::{LINES, POINTS, POLYGON, STRIP};
use super::grid::VtkGrid;
use crate::error::{Fault, Place};
use crate::foreign::EXTRACT_SURFACE;
use crate::report::Warnings;
use crate::text::{Cursor, quoted};

/// First bytes of a legacy file.
pub(super) const MAGIC: &[u8] = b"# vtk DataFile Version";

/// Reader of a file, keyword by keyword.
struct LegacyReader<'a, 'w> {
    cursor: Cursor<'a>,
    is_binary: bool,
    /// Whether cells are listed as offsets and connectivity, since version 5.
    has_offsets: bool,
    grid: VtkGrid,
    /// Cells of an unstructured grid, until their types are known.
    untyped: Option<CellList>,
    /// Cells of poly data, by type, since their order in the file is free.
    poly_cells: [Option<CellList>; 4],
    section: LegacySection,
    warnings: &'w mut Warnings,
}

/// Cells of one list.
struct CellList {
    connectivity: Vec<i64>,
    /// One past the last entry of each cell.
    ends: Vec<i64>,
    place: Place,
}

/// Part of the file that the arrays that follow belong to.
#[derive(Clone, Copy, PartialEq, Eq)]
enum LegacySection {
    File,
    Points(usize),
    Cells(usize),
}

/// Types of the cells of poly data in the order of their data.
const POLY_KINDS: [u8; 4] = [POINTS, LINES, POLYGON, STRIP];

/// Reads the points, cells and data of a file.
pub(super) fn read(bytes: &[u8], warnings: &mut Warnings) -> Result<VtkGrid, Fault> {
    let mut cursor = Cursor::new(bytes);
    let version = cursor.rest_of_line();
    let Some(version) = version.strip_prefix(MAGIC) else {
        return Err(cursor.fault("expected `# vtk DataFile Version`"));
    };
    let version = String::from_utf8_lossy(version);
    let has_offsets = version.trim().parse::<f32>().is_ok_and(|version| version >= 5.0);
    cursor.next_line();
    // The title.
    cursor.next_line();
    cursor.skip_lines(None);
    let encoding = cursor.word();
    let is_binary = match encoding.to_ascii_uppercase().as_slice() {
        b"ASCII" => false,
        b"BINARY" => true,
        _ => return Err(cursor.fault(format!("expected ASCII or BINARY, found {}", quoted(encoding)))),
    };
    let mut reader = LegacyReader {
        cursor,
        is_binary,
        has_offsets,
        grid: VtkGrid::default(),
        untyped: None,
        poly_cells: Default::default(),
        section: LegacySection::File,
        warnings,
    };
    let mut has_data_set = false;
    loop {
        reader.cursor.skip_lines(None);
        if reader.cursor.at_end() {
            break;
        }
        let keyword = reader.cursor.word().to_ascii_uppercase();
        has_data_set |= keyword == b"DATASET";
        reader.statement(&keyword)?;
    }
    if !has_data_set {
        return Err(reader.fault("the file ends before `DATASET`"));
    }
    reader.finish()
}

/// The name of an array, and what it is used for.
struct ArrayUse {
    /// Name in the file.
    pub name: String,
    /// Its use.
    pub role: Role,
}

impl<'a> LegacyReader<'a, '_> {
    /// Creates a fault at the current place.
    #[cold]
    fn fault(&self, reason: impl Into<String>) -> Fault {
        if self.is_binary { Fault::at_byte(self.cursor.offset(), reason) } else { self.cursor.fault(reason) }
    }

    fn place(&self) -> Place {
        if self.is_binary {
            Place::Byte(self.cursor.offset() as u64)
        } else {
            Place::Line(self.cursor.line())
        }
    }

    /// Reads what follows a keyword.
    fn statement(&mut self, keyword: &[u8]) -> Result<(), Fault> {
        match keyword {
            b"DATASET" => self.data_set(),
            b"POINTS" => self.points(),
            b"VERTICES" => self.poly_list(0),
            b"LINES" => self.poly_list(1),
            b"POLYGONS" => self.poly_list(2),
            b"TRIANGLE_STRIPS" => self.poly_list(3),
            b"CELLS" => {
                self.untyped = Some(self.cell_list()?);
                Ok(())
            }
            b"CELL_TYPES" => self.cell_types(),
            b"POINT_DATA" => {
                self.section = LegacySection::Points(self.count("points")?);
                Ok(())
            }
            b"CELL_DATA" => {
                self.section = LegacySection::Cells(self.count("cells")?);
                Ok(())
            }
            b"SCALARS" => self.scalars(),
            b"COLOR_SCALARS" => self.color_scalars(),
            b"LOOKUP_TABLE" => self.lookup_table(),
            b"NORMALS" => self.attribute(Role::Normals, Some(3)),
            b"VECTORS" => self.attribute(Role::Other, Some(3)),
            b"TENSORS" => self.attribute(Role::Other, Some(9)),
            b"TENSORS6" => self.attribute(Role::Other, Some(6)),
            b"GLOBAL_IDS" | b"PEDIGREE_IDS" | b"EDGE_FLAGS" => self.attribute(Role::Other, Some(1)),
            b"TEXTURE_COORDINATES" => self.attribute(Role::TexCoords, None),
            b"FIELD" => self.field(),
            b"METADATA" => {
                self.skip_metadata();
                Ok(())
            }
            other => {
                let other = quoted(other);
                Err(self.fault(format!(
                    "unknown keyword {other}, or the list before it has more values than it should"
                )))
            }
        }
    }

    fn data_set(&mut self) -> Result<(), Fault> {
        let kind = self.cursor.word().to_ascii_uppercase();
        let what = match kind.as_slice() {
            b"POLYDATA" | b"UNSTRUCTURED_GRID" => return Ok(()),
            b"STRUCTURED_POINTS" => "an image (STRUCTURED_POINTS)",
            b"STRUCTURED_GRID" => "a structured grid",
            b"RECTILINEAR_GRID" => "a rectilinear grid",
            _ => return Err(self.fault(format!("unknown data set {}", quoted(&kind)))),
        };
        Err(Fault::NeedsConversion {
            found: format!("this VTK file contains {what}, not triangles"),
            hint: EXTRACT_SURFACE,
        })
    }

    fn points(&mut self) -> Result<(), Fault> {
        let count = self.count("points")?;
        let scalar = self.scalar()?;
        let place = self.place();
        let values = self.values(scalar, count, 3)?;
        if self.grid.point_count() > 0 {
            return Err(self.fault("`POINTS` occurs twice"));
        }
        self.grid.push_points(values).map_err(|reason| Fault::Malformed(place, reason))
    }

    fn poly_list(&mut self, kind: usize) -> Result<(), Fault> {
        let cells = self.cell_list()?;
        if self.poly_cells[kind].replace(cells).is_some() {
            return Err(self.fault("this list of cells occurs twice"));
        }
        Ok(())
    }

    /// Reads a list of cells in either form.
    fn cell_list(&mut self) -> Result<CellList, Fault> {
        let count = self.count("cells")?;
        let size = self.count("entries")?;
        self.cursor.next_line();
        let place = self.place();
        let mut ahead = self.cursor.clone();
        ahead.skip_lines(None);
        if self.has_offsets && ahead.word().eq_ignore_ascii_case(b"OFFSETS") {
            let mut ends = self.named_integers("OFFSETS", count)?;
            let connectivity = self.named_integers("CONNECTIVITY", size)?;
            if ends.first().is_some_and(|&start| start != 0) {
                return Err(Fault::Malformed(place, format!("the first offset is {}, not 0", ends[0])));
            }
            ends.drain(..ends.len().min(1));
            return Ok(CellList { connectivity, ends, place });
        }
        let entries = self.raw_values(VtkScalar::I32, size)?.integers();
        let mut rest = entries.as_slice();
        let mut list = CellList { connectivity: Vec::with_capacity(entries.len()), ends: Vec::new(), place };
        for number in 0..count {
            let cell = rest
                .split_first()
                .and_then(|(&length, after)| after.split_at_checked(usize::try_from(length).ok()?));
            let Some((corners, after)) = cell else {
                let reason =
                    format!("cell {number} of {count} does not end within the {size} entries of the list");
                return Err(Fault::Malformed(list.place, reason));
            };
            list.connectivity.extend_from_slice(corners);
            list.ends.push(list.connectivity.len() as i64);
            rest = after;
        }
        Ok(list)
    }

    /// Reads `OFFSETS type` or `CONNECTIVITY type` and the numbers.
    fn named_integers(&mut self, name: &str, count: usize) -> Result<Vec<i64>, Fault> {
        self.cursor.skip_lines(None);
        let word = self.cursor.word();
        if !word.eq_ignore_ascii_case(name.as_bytes()) {
            return Err(self.fault(format!("expected `{name}`, found {}", quoted(word))));
        }
        let scalar = self.scalar()?;
        Ok(self.values(scalar, count, 1)?.integers())
    }

    fn cell_types(&mut self) -> Result<(), Fault> {
        let count = self.count("cells")?;
        let place = self.place();
        let kinds = self.values(VtkScalar::I32, count, 1)?.integers();
        let cell_count = self.untyped.as_ref().map_or(0, |cells| cells.ends.len());
        if cell_count != kinds.len() {
            let reason = format!("{} types for {cell_count} cells", kinds.len());
            return Err(Fault::Malformed(place, reason));
        }
        let kind = |cell: usize| Some(u8::try_from(*kinds.get(cell)?).unwrap_or(u8::MAX));
        let cells = self.untyped.take();
        cells.map_or(Ok(()), |cells| self.push_cells(kind, &cells))
    }

    fn push_cells(&mut self, kind: impl Fn(usize) -> Option<u8>, cells: &CellList) -> Result<(), Fault> {
        let points = 0..self.grid.point_count();
        let pushed = self.grid.cells.push_list(kind, &cells.connectivity, &cells.ends, points);
        pushed.map_err(|reason| Fault::Malformed(cells.place.clone(), reason))
    }

    fn scalars(&mut self) -> Result<(), Fault> {
        let name = self.name();
        let scalar = self.scalar_or_other()?;
        let component_count = if self.cursor.at_line_end() { 1 } else { self.count("components")? };
        self.cursor.next_line();
        let mut ahead = self.cursor.clone();
        ahead.skip_lines(None);
        if ahead.word().eq_ignore_ascii_case(b"LOOKUP_TABLE") {
            ahead.next_line();
            self.cursor = ahead;
        }
        self.array(ArrayUse { name, role: Role::Other }, scalar, component_count, None)
    }

    fn color_scalars(&mut self) -> Result<(), Fault> {
        let name = self.name();
        let component_count = self.count("components")?;
        let count = self.tuple_count(None);
        if self.is_binary {
            self.cursor.next_line();
            return self.array(
                ArrayUse { name, role: Role::Other },
                Ok(VtkScalar::U8),
                component_count,
                None,
            );
        }
        let fractions = self.values(VtkScalar::F32, count, component_count)?.floats();
        let values = Values::U8(fractions.into_iter().map(|x| (x * 255.0).round() as u8).collect());
        self.keep(Array { name, role: Role::Other, component_count, values });
        Ok(())
    }

    /// Skips a table of colors, which scalars refer to.
    fn lookup_table(&mut self) -> Result<(), Fault> {
        let name = self.name();
        let count = self.count("colors")?;
        let scalar = if self.is_binary { VtkScalar::U8 } else { VtkScalar::F32 };
        self.values(scalar, count, 4)?;
        self.warnings.push(self.place(), format!("the color table `{name}` is left out"));
        Ok(())
    }

    /// Reads `NAME type` and the values of an attribute; the number of components is written if it is [`None`].
    fn attribute(&mut self, role: Role, component_count: Option<usize>) -> Result<(), Fault> {
        let name = self.name();
        let component_count = match component_count {
            Some(count) => count,
            None => self.count("components")?,
        };
        let scalar = self.scalar_or_other()?;
        self.cursor.next_line();
        self.array(ArrayUse { name, role }, scalar, component_count, None)
    }

    fn field(&mut self) -> Result<(), Fault> {
        self.name();
        let array_count = self.count("arrays")?;
        for _ in 0..array_count {
            self.cursor.skip_lines(None);
            while self.cursor.clone().word().eq_ignore_ascii_case(b"METADATA") {
                self.skip_metadata();
                self.cursor.skip_lines(None);
            }
            if self.cursor.at_end() {
                return Err(self.fault(format!("the file ends before the last of {array_count} arrays")));
            }
            let name = self.name();
            let component_count = self.count("components")?;
            let tuple_count = self.count("tuples")?;
            let scalar = self.scalar_or_other()?;
            self.cursor.next_line();
            self.array(ArrayUse { name, role: Role::Other }, scalar, component_count, Some(tuple_count))?;
        }
        Ok(())
    }

    /// Skips lines up to an empty one.
    fn skip_metadata(&mut self) {
        self.cursor.next_line();
        while !self.cursor.at_end() && !self.cursor.at_line_end() {
            self.cursor.next_line();
        }
    }

    /// Reads the values of an array, and keeps them if they belong to points or cells.
    fn array(
        &mut self,
        ArrayUse { name, role }: ArrayUse,
        scalar: Result<VtkScalar, Other>,
        component_count: usize,
        tuple_count: Option<usize>,
    ) -> Result<(), Fault> {
        let count = self.tuple_count(tuple_count);
        match scalar {
            Ok(scalar) => {
                let Some(value_count) = count.checked_mul(component_count) else {
                    return Err(self.fault("too many values"));
                };
                let values = self.raw_values(scalar, value_count)?;
                self.keep(Array { name, role, component_count, values });
            }
            Err(other) => {
                self.skip_other(other, count.saturating_mul(component_count))?;
                let reason = format!("data `{name}` are {}, not numbers; left out", other.name());
                self.warnings.push(self.place(), reason);
            }
        }
        Ok(())
    }

    fn keep(&mut self, array: Array) {
        match self.section {
            LegacySection::Points(_) => self.grid.point_data.push(array),
            LegacySection::Cells(_) => self.grid.cell_data.push(array),
            LegacySection::File => {
                let reason = format!("data `{}` of the whole file are left out", array.name);
                self.warnings.push(self.place(), reason);
            }
        }
    }

    fn tuple_count(&self, written: Option<usize>) -> usize {
        let (LegacySection::Points(count) | LegacySection::Cells(count)) = self.section else {
            return written.unwrap_or(0);
        };
        written.unwrap_or(count)
    }

    /// Reads the next word as a name, with `%20` for a blank.
    fn name(&mut self) -> String {
        decoded_name(self.cursor.word())
    }

    /// Reads a count.
    fn count(&mut self, what: &str) -> Result<usize, Fault> {
        let word = self.cursor.word();
        let count = std::str::from_utf8(word).ok().and_then(|text| text.parse().ok());
        count.ok_or_else(|| self.fault(format!("expected the number of {what}, found {}", quoted(word))))
    }

    fn scalar(&mut self) -> Result<VtkScalar, Fault> {
        let scalar = self.scalar_or_other()?;
        scalar.map_err(|other| {
            self.fault(format!("expected the name of a type of numbers, found {}", other.name()))
        })
    }

    /// Reads the name of a type, which may be one whose values are not kept.
    fn scalar_or_other(&mut self) -> Result<Result<VtkScalar, Other>, Fault> {
        let word = self.cursor.word();
        let name = String::from_utf8_lossy(word).to_ascii_lowercase();
        match (VtkScalar::from_legacy(&name), name.as_str()) {
            (Some(scalar), _) => Ok(Ok(scalar)),
            (None, "bit") => Ok(Err(Other::Bits)),
            (None, "string" | "utf8_string") => Ok(Err(Other::Strings)),
            _ => {
                Err(self.fault(format!("expected the name of a type, such as float, found {}", quoted(word))))
            }
        }
    }

    /// Reads the values after the line with their type.
    fn values(&mut self, scalar: VtkScalar, count: usize, component_count: usize) -> Result<Values, Fault> {
        self.cursor.next_line();
        match count.checked_mul(component_count) {
            Some(count) => self.raw_values(scalar, count),
            None => Err(self.fault("too many values")),
        }
    }

    /// Reads values that begin here.
    fn raw_values(&mut self, scalar: VtkScalar, count: usize) -> Result<Values, Fault> {
        let bytes_left = self.cursor.bytes_left();
        // Each value of a text takes a digit and a blank, except for the last.
        let least_bytes =
            if self.is_binary { count.saturating_mul(scalar.bytes()) } else { count.saturating_mul(2) };
        if least_bytes > bytes_left + usize::from(!self.is_binary) {
            let reason = format!("{count} values are declared, but only {bytes_left} bytes remain");
            return Err(self.fault(reason));
        }
        if self.is_binary {
            let bytes = self.cursor.take_bytes(least_bytes);
            return Ok(Values::from_bytes(scalar, bytes, true));
        }
        let (mut left, cursor) = (count, &mut self.cursor);
        let words = || {
            left = left.checked_sub(1)?;
            cursor.skip_lines(None);
            Some(cursor.word())
        };
        let read = Values::from_words(scalar, words);
        read.map_err(|reason| self.cursor.fault(reason))
    }

    /// Skips values that are not numbers.
    fn skip_other(&mut self, other: Other, count: usize) -> Result<(), Fault> {
        match (other, self.is_binary) {
            (Other::Bits, true) => {
                let bytes = count.div_ceil(8);
                if bytes > self.cursor.bytes_left() {
                    return Err(self.fault(format!("{count} bits are declared, but the file ends before")));
                }
                self.cursor.take_bytes(bytes);
            }
            (Other::Bits, false) => {
                self.raw_values(VtkScalar::U8, count)?;
            }
            (Other::Strings, false) => {
                for _ in 0..count.min(self.cursor.bytes_left()) {
                    self.cursor.next_line();
                }
            }
            (Other::Strings, true) => {
                for _ in 0..count {
                    self.skip_string()?;
                }
            }
        }
        Ok(())
    }

    /// Skips a string of a binary file: the two highest bits of its first byte say how long its length is.
    fn skip_string(&mut self) -> Result<(), Fault> {
        let too_short = |reader: &Self| reader.fault("the file ends within a string");
        let Some(first) = self.cursor.peek() else { return Err(too_short(self)) };
        let length_bytes = [8, 4, 2, 1][usize::from(first >> 6)];
        if length_bytes > self.cursor.bytes_left() {
            return Err(too_short(self));
        }
        let head = self.cursor.take_bytes(length_bytes);
        let length = head.iter().enumerate().fold(0u64, |length, (index, &byte)| {
            length << 8 | u64::from(if index == 0 { byte & 0x3f } else { byte })
        });
        match usize::try_from(length).ok().filter(|&length| length <= self.cursor.bytes_left()) {
            Some(length) => {
                self.cursor.take_bytes(length);
                Ok(())
            }
            None => Err(too_short(self)),
        }
    }

    /// Returns the grid with the cells of all lists.
    fn finish(mut self) -> Result<VtkGrid, Fault> {
        if self.untyped.take().is_some_and(|cells| !cells.ends.is_empty()) {
            return Err(Fault::Malformed(Place::File, "`CELL_TYPES` is missing".to_owned()));
        }
        for (kind, cells) in POLY_KINDS.into_iter().zip(std::mem::take(&mut self.poly_cells)) {
            if let Some(cells) = cells {
                self.push_cells(|_| Some(kind), &cells)?;
            }
        }
        Ok(self.grid)
    }
}

/// Type of values that are not kept.
#[derive(Clone, Copy)]
enum Other {
    Bits,
    Strings,
}

impl Other {
    fn name(self) -> &'static str {
        match self {
            Self::Bits => "bits",
            Self::Strings => "strings",
        }
    }
}

/// Replaces `%20` and the like by the bytes that they stand for.
fn decoded_name(word: &[u8]) -> String {
    let mut bytes = Vec::with_capacity(word.len());
    let mut rest = word;
    while let Some((&byte, after)) = rest.split_first() {
        let hex = after.get(..2).filter(|_| byte == b'%').and_then(|hex| std::str::from_utf8(hex).ok());
        match hex.and_then(|hex| u8::from_str_radix(hex, 16).ok()) {
            Some(decoded) => {
                bytes.push(decoded);
                rest = &after[2..];
            }
            None => {
                bytes.push(byte);
                rest = after;
            }
        }
    }
    String::from_utf8_lossy(&bytes).into_owned()
}
