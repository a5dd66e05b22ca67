//! Builds patterns from fragments.

use super::bounds::{BoundScale, PackedBounds};
use super::dependencies::Dependencies;
use super::kinds::KindTable;
use super::overlaps::{CeilingShare, MAX_RUN, OverlapTableBuilder};
use super::records::{Draft, RecordLayout, Records, UpLink};
use super::rule::{Rule, first_corner};
use super::rule_table::{RuleTable, of_rule};
use super::rulebook::{Matched, Rulebook};
use super::{BaseFace, Patterns};
use crate::mesh::{Face, FragmentSequence, FragmentedMesh};
use crate::model::{ModelError, StepVertices};

impl Patterns {
    /// Builds the patterns of a mesh with fragments of any origin, including the bounds of the fragments.
    ///
    /// # Errors
    /// [`ModelError::TooMany`] if the links would take more than 512 MB.
    pub fn build(mesh: &FragmentedMesh) -> Result<Self, ModelError> {
        let patterns = Self::build_without_bounds(mesh)?;
        Ok(Self { bounds: Some(PackedBounds::of_fragments(mesh)), ..patterns })
    }

    /// Builds the patterns with bounds of the fragments and an error for each overlap, from an error for each
    /// face; see [`certify_faces`](crate::simplify::certify_faces).
    ///
    /// # Errors
    /// Fails under the same conditions as [`build`](Self::build), and if the number of errors is not that
    /// of the faces.
    pub fn build_with_overlap_errors(mesh: &FragmentedMesh, face_errors: &[f32]) -> Result<Self, ModelError> {
        let (found, expected) = (face_errors.len(), mesh.fragments.faces().len());
        if found != expected {
            return Err(ModelError::Length { what: "errors of faces", found, expected });
        }
        let bounds = PackedBounds::of_fragments(mesh);
        let largest = face_errors.iter().copied().fold(0.0, f32::max);
        let errors = FaceErrors { errors: face_errors, scale: BoundScale::of_errors(largest) };
        let group_count = mesh.mesh.groups.len().max(1);
        Ok(Self { bounds: Some(bounds), ..Self::of_parts(&mesh.fragments, group_count, Some(errors))? })
    }

    /// Builds the patterns without bounds; see [`from_fragments`](Self::from_fragments).
    ///
    /// # Errors
    /// Fails under the same conditions as [`build`](Self::build).
    pub fn build_without_bounds(mesh: &FragmentedMesh) -> Result<Self, ModelError> {
        Self::from_fragments(&mesh.fragments, mesh.mesh.groups.len().max(1))
    }

    /// Removes the bounds.
    pub fn without_bounds(self) -> Self {
        Self { bounds: None, ..self }
    }

    /// Builds the patterns from fragments alone, without positions and therefore without bounds. That is
    /// sufficient for uniform levels and for conditions that do not evaluate bounds; a
    /// [`PatternScene`](super::PatternScene) and a file need them.
    ///
    /// # Errors
    /// Fails under the same conditions as [`build`](Self::build).
    pub fn from_fragments(fragments: &FragmentSequence, group_count: usize) -> Result<Self, ModelError> {
        Self::of_parts(fragments, group_count, None)
    }

    fn of_parts(
        fragments: &FragmentSequence,
        group_count: usize,
        errors: Option<FaceErrors<'_>>,
    ) -> Result<Self, ModelError> {
        let step_count = fragments.step_count();
        let mut rulebook = Rulebook::new(fragments, group_count);
        let mut locations = FaceLocations::new(fragments, errors);
        let mut locals = Vec::with_capacity(step_count);
        let mut rules_of = Vec::with_capacity(step_count);
        for step in 0..step_count as u32 {
            let matched = rulebook.find(step);
            locations.record(&matched, rulebook.rule(matched.rule));
            rules_of.push(matched.rule);
            locals.push(matched.locals);
        }
        let rules = rulebook.into_table();
        let codes = RuleCodes::new(&rules);
        let vertices = StepVertices::of_levels(fragments.levels());
        let mut sharings = OverlapTableBuilder::default();
        let mut sharings_of = Vec::with_capacity(step_count);
        let mut drafts: Vec<Draft> = Vec::with_capacity(step_count);
        let mut dependencies = Dependencies::new(step_count);
        let mut below = Vec::new();
        for step in 0..step_count as u32 {
            let (sharing, up) = locations.share(step, &rules, &codes, &rules_of);
            sharings_of.push(sharings.find(&sharing));
            below.clear();
            below.extend(fragments.floor(step).iter().filter_map(|&face| fragments.creating_step(face)));
            below.sort_unstable();
            below.dedup();
            let down = dependencies.add(&below).to_vec();
            let first = vertices.of_step(step as usize).start;
            let locals = &locals[step as usize];
            let listed =
                of_rule!(rules.rule(rules_of[step as usize]), rule => rule.extras().collect::<Vec<_>>());
            let extras = listed.into_iter().map(|local| first - 1 - locals[local as usize]).collect();
            drafts.push(Draft { kind: 0, up, down, extras });
        }
        let sharings = sharings.into_table();
        let pairs = rules_of.iter().zip(sharings_of).map(|(&rule, found)| (rule, sharings.index_of(found)));
        let (kinds, kinds_of) = KindTable::of_steps(&pairs.collect::<Vec<_>>(), &rules, &sharings)?;
        drafts.iter_mut().zip(kinds_of).for_each(|(draft, kind)| draft.kind = kind);
        let base = (0..fragments.base_face_count() as u32)
            .map(|face| locations.base_face(face, &codes, &rules_of))
            .collect();
        let layout = RecordLayout {
            kind_count: kinds.len(),
            half_edge_count: rules.iter().map(|rule| 3 * rule.floor_count()).max().unwrap_or(0) as u32,
            has_errors: errors.is_some(),
            ..RecordLayout::default()
        };
        Ok(Self {
            vertices,
            group_count,
            base,
            floorless: (0..step_count as u32).filter(|&s| fragments.floor(s).is_empty()).collect(),
            records: Records::pack(&drafts, layout)?,
            rules,
            sharings,
            kinds,
            overlap_errors: errors.map(|errors| errors.scale),
            bounds: None,
        })
    }
}

/// Errors of all faces, and how they are packed.
#[derive(Clone, Copy)]
struct FaceErrors<'a> {
    errors: &'a [f32],
    scale: BoundScale,
}

/// For each rule, the code of each half-edge at which a run can begin.
struct RuleCodes {
    firsts: Vec<u32>,
    codes: Vec<u32>,
}

impl RuleCodes {
    fn new(rules: &RuleTable) -> Self {
        let mut out = Self { firsts: Vec::with_capacity(rules.len()), codes: Vec::new() };
        for rule in rules.iter() {
            let first = out.codes.len();
            out.firsts.push(first as u32);
            let count = 3 * rule.floor_count();
            out.codes.resize(first + count, 0);
            for code in 0..count as u32 {
                let half_edge = rule.locate(code, 0).expect("every half-edge has a code");
                out.codes[first + half_edge as usize] = code;
            }
        }
        out
    }

    fn code(&self, rule: u32, half_edge: u32) -> u32 {
        self.codes[(self.firsts[rule as usize] + half_edge) as usize]
    }
}

/// Location of each face in the ceiling of its creator and in the floor of the fragment that replaces it.
struct FaceLocations<'a> {
    fragments: &'a FragmentSequence,
    replaced_by: Vec<u32>,
    /// Faces of all ceilings, in the order of their rules.
    ceilings: Vec<u32>,
    /// For each face, the corner of its youngest vertex in the floor that contains it, as a half-edge of
    /// the rule.
    half_edges: Vec<u32>,
    errors: Option<FaceErrors<'a>>,
}

impl<'a> FaceLocations<'a> {
    fn new(fragments: &'a FragmentSequence, errors: Option<FaceErrors<'a>>) -> Self {
        Self {
            fragments,
            errors,
            replaced_by: fragments.replacing_steps(),
            ceilings: Vec::with_capacity(fragments.faces().len() - fragments.base_face_count()),
            half_edges: vec![0; fragments.faces().len()],
        }
    }

    /// Records the locations of the faces of the next step.
    fn record(&mut self, matched: &Matched, rule: &Rule) {
        self.ceilings.extend_from_slice(&matched.ceiling);
        for (j, (&face, triangle)) in matched.floor.iter().zip(&rule.floor).enumerate() {
            let corners = triangle.map(|local| matched.locals[local as usize]);
            let youngest = (0..3).max_by_key(|&c| corners[c]).expect("a triangle has corners");
            self.half_edges[face as usize] = (3 * j + youngest) as u32;
        }
    }

    fn base_face(&self, face: u32, codes: &RuleCodes, rules_of: &[u32]) -> BaseFace {
        let Face { corners: [a, b, c], group } = self.fragments.faces()[face as usize];
        let above = self.replaced_by[face as usize];
        let is_replaced = above != FragmentSequence::NO_STEP;
        let code = |()| codes.code(rules_of[above as usize], self.half_edges[face as usize]);
        BaseFace {
            corners: first_corner([a, b, c], a.max(b).max(c)),
            group,
            above,
            code: is_replaced.then_some(()).map_or(0, code),
            error: if is_replaced { self.error_code(face) } else { 0 },
        }
    }

    fn error_code(&self, face: u32) -> u32 {
        self.errors.map_or(0, |errors| errors.scale.error_code(errors.errors[face as usize]))
    }

    /// Returns how the ceiling of a step is shared, and its links up.
    fn share(
        &self,
        step: u32,
        rules: &RuleTable,
        codes: &RuleCodes,
        rules_of: &[u32],
    ) -> (Vec<CeilingShare>, Vec<UpLink>) {
        let base = self.fragments.base_face_count();
        let range = self.fragments.ceiling(step);
        let faces = &self.ceilings[range.start as usize - base..range.end as usize - base];
        let above = |s: usize| self.replaced_by[faces[s] as usize];
        let half_edge = |s: usize| self.half_edges[faces[s] as usize];
        let follows = |s: usize, before: usize| {
            let is_same = above(s) == above(before) && above(s) != FragmentSequence::NO_STEP;
            is_same && {
                let rule = rules.rule(rules_of[above(s) as usize]);
                rule.next_around(half_edge(before)) == Some(half_edge(s))
            }
        };
        let count = faces.len();
        let mut sharing = vec![CeilingShare { link: CeilingShare::FULL, offset: 0 }; count];
        let mut up = Vec::new();
        // Starting at the beginning of a run ensures that no run is split at an arbitrary point of the ring.
        let start = (0..count).find(|&s| !follows(s, (s + count - 1) % count)).unwrap_or(0);
        let mut offset = 0;
        for i in 0..count {
            let s = (start + i) % count;
            if above(s) == FragmentSequence::NO_STEP {
                continue;
            }
            offset += 1;
            if i == 0 || offset == MAX_RUN || !follows(s, (s + count - 1) % count) {
                offset = 0;
                let code = codes.code(rules_of[above(s) as usize], half_edge(s));
                up.push(UpLink { above: above(s), code, error: 0 });
            }
            let link = up.len() - 1;
            up[link].error = up[link].error.max(self.error_code(faces[s]));
            sharing[s] = CeilingShare { link: link as u32, offset };
        }
        renumber(&mut sharing, &mut up);
        (sharing, up)
    }
}

/// Renumbers links by first use in the ceiling, so that equivalent sharings become equal.
fn renumber(sharing: &mut [CeilingShare], up: &mut Vec<UpLink>) {
    let mut fresh = vec![u32::MAX; up.len()];
    let mut order = Vec::with_capacity(up.len());
    for share in sharing.iter_mut().filter(|share| share.link != CeilingShare::FULL) {
        let index = &mut fresh[share.link as usize];
        if *index == u32::MAX {
            *index = order.len() as u32;
            order.push(up[share.link as usize]);
        }
        share.link = *index;
    }
    *up = order;
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn links_are_numbered_by_first_use() {
        let share = |link| CeilingShare { link, offset: 0 };
        let mut sharing = [2, CeilingShare::FULL, 0, 2, 1].map(share);
        let up = |above| UpLink { above, code: above % 3, error: 0 };
        let mut ups = [7, 8, 9].map(up).to_vec();
        renumber(&mut sharing, &mut ups);
        assert_eq!(sharing, [0, CeilingShare::FULL, 1, 0, 2].map(share));
        assert_eq!(ups, [9, 7, 8].map(up));
    }
}
