//! The report of `extract`.

use std::time::Instant;

use serde::Serialize;
use striata::mesh::IndexedMesh;
use striata::model::ModelKind;
use striata::simplify::{StopReason, Target};

use super::fan_view::ViewLevel;
use super::from_paged::PagesRead;
use super::level_output::view_output_path;
use crate::args::ExtractArgs;
use striata_command::failure::Failure;
use striata_command::level::{
    CoarseningLimit, LevelRequest, LevelRow, ReachedLevel, check_strict, shortfall, shortfall_note,
    table_of_levels,
};
use striata_command::output::{format_count, format_duration, format_length};
use striata_command::save::display_name;

/// Report on several levels.
#[derive(Serialize)]
pub(super) struct LevelsReport {
    pub(super) levels: Vec<Report>,
    pub(super) step_count: usize,
    pub(super) secs: f64,
}

#[derive(Serialize)]
pub(super) struct Report {
    /// The text that the user wrote for the level, if there are several.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) level: Option<String>,
    pub(super) path: String,
    pub(super) model: &'static str,
    /// For views: whether the fans were `stored` in the file or `built` from the sequence.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) fans: Option<&'static str>,
    /// For views and boxes: whether the patterns were `stored` in the file or `built` from the sequence.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) patterns: Option<&'static str>,
    /// For views: the pixel tolerance, after it was raised to respect the triangle limit.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) pixels: Option<f64>,
    /// For paged files: what was read.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) pages: Option<PagesRead>,
    pub(super) split_count: usize,
    pub(super) vertex_count: usize,
    pub(super) triangle_count: usize,
    pub(super) error: f32,
    /// Whether no point of the original is farther from the level than the error.
    pub(super) error_is_guaranteed: bool,
    pub(super) stop_reason: &'static str,
    /// How the level misses its target; null if it does not.
    pub(super) shortfall: Option<String>,
    pub(super) seek_secs: f64,
    pub(super) secs: f64,
}

/// The mesh of a level.
#[derive(Clone, Copy)]
pub(super) struct LevelMesh<'a> {
    pub(super) mesh: &'a IndexedMesh,
    pub(super) split_count: usize,
    pub(super) stop_reason: StopReason,
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
            level: request.name.clone(),
            path: display_name(&request.path),
            model: model.as_str(),
            fans: None,
            patterns: None,
            pixels: None,
            pages: None,
            split_count,
            vertex_count: reached.vertex_count,
            triangle_count: reached.triangle_count,
            error: 0.0,
            error_is_guaranteed: false,
            stop_reason: stop_reason.as_str(),
            shortfall: request.target.and_then(|target| shortfall(target, reached, &CoarseningLimit::File)),
            seek_secs,
            secs,
        }
    }

    /// Creates the report on a level for a view or a box.
    ///
    /// # Errors
    /// If the level exceeds the triangle limit and `--strict` was given, or there is no output path.
    pub(super) fn of_view_or_box(
        model: ModelKind,
        args: &ExtractArgs,
        (level, triangle_limit): (&ViewLevel, Option<usize>),
        started: Instant,
    ) -> Result<Self, Failure> {
        let path = view_output_path(args)?;
        let request = LevelRequest { name: None, target: triangle_limit.map(Target::Triangles), path };
        let ViewLevel { mesh, split_count, stop_reason, .. } = level;
        let shown = LevelMesh { mesh, split_count: *split_count, stop_reason: *stop_reason };
        let report = Self {
            error: level.error,
            ..Self::of_level(model, &request, shown, [level.seek_secs, started.elapsed().as_secs_f64()])
        };
        check_strict(args.strict, None, report.shortfall.as_deref())?;
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
            format_count(self.triangle_count),
            format_count(self.vertex_count),
            format_count(self.split_count),
            format_count(step_count),
            format_length(self.error.into()),
            self.stop_reason.replace('_', " "),
            format_duration(self.seek_secs),
            self.shortfall
                .as_ref()
                .map_or_else(String::new, |text| format!("\n{}", shortfall_note(None, text))),
            self.pages.map_or_else(String::new, PagesRead::to_text)
        )
    }
}

impl LevelsReport {
    pub(super) fn to_text(&self) -> String {
        let rows: Vec<LevelRow<'_>> = self.levels.iter().map(Report::row).collect();
        let model = self.levels.first().map_or("", |level| level.model);
        format!("{}extracted from {model} in {}", table_of_levels(&rows), format_duration(self.secs))
    }
}

impl Report {
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
