//! The arguments of `view`: the files, the window, and what is shown first.

use std::path::PathBuf;

use clap::{Args, ValueEnum};
use striata::model::ModelKind;

use striata_command::args::{Coloring, Count, DriverArgs, Viewport, parse_detail};
use striata_command::failure::Failure;

/// Arguments of `view`.
#[derive(Debug, Args)]
#[command(after_help = "Examples:\n  \
    striata view bunny.striata\n  \
    striata view scan.ply --pixels 1 --colors fans --screenshot scan.png")]
pub struct WindowArgs {
    /// Meshes, .striata files or streams; more can be dropped on the window
    #[arg(value_name = "FILE")]
    pub files: Vec<PathBuf>,
    /// Size of the window, pixels
    #[arg(long, value_name = "WxH", default_value = "1280x800")]
    size: Viewport,
    /// Dark or light [default: as the system]
    #[arg(long, value_name = "THEME")]
    pub theme: Option<ThemeArg>,
    /// Save what the window shows once it shows the model, and close it
    #[arg(long, value_name = "OUT.png")]
    pub screenshot: Option<PathBuf>,
    /// Show one file in the web viewer instead, until the command is ended
    #[cfg(feature = "serve")]
    #[arg(long, conflicts_with_all = ["size", "theme", "screenshot", "FirstArgs"])]
    pub browser: bool,
    /// What is shown first.
    #[command(flatten)]
    pub first: FirstArgs,
    /// How graphics drivers report.
    #[command(flatten)]
    pub drivers: DriverArgs,
}

/// What is shown first; all of it can be changed in the window.
#[derive(Clone, Debug, Args)]
#[command(next_help_heading = "Shown first")]
pub struct FirstArgs {
    /// Which model makes the triangles; one that the file lacks is built
    #[arg(long, value_name = "NAME")]
    pub model: Option<ShownModel>,
    /// Share of the vertex splits from the base mesh (0) to the full mesh (1)
    #[arg(long, value_name = "F", allow_negative_numbers = true, value_parser = parse_detail, group = "first_level")]
    pub detail: Option<f64>,
    /// At most this many triangles, or this share of the full mesh's, the same detail everywhere
    #[arg(long, value_name = "N|P%", allow_hyphen_values = true, group = "first_level")]
    pub triangles: Option<Count>,
    /// As fine as the screen asks for: errors of no more pixels
    #[arg(long, value_name = "P", allow_negative_numbers = true, value_parser = parse_pixels, group = "first_level")]
    pub pixels: Option<f64>,
    /// At most this many triangles, or this share of the full mesh's, those that the view shows best
    #[arg(long, value_name = "N|P%", allow_hyphen_values = true, group = "first_level")]
    pub budget: Option<Count>,
    /// Colors of triangles: surface (those of the vertices, or stone), strips, fans, triangles, groups
    #[arg(
        long,
        value_name = "NAME",
        default_value = "surface",
        hide_possible_values = true,
        alias = "colours"
    )]
    pub colors: Coloring,
    /// Draw the edges
    #[arg(long)]
    pub wireframe: bool,
    /// Light each triangle by its own normal
    #[arg(long)]
    pub flat: bool,
    /// The model's z axis is up, not y
    #[arg(long)]
    pub z_up: bool,
}

/// Dark or light.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum ThemeArg {
    /// Light on dark
    Dark,
    /// Dark on light
    Light,
}

/// Models that the window shows.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum ShownModel {
    /// Strips edited in place
    #[value(name = ModelKind::LodStrips.as_str())]
    LodStrips,
    /// Strips walked anew
    #[value(name = ModelKind::Mts.as_str())]
    Mts,
    /// Fans, which follow the view
    #[value(name = ModelKind::Fans.as_str())]
    Fans,
    /// Fans, extracted in a compute shader
    #[value(name = "fans-gpu")]
    FansGpu,
    /// Fragments, which follow the view
    #[value(name = ModelKind::Patterns.as_str())]
    Patterns,
    /// A list of triangles
    List,
}

impl WindowArgs {
    /// Size of the window, pixels.
    ///
    /// # Errors
    /// Where no window is so large.
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
