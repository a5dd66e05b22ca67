//! Reading of patterns and fragments, including the levels of files that have no collapses.

use super::StriataFile;
use crate::file::{DecodeError, SectionKind};
use crate::mesh::{FragmentedMesh, LevelTable};
use crate::model::patterns::{HEADER_LEN, PatternsParts};
use crate::model::{LodModel, ModelKind, Patterns};

impl StriataFile<'_> {
    /// The patterns and the bounds of their fragments, if the file has them; copied out of the file and
    /// validated once, so that no move can fail.
    pub fn patterns(&self) -> Option<Result<Patterns, DecodeError>> {
        self.has_patterns().then(|| self.read_patterns().cloned())
    }

    /// Whether the file has patterns, even if they cannot be read.
    pub(super) fn has_patterns(&self) -> bool {
        self.has(SectionKind::PATTERN_RECORDS)
    }

    pub(super) fn read_patterns(&self) -> Result<&Patterns, DecodeError> {
        if let Some(checked) = self.patterns.get() {
            return Ok(checked);
        }
        let checked = self.check_patterns()?;
        Ok(self.patterns.get_or_init(|| checked))
    }

    fn check_patterns(&self) -> Result<Patterns, DecodeError> {
        let header = self.container.numbers::<u32>(SectionKind::PATTERN_HEADER)?;
        self.expect(SectionKind::PATTERN_HEADER, "numbers", header.len(), HEADER_LEN)?;
        let parts = PatternsParts {
            header: std::array::from_fn(|i| header[i]),
            rules: self.container.get(SectionKind::PATTERN_RULES)?.into(),
            sharings: self.container.get(SectionKind::PATTERN_SHARINGS)?.into(),
            kinds: self.container.get(SectionKind::PATTERN_KINDS)?,
            blocks: &self.container.numbers(SectionKind::PATTERN_BLOCKS)?,
            records: self.container.get(SectionKind::PATTERN_RECORDS)?,
            base: self.container.numbers(SectionKind::PATTERN_BASE)?.into_owned(),
            bounds: self.container.get(SectionKind::PATTERN_BOUNDS)?,
        };
        let unsound = |reason| DecodeError::Model { model: ModelKind::Patterns, reason };
        let group_count = self.groups()?.len().max(1);
        let triangle_count = self.summary.triangle_count;
        let patterns = Patterns::from_parts(self.step_vertices()?, group_count, triangle_count, parts);
        let patterns = patterns.map_err(unsound)?;
        let kind = SectionKind::PATTERN_RECORDS;
        self.expect(kind, "steps", patterns.step_count(), self.summary.step_count)?;
        Ok(patterns)
    }

    /// The levels with the given triangle counts, which are those of a model.
    pub(super) fn levels_of(&self, triangle_counts: Vec<u32>) -> Result<LevelTable, DecodeError> {
        let base = self.summary.base_position_count;
        let errors = self.errors()?.into_owned();
        let levels = LevelTable::new(self.position_index()?, base, triangle_counts, errors)?;
        let kind = SectionKind::SUMMARY;
        self.expect(kind, "base vertices", self.summary.base_vertex_count, levels.base_vertex_count())?;
        self.expect(kind, "base triangles", self.summary.base_triangle_count, levels.triangle_count_at(0))?;
        Ok(levels)
    }

    /// The whole mesh with its fragments, validated and copied out of the file.
    ///
    /// The fragments come from the patterns if the file has them, otherwise from the collapses or, if the steps
    /// are not collapses, from the fans. The error of a floor is the error of the level without its fragment.
    ///
    /// # Errors
    /// [`DecodeError`] if any part is invalid or inconsistent with the others.
    pub fn fragmented_mesh(&self) -> Result<FragmentedMesh, DecodeError> {
        if let Some(steps) = self.mesh_of_stream()? {
            return Ok(steps.fragments().into_owned());
        }
        let unsound = |model, reason| DecodeError::Model { model, reason };
        let fragments = if self.has_patterns() {
            let fragments = self.read_patterns()?.unpack(self.errors()?.into_owned());
            fragments.map_err(|reason| unsound(ModelKind::Patterns, reason))?
        } else if self.has_collapses() {
            return Ok(FragmentedMesh::from_collapses(&self.refinable_mesh()?));
        } else {
            let fragments = self.read_fans()?.to_fragments(&self.errors()?);
            fragments.map_err(|reason| unsound(ModelKind::Fans, reason))?
        };
        Ok(FragmentedMesh { mesh: self.mesh()?, fragments })
    }
}
