//! Arguments of `render`: what is drawn, from where, and how it looks.

use std::path::PathBuf;
use std::str::FromStr;

use clap::builder::PossibleValue;
use clap::{Args, ValueEnum};
use striata::model::ModelKind;

#[cfg(feature = "gpu")]
use striata_command::args::DriverArgs;
use striata_command::args::{
    Coloring, Count, Length, LevelChoice, Point, PoseArgs, RasterArgs, ViewArgs, Viewport,
};

/// Help heading of the camera flags.
const CAMERA: &str = "Camera";

/// Help heading of the flags for how the picture looks.
const APPEARANCE: &str = "Appearance";

/// Help heading of the flags for animated scenes.
const POSE: &str = "Pose (of an animated scene)";

/// Arguments of `render`.
#[derive(Debug, Args)]
#[command(
    override_usage = "striata render [OPTIONS] <INPUT> -o <OUT.png> [LEVEL]",
    after_help = "Examples:\n  \
    striata render shape:torus -o levels.png --levels 100%,10%,1%\n  \
    striata render robot.glb -o robot.png --time 0.5 --triangles 10%"
)]
pub(crate) struct RenderArgs {
    /// Scene, mesh, .striata file or stream to read, - for stdin, or a built-in shape: shape:torus
    pub input: PathBuf,
    /// PNG file to write, or - for stdout
    #[arg(short, long, value_name = "OUT.png")]
    pub output: PathBuf,
    /// Several levels in one picture, each as in --triangles: 100%,10%,500
    #[arg(long, value_name = "N|P%,...", value_delimiter = ',', conflicts_with = "LevelArgs")]
    pub levels: Option<Vec<Count>>,
    /// Fail and write nothing if a level cannot be reached
    #[arg(long)]
    pub strict: bool,
    /// Model that provides the triangles: lodstrips, mts, fans, patterns or list (the mesh itself) [default: the
    /// first of these in the file, else list]
    #[arg(long, value_name = "NAME", hide_possible_values = true)]
    pub model: Option<DrawnModel>,
    /// Color by surface (materials, vertex colors, or plain stone), strips, fans, triangles, groups or fragments
    /// (triangles that one step inserted); several get a row each
    #[arg(
        long,
        value_name = "NAME,...",
        value_delimiter = ',',
        alias = "colours",
        default_value = "surface",
        hide_possible_values = true,
        help_heading = APPEARANCE,
    )]
    pub colors: Vec<Coloring>,
    /// Draw the edges of triangles
    #[arg(long, help_heading = APPEARANCE)]
    pub wireframe: bool,
    /// Shade each triangle with its own normal
    #[arg(long, help_heading = APPEARANCE)]
    pub flat: bool,
    /// Draw the original, colored by its distance from the level
    #[arg(long, conflicts_with_all = ["colors", "model"], help_heading = APPEARANCE)]
    pub heat: bool,
    /// Distance at the end of the color scale (mesh units, or % of the diagonal) [default: the largest in the
    /// picture]
    #[arg(long, value_name = "DISTANCE", requires = "heat", help_heading = APPEARANCE)]
    pub heat_max: Option<Length>,
    /// Background color: dark, light, none (transparent) or #rrggbb
    #[arg(long, value_name = "COLOR", default_value = "dark", help_heading = APPEARANCE)]
    pub background: PictureBackground,
    /// Size of the picture in pixels
    #[arg(long, value_name = "WxH", default_value = "1280x960", help_heading = APPEARANCE)]
    pub size: Viewport,
    /// Number of rows of levels [default: whatever shows them largest]
    #[arg(
        long,
        value_name = "N",
        allow_negative_numbers = true,
        value_parser = clap::value_parser!(u16).range(1..=64),
        help_heading = APPEARANCE,
    )]
    pub rows: Option<u16>,
    /// Pose of an animated scene.
    #[command(flatten, next_help_heading = POSE)]
    pub pose: PoseArgs,
    /// Camera of the scene: its number, beginning with 0, or its name
    #[arg(
        long,
        value_name = "N|NAME",
        conflicts_with_all = ["from", "turn", "rise", "eye", "look_at", "up", "fov"],
        help_heading = CAMERA,
    )]
    pub camera: Option<String>,
    /// Position of the camera; with --eye, shows the level of that view from here
    #[arg(
        long,
        value_name = "X,Y,Z",
        allow_hyphen_values = true,
        conflicts_with_all = ["turn", "rise"],
        help_heading = CAMERA,
    )]
    pub from: Option<Point>,
    /// Azimuth of the camera, from the front of the mesh to its right [default: -35]
    #[arg(
        long,
        value_name = "DEG",
        allow_hyphen_values = true,
        value_parser = parse_degrees,
        help_heading = CAMERA,
    )]
    pub turn: Option<f32>,
    /// Elevation of the camera [default: 8; 40 for a mesh that is flat along z, with z up]
    #[arg(
        long,
        value_name = "DEG",
        allow_hyphen_values = true,
        value_parser = parse_degrees,
        help_heading = CAMERA,
    )]
    pub rise: Option<f32>,
    /// Magnification
    #[arg(
        long,
        value_name = "FACTOR",
        allow_hyphen_values = true,
        default_value_t = 1.0,
        value_parser = parse_zoom,
        help_heading = CAMERA,
    )]
    pub zoom: f32,
    /// The rest of the view; without `--eye`, parameters of the camera.
    #[command(flatten)]
    pub view: ViewArgs,
    /// The level to draw. Must come after `view`, because it changes the help of `--viewport`.
    #[command(flatten)]
    pub level: LevelChoice,
    /// Use the graphics adapter whose name contains this [default: the fastest GPU]
    #[cfg(feature = "gpu")]
    #[arg(long, value_name = "NAME", conflicts_with = "software", help_heading = "Adapter")]
    pub adapter: Option<String>,
    /// Render on the CPU, as machines without a GPU do
    #[arg(long, help_heading = "Adapter")]
    pub software: bool,
    /// Options for the messages of graphics drivers.
    #[cfg(feature = "gpu")]
    #[command(flatten)]
    pub drivers: DriverArgs,
    /// How a raster is read.
    #[command(flatten)]
    pub raster: RasterArgs,
}

impl RenderArgs {
    /// Whether the picture shows the surface of the mesh.
    pub(crate) fn shows_surface(&self) -> bool {
        self.colors.contains(&Coloring::Surface) && !self.heat && !self.wireframe
    }

    /// Whether the picture needs levels, and not just the mesh.
    pub(crate) fn needs_levels(&self) -> bool {
        let has_target = self.level.level.is_given() || self.level.eye.is_some();
        let has_model = self.model.is_some_and(|model| model != DrawnModel::List);
        has_target || has_model || self.levels.is_some() || self.colors.contains(&Coloring::Fragments)
    }
}

/// The source of the triangles that are drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum DrawnModel {
    /// A model, from the file or built for the picture.
    Model(ModelKind),
    /// The mesh itself, as a triangle list.
    List,
}

impl DrawnModel {
    /// Returns the name as it is spelled on the command line.
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
                Self::Model(ModelKind::Patterns),
                Self::List,
            ]
        }
    }

    fn to_possible_value(&self) -> Option<PossibleValue> {
        let help = match self {
            Self::Model(ModelKind::LodStrips) => "Strips that are edited in place",
            Self::Model(ModelKind::Mts) => "Strips that are traversed again for each level",
            Self::Model(ModelKind::Fans) => "Fans, drawn as a triangle list",
            Self::Model(ModelKind::Patterns) => "Fragments that any step may leave, drawn as a triangle list",
            Self::Model(_) => return None,
            Self::List => "The mesh itself",
        };
        Some(PossibleValue::new(self.as_str()).help(help))
    }
}

/// The background of a picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum PictureBackground {
    /// Nearly black.
    Dark,
    /// Nearly white.
    Light,
    /// Transparent.
    None,
    /// A color in sRGB.
    Color([u8; 3]),
}

impl FromStr for PictureBackground {
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
            _ => Err(format!("{text:?} is not a background; use dark, light, none or a color: #203040")),
        }
    }
}

fn parse_degrees(text: &str) -> Result<f32, String> {
    match text.parse::<f32>() {
        Ok(angle) if angle.abs() <= 360.0 => Ok(angle),
        _ => Err("must be an angle from -360 to 360 degrees".to_owned()),
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
        assert_eq!("none".parse(), Ok(PictureBackground::None));
        assert_eq!("#0a1bFF".parse(), Ok(PictureBackground::Color([10, 27, 255])));
        for wrong in ["", "black", "#", "#12345", "#1234567", "#12345g", "#+12345", "123456"] {
            assert!(wrong.parse::<PictureBackground>().is_err(), "{wrong:?} was accepted");
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
