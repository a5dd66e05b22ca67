//! Arguments of `tiles`.

use std::path::PathBuf;

use clap::{Args, ValueEnum};

use super::{ByteSize, CellArgs};

/// Arguments of `tiles`.
#[derive(Debug, Args)]
#[command(
    override_usage = "striata tiles [OPTIONS] <INPUT>... -o <FOLDER|OUT.3tz>",
    after_help = "Examples:\n  \
    striata tiles city.striata -o city-tiles --meshopt\n  \
    striata tiles N35E138.hgt N35E139.hgt -o fuji.3tz --draco --skirts"
)]
pub(crate) struct TilesArgs {
    /// Paged file, or meshes or rasters that are one mesh: these are built into a temporary paged file first
    #[arg(required = true)]
    pub inputs: Vec<PathBuf>,
    /// Folder to write tileset.json and the tiles to, or one file if it ends in .3tz; a tileset that is there is replaced
    #[arg(short, long, value_name = "FOLDER|OUT.3tz")]
    pub output: PathBuf,
    /// Triangles per tile, about
    #[arg(long, value_name = "N", default_value_t = 16_384, value_parser = clap::value_parser!(u64).range(100..=1_000_000))]
    pub tile_triangles: u64,
    /// Store integers of 16 bits (KHR_mesh_quantization) instead of floats
    #[arg(long, conflicts_with_all = ["meshopt", "draco"])]
    pub quantize: bool,
    /// Store integers, compressed with meshoptimizer (EXT_meshopt_compression)
    #[arg(long, conflicts_with = "draco")]
    pub meshopt: bool,
    /// Store integers, compressed with Draco (KHR_draco_mesh_compression)
    #[arg(long)]
    pub draco: bool,
    /// Keep a mesh without normals or materials as it is; viewers show it with flat facets, as white metal
    #[arg(long)]
    pub raw: bool,
    /// Leave out textures; texture coordinates stay
    #[arg(long, conflicts_with = "texture_quality")]
    pub no_textures: bool,
    /// Quality of the JPEG images of textures, from 1 to 100
    #[arg(long, value_name = "N", default_value_t = 90, value_parser = clap::value_parser!(u8).range(1..=100))]
    pub texture_quality: u8,
    /// Add vertical strips below the borders of the tiles of a terrain
    #[arg(long)]
    pub skirts: bool,
    /// Keep the coordinates of the input, although it has a place on the Earth
    #[arg(long)]
    pub local: bool,
    /// Axis of the input that is up: y or z [default: z for terrains and what is flat along z, else y]
    #[arg(long, value_name = "AXIS", hide_possible_values = true)]
    pub up: Option<UpAxis>,
    /// How the paged file is built.
    #[command(flatten)]
    pub build: PageBuildArgs,
}

/// How a paged file is built that only this verb reads.
#[derive(Debug, Args)]
pub(crate) struct PageBuildArgs {
    /// Work within so much memory: 4GB, 500MB
    #[arg(long, value_name = "SIZE")]
    pub memory: Option<ByteSize>,
    /// Threads that build the paged file [default: one per core, as far as memory allows]
    #[arg(long, value_name = "N")]
    pub threads: Option<usize>,
    /// How cells and positions are chosen.
    #[command(flatten)]
    pub cells: CellArgs,
}

/// Axis that is up.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum UpAxis {
    /// The y axis, as in glTF
    Y,
    /// The z axis, as in terrains
    Z,
}
