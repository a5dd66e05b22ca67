//! Flags that choose one or several levels: by triangle or vertex count, error, detail or view.

use std::fmt;
use std::str::FromStr;

use clap::{ArgMatches, Args, Command, FromArgMatches};

use super::{Length, Point};

/// Help heading of the flags that choose a level.
pub const LEVEL: &str = "Level (choose one)";

/// The level to produce; the user must give exactly one of these flags.
#[derive(Clone, Copy, Debug, Args)]
#[group(required = true, multiple = true)]
#[command(next_help_heading = LEVEL)]
pub struct LevelArgs {
    /// At most N triangles, or P% of the full mesh
    #[arg(
        long,
        value_name = "N|P%",
        allow_hyphen_values = true,
        conflicts_with_all = ["ratio", "vertices", "detail", "error", "split_count"],
    )]
    pub triangles: Option<Count>,
    /// Like --triangles, as a fraction: 0.1 is 10%
    #[arg(
        long,
        value_name = "0..1",
        allow_negative_numbers = true,
        value_parser = parse_ratio,
        conflicts_with_all = ["vertices", "detail", "error", "split_count"],
    )]
    pub ratio: Option<f64>,
    /// At most N vertices, or P% of the full mesh
    #[arg(
        long,
        value_name = "N|P%",
        allow_hyphen_values = true,
        conflicts_with_all = ["detail", "error", "split_count"],
    )]
    pub vertices: Option<Count>,
    /// Fraction of the vertex splits: 0 is the base mesh, 1 the full mesh
    #[arg(
        long,
        value_name = "0..1",
        allow_negative_numbers = true,
        value_parser = parse_detail,
        conflicts_with_all = ["error", "split_count"],
    )]
    pub detail: Option<f64>,
    /// Largest error allowed, in mesh units or as a percentage of the diagonal: 1%
    #[arg(long, value_name = "DISTANCE", allow_negative_numbers = true, conflicts_with = "split_count")]
    pub error: Option<Length>,
    /// Exactly N vertex splits above the base mesh
    #[arg(long, value_name = "N", allow_negative_numbers = true)]
    pub split_count: Option<usize>,
}

/// An optional level or view; without one, the verb uses the full mesh.
///
/// Parses the flags of [`LevelArgs`] and [`EyeArgs`], listed under another heading in the help.
#[derive(Clone, Copy, Debug)]
pub struct LevelChoice {
    /// The level, if one is given.
    pub level: LevelArgs,
    /// The position of the eye, if a view is given.
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
            argument.help("Screen size that --pixels refers to, in pixels [default: --size]")
        });
        command.mut_arg("eye", |argument| {
            argument.help("Level for a viewer at this point; --from, --turn or --rise show it from elsewhere")
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

/// An optional level; without one, the verb uses everything in the input.
///
/// Parses the flags of [`LevelArgs`], listed under another heading in the help.
#[derive(Clone, Copy, Debug)]
pub struct OptionalLevel {
    /// The level, if one is given.
    pub level: LevelArgs,
}

impl Args for OptionalLevel {
    fn augment_args(command: Command) -> Command {
        let command = LevelArgs::augment_args(command).mut_group("LevelArgs", |group| group.required(false));
        under_heading(command, &LEVEL_FLAGS, "Level [default: everything in the input]")
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

/// The ids of the flags of [`LevelArgs`].
const LEVEL_FLAGS: [&str; 6] = ["triangles", "ratio", "vertices", "detail", "error", "split_count"];

fn under_heading(command: Command, names: &[&'static str], heading: &'static str) -> Command {
    names
        .iter()
        .fold(command, |command, name| command.mut_arg(name, |argument| argument.help_heading(heading)))
}

/// The eye of a view, which is another way to choose a level.
#[derive(Clone, Copy, Debug, Args)]
#[group(skip)]
#[command(next_help_heading = LEVEL)]
pub struct EyeArgs {
    /// Level for a viewer at this point, with errors up to --pixels; with --triangles or --ratio, the best
    /// level within that count
    #[arg(
        long,
        value_name = "X,Y,Z",
        allow_hyphen_values = true,
        group = "LevelArgs",
        conflicts_with_all = ["vertices", "detail", "error", "split_count"],
    )]
    pub eye: Option<Point>,
}

/// A list of levels that are written in one run.
#[derive(Clone, Debug, Args)]
#[group(skip)]
#[command(next_help_heading = LEVEL)]
pub struct LevelsArgs {
    /// Several levels, each as in --triangles: 50%,25%,500; {} in the output name becomes the level, and {i}
    /// its number from 0: -o bunny-{}.glb
    #[arg(
        long,
        value_name = "N|P%,...",
        value_delimiter = ',',
        allow_hyphen_values = true,
        group = "LevelArgs",
        conflicts_with_all = ["triangles", "ratio", "vertices", "detail", "error", "split_count"],
    )]
    pub levels: Option<Vec<Level>>,
    /// With --levels: write the full mesh and these levels to one glTF file, between which engines switch
    /// (MSFT_lod); no {} in the output name
    #[arg(long, requires = "levels")]
    pub lod_chain: bool,
}

/// A triangle or vertex count, given as a number or as a percentage of the full mesh.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Count {
    /// An absolute count.
    Number(usize),
    /// A fraction of the full mesh, 0 to 1.
    Share(f64),
}

impl Count {
    /// Returns the triangle count for a full mesh of `full` triangles.
    ///
    /// A share gives at least 2 triangles, the fewest that a closed surface can have.
    pub fn of_triangles(self, full: usize) -> usize {
        self.of(full, 2)
    }

    /// Returns the vertex count for a full mesh of `full` vertices.
    ///
    /// A share gives at least 6 vertices, as many as two separate triangles have.
    pub fn of_vertices(self, full: usize) -> usize {
        self.of(full, 6)
    }

    /// Rounds shares down, but to no less than `least` (unless the share is 0), so that small shares of tiny
    /// meshes can be reached.
    fn of(self, full: usize, least: usize) -> usize {
        match self {
            Self::Number(count) => count,
            Self::Share(0.0) => 0,
            // The factor keeps a product that should be a whole number from being rounded down to the one
            // below.
            Self::Share(share) => ((share * full as f64 * (1.0 + 1e-12)) as usize).max(least).min(full),
        }
    }

    /// Whether the count depends on the mesh.
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
            format!("{text:?} is not a count; write a number or a percentage of the full mesh: 500, {share}")
        };
        match text.strip_suffix('%') {
            None => Ok(Self::Number(text.trim().parse().map_err(|_| wrong())?)),
            Some(percent) => match percent.trim().parse::<f64>() {
                Ok(percent) if (0.0..=100.0).contains(&percent) => Ok(Self::Share(percent / 100.0)),
                Ok(percent) if percent > 100.0 => Err(format!("{text} is too large; the full mesh is 100%")),
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

/// A level given by its triangle count, with the text that the user wrote.
#[derive(Clone, Debug, PartialEq)]
pub struct Level {
    /// The text that the user wrote.
    pub text: String,
    /// The largest triangle count allowed.
    pub triangles: Count,
}

impl FromStr for Level {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let text = text.trim();
        let triangles = text.parse().map_err(|_| {
            format!(
                "{text:?} is not a level; write a triangle count or a percentage of the triangles: 500, 10%"
            )
        })?;
        Ok(Self { text: text.to_owned(), triangles })
    }
}

impl LevelArgs {
    /// Returns the requested triangle count, from `--triangles` or `--ratio`.
    pub fn triangle_count(&self) -> Option<Count> {
        self.triangles.or(self.ratio.map(Count::Share))
    }

    /// Returns the value of the given flag as text, which replaces `{}` in file names.
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

    /// Whether the user gave any of these flags.
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
        Ok(percent) if (1.0..=100.0).contains(&percent) && !text.contains('%') => Err(format!(
            "must lie between 0 (no triangles) and 1 (all of them); {percent} percent is {percent}%"
        )),
        _ => Err("must lie between 0 (no triangles) and 1 (all of them)".to_owned()),
    }
}

/// Parses a detail, a number from 0 to 1.
///
/// # Errors
/// If the text is not such a number.
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
    fn counts_are_numbers_or_percentages() {
        assert_eq!("10%".parse(), Ok(Count::Share(0.1)));
        assert_eq!("0.5 %".parse(), Ok(Count::Share(0.005)));
        assert_eq!("500".parse(), Ok(Count::Number(500)));
        for wrong in ["", "%", "101%", "-1%", "nan%", "1.5", "-3", "ten"] {
            assert!(wrong.parse::<Count>().is_err(), "{wrong:?} was accepted");
            assert!(wrong.parse::<Level>().is_err(), "{wrong:?} was accepted");
        }
    }

    #[test]
    fn ratios_are_fractions_or_percentages() {
        assert_eq!((parse_ratio("0.1"), parse_ratio("10%")), (Ok(0.1), Ok(0.1)));
        for wrong in ["", "%", "1.1", "101%", "-0.1", "nan"] {
            assert!(parse_ratio(wrong).is_err(), "{wrong:?} was accepted");
        }
        let message = "0.25".parse::<Count>().expect_err("no count");
        assert!(message.ends_with("500, 25%"), "{message}");
    }

    #[test]
    fn shares_round_down_but_not_because_of_float_errors() {
        for (share, full, expected) in
            [(0.1, 99_938, 9993), (0.29, 100, 29), (0.07, 100, 7), (1.0, 7, 7), (0.0, 7, 0), (0.999, 3, 2)]
        {
            assert_eq!(Count::Share(share).of_triangles(full), expected, "{share} of {full}");
        }
        assert_eq!(Count::Number(50).of_triangles(7), 50);
    }

    #[test]
    fn shares_of_tiny_meshes_can_be_reached() {
        let share = Count::Share(0.01);
        assert_eq!([0, 1, 2, 50, 300].map(|full| share.of_triangles(full)), [0, 1, 2, 2, 3]);
        assert_eq!([0, 1, 4, 50, 700].map(|full| share.of_vertices(full)), [0, 1, 4, 6, 7]);
        assert_eq!(Count::Number(1).of_triangles(50), 1, "an absolute count has no minimum");
    }

    #[test]
    fn counts_display_as_they_were_written() {
        for text in ["500", "10%", "0.07%", "12.5%", "100%", "0%"] {
            assert_eq!(text.parse::<Count>().map(|count| count.to_string()).as_deref(), Ok(text));
        }
    }
}
