//! Fills the structures as figure 4 of \[RCRG06\] shows: collapse a vertex, remove repetitions, note both.

use striata::mesh::RefinableMesh;
use striata::model::{ModelError, StepVertices, check_strips};
use striata::strip::StripSet;

use super::resizes::{Winding, has_triangle};
use super::{EfficientLodStrips, RecordChange, VertexChange};

impl EfficientLodStrips {
    /// Builds the model from strips of the full mesh, which are used unchanged.
    ///
    /// # Errors
    /// [`ModelError`] if the strips do not match the mesh (other groups, other triangle counts, vertices
    /// out of range), or if there are more than 2^32 positions in all changes.
    pub fn build(refinable: &RefinableMesh, strips: &StripSet, winding: Winding) -> Result<Self, ModelError> {
        check_strips(&refinable.mesh, strips)?;
        let vertices = StepVertices::of_sequence(&refinable.sequence).into_owned();
        let base = 0..vertices.base_vertex_count();
        let above = vertices.base_vertex_count()..vertices.vertex_count() as u32;
        let collapses = base.chain(above.clone().map(|v| vertices.target(v))).collect();
        let mut shown = CollapsingStrips::new(strips, vertices.vertex_count());
        let mut changes: Vec<Vec<StripChange>> = Vec::new();
        for vertex in above.rev() {
            changes.push(shown.collapse(vertex, vertices.target(vertex), winding));
        }
        changes.reverse();
        let mut model = Self {
            vertices: vertices.without_targets(),
            collapses,
            strips: strips.clone(),
            winding,
            changes: Vec::with_capacity(changes.len()),
            records: Vec::new(),
            data: Vec::new(),
        };
        changes.iter().try_for_each(|change| model.push(change))?;
        Ok(model)
    }

    /// Appends the change of the next vertex.
    fn push(&mut self, change: &[StripChange]) -> Result<(), ModelError> {
        let first_record = self.records.len() as u32;
        for StripChange { strip, collapses, resizes } in change {
            self.records.push(RecordChange {
                strip: *strip,
                collapse_count: collapses.len() as u32,
                resize_count: resizes.len() as u32,
                data: self.data.len() as u32,
            });
            self.data.extend(collapses.iter().chain(resizes));
        }
        self.changes.push(VertexChange { record_count: change.len() as u32, first_record });
        let (found, limit) = (self.data.len() as u64, u64::from(u32::MAX));
        if found > limit {
            return Err(ModelError::TooMany { what: "positions of changes", found, limit });
        }
        Ok(())
    }
}

/// Positions in one strip at which a change replaces vertices and removes repetitions.
#[derive(Debug)]
struct StripChange {
    strip: u32,
    collapses: Vec<u32>,
    resizes: Vec<u32>,
}

/// The strips while their vertices collapse.
struct CollapsingStrips {
    strips: Vec<Vec<u32>>,
    /// For each vertex, the strips that contain it, possibly with some that no longer do.
    strips_of: Vec<Vec<u32>>,
}

impl CollapsingStrips {
    fn new(strips: &StripSet, vertex_count: usize) -> Self {
        let mut strips_of: Vec<Vec<u32>> = vec![Vec::new(); vertex_count];
        for (strip, indices) in strips.strips().enumerate() {
            for &vertex in indices {
                note(&mut strips_of[vertex as usize], strip as u32);
            }
        }
        Self { strips: strips.strips().map(<[u32]>::to_vec).collect(), strips_of }
    }

    fn collapse(&mut self, vertex: u32, target: u32, winding: Winding) -> Vec<StripChange> {
        let mut affected = std::mem::take(&mut self.strips_of[vertex as usize]);
        affected.sort_unstable();
        affected.dedup();
        let mut changes = Vec::new();
        for strip in affected {
            let indices = &mut self.strips[strip as usize];
            if !has_triangle(indices) {
                continue;
            }
            let collapses: Vec<u32> =
                (0..).zip(&*indices).filter(|&(_, &v)| v == vertex).map(|(index, _)| index).collect();
            if collapses.is_empty() {
                continue;
            }
            for &index in &collapses {
                indices[index as usize] = target;
            }
            note(&mut self.strips_of[target as usize], strip);
            let mut resizes = Vec::new();
            let mut from = collapses[0].saturating_sub(3) as usize;
            while let Some(position) = winding.remove(indices, from) {
                resizes.push(position as u32);
                // The joined indices may repeat those before them.
                from = position.saturating_sub(5).min(from);
            }
            changes.push(StripChange { strip, collapses, resizes });
        }
        changes
    }
}

/// Adds a strip to the list of a vertex, if it is not the last one there.
fn note(strips: &mut Vec<u32>, strip: u32) {
    if strips.last() != Some(&strip) {
        strips.push(strip);
    }
}
