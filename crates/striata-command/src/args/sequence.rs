//! Flags of the verbs that simplify: the order of the steps, and what they must preserve.

use clap::builder::{PossibleValuesParser, TypedValueParser};
use clap::{Args, ValueEnum};
use striata::simplify::{
    AttributeWeights, CostFunction, HoleCriterion, PlacedCollapse, RemovalOptions, RemovalOrder,
    Retriangulation,
};

use super::Length;

/// Help heading of the flags that only the quadric order has.
const QUADRIC: &str = "Simplification with --order quadric";

/// Help heading of the flags that only the Hausdorff order has.
const HAUSDORFF: &str = "Simplification with --order hausdorff";

/// How a mesh is simplified.
#[derive(Clone, Debug, Args)]
#[command(next_help_heading = "Simplification")]
pub struct SequenceArgs {
    /// Order of removals: quadric (edges of least quadric cost), hausdorff (vertices, by distance, area
    /// and attributes; slower, with guaranteed errors) or hausdorff-strict (vertices, by the largest distance
    /// alone)
    #[arg(long, value_name = "ORDER", default_value = "quadric", hide_possible_values = true)]
    pub order: OrderArg,
    /// Guarantee errors in quadric order too: no point of the original is farther from a level than its error
    #[arg(long)]
    pub certify: bool,
    /// Keep all boundary vertices
    #[arg(long)]
    pub lock_boundary: bool,
    /// Keep all vertices on borders between groups (materials)
    #[arg(long)]
    pub lock_groups: bool,
    /// Collapse seams and material borders only along themselves; some levels become unreachable
    #[arg(long)]
    pub keep_seams: bool,
    /// Keep at least one triangle of every connected part; some levels become unreachable
    #[arg(long)]
    pub keep_parts: bool,
    /// Let no triangle turn over in plan, seen along the z axis, as levels of rasters and generated terrain never
    /// do; some levels become unreachable
    #[arg(long)]
    pub keep_height_field: bool,
    /// Cost function; the default is that of the library.
    #[arg(
        long,
        hide_possible_values = true,
        help_heading = QUADRIC,
        value_parser = cost_parser(),
        help = cost_help(),
    )]
    pub cost: Option<CostFunction>,
    /// Also merge disconnected parts that are closer than this (mesh units, or % of the diagonal)
    #[arg(long, value_name = "LENGTH", allow_negative_numbers = true, help_heading = QUADRIC)]
    pub pair_distance: Option<Length>,
    /// Collapse each edge or triangle (edge, triangle) to a new vertex at the best position, with guaranteed
    /// errors; stores about twice as many vertices, for patterns, fans and streams
    #[arg(long, value_name = "KIND", hide_possible_values = true, help_heading = QUADRIC)]
    pub new_vertices: Option<NewVerticesArg>,
    /// Weights of attributes.
    #[command(flatten)]
    pub weights: WeightArgs,
    /// Options of vertex removal.
    #[command(flatten)]
    pub removal: RemovalArgs,
}

/// Weights of attributes relative to distances.
#[derive(Clone, Copy, Debug, Args)]
#[command(next_help_heading = QUADRIC)]
pub struct WeightArgs {
    #[arg(
        long,
        value_name = "0..100",
        allow_negative_numbers = true,
        value_parser = parse_weight,
        help = weight_help(|w| w.normal, "normals"),
    )]
    normal_weight: Option<f32>,
    #[arg(
        long,
        value_name = "0..100",
        allow_negative_numbers = true,
        value_parser = parse_weight,
        help = weight_help(|w| w.texcoord, "texture coordinates and textures"),
    )]
    uv_weight: Option<f32>,
    #[arg(
        long,
        value_name = "0..100",
        allow_negative_numbers = true,
        value_parser = parse_weight,
        alias = "colour-weight",
        help = weight_help(|w| w.color, "colors"),
    )]
    color_weight: Option<f32>,
}

impl WeightArgs {
    /// Largest weight: a difference of 1 in an attribute then counts as much as a distance of 100 diagonals.
    const MAX: f32 = 100.0;

    /// Returns the first of these flags that the user gave.
    pub fn first_given_flag(&self) -> Option<&'static str> {
        let Self { normal_weight, uv_weight, color_weight } = self;
        let flags = [
            ("--normal-weight", normal_weight.is_some()),
            ("--uv-weight", uv_weight.is_some()),
            ("--color-weight", color_weight.is_some()),
        ];
        flags.into_iter().find(|&(_, is_given)| is_given).map(|(flag, _)| flag)
    }

    /// Returns the weights, with defaults for those that were not given.
    pub fn weights(&self) -> AttributeWeights {
        let defaults = AttributeWeights::default();
        AttributeWeights {
            normal: self.normal_weight.unwrap_or(defaults.normal),
            texcoord: self.uv_weight.unwrap_or(defaults.texcoord),
            color: self.color_weight.unwrap_or(defaults.color),
            displacement: defaults.displacement,
        }
    }
}

/// How the Hausdorff order removes vertices.
#[derive(Clone, Debug, Args)]
#[command(next_help_heading = HAUSDORFF)]
pub struct RemovalArgs {
    /// How the hole of a removed vertex is filled: free (best of all triangulations) or collapse (as a
    /// half-edge collapse would, for the models that need it) [default: free if the models allow it]
    #[arg(long, value_name = "METHOD", hide_possible_values = true)]
    pub retriangulation: Option<RetriangulationArg>,
    /// Which triangulation is best: distance (closest to the original), maximum (smallest largest distance),
    /// flatness or shape (roundest triangles) [default: distance; in strict order maximum]
    #[arg(long, hide_possible_values = true)]
    pub criterion: Option<CriterionArg>,
    #[arg(
        long,
        value_name = "3..16",
        allow_negative_numbers = true,
        value_parser = clap::value_parser!(u32).range(3..=16),
        help = degree_help(),
    )]
    pub degree_limit: Option<u32>,
    /// Keep edges where the surface bends by more than this [default: no limit]
    #[arg(long, value_name = "DEG", allow_negative_numbers = true, value_parser = parse_bend)]
    pub feature_angle: Option<f64>,
}

impl RemovalArgs {
    /// Returns the first of these flags that the user gave.
    pub fn first_given_flag(&self) -> Option<&'static str> {
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

/// Part of a mesh that a step collapses to a new vertex.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum NewVerticesArg {
    /// Edges
    Edge,
    /// Triangles; single edges where that costs far less
    Triangle,
}

impl From<NewVerticesArg> for PlacedCollapse {
    fn from(collapse: NewVerticesArg) -> Self {
        match collapse {
            NewVerticesArg::Edge => Self::Edge,
            NewVerticesArg::Triangle => Self::Triangle,
        }
    }
}

/// Order in which the parts of the mesh are simplified.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum OrderArg {
    /// Half-edge collapses of least quadric cost
    Quadric,
    /// Vertex removals that leave the smallest distance
    Hausdorff,
    /// Vertex removals in the order of the one-sided Hausdorff distance
    HausdorffStrict,
}

impl OrderArg {
    /// Returns the name as it is spelled on the command line.
    pub const fn as_str(self) -> &'static str {
        match self {
            Self::Quadric => "quadric",
            Self::Hausdorff => "hausdorff",
            Self::HausdorffStrict => "hausdorff-strict",
        }
    }

    /// Returns the order of vertex removals; `None` for other orders.
    pub const fn of_removals(self) -> Option<RemovalOrder> {
        match self {
            Self::Quadric => None,
            Self::Hausdorff => Some(RemovalOrder::Mixed),
            Self::HausdorffStrict => Some(RemovalOrder::Hausdorff),
        }
    }
}

/// Parses the name of a cost function; those that may be given are in the help.
fn cost_parser() -> impl TypedValueParser<Value = CostFunction> {
    let names = CostFunction::ALL.iter().map(|cost| cost.name());
    PossibleValuesParser::new(names).try_map(|name| {
        CostFunction::ALL.iter().copied().find(|cost| cost.name() == name).ok_or("no such cost function")
    })
}

fn cost_help() -> String {
    let mut costs = String::new();
    for (i, cost) in CostFunction::ALL.iter().enumerate() {
        let separator = match CostFunction::ALL.len() - i {
            _ if i == 0 => "",
            1 => " or ",
            _ => ", ",
        };
        costs += &format!("{separator}{} ({})", cost.name(), cost.help());
    }
    format!("Cost function: {costs} [default: {}]", CostFunction::default().name())
}

/// How the hole of a removed vertex is filled.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum RetriangulationArg {
    /// With the best of all triangulations
    Free,
    /// As a half-edge collapse would
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

/// Criterion that selects the triangulation of a hole.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum CriterionArg {
    /// The one closest to the original surface
    Distance,
    /// The one with the smallest largest distance from it
    Maximum,
    /// The flattest one
    Flatness,
    /// The one with the roundest triangles
    Shape,
}

impl From<CriterionArg> for HoleCriterion {
    fn from(criterion: CriterionArg) -> Self {
        match criterion {
            CriterionArg::Distance => Self::Distance,
            CriterionArg::Maximum => Self::Maximum,
            CriterionArg::Flatness => Self::Flatness,
            CriterionArg::Shape => Self::Shape,
        }
    }
}

fn degree_help() -> String {
    let default = RemovalOptions::default().degree_limit;
    format!("Keep vertices with more triangles than this [default: {default}]")
}

fn weight_help(weight: impl Fn(AttributeWeights) -> f32, what: &str) -> String {
    let default = weight(AttributeWeights::default());
    format!(
        "Weight of {what}: a difference of 1 counts as this fraction of the diagonal; 0 ignores them \
         [default: {default}]"
    )
}

fn parse_weight(text: &str) -> Result<f32, String> {
    match text.parse::<f32>() {
        Ok(weight) if (0.0..=WeightArgs::MAX).contains(&weight) => Ok(weight),
        _ => Err(format!("must lie between 0 (ignored) and {}", WeightArgs::MAX)),
    }
}

fn parse_bend(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(angle) if (0.0..=180.0).contains(&angle) => Ok(angle),
        _ => Err("must be an angle from 0 to 180 degrees".to_owned()),
    }
}
