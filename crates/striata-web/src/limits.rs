//! What a page is asked to hold at most.
//!
//! A page has 4 GiB at the very most, and a browser that runs out of them ends the page. A stream's head says what the
//! whole will be, so what cannot fit is refused when it has come; the decoder itself allocates no more than the bytes that
//! are there can pay for.

use striata_stream::StreamInfo;

use crate::Failure;

/// Vertices of a stream or a `.striata` file.
const MOST_VERTICES: usize = 8_000_000;

/// Triangles of them.
const MOST_TRIANGLES: usize = 16_000_000;

/// Triangles of a mesh that is simplified here, which takes several times the memory.
const MOST_BUILT_TRIANGLES: usize = 6_000_000;

/// Bytes of a file that is taken whole.
pub(crate) const MOST_FILE_BYTES: usize = 1 << 30;

/// # Errors
/// Where the whole stream would not fit.
pub(crate) fn check_stream(facts: &StreamInfo) -> Result<(), Failure> {
    check_counts(facts.vertex_count, facts.triangle_count)
}

/// # Errors
/// Where a finished model would not fit.
pub(crate) fn check_counts(vertex_count: usize, triangle_count: usize) -> Result<(), Failure> {
    check(vertex_count, MOST_VERTICES, "vertices")?;
    check(triangle_count, MOST_TRIANGLES, "triangles")
}

/// # Errors
/// Where simplifying a mesh would not fit.
pub(crate) fn check_to_build(vertex_count: usize, triangle_count: usize) -> Result<(), Failure> {
    let hint = "`striata encode` makes a stream of it, which takes a page less memory and time";
    let most = MOST_BUILT_TRIANGLES;
    check(triangle_count, most, "triangles")
        .and_then(|()| check(vertex_count, most, "vertices"))
        .map_err(|failure| failure.with_hint(hint))
}

/// # Errors
/// Where a whole file is too long.
pub(crate) fn check_file(byte_count: usize) -> Result<(), Failure> {
    check(byte_count, MOST_FILE_BYTES, "bytes")
}

fn check(found: usize, most: usize, what: &str) -> Result<(), Failure> {
    if found <= most {
        return Ok(());
    }
    Err(Failure::too_large(format!(
        "the model has {found} {what}, more than the {most} that a page can hold"
    )))
}
