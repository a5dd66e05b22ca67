//! Rules: the shapes of fragments, independent of where they are in the mesh.
//!
//! A ceiling is the fan around the removed vertex. Kinds of fragments therefore differ only in the number
//! of ring corners, in whether the ring is closed, and in how the floor triangulates it. With the ring
//! corners numbered counterclockwise, the floor is a binary tree: the triangle at side 0 1 has an apex,
//! which leaves a smaller ring on either side, and so on.
//!
//! ```text
//!        3                 side 0 1 -> apex 3: ring 1 2 3 and ring 3 4 0
//!       /|\                side 3 1 -> apex 2
//!     4  | 2               side 0 3 -> apex 4
//!      \ |/
//!       0-1                code: closed, 3 2 4
//! ```
//!
//! Of all corners at which a closed ring can begin, the one with the smallest code is chosen. The mirror
//! image of a floor has a different code. An open ring, at a border of the mesh, begins where the border
//! enters it.

use std::collections::HashMap;

use striata::model::ModelError;

/// Number of rules that 12 bits can address.
pub(super) const MAX_RULES: usize = 1 << 12;

/// Number of ring corners that a byte can address.
const MAX_RING: usize = 255;

/// The surroundings of a fragment: its ring, beginning at the anchors, and its code.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(in crate::baseline) struct LoopShape {
    /// Vertices of the ring; the first two are the anchors.
    pub ring: Vec<u32>,
    /// 1 for an open ring or else 0, then the apexes: each triangle before its left part, and that before
    /// its right part.
    pub code: Vec<u8>,
}

/// A rule in a table.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::baseline) struct LoopRule<'a> {
    /// Whether the ring is open.
    pub is_open: bool,
    /// Apexes of the floor's triangles, in the order of the code.
    pub apexes: &'a [u8],
}

impl<'a> LoopRule<'a> {
    pub(in crate::baseline) fn of_code(code: &'a [u8]) -> Self {
        Self { is_open: code[0] != 0, apexes: &code[1..] }
    }

    /// Whether the apexes fill the ring completely.
    pub(in crate::baseline) fn is_tree(self) -> bool {
        let n = self.ring_len();
        let mut rings = if n > 2 { vec![(1, n)] } else { Vec::new() };
        for &apex in self.apexes {
            let m = usize::from(apex);
            match rings.pop() {
                Some((i, j)) if i < m && m < j => {
                    rings.extend([(m, j), (i, m)].into_iter().filter(|&(i, j)| j - i > 1));
                }
                _ => return false,
            }
        }
        rings.is_empty()
    }

    /// Number of ring corners.
    pub(in crate::baseline) fn ring_len(self) -> usize {
        self.apexes.len() + 2
    }

    /// Number of triangles in the ceiling.
    pub(in crate::baseline) fn ceiling_len(self) -> usize {
        self.ring_len() - usize::from(self.is_open)
    }
}

impl LoopShape {
    /// Determines the shape of a fragment from its triangles.
    ///
    /// # Errors
    /// The property of the fragment that no rule can represent.
    pub(in crate::baseline) fn of(
        vertex: u32,
        ceiling: &[[u32; 3]],
        floor: &[[u32; 3]],
    ) -> Result<Self, &'static str> {
        let (mut ring, is_open) = ring_of(vertex, ceiling)?;
        let n = ring.len();
        if floor.len() + 2 != n || n < if is_open { 2 } else { 3 } {
            return Err("has a floor that does not fill the hole");
        }
        let sides = sides_of(&ring, floor)?;
        let starts = if is_open { 1 } else { n };
        let mut best: Option<(Vec<u8>, usize)> = None;
        for start in 0..starts {
            let code =
                code_from(&sides, n, start, is_open).ok_or("has a floor that does not fill the hole")?;
            let is_better = best.as_ref().is_none_or(|(least, at)| {
                // If a floor looks the same from several corners, start at the one with the smallest vertex.
                code.cmp(least).then(ring[start].cmp(&ring[*at])).is_lt()
            });
            if is_better {
                best = Some((code, start));
            }
        }
        let (code, start) = best.ok_or("has an empty ring")?;
        ring.rotate_left(start);
        Ok(Self { ring, code })
    }
}

/// The neighbors of a vertex, counterclockwise, and whether the ring is open.
fn ring_of(vertex: u32, ceiling: &[[u32; 3]]) -> Result<(Vec<u32>, bool), &'static str> {
    const NO_FAN: &str = "removes a vertex whose triangles are not one fan";
    if ceiling.is_empty() {
        return Err("removes a vertex without triangles");
    }
    if ceiling.len() > MAX_RING {
        return Err("removes a vertex with more than 255 triangles");
    }
    let arc = |t: &[u32; 3]| {
        let turn = t.iter().position(|&v| v == vertex)?;
        Some([t[(turn + 1) % 3], t[(turn + 2) % 3]])
    };
    let mut arcs = ceiling.iter().map(arc).collect::<Option<Vec<_>>>().ok_or(NO_FAN)?;
    let ends = |v: u32| arcs.iter().any(|arc| arc[1] == v);
    let start = arcs.iter().map(|arc| arc[0]).find(|&v| !ends(v));
    let is_open = start.is_some();
    let mut ring = vec![start.unwrap_or(arcs[0][0])];
    while let Some(at) = arcs.iter().position(|arc| arc[0] == ring[ring.len() - 1]) {
        ring.push(arcs.swap_remove(at)[1]);
        if ring.len() > MAX_RING + 1 {
            break;
        }
    }
    if !is_open && ring.pop() != Some(ring[0]) {
        return Err(NO_FAN);
    }
    let mut sorted = ring.clone();
    sorted.sort_unstable();
    let is_simple = sorted.windows(2).all(|w| w[0] != w[1]) && !ring.contains(&vertex);
    if !arcs.is_empty() || !is_simple {
        return Err(NO_FAN);
    }
    if ring.len() > MAX_RING {
        return Err("removes a vertex with more than 255 triangles");
    }
    Ok((ring, is_open))
}

/// The directed edges of a floor's triangles as ring corners, each with the apex to its left; sorted.
fn sides_of(ring: &[u32], floor: &[[u32; 3]]) -> Result<Vec<[u8; 3]>, &'static str> {
    let mut corner_of: Vec<(u32, u8)> = ring.iter().copied().zip(0..).collect();
    corner_of.sort_unstable();
    let corner = |v: u32| {
        let at = corner_of.binary_search_by_key(&v, |entry| entry.0).ok()?;
        Some(corner_of[at].1)
    };
    let mut sides = Vec::with_capacity(3 * floor.len());
    for t in floor {
        let [a, b, c] = t.map(corner);
        let (Some(a), Some(b), Some(c)) = (a, b, c) else {
            return Err("has a floor with a vertex that is not a neighbor of the removed one");
        };
        sides.extend([[a, b, c], [b, c, a], [c, a, b]]);
    }
    sides.sort_unstable();
    Ok(sides)
}

/// The code of a floor whose ring begins at corner `start`, or `None` if the floor does not triangulate
/// the ring.
fn code_from(sides: &[[u8; 3]], n: usize, start: usize, is_open: bool) -> Option<Vec<u8>> {
    let mut code = vec![u8::from(is_open)];
    let mut rings = if n > 2 { vec![(1, n)] } else { Vec::new() };
    while let Some((i, j)) = rings.pop() {
        let side = [j, i].map(|corner| ((corner + start) % n) as u8);
        let at = sides.partition_point(|entry| entry[..2] < side[..]);
        let apex = sides.get(at).filter(|entry| entry[..2] == side[..])?[2];
        let m = (usize::from(apex) + n - start) % n;
        if m <= i || m >= j {
            return None;
        }
        code.push(m as u8);
        rings.extend([(m, j), (i, m)].into_iter().filter(|&(i, j)| j - i > 1));
    }
    Some(code)
}

/// All rules of a model, sorted by code.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(in crate::baseline) struct LoopRuleTable {
    codes: Vec<u8>,
    /// First byte of each code, followed by the total length.
    firsts: Vec<u32>,
}

impl LoopRuleTable {
    pub(in crate::baseline) fn of<'a>(codes: impl Iterator<Item = &'a [u8]>) -> Self {
        let mut table = Self { codes: Vec::new(), firsts: vec![0] };
        for code in codes {
            table.codes.extend_from_slice(code);
            table.firsts.push(table.codes.len() as u32);
        }
        table
    }

    pub(in crate::baseline) fn len(&self) -> usize {
        self.firsts.len() - 1
    }

    pub(in crate::baseline) fn code(&self, rule: usize) -> &[u8] {
        &self.codes[self.firsts[rule] as usize..self.firsts[rule + 1] as usize]
    }

    #[inline]
    pub(in crate::baseline) fn get(&self, rule: usize) -> LoopRule<'_> {
        LoopRule::of_code(self.code(rule))
    }

    pub(super) fn bytes(&self) -> usize {
        self.codes.len() + 4 * self.firsts.len()
    }
}

/// Collects rules in order of appearance and finds them by the hash of their code.
#[derive(Debug, Default)]
pub(super) struct RuleFinder {
    indices: HashMap<Vec<u8>, u32>,
}

impl RuleFinder {
    pub(super) fn index_of(&mut self, code: Vec<u8>) -> u32 {
        let next = self.indices.len() as u32;
        *self.indices.entry(code).or_insert(next)
    }

    /// Returns the table, and the new index of each rule in order of appearance.
    ///
    /// # Errors
    /// If 12 bits cannot address all rules.
    pub(super) fn finish(self) -> Result<(LoopRuleTable, Vec<u32>), ModelError> {
        if self.indices.len() > MAX_RULES {
            let (found, limit) = (self.indices.len() as u64, MAX_RULES as u64);
            return Err(ModelError::Form { what: "rules", found, limit });
        }
        let mut sorted: Vec<(Vec<u8>, u32)> = self.indices.into_iter().collect();
        sorted.sort_unstable_by(|(a, _), (b, _)| (a.len(), a).cmp(&(b.len(), b)));
        let mut new_indices = vec![0; sorted.len()];
        sorted
            .iter()
            .zip(0..)
            .for_each(|((_, old_index), new_index)| new_indices[*old_index as usize] = new_index);
        Ok((LoopRuleTable::of(sorted.iter().map(|(code, _)| &code[..])), new_indices))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The fan of vertex 9 around a ring.
    fn fan(ring: &[u32], is_open: bool) -> Vec<[u32; 3]> {
        let count = ring.len() - usize::from(is_open);
        (0..count).map(|i| [ring[i], ring[(i + 1) % ring.len()], 9]).collect()
    }

    #[test]
    fn code_of_the_drawing_is_as_documented() {
        let floor = [[0, 1, 3], [1, 2, 3], [0, 3, 4]];
        let shape = LoopShape::of(9, &fan(&[0, 1, 2, 3, 4], true), &floor).unwrap();
        assert_eq!((shape.ring, shape.code), (vec![0, 1, 2, 3, 4], vec![1, 3, 2, 4]));
    }

    #[test]
    fn rotated_floors_are_equal_and_mirrored_ones_are_not() {
        let zigzag = |turn: u32| {
            let at = |i: u32| (i + turn) % 6;
            let floor = [[0, 1, 5], [1, 2, 5], [2, 4, 5], [2, 3, 4]].map(|t| t.map(at));
            LoopShape::of(9, &fan(&[0, 1, 2, 3, 4, 5], false), &floor).unwrap()
        };
        assert!((1..6).all(|turn| zigzag(turn).code == zigzag(0).code));
        // The zigzag looks the same from its other end, so the ring begins at the smaller of the two
        // vertices.
        assert!(zigzag(3).ring == zigzag(0).ring && zigzag(1).ring == zigzag(4).ring);
        let mirrored = [[0, 1, 5], [1, 4, 5], [1, 2, 4], [2, 3, 4]];
        let mirrored = LoopShape::of(9, &fan(&[0, 1, 2, 3, 4, 5], false), &mirrored).unwrap();
        assert_ne!(mirrored.code, zigzag(0).code);
    }

    /// Triangulations of a ring up to rotation: 1, 1, 1, 4, 6, 19 for three to eight corners.
    #[test]
    fn rule_count_matches_the_triangulations_of_a_polygon() {
        fn cuts(i: u32, j: u32) -> Vec<Vec<[u32; 3]>> {
            if j - i < 2 {
                return vec![Vec::new()];
            }
            let mut all = Vec::new();
            for m in i + 1..j {
                for left in cuts(i, m) {
                    for right in cuts(m, j) {
                        all.push([&left[..], &right[..], &[[i, m, j]]].concat());
                    }
                }
            }
            all
        }
        for (n, expected) in [(3, 1), (4, 1), (5, 1), (6, 4), (7, 6), (8, 19)] {
            let ring: Vec<u32> = (0..n).map(|i| 10 + i * 11 % n).collect();
            let mut finder = RuleFinder::default();
            for floor in cuts(0, n - 1) {
                let floor: Vec<_> = floor.iter().map(|t| t.map(|i| ring[i as usize])).collect();
                finder.index_of(LoopShape::of(9, &fan(&ring, false), &floor).unwrap().code);
            }
            assert_eq!(finder.finish().unwrap().0.len(), expected, "{n} corners");
        }
    }

    #[test]
    fn fragments_without_a_rule_are_reported() {
        let reason = |ceiling: &[[u32; 3]], floor: &[[u32; 3]]| LoopShape::of(9, ceiling, floor).unwrap_err();
        let no_fan = "removes a vertex whose triangles are not one fan";
        assert_eq!(reason(&[[9, 0, 1], [9, 2, 3]], &[]), no_fan);
        assert_eq!(reason(&[[9, 0, 1], [9, 1, 2], [9, 0, 3]], &[]), no_fan);
        assert_eq!(reason(&[[9, 0, 0]], &[]), "has a floor that does not fill the hole");
        assert_eq!(reason(&[[9, 9, 0]], &[]), no_fan);
        assert_eq!(reason(&[], &[]), "removes a vertex without triangles");
        let hole = "has a floor that does not fill the hole";
        let square = fan(&[0, 1, 2, 3], false);
        assert_eq!(reason(&square, &[[0, 1, 2]]), hole);
        assert_eq!(reason(&square, &[[0, 1, 2], [0, 1, 2]]), hole);
        assert_eq!(reason(&square, &[[2, 1, 0], [3, 2, 0]]), hole);
        assert_eq!(reason(&fan(&[0, 1], false), &[]), hole);
        let outside = "has a floor with a vertex that is not a neighbor of the removed one";
        assert_eq!(reason(&square, &[[0, 1, 2], [0, 2, 7]]), outside);
        let wide: Vec<u32> = (10..300).collect();
        assert_eq!(reason(&fan(&wide, false), &[]), "removes a vertex with more than 255 triangles");
    }
}
