//! Converts patterns back to fragments.

use super::Patterns;
use super::overlaps::Share;
use super::parts::UNKNOWN;
use super::rule::{NONE, first_corner};
use super::rule_table::RuleRef;
use crate::mesh::{Face, Fragment, FragmentError, FragmentSequence};
use crate::model::ModelError;

/// Destination of a face: the step above, and the corner of its floor with the face's youngest vertex.
#[derive(Clone, Copy)]
struct FaceDestination {
    above: u32,
    half_edge: u32,
}

impl Patterns {
    /// Reconstructs the fragments, given the errors of their floors. Faces come in the order of the rules.
    ///
    /// # Errors
    /// [`ModelError`] naming the first step that contradicts others, if the patterns were not produced by
    /// a build.
    pub fn unpack(&self, floor_errors: Vec<f32>) -> Result<FragmentSequence, ModelError> {
        let step_count = self.records.step_count;
        if floor_errors.len() != step_count {
            let (found, expected) = (floor_errors.len(), step_count);
            return Err(ModelError::Length { what: "errors", found, expected });
        }
        let floors = self.floors()?;
        let mut faces: Vec<Face> = Vec::new();
        for (place, face) in self.base.iter().enumerate() {
            let [a, b, c] = face.corners;
            let is_valid = a.max(b).max(c) < self.vertices.base_vertex_count;
            if !is_valid || a < b.max(c) || (face.group as usize) >= self.group_count {
                let reason = "has corners or a group that do not exist";
                return Err(ModelError::Listed { what: "triangle of the base", place, reason });
            }
            faces.push(Face { corners: face.corners, group: face.group });
        }
        let mut fragments = Vec::with_capacity(step_count);
        let mut locals = Vec::new();
        for step in 0..step_count as u32 {
            let wrong = |reason| ModelError::Step { step: step as usize, reason };
            let rule = self.rules.rule(self.records.head(step).rule);
            let floor = floors.of_step(step);
            self.find_locals(step, &rule, (floor, &faces), &mut locals).map_err(wrong)?;
            let corners_of = |triangle: [u32; 3]| triangle.map(|local| locals[local as usize]);
            let ceiling = (0..rule.ceiling_count())
                .map(|s| Face { corners: corners_of(rule.ceiling(s)), group: rule.group(s) });
            let ceiling: Vec<Face> = ceiling.collect();
            if ceiling.iter().any(|face| face.corners.contains(&UNKNOWN)) {
                return Err(wrong("has a triangle with a corner that cannot be determined"));
            }
            let mut ordered = vec![None; rule.floor_count()];
            for &(face, half_edge) in floor {
                ordered[half_edge as usize / 3] = Some(faces[face as usize]);
            }
            let floor = ordered.into_iter().collect::<Option<Vec<Face>>>();
            let floor = floor.ok_or(wrong("has fewer floor triangles than its rule"))?;
            faces.extend_from_slice(&ceiling);
            fragments.push(Fragment { ceiling, floor, error: floor_errors[step as usize] });
        }
        let base = faces[..self.base.len()].to_vec();
        FragmentSequence::from_fragments(self.vertices.positions(), base, fragments.into_iter())
            .map_err(combination_error)
    }

    /// Finds the vertices of a fragment from its floor, and checks that the floor's triangles agree on them.
    fn find_locals(
        &self,
        step: u32,
        rule: &RuleRef<'_>,
        (floor, faces): (&[(u32, u32)], &[Face]),
        locals: &mut Vec<u32>,
    ) -> Result<(), &'static str> {
        locals.clear();
        locals.extend(self.vertices.of_step(step as usize));
        if locals.len() != rule.own_count() {
            return Err("restores a different number of vertices than its rule");
        }
        locals.resize(rule.local_count(), UNKNOWN);
        let extras = self.extras.of_step(step);
        if rule.extras().count() != extras.len() {
            return Err("has a different number of extra vertices than its rule");
        }
        let first = self.vertices.of_step(step as usize).start;
        for (local, &vertex) in rule.extras().zip(extras) {
            if vertex >= first {
                return Err("has an extra vertex that comes later");
            }
            locals[local as usize] = vertex;
        }
        if floor.len() != rule.floor_count() {
            return Err("has a different number of floor triangles than its rule");
        }
        for &(face, half_edge) in floor {
            if half_edge as usize >= 3 * rule.floor_count() {
                return Err("has a floor triangle that its rule does not have");
            }
            let triangle = rule.floor(half_edge as usize / 3);
            let triangle = first_corner(triangle, triangle[half_edge as usize % 3]);
            let Face { corners, group } = faces[face as usize];
            if group != rule.group(rule.ceiling_count() + half_edge as usize / 3) {
                return Err("has a floor triangle of a different group");
            }
            for (local, vertex) in triangle.into_iter().zip(corners) {
                let known = &mut locals[local as usize];
                if *known != UNKNOWN && *known != vertex {
                    return Err("has floor triangles that contradict each other");
                }
                *known = vertex;
            }
        }
        Ok(())
    }

    /// Collects the faces of each floor and their locations in it.
    fn floors(&self) -> Result<Floors, ModelError> {
        let step_count = self.records.step_count as u32;
        let mut destinations: Vec<FaceDestination> = self
            .base
            .iter()
            .map(|face| FaceDestination { above: face.above, half_edge: face.half_edge })
            .collect();
        let mut links = Vec::new();
        for step in 0..step_count {
            let wrong = |reason| ModelError::Step { step: step as usize, reason };
            let head = self.records.head(step);
            let ceiling_count = self.rules.rule(head.rule).ceiling_count();
            if self.sharings.count(head.sharing) != ceiling_count {
                return Err(wrong("shares a different number of triangles than its rule has"));
            }
            links.clear();
            self.links_into(&head, &mut links);
            for share in self.sharings.shares(head.sharing) {
                if share.link == Share::FULL {
                    destinations.push(FaceDestination { above: NONE, half_edge: 0 });
                    continue;
                }
                let (above, half_edge) = links[share.link as usize];
                if above <= step || above >= step_count {
                    return Err(wrong("has a link to a step that is not above it"));
                }
                let rule = self.rules.rule(self.records.head(above).rule);
                let is_valid = (half_edge as usize) < 3 * rule.floor_count();
                let half_edge = if is_valid { rule.around(half_edge, share.offset) } else { None };
                let half_edge = half_edge.ok_or(wrong("has a link to a corner that does not exist"))?;
                destinations.push(FaceDestination { above, half_edge });
            }
            if self.records.down(&head, links.len()).any(|below| below >= step) {
                return Err(wrong("has a link down to a step that is not below it"));
            }
        }
        Floors::of(step_count as usize, self.base.len(), &destinations)
    }
}

/// Converts an error that only shows when the fragments are combined.
fn combination_error(error: FragmentError) -> ModelError {
    let (step, reason) = match error {
        FragmentError::Degenerate { step, .. } => (step, "has a triangle with a repeated corner"),
        FragmentError::Ceiling { step, .. } => (step, "has a triangle whose youngest corner is not its own"),
        FragmentError::Floor { step, .. } => (Some(step), "has a floor triangle that does not exist"),
        FragmentError::Sequence(_) => (None, "has inconsistent levels"),
    };
    match step {
        Some(step) => ModelError::Step { step: step as usize, reason },
        None => ModelError::Listed { what: "base", place: 0, reason },
    }
}

/// The faces of each step's floor.
struct Floors {
    firsts: Vec<u32>,
    faces: Vec<(u32, u32)>,
}

impl Floors {
    fn of(
        step_count: usize,
        base_count: usize,
        destinations: &[FaceDestination],
    ) -> Result<Self, ModelError> {
        let mut firsts = vec![0u32; step_count + 1];
        for (face, destination) in destinations.iter().enumerate() {
            if destination.above == NONE {
                continue;
            }
            if face < base_count && destination.above as usize >= step_count {
                let reason = "leads to a step that does not exist";
                return Err(ModelError::Listed { what: "triangle of the base", place: face, reason });
            }
            firsts[destination.above as usize + 1] += 1;
        }
        for step in 0..step_count {
            firsts[step + 1] += firsts[step];
        }
        let mut next = firsts.clone();
        let mut faces = vec![(0, 0); firsts[step_count] as usize];
        for (destination, face) in destinations.iter().zip(0..) {
            if destination.above != NONE {
                let at = &mut next[destination.above as usize];
                faces[*at as usize] = (face, destination.half_edge);
                *at += 1;
            }
        }
        Ok(Self { firsts, faces })
    }

    fn of_step(&self, step: u32) -> &[(u32, u32)] {
        &self.faces[self.firsts[step as usize] as usize..self.firsts[step as usize + 1] as usize]
    }
}
