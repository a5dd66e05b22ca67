//! Arguments of `view`: what it opens, and the settings of the page at first.

use std::fmt::Write as _;
use std::path::PathBuf;

use clap::{Args, ValueEnum};
use striata::model::ModelKind;

/// Arguments of `view`.
#[derive(Debug, Args)]
#[command(after_help = "Examples:\n  \
    striata view robot.glb --time 0.5\n  \
    striata view scan.ply --pixels 1 --colors fans")]
pub struct PageArgs {
    /// Show this scene, mesh, .striata file or stream; or the gallery of a folder. The command ends when its page is
    /// closed
    #[arg(value_name = "FILE|DIR", default_value = ".")]
    pub path: PathBuf,
    /// Print the address instead of opening the default browser
    #[arg(long)]
    pub no_open: bool,
    /// Settings of the page at first.
    #[command(flatten)]
    pub first: FirstArgs,
}

/// Settings of the page at first, all of which can be changed there.
#[derive(Clone, Debug, Default, Args)]
#[command(next_help_heading = "First settings of the page")]
pub struct FirstArgs {
    /// Set the detail from 0 (base mesh) to 1 (full mesh)
    #[arg(long, value_name = "F", allow_negative_numbers = true, value_parser = parse_detail, group = "first_level")]
    pub detail: Option<f64>,
    /// Limit the triangle count
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..), group = "first_level")]
    pub triangles: Option<u32>,
    /// Refine for the view until the screen error is at most this many pixels
    #[arg(long, value_name = "P", allow_negative_numbers = true, value_parser = parse_pixels, group = "first_level")]
    pub pixels: Option<f64>,
    /// Show everything as one mesh in this model, which is built if the file does not contain it
    #[arg(long, value_name = "NAME")]
    pub model: Option<InspectedModel>,
    /// Pose of the scene at this time of its animation, in seconds
    #[arg(long, value_name = "SECONDS", allow_negative_numbers = true, value_parser = parse_time)]
    pub time: Option<f64>,
    /// Animation to take the pose from: its number, beginning with 0
    #[arg(long, value_name = "N", requires = "time")]
    pub animation: Option<u16>,
    /// Color by surface (materials, vertex colors, or clay), strips, fans or triangles
    #[arg(long, value_name = "NAME", alias = "colours")]
    pub colors: Option<PageColors>,
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

/// Models that the page can show.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum InspectedModel {
    /// Triangle list
    List,
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
    /// Fragment patterns, with view-dependent detail
    #[value(name = ModelKind::Patterns.as_str())]
    Patterns,
}

/// How the page colors triangles.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum PageColors {
    /// Materials, vertex colors, or clay
    Surface,
    /// One color per strip
    Strips,
    /// One color per fan
    Fans,
    /// One color per triangle
    Triangles,
}

impl FirstArgs {
    /// The settings as parameters of the page's address, each behind an `&`.
    pub(super) fn parameters(&self) -> String {
        let mut written = String::new();
        let mut add = |name: &str, value: Option<String>| {
            if let Some(value) = value {
                // Writing to a string does not fail.
                let _ = write!(written, "&{name}={value}");
            }
        };
        let flag = |is_set: bool| is_set.then(|| "1".to_owned());
        add("detail", self.detail.map(|detail| detail.to_string()));
        add("triangles", self.triangles.map(|count| count.to_string()));
        add("error", self.pixels.map(|pixels| pixels.to_string()));
        add("as", self.model.and_then(|model| Some(model.to_possible_value()?.get_name().to_owned())));
        let color = match self.colors {
            Some(PageColors::Strips) => Some("strip"),
            Some(PageColors::Fans) => Some("fan"),
            Some(PageColors::Triangles) => Some("triangle"),
            Some(PageColors::Surface) | None => None,
        };
        add("color", color.map(str::to_owned));
        add("wireframe", flag(self.wireframe));
        add("flat", flag(self.flat));
        add("z-up", flag(self.z_up));
        add("clip", self.animation.map(|number| (u32::from(number) + 1).to_string()));
        add("time", self.time.map(|seconds| seconds.to_string()));
        written
    }
}

fn parse_detail(text: &str) -> Result<f64, String> {
    parse_between(text, [0.0, 1.0], "")
}

/// The limits are those of the page's slider.
fn parse_pixels(text: &str) -> Result<f64, String> {
    parse_between(text, [0.25, 20.0], " of pixels")
}

fn parse_time(text: &str) -> Result<f64, String> {
    parse_between(text, [0.0, 1e9], " of seconds")
}

fn parse_between(text: &str, [least, most]: [f64; 2], unit: &str) -> Result<f64, String> {
    match text.parse() {
        Ok(value) if (least..=most).contains(&value) => Ok(value),
        _ => Err(format!("must be a number{unit} from {least} to {most}")),
    }
}

#[cfg(test)]
mod tests {
    use clap::Parser;

    use super::*;

    #[derive(Parser)]
    struct Line {
        #[command(flatten)]
        show: PageArgs,
    }

    fn parameters(line: &str) -> Result<String, clap::Error> {
        let words = std::iter::once("view").chain(line.split_whitespace());
        Ok(Line::try_parse_from(words)?.show.first.parameters())
    }

    #[test]
    fn settings_become_parameters() {
        let all = "a.glb --pixels 1.5 --model live-strips --colors strips --wireframe --flat --z-up --time 2.5 --animation 1";
        let expected = "&error=1.5&as=live-strips&color=strip&wireframe=1&flat=1&z-up=1&clip=2&time=2.5";
        assert_eq!(parameters(all).expect("valid"), expected);
        assert_eq!(parameters("a.glb --detail 0.5 --colors surface").expect("valid"), "&detail=0.5");
        assert_eq!(parameters("a.glb --triangles 500").expect("valid"), "&triangles=500");
        assert_eq!(parameters("a.glb").expect("valid"), "");
    }

    #[test]
    fn settings_that_no_page_has_are_refused() {
        for line in [
            "--detail 1.5",
            "--pixels 0",
            "--pixels nan",
            "--triangles 0",
            "--time -1",
            "--animation 0",
            "--detail 1 --pixels 1",
        ] {
            assert!(parameters(&format!("a.glb {line}")).is_err(), "{line}");
        }
    }
}
