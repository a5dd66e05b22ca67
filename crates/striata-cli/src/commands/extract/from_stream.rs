//! `extract` from a stream, which is read only as far as the level needs.

use std::time::Instant;

use serde::Serialize;
use striata::file::StriataFile;
use striata::mesh::replay;
use striata::model::ModelKind;
use striata_stream::StreamDecoder;

use super::level_output::{no_level, primitives_of};
use super::stream_level::{
    INPUT_ENDED_TEXT, StreamStopReason, detail_to_splits, full_mesh, has_level, resolve, stream_of,
};
use crate::args::ExtractArgs;
use striata_command::failure::Failure;
use striata_command::input::Input;
use striata_command::level::{
    CoarseningLimit, LevelRequest, LevelRow, ReachedLevel, check_strict, level_requests, shortfall,
    shortfall_note, table_of_levels,
};
use striata_command::output::{Output, format_count, format_duration, format_length};
use striata_command::save::{LevelFiles, display_name};
use striata_command::stream::DecodedStream;

/// Report on several levels.
#[derive(Serialize)]
struct LevelsReport {
    levels: Vec<Report>,
    secs: f64,
}

#[derive(Serialize)]
struct Report {
    /// The text that the user wrote for the level, if there are several.
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
    /// How the level misses its target; null if it does not.
    shortfall: Option<String>,
    /// Whether the stream is complete.
    is_complete: bool,
    /// Number of bytes of the stream that were read.
    read_bytes: usize,
    /// Number of bytes of the stream needed for the level.
    level_bytes: Option<u64>,
    /// Size of the whole stream.
    stream_bytes: u64,
    file_bytes: Option<usize>,
    seek_secs: f64,
    secs: f64,
}

/// Decodes the requested levels, writes them, and reports.
///
/// # Errors
/// If the stream is damaged or an output cannot be written.
pub(super) fn run(
    args: &ExtractArgs,
    (file, input): (&StriataFile<'_>, &Input),
    (started, error_is_guaranteed): (Instant, bool),
    output: &Output,
) -> Result<(), Failure> {
    let damaged = |error| input.damaged(&error);
    let stream = stream_of(file, input)?;
    let step_count = file.summary().step_count;
    let full = full_mesh(&args.level, file, input)?;
    let requests = level_requests(&args.level, &args.levels, full, &args.output.output)?;
    let target =
        |request: &LevelRequest| Ok(detail_to_splits(request.target.ok_or_else(no_level)?, step_count));
    let targets = requests.iter().map(target).collect::<Result<Vec<_>, Failure>>()?;
    // One pass, as far as the finest level needs.
    let are_enough = |decoder: &StreamDecoder| targets.iter().all(|&target| has_level(decoder, target));
    let received = DecodedStream::read_levels(stream, are_enough).map_err(damaged)?;
    let refinable = received.refinable().map_err(damaged)?;
    let mut files = LevelFiles::new(&args.output.format, args.levels.levels.is_some(), output);
    let mut reports = Vec::new();
    for (request, &target) in requests.iter().zip(&targets) {
        let (split_count, end) = resolve(target, &received, refinable.sequence.levels());
        let mesh = replay(&refinable, split_count).without_unused_vertices();
        let shortfall = match end {
            StreamStopReason::InputEnded => Some(INPUT_ENDED_TEXT.to_owned()),
            StreamStopReason::Level(stop_reason) => {
                let (vertex_count, triangle_count) = (mesh.vertex_count(), mesh.triangle_count());
                shortfall(
                    target,
                    ReachedLevel { vertex_count, triangle_count, stop_reason },
                    &CoarseningLimit::File,
                )
            }
        };
        check_strict(args.strict, request.name.as_deref(), shortfall.as_deref())?;
        files.write(&mesh, primitives_of(args.form, &mesh, None)?, &request.path)?;
        let is_last = split_count == received.decoder.split_count();
        reports.push(Report {
            level: request.name.clone(),
            path: display_name(&request.path),
            model: ModelKind::Progressive.as_str(),
            split_count,
            step_count,
            vertex_count: mesh.vertex_count(),
            triangle_count: mesh.triangle_count(),
            error: match received.decoder.error() {
                Some(error) if is_last => error,
                _ => refinable.sequence.error_at(split_count),
            },
            error_is_guaranteed,
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
    if let Some(remark) = received.truncation_note(&input.name) {
        output.say(&remark);
    }
    if args.levels.levels.is_some() {
        let report = LevelsReport { levels: reports, secs: started.elapsed().as_secs_f64() };
        return output.summary(&report, &report.to_text());
    }
    let report = reports.pop().ok_or_else(no_level)?;
    output.summary(&report, &report.to_text())
}

impl Report {
    fn to_text(&self) -> String {
        format!(
            "{} triangles, {} vertices, split {} of {}, error {}, {}; {} of {} bytes decoded in {}{}",
            format_count(self.triangle_count),
            format_count(self.vertex_count),
            format_count(self.split_count),
            format_count(self.step_count),
            format_length(self.error.into()),
            self.stop_reason.replace('_', " "),
            format_count(self.read_bytes),
            format_count(usize::try_from(self.stream_bytes).unwrap_or(usize::MAX)),
            format_duration(self.seek_secs),
            self.shortfall
                .as_ref()
                .map_or_else(String::new, |text| format!("\n{}", shortfall_note(None, text)))
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
        let whole = format_count(usize::try_from(whole).unwrap_or(usize::MAX));
        format!("{}{} of {whole} bytes decoded", table_of_levels(&rows), format_count(read))
    }
}
