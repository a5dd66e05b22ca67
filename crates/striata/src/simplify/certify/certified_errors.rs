//! Certified errors of finished sequences.

use crate::mesh::{CollapseSequence, Face, FragmentSequence, FragmentedMesh, RefinableMesh, SequenceParts};
use crate::{Cancelled, Progress, ProgressFn, ignore_progress};

use super::Cover;
use super::substitutes::SubstituteFinder;

/// Steps between two calls of the progress callback.
const STEPS_PER_REPORT: usize = 1 << 10;

/// Returns the fragments with certified errors.
///
/// In any state of selective refinement, the distance of the original surface from the active faces is
/// at most the largest error of the floors to which they belong; at a level, it is at most the error of
/// the level. This holds for all points of the original surface, not only its vertices, but says
/// nothing about the opposite distance. An unapplied step with an empty floor counts as well. If
/// nothing is left at all, the error is the diagonal of the mesh's bounds.
///
/// # Example
/// ```
/// use striata::mesh::{FragmentedMesh, shapes};
/// use striata::simplify::{SequenceOptions, build_sequence, certify};
///
/// let built = build_sequence(&shapes::torus(32, 16, 1.0, 0.4), &SequenceOptions::default())?;
/// let fragmented = FragmentedMesh::from_collapses(&built.refinable);
/// let certain = certify(&fragmented);
/// let levels = certain.fragments.levels();
/// let level = levels.split_count_for_triangles(200);
/// println!("no point of the torus is more than {} away", levels.error_at(level));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn certify(mesh: &FragmentedMesh) -> FragmentedMesh {
    certify_with_progress(mesh, &mut ignore_progress).expect("the default callback never cancels")
}

/// Runs [`certify`] and reports progress; the callback can cancel.
///
/// # Errors
/// [`Cancelled`] if the callback cancels.
pub fn certify_with_progress(
    mesh: &FragmentedMesh,
    progress: &mut ProgressFn<'_>,
) -> Result<FragmentedMesh, Cancelled> {
    let errors = floor_errors(mesh, Scope::All, progress)?;
    let fragments = mesh.fragments.with_floor_errors(errors).expect("one finite error per step");
    Ok(FragmentedMesh { mesh: mesh.mesh.clone(), fragments })
}

/// Fragments with certified errors for their floors and for each face.
#[derive(Clone, Debug)]
pub struct CertifiedFaces {
    /// The fragments with certified errors of their floors, as [`certify`] returns them.
    pub fragmented: FragmentedMesh,
    /// The error of each face, mesh units: how far what the face stands for is from it. 0 for faces of the
    /// full mesh.
    pub face_errors: Vec<f32>,
}

/// Returns the fragments with certified errors, also of single faces.
///
/// The error of a floor is the largest error of its faces. A state of selective refinement that takes the
/// errors of its faces into account is therefore coarser than one for the same error that only knows floors.
pub fn certify_faces(mesh: &FragmentedMesh) -> CertifiedFaces {
    certify_faces_with_progress(mesh, &mut ignore_progress).expect("the default callback never cancels")
}

/// Runs [`certify_faces`] and reports progress; the callback can cancel.
///
/// # Errors
/// [`Cancelled`] if the callback cancels.
pub fn certify_faces_with_progress(
    mesh: &FragmentedMesh,
    progress: &mut ProgressFn<'_>,
) -> Result<CertifiedFaces, Cancelled> {
    let mut face_errors = vec![0.0; mesh.fragments.faces().len()];
    let errors = walk_errors(mesh, Scope::All, progress, |walk, step| {
        for (index, &face) in mesh.fragments.floor(step).iter().enumerate() {
            face_errors[face as usize] = rounded_up(walk.cover.face_bound(index));
        }
    })?;
    let fragments = mesh.fragments.with_floor_errors(errors).expect("one finite error per step");
    Ok(CertifiedFaces { fragmented: FragmentedMesh { mesh: mesh.mesh.clone(), fragments }, face_errors })
}

/// Returns the collapse sequence with certified errors for its levels: the distance of the original
/// surface from a level is at most the level's error.
///
/// The errors hold for levels only, not for other states of selective refinement. They may therefore be
/// lower than those of [`certify`] and [`certify_collapses_in_any_state`].
pub fn certify_collapses(refinable: &RefinableMesh) -> RefinableMesh {
    certify_collapses_with_progress(refinable, &mut ignore_progress)
        .expect("the default callback never cancels")
}

/// Runs [`certify_collapses`] and reports progress; the callback can cancel.
///
/// # Errors
/// [`Cancelled`] if the callback cancels.
pub fn certify_collapses_with_progress(
    refinable: &RefinableMesh,
    progress: &mut ProgressFn<'_>,
) -> Result<RefinableMesh, Cancelled> {
    certified_collapses(refinable, Scope::Levels, progress)
}

/// Returns the collapse sequence with errors certified for any state of selective refinement, as those
/// of [`certify`] are: for view-dependent models.
///
/// The distance of the original surface from the active triangles is at most the error of the coarsest
/// step that is not applied.
pub fn certify_collapses_in_any_state(refinable: &RefinableMesh) -> RefinableMesh {
    certify_collapses_in_any_state_with_progress(refinable, &mut ignore_progress)
        .expect("the default callback never cancels")
}

/// Runs [`certify_collapses_in_any_state`] and reports progress; the callback can cancel.
///
/// # Errors
/// [`Cancelled`] if the callback cancels.
pub fn certify_collapses_in_any_state_with_progress(
    refinable: &RefinableMesh,
    progress: &mut ProgressFn<'_>,
) -> Result<RefinableMesh, Cancelled> {
    certified_collapses(refinable, Scope::All, progress)
}

fn certified_collapses(
    refinable: &RefinableMesh,
    scope: Scope,
    progress: &mut ProgressFn<'_>,
) -> Result<RefinableMesh, Cancelled> {
    let fragmented = FragmentedMesh::from_collapses(refinable);
    let floor_errors = floor_errors(&fragmented, scope, progress)?;
    drop(fragmented);
    let sequence = &refinable.sequence;
    let mut errors = floor_errors;
    for step in (1..errors.len()).rev() {
        errors[step - 1] = errors[step - 1].max(errors[step]);
    }
    let sequence = CollapseSequence::from_parts(SequenceParts {
        positions: sequence.positions().clone(),
        base_position_count: sequence.base_position_count(),
        targets: sequence.targets().to_vec(),
        errors,
        removed_triangle_counts: sequence.removed_triangle_counts().to_vec(),
        triangle_count: refinable.mesh.triangle_count(),
    });
    let sequence = sequence.expect("errors are finite and never rise");
    Ok(RefinableMesh { mesh: refinable.mesh.clone(), sequence })
}

/// If a step raises the error of the levels by more than this factor, nearby faces are searched as
/// well: if a triangle folds over its neighbor, its pieces are best assigned to that neighbor, which
/// does not belong to the step's floor.
const SEARCH_THRESHOLD: f64 = 1.02;

/// The states for which errors are certified.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Scope {
    Levels,
    All,
}

/// Returns the bound of each step's floor, rounded up.
fn floor_errors(
    mesh: &FragmentedMesh,
    scope: Scope,
    progress: &mut ProgressFn<'_>,
) -> Result<Vec<f32>, Cancelled> {
    walk_errors(mesh, scope, progress, |_, _| ())
}

/// Returns the bound of each step's floor, rounded up, and calls `visit` after each step.
fn walk_errors(
    mesh: &FragmentedMesh,
    scope: Scope,
    progress: &mut ProgressFn<'_>,
    mut visit: impl FnMut(&CoarseningWalk<'_>, u32),
) -> Result<Vec<f32>, Cancelled> {
    let fragments = &mesh.fragments;
    let mut walk = CoarseningWalk::new(mesh, scope);
    let step_count = fragments.step_count();
    let mut errors = vec![0.0; step_count];
    for (done, step) in (0..step_count).rev().enumerate() {
        if done % STEPS_PER_REPORT == 0 {
            let now = Progress { phase: "certify", done: done as u64, total: step_count as u64 };
            if progress(now).is_break() {
                return Err(Cancelled);
            }
        }
        errors[step] = rounded_up(walk.undo(step as u32));
        visit(&walk, step as u32);
    }
    Ok(errors)
}

/// Returns the smallest f32 that is not less than `x`.
fn rounded_up(x: f64) -> f32 {
    let nearest = x as f32;
    let up = if f64::from(nearest) < x { nearest.next_up() } else { nearest };
    up.min(f32::MAX)
}

/// Walks from the full mesh to the base and updates the assignment of pieces.
struct CoarseningWalk<'a> {
    positions: &'a [[f32; 3]],
    fragments: &'a FragmentSequence,
    cover: Cover,
    /// For each face its index in the cover; indices of replaced faces are reused.
    slots: Vec<u32>,
    slot_count: u32,
    scope: Scope,
    /// The largest bound so far between pieces and their faces.
    largest: f64,
    ceiling: Vec<u32>,
    floor: Vec<(u32, [[f64; 3]; 3])>,
    /// Created when the first step needs it.
    substitutes: Option<SubstituteFinder>,
}

impl<'a> CoarseningWalk<'a> {
    fn new(mesh: &'a FragmentedMesh, scope: Scope) -> Self {
        let FragmentedMesh { mesh, fragments } = mesh;
        let mut slots = vec![0; fragments.faces().len()];
        let mut triangles = Vec::with_capacity(mesh.triangle_count());
        for (face, step) in fragments.replacing_steps().into_iter().enumerate() {
            if step == FragmentSequence::NO_STEP {
                slots[face] = triangles.len() as u32;
                triangles.push(fragments.faces()[face].corners);
            }
        }
        Self {
            positions: &mesh.positions,
            fragments,
            cover: Cover::new(&mesh.positions, &triangles),
            slots,
            slot_count: triangles.len() as u32,
            scope,
            largest: 0.0,
            ceiling: Vec::new(),
            floor: Vec::new(),
            substitutes: None,
        }
    }

    /// Undoes a step; returns a bound on the distance between its floor and the pieces assigned to it.
    fn undo(&mut self, step: u32) -> f64 {
        let fragments = self.fragments;
        let Self { slots, slot_count, ceiling, .. } = self;
        ceiling.clear();
        ceiling.extend(fragments.ceiling(step).map(|face| slots[face as usize]));
        if fragments.floor(step).is_empty() {
            return self.undo_with_empty_floor(step);
        }
        for (i, &face) in fragments.floor(step).iter().enumerate() {
            slots[face as usize] = ceiling.get(i).copied().unwrap_or_else(|| {
                *slot_count += 1;
                *slot_count - 1
            });
        }
        self.set_floor(fragments.floor(step));
        let bound = match self.scope {
            Scope::All => self.cover.replace(&self.ceiling, &self.floor),
            Scope::Levels => self.replace_or_search_nearby(step),
        };
        self.largest = self.largest.max(bound);
        bound
    }

    /// Assigns the pieces of the ceiling to the floor. If that would raise the error, also tries nearby
    /// faces and uses them if the bound is smaller.
    fn replace_or_search_nearby(&mut self, step: u32) -> f64 {
        let mut bound = self.cover.propose(&self.ceiling, &self.floor);
        if bound > self.largest * SEARCH_THRESHOLD {
            let fragments = self.fragments;
            let substitutes = self.substitutes.get_or_insert_with(|| SubstituteFinder::new(fragments));
            let mut faces = substitutes.find(fragments, self.positions, step);
            faces.extend_from_slice(fragments.floor(step));
            self.set_floor(&faces);
            let combined = self.cover.propose(&self.ceiling, &self.floor);
            if combined >= bound {
                self.set_floor(fragments.floor(step));
                self.cover.propose(&self.ceiling, &self.floor);
            }
            bound = bound.min(combined);
        }
        self.cover.commit();
        bound
    }

    /// Undoes a step without a floor: other faces get the pieces of its ceiling.
    fn undo_with_empty_floor(&mut self, step: u32) -> f64 {
        let fragments = self.fragments;
        let substitutes = self.substitutes.get_or_insert_with(|| SubstituteFinder::new(fragments));
        let mut found = substitutes.find(fragments, self.positions, step);
        let is_free = self.scope == Scope::Levels;
        found.retain(|&face| {
            is_free
                || substitutes.is_guaranteed(fragments, face, step)
                || !self.cover.assigned_triangles(self.slots[face as usize]).is_empty()
        });
        let is_guaranteed: Vec<bool> =
            found.iter().map(|&face| substitutes.is_guaranteed(fragments, face, step)).collect();
        self.set_floor(&found);
        let bound = self.cover.propose(&self.ceiling, &self.floor);
        let reach = self.cover.reach(|index| is_free || is_guaranteed[index]);
        self.cover.mark_orphans();
        self.cover.commit();
        self.largest = self.largest.max(bound);
        let displaced_bound = reach.map_or(0.0, |reach| reach + self.largest);
        bound.max(displaced_bound.min(self.cover.diagonal()))
    }

    fn set_floor(&mut self, faces: &[u32]) {
        self.floor.clear();
        for &face in faces {
            let Face { corners, .. } = self.fragments.faces()[face as usize];
            let corners = corners.map(|v| self.positions[v as usize].map(f64::from));
            self.floor.push((self.slots[face as usize], corners));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn errors_are_never_rounded_down() {
        for x in [0.0, 0.1, 1.0, 1e-50, 0.3, 1e38] {
            let up = rounded_up(x);
            assert!(f64::from(up) >= x);
            assert!(x == 0.0 || f64::from(up.next_down()) < x);
        }
    }
}
