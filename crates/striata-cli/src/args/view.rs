//! A view as a level: where the eye is, what it looks at, and how many pixels an error may take.

use std::str::FromStr;

use clap::Args;
use striata::view::{Camera, CameraError, ScreenError};

/// The heading of these flags.
const VIEW: &str = "View, with --eye";

/// What else a view needs. All have a default, and make no sense without an eye.
#[derive(Clone, Copy, Debug, Args)]
#[command(next_help_heading = VIEW)]
pub(crate) struct ViewArgs {
    /// What the eye looks at [default: the middle of the mesh]
    #[arg(long, value_name = "X,Y,Z", allow_hyphen_values = true)]
    look_at: Option<Point>,
    /// What is upwards on the screen [default: 0,1,0]
    #[arg(long, value_name = "X,Y,Z", allow_hyphen_values = true)]
    up: Option<Point>,
    /// Angle of view from the lower to the upper side of the screen, degrees [default: 60]
    #[arg(long, value_name = "DEG", allow_negative_numbers = true, value_parser = parse_angle)]
    fov: Option<f64>,
    /// Pixels of the screen [default: 1920x1080]
    #[arg(long, value_name = "WxH")]
    viewport: Option<Viewport>,
    /// Pixels that an error may take on the screen [default: 1]
    #[arg(long, value_name = "P", allow_negative_numbers = true, value_parser = super::strips::parse_at_least_zero)]
    pixels: Option<f64>,
    /// Pixels that an error may take where the surface turns from the eye [default: as elsewhere]
    #[arg(long, value_name = "P", allow_negative_numbers = true, value_parser = super::strips::parse_at_least_zero)]
    silhouette_pixels: Option<f64>,
}

impl ViewArgs {
    /// Whether anything was said of a view.
    pub(crate) fn is_given(&self) -> bool {
        let Self { look_at, up, fov, viewport, pixels, silhouette_pixels } = self;
        let has_screen = fov.is_some() || viewport.is_some();
        has_screen || look_at.is_some() || up.is_some() || pixels.is_some() || silhouette_pixels.is_some()
    }

    /// Pixels that an error may take.
    pub(crate) fn pixels(&self) -> f64 {
        self.pixels.unwrap_or(1.0)
    }

    /// What a camera asks for, with at least so many pixels allowed.
    pub(crate) fn criterion(&self, camera: Camera, least_pixels: f64) -> ScreenError {
        let criterion = ScreenError::new(camera, self.pixels().max(least_pixels) as f32);
        match self.silhouette_pixels {
            Some(pixels) => criterion.with_silhouettes(pixels.max(least_pixels) as f32),
            None => criterion,
        }
    }

    /// The camera at an eye; where nothing is said it looks at `center`.
    ///
    /// # Errors
    /// Where that makes no picture.
    pub(crate) fn camera(&self, eye: Point, center: [f32; 3]) -> Result<Camera, CameraError> {
        let target = self.look_at.map_or(center, |point| point.0);
        let up = self.up.map_or([0.0, 1.0, 0.0], |up| up.0);
        let Viewport(screen) = self.viewport.unwrap_or(Viewport([1920, 1080]));
        Camera::new(eye.0, target, up, tan(self.fov.unwrap_or(60.0).to_radians() / 2.0), screen)
    }
}

/// A point as the user writes it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Point(pub(crate) [f32; 3]);

impl FromStr for Point {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let numbers: Result<Vec<f32>, _> = text.split(',').map(|part| part.trim().parse::<f32>()).collect();
        match numbers.as_deref() {
            Ok(&[x, y, z]) if x.is_finite() && y.is_finite() && z.is_finite() => Ok(Self([x, y, z])),
            _ => Err(format!("{text:?} is no point; write three numbers: 0,1.5,-2")),
        }
    }
}

/// Width and height of a screen as the user writes them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Viewport([u32; 2]);

impl FromStr for Viewport {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let sides = text.split_once('x').map(|(width, height)| (width.parse(), height.parse()));
        match sides {
            Some((Ok(width @ 1..), Ok(height @ 1..))) => Ok(Self([width, height])),
            _ => Err(format!("{text:?} is no size of a screen; write 1920x1080")),
        }
    }
}

fn parse_angle(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(angle) if angle > 0.0 && angle < 180.0 => Ok(angle),
        _ => Err("must be an angle over 0 and under 180".to_owned()),
    }
}

/// The tangent of an angle up to a quarter turn, by its continued fraction: the same on every machine.
pub(crate) fn tan(angle: f64) -> f64 {
    let square = angle * angle;
    let rest = (1..=20).rev().map(|i| f64::from(2 * i + 1)).fold(43.0, |below, odd| odd - square / below);
    angle / (1.0 - square / rest)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tangents_are_those_of_the_table() {
        for (degrees, expected) in [
            (1e-6, 1.745_329_251_994_33e-8),
            (30.0, 0.577_350_269_189_625_8),
            (45.0, 1.0),
            (89.0, 57.289_961_630_759_42),
        ] {
            let found = tan(f64::to_radians(degrees));
            assert!((found - expected).abs() < 1e-12 * expected, "{degrees}: {found}");
        }
    }

    #[test]
    fn points_and_screens_are_read_or_refused() {
        assert_eq!("0,-1.5, 2".parse(), Ok(Point([0.0, -1.5, 2.0])));
        assert_eq!("16x9".parse(), Ok(Viewport([16, 9])));
        for wrong in ["", "1,2", "1,2,3,4", "a,b,c", "1,2,nan"] {
            assert!(wrong.parse::<Point>().is_err(), "{wrong:?} was taken");
        }
        for wrong in ["", "16", "0x9", "16x", "16x9x2", "-1x5"] {
            assert!(wrong.parse::<Viewport>().is_err(), "{wrong:?} was taken");
        }
    }
}
