//! Compares models that follow a camera: time per frame, memory per instance, and error on the screen.
//!
//! All of them follow the same recorded paths. Fans and view-dependent progressive meshes evaluate the same
//! criterion; for comparison there is a uniform level that is as fine as the nearest visible point requires.

mod charts;
mod costs;
mod figures;
mod followers;
mod logged_criterion;
mod memory;
mod paths;
mod report;
mod scenario;
mod screen_errors;

use striata::mesh::RefinableMesh;

pub(super) use self::charts::{by_size, sections};
use self::followers::Models;
use self::paths::{Path, SCREEN_PX};
pub(super) use self::report::ViewsReport;
use self::report::{PathReport, READING, pixels_word};
use self::scenario::Scenario;
use striata_command::failure::Failure;
use striata_command::output::Bar;

/// All scenarios; memory is reported for the first one.
const SCENARIOS: [Scenario; 6] = [
    Scenario { path: Path::Orbit, pixels: 1.0 },
    Scenario { path: Path::Orbit, pixels: 5.0 },
    Scenario { path: Path::Jumps, pixels: 1.0 },
    Scenario { path: Path::Jumps, pixels: 5.0 },
    Scenario { path: Path::Dive, pixels: 1.0 },
    Scenario { path: Path::Inside, pixels: 1.0 },
];

/// Builds the models and runs all scenarios.
///
/// # Errors
/// If fans with and without memory show different triangles, which would be a bug.
pub(super) fn measure(
    refinable: &RefinableMesh,
    bar: &mut Bar,
    say: &dyn Fn(&str),
) -> Result<ViewsReport, Failure> {
    let models = Models::build(refinable);
    let mut memory = Vec::new();
    let mut paths = Vec::new();
    for scenario in SCENARIOS {
        let name = scenario.path.as_str();
        say(&format!("{name}, {} {}", scenario.pixels, pixels_word(scenario.pixels)));
        let (runs, rounds) = scenario.run(&models, &mut |share| bar.share(name, share))?;
        if memory.is_empty() {
            memory = memory::measure(&models, &runs);
        }
        paths.push(PathReport::new(scenario, &models, runs, rounds));
    }
    say("refinement from the base");
    let refinement = costs::measure(&models)?;
    let triangle_count = refinable.mesh.triangle_count();
    Ok(ViewsReport { triangle_count, screen_px: SCREEN_PX, paths, memory, refinement })
}

/// The tables, with explanations of their columns.
pub(super) fn to_text(report: &ViewsReport, text_of: impl Fn(Vec<Vec<String>>) -> String) -> String {
    let mut text =
        format!("Views of {px} x {px} pixels. {READING}{}\n", report.missing(), px = report.screen_px);
    for path in &report.paths {
        text.push_str(&format!("\n{}: {} frames {}\n", path.title(), path.frame_count, path.path.about()));
        text.push_str(&text_of(path.table()));
    }
    text.push_str("\nMemory in bytes per vertex of the full mesh; instances on the orbit at 1 pixel\n");
    text.push_str(&text_of(memory::table(&report.memory)));
    text.push_str("\nOne view from the base\n");
    text.push_str(&text_of(costs::table(&report.refinement)));
    text
}
