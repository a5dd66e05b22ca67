//! `decode`: the mesh of a stream, of as much of it as is there, or of one level.

use std::time::Instant;

use serde::Serialize;
use striata::mesh::{IndexedMesh, RefinableMesh, replay};
use striata::simplify::Target;

use super::extract::{End, INPUT_ENDS, full_mesh, in_splits, is_enough, resolve, stream_of};
use crate::args::DecodeArgs;
use striata_command::failure::Failure;
use striata_command::input::Input;
use striata_command::level::{Floor, Reached, remark, shortfall};
use striata_command::output::{Output, format_count, format_duration, format_length};
use striata_command::save::{Drawn, format_of, is_stdout, save};
use striata_command::stream::{DecodedStream, effort_name};

#[derive(Serialize)]
struct Report {
    vertex_count: usize,
    triangle_count: usize,
    split_count: usize,
    step_count: usize,
    is_complete: bool,
    /// Why the mesh is not the level that was asked for; null if it is, or if no level was.
    shortfall: Option<String>,
    effort: &'static str,
    /// Bytes of the stream that were read.
    read_bytes: usize,
    /// Bytes of the whole stream.
    stream_bytes: u64,
    error: f32,
    decode_secs: f64,
    /// In the decoder alone.
    triangles_per_sec: f64,
    secs: f64,
}

/// Reads, decodes, writes, reports.
///
/// # Errors
/// Where any of it fails.
pub(crate) fn run(args: &DecodeArgs, output: &Output) -> Result<(), Failure> {
    let started = Instant::now();
    output.check_stdout_is_free(is_stdout(&args.output.output))?;
    format_of(&args.output.output, &args.output.format)?;
    let mut bar = output.bar();
    bar.phase("read");
    let input = Input::open(&args.input)?;
    let file = input.striata()?;
    let stream = stream_of(&file, &input)?;
    bar.phase("decode");
    let step_count = file.summary().step_count;
    let target = args.level.level.target(full_mesh(&args.level.level, &file, &input)?);
    let target = target.map(|target| in_splits(target, step_count));
    let received =
        DecodedStream::read(stream, |decoder| target.is_some_and(|target| is_enough(decoder, target)));
    let received = received.map_err(|error| input.damaged(&error))?;
    let refinable = received.refinable().map_err(|error| input.damaged(&error))?;
    let decoded = match target {
        Some(target) => Decoded::at_level(&refinable, &received, target),
        None => Decoded::of_all(refinable, &received),
    };
    bar.phase("write");
    save(&decoded.mesh, Drawn::Triangles, &args.output.output, &args.output.format)?;
    drop(bar);
    if let Some(remark) = received.remark(&input.name) {
        output.say(&remark);
    }
    let report = Report::new(decoded, &received, started);
    output.summary(&report, &report.to_text())
}

/// What is written.
struct Decoded {
    mesh: IndexedMesh,
    split_count: usize,
    error: f32,
    shortfall: Option<String>,
}

impl Decoded {
    fn of_all(refinable: RefinableMesh, received: &DecodedStream) -> Self {
        let (split_count, error) = (received.decoder.split_count(), received.decoder.error());
        Self { mesh: refinable.mesh, split_count, error: error.unwrap_or_default(), shortfall: None }
    }

    fn at_level(refinable: &RefinableMesh, received: &DecodedStream, target: Target) -> Self {
        let (split_count, end) = resolve(target, received, refinable.sequence.levels());
        let mesh = replay(refinable, split_count).without_unused_vertices();
        let (vertex_count, triangle_count) = (mesh.vertex_count(), mesh.triangle_count());
        let shortfall = match end {
            End::Input => Some(INPUT_ENDS.to_owned()),
            End::Level(stop_reason) => {
                shortfall(target, Reached { vertex_count, triangle_count, stop_reason }, &Floor::File)
            }
        };
        let error = received.decoder.error_at(split_count).unwrap_or_default();
        Self { mesh, split_count, error, shortfall }
    }
}

impl Report {
    fn new(decoded: Decoded, received: &DecodedStream, started: Instant) -> Self {
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
            self.shortfall.as_ref().map_or_else(String::new, |text| format!("\n{}", remark(None, text)))
        )
    }
}
