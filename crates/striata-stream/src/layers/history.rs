//! What is known of earlier vertices besides their values: which copied others, and how far the rest was from predictions.
//!
//! Flat parts, hard edges and seams repeat values exactly: vertices of one position that differ in texture coordinates
//! often share a normal, and so do all corners of a flat part. Whether a vertex copies another one is asked first, in the
//! context of how many vertices around it did. If none did, the answer costs next to nothing.

use crate::entropy::{AdaptiveBit, Coder, Rate};
use crate::layers::hood::{KINDS, LayerHood, LayerValues};
use crate::layers::residuals::{SCALES, scale_of};

/// Vertices around that are looked at.
const MOST_AROUND: usize = 8;
/// Distinct values that can be copied.
const MOST_SOURCES: usize = 6;
/// Vertices of the same position whose values can be copied.
const MOST_SIBLINGS: u32 = 3;

/// Classes of how many of the vertices around are copies.
const SHARES: usize = 5;
/// Ways in which the vertex before it at the same position resembles a vertex.
const RESEMBLANCES: usize = 4;
/// Kinds of vertices that are copied.
const SOURCES: usize = 6;
/// Classes of how many distinct values are around: not counted, one, two, more.
const VARIETIES: usize = 4;

/// The kind of a vertex of the ring; those above it are had by several.
const RING: usize = 2;

/// A value that can be copied.
#[derive(Clone, Copy, Debug)]
struct CopySource {
    vertex: u32,
    /// Who has it, below [`SOURCES`].
    kind: usize,
}

/// The history of one layer.
#[derive(Clone, Debug)]
pub(crate) struct LayerHistory {
    /// For each vertex 0 if it is a copy, or one more than the scale of what its prediction was off.
    sizes: Vec<u8>,
    is_copy: Vec<AdaptiveBit>,
    is_source: [AdaptiveBit; 2 * SOURCES],
    sources: Vec<CopySource>,
}

impl LayerHistory {
    /// No vertices.
    pub(crate) fn new() -> Self {
        let bit = AdaptiveBit::new(Rate::Steady);
        Self {
            sizes: Vec::new(),
            is_copy: vec![bit; KINDS * SHARES * RESEMBLANCES * VARIETIES],
            is_source: [bit; 2 * SOURCES],
            sources: Vec::new(),
        }
    }

    /// Codes whether the next vertex is a copy, and of which vertex.
    pub(crate) fn copied<C: Coder>(
        &mut self,
        coder: &mut C,
        values: &LayerValues,
        hood: &LayerHood<'_>,
        meant: Option<&[i32]>,
    ) -> Option<u32> {
        let share = self.share(hood);
        // Counting pays where copies are common.
        let counts = share > 1;
        if counts || !C::READS {
            self.find_sources(values, hood);
        }
        let is_meant = |source: &CopySource| meant.is_some_and(|m| m == values.of(source.vertex));
        let place = if C::READS { None } else { self.sources.iter().position(is_meant) };
        let variety = if counts { self.variety() } else { 0 };
        let context = (hood.kind() * SHARES + share) * RESEMBLANCES + resemblance(values, hood);
        let context = context * VARIETIES + variety;
        if !self.is_copy[context].code(coder, place.is_some()) {
            return None;
        }
        if C::READS && !counts {
            self.find_sources(values, hood);
        }
        let (last, others) = self.sources.split_last()?;
        for (at, source) in others.iter().enumerate() {
            let bit = &mut self.is_source[2 * source.kind + usize::from(at > 0)];
            if bit.code(coder, place == Some(at)) {
                return Some(source.vertex);
            }
        }
        Some(last.vertex)
    }

    /// The distinct values around: those of the same position, latest first, then those of the ring and of the target.
    fn find_sources(&mut self, values: &LayerValues, hood: &LayerHood<'_>) {
        self.sources.clear();
        let next = values.vertex_count() as u32;
        for back in 1..=hood.sibling_count.min(MOST_SIBLINGS) {
            self.add_source(values, next - back, if back == 1 { 0 } else { 1 });
        }
        for &vertex in hood.ring.iter().take(MOST_AROUND) {
            self.add_source(values, vertex, RING);
        }
        if let Some(target) = hood.target {
            self.add_source(values, target, SOURCES - 1);
        }
    }

    /// Adds a value, or notes that a vertex of the ring has it as well.
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

    /// How many distinct values the ring and the target have.
    fn variety(&self) -> usize {
        self.sources.iter().filter(|source| source.kind >= RING).count().min(VARIETIES - 1)
    }

    /// Which share of the vertices around are copies.
    fn share(&self, hood: &LayerHood<'_>) -> usize {
        let around = hood.target.iter().chain(hood.ring.iter().take(MOST_AROUND));
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

    /// The mean scale of what predictions of the vertices around were off; the largest if there are none.
    pub(crate) fn scale_around(&self, hood: &LayerHood<'_>) -> usize {
        let around = hood.target.iter().chain(hood.ring.iter().take(MOST_AROUND));
        let (mut count, mut sum) = (0usize, 0);
        for &vertex in around {
            count += 1;
            sum += usize::from(self.sizes[vertex as usize]).saturating_sub(1);
        }
        usize::checked_div(sum, count).map_or(SCALES - 1, |mean| mean.min(SCALES - 1))
    }

    /// The next vertex is a copy.
    pub(crate) fn note_copy(&mut self) {
        self.sizes.push(0);
    }

    /// The prediction of the next vertex was off by this.
    pub(crate) fn note(&mut self, off: u64) {
        self.sizes.push(1 + scale_of(16 * off) as u8);
    }

    /// Forgets all but the first vertices.
    pub(crate) fn truncate(&mut self, vertex_count: usize) {
        self.sizes.truncate(vertex_count);
    }
}

/// How the targets of a vertex and of the one before it at the same position resemble each other: 0 if there is none before.
fn resemblance(values: &LayerValues, hood: &LayerHood<'_>) -> usize {
    match (hood.target, hood.sibling_target) {
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

    /// Vertices in a row; every second has the value of the one before it, or of the one before that.
    fn code<C: Coder>(coder: &mut C, meant: &[i32]) -> Vec<Option<u32>> {
        let mut history = LayerHistory::new();
        let mut values = LayerValues::new(1);
        let fit = RingFit::default();
        let mut copied = Vec::new();
        for (vertex, value) in meant.iter().enumerate() {
            let ring: Vec<u32> = (vertex.saturating_sub(2) as u32..vertex as u32).collect();
            let hood = LayerHood::new(ring.last().copied(), &ring, &fit);
            let known = (!C::READS).then_some(std::slice::from_ref(value));
            let from = history.copied(coder, &values, &hood, known);
            match from {
                Some(_) => history.note_copy(),
                None => history.note(4),
            }
            values.push(&[*value]);
            copied.push(from);
        }
        copied
    }

    #[test]
    fn copies_are_found_again_by_a_reader() {
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
    fn where_nothing_repeats_asking_costs_next_to_nothing() {
        let values: Vec<i32> = (0..4000).collect();
        let mut writer = RangeWriter::new();
        assert!(code(&mut writer, &values).iter().all(Option::is_none));
        let bytes = writer.finish().0.len();
        assert!(bytes < 12, "{bytes} bytes for 4000 answers");
    }
}
