//! Upper limits on the models that a page loads.
//!
//! A page has at most 4 GiB of memory, and a browser terminates a page that exceeds it. The header of a
//! stream states its final size, so a stream that cannot fit is rejected as soon as its header has arrived.
//! The decoder itself never allocates more than the bytes received so far justify.

#[cfg(feature = "stream")]
use striata_scene::stream::SceneStreamInfo;
#[cfg(feature = "stream")]
use striata_stream::StreamInfo;

use crate::Failure;

/// Maximum number of vertices of a stream or a `.striata` file.
#[cfg(any(feature = "stream", feature = "files"))]
const MAX_VERTICES: usize = 8_000_000;

/// Maximum number of triangles of a stream or a `.striata` file.
#[cfg(any(feature = "stream", feature = "files"))]
const MAX_TRIANGLES: usize = 16_000_000;

/// Maximum number of triangles of a mesh to simplify, which takes several times as much memory.
#[cfg(feature = "build")]
const MAX_BUILT_TRIANGLES: usize = 6_000_000;

/// Maximum size of a file that is read as a whole, bytes.
#[cfg(any(feature = "stream", feature = "files"))]
const MAX_FILE_BYTES: usize = 1 << 30;

/// Checks that a stream will fit into a page.
///
/// # Errors
/// If the complete stream would not fit.
#[cfg(feature = "stream")]
pub(crate) fn check_stream(facts: &StreamInfo) -> Result<(), Failure> {
    if facts.has_fragments {
        return Err(Failure::unsupported(
            "the steps of the stream are no collapses, so pages cannot show it",
        )
        .with_hint("encode it again without --order and --new-vertices"));
    }
    check_counts(facts.vertex_count, facts.triangle_count)
}

/// Checks that the meshes, the buffer and the images of a scene will fit into a page.
///
/// # Errors
/// If the complete scene would not fit.
#[cfg(feature = "stream")]
pub(crate) fn check_scene(info: &SceneStreamInfo) -> Result<(), Failure> {
    let meshes = || info.meshes.iter().flatten();
    let count = |counts: u64| usize::try_from(counts).unwrap_or(usize::MAX);
    let vertices = meshes().map(|mesh| u64::from(mesh.vertex_count)).sum();
    let triangles = meshes().map(|mesh| u64::from(mesh.triangle_count)).sum();
    check_counts(count(vertices), count(triangles))?;
    let images = info.images.iter().fold(0u64, |sum, image| sum.saturating_add(image.bytes));
    check_file(count(images.saturating_add(info.buffer_bytes)))
}

/// Checks that a complete model will fit into the memory of a page.
///
/// # Errors
/// If it would not fit.
#[cfg(any(feature = "stream", feature = "files"))]
pub(crate) fn check_counts(vertex_count: usize, triangle_count: usize) -> Result<(), Failure> {
    check(vertex_count, MAX_VERTICES, "vertices")?;
    check(triangle_count, MAX_TRIANGLES, "triangles")
}

/// Checks that a mesh can be simplified in a page.
///
/// # Errors
/// If simplifying it would take too much memory.
#[cfg(feature = "build")]
pub(crate) fn check_to_build(vertex_count: usize, triangle_count: usize) -> Result<(), Failure> {
    let hint = "convert it to a stream with `striata encode`, which needs less memory and time";
    let limit = MAX_BUILT_TRIANGLES;
    check(triangle_count, limit, "triangles")
        .and_then(|()| check(vertex_count, limit, "vertices"))
        .map_err(|failure| failure.with_hint(hint))
}

/// Checks the size of a file that is read as a whole.
///
/// # Errors
/// If the file is too large.
#[cfg(any(feature = "stream", feature = "files"))]
pub(crate) fn check_file(byte_count: usize) -> Result<(), Failure> {
    check(byte_count, MAX_FILE_BYTES, "bytes")
}

fn check(found: usize, limit: usize, what: &str) -> Result<(), Failure> {
    if found <= limit {
        return Ok(());
    }
    Err(Failure::too_large(format!("the model has {found} {what}; a page can load at most {limit}")))
}
