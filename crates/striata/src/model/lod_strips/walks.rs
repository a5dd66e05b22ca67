//! Strips of a level, stored as walks over its triangles.
//!
//! Who has a level of one stage knows the triangles of the next one, so its strips need no vertices: a strip
//! begins at a triangle and mostly goes on across the edge of its last two indices. That takes one bit. What
//! a strip does besides is in the table; prefix codes are read from the low bit on.
//!
//! | code | the strip |
//! | --- | --- |
//! | 0 | goes on to the first triangle across the edge that no strip has shown |
//! | 10 | swaps: repeats the index before the last |
//! | 110 | ends |
//! | 1110 | goes on to a named triangle |
//! | 1111 | goes on to a named vertex, which makes a triangle without area |
//!
//! The triangles are numbered in the order in which the strips of the stage before show them, each rotated so that
//! its smallest corner comes first. Strips are sorted in space, so triangles with close numbers are neighbors.
//!
//! Cost: linear, about 0.1 microseconds a triangle; 2.2 bits an index, where the indices themselves take 12 to 17.

use std::collections::HashMap;
use std::ops::Range;

use crate::mesh::is_proper;
use crate::model::bits::{Bits, field, width_of};
use crate::model::stored_strips::MAX_STRIP_INDICES;
use crate::strip::{StripSet, strip_triangles};

/// Number of triangles on an edge among which the next one is looked for: more would take forever at an edge
/// that a whole mesh shares.
const MAX_SIDES: usize = 8;

/// A code, low bit first, and its length.
struct Code {
    bits: u64,
    width: u32,
}

const SWAP: Code = Code { bits: 0b01, width: 2 };
const END: Code = Code { bits: 0b011, width: 3 };
const TRIANGLE: Code = Code { bits: 0b0111, width: 4 };
const VERTEX: Code = Code { bits: 0b1111, width: 4 };
/// Start of a strip at two named vertices; smaller numbers rotate the triangle that it starts with.
const AT_VERTICES: u64 = 3;

const TOO_SHORT: &str = "has walks that end too early";

/// Number of sides at a vertex up to which they are searched one by one.
const FEW_SIDES: usize = 32;

/// The triangles of a level, and which of them strips have shown.
pub(super) struct Ground {
    vertex_count: usize,
    triangles: Vec<[u32; 3]>,
    groups: Vec<Range<usize>>,
    is_shown: Vec<bool>,
    /// Start of the sides that begin at each vertex, followed by the number of sides.
    first_side: Vec<u32>,
    /// Sides by vertex and triangle; those of a vertex with more than [`FEW_SIDES`] by their other end first.
    sides: Vec<WalkSide>,
}

/// A side of a triangle, without the vertex where it begins.
#[derive(Clone, Copy, Default, PartialEq, Eq, PartialOrd, Ord)]
struct WalkSide {
    end: u32,
    triangle: u32,
    /// The corner of the triangle that is not on the side.
    opposite: u32,
}

impl Ground {
    /// A level without triangles, whose vertices are less than `vertex_count`.
    pub(super) fn new(vertex_count: usize) -> Self {
        let (triangles, groups, is_shown) = (Vec::new(), Vec::new(), Vec::new());
        Self { vertex_count, triangles, groups, is_shown, first_side: Vec::new(), sides: Vec::new() }
    }

    /// Adds the triangles of a strip to the current group, with each vertex replaced.
    pub(super) fn add_strip(&mut self, strip: &[u32], replace: impl Fn(u32) -> u32) {
        let triangles = strip_triangles(strip).map(|t| t.map(&replace));
        self.triangles.extend(triangles.filter(is_proper).map(rotated));
    }

    /// Ends the current group.
    pub(super) fn end_group(&mut self) {
        let first = self.groups.last().map_or(0, |group| group.end);
        self.groups.push(first..self.triangles.len());
    }

    /// Prepares walks over all triangles.
    fn finish(&mut self) {
        self.is_shown = vec![false; self.triangles.len()];
        self.first_side = vec![0; self.vertex_count + 1];
        for &v in self.triangles.as_flattened() {
            self.first_side[v as usize + 1] += 1;
        }
        for v in 0..self.vertex_count {
            self.first_side[v + 1] += self.first_side[v];
        }
        self.sides = vec![WalkSide::default(); 3 * self.triangles.len()];
        let mut next = self.first_side.clone();
        for (triangle, &[a, b, c]) in (0..).zip(&self.triangles) {
            for (start, end, opposite) in [(a, b, c), (b, c, a), (c, a, b)] {
                let slot = &mut next[start as usize];
                self.sides[*slot as usize] = WalkSide { end, triangle, opposite };
                *slot += 1;
            }
        }
        for w in self.first_side.windows(2) {
            if (w[1] - w[0]) as usize > FEW_SIDES {
                self.sides[w[0] as usize..w[1] as usize].sort_unstable();
            }
        }
    }

    fn triangle_width(&self) -> u32 {
        width_of(self.triangles.len() as u64)
    }

    fn vertex_width(&self) -> u32 {
        width_of(self.vertex_count as u64)
    }

    /// The first [`MAX_SIDES`] sides from one vertex to another, by triangle.
    fn sides_between(&self, [start, end]: [u32; 2]) -> impl Iterator<Item = &WalkSide> {
        let range = self.first_side[start as usize] as usize..self.first_side[start as usize + 1] as usize;
        let mut sides = &self.sides[range];
        if sides.len() > FEW_SIDES {
            sides = &sides[sides.partition_point(|side| side.end < end)..];
            sides = &sides[..sides.len().min(MAX_SIDES)];
        }
        sides.iter().filter(move |side| side.end == end).take(MAX_SIDES)
    }

    fn is_free(&self, group: &Range<usize>, triangle: u32) -> bool {
        group.contains(&(triangle as usize)) && !self.is_shown[triangle as usize]
    }

    /// The first triangle of a group that lies to the left of an edge and has not been shown.
    fn across(&self, group: &Range<usize>, edge: [u32; 2]) -> Option<WalkSide> {
        self.sides_between(edge).find(|side| self.is_free(group, side.triangle)).copied()
    }
}

/// The edge of a strip's last two indices, as the next triangle uses it, if the strip has this many indices.
fn next_edge([a, b]: [u32; 2], length: usize) -> [u32; 2] {
    if length.is_multiple_of(2) { [a, b] } else { [b, a] }
}

/// A triangle with its smallest corner first.
fn rotated([a, b, c]: [u32; 3]) -> [u32; 3] {
    let smallest = a.min(b).min(c);
    if a == smallest {
        [a, b, c]
    } else if b == smallest {
        [b, c, a]
    } else {
        [c, a, b]
    }
}

/// Writes strips as walks. They must show each triangle of the level once.
///
/// # Errors
/// The first strip that shows a triangle which the level does not have, or not so often.
pub(super) fn write(mut ground: Ground, strips: &StripSet) -> Result<Vec<u8>, usize> {
    ground.finish();
    let mut writer = WalkWriter { ground, crowded: HashMap::new(), bits: Bits::default() };
    for (index, group) in writer.ground.groups.clone().iter().enumerate() {
        writer.crowded.clear();
        for strip in strips.group_strips(index) {
            writer.write(group, strips.strip(strip)).ok_or(strip)?;
        }
    }
    Ok(writer.bits.as_bytes().to_vec())
}

struct WalkWriter {
    ground: Ground,
    /// The triangles of the group by their corners, the last first; filled if an edge has too many sides.
    crowded: HashMap<[u32; 3], Vec<u32>>,
    bits: Bits,
}

impl WalkWriter {
    fn write(&mut self, group: &Range<usize>, strip: &[u32]) -> Option<()> {
        let mut length = self.write_start(group, strip)?;
        while let Some(&next) = strip.get(length) {
            let last = [strip[length - 2], strip[length - 1]];
            let edge = next_edge(last, length);
            length += 1;
            if next == last[0] {
                self.push(SWAP);
            } else if !is_proper(&[last[0], last[1], next]) {
                self.push(VERTEX);
                self.bits.push(u64::from(next), self.ground.vertex_width());
            } else if let Some(side) = self.ground.across(group, edge).filter(|side| side.opposite == next) {
                self.ground.is_shown[side.triangle as usize] = true;
                self.bits.push(0, 1);
            } else {
                let triangle = self.show(group, [edge[0], edge[1], next])?;
                self.push(TRIANGLE);
                self.bits.push(u64::from(triangle), self.ground.triangle_width());
            }
        }
        self.push(END);
        Some(())
    }

    /// Writes the first triangle or the first two vertices, and returns the number of indices.
    fn write_start(&mut self, group: &Range<usize>, strip: &[u32]) -> Option<usize> {
        match *strip {
            [a, b, c, ..] if is_proper(&[a, b, c]) => {
                let triangle = self.show(group, [a, b, c])?;
                let rotation = self.ground.triangles[triangle as usize].iter().position(|&v| v == a)?;
                self.bits.push(rotation as u64, 2);
                self.bits.push(u64::from(triangle), self.ground.triangle_width());
                Some(3)
            }
            [a, b, ..] => {
                self.bits.push(AT_VERTICES, 2);
                for vertex in [a, b] {
                    self.bits.push(u64::from(vertex), self.ground.vertex_width());
                }
                Some(2)
            }
            _ => None,
        }
    }

    fn push(&mut self, code: Code) {
        self.bits.push(code.bits, code.width);
    }

    /// Marks a triangle with these corners that has not been shown.
    fn show(&mut self, group: &Range<usize>, corners: [u32; 3]) -> Option<u32> {
        let [a, b, c] = corners;
        let is_free = |side: &&WalkSide| side.opposite == c && self.ground.is_free(group, side.triangle);
        let beside = self.ground.sides_between([a, b]).find(is_free).copied();
        let found = match beside {
            Some(side) => side.triangle,
            None => self.show_crowded(group, rotated(corners))?,
        };
        self.ground.is_shown[found as usize] = true;
        Some(found)
    }

    /// Finds a triangle at an edge with more than [`MAX_SIDES`] sides.
    fn show_crowded(&mut self, group: &Range<usize>, corners: [u32; 3]) -> Option<u32> {
        if self.crowded.is_empty() {
            for triangle in group.clone().rev() {
                self.crowded.entry(self.ground.triangles[triangle]).or_default().push(triangle as u32);
            }
        }
        let equals = self.crowded.get_mut(&corners)?;
        while let Some(triangle) = equals.pop() {
            if !self.ground.is_shown[triangle as usize] {
                return Some(triangle);
            }
        }
        None
    }
}

/// Reads walks of a level from padded bytes: this many strips of each group. Also returns the number of bytes.
///
/// # Errors
/// Defect of the walks, if they do not show each triangle of the level once.
pub(super) fn read(
    mut ground: Ground,
    strip_counts: &[u32],
    padded: &[u8],
) -> Result<(StripSet, usize), &'static str> {
    ground.finish();
    let mut reader = WalkReader { ground, padded, at: 0, strip: Vec::new() };
    let mut strips = StripSet::new();
    for (group, &count) in reader.ground.groups.clone().iter().zip(strip_counts) {
        for _ in 0..count {
            reader.read(group)?;
            strips.push(&reader.strip);
        }
        strips.end_group();
    }
    if reader.ground.is_shown.contains(&false) {
        return Err("does not show all triangles of its level");
    }
    Ok((strips, reader.at.div_ceil(8)))
}

struct WalkReader<'a> {
    ground: Ground,
    padded: &'a [u8],
    /// The next bit.
    at: usize,
    /// The strip that is being read.
    strip: Vec<u32>,
}

impl WalkReader<'_> {
    fn read(&mut self, group: &Range<usize>) -> Result<(), &'static str> {
        self.read_start(group)?;
        loop {
            let (length, last) = (self.strip.len(), self.strip.last_chunk().copied());
            let last: [u32; 2] = last.ok_or(TOO_SHORT)?;
            let edge = next_edge(last, length);
            // A code is as long as its ones and the zero that ends them, and at most four bits.
            let ones = self.peek(VERTEX.width)?.trailing_ones();
            self.at += (ones + 1).min(VERTEX.width) as usize;
            let next = match ones {
                0 => {
                    let side = self.ground.across(group, edge).ok_or("goes on where no triangle is left")?;
                    self.ground.is_shown[side.triangle as usize] = true;
                    side.opposite
                }
                1 => last[0],
                2 => return Ok(()),
                3 => {
                    let corners = self.read_triangle(group)?;
                    let is_there = |k: &usize| corners[*k] == edge[0] && corners[(k + 1) % 3] == edge[1];
                    let k = (0..3).find(is_there).ok_or("goes on to a triangle that lies elsewhere")?;
                    corners[(k + 2) % 3]
                }
                _ => {
                    let next = self.read_vertex()?;
                    if is_proper(&[last[0], last[1], next]) {
                        return Err("shows a triangle that its level does not have");
                    }
                    next
                }
            };
            if length == MAX_STRIP_INDICES {
                return Err("has a strip that is too long");
            }
            self.strip.push(next);
        }
    }

    fn read_start(&mut self, group: &Range<usize>) -> Result<(), &'static str> {
        self.strip.clear();
        let rotation = self.take(2)?;
        if rotation == AT_VERTICES {
            for _ in 0..2 {
                let vertex = self.read_vertex()?;
                self.strip.push(vertex);
            }
        } else {
            let mut corners = self.read_triangle(group)?;
            corners.rotate_left(rotation as usize);
            self.strip.extend(corners);
        }
        Ok(())
    }

    fn read_vertex(&mut self) -> Result<u32, &'static str> {
        let vertex = self.take(self.ground.vertex_width())?;
        if vertex >= self.ground.vertex_count as u64 {
            return Err("uses a vertex that its level does not have");
        }
        Ok(vertex as u32)
    }

    /// Reads and marks a triangle.
    fn read_triangle(&mut self, group: &Range<usize>) -> Result<[u32; 3], &'static str> {
        let triangle = self.take(self.ground.triangle_width())? as usize;
        if !group.contains(&triangle) || std::mem::replace(&mut self.ground.is_shown[triangle], true) {
            return Err("shows a triangle twice, or one of another group");
        }
        Ok(self.ground.triangles[triangle])
    }

    fn peek(&self, width: u32) -> Result<u64, &'static str> {
        field(self.padded, self.at, width).ok_or(TOO_SHORT)
    }

    fn take(&mut self, width: u32) -> Result<u64, &'static str> {
        let number = self.peek(width)?;
        self.at += width as usize;
        Ok(number)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::{Random, shapes};
    use crate::model::bits::PADDING;
    use crate::strip::stripify;

    fn ground(triangles: &[[u32; 3]], group_ends: &[usize]) -> Ground {
        let vertex_count = triangles.iter().flatten().max().map_or(0, |&v| v as usize + 1);
        let mut ground = Ground::new(vertex_count);
        let mut first = 0;
        for &end in group_ends {
            triangles[first..end].iter().for_each(|triangle| ground.add_strip(triangle, |v| v));
            ground.end_group();
            first = end;
        }
        ground
    }

    fn counts(strips: &StripSet) -> Vec<u32> {
        strips.group_offsets().windows(2).map(|w| w[1] - w[0]).collect()
    }

    fn padded(bytes: &[u8]) -> Vec<u8> {
        [bytes, &[0; PADDING]].concat()
    }

    /// Writes strips, reads them again and returns their bytes.
    fn check(triangles: &[[u32; 3]], group_ends: &[usize], strips: &StripSet) -> Vec<u8> {
        let bytes = write(ground(triangles, group_ends), strips).unwrap();
        let again = read(ground(triangles, group_ends), &counts(strips), &padded(&bytes)).unwrap();
        assert_eq!(again, (strips.clone(), bytes.len()));
        bytes
    }

    #[test]
    fn strips_read_back_in_any_order_of_the_triangles() {
        let mesh = shapes::torus(24, 16, 1.0, 0.4);
        let strips = stripify(&mesh).unwrap().cut(MAX_STRIP_INDICES);
        let bytes = check(&mesh.triangles, &[mesh.triangles.len()], &strips);
        assert!(8 * bytes.len() < 2 * strips.indices().len(), "{} bytes", bytes.len());
        let mut random = Random::new(1);
        let mut shuffled = mesh.triangles.clone();
        for i in (1..shuffled.len()).rev() {
            shuffled.swap(i, random.below(i as u32 + 1) as usize);
            shuffled[i].rotate_left(random.below(3) as usize);
        }
        assert_eq!(check(&shuffled, &[shuffled.len()], &strips).len(), bytes.len());
    }

    #[test]
    fn all_ways_of_strips_read_back() {
        // A swap, a repeated vertex, a start without a triangle, equal triangles, and an edge that many share.
        let mut strips = StripSet::new();
        strips.push(&[0, 1, 2, 1, 3]);
        strips.push(&[4, 4, 5, 6, 6, 7, 0]);
        strips.end_group();
        for _ in 0..20 {
            strips.push(&[0, 1, 2]);
        }
        for v in 3..40 {
            strips.push(&[v, 0, 1]);
        }
        strips.push(&[41, 1, 0, 42]);
        strips.end_group();
        let mut triangles = Vec::new();
        let mut ends = Vec::new();
        for group in 0..2 {
            let of_group = strips.group_strips(group);
            triangles.extend(of_group.flat_map(|s| strip_triangles(strips.strip(s))));
            ends.push(triangles.len());
        }
        check(&triangles, &ends, &strips);
    }

    #[test]
    fn strips_of_another_mesh_are_refused() {
        let mesh = shapes::grid(4, 4);
        let strips = stripify(&mesh).unwrap();
        let last = mesh.triangles.len() - 1;
        assert!(write(ground(&mesh.triangles[..last], &[last]), &strips).is_err());
    }

    #[test]
    fn damaged_walks_are_refused_or_show_each_triangle_once() {
        let mesh = shapes::torus(9, 7, 1.0, 0.4);
        let count = mesh.triangles.len();
        let strips = stripify(&mesh).unwrap().cut(MAX_STRIP_INDICES);
        let bytes = check(&mesh.triangles, &[count], &strips);
        let mut refused = 0;
        for bit in 0..8 * bytes.len() {
            let mut damaged = padded(&bytes);
            damaged[bit / 8] ^= 1 << (bit % 8);
            match read(ground(&mesh.triangles, &[count]), &counts(&strips), &damaged) {
                Ok((strips, _)) => {
                    let mut shown = Vec::new();
                    strips.triangles_into(&mut shown);
                    assert_eq!(shown.len(), count);
                }
                Err(_) => refused += 1,
            }
        }
        assert!(refused > 4 * bytes.len(), "{refused} of {}", 8 * bytes.len());
        for end in 0..bytes.len() {
            assert!(read(ground(&mesh.triangles, &[count]), &counts(&strips), &bytes[..end]).is_err());
        }
    }
}
