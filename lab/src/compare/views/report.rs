//! Report of the view-dependent comparison.

use serde::Serialize;

use super::costs::CostRow;
use super::figures::Figures;
use super::followers::{FANS, Models, NAMES};
use super::memory::{self, MemoryRow};
use super::paths::Path;
use super::scenario::{Scenario, ScenarioRun};
use striata_command::output::format_count;

/// The report of one mesh.
#[derive(Clone, Debug, Serialize)]
pub(in crate::compare) struct ViewsReport {
    /// Number of triangles of the welded mesh.
    pub(super) triangle_count: usize,
    /// Width and height of the screen in pixels.
    pub(super) screen_px: u32,
    /// One entry per scenario.
    pub(super) paths: Vec<PathReport>,
    pub(super) memory: Vec<MemoryRow>,
    pub(super) refinement: Vec<CostRow>,
}

/// The report of one scenario.
#[derive(Clone, Debug, Serialize)]
pub(super) struct PathReport {
    pub name: &'static str,
    #[serde(skip)]
    pub path: Path,
    /// Allowed error on the screen, in pixels.
    pub pixels: f32,
    pub frame_count: usize,
    pub rounds: usize,
    pub contenders: Vec<FollowerReport>,
}

/// The report of one follower in one scenario.
#[derive(Clone, Debug, Serialize)]
pub(super) struct FollowerReport {
    pub name: &'static str,
    /// Why the follower cannot be built; null if it can.
    pub cannot_be_built: Option<String>,
    #[serde(flatten)]
    pub figures: Option<Figures>,
    /// Measurements of every frame.
    #[serde(skip)]
    pub run: Option<ScenarioRun>,
}

pub(super) fn pixels_word(pixels: f32) -> &'static str {
    if pixels == 1.0 { "pixel" } else { "pixels" }
}

impl PathReport {
    pub(super) fn new(
        scenario: Scenario,
        models: &Models<'_>,
        runs: Vec<Option<ScenarioRun>>,
        rounds: usize,
    ) -> Self {
        let vertex_count = models.refinable.mesh.vertex_count().max(1);
        let bytes = memory::static_bytes(models);
        let fans = runs[FANS].clone().unwrap_or_default();
        let contenders = NAMES.into_iter().zip(runs).zip(bytes).map(|((name, run), bytes)| FollowerReport {
            name,
            cannot_be_built: run.is_none().then(|| models.why_missing(name)).flatten(),
            figures: run.as_ref().map(|run| Figures::new(run, &fans, bytes, vertex_count)),
            run,
        });
        Self {
            name: scenario.path.as_str(),
            path: scenario.path,
            pixels: scenario.pixels,
            frame_count: fans.triangles.len(),
            rounds,
            contenders: contenders.collect(),
        }
    }

    pub(super) fn title(&self) -> String {
        format!("{}, {} {}", self.name, self.pixels, pixels_word(self.pixels))
    }

    /// Header and rows of the table.
    pub(super) fn table(&self) -> Vec<Vec<String>> {
        let head = [
            "model",
            "criterion",
            "update",
            "criterion + update",
            "x fans",
            "emission",
            "frame, ms",
            "x fans",
            "worst",
            "first",
            "triangles",
            "asked",
            "changes",
            "M per second",
            "error, px",
            "99 %",
            "instance, kB",
            "bytes per vertex",
        ];
        let mut table = vec![head.map(str::to_owned).to_vec()];
        table.extend(self.contenders.iter().map(FollowerReport::row));
        table
    }
}

impl FollowerReport {
    fn row(&self) -> Vec<String> {
        let Some(figures) = &self.figures else {
            return vec![self.name.to_owned(), "-".to_owned()];
        };
        let ms = |ms: f64| format!("{ms:.3}");
        let pixels = |px: Option<f64>| px.map_or_else(|| "-".to_owned(), |px| format!("{px:.2}"));
        vec![
            self.name.to_owned(),
            ms(figures.criterion_ms),
            ms(figures.update_ms),
            ms(figures.follow_ms),
            format!("{:.2}", figures.ratio_to_fans),
            ms(figures.emission_ms),
            ms(figures.frame_ms),
            format!("{:.2}", figures.frame_ratio_to_fans),
            ms(figures.worst_ms),
            ms(figures.first_ms),
            format_count(figures.triangles.round() as usize),
            format_count(figures.asked_per_frame.round() as usize),
            format_count(figures.changes_per_frame.round() as usize),
            figures.changes_per_sec.map_or_else(|| "-".to_owned(), |count| format!("{:.1}", count / 1e6)),
            pixels(figures.max_error_px),
            pixels(figures.p99_error_px),
            format!("{:.1}", figures.bytes_per_instance as f64 / 1e3),
            format!("{:.2}", figures.instance_bytes_per_vertex),
        ]
    }
}

impl ViewsReport {
    /// Names the followers that cannot be built, with the reason; empty if there are none.
    pub(super) fn missing(&self) -> String {
        let missing =
            self.paths.first().into_iter().flat_map(|path| &path.contenders).filter_map(|contender| {
                let why = contender.cannot_be_built.as_ref()?;
                Some(format!(" {} cannot be built: {why}.", contender.name))
            });
        missing.collect()
    }
}

/// Explanation of the tables of scenarios.
pub(super) const READING: &str = "Means per frame in ms, without the first frame, which begins at the \
    base. Criterion is the time to evaluate steps, update the rest of the time to change the mesh, and \
    emission writes the indices. Asked is the number of steps evaluated; changes are splits and \
    collapses per frame, and millions of them per second of criterion and update. Errors are distances \
    on the screen between the full mesh and the triangles shown, the largest and the 99th percentile. \
    Instance is the maximum memory owned, in kB and in bytes per vertex of the full mesh.";
