//! A paged file as a source of levels; only the pages that a level needs are read.

use striata::levels::{FoundLevel, Levels, LevelsFacts};
use striata::mesh::{Bounds, IndexedMesh, replay};
use striata::simplify::{StopReason, Target};
use striata::view::{DetailBox, ScreenError};

use crate::{PagedCut, PagedError, PagedFile, ShownPages, ViewCut};

impl PagedFile {
    /// Returns the pages and steps from which the last level of [`Levels`] was made.
    pub fn shown_pages(&self) -> ShownPages {
        self.levels.shown
    }

    fn note_shown(&mut self, pages: impl Iterator<Item = u32>, step_count: usize) {
        let mut is_shown = vec![false; self.reader().page_count() as usize];
        pages.for_each(|page| is_shown[page as usize] = true);
        let page_count = is_shown.into_iter().filter(|&is_shown| is_shown).count();
        self.levels.shown = ShownPages { page_count, step_count };
    }

    /// Describes a level of varying detail.
    fn found(&mut self, view: ViewCut) -> FoundLevel<IndexedMesh> {
        let ViewCut { cut, relaxation, is_within_limit } = view;
        let PagedCut { mesh, refined_count, error, page_of_vertex, step_count, .. } = cut;
        self.note_shown(page_of_vertex.into_iter(), step_count);
        let stop_reason = if is_within_limit { StopReason::TargetReached } else { StopReason::BaseReached };
        let level = FoundLevel::of_mesh(mesh, refined_count, error, stop_reason);
        FoundLevel { relaxation: f64::from(relaxation), ..level }
    }
}

impl Levels for PagedFile {
    type Shape = IndexedMesh;
    type Error = PagedError;

    fn facts(&self) -> LevelsFacts {
        let metadata = self.metadata();
        LevelsFacts {
            vertex_count: metadata.vertex_count as usize,
            triangle_count: metadata.triangle_count as usize,
            // How many steps the pages have is not known before they are read.
            step_count: metadata.position_count as usize,
            has_guaranteed_errors: false,
            origin: metadata.origin,
        }
    }

    fn bounds(&mut self) -> Result<Option<Bounds>, PagedError> {
        let metadata = self.metadata();
        Ok(Some(Bounds { min: metadata.min, max: metadata.max }))
    }

    fn prepare(&mut self, targets: &[Target]) -> Result<(), PagedError> {
        self.levels.prepared = Some(self.levels_for(targets)?);
        self.levels.targets = targets.to_vec();
        Ok(())
    }

    /// Levels that were not prepared are read for this target alone.
    fn find(&mut self, target: Target) -> Result<FoundLevel<IndexedMesh>, PagedError> {
        let assembled = match self.levels.prepared.take() {
            Some(assembled) if self.levels.targets.contains(&target) => assembled,
            _ => {
                self.levels.targets = vec![target];
                self.levels_for(&[target])?
            }
        };
        let sequence = &assembled.refinable.sequence;
        let (split_count, stop_reason) = target.resolve(sequence);
        let error = sequence.error_at(split_count).max(self.unread_error());
        let level = replay(&assembled.refinable, split_count);
        let corners = level.triangles.as_flattened().iter();
        let pages = corners.map(|&v| assembled.page_of_vertex[v as usize]);
        self.note_shown(pages, sequence.step_count());
        self.levels.prepared = Some(assembled);
        Ok(FoundLevel::of_mesh(level.without_unused_vertices(), split_count, error, stop_reason))
    }

    fn find_for_view(
        &mut self,
        criterion: &ScreenError,
        triangle_limit: Option<usize>,
    ) -> Result<FoundLevel<IndexedMesh>, PagedError> {
        let view = self.level_for_view(criterion, triangle_limit)?;
        Ok(self.found(view))
    }

    fn find_for_box(
        &mut self,
        detail_box: &DetailBox,
        triangle_limit: Option<usize>,
    ) -> Result<Option<FoundLevel<IndexedMesh>>, PagedError> {
        let cut = match triangle_limit {
            Some(limit) if !detail_box.error_outside.is_finite() => self.level_for_box(detail_box, limit)?,
            _ => ViewCut { cut: self.level_for(detail_box)?, relaxation: 1.0, is_within_limit: true },
        };
        Ok(Some(FoundLevel { relaxation: 1.0, ..self.found(cut) }))
    }
}
