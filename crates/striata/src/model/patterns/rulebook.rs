//! Finds the rule of each fragment, adding new rules as they occur.
//!
//! If the ceiling is a ring or an open run of triangles around one vertex, the other vertices are numbered
//! along it, starting at the rotation that yields the smallest floor. Otherwise (seams, non-manifold edges)
//! vertices are numbered in order of first use; such fragments are valid too, but rarely share a rule.

use std::collections::HashMap;

use super::rule::{Rule, first_corner};
use super::rule_table::RuleTable;
use crate::mesh::{Face, FragmentSequence};

/// Fragments with more triangles than this are not rotated, because comparing all rotations takes
/// quadratic time.
const MAX_ROTATED: usize = 64;

/// The rules found so far.
pub(super) struct Rulebook<'a> {
    fragments: &'a FragmentSequence,
    is_grouped: bool,
    rules: Vec<Rule>,
    indices: HashMap<Rule, u32>,
}

/// A fragment in the order of its rule.
#[derive(Debug, Default)]
pub(super) struct Matched {
    pub(super) rule: u32,
    /// Vertex for each local index.
    pub(super) locals: Vec<u32>,
    /// Faces in the order of the rule's ceiling.
    pub(super) ceiling: Vec<u32>,
    /// Faces in the order of the rule's floor.
    pub(super) floor: Vec<u32>,
}

impl<'a> Rulebook<'a> {
    pub(super) fn new(fragments: &'a FragmentSequence, group_count: usize) -> Self {
        Self { fragments, is_grouped: group_count > 1, rules: Vec::new(), indices: HashMap::new() }
    }

    /// Returns a rule found earlier, without derived fields.
    pub(super) fn rule(&self, number: u32) -> &Rule {
        &self.rules[number as usize]
    }

    /// Converts the rules to a table, in the order in which they were found.
    pub(super) fn into_table(self) -> RuleTable {
        RuleTable::pack(self.rules)
    }

    /// Returns the rule of a step's fragment, which is a new rule if the fragment is the first of its kind.
    pub(super) fn find(&mut self, step: u32) -> Matched {
        let own: Vec<u32> = self.fragments.levels().step_vertices(step as usize).collect();
        let ceiling: Vec<u32> = self.fragments.ceiling(step).collect();
        let is_small = ceiling.len().max(self.fragments.floor(step).len()) <= MAX_ROTATED;
        let ring = if is_small { self.ring_of(&own, &ceiling) } else { None };
        let (rule, mut matched) = match ring {
            Some(ring) => self.match_ring(step, own[0], &ring),
            None => self.match_by_first_use(step, own, ceiling),
        };
        let fresh = self.rules.len() as u32;
        matched.rule = *self.indices.entry(rule).or_insert_with_key(|rule| {
            self.rules.push(rule.clone());
            fresh
        });
        matched
    }

    fn face(&self, face: u32) -> Face {
        self.fragments.faces()[face as usize]
    }

    fn groups(&self, faces: &[u32]) -> Vec<u32> {
        if self.is_grouped { faces.iter().map(|&face| self.face(face).group).collect() } else { Vec::new() }
    }

    /// Returns the triangles around the only restored vertex, if they form one ring or one open run.
    fn ring_of(&self, own: &[u32], ceiling: &[u32]) -> Option<Ring> {
        let &[center] = own else { return None };
        let mut arcs = Vec::with_capacity(ceiling.len());
        for &face in ceiling {
            let [_, from, to] = first_corner(self.face(face).corners, center);
            arcs.push((from, to, face));
        }
        Ring::of(arcs)
    }

    /// Numbers the vertices along the ring, using the rotation that yields the smallest floor.
    fn match_ring(&self, step: u32, center: u32, ring: &Ring) -> (Rule, Matched) {
        let floor_faces = self.fragments.floor(step);
        let turns = if ring.is_closed { ring.vertices.len() } else { 1 };
        let Some(triangles) = self.local_triangles(ring, floor_faces) else {
            // A vertex of the floor is not on the ring, because the target is elsewhere.
            return self.match_by_first_use(step, vec![center], self.fragments.ceiling(step).collect());
        };
        let mut best: Option<(Vec<LocalTriangle>, Vec<u32>, usize)> = None;
        for turn in 0..turns {
            let floor = rotated_floor(&triangles, ring.vertices.len(), turn);
            let mut faces = ring.faces.clone();
            faces.rotate_left(turn);
            let groups = self.groups(&faces);
            let is_less = best.as_ref().is_none_or(|(old, old_groups, _)| {
                let order = floor.iter().map(LocalTriangle::shape).cmp(old.iter().map(LocalTriangle::shape));
                order.then_with(|| groups.cmp(old_groups)).is_lt()
            });
            if is_less {
                best = Some((floor, groups, turn));
            }
        }
        let (floor, ceiling_groups, turn) = best.expect("a ring has a vertex");
        let count = ring.vertices.len();
        let local = |i: usize| 1 + (i % count) as u32;
        let mut faces = ring.faces.clone();
        faces.rotate_left(turn);
        let locals = std::iter::once(center).chain((0..count).map(|i| ring.vertices[(i + turn) % count]));
        let floor_faces = floor.iter().map(|triangle| triangle.face).collect::<Vec<_>>();
        let rule = Rule {
            own_count: 1,
            local_count: 1 + count as u32,
            ceiling: (0..faces.len()).map(|s| [0, local(s), local(s + 1)]).collect(),
            floor: floor.iter().map(|triangle| triangle.locals).collect(),
            ceiling_groups,
            floor_groups: self.groups(&floor_faces),
            ..Rule::default()
        };
        (rule, Matched { rule: 0, locals: locals.collect(), ceiling: faces, floor: floor_faces })
    }

    /// Expresses faces by the indices of their corners on a ring; `None` if a corner is not on it.
    fn local_triangles(&self, ring: &Ring, faces: &[u32]) -> Option<Vec<LocalTriangle>> {
        let mut out = Vec::with_capacity(faces.len());
        for &index in faces {
            let face = self.face(index);
            let mut locals = [0; 3];
            for (local, corner) in locals.iter_mut().zip(face.corners) {
                *local = ring.vertices.iter().position(|&v| v == corner)? as u32;
            }
            let group = if self.is_grouped { face.group } else { 0 };
            out.push(LocalTriangle { locals, group, face: index });
        }
        Some(out)
    }

    /// Numbers the vertices in the order in which the triangles use them.
    fn match_by_first_use(&self, step: u32, own: Vec<u32>, ceiling: Vec<u32>) -> (Rule, Matched) {
        let own_count = own.len() as u32;
        let mut numbers: HashMap<u32, u32> = own.iter().copied().zip(0..).collect();
        let mut locals = own;
        let floor = self.fragments.floor(step).to_vec();
        // The youngest corner comes first, so that unpacked fragments are numbered in the same way.
        let mut localize = |face: u32| {
            let [a, b, c] = self.fragments.faces()[face as usize].corners;
            first_corner([a, b, c], a.max(b).max(c)).map(|v| {
                *numbers.entry(v).or_insert_with(|| {
                    locals.push(v);
                    locals.len() as u32 - 1
                })
            })
        };
        let ceiling_locals = ceiling.iter().map(|&face| localize(face)).collect();
        let floor_locals = floor.iter().map(|&face| localize(face)).collect();
        let rule = Rule {
            own_count,
            local_count: locals.len() as u32,
            ceiling: ceiling_locals,
            floor: floor_locals,
            ceiling_groups: self.groups(&ceiling),
            floor_groups: self.groups(&floor),
            ..Rule::default()
        };
        (rule, Matched { rule: 0, locals, ceiling, floor })
    }
}

/// A triangle of a floor in local vertex indices.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
struct LocalTriangle {
    locals: [u32; 3],
    group: u32,
    face: u32,
}

impl LocalTriangle {
    fn shape(&self) -> ([u32; 3], u32) {
        (self.locals, self.group)
    }
}

/// Returns a floor after rotating a ring of `count` vertices by `turn`, sorted.
fn rotated_floor(triangles: &[LocalTriangle], count: usize, turn: usize) -> Vec<LocalTriangle> {
    let local = |i: u32| 1 + ((i as usize + count - turn) % count) as u32;
    let rotated = triangles.iter().map(|&triangle| {
        let [a, b, c] = triangle.locals.map(local);
        LocalTriangle { locals: first_corner([a, b, c], a.min(b).min(c)), ..triangle }
    });
    let mut out: Vec<LocalTriangle> = rotated.collect();
    out.sort_unstable();
    out
}

/// Consecutive triangles around a vertex.
struct Ring {
    is_closed: bool,
    vertices: Vec<u32>,
    faces: Vec<u32>,
}

impl Ring {
    /// Builds a ring from arcs (corner after the center, corner after that, face). `None` if they do not
    /// form a single run without repeated vertices.
    fn of(mut arcs: Vec<(u32, u32, u32)>) -> Option<Self> {
        let is_end = |v: u32| arcs.iter().any(|arc| arc.1 == v);
        let starts = arcs.iter().filter(|arc| !is_end(arc.0)).count();
        let first = match starts {
            0 => arcs.iter().map(|arc| arc.0).min()?,
            1 => arcs.iter().find(|arc| !is_end(arc.0))?.0,
            _ => return None,
        };
        let mut ring = Self { is_closed: starts == 0, vertices: vec![first], faces: Vec::new() };
        let mut at = first;
        while let Some(found) = arcs.iter().position(|arc| arc.0 == at) {
            let (_, to, face) = arcs.swap_remove(found);
            ring.faces.push(face);
            at = to;
            if at == first {
                break;
            }
            if ring.vertices.contains(&at) {
                return None;
            }
            ring.vertices.push(at);
        }
        (arcs.is_empty() && ring.is_closed == (at == first)).then_some(ring)
    }
}
