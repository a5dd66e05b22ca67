//! Normals of primitives that have none, in a scene that has some.

use striata::mesh::IndexedMesh;

use super::assembly::Assembly;
use super::cuts::CutPart;
use super::outline::SceneOutline;
use crate::error::Fault;
use crate::gltf::parts::{GltfDocument, document_fault};
use crate::normals::NormalSums;

/// Number of triangles of a block regardless of the size of the scene.
const ALWAYS_ALLOWED: u64 = 1 << 26;

/// Number of triangles more for each byte of the document and its buffers: as long as none is shown twice at
/// the same place, there are fewer.
const TRIANGLES_PER_INPUT_BYTE: u64 = 1;

/// Computes the normals of all vertices of a block, from the triangles of all of its primitives.
///
/// The triangles are read piece by piece, and nothing else is kept for them but three numbers per vertex.
pub(super) fn block_normals(
    outline: &SceneOutline,
    block: usize,
    document: &GltfDocument<'_>,
    piece_size: usize,
) -> Result<Vec<[f32; 3]>, Fault> {
    let shown = &outline.blocks[block];
    let counts = shown.iter().map(|&shown| outline.triangle_count_of(&outline.shown[shown as usize]));
    let triangle_count = counts.fold(0, u64::saturating_add);
    if triangle_count > ALWAYS_ALLOWED.max(document.input_bytes.saturating_mul(TRIANGLES_PER_INPUT_BYTE)) {
        let reason = format!(
            "{triangle_count} triangles share vertices without normals, too many for a scene of {} bytes",
            document.input_bytes
        );
        return Err(document_fault(reason));
    }
    let vertex_count = Assembly::new(outline, document).claim_vertices(shown[0], size_of::<[f64; 3]>())?;
    let mut sums = NormalSums::of(vertex_count);
    for &shown in shown {
        let count = outline.triangle_count_of(&outline.shown[shown as usize]);
        for first in (0..count).step_by(piece_size) {
            let part =
                CutPart { shown: shown as usize, triangles: first..count.min(first + piece_size as u64) };
            let mut assembly = Assembly::new(outline, document);
            let batch = assembly.add(&[part])?;
            let IndexedMesh { positions, triangles, .. } = &assembly.mesh;
            for &triangle in triangles {
                sums.add_triangle(positions, triangle, &batch.numbers);
            }
        }
    }
    Ok(sums.into_normals())
}
