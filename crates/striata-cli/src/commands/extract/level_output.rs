//! What the ways of extracting a level share: where it goes, how large it may be, how its triangles are
//! written.

use std::path::PathBuf;

use striata::file::StriataFile;
use striata::mesh::{Bounds, IndexedMesh};
use striata::strip::StripSet;

use crate::args::{ExtractArgs, TriangleForm};
use crate::strip_lists::StripLists;
use striata_command::args::{Length, LevelArgs};
use striata_command::failure::Failure;
use striata_command::fan_cover::cover_with_fans;
use striata_command::input::Input;
use striata_command::level::check_paths;
use striata_command::save::Primitives;

/// The parser sees to it that there is a level.
pub(super) fn no_level() -> Failure {
    Failure::internal("no level was given")
}

/// What is written of a level. Strips come from its model, or are made anew if it has none or if new ones are
/// shorter.
///
/// # Errors
/// Where the mesh's parts do not fit together.
pub(super) fn primitives_of(
    form: TriangleForm,
    mesh: &IndexedMesh,
    strips: Option<StripSet>,
) -> Result<Primitives, Failure> {
    Ok(match form {
        TriangleForm::List => Primitives::Triangles,
        TriangleForm::Strips => Primitives::Strips(StripLists::of_level(mesh, strips.as_ref())?.lists),
        TriangleForm::Fans => Primitives::Fans(cover_with_fans(mesh)),
    })
}

/// The bounds of the full mesh; of a stream without a file around it, those of what is there.
///
/// # Errors
/// Where the stream is unsound.
pub(super) fn bounds_of(file: &StriataFile<'_>, input: &Input) -> Result<Option<Bounds>, Failure> {
    match file.summary().bounds {
        Some(bounds) => Ok(Some(bounds)),
        None => Ok(file.mesh().map_err(|error| input.damaged(&error))?.bounds()),
    }
}

/// The diagonal that an error is a share of; 0 where none is.
///
/// # Errors
/// Where the stream is unsound.
pub(super) fn diagonal_of(level: &LevelArgs, file: &StriataFile<'_>, input: &Input) -> Result<f64, Failure> {
    match level.error {
        Some(Length::OfDiagonal(_)) => Ok(bounds_of(file, input)?.map_or(0.0, |b| b.diagonal())),
        _ => Ok(0.0),
    }
}

/// Where a view or a box goes.
///
/// # Errors
/// If its name has a place for a level and there is none.
pub(super) fn view_output_path(args: &ExtractArgs) -> Result<PathBuf, Failure> {
    let paths = check_paths(&args.level, &args.levels, &args.output.output)?;
    paths.into_iter().next().ok_or_else(no_level)
}

/// The number of triangles that a view or a box may have.
pub(super) fn triangle_limit(args: &ExtractArgs, file: &StriataFile<'_>) -> Option<usize> {
    args.level.triangle_count().map(|count| count.of_triangles(file.summary().triangle_count))
}
