//! The arguments of verbs that simplify: what goes first, and what may not happen.

use clap::{Args, ValueEnum};
use striata::simplify::{AttributeWeights, HoleCriterion, RemovalOptions, Retriangulation};

use super::Length;

/// How the simplification sequence is made.
#[derive(Clone, Debug, Args)]
#[command(next_help_heading = "Simplification")]
pub struct SequenceArgs {
    /// What is simplified first: quadric (collapses of edges that cost least) or hausdorff (vertices, by a
    /// mixture of distance, area and attributes; slower, errors are guaranteed)
    #[arg(long, value_name = "ORDER", default_value = "quadric", hide_possible_values = true)]
    pub order: OrderArg,
    /// Guarantee errors in quadric order too: no point of the original is farther from a level than its error
    #[arg(long)]
    pub certify: bool,
    /// Which cost has the quadric order: of the current mesh, summed up, or of all removed vertices (slow, best far
    /// down) [default: memoryless]
    #[arg(long)]
    pub cost: Option<CostArg>,
    /// Keep every boundary vertex in place
    #[arg(long)]
    pub lock_boundary: bool,
    /// Keep every vertex on a border between groups (materials) in place
    #[arg(long)]
    pub lock_groups: bool,
    /// Move vertices on seams and material borders only along them; some targets are then out of reach
    #[arg(long)]
    pub keep_seams: bool,
    /// Keep at least one triangle of every connected part; some targets are then out of reach
    #[arg(long)]
    pub keep_parts: bool,
    /// Let parts grow together that are nearer than this: mesh units, or `1%` of the diagonal
    #[arg(long, value_name = "D", allow_negative_numbers = true)]
    pub pair_distance: Option<Length>,
    /// How much attributes weigh.
    #[command(flatten)]
    pub weights: WeightArgs,
    /// How vertices are removed.
    #[command(flatten)]
    pub removal: RemovalArgs,
}

/// How much attributes weigh against distances.
#[derive(Clone, Copy, Debug, Args)]
#[command(next_help_heading = "Simplification, with --order quadric")]
pub struct WeightArgs {
    #[arg(long, value_name = "W", allow_negative_numbers = true, value_parser = parse_weight, help = weight_help(|w| w.normal, "normals"))]
    normal_weight: Option<f32>,
    #[arg(long, value_name = "W", allow_negative_numbers = true, value_parser = parse_weight, help = weight_help(|w| w.texcoord, "texture coordinates"))]
    uv_weight: Option<f32>,
    /// Scale the weight of texture coordinates by the contrast of each material's base color texture (PNG or JPEG, glTF
    /// input), 0.1 to 2 times
    #[arg(long)]
    pub uv_contrast: bool,
    #[arg(long, value_name = "W", allow_negative_numbers = true, value_parser = parse_weight, alias = "colour-weight", help = weight_help(|w| w.color, "colors"))]
    color_weight: Option<f32>,
}

impl WeightArgs {
    /// The greatest weight: a difference of 1 in an attribute then weighs as much as a distance of 100 diagonals.
    const MOST: f32 = 100.0;

    /// The first flag that was given.
    pub fn given(&self) -> Option<&'static str> {
        let Self { normal_weight, uv_weight, uv_contrast, color_weight } = self;
        let flags = [
            ("--normal-weight", normal_weight.is_some()),
            ("--uv-weight", uv_weight.is_some()),
            ("--uv-contrast", *uv_contrast),
            ("--color-weight", color_weight.is_some()),
        ];
        flags.into_iter().find(|&(_, is_given)| is_given).map(|(flag, _)| flag)
    }

    /// The weights asked for, and the usual ones of other layers.
    pub fn weights(&self) -> AttributeWeights {
        let usual = AttributeWeights::default();
        AttributeWeights {
            normal: self.normal_weight.unwrap_or(usual.normal),
            texcoord: self.uv_weight.unwrap_or(usual.texcoord),
            color: self.color_weight.unwrap_or(usual.color),
        }
    }
}

/// How vertices are removed.
#[derive(Clone, Debug, Args)]
#[command(next_help_heading = "Simplification, with --order hausdorff")]
pub struct RemovalArgs {
    /// How the hole of a vertex is filled: in the best of all ways, or as a collapse would, which all models but patterns
    /// need [default: free where they allow it]
    #[arg(long, value_name = "HOW")]
    pub retriangulation: Option<RetriangulationArg>,
    /// Which way is the best: nearest to the original, flattest, or of the roundest triangles [default: distance]
    #[arg(long)]
    pub criterion: Option<CriterionArg>,
    #[arg(long, value_name = "N", allow_negative_numbers = true, value_parser = clap::value_parser!(u32).range(3..=16), help = degree_help())]
    pub degree_limit: Option<u32>,
    /// Keep edges where the surface turns by more than this, degrees [default: distances alone decide]
    #[arg(long, value_name = "DEG", allow_negative_numbers = true, value_parser = parse_turn)]
    pub feature_angle: Option<f64>,
}

impl RemovalArgs {
    /// The first flag that was given.
    pub fn given(&self) -> Option<&'static str> {
        let Self { retriangulation, criterion, degree_limit, feature_angle } = self;
        let flags = [
            ("--retriangulation", retriangulation.is_some()),
            ("--criterion", criterion.is_some()),
            ("--degree-limit", degree_limit.is_some()),
            ("--feature-angle", feature_angle.is_some()),
        ];
        flags.into_iter().find(|&(_, is_given)| is_given).map(|(flag, _)| flag)
    }
}

/// What is simplified first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum OrderArg {
    /// Half-edge collapses, by quadrics
    Quadric,
    /// Vertices removed, by the distance that is left
    Hausdorff,
}

impl OrderArg {
    /// As the flag spells it.
    pub const fn as_str(self) -> &'static str {
        match self {
            Self::Quadric => "quadric",
            Self::Hausdorff => "hausdorff",
        }
    }
}

/// What a collapse costs.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum CostArg {
    /// Against the current mesh: fast, best at mild levels
    Memoryless,
    /// Quadrics summed up over the history: the classic
    Accumulated,
    /// Against all removed vertices: slower, best at coarse levels
    Tracked,
}

/// How holes are filled.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum RetriangulationArg {
    /// In any way
    Free,
    /// As half-edge collapses do
    Collapse,
}

impl From<RetriangulationArg> for Retriangulation {
    fn from(how: RetriangulationArg) -> Self {
        match how {
            RetriangulationArg::Free => Self::Free,
            RetriangulationArg::Collapse => Self::Collapse,
        }
    }
}

/// Which filling of a hole is the best.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum CriterionArg {
    /// Nearest to the original surface
    Distance,
    /// Turned least
    Flatness,
    /// Of the roundest triangles
    Shape,
}

impl From<CriterionArg> for HoleCriterion {
    fn from(criterion: CriterionArg) -> Self {
        match criterion {
            CriterionArg::Distance => Self::Distance,
            CriterionArg::Flatness => Self::Flatness,
            CriterionArg::Shape => Self::Shape,
        }
    }
}

fn degree_help() -> String {
    let usual = RemovalOptions::default().degree_limit;
    format!("Most triangles around a vertex that is removed, 3 to 16 [default: {usual}]")
}

fn weight_help(weight: impl Fn(AttributeWeights) -> f32, what: &str) -> String {
    let usual = weight(AttributeWeights::default());
    let most = WeightArgs::MOST;
    format!(
        "Distance, as a share of the diagonal, that a difference of 1 in {what} weighs, 0 to {most}; 0 ignores them [default: {usual}]"
    )
}

fn parse_weight(text: &str) -> Result<f32, String> {
    match text.parse::<f32>() {
        Ok(weight) if (0.0..=WeightArgs::MOST).contains(&weight) => Ok(weight),
        _ => Err(format!("must lie between 0 (ignored) and {}", WeightArgs::MOST)),
    }
}

fn parse_turn(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(angle) if (0.0..=180.0).contains(&angle) => Ok(angle),
        _ => Err("must be an angle from 0 to 180".to_owned()),
    }
}
