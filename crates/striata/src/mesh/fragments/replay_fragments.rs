//! Reference extraction from fragments: for each step, its floor is removed and its ceiling added. The
//! tests' oracle.
//!
//! Every model built from fragments must show the same oriented triangles at every level and for every
//! valid set of steps.

use crate::mesh::{IndexedMesh, TriangleGroup};

use super::{Face, FragmentSequence, FragmentedMesh};

/// Computes the faces that are present after a set of steps has been refined, as sorted face indices.
///
/// # Panics
/// If a step is refined without the steps that create the faces of its floor.
pub fn fragment_faces(fragments: &FragmentSequence, mut is_refined: impl FnMut(u32) -> bool) -> Vec<u32> {
    let mut is_present = vec![false; fragments.faces.len()];
    is_present[..fragments.base_face_count()].fill(true);
    for step in 0..fragments.step_count() as u32 {
        if !is_refined(step) {
            continue;
        }
        for &face in fragments.floor(step) {
            assert!(is_present[face as usize], "step {step} is refined before the faces of its floor exist");
            is_present[face as usize] = false;
        }
        for face in fragments.ceiling(step) {
            is_present[face as usize] = true;
        }
    }
    (0..is_present.len() as u32).filter(|&face| is_present[face as usize]).collect()
}

/// Extracts the level of `mesh` after `split_count` steps as a separate mesh.
///
/// Its vertices are a prefix of those of the full mesh; its triangles are sorted by group, and have the data of
/// the triangles of the full mesh at their centroids.
///
/// # Panics
/// If `split_count` exceeds the step count.
pub fn replay_fragments(mesh: &FragmentedMesh, split_count: usize) -> IndexedMesh {
    let FragmentedMesh { mesh: full, fragments } = mesh;
    let vertex_count = fragments.levels().vertex_count_at(split_count);
    let order: Vec<u32> = (0..vertex_count as u32).collect();
    let present = fragment_faces(fragments, |step| (step as usize) < split_count);
    let mut faces: Vec<Face> = present.iter().map(|&face| fragments.faces[face as usize]).collect();
    faces.sort_by_key(|face| face.group);
    let groups = full.groups.iter().enumerate().map(|(group_index, group)| {
        let first = faces.partition_point(|face| (face.group as usize) < group_index);
        let end = faces.partition_point(|face| face.group as usize <= group_index);
        TriangleGroup { first: first as u32, count: (end - first) as u32, ..group.clone() }
    });
    let mut level = IndexedMesh {
        positions: full.positions[..vertex_count].to_vec(),
        origin: full.origin,
        exact_positions: full.exact_positions.iter().take(vertex_count).copied().collect(),
        groups: groups.collect(),
        triangles: faces.iter().map(|face| face.corners).collect(),
        layers: full.layers.iter().map(|layer| layer.gather(&order)).collect(),
        appearance: full.appearance.clone(),
        triangle_layers: Vec::new(),
    };
    level.take_nearest_triangle_layers(full);
    level
}
