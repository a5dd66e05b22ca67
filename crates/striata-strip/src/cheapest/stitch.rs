//! Joins strips whose ends meet at a vertex, which saves the restart.
//!
//! The first index of a strip is the free corner of its first triangle, and the last index that of its last
//! triangle. If one strip ends at the vertex at which another begins, the two can be written one after the
//! other with that vertex repeated:
//!
//! ```text
//!     ... n o v | v p q ...      (n o v) is the last triangle, (v p q) the first;
//!                                (o v v) and (v v p) have no area
//! ```
//!
//! The second strip's first triangle then has the opposite parity of the first strip's last triangle. That
//! is right for both windings exactly if both ends have the right winding at an even position, or neither
//! has. In that case the joint is free, while a restart costs an index. Chains of joined strips are found
//! vertex by vertex; loops are not closed. Linear in time; 20 bytes per strip and per vertex.

use striata::mesh::NO_TWIN as NONE;
use striata::strip::{StripLinks, StripOrder, StripPath, StripSet};

use crate::task::StripTask;

/// Writes all strips, joined into chains.
pub(super) fn write(task: &StripTask<'_>, links: &StripLinks<'_>, out: &mut StripSet) {
    let mut order = StripOrder::new(task.triangles);
    let mut chain = Vec::new();
    for group in task.groups {
        let mut pieces = Vec::new();
        order.visit(group.clone(), links, |path| pieces.push(StripPiece::new(path, task.triangles, links)));
        let joints = join_pieces(&pieces);
        let mut writer =
            PieceWriter { triangles: task.triangles, links, pieces: &pieces, path: StripPath::default() };
        for start in chain_starts(&pieces, &joints) {
            chain.clear();
            let mut entered = start;
            while entered != NONE {
                writer.write(entered, &mut chain);
                entered = joints[entered as usize ^ 1];
            }
            out.push(&chain);
        }
        out.end_group();
    }
}

/// One end of a strip.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct PieceEnd {
    /// Vertex with which the strip begins when written from this end.
    apex: u32,
    /// Whether the strip has to begin at an odd position to cost nothing when written from this end.
    is_odd: bool,
}

/// One strip before strips are joined.
#[derive(Clone, Copy, Debug)]
struct StripPiece {
    /// Triangle at end 0.
    triangle: u32,
    ends: [PieceEnd; 2],
}

/// For each end `2 * piece + k`, the end joined to it, or [`NONE`].
type Joints = Vec<u32>;

impl StripPiece {
    fn new(path: &StripPath, triangles: &[[u32; 3]], links: &StripLinks<'_>) -> Self {
        let apex = |side: u32| triangles[side as usize / 3][(side as usize + 2) % 3];
        let ends = match (path.exits.first(), path.exits.last()) {
            (Some(&first), Some(&last)) => [
                PieceEnd { apex: apex(first), is_odd: !path.begins_without_parity_fix(links) },
                PieceEnd {
                    apex: apex(links.twins()[last as usize]),
                    is_odd: !path.ends_without_parity_fix(links),
                },
            ],
            _ => {
                // A single triangle can begin with any corner at an even position; it ends with the
                // previous corner.
                let [first, _, last] = triangles[path.first as usize];
                [PieceEnd { apex: first, is_odd: false }, PieceEnd { apex: last, is_odd: true }]
            }
        };
        Self { triangle: path.first, ends }
    }
}

/// Joins ends of the same kind at the same vertex in pairs, without closing a loop.
fn join_pieces(pieces: &[StripPiece]) -> Joints {
    let mut joints = vec![NONE; 2 * pieces.len()];
    // For each free end of a chain, the other end of that chain.
    let mut far_ends: Vec<u32> = (0..2 * pieces.len() as u32).map(|end| end ^ 1).collect();
    let mut ends: Vec<(PieceEnd, u32)> = pieces.iter().flat_map(|piece| piece.ends).zip(0..).collect();
    ends.sort_unstable_by_key(|&(end, i)| (end.apex, end.is_odd, i));
    for equal in ends.chunk_by(|(a, _), (b, _)| a == b) {
        for (i, &(_, one)) in equal.iter().enumerate() {
            if joints[one as usize] != NONE {
                continue;
            }
            let free = equal[i + 1..].iter().map(|&(_, other)| other).filter(|&o| joints[o as usize] == NONE);
            let mut fitting = free.filter(|&other| far_ends[one as usize] != other);
            if let Some(other) = fitting.next() {
                joints[one as usize] = other;
                joints[other as usize] = one;
                let [a, b] = [one, other].map(|end| far_ends[end as usize]);
                far_ends[a as usize] = b;
                far_ends[b as usize] = a;
            }
        }
    }
    joints
}

/// Returns the best end to start each chain from, in the order of the chains' first pieces.
fn chain_starts(pieces: &[StripPiece], joints: &[u32]) -> Vec<u32> {
    let mut is_done = vec![false; pieces.len()];
    let mut starts = Vec::new();
    for piece in 0..pieces.len() as u32 {
        if is_done[piece as usize] {
            continue;
        }
        let start = last_end(2 * piece + 1, joints, |_| ());
        let other = last_end(start, joints, |piece| is_done[piece as usize] = true);
        let is_odd = |end: u32| pieces[end as usize / 2].ends[end as usize % 2].is_odd;
        // A chain costs an index if it begins at an even position but should not.
        starts.push(if is_odd(start) && !is_odd(other) { other } else { start });
    }
    starts
}

/// Returns the far end of the chain that is entered at this end, and visits its pieces.
fn last_end(mut entered: u32, joints: &[u32], mut visit: impl FnMut(u32)) -> u32 {
    loop {
        visit(entered / 2);
        let far = entered ^ 1;
        match joints[far as usize] {
            NONE => return far,
            next => entered = next,
        }
    }
}

/// Writes the pieces of a chain into one strip.
struct PieceWriter<'a, 'g> {
    triangles: &'a [[u32; 3]],
    links: &'a StripLinks<'g>,
    pieces: &'a [StripPiece],
    path: StripPath,
}

impl PieceWriter<'_, '_> {
    /// Appends a piece, starting at one of its ends.
    fn write(&mut self, entered: u32, out: &mut Vec<u32>) {
        let piece = self.pieces[entered as usize / 2];
        let end = piece.ends[entered as usize % 2];
        let is_odd = out.len() % 2 == 1;
        debug_assert!(out.is_empty() || is_odd == end.is_odd, "a joint on the wrong winding");
        debug_assert!(out.last().is_none_or(|&last| last == end.apex), "a joint between two vertices");
        self.path.follow(self.links, piece.triangle);
        if self.path.exits.is_empty() {
            // At an even position it begins with the corner of one end, at an odd position with that of the
            // other.
            if end.is_odd && !is_odd {
                out.push(end.apex);
            }
            let [a, b, c] = self.triangles[piece.triangle as usize];
            out.extend(if end.is_odd { [c, b, a] } else { [a, b, c] });
            return;
        }
        if entered % 2 == 1 {
            self.path.reverse(self.links);
        }
        self.path.write(self.triangles, self.links, is_odd, out);
    }
}
