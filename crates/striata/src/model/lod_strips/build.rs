//! Builds the edit records in one pass from the full mesh to the base, tracking which strips use each vertex.

use super::record::{Edit, FLAG_BITS, write_record};
use super::{LodStrips, LodStripsParts, MAX_STRIP_INDICES};
use crate::mesh::{CollapseSequence, RefinableMesh};
use crate::model::ModelError;
use crate::model::record_arena::{head_bytes, in_refinement_order};
use crate::model::step_vertices::StepVertices;
use crate::model::strip_input::{check_strips, sorted_spatially};
use crate::model::superfluous::drop_superfluous;
use crate::strip::StripSet;

impl LodStrips<'static> {
    /// Builds the model from strips of the full mesh; strips longer than [`MAX_STRIP_INDICES`] are cut.
    ///
    /// # Errors
    /// [`ModelError`] if the strips do not belong to the mesh: different groups, different triangle
    /// counts, or vertices that do not exist.
    pub fn build(refinable: &RefinableMesh, strips: &StripSet) -> Result<Self, ModelError> {
        check_strips(&refinable.mesh, strips)?;
        let strips = sorted_spatially(&strips.cut(MAX_STRIP_INDICES), &refinable.mesh.positions);
        let sequence = &refinable.sequence;
        let mut builder = Builder::new(sequence, &strips);
        let mut reversed = Vec::new();
        let mut lengths = Vec::with_capacity(sequence.step_count());
        for step in (0..sequence.step_count()).rev() {
            let start = reversed.len();
            builder.write_step(step, &mut reversed);
            lengths.push(reversed.len() - start);
        }
        let (arena, record_lengths) = in_refinement_order(&reversed, &lengths);
        let parts = LodStripsParts {
            indices: strips.indices().to_vec().into(),
            offsets: strips.offsets().to_vec().into(),
            group_offsets: strips.group_offsets().to_vec().into(),
            record_lengths: record_lengths.into(),
            arena: arena.into(),
        };
        Ok(Self::unchecked(StepVertices::of_sequence(sequence).into_owned(), parts))
    }
}

struct Builder<'s> {
    sequence: &'s CollapseSequence,
    strips: &'s StripSet,
    head_bytes: usize,
    slots: Vec<u32>,
    lengths: Vec<u32>,
    /// For each vertex, the strips that use it, possibly with some that no longer do.
    strips_of: Vec<Vec<u32>>,
    edits: Vec<Edit>,
    touched: Vec<u32>,
    changed: Vec<u32>,
}

impl<'s> Builder<'s> {
    fn new(sequence: &'s CollapseSequence, strips: &'s StripSet) -> Self {
        let mut strips_of = vec![Vec::new(); sequence.positions().vertex_count()];
        for (strip, indices) in strips.strips().enumerate() {
            for &v in indices {
                let list: &mut Vec<u32> = &mut strips_of[v as usize];
                if list.last() != Some(&(strip as u32)) {
                    list.push(strip as u32);
                }
            }
        }
        Self {
            sequence,
            strips,
            head_bytes: head_bytes(strips.strip_count(), FLAG_BITS),
            slots: strips.indices().to_vec(),
            lengths: strips.strips().map(|s| s.len() as u32).collect(),
            strips_of,
            edits: Vec::new(),
            touched: Vec::new(),
            changed: Vec::new(),
        }
    }

    /// Applies a step to all strips that use its vertices, and appends the record of these edits.
    fn write_step(&mut self, step: usize, out: &mut Vec<u8>) {
        let vertices = self.sequence.step_vertices(step);
        let wedge_count = vertices.end - vertices.start;
        self.touched.clear();
        for v in vertices.clone() {
            self.touched.append(&mut self.strips_of[v as usize]);
        }
        self.touched.sort_unstable();
        self.touched.dedup();
        let touched = std::mem::take(&mut self.touched);
        let mut used = 0;
        for &strip in &touched {
            if used == self.edits.len() {
                self.edits.push(Edit::default());
            }
            used += usize::from(self.edit_strip(strip, vertices.clone(), used));
        }
        self.touched = touched;
        write_record(&self.edits[..used], wedge_count, self.head_bytes, out);
    }

    /// Replaces the vertices in one strip and drops what becomes superfluous. Returns whether the strip
    /// used any of them.
    fn edit_strip(&mut self, strip: u32, vertices: std::ops::Range<u32>, edit: usize) -> bool {
        let first = self.strips.offsets()[strip as usize] as usize;
        let length = &mut self.lengths[strip as usize];
        let slots = &mut self.slots[first..first + *length as usize];
        let edit = &mut self.edits[edit];
        edit.strip = strip;
        edit.substitutions.clear();
        edit.drops.clear();
        for (index, v) in slots.iter_mut().enumerate() {
            if vertices.contains(v) {
                edit.substitutions.push((index as u32, *v - vertices.start));
                *v = self.sequence.target(*v);
                let list = &mut self.strips_of[*v as usize];
                if list.last() != Some(&strip) {
                    list.push(strip);
                }
            }
        }
        if edit.substitutions.is_empty() {
            return false;
        }
        self.changed.clear();
        self.changed.extend(edit.substitutions.iter().map(|s| s.0));
        *length = drop_superfluous(slots, &mut self.changed, &mut edit.drops) as u32;
        true
    }
}
