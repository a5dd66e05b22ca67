//! `thumbnail`: one small picture, within limits that a server can rely on.

use striata::mesh::IndexedMesh;
use striata::simplify::Target;

use crate::picture::portrait;
use crate::serve::args::ThumbnailArgs;
use striata_command::failure::Failure;
use striata_command::input::Input;
use striata_command::output::{Output, to_stdout};
use striata_command::stream::DecodedStream;

/// Pixels in a row.
pub(super) const WIDTH: usize = 320;
/// Rows.
pub(super) const HEIGHT: usize = 240;
/// More triangles would be smaller than pixels.
const MAX_TRIANGLES: usize = 40_000;
/// Memory that the drawing may take.
#[cfg(unix)]
const MAX_MEMORY_BYTES: u64 = 3 << 30;
/// Seconds of computing that it may take.
#[cfg(unix)]
const MAX_CPU_SECS: u64 = 20;

/// Draws and writes the picture.
///
/// # Errors
/// Where the file cannot be read.
pub fn run(args: &ThumbnailArgs, output: &Output) -> Result<(), Failure> {
    limit_this_process();
    let input = Input::open(&args.input)?;
    let mesh = mesh_of(&input, output)?;
    mesh.check()?;
    let picture = portrait(mesh, [WIDTH, HEIGHT]).to_png();
    to_stdout(&picture.map_err(|error| Failure::internal(format!("a picture: {error}")))?)
}

/// Where the system knows no such limits, whoever waits for the picture ends it.
fn limit_this_process() {
    #[cfg(unix)]
    {
        let _ = rlimit::setrlimit(rlimit::Resource::AS, MAX_MEMORY_BYTES, MAX_MEMORY_BYTES);
        let _ = rlimit::setrlimit(rlimit::Resource::CPU, MAX_CPU_SECS, MAX_CPU_SECS);
    }
}

/// As much of the mesh as a small picture shows: of a stream only its beginning is decoded.
fn mesh_of(input: &Input, output: &Output) -> Result<IndexedMesh, Failure> {
    if !input.has_levels() {
        return input.mesh(output);
    }
    let damaged = |error| input.damaged(&error);
    let file = input.striata()?;
    if let Some(stream) = file.stream() {
        let is_enough = |decoder: &striata_stream::StreamDecoder| decoder.triangles().len() >= MAX_TRIANGLES;
        let decoder = DecodedStream::read(stream.map_err(damaged)?, is_enough).map_err(damaged)?.decoder;
        return Ok(IndexedMesh::new(decoder.positions().to_vec(), decoder.triangles().to_vec()));
    }
    let levels = file.levels().map_err(damaged)?;
    let (split_count, _) = Target::Triangles(MAX_TRIANGLES).resolve_in(&levels);
    file.level(split_count).map_err(damaged)
}
