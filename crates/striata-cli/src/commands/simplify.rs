//! `simplify`: one level of a mesh, without a .striata file.

use std::time::Instant;

use serde::Serialize;
use striata::simplify::{Placement, SimplifyOptions, simplify};

use crate::args::{PlacementArg, SimplifyArgs};
use crate::failure::Failure;
use crate::input::Input;
use crate::output::{Output, grouped, lasted, measured};
use crate::save::{Drawn, format_of, is_stdout, save};

#[derive(Serialize)]
struct Report {
    vertex_count: usize,
    triangle_count: usize,
    error: f64,
    stop_reason: &'static str,
    simplify_secs: f64,
    secs: f64,
}

/// Reads, simplifies, writes, reports.
///
/// # Errors
/// Where any of it fails.
pub(crate) fn run(args: &SimplifyArgs, output: &Output) -> Result<(), Failure> {
    let started = Instant::now();
    output.check_stdout_is_free(is_stdout(&args.output.output))?;
    format_of(&args.output.output, &args.output.format)?;
    let mut bar = output.bar();
    bar.phase("read");
    let input = Input::open(&args.input)?;
    let mesh = input.mesh()?;
    let diagonal = mesh.diagonal();
    let options = SimplifyOptions::default()
        .with_target(args.level.target(diagonal)?)
        .with_placement(args.placement.into())
        .with_sequence(args.sequence.options(diagonal)?);
    let simplify_started = Instant::now();
    let simplified = simplify(&mesh, &options, &mut |progress| bar.show(progress))
        .map_err(|error| Failure::from(error).in_file(&input.name))?;
    let simplify_secs = simplify_started.elapsed().as_secs_f64();
    bar.phase("write");
    save(&simplified.mesh, Drawn::Triangles, &args.output.output, &args.output.format)?;
    drop(bar);
    let report = Report {
        vertex_count: simplified.mesh.vertex_count(),
        triangle_count: simplified.mesh.triangle_count(),
        error: simplified.error,
        stop_reason: simplified.stop_reason.as_str(),
        simplify_secs,
        secs: started.elapsed().as_secs_f64(),
    };
    output.summary(&report, &report.to_text(mesh.triangle_count(), diagonal))
}

impl Report {
    fn to_text(&self, before: usize, diagonal: f64) -> String {
        let share = if diagonal > 0.0 { 100.0 * self.error / diagonal } else { 0.0 };
        format!(
            "{} -> {} triangles, error {} ({share:.4} % of the diagonal), {}, {}",
            grouped(before),
            grouped(self.triangle_count),
            measured(self.error),
            self.stop_reason.replace('_', " "),
            lasted(self.secs)
        )
    }
}

impl From<PlacementArg> for Placement {
    fn from(placement: PlacementArg) -> Self {
        match placement {
            PlacementArg::Subset => Self::Subset,
            PlacementArg::Optimal => Self::Optimal,
        }
    }
}
