//! [`ConnectivityModel`]: flags and cuts. Flags depend only on numbers stored with each vertex.
//!
//! A vertex that does not split costs one access to three bytes: its triangle count, the batch that created
//! it, and the batch in which it last split. The surface is visited only around vertices that split, many
//! at a time, so that memory accesses overlap. Cuts around vertices with few triangles are two symbols: the
//! length, and which of the free runs of that length. The fast effort ranks these runs by edge length,
//! since vertices are missing where edges are long (`ranked_cuts.rs`); the compact effort scores them by a
//! learned model (`learned_cuts.rs`). Cuts around other vertices are sequences of binary decisions
//! (`chain_cuts.rs`).

use super::chain_cuts::{ChainCuts, Edges};
use super::learned_cuts::{LearnedCuts, Spoke as LearnedSpoke};
use super::ranked_cuts::{self, RankedCuts, RankedEdge};
use super::split_context::SplitContext;
use crate::entropy::{AdaptiveBit, Coder, Rate};
use crate::format::effort::Effort;
use crate::positions::Surroundings;
use crate::refine::walk::BatchWalk;
use crate::topology::rings::{Neighbor, Rings};
use crate::topology::surface::{Cut, Surface, triangle_of};

/// Data stored with a vertex.
#[derive(Clone, Copy, Debug, Default)]
struct VertexRecord {
    /// Number of triangles around it, at most 255.
    triangle_count: u8,
    /// The batch that created it, and the last batch that split it, modulo 256.
    created: u8,
    split: u8,
}

/// Mask of the recent flags that serve as context.
const RECENT_FLAGS_MASK: usize = 0xff;

/// Models of flags and cuts by small contexts.
#[derive(Clone, Debug)]
pub(crate) struct ConnectivityModel {
    records: Vec<VertexRecord>,
    batch: u8,
    /// Whether vertices have been renumbered, so that the triangles around each have to be counted again.
    is_renumbered: bool,
    /// The most recent flags, one bit each.
    recent_flags: usize,
    flags: Vec<AdaptiveBit>,
    /// Vertices that split, and the corners around them.
    splits: Vec<u32>,
    rings: Rings,
    cuts: ShortCuts,
    chains: ChainCuts,
    /// The batch in which each vertex was last visited, modulo 256; used only by learned cuts.
    visited: Vec<u8>,
    /// Start of each cut of the stretch: the index of the split, and of the first corner in its ring.
    begins: Vec<(u32, u32)>,
}

/// Coder of cuts around vertices with few triangles.
#[derive(Clone, Debug)]
enum ShortCuts {
    /// Two symbols: the length of the run and its rank.
    Ranked(RankedCuts),
    /// Two symbols, by scores of edges and triangles.
    Learned(Box<LearnedCuts>),
}

/// A split, and its cut for an encoder.
pub(crate) struct CutOfSplit {
    /// Number of the split.
    pub split: usize,
    /// The cut, if it is known.
    pub actual: Option<Cut>,
}

impl ConnectivityModel {
    /// Creates an untrained model, and counts the triangles around each vertex of the base.
    pub(crate) fn new(surface: &Surface, effort: Effort) -> Self {
        let bit = AdaptiveBit::new(Rate::Steady);
        let triangle_count = |v: u32| surface.ring(v).take(255).count() as u8;
        let record = |v: u32| VertexRecord { triangle_count: triangle_count(v), ..VertexRecord::default() };
        Self {
            records: (0..surface.vertex_count() as u32).map(record).collect(),
            batch: 0,
            is_renumbered: false,
            recent_flags: 0,
            flags: vec![bit; 16 * 4 * 4 * 8],
            splits: Vec::new(),
            rings: Rings::default(),
            cuts: match effort {
                Effort::Fast => ShortCuts::Ranked(RankedCuts::new()),
                Effort::Compact => ShortCuts::Learned(Box::new(LearnedCuts::new())),
            },
            chains: ChainCuts::new(),
            visited: Vec::new(),
            begins: Vec::new(),
        }
    }

    /// Reserves memory for `splits` more vertices.
    pub(crate) fn reserve(&mut self, splits: usize) {
        self.records.reserve_exact(splits);
        if self.is_learned() {
            self.visited.reserve_exact(self.records.len() + splits);
        }
    }

    /// Whether cuts are coded by the learned model.
    fn is_learned(&self) -> bool {
        matches!(self.cuts, ShortCuts::Learned(_))
    }

    /// Starts a batch.
    pub(crate) fn begin_batch(&mut self, surface: &Surface) {
        self.batch = self.batch.wrapping_add(1);
        if std::mem::take(&mut self.is_renumbered) {
            for (vertex, record) in (0..).zip(&mut self.records) {
                record.triangle_count = surface.ring(vertex).take(255).count() as u8;
            }
        }
        if self.is_learned() {
            self.visited.resize(surface.vertex_count(), self.batch.wrapping_sub(1));
        }
    }

    /// Renumbers what is stored per vertex after the surface has been rebuilt; gives the old index of each
    /// vertex, or [`NONE`](crate::topology::surface::NONE) for new ones, which count as just created.
    pub(crate) fn renumber(&mut self, old_of_new: &[u32]) {
        let new = VertexRecord { triangle_count: 6, created: self.batch, split: self.batch };
        self.records =
            old_of_new.iter().map(|&old| self.records.get(old as usize).copied().unwrap_or(new)).collect();
        self.is_renumbered = true;
        // No vertex has been visited in the next batch.
        self.visited.clear();
    }

    /// Returns the vertices that split, as far as flags have been coded.
    pub(crate) fn splits(&self) -> &[u32] {
        &self.splits
    }

    /// Codes flags until `max_splits` vertices split; returns true when the batch is complete.
    pub(crate) fn flags<C: Coder>(
        &mut self,
        coder: &mut C,
        walk: &mut BatchWalk,
        max_splits: usize,
        does_split: impl Fn(u32) -> bool,
    ) -> bool {
        self.splits.clear();
        let mut recent_flags = self.recent_flags;
        let mut visited = 0;
        for &vertex in walk.rest() {
            if self.splits.len() == max_splits {
                break;
            }
            visited += 1;
            let record = self.records[vertex as usize];
            let age = usize::from(self.batch.wrapping_sub(record.created).wrapping_sub(1)).min(3);
            let rest = usize::from(self.batch.wrapping_sub(record.split).wrapping_sub(1)).min(3);
            let recent = (recent_flags & RECENT_FLAGS_MASK).count_ones().min(7) as usize;
            let context = ((usize::from(record.triangle_count.min(15)) * 4 + age) * 4 + rest) * 8 + recent;
            let splits = self.flags[context].code(coder, !C::READS && does_split(vertex));
            recent_flags = recent_flags << 1 | usize::from(splits);
            if splits {
                self.splits.push(vertex);
            }
        }
        if self.is_learned() {
            for &vertex in &walk.rest()[..visited] {
                self.visited[vertex as usize] = self.batch;
            }
            for &vertex in &self.splits {
                self.records[vertex as usize].split = self.batch;
            }
        }
        walk.skip(visited);
        self.recent_flags = recent_flags;
        walk.rest().is_empty()
    }

    /// Finds the corners and neighbors around the vertices that split.
    pub(crate) fn find_rings(&mut self, surface: &Surface, grid_points: &[[i32; 3]]) {
        self.begins.clear();
        self.rings.find(surface, &self.splits);
        self.rings.look_up_neighbors(surface, grid_points);
    }

    /// Codes the cut of a vertex that splits, and appends the corners of its patch; returns false if no cut
    /// is possible.
    pub(crate) fn cut<C: Coder>(
        &mut self,
        coder: &mut C,
        split_context: &SplitContext<'_>,
        CutOfSplit { split, actual }: CutOfSplit,
        patch: &mut Vec<u32>,
    ) -> bool {
        let n = self.rings.of(split).len();
        let is_short = (2..=ranked_cuts::MAX_RING).contains(&n);
        let run = match self.cuts {
            ShortCuts::Ranked(_) if is_short => self.ranked_run(coder, split_context, split, actual),
            ShortCuts::Learned(_) if is_short => self.learned_run(coder, split_context, split, actual),
            _ => {
                let kept = split_context.grid_points[self.splits[split] as usize];
                let edges = Edges {
                    corners: self.rings.of(split),
                    neighbors: self.rings.neighbors(split),
                    position: kept,
                };
                self.chains.code(coder, split_context, edges, actual)
            }
        };
        let Some((start, length)) = run else { return false };
        let ring = self.rings.of(split);
        patch.extend((start..start + length).map(|at| ring[if at < n { at } else { at - n }]));
        self.begins.push((split as u32, start as u32));
        if self.is_learned() {
            // The following cuts see the triangle counts after this one.
            let at = |at: usize| self.rings.neighbors(split)[at % n].vertex;
            self.update_triangle_counts(self.splits[split], [at(start), at(start + length)], length);
        }
        true
    }

    /// Codes a cut by rank; returns its start in the ring and its length.
    fn ranked_run<C: Coder>(
        &mut self,
        coder: &mut C,
        split_context: &SplitContext<'_>,
        split: usize,
        actual: Option<Cut>,
    ) -> Option<(usize, usize)> {
        let ring = self.rings.of(split);
        let kept = split_context.grid_points[self.splits[split] as usize];
        let mut edges = [RankedEdge::default(); ranked_cuts::MAX_RING];
        for ((edge, &corner), neighbor) in edges.iter_mut().zip(ring).zip(self.rings.neighbors(split)) {
            let is_virtual = split_context.surface.is_virtual(neighbor.vertex);
            let square = (0..3).map(|a| i64::from(neighbor.grid_point[a] - kept[a]).pow(2)).sum::<i64>();
            *edge = RankedEdge {
                square: if is_virtual { 0 } else { square },
                missing_triangles: if is_virtual {
                    0
                } else {
                    6 - self.records[neighbor.vertex as usize].triangle_count.min(15) as i8
                },
                is_virtual,
                is_free: !split_context.is_claimed(triangle_of(corner)),
            };
        }
        let ShortCuts::Ranked(cuts) = &mut self.cuts else { return None };
        cuts.code(coder, &edges[..ring.len()], split_context.max_patch as usize, run_in_ring(actual, ring))
    }

    /// Codes a cut by the learned model; returns its start in the ring and its length.
    fn learned_run<C: Coder>(
        &mut self,
        coder: &mut C,
        split_context: &SplitContext<'_>,
        split: usize,
        actual: Option<Cut>,
    ) -> Option<(usize, usize)> {
        let ring = self.rings.of(split);
        let vertex = self.splits[split];
        let here = split_context.grid_points[vertex as usize];
        let mut spokes = [LearnedSpoke::default(); ranked_cuts::MAX_RING];
        for ((spoke, &corner), neighbor) in spokes.iter_mut().zip(ring).zip(self.rings.neighbors(split)) {
            let is_free = !split_context.is_claimed(triangle_of(corner));
            *spoke = if split_context.surface.is_virtual(neighbor.vertex) {
                LearnedSpoke { valence: 9, history: 13, is_virtual: true, is_free, ..LearnedSpoke::default() }
            } else {
                LearnedSpoke {
                    step: std::array::from_fn(|a| neighbor.grid_point[a].wrapping_sub(here[a])),
                    valence: self.records[neighbor.vertex as usize].triangle_count,
                    history: self.history(neighbor.vertex),
                    is_virtual: false,
                    is_free,
                }
            };
        }
        let limits =
            (usize::from(self.records[vertex as usize].triangle_count), split_context.max_patch as usize);
        let ShortCuts::Learned(cuts) = &mut self.cuts else { return None };
        cuts.code(coder, &mut spokes[..ring.len()], limits, run_in_ring(actual, ring))
    }

    /// Returns four times the age of a vertex in batches, up to 3, plus its state: not visited, stays,
    /// splits, new.
    #[inline]
    fn history(&self, vertex: u32) -> u8 {
        let record = self.records[vertex as usize];
        let age = self.batch.wrapping_sub(record.created).min(3);
        let is_visited = self.visited.get(vertex as usize) == Some(&self.batch);
        let state = if age == 0 { 3 } else { u8::from(is_visited) + u8::from(record.split == self.batch) };
        4 * age + state
    }

    /// Visits the surroundings of each vertex that the cuts will create, in order, before any split is
    /// applied. `patches` contains the corners of all patches, and `ends` the end of each patch.
    pub(crate) fn for_each_surroundings(
        &self,
        surface: &Surface,
        grid_points: &[[i32; 3]],
        (patches, ends): (&[u32], &[u32]),
        mut visit: impl FnMut(&Surroundings),
    ) {
        let mut first = 0;
        let mut around = Surroundings::default();
        for (&(split, begin), &end) in self.begins.iter().zip(ends) {
            let patch = &patches[first..end as usize];
            first = end as usize;
            let neighbors = self.rings.neighbors(split as usize);
            let kept = grid_points[self.splits[split as usize] as usize];
            gather_surroundings(
                surface,
                grid_points,
                (neighbors, begin as usize),
                (patch, kept),
                &mut around,
            );
            visit(&around);
        }
    }

    /// Records that a split has been applied. The new vertex has `length` triangles plus the last two of
    /// the surface.
    pub(crate) fn split(&mut self, surface: &Surface, length: usize, kept: u32) {
        let triangle_count = (length + 2).min(255) as u8;
        self.records.push(VertexRecord { triangle_count, created: self.batch, split: self.batch });
        if !self.is_learned() {
            let last = surface.triangle_count() as u32 - 1;
            let ends = [surface.vertex(4 * (last - 1) + 2), surface.vertex(4 * last + 1)];
            self.update_triangle_counts(kept, ends, length);
        }
        self.records[kept as usize].split = self.batch;
    }

    /// Updates the triangle counts for a split: the split vertex loses `length` triangles and gets two new
    /// ones, each end of the cut gets one.
    fn update_triangle_counts(&mut self, kept: u32, ends: [u32; 2], length: usize) {
        for end in ends {
            let end = &mut self.records[end as usize];
            end.triangle_count = end.triangle_count.saturating_add(1);
        }
        let record = &mut self.records[kept as usize];
        if record.triangle_count < 255 {
            // Two new triangles.
            record.triangle_count =
                (usize::from(record.triangle_count) + 2).saturating_sub(length).min(255) as u8;
        }
    }
}

/// Returns the start of a cut in a ring and its length, or (0, 1) for a reader.
fn run_in_ring(cut: Option<Cut>, ring: &[u32]) -> (usize, usize) {
    cut.map_or((0, 1), |cut| {
        let start = ring.iter().position(|&corner| corner == cut.first);
        (start.unwrap_or(0), cut.length as usize)
    })
}

/// Gathers the surroundings of the vertex that takes over a patch.
#[inline]
fn gather_surroundings(
    surface: &Surface,
    grid_points: &[[i32; 3]],
    (neighbors, begin): (&[Neighbor], usize),
    (patch, [x, y, z]): (&[u32], [i32; 3]),
    around: &mut Surroundings,
) {
    let n = neighbors.len();
    let wrap = |at: usize| if at < n { at } else { at - n };
    let point = |vertex: u32, [x, y, z]: [i32; 3]| {
        if surface.is_virtual(vertex) { [0; 4] } else { [x, y, z, 1] }
    };
    let neighbor = |at: usize| {
        let neighbor = &neighbors[wrap(at)];
        point(neighbor.vertex, neighbor.grid_point)
    };
    around.ring[0] = [x, y, z, 1];
    around.across[0] = neighbor(begin + n - 1);
    let capacity = around.ring.len() - 1;
    for (at, &corner) in patch.iter().enumerate().take(capacity) {
        around.ring[at + 1] = neighbor(begin + at);
        let across = surface.vertex(surface.opposite(corner));
        around.across[at + 1] = point(across, grid_points[across as usize]);
    }
    if let Some(last) = around.ring.get_mut(patch.len() + 1) {
        *last = neighbor(begin + patch.len());
        around.across[patch.len() + 1] = neighbor(wrap(begin + patch.len()) + 1);
    }
    around.count = (patch.len() + 2).min(around.ring.len());
}

#[cfg(test)]
mod tests {
    use striata::mesh::shapes;

    use super::*;
    use crate::topology::cutting::close;
    use crate::topology::surface::NONE;

    #[test]
    fn records_follow_renumbered_vertices() {
        let mesh = shapes::grid(5, 4);
        let mut surface = close(&mesh.triangles, mesh.positions.len()).surface;
        let mut model = ConnectivityModel::new(&surface, Effort::Fast);
        model.begin_batch(&surface);
        let corner = surface.corner_of(7);
        let new = surface.split(&[corner]);
        model.split(&surface, 1, 7);
        model.renumber(&[0, new, 7, 2, NONE]);
        assert_eq!([1, 2, 3, 4].map(|v| model.records[v].split), [1, 1, 0, 1]);
        assert_eq!([1, 2, 3, 4].map(|v| model.records[v].created), [1, 0, 0, 1]);
        model.begin_batch(&surface);
        for (vertex, record) in (0..).zip(&model.records) {
            assert_eq!(usize::from(record.triangle_count), surface.ring(vertex).count());
        }
    }
}
