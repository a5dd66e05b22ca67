//! Flags of the verbs that make strips.

use clap::Args;
use striata_strip::{StripOptions, Stripifier};

/// Default stripifier of `build`.
pub const BUILD_STRIPS: Stripifier = Stripifier::Cheapest;

/// Default number of vertex cache entries.
const DEFAULT_CACHE_SIZE: u32 = 16;

/// Help heading of the flags about strips.
pub const STRIPS: &str = "Strips";

/// Returns the help text of flags that take a chain of stripifiers.
pub fn strips_help() -> String {
    format!(
        "Stripifiers, joined by +, each starting from the strips of the one before: {}",
        Stripifier::SPELLINGS
    )
}

/// Options of stripifiers that search for better strips.
#[derive(Clone, Copy, Debug, Args)]
#[command(next_help_heading = STRIPS)]
pub struct StripSearchArgs {
    /// Time for each stripifier that searches; results then vary between runs [default: a fixed number of
    /// moves]
    #[arg(long, value_name = "SECS", allow_negative_numbers = true, value_parser = parse_at_least_zero)]
    pub budget: Option<f64>,
    /// Random seed; equal seeds give equal strips
    #[arg(long, value_name = "N", default_value_t = 0, allow_negative_numbers = true)]
    pub seed: u64,
    /// Number of indices that the last stripifier spends to avoid one vertex cache miss
    #[arg(
        long,
        value_name = "INDICES",
        default_value_t = 0.0,
        allow_negative_numbers = true,
        value_parser = parse_at_least_zero,
    )]
    pub cache_weight: f64,
    /// Vertex cache entries, for --cache-weight (FIFO) and for the misses in the report
    #[arg(
        long,
        value_name = "N",
        default_value_t = DEFAULT_CACHE_SIZE,
        allow_negative_numbers = true,
        value_parser = clap::value_parser!(u32).range(1..=4096),
    )]
    pub cache_size: u32,
}

impl Default for StripSearchArgs {
    fn default() -> Self {
        let StripOptions { seed, cache_weight, .. } = StripOptions::default();
        Self { budget: None, seed, cache_weight, cache_size: DEFAULT_CACHE_SIZE }
    }
}

/// Parses a number that is 0 or more.
///
/// # Errors
/// If the text is not such a number.
pub fn parse_at_least_zero(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(number) if number.is_finite() && number >= 0.0 => Ok(number),
        _ => Err("must be a number, 0 or more".to_owned()),
    }
}
