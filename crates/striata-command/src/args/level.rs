//! Levels as the user asks for them: a number, a share of the full mesh, an error, or several levels at once.

use std::fmt;
use std::str::FromStr;

use clap::{ArgMatches, Args, Command, FromArgMatches};

use super::{Length, Point};

/// The heading of targets.
pub const LEVEL: &str = "Level (exactly one)";

/// The target of a level; exactly one must be given.
#[derive(Clone, Copy, Debug, Args)]
#[group(required = true, multiple = true)]
#[command(next_help_heading = LEVEL)]
pub struct LevelArgs {
    /// At most this many triangles, or this share of the full mesh's (at least 2)
    #[arg(long, value_name = "N|P%", allow_hyphen_values = true, conflicts_with_all = ["ratio", "vertices", "detail", "error", "split_count"])]
    pub triangles: Option<Count>,
    /// At most this share of the full mesh's triangles: 0.1 is --triangles 10%
    #[arg(long, value_name = "F", allow_negative_numbers = true, value_parser = parse_ratio, conflicts_with_all = ["vertices", "detail", "error", "split_count"])]
    pub ratio: Option<f64>,
    /// At most this many vertices, or this share of the full mesh's
    #[arg(long, value_name = "N|P%", allow_hyphen_values = true, conflicts_with_all = ["detail", "error", "split_count"])]
    pub vertices: Option<Count>,
    /// Share of the vertex splits from the base mesh (0) to the full mesh (1); unlike --ratio, 0 is the base mesh
    #[arg(long, value_name = "F", allow_negative_numbers = true, value_parser = parse_detail, conflicts_with_all = ["error", "split_count"])]
    pub detail: Option<f64>,
    /// At most this error, estimated unless it is guaranteed: mesh units, or `1%` of the diagonal
    #[arg(long, value_name = "E|P%", allow_negative_numbers = true, conflicts_with = "split_count")]
    pub error: Option<Length>,
    /// Exactly this many vertex splits above the base mesh
    #[arg(long, value_name = "N", allow_negative_numbers = true)]
    pub split_count: Option<usize>,
}

/// One level or a view, or none: then it is the full mesh. To `clap` the flags of [`LevelArgs`] under another heading.
#[derive(Clone, Copy, Debug)]
pub struct LevelChoice {
    /// The level, where one is given.
    pub level: LevelArgs,
    /// The eye of a view.
    pub eye: Option<Point>,
}

impl Args for LevelChoice {
    fn augment_args(command: Command) -> Command {
        let command = LevelArgs::augment_args(command).mut_group("LevelArgs", |group| group.required(false));
        let command = EyeArgs::augment_args(command);
        let heading = "Level [default: the full mesh]";
        let command = under_heading(command, &LEVEL_FLAGS, heading);
        let command = under_heading(command, &["eye"], heading);
        let command = command.mut_arg("viewport", |argument| {
            argument.help("Pixels of the screen [default: those of the picture]")
        });
        command.mut_arg("eye", |argument| {
            argument.help("As fine as the screen asks for, seen from here; with --from, --turn or --rise shown from outside")
        })
    }

    fn augment_args_for_update(command: Command) -> Command {
        Self::augment_args(command)
    }
}

impl FromArgMatches for LevelChoice {
    fn from_arg_matches(matches: &ArgMatches) -> Result<Self, clap::Error> {
        let level = LevelArgs::from_arg_matches(matches)?;
        Ok(Self { level, eye: EyeArgs::from_arg_matches(matches)?.eye })
    }

    fn update_from_arg_matches(&mut self, matches: &ArgMatches) -> Result<(), clap::Error> {
        *self = Self::from_arg_matches(matches)?;
        Ok(())
    }
}

/// A level, or none: then it is all that is there. To `clap` the flags of [`LevelArgs`] under another heading.
#[derive(Clone, Copy, Debug)]
pub struct OptionalLevel {
    /// The level, if one is given.
    pub level: LevelArgs,
}

impl Args for OptionalLevel {
    fn augment_args(command: Command) -> Command {
        let command = LevelArgs::augment_args(command).mut_group("LevelArgs", |group| group.required(false));
        under_heading(command, &LEVEL_FLAGS, "Level [default: all that is there]")
    }

    fn augment_args_for_update(command: Command) -> Command {
        Self::augment_args(command)
    }
}

impl FromArgMatches for OptionalLevel {
    fn from_arg_matches(matches: &ArgMatches) -> Result<Self, clap::Error> {
        Ok(Self { level: LevelArgs::from_arg_matches(matches)? })
    }

    fn update_from_arg_matches(&mut self, matches: &ArgMatches) -> Result<(), clap::Error> {
        *self = Self::from_arg_matches(matches)?;
        Ok(())
    }
}

/// The names of the flags of [`LevelArgs`].
const LEVEL_FLAGS: [&str; 6] = ["triangles", "ratio", "vertices", "detail", "error", "split_count"];

fn under_heading(command: Command, names: &[&'static str], heading: &'static str) -> Command {
    names
        .iter()
        .fold(command, |command, name| command.mut_arg(name, |argument| argument.help_heading(heading)))
}

/// The eye of a view, which is a level too.
#[derive(Clone, Copy, Debug, Args)]
#[group(skip)]
#[command(next_help_heading = LEVEL)]
pub struct EyeArgs {
    /// As fine as the screen asks for, seen from here; with --triangles or --ratio the level of at most that many triangles
    /// that looks best from there
    #[arg(long, value_name = "X,Y,Z", allow_hyphen_values = true, group = "LevelArgs", conflicts_with_all = ["vertices", "detail", "error", "split_count"])]
    pub eye: Option<Point>,
}

/// Several levels at once.
#[derive(Clone, Debug, Args)]
#[group(skip)]
#[command(next_help_heading = LEVEL)]
pub struct LevelsArgs {
    /// Several levels at once, as --triangles takes them: 50%,25%,500. Each goes to a file of its own: {} in the name of the output
    /// stands for the level, `-o bunny-{}.glb`
    #[arg(long, value_name = "LEVELS", value_delimiter = ',', allow_hyphen_values = true, group = "LevelArgs", conflicts_with_all = ["triangles", "ratio", "vertices", "detail", "error", "split_count"])]
    pub levels: Option<Vec<Level>>,
}

/// A number of triangles or vertices, as it is or as a share of the full mesh's.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Count {
    /// This many.
    Number(usize),
    /// This share of all, 0 to 1.
    Share(f64),
}

impl Count {
    /// The number of triangles that it means for a full mesh of `full`; a share is at least what any closed surface has.
    pub fn of_triangles(self, full: usize) -> usize {
        self.of(full, 2)
    }

    /// The number of vertices that it means for a full mesh of `full`; a share is at least what two triangles can have.
    pub fn of_vertices(self, full: usize) -> usize {
        self.of(full, 6)
    }

    /// No share but 0 asks for less than `least`, so that shares of tiny meshes are in reach.
    fn of(self, full: usize, least: usize) -> usize {
        match self {
            Self::Number(count) => count,
            Self::Share(0.0) => 0,
            // The small term keeps a share that is a whole number from rounding down to the one before.
            Self::Share(share) => ((share * full as f64 * (1.0 + 1e-12)) as usize).max(least).min(full),
        }
    }

    /// Whether the number depends on the mesh.
    pub fn is_share(self) -> bool {
        matches!(self, Self::Share(_))
    }
}

impl FromStr for Count {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let wrong = || {
            let share = text.parse::<f64>().ok().filter(|share| *share > 0.0 && *share < 1.0);
            let share = share.map_or_else(|| "10%".to_owned(), |share| Self::Share(share).to_string());
            format!("{text:?} is no count; write a number or a share of the full mesh: 500, {share}")
        };
        match text.strip_suffix('%') {
            None => Ok(Self::Number(text.trim().parse().map_err(|_| wrong())?)),
            Some(percent) => match percent.trim().parse::<f64>() {
                Ok(percent) if (0.0..=100.0).contains(&percent) => Ok(Self::Share(percent / 100.0)),
                _ => Err(wrong()),
            },
        }
    }
}

impl fmt::Display for Count {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Number(count) => write!(f, "{count}"),
            Self::Share(share) => write!(f, "{}%", (1e6 * 100.0 * share).round() / 1e6),
        }
    }
}

/// A level by its number of triangles, and how the user spelled it.
#[derive(Clone, Debug, PartialEq)]
pub struct Level {
    /// As the user wrote it.
    pub text: String,
    /// Its triangles.
    pub triangles: Count,
}

impl FromStr for Level {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let text = text.trim();
        let triangles = text.parse().map_err(|_| {
            format!("{text:?} is no level; write a share of the triangles or their number: 10%, 500")
        })?;
        Ok(Self { text: text.to_owned(), triangles })
    }
}

impl LevelArgs {
    /// The triangles asked for, by either flag.
    pub fn triangle_count(&self) -> Option<Count> {
        self.triangles.or(self.ratio.map(Count::Share))
    }

    /// The value of the flag that is given, as `{}` in a file name shows it.
    pub fn text(&self) -> Option<String> {
        let Self { triangles, ratio, vertices, detail, error, split_count } = self;
        let texts = [
            triangles.map(|count| count.to_string()),
            ratio.map(|ratio| ratio.to_string()),
            vertices.map(|count| count.to_string()),
            detail.map(|detail| detail.to_string()),
            error.map(|error| error.to_string()),
            split_count.map(|count| count.to_string()),
        ];
        texts.into_iter().flatten().next()
    }

    /// Whether any level is given.
    pub fn is_given(&self) -> bool {
        self.text().is_some()
    }
}

fn parse_ratio(text: &str) -> Result<f64, String> {
    let ratio = match text.strip_suffix('%') {
        Some(percent) => percent.trim().parse::<f64>().map(|percent| percent / 100.0),
        None => text.parse::<f64>(),
    };
    match ratio {
        Ok(ratio) if (0.0..=1.0).contains(&ratio) => Ok(ratio),
        _ => Err("must lie between 0 (no triangles) and 1 (all of them)".to_owned()),
    }
}

/// Parses a detail from 0 to 1.
///
/// # Errors
/// If the text is none.
pub fn parse_detail(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(detail) if (0.0..=1.0).contains(&detail) => Ok(detail),
        _ => Err("must lie between 0 (base mesh) and 1 (full mesh)".to_owned()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn counts_are_numbers_or_shares() {
        assert_eq!("10%".parse(), Ok(Count::Share(0.1)));
        assert_eq!("0.5 %".parse(), Ok(Count::Share(0.005)));
        assert_eq!("500".parse(), Ok(Count::Number(500)));
        for wrong in ["", "%", "101%", "-1%", "nan%", "1.5", "-3", "ten"] {
            assert!(wrong.parse::<Count>().is_err(), "{wrong:?} was taken");
            assert!(wrong.parse::<Level>().is_err(), "{wrong:?} was taken");
        }
    }

    #[test]
    fn ratios_are_shares_too() {
        assert_eq!((parse_ratio("0.1"), parse_ratio("10%")), (Ok(0.1), Ok(0.1)));
        for wrong in ["", "%", "1.1", "101%", "-0.1", "nan"] {
            assert!(parse_ratio(wrong).is_err(), "{wrong:?} was taken");
        }
        let said = "0.25".parse::<Count>().expect_err("no count");
        assert!(said.ends_with("500, 25%"), "{said}");
    }

    #[test]
    fn shares_are_rounded_down_but_for_what_floats_lose() {
        for (share, full, expected) in
            [(0.1, 99_938, 9993), (0.29, 100, 29), (0.07, 100, 7), (1.0, 7, 7), (0.0, 7, 0), (0.999, 3, 2)]
        {
            assert_eq!(Count::Share(share).of_triangles(full), expected, "{share} of {full}");
        }
        assert_eq!(Count::Number(50).of_triangles(7), 50);
    }

    #[test]
    fn shares_of_tiny_meshes_are_in_reach() {
        let share = Count::Share(0.01);
        assert_eq!([0, 1, 2, 50, 300].map(|full| share.of_triangles(full)), [0, 1, 2, 2, 3]);
        assert_eq!([0, 1, 4, 50, 700].map(|full| share.of_vertices(full)), [0, 1, 4, 6, 7]);
        assert_eq!(Count::Number(1).of_triangles(50), 1, "a number means what it says");
    }

    #[test]
    fn counts_are_written_as_they_are_read() {
        for text in ["500", "10%", "0.07%", "12.5%", "100%", "0%"] {
            assert_eq!(text.parse::<Count>().map(|count| count.to_string()).as_deref(), Ok(text));
        }
    }
}
