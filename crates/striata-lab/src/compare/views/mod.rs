//! Models that follow an eye, side by side: what a frame costs, what an instance owns, and how far off the screen is.
//!
//! All go the same recorded paths. Fans and view-dependent progressive meshes are asked the same criterion; beside them stands a
//! level that is the same everywhere and as fine as the nearest point in the picture asks for.

mod asker;
mod charts;
mod costs;
mod course;
mod figures;
mod followers;
mod memory;
mod paths;
mod seen;

use serde::Serialize;
use striata::mesh::RefinableMesh;

pub(super) use self::charts::{by_size, sections};
use self::costs::CostRow;
use self::course::{Course, Run};
use self::figures::Figures;
use self::followers::{FANS, Models, NAMES};
use self::memory::MemoryRow;
use self::paths::{Path, SCREEN_PX};
use striata_command::failure::Failure;
use striata_command::output::{Bar, grouped};

/// All courses; the first is that of which memory is told.
const COURSES: [Course; 6] = [
    Course { path: Path::Orbit, pixels: 1.0 },
    Course { path: Path::Orbit, pixels: 5.0 },
    Course { path: Path::Jumps, pixels: 1.0 },
    Course { path: Path::Jumps, pixels: 5.0 },
    Course { path: Path::Dive, pixels: 1.0 },
    Course { path: Path::Inside, pixels: 1.0 },
];

/// What was measured of one mesh.
#[derive(Clone, Debug, Serialize)]
pub(super) struct ViewsReport {
    /// Of the welded mesh.
    triangle_count: usize,
    /// Of the screen, each way.
    screen_px: u32,
    /// Course by course.
    paths: Vec<PathReport>,
    memory: Vec<MemoryRow>,
    refinement: Vec<CostRow>,
}

/// One course.
#[derive(Clone, Debug, Serialize)]
struct PathReport {
    name: &'static str,
    #[serde(skip)]
    path: Path,
    /// Allowed on the screen.
    pixels: f32,
    frame_count: usize,
    rounds: usize,
    contenders: Vec<FollowerReport>,
}

/// A follower on one course.
#[derive(Clone, Debug, Serialize)]
struct FollowerReport {
    name: &'static str,
    /// Why there is nothing to tell; null where there is.
    cannot_be_built: Option<String>,
    #[serde(flatten)]
    figures: Option<Figures>,
    /// Every frame.
    #[serde(skip)]
    run: Option<Run>,
}

/// Builds the models and lets them go all courses.
///
/// # Errors
/// Where fans show different things with and without a memory, which is our fault.
pub(super) fn measure(
    refinable: &RefinableMesh,
    bar: &mut Bar,
    say: &dyn Fn(&str),
) -> Result<ViewsReport, Failure> {
    let models = Models::build(refinable);
    let mut memory = Vec::new();
    let mut paths = Vec::new();
    for course in COURSES {
        let name = course.path.as_str();
        say(&format!("{name}, {} {}", course.pixels, pixels_word(course.pixels)));
        let (runs, rounds) = course.go(&models, &mut |share| bar.share(name, share))?;
        if memory.is_empty() {
            memory = memory::measure(&models, &runs);
        }
        paths.push(PathReport::new(course, &models, runs, rounds));
    }
    say("refinement from the base");
    let refinement = costs::measure(&models)?;
    let triangle_count = refinable.mesh.triangle_count();
    Ok(ViewsReport { triangle_count, screen_px: SCREEN_PX, paths, memory, refinement })
}

fn pixels_word(pixels: f32) -> &'static str {
    if pixels == 1.0 { "pixel" } else { "pixels" }
}

impl PathReport {
    fn new(course: Course, models: &Models<'_>, runs: Vec<Option<Run>>, rounds: usize) -> Self {
        let vertex_count = models.refinable.mesh.vertex_count().max(1);
        let bytes = memory::static_bytes(models);
        let fans = runs[FANS].clone().unwrap_or_default();
        let contenders = NAMES.into_iter().zip(runs).zip(bytes).map(|((name, run), bytes)| FollowerReport {
            name,
            cannot_be_built: run.is_none().then(|| models.rival.as_ref().err().cloned()).flatten(),
            figures: run.as_ref().map(|run| Figures::new(run, &fans, bytes, vertex_count)),
            run,
        });
        Self {
            name: course.path.as_str(),
            path: course.path,
            pixels: course.pixels,
            frame_count: fans.triangles.len(),
            rounds,
            contenders: contenders.collect(),
        }
    }

    fn title(&self) -> String {
        format!("{}, {} {}", self.name, self.pixels, pixels_word(self.pixels))
    }

    /// Head and rows.
    fn table(&self) -> Vec<Vec<String>> {
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
            "M a second",
            "error, px",
            "99 %",
            "instance, kB",
            "bytes a vertex",
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
            grouped(figures.triangles.round() as usize),
            grouped(figures.asked_per_frame.round() as usize),
            grouped(figures.changes_per_frame.round() as usize),
            figures.changes_per_sec.map_or_else(|| "-".to_owned(), |count| format!("{:.1}", count / 1e6)),
            pixels(figures.max_error_px),
            pixels(figures.p99_error_px),
            format!("{:.1}", figures.bytes_per_instance as f64 / 1e3),
            format!("{:.2}", figures.instance_bytes_per_vertex),
        ]
    }
}

impl ViewsReport {
    /// Which followers cannot be built, and why; nothing where all can.
    fn missing(&self) -> String {
        let missing =
            self.paths.first().into_iter().flat_map(|path| &path.contenders).filter_map(|contender| {
                let why = contender.cannot_be_built.as_ref()?;
                Some(format!(" {} cannot be built: {why}.", contender.name))
            });
        missing.collect()
    }
}

/// How to read the tables of courses.
const READING: &str = "Means of a frame in ms, the first left out, which begins at the base. The criterion is asked, the \
    update is what else it takes to change the mesh, emission writes the indices. Steps are asked for; changes are splits and collapses of a frame, and millions of \
    them in a second of criterion and update. Errors are distances on the screen between the full mesh and what is shown, \
    the largest and what 99 of 100 points do not exceed. An instance is the most that one owned, in kB and in bytes a vertex of the full mesh.";

/// The tables for people, with what is to be known about them.
pub(super) fn to_text(report: &ViewsReport, text_of: impl Fn(Vec<Vec<String>>) -> String) -> String {
    let mut text =
        format!("Views of {px} x {px} pixels. {READING}{}\n", report.missing(), px = report.screen_px);
    for path in &report.paths {
        text.push_str(&format!("\n{}: {} frames {}\n", path.title(), path.frame_count, path.path.about()));
        text.push_str(&text_of(path.table()));
    }
    text.push_str("\nMemory, bytes a vertex of the full mesh; instances on the orbit at 1 pixel\n");
    text.push_str(&text_of(memory::table(&report.memory)));
    text.push_str("\nOne view from the base\n");
    text.push_str(&text_of(costs::table(&report.refinement)));
    text
}
