//! The second simplifier: vertices are removed one by one, and each hole is filled in the best of all ways.
//!
//! After \[KLS96\], \[KK97\] and \[KG98\].

mod collapses;
mod engine;
mod hole;
mod judge;
mod options;
mod points;
mod record;

pub use options::{BuiltFragments, HoleCriterion, RemovalOptions, Retriangulation};

use crate::ProgressFn;
use crate::mesh::{IndexedMesh, Welded, weld};

use super::options::{SimplifyError, check_locked};

/// Removes vertices as far as it goes, and gives every level on the way.
///
/// # Errors
/// [`SimplifyError`] where the mesh does not hang together, an option is out of range, or the callback cancels.
pub fn build_fragments(
    mesh: &IndexedMesh,
    options: &RemovalOptions,
    progress: &mut ProgressFn<'_>,
) -> Result<BuiltFragments, SimplifyError> {
    options.check()?;
    check_locked(&options.locked_vertices, mesh.vertex_count())?;
    build_welded_fragments(weld(mesh)?, options, progress)
}

/// The same for a mesh that is welded already.
///
/// # Errors
/// As [`build_fragments`].
pub fn build_welded_fragments(
    welded: Welded,
    options: &RemovalOptions,
    progress: &mut ProgressFn<'_>,
) -> Result<BuiltFragments, SimplifyError> {
    options.check()?;
    let (record, faces, stop_reason) = engine::Engine::new(&welded, options).run(progress)?;
    record.finish(welded, &faces, stop_reason)
}
