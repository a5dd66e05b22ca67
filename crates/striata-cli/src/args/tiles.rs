//! Arguments of `tiles`.

use std::path::PathBuf;

use clap::{Args, ValueEnum};

use super::threads::ThreadArgs;
use super::{ByteSize, CellArgs};

/// Arguments of `tiles`.
#[derive(Debug, Args)]
#[command(
    override_usage = "striata tiles [OPTIONS] <INPUT>... -o <FOLDER|OUT.3tz>",
    after_help = "Examples:\n  \
    striata tiles N35E138.hgt N35E139.hgt -o fuji.3tz --draco --skirts\n  \
    striata tiles neurons/ -o meshes --format neuroglancer --sharded"
)]
pub(crate) struct TilesArgs {
    /// Paged file, or meshes or rasters that are one mesh: these are built into a temporary paged file first; for
    /// neuroglancer also a folder with a mesh ID.ply, ID.obj, ... for each segment
    #[arg(required = true)]
    pub inputs: Vec<PathBuf>,
    /// Folder to write the tiles to, or one file if it ends in .3tz (3D Tiles); tiles that are there are replaced
    #[arg(short, long, value_name = "FOLDER|OUT.3tz")]
    pub output: PathBuf,
    /// Format: 3D Tiles 1.1, meshes of Neuroglancer (neuroglancer_multilod_draco), or arrays in refinement order (Zarr v3)
    #[arg(long, value_name = "FORMAT", default_value = "3dtiles")]
    pub format: TilesFormat,
    /// Options of meshes for Neuroglancer.
    #[command(flatten)]
    pub neuroglancer: NeuroglancerArgs,
    /// Triangles per tile or fragment, about [default: 16384]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u64).range(100..=1_000_000))]
    pub tile_triangles: Option<u64>,
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
    /// Quality of the JPEG images of textures, from 1 to 100 [default: 90]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u8).range(1..=100))]
    pub texture_quality: Option<u8>,
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
    /// Number of threads.
    #[command(flatten)]
    pub threads: ThreadArgs,
}

/// Options of meshes for Neuroglancer.
#[derive(Debug, Args)]
pub(crate) struct NeuroglancerArgs {
    /// Number of the segment that the input becomes [default: 1]
    #[arg(long, value_name = "ID")]
    pub segment_id: Option<u64>,
    /// Bits per coordinate of a vertex in its fragment: 10 or 16 [default: 16]
    #[arg(long, value_name = "BITS", value_parser = ["10", "16"], hide_possible_values = true)]
    pub bits: Option<String>,
    /// Write all segments into a few files (neuroglancer_uint64_sharded_v1)
    #[arg(long)]
    pub sharded: bool,
}

impl NeuroglancerArgs {
    /// Returns the first flag that the user gave.
    pub(crate) fn first_given_flag(&self) -> Option<&'static str> {
        let Self { segment_id, bits, sharded } = self;
        let flags =
            [("--segment-id", segment_id.is_some()), ("--bits", bits.is_some()), ("--sharded", *sharded)];
        flags.into_iter().find(|&(_, is_given)| is_given).map(|(flag, _)| flag)
    }
}

/// Format of tiles.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum TilesFormat {
    /// 3D Tiles 1.1
    #[value(name = "3dtiles")]
    Tiles3d,
    /// Meshes of Neuroglancer
    Neuroglancer,
    /// Arrays in refinement order
    Zarr,
}

/// How a paged file is built that only this verb reads.
#[derive(Debug, Args)]
pub(crate) struct PageBuildArgs {
    /// Work within so much memory: 4GB, 500MB
    #[arg(long, value_name = "SIZE")]
    pub memory: Option<ByteSize>,
    /// How cells and positions are chosen.
    #[command(flatten)]
    pub cells: CellArgs,
}

impl PageBuildArgs {
    /// Returns the first flag that the user gave.
    pub(crate) fn first_given_flag(&self) -> Option<&'static str> {
        self.memory.map(|_| "--memory").or_else(|| self.cells.first_given_flag())
    }
}

impl TilesArgs {
    /// Returns the first flag that the user gave and that only 3D Tiles have.
    pub(crate) fn first_flag_of_3d_tiles(&self) -> Option<&'static str> {
        let flags = [
            ("--quantize", self.quantize),
            ("--meshopt", self.meshopt),
            ("--draco", self.draco),
            ("--raw", self.raw),
            ("--no-textures", self.no_textures),
            ("--texture-quality", self.texture_quality.is_some()),
            ("--skirts", self.skirts),
            ("--local", self.local),
            ("--up", self.up.is_some()),
        ];
        flags.into_iter().find(|&(_, is_given)| is_given).map(|(flag, _)| flag)
    }
}

/// Axis that is up.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum UpAxis {
    /// The y axis, as in glTF
    Y,
    /// The z axis, as in terrains
    Z,
}
