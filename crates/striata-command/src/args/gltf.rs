//! Flags for how glTF files are quantized and compressed.

use clap::{ArgGroup, Args, ValueEnum};
use striata_io::{GridScope, QuantizeOptions, WriteOptions};

/// Help heading of these flags.
const GLTF: &str = "glTF output (.glb, .gltf)";

/// Largest number of bits of all these flags.
const MAX_BITS: i64 = 16;

/// How a glTF file is quantized and compressed; without any of these flags, all values are kept exactly.
#[derive(Clone, Copy, Debug, Default, Args)]
#[command(
    next_help_heading = GLTF,
    group = ArgGroup::new("GltfCoding").args(["quantize", "meshopt", "draco"]).multiple(true),
)]
pub struct GltfArgs {
    /// Keep a mesh without normals or materials as it is; viewers show it with flat facets, as white metal
    #[arg(long)]
    pub raw: bool,
    /// Write .gltf as one file, a third larger, instead of putting its buffer and images next to it
    #[arg(long)]
    embed: bool,
    /// Round attributes to small integers (KHR_mesh_quantization)
    #[arg(long)]
    quantize: bool,
    /// Quantize, and compress with meshoptimizer (EXT_meshopt_compression)
    #[arg(long)]
    meshopt: bool,
    /// Quantize, and compress with Draco (KHR_draco_mesh_compression)
    #[arg(long, conflicts_with = "meshopt")]
    draco: bool,
    /// With --meshopt or --draco: do not quantize
    #[arg(long, requires = "GltfCoding", conflicts_with = "quantize")]
    lossless: bool,
    #[arg(
        long,
        value_name = "BITS",
        allow_negative_numbers = true,
        value_parser = clap::value_parser!(u32).range(1..=MAX_BITS),
        requires = "GltfCoding",
        conflicts_with = "lossless",
        help = bits_help(
            |q| q.position_bits,
            "Bits per coordinate along the longest side of the bounding box, 1 to 16",
        ),
    )]
    bits: Option<u32>,
    #[arg(
        long,
        value_name = "BITS",
        allow_negative_numbers = true,
        value_parser = clap::value_parser!(u32).range(2..=MAX_BITS),
        requires = "GltfCoding",
        conflicts_with = "lossless",
        help = bits_help(|q| q.normal_bits, "Bits per coordinate of a normal or tangent, 2 to 16"),
    )]
    normal_bits: Option<u32>,
    #[arg(
        long,
        value_name = "BITS",
        allow_negative_numbers = true,
        value_parser = clap::value_parser!(u32).range(1..=MAX_BITS),
        requires = "GltfCoding",
        conflicts_with = "lossless",
        help = bits_help(|q| q.texcoord_bits, "Bits per texture coordinate, 1 to 16"),
    )]
    uv_bits: Option<u32>,
    #[arg(
        long,
        value_name = "BITS",
        allow_negative_numbers = true,
        value_parser = clap::value_parser!(u32).range(1..=MAX_BITS),
        requires = "GltfCoding",
        conflicts_with = "lossless",
        alias = "colour-bits",
        help = bits_help(|q| q.color_bits, "Bits per color channel, 1 to 16"),
    )]
    color_bits: Option<u32>,
    #[arg(
        long,
        value_name = "BITS",
        allow_negative_numbers = true,
        value_parser = clap::value_parser!(u32).range(9..=MAX_BITS),
        requires = "GltfCoding",
        conflicts_with = "lossless",
        help = bits_help(|q| q.rotation_bits, "Bits per component of an animated rotation, 9 to 16"),
    )]
    rotation_bits: Option<u32>,
    /// Which meshes are rounded to a common grid: those that touch, all of the scene, or none
    #[arg(
        long,
        value_name = "MESHES",
        default_value = "touching",
        requires = "GltfCoding",
        conflicts_with = "lossless"
    )]
    grid: GridArg,
}

/// Which meshes have a common grid.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
enum GridArg {
    /// Meshes with common vertices
    #[default]
    Touching,
    /// All meshes
    Scene,
    /// None: each mesh has its own
    Mesh,
}

impl GltfArgs {
    /// Returns the first flag that the user gave and that changes how the file is encoded.
    pub fn first_given_flag(&self) -> Option<&'static str> {
        let flags = [("--quantize", self.quantize), ("--meshopt", self.meshopt), ("--draco", self.draco)];
        flags.into_iter().find(|&(_, is_given)| is_given).map(|(flag, _)| flag)
    }

    /// Returns the first flag that the user gave and that has no effect on the encoding.
    pub fn first_plain_flag(&self) -> Option<&'static str> {
        let flags = [("--raw", self.raw), ("--embed", self.embed)];
        flags.into_iter().find(|&(_, is_given)| is_given).map(|(flag, _)| flag)
    }

    /// Sets these options; without any of these flags, they are unchanged.
    pub fn applied_to(&self, options: WriteOptions) -> WriteOptions {
        let options = options.with_embed(self.embed);
        if self.first_given_flag().is_none() {
            return options;
        }
        let options = options.with_meshopt(self.meshopt).with_draco(self.draco);
        if self.lossless {
            return options;
        }
        let defaults = QuantizeOptions::default();
        let quantize = defaults
            .clone()
            .with_position_bits(self.bits.unwrap_or(defaults.position_bits))
            .with_normal_bits(self.normal_bits.unwrap_or(defaults.normal_bits))
            .with_texcoord_bits(self.uv_bits.unwrap_or(defaults.texcoord_bits))
            .with_color_bits(self.color_bits.unwrap_or(defaults.color_bits))
            .with_rotation_bits(self.rotation_bits.unwrap_or(defaults.rotation_bits))
            .with_grid(match self.grid {
                GridArg::Touching => GridScope::Touching,
                GridArg::Scene => GridScope::Scene,
                GridArg::Mesh => GridScope::Mesh,
            });
        options.with_quantize(quantize)
    }
}

fn bits_help(bits: impl Fn(QuantizeOptions) -> u32, what: &str) -> String {
    format!("{what} [default: {}]", bits(QuantizeOptions::default()))
}
