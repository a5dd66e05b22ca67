//! Visits the fragments of a model from coarse to fine and checks that they fit together.
//!
//! Each step finds its floor where the steps that create it have left it, so that a single pass over the
//! records is enough: the vertices of the ceiling follow from those of the floor, and the triangles of the
//! ceiling are left for the steps above. Time is linear in the number of triangles.

use super::Patterns;
use super::dependencies::Dependencies;
use super::exchange::{rotated, vertices_of};
use super::overlaps::run_location;
use super::overlaps::{CeilingShare, MAX_RUN};
use super::records::StepHead;
use super::rule::NONE;
use super::rule_table::{Number, RuleView, of_rule};
use crate::mesh::Face;
use crate::model::ModelError;

/// Marks a local vertex that is not known yet.
const UNKNOWN: u32 = NONE;

/// A triangle that waits for the step that replaces it.
#[derive(Clone, Copy, Debug, Default)]
struct Waiting {
    /// Vertices, youngest first.
    corners: [u32; 3],
    /// Location in the floor.
    location: u32,
}

/// Purpose of a visit to a step: to check it, or to collect its faces too.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum VisitPurpose {
    Check,
    Collect,
}

/// The walk over all fragments.
pub(super) struct FragmentWalk<'a> {
    patterns: &'a Patterns,
    /// For each step, its first entry in `waiting`, and the entry for the next triangle that arrives.
    floors: Vec<[u32; 2]>,
    waiting: Vec<Waiting>,
    /// The group of each entry in `waiting`; empty if there is only one group.
    groups: Vec<u32>,
    /// Number of triangles of all ceilings.
    ceiling_count: u64,
    dependencies: Dependencies,
    /// Vertices of the current step by local index; those after the last are of no use.
    locals: Vec<u32>,
    /// Faces of the floor in the order of the rule, if they are asked for.
    floor: Vec<Face>,
    ceiling: Vec<Face>,
    /// Steps that create the current floor, ascending.
    makers: Vec<u32>,
}

impl<'a> FragmentWalk<'a> {
    /// Prepares the walk: counts the triangles of floors and ceilings, and checks that all kinds exist.
    ///
    /// # Errors
    /// [`ModelError`] naming the first step whose kind does not exist.
    pub(super) fn new(patterns: &'a Patterns) -> Result<Self, ModelError> {
        let counts = patterns.kind_counts();
        let step_count = patterns.records.step_count;
        let mut floors = Vec::with_capacity(step_count + 1);
        let (mut end, mut ceiling_count) = (0u64, 0u64);
        patterns.records.try_for_each_head(|step, head| {
            let Some(&[ceiling, floor]) = counts.get(head.kind as usize) else {
                return Err(ModelError::Step {
                    step: step as usize,
                    reason: "has a kind that does not exist",
                });
            };
            floors.push([end as u32; 2]);
            end += u64::from(floor);
            ceiling_count += u64::from(ceiling);
            Ok(())
        })?;
        floors.push([end as u32; 2]);
        let limit = u64::from(u32::MAX);
        if end > limit {
            return Err(ModelError::TooMany { what: "triangles of floors", found: end, limit });
        }
        Ok(Self {
            patterns,
            floors,
            waiting: Vec::new(),
            groups: Vec::new(),
            ceiling_count,
            dependencies: Dependencies::new(step_count),
            locals: Vec::new(),
            floor: Vec::new(),
            ceiling: Vec::new(),
            makers: Vec::new(),
        })
    }

    /// Number of triangles of all ceilings.
    pub(super) fn ceiling_count(&self) -> u64 {
        self.ceiling_count
    }

    /// Number of triangles of the full mesh, if the fragments fit together.
    pub(super) fn full_count(&self) -> u64 {
        let floor_count = u64::from(self.floors[self.floors.len() - 1][0]);
        (self.patterns.base.len() as u64 + self.ceiling_count).saturating_sub(floor_count)
    }

    /// Returns the steps with an empty floor.
    pub(super) fn floorless(&self) -> Vec<u32> {
        let is_floorless = |(step, ends): (u32, &[[u32; 2]])| (ends[0][0] == ends[1][0]).then_some(step);
        (0..).zip(self.floors.windows(2)).filter_map(is_floorless).collect()
    }

    /// Checks all fragments.
    ///
    /// # Errors
    /// [`ModelError`] naming the first step that contradicts others.
    pub(super) fn check(mut self) -> Result<(), ModelError> {
        self.place_base()?;
        let patterns = self.patterns;
        patterns.records.try_for_each_head(|step, head| {
            self.visit(step, head, VisitPurpose::Check)
                .map_err(|reason| ModelError::Step { step: step as usize, reason })
        })
    }

    /// Calls `visit` with the faces of the ceiling and of the floor of each step, in the order of its rule.
    ///
    /// # Errors
    /// See [`check`](Self::check).
    pub(super) fn for_each(mut self, mut visit: impl FnMut(&[Face], &[Face])) -> Result<(), ModelError> {
        self.place_base()?;
        let patterns = self.patterns;
        patterns.records.try_for_each_head(|step, head| {
            self.visit(step, head, VisitPurpose::Collect)
                .map_err(|reason| ModelError::Step { step: step as usize, reason })?;
            visit(&self.ceiling, &self.floor);
            Ok(())
        })
    }

    fn place_base(&mut self) -> Result<(), ModelError> {
        let count = self.floors[self.floors.len() - 1][0] as usize;
        self.waiting = vec![Waiting::default(); count];
        self.groups = if self.patterns.group_count > 1 { vec![0; count] } else { Vec::new() };
        let Patterns { vertices, group_count, .. } = self.patterns;
        for (place, face) in self.patterns.base.iter().enumerate() {
            let wrong = |reason| ModelError::Listed { what: "triangle of the base", place, reason };
            let [a, b, c] = face.corners;
            if a.max(b).max(c) >= vertices.base_vertex_count
                || a <= b.max(c)
                || b == c
                || face.group as usize >= *group_count
            {
                return Err(wrong("has corners or a group that do not exist"));
            }
            if face.above == NONE {
                continue;
            }
            if face.above as usize >= self.patterns.records.step_count {
                return Err(wrong("leads to a step that does not exist"));
            }
            if face.code >= 1 << 27 {
                return Err(wrong("leads to a corner that does not exist"));
            }
            let waiting = Waiting { corners: face.corners, location: run_location(face.code, 0) };
            self.place(face.above, waiting, face.group).map_err(wrong)?;
        }
        Ok(())
    }

    /// Places a triangle in the floor of a step.
    #[inline]
    fn place(&mut self, above: u32, waiting: Waiting, group: u32) -> Result<(), &'static str> {
        let end = self.floors[above as usize + 1][0];
        let next = &mut self.floors[above as usize][1];
        if *next >= end {
            return Err("leads to a step whose floor is complete");
        }
        self.waiting[*next as usize] = waiting;
        if let Some(slot) = self.groups.get_mut(*next as usize) {
            *slot = group;
        }
        *next += 1;
        Ok(())
    }

    #[inline]
    fn visit(&mut self, step: u32, head: &StepHead, task: VisitPurpose) -> Result<(), &'static str> {
        let patterns = self.patterns;
        let (rule, sharing) = patterns.kinds.get(head.kind);
        of_rule!(patterns.rules.rule(rule), rule => {
            self.start(step, head, &rule)?;
            self.read_floor(step, &rule, task)?;
            self.check_dependencies(head)?;
            self.place_ceiling(step, head, (&rule, sharing), task)
        })
    }

    /// Sets the vertices that the step restores, and those that it lists.
    #[inline]
    fn start<N: Number>(
        &mut self,
        step: u32,
        head: &StepHead,
        rule: &RuleView<'_, N>,
    ) -> Result<(), &'static str> {
        let Self { patterns, locals, .. } = self;
        let own = patterns.vertices.of_step(step as usize);
        let first = own.start;
        if own.len() != rule.own_count() {
            return Err("restores a different number of vertices than its rule");
        }
        if locals.len() < rule.local_count() {
            locals.resize(rule.local_count(), UNKNOWN);
        }
        locals[..rule.local_count()].fill(UNKNOWN);
        locals.iter_mut().zip(own).for_each(|(local, vertex)| *local = vertex);
        if rule.extra_count() != head.extra_count as usize {
            return Err("lists a different number of vertices than its rule");
        }
        if head.extra_count > 0 {
            for (local, distance) in rule.extras().zip(patterns.records.extras(head)) {
                let vertex = first.checked_sub(1).and_then(|last| last.checked_sub(distance));
                locals[local as usize] = vertex.ok_or("lists a vertex that does not exist")?;
            }
        }
        Ok(())
    }

    /// Finds the vertices of a fragment from its floor, and checks that the floor's triangles agree on them.
    #[inline]
    fn read_floor<N: Number>(
        &mut self,
        step: u32,
        rule: &RuleView<'_, N>,
        task: VisitPurpose,
    ) -> Result<(), &'static str> {
        let count = rule.floor_count();
        let [at, next] = self.floors[step as usize].map(|i| i as usize);
        if next - at != count {
            return Err("has fewer floor triangles than its rule");
        }
        if task == VisitPurpose::Collect {
            self.floor.clear();
            self.floor.resize(count, Face { corners: [UNKNOWN; 3], group: 0 });
        }
        let Self { patterns, waiting, groups, locals, makers, floor, .. } = self;
        makers.clear();
        // Which triangles of the floor have been found: bits, as long as they are few.
        let (mut few, mut many) = (0u64, Vec::new());
        if count > u64::BITS as usize {
            many.resize(count, false);
        }
        for (i, &Waiting { corners, location }) in (at..).zip(&waiting[at..next]) {
            let half_edge = rule.locate(location / MAX_RUN, location % MAX_RUN);
            let half_edge = half_edge.ok_or("has a floor triangle at a corner that does not exist")?;
            let j = half_edge as usize / 3;
            let is_known = match many.get_mut(j) {
                Some(known) => std::mem::replace(known, true),
                None => {
                    let before = few;
                    few |= 1 << j;
                    few == before
                }
            };
            if is_known {
                return Err("has two floor triangles in the same place");
            }
            let group = groups.get(i).copied().unwrap_or(0);
            if group != rule.group(rule.ceiling_count() + j) {
                return Err("has a floor triangle of a different group");
            }
            let triangle = rotated(rule.floor(j), half_edge % 3);
            for k in 0..3 {
                let known = &mut locals[triangle[k] as usize];
                if *known != corners[k] {
                    if *known != UNKNOWN {
                        return Err("has floor triangles that contradict each other");
                    }
                    *known = corners[k];
                }
            }
            if corners[0] >= patterns.vertices.base_vertex_count {
                // Triangles arrive in the order of the steps that create them.
                let maker = patterns.vertices.step_of(corners[0]) as u32;
                if makers.last() != Some(&maker) {
                    makers.push(maker);
                }
            }
            if task == VisitPurpose::Collect {
                floor[j] = Face { corners, group };
            }
        }
        Ok(())
    }

    /// Checks that the links down lead to the steps that create the floor, except for those that others need.
    #[inline]
    fn check_dependencies(&mut self, head: &StepHead) -> Result<(), &'static str> {
        let needed = self.dependencies.add(&self.makers);
        if needed.len() == head.down_count as usize
            && self.patterns.records.downs(head).zip(needed).all(|(below, needed)| below == *needed)
        {
            return Ok(());
        }
        Err("has links down that differ from the steps that create its floor")
    }

    /// Creates the triangles of a ceiling and places them in the floors above.
    #[inline]
    fn place_ceiling<N: Number>(
        &mut self,
        step: u32,
        head: &StepHead,
        (rule, sharing): (&RuleView<'_, N>, u32),
        task: VisitPurpose,
    ) -> Result<(), &'static str> {
        let patterns = self.patterns;
        let first = patterns.vertices.of_step(step as usize).start;
        let step_count = patterns.records.step_count;
        self.ceiling.clear();
        let mut link_count = 0;
        patterns.sharings.get(sharing).try_for_each_run(
            rule.ceiling_count(),
            |run, CeilingShare { link, offset }| {
                let mut location = offset;
                let mut above = step;
                if link != CeilingShare::FULL {
                    if link >= head.up_count {
                        return Err("has fewer links than its sharing");
                    }
                    link_count = link_count.max(link + 1);
                    let up = patterns.records.up(head, link);
                    above = up.above;
                    if above <= step || above as usize >= step_count {
                        return Err("has a link to a step that is not above it");
                    }
                    location = run_location(up.code, offset);
                }
                for s in run {
                    let corners @ [a, b, c] = vertices_of(&self.locals, rule.ceiling(s));
                    // A vertex that is not known is larger than all others.
                    if a < first || a <= b.max(c) || b == c || a == UNKNOWN {
                        return Err("has a triangle with a repeated, unknown or wrong corner");
                    }
                    let group = rule.group(s);
                    if task == VisitPurpose::Collect {
                        self.ceiling.push(Face { corners, group });
                    }
                    if above != step {
                        self.place(above, Waiting { corners, location }, group)?;
                        location += 1;
                    }
                }
                Ok(())
            },
        )?;
        if link_count == head.up_count { Ok(()) } else { Err("has more links than its sharing") }
    }
}
