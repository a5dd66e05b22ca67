//! Strips on their way to a file: spooled to an unnamed file until their number is known.

use std::fs::File;
use std::io::{self, BufWriter, Read, Seek, SeekFrom, Write};
use std::path::Path;

use striata::strip::{RESTART, stitch};

use super::scratch::ScratchFolder;
use super::triangle_blocks::TriangleBlocks;
#[cfg(feature = "gltf")]
use crate::gltf::VertexPieces;
use crate::ply::CopyError;
use crate::{Format, WriteError, write_atomically};

/// Spool that collects the strips of a [`TriangleBlocks`] and writes them to a file with its vertices.
#[derive(Debug)]
pub struct StripSpool {
    format: Format,
    scratch: ScratchFolder,
    indices: BufWriter<File>,
    index_count: u64,
    last: Option<u32>,
}

impl StripSpool {
    /// Creates a spool for a file in this format: PLY, with restarts between strips, or GLB, with strips
    /// joined by degenerate triangles. Temporary files are created in the folder `scratch`.
    ///
    /// # Errors
    /// Returns [`WriteError`] for other formats, or if the temporary file cannot be created.
    pub fn new(format: Format, scratch: &Path) -> Result<Self, WriteError> {
        let is_writable = format == Format::Ply || cfg!(feature = "gltf") && format == Format::Glb;
        if !is_writable {
            let reason = "strips block by block go to PLY or GLB".to_owned();
            return Err(WriteError::Unsupported { file: format.to_string(), format, reason });
        }
        let scratch = ScratchFolder { folder: scratch.to_owned() };
        let file = tempfile::tempfile_in(&scratch.folder).map_err(|error| spool_error(&scratch, error))?;
        let indices = BufWriter::with_capacity(1 << 16, file);
        Ok(Self { format, scratch, indices, index_count: 0, last: None })
    }

    /// Adds a strip.
    ///
    /// # Errors
    /// Returns [`WriteError`] if the temporary file cannot be written.
    pub fn push(&mut self, strip: &[u32]) -> Result<(), WriteError> {
        let (Some(&first), Some(&last)) = (strip.first(), strip.last()) else { return Ok(()) };
        let mut joined: Vec<u32> = Vec::with_capacity(strip.len() + 3);
        match (self.last, self.format) {
            (None, _) => {}
            (Some(_), Format::Ply) => joined.push(RESTART),
            (Some(before), _) => stitch(before, self.index_count % 2 == 1, first, &mut joined),
        }
        joined.extend(strip);
        self.index_count += joined.len() as u64;
        self.last = Some(last);
        self.indices
            .write_all(bytemuck::cast_slice(&joined))
            .map_err(|error| spool_error(&self.scratch, error))
    }

    /// Writes the file completely or not at all, and returns the number of its indices.
    ///
    /// # Errors
    /// Returns [`WriteError`] if the format cannot store the mesh or a file cannot be read or written.
    pub fn write(self, path: &Path, mesh: &TriangleBlocks) -> Result<u64, WriteError> {
        let (format, count, scratch) = (self.format, self.index_count, self.scratch);
        let file = self.indices.into_inner().map_err(|e| spool_error(&scratch, e.into_error()))?;
        let mut spool = IndexSpool { file };
        write_atomically(path, |out| match format {
            #[cfg(feature = "gltf")]
            Format::Glb => write_glb(mesh, count, &mut spool, out),
            _ => write_ply(mesh, count, &mut spool, out),
        })?;
        Ok(count)
    }
}

fn spool_error(scratch: &ScratchFolder, source: io::Error) -> WriteError {
    WriteError::Io { file: scratch.name(), source }
}

/// Indices in a file, four bytes each, in native byte order.
struct IndexSpool {
    file: File,
}

impl IndexSpool {
    /// Passes all indices to `visit`, in pieces.
    fn for_each_piece(&mut self, mut visit: impl FnMut(&[u32]) -> io::Result<()>) -> io::Result<()> {
        self.file.seek(SeekFrom::Start(0))?;
        let mut piece = vec![0u32; 1 << 14];
        loop {
            let bytes: &mut [u8] = bytemuck::cast_slice_mut(&mut piece);
            let mut length = 0;
            while length < bytes.len() {
                match self.file.read(&mut bytes[length..])? {
                    0 => break,
                    more => length += more,
                }
            }
            if length == 0 {
                return Ok(());
            }
            visit(&piece[..length / 4])?;
        }
    }
}

fn write_ply(
    mesh: &TriangleBlocks,
    count: u64,
    spool: &mut IndexSpool,
    out: &mut dyn Write,
) -> io::Result<()> {
    let count = u32::try_from(count)
        .map_err(|_| io::Error::other(format!("a PLY file cannot store a list of {count} indices")))?;
    if mesh.stream.vertex_count > 1 << 31 {
        return Err(io::Error::other("strips in a PLY file cannot refer to more than 2147483648 vertices"));
    }
    mesh.stream.write_strip_header(count, out)?;
    // The restart index is the -1 that separates strips.
    spool.for_each_piece(|indices| {
        indices.iter().try_for_each(|&index| out.write_all(&mesh.stream.u32_bytes(index)))
    })
}

#[cfg(feature = "gltf")]
fn write_glb(
    mesh: &TriangleBlocks,
    count: u64,
    spool: &mut IndexSpool,
    out: &mut dyn Write,
) -> io::Result<()> {
    let refused = |refusal: crate::error::Refusal| match refusal {
        crate::error::Refusal::Unsupported(reason) | crate::error::Refusal::BadMesh(reason) => {
            CopyError::Write(io::Error::other(format!("GLB cannot store this mesh: {reason}")))
        }
    };
    let mut pieces = VertexPieces::default();
    mesh.stream.for_each_row_batch(|_, rows| pieces.add(&mesh.stream.vertices(rows)?).map_err(refused))?;
    pieces.write_head(count, out)?;
    if count == 0 {
        return Ok(());
    }
    for view in 0..pieces.view_count() {
        mesh.stream.for_each_row_batch(|_, rows| {
            let bytes = VertexPieces::view_of(&mesh.stream.vertices(rows)?, view).map_err(refused)?;
            out.write_all(&bytes).map_err(CopyError::Write)
        })?;
    }
    if !pieces.has_short_indices() {
        return spool.for_each_piece(|indices| {
            indices.iter().try_for_each(|&index| out.write_all(&index.to_le_bytes()))
        });
    }
    spool.for_each_piece(|indices| {
        indices.iter().try_for_each(|&index| out.write_all(&(index as u16).to_le_bytes()))
    })?;
    out.write_all(&[0; 2][..if count % 2 == 1 { 2 } else { 0 }])
}
