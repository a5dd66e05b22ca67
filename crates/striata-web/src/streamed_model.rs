//! A model that is decoded from a stream: shows any level and view of what has arrived.
//!
//! A uniform level needs no model: it uses the first vertices, and the first triangles with each corner
//! replaced by the vertex it has collapsed to. Views use a hierarchy that grows with the stream. Both show
//! only what has been revealed: more may have been decoded, but requests are answered without new vertices
//! and normals.

use striata::Target;
use striata::mesh::{Bounds, steps_for_detail};
use striata_stream::{GrowingHierarchy, HierarchyCut, StreamDecoder, StreamInfo};

use crate::leveled::Leveled;
use crate::prefix_model::step_in;
use crate::shown_level::{ShownLevel, by_group};
use crate::stream_source::StreamSource;
use crate::vertices::Vertices;
use crate::view::View;
use crate::{Failure, coloring, limits, normals};

/// Number of bytes passed to the decoder per call.
const CHUNK_BYTES: usize = 1 << 16;

/// Maximum size of a stream's header, which is buffered until it is complete.
const MAX_HEAD_BYTES: usize = 1 << 24;

/// A stream decoder, the facts from the stream's header, and the hierarchy for views.
#[derive(Debug, Default)]
pub(crate) struct StreamedModel {
    source: StreamSource,
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
    /// Shows a mesh that something else decodes.
    pub(crate) fn of_source(source: StreamSource) -> Self {
        Self { source, ..Self::default() }
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

    fn grow_bounds(&mut self) {
        let first = self.bounded_count;
        let read = self.source.read(|decoder| {
            let positions = decoder.positions();
            Some((Bounds::of(&positions[first..])?, positions.len()))
        });
        let Some((new, count)) = read else { return };
        self.bounded_count = count;
        let old = self.bounds.unwrap_or(new);
        self.bounds = Some(Bounds {
            min: [0, 1, 2].map(|i| old.min[i].min(new.min[i])),
            max: [0, 1, 2].map(|i| old.max[i].max(new.max[i])),
        });
    }

    /// Properties of the whole stream, once its header has arrived.
    fn facts(&self) -> Option<StreamInfo> {
        self.facts.clone().or_else(|| self.source.read(|decoder| decoder.info()))
    }

    /// Sorts triangles by group; the error is that of the level that lacks the step `coarsest`.
    fn shown(&self, numbered: &[(u32, [u32; 3])], split_count: usize, coarsest: usize) -> ShownLevel {
        let group_count = self.group_count();
        let ((triangles, group_counts), error) = self.source.read(|decoder| {
            let error = decoder.error_at(coarsest).unwrap_or(0.0);
            (by_group(numbered, decoder.triangle_groups(), group_count), error)
        });
        ShownLevel { triangles, group_counts, split_count, error }
    }
}

impl Leveled for StreamedModel {
    fn push(&mut self, bytes: &[u8]) -> Result<(), Failure> {
        if self.facts.is_none() {
            return self.push_head(bytes);
        }
        let result = bytes.chunks(CHUNK_BYTES).try_for_each(|chunk| {
            let update = self.source.own()?.push(chunk)?;
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

    fn finish(&mut self) -> Result<(), Failure> {
        if self.is_complete() {
            return Ok(());
        }
        let result = self.source.own()?.finish();
        self.grow_bounds();
        let update =
            result.map_err(|error| Failure::from(error).with_hint("the stream was truncated very early"))?;
        self.changed.extend(update.changed_triangles);
        Ok(())
    }

    fn grow(&mut self) {
        if let Some(changed) = self.source.take_changed_triangles() {
            self.changed.extend(changed);
            self.grow_bounds();
        }
        self.changed.sort_unstable();
        self.changed.dedup();
        let Self { source, hierarchy, changed, .. } = self;
        source.read(|decoder| {
            let error = |step| decoder.error_at(step).unwrap_or(0.0);
            hierarchy.grow(&decoder.prefix(), changed, error);
        });
        self.changed.clear();
    }

    fn reveal(&mut self) {
        self.grow();
        self.revealed = Revealed {
            step_count: self.hierarchy.step_count(),
            vertex_count: self.hierarchy.vertex_count(),
            triangle_count: self.hierarchy.triangle_count(),
        };
        self.cut.limit_steps(self.revealed.step_count);
    }

    fn is_complete(&self) -> bool {
        self.source.read(|decoder| decoder.is_complete())
    }

    fn vertex_count(&self) -> usize {
        self.revealed.vertex_count
    }

    fn triangle_count(&self) -> usize {
        self.revealed.triangle_count
    }

    fn step_count(&self) -> usize {
        self.source.read(|decoder| decoder.step_count()).unwrap_or(0)
    }

    fn group_count(&self) -> usize {
        self.facts().map_or(1, |facts| facts.group_count.max(1))
    }

    fn bounds(&self) -> Option<Bounds> {
        self.bounds
    }

    fn is_georeferenced(&self) -> bool {
        self.source.read(|decoder| !decoder.georeference().is_empty())
    }

    fn vertices(&self, first: usize) -> Vertices {
        let count = self.vertex_count();
        let first = first.min(count);
        self.source.read(|decoder| {
            let layers = decoder.layers_of(first..count);
            Vertices::new(&decoder.positions()[first..count], &layers, 0, decoder.color_space())
        })
    }

    fn full_counts(&self) -> (usize, usize) {
        self.facts().map_or((0, 0), |facts| (facts.vertex_count, facts.triangle_count))
    }

    fn stream_bytes(&self) -> u64 {
        self.facts().map_or(0, |facts| facts.stream_bytes)
    }

    fn smooth_normals(&self) -> Vec<[f32; 3]> {
        let mut normals = self.source.read(|decoder| {
            normals::of_vertices(decoder.positions(), decoder.triangles(), decoder.first_vertices())
        });
        normals.truncate(self.vertex_count());
        normals
    }

    fn split_count_for(&self, target: Target) -> usize {
        let available = self.revealed.step_count;
        self.source.read(|decoder| split_count_for(decoder, target, available))
    }

    fn triangle_count_at(&self, split_count: usize) -> usize {
        let split_count = split_count.min(self.revealed.step_count);
        self.source.read(|decoder| decoder.prefix().triangle_count_at(split_count))
    }

    fn error_at(&self, split_count: usize) -> f32 {
        self.source.read(|decoder| decoder.error_at(split_count).unwrap_or(0.0))
    }

    fn step_of(&self, vertex: u32) -> Option<usize> {
        self.source.read(|decoder| {
            let first_vertices = decoder.first_vertices();
            step_in(first_vertices, decoder.prefix().added_triangle_counts.len(), vertex)
        })
    }

    fn show(&mut self, target: Target) -> ShownLevel {
        let split_count = self.split_count_for(target);
        let mut triangles = Vec::new();
        self.source.read(|decoder| decoder.prefix().triangles_at_into(split_count, &mut triangles));
        self.shown(&triangles, split_count, split_count)
    }

    fn show_view(&mut self, view: &View) -> Result<(ShownLevel, bool), Failure> {
        let criterion = view.criterion()?;
        let limit = if view.triangle_limit == 0 { usize::MAX } else { view.triangle_limit as usize };
        self.cut.refine(&self.hierarchy, &criterion, limit);
        let mut triangles = Vec::new();
        let (cut, hierarchy) = (&self.cut, &self.hierarchy);
        self.source.read(|decoder| cut.triangles_into(hierarchy, &decoder.prefix(), &mut triangles));
        let coarsest = self.cut.first_coarse_step(&self.hierarchy);
        Ok((self.shown(&triangles, self.cut.split_count(), coarsest), true))
    }

    fn color_fans(&mut self, shown: &mut ShownLevel) -> Vec<u32> {
        coloring::by_pivots(shown)
    }
}

/// Number of vertex splits of the level that a request selects among those that are available.
fn split_count_for(decoder: &StreamDecoder, target: Target, available: usize) -> usize {
    match target {
        Target::Detail(detail) => steps_for_detail(detail, decoder.step_count().unwrap_or(0)).min(available),
        Target::Triangles(limit) => decoder.prefix().split_count_for_triangles(limit).min(available),
        Target::Error(limit) => {
            let is_farther = |s: usize| decoder.error_at(s).is_some_and(|e| f64::from(e) > limit);
            // Errors never rise with the split count, so a binary search finds the first small enough one.
            let (mut low, mut high) = (0, available);
            while low < high {
                let middle = low.midpoint(high);
                if is_farther(middle) { low = middle + 1 } else { high = middle }
            }
            low
        }
        // Pages ask for no others.
        _ => available,
    }
}
