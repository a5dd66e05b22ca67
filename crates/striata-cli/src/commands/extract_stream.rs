//! `extract` from a stream: read as far as the level needs, or as far as there is any.

use std::time::Instant;

use serde::Serialize;
use striata::file::StriataFile;
use striata::mesh::{Levels, replay};
use striata::model::ModelKind;
use striata::simplify::{StopReason, Target};
use striata_stream::StreamDecoder;

use super::decode::stream_of;
use super::extract::{diagonal_of, drawn, no_level};
use crate::args::ExtractArgs;
use crate::commands::build::errors_are_guaranteed;
use striata_command::args::LevelArgs;
use striata_command::failure::Failure;
use striata_command::input::Input;
use striata_command::level::{
    Floor, FullMesh, LevelRow, Reached, Wanted, check_strict, remark, shortfall, table_of_levels,
    wanted_levels,
};
use striata_command::output::{Output, grouped, lasted, measured};
use striata_command::save::{LevelFiles, name_of};
use striata_command::stream::Received;

/// Why a level is no finer where the bytes end before it.
const INPUT_ENDED: &str = "input_ended";

/// The same for people.
pub(super) const INPUT_ENDS: &str = "the input ends before this level";

/// Of several levels.
#[derive(Serialize)]
struct LevelsReport {
    levels: Vec<Report>,
    secs: f64,
}

#[derive(Serialize)]
struct Report {
    /// As the user wrote it, if it is one of several.
    #[serde(skip_serializing_if = "Option::is_none")]
    level: Option<String>,
    path: String,
    model: &'static str,
    split_count: usize,
    step_count: usize,
    vertex_count: usize,
    triangle_count: usize,
    error: f32,
    error_is_guaranteed: bool,
    stop_reason: &'static str,
    /// Why the level is not what was asked for; null if it is.
    shortfall: Option<String>,
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
    let full = full_mesh(&args.level, file, input)?;
    let wanted = wanted_levels(&args.level, &args.levels, full, &args.output.output)?;
    let target = |wanted: &Wanted| Ok(in_splits(wanted.target.ok_or_else(no_level)?, step_count));
    let targets = wanted.iter().map(target).collect::<Result<Vec<_>, Failure>>()?;
    // One pass, as far as the finest level needs.
    let are_enough = |decoder: &StreamDecoder| targets.iter().all(|&target| is_enough(decoder, target));
    let received = Received::read(stream, are_enough).map_err(damaged)?;
    let refinable = received.refinable().map_err(damaged)?;
    let mut files = LevelFiles::new(&args.output.format, args.levels.levels.is_some());
    let mut reports = Vec::new();
    for (wanted, &target) in wanted.iter().zip(&targets) {
        let (split_count, end) = resolve(target, &received, refinable.sequence.levels());
        let mesh = replay(&refinable, split_count).without_unused_vertices();
        let shortfall = match end {
            End::Input => Some(INPUT_ENDS.to_owned()),
            End::Level(stop_reason) => {
                let (vertex_count, triangle_count) = (mesh.vertex_count(), mesh.triangle_count());
                shortfall(target, Reached { vertex_count, triangle_count, stop_reason }, &Floor::File)
            }
        };
        check_strict(args.strict, wanted.name.as_deref(), shortfall.as_deref())?;
        files.save(&mesh, drawn(args.form, &mesh, None)?, &wanted.path)?;
        let is_last = split_count == received.decoder.split_count();
        reports.push(Report {
            level: wanted.name.clone(),
            path: name_of(&wanted.path),
            model: ModelKind::Progressive.as_str(),
            split_count,
            step_count,
            vertex_count: mesh.vertex_count(),
            triangle_count: mesh.triangle_count(),
            error: match received.decoder.error() {
                Some(error) if is_last => error,
                _ => refinable.sequence.error_at(split_count),
            },
            error_is_guaranteed: errors_are_guaranteed(file).map_err(damaged)?,
            stop_reason: end.as_str(),
            shortfall,
            is_complete: !received.is_cut,
            read_bytes: received.read_bytes,
            level_bytes: received.decoder.bytes_for(split_count),
            stream_bytes: received.facts.stream_bytes,
            file_bytes: input.file_bytes(),
            seek_secs: received.decode_secs,
            secs: started.elapsed().as_secs_f64(),
        });
    }
    files.commit()?;
    if let Some(remark) = received.remark(&input.name) {
        output.say(&remark);
    }
    if args.levels.levels.is_some() {
        let report = LevelsReport { levels: reports, secs: started.elapsed().as_secs_f64() };
        return output.summary(&report, &report.to_text());
    }
    let report = reports.pop().ok_or_else(no_level)?;
    output.summary(&report, &report.to_text())
}

/// What targets are shares of: numbers of the whole stream.
///
/// # Errors
/// If the stream is unsound and its bounds are needed.
pub(super) fn full_mesh(
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
pub(super) enum End {
    /// The bytes end before a better one.
    Input,
    /// As in every other file.
    Level(StopReason),
}

impl End {
    pub(super) fn as_str(self) -> &'static str {
        match self {
            Self::Input => INPUT_ENDED,
            Self::Level(reason) => reason.as_str(),
        }
    }
}

/// A share of the way is one of the whole stream's, however much of it is there.
pub(super) fn in_splits(target: Target, step_count: usize) -> Target {
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
pub(super) fn is_enough(decoder: &StreamDecoder, target: Target) -> bool {
    match target {
        Target::Triangles(count) => decoder.triangles().len() > count,
        Target::Vertices(count) => decoder.positions().len() > count,
        Target::SplitCount(count) => decoder.split_count() >= count,
        Target::Error(error) => decoder.error().is_some_and(|e| f64::from(e) <= error),
        _ => false,
    }
}

/// The level that comes nearest to the target, and why it comes no nearer.
pub(super) fn resolve(target: Target, received: &Received, levels: &Levels) -> (usize, End) {
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

impl Report {
    fn to_text(&self) -> String {
        format!(
            "{} triangles, {} vertices, split {} of {}, error {}, {}; {} of {} bytes decoded in {}{}",
            grouped(self.triangle_count),
            grouped(self.vertex_count),
            grouped(self.split_count),
            grouped(self.step_count),
            measured(self.error.into()),
            self.stop_reason.replace('_', " "),
            grouped(self.read_bytes),
            grouped(usize::try_from(self.stream_bytes).unwrap_or(usize::MAX)),
            lasted(self.seek_secs),
            self.shortfall.as_ref().map_or_else(String::new, |text| format!("\n{}", remark(None, text)))
        )
    }

    fn row(&self) -> LevelRow<'_> {
        LevelRow {
            name: self.level.as_deref().unwrap_or_default(),
            triangle_count: self.triangle_count,
            vertex_count: self.vertex_count,
            error: self.error.into(),
            path: &self.path,
            shortfall: self.shortfall.as_deref(),
        }
    }
}

impl LevelsReport {
    fn to_text(&self) -> String {
        let rows: Vec<LevelRow<'_>> = self.levels.iter().map(Report::row).collect();
        let (read, whole) =
            self.levels.first().map_or((0, 0), |level| (level.read_bytes, level.stream_bytes));
        let whole = grouped(usize::try_from(whole).unwrap_or(usize::MAX));
        format!("{}{} of {whole} bytes decoded", table_of_levels(&rows), grouped(read))
    }
}
