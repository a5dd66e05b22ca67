//! Patches: rectangular regions of quadrilaterals, each row of which becomes a strip \[ESV96, global
//! algorithm\].
//!
//! The largest patch comes first. From each quadrilateral, the number of others that follow in each direction
//! bounds the patches that have it at a corner. A priority queue holds these bounds; a patch is only measured
//! when its bound is the largest, and covered if its true area is still the largest then.
//!
//! Cost: a measured patch costs its area. On a regular grid the first one covers everything; on a scan, patches
//! have a few quadrilaterals.

use std::collections::BinaryHeap;

use striata::strip::StripLinks;

use super::quads::{QuadSide, Quads};

/// Smallest number of quadrilaterals of a patch.
///
/// Smaller patches cut the mesh into pieces that cost more strips than their rows save.
const CUTOFF: u32 = 5;

/// Candidate: bound of the area, and the east side of the patch's south-west corner.
///
/// Ties go to the lowest quadrilateral.
type Candidate = (u32, std::cmp::Reverse<(u32, u8)>);

/// Covers patches by strips along their rows.
pub(super) fn cover(triangles: &[[u32; 3]], links: &mut StripLinks<'_>) {
    let quads = Quads::new(triangles, links);
    let mut patches = Patches {
        is_used: vec![false; quads.count()],
        measured: vec![0; quads.count()],
        measurement: 0,
        quads: &quads,
        cells: Vec::new(),
    };
    let mut candidates: BinaryHeap<Candidate> = patches.bounds().into();
    while let Some((bound, corner)) = candidates.pop() {
        let east = QuadSide { quad: corner.0.0, number: corner.0.1 };
        let (width, height) = patches.measure(east);
        let area = width * height;
        if area < CUTOFF {
            continue;
        }
        // Areas only shrink, so that every true area is a bound as well.
        if area < bound && candidates.peek().is_some_and(|&(next, _)| next > area) {
            candidates.push((area, corner));
            continue;
        }
        patches.cover(width, height, links);
    }
}

struct Patches<'q, 'a> {
    quads: &'q Quads<'a>,
    is_used: Vec<bool>,
    /// Index of the last measurement that visited each quadrilateral.
    measured: Vec<u32>,
    measurement: u32,
    /// East sides of the quadrilaterals of the measured patch, row by row.
    cells: Vec<Vec<QuadSide>>,
}

impl Patches<'_, '_> {
    /// Bounds the areas of the patches at every corner.
    fn bounds(&self) -> Vec<Candidate> {
        let count = self.quads.count() as u32;
        let lengths = self.walk_lengths();
        let candidates = all_sides(count).filter_map(|east| {
            let [width, height] = [east, east.turned(1)].map(|side| lengths[index_of(side)] + 1);
            let area = width.saturating_mul(height);
            (area >= CUTOFF).then_some((area, std::cmp::Reverse((east.quad, east.number))))
        });
        candidates.collect()
    }

    /// For each side, the number of quadrilaterals that follow in a straight line beyond it.
    fn walk_lengths(&self) -> Vec<u32> {
        const UNKNOWN: u32 = u32::MAX;
        let mut lengths = vec![UNKNOWN; 4 * self.quads.count()];
        let mut line = Vec::new();
        for start in all_sides(self.quads.count() as u32) {
            line.clear();
            let (mut side, mut is_closed) = (start, false);
            // The line ends where no quadrilateral follows or where a length is known, or it is closed.
            let beyond = loop {
                if lengths[index_of(side)] != UNKNOWN {
                    break lengths[index_of(side)] + 1;
                }
                line.push(side);
                match self.quads.across(side).map(QuadSide::opposite) {
                    None => break 0,
                    Some(next) if next == start => {
                        is_closed = true;
                        break line.len() as u32 - 1;
                    }
                    Some(next) => side = next,
                }
            };
            for (steps, &side) in line.iter().rev().enumerate() {
                lengths[index_of(side)] = if is_closed { beyond } else { beyond + steps as u32 };
            }
        }
        lengths
    }

    /// Measures the largest patch with a corner in the south-west: its width and height. Fills `cells`.
    fn measure(&mut self, east: QuadSide) -> (u32, u32) {
        self.measurement += 1;
        self.cells.clear();
        let (mut best, mut width) = ((0, 0), u32::MAX);
        let mut start = Some(east);
        while let Some(first) = start {
            let row = self.row(first, width);
            width = row.len() as u32;
            if width == 0 {
                break;
            }
            self.cells.push(row);
            let height = self.cells.len() as u32;
            if width * height > best.0 * best.1 {
                best = (width, height);
            }
            // The next row begins across the north side; its south side is east + 3.
            start = self.quads.across(first.turned(1)).map(|south| south.turned(1));
        }
        best
    }

    /// Collects a row of at most `limit` free quadrilaterals, each of which lies north of one in the row
    /// before.
    fn row(&mut self, first: QuadSide, limit: u32) -> Vec<QuadSide> {
        let mut row = Vec::new();
        let mut next = Some(first);
        while let Some(east) = next.filter(|_| (row.len() as u32) < limit) {
            let quad = east.quad as usize;
            let is_new = !self.is_used[quad] && self.measured[quad] != self.measurement;
            let below = self.cells.last().map(|below| below[row.len()]);
            let is_above =
                below.is_none_or(|below| self.quads.across(below.turned(1)) == Some(east.turned(3)));
            if !is_new || !is_above {
                break;
            }
            self.measured[quad] = self.measurement;
            row.push(east);
            next = self.quads.across(east).map(QuadSide::opposite);
        }
        row
    }

    /// Joins the measured patch along its longer direction.
    fn cover(&mut self, width: u32, height: u32, links: &mut StripLinks<'_>) {
        let (width, height) = (width as usize, height as usize);
        for row in self.cells[..height].iter().map(|row| &row[..width]) {
            for east in row {
                self.is_used[east.quad as usize] = true;
                links.join(self.quads.diagonal(east.quad));
            }
        }
        if width >= height {
            for row in &self.cells[..height] {
                row[..width - 1].iter().for_each(|&east| links.join(self.quads.triangle_side(east)));
            }
        } else {
            for row in &self.cells[..height - 1] {
                row[..width].iter().for_each(|east| links.join(self.quads.triangle_side(east.turned(1))));
            }
        }
    }
}

/// All sides, quadrilateral by quadrilateral.
fn all_sides(quad_count: u32) -> impl Iterator<Item = QuadSide> {
    (0..quad_count).flat_map(|quad| (0..4).map(move |number| QuadSide { quad, number }))
}

/// Index of a side among all.
fn index_of(side: QuadSide) -> usize {
    4 * side.quad as usize + usize::from(side.number)
}
