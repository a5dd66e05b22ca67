//! OBJ in pieces: one pass writes the tables of positions, texture coordinates, normals and corners to
//! temporary files.

use std::collections::BTreeMap;

use striata::mesh::{AttributeLayer, Semantic};

use super::input::{Input, Mapped};
use super::spool::Spool;
use super::{ComponentType, LayerKind, Piece, PieceGroup, PieceOptions, PieceSource, PieceSummary};
use crate::ReadError;
use crate::error::{Fault, Place};
use crate::obj::{Batch, Outline, read_batches};
use crate::report::Warnings;

/// Marks a missing texture coordinate or normal.
const NONE: u32 = u32::MAX;
const CORNER_BYTES: usize = 12;

/// OBJ file whose tables are in temporary files.
pub(crate) struct ObjPieces {
    tables: Tables<Mapped>,
    summary: PieceSummary,
    /// First triangle and group of each run of triangles; no runs if there is one group.
    runs: Vec<(usize, u32)>,
    piece_size: usize,
}

/// Tables of a file.
struct Tables<T> {
    positions: T,
    colors: T,
    texcoords: T,
    normals: T,
    /// Indices of position, texture coordinate and normal.
    corners: T,
}

/// Tables that are being written.
struct Writer {
    tables: Tables<Spool>,
    position_count: usize,
    has_colors: bool,
    /// Whether some corner has a texture coordinate, and whether some have a normal and some have none.
    has_texcoord: bool,
    has_normal: bool,
    lacks_normal: bool,
}

impl ObjPieces {
    /// Reads a file once.
    pub(crate) fn open(input: &Input, options: &PieceOptions) -> Result<Self, ReadError> {
        let mut writer = Writer::new(options)?;
        let mut warnings = Warnings::of_file(&input.name);
        let outline = read_batches(&input.bytes, &input.source(), &mut warnings, |batch| writer.add(&batch))
            .map_err(|fault| fault.in_file(&input.name))?;
        if writer.has_normal && writer.lacks_normal {
            warnings.push(Place::File, "not all faces have normals: the normals are left out");
        }
        let layers = writer.layers();
        let tables = writer.tables.finish(options)?;
        let mut summary = PieceSummary {
            name: input.name.clone(),
            layers,
            triangle_count: (tables.corners.len() / (3 * CORNER_BYTES)) as u64,
            byte_count: input.file_bytes,
            warnings: warnings.into_list().iter().map(ToString::to_string).collect(),
            ..PieceSummary::default()
        };
        let runs = runs_of(outline, &mut summary);
        Ok(Self { tables, summary, runs, piece_size: options.piece_size() })
    }

    /// Whether vertices have texture coordinates and normals.
    fn used(&self) -> (bool, bool) {
        let keeps = |semantic| self.summary.layers.iter().any(|kind| kind.semantic == semantic);
        (keeps(Semantic::TexCoord(0)), keeps(Semantic::Normal))
    }

    fn triangle_count(&self) -> usize {
        self.tables.corners.len() / (3 * CORNER_BYTES)
    }

    fn piece(&self, first: usize) -> Piece {
        let end = self.triangle_count().min(first + self.piece_size);
        let bytes = &self.tables.corners[first * 3 * CORNER_BYTES..end * 3 * CORNER_BYTES];
        let (has_texcoord, has_normal) = self.used();
        let corners = bytes.chunks_exact(CORNER_BYTES).map(|at| corner_at(at, has_texcoord, has_normal));
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
        let (has_texcoord, has_normal) = self.used();
        for bytes in self.tables.corners.chunks_exact(3 * CORNER_BYTES) {
            visit([0, 1, 2].map(|k| corner_at(&bytes[k * CORNER_BYTES..], has_texcoord, has_normal)))?;
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
fn runs_of(outline: Outline, summary: &mut PieceSummary) -> Vec<(usize, u32)> {
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

/// Indices of a corner; those of tables that are not used are left out.
fn corner_at(bytes: &[u8], has_texcoord: bool, has_normal: bool) -> [u32; 3] {
    let [position, texcoord, normal] = words(bytes);
    [position, if has_texcoord { texcoord } else { NONE }, if has_normal { normal } else { NONE }]
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

impl Writer {
    fn new(options: &PieceOptions) -> Result<Self, ReadError> {
        let spool = || Spool::new(options);
        let tables = Tables {
            positions: spool()?,
            colors: spool()?,
            texcoords: spool()?,
            normals: spool()?,
            corners: spool()?,
        };
        let [has_colors, has_texcoord, has_normal, lacks_normal] = [false; 4];
        Ok(Self { tables, position_count: 0, has_colors, has_texcoord, has_normal, lacks_normal })
    }

    fn add(&mut self, batch: &Batch) {
        let tables = &mut self.tables;
        if let Some(colors) = &batch.colors {
            if !self.has_colors {
                // Vertices before the first color are white.
                (0..3 * self.position_count).for_each(|_| tables.colors.write(&1f32.to_le_bytes()));
                self.has_colors = true;
            }
            tables.colors.write(bytemuck::cast_slice(colors));
        }
        tables.positions.write(bytemuck::cast_slice(&batch.positions));
        tables.texcoords.write(bytemuck::cast_slice(&batch.texcoords));
        tables.normals.write(bytemuck::cast_slice(&batch.normals));
        tables.corners.write(bytemuck::cast_slice(&batch.corners));
        self.position_count += batch.positions.len();
        for corner in &batch.corners {
            self.has_texcoord |= corner[1] != NONE;
            self.has_normal |= corner[2] != NONE;
            self.lacks_normal |= corner[2] == NONE;
        }
    }

    fn layers(&self) -> Vec<LayerKind> {
        let kind = |semantic, component_count| LayerKind {
            semantic,
            component_count,
            normalized: false,
            component_type: ComponentType::F32,
        };
        let mut layers = Vec::new();
        if self.has_normal && !self.lacks_normal {
            layers.push(kind(Semantic::Normal, 3));
        }
        if self.has_texcoord {
            layers.push(kind(Semantic::TexCoord(0), 2));
        }
        if self.has_colors {
            layers.push(kind(Semantic::Color(0), 3));
        }
        layers
    }
}

impl Tables<Spool> {
    fn finish(self, options: &PieceOptions) -> Result<Tables<Mapped>, ReadError> {
        Ok(Tables {
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
