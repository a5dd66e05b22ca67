//! How the triangles of a scene are cut into pieces.
//!
//! Large primitives have pieces of their own, so that each can be cut at multiples of the size of a piece.
//! Small ones share pieces with their neighbors. Two consecutive pieces of small primitives have more
//! triangles than fit into one, so there are at most about four times as many pieces as would be needed.

use std::ops::Range;

/// Triangles of one shown primitive in a piece.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct CutPart {
    /// Number of the shown primitive.
    pub shown: usize,
    pub triangles: Range<u64>,
}

/// Pieces of a scene.
pub(super) struct Cuts {
    piece_size: u64,
    runs: Vec<PrimitiveRun>,
    piece_count: u64,
}

/// A large primitive with all of its pieces, or small ones that share a piece.
struct PrimitiveRun {
    first_piece: u64,
    shown: Range<u32>,
}

impl Cuts {
    /// Cuts primitives with these numbers of triangles.
    pub(super) fn new(counts: impl Iterator<Item = u64>, piece_size: usize) -> Self {
        let mut cuts = Self { piece_size: piece_size as u64, runs: Vec::new(), piece_count: 0 };
        let mut small = (0..0, 0);
        for (shown, count) in (0..).zip(counts).filter(|&(_, count)| count > 0) {
            if small.1 > 0 && small.1 + count > cuts.piece_size {
                cuts.push(std::mem::replace(&mut small, (0..0, 0)).0, 1);
            }
            if count > cuts.piece_size {
                cuts.push(shown..shown + 1, count.div_ceil(cuts.piece_size));
            } else {
                let first = if small.1 > 0 { small.0.start } else { shown };
                small = (first..shown + 1, small.1 + count);
            }
        }
        if small.1 > 0 {
            cuts.push(small.0, 1);
        }
        cuts
    }

    fn push(&mut self, shown: Range<u32>, piece_count: u64) {
        self.runs.push(PrimitiveRun { first_piece: self.piece_count, shown });
        self.piece_count = self.piece_count.saturating_add(piece_count);
    }

    pub(super) fn piece_count(&self) -> u64 {
        self.piece_count
    }

    /// Returns the parts of an existing piece; `count` is the number of triangles of a shown primitive.
    pub(super) fn parts(&self, piece: u64, count: impl Fn(usize) -> u64) -> Vec<CutPart> {
        let run = &self.runs[self.runs.partition_point(|run| run.first_piece <= piece) - 1];
        let first = (piece - run.first_piece) * self.piece_size;
        let part = |shown: u32| {
            let shown = shown as usize;
            CutPart { shown, triangles: first..count(shown).min(first + self.piece_size) }
        };
        run.shown.clone().map(part).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Numbers of triangles by piece, each checked to be cut from primitives in order.
    fn pieces(counts: &[u64], piece_size: usize) -> Vec<u64> {
        let cuts = Cuts::new(counts.iter().copied(), piece_size);
        let mut next = vec![0; counts.len()];
        let mut sizes = Vec::new();
        for piece in 0..cuts.piece_count() {
            let parts = cuts.parts(piece, |shown| counts[shown]);
            for part in &parts {
                assert_eq!(part.triangles.start, next[part.shown]);
                next[part.shown] = part.triangles.end;
                assert!(next[part.shown + 1..].iter().all(|&next| next == 0));
            }
            sizes.push(parts.iter().map(|part| part.triangles.end - part.triangles.start).sum());
        }
        assert_eq!(next, counts);
        sizes
    }

    #[test]
    fn small_primitives_share_pieces_and_large_ones_are_cut() {
        assert!(pieces(&[], 10).is_empty());
        assert!(pieces(&[0, 0], 10).is_empty());
        assert_eq!(pieces(&[0, 3, 0, 7, 1, 0], 10), [10, 1]);
        assert_eq!(pieces(&[25, 4, 4, 4, 10, 11], 10), [10, 10, 5, 8, 4, 10, 10, 1]);
        assert_eq!(pieces(&[1; 100_000], 1000), [1000; 100]);
        assert_eq!(pieces(&[3, 2], 1), [1; 5]);
    }
}
