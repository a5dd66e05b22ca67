//! The stripifiers and their names on the command line.

use std::fmt;
use std::str::FromStr;

/// Algorithm that makes the strips.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum Stripifier {
    /// Best of three greedy walks from triangles with few free neighbors: fast, few indices.
    #[default]
    Greedy,
    /// The classic STRIPE \[ESV96\]: to the neighbor with the fewest free neighbors. Few strips.
    Stripe {
        /// Whether patches of quadrilaterals are covered row by row first: the global algorithm.
        has_patches: bool,
        /// How swaps are weighed against isolated triangles.
        swaps: StripeSwaps,
    },
    /// Tunnelling with dynamic strip identities \[PS03\]: few strips.
    Tunnel {
        /// Length of the longest tunnel, in links: odd (an even number acts as the odd one below it).
        max_length: u32,
    },
    /// Random walks of strip ends until they meet: fewest strips.
    Fewest,
    /// Simulated annealing of single links, then joins strips that meet at a vertex: fewest indices.
    Cheapest,
}

/// How [`Stripifier::Stripe`] weighs swaps against isolated triangles.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum StripeSwaps {
    /// Among equally isolated neighbors, to the one whose own neighbors are most isolated.
    #[default]
    Free,
    /// Among equally isolated neighbors, to the one that needs no swap.
    Few,
    /// Strips end where they cannot go on without a swap.
    Never,
}

/// Default length of the longest tunnel, in links: the length that \[PS03\] uses for the bunny.
pub const DEFAULT_TUNNEL_LENGTH: u32 = 17;

impl fmt::Display for Stripifier {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Greedy => f.write_str("greedy"),
            Self::Stripe { has_patches, swaps } => {
                let patches = if *has_patches { ":global" } else { "" };
                let swaps = match swaps {
                    StripeSwaps::Free => "",
                    StripeSwaps::Few => ":few-swaps",
                    StripeSwaps::Never => ":no-swaps",
                };
                write!(f, "stripe{patches}{swaps}")
            }
            Self::Tunnel { max_length } => write!(f, "tunnel:{max_length}"),
            Self::Fewest => f.write_str("fewest"),
            Self::Cheapest => f.write_str("cheapest"),
        }
    }
}

/// Error for a name that is not a stripifier.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{found:?} is not a stripifier; expected one of {}, with MAX 1 or more", Stripifier::SPELLINGS)]
pub struct ParseStripifierError {
    /// The text that was parsed.
    pub found: String,
}

impl Stripifier {
    /// Names of all stripifiers, for messages and help.
    pub const SPELLINGS: &'static str =
        "greedy, stripe[:global][:few-swaps|:no-swaps], tunnel[:MAX], fewest, cheapest";

    /// Number of moves that the search makes per triangle of a mesh at effort 1.
    pub(crate) fn moves_per_triangle(self) -> f64 {
        match self {
            // These end without a budget.
            Self::Greedy | Self::Stripe { .. } | Self::Tunnel { .. } => f64::INFINITY,
            Self::Fewest => 20.0,
            Self::Cheapest => 50.0,
        }
    }
}

impl FromStr for Stripifier {
    type Err = ParseStripifierError;

    /// Parses a name, followed by a colon and the parameter if the stripifier has one.
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
            "stripe" => parse_stripe(parameter).ok_or_else(wrong),
            _ if parameter.is_some() => Err(wrong()),
            "greedy" => Ok(Self::Greedy),
            "fewest" => Ok(Self::Fewest),
            "cheapest" => Ok(Self::Cheapest),
            _ => Err(wrong()),
        }
    }
}

/// Parses the parameters of `stripe`: `global`, then one about swaps.
fn parse_stripe(parameter: Option<&str>) -> Option<Stripifier> {
    let mut words: Vec<&str> = parameter.into_iter().flat_map(|text| text.split(':')).collect();
    let has_patches = words.first() == Some(&"global");
    if has_patches {
        words.remove(0);
    }
    let swaps = match words[..] {
        [] => StripeSwaps::Free,
        ["few-swaps"] => StripeSwaps::Few,
        ["no-swaps"] => StripeSwaps::Never,
        _ => return None,
    };
    Some(Stripifier::Stripe { has_patches, swaps })
}
