//! Builds records and stages in one pass from the full mesh to the base, tracking which strips use each
//! vertex.

use std::borrow::Cow;

use super::record::{ARENA_PADDING, Drop, Edit, RecordFormat};
use super::stage::{Stage, group_offsets};
use super::walks::{self, Ground};
use super::{LodStrips, MAX_STRIP_INDICES, StageOptions};
use crate::mesh::{CollapseSequence, IndexedMesh, RefinableMesh, TriangleGroup};
use crate::model::ModelError;
use crate::model::packed_vertices::PackedVertices;
use crate::model::step_vertices::StepVertices;
use crate::model::stored_strips::StoredStrips;
use crate::model::strip_input::{check_strips, sorted_spatially};
use crate::model::strip_run::{Run, restore_run};
use crate::model::superfluous::drop_superfluous;
use crate::strip::{StripSet, strip_triangles};

/// A stage is not tried before the triangles have fallen to this share of those at the last try, or if there are
/// more groups, which take room in each stage. Otherwise a limit that no strips can meet would be tried at every
/// step.
const RETRY_SHARE: f64 = 0.95;
/// This share applies if new strips do not meet the limit either: those of a triangulated polygon never do, and
/// all tries together would take twenty times as long as the first.
const MISSED_RETRY_SHARE: f64 = 0.7;
/// Stages with fewer triangles are tried as often as if they met the limit: that costs little.
const SMALL_STAGE: usize = 10_000;

impl LodStrips<'static> {
    /// Builds the model from strips of the full mesh, in a single stage; strips longer than
    /// [`MAX_STRIP_INDICES`] are cut.
    ///
    /// # Errors
    /// [`ModelError`] if the strips do not belong to the mesh: different groups, different triangle
    /// counts, or vertices that do not exist.
    pub fn build(refinable: &RefinableMesh, strips: &StripSet) -> Result<Self, ModelError> {
        Self::build_staged(refinable, strips, &StageOptions::single(), |_| {
            Ok::<_, ModelError>(StripSet::new())
        })
    }

    /// Builds the model from strips of the full mesh, and calls `stripify` for new strips whenever a level
    /// would need too many indices. The mesh that it receives is that level, with the groups of the full mesh
    /// and without attributes. Strips longer than [`MAX_STRIP_INDICES`] are cut.
    ///
    /// ```
    /// use striata::model::{LodModel as _, LodStrips};
    /// use striata::{mesh::shapes, simplify::build_sequence, strip::stripify};
    ///
    /// let refinable = build_sequence(&shapes::torus(64, 32, 1.0, 0.4), &Default::default())?.refinable;
    /// let strips = stripify(&refinable.mesh)?;
    /// let model = LodStrips::build_staged(&refinable, &strips, &Default::default(), |level| {
    ///     stripify(level).map_err(Box::<dyn std::error::Error>::from)
    /// })?;
    /// let mut state = model.new_state();
    /// let tenth = refinable.sequence.split_count_for_triangles(refinable.mesh.triangle_count() / 10);
    /// model.move_to(&mut state, tenth);
    /// let indices = model.draw_counts(&state).index_count;
    /// assert!(indices as f64 <= 1.45 * refinable.sequence.triangle_count_at(tenth) as f64);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// What `stripify` returns, and [`ModelError`] if its strips or `strips` do not belong to their mesh:
    /// different groups, different triangle counts, or vertices that do not exist.
    pub fn build_staged<E: From<ModelError>>(
        refinable: &RefinableMesh,
        strips: &StripSet,
        options: &StageOptions,
        mut stripify: impl FnMut(&IndexedMesh) -> Result<StripSet, E>,
    ) -> Result<Self, E> {
        check_strips(&refinable.mesh, strips)?;
        let mut builder = LodStripsBuilder::new(refinable, strips);
        for step in (0..refinable.sequence.step_count()).rev() {
            let before = builder.written();
            builder.write_step(step);
            if builder.needs_strips(step, options.max_indices_per_triangle) {
                let level = builder.level(step);
                let strips = stripify(&level)?;
                check_strips(&level, &strips)?;
                builder.offer_stage(step, &strips, before)?;
                builder.wait_for_next_try(step, options.max_indices_per_triangle);
            }
        }
        Ok(builder.finish())
    }
}

struct LodStripsBuilder<'r> {
    refinable: &'r RefinableMesh,
    sequence: &'r CollapseSequence,
    stages: Vec<Stage<'static>>,
    current: CurrentStage,
    /// Edits of the last step to the current strips, with the vertex that each belongs to.
    step_edits: Vec<(u32, Edit)>,
    /// Records in the order in which they are written: from the last vertex to the base.
    arena: Vec<u8>,
    /// Head and length of each record, in the same order.
    records: Vec<(u8, u32)>,
    /// New strips are tried at this number of triangles, or of groups if there are more.
    next_try: f64,
}

/// How much of the records has been written.
#[derive(Clone, Copy)]
struct WrittenRecords {
    arena: usize,
    records: usize,
}

impl<'r> LodStripsBuilder<'r> {
    fn new(refinable: &'r RefinableMesh, strips: &StripSet) -> Self {
        let (mesh, sequence) = (&refinable.mesh, &refinable.sequence);
        let strips = sorted_spatially(&strips.cut(MAX_STRIP_INDICES), &mesh.positions);
        let vertex_count = mesh.vertex_count();
        Self {
            refinable,
            sequence,
            stages: vec![Stage::new(
                sequence.step_count(),
                StoredStrips::pack(&strips, vertex_count),
                Cow::default(),
            )],
            current: CurrentStage::new(strips, vertex_count),
            step_edits: Vec::new(),
            arena: Vec::new(),
            records: Vec::with_capacity(sequence.targets().len()),
            next_try: f64::INFINITY,
        }
    }

    fn written(&self) -> WrittenRecords {
        WrittenRecords { arena: self.arena.len(), records: self.records.len() }
    }

    /// Collapses the vertices of a step and writes their records.
    fn write_step(&mut self, step: usize) {
        self.step_edits.clear();
        for vertex in self.sequence.step_vertices(step).rev() {
            self.current.collapse(vertex, self.sequence.target(vertex));
            let start = self.arena.len();
            let head = self.current.format.write(&self.current.edit, &mut self.arena);
            self.records.push((head, (self.arena.len() - start) as u32));
            self.step_edits.push((vertex, self.current.edit.clone()));
        }
    }

    /// Whether the current strips need too many indices after a step.
    fn needs_strips(&self, step: usize, limit: f64) -> bool {
        self.misses(step, limit) && self.size_at(step) as f64 <= self.next_try
    }

    fn misses(&self, step: usize, limit: f64) -> bool {
        self.current.index_count() as f64 > limit * self.sequence.triangle_count_at(step) as f64
    }

    /// Sets when new strips may be tried again after they were at a step.
    fn wait_for_next_try(&mut self, step: usize, limit: f64) {
        let size = self.size_at(step);
        let misses = size >= SMALL_STAGE && self.misses(step, limit);
        self.next_try = size as f64 * if misses { MISSED_RETRY_SHARE } else { RETRY_SHARE };
    }

    /// Number of triangles after a step, or of groups if there are more.
    fn size_at(&self, step: usize) -> usize {
        self.sequence.triangle_count_at(step).max(self.current.strips.group_count())
    }

    /// The mesh after a step, from the current strips.
    fn level(&self, step: usize) -> IndexedMesh {
        let vertex_count = self.sequence.step_vertices(step).start as usize;
        let mut level = IndexedMesh::new(self.refinable.mesh.positions[..vertex_count].to_vec(), Vec::new());
        let strips = &self.current.strips;
        for group in 0..strips.group_count() {
            let first = level.triangles.len();
            for strip in strips.group_strips(group) {
                level.triangles.extend(strip_triangles(self.current.live(strip)));
            }
            let count = (level.triangles.len() - first) as u32;
            let name = String::new();
            level.groups.push(TriangleGroup { name, material: None, first: first as u32, count });
        }
        level
    }

    /// Begins a stage with these strips of the level after a step, if they need fewer indices than the
    /// current ones. The records of the step, written after `before`, are then not needed.
    fn offer_stage(
        &mut self,
        step: usize,
        strips: &StripSet,
        before: WrittenRecords,
    ) -> Result<(), ModelError> {
        let strips = sorted_spatially(&strips.cut(MAX_STRIP_INDICES), &self.refinable.mesh.positions);
        let vertex_count = self.sequence.step_vertices(step).start as usize;
        let stage = CurrentStage::new(strips, vertex_count);
        if stage.index_count() >= self.current.index_count() {
            return Ok(());
        }
        let walks = walks::write(self.ground(step), &stage.strips).map_err(|place| {
            let reason = "shows a triangle that the level does not have";
            ModelError::Listed { what: "strip", place, reason }
        })?;
        self.arena.truncate(before.arena);
        self.records[before.records..].fill((0, 0));
        let stored = StoredStrips::pack(&stage.strips, vertex_count);
        self.stages.push(Stage::new(step, stored, walks.into()));
        self.current = stage;
        Ok(())
    }

    /// The triangles of the level after a step, as readers find them: those of the level before the step, with
    /// the vertices of the step replaced. The current strips are then those before the step.
    fn ground(&mut self, step: usize) -> Ground {
        for (vertex, edit) in self.step_edits.iter().rev() {
            self.current.undo(*vertex, edit);
        }
        let vertex_count = self.sequence.step_vertices(step).start;
        let after_step = |v: u32| if v < vertex_count { v } else { self.sequence.target(v) };
        let mut ground = Ground::new(vertex_count as usize);
        let strips = &self.current.strips;
        for group in 0..strips.group_count() {
            for strip in strips.group_strips(group) {
                ground.add_strip(self.current.live(strip), after_step);
            }
            ground.end_group();
        }
        ground
    }

    fn finish(self) -> LodStrips<'static> {
        let mut arena = Vec::with_capacity(self.arena.len() + ARENA_PADDING);
        let mut end = self.arena.len();
        for &(_, length) in self.records.iter().rev() {
            let start = end - length as usize;
            arena.extend_from_slice(&self.arena[start..end]);
            end = start;
        }
        arena.extend([0; ARENA_PADDING]);
        let heads = self.records.iter().rev().map(|record| record.0).collect();
        let vertices = StepVertices::of_sequence(self.sequence).without_targets();
        let targets = PackedVertices::pack(self.sequence.targets(), self.refinable.mesh.vertex_count());
        let group_offsets = group_offsets(&self.stages);
        LodStrips { vertices, targets, stages: self.stages, heads, arena: arena.into(), group_offsets }
    }
}

/// The strips of the stage being built.
struct CurrentStage {
    /// The strips at the finest level of the stage.
    strips: StripSet,
    format: RecordFormat,
    slots: Vec<u32>,
    lengths: Vec<u32>,
    /// For each vertex, the strips that use it, possibly with some that no longer do.
    strips_of: Vec<Vec<u32>>,
    /// Number of indices that are drawn, with a restart after each strip.
    drawn: usize,
    edit: Edit,
    changed: Vec<u32>,
    runs: Vec<Run>,
}

impl CurrentStage {
    fn new(strips: StripSet, vertex_count: usize) -> Self {
        let mut strips_of = vec![Vec::new(); vertex_count];
        for (strip, indices) in strips.strips().enumerate() {
            for &v in indices {
                note(&mut strips_of[v as usize], strip as u32);
            }
        }
        let lengths: Vec<u32> = strips.strips().map(|strip| strip.len() as u32).collect();
        Self {
            format: RecordFormat::new(strips.indices().len(), strips.strip_count()),
            slots: strips.indices().to_vec(),
            drawn: lengths.iter().map(|&length| drawn(length as usize)).sum(),
            strips,
            lengths,
            strips_of,
            edit: Edit::default(),
            changed: Vec::new(),
            runs: Vec::new(),
        }
    }

    /// Number of indices needed to draw all strips, restarts between them included.
    fn index_count(&self) -> usize {
        self.drawn.saturating_sub(1)
    }

    /// Live indices of a strip.
    fn live(&self, strip: usize) -> &[u32] {
        let first = self.strips.offsets()[strip] as usize;
        &self.slots[first..first + self.lengths[strip] as usize]
    }

    /// Replaces a vertex by its target in all strips and drops what becomes superfluous; `edit` then says
    /// where.
    fn collapse(&mut self, vertex: u32, target: u32) {
        self.edit.slots.clear();
        self.edit.drops.clear();
        let mut touched = std::mem::take(&mut self.strips_of[vertex as usize]);
        touched.sort_unstable();
        touched.dedup();
        for &strip in &touched {
            self.edit_strip(strip, vertex, target);
        }
    }

    /// Undoes the last edit that has not been undone, by which a vertex collapsed.
    fn undo(&mut self, vertex: u32, edit: &Edit) {
        for &Drop { strip, run } in edit.drops.iter().rev() {
            self.lengths[strip as usize] += run.count;
            let first = self.strips.offsets()[strip as usize] as usize;
            restore_run(&mut self.slots[first..first + self.lengths[strip as usize] as usize], run);
        }
        edit.slots.iter().for_each(|&slot| self.slots[slot as usize] = vertex);
    }

    fn edit_strip(&mut self, strip: u32, vertex: u32, target: u32) {
        let first = self.strips.offsets()[strip as usize];
        let length = &mut self.lengths[strip as usize];
        let live = &mut self.slots[first as usize..(first + *length) as usize];
        self.changed.clear();
        for (index, v) in live.iter_mut().enumerate().filter(|(_, v)| **v == vertex) {
            *v = target;
            self.changed.push(index as u32);
            self.edit.slots.push(first + index as u32);
        }
        if self.changed.is_empty() {
            return;
        }
        note(&mut self.strips_of[target as usize], strip);
        self.runs.clear();
        let left = drop_superfluous(live, &mut self.changed, &mut self.runs);
        self.edit.drops.extend(self.runs.iter().map(|&run| Drop { strip, run }));
        self.drawn = self.drawn + drawn(left) - drawn(*length as usize);
        *length = left as u32;
    }
}

/// Number of indices that a strip and its restart take.
fn drawn(length: usize) -> usize {
    if length == 0 { 0 } else { length + 1 }
}

/// Adds a strip to the list of a vertex, if it is not the last one there.
fn note(strips: &mut Vec<u32>, strip: u32) {
    if strips.last() != Some(&strip) {
        strips.push(strip);
    }
}
