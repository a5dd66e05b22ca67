//! Rules: what fragments look like, up to where they are.
//!
//! A ceiling is the fan around the removed vertex, so all that tells one kind of fragment from another is how many corners the
//! ring has, whether it is closed, and how the floor triangulates it. With ring corners numbered counterclockwise, the floor
//! is a binary tree: the triangle at side 0 1 has an apex, which leaves a smaller ring on either side of it, and so on.
//!
//! ```text
//!        3                 side 0 1 -> apex 3: ring 1 2 3 and ring 3 4 0
//!       /|\                side 3 1 -> apex 2
//!     4  | 2               side 0 3 -> apex 4
//!      \ |/
//!       0-1                code: closed, 3 2 4
//! ```
//!
//! Of all corners that a closed ring can begin with the one with the smallest code counts; the mirror image of a floor has
//! another code. An open ring, that of a border, begins where the border enters it.

use std::collections::HashMap;

use striata::model::ModelError;

/// Rules that 12 bits can number.
pub(super) const MAX_RULES: usize = 1 << 12;

/// Corners of a ring that a byte can number.
const MAX_RING: usize = 255;

/// A fragment's surroundings: its ring from the anchors on, and its code.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(in crate::baseline) struct Shape {
    /// The first two are the anchors.
    pub(in crate::baseline) ring: Vec<u32>,
    /// 1 for an open ring, then the apexes, triangle before its left part before its right one.
    pub(in crate::baseline) code: Vec<u8>,
}

/// A rule of a table.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::baseline) struct Rule<'a> {
    /// Whether the ring is open.
    pub(in crate::baseline) is_open: bool,
    /// Apexes of the floor's triangles in order.
    pub(in crate::baseline) apexes: &'a [u8],
}

impl<'a> Rule<'a> {
    pub(in crate::baseline) fn of_code(code: &'a [u8]) -> Self {
        Self { is_open: code[0] != 0, apexes: &code[1..] }
    }

    /// Whether the apexes leave no part of the ring open.
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

    /// Corners of the ring.
    pub(in crate::baseline) fn ring_len(self) -> usize {
        self.apexes.len() + 2
    }

    /// Triangles of the ceiling.
    pub(in crate::baseline) fn ceiling_len(self) -> usize {
        self.ring_len() - usize::from(self.is_open)
    }
}

impl Shape {
    /// Looks at a fragment by itself.
    ///
    /// # Errors
    /// What it has that no rule can say.
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
                // Where a floor looks the same from several corners the smallest vertex comes first.
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

/// The neighbors of a vertex, counterclockwise, and whether they end at a border.
fn ring_of(vertex: u32, ceiling: &[[u32; 3]]) -> Result<(Vec<u32>, bool), &'static str> {
    const NO_FAN: &str = "removes a vertex whose triangles are not one fan";
    if ceiling.is_empty() {
        return Err("removes a vertex without triangles");
    }
    if ceiling.len() > MAX_RING {
        return Err("removes a vertex of more than 255 triangles");
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
        return Err("removes a vertex of more than 255 triangles");
    }
    Ok((ring, is_open))
}

/// The sides of a floor's triangles by ring corner, with the corner on the left of each; sorted.
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
            return Err("has a floor with a vertex that is not around the removed one");
        };
        sides.extend([[a, b, c], [b, c, a], [c, a, b]]);
    }
    sides.sort_unstable();
    Ok(sides)
}

/// The code of a floor whose ring begins at corner `start`; none where the floor does not triangulate the ring.
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
pub(in crate::baseline) struct RuleTable {
    codes: Vec<u8>,
    /// First byte of each code, closed by their number.
    firsts: Vec<u32>,
}

impl RuleTable {
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
    pub(in crate::baseline) fn get(&self, rule: usize) -> Rule<'_> {
        Rule::of_code(self.code(rule))
    }

    pub(super) fn bytes(&self) -> usize {
        self.codes.len() + 4 * self.firsts.len()
    }
}

/// Rules as they are met, found again by their codes' hash.
#[derive(Debug, Default)]
pub(super) struct RuleFinder {
    numbers: HashMap<Vec<u8>, u32>,
}

impl RuleFinder {
    pub(super) fn number_of(&mut self, code: Vec<u8>) -> u32 {
        let next = self.numbers.len() as u32;
        *self.numbers.entry(code).or_insert(next)
    }

    /// The table, and for each rule as it was met its number there.
    ///
    /// # Errors
    /// Where there are more than 12 bits can number.
    pub(super) fn finish(self) -> Result<(RuleTable, Vec<u32>), ModelError> {
        if self.numbers.len() > MAX_RULES {
            let (found, limit) = (self.numbers.len() as u64, MAX_RULES as u64);
            return Err(ModelError::Form { what: "rules", found, limit });
        }
        let mut sorted: Vec<(Vec<u8>, u32)> = self.numbers.into_iter().collect();
        sorted.sort_unstable_by(|(a, _), (b, _)| (a.len(), a).cmp(&(b.len(), b)));
        let mut renumbered = vec![0; sorted.len()];
        sorted.iter().zip(0..).for_each(|((_, met), number)| renumbered[*met as usize] = number);
        Ok((RuleTable::of(sorted.iter().map(|(code, _)| &code[..])), renumbered))
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
    fn the_drawing_has_its_code() {
        let floor = [[0, 1, 3], [1, 2, 3], [0, 3, 4]];
        let shape = Shape::of(9, &fan(&[0, 1, 2, 3, 4], true), &floor).unwrap();
        assert_eq!((shape.ring, shape.code), (vec![0, 1, 2, 3, 4], vec![1, 3, 2, 4]));
    }

    #[test]
    fn turned_floors_are_equal_and_mirrored_ones_are_not() {
        let zigzag = |turn: u32| {
            let at = |i: u32| (i + turn) % 6;
            let floor = [[0, 1, 5], [1, 2, 5], [2, 4, 5], [2, 3, 4]].map(|t| t.map(at));
            Shape::of(9, &fan(&[0, 1, 2, 3, 4, 5], false), &floor).unwrap()
        };
        assert!((1..6).all(|turn| zigzag(turn).code == zigzag(0).code));
        // The zigzag looks the same from its other end, where the ring begins at the smaller vertex.
        assert!(zigzag(3).ring == zigzag(0).ring && zigzag(1).ring == zigzag(4).ring);
        let mirrored = [[0, 1, 5], [1, 4, 5], [1, 2, 4], [2, 3, 4]];
        let mirrored = Shape::of(9, &fan(&[0, 1, 2, 3, 4, 5], false), &mirrored).unwrap();
        assert_ne!(mirrored.code, zigzag(0).code);
    }

    /// Triangulations of a ring up to turning: 1, 1, 1, 4, 6, 19 for three to eight corners.
    #[test]
    fn there_are_as_many_rules_as_ways_to_cut_a_polygon() {
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
                finder.number_of(Shape::of(9, &fan(&ring, false), &floor).unwrap().code);
            }
            assert_eq!(finder.finish().unwrap().0.len(), expected, "{n} corners");
        }
    }

    #[test]
    fn what_has_no_rule_is_told() {
        let reason = |ceiling: &[[u32; 3]], floor: &[[u32; 3]]| Shape::of(9, ceiling, floor).unwrap_err();
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
        let outside = "has a floor with a vertex that is not around the removed one";
        assert_eq!(reason(&square, &[[0, 1, 2], [0, 2, 7]]), outside);
        let wide: Vec<u32> = (10..300).collect();
        assert_eq!(reason(&fan(&wide, false), &[]), "removes a vertex of more than 255 triangles");
    }
}
