//! A model whose bytes are still coming: what is there, and any level of it.
//!
//! A level of a prefix has the first vertices, and the triangles of what has come with each corner moved to where its
//! vertex has collapsed to; so it takes a walk over the triangles and nothing that would have to be built first.

use striata::codec::progressive::{StreamDecoder, StreamFacts};
use striata::mesh::Bounds;

use crate::built::Built;
use crate::shown::{Shown, Wish};
use crate::vertices::Vertices;
use crate::{Failure, limits};

/// Bytes that the decoder gets at once.
const PIECE_BYTES: usize = 1 << 16;

/// As much of a head as is kept until it is whole.
const MOST_HEAD_BYTES: usize = 1 << 24;

/// A decoder, and what its head says of the whole.
#[derive(Debug, Default)]
pub(crate) struct Streaming {
    decoder: StreamDecoder,
    facts: Option<StreamFacts>,
    /// The first bytes, until they hold the head.
    head: Vec<u8>,
    bounds: Option<Bounds>,
    /// Vertices that the bounds hold.
    bounded_count: usize,
}

impl Streaming {
    /// # Errors
    /// Where the bytes are no sound stream, or the whole would not fit into a page; what came before stays.
    pub(crate) fn push(&mut self, bytes: &[u8]) -> Result<(), Failure> {
        if self.facts.is_none() {
            return self.push_head(bytes);
        }
        let result = bytes.chunks(PIECE_BYTES).try_for_each(|piece| self.decoder.push(piece).map(drop));
        self.grow_bounds();
        Ok(result?)
    }

    /// Keeps bytes back until the head says what the whole is: nothing is decoded of what would not fit.
    fn push_head(&mut self, bytes: &[u8]) -> Result<(), Failure> {
        self.head.extend_from_slice(bytes);
        let Some(facts) = StreamFacts::read(&self.head)? else {
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
        result.map(drop).map_err(|error| Failure::from(error).with_hint("the stream is cut off very early"))
    }

    /// Builds what views are taken from, of what has come.
    ///
    /// # Errors
    /// Where that is no mesh yet.
    pub(crate) fn into_built(self) -> Result<Built, Failure> {
        let decoder = self.decoder;
        let Some(refinable) = decoder.refinable_mesh() else {
            return Err(Failure::corrupt("what has come of the stream is no mesh yet"));
        };
        let rest_error = decoder.error_at(decoder.split_count()).unwrap_or(0.0);
        // Its memory is free before the table takes its own.
        drop(decoder);
        Ok(Built::new(refinable, rest_error))
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

    pub(crate) fn facts(&self) -> Option<&StreamFacts> {
        self.facts.as_ref()
    }

    pub(crate) fn bounds(&self) -> Option<Bounds> {
        self.bounds
    }

    pub(crate) fn group_count(&self) -> usize {
        self.facts.as_ref().map_or(1, |facts| facts.group_count.max(1))
    }

    pub(crate) fn vertices(&self, first: usize) -> Vertices {
        let positions = self.decoder.positions();
        let first = first.min(positions.len());
        Vertices::new(&positions[first..], &self.decoder.layers_of(first..positions.len()), 0)
    }

    /// The level that a wish means, as far as it has come.
    pub(crate) fn show(&self, wish: Wish) -> Shown {
        let split_count = self.split_count_for(wish);
        let mut triangles = Vec::new();
        let mut groups = Vec::new();
        let all = self.decoder.triangle_groups();
        for (t, corners) in self.triangles_at(split_count) {
            triangles.push(corners);
            groups.extend(all.get(t));
        }
        let group_counts = order_by_group(&mut triangles, &groups, self.group_count());
        let error = self.decoder.error_at(split_count).unwrap_or(0.0);
        Shown { triangles, group_counts, split_count, error }
    }

    /// Triangles of a level with the number of the triangle of all that each is.
    fn triangles_at(&self, split_count: usize) -> impl Iterator<Item = (usize, [u32; 3])> + '_ {
        let (firsts, targets) = (self.decoder.first_vertices(), self.decoder.targets());
        let base_position_count = firsts.len().saturating_sub(1 + self.decoder.split_count());
        let vertex_count = firsts.get(base_position_count + split_count).copied().unwrap_or(0);
        let base_vertex_count = firsts.get(base_position_count).copied().unwrap_or(0);
        let shown = move |mut vertex: u32| {
            while vertex >= vertex_count {
                vertex = targets[(vertex - base_vertex_count) as usize];
            }
            vertex
        };
        let is_all = split_count == self.decoder.split_count();
        let triangles = self.decoder.triangles().iter().enumerate();
        let moved =
            triangles.map(move |(t, &corners)| (t, if is_all { corners } else { corners.map(shown) }));
        moved.filter(move |&(_, [a, b, c])| is_all || (a != b && b != c && c != a))
    }

    fn split_count_for(&self, wish: Wish) -> usize {
        let there = self.decoder.split_count();
        match wish {
            Wish::Detail(detail) => {
                let step_count = self.decoder.step_count().unwrap_or(0);
                let exact = detail.clamp(0.0, 1.0) * step_count as f64;
                // The small term keeps `k / step_count` from rounding down to k - 1.
                ((exact + 1e-9 * exact.max(1.0)) as usize).min(there)
            }
            Wish::Triangles(most) => {
                let added = self.decoder.added_triangle_counts();
                let mut count = self.decoder.triangles().len();
                let mut split_count = there;
                while count > most && split_count > 0 {
                    split_count -= 1;
                    count -= usize::from(added[split_count]);
                }
                split_count
            }
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

/// Puts triangles group after group, where their groups are told; counts those of each.
fn order_by_group(triangles: &mut Vec<[u32; 3]>, groups: &[u32], group_count: usize) -> Vec<u32> {
    if groups.len() != triangles.len() || group_count < 2 {
        return vec![triangles.len() as u32];
    }
    let mut counts = vec![0u32; group_count];
    groups.iter().for_each(|&group| counts[group as usize] += 1);
    let mut next = Vec::with_capacity(group_count);
    let mut first = 0;
    for &count in &counts {
        next.push(first as usize);
        first += count;
    }
    let mut ordered = vec![[0; 3]; triangles.len()];
    for (&corners, &group) in triangles.iter().zip(groups) {
        let place = &mut next[group as usize];
        ordered[*place] = corners;
        *place += 1;
    }
    *triangles = ordered;
    counts
}
