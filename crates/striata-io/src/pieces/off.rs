//! OFF in pieces: one pass writes the rows of vertices and the triangles to temporary files.

use striata::mesh::{AttributeLayer, relative_position};

use super::input::PieceInput;
use super::local::localize;
use super::scratch::Mapped;
use super::spool::{Spool, origin_near};
use super::{LayerKind, Piece, PieceGroup, PieceOptions, PieceSource, PieceSummary};
use crate::ReadError;
use crate::error::{Fault, Place};
use crate::off::{Columns, OffLayout, PolygonColors, read_rows, visit_coordinates};
use crate::repair::check_triangles;
use crate::report::Warnings;
use crate::text::trimmed;

const TRIANGLE_BYTES: usize = 12;

/// OFF file whose tables are in temporary files.
pub(crate) struct OffPieces {
    layout: OffLayout,
    /// Numbers of each vertex.
    rows: Mapped,
    /// Positions of all vertices, if they are relative to an origin.
    relative: Option<Mapped>,
    triangles: Mapped,
    /// Colors of the polygons of all triangles, and their numbers.
    colors: Option<(PolygonColors, Mapped)>,
    summary: PieceSummary,
    piece_size: usize,
}

impl OffPieces {
    /// Reads a file once.
    pub(crate) fn open(mut input: PieceInput, options: &PieceOptions) -> Result<Self, ReadError> {
        input.make_plain_text(options)?;
        let mut warnings = Warnings::of_file(&input.name);
        let (mut rows, mut triangles) = (Spool::new(options)?, Spool::new(options)?);
        let (mut colors, mut color_rows) = (PolygonColors::default(), Spool::new(options)?);
        let mut count = 0;
        let vertex = |_: &OffLayout, row: &[f32]| rows.write(bytemuck::cast_slice(row));
        let layout = read_rows(trimmed(&input.bytes), &mut warnings, vertex, |triangle, color| {
            triangles.write(bytemuck::cast_slice(&triangle));
            count += 1;
            colors.push(color, count, |values| color_rows.write(bytemuck::cast_slice(&values)));
        })
        .map_err(|fault| fault.in_file(&input.name))?;
        let (rows, triangles) = (rows.finish(options)?, triangles.finish(options)?);
        let color_rows = color_rows.finish(options)?;
        check_triangles([rows.len() / (4 * layout.row_length()), count], count, &warnings)?;
        colors.warn(count, &mut warnings);
        let colors = (colors.count > 0).then_some((colors, color_rows));
        let origin = options.origin.unwrap_or_else(|| match layout.has_long_coordinates {
            true => origin_near(&rows, 4 * layout.row_length()),
            false => [0.0; 3],
        });
        let relative = match origin == [0.0; 3] {
            true => None,
            false => Some(relative_positions(&input, origin, options)?),
        };
        let (_, layers) = Columns::default().into_mesh(&layout);
        let summary = PieceSummary {
            name: input.name.clone(),
            origin,
            layers: layers.iter().map(LayerKind::of).collect(),
            triangle_layers: colors
                .iter()
                .map(|(colors, _)| LayerKind::of(&colors.layer([].into_iter())))
                .collect(),
            groups: vec![PieceGroup::default()],
            triangle_count: count as u64,
            byte_count: input.file_bytes,
            warnings: warnings.into_list(),
            ..PieceSummary::default()
        };
        Ok(Self { layout, rows, relative, triangles, colors, summary, piece_size: options.piece_size() })
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
            if let Some(relative) = &self.relative {
                let (words, _) = relative[number as usize * 12..][..12].as_chunks::<4>();
                row[..3].iter_mut().zip(words).for_each(|(x, bytes)| *x = f32::from_ne_bytes(*bytes));
            }
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
        let triangle_layers = self.colors.iter().map(|(colors, rows)| {
            let (words, _) = rows.as_chunks::<4>();
            let (rows, _) = words.as_chunks::<{ PolygonColors::WIDTH }>();
            let rows = rows[first..first + triangles.len()].iter();
            colors.layer(rows.map(|row| row.map(f32::from_ne_bytes)))
        });
        let triangle_layers = triangle_layers.collect();
        Piece { positions, layers, triangles, triangle_layers, groups: Vec::new() }
    }
}

/// Reads the coordinates of the vertices again, in doubles, and writes them relative to an origin.
fn relative_positions(
    input: &PieceInput,
    origin: [f64; 3],
    options: &PieceOptions,
) -> Result<Mapped, ReadError> {
    let mut spool = Spool::new(options)?;
    visit_coordinates(trimmed(&input.bytes), |position| {
        spool.write(bytemuck::cast_slice(&relative_position(position, origin)));
    })
    .map_err(|fault| fault.in_file(&input.name))?;
    spool.finish(options)
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
