//! Builds the model: first the nodes of each strip, then for each step the strips that it changes.

use striata::mesh::RefinableMesh;
use striata::model::{ModelError, StepVertices, check_strips};
use striata::strip::StripSet;

use super::node_builder::{NodeArrays, NodeBuilder};
use super::{SkipStrip, SkipStrips};

impl SkipStrips {
    /// Builds the model from strips of the full mesh, which are used unchanged.
    ///
    /// # Errors
    /// [`ModelError`] if the strips do not match the mesh (other groups, other triangle counts, vertices
    /// out of range), or if all nodes together number more than 2^32.
    pub fn build(refinable: &RefinableMesh, strips: &StripSet) -> Result<Self, ModelError> {
        check_strips(&refinable.mesh, strips)?;
        let sequence = &refinable.sequence;
        let mut builder = NodeBuilder::new(sequence);
        let mut arrays = NodeArrays::default();
        let mut entries = Vec::with_capacity(strips.strip_count() + 1);
        let mut affected = AffectedStrips::default();
        for (strip, indices) in strips.strips().enumerate() {
            entries.push(builder.build(indices, &mut arrays));
            affected.add(strip as u32, &builder.steps);
            check_node_count(arrays.node_vertices.len())?;
        }
        entries.push(SkipStrip {
            first_slot: arrays.slots.len() as u32,
            first_node: arrays.node_vertices.len() as u32,
            drawn_from: 0,
        });
        let (step_offsets, affected_strips) = affected.by_step(sequence.step_count());
        let mut model = Self {
            // Climbing follows the nodes of strips, so targets are never read.
            vertices: StepVertices::of_sequence(sequence).without_targets(),
            strips: entries,
            group_offsets: strips.group_offsets().to_vec(),
            slots: arrays.slots,
            node_vertices: arrays.node_vertices,
            node_parents: arrays.node_parents,
            step_offsets,
            affected_strips,
        };
        model.node_vertices.shrink_to_fit();
        model.node_parents.shrink_to_fit();
        Ok(model)
    }
}

fn check_node_count(found: usize) -> Result<(), ModelError> {
    let (found, limit) = (found as u64, u64::from(u32::MAX));
    if found > limit { Err(ModelError::TooMany { what: "nodes of strips", found, limit }) } else { Ok(()) }
}

/// Pairs of a strip and a step that changes it, ordered by strip.
#[derive(Default)]
struct AffectedStrips {
    steps: Vec<u32>,
    strips: Vec<u32>,
}

impl AffectedStrips {
    fn add(&mut self, strip: u32, steps: &[u32]) {
        self.steps.extend_from_slice(steps);
        self.strips.resize(self.steps.len(), strip);
    }

    /// The strips that each step changes, and the offset of each step in them, followed by the total.
    fn by_step(&self, step_count: usize) -> (Vec<u32>, Vec<u32>) {
        let mut offsets = vec![0; step_count + 1];
        for &step in &self.steps {
            offsets[step as usize + 1] += 1;
        }
        for step in 0..step_count {
            offsets[step + 1] += offsets[step];
        }
        let mut nexts = offsets.clone();
        let mut sorted = vec![0; self.strips.len()];
        for (&step, &strip) in self.steps.iter().zip(&self.strips) {
            let next = &mut nexts[step as usize];
            sorted[*next as usize] = strip;
            *next += 1;
        }
        (offsets, sorted)
    }
}
