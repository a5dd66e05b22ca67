//! Rules: pairs of patterns, found by a walk from the anchors.

use std::collections::{HashMap, VecDeque};
use std::ops::Range;

use striata::model::ModelError;

/// Number of rules that 16 bits can address.
const MAX_RULES: usize = 1 << 16;

/// Number of vertices that a byte can address.
const MAX_LOCALS: usize = 255;

/// The kind of a fragment, and the vertices that it is applied to.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct PatternShape {
    /// Counts of triangles of the ceiling and the floor, of own and of listed vertices; own vertices; listed
    /// vertices; the corners of the ceiling, then those of the floor, in the order of the walk.
    pub code: Vec<u8>,
    /// The anchors, then the listed vertices.
    pub vertices: Vec<u32>,
}

/// A rule in a table.
#[derive(Clone, Copy, Debug)]
pub(super) struct GeneralRule<'a> {
    /// Local vertices that the step restores, in the order of their numbers.
    pub own: &'a [u8],
    /// Other local vertices that either the ceiling or the floor lacks, so that each fragment lists them.
    pub listed: &'a [u8],
    pub ceiling: &'a [[u8; 3]],
    pub floor: &'a [[u8; 3]],
    pub local_count: usize,
}

impl<'a> GeneralRule<'a> {
    fn of_code(code: &'a [u8]) -> Self {
        let [ceiling_count, _, own_count, listed_count] = std::array::from_fn(|i| usize::from(code[i]));
        let (own, rest) = code[4..].split_at(own_count);
        let (listed, corners) = rest.split_at(listed_count);
        let (ceiling, floor) = corners.as_chunks().0.split_at(ceiling_count);
        let last = corners.iter().copied().max().map_or(0, usize::from);
        Self { own, listed, ceiling, floor, local_count: last + 1 }
    }
}

impl PatternShape {
    /// Determines the shape of a fragment that restores the vertices `own`.
    ///
    /// # Errors
    /// The property of the fragment that no rule can represent.
    pub(super) fn of(
        own: Range<u32>,
        ceiling: &[[u32; 3]],
        floor: &[[u32; 3]],
    ) -> Result<Self, &'static str> {
        if ceiling.len().max(floor.len()) > MAX_LOCALS / 3 || own.len() > MAX_LOCALS {
            return Err("has more triangles than a rule can have");
        }
        let [ceiling, floor] = [Pattern::new(ceiling)?, Pattern::new(floor)?];
        let mut best: Option<Self> = None;
        let mut why = "has a floor that shares no edge with its ceiling";
        let starts =
            if floor.triangles.is_empty() { ceiling.starts() } else { ceiling.common_borders(&floor) };
        for anchors in starts {
            match Self::from_anchors(anchors, own.clone(), [&ceiling, &floor]) {
                Ok(shape) => {
                    let is_better = best.as_ref().is_none_or(|best| {
                        // A pattern that looks the same from several edges begins at the smallest vertices.
                        (&shape.code, &shape.vertices) < (&best.code, &best.vertices)
                    });
                    if is_better {
                        best = Some(shape);
                    }
                }
                Err(reason) => why = reason,
            }
        }
        best.ok_or(why)
    }

    fn from_anchors(
        anchors: [u32; 2],
        own: Range<u32>,
        [ceiling, floor]: [&Pattern<'_>; 2],
    ) -> Result<Self, &'static str> {
        let mut locals = anchors.to_vec();
        let mut corners = Vec::new();
        ceiling.walk(anchors, &mut locals, &mut corners)?;
        let ceiling_locals = locals.len();
        floor.walk(anchors, &mut locals, &mut corners)?;
        if locals.len() > MAX_LOCALS {
            return Err("has more vertices than a rule can have");
        }
        let of_floor = &corners[3 * ceiling.triangles.len()..];
        let is_listed = |&local: &usize| {
            let is_shared = local < ceiling_locals && of_floor.contains(&(local as u8));
            !is_shared && !own.contains(&locals[local])
        };
        let listed: Vec<usize> = (2..locals.len()).filter(is_listed).collect();
        let counts = [ceiling.triangles.len(), floor.triangles.len(), own.len(), listed.len()];
        let mut code: Vec<u8> = counts.iter().map(|&count| count as u8).collect();
        for vertex in own {
            let local = locals[..ceiling_locals].iter().position(|&v| v == vertex);
            code.push(local.ok_or("restores a vertex that has no triangles")? as u8);
        }
        code.extend(listed.iter().map(|&local| local as u8));
        code.extend(corners);
        let vertices = anchors.into_iter().chain(listed.into_iter().map(|local| locals[local])).collect();
        Ok(Self { code, vertices })
    }
}

/// Triangles of a ceiling or a floor, and their directed edges.
struct Pattern<'a> {
    triangles: &'a [[u32; 3]],
    /// Directed edges, each with its triangle; sorted.
    sides: Vec<([u32; 2], usize)>,
}

impl<'a> Pattern<'a> {
    fn new(triangles: &'a [[u32; 3]]) -> Result<Self, &'static str> {
        let of =
            |(index, &[a, b, c]): (usize, &[u32; 3])| [([a, b], index), ([b, c], index), ([c, a], index)];
        let mut sides: Vec<_> = triangles.iter().enumerate().flat_map(of).collect();
        sides.sort_unstable();
        if sides.windows(2).any(|pair| pair[0].0 == pair[1].0) {
            return Err("has an edge in the same direction as another triangle");
        }
        Ok(Self { triangles, sides })
    }

    fn triangle_at(&self, side: [u32; 2]) -> Option<usize> {
        let at = self.sides.partition_point(|entry| entry.0 < side);
        self.sides.get(at).filter(|entry| entry.0 == side).map(|entry| entry.1)
    }

    fn is_border(&self, [a, b]: [u32; 2]) -> bool {
        self.triangle_at([a, b]).is_some() && self.triangle_at([b, a]).is_none()
    }

    /// The directed edges at the border of both patterns.
    fn common_borders(&self, other: &Self) -> Vec<[u32; 2]> {
        let sides = self.sides.iter().map(|entry| entry.0);
        sides.filter(|&side| self.is_border(side) && other.is_border(side)).collect()
    }

    /// The directed edges where a ceiling without a floor can begin: its border, or all edges without one.
    fn starts(&self) -> Vec<[u32; 2]> {
        let sides = || self.sides.iter().map(|entry| entry.0);
        let borders: Vec<_> = sides().filter(|&side| self.is_border(side)).collect();
        if borders.is_empty() { sides().collect() } else { borders }
    }

    /// Walks all triangles breadth first from a directed edge. Appends vertices that are not yet known to
    /// `locals`, and the corners of each triangle, beginning at the edge where the walk enters it.
    fn walk(
        &self,
        start: [u32; 2],
        locals: &mut Vec<u32>,
        corners: &mut Vec<u8>,
    ) -> Result<(), &'static str> {
        let mut waiting = VecDeque::from([start]);
        let mut is_visited = vec![false; self.triangles.len()];
        let mut count = 0;
        while let Some([x, y]) = waiting.pop_front() {
            let Some(triangle) = self.triangle_at([x, y]).filter(|&triangle| !is_visited[triangle]) else {
                continue;
            };
            is_visited[triangle] = true;
            count += 1;
            let z = self.triangles[triangle].iter().copied().find(|&v| v != x && v != y);
            let z = z.ok_or("has a triangle with a vertex twice")?;
            for vertex in [x, y, z] {
                let known = locals.iter().position(|&v| v == vertex);
                let local = known.unwrap_or_else(|| {
                    locals.push(vertex);
                    locals.len() - 1
                });
                corners.push(local as u8);
            }
            waiting.extend([[z, y], [x, z]]);
        }
        if count < self.triangles.len() {
            return Err("has triangles that are not connected by edges");
        }
        Ok(())
    }
}

/// All rules of a model, sorted by code.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct PatternRuleTable {
    codes: Vec<u8>,
    /// First byte of each code, followed by the total length.
    firsts: Vec<u32>,
}

impl PatternRuleTable {
    pub(super) fn len(&self) -> usize {
        self.firsts.len() - 1
    }

    #[inline]
    pub(super) fn get(&self, rule: usize) -> GeneralRule<'_> {
        GeneralRule::of_code(&self.codes[self.firsts[rule] as usize..self.firsts[rule + 1] as usize])
    }

    pub(super) fn bytes(&self) -> usize {
        self.codes.len() + 4 * self.firsts.len()
    }
}

/// Collects rules in order of appearance.
#[derive(Debug, Default)]
pub(super) struct PatternRuleFinder {
    indices: HashMap<Vec<u8>, u32>,
}

impl PatternRuleFinder {
    pub(super) fn index_of(&mut self, code: Vec<u8>) -> u32 {
        let next = self.indices.len() as u32;
        *self.indices.entry(code).or_insert(next)
    }

    /// Returns the table, and the new index of each rule in order of appearance.
    ///
    /// # Errors
    /// If 16 bits cannot address all rules.
    pub(super) fn finish(self) -> Result<(PatternRuleTable, Vec<u32>), ModelError> {
        if self.indices.len() > MAX_RULES {
            let (found, limit) = (self.indices.len() as u64, MAX_RULES as u64);
            return Err(ModelError::Form { what: "rules", found, limit });
        }
        let mut sorted: Vec<(Vec<u8>, u32)> = self.indices.into_iter().collect();
        sorted.sort_unstable();
        let mut table = PatternRuleTable { codes: Vec::new(), firsts: vec![0] };
        let mut new_indices = vec![0; sorted.len()];
        for (new, (code, old)) in (0..).zip(&sorted) {
            new_indices[*old as usize] = new;
            table.codes.extend_from_slice(code);
            table.firsts.push(table.codes.len() as u32);
        }
        Ok((table, new_indices))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Collapse of the edge 20 21 in a ring of eight vertices to the new vertex 9.
    fn edge_collapse(ring: [u32; 8]) -> (Vec<[u32; 3]>, Vec<[u32; 3]>) {
        let mut ceiling: Vec<_> = (0..4).map(|i| [20, ring[i], ring[i + 1]]).collect();
        ceiling.extend((4..8).map(|i| [21, ring[i], ring[(i + 1) % 8]]));
        ceiling.extend([[20, ring[4], 21], [21, ring[0], 20]]);
        (ceiling, (0..8).map(|i| [9, ring[i], ring[(i + 1) % 8]]).collect())
    }

    #[test]
    fn turned_fragments_have_one_rule() {
        let ring: [u32; 8] = std::array::from_fn(|i| 100 + (3 * i as u32) % 8);
        let (ceiling, floor) = edge_collapse(ring);
        let shape = PatternShape::of(20..22, &ceiling, &floor).unwrap();
        let mut turned = ceiling.clone();
        turned.rotate_left(3);
        turned.iter_mut().for_each(|triangle| triangle.rotate_left(1));
        assert_eq!(PatternShape::of(20..22, &turned, &floor).unwrap(), shape);
        let mut other = ring;
        other.rotate_left(4);
        // Only the numbers of the two restored vertices differ.
        let (ceiling, floor) = edge_collapse(other);
        let other = PatternShape::of(20..22, &ceiling, &floor).unwrap();
        assert_eq!(other.code, shape.code);
        let mut code_bytes = shape.code;
        code_bytes.swap(4, 5);
        assert_ne!(code_bytes, other.code);
        let table = PatternRuleTable { firsts: vec![0, other.code.len() as u32], codes: other.code };
        let rule = table.get(0);
        assert_eq!((rule.ceiling.len(), rule.floor.len(), rule.own.len()), (10, 8, 2));
        assert_eq!((rule.local_count, rule.listed), (11, &[10][..]));
        assert_eq!(other.vertices[2], 9);
    }

    #[test]
    fn fragments_without_a_rule_are_reported() {
        let reason =
            |ceiling: &[[u32; 3]], floor: &[[u32; 3]]| PatternShape::of(9..10, ceiling, floor).unwrap_err();
        assert_eq!(reason(&[[9, 0, 1]], &[[0, 2, 3]]), "has a floor that shares no edge with its ceiling");
        // Both neighbors are known: as anchors, or because they are listed.
        let attached = PatternShape::of(9..10, &[[9, 0, 1]], &[]).unwrap();
        assert!([0, 1].iter().all(|vertex| attached.vertices.contains(vertex)));
        assert_eq!(
            reason(&[[9, 0, 1], [9, 2, 3]], &[[0, 1, 2]]),
            "has triangles that are not connected by edges"
        );
        assert_eq!(
            reason(&[[9, 0, 1], [9, 0, 1]], &[[0, 1, 4]]),
            "has an edge in the same direction as another triangle"
        );
        assert_eq!(reason(&[[7, 0, 1]], &[[0, 1, 4]]), "restores a vertex that has no triangles");
    }
}
