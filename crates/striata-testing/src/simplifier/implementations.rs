//! The simplifiers that the guarantees are checked for.

use striata::ProgressFn;
use striata::mesh::{IndexedMesh, replay, replay_fragments};
use striata::simplify::{
    BatchOptions, BuiltFragments, BuiltSequence, HoleCriterion, RemovalOptions, Retriangulation,
    SequenceOptions, SimplifyError, build_batches_with_progress, build_fragments_with_progress,
    build_sequence_with_progress,
};

use super::{Rules, Simplifier, SimplifierOutcome};
use crate::meshes;

impl Simplifier for SequenceOptions {
    fn variants() -> Vec<(String, Self)> {
        meshes::by_cost()
    }

    fn rules(&mut self) -> Rules<'_> {
        Rules {
            base_triangle_count: &mut self.base_triangle_count,
            boundary: &mut self.boundary,
            group_borders: &mut self.group_borders,
            seams: &mut self.seams,
            topology: &mut self.topology,
            locked_vertices: &mut self.locked_vertices,
        }
    }

    fn run(
        &self,
        mesh: &IndexedMesh,
        progress: &mut ProgressFn<'_>,
    ) -> Result<SimplifierOutcome, SimplifyError> {
        let BuiltSequence { refinable, stop_reason, .. } =
            build_sequence_with_progress(mesh, self, progress)?;
        Ok(SimplifierOutcome {
            full: refinable.mesh.clone(),
            levels: refinable.sequence.levels().clone(),
            replay: Box::new(move |split_count| replay(&refinable, split_count)),
            stop_reason,
        })
    }
}

impl Simplifier for BatchOptions {
    fn variants() -> Vec<(String, Self)> {
        vec![("default".to_owned(), Self::default())]
    }

    fn rules(&mut self) -> Rules<'_> {
        Rules {
            base_triangle_count: &mut self.sequence.base_triangle_count,
            boundary: &mut self.sequence.boundary,
            group_borders: &mut self.sequence.group_borders,
            seams: &mut self.sequence.seams,
            topology: &mut self.sequence.topology,
            locked_vertices: &mut self.sequence.locked_vertices,
        }
    }

    fn run(
        &self,
        mesh: &IndexedMesh,
        progress: &mut ProgressFn<'_>,
    ) -> Result<SimplifierOutcome, SimplifyError> {
        let BuiltSequence { refinable, stop_reason, .. } =
            build_batches_with_progress(mesh, self, progress)?.built;
        Ok(SimplifierOutcome {
            full: refinable.mesh.clone(),
            levels: refinable.sequence.levels().clone(),
            replay: Box::new(move |split_count| replay(&refinable, split_count)),
            stop_reason,
        })
    }
}

impl Simplifier for RemovalOptions {
    fn variants() -> Vec<(String, Self)> {
        hole_fillings().map(|(filling, options)| (filling.to_owned(), options)).to_vec()
    }

    fn rules(&mut self) -> Rules<'_> {
        Rules {
            base_triangle_count: &mut self.base_triangle_count,
            boundary: &mut self.boundary,
            group_borders: &mut self.group_borders,
            seams: &mut self.seams,
            topology: &mut self.topology,
            locked_vertices: &mut self.locked_vertices,
        }
    }

    fn run(
        &self,
        mesh: &IndexedMesh,
        progress: &mut ProgressFn<'_>,
    ) -> Result<SimplifierOutcome, SimplifyError> {
        let BuiltFragments { fragmented, stop_reason, .. } =
            build_fragments_with_progress(mesh, self, progress)?;
        Ok(SimplifierOutcome {
            full: fragmented.mesh.clone(),
            levels: fragmented.fragments.levels().clone(),
            replay: Box::new(move |split_count| replay_fragments(&fragmented, split_count)),
            stop_reason,
        })
    }
}

/// All methods of filling holes.
pub fn hole_fillings() -> [(&'static str, RemovalOptions); 4] {
    let free = RemovalOptions::default;
    [
        ("distance", free()),
        ("flatness", free().with_criterion(HoleCriterion::Flatness)),
        ("shape", free().with_criterion(HoleCriterion::Shape)),
        ("collapse", free().with_retriangulation(Retriangulation::Collapse)),
    ]
}
