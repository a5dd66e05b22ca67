//! OFF in pieces: one pass writes the rows of vertices and the triangles to temporary files.

use striata::mesh::AttributeLayer;

use super::input::{Input, Mapped};
use super::local::localize;
use super::spool::Spool;
use super::{LayerKind, Piece, PieceGroup, PieceOptions, PieceSource, PieceSummary};
use crate::ReadError;
use crate::error::{Fault, Place};
use crate::off::{Columns, Layout, read_rows};
use crate::repair::check_triangles;
use crate::report::Warnings;
use crate::text::trimmed;

const TRIANGLE_BYTES: usize = 12;

/// OFF file whose tables are in temporary files.
pub(crate) struct OffPieces {
    layout: Layout,
    /// Numbers of each vertex.
    rows: Mapped,
    triangles: Mapped,
    summary: PieceSummary,
    piece_size: usize,
}

impl OffPieces {
    /// Reads a file once.
    pub(crate) fn open(mut input: Input, options: &PieceOptions) -> Result<Self, ReadError> {
        input.make_plain_text(options)?;
        let mut warnings = Warnings::of_file(&input.name);
        let (mut rows, mut triangles) = (Spool::new(options)?, Spool::new(options)?);
        let mut has_colors = false;
        let vertex = |_: &Layout, row: &[f32]| rows.write(bytemuck::cast_slice(row));
        let layout = read_rows(trimmed(&input.bytes), &mut warnings, vertex, |triangle, color| {
            triangles.write(bytemuck::cast_slice(&triangle));
            has_colors |= !color.is_empty();
        })
        .map_err(|fault| fault.in_file(&input.name))?;
        let (rows, triangles) = (rows.finish(options)?, triangles.finish(options)?);
        let count = triangles.len() / TRIANGLE_BYTES;
        check_triangles([rows.len() / (4 * layout.row_length()), count], count, &warnings)?;
        if has_colors {
            warnings.push(Place::File, "the property color_0 of faces is left out: pages cannot store it");
        }
        let (_, layers) = Columns::default().into_mesh(&layout);
        let summary = PieceSummary {
            name: input.name.clone(),
            layers: layers.iter().map(LayerKind::of).collect(),
            groups: vec![PieceGroup::default()],
            triangle_count: count as u64,
            byte_count: input.file_bytes,
            warnings: warnings.into_list(),
            ..PieceSummary::default()
        };
        Ok(Self { layout, rows, triangles, summary, piece_size: options.piece_size() })
    }

    /// Number of vertices.
    #[cfg(feature = "blocks")]
    pub(crate) fn vertex_count(&self) -> u32 {
        (self.rows.len() / self.row_bytes()) as u32
    }

    /// All triangles.
    #[cfg(feature = "blocks")]
    pub(crate) fn triangles(&self) -> impl Iterator<Item = [u32; 3]> {
        triangles_in(&self.triangles)
    }

    fn row_bytes(&self) -> usize {
        4 * self.layout.row_length()
    }

    /// Positions and layers of some vertices.
    pub(crate) fn vertices(
        &self,
        numbers: impl IntoIterator<Item = u32>,
    ) -> (Vec<[f32; 3]>, Vec<AttributeLayer>) {
        let (mut columns, mut row) = (Columns::default(), Vec::new());
        let row_bytes = self.row_bytes();
        for number in numbers {
            row.clear();
            let (words, _) = self.rows[number as usize * row_bytes..][..row_bytes].as_chunks::<4>();
            row.extend(words.iter().map(|bytes| f32::from_ne_bytes(*bytes)));
            columns.push(&self.layout, &row);
        }
        columns.into_mesh(&self.layout)
    }

    fn piece(&self, first: usize) -> Piece {
        let end = self.triangles.len().min((first + self.piece_size) * TRIANGLE_BYTES);
        let mut triangles: Vec<[u32; 3]> =
            triangles_in(&self.triangles[first * TRIANGLE_BYTES..end]).collect();
        let numbers = localize(&mut triangles);
        let (positions, layers) = self.vertices(numbers);
        Piece { positions, layers, triangles, groups: Vec::new() }
    }
}

fn triangles_in(bytes: &[u8]) -> impl Iterator<Item = [u32; 3]> {
    let (words, _) = bytes.as_chunks::<4>();
    words.as_chunks::<3>().0.iter().map(|corners| corners.map(u32::from_ne_bytes))
}

impl PieceSource for OffPieces {
    fn summary(&self) -> &PieceSummary {
        &self.summary
    }

    fn piece_count(&self) -> u64 {
        self.summary.triangle_count.div_ceil(self.piece_size as u64)
    }

    fn read_piece(&self, index: u64) -> Result<Piece, ReadError> {
        if index >= self.piece_count() {
            let fault = Fault::Malformed(Place::File, format!("piece {index} does not exist"));
            return Err(fault.in_file(&self.summary.name));
        }
        Ok(self.piece(index as usize * self.piece_size))
    }
}
