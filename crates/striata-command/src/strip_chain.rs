//! Stripifiers in a chain: each begins with the strips of the one before.
//!
//! Written `greedy+tunnel:17`; the names are the library's own, so what it learns the command knows.

use std::fmt;
use std::str::FromStr;
use std::time::Instant;

use striata::mesh::{IndexedMesh, MeshError};
use striata::strip::StripSet;
use striata_strip::{StripOptions, Stripifier, stripify_from};

use crate::args::StripSearchArgs;

/// Stripifiers in the order in which they work; at least one.
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

/// A chain, and how its stripifiers search.
#[derive(Clone, Debug)]
pub struct StripPlan {
    /// The stripifiers.
    pub chain: StripChain,
    /// How long and with which chances they search.
    pub search: StripSearchArgs,
}

/// Strips, and how long the stripifiers took to make them.
#[derive(Clone, Debug)]
pub struct TimedStrips {
    /// The strips.
    pub strips: StripSet,
    /// Seconds.
    pub secs: f64,
}

impl StripPlan {
    /// Entries of the vertex cache that strips are made and measured for.
    pub fn cache_size(&self) -> usize {
        self.search.cache_size as usize
    }

    /// The same with another seed.
    pub fn with_seed(&self, seed: u64) -> Self {
        Self { chain: self.chain.clone(), search: StripSearchArgs { seed, ..self.search } }
    }

    /// The same with a budget in seconds.
    pub fn with_budget(&self, secs: f64) -> Self {
        Self { chain: self.chain.clone(), search: StripSearchArgs { budget: Some(secs), ..self.search } }
    }

    /// Lets each stripifier work on the strips of the one before; `show` is told which share of the work is done.
    ///
    /// # Errors
    /// Where the mesh's parts do not fit together.
    pub fn run(&self, mesh: &IndexedMesh, show: &mut dyn FnMut(f64)) -> Result<TimedStrips, MeshError> {
        let started = Instant::now();
        let mut strips = StripSet::new();
        for (i, &stripifier) in self.chain.stripifiers.iter().enumerate() {
            let is_last = i + 1 == self.chain.stripifiers.len();
            let mut options = self.search.options(stripifier);
            if !is_last {
                // The next one would take strips for a cache apart.
                options.cache_weight = 0.0;
            }
            let allowed = options.allowed_moves(mesh.triangle_count());
            let searches_since = Instant::now();
            let mut spent = |moves: u64| {
                let share = match self.search.budget {
                    Some(secs) => share_of(searches_since.elapsed().as_secs_f64(), secs),
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
    /// The stripifier of a chain of one.
    pub fn only(&self) -> Option<Stripifier> {
        match self.stripifiers[..] {
            [only] => Some(only),
            _ => None,
        }
    }

    /// The stripifier whose strips come out.
    pub fn last(&self) -> Stripifier {
        self.stripifiers.last().copied().unwrap_or(StripOptions::default().stripifier)
    }

    /// Whether a budget changes what comes out: one of the stripifiers goes on as long as it may.
    pub fn searches(&self) -> bool {
        self.stripifiers.iter().any(|&stripifier| {
            StripOptions::default().with_stripifier(stripifier).allowed_moves(1).is_finite()
        })
    }

    /// Whether few strips are what counts at last.
    pub fn wants_few_strips(&self) -> bool {
        self.last() == Stripifier::Fewest
    }
}

/// All of it where nothing is allowed.
fn share_of(spent: f64, allowed: f64) -> f64 {
    if allowed > 0.0 { spent / allowed } else { 1.0 }
}

impl StripSearchArgs {
    /// Options of one stripifier.
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
    fn chains_are_written_as_they_are_read() {
        for text in ["greedy", "greedy+greedy"] {
            assert_eq!(text.parse::<StripChain>().map(|chain| chain.to_string()), Ok(text.to_owned()));
        }
        assert_eq!("greedy + greedy".parse::<StripChain>(), "greedy+greedy".parse());
        for wrong in ["", "+", "greedy+", "greedy,greedy", "greed"] {
            let said = wrong.parse::<StripChain>().expect_err("no such chain");
            assert!(said.contains("greedy"), "{said}");
        }
    }

    #[test]
    fn a_budget_of_nothing_is_spent_at_once() {
        assert_eq!(share_of(0.0, 0.0), 1.0);
        assert_eq!(share_of(1.0, 4.0), 0.25);
        assert_eq!(share_of(7.0, f64::INFINITY), 0.0);
    }
}
