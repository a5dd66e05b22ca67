//! Levels of a stream: how far it must be read to reach them, and which level a truncated stream reaches.

use striata::file::StriataFile;
use striata::mesh::Levels;
use striata::simplify::{StopReason, Target};
use striata_stream::StreamDecoder;

use super::level_output::diagonal_of;
use striata_command::args::LevelArgs;
use striata_command::failure::Failure;
use striata_command::input::Input;
use striata_command::level::FullMesh;
use striata_command::stream::DecodedStream;

/// Stop reason in reports if the stream ends before the level.
const INPUT_ENDED: &str = "input_ended";

/// Message for the user if the stream ends before the level.
pub(in crate::commands) const INPUT_ENDED_TEXT: &str = "the input ends before this level";

/// Returns the stream of a file, possibly cut off.
///
/// # Errors
/// If the file has no stream, or is damaged.
pub(in crate::commands) fn stream_of<'a>(file: &StriataFile<'a>, input: &Input) -> Result<&'a [u8], Failure> {
    let stream = file.stream().ok_or_else(|| {
        Failure::user(format!("{}: this file has no progressive stream", input.name))
            .with_hint("build it again with --models progressive, or make a stream with `striata encode`")
    })?;
    stream.map_err(|error| input.damaged(&error))
}

/// Returns the sizes that percentages of targets refer to, which are those of the whole stream.
///
/// # Errors
/// If the stream is damaged and its bounds are needed.
pub(in crate::commands) fn full_mesh(
    level: &LevelArgs,
    file: &StriataFile<'_>,
    input: &Input,
) -> Result<FullMesh, Failure> {
    let summary = file.summary();
    Ok(FullMesh {
        diagonal: diagonal_of(level, file, input)?,
        vertex_count: summary.vertex_count,
        triangle_count: summary.triangle_count,
    })
}

/// Reason why extraction stopped at this level of a stream.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::commands) enum StreamStopReason {
    /// The stream ends before the target.
    InputEnded,
    /// A reason that also applies to models in a file.
    Level(StopReason),
}

impl StreamStopReason {
    /// Returns the name used in reports.
    pub(in crate::commands) fn as_str(self) -> &'static str {
        match self {
            Self::InputEnded => INPUT_ENDED,
            Self::Level(reason) => reason.as_str(),
        }
    }
}

/// Converts a detail to a split count of the whole stream, so that it does not depend on how much was
/// received.
pub(in crate::commands) fn detail_to_splits(target: Target, step_count: usize) -> Target {
    match target {
        Target::Detail(detail) => {
            // The small term keeps `k / step_count` from being rounded down to k - 1, as in `Levels`.
            let exact = detail * step_count as f64;
            Target::SplitCount(((exact + 1e-9 * exact.max(1.0)) as usize).min(step_count))
        }
        target => target,
    }
}

/// Whether the decoder has reached the target or a finer level.
pub(in crate::commands) fn has_level(decoder: &StreamDecoder, target: Target) -> bool {
    match target {
        Target::Triangles(count) => decoder.triangle_count() > count,
        Target::Vertices(count) => decoder.positions().len() > count,
        Target::SplitCount(count) => decoder.split_count() >= count,
        Target::Error(error) => decoder.error().is_some_and(|e| f64::from(e) <= error),
        _ => false,
    }
}

/// Returns the split count of the received level closest to the target, and why it is no closer.
pub(in crate::commands) fn resolve(
    target: Target,
    received: &DecodedStream,
    levels: &Levels,
) -> (usize, StreamStopReason) {
    let is_whole = received.decoder.is_complete();
    if let (false, Target::Error(error)) = (is_whole, target) {
        // `levels` takes the finest received mesh for the full mesh, with an error of 0.
        let remaining_error = received.decoder.error().unwrap_or_default();
        if f64::from(remaining_error) > error {
            return (levels.step_count(), StreamStopReason::InputEnded);
        }
    }
    match target.resolve_in(levels) {
        (split_count, StopReason::FullMesh) if !is_whole => (split_count, StreamStopReason::InputEnded),
        (split_count, reason) => (split_count, StreamStopReason::Level(reason)),
    }
}
