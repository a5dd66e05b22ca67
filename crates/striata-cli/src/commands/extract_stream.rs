//! `extract` from a stream: read as far as the level needs, or as far as there is any.

use std::time::Instant;

use serde::Serialize;
use striata::codec::StriataFile;
use striata::codec::progressive::StreamDecoder;
use striata::mesh::{Levels, replay};
use striata::simplify::{StopReason, Target};

use super::decode::stream_of;
use super::extract::{diagonal_of, drawn};
use crate::args::ExtractArgs;
use crate::commands::build::errors_are_guaranteed;
use crate::failure::Failure;
use crate::input::Input;
use crate::output::{Output, grouped, lasted, measured};
use crate::save::save;
use crate::stream::Received;

/// Why a level is no finer where the bytes end before it.
const INPUT_ENDED: &str = "input_ended";

#[derive(Serialize)]
struct Report {
    model: &'static str,
    split_count: usize,
    step_count: usize,
    vertex_count: usize,
    triangle_count: usize,
    error: f32,
    error_is_guaranteed: bool,
    stop_reason: &'static str,
    /// Whether all bytes of the stream are there.
    is_complete: bool,
    /// Bytes of the stream that were read.
    read_bytes: usize,
    /// Bytes of the stream after which the level is there.
    level_bytes: Option<u64>,
    /// Bytes of the whole stream.
    stream_bytes: u64,
    file_bytes: Option<usize>,
    seek_secs: f64,
    secs: f64,
}

/// Goes to the level, writes it.
///
/// # Errors
/// Where the stream is unsound or the output cannot be written.
pub(super) fn run(
    args: &ExtractArgs,
    (file, input): (&StriataFile<'_>, &Input),
    started: Instant,
    output: &Output,
) -> Result<(), Failure> {
    let damaged = |error| input.damaged(&error);
    let stream = stream_of(file, input)?;
    let step_count = file.summary().step_count;
    let target = in_splits(args.level.target(diagonal_of(args, file, input)?)?, step_count);
    let received = Received::read(stream, |decoder| is_enough(decoder, target)).map_err(damaged)?;
    let refinable = received.refinable().map_err(damaged)?;
    let (split_count, stop_reason) = resolve(target, &received, refinable.sequence.levels());
    let mesh = replay(&refinable, split_count);
    save(&mesh, drawn(args.form, &mesh, None)?, &args.output.output, &args.output.format)?;
    if let Some(remark) = received.remark(&input.name) {
        output.say(&remark);
    }
    let is_last = split_count == received.decoder.split_count();
    let report = Report {
        model: "progressive",
        split_count,
        step_count,
        vertex_count: mesh.vertex_count(),
        triangle_count: mesh.triangle_count(),
        error: match received.decoder.error() {
            Some(error) if is_last => error,
            _ => refinable.sequence.error_at(split_count),
        },
        error_is_guaranteed: errors_are_guaranteed(file).map_err(damaged)?,
        stop_reason,
        is_complete: !received.is_cut,
        read_bytes: received.read_bytes,
        level_bytes: received.decoder.bytes_for(split_count),
        stream_bytes: received.facts.stream_bytes,
        file_bytes: input.file_bytes(),
        seek_secs: received.decode_secs,
        secs: started.elapsed().as_secs_f64(),
    };
    output.summary(&report, &report.to_text())
}

/// A share of the way is one of the whole stream's, however much of it is there.
fn in_splits(target: Target, step_count: usize) -> Target {
    match target {
        Target::Detail(detail) => {
            // The small term keeps `k / step_count` from rounding down to k - 1, as in `Levels`.
            let exact = detail * step_count as f64;
            Target::SplitCount(((exact + 1e-9 * exact.max(1.0)) as usize).min(step_count))
        }
        target => target,
    }
}

/// Whether the level, or one beyond it, has come.
fn is_enough(decoder: &StreamDecoder, target: Target) -> bool {
    match target {
        Target::Triangles(count) => decoder.triangles().len() > count,
        Target::Vertices(count) => decoder.positions().len() > count,
        Target::SplitCount(count) => decoder.split_count() >= count,
        Target::Error(error) => decoder.error().is_some_and(|e| f64::from(e) <= error),
        _ => false,
    }
}

/// The level that comes nearest to the target, and why it comes no nearer.
fn resolve(target: Target, received: &Received, levels: &Levels) -> (usize, &'static str) {
    let is_whole = received.decoder.is_complete();
    if let (false, Target::Error(error)) = (is_whole, target) {
        // To its levels what has come is the full mesh, without error.
        let left = received.decoder.error().unwrap_or_default();
        if f64::from(left) > error {
            return (levels.step_count(), INPUT_ENDED);
        }
    }
    match target.resolve_in(levels) {
        (split_count, StopReason::FullMesh) if !is_whole => (split_count, INPUT_ENDED),
        (split_count, reason) => (split_count, reason.as_str()),
    }
}

impl Report {
    fn to_text(&self) -> String {
        format!(
            "{} triangles, {} vertices, split {} of {}, error {}, {}; {} of {} bytes decoded in {}",
            grouped(self.triangle_count),
            grouped(self.vertex_count),
            grouped(self.split_count),
            grouped(self.step_count),
            measured(self.error.into()),
            self.stop_reason.replace('_', " "),
            grouped(self.read_bytes),
            grouped(usize::try_from(self.stream_bytes).unwrap_or(usize::MAX)),
            lasted(self.seek_secs)
        )
    }
}
