//! Fits a finished level to the original: its triangles stay, its vertices move.
//!
//! This is the inner problem of mesh optimization \[HDD+93, 4.1\]. Sample points of either surface are paired
//! with the nearest point of the other that faces the same side (`pairs`). The distance of a pair along the
//! normal of the level's triangle is linear in the positions of its corners, and the difference of an
//! attribute is linear in its values there, so both are sparse least-squares problems (`positions`, `layers`).
//! Boundaries, seams of texture coordinates and borders between materials have pairs of their own, across which
//! they must not slide. Pairs are found again after every move.
//!
//! A surface with its vertices on a smooth original lies on one side of it. Fitting removes the mean of that
//! distance, which is more than half of it: the level stays as it is otherwise, seams, materials and the
//! order of triangles included.
//!
//! Differs: the regularizing spring between neighbors is a resistance to moving at all, and distances are
//! measured along normals, which converges in two moves instead of dozens. Cost: O(n log n) for n triangles
//! of the original.

mod corner_forms;
mod layers;
mod measure;
mod pairs;
mod positions;
mod surface;

use crate::mesh::{IndexedMesh, index_positions, weld};
use crate::simplify::options::{SequenceOptions, Simplified, SimplifyError};
use crate::{Progress, ProgressFn, ignore_progress};
use measure::measured_error;
use pairs::Pairing;
use positions::{Constraints, LevelPositions};

/// Number of times that vertices move.
const MOVES: u64 = 2;
/// Number of times that corners of triangles that are farther away than before move back.
const RETURNS: usize = 4;
/// Number of times that a level beyond the error limit is replaced by a finer one before the full mesh is.
const MAX_RETRIES: usize = 8;
/// Share of the diagonal that rounding to single precision may add to a distance.
const NOISE: f64 = 1e-6;

/// Moves the vertices of a level so that it lies as close to the original as its triangles allow.
///
/// Positions, normals, tangents, texture coordinates, colors and other numbers are fitted by least squares;
/// joints, weights, morph targets and identifiers stay as they are. Vertices that the options lock stay, and
/// if triangles of a height field must not turn over, positions move along z only. The error of the result is
/// the largest distance between sampled points of one mesh and the other, measured both ways, mesh units.
///
/// # Errors
/// [`SimplifyError`] if a mesh is inconsistent.
///
/// # Example
/// ```
/// use striata::mesh::{DistanceOptions, shapes, surface_distance};
/// use striata::simplify::{SimplifyOptions, SequenceOptions, Target, fit_level, simplify};
///
/// let torus = shapes::torus(64, 32, 1.0, 0.4);
/// let level = simplify(&torus, &SimplifyOptions::default().with_target(Target::Triangles(400)))?;
/// let fitted = fit_level(&torus, level.clone(), &SequenceOptions::default())?;
/// let rms = |level| surface_distance(&torus, level, &DistanceOptions::default()).map(|distance| distance.rms);
/// assert!(rms(&fitted.mesh)? < 0.7 * rms(&level.mesh)?);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn fit_level(
    original: &IndexedMesh,
    level: Simplified,
    options: &SequenceOptions,
) -> Result<Simplified, SimplifyError> {
    fit_level_with_progress(original, level, options, &mut ignore_progress)
}

/// Fits the coarsest level whose measured error does not exceed `max_error`, mesh units.
///
/// `level_within` returns the level for a limit of the estimated error, which shrinks until the fitted level is
/// within `max_error`; 0 means the full mesh.
///
/// # Errors
/// See [`fit_level_with_progress`].
pub fn fit_within(
    original: &IndexedMesh,
    mut level_within: impl FnMut(f64) -> Simplified,
    options: &SequenceOptions,
    max_error: f64,
    progress: &mut ProgressFn<'_>,
) -> Result<Simplified, SimplifyError> {
    let noise = NOISE * original.diagonal();
    let mut limit = max_error;
    for retry in 0.. {
        let level = level_within(limit);
        let estimate = level.error;
        let fitted = fit_level_with_progress(original, level, options, progress)?;
        if fitted.error <= max_error + noise || limit == 0.0 {
            return Ok(Simplified { error: fitted.error.min(max_error), ..fitted });
        }
        let smaller = estimate.min(limit) * (0.9 * max_error / fitted.error);
        limit = if retry < MAX_RETRIES { smaller } else { 0.0 };
    }
    unreachable!("a limit of 0 ends the loop")
}

/// Runs [`fit_level`] and reports progress; the callback can cancel.
///
/// # Errors
/// See [`fit_level`]; also [`SimplifyError::Cancelled`] if the callback cancels.
pub fn fit_level_with_progress(
    original: &IndexedMesh,
    level: Simplified,
    options: &SequenceOptions,
    progress: &mut ProgressFn<'_>,
) -> Result<Simplified, SimplifyError> {
    options.check_locked(original.vertex_count())?;
    original.check()?;
    level.mesh.check()?;
    if level.mesh.triangles.is_empty() || level.mesh.triangle_count() == original.triangle_count() {
        return Ok(level);
    }
    let mut report = |done| Progress { phase: "fit", done, total: MOVES + 2 }.report(progress);
    let mut fitted = level.mesh.clone();
    let constraints = Constraints::new(original, options);
    let welded;
    let original = if has_degenerate_triangles(original) {
        welded = weld(original)?.mesh;
        &welded
    } else {
        original
    };
    let mut places = LevelPositions::of(&fitted);
    let mut pairing = Pairing::new(original, &fitted, &places.adjacency)?;
    let mut pairs = pairing.pairs(&fitted);
    let before = pairing.distances(&pairs);
    for done in 0..MOVES {
        report(done)?;
        positions::move_vertices(&mut fitted, &mut places, &pairs, &constraints);
        pairs = pairing.pairs(&fitted);
    }
    report(MOVES)?;
    let noise = NOISE * original.diagonal();
    for _ in 0..RETURNS {
        let is_worse = pairing.distances(&pairs).worse_than(&before, noise);
        if !is_worse.contains(&true) {
            break;
        }
        move_back(&mut fitted, &level.mesh, &is_worse);
        pairs = pairing.pairs(&fitted);
    }
    if pairing.distances(&pairs).mean_square() > before.mean_square() + noise * noise {
        // Parts that have folded flat may have no useful pairs.
        fitted.positions.clone_from(&level.mesh.positions);
        pairs = pairing.pairs(&fitted);
    }
    for v in 0..fitted.exact_positions.len() {
        if fitted.positions[v] != level.mesh.positions[v] {
            let moved = fitted.in_file(fitted.positions[v]);
            fitted.exact_positions[v] = moved;
        }
    }
    layers::fit_layers(&mut fitted, &pairs, original);
    report(MOVES + 1)?;
    let error = measured_error(&pairing.original, &pairing.level, &pairs.of_surfaces);
    Ok(Simplified { mesh: fitted, error, ..level })
}

/// Moves the corners of some triangles back to where they were, and all vertices at the same positions.
fn move_back(fitted: &mut IndexedMesh, level: &IndexedMesh, is_chosen: &[bool]) {
    let position_of = index_positions(&level.positions);
    let mut returns = vec![false; position_of.len()];
    for (triangle, _) in level.triangles.iter().zip(is_chosen).filter(|(_, is_chosen)| **is_chosen) {
        triangle.iter().for_each(|&v| returns[position_of[v as usize] as usize] = true);
    }
    for (v, position) in fitted.positions.iter_mut().enumerate() {
        if returns[position_of[v] as usize] {
            *position = level.positions[v];
        }
    }
}

/// Whether two corners of a triangle share a position.
fn has_degenerate_triangles(mesh: &IndexedMesh) -> bool {
    let is_degenerate = |t: &[u32; 3]| {
        let [a, b, c] = t.map(|v| mesh.positions[v as usize]);
        a == b || b == c || c == a
    };
    mesh.triangles.iter().any(is_degenerate)
}
