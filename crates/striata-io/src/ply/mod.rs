//! PLY, ascii and binary of either byte order.
//!
//! A parser of our own: `ply-rs-bw` gives each vertex as a map of properties (27 MB/s), and its errors name
//! no byte. Vertices become rows of one fixed layout in little-endian bytes, which for the usual file
//! are the bytes of the file itself; layers are then gathered column by column. Polygons are fanned as they are
//! read. Cost: one pass, and one copy of the vertices where the file is ascii, big-endian or has lists.
//!
//! Texture coordinates are kept as they are: the format does not say where their origin is.

mod body;
mod column;
mod header;
mod names;
mod rows;
#[cfg(all(feature = "blocks", not(target_family = "wasm")))]
mod stream;
mod write;

#[cfg(all(feature = "blocks", not(target_family = "wasm")))]
pub(crate) use stream::{PlyStream, Stopped};
pub(crate) use write::to_bytes;

use striata::mesh::IndexedMesh;

use crate::error::Fault;
use crate::text::Cursor;
use body::{Faces, read_elements};
use header::{Encoding, Header};
use rows::{AsciiRows, BinaryRows};

pub(crate) fn read(bytes: &[u8]) -> Result<IndexedMesh, Fault> {
    let header = Header::read(bytes)?;
    let mut faces = Faces::default();
    let vertices = match header.encoding {
        Encoding::Ascii => {
            let cursor = Cursor::starting_at(bytes, header.body_at, header.body_line);
            read_elements(&header, &mut AsciiRows(cursor), &mut faces)?
        }
        Encoding::LittleEndian => {
            read_elements(&header, &mut BinaryRows::<false>::new(bytes, header.body_at), &mut faces)?
        }
        Encoding::BigEndian => {
            read_elements(&header, &mut BinaryRows::<true>::new(bytes, header.body_at), &mut faces)?
        }
    };
    let positions = vertices.positions(&header)?;
    faces.check_indices(positions.len())?;
    let layers = vertices.layers(&header);
    Ok(IndexedMesh { layers, ..IndexedMesh::new(positions, faces.triangles) })
}
