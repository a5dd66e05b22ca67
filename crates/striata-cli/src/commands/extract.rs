//! `extract`: one level of a .striata file as a mesh.

use std::time::Instant;

use serde::Serialize;
use striata::strip::StripSet;
use striata_io::Format;

use crate::args::{ExtractArgs, TriangleForm};
use crate::failure::Failure;
use crate::input::Input;
use crate::level::choose;
use crate::output::{Output, grouped, lasted};
use crate::save::{format_of, is_stdout, save};

#[derive(Serialize)]
struct Report {
    model: &'static str,
    split_count: usize,
    vertex_count: usize,
    triangle_count: usize,
    error: f32,
    stop_reason: &'static str,
    seek_secs: f64,
    secs: f64,
}

/// Opens the file, goes to the level, writes it.
///
/// # Errors
/// Where any of it fails.
pub(crate) fn run(args: &ExtractArgs, output: &Output) -> Result<(), Failure> {
    let started = Instant::now();
    output.check_stdout_is_free(is_stdout(&args.output.output))?;
    check_form(args)?;
    let input = Input::open(&args.input)?;
    let file = input.striata()?;
    todo!()
}

/// # Errors
/// Where strips are asked for in a format that has none.
fn check_form(args: &ExtractArgs) -> Result<(), Failure> {
    let format = format_of(&args.output.output, &args.output.format)?;
    if args.form == TriangleForm::Strips && !matches!(format, Format::Glb | Format::Gltf) {
        return Err(Failure::user(format!("{format} has no strips")).with_hint("write .glb or .gltf, or --as list"));
    }
    Ok(())
}
