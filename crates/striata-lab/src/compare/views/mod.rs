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
mod report;
mod seen;

use striata::mesh::RefinableMesh;

pub(super) use self::charts::{by_size, sections};
use self::course::Course;
use self::followers::Models;
use self::paths::{Path, SCREEN_PX};
pub(super) use self::report::ViewsReport;
use self::report::{PathReport, READING, pixels_word};
use striata_command::failure::Failure;
use striata_command::output::Bar;

/// All courses; the first is that of which memory is told.
const COURSES: [Course; 6] = [
    Course { path: Path::Orbit, pixels: 1.0 },
    Course { path: Path::Orbit, pixels: 5.0 },
    Course { path: Path::Jumps, pixels: 1.0 },
    Course { path: Path::Jumps, pixels: 5.0 },
    Course { path: Path::Dive, pixels: 1.0 },
    Course { path: Path::Inside, pixels: 1.0 },
];

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
