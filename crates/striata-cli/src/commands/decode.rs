//! `decode`: decodes a stream, complete or cut off, or one level of it, into a mesh.

use std::time::Instant;

use serde::Serialize;
use striata::mesh::{IndexedMesh, Steps};
use striata::simplify::Target;

use super::extract::{
    INPUT_ENDED_TEXT, StreamStopReason, detail_to_splits, full_mesh, has_level, resolve, stream_of,
};
use super::scene;
use crate::args::DecodeArgs;
use striata_command::failure::Failure;
use striata_command::input::Input;
use striata_command::level::{CoarseningLimit, ReachedLevel, shortfall, shortfall_note};
use striata_command::output::{Output, format_count, format_duration, format_length};
use striata_command::save::{Primitives, format_of, is_stdout, write_mesh};
use striata_command::stream::{DecodedStream, effort_name};

#[derive(Serialize)]
struct Report {
    vertex_count: usize,
    triangle_count: usize,
    split_count: usize,
    step_count: usize,
    is_complete: bool,
    /// How the mesh misses the requested level; null if it does not, or if no level was requested.
    shortfall: Option<String>,
    effort: &'static str,
    /// Number of bytes of the stream that were read.
    read_bytes: usize,
    /// Size of the whole stream.
    stream_bytes: u64,
    error: f32,
    decode_secs: f64,
    /// Throughput of the decoder alone.
    triangles_per_sec: f64,
    secs: f64,
}

/// Reads and decodes the stream, writes the mesh, and reports.
///
/// # Errors
/// If any of this fails.
pub(crate) fn run(args: &DecodeArgs, output: &Output) -> Result<(), Failure> {
    let started = Instant::now();
    output.check_stdout_is_free(is_stdout(&args.output.output))?;
    format_of(&args.output.output, &args.output.format)?;
    let mut bar = output.bar();
    bar.phase("read");
    let input = Input::open(&args.input)?;
    if input.scene_kind().is_some() {
        drop(bar);
        return scene::decode(args, &input, started, output);
    }
    let file = input.striata()?;
    let stream = stream_of(&file, &input)?;
    bar.phase("decode");
    let step_count = file.summary().step_count;
    let target = args.level.level.target(full_mesh(&args.level.level, &file, &input)?);
    let target = target.map(|target| detail_to_splits(target, step_count));
    let received =
        DecodedStream::read_levels(stream, |decoder| target.is_some_and(|target| has_level(decoder, target)));
    let received = received.map_err(|error| input.damaged(&error))?;
    let steps = received.steps().map_err(|error| input.damaged(&error))?;
    let decoded = match target {
        Some(target) => DecodedLevel::at_level(&steps, &received, target),
        None => DecodedLevel::of_all(steps, &received),
    };
    bar.phase("write");
    write_mesh(&decoded.mesh, Primitives::Triangles, &args.output.output, &args.output.format, output)?;
    drop(bar);
    if let Some(remark) = received.truncation_note(&input.name) {
        output.say(&remark);
    }
    let report = Report::new(decoded, &received, started);
    output.summary(&report, &report.to_text())
}

/// The mesh to write, with its place in the sequence of levels.
struct DecodedLevel {
    mesh: IndexedMesh,
    split_count: usize,
    error: f32,
    shortfall: Option<String>,
}

impl DecodedLevel {
    fn of_all(steps: Steps, received: &DecodedStream) -> Self {
        let (split_count, error) = (received.decoder.split_count(), received.decoder.error());
        Self { mesh: steps.into_mesh(), split_count, error: error.unwrap_or_default(), shortfall: None }
    }

    fn at_level(steps: &Steps, received: &DecodedStream, target: Target) -> Self {
        let (split_count, end) = resolve(target, received, steps.levels());
        let mesh = steps.level(split_count).without_unused_vertices();
        let (vertex_count, triangle_count) = (mesh.vertex_count(), mesh.triangle_count());
        let shortfall = match end {
            StreamStopReason::InputEnded => Some(INPUT_ENDED_TEXT.to_owned()),
            StreamStopReason::Level(stop_reason) => shortfall(
                target,
                ReachedLevel { vertex_count, triangle_count, stop_reason },
                &CoarseningLimit::File,
            ),
        };
        let error = received.decoder.error_at(split_count).unwrap_or_default();
        Self { mesh, split_count, error, shortfall }
    }
}

impl Report {
    fn new(decoded: DecodedLevel, received: &DecodedStream, started: Instant) -> Self {
        Self {
            vertex_count: decoded.mesh.vertex_count(),
            triangle_count: decoded.mesh.triangle_count(),
            split_count: decoded.split_count,
            step_count: received.facts.step_count,
            is_complete: !received.is_cut,
            shortfall: decoded.shortfall,
            effort: effort_name(received.facts.effort),
            read_bytes: received.read_bytes,
            stream_bytes: received.facts.stream_bytes,
            error: decoded.error,
            decode_secs: received.decode_secs,
            triangles_per_sec: received.decoder.triangles().len() as f64 / received.decode_secs,
            secs: started.elapsed().as_secs_f64(),
        }
    }

    fn to_text(&self) -> String {
        format!(
            "{} triangles, {} vertices, split {} of {}, error {}; decoded in {} ({:.2} M triangles/s){}",
            format_count(self.triangle_count),
            format_count(self.vertex_count),
            format_count(self.split_count),
            format_count(self.step_count),
            format_length(self.error.into()),
            format_duration(self.decode_secs),
            self.triangles_per_sec / 1e6,
            self.shortfall
                .as_ref()
                .map_or_else(String::new, |text| format!("\n{}", shortfall_note(None, text)))
        )
    }
}
