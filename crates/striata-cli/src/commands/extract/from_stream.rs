//! `extract` from a stream, which is read only as far as the level needs.

use std::time::Instant;

use serde::Serialize;
use striata::file::StriataFile;
use striata::model::ModelKind;
use striata::simplify::StopReason;
use striata_stream::StreamDecoder;

use super::level_output::{no_level, primitives_of};
use super::stream_level::{
    INPUT_ENDED_TEXT, StreamStopReason, detail_to_splits, full_mesh, has_level, resolve, stream_of,
};
use crate::args::ExtractArgs;
use striata_command::failure::Failure;
use striata_command::input::Input;
use striata_command::level::{
    CoarseningLimit, LevelRequest, LevelsReport, ReachedLevel, WrittenLevel, level_requests, table_of_levels,
};
use striata_command::output::{Output, format_count, format_duration, format_length};
use striata_command::save::LevelFiles;
use striata_command::stream::DecodedStream;

/// The report: of one level, or of several with the time that they took together.
type StreamedLevels = LevelsReport<Report, Option<StreamedList>>;

#[derive(Serialize)]
struct StreamedList {
    secs: f64,
}

#[derive(Serialize)]
struct Report {
    #[serde(flatten)]
    written: WrittenLevel,
    model: &'static str,
    split_count: usize,
    step_count: usize,
    error_is_guaranteed: bool,
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
    let steps = received.steps().map_err(damaged)?;
    let mut files = LevelFiles::new(&args.output.format, args.levels.levels.is_some(), output);
    let mut reports = Vec::new();
    for (request, &target) in requests.iter().zip(&targets) {
        let (split_count, end) = resolve(target, &received, steps.levels());
        let mesh = steps.level(split_count).without_unused_vertices();
        let (vertex_count, triangle_count) = (mesh.vertex_count(), mesh.triangle_count());
        let stop_reason = match end {
            StreamStopReason::Level(stop_reason) => stop_reason,
            StreamStopReason::InputEnded => StopReason::TargetReached,
        };
        let reached = ReachedLevel { vertex_count, triangle_count, stop_reason };
        let asked = LevelRequest { target: Some(target), ..request.clone() };
        let mut written = WrittenLevel::new(&asked, reached, &CoarseningLimit::File);
        written.stop_reason = end.as_str();
        if let StreamStopReason::InputEnded = end {
            written.shortfall = Some(INPUT_ENDED_TEXT.to_owned());
        }
        written.check_strict(args.strict)?;
        files.write(&mesh, primitives_of(args.form, &mesh, None)?, &request.path)?;
        let is_last = split_count == received.decoder.split_count();
        let error = match received.decoder.error() {
            Some(error) if is_last => error,
            _ => steps.levels().error_at(split_count),
        };
        reports.push(Report {
            written: written.with_error(error),
            model: ModelKind::Progressive.as_str(),
            split_count,
            step_count,
            error_is_guaranteed,
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
    let is_list = args.levels.levels.is_some();
    let common = is_list.then(|| StreamedList { secs: started.elapsed().as_secs_f64() });
    let report = StreamedLevels::new(reports, is_list, common)?;
    output.summary(&report, &text_of(&report))
}

impl Report {
    fn to_text(&self) -> String {
        format!(
            "{} triangles, {} vertices, split {} of {}, error {}, {}; {} of {} bytes decoded in {}{}",
            format_count(self.written.triangle_count),
            format_count(self.written.vertex_count),
            format_count(self.split_count),
            format_count(self.step_count),
            format_length(self.written.error.unwrap_or_default()),
            self.written.stop_text(),
            format_count(self.read_bytes),
            format_count(usize::try_from(self.stream_bytes).unwrap_or(usize::MAX)),
            format_duration(self.seek_secs),
            self.written.note()
        )
    }
}

fn text_of(report: &StreamedLevels) -> String {
    let levels = match report {
        StreamedLevels::One { level, .. } => return level.to_text(),
        StreamedLevels::Several { levels, .. } => levels,
    };
    let (read, whole) = levels.first().map_or((0, 0), |level| (level.read_bytes, level.stream_bytes));
    let whole = format_count(usize::try_from(whole).unwrap_or(usize::MAX));
    let table = table_of_levels(levels.iter().map(|level| &level.written));
    format!("{table}{} of {whole} bytes decoded", format_count(read))
}
