//! The models by name.

use std::fmt;
use std::str::FromStr;

/// A model of levels of detail. Its name is the same in files, in reports and on the command line.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[non_exhaustive]
pub enum ModelKind {
    /// Strips that are edited in place: [`LodStrips`](super::LodStrips).
    LodStrips,
    /// Strips that are walked again where they change: [`Mts`](super::Mts).
    Mts,
    /// Progressive fans, which follow a view: [`Fans`](super::Fans).
    Fans,
    /// Fragments of any kind, which follow a view or a box: [`Patterns`](super::Patterns).
    Patterns,
    /// The progressive stream of a mesh, which the crate `striata-stream` codes.
    Progressive,
}

impl ModelKind {
    /// All of them, in the order of files.
    pub const ALL: [Self; 5] = [Self::LodStrips, Self::Mts, Self::Fans, Self::Patterns, Self::Progressive];

    /// The name.
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

/// The error of a name that no model has. Its message lists the names that there are.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("there is no model {name:?}; there are {}", ModelKind::ALL.map(ModelKind::as_str).join(", "))]
#[non_exhaustive]
pub struct UnknownModel {
    /// The name.
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
            "there is no model \"MTS\"; there are lodstrips, mts, fans, patterns, progressive"
        );
    }
}
