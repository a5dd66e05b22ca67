//! Arguments of builds that do not need the whole mesh in memory.

use std::path::PathBuf;
use std::str::FromStr;

use clap::Args;
use striata_command::args::Length;

use super::BaseArgs;
use super::threads::ThreadArgs;

/// Help heading of these flags.
const PAGED: &str = "Paged files, for meshes larger than memory";

/// How a mesh is built out of core.
#[derive(Debug, Args)]
pub(crate) struct PagedArgs {
    /// Build a paged file in tasks, whatever the size of the input [default: if it does not fit into memory]
    #[arg(long, help_heading = PAGED)]
    pub paged: bool,
    /// Build a paged file within so much memory: 4GB, 500MB
    #[arg(long, value_name = "SIZE", help_heading = PAGED)]
    pub memory: Option<ByteSize>,
    /// Folder for what tasks pass to each other [default: the output with .work appended]
    #[arg(long, value_name = "DIR", help_heading = PAGED)]
    pub work: Option<PathBuf>,
    /// Begin again, instead of going on with a build that was interrupted
    #[arg(long, help_heading = PAGED)]
    pub restart: bool,
    /// How cells and positions are chosen.
    #[command(flatten)]
    pub cells: CellArgs,
}

/// Arguments that change the result of an out-of-core build.
#[derive(Debug, Args)]
pub(crate) struct CellArgs {
    /// Triangles per page [default: 65536]
    #[arg(long, value_name = "N", help_heading = PAGED)]
    pub cell: Option<usize>,
    /// Join files whose borders differ by less than this (mesh units)
    #[arg(long, value_name = "DISTANCE", help_heading = PAGED)]
    pub weld_distance: Option<Length>,
    /// Keep positions and attributes bit for bit instead of rounding them to 1/256 of an edge
    #[arg(long, help_heading = PAGED)]
    pub exact: bool,
    /// Build even if rounding positions merges more than one in a thousand vertices
    #[arg(long, conflicts_with = "exact", help_heading = PAGED)]
    pub allow_merging: bool,
    /// Multiply the heights of a terrain
    #[arg(long, value_name = "FACTOR", allow_negative_numbers = true, help_heading = PAGED)]
    pub z_scale: Option<f64>,
    /// Take this sample of a raster for none, besides the one that the file names
    #[arg(long, value_name = "VALUE", allow_negative_numbers = true, help_heading = PAGED)]
    pub nodata: Option<f64>,
}

impl PagedArgs {
    /// Whether any flag asks for a paged file.
    pub(crate) fn is_given(&self) -> bool {
        self.paged
            || self.memory.is_some()
            || self.work.is_some()
            || self.restart
            || self.cells.first_given_flag().is_some()
    }
}

impl CellArgs {
    /// Returns the first flag that the user gave.
    pub(crate) fn first_given_flag(&self) -> Option<&'static str> {
        let Self { cell, weld_distance, exact, allow_merging, z_scale, nodata } = self;
        let flags = [
            ("--cell", cell.is_some()),
            ("--weld-distance", weld_distance.is_some()),
            ("--exact", *exact),
            ("--allow-merging", *allow_merging),
            ("--z-scale", z_scale.is_some()),
            ("--nodata", nodata.is_some()),
        ];
        flags.into_iter().find(|&(_, is_given)| is_given).map(|(flag, _)| flag)
    }
}

/// Arguments of `plan`.
#[derive(Debug, Args)]
#[command(
    override_usage = "striata plan [OPTIONS] <INPUT>... -o <OUT>",
    after_help = "Examples:\n  \
    striata plan scans/*.ply -o city.striata\n  \
    striata plan N35E138.hgt N35E139.hgt -o fuji.striata --workers 8,64"
)]
pub(crate) struct PlanArgs {
    /// Meshes or rasters that are one mesh
    #[arg(required = true)]
    pub inputs: Vec<PathBuf>,
    /// File to write; without an extension, a folder with one object per page
    #[arg(short, long, value_name = "OUT")]
    pub output: PathBuf,
    /// Folder for the plan and for what tasks pass to each other [default: the output with .work appended]
    #[arg(long, value_name = "DIR")]
    pub work: Option<PathBuf>,
    /// Number of threads.
    #[command(flatten)]
    pub threads: ThreadArgs,
    /// Simulate the build on these numbers of workers, each with one core
    #[arg(long, value_name = "N,...", value_delimiter = ',', default_values_t = [1usize, 16, 256])]
    pub workers: Vec<usize>,
    /// Limits of the base mesh.
    #[command(flatten)]
    pub limits: BaseArgs,
    /// How cells and positions are chosen.
    #[command(flatten)]
    pub cells: CellArgs,
}

/// Arguments of `run`.
#[derive(Debug, Args)]
#[command(after_help = "Examples:\n  \
    striata run city.striata.work --task 17\n  \
    striata run city.striata.work")]
pub(crate) struct RunArgs {
    /// Plan, or the folder that it is in
    pub plan: PathBuf,
    /// Run only this task [default: all that have not been run]
    #[arg(long, value_name = "N")]
    pub task: Option<usize>,
    /// Number of threads.
    #[command(flatten)]
    pub threads: ThreadArgs,
}

/// A number of bytes, written with a unit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct ByteSize(pub(crate) u64);

impl FromStr for ByteSize {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        let wrong = || format!("{text:?} is not a size such as 4GB, 500MB or 1.5GiB");
        let text = text.trim();
        let digits = text.find(|c: char| !c.is_ascii_digit() && c != '.').unwrap_or(text.len());
        let number: f64 = text[..digits].parse().map_err(|_| wrong())?;
        let unit = match text[digits..].trim().to_ascii_lowercase().as_str() {
            "" | "b" => 1.0,
            "k" | "kb" => 1e3,
            "m" | "mb" => 1e6,
            "g" | "gb" => 1e9,
            "t" | "tb" => 1e12,
            "kib" => 1024.0,
            "mib" => 1024f64.powi(2),
            "gib" => 1024f64.powi(3),
            "tib" => 1024f64.powi(4),
            _ => return Err(wrong()),
        };
        let bytes = number * unit;
        if bytes >= 1e6 { Ok(Self(bytes as u64)) } else { Err(format!("{text} is less than 1 MB")) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sizes_have_units() {
        assert_eq!("4GB".parse(), Ok(ByteSize(4_000_000_000)));
        assert_eq!("1.5 GiB".parse(), Ok(ByteSize(1_610_612_736)));
        for text in ["", "GB", "4 pounds", "1", "-1GB", "1e9"] {
            assert!(text.parse::<ByteSize>().is_err(), "{text}");
        }
    }
}
