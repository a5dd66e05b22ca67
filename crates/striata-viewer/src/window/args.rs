//! Arguments of `view`: the files, the window, and the initial settings.

use std::path::PathBuf;

use clap::{Args, ValueEnum};
use striata::model::ModelKind;

use striata_command::args::{Coloring, Count, DriverArgs, PoseArgs, Viewport, parse_detail};
use striata_command::failure::Failure;

/// Arguments of `view`.
#[derive(Debug, Args)]
#[command(after_help = "Examples:\n  \
    striata view robot.glb --time 0.5\n  \
    striata view scan.ply --pixels 1 --colors fans --screenshot scan.png")]
pub struct WindowArgs {
    /// Scenes, meshes, .striata files or streams to open; drop more on the window
    #[arg(value_name = "FILE")]
    pub files: Vec<PathBuf>,
    /// Set the window size in pixels
    #[arg(long, value_name = "WxH", default_value = "1280x800")]
    size: Viewport,
    /// Use the dark or light theme [default: the system's]
    #[arg(long, value_name = "THEME")]
    pub theme: Option<ThemeArg>,
    /// Save a screenshot once the model is shown, and exit
    #[arg(long, value_name = "OUT.png")]
    pub screenshot: Option<PathBuf>,
    /// Show one file in the web viewer instead, until the command is stopped
    #[cfg(feature = "serve")]
    #[arg(long, conflicts_with_all = ["size", "theme", "screenshot", "FirstArgs"])]
    pub browser: bool,
    /// Initial settings.
    #[command(flatten)]
    pub first: FirstArgs,
    /// Reporting of graphics drivers.
    #[command(flatten)]
    pub drivers: DriverArgs,
}

/// Initial settings, all of which can be changed in the window.
#[derive(Clone, Debug, Args)]
#[command(next_help_heading = "Initial settings")]
pub struct FirstArgs {
    /// Show one mesh in this model; it is built if the file does not contain it [default: scenes as they
    /// are, other meshes as lodstrips]
    #[arg(long, value_name = "NAME")]
    pub model: Option<ShownModel>,
    /// Set the detail from 0 (base mesh) to 1 (full mesh)
    #[arg(
        long, value_name = "F", allow_negative_numbers = true,
        value_parser = parse_detail, group = "first_level"
    )]
    pub detail: Option<f64>,
    /// Limit the triangle count, with uniform detail
    #[arg(long, value_name = "N|P%", allow_hyphen_values = true, group = "first_level")]
    pub triangles: Option<Count>,
    /// Refine for the view until the screen error is at most this many pixels
    #[arg(
        long, value_name = "P", allow_negative_numbers = true,
        value_parser = parse_pixels, group = "first_level"
    )]
    pub pixels: Option<f64>,
    /// Limit the triangle count, with detail optimized for the view
    #[arg(long, value_name = "N|P%", allow_hyphen_values = true, group = "first_level")]
    pub budget: Option<Count>,
    /// Pose of an animated scene.
    #[command(flatten)]
    pub pose: PoseArgs,
    /// Color triangles by surface (materials, vertex colors, or stone), strips, fans, triangles or groups
    #[arg(
        long,
        value_name = "NAME",
        default_value = "surface",
        value_parser = parse_coloring,
        alias = "colours"
    )]
    pub colors: Coloring,
    /// Draw the edges
    #[arg(long)]
    pub wireframe: bool,
    /// Use flat shading
    #[arg(long)]
    pub flat: bool,
    /// Treat the z axis as up instead of y
    #[arg(long)]
    pub z_up: bool,
}

/// Color theme of the window.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum ThemeArg {
    /// Light on dark
    Dark,
    /// Dark on light
    Light,
}

/// Models that the window can show.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum ShownModel {
    /// Strips edited in place
    #[value(name = ModelKind::LodStrips.as_str())]
    LodStrips,
    /// Strips, repaired after every step
    #[value(name = "live-strips")]
    LiveStrips,
    /// Strips, traversed again where they change
    #[value(name = ModelKind::Mts.as_str())]
    Mts,
    /// Fans, with view-dependent detail
    #[value(name = ModelKind::Fans.as_str())]
    Fans,
    /// Fans, extracted in a compute shader
    #[value(name = "fans-gpu")]
    FansGpu,
    /// Fragment patterns, with view-dependent detail
    #[value(name = ModelKind::Patterns.as_str())]
    Patterns,
    /// Triangle list
    List,
}

impl ShownModel {
    /// Whether the model can only be built from collapses, not from removals of any kind.
    pub(super) fn needs_collapses(self) -> bool {
        matches!(self, Self::LodStrips | Self::Mts)
    }
}

impl WindowArgs {
    /// Size of the window, pixels.
    ///
    /// # Errors
    /// If the size exceeds what can be drawn.
    pub fn size(&self) -> Result<[u32; 2], Failure> {
        self.size.check_drawable()?;
        Ok(self.size.0)
    }
}

fn parse_pixels(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(pixels) if (0.01..=10_000.0).contains(&pixels) => Ok(pixels),
        _ => Err("must be a number of pixels from 0.01 to 10000".to_owned()),
    }
}

/// Reads the name of a coloring; fragments are colored in pictures only.
///
/// # Errors
/// If the window does not have the coloring.
fn parse_coloring(name: &str) -> Result<Coloring, String> {
    match Coloring::from_str(name, true) {
        Ok(Coloring::Fragments) => Err("fragments are colored by `striata render` only".to_owned()),
        Ok(coloring) => Ok(coloring),
        Err(_) => Err("expected surface, strips, fans, triangles or groups".to_owned()),
    }
}
