//! Which triangles each of many partial answers has drawn, in little memory.
//!
//! The answers of a beam search share nearly all that they have drawn. What all of them have drawn is **settled**, with one
//! mark for all; a triangle that only some have drawn takes a **column**, and each answer has one bit for each
//! column. To copy an answer is to copy 128 bytes, and a question costs two loads. Two bytes a triangle and
//! eight a vertex.

use super::surface::Surface;

/// Columns that there are.
pub(super) const COLUMN_COUNT: usize = 1024;
const WORD_COUNT: usize = COLUMN_COUNT / 64;

/// The bits of one answer.
pub(super) type Drawn = [u64; WORD_COUNT];

const UNTOUCHED: u16 = u16::MAX;
const SETTLED: u16 = u16::MAX - 1;
const NO_TRIANGLE: u32 = u32::MAX;

/// Up to this many triangles around a vertex are asked one by one.
const SMALL_VALENCE: usize = 32;

/// What all answers know in common.
pub(super) struct Covered {
    /// The column of each triangle, or [`UNTOUCHED`] or [`SETTLED`].
    columns: Vec<u16>,
    /// The triangle of each column that is in use.
    triangles: Vec<u32>,
    free: Vec<u16>,
    /// Proper triangles around each vertex that are not settled.
    open_counts: Vec<u32>,
    /// Settled triangles at the beginning of those around each vertex.
    settled_counts: Vec<u32>,
}

impl Covered {
    pub(super) fn new(surface: &Surface<'_>) -> Self {
        let valence = |v: usize| surface.around(v as u32).len() as u32;
        Self {
            columns: vec![UNTOUCHED; surface.triangles.len()],
            triangles: vec![NO_TRIANGLE; COLUMN_COUNT],
            free: (0..COLUMN_COUNT as u16).rev().collect(),
            open_counts: (0..surface.vertex_limit()).map(valence).collect(),
            settled_counts: vec![0; surface.vertex_limit()],
        }
    }

    /// Whether every answer has drawn this triangle.
    #[inline]
    pub(super) fn is_settled(&self, triangle: u32) -> bool {
        self.columns[triangle as usize] == SETTLED
    }

    #[inline]
    pub(super) fn is_drawn(&self, drawn: &Drawn, triangle: u32) -> bool {
        match self.columns[triangle as usize] {
            UNTOUCHED => false,
            SETTLED => true,
            column => has(drawn, usize::from(column)),
        }
    }

    /// Columns that can still be taken.
    pub(super) fn free_count(&self) -> usize {
        self.free.len()
    }

    /// Draws a triangle in one answer.
    ///
    /// # Panics
    /// If it needs a column and none is free.
    pub(super) fn draw(&mut self, drawn: &mut Drawn, triangle: u32) {
        debug_assert!(!self.is_drawn(drawn, triangle), "triangle {triangle} is drawn twice");
        let column = &mut self.columns[triangle as usize];
        if *column == UNTOUCHED {
            *column = self.free.pop().expect("the search settles before columns run out");
            self.triangles[usize::from(*column)] = triangle;
        }
        drawn[usize::from(*column) / 64] |= 1 << (*column % 64);
    }

    /// Proper triangles around a vertex that an answer has not drawn.
    pub(super) fn open_count(&self, surface: &Surface<'_>, drawn: &Drawn, v: u32) -> u32 {
        let around = surface.around(v);
        if around.len() <= SMALL_VALENCE {
            return around.iter().filter(|&&t| !self.is_drawn(drawn, t)).count() as u32;
        }
        // Around the hub of a large fan it is quicker to count what is drawn and not yet settled.
        let is_here = |column: &usize| {
            has(drawn, *column) && surface.triangles[self.triangles[*column] as usize].contains(&v)
        };
        self.open_counts[v as usize] - (0..COLUMN_COUNT).filter(is_here).count() as u32
    }

    /// The triangles around a vertex, without those at the beginning that are settled.
    pub(super) fn unsettled_around<'s>(&self, surface: &'s Surface<'_>, v: u32) -> &'s [u32] {
        &surface.around(v)[self.settled_counts[v as usize] as usize..]
    }

    /// Settles what all answers have drawn, and frees the columns of what none has.
    pub(super) fn settle(&mut self, surface: &Surface<'_>, answers: &mut [&mut Drawn]) {
        for word in 0..WORD_COUNT {
            let all = answers.iter().fold(u64::MAX, |bits, drawn| bits & drawn[word]);
            let any = answers.iter().fold(0, |bits, drawn| bits | drawn[word]);
            for bit in (0..64).filter(|bit| (all | !any) >> bit & 1 != 0) {
                self.release(surface, 64 * word + bit, all >> bit & 1 != 0);
            }
            for drawn in answers.iter_mut() {
                drawn[word] &= !all;
            }
        }
    }

    /// Frees a column whose triangle all answers have drawn, or none.
    fn release(&mut self, surface: &Surface<'_>, column: usize, is_drawn: bool) {
        let triangle = std::mem::replace(&mut self.triangles[column], NO_TRIANGLE);
        if triangle == NO_TRIANGLE {
            return;
        }
        self.free.push(column as u16);
        self.columns[triangle as usize] = if is_drawn { SETTLED } else { UNTOUCHED };
        if is_drawn {
            for v in surface.triangles[triangle as usize] {
                self.open_counts[v as usize] -= 1;
                let later = self.unsettled_around(surface, v);
                let count = later.iter().take_while(|&&t| self.is_settled(t)).count();
                self.settled_counts[v as usize] += count as u32;
            }
        }
    }
}

#[inline]
fn has(drawn: &Drawn, column: usize) -> bool {
    drawn[column / 64] >> (column % 64) & 1 != 0
}
