//! STL in pieces: binary facets have the same size, so that each can be found by its number.

use std::sync::atomic::{AtomicBool, Ordering};

use super::input::PieceInput;
use super::stl_text::{self, Solids};
use super::{LayerKind, Piece, PieceGroup, PieceOptions, PieceSource, PieceSummary};
use crate::error::{Fault, Place};
use crate::report::Warnings;
use crate::stl::{
    FACET_BYTES, FacetForm, HEADER_BYTES, VertexTable, facet_count, is_ascii, position_at, word_of,
};
use crate::{ReadError, Warning};

/// Largest number of facets whose attribute words are read to find what they mean.
const MAX_SAMPLES: usize = 1 << 16;

/// Binary STL file.
pub(crate) struct StlPieces {
    input: PieceInput,
    summary: PieceSummary,
    /// First facet of each solid; empty for binary files.
    solid_starts: Vec<usize>,
    facet_count: usize,
    piece_size: usize,
    /// Meaning of the attribute words, if the sample has any.
    facet_form: Option<FacetForm>,
    /// Whether a facet that has been read has a word although the sample has none.
    has_lost_words: AtomicBool,
}

impl StlPieces {
    /// Opens a file; text is converted to a temporary file.
    pub(crate) fn open(mut input: PieceInput, options: &PieceOptions) -> Result<Self, ReadError> {
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
        let words = || {
            let facets = input.bytes[HEADER_BYTES..].chunks_exact(FACET_BYTES).take(facet_count);
            facets.step_by(facet_count.div_ceil(MAX_SAMPLES).max(1)).map(word_of)
        };
        let facet_form = FacetForm::of(&input.bytes, words());
        facet_form.inspect(|form| form.warn(words(), &mut warnings));
        let kind = |form: FacetForm| LayerKind::of(&form.layer([].into_iter()));
        let summary = PieceSummary {
            triangle_layers: facet_form.map(kind).into_iter().collect(),
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
            facet_form,
            has_lost_words: AtomicBool::new(false),
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
        let (mut triangles, mut all_words) = (Vec::with_capacity(count), 0);
        for bytes in bytes.chunks_exact(FACET_BYTES) {
            triangles.push([12, 24, 36].map(|at| vertices.vertex(position_at(bytes, at))));
            all_words |= word_of(bytes);
        }
        let words = bytes.chunks_exact(FACET_BYTES).map(word_of);
        let triangle_layers = self.facet_form.map(|form| form.layer(words)).into_iter().collect();
        self.has_lost_words.fetch_or(all_words != 0 && self.facet_form.is_none(), Ordering::Relaxed);
        let groups = match self.summary.groups.len() {
            1 => Vec::new(),
            _ => (first..first + count).map(|facet| self.solid_of(facet)).collect(),
        };
        Piece { positions: vertices.positions, layers: Vec::new(), triangles, groups, triangle_layers }
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
        if self.has_lost_words.load(Ordering::Relaxed) {
            all.push(Place::File, "the attribute words of few facets are left out: a sample of all has none");
        }
        all.into_list()
    }
}
