//! PLY, ASCII and binary of either byte order.
//!
//! The parser is our own: `ply-rs-bw` builds a map of properties for each vertex (27 MB/s), and its errors
//! give no byte offsets. Here vertices become rows with a fixed layout of little-endian bytes, which for the
//! usual file are the bytes of the file itself; layers are then gathered column by column. Polygons are
//! triangulated as fans while they are read. Cost: one pass, and one copy of the vertices if the file is
//! ASCII, big-endian or has lists.
//!
//! The format does not define the origin of texture coordinates, but Blender, MeshLab, trimesh and
//! photogrammetry programs count `v` from the bottom of the image, as OBJ does. So it becomes `1 - v` when it is
//! read and when it is written (`texcoords`). The images of `comment TextureFile` become materials
//! (`textures`), and the coordinates of faces are split into vertices (`face_textures`).

pub(crate) mod body;
mod column;
pub(crate) mod face_data;
pub(crate) mod face_textures;
pub(crate) mod header;
pub(crate) mod lists;
mod names;
pub(crate) mod rows;
#[cfg(all(feature = "blocks", not(target_family = "wasm")))]
mod stream;
pub(crate) mod texcoords;
pub(crate) mod textures;
pub(crate) mod vertices;
mod write;
mod write_textures;

#[cfg(all(feature = "blocks", not(target_family = "wasm")))]
pub(crate) use stream::{CopyError, PlyStream};
#[cfg(all(feature = "pieces", not(target_family = "wasm")))]
pub(crate) use write::georeference_comment;
pub(crate) use write::to_bytes;
#[cfg(all(feature = "blocks", not(target_family = "wasm")))]
pub(crate) use write::{push_row, vertex_header};

use striata::mesh::IndexedMesh;

use crate::Source;
use crate::error::{Fault, Place};
use crate::report::Warnings;
use crate::text::trimmed;
use crate::texture_set::TextureSet;
use body::{ReadFaces, read_elements};
use face_data::{FaceData, left_out};
use header::{Encoding, Header};
use rows::{AsciiRows, BinaryRows, Rows as _};

/// Reads a mesh from the bytes of a PLY file, and the images that it names from files next to it.
pub(crate) fn read(bytes: &[u8], source: &Source<'_>, warnings: &mut Warnings) -> Result<IndexedMesh, Fault> {
    let mut header = Header::read(bytes)?;
    let mut faces = ReadFaces::default();
    faces.data = FaceData::new(&header, bytes.len());
    let vertices = match header.encoding {
        Encoding::Ascii => {
            let mut rows = AsciiRows::new(bytes, &header, warnings.file());
            let mut vertices = read_elements(&header, &mut rows, &mut faces)?;
            if rows.cursor.has_long_coordinates() {
                // Doubles in a text that declares floats.
                header.widen_coordinates();
                faces = ReadFaces::default();
                faces.data = FaceData::new(&header, bytes.len());
                rows = AsciiRows::new(bytes, &header, warnings.file());
                vertices = read_elements(&header, &mut rows, &mut faces)?;
            }
            warnings.append(rows.warnings);
            warn_of_rest(bytes, rows.cursor.bytes_left(), warnings);
            vertices
        }
        Encoding::LittleEndian => {
            let mut rows = BinaryRows::<false>::new(bytes, header.body_at);
            let vertices = read_elements(&header, &mut rows, &mut faces)?;
            warn_of_rest(bytes, rows.bytes_left(), warnings);
            vertices
        }
        Encoding::BigEndian => {
            let mut rows = BinaryRows::<true>::new(bytes, header.body_at);
            let vertices = read_elements(&header, &mut rows, &mut faces)?;
            warn_of_rest(bytes, rows.bytes_left(), warnings);
            vertices
        }
    };
    let positions = vertices.positions(&header, [0.0; 3])?;
    faces.check_indices(positions.len())?;
    let layers = vertices.layers(&header);
    if !faces.textures.is_empty() {
        faces.pad_textures();
    }
    let (triangle_layers, remarks) =
        std::mem::take(&mut faces.data).into_layers(&header, faces.triangles.len());
    for remark in left_out(&header).into_iter().chain(remarks) {
        warnings.push(Place::File, remark);
    }
    let mut mesh = IndexedMesh { layers, triangle_layers, ..IndexedMesh::new(positions, faces.triangles) };
    if let Some(positions) = vertices.file_positions(&header)? {
        mesh.set_file_positions(positions);
    }
    let comments = &header.texture_files;
    faces.textures.split_vertices(&mut mesh);
    let set = TextureSet::new(source, bytes.len() as u64);
    textures::attach(&mut mesh, comments, faces.textures.numbers(), set, warnings);
    mesh.appearance.georeference = header.georeference;
    Ok(mesh)
}

/// Warns of what follows the last element that the header declares; `left` is its number of bytes.
pub(crate) fn warn_of_rest(bytes: &[u8], left: usize, warnings: &mut Warnings) {
    let at = bytes.len() - left;
    let rest = trimmed(&bytes[at..]).trim_ascii().len();
    if rest > 0 {
        let reason =
            format!("{rest} bytes follow the last element that the header declares; they are left out");
        warnings.push(Place::Byte(at as u64), reason);
    }
}
