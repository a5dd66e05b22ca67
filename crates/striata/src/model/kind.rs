//! Names of the models, as used in files, reports and on the command line.

use std::fmt;
use std::str::FromStr;

/// A kind of level-of-detail model. Its name is the same in files, in reports and on the command line.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[non_exhaustive]
pub enum ModelKind {
    /// Strips that are edited in place; see [`LodStrips`](super::LodStrips).
    LodStrips,
    /// Strips that are rebuilt only when they change; see [`Mts`](super::Mts).
    Mts,
    /// Progressive fans for view-dependent refinement; see [`Fans`](super::Fans).
    Fans,
    /// Fragments of any simplifier, refined by view or by region; see [`Patterns`](super::Patterns).
    Patterns,
    /// The progressive stream of a mesh, coded by the crate `striata-stream`.
    Progressive,
}

impl ModelKind {
    /// All kinds, in the order in which files store them.
    pub const ALL: [Self; 5] = [Self::LodStrips, Self::Mts, Self::Fans, Self::Patterns, Self::Progressive];

    /// Returns the name of the kind.
    pub const fn as_str(self) -> &'static str {
        match self {
            Self::LodStrips => "lodstrips",
            Self::Mts => "mts",
            Self::Fans => "fans",
            Self::Patterns => "patterns",
            Self::Progressive => "progressive",
        }
    }
}

impl fmt::Display for ModelKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.as_str())
    }
}

impl FromStr for ModelKind {
    type Err = UnknownModel;

    fn from_str(name: &str) -> Result<Self, UnknownModel> {
        let known = Self::ALL.into_iter().find(|kind| kind.as_str() == name);
        known.ok_or_else(|| UnknownModel { name: name.to_owned() })
    }
}

/// Error for a name that is not a model. Its message lists the valid names.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("unknown model {name:?}, expected one of {}", ModelKind::ALL.map(ModelKind::as_str).join(", "))]
#[non_exhaustive]
pub struct UnknownModel {
    /// The unknown name.
    pub name: String,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_read_back() {
        for kind in ModelKind::ALL {
            assert_eq!(kind.to_string().parse(), Ok(kind));
        }
        let error = "MTS".parse::<ModelKind>().unwrap_err();
        assert_eq!(
            error.to_string(),
            "unknown model \"MTS\", expected one of lodstrips, mts, fans, patterns, progressive"
        );
    }
}
