//! `tiles --format zarr`: a mesh in refinement order as arrays.

use std::path::Path;
use std::time::Instant;

use serde::Serialize;
use striata_command::failure::Failure;
use striata_command::output::{Output, Table, format_count, format_duration, format_length};
use striata_tiles::{ZarrReport, check_folder, write_zarr};

use super::failure;
use crate::args::TilesArgs;
use crate::commands::{paged, strip_levels};

#[derive(Serialize)]
struct WrittenStore<'a> {
    output: &'a Path,
    seconds: f64,
    #[serde(flatten)]
    store: ZarrReport,
}

pub(super) fn run(args: &TilesArgs, output: &Output) -> Result<(), Failure> {
    let start = Instant::now();
    check_folder(&args.output).map_err(failure)?;
    let [path] = &args.inputs[..] else {
        return Err(Failure::usage("a Zarr store has one input").with_hint("write a store for each input"));
    };
    let input = paged::open_input(path, usize::MAX)?;
    let mut bar = output.bar();
    let refinable = strip_levels::refinable(&input, &mut bar, output)?;
    let is_guaranteed = match input.has_levels() {
        true => input.striata()?.has_guaranteed_errors().map_err(|error| input.damaged(&error))?,
        false => false,
    };
    let store = write_zarr(&refinable, is_guaranteed, &args.output, &mut |p| bar.show(p)).map_err(failure)?;
    drop(bar);
    store.left_out.iter().for_each(|warning| output.say(&format!("warning: {warning}")));
    let report = WrittenStore { output: &args.output, seconds: start.elapsed().as_secs_f64(), store };
    output.summary(&report, &text_of(&report, is_guaranteed))
}

fn text_of(report: &WrittenStore<'_>, is_guaranteed: bool) -> String {
    let store = &report.store;
    let mut table = Table::with_head(&["stored level", "vertices", "triangles", "error"]);
    for level in store.levels.iter().rev() {
        table.row(vec![
            level.path.clone(),
            format_count(level.vertices as usize),
            format_count(level.triangles as usize),
            format_length(level.error.into()),
        ]);
    }
    format!(
        "{}: {} arrays, {} levels; errors are {}\nwritten in {}\n\n{}",
        report.output.display(),
        store.arrays.len(),
        format_count(store.level_count as usize),
        if is_guaranteed { "guaranteed" } else { "estimates" },
        format_duration(report.seconds),
        table.to_text(),
    )
}
