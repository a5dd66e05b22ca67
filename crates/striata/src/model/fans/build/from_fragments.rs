//! The history of removals: their faces are the triangles, and the step that replaces a face creates it again.

use super::history::{FanHistory, HistoryTriangle, PERMANENT, StepLinks};
use crate::mesh::{FragmentSequence, FragmentedMesh};

/// Collects the triangles of all levels of a mesh with fragments.
pub(super) fn history(fragmented: &FragmentedMesh) -> FanHistory {
    let FragmentedMesh { fragments, .. } = fragmented;
    let faces = fragments.faces();
    let triangles = faces.iter().zip(fragments.replacing_steps()).map(|(face, replaced_by)| {
        let creator = if replaced_by == FragmentSequence::NO_STEP { PERMANENT } else { replaced_by };
        HistoryTriangle { corners: face.corners, creator, group: face.group }
    });
    let corners_of = |face: u32| faces[face as usize].corners;
    let mut links = StepLinks::default();
    for step in 0..fragments.step_count() as u32 {
        let star = fragments.ceiling(step).flat_map(corners_of);
        let floor = fragments.floor(step).iter().copied().flat_map(corners_of);
        links.note(step, fragments.levels(), star, floor);
    }
    FanHistory::new(triangles.collect(), links, fragments.levels())
}
