//! Flags of all verbs that write streams.

use clap::{Args, ValueEnum};
use striata_stream::{LayerOptions, Precision, SHAPE_STEPS, StreamError, StreamOptions};

use striata::mesh::IndexedMesh;

use super::Length;
use crate::failure::Failure;
use crate::sequence::BatchTerms;

/// Heading of the flags about streams.
const STREAM: &str = "Stream";

/// How a stream is coded.
#[derive(Clone, Copy, Debug, Default, Args)]
#[command(next_help_heading = STREAM)]
pub struct StreamArgs {
    /// Bits of a coordinate along the longest side of the bounding box, 1 to 24 [default: 14]
    #[arg(long, value_name = "N", allow_negative_numbers = true, value_parser = clap::value_parser!(u32).range(1..=24), conflicts_with_all = ["tolerance", "lossless"])]
    bits: Option<u32>,
    /// Let no vertex move farther than this, instead: mesh units, or `1%` of the diagonal
    #[arg(long, value_name = "E", allow_negative_numbers = true, conflicts_with = "lossless")]
    tolerance: Option<Length>,
    /// Keep the very numbers of the mesh, instead
    #[arg(long)]
    lossless: bool,
    #[arg(long, value_name = "N", allow_negative_numbers = true, value_parser = clap::value_parser!(u32).range(2..=16), conflicts_with = "lossless", help = bits_help(|l| l.normal_bits, "Bits of each of the two numbers that a normal becomes, 2 to 16"))]
    normal_bits: Option<u32>,
    #[arg(long, value_name = "N", allow_negative_numbers = true, value_parser = clap::value_parser!(u32).range(1..=24), conflicts_with = "lossless", help = bits_help(|l| l.texcoord_bits, "Bits of a texture coordinate over its range, 1 to 24"))]
    uv_bits: Option<u32>,
    #[arg(long, value_name = "N", allow_negative_numbers = true, value_parser = clap::value_parser!(u32).range(1..=24), conflicts_with = "lossless", alias = "colour-bits", help = bits_help(|l| l.color_bits, "Bits of a color channel that is given as floats, 1 to 24"))]
    color_bits: Option<u32>,
    /// How hard the coder tries: fast (reads 3.4 to 4.6 million triangles a second), default (1.1 to 1.3 million, 6 to 26 % fewer bytes
    /// than fast), small (0.35 million, 9 to 35 % fewer bytes than fast)
    #[arg(long, value_name = "EFFORT", hide_possible_values = true)]
    effort: Option<EffortArg>,
    /// Let each batch of splits take from this share of the vertices, the cheapest ones, over 0 and up to 1: more makes smaller
    /// streams and worse levels [default: 0.35]
    #[arg(long, value_name = "F", allow_negative_numbers = true, value_parser = parse_share)]
    pub share: Option<f64>,
}

/// How hard the coder tries.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub enum EffortArg {
    /// Read quickest
    Fast,
    /// Good models
    #[default]
    Default,
    /// Fewest bytes
    Small,
}

impl StreamArgs {
    /// The first flag that was given.
    pub fn given(&self) -> Option<&'static str> {
        let Self { bits, tolerance, lossless, normal_bits, uv_bits, color_bits, effort, share } = self;
        let flags = [
            ("--bits", bits.is_some()),
            ("--tolerance", tolerance.is_some()),
            ("--lossless", *lossless),
            ("--normal-bits", normal_bits.is_some()),
            ("--uv-bits", uv_bits.is_some()),
            ("--color-bits", color_bits.is_some()),
            ("--effort", effort.is_some()),
            ("--share", share.is_some()),
        ];
        flags.into_iter().find(|&(_, is_given)| is_given).map(|(flag, _)| flag)
    }

    /// What was asked for, in mesh units.
    pub fn options(&self, diagonal: f64) -> StreamOptions {
        let precision = match (self.bits, self.tolerance) {
            _ if self.lossless => Precision::Lossless,
            (Some(bits), _) => Precision::Bits(bits),
            (None, Some(tolerance)) => Precision::Tolerance(tolerance.in_units(diagonal)),
            (None, None) => Precision::default(),
        };
        let effort = self.effort.unwrap_or_default();
        let usual = LayerOptions::default();
        let layers = usual
            .clone()
            .with_normal_bits(self.normal_bits.unwrap_or(usual.normal_bits))
            .with_texcoord_bits(self.uv_bits.unwrap_or(usual.texcoord_bits))
            .with_color_bits(self.color_bits.unwrap_or(usual.color_bits));
        StreamOptions::default().with_precision(precision).with_effort(effort.into()).with_layers(layers)
    }

    /// The batches that suit a stream of this precision.
    ///
    /// # Errors
    /// Where there is no grid as asked for.
    pub fn batches(&self, mesh: &IndexedMesh) -> Result<BatchTerms, Failure> {
        let step = self.options(mesh.diagonal()).grid_step(mesh).map_err(StreamError::Grid)?;
        Ok(BatchTerms { share: self.share, shape_step: Some(SHAPE_STEPS * step) })
    }
}

fn bits_help(bits: impl Fn(LayerOptions) -> u32, what: &str) -> String {
    format!("{what} [default: {}]", bits(LayerOptions::default()))
}

fn parse_share(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(share) if share > 0.0 && share <= 1.0 => Ok(share),
        _ => Err("must be over 0 and up to 1".to_owned()),
    }
}
