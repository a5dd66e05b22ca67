//! Flags of the verbs that write progressive streams.

use clap::{Args, ValueEnum};
use striata_stream::{LayerOptions, Precision, SHAPE_STEPS, StreamError, StreamOptions};

use striata::mesh::IndexedMesh;

use super::Length;
use crate::failure::Failure;
use crate::sequence::BatchSettings;

/// Help heading of these flags.
const STREAM: &str = "Stream";

/// How a stream is encoded.
#[derive(Clone, Copy, Debug, Default, Args)]
#[command(next_help_heading = STREAM)]
pub struct StreamArgs {
    /// Bits per coordinate along the longest side of the bounding box, 1 to 24 [default: 14]
    #[arg(
        long,
        value_name = "BITS",
        allow_negative_numbers = true,
        value_parser = clap::value_parser!(u32).range(1..=24),
        conflicts_with_all = ["tolerance", "lossless"],
    )]
    bits: Option<u32>,
    /// Instead of --bits: move no vertex farther than this (mesh units, or % of the diagonal)
    #[arg(long, value_name = "DISTANCE", allow_negative_numbers = true, conflicts_with = "lossless")]
    tolerance: Option<Length>,
    /// Instead of --bits: keep all values exactly
    #[arg(long)]
    lossless: bool,
    #[arg(
        long,
        value_name = "BITS",
        allow_negative_numbers = true,
        value_parser = clap::value_parser!(u32).range(2..=16),
        conflicts_with = "lossless",
        help = bits_help(|l| l.normal_bits, "Bits for each of the two numbers that encode a normal, 2 to 16"),
    )]
    normal_bits: Option<u32>,
    #[arg(
        long,
        value_name = "BITS",
        allow_negative_numbers = true,
        value_parser = clap::value_parser!(u32).range(1..=24),
        conflicts_with = "lossless",
        help = bits_help(|l| l.texcoord_bits, "Bits per texture coordinate, 1 to 24"),
    )]
    uv_bits: Option<u32>,
    #[arg(
        long,
        value_name = "BITS",
        allow_negative_numbers = true,
        value_parser = clap::value_parser!(u32).range(1..=24),
        conflicts_with = "lossless",
        alias = "colour-bits",
        help = bits_help(|l| l.color_bits, "Bits per color channel if colors are floats, 1 to 24"),
    )]
    color_bits: Option<u32>,
    /// Compression effort: fast (decodes 3.5 to 4.2 million triangles/s; complete sooner on lines above 1 Mbit/s)
    /// or compact (1.1 million; 6 to 26 % smaller, for slow lines and storage) [default: fast]
    #[arg(long, value_name = "EFFORT", hide_possible_values = true)]
    effort: Option<EffortArg>,
    /// Fraction of the vertices, cheapest first, that each batch of splits may use: more makes streams
    /// smaller and levels worse [default: 0.35]
    #[arg(
        long = "batch-share",
        alias = "share",
        value_name = "0..1",
        allow_negative_numbers = true,
        value_parser = parse_share,
    )]
    pub share: Option<f64>,
}

/// Compression effort of the encoder.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub enum EffortArg {
    /// Three times as fast to decode
    #[default]
    Fast,
    /// Smaller streams
    Compact,
}

impl StreamArgs {
    /// Returns the first of these flags that the user gave.
    pub fn first_given_flag(&self) -> Option<&'static str> {
        let Self { bits, tolerance, lossless, normal_bits, uv_bits, color_bits, effort, share } = self;
        let flags = [
            ("--bits", bits.is_some()),
            ("--tolerance", tolerance.is_some()),
            ("--lossless", *lossless),
            ("--normal-bits", normal_bits.is_some()),
            ("--uv-bits", uv_bits.is_some()),
            ("--color-bits", color_bits.is_some()),
            ("--effort", effort.is_some()),
            ("--batch-share", share.is_some()),
        ];
        flags.into_iter().find(|&(_, is_given)| is_given).map(|(flag, _)| flag)
    }

    /// Returns the options for a mesh with this bounding box diagonal, with lengths in mesh units.
    pub fn options(&self, diagonal: f64) -> StreamOptions {
        let precision = match (self.bits, self.tolerance) {
            _ if self.lossless => Precision::Lossless,
            (Some(bits), _) => Precision::Bits(bits),
            (None, Some(tolerance)) => Precision::Tolerance(tolerance.in_units(diagonal)),
            (None, None) => Precision::default(),
        };
        let effort = self.effort.unwrap_or_default();
        let defaults = LayerOptions::default();
        let layers = defaults
            .clone()
            .with_normal_bits(self.normal_bits.unwrap_or(defaults.normal_bits))
            .with_texcoord_bits(self.uv_bits.unwrap_or(defaults.texcoord_bits))
            .with_color_bits(self.color_bits.unwrap_or(defaults.color_bits));
        StreamOptions::default().with_precision(precision).with_effort(effort.into()).with_layers(layers)
    }

    /// Returns settings for batches of collapses that suit the precision of the stream.
    ///
    /// # Errors
    /// If no grid has the requested precision.
    pub fn batches(&self, mesh: &IndexedMesh) -> Result<BatchSettings, Failure> {
        let step = self.options(mesh.diagonal()).grid_step(mesh).map_err(StreamError::Grid)?;
        Ok(BatchSettings { share: self.share, shape_step: Some(SHAPE_STEPS * step) })
    }
}

fn bits_help(bits: impl Fn(LayerOptions) -> u32, what: &str) -> String {
    format!("{what} [default: {}]", bits(LayerOptions::default()))
}

fn parse_share(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(share) if share > 0.0 && share <= 1.0 => Ok(share),
        _ => Err("must be greater than 0 and at most 1".to_owned()),
    }
}
