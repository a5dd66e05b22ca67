//! From a mesh to its simplification sequence: half-edge collapses ordered by cost.

mod engine;
mod fan;
mod finish;
mod heap;
mod legality;
mod links;
mod options;
mod star;
mod wedges;
mod witness;

pub use options::{
    AttributeWeights, BoundaryRule, BuiltSequence, CollapseCost, Placement, SequenceOptions, Simplified,
    SimplifyError, SimplifyOptions, StopReason, Target,
};

use crate::ProgressFn;
use crate::mesh::{IndexedMesh, Welded, weld};

/// Simplifies a mesh as far as it goes and gives every level on the way.
///
/// # Errors
/// [`SimplifyError`] where the mesh does not hang together, an option is out of range, or the callback cancels.
pub fn build_sequence(
    mesh: &IndexedMesh,
    options: &SequenceOptions,
    progress: &mut ProgressFn<'_>,
) -> Result<BuiltSequence, SimplifyError> {
    build_welded_sequence(weld(mesh)?, options, progress)
}

/// The same for a mesh that is welded already.
///
/// # Errors
/// As [`build_sequence`].
pub fn build_welded_sequence(
    welded: Welded,
    options: &SequenceOptions,
    progress: &mut ProgressFn<'_>,
) -> Result<BuiltSequence, SimplifyError> {
    let (record, stop_reason) = engine::Engine::new(&welded, options).run(progress)?;
    let degenerate_triangle_count = welded.degenerate_triangle_count;
    let merged_vertex_count = welded.merged_vertex_count;
    let (refinable, source_vertex) = finish::finish(welded, record)?;
    Ok(BuiltSequence {
        refinable,
        source_vertex,
        stop_reason,
        degenerate_triangle_count,
        merged_vertex_count,
    })
}
