//! A model that is decoded from a stream: shows any level and view of what has arrived.
//!
//! A uniform level needs no model: it uses the first vertices, and the first triangles with each corner
//! replaced by the vertex it has collapsed to. Views use a hierarchy that grows with the stream. Both show
//! only what has been revealed: more may have been decoded, but requests are answered without new vertices
//! and normals.

use striata::mesh::Bounds;
use striata_stream::{GrowingHierarchy, HierarchyCut, StreamDecoder, StreamInfo};

use crate::shown_level::{LevelRequest, ShownLevel};
use crate::vertices::Vertices;
use crate::view::View;
use crate::{Failure, limits, normals};

/// Number of bytes passed to the decoder per call.
const CHUNK_BYTES: usize = 1 << 16;

/// Maximum size of a stream's header, which is buffered until it is complete.
const MAX_HEAD_BYTES: usize = 1 << 24;

/// A stream decoder, the facts from the stream's header, and the hierarchy for views.
#[derive(Debug, Default)]
pub(crate) struct StreamedModel {
    decoder: StreamDecoder,
    facts: Option<StreamInfo>,
    /// Bytes received so far, until the header is complete.
    head: Vec<u8>,
    bounds: Option<Bounds>,
    /// Number of vertices included in the bounds.
    bounded_count: usize,
    hierarchy: GrowingHierarchy,
    /// Triangles that have changed since the hierarchy last grew, with duplicates.
    changed: Vec<u32>,
    cut: HierarchyCut,
    revealed: Revealed,
}

/// The part of the stream that levels and views may show.
#[derive(Clone, Copy, Debug, Default)]
struct Revealed {
    step_count: usize,
    vertex_count: usize,
    triangle_count: usize,
}

impl StreamedModel {
    /// Appends bytes of the stream and decodes all complete chunks.
    ///
    /// # Errors
    /// If the bytes are not a valid stream, or the model is too large for a page. The part decoded before
    /// stays.
    pub(crate) fn push(&mut self, bytes: &[u8]) -> Result<(), Failure> {
        if self.facts.is_none() {
            return self.push_head(bytes);
        }
        let result = bytes.chunks(CHUNK_BYTES).try_for_each(|chunk| {
            let update = self.decoder.push(chunk)?;
            self.changed.extend(update.changed_triangles);
            Ok::<(), Failure>(())
        });
        if result.is_err() {
            // A failed push keeps what it decoded before the damage, but does not report which triangles
            // that changed.
            self.hierarchy = GrowingHierarchy::new();
        }
        self.grow_bounds();
        result
    }

    /// Buffers bytes until the header states the final size: nothing is decoded of a stream that is too
    /// large.
    fn push_head(&mut self, bytes: &[u8]) -> Result<(), Failure> {
        self.head.extend_from_slice(bytes);
        let Some(facts) = StreamInfo::read(&self.head)? else {
            if self.head.len() > MAX_HEAD_BYTES {
                return Err(Failure::too_large("the header of the stream is too long"));
            }
            return Ok(());
        };
        limits::check_stream(&facts)?;
        self.facts = Some(facts);
        let bytes = std::mem::take(&mut self.head);
        self.push(&bytes)
    }

    /// Ends the stream: decodes what an incomplete last chunk contains.
    ///
    /// # Errors
    /// If the base mesh is incomplete.
    pub(crate) fn finish(&mut self) -> Result<(), Failure> {
        if self.decoder.is_complete() {
            return Ok(());
        }
        let result = self.decoder.finish();
        self.grow_bounds();
        let update =
            result.map_err(|error| Failure::from(error).with_hint("the stream was truncated very early"))?;
        self.changed.extend(update.changed_triangles);
        Ok(())
    }

    /// Extends the hierarchy by all steps that have arrived.
    pub(crate) fn grow(&mut self) {
        self.changed.sort_unstable();
        self.changed.dedup();
        let error = |step| self.decoder.error_at(step).unwrap_or(0.0);
        self.hierarchy.grow(&self.decoder.prefix(), &self.changed, error);
        self.changed.clear();
    }

    /// Makes everything that has arrived available to levels and views.
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

    /// Number of revealed vertices.
    pub(crate) fn vertex_count(&self) -> usize {
        self.revealed.vertex_count
    }

    /// Triangle count of the finest revealed level.
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

    /// Returns the requested level, as far as it has arrived.
    pub(crate) fn show(&self, request: LevelRequest) -> ShownLevel {
        let split_count = self.split_count_for(request);
        let mut triangles = Vec::new();
        self.decoder.prefix().triangles_at_into(split_count, &mut triangles);
        self.shown(&triangles, split_count, split_count)
    }

    /// Refines what has been revealed for a camera.
    ///
    /// # Errors
    /// If such a camera sees nothing.
    pub(crate) fn show_view(&mut self, view: &View) -> Result<ShownLevel, Failure> {
        let criterion = view.criterion()?;
        let mesh = self.decoder.prefix();
        let limit = if view.triangle_limit == 0 { usize::MAX } else { view.triangle_limit as usize };
        self.cut.refine(&self.hierarchy, &criterion, limit);
        let mut triangles = Vec::new();
        self.cut.triangles_into(&self.hierarchy, &mesh, &mut triangles);
        let coarsest = self.cut.first_coarse_step(&self.hierarchy);
        Ok(self.shown(&triangles, self.cut.split_count(), coarsest))
    }

    /// Sorts triangles by group; the error is that of the level that lacks the step `coarsest`.
    fn shown(&self, numbered: &[(u32, [u32; 3])], split_count: usize, coarsest: usize) -> ShownLevel {
        let (triangles, group_counts) =
            by_group(numbered, self.decoder.triangle_groups(), self.group_count());
        let error = self.decoder.error_at(coarsest).unwrap_or(0.0);
        ShownLevel { triangles, group_counts, split_count, error }
    }

    fn split_count_for(&self, request: LevelRequest) -> usize {
        let available = self.revealed.step_count;
        match request {
            LevelRequest::Detail(detail) => {
                let step_count = self.decoder.step_count().unwrap_or(0);
                let exact = detail.clamp(0.0, 1.0) * step_count as f64;
                // The small term keeps `k / step_count` from rounding down to k - 1.
                ((exact + 1e-9 * exact.max(1.0)) as usize).min(available)
            }
            LevelRequest::Triangles(limit) => {
                self.decoder.prefix().split_count_for_triangles(limit).min(available)
            }
            LevelRequest::Error(limit) => {
                let is_farther = |s: usize| self.decoder.error_at(s).is_some_and(|e| f64::from(e) > limit);
                // Errors never rise with the split count, so a binary search finds the first small enough
                // one.
                let (mut low, mut high) = (0, available);
                while low < high {
                    let middle = low.midpoint(high);
                    if is_farther(middle) { low = middle + 1 } else { high = middle }
                }
                low
            }
        }
    }
}

/// Sorts triangles with their indices by group and counts each group's.
fn by_group(numbered: &[(u32, [u32; 3])], groups: &[u32], group_count: usize) -> (Vec<[u32; 3]>, Vec<u32>) {
    if groups.is_empty() || group_count < 2 {
        return (numbered.iter().map(|&(_, corners)| corners).collect(), vec![numbered.len() as u32]);
    }
    let group_of = |triangle: u32| groups[triangle as usize] as usize;
    let mut counts = vec![0u32; group_count];
    numbered.iter().for_each(|&(triangle, _)| counts[group_of(triangle)] += 1);
    let mut next = Vec::with_capacity(group_count);
    let mut first = 0;
    for &count in &counts {
        next.push(first as usize);
        first += count;
    }
    let mut ordered = vec![[0; 3]; numbered.len()];
    for &(triangle, corners) in numbered {
        let slot = &mut next[group_of(triangle)];
        ordered[*slot] = corners;
        *slot += 1;
    }
    (ordered, counts)
}
