//! Building the changes: one pass from the full mesh to the base, with the places of each vertex at hand.
//!
//! The places of a vertex go to its target, so time is linear in what is listed.

use striata::mesh::RefinableMesh;
use striata::model::{ModelError, StepVertices, check_strips};
use striata::strip::StripSet;

use super::OriginalLodStrips;

impl OriginalLodStrips {
    /// Builds the model from strips of the full mesh, which are taken as they are.
    ///
    /// # Errors
    /// [`ModelError`] where the strips are not those of the mesh: other groups, other numbers of
    /// triangles, vertices that are not there; or where all changes together may need more than 2^32 words.
    pub fn build(refinable: &RefinableMesh, strips: &StripSet) -> Result<Self, ModelError> {
        check_strips(&refinable.mesh, strips)?;
        let vertices = StepVertices::of_sequence(&refinable.sequence).into_owned();
        let mut places_of = places_by_vertex(strips, vertices.vertex_count());
        check_size(&vertices, &places_of)?;
        let mut shown = ShownStrips::new(strips);
        let mut reversed = Vec::new();
        let mut ends = vec![0];
        for vertex in (vertices.base_vertex_count()..vertices.vertex_count() as u32).rev() {
            let mut places = std::mem::take(&mut places_of[vertex as usize]);
            // Runs of those that came together: this sort merges them.
            places.sort();
            let target = vertices.target(vertex);
            shown.write_change(&mut places, target, &mut reversed);
            ends.push(reversed.len() as u32);
            let others = &mut places_of[target as usize];
            if others.is_empty() {
                *others = places;
            } else {
                others.append(&mut places);
            }
        }
        let (changes, change_offsets) = in_vertex_order(&reversed, &ends);
        Ok(Self { vertices, strips: strips.clone(), change_offsets, changes })
    }
}

/// Where each vertex stands in the strips of the full mesh, counted through all of them.
fn places_by_vertex(strips: &StripSet, vertex_count: usize) -> Vec<Vec<u32>> {
    let mut places_of = vec![Vec::new(); vertex_count];
    for (place, &vertex) in strips.indices().iter().enumerate() {
        places_of[vertex as usize].push(place as u32);
    }
    places_of
}

/// Whether the changes fit 32-bit offsets; looked at before any of them takes memory.
fn check_size(vertices: &StepVertices<'_>, places_of: &[Vec<u32>]) -> Result<(), ModelError> {
    let mut counts: Vec<u64> = places_of.iter().map(|places| places.len() as u64).collect();
    let mut found = 0;
    for vertex in (vertices.base_vertex_count()..vertices.vertex_count() as u32).rev() {
        // At worst each place has a record of its own.
        found += 3 * counts[vertex as usize];
        counts[vertices.target(vertex) as usize] += counts[vertex as usize];
    }
    let limit = u64::from(u32::MAX);
    if found > limit { Err(ModelError::TooMany { what: "words of changes", found, limit }) } else { Ok(()) }
}

/// The strips while their vertices collapse, and how many triangles each has left.
struct ShownStrips<'s> {
    strips: &'s StripSet,
    indices: Vec<u32>,
    /// Whether the triangle that begins at a place has three corners.
    is_shown: Vec<bool>,
    shown_counts: Vec<u32>,
}

impl<'s> ShownStrips<'s> {
    fn new(strips: &'s StripSet) -> Self {
        let mut shown = Self {
            strips,
            indices: strips.indices().to_vec(),
            is_shown: vec![false; strips.indices().len()],
            shown_counts: Vec::with_capacity(strips.strip_count()),
        };
        for w in strips.offsets().windows(2) {
            let mut count = 0;
            for place in w[0] as usize..(w[1] as usize).saturating_sub(2).max(w[0] as usize) {
                shown.is_shown[place] = has_three_corners(&shown.indices[place..place + 3]);
                count += u32::from(shown.is_shown[place]);
            }
            shown.shown_counts.push(count);
        }
        shown
    }

    /// Substitutes `target` at `places`, which rise, and appends the change; places of strips that have had no triangle
    /// before are forgotten.
    fn write_change(&mut self, places: &mut Vec<u32>, target: u32, out: &mut Vec<u32>) {
        let offsets = self.strips.offsets();
        let mut kept = 0;
        let mut at = 0;
        while let Some(&first) = places.get(at) {
            let strip = offsets.partition_point(|&offset| offset <= first) - 1;
            let count = places[at..].partition_point(|&place| place < offsets[strip + 1]);
            if self.shown_counts[strip] > 0 {
                places.copy_within(at..at + count, kept);
                let here = &places[kept..kept + count];
                self.substitute(strip, here, target);
                out.extend([strip as u32, count as u32]);
                out.extend(here.iter().map(|place| place - offsets[strip]));
                kept += count;
            }
            at += count;
        }
        places.truncate(kept);
    }

    fn substitute(&mut self, strip: usize, places: &[u32], target: u32) {
        let first = self.strips.offsets()[strip] as usize;
        for place in places.iter().map(|&place| place as usize) {
            self.indices[place] = target;
            for start in place.saturating_sub(2).max(first)..=place {
                if self.is_shown[start] && !has_three_corners(&self.indices[start..start + 3]) {
                    self.is_shown[start] = false;
                    self.shown_counts[strip] -= 1;
                }
            }
        }
    }
}

fn has_three_corners(w: &[u32]) -> bool {
    w[0] != w[1] && w[1] != w[2] && w[2] != w[0]
}

/// Turns changes written from the last vertex down, with the ends of each, into those in order of vertices.
fn in_vertex_order(reversed: &[u32], ends: &[u32]) -> (Vec<u32>, Vec<u32>) {
    let mut changes = Vec::with_capacity(reversed.len());
    let mut offsets = Vec::with_capacity(ends.len());
    offsets.push(0);
    for w in ends.windows(2).rev() {
        changes.extend_from_slice(&reversed[w[0] as usize..w[1] as usize]);
        offsets.push(changes.len() as u32);
    }
    (changes, offsets)
}
