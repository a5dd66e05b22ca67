//! The arguments of `compare`.

use std::path::PathBuf;

use clap::{Args, ValueEnum};
use striata_stream::Effort;

use crate::compare::compared_models;
use striata_command::args::{BUILD_STRIPS, EffortArg, STRIPS, parse_at_least_zero};
use striata_command::strip_chain::{StripChain, StripPlan};

/// The stripifiers that are measured where nothing else is said.
const COMPARED_STRIPS: &str =
    "greedy,stripe,tunnel:3,tunnel:17,tunnel-static:17,greedy+tunnel:17,fewest,cheapest";

/// Heading of the flags about models.
const MODELS: &str = "Models";

/// Arguments of `compare`.
#[derive(Debug, Args)]
#[command(after_help = "Examples:\n  \
    striata-lab compare cow.obj bunny.ply shape:sphere --html compared.html\n  \
    striata-lab compare bunny.ply --rate --html rate.html --json")]
pub(crate) struct CompareArgs {
    /// Meshes, .striata files (their full level), or shapes such as shape:sphere
    #[arg(value_name = "INPUT", required = true)]
    pub(crate) inputs: Vec<PathBuf>,
    /// Write a page with charts too; it opens without a network
    #[arg(long, value_name = "OUT")]
    pub(crate) html: Option<PathBuf>,
    /// What to measure, separated by commas: strips, models, views, patterns, rate, assets
    #[arg(
        long,
        value_name = "PARTS",
        value_delimiter = ',',
        default_value = "strips,models,views,patterns",
        hide_possible_values = true
    )]
    parts: Vec<Part>,
    /// Measure only how near the mesh is after so many bytes, of streams, of levels and of other coders: --parts rate
    #[arg(long, conflicts_with = "parts")]
    rate: bool,
    /// Let models go by errors that hold at every point of the mesh, not by estimates
    #[arg(long)]
    pub(crate) certify: bool,
    /// How models are compared.
    #[command(flatten)]
    pub(crate) models: ModelArgs,
    /// How stripifiers are compared.
    #[command(flatten)]
    pub(crate) strips: StripifierArgs,
    /// How bytes are compared.
    #[command(flatten)]
    pub(crate) rates: RateArgs,
    /// How levels of assets are compared.
    #[command(flatten)]
    pub(crate) assets: AssetArgs,
}

/// What can be measured.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Part {
    /// Stripifiers, on the mesh as it is.
    Strips,
    /// Multiresolution models, every level the same everywhere.
    Models,
    /// Models that follow an eye.
    Views,
    /// Patterns and what they replace, of several simplifiers.
    Patterns,
    /// Distances after so many bytes, of streams and of what else is sent.
    Rate,
    /// Levels next to those of other simplifiers: distances, attributes, pictures.
    Assets,
}

/// How models are compared.
#[derive(Debug, Args)]
#[command(next_help_heading = MODELS)]
pub(crate) struct ModelArgs {
    #[arg(long = "models", value_name = "NAMES", value_delimiter = ',', help = models_help())]
    names: Option<Vec<String>>,
    /// Levels that a model is moved to on its way to the base mesh, and again on its way back
    #[arg(long, value_name = "N", default_value_t = 200, value_parser = clap::value_parser!(u32).range(1..=10_000))]
    pub(crate) frames: u32,
    /// The stripifiers whose strips models are built from, as in --strips
    #[arg(long, value_name = "SPEC", default_value_t = BUILD_STRIPS.into())]
    model_strips: StripChain,
}

/// How bytes are compared.
#[derive(Debug, Args)]
#[command(next_help_heading = "Rate")]
pub(crate) struct RateArgs {
    /// Bits of a coordinate in streams and levels
    #[arg(long = "rate-bits", value_name = "N", default_value_t = 12, value_parser = clap::value_parser!(u32).range(4..=16))]
    pub(crate) bits: u32,
    /// Efforts of streams, separated by commas
    #[arg(
        long = "rate-efforts",
        value_name = "EFFORTS",
        value_delimiter = ',',
        default_value = "fast,default,small",
        hide_possible_values = true
    )]
    efforts: Vec<EffortArg>,
    /// Measure sizes and times of whole files only: no distances, no levels
    #[arg(long = "rate-sizes")]
    pub(crate) sizes_only: bool,
}

impl RateArgs {
    /// The efforts asked for.
    pub(crate) fn efforts(&self) -> impl Iterator<Item = Effort> {
        self.efforts.iter().map(|&effort| effort.into())
    }
}

/// How levels of assets are compared.
#[derive(Debug, Args)]
#[command(next_help_heading = "Assets")]
pub(crate) struct AssetArgs {
    /// Percent of the triangles that levels are to have, separated by commas
    #[arg(
        long,
        value_name = "PERCENT",
        value_delimiter = ',',
        default_value = "50,25,10,5,2",
        value_parser = parse_percent
    )]
    pub(crate) shares: Vec<f64>,
    /// Simplifiers to compare, separated by commas; gltfpack runs through npx, which may download it
    #[arg(
        long,
        value_name = "NAMES",
        value_delimiter = ',',
        default_value = "striata,meshoptimizer,meshoptimizer-permissive,gltfpack,gltfpack-sp",
        hide_possible_values = true
    )]
    pub(crate) contenders: Vec<AssetContender>,
}

/// A simplifier of assets.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum AssetContender {
    /// Default options.
    Striata,
    /// Keeps seams.
    Meshoptimizer,
    /// Collapses across seams.
    MeshoptimizerPermissive,
    /// Keeps seams; each material by itself.
    Gltfpack,
    /// Collapses across seams of normals, keeps those of texture coordinates.
    GltfpackSp,
}

impl AssetContender {
    /// The name in reports.
    pub(crate) const fn as_str(self) -> &'static str {
        match self {
            Self::Striata => "striata",
            Self::Meshoptimizer => "meshoptimizer",
            Self::MeshoptimizerPermissive => "meshoptimizer-permissive",
            Self::Gltfpack => "gltfpack",
            Self::GltfpackSp => "gltfpack-sp",
        }
    }
}

/// How stripifiers are compared.
#[derive(Debug, Args)]
#[command(next_help_heading = STRIPS)]
pub(crate) struct StripifierArgs {
    /// Merge equal vertices before stripifiers are compared; for models they always are
    #[arg(long)]
    pub(crate) weld: bool,
    /// The longest tunnel searched for: every odd length up to it is measured
    #[arg(long, value_name = "N", default_value_t = 25, value_parser = clap::value_parser!(u32).range(1..=999))]
    pub(crate) max_tunnel: u32,
    /// Seeds that each tunnel length is measured with
    #[arg(long, value_name = "N", default_value_t = 10, value_parser = clap::value_parser!(u32).range(1..=1000))]
    pub(crate) seeds: u32,
    /// Stripifiers to compare, separated by commas, chained by +
    #[arg(long = "strips", value_name = "SPECS", value_delimiter = ',', default_value = COMPARED_STRIPS)]
    pub(crate) chains: Vec<StripChain>,
    /// Seconds that those which search are given, one after the other, besides their usual number of moves
    #[arg(long, value_name = "SECS", value_delimiter = ',', default_value = "0.1,0.5,2", allow_negative_numbers = true, value_parser = parse_at_least_zero)]
    pub(crate) budgets: Vec<f64>,
}

impl CompareArgs {
    /// Whether a part is asked for.
    pub(crate) fn has(&self, part: Part) -> bool {
        if self.rate { part == Part::Rate } else { self.parts.contains(&part) }
    }
}

impl ModelArgs {
    /// The models asked for; all where none is named.
    pub(crate) fn names(&self) -> Vec<&str> {
        match &self.names {
            Some(names) => names.iter().map(|name| name.trim()).collect(),
            None => compared_models().collect(),
        }
    }

    /// The strips that models are built from.
    pub(crate) fn strip_plan(&self) -> StripPlan {
        StripPlan { chain: self.model_strips.clone(), search: Default::default() }
    }
}

fn parse_percent(text: &str) -> Result<f64, String> {
    match text.trim().parse::<f64>() {
        Ok(percent) if percent > 0.0 && percent < 100.0 => Ok(percent),
        _ => Err("must be a number between 0 and 100".to_owned()),
    }
}

fn models_help() -> String {
    format!(
        "Models to compare, separated by commas [default: all]: {}",
        compared_models().collect::<Vec<_>>().join(", ")
    )
}
