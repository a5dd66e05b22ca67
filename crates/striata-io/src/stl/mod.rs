//! STL, binary and ASCII; the reader builds an indexed mesh.
//!
//! STL has no shared vertices: corners with equal coordinates become one vertex, in the order in which they
//! first occur. Normals are dropped, because the triangles imply them; colors of facets are kept
//! (`facet_colors`). Own parser: the binary form is 84 + 50 n bytes, and welding, the main work, is done in
//! the same pass. Cost: O(n) expected time, 4 to 8 bytes of hash table per vertex besides the mesh.

use striata::mesh::{IndexedMesh, Semantic};

use crate::error::{Fault, Place, Refusal};
use crate::format::is_binary_stl;
use crate::normals;
use crate::report::Warnings;
use crate::text::{plain, trimmed};
use crate::{Format, losses};
use facet_colors::{stored, word_to_store};
use text_form::read_ascii;
pub(crate) use vertex_table::VertexTable;

mod facet_colors;
mod text_form;
mod vertex_table;

pub(crate) use facet_colors::{FacetForm, is_exact, word_of};

#[cfg(feature = "pieces")]
pub(crate) use text_form::{Statement, visit_ascii};

pub(crate) const HEADER_BYTES: usize = 84;
pub(crate) const FACET_BYTES: usize = 50;

/// Reads a mesh from the bytes of an STL file.
pub(crate) fn read(bytes: &[u8], warnings: &mut Warnings) -> Result<IndexedMesh, Fault> {
    if is_ascii(bytes) { read_ascii(&plain(bytes), warnings) } else { read_binary(bytes, warnings) }
}

/// Whether a file is ASCII. Its first word says nothing: binary files begin with "solid" too, and texts with
/// remarks. The length decides, then the bytes: text has no control characters.
pub(crate) fn is_ascii(bytes: &[u8]) -> bool {
    if is_binary_stl(bytes) {
        return false;
    }
    let head = &bytes[..bytes.len().min(1024)];
    let head = if head.len() == bytes.len() { trimmed(head) } else { head };
    let is_text = |&b: &u8| b >= b' ' || b.is_ascii_whitespace() || matches!(b, 0x0b | 0x1a);
    let has = |word: &[u8]| head.windows(word.len()).any(|window| window.eq_ignore_ascii_case(word));
    head.iter().all(is_text) && (has(b"solid") || has(b"facet") || has(b"vertex"))
}

/// Returns the number of facets of a binary file, which are all there.
pub(crate) fn facet_count(bytes: &[u8], warnings: &mut Warnings) -> Result<usize, Fault> {
    let Some(count) = bytes.get(80..HEADER_BYTES).and_then(|b| b.first_chunk::<4>()) else {
        let reason = format!("a binary STL begins with {HEADER_BYTES} bytes, found {}", bytes.len());
        return Err(Fault::at_byte(bytes.len(), reason));
    };
    let count = u32::from_le_bytes(*count) as usize;
    let body = &bytes[HEADER_BYTES..];
    if body.len() / FACET_BYTES < count {
        let reason = format!(
            "the header declares {count} triangles, which take {} bytes, found {}",
            count as u64 * FACET_BYTES as u64,
            body.len()
        );
        return Err(Fault::at_byte(80, reason));
    }
    let found = body.len() / FACET_BYTES;
    if count == 0 && found > 0 && body.len().is_multiple_of(FACET_BYTES) && u32::try_from(found).is_ok() {
        // Writers that cannot go back to the header leave zero in it.
        let reason = format!("the header declares no triangles, but {found} follow, which are read");
        warnings.push(Place::Byte(80), reason);
        return Ok(found);
    }
    let used = HEADER_BYTES + count * FACET_BYTES;
    if used < bytes.len() {
        let reason = format!("{} bytes follow the last triangle; they are left out", bytes.len() - used);
        warnings.push(Place::Byte(used as u64), reason);
    }
    Ok(count)
}

fn read_binary(bytes: &[u8], warnings: &mut Warnings) -> Result<IndexedMesh, Fault> {
    let count = facet_count(bytes, warnings)?;
    let body = &bytes[HEADER_BYTES..];
    let mut vertices = VertexTable::with_capacity(count / 2 + 2);
    let mut triangles = Vec::with_capacity(count);
    let mut all_words = 0;
    for facet in body.chunks_exact(FACET_BYTES).take(count) {
        triangles.push([12, 24, 36].map(|at| vertices.vertex(position_at(facet, at))));
        all_words |= word_of(facet);
    }
    let mut mesh = IndexedMesh::new(vertices.positions, triangles);
    if all_words != 0 {
        let words = || body.chunks_exact(FACET_BYTES).take(count).map(word_of);
        if let Some(form) = FacetForm::of(bytes, words()) {
            form.warn(words(), warnings);
            mesh.triangle_layers.push(form.layer(words()));
        }
    }
    Ok(mesh)
}

#[inline]
pub(crate) fn position_at(facet: &[u8], at: usize) -> [f32; 3] {
    [at, at + 4, at + 8].map(|i| f32::from_le_bytes([facet[i], facet[i + 1], facet[i + 2], facet[i + 3]]))
}

/// Encodes a mesh as a binary STL file; positions, triangles and their colors are kept.
pub(crate) fn to_bytes(mesh: &IndexedMesh, warnings: &mut Warnings) -> Result<Vec<u8>, Refusal> {
    // Normals are those of the triangles.
    losses::of_layers(mesh, Format::Stl, |layer| layer.semantic == Semantic::Normal, warnings);
    losses::of_materials(mesh, Format::Stl, warnings);
    losses::of_group_names(mesh, Format::Stl, warnings);
    losses::of_positions(mesh, Format::Stl, warnings);
    let (count, is_far) = (mesh.triangles.len(), mesh.needs_doubles());
    let mut out = Vec::with_capacity(HEADER_BYTES + FACET_BYTES * count);
    let mut header = [b' '; 80];
    // Not "solid", which readers take for ASCII.
    header[..18].copy_from_slice(b"binary STL striata");
    out.extend_from_slice(&header);
    out.extend_from_slice(&(count as u32).to_le_bytes());
    let stored = stored(mesh);
    for (index, &triangle) in mesh.triangles.iter().enumerate() {
        let normal = normals::of_triangle(&mesh.positions, triangle);
        let corners = triangle.map(|v| match is_far {
            true => mesh.file_position(v as usize).map(|x| x as f32),
            false => mesh.positions[v as usize],
        });
        for value in normal.iter().chain(corners.as_flattened()) {
            out.extend_from_slice(&value.to_le_bytes());
        }
        let word = stored.map_or(0, |layer| word_to_store(layer, index));
        out.extend_from_slice(&word.to_le_bytes());
    }
    Ok(out)
}
