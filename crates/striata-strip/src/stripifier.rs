//! One entry for all stripifiers.

use std::fmt;
use std::ops::Range;
use std::str::FromStr;

use super::cache::cheapest_for_cache;
use super::links::StripLinks;
use super::tunnel::{self, Identity};
use super::write::write_strips;
use super::{StripSet, cheapest, fewest, greedy, stripe};
use crate::mesh::{DualGraph, IndexedMesh, MeshError, is_proper};

/// Which algorithm makes the strips.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum Stripifier {
    /// Best of three walks from triangles with few free neighbours: fast, few indices.
    #[default]
    Greedy,
    /// On to the neighbour with the fewest free neighbours, without a swap among equals: the classic \[ESV96\], few strips.
    Stripe,
    /// Tunnelling with dynamic identities \[PS03\]: few strips.
    Tunnel {
        /// The longest tunnel searched for, in links; odd (an even length acts as the odd one below it).
        max_length: u32,
    },
    /// Tunnelling with identities of the search's beginning \[Ste01\]: the baseline of the former.
    StaticTunnel {
        /// As for [`Stripifier::Tunnel`].
        max_length: u32,
    },
    /// Walks of strip ends: fewest strips.
    Fewest,
    /// Local moves with annealing, strips joined where they meet: fewest indices.
    Cheapest,
}

/// The longest tunnel that is searched for where nothing else is said: what the paper took for its bunny.
pub const DEFAULT_TUNNEL_LENGTH: u32 = 17;

impl fmt::Display for Stripifier {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Greedy => f.write_str("greedy"),
            Self::Stripe => f.write_str("stripe"),
            Self::Tunnel { max_length } => write!(f, "tunnel:{max_length}"),
            Self::StaticTunnel { max_length } => write!(f, "tunnel-static:{max_length}"),
            Self::Fewest => f.write_str("fewest"),
            Self::Cheapest => f.write_str("cheapest"),
        }
    }
}

/// A name that no stripifier has.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{found:?} is no stripifier; there are {}, where MAX is 1 or more", Stripifier::SPELLINGS)]
pub struct ParseStripifierError {
    /// What was found.
    pub found: String,
}

impl Stripifier {
    /// How each is written, for messages and help.
    pub const SPELLINGS: &'static str = "greedy, stripe, tunnel[:MAX], tunnel-static[:MAX], fewest, cheapest";
}

impl FromStr for Stripifier {
    type Err = ParseStripifierError;

    /// Reads a name, and after a colon the parameter of those that have one.
    fn from_str(text: &str) -> Result<Self, Self::Err> {
        let wrong = || ParseStripifierError { found: text.to_owned() };
        let (name, parameter) = match text.split_once(':') {
            Some((name, parameter)) => (name, Some(parameter)),
            None => (text, None),
        };
        let max_length = || match parameter {
            Some(length) => length.parse().ok().filter(|&length| length > 0).ok_or_else(wrong),
            None => Ok(DEFAULT_TUNNEL_LENGTH),
        };
        match name {
            "tunnel" => Ok(Self::Tunnel { max_length: max_length()? }),
            "tunnel-static" => Ok(Self::StaticTunnel { max_length: max_length()? }),
            _ if parameter.is_some() => Err(wrong()),
            "greedy" => Ok(Self::Greedy),
            "stripe" => Ok(Self::Stripe),
            "fewest" => Ok(Self::Fewest),
            "cheapest" => Ok(Self::Cheapest),
            _ => Err(wrong()),
        }
    }
}

/// The most that [`StripOptions::effort`] counts as.
const MAX_EFFORT: f64 = 1e6;

/// Options of [`stripify`].
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct StripOptions {
    /// The algorithm; default [`Stripifier::Greedy`].
    pub stripifier: Stripifier,
    /// Seed of those that choose at random; equal seeds give equal strips. Default 0.
    pub seed: u64,
    /// How long those that search go on, as a factor of their usual number of moves, 0 to 1,000,000; default 1.
    pub effort: f64,
    /// Indices that one miss of a vertex cache is worth; default 0: misses do not count. Over 0, the strips of any
    /// stripifier are put in a better order, and from 0.1 on they give way to strips grown for the cache where
    /// these make `indices + cache_weight * misses` less. Between 0.5 and 3 these are compact rows.
    pub cache_weight: f64,
    /// Entries of that first-in first-out cache; default 16. With fewer than 3 misses do not count; strips are
    /// grown for at most 64.
    pub cache_size: usize,
}

impl Default for StripOptions {
    fn default() -> Self {
        Self { stripifier: Stripifier::default(), seed: 0, effort: 1.0, cache_weight: 0.0, cache_size: 16 }
    }
}

impl StripOptions {
    /// Sets [`StripOptions::stripifier`].
    pub fn with_stripifier(mut self, stripifier: Stripifier) -> Self {
        self.stripifier = stripifier;
        self
    }

    /// Sets [`StripOptions::seed`].
    pub fn with_seed(mut self, seed: u64) -> Self {
        self.seed = seed;
        self
    }

    /// Sets [`StripOptions::effort`].
    pub fn with_effort(mut self, effort: f64) -> Self {
        self.effort = effort;
        self
    }

    /// Sets [`StripOptions::cache_weight`].
    pub fn with_cache_weight(mut self, weight: f64) -> Self {
        self.cache_weight = weight;
        self
    }

    /// Sets [`StripOptions::cache_size`].
    pub fn with_cache_size(mut self, size: usize) -> Self {
        self.cache_size = size;
        self
    }

    /// The moves that [`stripify`] allows a search on so many triangles; infinite for those that end by themselves.
    pub fn allowed_moves(&self, triangle_count: usize) -> f64 {
        let effort = if self.effort.is_nan() { 0.0 } else { self.effort.clamp(0.0, MAX_EFFORT) };
        self.stripifier.moves_per_triangle() * effort * triangle_count.max(1) as f64
    }
}

/// Told how many moves a search has made, answers which share of its budget that is; the search ends at 1.
///
/// A search plans with it (it cools as the share grows), so it should grow steadily, and it must come to 1:
/// `cheapest` has no other end.
pub type SpentFn<'a> = dyn FnMut(u64) -> f64 + 'a;

/// What a stripifier works on.
pub(super) struct Task<'a> {
    pub(super) triangles: &'a [[u32; 3]],
    pub(super) groups: Vec<Range<usize>>,
    pub(super) options: &'a StripOptions,
}

impl Task<'_> {
    /// Whether a triangle has three corners: others are in no strip.
    pub(super) fn is_proper(&self, triangle: u32) -> bool {
        is_proper(&self.triangles[triangle as usize])
    }
}

/// Covers each triangle of a mesh by exactly one strip; degenerate triangles (two equal corners) are left out.
///
/// The groups of the set are those of the mesh (one where it has none).
///
/// # Errors
/// [`MeshError`] where the mesh's parts do not fit together.
pub fn stripify(mesh: &IndexedMesh, options: &StripOptions) -> Result<StripSet, MeshError> {
    let allowed = options.allowed_moves(mesh.triangle_count());
    stripify_from(mesh, &StripSet::new(), options, &mut |moves| moves as f64 / allowed.max(1.0))
}

/// Does as [`stripify`] with [`Stripifier::Greedy`]; a small program that needs no other is spared the code of all others.
///
/// # Errors
/// [`MeshError`] where the mesh's parts do not fit together.
pub fn stripify_greedily(mesh: &IndexedMesh) -> Result<StripSet, MeshError> {
    mesh.check()?;
    let graph = DualGraph::of_vertices(mesh);
    let groups: Vec<_> = mesh.groups_or_whole().iter().map(|group| group.range()).collect();
    let options = StripOptions::default().with_stripifier(Stripifier::Greedy);
    let task = Task { triangles: &mesh.triangles, groups, options: &options };
    let mut links = StripLinks::new(&graph);
    greedy::run(&task, &mut links);
    let mut out = StripSet::new();
    write_strips(task.triangles, &links, task.groups.iter().cloned(), &mut out);
    Ok(out)
}

/// Does as [`stripify`], but begins with strips that are there (none: an empty set) and lasts as long as
/// the caller's budget.
///
/// Strips that do not fit the mesh are cut where they do not: triangles that it does not have, edges that its dual
/// graph does not link, and, among equal triangles, where the one that a strip meant cannot be told. The
/// stripifiers that do not search keep what is then there and cover the rest.
///
/// # Errors
/// [`MeshError`] where the mesh's parts do not fit together.
pub fn stripify_from(
    mesh: &IndexedMesh,
    start: &StripSet,
    options: &StripOptions,
    spent: &mut SpentFn<'_>,
) -> Result<StripSet, MeshError> {
    mesh.check()?;
    let graph = DualGraph::of_vertices(mesh);
    let groups = mesh.groups_or_whole().iter().map(|group| group.range()).collect();
    let task = Task { triangles: &mesh.triangles, groups, options };
    let mut links = match start.strip_count() {
        0 => StripLinks::new(&graph),
        _ => StripLinks::from_strips(&graph, &mesh.triangles, start),
    };
    links.cut_loops();
    let mut out = StripSet::new();
    match options.stripifier {
        Stripifier::Greedy => greedy::run(&task, &mut links),
        Stripifier::Stripe => stripe::run(&task, &mut links),
        Stripifier::Tunnel { max_length } => {
            tunnel::run(&task, &mut links, max_length, Identity::Dynamic, spent);
        }
        Stripifier::StaticTunnel { max_length } => {
            tunnel::run(&task, &mut links, max_length, Identity::Static, spent);
        }
        Stripifier::Fewest => fewest::run(&task, &graph, &mut links, spent),
        Stripifier::Cheapest => {
            cheapest::run(&task, &mut links, spent, &mut out);
        }
    }
    debug_assert_eq!(links.clone().cut_loops(), 0, "{} closed a loop", options.stripifier);
    if options.stripifier != Stripifier::Cheapest {
        write_strips(task.triangles, &links, task.groups.iter().cloned(), &mut out);
    }
    if options.cache_weight > 0.0 {
        out = cheapest_for_cache(&task, &links, out);
    }
    Ok(out)
}

impl Stripifier {
    /// Moves that the search makes for each triangle of a mesh, with an effort of 1.
    fn moves_per_triangle(self) -> f64 {
        match self {
            // These end by themselves.
            Self::Greedy | Self::Stripe | Self::Tunnel { .. } | Self::StaticTunnel { .. } => f64::INFINITY,
            Self::Fewest => 20.0,
            Self::Cheapest => 50.0,
        }
    }
}
