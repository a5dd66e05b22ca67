//! Lengths in mesh units or as shares of the diagonal.

use std::fmt;
use std::str::FromStr;

/// A length as the user writes it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Length {
    /// Mesh units.
    Absolute(f64),
    /// A share of the bounding box's diagonal, 0.01 for `1%`.
    OfDiagonal(f64),
}

impl Length {
    /// The length in mesh units.
    pub fn in_units(self, diagonal: f64) -> f64 {
        match self {
            Self::Absolute(length) => length,
            Self::OfDiagonal(share) => share * diagonal,
        }
    }
}

impl fmt::Display for Length {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Absolute(length) => write!(f, "{length}"),
            Self::OfDiagonal(share) => write!(f, "{}%", share * 100.0),
        }
    }
}

impl FromStr for Length {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let wrong =
            || format!("{text:?} is no length; write mesh units (0.02) or a share of the diagonal (1%)");
        let (number, length): (&str, fn(f64) -> Self) = match text.strip_suffix('%') {
            Some(percent) => (percent, |x| Self::OfDiagonal(x / 100.0)),
            None => (text, Self::Absolute),
        };
        let number: f64 = number.trim().parse().map_err(|_| wrong())?;
        if number.is_finite() && number >= 0.0 { Ok(length(number)) } else { Err(wrong()) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lengths_are_units_or_shares_of_the_diagonal() {
        assert_eq!("0.5".parse(), Ok(Length::Absolute(0.5)));
        assert_eq!("1%".parse(), Ok(Length::OfDiagonal(0.01)));
        assert_eq!("1 %".parse(), Ok(Length::OfDiagonal(0.01)));
        assert_eq!("2%".parse::<Length>().map(|l| l.in_units(50.0)), Ok(1.0));
        for wrong in ["", "%", "-1", "nan", "inf%", "1m"] {
            assert!(wrong.parse::<Length>().is_err(), "{wrong:?} was taken");
        }
    }
}
