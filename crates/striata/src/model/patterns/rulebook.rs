//! Finds the rule of each fragment, adding new rules as they occur.
//!
//! If the border of the ceiling is one simple loop, vertices are numbered along it, from the place that yields the
//! smallest triangles. Otherwise (seams, non-manifold edges) vertices are numbered in order of first use; such fragments
//! are valid too, but rarely share a rule.

use std::cmp::Reverse;
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
    pub rule: u32,
    /// Vertex for each local index.
    pub locals: Vec<u32>,
    /// Faces in the order of the rule's ceiling.
    pub ceiling: Vec<u32>,
    /// Faces in the order of the rule's floor.
    pub floor: Vec<u32>,
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
        let border = if is_small { self.border_of(&own, &ceiling) } else { None };
        let (rule, mut matched) = match border {
            Some(border) => self.match_border(step, &own, &border),
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

    /// Returns the border of a ceiling from its smallest vertex on; `None` if it is not one simple loop, or if other
    /// vertices than those that the step restores are inside.
    fn border_of(&self, own: &[u32], ceiling: &[u32]) -> Option<Vec<u32>> {
        let sides = |&face: &u32| {
            let [a, b, c] = self.face(face).corners;
            [[a, b], [b, c], [c, a]]
        };
        let mut sides: Vec<[u32; 2]> = ceiling.iter().flat_map(sides).collect();
        sides.sort_unstable();
        if sides.windows(2).any(|pair| pair[0] == pair[1]) {
            return None;
        }
        let is_border = |&[a, b]: &[u32; 2]| sides.binary_search(&[b, a]).is_err();
        let outer: Vec<[u32; 2]> = sides.iter().copied().filter(is_border).collect();
        let first = outer.first()?[0];
        let mut border = vec![first];
        loop {
            let mut after = outer.iter().filter(|side| side[0] == border[border.len() - 1]);
            let (Some(&[_, next]), None) = (after.next(), after.next()) else { return None };
            if next == first {
                break;
            }
            if border.len() == outer.len() {
                return None;
            }
            border.push(next);
        }
        let is_known = |side: &[u32; 2]| own.contains(&side[0]) || border.contains(&side[0]);
        (border.len() == outer.len() && sides.iter().all(is_known)).then_some(border)
    }

    /// Numbers the vertices along the border of the ceiling, from the place that yields the smallest triangles. On a
    /// border with restored vertices, it begins after one of them.
    fn match_border(&self, step: u32, own: &[u32], border: &[u32]) -> (Rule, Matched) {
        let [ceiling, floor]: [Vec<u32>; 2] =
            [self.fragments.ceiling(step).collect(), self.fragments.floor(step).to_vec()];
        let elsewhere = self.floor_vertices_elsewhere(own, border, &floor);
        let count = border.len();
        let is_own = |place: usize| own.contains(&border[place % count]);
        let has_own = (0..count).any(is_own);
        let turns = (0..count).filter(|&turn| !has_own || (!is_own(turn) && is_own(turn + count - 1)));
        let numbered = turns.map(|turn| {
            let around = (0..count).map(|i| border[(i + turn) % count]).filter(|v| !own.contains(v));
            let locals: Vec<u32> =
                own.iter().copied().chain(around).chain(elsewhere.iter().copied()).collect();
            let [ceiling, floor] = [&ceiling, &floor].map(|faces| self.numbered(faces, &locals));
            (fans(ceiling, own.len() as u32), floor, locals)
        });
        let shapes = |triangles: &[LocalTriangle]| {
            triangles.iter().map(|triangle| triangle.locals).collect::<Vec<_>>()
        };
        let groups =
            |triangles: &[LocalTriangle]| triangles.iter().map(|triangle| triangle.group).collect::<Vec<_>>();
        let least = numbered.min_by_key(|(ceiling, floor, _)| {
            (shapes(ceiling), floor.iter().map(LocalTriangle::shape).collect::<Vec<_>>(), groups(ceiling))
        });
        let Some((ceiling, floor, locals)) = least else {
            // The border has only restored vertices.
            return self.match_by_first_use(step, own.to_vec(), ceiling);
        };
        let groups = |triangles| if self.is_grouped { groups(triangles) } else { Vec::new() };
        let rule = Rule {
            own_count: own.len() as u32,
            local_count: locals.len() as u32,
            ceiling: shapes(&ceiling),
            floor: shapes(&floor),
            ceiling_groups: groups(&ceiling),
            floor_groups: groups(&floor),
            ..Rule::default()
        };
        let [ceiling, floor] = [ceiling, floor].map(|all| all.iter().map(|triangle| triangle.face).collect());
        (rule, Matched { rule: 0, locals, ceiling, floor })
    }

    /// Returns the vertices of a floor that are not on the border: new vertices that only the floor has, or a target
    /// elsewhere. The youngest comes first.
    fn floor_vertices_elsewhere(&self, own: &[u32], border: &[u32], floor: &[u32]) -> Vec<u32> {
        let mut found: Vec<u32> = floor.iter().flat_map(|&face| self.face(face).corners).collect();
        found.retain(|v| !border.contains(v) && !own.contains(v));
        found.sort_unstable_by_key(|&v| Reverse(v));
        found.dedup();
        found
    }

    /// Expresses faces by the places of their corners among `locals`, sorted.
    fn numbered(&self, faces: &[u32], locals: &[u32]) -> Vec<LocalTriangle> {
        let number =
            |v: u32| locals.iter().position(|&local| local == v).expect("all vertices are numbered") as u32;
        let mut out: Vec<LocalTriangle> = faces
            .iter()
            .map(|&index| {
                let face = self.face(index);
                let [a, b, c] = face.corners.map(number);
                let group = if self.is_grouped { face.group } else { 0 };
                LocalTriangle { locals: first_corner([a, b, c], a.min(b).min(c)), group, face: index }
            })
            .collect();
        out.sort_unstable();
        out
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

/// A triangle in local vertex indices.
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

/// Sorts the triangles of a ceiling by their youngest vertices, those of each vertex in their order around it, so that
/// as many as possible follow each other in the floors above.
fn fans(mut triangles: Vec<LocalTriangle>, own_count: u32) -> Vec<LocalTriangle> {
    for triangle in &mut triangles {
        let youngest = triangle.locals.into_iter().filter(|&local| local < own_count).max();
        triangle.locals = first_corner(triangle.locals, youngest.unwrap_or(triangle.locals[0]));
    }
    triangles.sort_unstable();
    let mut sorted: Vec<LocalTriangle> = Vec::with_capacity(triangles.len());
    while !triangles.is_empty() {
        let [center, ..] = triangles[0].locals;
        let around = |triangle: &&LocalTriangle| triangle.locals[0] == center;
        let is_preceded = |at: &LocalTriangle| {
            triangles.iter().filter(around).any(|triangle| triangle.locals[2] == at.locals[1])
        };
        let first = triangles.iter().take_while(around).position(|triangle| !is_preceded(triangle));
        let mut next = Some(first.unwrap_or(0));
        while let Some(at) = next {
            let triangle = triangles.remove(at);
            sorted.push(triangle);
            next =
                triangles.iter().take_while(around).position(|after| after.locals[1] == triangle.locals[2]);
        }
    }
    sorted
}
