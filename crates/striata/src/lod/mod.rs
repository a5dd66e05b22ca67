//! The front door: every level of one mesh, uniform or for a camera, over one vertex buffer.
//!
//! [`Lod`] puts the stages of the library together: [`simplify`](crate::simplify) makes the sequence of collapses, progressive
//! fans ([`model::fans`](crate::model::fans)) turn any set of its steps into triangles, and [`view`](crate::view) says which
//! steps a camera needs. Nothing here is new; engines that need more control use the stages themselves.
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
mod options;
mod tables;
mod view;

pub use level::Level;
pub use options::LodOptions;
pub use view::View;

use std::sync::Arc;

use self::tables::Tables;
use crate::file::{DecodeError, StriataFile};
use crate::mesh::{CollapseSequence, IndexedMesh, RefinableMesh};
use crate::simplify::{
    SimplifyError, Target, build_sequence_with_progress, certify_collapses_in_any_state_with_progress,
};
use crate::{ProgressFn, ignore_progress};

/// Every level of detail of one mesh: its vertices in refinement order, the collapse sequence, and what turns any level or
/// view into triangles. It never changes, and a clone shares everything with its original.
///
/// Memory: the mesh, and about 40 bytes for each vertex.
#[derive(Clone, Debug)]
pub struct Lod {
    tables: Arc<Tables>,
}

impl Lod {
    /// Simplifies a mesh as far as the options allow and keeps every level on the way.
    ///
    /// # Errors
    /// [`SimplifyError`] if the mesh's parts do not fit together or an option is out of range.
    pub fn build(mesh: &IndexedMesh, options: &LodOptions) -> Result<Self, SimplifyError> {
        Self::build_with_progress(mesh, options, &mut ignore_progress)
    }

    /// Does as [`build`](Self::build) and reports its progress; the callback can cancel.
    ///
    /// # Errors
    /// As [`build`](Self::build), and if the callback cancels.
    pub fn build_with_progress(
        mesh: &IndexedMesh,
        options: &LodOptions,
        progress: &mut ProgressFn<'_>,
    ) -> Result<Self, SimplifyError> {
        let built = build_sequence_with_progress(mesh, &options.sequence, progress)?;
        if !options.has_guaranteed_errors {
            return Ok(Self::from_refinable(built.refinable));
        }
        let certified = certify_collapses_in_any_state_with_progress(&built.refinable, progress)?;
        Ok(Self { tables: Arc::new(Tables::new(certified, true)) })
    }

    /// The levels of a mesh that has a sequence already, with estimated errors. A decoded stream is one such mesh.
    pub fn from_refinable(refinable: RefinableMesh) -> Self {
        Self { tables: Arc::new(Tables::new(refinable, false)) }
    }

    /// The levels of a `.striata` file. Its fans are read if it has some, and built otherwise.
    ///
    /// # Errors
    /// [`DecodeError`] if the file is damaged, or if it was made by removals instead of collapses
    /// ([`DecodeError::NoCollapses`]).
    pub fn from_file(file: &StriataFile<'_>) -> Result<Self, DecodeError> {
        Ok(Self { tables: Arc::new(Tables::from_file(file)?) })
    }

    /// The file that holds these levels: the mesh, the sequence and the fans, as [`StriataFile::parse`] reads it.
    ///
    /// # Errors
    /// [`EncodeError`](crate::file::EncodeError) if a part is too large for the format.
    pub fn to_striata(
        &self,
        options: &crate::file::WriteOptions,
    ) -> Result<Vec<u8>, crate::file::EncodeError> {
        self.tables.to_striata(options)
    }

    /// The full mesh with its vertices in refinement order: every level uses the first few of them.
    pub fn mesh(&self) -> &IndexedMesh {
        &self.tables.refinable().mesh
    }

    /// Positions of all vertices, in refinement order.
    pub fn positions(&self) -> &[[f32; 3]] {
        &self.mesh().positions
    }

    /// The sequence of collapses, with the error of each step.
    pub fn sequence(&self) -> &CollapseSequence {
        &self.tables.refinable().sequence
    }

    /// Vertex splits from the base mesh to the full mesh.
    pub fn step_count(&self) -> usize {
        self.sequence().step_count()
    }

    /// Whether errors are bounds that hold at every point of the original, and not estimates.
    pub fn has_guaranteed_errors(&self) -> bool {
        self.tables.has_guaranteed_errors()
    }

    /// One uniform level: the most detailed one that does not exceed the target. A target below the base mesh gives the base
    /// mesh, one above the full mesh gives the full mesh.
    ///
    /// Cost: linear in the triangles of the level.
    pub fn level(&self, target: Target) -> Level {
        let mut level = Level::empty(Arc::clone(&self.tables));
        level.move_to(target);
        level
    }

    /// A new instance that follows a camera; it shows the base mesh until its first update. Any number of instances share one
    /// `Lod`.
    pub fn view(&self) -> View {
        View::new(Arc::clone(&self.tables))
    }
}

#[cfg(test)]
mod tests;
