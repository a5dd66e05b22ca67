//! The names of all stripifiers.

use std::fmt;
use std::str::FromStr;

/// Which algorithm makes the strips.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum Stripifier {
    /// Best of three walks from triangles with few free neighbors: fast, few indices.
    #[default]
    Greedy,
    /// On to the neighbor with the fewest free neighbors, without a swap among equals: the classic \[ESV96\], few strips.
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

/// The longest tunnel that is searched for when nothing else is said: what the paper took for its bunny.
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

    /// Moves that the search makes for each triangle of a mesh, with an effort of 1.
    pub(crate) fn moves_per_triangle(self) -> f64 {
        match self {
            // These end by themselves.
            Self::Greedy | Self::Stripe | Self::Tunnel { .. } | Self::StaticTunnel { .. } => f64::INFINITY,
            Self::Fewest => 20.0,
            Self::Cheapest => 50.0,
        }
    }
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
