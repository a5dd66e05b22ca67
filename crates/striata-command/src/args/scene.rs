//! Flags for scenes: whether they stay scenes, and what happens to their textures.

use clap::{ArgGroup, Args, ValueEnum};
use striata_scene::textures::{TextureFormat, TextureOptions};

/// How a raster of heights is read.
#[derive(Clone, Copy, Debug, Default, Args)]
pub struct RasterArgs {
    /// Take this sample of a raster for none, besides the one that the file names
    #[arg(
        long,
        value_name = "VALUE",
        allow_negative_numbers = true,
        help_heading = "Terrain (.tif, .hgt, .png)"
    )]
    pub nodata: Option<f64>,
    /// Multiply the heights of a terrain
    #[arg(
        long,
        value_name = "FACTOR",
        allow_negative_numbers = true,
        help_heading = "Terrain (.tif, .hgt, .png)"
    )]
    pub z_scale: Option<f64>,
}

/// Whether a scene is treated as one mesh.
#[derive(Clone, Copy, Debug, Default, Args)]
#[command(next_help_heading = "Scenes (.gltf, .glb, and files made from them)")]
pub struct FlatArgs {
    /// Treat a scene as one mesh: apply the transforms of nodes, and drop skins, animations and cameras
    #[arg(long)]
    pub flat: bool,
}

/// Parts of a scene that are left out because the rest of it implies them.
#[derive(Clone, Copy, Debug, Default, Args)]
#[command(next_help_heading = "Scenes (.gltf, .glb, and files made from them)")]
pub struct EditArgs {
    /// Merge equal images, textures, materials, vertices and meshes; simplify and encode do so in any case
    #[arg(long)]
    pub dedup: bool,
    /// Leave out keyframes within a tolerance of what their neighbors give, relative to the largest value
    #[arg(
        long,
        value_name = "TOLERANCE",
        num_args = 0..=1,
        require_equals = true,
        default_missing_value = "1e-4",
        value_parser = parse_tolerance,
    )]
    pub resample: Option<f64>,
}

fn parse_tolerance(text: &str) -> Result<f64, String> {
    let tolerance: f64 = text.parse().map_err(|_| "a number is expected, such as 1e-4".to_owned())?;
    if (0.0..=1.0).contains(&tolerance) {
        Ok(tolerance)
    } else {
        Err("the tolerance must be between 0 and 1".to_owned())
    }
}

impl EditArgs {
    /// Returns the first of these flags that the user gave.
    pub fn first_given_flag(&self) -> Option<&'static str> {
        let flags = [("--dedup", self.dedup), ("--resample", self.resample.is_some())];
        flags.into_iter().find(|&(_, is_given)| is_given).map(|(flag, _)| flag)
    }
}

/// How the images of textures are re-encoded; without any of these flags, they stay as they are.
#[derive(Clone, Copy, Debug, Default, Args)]
#[command(
    next_help_heading = "Textures",
    group = ArgGroup::new("TextureCoding").args(["texture_max", "texture_format"]).multiple(true),
)]
pub struct TextureArgs {
    /// Reduce images to at most this many pixels per side
    #[arg(
        long,
        value_name = "PIXELS",
        allow_negative_numbers = true,
        value_parser = clap::value_parser!(u32).range(1..),
    )]
    texture_max: Option<u32>,
    /// Re-encode images: jpeg (those with visible alpha as png), png or webp (lossless)
    #[arg(long, value_name = "FORMAT", hide_possible_values = true)]
    texture_format: Option<TextureFormatArg>,
    /// Quality of images that become JPEG, 1 to 100 [default: 90]
    #[arg(
        long,
        value_name = "QUALITY",
        allow_negative_numbers = true,
        value_parser = clap::value_parser!(u8).range(1..=100),
        requires = "TextureCoding",
    )]
    texture_quality: Option<u8>,
}

/// A format that images can be written in.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum TextureFormatArg {
    /// JPEG; images whose alpha is visible become PNG
    Jpeg,
    /// PNG
    Png,
    /// WebP, lossless
    Webp,
}

impl TextureArgs {
    /// Returns the first of these flags that the user gave.
    pub fn first_given_flag(&self) -> Option<&'static str> {
        // The parser accepts the quality only together with one of these.
        let flags = [
            ("--texture-max", self.texture_max.is_some()),
            ("--texture-format", self.texture_format.is_some()),
        ];
        flags.into_iter().find(|&(_, is_given)| is_given).map(|(flag, _)| flag)
    }

    /// Returns how images are re-encoded; `None` if they stay as they are.
    pub fn options(&self) -> Option<TextureOptions> {
        self.first_given_flag()?;
        let format = self.texture_format.map(|format| match format {
            TextureFormatArg::Jpeg => TextureFormat::Jpeg,
            TextureFormatArg::Png => TextureFormat::Png,
            TextureFormatArg::Webp => TextureFormat::WebP,
        });
        let defaults = TextureOptions::default();
        let quality = self.texture_quality.unwrap_or(defaults.quality);
        Some(defaults.with_max_side(self.texture_max).with_format(format).with_quality(quality))
    }
}
