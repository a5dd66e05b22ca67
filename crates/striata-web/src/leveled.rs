//! The interface that a model requires from what decodes or builds it.

use striata::Target;
use striata::mesh::Bounds;

use crate::Failure;
use crate::shown_level::ShownLevel;
use crate::vertices::Vertices;
use crate::view::View;

/// A mesh that can show its levels. Not `Debug`: through a trait object, code for all parts of the decoder
/// would stay in the wasm.
pub(crate) trait Leveled {
    /// Appends bytes of a stream.
    ///
    /// # Errors
    /// If they are not a valid stream, or the mesh is not decoded from one.
    fn push(&mut self, _bytes: &[u8]) -> Result<(), Failure> {
        Err(Failure::unsupported("cannot push bytes: the model was read from a file"))
    }

    /// Ends a stream: decodes what an incomplete last chunk contains.
    ///
    /// # Errors
    /// If the base mesh is incomplete.
    fn finish(&mut self) -> Result<(), Failure> {
        Ok(())
    }

    /// Prepares views of what has been decoded since the last call.
    fn grow(&mut self) {}

    /// Makes everything that has arrived available.
    fn reveal(&mut self) {}

    /// Whether the whole mesh has arrived.
    fn is_complete(&self) -> bool;

    /// Number of available vertices.
    fn vertex_count(&self) -> usize;

    /// Triangle count of the finest available level.
    fn triangle_count(&self) -> usize;

    /// Number of vertices and triangles of the full mesh; 0 while they are unknown.
    fn full_counts(&self) -> (usize, usize);

    /// Number of vertex splits of the full mesh; 0 while it is unknown.
    fn step_count(&self) -> usize;

    /// Length of the stream, bytes; 0 while it is unknown, and without a stream.
    fn stream_bytes(&self) -> u64 {
        0
    }

    /// Number of triangle groups, at least one.
    fn group_count(&self) -> usize;

    /// Bounds of the available vertices.
    fn bounds(&self) -> Option<Bounds>;

    /// Whether the mesh is a terrain whose place on the Earth is known.
    fn is_georeferenced(&self) -> bool {
        false
    }

    /// Vertices from index `first` on.
    fn vertices(&self, first: usize) -> Vertices;

    /// Normals of all available vertices, computed from the finest available level.
    fn smooth_normals(&self) -> Vec<[f32; 3]>;

    /// Number of vertex splits of the level that a request selects among the available ones.
    fn split_count_for(&self, target: Target) -> usize;

    /// Number of triangles of a level.
    fn triangle_count_at(&self, split_count: usize) -> usize;

    /// Error of a level, mesh units.
    fn error_at(&self, split_count: usize) -> f32;

    /// Number of splits before the one that adds a vertex; [`None`] if it is in the base mesh.
    fn step_of(&self, vertex: u32) -> Option<usize>;

    /// Shows the requested level.
    fn show(&mut self, target: Target) -> ShownLevel;

    /// Refines for a camera; also returns whether repeating the request would give the same result.
    ///
    /// # Errors
    /// If such a camera sees nothing.
    fn show_view(&mut self, view: &View) -> Result<(ShownLevel, bool), Failure>;

    /// Returns the fan number of each shown triangle, whose order may change.
    fn color_fans(&mut self, shown: &mut ShownLevel) -> Vec<u32>;
}
