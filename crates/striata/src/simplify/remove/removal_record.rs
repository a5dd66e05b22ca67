//! Records removals, and builds the mesh and its fragments in refinement order from them.

use crate::ProgressFn;
use crate::mesh::{Face, Fragment, FragmentSequence, FragmentedMesh, PositionIndex, Welded};
use crate::simplify::certify::{certify_collapses_with_progress, certify_with_progress};
use crate::simplify::collapse::refinement_order::{CollapseRecord, RefinementOrder, build_refinable};
use crate::simplify::options::{SimplifyError, StopReason};

use super::removal_options::BuiltFragments;

/// The steps in order of removal, in the numbering of the welded mesh.
#[derive(Debug, Default)]
pub(super) struct RemovalRecord {
    /// Removed positions.
    pub removed: Vec<u32>,
    /// Indices of the faces around each removed position, step by step.
    pub ceilings: Vec<u32>,
    /// End of each step's range in `ceilings`.
    pub ceiling_ends: Vec<u32>,
    /// End of the range of faces that each step adds.
    pub face_ends: Vec<u32>,
    /// Error of each step's floor, mesh units.
    pub errors: Vec<f32>,
    /// The vertex that each vertex collapses to, if all steps are collapses.
    pub targets: Option<Vec<u32>>,
    /// Whether some step has an empty floor but a ceiling.
    pub has_vanished: bool,
}

/// State at the end of the loop.
pub(super) struct RemovalOutcome {
    pub record: RemovalRecord,
    pub faces: Faces,
    pub stop_reason: StopReason,
}

/// All faces that ever existed, by index, in the numbering of the welded mesh.
pub(super) struct Faces {
    pub corners: Vec<[u32; 3]>,
    pub groups: Vec<u32>,
}

impl RemovalOutcome {
    /// Builds the mesh and its fragments in refinement order.
    pub(super) fn into_fragments(
        self,
        welded: Welded,
        progress: &mut ProgressFn<'_>,
    ) -> Result<BuiltFragments, SimplifyError> {
        self.record.into_fragments(welded, &self.faces, self.stop_reason, progress)
    }
}

impl RemovalRecord {
    /// Adds a step whose ceiling and floor are complete.
    pub(super) fn push(&mut self, removed: u32, error: f32, face_end: u32) {
        self.removed.push(removed);
        self.errors.push(error);
        self.ceiling_ends.push(self.ceilings.len() as u32);
        self.face_ends.push(face_end);
    }

    fn into_fragments(
        self,
        welded: Welded,
        faces: &Faces,
        stop_reason: StopReason,
        progress: &mut ProgressFn<'_>,
    ) -> Result<BuiltFragments, SimplifyError> {
        let order = RefinementOrder::new(&welded.positions, &self.removed);
        let source_vertex = order.vertex_order.iter().map(|&v| welded.source_vertex[v as usize]).collect();
        let face = |face: u32| Face {
            corners: faces.corners[face as usize].map(|v| order.new_index[v as usize]),
            group: faces.groups[face as usize],
        };
        let mut is_gone = vec![false; faces.corners.len()];
        self.ceilings.iter().for_each(|&face| is_gone[face as usize] = true);
        let base = (0..faces.corners.len() as u32).filter(|&f| !is_gone[f as usize]).map(face).collect();
        let fragment = |step: usize| {
            let start = |ends: &[u32], first: u32| if step == 0 { first } else { ends[step - 1] };
            let ceiling = start(&self.ceiling_ends, 0)..self.ceiling_ends[step];
            let floor = start(&self.face_ends, welded.mesh.triangle_count() as u32)..self.face_ends[step];
            Fragment {
                ceiling: self.ceilings[ceiling.start as usize..ceiling.end as usize]
                    .iter()
                    .map(|&f| face(f))
                    .collect(),
                floor: floor.map(face).collect(),
                error: self.errors[step],
            }
        };
        let steps = (0..self.removed.len()).rev().map(fragment);
        let positions = PositionIndex::from_first(order.first.clone());
        let fragments = FragmentSequence::from_fragments(positions, base, steps)?;
        let mesh = welded.mesh.gather(&order.vertex_order, &order.new_index);
        let mut fragmented = FragmentedMesh { mesh, fragments };
        if self.has_vanished {
            // The floor is empty, so the surface that it should have represented is assigned to other faces.
            fragmented = certify_with_progress(&fragmented, progress)?;
        }
        let (degenerate_triangle_count, merged_vertex_count) =
            (welded.degenerate_triangle_count, welded.merged_vertex_count);
        let refinable = match self.targets {
            None => None,
            Some(targets) => {
                let step_count = self.removed.len() as u32;
                let fragments = &fragmented.fragments;
                let mut errors: Vec<f32> =
                    (0..step_count).rev().map(|step| fragments.floor_error(step)).collect();
                for step in 1..errors.len() {
                    errors[step] = errors[step].max(errors[step - 1]);
                }
                let levels = fragments.levels();
                let counts = (0..self.removed.len()).rev();
                let counts = counts.map(|s| levels.triangle_count_at(s + 1) - levels.triangle_count_at(s));
                let removed_triangle_counts = counts.map(|n| n as u8).collect();
                let record = CollapseRecord {
                    removed: self.removed,
                    errors,
                    removed_triangle_counts,
                    targets,
                    costs: Vec::new(),
                };
                let refinable = build_refinable(welded, record)?.0;
                // The errors of a collapse sequence only apply to its levels.
                Some(if self.has_vanished {
                    certify_collapses_with_progress(&refinable, progress)?
                } else {
                    refinable
                })
            }
        };
        Ok(BuiltFragments {
            fragmented,
            refinable,
            source_vertex,
            stop_reason,
            degenerate_triangle_count,
            merged_vertex_count,
        })
    }
}
