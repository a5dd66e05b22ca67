//! Entry points of all stripifiers.

use striata::mesh::{DualGraph, IndexedMesh, MeshError};
use striata::strip::{StripLinks, StripSet, join_greedily_with_progress, write_strips};
use striata::{Cancelled, Progress, ProgressFn};

use crate::cache::cheapest_for_cache;
use crate::options::StripOptions;
use crate::stripifier::Stripifier;
use crate::task::{CallerBudget, Reported, SearchLimits, SpentFn, StripTask};
use crate::{cheapest, fewest, stripe, tunnel};

/// Why no strips could be made.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum StripifyError {
    /// The mesh is inconsistent.
    #[error(transparent)]
    Mesh(#[from] MeshError),
    /// The progress callback asked to stop.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
}

/// Covers each triangle of a mesh by exactly one strip. Degenerate triangles (two equal corners) are left
/// out.
///
/// The returned set has the groups of the mesh, or one group if the mesh has none.
///
/// # Errors
/// Returns [`MeshError`] if the mesh is inconsistent.
pub fn stripify(mesh: &IndexedMesh, options: &StripOptions) -> Result<StripSet, MeshError> {
    let allowed = options.allowed_moves(mesh.triangle_count());
    stripify_from(mesh, &StripSet::new(), options, &mut |moves| moves as f64 / allowed.max(1.0))
}

/// Runs [`stripify`] and reports progress, in moves of the search or in triangles; the callback can cancel.
///
/// # Errors
/// See [`stripify`]; also [`StripifyError::Cancelled`] if the callback cancels.
pub fn stripify_with_progress(
    mesh: &IndexedMesh,
    options: &StripOptions,
    progress: &mut ProgressFn<'_>,
) -> Result<StripSet, StripifyError> {
    let allowed = options.allowed_moves(mesh.triangle_count());
    run(mesh, &StripSet::new(), options, &mut Reported::new(progress, allowed))
}

/// Makes strips like [`stripify`], but starts from existing strips and runs until the caller's budget is
/// spent.
///
/// An empty `start` means no strips. Existing strips are cut wherever they do not fit the mesh: at
/// triangles that the mesh does not have, at edges that its dual graph does not link, and, among identical
/// triangles, wherever it is unclear which one the strip meant. The stripifiers that do not search keep
/// what remains and cover the rest.
///
/// # Errors
/// Returns [`MeshError`] if the mesh is inconsistent.
pub fn stripify_from(
    mesh: &IndexedMesh,
    start: &StripSet,
    options: &StripOptions,
    spent: &mut SpentFn<'_>,
) -> Result<StripSet, MeshError> {
    match run(mesh, start, options, &mut CallerBudget(spent)) {
        Ok(strips) => Ok(strips),
        Err(StripifyError::Mesh(error)) => Err(error),
        Err(StripifyError::Cancelled(_)) => unreachable!("a budget never cancels"),
    }
}

fn run(
    mesh: &IndexedMesh,
    start: &StripSet,
    options: &StripOptions,
    limits: &mut dyn SearchLimits,
) -> Result<StripSet, StripifyError> {
    mesh.check()?;
    // A search of a small mesh may end before its first report.
    let _ = limits.report(Progress { phase: "strip", done: 0, total: mesh.triangle_count() as u64 });
    limits.check()?;
    let graph = DualGraph::of_vertices(mesh);
    let groups: Vec<_> = mesh.groups_or_whole().iter().map(|group| group.range()).collect();
    let task = StripTask { triangles: &mesh.triangles, positions: &mesh.positions, groups: &groups, options };
    let mut links = match start.strip_count() {
        0 => StripLinks::new(&graph),
        _ => StripLinks::from_strips(&graph, &mesh.triangles, start),
    };
    links.cut_loops();
    let mut out = StripSet::new();
    match options.stripifier {
        Stripifier::Greedy => {
            join_greedily_with_progress(task.triangles, task.groups, &mut links, &mut |now| {
                limits.report(now)
            })?;
        }
        Stripifier::Stripe { has_patches, swaps } => {
            stripe::run(&task, &mut links, has_patches, swaps, &mut |now| limits.report(now))?;
        }
        Stripifier::Tunnel { max_length } => {
            tunnel::run(&task, &mut links, max_length, &mut |moves| limits.spent(moves));
        }
        Stripifier::Fewest => fewest::run(&task, &graph, &mut links, &mut |moves| limits.spent(moves)),
        Stripifier::Cheapest => cheapest::run(&task, &mut links, limits, &mut out)?,
    }
    limits.check()?;
    debug_assert_eq!(links.clone().cut_loops(), 0, "{} closed a loop", options.stripifier);
    if options.stripifier != Stripifier::Cheapest {
        write_strips(task.triangles, &links, task.groups.iter().cloned(), &mut out);
    }
    if options.cache_weight > 0.0 {
        out = cheapest_for_cache(&task, &links, out, limits)?;
    }
    Ok(out)
}
