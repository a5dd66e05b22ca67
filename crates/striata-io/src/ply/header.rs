//! Header of a PLY file: elements, their properties, and the start of the body.

use crate::error::{Fault, Place};
use crate::text::{Cursor, quoted, with_line_feeds};

/// Bytes by which some editors mark UTF-8.
const BYTE_ORDER_MARK: &[u8] = b"\xef\xbb\xbf";

/// Number of bytes in which the first line ends.
const LONGEST_FIRST_LINE: usize = 16;

/// Names of the elements that are read.
const ELEMENTS: [&str; 3] = ["vertex", "face", "tristrips"];

/// Encoding of the body.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Encoding {
    Ascii,
    LittleEndian,
    BigEndian,
}

/// Type of a number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Scalar {
    I8,
    U8,
    I16,
    U16,
    I32,
    U32,
    F32,
    F64,
}

impl Scalar {
    fn from_name(name: &[u8]) -> Option<Self> {
        Some(match name.to_ascii_lowercase().as_slice() {
            b"char" | b"int8" => Self::I8,
            b"uchar" | b"uint8" => Self::U8,
            b"short" | b"int16" => Self::I16,
            b"ushort" | b"uint16" => Self::U16,
            b"int" | b"int32" => Self::I32,
            b"uint" | b"uint32" => Self::U32,
            b"float" | b"float32" => Self::F32,
            b"double" | b"float64" => Self::F64,
            _ => return None,
        })
    }

    /// Returns the type's name in a PLY header.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::I8 => "char",
            Self::U8 => "uchar",
            Self::I16 => "short",
            Self::U16 => "ushort",
            Self::I32 => "int",
            Self::U32 => "uint",
            Self::F32 => "float",
            Self::F64 => "double",
        }
    }

    /// Returns the size of a number in bytes.
    pub(crate) fn bytes(self) -> usize {
        match self {
            Self::I8 | Self::U8 => 1,
            Self::I16 | Self::U16 => 2,
            Self::I32 | Self::U32 | Self::F32 => 4,
            Self::F64 => 8,
        }
    }

    fn is_integer(self) -> bool {
        !matches!(self, Self::F32 | Self::F64)
    }
}

/// Property of an element: a number or a list of numbers.
#[derive(Clone, Debug)]
pub(crate) struct PlyProperty {
    pub name: String,
    pub scalar: Scalar,
    /// Type of the list's length, if the property is a list.
    pub list: Option<Scalar>,
}

/// Element of the file: rows with the same properties.
#[derive(Clone, Debug)]
pub(crate) struct Element {
    pub name: String,
    pub count: usize,
    pub properties: Vec<PlyProperty>,
}

impl PlyProperty {
    /// Whether the property is a coordinate of a vertex.
    pub(crate) fn is_coordinate(&self) -> bool {
        self.list.is_none() && matches!(self.name.as_str(), "x" | "y" | "z")
    }
}

impl Element {
    /// Returns the smallest number of bytes that a row takes in binary.
    pub(crate) fn least_row_bytes(&self) -> usize {
        self.properties.iter().map(|p| p.list.unwrap_or(p.scalar).bytes()).sum()
    }
}

/// Image that a comment names.
#[derive(Clone, Debug)]
pub(crate) struct TextureComment {
    pub name: String,
    pub line: u64,
}

/// Parsed header.
#[derive(Clone, Debug)]
pub(crate) struct Header {
    pub encoding: Encoding,
    pub elements: Vec<Element>,
    /// Layers marked by `comment normalized NAME`, a note of our own writer.
    pub normalized: Vec<String>,
    /// Layers of triangles marked by `comment normalized_face NAME`.
    pub normalized_faces: Vec<String>,
    /// Images named by `comment TextureFile NAME`.
    pub texture_files: Vec<TextureComment>,
    /// JSON object of `comment georeference JSON`, a note of our own writer; may be empty.
    pub georeference: String,
    /// Whether texture coordinates count from the top of the image, as in temporary files of our own; set by
    /// those who know.
    #[cfg_attr(
        not(all(feature = "pieces", not(target_family = "wasm"))),
        allow(dead_code, reason = "only these have temporary files")
    )]
    pub has_top_origin: bool,
    pub body_at: usize,
    pub body_line: u64,
}

impl Header {
    /// Declares coordinates as doubles: texts may have more digits than the type that their header declares.
    pub(crate) fn widen_coordinates(&mut self) {
        let vertex = self.elements.iter_mut().find(|element| element.name == "vertex");
        let properties = vertex.into_iter().flat_map(|vertex| &mut vertex.properties);
        properties.filter(|p| p.is_coordinate()).for_each(|property| property.scalar = Scalar::F64);
    }

    /// Parses the header at the start of a file. Keywords may have any case, and lines may end in carriage returns.
    pub(crate) fn read(bytes: &[u8]) -> Result<Self, Fault> {
        match with_returns(bytes) {
            None => Self::of_lines(bytes),
            Some(mut header) => {
                with_line_feeds(&mut header, false);
                Self::of_lines(&header)
            }
        }
    }

    fn of_lines(bytes: &[u8]) -> Result<Self, Fault> {
        let start = if bytes.starts_with(BYTE_ORDER_MARK) { BYTE_ORDER_MARK.len() } else { 0 };
        let mut cursor = Cursor::starting_at(bytes, start, 1);
        if !cursor.rest_of_line().eq_ignore_ascii_case(b"ply") {
            return Err(cursor.fault("a PLY file begins with the line `ply`"));
        }
        let mut encoding = None;
        let mut elements: Vec<Element> = Vec::new();
        let (mut normalized, mut normalized_faces, mut texture_files) = (Vec::new(), Vec::new(), Vec::new());
        let mut georeference = String::new();
        loop {
            cursor.next_line();
            let word = cursor.word();
            match word.to_ascii_lowercase().as_slice() {
                b"format" => encoding = Some(read_format(&mut cursor)?),
                b"comment" => match cursor.word() {
                    b"normalized" => normalized.push(text(cursor.word())),
                    b"georeference" => georeference = text(cursor.rest_of_line()),
                    b"normalized_face" => normalized_faces.push(text(cursor.word())),
                    word if word.eq_ignore_ascii_case(b"texturefile") => {
                        let (name, line) = (text(cursor.rest_of_line()), cursor.line());
                        texture_files.push(TextureComment { name, line });
                    }
                    _ => {}
                },
                b"element" => elements.push(read_element(&mut cursor)?),
                b"property" => {
                    let property = read_property(&mut cursor)?;
                    match elements.last_mut() {
                        Some(element) => element.properties.push(property),
                        None => return Err(cursor.fault("a property precedes the first element")),
                    }
                }
                b"end_header" => break,
                b"obj_info" => {}
                // A blank line is harmless, the end of the file is not.
                b"" if cursor.bytes_left() > 0 => {}
                b"" => return Err(cursor.fault("the file ends before `end_header`")),
                _ => return Err(cursor.fault(format!("no PLY header line begins with {}", quoted(word)))),
            }
        }
        cursor.next_line();
        let encoding = encoding.ok_or_else(|| cursor.fault("the header has no `format` line"))?;
        let (body_at, body_line) = (bytes.len() - cursor.bytes_left(), cursor.line());
        Ok(Self {
            encoding,
            elements,
            normalized,
            normalized_faces,
            texture_files,
            georeference,
            has_top_origin: false,
            body_at,
            body_line,
        })
    }

    /// Returns the element `vertex`.
    pub(crate) fn vertex(&self) -> Result<&Element, Fault> {
        self.elements
            .iter()
            .find(|e| e.name == "vertex")
            .ok_or_else(|| Fault::Malformed(Place::File, "the header names no element `vertex`".to_owned()))
    }
}

/// Returns the header of a file whose lines end in carriage returns alone.
fn with_returns(bytes: &[u8]) -> Option<Vec<u8>> {
    const END: &[u8] = b"end_header\r";
    let first_end = bytes.iter().take(LONGEST_FIRST_LINE).position(|&b| b == b'\r')?;
    if bytes.get(first_end + 1) == Some(&b'\n') {
        return None;
    }
    let end = bytes.windows(END.len()).position(|window| window.eq_ignore_ascii_case(END))?;
    Some(bytes[..end + END.len()].to_vec())
}

fn read_format(cursor: &mut Cursor<'_>) -> Result<Encoding, Fault> {
    let word = cursor.word();
    let encoding = match word.to_ascii_lowercase().as_slice() {
        b"ascii" => Encoding::Ascii,
        b"binary_little_endian" => Encoding::LittleEndian,
        b"binary_big_endian" => Encoding::BigEndian,
        _ => {
            let what = format!("the PLY encoding {}", quoted(word));
            return Err(Fault::Unsupported(Place::Line(cursor.line()), what));
        }
    };
    match cursor.word() {
        b"1.0" => Ok(encoding),
        word => {
            let what = format!("PLY version {}", quoted(word));
            Err(Fault::Unsupported(Place::Line(cursor.line()), what))
        }
    }
}

fn read_element(cursor: &mut Cursor<'_>) -> Result<Element, Fault> {
    let mut name = text(cursor.word());
    if let Some(known) = ELEMENTS.iter().find(|known| known.eq_ignore_ascii_case(&name)) {
        name = (*known).to_owned();
    }
    let count = cursor.integer()?;
    let count = usize::try_from(count)
        .ok()
        .filter(|&n| n <= u32::MAX as usize)
        .ok_or_else(|| cursor.fault(format!("{count} is not a supported number of elements")))?;
    Ok(Element { name, count, properties: Vec::new() })
}

fn read_property(cursor: &mut Cursor<'_>) -> Result<PlyProperty, Fault> {
    let scalar = |cursor: &mut Cursor<'_>, word: &[u8]| {
        Scalar::from_name(word).ok_or_else(|| cursor.fault(format!("no PLY type is called {}", quoted(word))))
    };
    let first = cursor.word();
    let (list, scalar) = if first.eq_ignore_ascii_case(b"list") {
        let (count, item) = (cursor.word(), cursor.word());
        let count = scalar(cursor, count)?;
        if !count.is_integer() {
            return Err(cursor.fault(format!("a list's length cannot be a {}", count.name())));
        }
        (Some(count), scalar(cursor, item)?)
    } else {
        (None, scalar(cursor, first)?)
    };
    let name = text(cursor.word());
    if name.is_empty() {
        return Err(cursor.fault("a property has no name"));
    }
    Ok(PlyProperty { name, scalar, list })
}

fn text(word: &[u8]) -> String {
    String::from_utf8_lossy(word).into_owned()
}
