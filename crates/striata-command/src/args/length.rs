//! Lengths given in mesh units or as a percentage of the bounding box diagonal.

use std::fmt;
use std::str::FromStr;

/// A length as written on the command line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Length {
    /// A length in mesh units.
    Absolute(f64),
    /// A fraction of the bounding box diagonal: `1%` is 0.01.
    OfDiagonal(f64),
}

impl Length {
    /// Returns the length in mesh units, given the diagonal in mesh units.
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
        let wrong = || {
            format!("{text:?} is not a length; write mesh units (0.02) or a percentage of the diagonal (1%)")
        };
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
    fn lengths_are_mesh_units_or_percentages_of_the_diagonal() {
        assert_eq!("0.5".parse(), Ok(Length::Absolute(0.5)));
        assert_eq!("1%".parse(), Ok(Length::OfDiagonal(0.01)));
        assert_eq!("1 %".parse(), Ok(Length::OfDiagonal(0.01)));
        assert_eq!("2%".parse::<Length>().map(|l| l.in_units(50.0)), Ok(1.0));
        for wrong in ["", "%", "-1", "nan", "inf%", "1m"] {
            assert!(wrong.parse::<Length>().is_err(), "{wrong:?} was accepted");
        }
    }
}
