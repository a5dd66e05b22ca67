//! STL in pieces: binary facets have the same size, so that each can be found by its number.

use std::sync::atomic::{AtomicBool, Ordering};

use super::input::Input;
use super::stl_text::{self, Solids};
use super::{Piece, PieceGroup, PieceOptions, PieceSource, PieceSummary};
use crate::error::{Fault, Place};
use crate::report::Warnings;
use crate::stl::{FACET_BYTES, HEADER_BYTES, VertexTable, facet_count, is_ascii, position_at};
use crate::{ReadError, Warning};

/// Binary STL file.
pub(crate) struct StlPieces {
    input: Input,
    summary: PieceSummary,
    /// First facet of each solid; empty for binary files.
    solid_starts: Vec<usize>,
    facet_count: usize,
    piece_size: usize,
    /// Whether a facet that has been read has a color or another attribute.
    has_facet_data: AtomicBool,
}

impl StlPieces {
    /// Opens a file; text is converted to a temporary file.
    pub(crate) fn open(mut input: Input, options: &PieceOptions) -> Result<Self, ReadError> {
        let mut solids = Solids { groups: Vec::new(), starts: Vec::new() };
        let mut warnings = Warnings::of_file(&input.name);
        // Coordinates of binary files are single precision; another origin would only round them again.
        let mut origin = [0.0; 3];
        if is_ascii(&input.bytes) {
            (solids, origin) = stl_text::convert(&mut input, options, &mut warnings)?;
        }
        if solids.groups.is_empty() {
            solids.groups.push(PieceGroup::default());
        }
        let facet_count = facet_count(&input.bytes, &mut warnings);
        let facet_count = facet_count.map_err(|fault| fault.in_file(&input.name))?;
        let summary = PieceSummary {
            name: input.name.clone(),
            origin,
            groups: std::mem::take(&mut solids.groups),
            triangle_count: facet_count as u64,
            byte_count: input.file_bytes,
            warnings: warnings.into_list(),
            ..PieceSummary::default()
        };
        Ok(Self {
            input,
            summary,
            solid_starts: solids.starts,
            facet_count,
            piece_size: options.piece_size(),
            has_facet_data: AtomicBool::new(false),
        })
    }

    /// The solid of a facet: the last one that begins before it or with it.
    fn solid_of(&self, facet: usize) -> u32 {
        self.solid_starts.partition_point(|&start| start <= facet).saturating_sub(1) as u32
    }

    fn facets(&self, first: usize) -> Piece {
        let count = self.piece_size.min(self.facet_count - first);
        let start = HEADER_BYTES + first * FACET_BYTES;
        let bytes = &self.input.bytes[start..start + count * FACET_BYTES];
        let mut vertices = VertexTable::with_capacity(count / 2 + 2);
        let (mut triangles, mut has_data) = (Vec::with_capacity(count), false);
        for bytes in bytes.chunks_exact(FACET_BYTES) {
            triangles.push([12, 24, 36].map(|at| vertices.vertex(position_at(bytes, at))));
            has_data |= bytes[48..] != [0, 0];
        }
        self.has_facet_data.fetch_or(has_data, Ordering::Relaxed);
        let groups = match self.summary.groups.len() {
            1 => Vec::new(),
            _ => (first..first + count).map(|facet| self.solid_of(facet)).collect(),
        };
        Piece { positions: vertices.positions, layers: Vec::new(), triangles, groups }
    }
}

impl PieceSource for StlPieces {
    fn summary(&self) -> &PieceSummary {
        &self.summary
    }

    fn piece_count(&self) -> u64 {
        self.facet_count.div_ceil(self.piece_size) as u64
    }

    fn read_piece(&self, index: u64) -> Result<Piece, ReadError> {
        if index >= self.piece_count() {
            let fault = Fault::Malformed(Place::File, format!("piece {index} does not exist"));
            return Err(fault.in_file(&self.input.name));
        }
        Ok(self.facets(index as usize * self.piece_size))
    }

    fn warnings(&self) -> Vec<Warning> {
        let mut all = Warnings::of_list(&self.summary.name, self.summary.warnings.clone());
        if self.has_facet_data.load(Ordering::Relaxed) {
            all.push(
                Place::File,
                "the colors and attributes of facets are left out: pages cannot store them",
            );
        }
        all.into_list()
    }
}
