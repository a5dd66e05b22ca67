//! Every level of detail of one mesh, uniform or view-dependent, over one vertex buffer.
//!
//! [`Lod`] connects the stages of the library: [`simplify`](crate::simplify) builds the collapse sequence,
//! progressive fans ([`model::fans`](crate::model::fans)) turn any set of refined steps into triangles, and
//! [`view`](crate::view) decides which steps a camera needs. This module is a convenience layer; engines
//! that need more control can use the stages directly.
//!
//! # Example
//! ```
//! use striata::mesh::shapes;
//! use striata::view::Camera;
//! use striata::{Lod, LodOptions, Target};
//!
//! let mesh = shapes::icosphere(4, 1.0);
//! let lod = Lod::build(&mesh, &LodOptions::default())?;
//!
//! let level = lod.level(Target::Triangles(500)); // the same detail everywhere
//! assert!(level.triangle_count() <= 500);
//! // Draw level.indices() over the first level.vertex_count() vertices of lod.mesh().
//!
//! let mut view = lod.view(); // one instance that follows a camera
//! let camera = Camera::new([0.0, 0.0, 3.0], [0.0; 3], [0.0, 1.0, 0.0], 0.577, [1920, 1080])?;
//! view.update(&camera, 1.0);
//! assert!(view.triangle_count() < mesh.triangle_count());
//! // Draw view.indices().
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod level;
mod level_sizes;
mod levels;
mod options;
mod placed_triangles;
mod ranges;
mod strip_level;
mod tables;
mod view;
mod view_set;

pub use level::Level;
pub use level_sizes::LevelSizes;
pub use options::LodOptions;
pub use placed_triangles::PlacedTriangles;
pub use ranges::{IndexRange, LevelRanges};
pub use strip_level::StripLevel;
pub use view::View;
pub use view_set::{InstanceId, PlacementError, ViewSet, ViewSetUpdate};

use std::sync::Arc;

use self::tables::LodTables;
use crate::file::{DecodeError, StriataFile};
use crate::mesh::{CollapseSequence, IndexedMesh, RefinableMesh, replay};
use crate::model::{Fans, LodStrips, ModelError, Mts, Patterns};
use crate::simplify::{
    SimplifyError, Target, build_sequence_with_progress, certify_collapses_in_any_state_with_progress,
};
use crate::{Cancelled, ProgressFn, ignore_progress};

/// Every level of detail of one mesh: the vertices in refinement order, the collapse sequence, and the
/// tables that turn any level or view into triangles.
///
/// A `Lod` is immutable, and its clones share their data. A model is built when it is used for the first time: the fans
/// for the first level or view, the strips for the first [`strip_level`](Self::strip_level);
/// [`level_mesh`](Self::level_mesh) does without any. Memory: the mesh plus about 40 bytes per vertex.
#[derive(Clone, Debug)]
pub struct Lod {
    tables: Arc<LodTables>,
}

impl Lod {
    /// Simplifies a mesh as far as the options allow and keeps every level of detail along the way.
    ///
    /// # Errors
    /// [`SimplifyError`] if the mesh is inconsistent or an option is out of range.
    pub fn build(mesh: &IndexedMesh, options: &LodOptions) -> Result<Self, SimplifyError> {
        Self::build_with_progress(mesh, options, &mut ignore_progress)
    }

    /// Builds the levels like [`build`](Self::build) and reports progress; the callback can cancel.
    ///
    /// # Errors
    /// [`SimplifyError`] under the conditions of [`build`](Self::build), or if the callback cancels.
    pub fn build_with_progress(
        mesh: &IndexedMesh,
        options: &LodOptions,
        progress: &mut ProgressFn<'_>,
    ) -> Result<Self, SimplifyError> {
        let built = build_sequence_with_progress(mesh, &options.sequence, progress)?;
        let refinable = match options.has_guaranteed_errors {
            true => certify_collapses_in_any_state_with_progress(&built.refinable, progress)?,
            false => built.refinable,
        };
        let tables = LodTables::new(refinable, options.has_guaranteed_errors);
        Ok(Self { tables: Arc::new(tables.with_source_vertices(built.source_vertex)) })
    }

    /// Wraps a mesh that already has a collapse sequence, such as a decoded stream; its errors count as
    /// estimates.
    pub fn from_refinable(refinable: RefinableMesh) -> Self {
        Self { tables: Arc::new(LodTables::new(refinable, false)) }
    }

    /// Returns the levels with at least `split_count` vertex splits; the first of them becomes the base mesh.
    /// Counts above the full mesh leave only the full mesh.
    #[must_use]
    pub fn without_levels_below(&self, split_count: usize) -> Self {
        let first = split_count.min(self.step_count());
        let refinable = self.tables.refinable().clone().without_levels_below(first);
        let tables = LodTables::new(refinable, self.has_guaranteed_errors());
        Self { tables: Arc::new(tables.with_source_vertices(self.source_vertices().to_vec())) }
    }

    /// Wraps a mesh whose errors are guaranteed bounds, as computed by
    /// [`certify_collapses_in_any_state`](crate::simplify::certify_collapses_in_any_state).
    pub fn from_certified(refinable: RefinableMesh) -> Self {
        Self { tables: Arc::new(LodTables::new(refinable, true)) }
    }

    /// Builds the fans now, which the first level or view would do otherwise. Reports progress; the callback can cancel.
    ///
    /// # Errors
    /// [`Cancelled`] if the callback cancels.
    pub fn prepare_with_progress(&self, progress: &mut ProgressFn<'_>) -> Result<(), Cancelled> {
        self.tables.prepare_fans(progress)
    }

    /// Reads the levels from a `.striata` file.
    ///
    /// The fans are read from the file if it contains them.
    ///
    /// # Errors
    /// [`DecodeError`] if the file is damaged, or [`DecodeError::NoCollapses`] if it was made by vertex
    /// removals instead of collapses.
    pub fn from_file(file: &StriataFile<'_>) -> Result<Self, DecodeError> {
        Ok(Self { tables: Arc::new(LodTables::from_file(file)?) })
    }

    /// Takes over LodStrips from a file or another stripifier, instead of those that [`strips`](Self::strips) would
    /// build; without effect if that has been called before.
    ///
    /// # Errors
    /// [`ModelError`] if they do not belong to this mesh.
    pub fn with_strips(self, strips: LodStrips<'static>) -> Result<Self, ModelError> {
        self.tables.set_strips(strips)?;
        Ok(self)
    }

    /// Encodes the mesh, the sequence, the fans and the models that were used as a `.striata` file, which
    /// [`StriataFile::parse`] reads.
    ///
    /// # Errors
    /// [`EncodeError`](crate::file::EncodeError) if a part is too large for the format.
    pub fn to_striata(
        &self,
        options: &crate::file::WriteOptions,
    ) -> Result<Vec<u8>, crate::file::EncodeError> {
        self.tables.to_striata(options)
    }

    /// The full mesh, with its vertices in refinement order: every level uses a prefix of them.
    pub fn mesh(&self) -> &IndexedMesh {
        &self.tables.refinable().mesh
    }

    /// Positions of all vertices, in refinement order.
    pub fn positions(&self) -> &[[f32; 3]] {
        &self.mesh().positions
    }

    /// The vertex of the input that each vertex of [`mesh`](Self::mesh) came from, so that a caller can put vertex
    /// buffers of its own into refinement order. Equal vertices of the input are one vertex, and come from the first.
    ///
    /// Empty if the levels were read from a file or a stream, which do not know the input.
    pub fn source_vertices(&self) -> &[u32] {
        self.tables.source_vertices()
    }

    /// The sequence of collapses, with the error of each step.
    pub fn sequence(&self) -> &CollapseSequence {
        &self.tables.refinable().sequence
    }

    /// Number of vertex splits from the base mesh to the full mesh.
    pub fn step_count(&self) -> usize {
        self.sequence().step_count()
    }

    /// Whether errors are guaranteed bounds that hold at every point of the original surface, rather than
    /// estimates.
    pub fn has_guaranteed_errors(&self) -> bool {
        self.tables.has_guaranteed_errors()
    }

    /// Returns the most detailed uniform level that does not exceed the target.
    ///
    /// A target below the base mesh gives the base mesh; a target above the full mesh gives the full mesh.
    /// Cost: linear in the number of triangles of the level.
    pub fn level(&self, target: Target) -> Level {
        let mut level = Level::empty(Arc::clone(&self.tables));
        level.move_to(target);
        level
    }

    /// Returns an instance of triangle strips at the most detailed level that does not exceed the target; it moves to
    /// other levels by editing its strips.
    ///
    /// # Errors
    /// Those of [`strips`](Self::strips).
    pub fn strip_level(&self, target: Target) -> Result<StripLevel, ModelError> {
        let mut level = StripLevel::full(Arc::clone(&self.tables))?;
        level.move_to(target);
        Ok(level)
    }

    /// Strips that are good strips at every level \[RCRG06\]: at most about 1.45 indices for each triangle, down to very
    /// coarse levels.
    ///
    /// Built by the fast stripifier on first use, unless [`with_strips`](Self::with_strips) took over others.
    ///
    /// # Errors
    /// [`ModelError::TooMany`] if the mesh is too large for the model.
    pub fn strips(&self) -> Result<&LodStrips<'static>, ModelError> {
        self.tables.strips()
    }

    /// Multiresolution triangle strips \[BRR02\], built on first use.
    ///
    /// # Errors
    /// [`ModelError::TooMany`] if the mesh is too large for the model.
    pub fn mts(&self) -> Result<&Mts<'static>, ModelError> {
        self.tables.mts()
    }

    /// Progressive fans \[Cor01\], on which levels and views are built; built on first use unless read from a file.
    pub fn fans(&self) -> &Fans {
        self.tables.fans()
    }

    /// Patterns of the collapses \[KG98\], with bounds for views; built on first use.
    ///
    /// # Errors
    /// [`ModelError::TooMany`] if the mesh is too large for the model.
    pub fn patterns(&self) -> Result<&Patterns, ModelError> {
        self.tables.patterns()
    }

    /// Copies the level that [`level`](Self::level) selects into a separate mesh for export, with only the vertices that
    /// its triangles use and all of their attributes.
    pub fn level_mesh(&self, target: Target) -> IndexedMesh {
        let refinable = self.tables.refinable();
        let (split_count, _) = target.resolve(&refinable.sequence);
        replay(refinable, split_count).without_unused_vertices()
    }

    /// Creates an instance that follows a camera. It shows the base mesh until its first update; any number
    /// of instances can share one `Lod`.
    pub fn view(&self) -> View {
        View::new(Arc::clone(&self.tables))
    }
}

#[cfg(test)]
mod tests;
