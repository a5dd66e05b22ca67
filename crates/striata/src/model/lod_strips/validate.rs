//! Validates a stored model once, so that later moves can trust its records.
//!
//! All records are applied once, from the full mesh to the base, to a copy of the strips. Every index and run
//! must lie within its strip, every replaced vertex must be found at its index, and none of the step's
//! vertices may be left over. A model that passes can be moved up and down without failing, and each of its
//! levels uses only vertices of that level. Takes the time of one full sweep and the memory of one instance.

use super::record::{HAS_DROPS, RecordReader};
use super::{LodStrips, ModelError};
use crate::model::StripModel;
use crate::model::record_arena::{record_at, record_before};
use crate::model::strip_run::drop_run;
use crate::strip::check_offsets;

pub(super) fn check(model: &LodStrips<'_>) -> Result<(), ModelError> {
    check_shape(model)?;
    let mut sweep = Sweep::new(model)?;
    for step in (0..model.record_lengths.len()).rev() {
        sweep.apply(step).map_err(|reason| ModelError::Record { step, reason })?;
    }
    if sweep.cursor != 0 {
        return Err(ModelError::Length { what: "record bytes left", found: sweep.cursor, expected: 0 });
    }
    Ok(())
}

fn check_shape(model: &LodStrips<'_>) -> Result<(), ModelError> {
    check_offsets("strip", &model.offsets, model.indices.len())?;
    check_offsets("group", &model.group_offsets, model.offsets.len().saturating_sub(1))?;
    model.vertices.check(model.record_lengths.len())
}

struct Sweep<'m, 'a> {
    model: &'m LodStrips<'a>,
    slots: Vec<u32>,
    lengths: Vec<u32>,
    /// Number of live indices that refer to each vertex.
    uses: Vec<u32>,
    cursor: usize,
}

impl<'m, 'a> Sweep<'m, 'a> {
    fn new(model: &'m LodStrips<'a>) -> Result<Self, ModelError> {
        let vertex_count = model.vertices.vertex_count;
        let mut uses = vec![0; vertex_count];
        for strip in 0..model.strip_count() {
            for &vertex in &model.indices[model.offsets[strip] as usize..model.offsets[strip + 1] as usize] {
                let Some(count) = uses.get_mut(vertex as usize) else {
                    return Err(ModelError::Vertex { strip, vertex, vertex_count });
                };
                *count += 1;
            }
        }
        let lengths = model.offsets.windows(2).map(|w| w[1] - w[0]).collect();
        Ok(Self { model, slots: model.indices.to_vec(), lengths, uses, cursor: model.arena.len() })
    }

    fn apply(&mut self, step: usize) -> Result<(), &'static str> {
        const TRUNCATED: &str = "ends too early";
        let model = self.model;
        let (body, start) =
            record_before(&model.arena, self.cursor, model.record_lengths[step]).ok_or(TRUNCATED)?;
        // A long record stores its length at both ends; the two must agree.
        let forward = record_at(&model.arena, start, model.record_lengths[step]);
        if forward != Some((body, self.cursor)) {
            return Err("has different lengths at its ends");
        }
        self.cursor = start;
        let vertices = model.vertices.of_step(step);
        let mut reader = RecordReader::new(body);
        let mut last = None;
        while !reader.is_empty() {
            let (strip, flags) = reader.head(last, model.head_bytes).ok_or(TRUNCATED)?;
            last = Some(strip);
            if strip as usize >= model.strip_count() {
                return Err("edits a strip that does not exist");
            }
            let first_index = self.substitute(strip as usize, flags, vertices.clone(), &mut reader)?;
            if flags & HAS_DROPS != 0 {
                self.drop_runs(strip as usize, first_index, &mut reader)?;
            }
        }
        if vertices.into_iter().any(|v| self.uses[v as usize] != 0) {
            return Err("leaves a vertex of the step in a strip");
        }
        Ok(())
    }

    fn live(&mut self, strip: usize) -> &mut [u32] {
        let first = self.model.offsets[strip] as usize;
        &mut self.slots[first..first + self.lengths[strip] as usize]
    }

    fn substitute(
        &mut self,
        strip: usize,
        flags: u32,
        vertices: std::ops::Range<u32>,
        reader: &mut RecordReader<'_>,
    ) -> Result<u32, &'static str> {
        const TRUNCATED: &str = "ends too early";
        let further = reader.further_substitution_count(flags).ok_or(TRUNCATED)?;
        let wedge_count = vertices.end - vertices.start;
        let mut first_index = None;
        let mut from = 0;
        for _ in 0..u64::from(further) + 1 {
            let (index, wedge) = reader.substitution(from, wedge_count).ok_or(TRUNCATED)?;
            let vertex = vertices.start + wedge;
            let target = self.model.vertices.target(vertex);
            match self.live(strip).get_mut(index as usize) {
                Some(v) if *v == vertex => *v = target,
                Some(_) => return Err("replaces a vertex at an index that holds a different one"),
                None => return Err("replaces a vertex beyond the end of a strip"),
            }
            self.uses[vertex as usize] -= 1;
            self.uses[target as usize] += 1;
            first_index.get_or_insert(index);
            from = index + 1;
        }
        first_index.ok_or(TRUNCATED)
    }

    fn drop_runs(
        &mut self,
        strip: usize,
        mut anchor: u32,
        reader: &mut RecordReader<'_>,
    ) -> Result<(), &'static str> {
        loop {
            let (run, follows) = reader.run(anchor).ok_or("ends too early")?;
            let length = self.lengths[strip];
            if run.count == 0 || run.first.checked_add(run.count).is_none_or(|end| end > length) {
                return Err("drops a run beyond the end of a strip");
            }
            let first = self.model.offsets[strip] as usize + run.first as usize;
            for &v in &self.slots[first..first + run.count as usize] {
                self.uses[v as usize] -= 1;
            }
            drop_run(self.live(strip), run);
            self.lengths[strip] = length - run.count;
            anchor = run.first;
            if !follows {
                return Ok(());
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::shapes;
    use crate::model::lod_strips::LodStripsParts;
    use crate::simplify::{SequenceOptions, build_sequence};
    use crate::strip::stripify;

    #[test]
    fn a_step_must_remove_its_vertices_from_every_strip() {
        let mesh = shapes::grid(8, 8);
        let built = build_sequence(&mesh, &SequenceOptions::default()).unwrap();
        let strips = stripify(&built.refinable.mesh).unwrap();
        let model = LodStrips::build(&built.refinable, &strips).unwrap();
        for step in 0..model.record_lengths.len() {
            let LodStrips { vertices, indices, offsets, group_offsets, record_lengths, arena, .. } =
                model.clone();
            let mut parts = LodStripsParts { indices, offsets, group_offsets, record_lengths, arena };
            let start: usize = parts.record_lengths[..step].iter().map(|&n| usize::from(n)).sum();
            let length = usize::from(std::mem::take(&mut parts.record_lengths.to_mut()[step]));
            assert!(length > 0, "on a grid each step changes a strip");
            parts.arena.to_mut().drain(start..start + length);
            let reason = "leaves a vertex of the step in a strip";
            let found = LodStrips::from_parts(vertices, parts).map(drop);
            assert_eq!(found, Err(ModelError::Record { step, reason }));
        }
    }
}
