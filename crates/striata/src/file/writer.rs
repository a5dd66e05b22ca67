//! Writing of files: all sections are laid out first, then everything is written in one pass.

use std::borrow::Cow;
use std::io::Write;

use super::container::{
    ENTRY_BYTES, HEADER_BYTES, MAGIC, MAX_SECTIONS, REQUIRED, VERSION, header_checksum, padding,
};
use super::mesh_sections::{appearance_to_bytes, groups_to_bytes, layer_to_bytes, metadata_to_bytes};
use super::{EncodeError, GUARANTEED_ERRORS, SectionKind, StoredStream, Summary};
use crate::mesh::{
    CollapseSequence, FragmentedMesh, IndexedMesh, LevelTable, RefinableMesh, gather_layers,
    sorted_triangle_order,
};
use crate::model::{
    Fans, LodModel, LodStrips, ModelKind, Mts, PackedVertices, Patterns, StoredModel, StoredStrips,
};

/// A model to be stored along with the mesh.
#[derive(Clone, Copy, Debug)]
#[non_exhaustive]
pub enum FileModel<'m> {
    /// Strips that are edited in place.
    LodStrips(&'m LodStrips<'m>),
    /// Strips that are rebuilt when they change.
    Mts(&'m Mts<'m>),
    /// Fans of each vertex with the bounds of their steps, for uniform and view-dependent levels.
    Fans(&'m Fans),
    /// Patterns with the bounds of their fragments, for uniform and view-dependent levels.
    Patterns(&'m Patterns),
    /// Progressive stream of the mesh, whose vertices must be in the stream's order
    /// (`EncodedStream::reorder` of the crate `striata-stream`). If it is the only model, the file contains
    /// nothing else, and mesh and levels are decoded from the stream.
    Progressive(StoredStream<'m>),
}

impl<'m> FileModel<'m> {
    /// Kind of the model.
    pub fn kind(&self) -> ModelKind {
        match self {
            Self::LodStrips(_) => ModelKind::LodStrips,
            Self::Mts(_) => ModelKind::Mts,
            Self::Fans(_) => ModelKind::Fans,
            Self::Patterns(_) => ModelKind::Patterns,
            Self::Progressive(_) => ModelKind::Progressive,
        }
    }

    /// The strips of the full mesh that the model uses, if any.
    fn strips(&self) -> Option<&'m StoredStrips<'m>> {
        match *self {
            Self::LodStrips(model) => Some(model.full_strips()),
            Self::Mts(model) => Some(&model.parts().strips),
            Self::Fans(_) | Self::Patterns(_) | Self::Progressive(_) => None,
        }
    }

    /// Sections of the model, without the strips.
    fn sections(&self) -> Vec<(SectionKind, Cow<'m, [u8]>)> {
        match *self {
            Self::LodStrips(model) => lod_strips_sections(model),
            Self::Mts(model) => {
                let parts = model.parts();
                vec![
                    (SectionKind::LIFETIMES, parts.lifetimes[..].into()),
                    (SectionKind::CHANGE_HEADS, parts.heads[..].into()),
                    (SectionKind::CHANGES, parts.arena[..].into()),
                ]
            }
            Self::Fans(fans) => {
                let parts = fans.parts();
                vec![
                    (SectionKind::FAN_ENTRIES, parts.entries.into()),
                    (SectionKind::FAN_BLOCKS, bytes_of(parts.blocks)),
                    (SectionKind::FAN_STARTS, bytes_of(parts.starts)),
                    (SectionKind::FAN_WAITS, bytes_of(parts.waits)),
                    (SectionKind::FAN_FAR_TARGETS, bytes_of(parts.far)),
                    (SectionKind::FAN_ORPHANS, bytes_of(parts.orphans)),
                    (SectionKind::FAN_BOUNDS, fans.stored_bounds().into()),
                ]
            }
            Self::Patterns(patterns) => {
                let parts = patterns.parts();
                vec![
                    (SectionKind::PATTERN_HEADER, bytes_of(&parts.header).into_owned().into()),
                    (SectionKind::PATTERN_RULES, parts.rules.into()),
                    (SectionKind::PATTERN_SHARINGS, parts.sharings.into()),
                    (SectionKind::PATTERN_KINDS, parts.kinds.into()),
                    (SectionKind::PATTERN_BLOCKS, bytes_of(parts.blocks)),
                    (SectionKind::PATTERN_RECORDS, parts.records.into()),
                    (SectionKind::PATTERN_BASE, bytes_of(&parts.base).into_owned().into()),
                    (SectionKind::PATTERN_BOUNDS, parts.bounds.into()),
                ]
            }
            // The stream is the last section, so that a truncated file still contains its beginning.
            Self::Progressive(_) => Vec::new(),
        }
    }
}

/// Sections of LodStrips, without the strips of the full mesh.
fn lod_strips_sections<'m>(model: &'m LodStrips<'m>) -> Vec<(SectionKind, Cow<'m, [u8]>)> {
    let [heads, arena] = model.records();
    let mut sections = vec![(SectionKind::RECORD_HEADS, heads.into()), (SectionKind::RECORDS, arena.into())];
    let (stages, walks) = model.later_stages();
    if !stages.is_empty() {
        let rows = stages.iter().flat_map(|stage| {
            std::iter::once(stage.split_count as u32).chain(stage.strip_counts.iter().copied())
        });
        let table: Vec<u32> = rows.collect();
        sections.push((SectionKind::STAGES, bytes_of(&table).into_owned().into()));
        sections.push((SectionKind::STAGE_WALKS, walks.into()));
    }
    sections
}

fn bytes_of<T: bytemuck::NoUninit>(numbers: &[T]) -> Cow<'_, [u8]> {
    bytemuck::must_cast_slice(numbers).into()
}

/// Options of [`write_striata`].
#[derive(Clone, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct WriteOptions {
    /// Key-value texts about the file, such as `creator` or `source`; default none.
    pub metadata: Vec<(String, String)>,
}

impl WriteOptions {
    /// Adds an entry to [`WriteOptions::metadata`].
    pub fn with_metadata(mut self, key: impl Into<String>, value: impl Into<String>) -> Self {
        self.metadata.push((key.into(), value.into()));
        self
    }

    /// Records whether errors are guaranteed bounds or estimates, unless the metadata say so already: see
    /// [`StriataFile::has_guaranteed_errors`](super::StriataFile::has_guaranteed_errors).
    pub fn with_guaranteed_errors(self, has_guaranteed_errors: bool) -> Self {
        let (key, value) = GUARANTEED_ERRORS;
        if self.metadata.iter().any(|(k, _)| k == key) {
            return self;
        }
        self.with_metadata(key, if has_guaranteed_errors { value } else { "estimated" })
    }
}

/// A section that has no offset in the file yet.
#[derive(Clone, Debug)]
pub struct Section<'m> {
    /// Kind of the section.
    pub kind: SectionKind,
    /// Whether a reader that does not know the kind must reject the file.
    pub is_required: bool,
    /// Contents of the section.
    pub bytes: Cow<'m, [u8]>,
}

/// Writes a mesh, its collapse sequence and its models as a `.striata` file.
///
/// A given input yields identical bytes on every machine. The triangles are stored only once. With models
/// that use strips, they are stored as strips, which all these models share, and are read back in the order
/// of the strips. With fans only, they are read back from the fans; with a stream only, from the stream, at
/// its precision. A stream is the last section, so that a truncated file still contains its beginning.
///
/// # Errors
/// [`EncodeError`] if the mesh is inconsistent, a model was built from a different mesh, or writing fails.
pub fn write_striata(
    refinable: &RefinableMesh,
    models: &[FileModel<'_>],
    options: &WriteOptions,
    out: &mut dyn Write,
) -> Result<(), EncodeError> {
    let RefinableMesh { mesh, sequence } = refinable;
    let source = FileSource { mesh, levels: sequence.levels(), collapses: Some(sequence) };
    write_sections(&lay_out(source, models, options)?, out)
}

/// Writes a mesh with fragments and its models as a `.striata` file: fans and patterns, or a stream of fragments and
/// nothing else. The other models need collapses.
///
/// A given input yields identical bytes on every machine. The triangles are read back in the order of the fans
/// or, without these, of the patterns. The file keeps the errors of the levels; the errors of individual floors
/// are only kept as part of the bounds of the models.
///
/// # Errors
/// [`EncodeError`] under the conditions of [`write_striata`], or if a model needs collapses, or there is none.
pub fn write_fragments(
    fragmented: &FragmentedMesh,
    models: &[FileModel<'_>],
    options: &WriteOptions,
    out: &mut dyn Write,
) -> Result<(), EncodeError> {
    let is_alone = models.len() == 1;
    let is_general = |model: &&FileModel<'_>| match model {
        FileModel::Fans(_) | FileModel::Patterns(_) => true,
        FileModel::Progressive(_) => is_alone,
        _ => false,
    };
    if let Some(model) = models.iter().find(|model| !is_general(model)) {
        return Err(EncodeError::NeedsCollapses { model: model.kind() });
    }
    if models.is_empty() {
        return Err(EncodeError::NoModel);
    }
    let levels = fragmented.fragments.levels();
    let source = FileSource { mesh: &fragmented.mesh, levels, collapses: None };
    write_sections(&lay_out(source, models, options)?, out)
}

/// The contents of a file other than models.
#[derive(Clone, Copy)]
struct FileSource<'m> {
    mesh: &'m IndexedMesh,
    levels: &'m LevelTable,
    /// `None` if vertices were removed in other ways than by collapses.
    collapses: Option<&'m CollapseSequence>,
}

/// Writes a file of the given sections, in their order; [`Container`](super::Container) reads it.
///
/// # Errors
/// [`EncodeError`] if there are too many sections, or writing fails.
pub fn write_sections(sections: &[Section<'_>], out: &mut dyn Write) -> Result<(), EncodeError> {
    let (found, limit) = (sections.len(), MAX_SECTIONS);
    if found > limit {
        return Err(EncodeError::TooManySections { found, limit });
    }
    let mut head = vec![0; HEADER_BYTES];
    let mut end = HEADER_BYTES + ENTRY_BYTES * sections.len();
    for section in sections {
        let offset = padding(end).end;
        head.extend(section.kind.0);
        let flags = if section.is_required { REQUIRED } else { 0 };
        head.extend(flags.to_le_bytes());
        head.extend((offset as u64).to_le_bytes());
        head.extend((section.bytes.len() as u64).to_le_bytes());
        head.extend(crc32fast::hash(&section.bytes).to_le_bytes());
        head.extend([0; 4]);
        end = offset + section.bytes.len();
    }
    head[..8].copy_from_slice(&MAGIC);
    head[8..12].copy_from_slice(&VERSION.to_le_bytes());
    head[12..16].copy_from_slice(&(sections.len() as u32).to_le_bytes());
    head[16..24].copy_from_slice(&(end as u64).to_le_bytes());
    let checksum = header_checksum(&head);
    head[24..28].copy_from_slice(&checksum.to_le_bytes());
    out.write_all(&head)?;
    let mut end = head.len();
    for section in sections {
        let padding = padding(end);
        out.write_all(&[0; 64][..padding.len()])?;
        out.write_all(&section.bytes)?;
        end = padding.end + section.bytes.len();
    }
    Ok(())
}

/// Encodes a `.striata` file in memory, like [`write_striata`].
///
/// # Errors
/// [`EncodeError`] under the conditions of [`write_striata`].
pub fn to_striata(
    refinable: &RefinableMesh,
    models: &[FileModel<'_>],
    options: &WriteOptions,
) -> Result<Vec<u8>, EncodeError> {
    let mut out = Vec::new();
    write_striata(refinable, models, options, &mut out)?;
    Ok(out)
}

fn lay_out<'m>(
    source: FileSource<'m>,
    models: &[FileModel<'m>],
    options: &WriteOptions,
) -> Result<Vec<Section<'m>>, EncodeError> {
    let FileSource { mesh, levels, collapses } = source;
    mesh.check()?;
    for (i, model) in models.iter().enumerate() {
        check_model(model, &models[..i], source)?;
    }
    let mut sections = Vec::new();
    let mut add =
        |kind, is_required, bytes: Cow<'m, [u8]>| sections.push(Section { kind, is_required, bytes });
    add(SectionKind::SUMMARY, true, Summary::of_levels(mesh, levels).to_bytes().into());
    if !options.metadata.is_empty() {
        add(SectionKind::METADATA, false, metadata_to_bytes(&options.metadata)?.into());
    }
    if mesh.origin != [0.0; 3] {
        add(SectionKind::ORIGIN, true, bytemuck::must_cast_slice(&mesh.origin).to_vec().into());
    }
    if let [FileModel::Progressive(stream)] = models {
        add(SectionKind::STREAM, true, stream.bytes.into());
        return Ok(sections);
    }
    add(SectionKind::GROUPS, true, groups_to_bytes(&mesh.groups)?.into());
    if !levels.positions().is_identity() {
        let firsts = levels.positions().first_vertices();
        add(SectionKind::FIRST_VERTICES, true, bytemuck::must_cast_slice(firsts).into());
    }
    if let Some(sequence) = collapses {
        let targets = PackedVertices::pack(sequence.targets(), mesh.vertex_count());
        add(SectionKind::TARGETS, true, targets.bytes().to_vec().into());
    }
    add(SectionKind::ERRORS, true, bytemuck::must_cast_slice(levels.errors()).into());
    if let Some(sequence) = collapses {
        add(SectionKind::REMOVED, true, sequence.removed_triangle_counts().into());
    }
    add(SectionKind::POSITIONS, true, bytemuck::must_cast_slice(&mesh.positions).into());
    for layer in &mesh.layers {
        add(SectionKind::LAYER, true, layer_to_bytes(layer)?.into());
    }
    if !mesh.triangle_layers.is_empty() {
        let order = sorted_triangle_order(mesh);
        for layer in gather_layers(&mesh.triangle_layers, &order) {
            add(SectionKind::TRIANGLE_LAYER, false, layer_to_bytes(&layer)?.into());
        }
    }
    if let Some(strips) = models.iter().find_map(FileModel::strips) {
        add(SectionKind::STRIP_GROUPS, false, bytes_of(&strips.group_offsets));
        add(SectionKind::STRIP_LENGTHS, false, strips.lengths[..].into());
        add(SectionKind::STRIP_INDICES, false, strips.indices.bytes().into());
    }
    for model in models {
        model.sections().into_iter().for_each(|(kind, bytes)| add(kind, false, bytes));
    }
    if models.is_empty() {
        add(SectionKind::TRIANGLES, false, bytemuck::must_cast_slice(&mesh.triangles).into());
    }
    // Images are large and needed last.
    if !mesh.appearance.is_empty() {
        add(SectionKind::APPEARANCE, true, appearance_to_bytes(&mesh.appearance)?.into());
    }
    for model in models {
        if let FileModel::Progressive(stream) = model {
            add(SectionKind::STREAM, false, stream.bytes.into());
        }
    }
    Ok(sections)
}

/// Checks that a model can be stored in a file after other models.
///
/// # Errors
/// [`EncodeError`] if the model was built from a different mesh, repeats an earlier kind, or uses other
/// strips.
fn check_model(
    model: &FileModel<'_>,
    before: &[FileModel<'_>],
    source: FileSource<'_>,
) -> Result<(), EncodeError> {
    let kind = model.kind();
    let (triangle_count, base_triangle_count) =
        (source.mesh.triangle_count(), source.levels.triangle_count_at(0));
    match model {
        FileModel::LodStrips(model) => check_counts(kind, *model, source)?,
        FileModel::Mts(model) => check_counts(kind, *model, source)?,
        FileModel::Fans(fans) => {
            check_counts(kind, *fans, source)?;
            let triangle_count_at =
                |split_count| fans.draw_counts(&fans.level_at(split_count)).index_count / 3;
            let step_count = fans.step_count();
            expect(kind, "bounds", fans.bounded_step_count(), step_count)?;
            expect(kind, "triangles", triangle_count_at(step_count), triangle_count)?;
            expect(kind, "triangles of the base", triangle_count_at(0), base_triangle_count)?;
        }
        FileModel::Patterns(patterns) => {
            check_counts(kind, *patterns, source)?;
            let counts = patterns.triangle_counts();
            expect(kind, "bounds", patterns.bounded_step_count(), patterns.step_count())?;
            expect(kind, "triangles", counts[counts.len() - 1] as usize, triangle_count)?;
            expect(kind, "triangles of the base", counts[0] as usize, base_triangle_count)?;
            patterns.check_size().map_err(|reason| EncodeError::Unstorable { model: kind, reason })?;
        }
        FileModel::Progressive(stream) => {
            expect(kind, "vertices", stream.vertex_count, source.mesh.vertex_count())?;
            expect(kind, "triangles", stream.triangle_count, triangle_count)?;
            expect(kind, "steps", stream.step_count, source.levels.step_count())?;
            expect(kind, "groups", stream.group_count, source.mesh.groups.len())?;
        }
    }
    if before.iter().any(|other| other.kind() == kind) {
        return Err(EncodeError::RepeatedModel { model: kind });
    }
    let first = before.iter().find_map(FileModel::strips);
    if first.is_some() && model.strips().is_some_and(|strips| first != Some(strips)) {
        return Err(EncodeError::OtherStrips { model: kind });
    }
    Ok(())
}

fn check_counts(
    kind: ModelKind,
    model: &impl StoredModel,
    source: FileSource<'_>,
) -> Result<(), EncodeError> {
    expect(kind, "vertices", model.vertex_count(), source.mesh.vertex_count())?;
    expect(kind, "steps", model.step_count(), source.levels.step_count())?;
    expect(kind, "groups", model.group_count(), source.mesh.groups.len().max(1))
}

fn expect(model: ModelKind, what: &'static str, found: usize, expected: usize) -> Result<(), EncodeError> {
    if found == expected { Ok(()) } else { Err(EncodeError::Model { model, what, found, expected }) }
}
