//! A model that is read from a stream: what has arrived, any level of it, and any view.
//!
//! A level has the first vertices, and the first triangles with each corner moved to where its vertex has collapsed to, so it
//! needs no model. Views are taken from a hierarchy that grows with the stream. Both show only what has been revealed: more is decoded
//! meanwhile, but requests are answered without new vertices and normals.

use striata::mesh::Bounds;
use striata_stream::{GrowingHierarchy, HierarchyCut, StreamDecoder, StreamInfo};

use crate::camera::View;
use crate::shown::{Shown, Wish};
use crate::vertices::Vertices;
use crate::{Failure, limits, normals};

/// Bytes that the decoder gets at once.
const PIECE_BYTES: usize = 1 << 16;

/// As much of a head as is kept until it is whole.
const MOST_HEAD_BYTES: usize = 1 << 24;

/// A decoder, and what its head says of the whole.
#[derive(Debug, Default)]
pub(crate) struct Streaming {
    decoder: StreamDecoder,
    facts: Option<StreamInfo>,
    /// The first bytes, until they hold the head.
    head: Vec<u8>,
    bounds: Option<Bounds>,
    /// Vertices that the bounds hold.
    bounded_count: usize,
    hierarchy: GrowingHierarchy,
    /// Triangles that have changed since the hierarchy last grew, with repetitions.
    changed: Vec<u32>,
    cut: HierarchyCut,
    revealed: Revealed,
}

/// How much levels and views may show.
#[derive(Clone, Copy, Debug, Default)]
struct Revealed {
    step_count: usize,
    vertex_count: usize,
    triangle_count: usize,
}

impl Streaming {
    /// # Errors
    /// Where the bytes are no sound stream, or the whole would not fit into a page; what came before stays.
    pub(crate) fn push(&mut self, bytes: &[u8]) -> Result<(), Failure> {
        if self.facts.is_none() {
            return self.push_head(bytes);
        }
        let result = bytes.chunks(PIECE_BYTES).try_for_each(|piece| {
            let update = self.decoder.push(piece)?;
            self.changed.extend(update.changed_triangles);
            Ok::<(), Failure>(())
        });
        if result.is_err() {
            // A failed push keeps what it read before the damage, but does not report what that changed.
            self.hierarchy = GrowingHierarchy::new();
        }
        self.grow_bounds();
        result
    }

    /// Keeps bytes back until the head says what the whole is: nothing is decoded of what would not fit.
    fn push_head(&mut self, bytes: &[u8]) -> Result<(), Failure> {
        self.head.extend_from_slice(bytes);
        let Some(facts) = StreamInfo::read(&self.head)? else {
            if self.head.len() > MOST_HEAD_BYTES {
                return Err(Failure::too_large("the head of the stream is longer than a page can hold"));
            }
            return Ok(());
        };
        limits::check_stream(&facts)?;
        self.facts = Some(facts);
        let bytes = std::mem::take(&mut self.head);
        self.push(&bytes)
    }

    /// No more bytes will come: reads what those of a last, incomplete chunk tell.
    ///
    /// # Errors
    /// Where the stream ends before its base mesh does.
    pub(crate) fn finish(&mut self) -> Result<(), Failure> {
        if self.decoder.is_complete() {
            return Ok(());
        }
        let result = self.decoder.finish();
        self.grow_bounds();
        let update =
            result.map_err(|error| Failure::from(error).with_hint("the stream is cut off very early"))?;
        self.changed.extend(update.changed_triangles);
        Ok(())
    }

    /// Grows the hierarchy to all steps that have arrived.
    pub(crate) fn grow(&mut self) {
        self.changed.sort_unstable();
        self.changed.dedup();
        let error = |step| self.decoder.error_at(step).unwrap_or(0.0);
        self.hierarchy.grow(&self.decoder.prefix(), &self.changed, error);
        self.changed.clear();
    }

    /// Lets levels and views show all that has arrived.
    pub(crate) fn reveal(&mut self) {
        self.grow();
        self.revealed = Revealed {
            step_count: self.hierarchy.step_count(),
            vertex_count: self.hierarchy.vertex_count(),
            triangle_count: self.hierarchy.triangle_count(),
        };
        self.cut.limit_steps(self.revealed.step_count);
    }

    fn grow_bounds(&mut self) {
        let positions = self.decoder.positions();
        let Some(new) = Bounds::of(&positions[self.bounded_count..]) else { return };
        self.bounded_count = positions.len();
        let old = self.bounds.unwrap_or(new);
        self.bounds = Some(Bounds {
            min: [0, 1, 2].map(|i| old.min[i].min(new.min[i])),
            max: [0, 1, 2].map(|i| old.max[i].max(new.max[i])),
        });
    }

    pub(crate) fn decoder(&self) -> &StreamDecoder {
        &self.decoder
    }

    pub(crate) fn facts(&self) -> Option<&StreamInfo> {
        self.facts.as_ref()
    }

    pub(crate) fn bounds(&self) -> Option<Bounds> {
        self.bounds
    }

    pub(crate) fn group_count(&self) -> usize {
        self.facts.as_ref().map_or(1, |facts| facts.group_count.max(1))
    }

    /// Vertices that can be shown.
    pub(crate) fn vertex_count(&self) -> usize {
        self.revealed.vertex_count
    }

    /// Triangles of the finest level that can be shown.
    pub(crate) fn triangle_count(&self) -> usize {
        self.revealed.triangle_count
    }

    pub(crate) fn vertices(&self, first: usize) -> Vertices {
        let count = self.vertex_count();
        let first = first.min(count);
        Vertices::new(&self.decoder.positions()[first..count], &self.decoder.layers_of(first..count), 0)
    }

    pub(crate) fn smooth_normals(&self) -> Vec<[f32; 3]> {
        let decoder = &self.decoder;
        let mut normals =
            normals::of_vertices(decoder.positions(), decoder.triangles(), decoder.first_vertices());
        normals.truncate(self.vertex_count());
        normals
    }

    /// The level that a wish means, as far as it has come.
    pub(crate) fn show(&self, wish: Wish) -> Shown {
        let split_count = self.split_count_for(wish);
        let mut triangles = Vec::new();
        self.decoder.prefix().triangles_at_into(split_count, &mut triangles);
        self.shown(&triangles, split_count, split_count)
    }

    /// What a camera asks for, of what has been revealed.
    ///
    /// # Errors
    /// If such a camera sees nothing.
    pub(crate) fn show_view(&mut self, view: &View) -> Result<Shown, Failure> {
        let criterion = view.criterion()?;
        let mesh = self.decoder.prefix();
        let limit = if view.triangle_limit == 0 { usize::MAX } else { view.triangle_limit as usize };
        self.cut.refine(&self.hierarchy, &criterion, limit);
        let mut triangles = Vec::new();
        self.cut.triangles_into(&self.hierarchy, &mesh, &mut triangles);
        let coarsest = self.cut.first_coarse_step(&self.hierarchy);
        Ok(self.shown(&triangles, self.cut.split_count(), coarsest))
    }

    /// Triangles with their numbers, group after group; the error is that of the level that lacks the step `coarsest`.
    fn shown(&self, numbered: &[(u32, [u32; 3])], split_count: usize, coarsest: usize) -> Shown {
        let (triangles, group_counts) =
            by_group(numbered, self.decoder.triangle_groups(), self.group_count());
        let error = self.decoder.error_at(coarsest).unwrap_or(0.0);
        Shown { triangles, group_counts, split_count, error }
    }

    fn split_count_for(&self, wish: Wish) -> usize {
        let there = self.revealed.step_count;
        match wish {
            Wish::Detail(detail) => {
                let step_count = self.decoder.step_count().unwrap_or(0);
                let exact = detail.clamp(0.0, 1.0) * step_count as f64;
                // The small term keeps `k / step_count` from rounding down to k - 1.
                ((exact + 1e-9 * exact.max(1.0)) as usize).min(there)
            }
            Wish::Triangles(most) => self.decoder.prefix().split_count_for_triangles(most).min(there),
            Wish::Error(most) => {
                let is_farther = |s: usize| self.decoder.error_at(s).is_some_and(|e| f64::from(e) > most);
                // Errors never rise.
                let (mut low, mut high) = (0, there);
                while low < high {
                    let middle = low.midpoint(high);
                    if is_farther(middle) { low = middle + 1 } else { high = middle }
                }
                low
            }
        }
    }
}

/// Puts numbered triangles group after group; counts those of each group.
fn by_group(numbered: &[(u32, [u32; 3])], groups: &[u32], group_count: usize) -> (Vec<[u32; 3]>, Vec<u32>) {
    if groups.is_empty() || group_count < 2 {
        return (numbered.iter().map(|&(_, corners)| corners).collect(), vec![numbered.len() as u32]);
    }
    let group_of = |number: u32| groups[number as usize] as usize;
    let mut counts = vec![0u32; group_count];
    numbered.iter().for_each(|&(number, _)| counts[group_of(number)] += 1);
    let mut next = Vec::with_capacity(group_count);
    let mut first = 0;
    for &count in &counts {
        next.push(first as usize);
        first += count;
    }
    let mut ordered = vec![[0; 3]; numbered.len()];
    for &(number, corners) in numbered {
        let place = &mut next[group_of(number)];
        ordered[*place] = corners;
        *place += 1;
    }
    (ordered, counts)
}
