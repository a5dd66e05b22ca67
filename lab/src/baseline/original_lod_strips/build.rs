//! Builds the changes in one pass from the full mesh to the base, keeping track of the slots of each vertex.
//!
//! When a vertex collapses, its slots pass to its target, so building takes time linear in the slots listed.

use striata::mesh::RefinableMesh;
use striata::model::{ModelError, StepVertices, check_strips};
use striata::strip::StripSet;

use super::OriginalLodStrips;

impl OriginalLodStrips {
    /// Builds the model from strips of the full mesh, which are used unchanged.
    ///
    /// # Errors
    /// [`ModelError`] if the strips do not match the mesh (other groups, other triangle counts, vertices
    /// out of range), or if all changes together could need more than 2^32 words.
    pub fn build(refinable: &RefinableMesh, strips: &StripSet) -> Result<Self, ModelError> {
        check_strips(&refinable.mesh, strips)?;
        let vertices = StepVertices::of_sequence(&refinable.sequence).into_owned();
        let mut slots_of = slots_by_vertex(strips, vertices.vertex_count());
        check_size(&vertices, &slots_of)?;
        let mut shown = CountedStrips::new(strips);
        let mut reversed = Vec::new();
        let mut ends = vec![0];
        for vertex in (vertices.base_vertex_count()..vertices.vertex_count() as u32).rev() {
            let mut slots = std::mem::take(&mut slots_of[vertex as usize]);
            // The list consists of sorted runs, which a stable sort merges quickly.
            slots.sort();
            let target = vertices.target(vertex);
            shown.write_change(&mut slots, target, &mut reversed);
            ends.push(reversed.len() as u32);
            let others = &mut slots_of[target as usize];
            if others.is_empty() {
                *others = slots;
            } else {
                others.append(&mut slots);
            }
        }
        let (changes, change_offsets) = in_vertex_order(&reversed, &ends);
        Ok(Self { vertices, strips: strips.clone(), change_offsets, changes })
    }
}

/// The slots of each vertex in the strips of the full mesh, counted through all strips.
fn slots_by_vertex(strips: &StripSet, vertex_count: usize) -> Vec<Vec<u32>> {
    let mut slots_of = vec![Vec::new(); vertex_count];
    for (slot, &vertex) in strips.indices().iter().enumerate() {
        slots_of[vertex as usize].push(slot as u32);
    }
    slots_of
}

/// Checks that the changes fit 32-bit offsets, before any memory is allocated for them.
fn check_size(vertices: &StepVertices<'_>, slots_of: &[Vec<u32>]) -> Result<(), ModelError> {
    let mut counts: Vec<u64> = slots_of.iter().map(|slots| slots.len() as u64).collect();
    let mut found = 0;
    for vertex in (vertices.base_vertex_count()..vertices.vertex_count() as u32).rev() {
        // In the worst case, each slot has a separate record.
        found += 3 * counts[vertex as usize];
        counts[vertices.target(vertex) as usize] += counts[vertex as usize];
    }
    let limit = u64::from(u32::MAX);
    if found > limit { Err(ModelError::TooMany { what: "words of changes", found, limit }) } else { Ok(()) }
}

/// The strips while their vertices collapse, with the number of triangles left in each.
struct CountedStrips<'s> {
    strips: &'s StripSet,
    indices: Vec<u32>,
    /// Whether the triangle that begins at each slot has three distinct corners.
    is_shown: Vec<bool>,
    shown_counts: Vec<u32>,
}

impl<'s> CountedStrips<'s> {
    fn new(strips: &'s StripSet) -> Self {
        let mut shown = Self {
            strips,
            indices: strips.indices().to_vec(),
            is_shown: vec![false; strips.indices().len()],
            shown_counts: Vec::with_capacity(strips.strip_count()),
        };
        for w in strips.offsets().windows(2) {
            let mut count = 0;
            for slot in w[0] as usize..(w[1] as usize).saturating_sub(2).max(w[0] as usize) {
                shown.is_shown[slot] = has_three_corners(&shown.indices[slot..slot + 3]);
                count += u32::from(shown.is_shown[slot]);
            }
            shown.shown_counts.push(count);
        }
        shown
    }

    /// Writes `target` to `slots`, which are in ascending order, and appends the change. Slots of strips
    /// that no longer had any triangle are dropped.
    fn write_change(&mut self, slots: &mut Vec<u32>, target: u32, out: &mut Vec<u32>) {
        let offsets = self.strips.offsets();
        let mut kept = 0;
        let mut at = 0;
        while let Some(&first) = slots.get(at) {
            let strip = offsets.partition_point(|&offset| offset <= first) - 1;
            let count = slots[at..].partition_point(|&slot| slot < offsets[strip + 1]);
            if self.shown_counts[strip] > 0 {
                slots.copy_within(at..at + count, kept);
                let here = &slots[kept..kept + count];
                self.substitute(strip, here, target);
                out.extend([strip as u32, count as u32]);
                out.extend(here.iter().map(|slot| slot - offsets[strip]));
                kept += count;
            }
            at += count;
        }
        slots.truncate(kept);
    }

    fn substitute(&mut self, strip: usize, slots: &[u32], target: u32) {
        let first = self.strips.offsets()[strip] as usize;
        for slot in slots.iter().map(|&slot| slot as usize) {
            self.indices[slot] = target;
            for start in slot.saturating_sub(2).max(first)..=slot {
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

/// Turns changes written in descending order of vertices, with the end of each, into changes in ascending
/// order and their offsets.
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
