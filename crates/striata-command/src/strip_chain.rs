//! Chains of stripifiers, each of which starts from the strips of the one before.
//!
//! A chain is written `greedy+tunnel:17`. The names are those of the library, so new stripifiers need no
//! change here.

use std::fmt;
use std::str::FromStr;
use std::time::Instant;

use striata::mesh::{IndexedMesh, MeshError};
use striata::strip::StripSet;
use striata_strip::{StripOptions, Stripifier, stripify_from};

use crate::args::StripSearchArgs;

/// One or more stripifiers, in the order in which they run.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct StripChain {
    stripifiers: Vec<Stripifier>,
}

impl From<Stripifier> for StripChain {
    fn from(stripifier: Stripifier) -> Self {
        Self { stripifiers: vec![stripifier] }
    }
}

impl FromStr for StripChain {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let parse = |name: &str| name.trim().parse::<Stripifier>().map_err(|error| error.to_string());
        Ok(Self { stripifiers: text.split('+').map(parse).collect::<Result<_, _>>()? })
    }
}

impl fmt::Display for StripChain {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (i, stripifier) in self.stripifiers.iter().enumerate() {
            f.write_str(if i == 0 { "" } else { "+" })?;
            write!(f, "{stripifier}")?;
        }
        Ok(())
    }
}

/// Share of the usual effort that is spent on the strips of each level: files grow by 2 %, and all levels take
/// one and a half times the time of the full mesh instead of four times.
const LEVEL_EFFORT: f64 = 0.2;

/// Share of the moves of a search, and of the time if that is its budget.
#[derive(Clone, Copy)]
struct Share {
    moves: f64,
    time: f64,
}

/// A chain of stripifiers with search options.
#[derive(Clone, Debug)]
pub struct StripPlan {
    /// The stripifiers to run.
    pub chain: StripChain,
    /// Options of stripifiers that search.
    pub search: StripSearchArgs,
}

/// Strips, with the time that it took to make them.
#[derive(Clone, Debug)]
pub struct TimedStrips {
    /// The strips.
    pub strips: StripSet,
    /// Time spent by all stripifiers, seconds.
    pub secs: f64,
}

impl StripPlan {
    /// Returns the number of vertex cache entries that strips are optimized and measured for.
    pub fn cache_size(&self) -> usize {
        self.search.cache_size as usize
    }

    /// Returns the plan with another seed.
    pub fn with_seed(&self, seed: u64) -> Self {
        Self { chain: self.chain.clone(), search: StripSearchArgs { seed, ..self.search } }
    }

    /// Returns the plan with a time budget in seconds.
    pub fn with_budget(&self, secs: f64) -> Self {
        Self { chain: self.chain.clone(), search: StripSearchArgs { budget: Some(secs), ..self.search } }
    }

    /// Runs each stripifier on the strips of the one before; calls `show` with the completed fraction of the
    /// work.
    ///
    /// # Errors
    /// If the mesh is inconsistent.
    pub fn run(&self, mesh: &IndexedMesh, show: &mut dyn FnMut(f64)) -> Result<TimedStrips, MeshError> {
        self.run_from(mesh, StripSet::new(), show)
    }

    /// Runs like [`run`](Self::run), but begins with existing strips.
    ///
    /// # Errors
    /// If the mesh is inconsistent.
    pub fn run_from(
        &self,
        mesh: &IndexedMesh,
        start: StripSet,
        show: &mut dyn FnMut(f64),
    ) -> Result<TimedStrips, MeshError> {
        self.run_share(mesh, start, Share { moves: 1.0, time: 1.0 }, show)
    }

    /// Makes the strips of a level of a mesh of `full_count` triangles, with a part of the moves or of the time
    /// that are spent on each triangle of the full mesh: there are many levels to make strips for.
    ///
    /// # Errors
    /// If the level is inconsistent.
    pub fn run_for_level(&self, level: &IndexedMesh, full_count: usize) -> Result<StripSet, MeshError> {
        let size = level.triangle_count() as f64 / full_count.max(1) as f64;
        let share = Share { moves: LEVEL_EFFORT, time: LEVEL_EFFORT * size };
        Ok(self.run_share(level, StripSet::new(), share, &mut |_| ())?.strips)
    }

    /// Runs with a share of the moves, or of the time if there is a budget.
    fn run_share(
        &self,
        mesh: &IndexedMesh,
        start: StripSet,
        share: Share,
        show: &mut dyn FnMut(f64),
    ) -> Result<TimedStrips, MeshError> {
        let started = Instant::now();
        let mut strips = start;
        for (i, &stripifier) in self.chain.stripifiers.iter().enumerate() {
            let is_last = i + 1 == self.chain.stripifiers.len();
            let mut options = self.search.options(stripifier);
            if !is_last {
                // The next stripifier would break up strips that are optimized for the cache.
                options.cache_weight = 0.0;
            }
            options.effort *= share.moves;
            let allowed = options.allowed_moves(mesh.triangle_count());
            let searches_since = Instant::now();
            let mut spent = |moves: u64| {
                let share = match self.search.budget {
                    Some(secs) => share_of(searches_since.elapsed().as_secs_f64(), secs * share.time),
                    None => share_of(moves as f64, allowed),
                };
                show((i as f64 + share.min(1.0)) / self.chain.stripifiers.len() as f64);
                share
            };
            strips = stripify_from(mesh, &strips, &options, &mut spent)?;
        }
        Ok(TimedStrips { strips, secs: started.elapsed().as_secs_f64() })
    }
}

impl StripChain {
    /// Returns the only stripifier of a chain of one.
    pub fn only(&self) -> Option<Stripifier> {
        match self.stripifiers[..] {
            [only] => Some(only),
            _ => None,
        }
    }

    /// Returns the last stripifier, which makes the final strips.
    pub fn last(&self) -> Stripifier {
        self.stripifiers.last().copied().unwrap_or(StripOptions::default().stripifier)
    }

    /// Whether a time budget affects the result, because one of the stripifiers searches as long as it may.
    pub fn searches(&self) -> bool {
        self.stripifiers.iter().any(|&stripifier| {
            StripOptions::default().with_stripifier(stripifier).allowed_moves(1).is_finite()
        })
    }

    /// Whether the last stripifier minimizes the number of strips.
    pub fn minimizes_strip_count(&self) -> bool {
        self.last() == Stripifier::Fewest
    }
}

/// Returns the spent fraction of a budget; an empty budget is always spent.
fn share_of(spent: f64, allowed: f64) -> f64 {
    if allowed > 0.0 { spent / allowed } else { 1.0 }
}

impl StripSearchArgs {
    /// Returns the options of one stripifier.
    pub fn options(&self, stripifier: Stripifier) -> StripOptions {
        StripOptions::default()
            .with_stripifier(stripifier)
            .with_seed(self.seed)
            .with_cache_weight(self.cache_weight)
            .with_cache_size(self.cache_size as usize)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn chains_display_as_they_were_written() {
        for text in ["greedy", "greedy+greedy"] {
            assert_eq!(text.parse::<StripChain>().map(|chain| chain.to_string()), Ok(text.to_owned()));
        }
        assert_eq!("greedy + greedy".parse::<StripChain>(), "greedy+greedy".parse());
        for wrong in ["", "+", "greedy+", "greedy,greedy", "greed"] {
            let message = wrong.parse::<StripChain>().expect_err("no such chain");
            assert!(message.contains("greedy"), "{message}");
        }
    }

    #[test]
    fn an_empty_budget_is_spent_immediately() {
        assert_eq!(share_of(0.0, 0.0), 1.0);
        assert_eq!(share_of(1.0, 4.0), 0.25);
        assert_eq!(share_of(7.0, f64::INFINITY), 0.0);
    }
}
