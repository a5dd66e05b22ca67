//! Normals of primitives that have none, in a scene that has some.

use striata::mesh::IndexedMesh;

use super::assembly::Assembly;
use super::cuts::Part;
use super::outline::Outline;
use crate::error::Fault;
use crate::gltf::parts::Document;
use crate::normals::NormalSums;

/// Computes the normals of all vertices of a block, from the triangles of all of its primitives.
///
/// The triangles are read piece by piece, and nothing else is kept for them but three numbers per vertex.
pub(super) fn block_normals(
    outline: &Outline,
    block: usize,
    (document, piece_size): (&Document<'_>, usize),
) -> Result<Vec<[f32; 3]>, Fault> {
    let shown = &outline.blocks[block];
    let vertex_count = Assembly::new(outline, document).claim_vertices(shown[0], size_of::<[f64; 3]>())?;
    let mut sums = NormalSums::of(vertex_count);
    for &shown in shown {
        let count = outline.triangle_count(&outline.shown[shown as usize]);
        for first in (0..count).step_by(piece_size) {
            let part = Part { shown: shown as usize, triangles: first..count.min(first + piece_size as u64) };
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
