//! The loop that both sides of a stream run: which vertices split, the splits, and what the new vertices are.
//!
//! One generic code over a [`Coder`]: a writer has a [`Source`] that knows what is to come, a reader has none. So the two
//! cannot disagree, as long as models look only at what has been coded.

use super::super::entropy::{Coder, Part};
use super::connectivity::{ConnectivityModel, Scene};
use super::growth::Growth;
use super::hood::Hood;
use super::positions::PositionModel;
use super::surface::{Cut, Surface, next, triangle_of};
use super::walk::Walk;
use super::{Effort, StreamDefect};

/// Splits whose connectivity is coded before their values: what a reader has to wait for.
const STRETCH: usize = 1024;

/// What a writer knows of what is to come.
pub(super) trait Source {
    /// A batch begins.
    fn begin_batch(&mut self);
    /// How a vertex splits in this batch, if it does.
    fn cut(&self, vertex: u32) -> Option<Cut>;
    /// A vertex has been split off another one.
    fn born(&mut self, vertex: u32, kept: u32);
    /// The grid coordinates of a vertex.
    fn place(&self, vertex: u32) -> [i32; 3];
}

/// A reader's source: nothing is known.
pub(super) struct Unknown;

impl Source for Unknown {
    fn begin_batch(&mut self) {}
    fn cut(&self, _: u32) -> Option<Cut> {
        None
    }
    fn born(&mut self, _: u32, _: u32) {}
    fn place(&self, _: u32) -> [i32; 3] {
        [0; 3]
    }
}

/// How a stretch of the stream ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Ended {
    /// All that was there was coded.
    Whole,
    /// The bytes ended before: what is complete stands.
    Short,
}

/// A surface under refinement, with all models.
#[derive(Clone, Debug)]
pub(super) struct Refiner {
    surface: Surface,
    /// Grid coordinates by vertex of the surface.
    places: Vec<[i32; 3]>,
    walk: Walk,
    is_in_batch: bool,
    splits_in_batch: usize,
    max_patch: u32,
    connectivity: ConnectivityModel,
    positions: PositionModel,
    pending: Vec<Cut>,
    corners: Vec<u32>,
    pub(super) growth: Growth,
}

impl Refiner {
    /// Begins with a base; `places` has the coordinates of all its vertices, anything for virtual ones.
    pub(super) fn new(
        surface: Surface,
        places: Vec<[i32; 3]>,
        growth: Growth,
        effort: Effort,
        max_patch: u32,
    ) -> Self {
        Self {
            surface,
            places,
            walk: Walk::default(),
            is_in_batch: false,
            splits_in_batch: 0,
            max_patch,
            connectivity: ConnectivityModel::new(effort),
            positions: PositionModel::new(effort),
            pending: Vec::new(),
            corners: Vec::new(),
            growth,
        }
    }

    /// Codes up to so many splits: the rest of a batch, or a part of it.
    pub(super) fn stretch<C: Coder>(
        &mut self,
        coder: &mut C,
        source: &mut impl Source,
        most: usize,
    ) -> Result<Ended, StreamDefect> {
        if !self.is_in_batch {
            self.walk.begin(&self.surface);
            self.connectivity.begin_batch(&self.surface, self.walk.end());
            source.begin_batch();
            self.is_in_batch = true;
            self.splits_in_batch = 0;
        }
        coder.part(Part::Connectivity);
        self.connectivity(coder, source, most.min(STRETCH));
        if coder.overran() {
            return Ok(Ended::Short);
        }
        self.splits_in_batch += self.pending.len();
        if !self.is_in_batch && self.splits_in_batch == 0 {
            return Err(StreamDefect::EmptyBatch { batch: self.walk.batch() });
        }
        let first = self.surface.vertex_count() as u32;
        self.split_pending(source);
        for vertex in first..self.surface.vertex_count() as u32 {
            if self.values(coder, source, vertex) == Ended::Short {
                return Ok(Ended::Short);
            }
        }
        Ok(Ended::Whole)
    }

    /// Which vertices split and how, until there are `most` or the batch is done.
    fn connectivity<C: Coder>(&mut self, coder: &mut C, source: &impl Source, most: usize) {
        self.pending.clear();
        while self.pending.len() < most {
            let Some(vertex) = self.walk.next_vertex() else {
                self.is_in_batch = false;
                return;
            };
            self.corners.clear();
            self.corners.extend(self.surface.ring(vertex));
            let scene = Scene {
                surface: &self.surface,
                places: &self.places,
                walk: &self.walk,
                max_patch: self.max_patch,
            };
            let actual = if C::READS { None } else { source.cut(vertex) };
            let cut = self.connectivity.code(coder, &scene, &self.corners, actual);
            self.walk.settle(&self.surface, vertex, &self.corners, cut.is_some());
            if let Some(cut) = cut {
                self.take(cut);
                self.pending.push(cut);
            }
        }
    }

    /// Marks the triangles of a patch: no other split of the batch may have them.
    fn take(&mut self, cut: Cut) {
        let mut corner = cut.first;
        for _ in 0..cut.length {
            self.surface.set_mark(triangle_of(corner), self.walk.batch());
            corner = self.surface.swing(corner);
        }
    }

    fn split_pending(&mut self, source: &mut impl Source) {
        for cut in &self.pending {
            let kept = self.surface.vertex(cut.first);
            let vertex = self.surface.split(*cut);
            let made = self.surface.triangle_count() as u32;
            self.surface.set_mark(made - 2, self.walk.batch());
            self.surface.set_mark(made - 1, self.walk.batch());
            source.born(vertex, kept);
        }
    }

    /// What the new vertex is; then it is part of the mesh.
    fn values<C: Coder>(&mut self, coder: &mut C, source: &impl Source, vertex: u32) -> Ended {
        self.corners.clear();
        self.corners.extend(self.surface.ring(vertex));
        let hood = Hood {
            surface: &self.surface,
            places: &self.places,
            vertex,
            corners: &self.corners,
            batch: self.walk.batch(),
        };
        coder.part(Part::Positions);
        let actual = if C::READS { [0; 3] } else { source.place(vertex) };
        let place = self.positions.code(coder, &hood, actual);
        if coder.overran() {
            return Ended::Short;
        }
        self.places.push(place);
        let kept = self.surface.vertex(next(self.corners[0]));
        self.growth.add(&mut self.surface, &self.corners, vertex, kept);
        Ended::Whole
    }

    /// Batches begun so far.
    pub(super) fn batch(&self) -> u32 {
        self.walk.batch()
    }

    /// True where the last batch has not been asked to its end.
    pub(super) fn is_in_batch(&self) -> bool {
        self.is_in_batch
    }
}
