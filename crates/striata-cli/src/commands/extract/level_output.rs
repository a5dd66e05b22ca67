//! Code shared by all kinds of extraction: output path, triangle limit, and primitives of a level.

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

/// Returns the internal error for a missing level, which the argument parser should have prevented.
pub(super) fn no_level() -> Failure {
    Failure::internal("no level was given")
}

/// Returns the primitives to write for a level.
///
/// Strips are those of its model, or new ones if these are shorter or the model has none.
///
/// # Errors
/// If the mesh is inconsistent.
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

/// Returns the bounds of the full mesh; for a bare stream, those of the finest level received.
///
/// # Errors
/// If the stream is damaged.
pub(super) fn bounds_of(file: &StriataFile<'_>, input: &Input) -> Result<Option<Bounds>, Failure> {
    match file.summary().bounds {
        Some(bounds) => Ok(Some(bounds)),
        None => Ok(file.mesh().map_err(|error| input.damaged(&error))?.bounds()),
    }
}

/// Returns the diagonal if the requested error is a percentage of it, else 0.
///
/// # Errors
/// If the stream is damaged.
pub(super) fn diagonal_of(level: &LevelArgs, file: &StriataFile<'_>, input: &Input) -> Result<f64, Failure> {
    match level.error {
        Some(Length::OfDiagonal(_)) => Ok(bounds_of(file, input)?.map_or(0.0, |b| b.diagonal())),
        _ => Ok(0.0),
    }
}

/// Returns the output path for a view or a box.
///
/// # Errors
/// If the path has a placeholder for a level and there is no level to fill it.
pub(super) fn view_output_path(args: &ExtractArgs) -> Result<PathBuf, Failure> {
    let paths = check_paths(&args.level, &args.levels, &args.output.output)?;
    paths.into_iter().next().ok_or_else(no_level)
}

/// Returns the largest number of triangles for a view or a box, if limited.
pub(super) fn triangle_limit(args: &ExtractArgs, file: &StriataFile<'_>) -> Option<usize> {
    args.level.triangle_count().map(|count| count.of_triangles(file.summary().triangle_count))
}
