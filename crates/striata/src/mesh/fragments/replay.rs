//! The oracle of fragments: each step's faces put in, and those of its floor taken out, one after the other.
//!
//! Every model of fragments must show the same oriented triangles as these at every level and for every set of steps.

use crate::mesh::{IndexedMesh, TriangleGroup};

use super::{Face, FragmentSequence, FragmentedMesh};

/// The faces that are there once some steps are taken, by number.
///
/// # Panics
/// If a step is taken before one that makes a face of its floor.
pub fn fragment_faces(fragments: &FragmentSequence, mut is_taken: impl FnMut(u32) -> bool) -> Vec<u32> {
    let mut is_there = vec![false; fragments.faces.len()];
    is_there[..fragments.base_face_count()].fill(true);
    for step in 0..fragments.step_count() as u32 {
        if !is_taken(step) {
            continue;
        }
        for &face in fragments.floor(step) {
            assert!(is_there[face as usize], "step {step} is taken before what it stands on");
            is_there[face as usize] = false;
        }
        for face in fragments.ceiling(step) {
            is_there[face as usize] = true;
        }
    }
    (0..is_there.len() as u32).filter(|&face| is_there[face as usize]).collect()
}

/// The level of `mesh` after `split_count` steps, as a mesh of its own.
///
/// Vertices are the first so many of the full mesh; triangles come group after group.
///
/// # Panics
/// If `split_count` exceeds the step count.
pub fn replay_fragments(mesh: &FragmentedMesh, split_count: usize) -> IndexedMesh {
    let FragmentedMesh { mesh: full, fragments } = mesh;
    let vertex_count = fragments.levels().vertex_count_at(split_count);
    let order: Vec<u32> = (0..vertex_count as u32).collect();
    let there = fragment_faces(fragments, |step| (step as usize) < split_count);
    let mut faces: Vec<Face> = there.iter().map(|&face| fragments.faces[face as usize]).collect();
    faces.sort_by_key(|face| face.group);
    let groups = full.groups.iter().enumerate().map(|(number, group)| {
        let first = faces.partition_point(|face| (face.group as usize) < number);
        let end = faces.partition_point(|face| face.group as usize <= number);
        TriangleGroup { first: first as u32, count: (end - first) as u32, ..group.clone() }
    });
    IndexedMesh {
        positions: full.positions[..vertex_count].to_vec(),
        groups: groups.collect(),
        triangles: faces.iter().map(|face| face.corners).collect(),
        layers: full.layers.iter().map(|layer| layer.gather(&order)).collect(),
        appearance: full.appearance.clone(),
    }
}
