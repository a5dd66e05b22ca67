//! `show`: pictures of the structures in the papers, for a small part of any mesh.
//!
//! The part is nearly flat and is drawn as seen along its mean normal (`patch`). Models are built from the part
//! alone, so what a picture shows can be followed to its end.

mod fan;
mod mts;
mod patch;
mod pattern;
mod sheet;
mod tunnel;

use serde::Serialize;
use striata_command::failure::Failure;
use striata_command::input::Input;
use striata_command::output::Output;
use striata_command::save::write_bytes;

use self::patch::MeshPatch;
use self::sheet::FigureSheet;
use crate::args::{ShowArgs, Structure};

#[derive(Serialize)]
struct ShowReport {
    path: String,
    what: &'static str,
    /// Triangles of the part that is drawn.
    triangle_count: usize,
}

/// Draws the structure and writes the picture.
///
/// # Errors
/// If the mesh cannot be read, has no part with such a structure, or the file cannot be written.
pub(crate) fn run(args: &ShowArgs, output: &Output) -> Result<(), Failure> {
    if args.output.extension().is_none_or(|extension| !extension.eq_ignore_ascii_case("svg")) {
        return Err(Failure::user(format!(
            "{}: pictures are SVG files; name it .svg",
            args.output.display()
        )));
    }
    let mesh = Input::open(&args.input)?.mesh(output)?;
    let count = args.triangles.unwrap_or(if args.what == Structure::Mts { 14 } else { 60 });
    let none = || {
        let what = args.what.as_str();
        Failure::user(format!("{}: its flattest {count} triangles contain no {what}", args.input.display()))
    };
    let patch = MeshPatch::of(&mesh, count as usize)?.ok_or_else(none)?;
    let mut sheet = FigureSheet::default();
    let is_drawn = match args.what {
        Structure::Mts => mts::draw(&patch, &mut sheet)?,
        Structure::Tunnel => tunnel::draw(&patch, &mut sheet)?,
        Structure::Fan => fan::draw(&patch, &mut sheet)?,
        Structure::Pattern => pattern::draw(&patch, &mut sheet)?,
    };
    if !is_drawn {
        return Err(none());
    }
    write_bytes(sheet.to_svg()?.as_bytes(), &args.output)?;
    let path = args.output.display().to_string();
    let triangle_count = patch.mesh.triangle_count();
    let text = format!("{path}: {} in {triangle_count} triangles", args.what.as_str());
    output.data(&ShowReport { path, what: args.what.as_str(), triangle_count }, &text)
}
