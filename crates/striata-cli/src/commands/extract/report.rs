//! The report of `extract`.

use std::time::Instant;

use serde::Serialize;
use striata::mesh::IndexedMesh;
use striata::model::ModelKind;
use striata::simplify::{StopReason, Target};

use super::fan_view::ViewLevel;
use super::level_output::view_output_path;
use crate::args::ExtractArgs;
use striata_command::failure::Failure;
use striata_command::level::{
    CoarseningLimit, LevelRequest, LevelsReport, ReachedLevel, WrittenLevel, table_of_levels,
};
use striata_command::output::{Output, format_bytes, format_count, format_duration, format_length};

/// The report of `extract`.
type ExtractedLevels = LevelsReport<Report, Option<ExtractedList>>;

/// Members of the report on a list of levels, besides the list.
#[derive(Serialize)]
pub(super) struct ExtractedList {
    pub step_count: usize,
    pub secs: f64,
}

#[derive(Serialize)]
pub(super) struct Report {
    #[serde(flatten)]
    pub written: WrittenLevel,
    pub model: &'static str,
    /// For views: whether the fans were `stored` in the file or `built` from the sequence.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub fans: Option<&'static str>,
    /// For views and boxes: whether the patterns were `stored` in the file or `built` from the sequence.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub patterns: Option<&'static str>,
    /// For views: the pixel tolerance, after it was raised to respect the triangle limit.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub pixels: Option<f64>,
    /// For paged files: what was read.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub pages: Option<PagesRead>,
    pub split_count: usize,
    /// Whether no point of the original is farther from the level than the error.
    pub error_is_guaranteed: bool,
    pub seek_secs: f64,
    pub secs: f64,
}

/// Pages of a paged file that were read.
#[derive(Clone, Copy, Serialize)]
pub(super) struct PagesRead {
    /// Pages of the file.
    pub page_count: u32,
    /// Pages that were read.
    pub read: u64,
    /// Pages whose vertices are in the result.
    pub shown: usize,
    /// Bytes that were read, with the head.
    pub bytes: u64,
    /// Steps of the pages that were read.
    pub step_count: usize,
}

impl PagesRead {
    /// The sentence for people.
    fn to_text(self) -> String {
        format!(
            "\nread {} of {} pages, {}; {} of them are shown",
            self.read,
            self.page_count,
            format_bytes(self.bytes as usize),
            self.shown
        )
    }
}

/// The mesh of a level.
#[derive(Clone, Copy)]
pub(super) struct LevelMesh<'a> {
    pub mesh: &'a IndexedMesh,
    pub split_count: usize,
    pub stop_reason: StopReason,
}

impl Report {
    /// Creates the report on a level of uniform detail; the caller fills in the error.
    pub(super) fn of_level(
        model: ModelKind,
        request: &LevelRequest,
        LevelMesh { mesh, split_count, stop_reason }: LevelMesh<'_>,
        [seek_secs, secs]: [f64; 2],
    ) -> Self {
        let reached = ReachedLevel {
            vertex_count: mesh.vertex_count(),
            triangle_count: mesh.triangle_count(),
            stop_reason,
        };
        Self {
            written: WrittenLevel::new(request, reached, &CoarseningLimit::File),
            model: model.as_str(),
            fans: None,
            patterns: None,
            pixels: None,
            pages: None,
            split_count,
            error_is_guaranteed: false,
            seek_secs,
            secs,
        }
    }

    /// Sets the error, mesh units.
    pub(super) fn with_error(self, error: f32) -> Self {
        Self { written: self.written.with_error(error), ..self }
    }

    /// Creates the report on a level for a view or a box.
    ///
    /// # Errors
    /// If the level exceeds the triangle limit and `--strict` was given, or there is no output path.
    pub(super) fn of_view_or_box(
        model: ModelKind,
        args: &ExtractArgs,
        level: &ViewLevel,
        triangle_limit: Option<usize>,
        started: Instant,
    ) -> Result<Self, Failure> {
        let path = view_output_path(args)?;
        let request = LevelRequest { name: None, target: triangle_limit.map(Target::Triangles), path };
        let ViewLevel { mesh, split_count, stop_reason, .. } = level;
        let shown = LevelMesh { mesh, split_count: *split_count, stop_reason: *stop_reason };
        let secs = [level.seek_secs, started.elapsed().as_secs_f64()];
        let report = Self::of_level(model, &request, shown, secs).with_error(level.error);
        report.written.check_strict(args.strict)?;
        Ok(report)
    }

    pub(super) fn to_text(&self, step_count: usize) -> String {
        let kind = if self.error_is_guaranteed { "guaranteed error" } else { "error" };
        let of_model = |model: ModelKind, origin: Option<&str>| {
            origin.map_or_else(String::new, |origin| format!(", {model} {origin}"))
        };
        let origin = of_model(ModelKind::Fans, self.fans) + &of_model(ModelKind::Patterns, self.patterns);
        format!(
            "{} triangles, {} vertices, split {} of {}, {kind} {}, {}; found in {}{origin}{}{}",
            format_count(self.written.triangle_count),
            format_count(self.written.vertex_count),
            format_count(self.split_count),
            format_count(step_count),
            format_length(self.written.error.unwrap_or_default()),
            self.written.stop_text(),
            format_duration(self.seek_secs),
            self.written.note(),
            self.pages.map_or_else(String::new, PagesRead::to_text)
        )
    }
}

/// Describes extracted levels of a file with this number of steps.
fn text_of(report: &ExtractedLevels, step_count: usize) -> String {
    match report {
        ExtractedLevels::One { level, .. } => level.to_text(step_count),
        ExtractedLevels::Several { levels, common } => {
            let table = table_of_levels(levels.iter().map(|level| &level.written));
            let model = levels.first().map_or("", |level| level.model);
            let secs = common.as_ref().map_or(0.0, |common| common.secs);
            format!("{table}extracted from {model} in {}", format_duration(secs))
        }
    }
}

/// Reports levels: the only one, or the list that the user asked for.
///
/// # Errors
/// If there is no level, or the report cannot be written.
pub(super) fn report_levels(
    levels: Vec<Report>,
    is_list: bool,
    common: ExtractedList,
    output: &Output,
) -> Result<(), Failure> {
    let step_count = common.step_count;
    let report = ExtractedLevels::new(levels, is_list, is_list.then_some(common))?;
    output.summary(&report, &text_of(&report, step_count))
}
