//! Sets of drawn triangles of many search states, in little memory.
//!
//! The states of a beam search share nearly all that they have drawn. A triangle that all of them have
//! drawn is **final** and has one mark for all. A triangle that only some have drawn gets a **column**, and
//! each state has one bit per column. Copying a state therefore copies 128 bytes, and a query takes two
//! loads. Memory: two bytes per triangle and eight per vertex.

use super::adjacency::TriangleAdjacency;

/// Number of columns.
pub(super) const COLUMN_COUNT: usize = 1024;
const WORD_COUNT: usize = COLUMN_COUNT / 64;

/// Drawn bits of one state, one per column.
pub(super) type DrawnBits = [u64; WORD_COUNT];

/// Marks a triangle that no state has drawn.
const UNTOUCHED: u16 = u16::MAX;
/// Marks a triangle that all states have drawn.
const FINAL: u16 = u16::MAX - 1;
/// Marks a column that is not in use.
const NO_TRIANGLE: u32 = u32::MAX;

/// Largest valence for which the triangles around a vertex are checked one by one.
const SMALL_VALENCE: usize = 32;

/// The part of the drawn sets that all states share.
pub(super) struct DrawnSets {
    /// Column of each triangle, or [`UNTOUCHED`] or [`FINAL`].
    columns: Vec<u16>,
    /// Triangle of each column in use.
    triangles: Vec<u32>,
    free: Vec<u16>,
    /// Number of proper triangles around each vertex that are not final.
    open_counts: Vec<u32>,
    /// Number of final triangles at the start of each vertex's triangle list.
    final_counts: Vec<u32>,
}

impl DrawnSets {
    /// Creates the sets for a mesh of which nothing is drawn.
    pub(super) fn new(adjacency: &TriangleAdjacency<'_>) -> Self {
        let valence = |v: usize| adjacency.around(v as u32).len() as u32;
        Self {
            columns: vec![UNTOUCHED; adjacency.triangles.len()],
            triangles: vec![NO_TRIANGLE; COLUMN_COUNT],
            free: (0..COLUMN_COUNT as u16).rev().collect(),
            open_counts: (0..adjacency.vertex_limit()).map(valence).collect(),
            final_counts: vec![0; adjacency.vertex_limit()],
        }
    }

    /// Whether every state has drawn this triangle.
    #[inline]
    pub(super) fn is_final(&self, triangle: u32) -> bool {
        self.columns[triangle as usize] == FINAL
    }

    /// Whether a state has drawn a triangle.
    #[inline]
    pub(super) fn is_drawn(&self, drawn: &DrawnBits, triangle: u32) -> bool {
        match self.columns[triangle as usize] {
            UNTOUCHED => false,
            FINAL => true,
            column => has(drawn, usize::from(column)),
        }
    }

    /// Number of unused columns.
    pub(super) fn free_count(&self) -> usize {
        self.free.len()
    }

    /// Marks a triangle as drawn in one state.
    ///
    /// # Panics
    /// If it needs a column and none is free.
    pub(super) fn draw(&mut self, drawn: &mut DrawnBits, triangle: u32) {
        debug_assert!(!self.is_drawn(drawn, triangle), "triangle {triangle} is drawn twice");
        let column = &mut self.columns[triangle as usize];
        if *column == UNTOUCHED {
            *column = self.free.pop().expect("the search settles before columns run out");
            self.triangles[usize::from(*column)] = triangle;
        }
        drawn[usize::from(*column) / 64] |= 1 << (*column % 64);
    }

    /// Number of proper triangles around a vertex that a state has not drawn.
    pub(super) fn open_count(&self, adjacency: &TriangleAdjacency<'_>, drawn: &DrawnBits, v: u32) -> u32 {
        let around = adjacency.around(v);
        if around.len() <= SMALL_VALENCE {
            return around.iter().filter(|&&t| !self.is_drawn(drawn, t)).count() as u32;
        }
        // Around the hub of a large fan it is quicker to count the triangles that are drawn but not final.
        let is_here = |column: &usize| {
            has(drawn, *column) && adjacency.triangles[self.triangles[*column] as usize].contains(&v)
        };
        self.open_counts[v as usize] - (0..COLUMN_COUNT).filter(is_here).count() as u32
    }

    /// Returns the triangles around a vertex, without the final ones at the start of the list.
    pub(super) fn pending_around<'s>(&self, adjacency: &'s TriangleAdjacency<'_>, v: u32) -> &'s [u32] {
        &adjacency.around(v)[self.final_counts[v as usize] as usize..]
    }

    /// Makes final what all states have drawn, and frees the columns that no state has drawn.
    pub(super) fn finalize(&mut self, adjacency: &TriangleAdjacency<'_>, states: &mut [&mut DrawnBits]) {
        for word in 0..WORD_COUNT {
            let all = states.iter().fold(u64::MAX, |bits, drawn| bits & drawn[word]);
            let any = states.iter().fold(0, |bits, drawn| bits | drawn[word]);
            for bit in (0..64).filter(|bit| (all | !any) >> bit & 1 != 0) {
                self.release(adjacency, 64 * word + bit, all >> bit & 1 != 0);
            }
            for drawn in states.iter_mut() {
                drawn[word] &= !all;
            }
        }
    }

    /// Frees a column whose triangle either all states have drawn or none has.
    fn release(&mut self, adjacency: &TriangleAdjacency<'_>, column: usize, is_drawn: bool) {
        let triangle = std::mem::replace(&mut self.triangles[column], NO_TRIANGLE);
        if triangle == NO_TRIANGLE {
            return;
        }
        self.free.push(column as u16);
        self.columns[triangle as usize] = if is_drawn { FINAL } else { UNTOUCHED };
        if is_drawn {
            for v in adjacency.triangles[triangle as usize] {
                self.open_counts[v as usize] -= 1;
                let later = self.pending_around(adjacency, v);
                let count = later.iter().take_while(|&&t| self.is_final(t)).count();
                self.final_counts[v as usize] += count as u32;
            }
        }
    }
}

#[inline]
fn has(drawn: &DrawnBits, column: usize) -> bool {
    drawn[column / 64] >> (column % 64) & 1 != 0
}
