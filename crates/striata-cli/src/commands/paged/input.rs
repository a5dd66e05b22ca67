//! Which inputs are built out of core, and how they are named on the command line.

use std::fs;
use std::path::{Path, PathBuf};

use striata_command::args::Length;
use striata_command::failure::Failure;
use striata_command::output::Output;
use striata_io::pieces::{PieceOptions, PieceSource};
use striata_paged::build::{BuildInput, BuildOptions};

use crate::args::CellArgs;

/// Prefix of generated inputs.
const SHAPE: &str = "shape:";
/// Memory that an in-memory build takes per byte of the input file, about.
const MEMORY_PER_BYTE: u64 = 12;

/// Whether a file is too large to be built in memory.
pub(crate) fn is_too_large(path: &Path) -> bool {
    let size = fs::metadata(path).map_or(0, |metadata| metadata.len());
    let Ok(mut system) = sysinfo::System::new() else { return false };
    system.refresh_memory();
    let available = system.available_memory();
    available > 0 && size.saturating_mul(MEMORY_PER_BYTE) > available
}

/// Whether a name stands for an input that only an out-of-core build reads.
pub(crate) fn is_streamed_only(path: &Path) -> bool {
    let extension = path.extension().unwrap_or_default().to_ascii_lowercase();
    is_generated(path) || ["tif", "tiff", "hgt", "png"].iter().any(|&raster| extension == raster)
}

/// Whether a name stands for an input that is generated piece by piece.
pub(crate) fn is_generated(path: &Path) -> bool {
    let name = path.to_string_lossy();
    name.starts_with("shape:terrain:") || name.starts_with("shape:tiles:")
}

/// Opens an input that is generated piece by piece.
///
/// # Errors
/// If the name has a number out of range, or the file of tiles cannot be read.
pub(crate) fn open_generated(path: &Path) -> Result<Box<dyn PieceSource>, Failure> {
    build_input(&[path.to_owned()])?.open(&PieceOptions::default()).map_err(super::failure)
}

/// The input of a build.
///
/// # Errors
/// If a name is not understood.
pub(super) fn build_input(paths: &[PathBuf]) -> Result<BuildInput, Failure> {
    let [path] = paths else { return Ok(BuildInput::Files(paths.to_vec())) };
    let name = path.to_string_lossy();
    let Some(shape) = name.strip_prefix(SHAPE) else { return Ok(BuildInput::Files(paths.to_vec())) };
    let wrong = || {
        Failure::user(format!("{name}: not a generated input of an out-of-core build"))
            .with_hint("use shape:terrain:SAMPLES_PER_SIDE or shape:tiles:COUNT:FILE")
    };
    let mut words = shape.splitn(3, ':');
    match (words.next(), words.next(), words.next()) {
        (Some("terrain"), Some(side), None) => {
            let side = side.parse().ok().filter(|&side| (2..=200_000).contains(&side));
            Ok(BuildInput::Terrain(side.ok_or_else(wrong)?))
        }
        (Some("tiles"), Some(count), Some(path)) => {
            let count = count.parse().ok().filter(|&count| (1..=1_000_000).contains(&count));
            Ok(BuildInput::Tiles { count: count.ok_or_else(wrong)?, path: path.into() })
        }
        _ => Err(wrong()),
    }
}

/// The options of a build.
///
/// # Errors
/// If one is out of range.
pub(super) fn build_options(args: &CellArgs, output: &Output) -> Result<BuildOptions, Failure> {
    let mut options = BuildOptions { exact: args.exact, ..BuildOptions::default() };
    if let Some(cell) = args.cell {
        if !(1000..=1_000_000).contains(&cell) {
            return Err(Failure::user(format!("--cell is {cell}, but must be 1000 to 1000000")));
        }
        if cell < 16_000 {
            output.say("note: cells of fewer than 16,000 triangles cost accuracy");
        }
        options.cell = cell;
    }
    options.weld_distance = match args.weld_distance {
        Some(Length::Absolute(distance)) if distance > 0.0 && distance.is_finite() => Some(distance),
        None => None,
        Some(_) => {
            return Err(Failure::user("--weld-distance must be a length in mesh units, larger than 0"));
        }
    };
    if let Some(z_scale) = args.z_scale {
        if !z_scale.is_finite() || z_scale == 0.0 {
            return Err(Failure::user("--z-scale must be a number other than 0"));
        }
        options.z_scale = z_scale;
    }
    Ok(options)
}

/// The work folder of an output.
pub(super) fn work_folder(output: &Path, given: Option<&Path>) -> PathBuf {
    let beside = || {
        let mut name = output.as_os_str().to_owned();
        name.push(".work");
        PathBuf::from(name)
    };
    given.map_or_else(beside, Path::to_owned)
}
