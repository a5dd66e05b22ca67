//! Flags of all verbs that make strips.

use clap::Args;
use striata_strip::{StripOptions, Stripifier};

/// The strips that `build` makes where nothing else is said.
pub const BUILD_STRIPS: Stripifier = Stripifier::Cheapest;

/// Entries of the vertex cache that misses are counted for where nothing else is said.
const USUAL_CACHE_SIZE: u32 = 16;

/// Heading of the flags about strips.
pub const STRIPS: &str = "Strips";

/// Help of a flag that takes a chain of stripifiers.
pub fn strips_help() -> String {
    format!(
        "Stripifiers, joined by +, each beginning with the strips of the one before: {}",
        Stripifier::SPELLINGS
    )
}

/// How those stripifiers that search do it.
#[derive(Clone, Copy, Debug, Args)]
#[command(next_help_heading = STRIPS)]
pub struct StripSearchArgs {
    /// Seconds for each stripifier that searches; results then differ between runs [default: a fixed number of moves]
    #[arg(long, value_name = "SECS", allow_negative_numbers = true, value_parser = parse_at_least_zero)]
    pub budget: Option<f64>,
    /// Seed of what is chosen at random; equal seeds give equal strips
    #[arg(long, value_name = "N", default_value_t = 0, allow_negative_numbers = true)]
    pub seed: u64,
    /// How many indices one miss of the vertex cache is worth, to the last stripifier
    #[arg(long, value_name = "W", default_value_t = 0.0, allow_negative_numbers = true, value_parser = parse_at_least_zero)]
    pub cache_weight: f64,
    /// Entries of that first-in first-out cache, and of the caches that misses are reported for
    #[arg(long, value_name = "N", default_value_t = USUAL_CACHE_SIZE, allow_negative_numbers = true, value_parser = clap::value_parser!(u32).range(1..=4096))]
    pub cache_size: u32,
}

impl Default for StripSearchArgs {
    fn default() -> Self {
        let StripOptions { seed, cache_weight, .. } = StripOptions::default();
        Self { budget: None, seed, cache_weight, cache_size: USUAL_CACHE_SIZE }
    }
}

/// Parses a number that is 0 or more.
///
/// # Errors
/// If the text is none.
pub fn parse_at_least_zero(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(number) if number.is_finite() && number >= 0.0 => Ok(number),
        _ => Err("must be a number, 0 or more".to_owned()),
    }
}
