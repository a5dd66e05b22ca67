//! OBJ in pieces: one pass writes the tables of positions, texture coordinates, normals and corners to
//! temporary files.

use std::collections::BTreeMap;

use striata::mesh::{AttributeLayer, Semantic, relative_position};

use super::input::PieceInput;
use super::scratch::Mapped;
use super::spool::{Spool, origin_near};
use super::{ComponentType, LayerKind, Piece, PieceGroup, PieceOptions, PieceSource, PieceSummary};
use crate::ReadError;
use crate::error::{Fault, Place};
use crate::obj::{ObjOutline, StatementBatch, is_missing, read_batches, visit_coordinates, warn_of_missing};
use crate::repair::check_triangles;
use crate::report::Warnings;

/// Marks a missing texture coordinate or normal.
const NONE: u32 = u32::MAX;
const CORNER_BYTES: usize = 12;

/// OBJ file whose tables are in temporary files.
pub(crate) struct ObjPieces {
    tables: ObjTables<Mapped>,
    summary: PieceSummary,
    /// First triangle and group of each run of triangles; no runs if there is one group.
    runs: Vec<(usize, u32)>,
    piece_size: usize,
    used: Used,
}

/// Tables of a file.
struct ObjTables<T> {
    positions: T,
    colors: T,
    texcoords: T,
    normals: T,
    /// Indices of position, texture coordinate and normal.
    corners: T,
}

/// Tables that are being written.
struct ObjTableWriter {
    tables: ObjTables<Spool>,
    position_count: usize,
    used: Used,
}

/// Kinds of values that the corners have.
#[derive(Clone, Copy, Default)]
struct Used {
    colors: bool,
    texcoords: Usage,
    normals: Usage,
}

/// Whether some corners have an index of a kind, and whether some have none.
#[derive(Clone, Copy)]
struct Usage {
    some: bool,
    lacking: bool,
    /// Indices from here on do not exist.
    count: usize,
}

impl Default for Usage {
    fn default() -> Self {
        Self { some: false, lacking: false, count: usize::MAX }
    }
}

impl Usage {
    /// The index of a corner, if the layer is kept and the index exists.
    fn index(&self, index: u32) -> u32 {
        if self.some && !is_missing(index, self.count) { index } else { NONE }
    }
}

impl ObjPieces {
    /// Reads a file once.
    pub(crate) fn open(mut input: PieceInput, options: &PieceOptions) -> Result<Self, ReadError> {
        input.make_plain_text(options)?;
        let mut writer = ObjTableWriter::new(options)?;
        let mut warnings = Warnings::of_file(&input.name);
        let mut outline =
            read_batches(&input.bytes, &input.source(), &mut warnings, |batch| writer.add(&batch))
                .map_err(|fault| fault.in_file(&input.name))?;
        let (mut tables, mut used) = (writer.tables.finish(options)?, writer.used);
        for (kind, used) in [(1, &mut used.texcoords), (2, &mut used.normals)] {
            let Some((line, reason)) = outline.missing[kind].take() else { continue };
            used.count = used.count.min(outline.counts[kind]);
            let missing = count_missing(&tables.corners, kind, used);
            warn_of_missing(kind, missing, line, reason, &mut warnings);
        }
        if used.normals.some && used.normals.lacking {
            warnings.push(Place::File, "not all faces have normals: the normals are left out");
            used.normals.some = false;
        }
        let count = tables.corners.len() / (3 * CORNER_BYTES);
        check_triangles([tables.positions.len() / 12, count], count, &warnings)?;
        let origin = match options.origin {
            Some(origin) => origin,
            None if outline.has_long_coordinates => origin_near(&tables.positions, 12),
            None => [0.0; 3],
        };
        if origin != [0.0; 3] {
            tables.positions = relative_positions(&input, origin, options)?;
        }
        let mut summary = PieceSummary {
            name: input.name.clone(),
            origin,
            layers: used.layers(),
            triangle_count: count as u64,
            byte_count: input.file_bytes,
            companions: input.companions(),
            warnings: warnings.into_list(),
            ..PieceSummary::default()
        };
        let runs = runs_of(outline, &mut summary);
        Ok(Self { tables, summary, runs, piece_size: options.piece_size(), used })
    }

    fn triangle_count(&self) -> usize {
        self.tables.corners.len() / (3 * CORNER_BYTES)
    }

    fn piece(&self, first: usize) -> Piece {
        let end = self.triangle_count().min(first + self.piece_size);
        let bytes = &self.tables.corners[first * 3 * CORNER_BYTES..end * 3 * CORNER_BYTES];
        let corners = bytes.chunks_exact(CORNER_BYTES).map(|at| self.used.corner_at(at));
        let corners: Vec<[u32; 3]> = corners.collect();
        let mut vertices = corners.clone();
        vertices.sort_unstable();
        vertices.dedup();
        let index = |corner: &[u32; 3]| vertices.partition_point(|vertex| vertex < corner) as u32;
        let triangles = corners.as_chunks::<3>().0.iter().map(|c| [index(&c[0]), index(&c[1]), index(&c[2])]);
        Piece {
            triangles: triangles.collect(),
            positions: vertices.iter().map(|v| floats(&self.tables.positions, v[0])).collect(),
            layers: self.summary.layers.iter().map(|kind| self.layer(kind, &vertices)).collect(),
            triangle_layers: Vec::new(),
            groups: self.groups(first, end),
        }
    }

    fn layer(&self, kind: &LayerKind, vertices: &[[u32; 3]]) -> AttributeLayer {
        let mut values = Vec::with_capacity(vertices.len() * usize::from(kind.component_count));
        for &[position, texcoord, normal] in vertices {
            match kind.semantic {
                Semantic::Normal => values.extend(floats::<3>(&self.tables.normals, normal)),
                Semantic::TexCoord(_) => values.extend(floats::<2>(&self.tables.texcoords, texcoord)),
                _ => values.extend(floats::<3>(&self.tables.colors, position)),
            }
        }
        AttributeLayer::from_f32(kind.semantic.clone(), kind.component_count, values)
    }

    fn groups(&self, first: usize, end: usize) -> Vec<u32> {
        if self.summary.groups.len() < 2 {
            return Vec::new();
        }
        let group_of = |triangle| {
            let after = self.runs.partition_point(|run| run.0 <= triangle);
            after.checked_sub(1).map_or(0, |run| self.runs[run].1)
        };
        (first..end).map(group_of).collect()
    }
}

#[cfg(feature = "blocks")]
impl ObjPieces {
    /// Number of positions.
    pub(crate) fn position_count(&self) -> usize {
        self.tables.positions.len() / 12
    }

    /// Whether a vertex is a position, because there are neither texture coordinates nor normals.
    pub(crate) fn has_positions_only(&self) -> bool {
        self.summary.layers.iter().all(|kind| matches!(kind.semantic, Semantic::Color(_)))
    }

    /// Passes the triangles to `visit`: for each corner its position, texture coordinate and normal.
    pub(crate) fn for_each_triangle<E>(
        &self,
        mut visit: impl FnMut([[u32; 3]; 3]) -> Result<(), E>,
    ) -> Result<(), E> {
        for bytes in self.tables.corners.chunks_exact(3 * CORNER_BYTES) {
            visit([0, 1, 2].map(|k| self.used.corner_at(&bytes[k * CORNER_BYTES..])))?;
        }
        Ok(())
    }

    /// Appends the position and the layers of a corner, little-endian.
    pub(crate) fn push_row(&self, corner: [u32; 3], row: &mut Vec<u8>) {
        row.extend_from_slice(bytemuck::cast_slice(&floats::<3>(&self.tables.positions, corner[0])));
        for kind in &self.summary.layers {
            row.extend_from_slice(self.layer(kind, &[corner]).data.as_bytes());
        }
    }
}

/// Sets the groups and the appearance of the summary; returns the runs of triangles.
fn runs_of(outline: ObjOutline, summary: &mut PieceSummary) -> Vec<(usize, u32)> {
    summary.appearance = outline.appearance;
    let mut known: BTreeMap<(String, Option<u32>), u32> = BTreeMap::new();
    let mut runs = Vec::with_capacity(outline.groups.len());
    for group in outline.groups {
        let next = summary.groups.len() as u32;
        let number = *known.entry((group.name.clone(), group.material)).or_insert(next);
        if number == next {
            summary.groups.push(PieceGroup { name: group.name, material: group.material });
        }
        runs.push((group.first as usize, number));
    }
    if summary.groups.is_empty() {
        summary.groups.push(PieceGroup::default());
    }
    runs
}

/// Counts indices that do not exist, and finds out anew whether some corners have one that does.
fn count_missing(corners: &[u8], kind: usize, used: &mut Usage) -> u64 {
    let mut missing = 0;
    used.some = false;
    for corner in corners.chunks_exact(CORNER_BYTES) {
        let index = words(corner)[kind];
        let is_missing = is_missing(index, used.count);
        missing += u64::from(is_missing);
        used.some |= index != NONE && !is_missing;
        used.lacking |= is_missing;
    }
    missing
}

/// Reads the coordinates of the vertices again, in doubles, and writes them relative to an origin.
fn relative_positions(
    input: &PieceInput,
    origin: [f64; 3],
    options: &PieceOptions,
) -> Result<Mapped, ReadError> {
    let mut spool = Spool::new(options)?;
    visit_coordinates(&input.bytes, |position| {
        spool.write(bytemuck::cast_slice(&relative_position(position, origin)));
    });
    spool.finish(options)
}

/// Numbers of one row of a table; zeros for a row that does not exist.
fn floats<const N: usize>(table: &[u8], row: u32) -> [f32; N] {
    let row = (row as usize).checked_mul(4 * N).and_then(|at| table.get(at..at.checked_add(4 * N)?));
    let number = |at: usize| row.map_or(0.0, |row| f32::from_bits(word(&row[4 * at..])));
    std::array::from_fn(number)
}

fn words(bytes: &[u8]) -> [u32; 3] {
    [0, 4, 8].map(|at| word(&bytes[at..]))
}

fn word(bytes: &[u8]) -> u32 {
    u32::from_le_bytes([bytes[0], bytes[1], bytes[2], bytes[3]])
}

impl ObjTableWriter {
    fn new(options: &PieceOptions) -> Result<Self, ReadError> {
        let spool = || Spool::new(options);
        let tables = ObjTables {
            positions: spool()?,
            colors: spool()?,
            texcoords: spool()?,
            normals: spool()?,
            corners: spool()?,
        };
        Ok(Self { tables, position_count: 0, used: Used::default() })
    }

    fn add(&mut self, batch: &StatementBatch) {
        let tables = &mut self.tables;
        if let Some(colors) = &batch.colors {
            if !self.used.colors {
                // Vertices before the first color are white.
                (0..3 * self.position_count).for_each(|_| tables.colors.write(&1f32.to_le_bytes()));
                self.used.colors = true;
            }
            tables.colors.write(bytemuck::cast_slice(colors));
        }
        tables.positions.write(bytemuck::cast_slice(&batch.positions));
        tables.texcoords.write(bytemuck::cast_slice(&batch.texcoords));
        tables.normals.write(bytemuck::cast_slice(&batch.normals));
        tables.corners.write(bytemuck::cast_slice(&batch.corners));
        self.position_count += batch.positions.len();
        for corner in &batch.corners {
            self.used.texcoords.some |= corner[1] != NONE;
            self.used.normals.some |= corner[2] != NONE;
            self.used.normals.lacking |= corner[2] == NONE;
        }
    }
}

impl Used {
    /// Indices of a corner; those of layers that are left out, or that do not exist, are missing.
    fn corner_at(&self, bytes: &[u8]) -> [u32; 3] {
        let [position, texcoord, normal] = words(bytes);
        [position, self.texcoords.index(texcoord), self.normals.index(normal)]
    }

    fn layers(&self) -> Vec<LayerKind> {
        let kind = |semantic, component_count| LayerKind {
            semantic,
            component_count,
            normalized: false,
            component_type: ComponentType::F32,
        };
        let mut layers = Vec::new();
        if self.normals.some {
            layers.push(kind(Semantic::Normal, 3));
        }
        if self.texcoords.some {
            layers.push(kind(Semantic::TexCoord(0), 2));
        }
        if self.colors {
            layers.push(kind(Semantic::Color(0), 3));
        }
        layers
    }
}

impl ObjTables<Spool> {
    fn finish(self, options: &PieceOptions) -> Result<ObjTables<Mapped>, ReadError> {
        Ok(ObjTables {
            positions: self.positions.finish(options)?,
            colors: self.colors.finish(options)?,
            texcoords: self.texcoords.finish(options)?,
            normals: self.normals.finish(options)?,
            corners: self.corners.finish(options)?,
        })
    }
}

impl PieceSource for ObjPieces {
    fn summary(&self) -> &PieceSummary {
        &self.summary
    }

    fn piece_count(&self) -> u64 {
        self.triangle_count().div_ceil(self.piece_size) as u64
    }

    fn read_piece(&self, index: u64) -> Result<Piece, ReadError> {
        if index >= self.piece_count() {
            let fault = Fault::Malformed(Place::File, format!("piece {index} does not exist"));
            return Err(fault.in_file(&self.summary.name));
        }
        Ok(self.piece(index as usize * self.piece_size))
    }
}
