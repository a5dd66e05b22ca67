//! Writes a run of arcs as triangles, as a fan or as a strip.
//!
//! A run of `n` arcs around `p`, starting at node `a`, takes 3 `n` indices as a triangle list and `n` + 2
//! as a fan. In a strip, a further triangle costs only one index as long as the strip turns from side to
//! side. Around a single vertex this works for three triangles; after that, `p` must be repeated:
//!
//! ```text
//! 1 triangle      p a b              3
//! 2 triangles     a b p c            4
//! 3 triangles     a b p c d          5
//! 4 triangles     a b p c p d e      7      p c p has no area
//! n triangles     a b p c p d p .. z 2 n - 1
//! ```
//!
//! No strip of these triangles alone is shorter; the tests try all of them, including restarts. Including
//! the restart behind it, a run takes 4, 5, 6, 8, 10 .. indices, which is two per triangle from three
//! triangles on; a fan is shorter from four triangles on. Joining consecutive runs by degenerate triangles
//! would cost two or three indices instead of one restart, because consecutive runs are neighbors in
//! refinement order but not on the surface.

use super::super::table::{FanView, MAX_ARCS};
use crate::model::DrawCounts;
use crate::strip::RESTART;

/// The form in which triangles of a table are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FanForm {
    /// A triangle list: three indices per triangle.
    Triangles,
    /// A pivot and its ring, then [`RESTART`]; each triangle consists of the pivot and two consecutive
    /// ring nodes.
    Fans,
    /// Strips with [`RESTART`] between them; every second triangle has reversed winding, as on GPUs.
    Strips,
}

impl FanForm {
    /// Adds the size of a fan in this form, including a restart behind each run.
    pub(super) fn count(self, fan: &FanView<'_>, mask: u32, counts: &mut DrawCounts) {
        if self == Self::Triangles {
            counts.index_count += 3 * mask.count_ones() as usize;
            return;
        }
        let arc_count = fan.node_count - usize::from(!fan.is_closed);
        for (_, count) in Runs::of_ring(mask, arc_count, fan.is_closed) {
            counts.strip_count += 1;
            counts.index_count += match (self, count) {
                (Self::Strips, 3..) => 2 * count,
                _ => count + 3,
            };
        }
    }
}

/// Converts fans with [`RESTART`] between them to triangles.
pub fn fan_triangles_into(indices: &[u32], out: &mut Vec<[u32; 3]>) {
    for fan in indices.split(|&index| index == RESTART) {
        if let [pivot, ring @ ..] = fan {
            out.extend(ring.windows(2).map(|edge| [*pivot, edge[0], edge[1]]));
        }
    }
}

/// Appends each run as a fan, followed by a restart.
#[inline]
pub(super) fn write_fans(fan: &FanView<'_>, mask: u32, out: &mut Vec<u32>) {
    if mask == 0 {
        return;
    }
    let ring = FanRing::of(fan);
    for (first, count) in ring.runs(mask) {
        out.reserve(count + 3);
        out.push(fan.vertex);
        let end = first + count + 1;
        out.extend_from_slice(&ring.nodes[first..end.min(ring.count)]);
        // A run that passes the end continues at the start.
        out.extend_from_slice(&ring.nodes[..end.saturating_sub(ring.count)]);
        out.push(RESTART);
    }
}

/// Appends each run as a strip, followed by a restart.
#[inline]
pub(super) fn write_strips(fan: &FanView<'_>, mask: u32, out: &mut Vec<u32>) {
    if mask == 0 {
        return;
    }
    let (pivot, ring) = (fan.vertex, FanRing::of(fan));
    for (first, count) in ring.runs(mask) {
        let node =
            |i: usize| ring.nodes[if first + i < ring.count { first + i } else { first + i - ring.count }];
        match count {
            1 => out.extend_from_slice(&[pivot, node(0), node(1), RESTART]),
            2 => out.extend_from_slice(&[node(0), node(1), pivot, node(2), RESTART]),
            _ => {
                out.extend_from_slice(&[node(0), node(1), pivot, node(2)]);
                (3..count).for_each(|i| out.extend_from_slice(&[pivot, node(i)]));
                out.extend_from_slice(&[node(count), RESTART]);
            }
        }
    }
}

/// The decoded nodes of a fan.
struct FanRing {
    nodes: [u32; MAX_ARCS + 1],
    count: usize,
    is_closed: bool,
}

impl FanRing {
    #[inline]
    fn of(fan: &FanView<'_>) -> Self {
        let mut ring = Self { nodes: [0; MAX_ARCS + 1], count: 0, is_closed: fan.is_closed };
        for (slot, node) in ring.nodes.iter_mut().zip(fan.nodes()) {
            *slot = node;
            ring.count += 1;
        }
        ring
    }

    #[inline]
    fn runs(&self, mask: u32) -> Runs {
        Runs::of_ring(mask, self.count - usize::from(!self.is_closed), self.is_closed)
    }
}

/// Connected runs of the arcs in a mask: the first arc and the arc count of each. On a closed ring, a run
/// may pass the end.
#[derive(Clone, Debug)]
struct Runs {
    /// The mask, rotated so that no run passes its end.
    turned: u64,
    /// The arc that corresponds to its lowest bit.
    start: usize,
    arc_count: usize,
}

impl Runs {
    #[inline]
    fn of_ring(mask: u32, arc_count: usize, is_closed: bool) -> Self {
        let mask = u64::from(mask);
        let all = (1 << arc_count) - 1;
        let passes_end = is_closed && mask != all && mask & 1 != 0 && mask >> (arc_count - 1) != 0;
        if !passes_end {
            return Self { turned: mask, start: 0, arc_count };
        }
        // The run that passes the end begins after the last gap.
        let start = 64 - (!mask & all).leading_zeros() as usize;
        Self { turned: (mask >> start | mask << (arc_count - start)) & all, start, arc_count }
    }
}

impl Iterator for Runs {
    type Item = (usize, usize);

    #[inline]
    fn next(&mut self) -> Option<(usize, usize)> {
        if self.turned == 0 {
            return None;
        }
        let at = self.turned.trailing_zeros() as usize;
        let count = (self.turned >> at).trailing_ones() as usize;
        self.turned &= !(((1 << count) - 1) << at);
        let first = self.start + at;
        Some((if first < self.arc_count { first } else { first - self.arc_count }, count))
    }
}

#[cfg(test)]
mod tests {
    use super::super::super::table::{Fan, TableWriter};
    use super::*;
    use crate::mesh::canonical_triangles;
    use crate::strip::restart_triangles_into;

    #[test]
    fn runs_of_open_and_closed_rings() {
        let runs = |mask: u32, count, is_closed| Runs::of_ring(mask, count, is_closed).collect::<Vec<_>>();
        assert_eq!(runs(0, 5, true), []);
        assert_eq!(runs(0b11011, 5, false), [(0, 2), (3, 2)]);
        assert_eq!(runs(0b11011, 5, true), [(3, 4)]);
        assert_eq!(runs(0b10101, 5, true), [(4, 2), (2, 1)]);
        assert_eq!(runs(0b11111, 5, true), [(0, 5)]);
        assert_eq!(runs(0b01110, 5, true), [(1, 3)]);
        assert_eq!(runs(u32::MAX, 32, true), [(0, 32)]);
        assert_eq!(runs(u32::MAX - 1, 32, true), [(1, 31)]);
        assert_eq!(runs(u32::MAX - 16, 32, true), [(5, 31)]);
        assert_eq!(runs(u32::MAX - 16, 32, false), [(0, 4), (5, 27)]);
    }

    /// Writes one run of a vertex that is newer than its ring, as a fan or as a strip, without the
    /// trailing restart.
    fn written(count: usize, write: impl Fn(&FanView<'_>, u32, &mut Vec<u32>)) -> Vec<u32> {
        let all = (1u64 << count) - 1;
        let nodes = (0..=count as u32).collect();
        let fan = Fan { group: 0, arc_count: count, nodes, permanent: all as u32, creators: Vec::new() };
        let mut table = TableWriter::new(false);
        (0..=count).for_each(|_| table.push(0, &[]));
        table.push(0, &[fan]);
        let table = table.finish();
        let mut out = Vec::new();
        table.entry(count as u32 + 1, 0).for_each(|fan| write(&fan, fan.mask(|_| false), &mut out));
        assert_eq!(out.pop(), Some(RESTART));
        out
    }

    #[test]
    fn a_run_is_a_fan_and_a_strip_of_the_same_triangles() {
        for count in 1..=32 {
            let pivot = count as u32 + 1;
            let expected: Vec<[u32; 3]> = (0..count as u32).map(|i| [pivot, i, i + 1]).collect();
            let fan = written(count, write_fans);
            assert_eq!(fan.len(), count + 2);
            let mut found = Vec::new();
            fan_triangles_into(&fan, &mut found);
            assert_eq!(found, expected);
            let strip = written(count, write_strips);
            assert_eq!(strip.len(), if count < 3 { count + 2 } else { 2 * count - 1 });
            let mut found = Vec::new();
            restart_triangles_into(&strip, &mut found);
            assert_eq!(canonical_triangles(&found), canonical_triangles(&expected));
        }
    }

    /// Whether `index_count` indices, possibly including restarts, can draw a run; tries all of them.
    fn can_draw(count: usize, index_count: usize) -> bool {
        let pivot = count as u32 + 1;
        let expected = canonical_triangles(&(0..count as u32).map(|i| [pivot, i, i + 1]).collect::<Vec<_>>());
        let letters: Vec<u32> = (0..=pivot).chain([RESTART]).collect();
        let mut found = Vec::new();
        (0..letters.len().pow(index_count as u32)).any(|number| {
            let word: Vec<u32> = (0..index_count as u32)
                .map(|i| letters[number / letters.len().pow(i) % letters.len()])
                .collect();
            found.clear();
            restart_triangles_into(&word, &mut found);
            found.len() == count && canonical_triangles(&found) == expected
        })
    }

    #[test]
    fn no_shorter_strip_draws_a_run() {
        for count in 1..=4 {
            let length = written(count, write_strips).len();
            assert!(can_draw(count, length) && !can_draw(count, length - 1), "{count} triangles");
        }
    }
}
