//! `build`: a mesh becomes one .striata file that holds every level.

use std::path::Path;

use serde::Serialize;
use serde_json::{Map, Value, json};
use striata::mesh::{IndexedMesh, RefinableMesh, weld};
use striata::model::lod_strips::LodStrips;
use striata::simplify::{
    BoundaryRule, CollapseCost, SequenceOptions, StopReason, build_welded_sequence,
};
use striata::strip::{StripCost, StripOptions, stripify};
use striata_io::write_atomically;

use crate::args::{BuildArgs, CostArg, SequenceArgs};
use crate::clock::{Phases, peak_rss_bytes};
use crate::failure::Failure;
use crate::input::Input;
use crate::output::{Bar, Output, Table, grouped, lasted, sized, to_stdout};
use crate::save::is_stdout;

/// The phases that a build reports.
pub(crate) const PHASES: [&str; 6] = ["read", "weld", "simplify", "strip", "models", "write"];

/// Orders of collapses that this version has.
const ORDERS: [&str; 1] = ["quadric"];

/// Models that this version has.
const MODELS: [&str; 1] = ["lodstrips"];

/// Reads, builds, writes, reports.
///
/// # Errors
/// Where any of it fails; the output is then as it was.
pub(crate) fn run(args: &BuildArgs, output: &Output) -> Result<(), Failure> {
    output.check_stdout_is_free(is_stdout(&args.output))?;
    check_models(&args.models)?;
    check_output_name(&args.output)?;
    let mut phases = Phases::new(&PHASES);
    let mut bar = output.bar();
    phases.enter("read");
    bar.phase("read");
    let mesh = Input::open(&args.input)?.mesh()?;
    let diagonal = mesh.diagonal();
    let mut options = args.sequence.options(diagonal)?;
    options.base_triangle_count = args.base.unwrap_or(0);
    options.max_error = args.max_error.map(|error| error.in_units(diagonal));
    let built = build(&mesh, &options, &mut phases, &mut bar)?;
    phases.enter("write");
    bar.phase("write");
    let bytes = built.to_bytes()?;
    if is_stdout(&args.output) {
        to_stdout(&bytes)?;
    } else {
        write_atomically(&args.output, |out| out.write_all(&bytes))?;
    }
    phases.leave();
    drop(bar);
    let report = Report::new(&mesh, &built, bytes.len(), phases);
    output.summary(&report, &report.to_text(&args.output, diagonal))
}
