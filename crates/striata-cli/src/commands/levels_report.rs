//! The report on levels that `simplify`, `extract` and `decode` have made of a mesh or a scene.

use serde::Serialize;
use serde_json::Value;

use super::placement::placement_note;
use striata_command::level::{LevelsReport, WrittenLevel, table_of_levels};
use striata_command::output::{format_count, format_duration, format_length};

/// The report.
pub(super) type MadeLevels = LevelsReport<MadeLevel, HowMade>;

/// A level that was made.
#[derive(Serialize)]
pub(super) struct MadeLevel {
    #[serde(flatten)]
    pub written: WrittenLevel,
    /// Largest sampled distance from the level to the original; null if one of them has no surface. Only reported for
    /// meshes with guaranteed errors, since that guarantee covers only distances from the original to the level.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub reverse_error: Option<Option<f64>>,
    /// Error allowed on the screen, for a view, pixels.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub pixels: Option<f64>,
}

impl From<WrittenLevel> for MadeLevel {
    fn from(written: WrittenLevel) -> Self {
        Self { written, reverse_error: None, pixels: None }
    }
}

/// How all levels of a report were made.
#[derive(Serialize, Default)]
pub(super) struct HowMade {
    pub error_is_guaranteed: bool,
    /// Order of the steps, for a mesh.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub order: Option<&'static str>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub placement: Option<&'static str>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub georeference: Option<Value>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub simplify_secs: Option<f64>,
    pub secs: f64,
}

/// Describes levels of a mesh or scene that had `before` triangles; for a mesh, errors are also shares of its diagonal.
pub(super) fn text_of(report: &MadeLevels, before: usize, diagonal: Option<f64>) -> String {
    let before = format_count(before);
    match report {
        MadeLevels::One { level, common } => level.text(common, &before, diagonal),
        MadeLevels::Several { levels, common } => {
            let kind = if common.error_is_guaranteed { "guaranteed" } else { "estimated" };
            let table = table_of_levels(levels.iter().map(|level| &level.written));
            format!("{table}from {before} triangles, errors {kind}, {}", format_duration(common.secs))
        }
    }
}

impl MadeLevel {
    fn text(&self, common: &HowMade, before: &str, diagonal: Option<f64>) -> String {
        let written = &self.written;
        let share = |error: f64, what: &str| match diagonal {
            None => String::new(),
            Some(diagonal) => {
                let share = if diagonal > 0.0 { 100.0 * error / diagonal } else { 0.0 };
                format!("{share:.4} %{what}")
            }
        };
        let kind = if common.error_is_guaranteed { "guaranteed " } else { "" };
        let error = match (written.error, self.pixels) {
            (Some(error), _) => {
                let share = share(error, " of the diagonal");
                let share = if share.is_empty() { share } else { format!(" ({share})") };
                format!("{kind}error {}{share}", format_length(error))
            }
            (None, pixels) => format!("{kind}errors up to {:.3} pixels", pixels.unwrap_or_default()),
        };
        let reverse = self.reverse_error.flatten().map_or_else(String::new, |error| {
            format!(", reverse error {} (sampled, {})", format_length(error), share(error, ""))
        });
        format!(
            "{}{before} -> {} triangles, {error}{reverse}{}, {}, {}{}",
            if diagonal.is_none() { format!("{}: ", written.path) } else { String::new() },
            format_count(written.triangle_count),
            placement_note(common.placement.unwrap_or_default()),
            written.stop_text(),
            format_duration(common.secs),
            written.note()
        )
    }
}
