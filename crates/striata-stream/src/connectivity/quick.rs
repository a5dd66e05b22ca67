//! Connectivity for those who cannot wait: what is asked of every vertex depends on numbers that are kept with it.
//!
//! A vertex that does not split costs one look at three bytes: its triangles, and how long ago it came and split. Only around
//! those that split the surface is walked, many at a time, so that no walk waits for memory alone. Then the length of each
//! cut is told, and which of the free runs of that length, the ones with the longest edges first, since that is where a
//! vertex is missing. Cuts around vertices of few triangles are two symbols (`quick_cuts.rs`); around others, and in streams of
//! the first version, they are chains of decisions (`chain_cuts.rs`). Effort default takes cuts of few triangles from `learned.rs`.

use super::chain_cuts::{ChainCuts, Edges};
use super::learned::{LearnedCuts, Spoke as LearnedSpoke};
use super::quick_cuts::{self, Edge, QuickCuts};
use super::scene::Scene;
use crate::entropy::{AdaptiveBit, Coder, Rate};
use crate::format::form::{Effort, StreamVersion};
use crate::positions::Surroundings;
use crate::refine::walk::Walk;
use crate::topology::rings::{Neighbor, Rings};
use crate::topology::surface::{Cut, Surface, triangle_of};

/// What is kept with a vertex.
#[derive(Clone, Copy, Debug, Default)]
struct Kept {
    /// Triangles around it, at most 255.
    triangles: u8,
    /// The batch that made it, and the last one that split it, modulo 256.
    made: u8,
    split: u8,
}

/// Flags that make up the history.
const HISTORY: usize = 0xff;

/// Flags and cuts by small contexts.
#[derive(Clone, Debug)]
pub(crate) struct QuickModel {
    kept: Vec<Kept>,
    batch: u8,
    /// How many triangles lie around each vertex has to be counted again.
    is_renumbered: bool,
    /// The last few flags.
    history: usize,
    flags: Vec<AdaptiveBit>,
    /// Vertices that split, and the corners around them.
    splits: Vec<u32>,
    rings: Rings,
    cuts: Cuts,
    chains: ChainCuts,
    /// The batch in which each vertex was asked last, modulo 256, if that matters to cuts.
    asked: Vec<u8>,
    /// Where the runs of the stretch begin: which of the vertices that split, and which of the corners around it.
    begins: Vec<(u32, u32)>,
}

/// What codes cuts around vertices of few triangles.
#[derive(Clone, Debug)]
enum Cuts {
    /// The same chains of decisions as around others.
    Chains,
    /// Two symbols, by ranks.
    Ranked(QuickCuts),
    /// Two symbols, by what is seen of edges and triangles.
    Learned(Box<LearnedCuts>),
}

impl QuickModel {
    /// Nothing learned; counts the triangles around the vertices of a base.
    pub(crate) fn new(surface: &Surface, (effort, version): (Effort, StreamVersion)) -> Self {
        let bit = AdaptiveBit::new(Rate::Steady);
        let triangles = |v: u32| surface.ring(v).take(255).count() as u8;
        let kept = |v: u32| Kept { triangles: triangles(v), ..Kept::default() };
        Self {
            kept: (0..surface.vertex_count() as u32).map(kept).collect(),
            batch: 0,
            is_renumbered: false,
            history: 0,
            flags: vec![bit; 16 * 4 * 4 * 8],
            splits: Vec::new(),
            rings: Rings::default(),
            cuts: match (version, effort) {
                (StreamVersion::One, _) => Cuts::Chains,
                (_, Effort::Fast) => Cuts::Ranked(QuickCuts::new()),
                _ => Cuts::Learned(Box::new(LearnedCuts::new())),
            },
            chains: ChainCuts::new(),
            asked: Vec::new(),
            begins: Vec::new(),
        }
    }

    /// Makes room for so many splits.
    pub(crate) fn reserve(&mut self, splits: usize) {
        self.kept.reserve_exact(splits);
        if self.is_learned() {
            self.asked.reserve_exact(self.kept.len() + splits);
        }
    }

    /// Whether cuts are learned from what is around vertices.
    fn is_learned(&self) -> bool {
        matches!(self.cuts, Cuts::Learned(_))
    }

    /// A batch begins.
    pub(crate) fn begin_batch(&mut self, surface: &Surface) {
        self.batch = self.batch.wrapping_add(1);
        if std::mem::take(&mut self.is_renumbered) {
            for (vertex, kept) in (0..).zip(&mut self.kept) {
                kept.triangles = surface.ring(vertex).take(255).count() as u8;
            }
        }
        if self.is_learned() {
            self.asked.resize(surface.vertex_count(), self.batch.wrapping_sub(1));
        }
    }

    /// The surface has been built anew between two batches: here is the old number of each vertex, or [`NONE`]. Those count as made
    /// just now.
    pub(crate) fn renumber(&mut self, old_of_new: &[u32]) {
        let new = Kept { triangles: 6, made: self.batch, split: self.batch };
        self.kept =
            old_of_new.iter().map(|&old| self.kept.get(old as usize).copied().unwrap_or(new)).collect();
        self.is_renumbered = true;
        // Nobody has been asked in the batch that comes next.
        self.asked.clear();
    }

    /// Vertices that split, as far as flags have been coded.
    pub(crate) fn splits(&self) -> &[u32] {
        &self.splits
    }

    /// Codes which vertices split, until there are `most`; true where the batch is done.
    pub(crate) fn flags<C: Coder>(
        &mut self,
        coder: &mut C,
        walk: &mut Walk,
        most: usize,
        does_split: impl Fn(u32) -> bool,
    ) -> bool {
        self.splits.clear();
        let mut history = self.history;
        let mut asked = 0;
        for &vertex in walk.rest() {
            if self.splits.len() == most {
                break;
            }
            asked += 1;
            let kept = self.kept[vertex as usize];
            let age = usize::from(self.batch.wrapping_sub(kept.made).wrapping_sub(1)).min(3);
            let rest = usize::from(self.batch.wrapping_sub(kept.split).wrapping_sub(1)).min(3);
            let recent = (history & HISTORY).count_ones().min(7) as usize;
            let context = ((usize::from(kept.triangles.min(15)) * 4 + age) * 4 + rest) * 8 + recent;
            let splits = self.flags[context].code(coder, !C::READS && does_split(vertex));
            history = history << 1 | usize::from(splits);
            if splits {
                self.splits.push(vertex);
            }
        }
        if self.is_learned() {
            for &vertex in &walk.rest()[..asked] {
                self.asked[vertex as usize] = self.batch;
            }
            for &vertex in &self.splits {
                self.kept[vertex as usize].split = self.batch;
            }
        }
        walk.pass(asked);
        self.history = history;
        walk.rest().is_empty()
    }

    /// Finds the corners around the vertices that split.
    pub(crate) fn find_rings(&mut self, surface: &Surface, places: &[[i32; 3]]) {
        self.begins.clear();
        self.rings.find(surface, &self.splits);
        self.rings.look(surface, places);
    }

    /// Codes the cut of a vertex that splits, and appends the corners of its patch; false where no cut is left.
    pub(crate) fn cut<C: Coder>(
        &mut self,
        coder: &mut C,
        scene: &Scene<'_>,
        (split, actual): (usize, Option<Cut>),
        patch: &mut Vec<u32>,
    ) -> bool {
        let n = self.rings.of(split).len();
        let is_short = (2..=quick_cuts::MOST).contains(&n);
        let run = match self.cuts {
            Cuts::Ranked(_) if is_short => self.ranked_run(coder, scene, (split, actual)),
            Cuts::Learned(_) if is_short => self.learned_run(coder, scene, (split, actual)),
            _ => {
                let kept = scene.places[self.splits[split] as usize];
                let edges =
                    Edges { corners: self.rings.of(split), neighbors: self.rings.neighbors(split), kept };
                self.chains.code(coder, scene, edges, actual)
            }
        };
        let Some((start, length)) = run else { return false };
        let ring = self.rings.of(split);
        patch.extend((start..start + length).map(|at| ring[if at < n { at } else { at - n }]));
        self.begins.push((split as u32, start as u32));
        if self.is_learned() {
            // The cuts that come next see what this one leaves.
            let at = |at: usize| self.rings.neighbors(split)[at % n].vertex;
            self.count(self.splits[split], [at(start), at(start + length)], length);
        }
        true
    }

    /// Codes a cut around a vertex of few triangles: where it begins in the ring, and its length.
    fn ranked_run<C: Coder>(
        &mut self,
        coder: &mut C,
        scene: &Scene<'_>,
        (split, actual): (usize, Option<Cut>),
    ) -> Option<(usize, usize)> {
        let ring = self.rings.of(split);
        let kept = scene.places[self.splits[split] as usize];
        let mut edges = [Edge::default(); quick_cuts::MOST];
        for ((edge, &corner), neighbor) in edges.iter_mut().zip(ring).zip(self.rings.neighbors(split)) {
            let is_virtual = scene.surface.is_virtual(neighbor.vertex);
            let square = (0..3).map(|a| i64::from(neighbor.place[a] - kept[a]).pow(2)).sum::<i64>();
            *edge = Edge {
                square: if is_virtual { 0 } else { square },
                few: if is_virtual {
                    0
                } else {
                    6 - self.kept[neighbor.vertex as usize].triangles.min(15) as i8
                },
                is_virtual,
                is_free: !scene.is_taken(triangle_of(corner)),
            };
        }
        let Cuts::Ranked(cuts) = &mut self.cuts else { return None };
        cuts.code(coder, &edges[..ring.len()], scene.max_patch as usize, place_of(actual, ring))
    }

    /// The same by what is seen of the edges and triangles.
    fn learned_run<C: Coder>(
        &mut self,
        coder: &mut C,
        scene: &Scene<'_>,
        (split, actual): (usize, Option<Cut>),
    ) -> Option<(usize, usize)> {
        let ring = self.rings.of(split);
        let vertex = self.splits[split];
        let here = scene.places[vertex as usize];
        let mut spokes = [LearnedSpoke::default(); quick_cuts::MOST];
        for ((spoke, &corner), neighbor) in spokes.iter_mut().zip(ring).zip(self.rings.neighbors(split)) {
            let is_free = !scene.is_taken(triangle_of(corner));
            *spoke = if scene.surface.is_virtual(neighbor.vertex) {
                LearnedSpoke { valence: 9, past: 13, is_virtual: true, is_free, ..LearnedSpoke::default() }
            } else {
                LearnedSpoke {
                    step: std::array::from_fn(|a| neighbor.place[a].wrapping_sub(here[a])),
                    valence: self.kept[neighbor.vertex as usize].triangles,
                    past: self.past(neighbor.vertex),
                    is_virtual: false,
                    is_free,
                }
            };
        }
        let known = (usize::from(self.kept[vertex as usize].triangles), scene.max_patch as usize);
        let Cuts::Learned(cuts) = &mut self.cuts else { return None };
        cuts.code(coder, &mut spokes[..ring.len()], known, place_of(actual, ring))
    }

    /// Four times the age of a vertex in batches, up to 3, and what became of it: not asked, stays, splits, new.
    #[inline]
    fn past(&self, vertex: u32) -> u8 {
        let kept = self.kept[vertex as usize];
        let age = self.batch.wrapping_sub(kept.made).min(3);
        let is_asked = self.asked.get(vertex as usize) == Some(&self.batch);
        let fate = if age == 0 { 3 } else { u8::from(is_asked) + u8::from(kept.split == self.batch) };
        4 * age + fate
    }

    /// Tells what is around the vertices that the cuts make, in order, before any is made; `patches` has the corners of their
    /// patches, up to `ends`.
    pub(crate) fn look_around(
        &self,
        surface: &Surface,
        places: &[[i32; 3]],
        (patches, ends): (&[u32], &[u32]),
        mut tell: impl FnMut(&Surroundings),
    ) {
        let mut first = 0;
        let mut around = Surroundings::default();
        for (&(split, begin), &end) in self.begins.iter().zip(ends) {
            let patch = &patches[first..end as usize];
            first = end as usize;
            let neighbors = self.rings.neighbors(split as usize);
            let kept = places[self.splits[split as usize] as usize];
            look_around(surface, places, (neighbors, begin as usize), (patch, kept), &mut around);
            tell(&around);
        }
    }

    /// A split has been done: the new vertex has A and B, the last two triangles, and so many others.
    pub(crate) fn split(&mut self, surface: &Surface, length: usize, kept: u32) {
        let triangles = (length + 2).min(255) as u8;
        self.kept.push(Kept { triangles, made: self.batch, split: self.batch });
        if !self.is_learned() {
            let last = surface.triangle_count() as u32 - 1;
            let ends = [surface.vertex(4 * (last - 1) + 2), surface.vertex(4 * last + 1)];
            self.count(kept, ends, length);
        }
        self.kept[kept as usize].split = self.batch;
    }

    /// Counts triangles after a split that leaves a vertex so many fewer but for two, and gives one more to each end.
    fn count(&mut self, kept: u32, ends: [u32; 2], length: usize) {
        for end in ends {
            let end = &mut self.kept[end as usize];
            end.triangles = end.triangles.saturating_add(1);
        }
        let kept = &mut self.kept[kept as usize];
        if kept.triangles < 255 {
            // Two of them are new.
            kept.triangles = (usize::from(kept.triangles) + 2).saturating_sub(length).min(255) as u8;
        }
    }
}

/// Where in a ring a cut begins that a writer means, and its length.
fn place_of(cut: Option<Cut>, ring: &[u32]) -> (usize, usize) {
    cut.map_or((0, 1), |cut| {
        let start = ring.iter().position(|&corner| corner == cut.first);
        (start.unwrap_or(0), cut.length as usize)
    })
}

/// What is around the vertex that takes over a patch.
#[inline]
fn look_around(
    surface: &Surface,
    places: &[[i32; 3]],
    (neighbors, begin): (&[Neighbor], usize),
    (patch, [x, y, z]): (&[u32], [i32; 3]),
    around: &mut Surroundings,
) {
    let n = neighbors.len();
    let wrap = |at: usize| if at < n { at } else { at - n };
    let spot = |vertex: u32, [x, y, z]: [i32; 3]| {
        if surface.is_virtual(vertex) { [0; 4] } else { [x, y, z, 1] }
    };
    let neighbor = |at: usize| {
        let neighbor = &neighbors[wrap(at)];
        spot(neighbor.vertex, neighbor.place)
    };
    around.ring[0] = [x, y, z, 1];
    around.across[0] = neighbor(begin + n - 1);
    let places_left = around.ring.len() - 1;
    for (at, &corner) in patch.iter().enumerate().take(places_left) {
        around.ring[at + 1] = neighbor(begin + at);
        let across = surface.vertex(surface.opposite(corner));
        around.across[at + 1] = spot(across, places[across as usize]);
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
    fn what_is_kept_follows_vertices_to_new_numbers() {
        let mesh = shapes::grid(5, 4);
        let mut surface = close(&mesh.triangles, mesh.positions.len()).surface;
        let mut model = QuickModel::new(&surface, (Effort::Fast, StreamVersion::Two));
        model.begin_batch(&surface);
        let corner = surface.corner_of(7);
        let new = surface.split(&[corner]);
        model.split(&surface, 1, 7);
        model.renumber(&[0, new, 7, 2, NONE]);
        assert_eq!([1, 2, 3, 4].map(|v| model.kept[v].split), [1, 1, 0, 1]);
        assert_eq!([1, 2, 3, 4].map(|v| model.kept[v].made), [1, 0, 0, 1]);
        model.begin_batch(&surface);
        for (vertex, kept) in (0..).zip(&model.kept) {
            assert_eq!(usize::from(kept.triangles), surface.ring(vertex).count());
        }
    }
}
