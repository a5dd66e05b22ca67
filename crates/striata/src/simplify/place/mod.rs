//! Free placement: a sequence of edge collapses with optimal positions of the new vertices.
//!
//! The cost of an edge is the squared distance of its new vertex from the planes of the *current*
//! triangles around both ends, weighted by area; the new position minimizes it while preserving the
//! volume [LT98], [Hop99]. No history is kept, so errors do not add up to a bias, and preserving the
//! volume keeps the surface from shrinking. Vertices move at every step, so every moved vertex is a new one
//! of the sequence (`placed_fragments`).
//!
//! ```text
//!     r1 --- r2                r1 --- r2
//!    /  \   /  \              /   \  /   \      A half-edge collapse v -> u in the links,
//!   s -- u v -- r3     ->    s --- x --- r3     then u moves to x. Links and legality tests
//!    \  /   \  /              \   /  \   /      are those of placement on a subset.
//!     r5 --- r4                r5 --- r4
//! ```
//!
//! The queue contains the cheapest edge of each position, by the quadratic form alone; flips, links,
//! seams and the distance of the old vertices from the new triangles are tested when it reaches the
//! top. If an edge has changed, the end that was evaluated last has its current cost, so the order is
//! strictly by cost although the other end may still have an older one.
//!
//! Borders (boundaries, edges with three triangles, seams that must stay) are preserved: a vertex on a
//! border is merged only along it, an inner vertex is merged into it without moving it, and vertices at
//! which borders meet or end stay in place. Seams that may be crossed do not count as borders; leaving
//! their path and crossing them adds to the cost (`seams`).
//!
//! A position without any such collapse gets a **relaxed** one, unless the topology must be preserved:
//! the half-edge collapse that subset placement would choose, with its target unmoved, so that every
//! target is reached. Both kinds share one queue, since both costs are squared distances over areas.
//!
//! Links, wedges and positions are those of a `CostEvaluator`, which represents the current mesh in
//! single precision.
//!
//! Differs: the cost is always memoryless, attributes count only at seams and in relaxed collapses, and
//! pairs without an edge are never merged. Time O(n log n), about 400 bytes per vertex.

mod blend;
mod merger;
mod neighborhood;
mod placed_fragments;
mod quadratic_form;
mod seams;

use crate::mesh::{FragmentedMesh, IndexedMesh, Welded, weld};
use crate::setters::setters;
use crate::simplify::certify::certify_with_progress;
use crate::simplify::options::{SequenceOptions, SimplifyError, StopReason, check_locked};
use crate::{ProgressFn, ignore_progress};
use merger::Merger;
use placed_fragments::{PlacedMesh, build_placed, steps_of};

/// Part of a mesh that a step collapses to one new vertex.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum PlacedCollapse {
    /// An edge: two vertices become one.
    #[default]
    Edge,
    /// A triangle: three vertices become one. If the third vertex cannot follow, or costs far more than other
    /// collapses, only an edge is collapsed.
    Triangle,
}

/// Options of [`build_placed_fragments`](crate::simplify::build_placed_fragments).
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct PlacedOptions {
    /// Part that a step collapses; default [`PlacedCollapse::Edge`].
    pub collapse: PlacedCollapse,
    /// Rules and limits. The cost is always memoryless, and `pair_distance` must be `None`. The error limit
    /// is one on certified errors: coarser levels are left out.
    pub sequence: SequenceOptions,
}

impl PlacedOptions {
    setters! {
        with_collapse, collapse: PlacedCollapse;
        with_sequence, sequence: SequenceOptions;
    }
}

/// Result of [`build_placed_fragments`](crate::simplify::build_placed_fragments).
#[derive(Clone, Debug)]
pub struct BuiltPlaced {
    /// The mesh in refinement order, with its steps. Vertices that a collapse creates come before those that
    /// it removes; the full mesh does not use them.
    pub fragmented: FragmentedMesh,
    /// For each vertex, the vertex of the input that it came from; `None` if a collapse created it.
    pub source_vertex: Vec<Option<u32>>,
    /// Why the sequence stops at its base mesh.
    pub stop_reason: StopReason,
    /// Number of input triangles that were dropped because two of their corners share a position.
    pub degenerate_triangle_count: usize,
    /// Number of input vertices that were merged into equal ones.
    pub merged_vertex_count: usize,
}

fn check_no_pairs(options: &SequenceOptions) -> Result<(), SimplifyError> {
    let Some(distance) = options.pair_distance else { return Ok(()) };
    let expected = "none with optimal placement";
    Err(SimplifyError::Option { option: "pair_distance", value: distance.to_string(), expected })
}

/// Collapses edges or triangles to new vertices as far as the options allow, and returns the sequence of all
/// levels on the way, with certified errors.
///
/// No vertex moves, and every level uses a prefix of the vertices, as in other sequences; but the new
/// vertices are stored in addition to those of the full mesh, about as many again. Levels are closer to
/// the original than those that use its vertices only. The steps are neither half-edge collapses nor
/// removals of single positions, so they need a model that takes any fragments:
/// [`Patterns`](crate::model::Patterns).
///
/// # Errors
/// [`SimplifyError`] if the mesh is invalid or an option is out of range.
///
/// # Example
/// ```
/// use striata::mesh::{replay_fragments, shapes};
/// use striata::model::Patterns;
/// use striata::simplify::{PlacedOptions, build_placed_fragments};
///
/// let torus = shapes::torus(32, 16, 1.0, 0.4);
/// let built = build_placed_fragments(&torus, &PlacedOptions::default())?;
/// let level = built.fragmented.fragments.levels().split_count_for_triangles(200);
/// println!("{} triangles", replay_fragments(&built.fragmented, level).triangle_count());
/// let patterns = Patterns::build(&built.fragmented)?;
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn build_placed_fragments(
    mesh: &IndexedMesh,
    options: &PlacedOptions,
) -> Result<BuiltPlaced, SimplifyError> {
    build_placed_fragments_with_progress(mesh, options, &mut ignore_progress)
}

/// Runs [`build_placed_fragments`] and reports progress; the callback can cancel.
///
/// # Errors
/// See [`build_placed_fragments`]; also [`SimplifyError::Cancelled`] if the callback cancels.
pub fn build_placed_fragments_with_progress(
    mesh: &IndexedMesh,
    options: &PlacedOptions,
    progress: &mut ProgressFn<'_>,
) -> Result<BuiltPlaced, SimplifyError> {
    options.sequence.check()?;
    check_locked(&options.sequence.locked_vertices, mesh.vertex_count())?;
    build_welded_placed_fragments_with_progress(weld(mesh)?, options, progress)
}

/// Collapses a mesh that is already welded; see [`build_placed_fragments`]. The callback reports progress and
/// can cancel.
///
/// # Errors
/// See [`build_placed_fragments_with_progress`].
pub fn build_welded_placed_fragments_with_progress(
    welded: Welded,
    options: &PlacedOptions,
    progress: &mut ProgressFn<'_>,
) -> Result<BuiltPlaced, SimplifyError> {
    options.sequence.check()?;
    check_no_pairs(&options.sequence)?;
    let mut merger =
        Merger::new(&welded, &options.sequence).with_log(options.collapse == PlacedCollapse::Triangle);
    // The error limit applies to certified errors, which are known when all steps are.
    let mut stop_reason = merger.run(options.sequence.base_triangle_count, progress)?;
    let (Some(log), targets) = merger.into_log() else { unreachable!("the merger was created with a log") };
    let step_count = steps_of(&log).count();
    let PlacedMesh { mut fragmented, mut rows } = build_placed(&welded, &log, &targets, step_count)?;
    fragmented = certify_with_progress(&fragmented, progress)?;
    let limit = options.sequence.max_error.unwrap_or(f64::INFINITY);
    let beyond = fragmented.fragments.levels().split_count_for_error(limit);
    if beyond > 0 {
        stop_reason = StopReason::ErrorLimit;
        PlacedMesh { fragmented, rows } = build_placed(&welded, &log, &targets, step_count - beyond)?;
        fragmented = certify_with_progress(&fragmented, progress)?;
    }
    let source = |&row: &u32| welded.source_vertex.get(row as usize).copied();
    Ok(BuiltPlaced {
        fragmented,
        source_vertex: rows.iter().map(source).collect(),
        stop_reason,
        degenerate_triangle_count: welded.degenerate_triangle_count,
        merged_vertex_count: welded.merged_vertex_count,
    })
}
