//! LodStrips: triangle strips that are edited in place to follow a collapse sequence \[RCRG06\].
//!
//! The strips of the full mesh are stored once. Each vertex has a record that lists the slots where it occurs
//! in the strips when it collapses. Coarsening writes its target to these slots and drops indices that have
//! become superfluous; refining undoes both. Changing the level costs only the records between the two levels.
//!
//! ```text
//! slots of a strip   | live indices .......... | dropped indices, the last dropped first |
//!                    0                      length                             full length
//! ```
//!
//! Dropping a run rotates it behind the live indices, where it stays until refining rotates it back. A
//! record therefore contains only slots, no vertices, and refining is an exact inverse by construction. A run
//! is dropped if the strip shows the same triangles without it (see `superfluous.rs`).
//!
//! **Stages.** The further a mesh is collapsed, the more indices its strips need per triangle: 1.1 for the
//! full bunny, 1.8 for half of it, 3.5 for a tenth. [`LodStrips::build_staged`] makes new strips whenever a
//! level would need more than a limit. Each set of strips is a *stage* and serves a range of levels; an
//! instance that leaves a stage keeps its strips until it comes back.
//!
//! ```text
//! split count    full mesh ------- stage 0 -------|------ stage 1 ------|--- stage 2 ---| base
//! indices per triangle   1.13 .............. 1.45 | 1.24 ......... 1.45 | 1.26 ... 1.45 |
//! ```
//!
//! Differs: \[RCRG06\] drops only `aa(a)+` and `ab(ab)+` and stores machine words, and has no stages. Here a
//! record is a few bytes that can be read in both directions. Strips are sorted along a space-filling curve, so
//! that the slots of a vertex are close to each other. Vertices are packed in as many bits as they need.
//!
//! A file stores the strips of later stages as `walks` over the triangles of their levels, which take a tenth of
//! the bytes of their indices.
//!
//! Cost: a step writes about three slots and moves 0.8 ends of strips, 24 to 35 ns on the bunny. What took 42 ns
//! and more before were branches: a substitution now names a slot instead of a strip and a place in it, and drops come
//! after all substitutions, so that a record is two loops over numbers of fixed width. Building takes time
//! linear in the number of steps times [`MAX_STRIP_INDICES`].

mod build;
mod changes;
mod record;
mod stage;
mod stage_options;
mod state;
mod strip_buffer;
mod validate;
mod walks;

use std::borrow::Cow;
use std::ops::Range;

pub use stage_options::StageOptions;
pub use state::LodStripsState;
pub use strip_buffer::StripBuffer;

pub use super::stored_strips::MAX_STRIP_INDICES;

pub(crate) use self::stage::StageHead;

use self::stage::Stage;
use super::bits::PADDING;
use super::packed_vertices::PackedVertices;
use super::step_vertices::StepVertices;
use super::stored_strips::StoredStrips;
use super::{
    DrawCounts, LodModel, ModelError, PartBytes, StoredModel, StripModel, Topology, join_strips,
    strips_of_group_into,
};
use crate::mesh::RefinableMesh;

/// The static half of the model, shared by all instances; see the [module](self).
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LodStrips<'a> {
    /// The vertices of each step, without targets.
    vertices: StepVertices<'a>,
    /// Target of each vertex above the base.
    targets: PackedVertices<'a>,
    /// From fine to coarse; the first one has the strips of the full mesh.
    stages: Vec<Stage<'a>>,
    /// Head of each record, by vertex, beginning above the base.
    heads: Cow<'a, [u8]>,
    /// The records, in the same order.
    arena: Cow<'a, [u8]>,
    /// First strip of each group, followed by the strip count, where strips of all stages count.
    group_offsets: Vec<u32>,
}

/// The stored arrays of a model, except for those that come from the sequence.
pub(crate) struct LodStripsParts<'a> {
    /// The strips of the full mesh.
    pub strips: StoredStrips<'a>,
    /// The later stages, from fine to coarse.
    pub stages: Vec<StageHead>,
    /// The strips of the later stages as [`walks`], then padding.
    pub walks: Cow<'a, [u8]>,
    pub heads: Cow<'a, [u8]>,
    pub arena: Cow<'a, [u8]>,
}

/// Counts of the edits in all records of a model.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct EditCounts {
    /// Number of indices that are replaced.
    pub substitutions: usize,
    /// Number of runs that are dropped.
    pub drops: usize,
}

impl<'a> LodStrips<'a> {
    /// Name of the part that is in memory only: a file has the walks.
    pub const LATER_STRIPS: &'static str = "strips of later stages";

    /// Assembles a model from stored arrays and validates every record, so that no later move can fail.
    pub(crate) fn from_parts(
        vertices: StepVertices<'a>,
        targets: PackedVertices<'a>,
        parts: LodStripsParts<'a>,
    ) -> Result<Self, ModelError> {
        let LodStripsParts { strips, stages, walks, heads, arena } = parts;
        let full = Stage::new(vertices.step_count(), strips, Cow::default());
        let group_offsets = Vec::new();
        let mut model = Self { vertices, targets, stages: vec![full], heads, arena, group_offsets };
        validate::read_stages(&mut model, &stages, walks)?;
        model.group_offsets = stage::group_offsets(&model.stages);
        Ok(model)
    }

    /// Returns a copy that owns its arrays.
    pub fn into_owned(self) -> LodStrips<'static> {
        LodStrips {
            vertices: self.vertices.into_owned(),
            targets: self.targets.into_owned(),
            stages: self.stages.into_iter().map(Stage::into_owned).collect(),
            heads: self.heads.into_owned().into(),
            arena: self.arena.into_owned().into(),
            group_offsets: self.group_offsets,
        }
    }

    /// Checks that the model was built for a mesh.
    ///
    /// # Errors
    /// [`ModelError`] for the first step or group that differs.
    pub(crate) fn check_mesh(&self, refinable: &RefinableMesh) -> Result<(), ModelError> {
        let sequence = &refinable.sequence;
        let (found, expected) = (self.vertices.step_count(), sequence.step_count());
        if found != expected {
            return Err(ModelError::Length { what: "steps", found, expected });
        }
        let base = self.vertices.base_vertex_count();
        let is_same = |&step: &usize| {
            let vertices = sequence.step_vertices(step);
            vertices == self.vertices.of_step(step)
                && vertices.into_iter().all(|v| self.targets.get((v - base) as usize) == sequence.target(v))
        };
        if let Some(step) = (0..expected).find(|step| !is_same(step)) {
            return Err(ModelError::Record { step, reason: "restores other vertices than that of the mesh" });
        }
        let groups = refinable.mesh.groups_or_whole();
        if self.group_count() != groups.len() {
            return Err(ModelError::GroupCount { found: self.group_count(), expected: groups.len() });
        }
        let (full, mut triangles) = (self.new_state(), Vec::new());
        for (group, expected) in groups.iter().map(|group| group.count as usize).enumerate() {
            triangles.clear();
            self.group_triangles_into(&full, group, &mut triangles);
            if triangles.len() != expected {
                return Err(ModelError::TriangleCount { group, found: triangles.len(), expected });
            }
        }
        Ok(())
    }

    /// The split counts at which the stages begin, from fine to coarse. The first one is the step count; a
    /// stage serves all levels down to the next one.
    pub fn stage_split_counts(&self) -> impl Iterator<Item = usize> {
        self.stages.iter().map(|stage| stage.split_count)
    }

    /// Number of indices of the strips of each stage at its finest level, without restarts.
    pub fn stage_index_counts(&self) -> impl Iterator<Item = usize> {
        self.stages.iter().map(|stage| stage.strips.slot_count())
    }

    /// Counts the edits of all records.
    pub fn edit_counts(&self) -> EditCounts {
        let mut counts = EditCounts::default();
        let mut cursor = 0;
        for (stage, vertices) in self.stages_with_vertices().rev() {
            for vertex in vertices {
                let found = record::counts_at(stage.format, &self.arena, cursor, self.head(vertex));
                let Some((substitutions, drops, end)) = found else {
                    debug_assert!(false, "a checked record ended early");
                    return counts;
                };
                counts.substitutions += substitutions;
                counts.drops += drops;
                cursor = end;
            }
        }
        counts
    }

    /// The strips of the full mesh.
    pub(crate) fn full_strips(&self) -> &StoredStrips<'a> {
        &self.stages[0].strips
    }

    /// The later stages, and their walks with padding.
    pub(crate) fn later_stages(&self) -> (Vec<StageHead>, Vec<u8>) {
        let later = &self.stages[1..];
        let walks = later.iter().flat_map(|stage| stage.walks.iter().copied());
        (later.iter().map(Stage::head).collect(), walks.chain([0; PADDING]).collect())
    }

    /// Heads and records.
    pub(crate) fn records(&self) -> [&[u8]; 2] {
        [&self.heads, &self.arena]
    }

    #[inline]
    fn head(&self, vertex: u32) -> u8 {
        self.heads[(vertex - self.vertices.base_vertex_count()) as usize]
    }

    /// The stages from fine to coarse, with the vertices whose records belong to each. The vertices of the
    /// step that leads from one stage to the next have no record.
    fn stages_with_vertices(
        &self,
    ) -> impl DoubleEndedIterator<Item = (&Stage<'a>, Range<u32>)> + ExactSizeIterator {
        (0..self.stages.len()).map(|index| (&self.stages[index], self.vertices_of_stage(index)))
    }

    /// Vertices that collapse within a stage.
    fn vertices_of_stage(&self, stage: usize) -> Range<u32> {
        let levels = self.levels_of_stage(stage);
        let [coarsest, finest] = [levels.start, levels.end - 1].map(|count| self.vertices.count_at(count));
        coarsest as u32..finest as u32
    }

    /// The split counts that a stage can show.
    fn levels_of_stage(&self, stage: usize) -> Range<usize> {
        let coarsest = self.stages.get(stage + 1).map_or(0, |next| next.split_count + 1);
        coarsest..self.stages[stage].split_count + 1
    }

    /// The strips that an instance shows, without those of other stages.
    fn current_strips<'s>(&self, state: &'s LodStripsState) -> impl Iterator<Item = &'s [u32]> {
        let stage = &self.stages[state.stage()];
        (0..stage.strips.strip_count()).map(|strip| state.live(stage, strip))
    }
}

impl LodModel for LodStrips<'_> {
    type State = LodStripsState;

    fn step_count(&self) -> usize {
        self.vertices.step_count()
    }

    fn new_state(&self) -> LodStripsState {
        LodStripsState::new(self)
    }

    fn split_count(&self, state: &LodStripsState) -> usize {
        state.split_count()
    }

    fn move_to(&self, state: &mut LodStripsState, split_count: usize) {
        state.move_to(self, split_count);
    }

    fn topology(&self) -> Topology {
        Topology::Strips
    }

    fn draw_counts(&self, state: &LodStripsState) -> DrawCounts {
        DrawCounts::of_strips(self.current_strips(state))
    }

    fn indices_into(&self, state: &LodStripsState, out: &mut Vec<u32>) {
        join_strips(self.current_strips(state), out);
    }

    fn bytes(&self) -> Vec<PartBytes> {
        let part = |name, bytes| PartBytes { name, bytes };
        let of_stages = |stages: &[Stage<'_>]| {
            let sizes = stages.iter().map(|stage| stage.strips.bytes());
            sizes.fold([0; 2], |sum, bytes| [sum[0] + bytes[0], sum[1] + bytes[1]])
        };
        let (first, later) = self.stages.split_at(1);
        let ([strips, offsets], later_bytes) = (of_stages(first), of_stages(later));
        let later_strips = later_bytes[0] + later_bytes[1] + 4 * self.group_offsets.len();
        let targets = self.targets.bytes().len() + 4 * self.vertices.word_count();
        vec![
            part("strips", strips),
            part("strip offsets", offsets),
            part("walks of later stages", self.stages.iter().map(|stage| stage.walks.len()).sum()),
            part(Self::LATER_STRIPS, later_strips),
            part("targets", targets),
            part("record heads", self.heads.len()),
            part("records", self.arena.len()),
        ]
    }

    fn state_bytes(&self, state: &LodStripsState) -> usize {
        state.bytes()
    }
}

impl StoredModel for LodStrips<'_> {
    fn step_vertices(&self) -> &StepVertices<'_> {
        &self.vertices
    }

    fn group_count(&self) -> usize {
        self.group_offsets.len() - 1
    }

    fn group_triangles_into(&self, state: &LodStripsState, group: usize, out: &mut Vec<[u32; 3]>) {
        strips_of_group_into(self, state, group, out);
    }
}

impl StripModel for LodStrips<'_> {
    fn group_offsets(&self) -> &[u32] {
        &self.group_offsets
    }

    fn strip<'s>(&self, state: &'s LodStripsState, strip: usize) -> &'s [u32] {
        let (index, strip) = stage::place_of(&self.stages, &self.group_offsets, strip);
        if index == state.stage() { state.live(&self.stages[index], strip) } else { &[] }
    }
}
