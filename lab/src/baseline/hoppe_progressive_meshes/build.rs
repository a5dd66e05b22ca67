//! Builds the records from the full mesh to the base. Faces are then numbered in the order in which splits
//! add them.

use striata::mesh::{CollapseSequence, RefinableMesh};
use striata::model::StepVertices;

use super::faces::{HalfEdgeFaces, NONE, next, prev};
use super::star::{CollapseStar, CollapsingSurface};
use super::{
    HAS_CORNERS, HAS_LEFT, HAS_RIGHT, HAS_SECOND_RUN, HoppeProgressiveMeshes, HoppeProgressiveMeshesError,
    Split,
};

/// A split whose half-edges refer to the triangles of the mesh.
struct DraftSplit {
    half_edge: u32,
    run: u16,
    code: u16,
    /// The half-edges that leave the vertex in the faces on the left and on the right, or [`NONE`].
    faces: [u32; 2],
    second_half_edge: Option<(u32, u32)>,
    corners: Vec<u32>,
}

impl HoppeProgressiveMeshes {
    /// Builds the model from a mesh and its sequence.
    ///
    /// # Errors
    /// [`HoppeProgressiveMeshesError`] if the surface is not an oriented manifold at every level, or a
    /// triangle that vanishes has no neighbor.
    ///
    /// # Panics
    /// If the mesh does not match the sequence: it refers to other vertices, or its groups do not tile it.
    pub fn build(refinable: &RefinableMesh) -> Result<Self, HoppeProgressiveMeshesError> {
        let sequence = &refinable.sequence;
        let groups = refinable.mesh.groups_or_whole();
        let (found, limit) = (groups.len(), usize::from(u16::MAX) + 1);
        if found > limit {
            return Err(HoppeProgressiveMeshesError::Groups { found, limit });
        }
        let mut surface = CollapsingSurface::new(refinable)?;
        let mut drafts = Vec::with_capacity(sequence.step_count());
        for step in (0..sequence.step_count()).rev() {
            let vertex = sequence.step_vertices(step).start;
            let error = |reason| HoppeProgressiveMeshesError::Step { step, vertex, reason };
            drafts.push(draft(&mut surface, sequence, step).map_err(error)?);
        }
        drafts.reverse();
        let mut group_of = vec![0; refinable.mesh.triangle_count()];
        for (index, group) in groups.iter().enumerate() {
            group_of[group.range()].fill(index as u16);
        }
        Ok(numbered(&surface, sequence, &drafts, &group_of, groups.len()))
    }
}

/// Collapses the position of a step and returns its record.
fn draft(
    surface: &mut CollapsingSurface<'_>,
    sequence: &CollapseSequence,
    step: usize,
) -> Result<DraftSplit, &'static str> {
    let vertices = sequence.step_vertices(step);
    let positions = sequence.positions();
    let position = positions.position_of(vertices.start);
    let target = positions.position_of(sequence.target(vertices.start));
    let star = surface.star(position, target)?;
    let [left, right] = star.vanishing;
    let outside = |face: u32, from: u32| if face == NONE { NONE } else { surface.faces.twin(next(from)) };
    let (outer_left, outer_right) = (outside(left, left), outside(right, right));
    let half_edge = star.run.first().copied().unwrap_or(if left == NONE { outer_right } else { outer_left });
    let second =
        star.second_run.as_ref().map(|run| (run.first().copied().unwrap_or(outer_right), run.len() as u32));
    if half_edge == NONE || second.is_some_and(|(half_edge, _)| half_edge == NONE) {
        return Err("a triangle vanishes that has no neighbor");
    }
    let run = u16::try_from(star.run.len()).map_err(|_| "it has too many triangles")?;
    let flag = |is_set: bool, flag: u16| if is_set { flag } else { 0 };
    let mut code = flag(left != NONE, HAS_LEFT)
        | flag(right != NONE, HAS_RIGHT)
        | flag(second.is_some(), HAS_SECOND_RUN);
    let corners = move_corners(surface, &star, sequence, vertices.len());
    code |= flag(!corners.is_empty(), HAS_CORNERS);
    surface.collapse(&star, step, target);
    Ok(DraftSplit { half_edge, run, code, faces: star.vanishing, second_half_edge: second, corners })
}

/// Replaces the corners of the run by their targets. Returns all corners around the step, unless they follow
/// from the walk around the vertex.
fn move_corners(
    surface: &mut CollapsingSurface<'_>,
    star: &CollapseStar,
    sequence: &CollapseSequence,
    vertex_count: usize,
) -> Vec<u32> {
    let run: Vec<u32> = star.run.iter().chain(star.second_run.iter().flatten()).copied().collect();
    let fine: Vec<u32> = run.iter().map(|&h| surface.faces.corner(h)).collect();
    let coarse: Vec<u32> = fine.iter().map(|&v| sequence.target(v)).collect();
    for (&half_edge, &corner) in run.iter().zip(&coarse) {
        surface.faces.set_corner(half_edge, corner);
    }
    let is_plain = vertex_count == 1 && coarse.windows(2).all(|w| w[0] == w[1]);
    if is_plain && sides_are_plain(&surface.faces, star) {
        return Vec::new();
    }
    let present = star.vanishing.into_iter().filter(|&face| face != NONE);
    let faces = present.flat_map(|face| [face, next(face), prev(face)]).map(|h| surface.faces.corner(h));
    coarse.into_iter().chain(fine).chain(faces).collect()
}

/// Whether both vanishing faces have the target and the tip that a split finds for them.
fn sides_are_plain(faces: &HalfEdgeFaces, star: &CollapseStar) -> bool {
    let [left, right] = star.vanishing;
    // Target and tip of the vanishing faces.
    let of_left = || [next(left), prev(left)].map(|h| faces.corner(h));
    let of_right = || [prev(right), next(right)].map(|h| faces.corner(h));
    let (first, last) = match &star.second_run {
        Some(run) => (star.run.first(), run.first()),
        None => (star.run.first(), star.run.last()),
    };
    if left != NONE {
        let found = match first {
            Some(&first) => [first, next(first)],
            None => [next(faces.twin(next(left))), faces.twin(next(left))],
        };
        if found.map(|h| faces.corner(h)) != of_left() {
            return false;
        }
    }
    if right == NONE {
        return true;
    }
    let found = match last {
        Some(&last) => [last, prev(last)].map(|h| faces.corner(h)),
        None if left != NONE && star.second_run.is_none() => of_left(),
        None => {
            let outer = faces.twin(next(right));
            [outer, next(outer)].map(|h| faces.corner(h))
        }
    };
    found == of_right()
}

/// Numbers the faces in the order in which splits add them, and translates all half-edges.
fn numbered(
    surface: &CollapsingSurface<'_>,
    sequence: &CollapseSequence,
    drafts: &[DraftSplit],
    group_of: &[u16],
    group_count: usize,
) -> HoppeProgressiveMeshes {
    let is_shown = |&face: &usize| surface.shown_from[face] != u32::MAX;
    let mut counts = vec![0; group_count];
    (0..group_of.len()).filter(is_shown).for_each(|face| counts[usize::from(group_of[face])] += 1);
    let mut group_offsets = vec![0];
    group_offsets.extend(counts.iter().scan(0, |end, count| {
        *end += count;
        Some(*end)
    }));
    let mut next_face = group_offsets[..group_count].to_vec();
    // For each face of the mesh: its new index, and how far its corners are rotated.
    let mut places = vec![(NONE, 0); group_of.len()];
    let mut place = |face: usize, first_corner: u32| {
        let next = &mut next_face[usize::from(group_of[face])];
        places[face] = (*next, first_corner);
        *next += 1;
    };
    let base: Vec<usize> = (0..group_of.len()).filter(|&face| surface.shown_from[face] == 0).collect();
    base.iter().for_each(|&face| place(face, 0));
    let mut base_counts = vec![0; group_count];
    base.iter().for_each(|&face| base_counts[usize::from(group_of[face])] += 1);
    for half_edge in drafts.iter().flat_map(|draft| draft.faces).filter(|&half_edge| half_edge != NONE) {
        place(half_edge as usize / 3, half_edge % 3);
    }
    let translated = |half_edge: u32| {
        if half_edge == NONE {
            return NONE;
        }
        let (face, first) = places[half_edge as usize / 3];
        3 * face + (half_edge % 3 + 3 - first) % 3
    };
    let of_face = |face: usize, values: &dyn Fn(u32) -> u32| [0, 1, 2].map(|i| values(3 * face as u32 + i));
    let mut model = HoppeProgressiveMeshes {
        vertices: StepVertices::of_sequence(sequence).without_targets(),
        group_offsets,
        base_counts,
        base_corners: base.iter().map(|&f| of_face(f, &|h| surface.faces.corner(h))).collect(),
        base_twins: base.iter().map(|&f| of_face(f, &|h| translated(surface.faces.twin(h)))).collect(),
        splits: Vec::with_capacity(drafts.len()),
        face_groups: Vec::new(),
        extras: Vec::new(),
    };
    for draft in drafts {
        let &DraftSplit { half_edge, run, code, faces, .. } = draft;
        model.splits.push(Split { half_edge: translated(half_edge), run, code });
        if group_count > 1 {
            let group = |face: u32| if face == NONE { 0 } else { group_of[face as usize / 3] };
            model.face_groups.push(faces.map(group));
        }
        if let Some((half_edge, count)) = draft.second_half_edge {
            model.extras.extend([translated(half_edge), count]);
        }
        model.extras.extend(&draft.corners);
    }
    model
}
