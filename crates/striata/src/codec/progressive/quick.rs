//! Connectivity for those who cannot wait: what is asked of every vertex depends on numbers that are kept with it.
//!
//! Vertices are asked in the order of their numbers, and a vertex that does not split costs one look at four bytes: its
//! triangles, how many of them are taken, and how long ago it came and split. Only where one does is the surface walked:
//! the length of its cut is told, and then which of the runs of that length, the ones with the longest edges
//! first, since that is where a vertex is missing.

use super::super::entropy::{AdaptiveBit, Coder, Rate};
use super::connectivity::Scene;
use super::surface::{Cut, Surface, next, previous, triangle_of};

/// What is kept with a vertex; counts stop at 255.
#[derive(Clone, Copy, Debug, Default)]
struct Kept {
    triangles: u8,
    /// Triangles that no other split of the batch may have.
    taken: u8,
    /// The batch that made it, and the last one that split it, modulo 256.
    made: u8,
    split: u8,
}

/// Lengths and ranks that are told apart.
const MOST: usize = 16;

/// Flags and cuts by small contexts.
#[derive(Clone, Debug)]
pub(super) struct QuickModel {
    kept: Vec<Kept>,
    /// The next vertex to be asked, and the last one of the batch.
    next: u32,
    end: u32,
    batch: u8,
    /// The last few flags.
    history: usize,
    flags: Vec<AdaptiveBit>,
    lengths: Vec<AdaptiveBit>,
    ranks: Vec<AdaptiveBit>,
    starts: Vec<(i64, u32)>,
    spokes: Vec<Spoke>,
}

/// An edge from a vertex that splits, and the triangle behind it.
#[derive(Clone, Copy, Debug)]
struct Spoke {
    /// Its squared length.
    square: i64,
    is_virtual: bool,
    /// Whether the triangle counter-clockwise of it is free.
    is_free: bool,
}

impl QuickModel {
    /// Nothing learned; counts the triangles around the vertices of a base.
    pub(super) fn new(surface: &Surface) -> Self {
        let bit = AdaptiveBit::new(Rate::Steady);
        let triangles = |v: u32| surface.ring(v).count().min(255) as u8;
        let kept = |v: u32| Kept { triangles: triangles(v), ..Kept::default() };
        Self {
            kept: (0..surface.vertex_count() as u32).map(kept).collect(),
            next: 0,
            end: 0,
            batch: 0,
            history: 0,
            flags: vec![bit; 16 * 8 * 4 * 4 * 4],
            lengths: vec![bit; MOST * MOST],
            ranks: vec![bit; MOST * MOST * MOST],
            starts: Vec::new(),
            spokes: Vec::new(),
        }
    }

    /// A batch begins.
    pub(super) fn begin_batch(&mut self, surface: &Surface) {
        self.batch = self.batch.wrapping_add(1);
        self.next = surface.virtual_count();
        self.end = surface.vertex_count() as u32;
        self.kept.iter_mut().for_each(|kept| kept.taken = 0);
    }

    /// Codes up to the next vertex that splits: that vertex, or none where the batch is done.
    pub(super) fn next_split<C: Coder>(
        &mut self,
        coder: &mut C,
        mut splits: impl FnMut(u32) -> bool,
    ) -> Option<u32> {
        while self.next < self.end {
            let vertex = self.next;
            self.next += 1;
            let kept = self.kept[vertex as usize];
            if kept.taken >= kept.triangles && kept.triangles < 255 {
                continue;
            }
            let age = usize::from(self.batch.wrapping_sub(kept.made) - 1).min(3);
            let rest = usize::from(self.batch.wrapping_sub(kept.split) - 1).min(3);
            let recent = (self.history & 0xff).count_ones().min(3) as usize;
            let counts = usize::from(kept.triangles.min(15)) * 8 + usize::from(kept.taken.min(7));
            let context = ((counts * 4 + age) * 4 + rest) * 4 + recent;
            let does = self.flags[context].code(coder, !C::READS && splits(vertex));
            self.history = self.history << 1 | usize::from(does);
            if does {
                return Some(vertex);
            }
        }
        None
    }

    /// Codes the cut of a vertex that splits; `corners` are all around it. None where no cut is left.
    pub(super) fn cut<C: Coder>(
        &mut self,
        coder: &mut C,
        scene: &Scene<'_>,
        corners: &[u32],
        actual: Option<Cut>,
    ) -> Option<Cut> {
        let n = corners.len();
        let most = (scene.max_patch as usize).min(n - 1);
        let meant = actual.map_or(0, |cut| cut.length as usize);
        let mut length = 1;
        while length < most {
            let bit = &mut self.lengths[n.min(MOST - 1) * MOST + length.min(MOST - 1)];
            if !bit.code(coder, meant > length) {
                break;
            }
            length += 1;
        }
        self.find_starts(scene, corners, length);
        let first = actual.map_or(0, |cut| cut.first);
        let key = (n.min(MOST - 1) * MOST + length.min(MOST - 1)) * MOST;
        let mut rank = 0;
        loop {
            let best = (0..self.starts.len()).max_by_key(|&at| self.starts[at])?;
            let (_, start) = self.starts.swap_remove(best);
            let is_last = self.starts.is_empty();
            if is_last || self.ranks[key + rank.min(MOST - 1)].code(coder, start == first) {
                return Some(Cut { first: start, length: length as u32 });
            }
            rank += 1;
        }
    }

    /// The corners where a run of free triangles can begin, and how long its edges are.
    fn find_starts(&mut self, scene: &Scene<'_>, corners: &[u32], length: usize) {
        let Scene { surface, places, .. } = *scene;
        let n = corners.len();
        let kept = places[surface.vertex(corners[0]) as usize];
        self.spokes.clear();
        self.spokes.extend(corners.iter().map(|&corner| {
            let vertex = surface.vertex(next(corner));
            let is_virtual = surface.is_virtual(vertex);
            let place = if is_virtual { kept } else { places[vertex as usize] };
            let square = (0..3).map(|a| (i64::from(place[a]) - i64::from(kept[a])).pow(2)).sum();
            Spoke { square, is_virtual, is_free: !scene.is_taken(triangle_of(corner)) }
        }));
        self.starts.clear();
        'starts: for start in 0..n {
            let mut at = start;
            let mut sum = self.spokes[start].square;
            for left in (0..length).rev() {
                let is_free = self.spokes[at].is_free;
                at = if at + 1 == n { 0 } else { at + 1 };
                let spoke = self.spokes[at];
                // What is inside the run leaves the vertex: it counts twice, and is no boundary.
                if !is_free || (left > 0 && spoke.is_virtual) {
                    continue 'starts;
                }
                sum += spoke.square << u32::from(left > 0);
            }
            self.starts.push((sum, corners[start]));
        }
    }

    /// The triangles of a patch are taken.
    pub(super) fn take(&mut self, surface: &Surface, patch: &[u32]) {
        let mut take = |vertex: u32, count: usize| {
            let kept = &mut self.kept[vertex as usize];
            kept.taken = kept.taken.saturating_add(count.min(255) as u8);
        };
        take(surface.vertex(patch[0]), patch.len());
        for &corner in patch {
            take(surface.vertex(next(corner)), 1);
            take(surface.vertex(previous(corner)), 1);
        }
    }

    /// A split has been done: `vertex` is new, with A and B as the last two triangles.
    pub(super) fn split(&mut self, surface: &Surface, length: usize, kept: u32) {
        let triangles = (length + 2).min(255) as u8;
        self.kept.push(Kept { triangles, taken: triangles, made: self.batch, split: self.batch });
        let last = surface.triangle_count() as u32 - 1;
        let ends = [surface.vertex(4 * (last - 1) + 2), surface.vertex(4 * last + 1)];
        for end in ends {
            let end = &mut self.kept[end as usize];
            end.triangles = end.triangles.saturating_add(1);
            end.taken = end.taken.saturating_add(1);
        }
        let kept = &mut self.kept[kept as usize];
        let gone = length.min(255) as u8;
        if kept.triangles < 255 {
            kept.triangles = kept.triangles.saturating_sub(gone).saturating_add(2);
        }
        kept.taken = kept.taken.saturating_sub(gone).saturating_add(2);
        kept.split = self.batch;
    }
}
