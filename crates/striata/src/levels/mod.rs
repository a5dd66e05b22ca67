//! Levels of detail, whatever they come from: one interface to meshes in memory, files, streams, pages and scenes.
//!
//! [`Levels`] is implemented by a built [`Lod`](crate::Lod), by a `.striata` file ([`FileLevels`]), and in other crates by
//! the prefix of a stream (`striata_stream::StreamLevels`), a paged file (`striata_paged::PagedFile`) and a scene
//! (`striata_scene::LodScene`). Programs that draw every frame use the models and views of these sources directly;
//! the trait is for those that export, convert or compare levels.
//!
//! ```
//! use striata::levels::{FoundLevel, Levels};
//! use striata::{Lod, LodOptions, Target, mesh::shapes};
//!
//! /// Works with any source.
//! fn halved<L: Levels>(levels: &mut L) -> Result<FoundLevel<L::Shape>, L::Error> {
//!     let triangle_count = levels.facts().triangle_count;
//!     levels.find(Target::Triangles(triangle_count / 2))
//! }
//!
//! let mut lod = Lod::build(&shapes::icosphere(4, 1.0), &LodOptions::default())?;
//! let Ok(level) = halved(&mut lod);
//! println!("{} triangles, error {:?}", level.shape.triangle_count(), level.error);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod fan_level;
mod file_levels;
mod pattern_levels;

pub use fan_level::fan_level;
pub use file_levels::FileLevels;
pub use pattern_levels::PatternLevels;

use crate::mesh::{Bounds, IndexedMesh, LevelTable};
use crate::simplify::{StopReason, Target};
use crate::view::{DetailBox, ScreenError};

/// Smallest pixel tolerance used with a triangle limit, so that weights stay finite.
pub const LEAST_PIXELS: f32 = 1e-6;

/// Sizes of a mesh or scene at full detail, even if only a part of it has arrived.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct LevelsFacts {
    /// Number of vertices; those of a mesh of a scene count once.
    pub vertex_count: usize,
    /// Number of triangles; those of a mesh of a scene count once for each instance.
    pub triangle_count: usize,
    /// Number of steps from the base to full detail.
    pub step_count: usize,
    /// Whether errors of uniform levels are guaranteed bounds rather than estimates.
    pub has_guaranteed_errors: bool,
    /// Point that positions are relative to, in the units of the input.
    pub origin: [f64; 3],
}

impl LevelsFacts {
    /// Returns the facts of a mesh whose levels are all there.
    pub fn of(mesh: &IndexedMesh, table: &LevelTable, has_guaranteed_errors: bool) -> Self {
        let step_count = table.step_count();
        Self {
            vertex_count: table.vertex_count_at(step_count),
            triangle_count: table.triangle_count_at(step_count),
            step_count,
            has_guaranteed_errors,
            origin: mesh.origin,
        }
    }
}

/// A level that a source found for a target, a view or a box.
#[derive(Clone, Debug, PartialEq)]
pub struct FoundLevel<S> {
    /// The mesh or scene, with only the vertices that its triangles use.
    pub shape: S,
    /// Number of refined steps; 0 for a view of a scene, which does not count them.
    pub split_count: usize,
    /// Number of vertices, counted as in [`LevelsFacts`].
    pub vertex_count: usize,
    /// Number of triangles, counted as in [`LevelsFacts`].
    pub triangle_count: usize,
    /// Largest distance of the full mesh from the level, in its units; of a view of a scene, which allows each object
    /// another error, [`None`].
    pub error: Option<f64>,
    /// Whether the level meets its target, and if not, why.
    pub stop_reason: StopReason,
    /// Factor by which all tolerances of a view were relaxed to respect its triangle limit; else 1.
    pub relaxation: f64,
}

impl FoundLevel<IndexedMesh> {
    /// Describes a level by its mesh; the error is in single precision, as models store it.
    pub fn of_mesh(shape: IndexedMesh, split_count: usize, error: f32, stop_reason: StopReason) -> Self {
        let (vertex_count, triangle_count) = (shape.vertex_count(), shape.triangle_count());
        let error = Some(f64::from(error));
        Self { shape, split_count, vertex_count, triangle_count, error, stop_reason, relaxation: 1.0 }
    }
}

/// A source of levels of detail of one mesh or scene.
///
/// Methods take `&mut self` because sources may read, decode or build what they need at its first use.
pub trait Levels {
    /// A mesh or a scene.
    type Shape;
    /// Why a level cannot be made.
    type Error;

    /// Returns the sizes at full detail.
    fn facts(&self) -> LevelsFacts;

    /// Returns the bounds of the full mesh or scene, relative to its origin; of what has arrived, if the whole is unknown.
    ///
    /// # Errors
    /// If the source is damaged.
    fn bounds(&mut self) -> Result<Option<Bounds>, Self::Error>;

    /// Reads or decodes all that these targets need, at once. Without it, each [`find`](Self::find) does so for itself.
    ///
    /// # Errors
    /// If the source is damaged or cannot be read.
    fn prepare(&mut self, _targets: &[Target]) -> Result<(), Self::Error> {
        Ok(())
    }

    /// Returns the most detailed level that does not exceed the target; for an error, the coarsest level within it.
    ///
    /// A target below the base gives the base, a target above full detail the finest level that there is.
    ///
    /// # Errors
    /// If the source is damaged or cannot be read.
    fn find(&mut self, target: Target) -> Result<FoundLevel<Self::Shape>, Self::Error>;

    /// Returns the coarsest level whose errors are within the tolerances of a view, or, with a triangle limit, the
    /// level that looks best within it. The criterion is relative to the origin.
    ///
    /// # Errors
    /// If the source is damaged or cannot be read.
    fn find_for_view(
        &mut self,
        criterion: &ScreenError,
        triangle_limit: Option<usize>,
    ) -> Result<FoundLevel<Self::Shape>, Self::Error>;

    /// Returns a level with full detail in a box, or [`None`] if the source has no such levels.
    ///
    /// Outside of the box are as few triangles as its error allows; with a triangle limit and an infinite error, as many as
    /// the limit allows.
    ///
    /// # Errors
    /// If the source is damaged or cannot be read.
    fn find_for_box(
        &mut self,
        _detail_box: &DetailBox,
        _triangle_limit: Option<usize>,
    ) -> Result<Option<FoundLevel<Self::Shape>>, Self::Error> {
        Ok(None)
    }
}
