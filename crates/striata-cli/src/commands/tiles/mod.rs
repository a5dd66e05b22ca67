//! `tiles`: 3D Tiles, or meshes for Neuroglancer, of a paged file, or of any input, which is built into one first; or
//! arrays in refinement order of a mesh.

mod neuroglancer;
mod zarr;

use std::path::{Path, PathBuf};
use std::time::Instant;

use serde::Serialize;
use striata_command::failure::Failure;
use striata_command::input::Input;
use striata_command::output::{Output, Table, format_bytes, format_count, format_duration, format_length};
use striata_io::WriteOptions;
use striata_paged::PagedFile;
use striata_tiles::{
    TileFormat, TileLevel, TilesError, TilesOptions, TilesReport, Up, check_output, write_tiles,
};
use tempfile::TempDir;

use super::paged;
use crate::args::{TilesArgs, TilesFormat, UpAxis};

/// Vertices of pages in memory, unless `--memory` allows fewer.
const MAX_VERTICES: u64 = 4_000_000;
/// Memory per vertex of a page.
const VERTEX_BYTES: u64 = 60;
/// Largest error of a linear place on the Earth that is not worth a remark, in meters.
const SMALL_ERROR: f64 = 0.5;

#[derive(Serialize)]
struct WrittenTileset<'a> {
    output: &'a Path,
    seconds: f64,
    #[serde(flatten)]
    tileset: TilesReport,
}

/// Writes tiles.
///
/// # Errors
/// If the input cannot be read or built, or the output cannot be written.
pub(crate) fn run(args: &TilesArgs, output: &Output) -> Result<(), Failure> {
    let (flag, format) = match args.format {
        TilesFormat::Tiles3d => (args.neuroglancer.first_given_flag(), "3D Tiles"),
        TilesFormat::Neuroglancer => (args.first_flag_of_3d_tiles(), "meshes of Neuroglancer"),
        TilesFormat::Zarr => {
            let of_tiles = args.first_flag_of_3d_tiles().or(args.neuroglancer.first_given_flag());
            let of_tiles = of_tiles.or(args.tile_triangles.map(|_| "--tile-triangles"));
            (of_tiles.or(args.build.first_given_flag()), "Zarr stores")
        }
    };
    if let Some(flag) = flag {
        let message = format!("{flag} has no effect on {format}");
        return Err(Failure::usage(message).with_hint(format!("remove {flag}, or choose another --format")));
    }
    match args.format {
        TilesFormat::Tiles3d => write_tileset(args, output),
        TilesFormat::Neuroglancer => neuroglancer::run(args, output),
        TilesFormat::Zarr => zarr::run(args, output),
    }
}

fn write_tileset(args: &TilesArgs, output: &Output) -> Result<(), Failure> {
    let start = Instant::now();
    // Reported before hours of work, not after them.
    check_output(&args.output).map_err(failure)?;
    let (mut file, _work) = opened(&args.inputs, args, output)?;
    let mut bar = output.bar();
    let options = options_of(args);
    let tileset = write_tiles(&mut file, &args.output, &options, &mut |p| bar.show(p)).map_err(failure)?;
    drop(bar);
    tileset.left_out.iter().for_each(|warning| output.say(&format!("warning: {warning}")));
    if let Some(error) = tileset.curvature_error.filter(|&error| error > SMALL_ERROR) {
        let error = format_length(error);
        output
            .say(&format!("note: tiles do not follow the curvature of the Earth: corners are {error} m off"));
    }
    let report = WrittenTileset { output: &args.output, seconds: start.elapsed().as_secs_f64(), tileset };
    output.summary(&report, &text_of(&report))
}

fn options_of(args: &TilesArgs) -> TilesOptions {
    let mut options = TilesOptions::default();
    options.tile_triangles = args.tile_triangles.unwrap_or(options.tile_triangles);
    options.format = match (args.quantize, args.meshopt, args.draco) {
        (_, _, true) => TileFormat::Draco,
        (_, true, _) => TileFormat::Meshopt,
        (true, ..) => TileFormat::Quantized,
        _ => TileFormat::Float,
    };
    options.up = args.up.map(|up| match up {
        UpAxis::Y => Up::Y,
        UpAxis::Z => Up::Z,
    });
    options.has_textures = !args.no_textures;
    options.texture_quality = args.texture_quality.unwrap_or(options.texture_quality);
    (options.is_local, options.has_skirts, options.shading) = (args.local, args.skirts, !args.raw);
    options
}

/// The paged file of some inputs, and the folder that it is in if it is a temporary one.
fn opened(
    inputs: &[PathBuf],
    args: &TilesArgs,
    output: &Output,
) -> Result<(PagedFile, Option<TempDir>), Failure> {
    let (pages, work) = pages_of(inputs, args, output)?;
    let memory = args.build.memory.map_or(u64::MAX, |size| size.0 / 4 / VERTEX_BYTES);
    let file = PagedFile::open(&pages.to_string_lossy()).map_err(paged::failure_of)?;
    Ok((file.with_max_vertices(memory.min(MAX_VERTICES)), work))
}

fn pages_of(
    inputs: &[PathBuf],
    args: &TilesArgs,
    output: &Output,
) -> Result<(PathBuf, Option<TempDir>), Failure> {
    if let [path] = inputs
        && paged::is_paged_file(path)
    {
        let flag = args.build.cells.first_given_flag();
        let Some(flag) = flag else { return Ok((path.clone(), None)) };
        let message = format!("{}: {flag} has no effect on a paged file", path.display());
        return Err(Failure::usage(message).with_hint(format!("remove {flag}")));
    }
    let parent = args.output.parent().filter(|parent| !parent.as_os_str().is_empty());
    let mut builder = tempfile::Builder::new();
    let work = builder.prefix(".striata-").suffix(".work").tempdir_in(parent.unwrap_or(Path::new(".")));
    let work = work.map_err(|error| Failure::user(format!("{}: {error}", args.output.display())))?;
    let mut inputs = inputs.to_vec();
    if let [path] = &mut inputs[..]
        && is_read_at_once(path)
    {
        let mesh = Input::open(path)?.mesh(output)?;
        *path = work.path().join("mesh.glb");
        striata_io::write(&path, &mesh, &WriteOptions::default())?;
    }
    let pages = work.path().join("pages.striata");
    paged::build_pages(&inputs, &args.build, &pages, output)?;
    Ok((pages, Some(work)))
}

/// Whether an input has no reader for pieces: built-in shapes, stdin, and what has levels already.
fn is_read_at_once(path: &Path) -> bool {
    let name = path.to_string_lossy();
    let has_levels = ["striata", "stri"]
        .iter()
        .any(|&known| path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case(known)));
    name == "-" || has_levels || name.starts_with("shape:") && !paged::is_generated(path)
}

fn text_of(report: &WrittenTileset<'_>) -> String {
    let tileset = &report.tileset;
    let table = table_of(&tileset.levels, "tiles");
    let place = match tileset.epsg {
        Some(epsg) => format!("on the Earth (EPSG:{epsg})"),
        None => "in the coordinates of the input".to_owned(),
    };
    let images = match tileset.image_bytes {
        0 => String::new(),
        bytes => {
            let atlases = format_count(tileset.atlases as usize);
            format!(" ({} of images, {atlases} atlases)", format_bytes(bytes as usize))
        }
    };
    format!(
        "{}: {} tiles of {} levels, {}{images}, {place}; errors are estimates\nwritten in {}\n\n{}",
        report.output.display(),
        format_count(tileset.tiles as usize),
        tileset.levels.len(),
        format_bytes(tileset.bytes as usize),
        format_duration(report.seconds),
        table.to_text(),
    )
}

fn table_of(levels: &[TileLevel], tiles: &str) -> Table {
    let mut table = Table::with_head(&["level", tiles, "triangles", "bytes", "error"]);
    for (number, level) in levels.iter().enumerate().rev() {
        table.row(vec![
            number.to_string(),
            format_count(level.tiles as usize),
            format_count(level.triangles as usize),
            format_bytes(level.bytes as usize),
            format_length(level.error),
        ]);
    }
    table
}

fn failure(error: TilesError) -> Failure {
    let text = error.to_string();
    match error {
        TilesError::Paged(error) => paged::failure_of(error),
        TilesError::Write(error) => Failure::from(error),
        TilesError::Place { .. } => Failure::usage(text).with_hint("choose another name"),
        TilesError::Skirts { .. } => {
            Failure::usage(text).with_hint("remove --skirts, or say which axis is --up")
        }
        TilesError::CoordinateSystem { .. } | TilesError::OffTheMap { .. } => {
            Failure::user(text).with_hint("add --local to keep the coordinates of the input")
        }
        _ => Failure::user(text),
    }
}
