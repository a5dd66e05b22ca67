//! History of a layer: which vertices copied others, and how well the others could be predicted.
//!
//! Flat parts, hard edges and seams repeat values exactly: vertices of one position that differ in
//! texture coordinates often share a normal, and so do all vertices of a flat part. The model first codes
//! whether a vertex copies another one, in the context of how many surrounding vertices did. If none did,
//! this flag costs almost nothing.

use crate::entropy::{AdaptiveBit, Coder, Rate};
use crate::layers::layer_neighborhood::{KINDS, LayerNeighborhood, LayerValues};
use crate::layers::residuals::{SCALES, scale_of};

/// Maximum number of surrounding vertices that are examined.
const MOST_AROUND: usize = 8;
/// Maximum number of distinct values that can be copied.
const MOST_SOURCES: usize = 6;
/// Maximum number of vertices of the same position whose values can be copied.
const MOST_SIBLINGS: u32 = 3;

/// Number of classes for the share of surrounding vertices that are copies.
const SHARES: usize = 5;
/// Number of classes for how the previous vertex of the position resembles the next one.
const RESEMBLANCES: usize = 4;
/// Number of kinds of vertices that are copied.
const SOURCES: usize = 6;
/// Number of classes for how many distinct values there are: not counted, one, two, more.
const VARIETIES: usize = 4;

/// Kind of a ring vertex. The next kinds are values that two, or more, ring vertices share.
const RING: usize = 2;

/// A value that can be copied.
#[derive(Clone, Copy, Debug)]
struct CopySource {
    vertex: u32,
    /// Kind of vertex that has this value, below [`SOURCES`].
    kind: usize,
}

/// History of one layer.
#[derive(Clone, Debug)]
pub(crate) struct LayerHistory {
    /// For each vertex, 0 if it is a copy, otherwise 1 plus the scale of its residual.
    sizes: Vec<u8>,
    /// Whether a vertex is a copy.
    is_copy: Vec<AdaptiveBit>,
    /// Whether a copied value is this source, by its kind and whether it is the first one.
    is_source: [AdaptiveBit; 2 * SOURCES],
    /// Values that the current vertex can copy.
    sources: Vec<CopySource>,
}

impl LayerHistory {
    /// Creates the history of an empty layer.
    pub(crate) fn new() -> Self {
        let bit = AdaptiveBit::new(Rate::Steady);
        Self {
            sizes: Vec::new(),
            is_copy: vec![bit; KINDS * SHARES * RESEMBLANCES * VARIETIES],
            is_source: [bit; 2 * SOURCES],
            sources: Vec::new(),
        }
    }

    /// Codes whether the next vertex is a copy; if so, returns the vertex that it copies.
    pub(crate) fn code_copy<C: Coder>(
        &mut self,
        coder: &mut C,
        values: &LayerValues,
        neighborhood: &LayerNeighborhood<'_>,
        actual: Option<&[i32]>,
    ) -> Option<u32> {
        let share = self.share(neighborhood);
        // Counting is only worthwhile if copies are common.
        let counts = share > 1;
        if counts || !C::READS {
            self.find_sources(values, neighborhood);
        }
        let is_equal = |source: &CopySource| actual.is_some_and(|m| m == values.of(source.vertex));
        let index = if C::READS { None } else { self.sources.iter().position(is_equal) };
        let variety = if counts { self.variety() } else { 0 };
        let context =
            (neighborhood.kind() * SHARES + share) * RESEMBLANCES + resemblance(values, neighborhood);
        let context = context * VARIETIES + variety;
        if !self.is_copy[context].code(coder, index.is_some()) {
            return None;
        }
        if C::READS && !counts {
            self.find_sources(values, neighborhood);
        }
        let (last, others) = self.sources.split_last()?;
        for (at, source) in others.iter().enumerate() {
            let bit = &mut self.is_source[2 * source.kind + usize::from(at > 0)];
            if bit.code(coder, index == Some(at)) {
                return Some(source.vertex);
            }
        }
        Some(last.vertex)
    }

    /// Collects the distinct values around the next vertex: first those of the same position, latest
    /// first, then those of the ring and of the target.
    fn find_sources(&mut self, values: &LayerValues, neighborhood: &LayerNeighborhood<'_>) {
        self.sources.clear();
        let next = values.vertex_count() as u32;
        for back in 1..=neighborhood.sibling_count.min(MOST_SIBLINGS) {
            self.add_source(values, next - back, if back == 1 { 0 } else { 1 });
        }
        for &vertex in neighborhood.ring.iter().take(MOST_AROUND) {
            self.add_source(values, vertex, RING);
        }
        if let Some(target) = neighborhood.target {
            self.add_source(values, target, SOURCES - 1);
        }
    }

    /// Adds a value, or records that another ring vertex has it as well.
    fn add_source(&mut self, values: &LayerValues, vertex: u32, kind: usize) {
        let value = values.of(vertex);
        let is_full = self.sources.len() == MOST_SOURCES;
        match self.sources.iter_mut().find(|source| values.of(source.vertex) == value) {
            Some(source) if (RING..RING + 2).contains(&source.kind) => source.kind += 1,
            Some(_) => {}
            None if is_full => {}
            None => self.sources.push(CopySource { vertex, kind }),
        }
    }

    /// Returns the class of how many distinct values the ring and the target have.
    fn variety(&self) -> usize {
        self.sources.iter().filter(|source| source.kind >= RING).count().min(VARIETIES - 1)
    }

    /// Returns the class of the share of surrounding vertices that are copies.
    fn share(&self, neighborhood: &LayerNeighborhood<'_>) -> usize {
        let around = neighborhood.target.iter().chain(neighborhood.ring.iter().take(MOST_AROUND));
        let (mut count, mut copies) = (0, 0);
        for &vertex in around {
            count += 1;
            copies += usize::from(self.sizes[vertex as usize] == 0);
        }
        match copies {
            0 => usize::from(count > 0),
            _ if copies == count => 4,
            _ => 2 + usize::from(2 * copies >= count),
        }
    }

    /// Returns the mean residual scale of the surrounding vertices, or the largest scale if there are none.
    pub(crate) fn scale_around(&self, neighborhood: &LayerNeighborhood<'_>) -> usize {
        let around = neighborhood.target.iter().chain(neighborhood.ring.iter().take(MOST_AROUND));
        let (mut count, mut sum) = (0usize, 0);
        for &vertex in around {
            count += 1;
            sum += usize::from(self.sizes[vertex as usize]).saturating_sub(1);
        }
        usize::checked_div(sum, count).map_or(SCALES - 1, |mean| mean.min(SCALES - 1))
    }

    /// Records that the next vertex is a copy.
    pub(crate) fn record_copy(&mut self) {
        self.sizes.push(0);
    }

    /// Records the residual of the next vertex.
    pub(crate) fn record_residual(&mut self, off: u64) {
        self.sizes.push(1 + scale_of(16 * off) as u8);
    }

    /// Removes all but the first vertices.
    pub(crate) fn truncate(&mut self, vertex_count: usize) {
        self.sizes.truncate(vertex_count);
    }
}

/// Classifies how similar the targets of the next vertex and of the previous one of the same position
/// are; 0 if there is no previous one.
fn resemblance(values: &LayerValues, neighborhood: &LayerNeighborhood<'_>) -> usize {
    match (neighborhood.target, neighborhood.sibling_target) {
        (Some(target), Some(other)) if target == other => 1,
        (Some(target), Some(other)) if values.of(target) == values.of(other) => 2,
        (Some(_), Some(_)) => 3,
        _ => 0,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::entropy::{RangeReader, RangeWriter};
    use crate::layers::ring_fit::RingFit;

    /// Codes a row of vertices. Every second one has the value of the vertex before it, or of the one
    /// before that.
    fn code<C: Coder>(coder: &mut C, actual: &[i32]) -> Vec<Option<u32>> {
        let mut history = LayerHistory::new();
        let mut values = LayerValues::new(1);
        let fit = RingFit::default();
        let mut copied = Vec::new();
        for (vertex, value) in actual.iter().enumerate() {
            let ring: Vec<u32> = (vertex.saturating_sub(2) as u32..vertex as u32).collect();
            let neighborhood = LayerNeighborhood::new(ring.last().copied(), &ring, &fit);
            let known = (!C::READS).then_some(std::slice::from_ref(value));
            let from = history.code_copy(coder, &values, &neighborhood, known);
            match from {
                Some(_) => history.record_copy(),
                None => history.record_residual(4),
            }
            values.push(&[*value]);
            copied.push(from);
        }
        copied
    }

    #[test]
    fn a_reader_decodes_the_same_copies() {
        let values: Vec<i32> = (0..900).map(|i| if i % 2 == 1 { i - 1 - (i % 3) % 2 } else { i }).collect();
        let mut writer = RangeWriter::new();
        let written = code(&mut writer, &values);
        let (bytes, _) = writer.finish();
        let read = code(&mut RangeReader::new(&bytes, true), &values);
        assert_eq!(written, read);
        for (vertex, from) in written.iter().enumerate() {
            let expected = values[..vertex].iter().rev().take(2).any(|v| *v == values[vertex]);
            assert_eq!(
                from.map(|from| values[from as usize]),
                expected.then_some(values[vertex]),
                "{vertex}"
            );
        }
    }

    #[test]
    fn copy_flags_cost_almost_nothing_if_nothing_repeats() {
        let values: Vec<i32> = (0..4000).collect();
        let mut writer = RangeWriter::new();
        assert!(code(&mut writer, &values).iter().all(Option::is_none));
        let bytes = writer.finish().0.len();
        assert!(bytes < 12, "{bytes} bytes for 4000 flags");
    }
}
