//! Binary PLY file read piece by piece, for meshes that do not fit into memory.
//!
//! Vertices must have rows of constant length, so that each can be located by its index, and must precede the
//! faces. Other elements before the faces must have constant row lengths too, so that they can be skipped.
//! Texture coordinates and texture numbers of faces are skipped, and images are not read: their names are
//! copied to the header of a PLY file that is written.

use std::borrow::Cow;
use std::fs::File;
use std::io::{self, BufRead, BufReader, Read, Seek, SeekFrom, Write};
use std::sync::Arc;

use striata::mesh::{Appearance, AttributeLayer, IndexedMesh, origin_of, relative_position};

use super::header::{Element, Encoding, Header, PlyProperty, Scalar};
use super::lists::index_list;
use super::rows::integer_from_bytes;
use super::texcoords::{has_origin, with_bottom_origin};
use super::vertices::PlyVertices;
use super::write::{georeference_comment, push_row, push_values, vertex_header};
use crate::ReadError;
use crate::color_space::byte_colors;
use crate::error::{Fault, Place};
use crate::file_view::FileView;
use crate::report::Warnings;

/// Largest supported size of a header, in bytes.
const MAX_HEADER_BYTES: u64 = 1 << 20;
/// Approximate size of the pieces in which rows are read, in bytes.
const PIECE_BYTES: usize = 1 << 18;

/// End of a header whose triangles are strips.
const STRIPS: &str = "element tristrips 1\nproperty list uint int vertex_indices\nend_header\n";

/// PLY file whose header has been read and whose elements have been located.
#[derive(Clone, Debug)]
pub(crate) struct PlyStream {
    source: Arc<File>,
    name: String,
    pub header: Header,
    /// Offset of the first vertex.
    pub vertices_offset: u64,
    pub vertex_count: u32,
    pub stride: usize,
    /// Offset within a row and type of each of the three coordinates.
    axes: [(usize, Scalar); 3],
    /// Offset of the first face.
    faces_offset: u64,
    file_bytes: u64,
    /// Positions are relative to this point of the file's coordinates.
    pub origin: [f64; 3],
    /// Whether the rows have positions relative to the origin already, as those of temporary files have.
    pub is_relative: bool,
}

impl PlyStream {
    /// Reads the header of a binary PLY file and locates its elements; `name` is for messages.
    ///
    /// # Errors
    /// Returns an error if the elements cannot be located without reading all of the file.
    pub(crate) fn open(source: File, name: String) -> Result<Self, ReadError> {
        let io = |source| ReadError::Io { file: name.clone(), source };
        let file_bytes = source.metadata().map_err(io)?.len();
        let source = Arc::new(source);
        let mut head = Vec::new();
        FileView::new(Arc::clone(&source)).take(MAX_HEADER_BYTES).read_to_end(&mut head).map_err(io)?;
        let header = Header::read(&head).map_err(|fault| fault.in_file(&name))?;
        debug_assert!(header.encoding != Encoding::Ascii, "text is converted first");
        let in_file = |fault: Fault| fault.in_file(&name);
        let places = ElementOffsets::of(&header, file_bytes).map_err(in_file)?;
        let vertex = header.vertex().map_err(in_file)?;
        let axes = axes_of(vertex, header.body_at as u64).map_err(in_file)?;
        let (vertex_count, stride) = (vertex.count as u32, vertex.least_row_bytes());
        let (vertices_offset, faces_offset) = (places.vertices_offset, places.faces_offset);
        Ok(Self {
            source,
            name,
            header,
            vertices_offset,
            vertex_count,
            stride,
            axes,
            faces_offset,
            file_bytes,
            origin: [0.0; 3],
            is_relative: false,
        })
    }

    /// Chooses the origin from evenly spaced vertices, if single precision cannot hold the coordinates.
    pub(crate) fn choose_origin(&mut self) -> Result<(), ReadError> {
        /// Number of vertices that the origin is chosen from.
        const SAMPLES: u32 = 1 << 12;
        if !self.has_doubles() {
            return Ok(());
        }
        let (mut file, mut row, mut sample) = (self.file(), vec![0; self.stride], Vec::new());
        for vertex in (0..self.vertex_count).step_by(self.vertex_count.div_ceil(SAMPLES).max(1) as usize) {
            let at = self.vertices_offset + u64::from(vertex) * self.stride as u64;
            file.seek(SeekFrom::Start(at)).map_err(|e| self.io(e))?;
            file.read_exact(&mut row).map_err(|e| self.io(e))?;
            sample.push(self.coordinates(&row));
        }
        self.origin = origin_of(&sample);
        Ok(())
    }

    /// Whether single precision cannot hold the type of a coordinate.
    fn has_doubles(&self) -> bool {
        self.axes.iter().any(|(_, scalar)| matches!(scalar, Scalar::F64 | Scalar::I32 | Scalar::U32))
    }

    /// Returns the file's name for messages.
    pub(crate) fn name(&self) -> &str {
        &self.name
    }

    /// Returns the file with a read position of its own.
    pub(crate) fn file(&self) -> FileView {
        FileView::new(Arc::clone(&self.source))
    }

    /// Wraps a system error with the file's name.
    pub(crate) fn io(&self, source: io::Error) -> ReadError {
        ReadError::Io { file: self.name.clone(), source }
    }

    fn is_big_endian(&self) -> bool {
        self.header.encoding == Encoding::BigEndian
    }

    /// Returns the position in one vertex row, relative to the origin.
    pub(crate) fn position(&self, row: &[u8]) -> [f32; 3] {
        let written = self.coordinates(row);
        if self.is_relative { written.map(|x| x as f32) } else { relative_position(written, self.origin) }
    }

    /// Returns the coordinates in one vertex row as they are.
    fn coordinates(&self, row: &[u8]) -> [f64; 3] {
        self.axes.map(|(offset, scalar)| {
            let taken = &row[offset..offset + scalar.bytes()];
            let mut word = [0; 8];
            for (i, &byte) in taken.iter().enumerate() {
                word[if self.is_big_endian() { taken.len() - 1 - i } else { i }] = byte;
            }
            match scalar {
                Scalar::F32 => f64::from(f32::from_bits(u64::from_le_bytes(word) as u32)),
                Scalar::F64 => f64::from_le_bytes(word),
                _ => integer_from_bytes(taken, scalar, self.is_big_endian()) as f64,
            }
        })
    }

    /// Converts whole vertex rows to a mesh without triangles, with all layers and the origin.
    pub(crate) fn vertices(&self, rows: &[u8]) -> Result<IndexedMesh, ReadError> {
        let in_file = |fault: Fault| fault.in_file(&self.name);
        let vertex = self.header.vertex().map_err(in_file)?;
        let mut rows = Cow::Borrowed(rows);
        if self.is_big_endian() {
            for row in rows.to_mut().chunks_exact_mut(self.stride) {
                let mut at = 0;
                for property in &vertex.properties {
                    row[at..at + property.scalar.bytes()].reverse();
                    at += property.scalar.bytes();
                }
            }
        }
        let vertices = PlyVertices::of_rows(vertex, rows, self.header.has_top_origin);
        let taken = if self.is_relative { [0.0; 3] } else { self.origin };
        let positions = vertices.positions(&self.header, taken).map_err(in_file)?;
        let layers = vertices.layers(&self.header);
        let appearance =
            Appearance { georeference: self.header.georeference.clone(), ..Appearance::default() };
        Ok(IndexedMesh { layers, origin: self.origin, appearance, ..IndexedMesh::new(positions, Vec::new()) })
    }

    /// Writes the header of a file whose triangles are strips, and copies the vertex rows: unchanged, unless
    /// this is a temporary file. All indices form one list, with strips separated by -1.
    ///
    /// The caller writes the list itself, in this file's byte order.
    pub(crate) fn write_strip_header(&self, index_count: u32, out: &mut dyn Write) -> io::Result<()> {
        if let Some(layers) = self.changed_layers().map_err(CopyError::Read)? {
            return self.write_changed(&layers, index_count, out);
        }
        let encoding = if self.is_big_endian() { "binary_big_endian" } else { "binary_little_endian" };
        let mut head = format!("ply\nformat {encoding} 1.0\n");
        for name in &self.header.normalized {
            head += &format!("comment normalized {name}\n");
        }
        for texture in &self.header.texture_files {
            head += &format!("comment TextureFile {}\n", texture.name);
        }
        head += &georeference_comment(&self.header.georeference);
        head += &format!("element vertex {}\n", self.vertex_count);
        let vertex = self.header.elements.iter().find(|e| e.name == "vertex");
        for property in vertex.into_iter().flat_map(|vertex| &vertex.properties) {
            head += &format!("property {} {}\n", property.scalar.name(), property.name);
        }
        head += STRIPS;
        out.write_all(head.as_bytes())?;
        self.for_each_row_batch(|_, rows| out.write_all(rows).map_err(CopyError::Write))?;
        out.write_all(&self.u32_bytes(index_count))
    }

    /// Returns the layers of a temporary file without values, if the file that is written differs: in the
    /// origin of positions or of texture coordinates, or in the type of colors.
    fn changed_layers(&self) -> Result<Option<Vec<AttributeLayer>>, ReadError> {
        if !self.header.has_top_origin {
            return Ok(None);
        }
        let layers = self.vertices(&[])?.layers;
        let written: Vec<AttributeLayer> = self.written(&layers).map(Cow::into_owned).collect();
        let is_moved = self.is_relative && self.origin != [0.0; 3];
        let is_changed = is_moved || layers.iter().any(has_origin) || written != layers;
        Ok(is_changed.then_some(written))
    }

    /// Returns layers as they are written.
    fn written<'l>(
        &self,
        layers: &'l [AttributeLayer],
    ) -> impl Iterator<Item = Cow<'l, AttributeLayer>> + use<'l> {
        let mut warnings = Warnings::of_file(&self.name);
        layers.iter().map(move |layer| match with_bottom_origin(layer) {
            Cow::Borrowed(layer) => byte_colors(layer, &mut warnings),
            flipped => flipped,
        })
    }

    /// Writes vertices whose layers change, like [`write_strip_header`](Self::write_strip_header).
    fn write_changed(
        &self,
        layers: &[AttributeLayer],
        index_count: u32,
        out: &mut dyn Write,
    ) -> io::Result<()> {
        let names: Vec<&str> = self.header.texture_files.iter().map(|file| file.name.as_str()).collect();
        let vertex_count = self.vertex_count.to_string();
        let has_doubles = self.has_doubles() || self.origin != [0.0; 3];
        let coordinate = if has_doubles { Scalar::F64 } else { Scalar::F32 };
        let head = vertex_header(coordinate, layers, &names, "binary_little_endian", &vertex_count);
        let mut head = head.map_err(|refusal| io::Error::other(refusal.into_reason()))?;
        let comment = georeference_comment(&self.header.georeference);
        head.insert_str(head.find("element").unwrap_or(head.len()), &comment);
        out.write_all((head + STRIPS).as_bytes())?;
        let mut written = Vec::new();
        self.for_each_row_batch(|_, rows| {
            let mesh = self.vertices(rows)?;
            let layers: Vec<_> = self.written(&mesh.layers).collect();
            written.clear();
            for (vertex, row) in rows.chunks_exact(self.stride).enumerate() {
                if has_doubles {
                    written.extend_from_slice(bytemuck::cast_slice(&self.file_position(row)));
                    push_values(&layers, vertex, &mut written);
                } else {
                    push_row(&mesh.positions, &layers, vertex, &mut written);
                }
            }
            out.write_all(&written).map_err(CopyError::Write)
        })?;
        out.write_all(&index_count.to_le_bytes())
    }

    /// Returns the coordinates of one vertex row in the file that was read first.
    fn file_position(&self, row: &[u8]) -> [f64; 3] {
        let written = self.coordinates(row);
        if !self.is_relative {
            return written;
        }
        std::array::from_fn(|axis| written[axis] + self.origin[axis])
    }

    /// Returns a four-byte integer in this file's byte order.
    pub(crate) fn u32_bytes(&self, number: u32) -> [u8; 4] {
        if self.is_big_endian() { number.to_be_bytes() } else { number.to_le_bytes() }
    }

    /// Passes the vertex rows to `visit` in order: the index of the first, and whole rows.
    ///
    /// # Errors
    /// Returns an error if the file cannot be read, or the error of `visit`.
    pub(crate) fn for_each_row_batch<E: From<ReadError>>(
        &self,
        mut visit: impl FnMut(u32, &[u8]) -> Result<(), E>,
    ) -> Result<(), E> {
        if self.stride == 0 {
            return Ok(());
        }
        let mut file = self.file();
        file.seek(SeekFrom::Start(self.vertices_offset)).map_err(|e| self.io(e))?;
        let rows_at_once = (PIECE_BYTES / self.stride).max(1) as u32;
        let mut rows = Vec::new();
        for first in (0..self.vertex_count).step_by(rows_at_once as usize) {
            let count = rows_at_once.min(self.vertex_count - first);
            rows.resize(count as usize * self.stride, 0);
            file.read_exact(&mut rows).map_err(|e| self.io(e))?;
            visit(first, &rows)?;
        }
        Ok(())
    }

    /// Passes the triangles to `visit` in order; polygons are triangulated as fans.
    ///
    /// # Errors
    /// Returns an error if the file is truncated or a vertex index is out of range, or the error of `visit`.
    pub(crate) fn for_each_triangle(
        &self,
        mut visit: impl FnMut([u32; 3]) -> Result<(), ReadError>,
    ) -> Result<(), ReadError> {
        let Some(element) = self.header.elements.iter().find(|e| e.name == "face") else { return Ok(()) };
        let mut file = self.file();
        file.seek(SeekFrom::Start(self.faces_offset)).map_err(|e| self.io(e))?;
        let mut reader = FaceRows {
            stream: self,
            bytes: BufReader::with_capacity(PIECE_BYTES, file),
            at: self.faces_offset,
            is_big: self.is_big_endian(),
        };
        let Some(list) = index_list(element) else { return Ok(()) };
        let mut left = element.count;
        while left > 0 {
            left -= reader.plain_triangles(element, left, &mut visit)?;
            if left == 0 {
                break;
            }
            for (place, property) in element.properties.iter().enumerate() {
                match property.list {
                    Some(length) if list == place => reader.polygon(property.scalar, length, &mut visit)?,
                    _ => reader.skip(property)?,
                }
            }
            left -= 1;
        }
        Ok(())
    }
}

/// Reason why copying a file's vertices failed.
pub(crate) enum CopyError {
    /// Error of the file that is read.
    Read(ReadError),
    /// Error of the file that is written.
    Write(io::Error),
}

impl From<ReadError> for CopyError {
    fn from(error: ReadError) -> Self {
        Self::Read(error)
    }
}

impl From<CopyError> for io::Error {
    fn from(stopped: CopyError) -> Self {
        match stopped {
            CopyError::Read(error) => Self::other(error),
            CopyError::Write(error) => error,
        }
    }
}

/// Locations of the elements in the file.
struct ElementOffsets {
    vertices_offset: u64,
    faces_offset: u64,
}

impl ElementOffsets {
    fn of(header: &Header, file_bytes: u64) -> Result<Self, Fault> {
        let (mut at, mut vertices_offset, mut faces_offset) = (header.body_at as u64, None, None);
        for element in &header.elements {
            let has_lists = element.properties.iter().any(|p| p.list.is_some());
            let found = element.name.as_str();
            let needed = element.least_row_bytes() as u64 * element.count as u64;
            if needed > file_bytes.saturating_sub(at) {
                let (count, left) = (element.count, file_bytes.saturating_sub(at));
                let reason = format!(
                    "{count} rows of `{found}` are declared, which take {needed} bytes or more, but only \
                     {left} follow"
                );
                return Err(fault_at(at, reason));
            }
            match found {
                "vertex" if vertices_offset.is_none() && !has_lists => vertices_offset = Some(at),
                "face" if vertices_offset.is_some() => {
                    faces_offset = Some(at);
                    break;
                }
                "tristrips" => return Err(not_in_blocks(at, "element `tristrips`")),
                _ if has_lists => return Err(not_in_blocks(at, &format!("list in the element `{found}`"))),
                _ => {}
            }
            at += needed;
        }
        let vertices_offset = vertices_offset.unwrap_or(at);
        Ok(Self { vertices_offset, faces_offset: faces_offset.unwrap_or(at) })
    }
}

fn fault_at(at: u64, reason: String) -> Fault {
    Fault::Malformed(Place::Byte(at), reason)
}

fn not_in_blocks(at: u64, what: &str) -> Fault {
    Fault::Unsupported(Place::Byte(at), format!("an {what} before the faces, block by block,"))
}

fn axes_of(vertex: &Element, at: u64) -> Result<[(usize, Scalar); 3], Fault> {
    let mut axes = [(0, Scalar::F32); 3];
    if vertex.count == 0 {
        return Ok(axes);
    }
    for (axis, name) in axes.iter_mut().zip(["x", "y", "z"]) {
        let Some(place) = vertex.properties.iter().position(|p| p.name == name) else {
            return Err(fault_at(at, format!("the element `vertex` has no property `{name}`")));
        };
        let before = &vertex.properties[..place];
        *axis = (before.iter().map(|p| p.scalar.bytes()).sum(), vertex.properties[place].scalar);
    }
    Ok(axes)
}

/// Reads face rows one after another.
struct FaceRows<'a> {
    stream: &'a PlyStream,
    bytes: BufReader<FileView>,
    /// Offset of the next byte.
    at: u64,
    is_big: bool,
}

impl FaceRows<'_> {
    /// Reads rows of the usual form, three 32-bit indices after one length byte, as far as they are in
    /// memory. Stops at the first other row and returns the number of rows read.
    fn plain_triangles(
        &mut self,
        element: &Element,
        most: usize,
        visit: &mut impl FnMut([u32; 3]) -> Result<(), ReadError>,
    ) -> Result<usize, ReadError> {
        const ROW: usize = 13;
        let is_plain = matches!(
            element.properties[..],
            [PlyProperty { scalar: Scalar::I32 | Scalar::U32, list: Some(Scalar::U8 | Scalar::I8), .. }]
        );
        if !is_plain || self.is_big {
            return Ok(0);
        }
        let stream = self.stream;
        let rows = self.bytes.fill_buf().map_err(|error| stream.io(error))?.as_chunks::<ROW>().0;
        let mut count = 0;
        for row in rows.iter().take(most) {
            let index = |at: usize| u32::from_le_bytes([row[at], row[at + 1], row[at + 2], row[at + 3]]);
            let triangle = [index(1), index(5), index(9)];
            if row[0] != 3 || triangle.iter().any(|&v| v >= stream.vertex_count) {
                break;
            }
            visit(triangle)?;
            count += 1;
        }
        self.bytes.consume(count * ROW);
        self.at += (count * ROW) as u64;
        Ok(count)
    }

    #[inline]
    fn integer(&mut self, scalar: Scalar) -> Result<i64, ReadError> {
        let mut word = [0; 8];
        let taken = &mut word[..scalar.bytes()];
        match self.bytes.read_exact(taken) {
            Ok(()) => {}
            Err(error) if error.kind() == io::ErrorKind::UnexpectedEof => {
                let left = self.stream.file_bytes.saturating_sub(self.at);
                return Err(self.fault(format!("{} bytes expected, {left} left", scalar.bytes())));
            }
            Err(error) => return Err(self.stream.io(error)),
        }
        self.at += taken.len() as u64;
        Ok(integer_from_bytes(taken, scalar, self.is_big))
    }

    fn fault(&self, reason: String) -> ReadError {
        fault_at(self.at, reason).in_file(&self.stream.name)
    }

    fn length(&mut self, scalar: Scalar) -> Result<u64, ReadError> {
        let length = self.integer(scalar)?;
        u64::try_from(length).map_err(|_| self.fault(format!("a list cannot have {length} entries")))
    }

    fn skip(&mut self, property: &PlyProperty) -> Result<(), ReadError> {
        let count = match property.list {
            None => 1,
            Some(scalar) => self.length(scalar)?,
        };
        for _ in 0..count {
            self.integer(property.scalar)?;
        }
        Ok(())
    }

    fn vertex(&mut self, scalar: Scalar) -> Result<u32, ReadError> {
        let index = self.integer(scalar)?;
        match u32::try_from(index) {
            Ok(vertex) if vertex < self.stream.vertex_count => Ok(vertex),
            _ => {
                self.at -= scalar.bytes() as u64;
                let count = self.stream.vertex_count;
                Err(self.fault(format!("vertex {index} does not exist: there are {count}")))
            }
        }
    }

    fn polygon(
        &mut self,
        scalar: Scalar,
        length: Scalar,
        visit: &mut impl FnMut([u32; 3]) -> Result<(), ReadError>,
    ) -> Result<(), ReadError> {
        let (mut first, mut last) = (0, 0);
        for corner in 0..self.length(length)? {
            let vertex = self.vertex(scalar)?;
            match corner {
                0 => first = vertex,
                1 => {}
                _ => visit([first, last, vertex])?,
            }
            last = vertex;
        }
        Ok(())
    }
}
