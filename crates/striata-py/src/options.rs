//! Options and targets, as dictionaries and pairs that the Python half has checked for their names.

use pyo3::prelude::*;
use striata::Target;
use striata::simplify::{
    AttributeWeights, BoundaryRule, CostFunction, SeamRule, SequenceOptions, StopReason, TopologyRule,
};

use crate::errors::{Outcome, value_error};

/// Options of simplification.
#[derive(Debug, FromPyObject)]
#[pyo3(from_item_all)]
pub(crate) struct SimplifyArguments {
    cost: String,
    boundary: String,
    seams: String,
    topology: String,
    height_field: Option<bool>,
    max_error: Option<f64>,
    pair_distance: Option<f64>,
    coarsest: usize,
    locked: Vec<u32>,
    /// Weights of normals, texture coordinates and colors.
    weights: Option<[f32; 3]>,
}

impl SimplifyArguments {
    /// Converts to the library's options.
    pub(crate) fn sequence(self) -> Outcome<SequenceOptions> {
        let costs: Vec<_> = CostFunction::ALL.iter().map(|cost| (cost.name(), *cost)).collect();
        let mut options = SequenceOptions::default()
            .with_cost(choice("cost", &self.cost, &costs)?)
            .with_boundary(choice(
                "boundary",
                &self.boundary,
                &[("keep", BoundaryRule::Kept), ("lock", BoundaryRule::Locked)],
            )?)
            .with_seams(choice(
                "seams",
                &self.seams,
                &[("cross", SeamRule::Cross), ("keep", SeamRule::Keep)],
            )?)
            .with_topology(choice(
                "topology",
                &self.topology,
                &[
                    ("change", TopologyRule::Change),
                    ("keep_parts", TopologyRule::KeepParts),
                    ("keep", TopologyRule::Keep),
                ],
            )?)
            .with_base_triangle_count(self.coarsest)
            .with_locked_vertices(self.locked);
        options.height_field = self.height_field;
        options.max_error = self.max_error;
        options.pair_distance = self.pair_distance;
        if let Some([normal, texcoord, color]) = self.weights {
            options.attribute_weights =
                AttributeWeights { normal, texcoord, color, ..AttributeWeights::default() };
        }
        Ok(options)
    }
}

/// Finds a name in a list of choices.
pub(crate) fn choice<T: Copy>(option: &str, name: &str, choices: &[(&str, T)]) -> Outcome<T> {
    let found = choices.iter().find(|(choice, _)| *choice == name);
    found.map(|(_, value)| *value).ok_or_else(|| {
        let names: Vec<String> = choices.iter().map(|(choice, _)| format!("{choice:?}")).collect();
        value_error(format!("{option} is {name:?}, but must be one of {}", names.join(", ")))
    })
}

/// A target as a pair: its kind and its value.
#[derive(Debug, FromPyObject)]
pub(crate) struct TargetArgument(String, f64);

impl TargetArgument {
    pub(crate) fn target(&self) -> Outcome<Target> {
        let Self(kind, value) = self;
        // Counts beyond the range of integers saturate, which means the full mesh.
        let count = *value as usize;
        Ok(match kind.as_str() {
            "triangles" => Target::Triangles(count),
            "vertices" => Target::Vertices(count),
            "error" => Target::Error(*value),
            "detail" => Target::Detail(*value),
            "splits" => Target::SplitCount(count),
            _ => return Err(value_error(format!("unknown target {kind:?}"))),
        })
    }
}

/// Name of a stop reason.
pub(crate) fn reason(stop_reason: StopReason) -> &'static str {
    stop_reason.as_str()
}
