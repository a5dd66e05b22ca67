//! The arguments of `render`: what is drawn, from where, and how it looks.

use std::path::PathBuf;
use std::str::FromStr;

use clap::builder::PossibleValue;
use clap::{Args, ValueEnum};
use striata::model::ModelKind;

#[cfg(feature = "gpu")]
use striata_command::args::DriverArgs;
use striata_command::args::{Coloring, Count, Length, LevelChoice, Point, ViewArgs, Viewport};

/// The heading of the camera's flags.
const CAMERA: &str = "Camera";

/// The heading of what a picture looks like.
const LOOK: &str = "Look";

/// Arguments of `render`.
#[derive(Debug, Args)]
#[command(
    override_usage = "striata render [OPTIONS] <INPUT> -o <OUT.png> [LEVEL]",
    after_help = "Examples:\n  \
    striata render bunny.ply -o levels.png --levels 100%,10%,1%\n  \
    striata render bunny.striata -o view.png --eye 0,0.1,0.3 --turn 70"
)]
pub(crate) struct RenderArgs {
    /// A mesh, a .striata file or a stream, or - for stdin; or a shape: shape:torus
    pub(crate) input: PathBuf,
    /// The picture to write, or - for stdout
    #[arg(short, long, value_name = "OUT.png")]
    pub(crate) output: PathBuf,
    /// Levels side by side, by their share of the triangles or their number: 100%,10%,500
    #[arg(long, value_name = "LEVELS", value_delimiter = ',', conflicts_with = "LevelArgs")]
    pub(crate) levels: Option<Vec<Count>>,
    /// Fail, and write nothing, if a level cannot be reached
    #[arg(long)]
    pub(crate) strict: bool,
    /// Which model hands over what is drawn: lodstrips or mts as strips, fans, or a list [default: the first of these that
    /// the file has, else a list]
    #[arg(long, value_name = "NAME", hide_possible_values = true)]
    pub(crate) model: Option<DrawnModel>,
    /// Colors of triangles: surface (those of the vertices, or stone), strips, fans, triangles, groups; of several, each
    /// gets a row
    #[arg(long, value_name = "NAMES", value_delimiter = ',', alias = "colours", default_value = "surface", hide_possible_values = true, help_heading = LOOK)]
    pub(crate) colors: Vec<Coloring>,
    /// Show the edges of triangles
    #[arg(long, help_heading = LOOK)]
    pub(crate) wireframe: bool,
    /// One normal a triangle
    #[arg(long, help_heading = LOOK)]
    pub(crate) flat: bool,
    /// Show the original, colored by how far it is from the level
    #[arg(long, conflicts_with_all = ["colors", "model"], help_heading = LOOK)]
    pub(crate) heat: bool,
    /// The distance that has the last color: mesh units, or `1%` of the diagonal [default: the largest on the picture]
    #[arg(long, value_name = "D", requires = "heat", help_heading = LOOK)]
    pub(crate) heat_max: Option<Length>,
    /// dark, light, none (see-through) or #rrggbb
    #[arg(long, value_name = "COLOR", default_value = "dark", help_heading = LOOK)]
    pub(crate) background: Background,
    /// Pixels of the picture
    #[arg(long, value_name = "WxH", default_value = "1280x960", help_heading = LOOK)]
    pub(crate) size: Viewport,
    /// Rows that levels stand in [default: as many as show them largest]
    #[arg(long, value_name = "N", allow_negative_numbers = true, value_parser = clap::value_parser!(u16).range(1..=64), help_heading = LOOK)]
    pub(crate) rows: Option<u16>,
    /// Where the picture is taken from; of a view, too, which is then seen from outside
    #[arg(long, value_name = "X,Y,Z", allow_hyphen_values = true, conflicts_with_all = ["turn", "rise"], help_heading = CAMERA)]
    pub(crate) from: Option<Point>,
    /// Turned around the mesh, degrees from its front to its right [default: -35]
    #[arg(long, value_name = "DEG", allow_hyphen_values = true, value_parser = parse_degrees, help_heading = CAMERA)]
    pub(crate) turn: Option<f32>,
    /// Degrees above the mesh [default: 8; 40 of what lies flat along z, which is up then]
    #[arg(long, value_name = "DEG", allow_hyphen_values = true, value_parser = parse_degrees, help_heading = CAMERA)]
    pub(crate) rise: Option<f32>,
    /// Times as large
    #[arg(long, value_name = "F", allow_hyphen_values = true, default_value_t = 1.0, value_parser = parse_zoom, help_heading = CAMERA)]
    pub(crate) zoom: f32,
    /// What a view needs beside its eye; of other pictures, the camera.
    #[command(flatten)]
    pub(crate) view: ViewArgs,
    /// Which level; after the view, whose help it completes.
    #[command(flatten)]
    pub(crate) level: LevelChoice,
    /// The graphics adapter whose name holds this [default: the quickest]
    #[cfg(feature = "gpu")]
    #[arg(long, value_name = "NAME", conflicts_with = "software", help_heading = "Adapter")]
    pub(crate) adapter: Option<String>,
    /// Draw without a graphics adapter
    #[arg(long, help_heading = "Adapter")]
    pub(crate) software: bool,
    /// How graphics drivers report.
    #[cfg(feature = "gpu")]
    #[command(flatten)]
    pub(crate) drivers: DriverArgs,
}

/// What hands over the triangles that are drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum DrawnModel {
    /// A model of the file, or one that is built.
    Model(ModelKind),
    /// The mesh itself.
    List,
}

impl DrawnModel {
    /// As the flag spells it.
    pub(crate) const fn as_str(self) -> &'static str {
        match self {
            Self::Model(kind) => kind.as_str(),
            Self::List => "list",
        }
    }
}

impl ValueEnum for DrawnModel {
    fn value_variants<'a>() -> &'a [Self] {
        const {
            &[
                Self::Model(ModelKind::LodStrips),
                Self::Model(ModelKind::Mts),
                Self::Model(ModelKind::Fans),
                Self::List,
            ]
        }
    }

    fn to_possible_value(&self) -> Option<PossibleValue> {
        let help = match self {
            Self::Model(ModelKind::LodStrips) => "Strips, edited in place",
            Self::Model(ModelKind::Mts) => "Strips, walked anew",
            Self::Model(ModelKind::Fans) => "Fans, as a list of triangles",
            Self::Model(_) => return None,
            Self::List => "The mesh itself",
        };
        Some(PossibleValue::new(self.as_str()).help(help))
    }
}

/// What is behind the mesh.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Background {
    /// Nearly black.
    Dark,
    /// Nearly white.
    Light,
    /// Nothing.
    None,
    /// A color in sRGB.
    Color([u8; 3]),
}

impl FromStr for Background {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let is_hexadecimal =
            |digits: &&str| digits.len() == 6 && digits.bytes().all(|b| b.is_ascii_hexdigit());
        let hexadecimal = text.strip_prefix('#').filter(is_hexadecimal);
        match (text, hexadecimal.map(|digits| u32::from_str_radix(digits, 16))) {
            ("dark", _) => Ok(Self::Dark),
            ("light", _) => Ok(Self::Light),
            ("none", _) => Ok(Self::None),
            (_, Some(Ok(color))) => {
                let [_, r, g, b] = color.to_be_bytes();
                Ok(Self::Color([r, g, b]))
            }
            _ => Err(format!("{text:?} is no background; say dark, light, none or a color: #203040")),
        }
    }
}

fn parse_degrees(text: &str) -> Result<f32, String> {
    match text.parse::<f32>() {
        Ok(angle) if angle.abs() <= 360.0 => Ok(angle),
        _ => Err("must be an angle from -360 to 360".to_owned()),
    }
}

fn parse_zoom(text: &str) -> Result<f32, String> {
    match text.parse::<f32>() {
        Ok(zoom) if (0.01..=10_000.0).contains(&zoom) => Ok(zoom),
        _ => Err("must lie between 0.01 and 10000".to_owned()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn backgrounds_are_names_or_colors() {
        assert_eq!("none".parse(), Ok(Background::None));
        assert_eq!("#0a1bFF".parse(), Ok(Background::Color([10, 27, 255])));
        for wrong in ["", "black", "#", "#12345", "#1234567", "#12345g", "#+12345", "123456"] {
            assert!(wrong.parse::<Background>().is_err(), "{wrong:?} was taken");
        }
    }

    #[test]
    fn angles_and_zooms_have_limits() {
        assert!(
            parse_degrees("-400").is_err() && parse_degrees("nan").is_err() && parse_degrees("90").is_ok()
        );
        assert!(parse_zoom("0").is_err() && parse_zoom("-1").is_err() && parse_zoom("2.5").is_ok());
    }
}
