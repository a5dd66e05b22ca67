//! Places of the faces of a binary PLY file.

use striata::mesh::AttributeLayer;

use super::LayerKind;
use super::local::localize;
use crate::error::Fault;
use crate::ply::body::{ReadFaces, read_faces};
use crate::ply::face_data::FaceData;
use crate::ply::header::{Element, Header, PlyProperty};
use crate::ply::lists::{list_length, skip_property};
use crate::ply::rows::{BinaryRows, Rows};

/// Triangles of a run over its own vertices, with their data.
pub(super) struct FaceRun {
    pub triangles: Vec<[u32; 3]>,
    pub triangle_layers: Vec<AttributeLayer>,
    /// Numbers of the vertices in the file.
    pub vertices: Vec<u32>,
}

/// Faces of a file in runs, with the offset at which each run begins.
#[derive(Clone, Debug)]
pub(super) struct FaceRuns {
    element: Element,
    is_big: bool,
    /// Offset of the first face of each run, and of the byte after the last face.
    starts: Starts,
    vertex_count: usize,
    pub triangle_count: u64,
}

#[derive(Clone, Debug)]
enum Starts {
    /// All rows are triangles of the same size.
    Even { first: usize, row_bytes: usize, faces_per_run: usize },
    /// The offset of each run, the number of its first face, and the end.
    Listed(Vec<(usize, usize)>),
}

/// Facts of the file that are needed to locate the faces.
#[derive(Clone, Copy)]
pub(super) struct FaceOptions {
    pub is_big: bool,
    pub vertex_count: usize,
    pub piece_size: usize,
    /// Whether no other element follows.
    pub is_last: bool,
}

/// Size of a row if its list has three entries; [`None`] if it has other lists.
fn triangle_row_bytes(element: &Element, list: usize) -> Option<usize> {
    let bytes = |(place, property): (usize, &PlyProperty)| match property.list {
        None => Some(property.scalar.bytes()),
        Some(length) if place == list => Some(length.bytes() + 3 * property.scalar.bytes()),
        Some(_) => None,
    };
    element.properties.iter().enumerate().map(bytes).sum()
}

impl FaceRuns {
    /// Finds the runs of the faces that begin at byte `at`; returns also where they end.
    ///
    /// If the rest of the file has exactly the size of triangles, they are taken for such without looking.
    /// Otherwise all faces are visited once.
    pub(super) fn locate(
        bytes: &[u8],
        at: usize,
        element: &Element,
        list: usize,
        options: FaceOptions,
    ) -> Result<(Self, usize), Fault> {
        let FaceOptions { is_big, vertex_count, piece_size, is_last } = options;
        let left = (bytes.len() - at) as u64;
        let even = triangle_row_bytes(element, list)
            .filter(|&row| is_last && row as u64 * element.count as u64 == left && element.count > 0);
        let (starts, triangle_count, end) = match even {
            Some(row_bytes) => {
                let starts = Starts::Even { first: at, row_bytes, faces_per_run: piece_size };
                (starts, element.count as u64, bytes.len())
            }
            None if is_big => listed(&mut BinaryRows::<true>::new(bytes, at), element, list, piece_size)?,
            None => listed(&mut BinaryRows::<false>::new(bytes, at), element, list, piece_size)?,
        };
        Ok((Self { element: element.clone(), is_big, starts, vertex_count, triangle_count }, end))
    }

    pub(super) fn run_count(&self) -> u64 {
        match &self.starts {
            Starts::Even { faces_per_run, .. } => self.element.count.div_ceil(*faces_per_run) as u64,
            Starts::Listed(starts) => starts.len() as u64 - 1,
        }
    }

    /// Layers of the triangles, without values.
    pub(super) fn layer_kinds(&self, header: &Header) -> Vec<LayerKind> {
        let mut data = FaceData::new(header, 0);
        data.begin(&self.element, 0);
        data.into_layers(header, 0).0.iter().map(LayerKind::of).collect()
    }

    /// Reads a run.
    pub(super) fn read(&self, bytes: &[u8], run: usize, header: &Header) -> Result<FaceRun, Fault> {
        let (start, end, face_count) = match &self.starts {
            Starts::Even { first, row_bytes, faces_per_run } => {
                let face = run * faces_per_run;
                let count = (*faces_per_run).min(self.element.count - face);
                (first + face * row_bytes, first + (face + count) * row_bytes, count)
            }
            Starts::Listed(starts) => {
                let ((start, first), (end, last)) = (starts[run], starts[run + 1]);
                (start, end, last - first)
            }
        };
        let element = Element { count: face_count, ..self.element.clone() };
        let mut faces = ReadFaces::default();
        faces.data = FaceData::new(header, bytes.len());
        // Rows past the end would belong to the next run: a face that is too long is found there.
        let bytes = &bytes[..end];
        let stopped = if self.is_big {
            let mut rows = BinaryRows::<true>::new(bytes, start);
            read_faces(&element, &mut rows, &mut faces, self.vertex_count).map(|()| rows.at())
        } else {
            let mut rows = BinaryRows::<false>::new(bytes, start);
            read_faces(&element, &mut rows, &mut faces, self.vertex_count).map(|()| rows.at())
        };
        faces.check_indices(self.vertex_count)?;
        if stopped? != end {
            let reason = "the size of the file is that of triangles, but not all faces are triangles";
            return Err(Fault::at_byte(start, reason));
        }
        let mut triangles = faces.triangles;
        let (triangle_layers, _) = faces.data.into_layers(header, triangles.len());
        let vertices = localize(&mut triangles);
        Ok(FaceRun { triangles, triangle_layers, vertices })
    }
}

/// Visits all faces: returns where runs begin, the number of triangles, and the end.
fn listed<'a, const BIG: bool>(
    rows: &mut BinaryRows<'a, BIG>,
    element: &Element,
    list: usize,
    piece_size: usize,
) -> Result<(Starts, u64, usize), Fault> {
    let (mut starts, mut in_run, mut total) = (vec![(rows.at(), 0)], 0, 0u64);
    for face in 0..element.count {
        if in_run >= piece_size {
            starts.push((rows.at(), face));
            in_run = 0;
        }
        for (place, property) in element.properties.iter().enumerate() {
            match property.list.filter(|_| place == list) {
                Some(length) => {
                    let length = list_length(length, rows)?;
                    rows.skip(property.scalar, length)?;
                    in_run += length.saturating_sub(2);
                    total += length.saturating_sub(2) as u64;
                }
                None => skip_property(property, rows)?,
            }
        }
    }
    if element.count > 0 {
        starts.push((rows.at(), element.count));
    }
    Ok((Starts::Listed(starts), total, rows.at()))
}
