//! The rules of fragments, each found once.
//!
//! Where the ceiling is one ring or one open run of triangles around one vertex, the others are numbered along it, and of
//! all places to begin the one with the smallest floor is taken. Everywhere else (seams, edges of many triangles) they are numbered as they
//! come: such fragments are right, and seldom share a rule.

use std::collections::HashMap;

use super::rule::{Rule, first_corner};
use super::rule_table::RuleTable;
use crate::mesh::{Face, FragmentSequence};

/// Rings longer than this, or over more triangles, are not turned: comparing all places to begin takes the product.
const MAX_TURNED: usize = 64;

/// Finds the rules of fragments.
pub(super) struct Rulebook<'a> {
    fragments: &'a FragmentSequence,
    is_grouped: bool,
    rules: Vec<Rule>,
    numbers: HashMap<Rule, u32>,
}

/// A fragment in the order of its rule.
#[derive(Debug, Default)]
pub(super) struct Matched {
    pub(super) rule: u32,
    /// Vertices by local number.
    pub(super) locals: Vec<u32>,
    /// Faces in the order of the rule's ceiling.
    pub(super) ceiling: Vec<u32>,
    /// Faces in the order of the rule's floor.
    pub(super) floor: Vec<u32>,
}

impl<'a> Rulebook<'a> {
    pub(super) fn new(fragments: &'a FragmentSequence, group_count: usize) -> Self {
        Self { fragments, is_grouped: group_count > 1, rules: Vec::new(), numbers: HashMap::new() }
    }

    /// A rule that was found; without what completes it.
    pub(super) fn rule(&self, number: u32) -> &Rule {
        &self.rules[number as usize]
    }

    /// The table of all rules so far; numbered as they came.
    pub(super) fn into_table(self) -> RuleTable {
        RuleTable::pack(self.rules)
    }

    /// The rule of a step's fragment, a new one if it is the first of its kind.
    pub(super) fn find(&mut self, step: u32) -> Matched {
        let own: Vec<u32> = self.fragments.levels().step_vertices(step as usize).collect();
        let ceiling: Vec<u32> = self.fragments.ceiling(step).collect();
        let is_small = ceiling.len().max(self.fragments.floor(step).len()) <= MAX_TURNED;
        let ring = if is_small { self.ring_of(&own, &ceiling) } else { None };
        let (rule, mut matched) = match ring {
            Some(ring) => self.turned(step, own[0], &ring),
            None => self.as_it_comes(step, own, ceiling),
        };
        let fresh = self.rules.len() as u32;
        matched.rule = *self.numbers.entry(rule).or_insert_with_key(|rule| {
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

    /// The triangles around the only restored vertex as one ring or one open run, if they are that.
    fn ring_of(&self, own: &[u32], ceiling: &[u32]) -> Option<Ring> {
        let &[center] = own else { return None };
        let mut arcs = Vec::with_capacity(ceiling.len());
        for &face in ceiling {
            let [_, from, to] = first_corner(self.face(face).corners, center);
            arcs.push((from, to, face));
        }
        Ring::of(arcs)
    }

    /// The fragment with its ring begun at each place in turn: the one with the smallest floor.
    fn turned(&self, step: u32, center: u32, ring: &Ring) -> (Rule, Matched) {
        let floor_faces = self.fragments.floor(step);
        let turns = if ring.is_closed { ring.vertices.len() } else { 1 };
        let Some(places) = self.places_on(ring, floor_faces) else {
            // A vertex of the floor is not on the ring: the target lies elsewhere.
            return self.as_it_comes(step, vec![center], self.fragments.ceiling(step).collect());
        };
        let mut best: Option<(Vec<Placed>, Vec<u32>, usize)> = None;
        for turn in 0..turns {
            let floor = turned_floor(&places, ring.vertices.len(), turn);
            let mut faces = ring.faces.clone();
            faces.rotate_left(turn);
            let groups = self.groups(&faces);
            let is_less = best.as_ref().is_none_or(|(old, old_groups, _)| {
                let order = floor.iter().map(Placed::shape).cmp(old.iter().map(Placed::shape));
                order.then_with(|| groups.cmp(old_groups)).is_lt()
            });
            if is_less {
                best = Some((floor, groups, turn));
            }
        }
        let (floor, ceiling_groups, turn) = best.expect("a ring has a first place");
        let count = ring.vertices.len();
        let local = |place: usize| 1 + (place % count) as u32;
        let mut faces = ring.faces.clone();
        faces.rotate_left(turn);
        let locals = std::iter::once(center).chain((0..count).map(|i| ring.vertices[(i + turn) % count]));
        let floor_faces = floor.iter().map(|placed| placed.face).collect::<Vec<_>>();
        let rule = Rule {
            own_count: 1,
            local_count: 1 + count as u32,
            ceiling: (0..faces.len()).map(|s| [0, local(s), local(s + 1)]).collect(),
            floor: floor.iter().map(|placed| placed.locals).collect(),
            ceiling_groups,
            floor_groups: self.groups(&floor_faces),
            ..Rule::default()
        };
        (rule, Matched { rule: 0, locals: locals.collect(), ceiling: faces, floor: floor_faces })
    }

    /// Faces by the places of their corners on a ring; none if a corner is not on it.
    fn places_on(&self, ring: &Ring, faces: &[u32]) -> Option<Vec<Placed>> {
        let mut out = Vec::with_capacity(faces.len());
        for &number in faces {
            let face = self.face(number);
            let mut locals = [0; 3];
            for (local, corner) in locals.iter_mut().zip(face.corners) {
                *local = ring.vertices.iter().position(|&v| v == corner)? as u32;
            }
            let group = if self.is_grouped { face.group } else { 0 };
            out.push(Placed { locals, group, face: number });
        }
        Some(out)
    }

    /// The fragment with its vertices numbered in the order in which its triangles name them.
    fn as_it_comes(&self, step: u32, own: Vec<u32>, ceiling: Vec<u32>) -> (Rule, Matched) {
        let own_count = own.len() as u32;
        let mut numbers: HashMap<u32, u32> = own.iter().copied().zip(0..).collect();
        let mut locals = own;
        let floor = self.fragments.floor(step).to_vec();
        // Begun with the youngest: what is unpacked again is then numbered as it was.
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

/// A triangle of a floor in local numbers.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
struct Placed {
    locals: [u32; 3],
    group: u32,
    face: u32,
}

impl Placed {
    fn shape(&self) -> ([u32; 3], u32) {
        (self.locals, self.group)
    }
}

/// A floor with the ring of so many vertices begun at a place, sorted.
fn turned_floor(places: &[Placed], count: usize, turn: usize) -> Vec<Placed> {
    let local = |place: u32| 1 + ((place as usize + count - turn) % count) as u32;
    let turned = places.iter().map(|&placed| {
        let [a, b, c] = placed.locals.map(local);
        Placed { locals: first_corner([a, b, c], a.min(b).min(c)), ..placed }
    });
    let mut out: Vec<Placed> = turned.collect();
    out.sort_unstable();
    out
}

/// Triangles around a vertex that follow each other.
struct Ring {
    is_closed: bool,
    vertices: Vec<u32>,
    faces: Vec<u32>,
}

impl Ring {
    /// From (corner after the center, corner after that, face); none where they are not one run that passes no vertex
    /// twice.
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
