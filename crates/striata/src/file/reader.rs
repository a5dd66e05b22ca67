//! Reading of files: typed access to the sections, the whole mesh, single levels.

mod read_patterns;
mod read_stream;

use std::borrow::Cow;
use std::sync::OnceLock;

use super::container::{Container, Ending};
use super::mesh_sections::{appearance_from_bytes, groups_from_bytes, layer_from_bytes};
use super::metadata_has_guaranteed_errors;
use super::{DecodeError, SectionInfo, SectionKind, StreamCodec, Summary, Verify};
use crate::mesh::{
    AttributeLayer, CollapseSequence, IndexedMesh, LevelTable, PositionIndex, RefinableMesh, SequenceParts,
    Steps, TriangleGroup, layers_from_sorted, level_sources, replay,
};
use crate::model::fans::FansParts;
use crate::model::lod_strips::{LodStripsParts, StageHead};
use crate::model::mts::MtsParts;
use crate::model::{
    Fans, LodModel, LodStrips, ModelKind, Mts, PackedVertices, Patterns, StepVertices, StoredModel,
    StoredStrips, StripModel,
};
use crate::strip::{StripSet, strip_triangles};

/// A `.striata` file in memory or memory-mapped; apart from the header, sections are read only when needed.
#[derive(Clone, Debug)]
pub struct StriataFile<'a> {
    container: Container<'a>,
    summary: Summary,
    /// The patterns, cached after validation.
    patterns: OnceLock<Patterns>,
    /// The decoded mesh of a file that contains only a stream.
    decoded: OnceLock<Steps>,
    /// The full mesh and its collapses, if levels need them for the data of their triangles.
    full: OnceLock<(IndexedMesh, Option<CollapseSequence>)>,
    codec: Option<&'static dyn StreamCodec>,
}

impl<'a> StriataFile<'a> {
    /// Reads the header, the section table and the summary; each section's checksum is verified when the
    /// section is read.
    ///
    /// If a file contains its mesh only as a stream, reading the mesh requires a decoder: see
    /// [`with_codec`](Self::with_codec).
    ///
    /// # Errors
    /// [`DecodeError`] if the bytes are not a valid `.striata` file.
    pub fn parse(bytes: &'a [u8]) -> Result<Self, DecodeError> {
        Self::parse_with(bytes, Verify::WhenRead)
    }

    /// Reads a file like [`parse`](Self::parse), with a choice of when checksums are verified.
    ///
    /// # Errors
    /// [`DecodeError`] under the conditions of [`parse`](Self::parse).
    pub fn parse_with(bytes: &'a [u8], verify: Verify) -> Result<Self, DecodeError> {
        Self::of_container(Container::parse(bytes, verify, Ending::Whole)?)
    }

    fn of_container(container: Container<'a>) -> Result<Self, DecodeError> {
        Container::check_single_mesh(&container.sections)?;
        let summary = Summary::from_bytes(container.get(SectionKind::SUMMARY)?)?;
        Ok(Self::of_parts(container, summary))
    }

    fn of_parts(container: Container<'a>, summary: Summary) -> Self {
        Self {
            container,
            summary,
            patterns: OnceLock::new(),
            decoded: OnceLock::new(),
            full: OnceLock::new(),
            codec: None,
        }
    }

    /// Counts and bounds.
    pub fn summary(&self) -> Summary {
        self.summary
    }

    /// All sections with their sizes, in file order.
    pub fn sections(&self) -> &[SectionInfo] {
        &self.container.sections
    }

    /// Key-value texts about the file; empty if there are none.
    ///
    /// # Errors
    /// [`DecodeError`] if the section is invalid.
    pub fn metadata(&self) -> Result<Vec<(String, String)>, DecodeError> {
        match self.has(SectionKind::METADATA) {
            true => self.container.metadata(),
            false => self.metadata_of_stream(),
        }
    }

    /// Positions of all vertices, in refinement order.
    ///
    /// # Errors
    /// [`DecodeError`] if the section is invalid.
    pub fn positions(&self) -> Result<Cow<'a, [[f32; 3]]>, DecodeError> {
        if let Some(steps) = self.mesh_of_stream()? {
            return Ok(steps.mesh().positions.clone().into());
        }
        let kind = SectionKind::POSITIONS;
        let positions = self.container.numbers::<[f32; 3]>(kind)?;
        self.expect(kind, "vertices", positions.len(), self.summary.vertex_count)?;
        Ok(positions)
    }

    /// Origin of the positions in the coordinates of the mesh's source, in mesh units.
    ///
    /// # Errors
    /// [`DecodeError`] if the section is invalid.
    pub fn origin(&self) -> Result<[f64; 3], DecodeError> {
        let kind = SectionKind::ORIGIN;
        if !self.has(kind) {
            return Ok([0.0; 3]);
        }
        let numbers = self.container.numbers::<f64>(kind)?;
        match *numbers {
            [x, y, z] if [x, y, z].iter().all(|x| x.is_finite()) => Ok([x, y, z]),
            [_, _, _] => Err(DecodeError::Malformed { kind, offset: 0, reason: "the origin is not finite" }),
            _ => Err(DecodeError::Count {
                kind,
                what: "coordinates",
                found: numbers.len() as u64,
                expected: 3,
            }),
        }
    }

    /// The attribute layers.
    ///
    /// # Errors
    /// [`DecodeError`] if a section is invalid.
    pub fn layers(&self) -> Result<Vec<AttributeLayer>, DecodeError> {
        if let Some(steps) = self.mesh_of_stream()? {
            return Ok(steps.mesh().layers.clone());
        }
        self.layers_of_first(self.positions()?.len())
    }

    /// The attribute layers of the first `vertex_count` vertices.
    fn layers_of_first(&self, vertex_count: usize) -> Result<Vec<AttributeLayer>, DecodeError> {
        let full = self.positions()?.len();
        self.container
            .all(SectionKind::LAYER)
            .map(|bytes| layer_from_bytes(SectionKind::LAYER, bytes?, vertex_count, full))
            .collect()
    }

    /// Gives the triangles of the full mesh their data, which the file stores in sorted order.
    fn read_triangle_layers(&self, mesh: &mut IndexedMesh) -> Result<(), DecodeError> {
        let (kind, count) = (SectionKind::TRIANGLE_LAYER, mesh.triangle_count());
        if !self.has(kind) {
            return Ok(());
        }
        let read = |bytes: Result<&[u8], DecodeError>| layer_from_bytes(kind, bytes?, count, count);
        let sorted = self.container.all(kind).map(read).collect::<Result<Vec<_>, _>>()?;
        mesh.triangle_layers = layers_from_sorted(mesh, &sorted);
        Ok(())
    }

    /// Gives the triangles of a level their data: those of the triangles that they stem from, or without
    /// collapses those of the nearest ones.
    fn add_triangle_layers(&self, level: &mut IndexedMesh, split_count: usize) -> Result<(), DecodeError> {
        if !self.has(SectionKind::TRIANGLE_LAYER) {
            return Ok(());
        }
        let full = match self.full.get() {
            Some(full) => full,
            None => {
                let sequence = self.has_collapses().then(|| self.sequence()).transpose()?;
                let mesh = self.mesh()?;
                self.full.get_or_init(|| (mesh, sequence))
            }
        };
        match full {
            (full, Some(sequence)) => {
                let sources = level_sources(full, level, |v| sequence.target_at(v, split_count));
                level.take_triangle_layers(full, &sources);
            }
            (full, None) => level.take_nearest_triangle_layers(full),
        }
        Ok(())
    }

    /// Triangle groups of the full mesh.
    ///
    /// # Errors
    /// [`DecodeError`] if the section is invalid.
    pub fn groups(&self) -> Result<Vec<TriangleGroup>, DecodeError> {
        if let Some(steps) = self.mesh_of_stream()? {
            return Ok(steps.mesh().groups.clone());
        }
        let kind = SectionKind::GROUPS;
        let groups = groups_from_bytes(self.container.get(kind)?)?;
        self.expect(kind, "groups", groups.len(), self.summary.group_count)?;
        Ok(groups)
    }

    /// Errors of the levels, starting with the base mesh; see [`CollapseSequence::errors`].
    ///
    /// # Errors
    /// [`DecodeError`] if the section is invalid.
    pub fn errors(&self) -> Result<Cow<'a, [f32]>, DecodeError> {
        if let Some(steps) = self.mesh_of_stream()? {
            return Ok(steps.levels().errors().to_vec().into());
        }
        let errors = self.container.numbers::<f32>(SectionKind::ERRORS)?;
        self.expect(SectionKind::ERRORS, "errors", errors.len(), self.summary.step_count)?;
        Ok(errors)
    }

    /// Whether the steps of the file are collapses; if not, its levels are only available as fans or patterns.
    pub fn has_collapses(&self) -> bool {
        if self.is_stream_only() {
            return self.has_collapses_in_stream();
        }
        self.has(SectionKind::TARGETS) || !(self.has_patterns() || self.has(SectionKind::FAN_ENTRIES))
    }

    /// Sizes and errors of the levels, whether the steps are collapses or not.
    ///
    /// # Errors
    /// [`DecodeError`] if a section is invalid.
    pub fn levels(&self) -> Result<LevelTable, DecodeError> {
        if let Some(steps) = self.mesh_of_stream()? {
            return Ok(steps.levels().clone());
        }
        if self.has_collapses() {
            return Ok(self.sequence()?.levels().clone());
        }
        let counts = if self.has(SectionKind::FAN_ENTRIES) {
            self.read_fans()?.triangle_counts()
        } else {
            self.read_patterns()?.triangle_counts()
        };
        self.levels_of(counts)
    }

    /// Sizes and errors of the levels of fans that this file has, whether the steps are collapses or not.
    ///
    /// # Errors
    /// [`DecodeError`] if a section is invalid.
    pub fn levels_of_fans(&self, fans: &Fans) -> Result<LevelTable, DecodeError> {
        self.levels_of(fans.triangle_counts())
    }

    /// The collapse sequence, validated and copied out of the file.
    ///
    /// # Errors
    /// [`DecodeError`] if a section is invalid, or if the steps are not collapses.
    pub fn sequence(&self) -> Result<CollapseSequence, DecodeError> {
        if let Some(steps) = self.mesh_of_stream()? {
            return Ok(steps.collapses().ok_or(DecodeError::NoCollapses)?.sequence.clone());
        }
        if !self.has_collapses() {
            return Err(DecodeError::NoCollapses);
        }
        let sequence = CollapseSequence::from_parts(SequenceParts {
            positions: self.position_index()?,
            base_position_count: self.summary.base_position_count,
            targets: self.targets()?.to_vec(),
            errors: self.errors()?.into_owned(),
            removed_triangle_counts: self.container.get(SectionKind::REMOVED)?.to_vec(),
            triangle_count: self.summary.triangle_count,
        })?;
        for (what, found, expected) in [
            ("base vertices", self.summary.base_vertex_count, sequence.base_vertex_count()),
            ("base triangles", self.summary.base_triangle_count, sequence.triangle_count_at(0)),
        ] {
            self.expect(SectionKind::SUMMARY, what, found, expected)?;
        }
        Ok(sequence)
    }

    /// The targets of all vertices above the base, packed.
    fn targets(&self) -> Result<PackedVertices<'a>, DecodeError> {
        let kind = SectionKind::TARGETS;
        let bytes = self.container.get(kind)?;
        let vertex_count = self.positions()?.len();
        let above_base = vertex_count.saturating_sub(self.summary.base_vertex_count);
        PackedVertices::from_bytes(bytes.into(), above_base, vertex_count, "targets").map_err(|_| {
            let reason = "the length is not that of one target for each vertex above the base";
            DecodeError::Malformed { kind, offset: bytes.len(), reason }
        })
    }

    fn position_index(&self) -> Result<PositionIndex, DecodeError> {
        // Bounded by the number of positions actually stored, not by the summary.
        let vertex_count = self.positions()?.len();
        let kind = SectionKind::FIRST_VERTICES;
        let Some(firsts) = self.first_vertices()? else {
            self.expect(SectionKind::SUMMARY, "positions", self.summary.position_count, vertex_count)?;
            return Ok(PositionIndex::identity(vertex_count));
        };
        let is_sound = firsts.first() == Some(&0)
            && firsts.last().is_some_and(|&last| last as usize == vertex_count)
            && firsts.windows(2).all(|w| w[0] < w[1]);
        if !is_sound {
            let reason = "first vertices do not rise from 0 to the vertex count";
            return Err(DecodeError::Malformed { kind, offset: 0, reason });
        }
        Ok(PositionIndex::from_first(firsts.into_owned()))
    }

    fn first_vertices(&self) -> Result<Option<Cow<'a, [u32]>>, DecodeError> {
        let kind = SectionKind::FIRST_VERTICES;
        if self.container.find(kind)?.is_none() {
            return Ok(None);
        }
        let firsts = self.container.numbers::<u32>(kind)?;
        self.expect(kind, "numbers", firsts.len(), self.summary.position_count.saturating_add(1))?;
        Ok(Some(firsts))
    }

    /// Whether the file has any section of a kind.
    fn has(&self, kind: SectionKind) -> bool {
        self.container.sections.iter().any(|section| section.kind == kind)
    }

    /// Triangles of the full mesh, if the file has a section for them; files with strips, fans or patterns
    /// do not.
    ///
    /// Vertex indices are not checked here, but in [`mesh`](Self::mesh).
    pub fn triangles(&self) -> Option<Result<Cow<'a, [[u32; 3]]>, DecodeError>> {
        self.has(SectionKind::TRIANGLES).then(|| self.container.numbers(SectionKind::TRIANGLES))
    }

    /// Strips of the full mesh, if the file has them, copied out of the file.
    pub fn strips(&self) -> Option<Result<StripSet, DecodeError>> {
        let kind = if self.has(SectionKind::RECORDS) { ModelKind::LodStrips } else { ModelKind::Mts };
        self.has(SectionKind::STRIP_INDICES).then(|| Ok(self.stored_strips(kind)?.to_strip_set()))
    }

    /// The strips of the full mesh as models use them; `model` is the one to name in errors.
    fn stored_strips(&self, model: ModelKind) -> Result<StoredStrips<'a>, DecodeError> {
        let groups = self.container.numbers(SectionKind::STRIP_GROUPS)?;
        let lengths = self.container.get(SectionKind::STRIP_LENGTHS)?;
        let bytes = self.container.get(SectionKind::STRIP_INDICES)?;
        let strips = StoredStrips::from_parts(groups, lengths.into(), bytes.into(), self.positions()?.len())
            .map_err(|reason| DecodeError::Model { model, reason })?;
        let group_count = self.summary.group_count.max(1);
        let found = strips.group_offsets.len().saturating_sub(1);
        self.expect(SectionKind::STRIP_GROUPS, "groups", found, group_count)?;
        Ok(strips)
    }

    /// Whether the file has a LodStrips model.
    pub fn has_lod_strips(&self) -> bool {
        self.has_model(ModelKind::LodStrips)
    }

    /// Whether the file has a model, even if it cannot be read.
    pub fn has_model(&self, kind: ModelKind) -> bool {
        self.has(match kind {
            ModelKind::LodStrips => SectionKind::RECORDS,
            ModelKind::Mts => SectionKind::LIFETIMES,
            ModelKind::Fans => SectionKind::FAN_ENTRIES,
            ModelKind::Patterns => SectionKind::PATTERN_RECORDS,
            ModelKind::Progressive => SectionKind::STREAM,
        })
    }

    /// Whether the errors of uniform levels are guaranteed bounds, as the metadata say, rather than estimates.
    ///
    /// # Errors
    /// [`DecodeError`] if the metadata are damaged.
    pub fn has_guaranteed_errors(&self) -> Result<bool, DecodeError> {
        Ok(metadata_has_guaranteed_errors(&self.metadata()?))
    }

    /// The LodStrips model, if the file has one; borrowed from the file and validated once, so that no move
    /// can fail.
    pub fn lod_strips(&self) -> Option<Result<LodStrips<'a>, DecodeError>> {
        self.has_lod_strips().then(|| self.read_lod_strips())
    }

    fn read_lod_strips(&self) -> Result<LodStrips<'a>, DecodeError> {
        let vertices = self.step_vertices()?;
        let has_stages = self.has(SectionKind::STAGES);
        let walks: &[u8] = if has_stages { self.container.get(SectionKind::STAGE_WALKS)? } else { &[] };
        let parts = LodStripsParts {
            strips: self.stored_strips(ModelKind::LodStrips)?,
            stages: if has_stages { self.stage_heads()? } else { Vec::new() },
            walks: walks.into(),
            heads: self.container.get(SectionKind::RECORD_HEADS)?.into(),
            arena: self.container.get(SectionKind::RECORDS)?.into(),
        };
        let model = LodStrips::from_parts(vertices, self.targets()?, parts);
        let model = model.map_err(|reason| DecodeError::Model { model: ModelKind::LodStrips, reason })?;
        self.expect_model(&model, SectionKind::RECORD_HEADS)?;
        Ok(model)
    }

    /// Split counts at which the later stages of LodStrips begin, and their numbers of strips.
    fn stage_heads(&self) -> Result<Vec<StageHead>, DecodeError> {
        let kind = SectionKind::STAGES;
        let table = self.container.numbers::<u32>(kind)?;
        let row = 1 + self.summary.group_count.max(1);
        if !table.len().is_multiple_of(row) {
            let reason = "the length is not that of whole stages";
            return Err(DecodeError::Malformed { kind, offset: 0, reason });
        }
        let head = |row: &[u32]| StageHead { split_count: row[0] as usize, strip_counts: row[1..].to_vec() };
        Ok(table.chunks_exact(row).map(head).collect())
    }

    /// The MTS model, if the file has one; borrowed from the file and validated once, so that no move can
    /// fail.
    pub fn mts(&self) -> Option<Result<Mts<'a>, DecodeError>> {
        self.has(SectionKind::LIFETIMES).then(|| self.read_mts())
    }

    fn read_mts(&self) -> Result<Mts<'a>, DecodeError> {
        let parts = MtsParts {
            strips: self.stored_strips(ModelKind::Mts)?,
            lifetimes: self.container.get(SectionKind::LIFETIMES)?.into(),
            heads: self.container.get(SectionKind::CHANGE_HEADS)?.into(),
            arena: self.container.get(SectionKind::CHANGES)?.into(),
        };
        let model = Mts::from_parts(self.step_vertices()?, self.targets()?, parts);
        let model = model.map_err(|reason| DecodeError::Model { model: ModelKind::Mts, reason })?;
        self.expect_model(&model, SectionKind::CHANGE_HEADS)?;
        Ok(model)
    }

    /// The fans and the bounds of their steps, if the file has them; copied out of the file and validated
    /// once, so that no move can fail.
    pub fn fans(&self) -> Option<Result<Fans, DecodeError>> {
        self.has(SectionKind::FAN_ENTRIES).then(|| self.read_fans())
    }

    fn read_fans(&self) -> Result<Fans, DecodeError> {
        let parts = FansParts {
            entries: self.container.get(SectionKind::FAN_ENTRIES)?,
            blocks: &self.container.numbers(SectionKind::FAN_BLOCKS)?,
            starts: &self.container.numbers(SectionKind::FAN_STARTS)?,
            waits: &self.container.numbers(SectionKind::FAN_WAITS)?,
            far: &self.container.numbers(SectionKind::FAN_FAR_TARGETS)?,
            orphans: &self.container.numbers(SectionKind::FAN_ORPHANS)?,
        };
        let unsound = |reason| DecodeError::Model { model: ModelKind::Fans, reason };
        let has_collapses = self.has_collapses();
        let removed = has_collapses.then(|| self.container.get(SectionKind::REMOVED)).transpose()?;
        let group_count = self.groups()?.len().max(1);
        let fans = Fans::from_parts(self.step_vertices()?, removed, group_count, parts).map_err(unsound)?;
        let kind = SectionKind::FAN_ENTRIES;
        self.expect(kind, "steps", fans.step_count(), self.summary.step_count)?;
        let base_triangle_count = self.summary.base_triangle_count;
        self.expect(kind, "triangles of the base", fans.base_triangle_count(), base_triangle_count)?;
        let records = self.container.get(SectionKind::FAN_BOUNDS)?;
        // The errors of the levels say nothing about single floors.
        let errors = has_collapses.then(|| self.errors()).transpose()?;
        fans.with_stored_bounds(records, errors.as_deref()).map_err(unsound)
    }

    fn step_vertices(&self) -> Result<StepVertices<'a>, DecodeError> {
        let base = self.summary.base_position_count;
        let firsts = match self.first_vertices()? {
            None => Cow::Borrowed(&[][..]),
            Some(Cow::Borrowed(all)) => all.get(base..).unwrap_or(&[]).into(),
            Some(Cow::Owned(all)) => all.get(base..).unwrap_or(&[]).to_vec().into(),
        };
        Ok(StepVertices {
            vertex_count: self.positions()?.len(),
            base_vertex_count: self.summary.base_vertex_count as u32,
            firsts,
            targets: Cow::Borrowed(&[]),
        })
    }

    /// Checks that a model has the number of steps and groups that the summary gives.
    fn expect_model(&self, model: &impl StripModel, steps_in: SectionKind) -> Result<(), DecodeError> {
        self.expect(steps_in, "steps", model.step_count(), self.summary.step_count)?;
        let group_count = self.summary.group_count.max(1);
        self.expect(SectionKind::STRIP_GROUPS, "groups", model.group_count(), group_count)
    }

    /// The whole mesh with its collapse sequence, validated and copied out of the file. If a file contains
    /// only a stream, this is the part of it that is available.
    ///
    /// The order of the triangles follows the strips if the file has them, otherwise the fans or patterns.
    ///
    /// # Errors
    /// [`DecodeError`] if any part is invalid or inconsistent with the others, or if the steps are not
    /// collapses.
    pub fn refinable_mesh(&self) -> Result<RefinableMesh, DecodeError> {
        let sequence = self.sequence()?;
        Ok(RefinableMesh { mesh: self.mesh()?, sequence })
    }

    /// The whole mesh with its steps, whether they are collapses or not, validated and copied out of the file.
    ///
    /// # Errors
    /// [`DecodeError`] if any part is invalid or inconsistent with the others.
    pub fn steps(&self) -> Result<Steps, DecodeError> {
        Ok(match self.has_collapses() {
            true => Steps::Collapses(self.refinable_mesh()?),
            false => Steps::Fragments(self.fragmented_mesh()?),
        })
    }

    /// The whole mesh, validated and copied out of the file, with its triangles in the order of
    /// [`refinable_mesh`](Self::refinable_mesh). If a file contains only a stream, this is the part of it
    /// that is available.
    ///
    /// # Errors
    /// [`DecodeError`] if any part is invalid or inconsistent with the others.
    pub fn mesh(&self) -> Result<IndexedMesh, DecodeError> {
        if let Some(steps) = self.mesh_of_stream()? {
            return Ok(steps.mesh().clone());
        }
        let mut mesh = IndexedMesh {
            positions: self.positions()?.into_owned(),
            origin: self.origin()?,
            exact_positions: Vec::new(),
            triangles: Vec::new(),
            layers: self.layers()?,
            triangle_layers: Vec::new(),
            groups: self.groups()?,
            appearance: self.appearance()?,
        };
        let kind = match self.strips() {
            Some(strips) => {
                self.append_strips(&strips?, &mut mesh)?;
                SectionKind::STRIP_INDICES
            }
            None if !self.has(SectionKind::TRIANGLES) && self.has(SectionKind::FAN_ENTRIES) => {
                self.append_full(&self.read_fans()?, SectionKind::FAN_ENTRIES, &mut mesh)?;
                SectionKind::FAN_ENTRIES
            }
            None if !self.has(SectionKind::TRIANGLES) && self.has_patterns() => {
                self.append_full(self.read_patterns()?, SectionKind::PATTERN_RECORDS, &mut mesh)?;
                SectionKind::PATTERN_RECORDS
            }
            None => {
                mesh.triangles = self.container.numbers(SectionKind::TRIANGLES)?.into_owned();
                SectionKind::TRIANGLES
            }
        };
        self.expect(kind, "triangles", mesh.triangle_count(), self.summary.triangle_count)?;
        mesh.check()?;
        self.read_triangle_layers(&mut mesh)?;
        Ok(mesh)
    }

    /// Extracts one level as a separate mesh, from the collapses in the file if there are any, else from its first
    /// model.
    ///
    /// # Errors
    /// [`DecodeError`] if the file has neither or no such level, or if any part is invalid.
    pub fn level(&self, split_count: usize) -> Result<IndexedMesh, DecodeError> {
        if let Some(steps) = self.mesh_of_stream()? {
            return read_stream::level(steps, split_count);
        }
        let step_count = self.summary.step_count;
        if split_count > step_count {
            return Err(DecodeError::SplitCount { split_count, step_count });
        }
        if self.has_collapses() {
            // Checking the records of a model would take much longer.
            return Ok(replay(&self.refinable_mesh()?, split_count));
        }
        if let Some(model) = self.fans() {
            return self.moved(&model?, split_count);
        }
        let missing = DecodeError::SectionCount { kind: SectionKind::STRIP_INDICES, found: 0 };
        if !self.has_patterns() {
            return Err(missing);
        }
        self.moved(self.read_patterns()?, split_count)
    }

    fn moved<M: StoredModel>(&self, model: &M, split_count: usize) -> Result<IndexedMesh, DecodeError> {
        let mut state = model.new_state();
        model.move_to(&mut state, split_count);
        self.level_of(model, &state)
    }

    /// Extracts the level that an instance of one of the file's models shows; for callers who keep the
    /// model and its state.
    ///
    /// # Errors
    /// [`DecodeError`] if any part is invalid, or if the model does not belong to the file.
    pub fn level_of<M: StoredModel>(&self, model: &M, state: &M::State) -> Result<IndexedMesh, DecodeError> {
        let positions = self.positions()?;
        let vertex_count = model.vertex_count_at(model.split_count(state));
        let Some(level_positions) = positions.get(..vertex_count) else {
            let (kind, what) = (SectionKind::POSITIONS, "vertices");
            let (found, expected) = (positions.len() as u64, vertex_count as u64);
            return Err(DecodeError::Count { kind, what, found, expected });
        };
        let mut level = IndexedMesh {
            positions: level_positions.to_vec(),
            origin: self.origin()?,
            exact_positions: Vec::new(),
            triangles: Vec::new(),
            layers: self.layers_of_first(vertex_count)?,
            triangle_layers: Vec::new(),
            groups: self.groups()?,
            appearance: self.appearance()?,
        };
        let group_count = level.groups.len().max(1);
        self.expect(SectionKind::GROUPS, "groups", group_count, model.group_count())?;
        for group in 0..group_count {
            let first = level.triangles.len();
            model.group_triangles_into(state, group, &mut level.triangles);
            if let Some(group) = level.groups.get_mut(group) {
                (group.first, group.count) = (first as u32, (level.triangles.len() - first) as u32);
            }
        }
        level.check()?;
        self.add_triangle_layers(&mut level, model.split_count(state))?;
        Ok(level)
    }

    /// Appends the triangles of the full mesh's strips and checks that each group has as many as it should.
    fn append_strips(&self, strips: &StripSet, mesh: &mut IndexedMesh) -> Result<(), DecodeError> {
        for group in 0..strips.group_count() {
            let first = mesh.triangles.len();
            for strip in strips.group_strips(group) {
                mesh.triangles.extend(strip_triangles(strips.strip(strip)));
            }
            self.end_group(SectionKind::STRIP_GROUPS, group, first, mesh)?;
        }
        Ok(())
    }

    /// Appends the triangles of a model's full level, like [`append_strips`](Self::append_strips); `kind`
    /// is the section used in errors.
    fn append_full<M: StoredModel>(
        &self,
        model: &M,
        kind: SectionKind,
        mesh: &mut IndexedMesh,
    ) -> Result<(), DecodeError> {
        let full = model.new_state();
        for group in 0..model.group_count() {
            let first = mesh.triangles.len();
            model.group_triangles_into(&full, group, &mut mesh.triangles);
            self.end_group(kind, group, first, mesh)?;
        }
        Ok(())
    }

    /// Ends a group at the last triangle added; its first triangle is `first`.
    fn end_group(
        &self,
        kind: SectionKind,
        group: usize,
        first: usize,
        mesh: &mut IndexedMesh,
    ) -> Result<(), DecodeError> {
        let count = mesh.triangles.len() - first;
        if let Some(group) = mesh.groups.get_mut(group) {
            self.expect(kind, "triangles of a group", count, group.count as usize)?;
            group.first = first as u32;
        }
        Ok(())
    }

    fn appearance(&self) -> Result<crate::mesh::Appearance, DecodeError> {
        self.container.find(SectionKind::APPEARANCE)?.map_or(Ok(Default::default()), appearance_from_bytes)
    }

    fn expect(
        &self,
        kind: SectionKind,
        what: &'static str,
        found: usize,
        expected: usize,
    ) -> Result<(), DecodeError> {
        let (found, expected) = (found as u64, expected as u64);
        if found == expected { Ok(()) } else { Err(DecodeError::Count { kind, what, found, expected }) }
    }
}
