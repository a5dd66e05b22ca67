//! Arguments of `compare`.

use std::path::PathBuf;

use clap::{Args, ValueEnum};
use striata_lab::stripifiers::Tunneling;
use striata_stream::Effort;

use crate::compare::compared_models;
use striata_command::args::{BUILD_STRIPS, EffortArg, STRIPS, parse_at_least_zero};
use striata_command::strip_chain::{StripChain, StripPlan};

/// Stripifiers that are compared by default.
const COMPARED_STRIPS: &str = "greedy,stripe,tunnel:3,tunnel:17,greedy+tunnel:17,fewest,cheapest";

/// Help heading of the flags about models.
const MODELS: &str = "Models";

/// Arguments of `compare`.
#[derive(Debug, Args)]
#[command(after_help = "Examples:\n  \
    striata-lab compare cow.obj bunny.ply shape:sphere --html compared.html\n  \
    striata-lab compare bunny.ply --rate --html rate.html --json")]
pub(crate) struct CompareArgs {
    /// Compare on these meshes, .striata files (at full detail) or shapes such as shape:sphere
    #[arg(value_name = "INPUT", required = true)]
    pub inputs: Vec<PathBuf>,
    /// Also write a page with charts; it works offline
    #[arg(long, value_name = "OUT")]
    pub html: Option<PathBuf>,
    /// Measure these parts: strips, models, views, patterns, rate, assets, clusters
    #[arg(
        long,
        value_name = "PART,...",
        value_delimiter = ',',
        default_value = "strips,models,views,patterns",
        hide_possible_values = true
    )]
    parts: Vec<ComparisonPart>,
    /// Measure only distance against bytes, for streams, levels and other coders: --parts rate
    #[arg(long, conflicts_with = "parts")]
    rate: bool,
    /// Search for tunnels of all lengths with ten seeds, and for strips up to 2 seconds; takes many times as long
    #[arg(long)]
    pub thorough: bool,
    /// Use certified error bounds instead of estimated errors in models
    #[arg(long)]
    pub certify: bool,
    /// Options for comparing models.
    #[command(flatten)]
    pub models: ModelArgs,
    /// Options for comparing stripifiers.
    #[command(flatten)]
    pub strips: StripifierArgs,
    /// Options for comparing bytes.
    #[command(flatten)]
    pub rates: RateArgs,
    /// Options for comparing assets.
    #[command(flatten)]
    pub assets: AssetArgs,
}

/// A part of the comparison.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum ComparisonPart {
    /// Stripifiers, on the unsimplified mesh.
    Strips,
    /// Multiresolution models at uniform levels of detail.
    Models,
    /// Models under view-dependent refinement.
    Views,
    /// Fragments and patterns of several simplifiers.
    Patterns,
    /// Distance after a given number of bytes, of streams, discrete levels and other coders.
    Rate,
    /// Levels of assets compared with other simplifiers: distances, attributes, pictures.
    Assets,
    /// Clusters for meshlets compared with those of meshoptimizer: triangles at equal error, errors, time.
    Clusters,
}

/// Options for comparing models.
#[derive(Debug, Args)]
#[command(next_help_heading = MODELS)]
pub(crate) struct ModelArgs {
    #[arg(long = "models", value_name = "NAME,...", value_delimiter = ',', help = models_help())]
    names: Option<Vec<String>>,
    /// Move each model through this many levels to the base mesh, and as many back
    #[arg(
        long,
        value_name = "N",
        default_value_t = 200,
        value_parser = clap::value_parser!(u32).range(1..=10_000)
    )]
    pub frames: u32,
    /// Build models from the strips of these stripifiers, as in --strips
    #[arg(long, value_name = "SPEC", default_value_t = BUILD_STRIPS.into())]
    model_strips: StripChain,
}

/// Options for comparing bytes.
#[derive(Debug, Args)]
#[command(next_help_heading = "Rate")]
pub(crate) struct RateArgs {
    /// Quantize coordinates in streams and levels to this many bits
    #[arg(
        long = "rate-bits",
        value_name = "N",
        default_value_t = 12,
        value_parser = clap::value_parser!(u32).range(4..=16)
    )]
    pub bits: u32,
    /// Encode streams with these efforts
    #[arg(
        long = "rate-efforts",
        value_name = "EFFORT,...",
        value_delimiter = ',',
        default_value = "fast,compact",
        hide_possible_values = true
    )]
    efforts: Vec<EffortArg>,
    /// Measure only sizes and times of whole files: no distances, no levels
    #[arg(long = "rate-sizes")]
    pub sizes_only: bool,
}

impl RateArgs {
    /// The requested efforts.
    pub(crate) fn efforts(&self) -> impl Iterator<Item = Effort> {
        self.efforts.iter().map(|&effort| effort.into())
    }
}

/// Options for comparing assets.
#[derive(Debug, Args)]
#[command(next_help_heading = "Assets")]
pub(crate) struct AssetArgs {
    /// Simplify to these percentages of the triangles
    #[arg(
        long,
        value_name = "PERCENT,...",
        value_delimiter = ',',
        default_value = "50,25,10,5,2",
        value_parser = parse_percent
    )]
    pub shares: Vec<f64>,
    /// Compare these simplifiers; gltfpack runs through npx, which may download it
    #[arg(
        long,
        value_name = "NAME,...",
        value_delimiter = ',',
        default_value = "striata,striata-subset,meshoptimizer,meshoptimizer-permissive,gltfpack,gltfpack-sp",
        hide_possible_values = true
    )]
    pub contenders: Vec<AssetContender>,
}

/// A simplifier of assets.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum AssetContender {
    /// One level of striata with default options: its vertices are fitted to the original.
    Striata,
    /// A level of striata that keeps vertices of the original, as levels that share vertices do.
    StriataSubset,
    /// meshoptimizer, keeping seams.
    Meshoptimizer,
    /// meshoptimizer, collapsing across seams.
    MeshoptimizerPermissive,
    /// gltfpack, keeping seams and simplifying each material separately.
    Gltfpack,
    /// gltfpack, collapsing across seams of normals but keeping those of texture coordinates.
    GltfpackSp,
}

impl AssetContender {
    /// The contender's name in reports.
    pub(crate) const fn as_str(self) -> &'static str {
        match self {
            Self::Striata => "striata",
            Self::StriataSubset => "striata-subset",
            Self::Meshoptimizer => "meshoptimizer",
            Self::MeshoptimizerPermissive => "meshoptimizer-permissive",
            Self::Gltfpack => "gltfpack",
            Self::GltfpackSp => "gltfpack-sp",
        }
    }
}

/// Options for comparing stripifiers.
#[derive(Debug, Args)]
#[command(next_help_heading = STRIPS)]
pub(crate) struct StripifierArgs {
    /// Merge equal vertices before comparing stripifiers; models always merge them
    #[arg(long)]
    pub weld: bool,
    /// Search tunnels of at most these lengths [default: 1,9,17, or 1,3,5,9,13,17,25 with --thorough]
    #[arg(
        long,
        value_name = "LENGTH,...",
        value_delimiter = ',',
        value_parser = clap::value_parser!(u32).range(1..=999)
    )]
    tunnels: Option<Vec<u32>>,
    /// Kinds of tunneling: published, per-path, shortest-first, same-strip, static, grown, tunnel
    #[arg(
        long,
        value_name = "NAME,...",
        value_delimiter = ',',
        default_value = "published,per-path,shortest-first,same-strip,static,grown,tunnel",
        hide_possible_values = true
    )]
    pub tunnel_searches: Vec<Tunneling>,
    /// Measure each tunnel length with this many seeds [default: 2, or 10 with --thorough]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=1000))]
    seeds: Option<u32>,
    /// Compare these stripifiers; join the passes of one with +
    #[arg(long = "strips", value_name = "SPEC,...", value_delimiter = ',', default_value = COMPARED_STRIPS)]
    pub chains: Vec<StripChain>,
    /// Also run stripifiers that search for each of these times, in seconds [default: 0.5, or 0.1,0.5,2 with --thorough]
    #[arg(
        long,
        value_name = "SECS,...",
        value_delimiter = ',',
        allow_negative_numbers = true,
        value_parser = parse_at_least_zero
    )]
    budgets: Option<Vec<f64>>,
}

impl CompareArgs {
    /// Whether a part is requested.
    pub(crate) fn has(&self, part: ComparisonPart) -> bool {
        if self.rate { part == ComparisonPart::Rate } else { self.parts.contains(&part) }
    }

    /// Largest lengths of tunnels.
    pub(crate) fn tunnels(&self) -> &[u32] {
        let usual: &[u32] = if self.thorough { &[1, 3, 5, 9, 13, 17, 25] } else { &[1, 9, 17] };
        self.strips.tunnels.as_deref().unwrap_or(usual)
    }

    /// Number of seeds for each length of tunnels.
    pub(crate) fn seeds(&self) -> u32 {
        self.strips.seeds.unwrap_or(if self.thorough { 10 } else { 2 })
    }

    /// Times for which stripifiers search, seconds.
    pub(crate) fn budgets(&self) -> &[f64] {
        let usual: &[f64] = if self.thorough { &[0.1, 0.5, 2.0] } else { &[0.5] };
        self.strips.budgets.as_deref().unwrap_or(usual)
    }
}

impl ModelArgs {
    /// The requested models, or all if none is given.
    pub(crate) fn names(&self) -> Vec<&str> {
        match &self.names {
            Some(names) => names.iter().map(|name| name.trim()).collect(),
            None => compared_models().collect(),
        }
    }

    /// The stripifiers whose strips models are built from.
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
    format!("Compare these models [default: all]: {}", compared_models().collect::<Vec<_>>().join(", "))
}
