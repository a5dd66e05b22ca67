//! The report on levels that `simplify`, `extract` and `decode` have made of anything.

use serde::Serialize;
use serde_json::Value;
use striata::model::ModelKind;

use super::super::placement::placement_note;
use striata_command::failure::Failure;
use striata_command::level::{WrittenLevel, table_of_levels};
use striata_command::output::{format_bytes, format_count, format_duration, format_length};

/// The report: on the only level, or on several in a list.
#[derive(Serialize)]
#[serde(untagged)]
pub(in crate::commands) enum LevelsReport {
    /// The members of the level are those of the report.
    One {
        #[serde(flatten)]
        level: Box<LevelReport>,
        #[serde(flatten)]
        how: HowMade,
    },
    /// The user asked for a list of levels.
    Several {
        /// The levels in the order of the user.
        levels: Vec<LevelReport>,
        error_is_guaranteed: bool,
        step_count: Option<usize>,
        #[serde(flatten)]
        how: HowMade,
        secs: f64,
    },
}

/// A level that was written.
#[derive(Serialize)]
pub(in crate::commands) struct LevelReport {
    #[serde(flatten)]
    pub written: WrittenLevel,
    /// Whether no point of the original is farther from the level than the error.
    pub error_is_guaranteed: bool,
    #[serde(flatten)]
    pub details: LevelDetails,
    pub secs: f64,
}

/// Members that depend on the kind of the source.
#[derive(Default, Serialize)]
pub(in crate::commands) struct LevelDetails {
    #[serde(skip_serializing_if = "Option::is_none")]
    pub model: Option<&'static str>,
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
    #[serde(skip_serializing_if = "Option::is_none")]
    pub split_count: Option<usize>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub step_count: Option<usize>,
    /// Largest sampled distance from the level to the original; null if one of them has no surface. Only reported for
    /// meshes with guaranteed errors, since that guarantee covers only distances from the original to the level.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub reverse_error: Option<Option<f64>>,
    /// The place of a terrain on the Earth.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub georeference: Option<Value>,
    /// For streams: what was read.
    #[serde(flatten)]
    pub stream: Option<StreamRead>,
    /// Time to read or decode what all levels need.
    #[serde(skip)]
    pub prepare_secs: f64,
    /// Time to find the level and make its mesh, with the time that all levels took to read or decode.
    pub seek_secs: f64,
    /// Whether the detail varies over the mesh.
    #[serde(skip)]
    pub is_varying: bool,
    /// Whether errors of levels of varying detail are guaranteed if those of uniform levels are.
    #[serde(skip)]
    pub has_guaranteed_views: bool,
}

/// Pages of a paged file that were read.
#[derive(Clone, Copy, Serialize)]
pub(in crate::commands) struct PagesRead {
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

/// The part of a stream that was read.
#[derive(Clone, Copy, Serialize)]
pub(in crate::commands) struct StreamRead {
    /// Whether the stream is complete.
    pub is_complete: bool,
    pub effort: &'static str,
    /// Number of bytes of the stream that were read.
    pub read_bytes: usize,
    /// Number of bytes of the stream needed for the level.
    pub level_bytes: Option<u64>,
    /// Size of the whole stream.
    pub stream_bytes: u64,
    pub file_bytes: Option<usize>,
    pub decode_secs: f64,
    /// Throughput of the decoder alone, after the base mesh.
    pub triangles_per_sec: f64,
}

/// How all levels of a report were made.
#[derive(Serialize, Default)]
pub(in crate::commands) struct HowMade {
    /// Order of the steps, for a mesh.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub order: Option<&'static str>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub placement: Option<&'static str>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub georeference: Option<Value>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub simplify_secs: Option<f64>,
}

impl LevelsReport {
    /// Creates the report on levels, which are a list if the user asked for one.
    ///
    /// # Errors
    /// If there is no level.
    pub(super) fn new(mut levels: Vec<LevelReport>, is_list: bool, secs: f64) -> Result<Self, Failure> {
        let how = HowMade::default();
        if is_list {
            let error_is_guaranteed = levels.iter().all(|level| level.error_is_guaranteed);
            let step_count = levels.first().and_then(|level| level.details.step_count);
            return Ok(Self::Several { levels, error_is_guaranteed, step_count, how, secs });
        }
        let level = levels.pop().ok_or_else(|| Failure::internal("no level was given"))?;
        Ok(Self::One { level: Box::new(level), how })
    }

    /// Adds how the levels were made.
    pub(in crate::commands) fn with_how(self, how: HowMade) -> Self {
        match self {
            Self::One { level, .. } => Self::One { level, how },
            Self::Several { levels, error_is_guaranteed, step_count, secs, .. } => {
                Self::Several { levels, error_is_guaranteed, step_count, how, secs }
            }
        }
    }
}

/// Describes levels that were extracted.
pub(in crate::commands) fn extracted_text(report: &LevelsReport) -> String {
    let (levels, secs) = match report {
        LevelsReport::One { level, .. } => return level.extracted_text(),
        LevelsReport::Several { levels, secs, .. } => (levels, secs),
    };
    let table = table_of_levels(levels.iter().map(|level| &level.written));
    let details = levels.first().map(|level| &level.details);
    match details.and_then(|details| details.stream.as_ref()) {
        Some(stream) => {
            format!("{table}{} of {} bytes decoded", format_count(stream.read_bytes), stream.whole())
        }
        None => {
            let from = details.and_then(|details| details.model).unwrap_or("the scene");
            format!("{table}extracted from {from} in {}", format_duration(*secs))
        }
    }
}

/// Describes a level that was decoded.
pub(in crate::commands) fn decoded_text(report: &LevelsReport) -> String {
    match report {
        LevelsReport::One { level, .. } => match &level.details.stream {
            Some(stream) => {
                format!("{} ({:.2} M triangles/s)", level.extracted_text(), stream.triangles_per_sec / 1e6)
            }
            None => level.extracted_text(),
        },
        LevelsReport::Several { .. } => extracted_text(report),
    }
}

/// Describes levels to which a mesh or scene of `before` triangles was simplified; for a mesh, errors are also shares of its
/// diagonal.
pub(in crate::commands) fn simplified_text(
    report: &LevelsReport,
    before: usize,
    diagonal: Option<f64>,
) -> String {
    let before = format_count(before);
    match report {
        LevelsReport::One { level, how } => level.simplified_text(how, &before, diagonal),
        LevelsReport::Several { levels, error_is_guaranteed, secs, .. } => {
            let kind = if *error_is_guaranteed { "guaranteed" } else { "estimated" };
            let table = table_of_levels(levels.iter().map(|level| &level.written));
            format!("{table}from {before} triangles, errors {kind}, {}", format_duration(*secs))
        }
    }
}

impl LevelReport {
    fn extracted_text(&self) -> String {
        let (written, details) = (&self.written, &self.details);
        let of_model = |model: ModelKind, origin: Option<&str>| {
            origin.map_or_else(String::new, |origin| format!(", {model} {origin}"))
        };
        let origin =
            of_model(ModelKind::Fans, details.fans) + &of_model(ModelKind::Patterns, details.patterns);
        let steps = match (details.split_count, details.step_count) {
            (Some(split_count), Some(step_count)) => {
                format!(", split {} of {}", format_count(split_count), format_count(step_count))
            }
            _ => String::new(),
        };
        let work = match &details.stream {
            Some(stream) => format!(
                "{} of {} bytes decoded in {}",
                format_count(stream.read_bytes),
                stream.whole(),
                format_duration(stream.decode_secs)
            ),
            None => format!("found in {}", format_duration(details.seek_secs)),
        };
        format!(
            "{} triangles, {} vertices{steps}, {}, {}; {work}{origin}{}{}",
            format_count(written.triangle_count),
            format_count(written.vertex_count),
            self.error_text(None),
            written.stop_text(),
            written.note(),
            details.pages.map_or_else(String::new, PagesRead::to_text)
        )
    }

    fn simplified_text(&self, how: &HowMade, before: &str, diagonal: Option<f64>) -> String {
        let written = &self.written;
        let reverse = self.details.reverse_error.flatten().map_or_else(String::new, |error| {
            let share = diagonal.map_or_else(String::new, |diagonal| share_text(error, diagonal));
            format!(", reverse error {} (sampled, {share})", format_length(error))
        });
        format!(
            "{}{before} -> {} triangles, {}{reverse}{}, {}, {}{}",
            if diagonal.is_none() { format!("{}: ", written.path) } else { String::new() },
            format_count(written.triangle_count),
            self.error_text(diagonal),
            placement_note(how.placement.unwrap_or_default()),
            written.stop_text(),
            format_duration(self.secs),
            written.note()
        )
    }

    fn error_text(&self, diagonal: Option<f64>) -> String {
        let kind = if self.error_is_guaranteed { "guaranteed " } else { "" };
        match (self.written.error, diagonal) {
            (Some(error), Some(diagonal)) => {
                let share = share_text(error, diagonal);
                format!("{kind}error {} ({share} of the diagonal)", format_length(error))
            }
            (Some(error), None) => format!("{kind}error {}", format_length(error)),
            (None, _) => {
                format!("{kind}errors up to {:.3} pixels", self.details.pixels.unwrap_or_default())
            }
        }
    }
}

fn share_text(error: f64, diagonal: f64) -> String {
    format!("{:.4} %", if diagonal > 0.0 { 100.0 * error / diagonal } else { 0.0 })
}

impl StreamRead {
    fn whole(&self) -> String {
        format_count(usize::try_from(self.stream_bytes).unwrap_or(usize::MAX))
    }
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
