//! Levels of a stream: how far it has to be read for them, and what they are once it ends.

use striata::file::StriataFile;
use striata::mesh::Levels;
use striata::simplify::{StopReason, Target};
use striata_stream::StreamDecoder;

use super::asked::diagonal_of;
use striata_command::args::LevelArgs;
use striata_command::failure::Failure;
use striata_command::input::Input;
use striata_command::level::FullMesh;
use striata_command::stream::DecodedStream;

/// Why a level is no finer where the bytes end before it.
const INPUT_ENDED: &str = "input_ended";

/// The same for people.
pub(in crate::commands) const INPUT_ENDS: &str = "the input ends before this level";

/// The stream of a file, as far as it is there.
///
/// # Errors
/// Where it has none, or it is damaged.
pub(in crate::commands) fn stream_of<'a>(file: &StriataFile<'a>, input: &Input) -> Result<&'a [u8], Failure> {
    let stream = file.stream().ok_or_else(|| {
        Failure::user(format!("{}: no model progressive is in this file", input.name))
            .with_hint("build it again with --models progressive, or make a stream with `striata encode`")
    })?;
    stream.map_err(|error| input.damaged(&error))
}

/// What targets are shares of: numbers of the whole stream.
///
/// # Errors
/// If the stream is unsound and its bounds are needed.
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

/// Why a level is the one that it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::commands) enum End {
    /// The bytes end before a better one.
    Input,
    /// As in every other file.
    Level(StopReason),
}

impl End {
    pub(in crate::commands) fn as_str(self) -> &'static str {
        match self {
            Self::Input => INPUT_ENDED,
            Self::Level(reason) => reason.as_str(),
        }
    }
}

/// A share of the way is one of the whole stream's, however much of it is there.
pub(in crate::commands) fn in_splits(target: Target, step_count: usize) -> Target {
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
pub(in crate::commands) fn is_enough(decoder: &StreamDecoder, target: Target) -> bool {
    match target {
        Target::Triangles(count) => decoder.triangles().len() > count,
        Target::Vertices(count) => decoder.positions().len() > count,
        Target::SplitCount(count) => decoder.split_count() >= count,
        Target::Error(error) => decoder.error().is_some_and(|e| f64::from(e) <= error),
        _ => false,
    }
}

/// The level that comes nearest to the target, and why it comes no nearer.
pub(in crate::commands) fn resolve(
    target: Target,
    received: &DecodedStream,
    levels: &Levels,
) -> (usize, End) {
    let is_whole = received.decoder.is_complete();
    if let (false, Target::Error(error)) = (is_whole, target) {
        // To its levels what has come is the full mesh, without error.
        let left = received.decoder.error().unwrap_or_default();
        if f64::from(left) > error {
            return (levels.step_count(), End::Input);
        }
    }
    match target.resolve_in(levels) {
        (split_count, StopReason::FullMesh) if !is_whole => (split_count, End::Input),
        (split_count, reason) => (split_count, End::Level(reason)),
    }
}
