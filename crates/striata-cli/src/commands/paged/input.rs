//! Which inputs are built out of core, and how they are named on the command line.

use std::fs;
use std::path::{Path, PathBuf};

use serde_json::Value;
use striata_command::args::Length;
use striata_command::failure::Failure;
use striata_command::output::Output;
use striata_io::pieces::{PieceOptions, PieceSource};
use striata_paged::build::{BuildInput, BuildOptions, is_address};

use crate::args::CellArgs;

/// Prefix of generated inputs.
const SHAPE: &str = "shape:";
/// Factor by which compressed meshes grow, about.
const COMPRESSED_RATIO: u64 = 3;
/// Memory that an in-memory build takes per byte of the input file, about.
const MEMORY_PER_BYTE: u64 = 12;
/// Largest `.gltf` file that is read to learn how large its buffers are, in bytes.
const MAX_JSON_BYTES: u64 = 64 << 20;

/// Whether a file is too large to be built in memory.
pub(crate) fn is_too_large(path: &Path) -> bool {
    let size = file_bytes(path).saturating_add(buffer_bytes(path));
    let Ok(mut system) = sysinfo::System::new() else { return false };
    system.refresh_memory();
    let available = system.available_memory();
    available > 0 && size.saturating_mul(MEMORY_PER_BYTE) > available
}

/// Bytes of the temporary copy that a file needs to be read in pieces: text takes less as numbers, compressed files
/// take more.
pub(super) fn scratch_bytes(path: &Path) -> u64 {
    let size = file_bytes(path);
    match path.extension().unwrap_or_default().to_ascii_lowercase().to_str() {
        Some("gz" | "zst") => size.saturating_mul(COMPRESSED_RATIO),
        Some("obj" | "off") => size,
        _ => 0,
    }
}

fn file_bytes(path: &Path) -> u64 {
    fs::metadata(path).map_or(0, |metadata| metadata.len())
}

/// Size of the buffers that a `.gltf` file declares besides those within it.
fn buffer_bytes(path: &Path) -> u64 {
    let is_gltf = path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("gltf"));
    if !is_gltf || file_bytes(path) > MAX_JSON_BYTES {
        return 0;
    }
    let document = fs::read(path).ok().and_then(|bytes| serde_json::from_slice::<Value>(&bytes).ok());
    let buffers = document.as_ref().and_then(|document| document.get("buffers")?.as_array());
    let bytes = |buffer: &Value| {
        let is_file = buffer.get("uri")?.as_str().is_some_and(|uri| !uri.starts_with("data:"));
        buffer.get("byteLength")?.as_u64().filter(|_| is_file)
    };
    buffers.into_iter().flatten().filter_map(bytes).fold(0, u64::saturating_add)
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
        Failure::usage(format!("{name}: not a generated input of an out-of-core build"))
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
    let (exact, allow_merging) = (args.exact, args.allow_merging);
    let mut options = BuildOptions { exact, allow_merging, ..BuildOptions::default() };
    if let Some(cell) = args.cell {
        if !(1000..=1_000_000).contains(&cell) {
            return Err(Failure::usage(format!("--cell is {cell}, but must be 1000 to 1000000")));
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
            return Err(Failure::usage("--weld-distance must be a length in mesh units, larger than 0"));
        }
    };
    if let Some(z_scale) = args.z_scale {
        if !z_scale.is_finite() || z_scale == 0.0 {
            return Err(Failure::usage("--z-scale must be a number other than 0"));
        }
        options.z_scale = z_scale;
    }
    options.nodata = args.nodata;
    Ok(options)
}

/// The work folder of an output.
pub(super) fn work_folder(output: &Path, given: Option<&Path>) -> PathBuf {
    let default = || {
        // The work folder of an address is in the current folder.
        let here = is_address(output).then(|| output.file_name()).flatten();
        let mut name = here.unwrap_or(output.as_os_str()).to_owned();
        name.push(".work");
        PathBuf::from(name)
    };
    given.map_or_else(default, Path::to_owned)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn buffers_in_files_count() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("scene.gltf");
        let document = r#"{"buffers":[{"byteLength":7,"uri":"a.bin"},{"byteLength":5,"uri":"data:,"},
            {"byteLength":18446744073709551615,"uri":"b.bin"},{}]}"#;
        fs::write(&path, document).unwrap();
        assert_eq!(buffer_bytes(&path), u64::MAX);
        assert!(is_too_large(&path));
        fs::write(&path, r#"{"buffers":[{"byteLength":7,"uri":"a.bin"},{"byteLength":5}]}"#).unwrap();
        assert_eq!(buffer_bytes(&path), 7);
        assert_eq!(buffer_bytes(Path::new("no such.gltf")), 0);
    }
}
