//! Simplification to one level, with guaranteed errors if they are asked for.
//!
//! [`simplify_one_level`] keeps the correspondence with the input: it returns which input vertices are kept and
//! which input triangle each triangle comes from, so that callers can carry data of any type along. Kept
//! vertices stay in the order of the input. [`simplify_whole_mesh`] returns a mesh with its groups.

use striata::ProgressFn;
use striata::mesh::{IndexedMesh, RefinableMesh, Welded, replay, weld};
use striata::simplify::{
    SequenceOptions, SimplifyError, StopReason, Target, build_welded_sequence_with_progress,
    certify_collapses_with_progress,
};

use crate::sources::{UNUSED, VertexSources, level_triangles, representatives};

/// Target and error limit that a level must satisfy.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OneLevelRequest {
    /// The level asked for.
    pub target: Target,
    /// Upper limit of the error, mesh units, whatever the target.
    pub max_error: Option<f64>,
    /// Whether errors are guaranteed bounds instead of estimates.
    pub is_guaranteed: bool,
}

/// One level of a mesh, in terms of the input.
#[derive(Clone, Debug, PartialEq)]
pub struct OneLevel {
    /// Triangles, as indices into `kept`.
    pub triangles: Vec<[u32; 3]>,
    /// Input vertices that the level keeps, ascending.
    pub kept: Vec<u32>,
    /// Input triangle of each triangle, ascending.
    pub origins: Vec<u32>,
    /// Error of the level, mesh units.
    pub error: f64,
    /// Whether the level meets the target, and if not, why.
    pub stop_reason: StopReason,
}

/// Simplifies a mesh without groups to one level.
///
/// # Errors
/// [`SimplifyError`] if the mesh is inconsistent, an option is out of range, or the callback cancels.
pub fn simplify_one_level(
    mesh: &IndexedMesh,
    request: OneLevelRequest,
    options: &SequenceOptions,
    progress: &mut ProgressFn<'_>,
) -> Result<OneLevel, SimplifyError> {
    options.check()?;
    check_locked(options, mesh)?;
    let welded = weld(mesh)?;
    let position_of_source = welded.position_of_source.clone();
    let level = resolved_level(welded, request, options, progress)?;
    let sequence = &level.refinable.sequence;
    let sources = VertexSources::new(mesh, &position_of_source, sequence, level.source_vertex);
    Ok(OneLevel { stop_reason: level.stop_reason, ..level_of(&level.refinable, &sources, level.split_count) })
}

/// Simplifies a mesh to one level as a mesh of its own, with groups, layers and materials; also returns the
/// error and the stop reason.
///
/// # Errors
/// [`SimplifyError`] if the mesh is inconsistent, an option is out of range, or the callback cancels.
pub fn simplify_whole_mesh(
    mesh: &IndexedMesh,
    request: OneLevelRequest,
    options: &SequenceOptions,
    progress: &mut ProgressFn<'_>,
) -> Result<(IndexedMesh, f64, StopReason), SimplifyError> {
    options.check()?;
    check_locked(options, mesh)?;
    let level = resolved_level(weld(mesh)?, request, options, progress)?;
    let error = f64::from(level.refinable.sequence.error_at(level.split_count));
    let mesh = replay(&level.refinable, level.split_count).without_unused_vertices();
    Ok((mesh, error, level.stop_reason))
}

/// A sequence, and the level of it that was asked for.
struct ResolvedLevel {
    refinable: RefinableMesh,
    /// Input vertex of each vertex.
    source_vertex: Vec<u32>,
    split_count: usize,
    stop_reason: StopReason,
}

fn resolved_level(
    welded: Welded,
    request: OneLevelRequest,
    options: &SequenceOptions,
    progress: &mut ProgressFn<'_>,
) -> Result<ResolvedLevel, SimplifyError> {
    let options = options_up_to(request, options);
    let built = build_welded_sequence_with_progress(welded, &options, progress)?;
    let refinable = match request.is_guaranteed {
        true => certify_collapses_with_progress(&built.refinable, progress)?,
        false => built.refinable,
    };
    let (split_count, stop_reason) = resolve(&refinable, request, built.stop_reason);
    Ok(ResolvedLevel { refinable, source_vertex: built.source_vertex, split_count, stop_reason })
}

/// Checks that all locked vertices are vertices of the mesh.
///
/// # Errors
/// [`SimplifyError::Option`] with the first one that is not.
pub fn check_locked(options: &SequenceOptions, mesh: &IndexedMesh) -> Result<(), SimplifyError> {
    let count = mesh.vertex_count();
    match options.locked_vertices.iter().find(|&&v| v as usize >= count) {
        None => Ok(()),
        Some(vertex) => Err(SimplifyError::Option {
            option: "locked_vertices",
            value: format!("vertex {vertex} of {count}"),
            expected: "a vertex of the mesh",
        }),
    }
}

/// Options that do not simplify farther than the request needs.
fn options_up_to(request: OneLevelRequest, options: &SequenceOptions) -> SequenceOptions {
    let mut options = options.clone();
    let limit = match request.target {
        Target::Triangles(count) => {
            options.base_triangle_count = options.base_triangle_count.max(count);
            None
        }
        Target::Error(error) => Some(error),
        _ => None,
    };
    let limits = [limit, request.max_error, options.max_error];
    options.max_error = limits.into_iter().flatten().reduce(f64::min);
    options
}

/// Finds the split count of the requested level.
fn resolve(refinable: &RefinableMesh, request: OneLevelRequest, stopped: StopReason) -> (usize, StopReason) {
    let sequence = &refinable.sequence;
    let (mut split_count, mut stop_reason) = request.target.resolve(sequence);
    if let Some(error) = request.max_error {
        let nearest = sequence.split_count_for_error(error);
        if nearest > split_count {
            (split_count, stop_reason) = (nearest, StopReason::ErrorLimit);
        }
    }
    match (stop_reason, stopped, request.target) {
        // Simplification stopped at the error asked for, so this base mesh is the target.
        (StopReason::BaseReached, StopReason::ErrorLimit, Target::Error(_)) => {
            (split_count, StopReason::TargetReached)
        }
        (StopReason::BaseReached, _, _) => (split_count, stopped),
        _ => (split_count, stop_reason),
    }
}

/// Extracts a level with only the vertices that its triangles use.
fn level_of(refinable: &RefinableMesh, sources: &VertexSources, split_count: usize) -> OneLevel {
    let representative = representatives(&refinable.sequence, split_count);
    let (mut triangles, mut origins) = level_triangles(&refinable.mesh, &representative);
    for origin in &mut origins {
        *origin = sources.input_of_triangle[*origin as usize];
    }
    let mut new_index = vec![UNUSED; sources.vertex_of_input.len()];
    for corner in triangles.iter_mut().flatten() {
        *corner = sources.input_of_vertex[*corner as usize];
        new_index[*corner as usize] = 0;
    }
    let mut kept = Vec::new();
    for (input, slot) in new_index.iter_mut().enumerate().filter(|(_, slot)| **slot != UNUSED) {
        *slot = kept.len() as u32;
        kept.push(input as u32);
    }
    triangles.iter_mut().flatten().for_each(|corner| *corner = new_index[*corner as usize]);
    let error = f64::from(refinable.sequence.error_at(split_count));
    OneLevel { triangles, kept, origins, error, stop_reason: StopReason::TargetReached }
}

#[cfg(test)]
mod tests {
    use striata::ignore_progress;
    use striata::mesh::{canonical_triangles, shapes};
    use striata::simplify::{SimplifyOptions, simplify};

    use super::*;

    fn request(target: Target) -> OneLevelRequest {
        OneLevelRequest { target, max_error: None, is_guaranteed: false }
    }

    /// Triangles as sorted corner positions, which do not depend on the order of vertices.
    fn corners(mesh: &IndexedMesh) -> Vec<[[u32; 3]; 3]> {
        let bits = |v: u32| mesh.positions[v as usize].map(f32::to_bits);
        let mut all: Vec<_> = canonical_triangles(&mesh.triangles).iter().map(|t| t.map(bits)).collect();
        for triangle in &mut all {
            let least = (0..3).min_by_key(|&i| triangle[i]).unwrap_or(0);
            triangle.rotate_left(least);
        }
        all.sort_unstable();
        all
    }

    #[test]
    fn equals_the_library_and_keeps_the_order() {
        let mesh = shapes::terrain(24, 7);
        for target in [Target::Triangles(200), Target::Vertices(90), Target::Error(0.01), Target::Detail(0.3)]
        {
            let ours =
                simplify_one_level(&mesh, request(target), &SequenceOptions::default(), &mut ignore_progress)
                    .expect("a level");
            let theirs = simplify(&mesh, &SimplifyOptions::default().with_target(target)).expect("a level");
            let positions = ours.kept.iter().map(|&v| mesh.positions[v as usize]).collect();
            assert!(ours.kept.is_sorted() && ours.origins.is_sorted());
            let ours = IndexedMesh::new(positions, ours.triangles);
            assert_eq!(corners(&ours), corners(&theirs.mesh), "{target:?}");
        }
    }

    #[test]
    fn locked_vertices_stay() {
        let mesh = shapes::terrain(24, 7);
        let options = SequenceOptions::default().with_locked_vertices(vec![3, 300]);
        let level = simplify_one_level(&mesh, request(Target::Triangles(20)), &options, &mut ignore_progress)
            .unwrap();
        assert!([3, 300].iter().all(|v| level.kept.contains(v)));
        let options = SequenceOptions::default().with_locked_vertices(vec![99_999]);
        let level = simplify_one_level(&mesh, request(Target::Triangles(20)), &options, &mut ignore_progress);
        assert!(level.is_err());
    }

    #[test]
    fn guaranteed_limits_hold_whatever_the_target() {
        let mesh = shapes::terrain(24, 7);
        let request =
            OneLevelRequest { target: Target::Triangles(2), max_error: Some(0.05), is_guaranteed: true };
        let level =
            simplify_one_level(&mesh, request, &SequenceOptions::default(), &mut ignore_progress).unwrap();
        assert!(level.error <= 0.05 && level.triangles.len() > 2);
        assert_eq!(level.stop_reason, StopReason::ErrorLimit);
        let (whole, error, stop_reason) =
            simplify_whole_mesh(&mesh, request, &SequenceOptions::default(), &mut ignore_progress).unwrap();
        assert_eq!((whole.triangle_count(), error), (level.triangles.len(), level.error));
        assert_eq!(stop_reason, StopReason::ErrorLimit);
    }
}
