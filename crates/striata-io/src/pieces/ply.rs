//! Binary PLY in pieces: vertices have rows of the same size, and pieces are runs of faces.

use std::borrow::Cow;

use striata::mesh::{AttributeLayer, IndexedMesh, origin_of};

use super::input::PieceInput;
use super::ply_faces::{FaceOptions, FaceRun, FaceRuns};
use super::{LayerKind, Piece, PieceGroup, PieceOptions, PieceSource, PieceSummary, ply_text};
use crate::ReadError;
use crate::error::{Fault, Place};
use crate::ply::body::TextureProperties;
use crate::ply::face_data::left_out;
use crate::ply::header::{Element, Encoding, Header};
use crate::ply::lists::{index_list, skip_element};
use crate::ply::rows::BinaryRows;
use crate::ply::vertices::PlyVertices;
use crate::ply::{textures, warn_of_rest};
use crate::repair::check_triangles;
use crate::report::Warnings;
use crate::texture_set::TextureSet;

/// Binary PLY file.
pub(super) struct PlyPieces {
    input: PieceInput,
    header: Header,
    vertices: VertexRows,
    faces: Option<FaceRuns>,
    summary: PieceSummary,
}

/// Vertices in the file.
struct VertexRows {
    element: Element,
    first: usize,
    stride: usize,
    is_big: bool,
}

/// Places of the vertices and of the faces in the file, if it has them.
#[derive(Default)]
struct Located {
    first_vertex: Option<usize>,
    faces: Option<FaceRuns>,
    /// End of the last element.
    end: usize,
}

impl PlyPieces {
    /// Opens a file; text is converted to a temporary file. What must be read at once is given back:
    /// strips, vertices with lists, and faces with texture coordinates.
    pub(super) fn open(
        mut input: PieceInput,
        options: &PieceOptions,
    ) -> Result<Result<Self, PieceInput>, ReadError> {
        let mut header = Header::read(&input.bytes).map_err(|fault| fault.in_file(&input.name))?;
        let count = |name: &str| header.elements.iter().filter(|e| e.name == name).count();
        let is_repeated = count("vertex") > 1 || count("face") > 1;
        if is_repeated || header.elements.iter().any(must_be_read_at_once) {
            return Ok(Err(input));
        }
        let mut warnings = Warnings::of_file(&input.name);
        left_out(&header).into_iter().for_each(|remark| warnings.push(Place::File, remark));
        if header.encoding == Encoding::Ascii {
            ply_text::convert(&mut input, &header, options, &mut warnings)?;
            let comments = std::mem::take(&mut header.texture_files);
            header = Header::read(&input.bytes).map_err(|fault| fault.in_file(&input.name))?;
            // Lines of the original file, for messages.
            header.texture_files = comments;
            header.has_top_origin = true;
        }
        let opened = locate(&input.bytes, &header, options).and_then(|located| {
            warn_of_rest(&input.bytes, input.bytes.len() - located.end, &mut warnings);
            let vertex = header.vertex()?;
            let vertices = VertexRows {
                element: vertex.clone(),
                first: located.first_vertex.unwrap_or(header.body_at),
                stride: vertex.least_row_bytes(),
                is_big: header.encoding == Encoding::BigEndian,
            };
            let kinds = vertices.values(&[], &header, [0.0; 3])?.1.iter().map(LayerKind::of).collect();
            let origin = match options.origin {
                Some(origin) => origin,
                None => vertices.origin(&input.bytes, &header)?,
            };
            Ok((vertices, located.faces, kinds, origin))
        });
        let (vertices, faces, layers, origin) = opened.map_err(|fault| fault.in_file(&input.name))?;
        let mut summary = PieceSummary {
            name: input.name.clone(),
            layers,
            triangle_layers: faces.as_ref().map_or(Vec::new(), |faces| faces.layer_kinds(&header)),
            origin,
            triangle_count: faces.as_ref().map_or(0, |faces| faces.triangle_count),
            byte_count: input.file_bytes,
            ..PieceSummary::default()
        };
        attach_textures(&mut summary, &input, &header, warnings, &vertices);
        summary.companions = input.companions();
        summary.appearance.georeference.clone_from(&header.georeference);
        let count = summary.triangle_count as usize;
        let warnings = Warnings::of_list(&input.name, summary.warnings.clone());
        check_triangles([vertices.element.count, count], count, &warnings)?;
        Ok(Ok(Self { input, header, vertices, faces, summary }))
    }

    fn piece(&self, run: usize) -> Result<Piece, Fault> {
        let Some(faces) = self.faces.as_ref().filter(|faces| (run as u64) < faces.run_count()) else {
            return Err(Fault::Malformed(Place::File, format!("piece {run} does not exist")));
        };
        let FaceRun { triangles, triangle_layers, vertices } =
            faces.read(&self.input.bytes, run, &self.header)?;
        let rows = self.vertices.rows(&self.input.bytes, &vertices);
        let (positions, layers) = self.vertices.values(&rows, &self.header, self.summary.origin)?;
        Ok(Piece { positions, layers, triangles, triangle_layers, groups: Vec::new() })
    }
}

/// Whether an element cannot be read in pieces.
pub(crate) fn must_be_read_at_once(element: &Element) -> bool {
    match element.name.as_str() {
        "vertex" => element.properties.iter().any(|p| p.list.is_some()),
        "tristrips" => true,
        "face" => TextureProperties::of(element, false).is_some(),
        _ => false,
    }
}

/// Finds the elements; all that are declared are in the file.
fn locate(bytes: &[u8], header: &Header, options: &PieceOptions) -> Result<Located, Fault> {
    let is_big = header.encoding == Encoding::BigEndian;
    let vertex_count = header.vertex()?.count;
    let (mut found, mut at) = (Located::default(), header.body_at);
    for (place, element) in header.elements.iter().enumerate() {
        check_room(element, bytes.len(), at)?;
        let is_vertex = element.name == "vertex" && found.first_vertex.is_none();
        if is_vertex {
            found.first_vertex = Some(at);
        }
        let list = index_list(element).filter(|_| element.name == "face" && found.faces.is_none());
        at = match list {
            Some(list) => {
                let is_last = place + 1 == header.elements.len();
                let piece_size = options.piece_size();
                let options = FaceOptions { is_big, vertex_count, piece_size, is_last };
                let (runs, end) = FaceRuns::locate(bytes, at, element, list, options)?;
                found.faces = Some(runs);
                end
            }
            None => skip(bytes, at, element, is_big)?,
        };
    }
    found.end = at;
    Ok(found)
}

/// Refuses counts that the remaining bytes cannot contain.
fn check_room(element: &Element, file_bytes: usize, at: usize) -> Result<(), Fault> {
    let needed = element.least_row_bytes() as u64 * element.count as u64;
    let left = (file_bytes - at) as u64;
    if needed <= left {
        return Ok(());
    }
    let (count, name) = (element.count, &element.name);
    let reason = format!(
        "{count} rows of `{name}` are declared, which take {needed} bytes or more, but only {left} follow"
    );
    Err(Fault::at_byte(at, reason))
}

fn skip(bytes: &[u8], at: usize, element: &Element, is_big: bool) -> Result<usize, Fault> {
    if is_big {
        let mut rows = BinaryRows::<true>::new(bytes, at);
        return skip_element(element, &mut rows).map(|()| rows.at());
    }
    let mut rows = BinaryRows::<false>::new(bytes, at);
    skip_element(element, &mut rows).map(|()| rows.at())
}

/// Gives the summary the images that the header names, and remarks on what was left out.
fn attach_textures(
    summary: &mut PieceSummary,
    input: &PieceInput,
    header: &Header,
    mut warnings: Warnings,
    vertices: &VertexRows,
) {
    let set = TextureSet::new(&input.source(), input.unpacked_bytes);
    // A stand-in for the whole mesh: its layers decide whether there are textures, its triangle gets the
    // group.
    let layers = vertices.values(&[], header, [0.0; 3]).map(|(_, layers)| layers).unwrap_or_default();
    let mut mesh = IndexedMesh { layers, ..IndexedMesh::new(Vec::new(), vec![[0; 3]]) };
    textures::attach(&mut mesh, &header.texture_files, &[], set, &mut warnings);
    let group = |group| PieceGroup { material: group, ..PieceGroup::default() };
    summary.groups = mesh.groups_or_whole().iter().map(|g| group(g.material)).collect();
    summary.appearance = mesh.appearance;
    summary.warnings = warnings.into_list();
}

impl VertexRows {
    fn byte_of(&self, vertex: u32) -> usize {
        self.first + vertex as usize * self.stride
    }

    /// Copies the rows of some vertices.
    fn rows(&self, bytes: &[u8], numbers: &[u32]) -> Vec<u8> {
        let mut rows = Vec::with_capacity(numbers.len() * self.stride);
        for &vertex in numbers {
            rows.extend_from_slice(&bytes[self.byte_of(vertex)..][..self.stride]);
        }
        rows
    }

    /// Converts whole rows to positions and layers.
    fn values(
        &self,
        rows: &[u8],
        header: &Header,
        origin: [f64; 3],
    ) -> Result<(Vec<[f32; 3]>, Vec<AttributeLayer>), Fault> {
        let vertices = self.vertices(rows, header);
        Ok((vertices.positions(header, origin)?, vertices.layers(header)))
    }

    /// Chooses the origin from evenly spaced vertices; zero if single precision holds the coordinates.
    fn origin(&self, bytes: &[u8], header: &Header) -> Result<[f64; 3], Fault> {
        /// Number of vertices that the origin is chosen from.
        const SAMPLES: usize = 1 << 16;
        let stride = self.element.count.div_ceil(SAMPLES).max(1);
        let numbers: Vec<u32> = (0..self.element.count as u32).step_by(stride).collect();
        let rows = self.rows(bytes, &numbers);
        Ok(self.vertices(&rows, header).file_positions(header)?.map_or([0.0; 3], |sample| origin_of(&sample)))
    }

    /// Wraps whole rows.
    fn vertices<'r>(&self, rows: &'r [u8], header: &Header) -> PlyVertices<'r> {
        let mut rows = Cow::Borrowed(rows);
        if self.is_big {
            for row in rows.to_mut().chunks_exact_mut(self.stride.max(1)) {
                let mut at = 0;
                for property in &self.element.properties {
                    row[at..at + property.scalar.bytes()].reverse();
                    at += property.scalar.bytes();
                }
            }
        }
        PlyVertices::of_rows(&self.element, rows, header.has_top_origin)
    }
}

impl PieceSource for PlyPieces {
    fn summary(&self) -> &PieceSummary {
        &self.summary
    }

    fn piece_count(&self) -> u64 {
        self.faces.as_ref().map_or(0, FaceRuns::run_count)
    }

    fn read_piece(&self, index: u64) -> Result<Piece, ReadError> {
        let run = usize::try_from(index).unwrap_or(usize::MAX);
        self.piece(run).map_err(|fault| fault.in_file(&self.input.name))
    }
}
