//! A view as a level: where the eye is, what it looks at, and how many pixels an error may take.

use std::str::FromStr;

use clap::Args;
use striata::view::{Camera, CameraError, Fovea, ScreenError, Sphere};

use crate::failure::Failure;

/// The heading of these flags.
const VIEW: &str = "View, with --eye";

/// What else a view needs. All have a default, and make no sense without an eye.
#[derive(Clone, Copy, Debug, Args)]
#[command(next_help_heading = VIEW)]
pub struct ViewArgs {
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
    /// Pixels that an error may take on the screen, by the file's errors: estimates, unless they are guaranteed [default: 1]
    #[arg(long, value_name = "P", allow_negative_numbers = true, value_parser = super::strips::parse_at_least_zero)]
    pixels: Option<f64>,
    /// Pixels that an error may take where the surface turns from the eye [default: as elsewhere]
    #[arg(long, value_name = "P", allow_negative_numbers = true, value_parser = super::strips::parse_at_least_zero)]
    silhouette_pixels: Option<f64>,
    /// A region of interest: the middle and the radius of a sphere
    #[arg(long, value_name = "X,Y,Z,R", allow_hyphen_values = true)]
    region: Option<Region>,
    /// Pixels that an error may take in the region [default: a tenth of elsewhere]
    #[arg(long, value_name = "P", allow_negative_numbers = true, value_parser = super::strips::parse_at_least_zero, requires = "region")]
    region_pixels: Option<f64>,
    /// Place of the screen that is looked at, -1 to 1 to the right and upwards; beyond 5 degrees from it errors may grow
    #[arg(long, value_name = "X,Y", allow_hyphen_values = true)]
    gaze: Option<Gaze>,
    /// How much they grow, times --pixels for each radian [default: 10]
    #[arg(long, value_name = "F", allow_negative_numbers = true, value_parser = super::strips::parse_at_least_zero, requires = "gaze")]
    gaze_falloff: Option<f64>,
}

/// Half the angle that an eye sees sharp, radians: 5 degrees.
const SHARP: f32 = 0.087_266_46;

impl ViewArgs {
    /// Whether anything was said of a view.
    pub fn is_given(&self) -> bool {
        // The other two need a region and a gaze.
        let Self { look_at, up, fov, viewport, pixels, silhouette_pixels, region, gaze, .. } = self;
        let has_camera = fov.is_some() || viewport.is_some() || look_at.is_some() || up.is_some();
        let has_place = region.is_some() || gaze.is_some();
        has_camera || has_place || pixels.is_some() || silhouette_pixels.is_some()
    }

    /// Pixels that an error may take.
    pub fn pixels(&self) -> f64 {
        self.pixels.unwrap_or(1.0)
    }

    /// What a camera asks for, with at least so many pixels allowed.
    pub fn criterion(&self, camera: Camera, least_pixels: f64) -> ScreenError {
        let at_least = |pixels: f64| pixels.max(least_pixels) as f32;
        let mut criterion = ScreenError::new(camera, at_least(self.pixels()));
        if let Some(pixels) = self.silhouette_pixels {
            criterion = criterion.with_silhouettes(at_least(pixels));
        }
        if let Some(Region([x, y, z, radius])) = self.region {
            let pixels = self.region_pixels.unwrap_or(self.pixels() / 10.0);
            criterion = criterion.with_region(Sphere { center: [x, y, z], radius }, at_least(pixels));
        }
        if let Some(Gaze(at)) = self.gaze {
            let falloff = self.gaze_falloff.unwrap_or(10.0) as f32;
            criterion = criterion.with_fovea(Fovea { at, radius: SHARP, falloff });
        }
        criterion
    }

    /// The camera at an eye; where nothing is said it looks at `center`.
    ///
    /// # Errors
    /// Where that makes no picture.
    pub fn camera(&self, eye: Point, center: [f32; 3]) -> Result<Camera, CameraError> {
        let target = self.look_at.map_or(center, |point| point.0);
        let up = self.up.map_or([0.0, 1.0, 0.0], |up| up.0);
        let Viewport(screen) = self.viewport.unwrap_or(Viewport([1920, 1080]));
        Camera::new(eye.0, target, up, tan(self.fov.unwrap_or(60.0).to_radians() / 2.0), screen)
    }
}

impl ViewArgs {
    /// What is looked at, where that was said.
    pub fn look_at(&self) -> Option<[f32; 3]> {
        self.look_at.map(|point| point.0)
    }

    /// What is upwards, where that was said.
    pub fn up(&self) -> Option<[f32; 3]> {
        self.up.map(|up| up.0)
    }

    /// The angle of view, radians, where that was said.
    pub fn fov(&self) -> Option<f64> {
        self.fov.map(f64::to_radians)
    }

    /// Pixels of the screen, where they were said.
    pub fn viewport(&self) -> Option<[u32; 2]> {
        self.viewport.map(|viewport| viewport.0)
    }

    /// The same for a screen of so many pixels, where none was said.
    pub fn on_screen(self, screen: [u32; 2]) -> Self {
        Self { viewport: self.viewport.or(Some(Viewport(screen))), ..self }
    }

    /// Whether anything was said that only a criterion of a view needs.
    pub fn has_criterion(&self) -> bool {
        let Self { viewport, pixels, silhouette_pixels, region, gaze, .. } = self;
        let has_place = region.is_some() || gaze.is_some();
        viewport.is_some() || has_place || pixels.is_some() || silhouette_pixels.is_some()
    }
}

/// A point as the user writes it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Point(pub [f32; 3]);

impl FromStr for Point {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        match numbers(text) {
            Some(point) => Ok(Self(point)),
            None => Err(format!("{text:?} is no point; write three numbers: 0,1.5,-2")),
        }
    }
}

/// A box as the user writes it: two corners that lie across.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Corners {
    /// The least coordinates.
    pub min: [f32; 3],
    /// The greatest coordinates.
    pub max: [f32; 3],
}

impl FromStr for Corners {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let wrong = || format!("{text:?} is no box; write two of its corners: 0,0,0,1,1.5,2");
        let [a, b, c, x, y, z] = numbers(text).ok_or_else(wrong)?;
        Ok(Self { min: [a.min(x), b.min(y), c.min(z)], max: [a.max(x), b.max(y), c.max(z)] })
    }
}

/// A sphere as the user writes it: its middle and its radius.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Region([f32; 4]);

impl FromStr for Region {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        match numbers(text) {
            Some(region) if region[3] >= 0.0 => Ok(Self(region)),
            _ => Err(format!("{text:?} is no sphere; write its middle and its radius: 0,1.5,-2,0.1")),
        }
    }
}

/// A place of the screen as the user writes it.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Gaze([f32; 2]);

impl FromStr for Gaze {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        match numbers(text) {
            Some(place) if place.iter().all(|x: &f32| x.abs() <= 1.0) => Ok(Self(place)),
            _ => Err(format!("{text:?} is no place of the screen; write two numbers from -1 to 1: 0.2,-0.5")),
        }
    }
}

/// So many finite numbers between commas.
fn numbers<const COUNT: usize>(text: &str) -> Option<[f32; COUNT]> {
    let numbers: Result<Vec<f32>, _> = text.split(',').map(|part| part.trim().parse::<f32>()).collect();
    let numbers: [f32; COUNT] = numbers.ok()?.try_into().ok()?;
    numbers.iter().all(|x| x.is_finite()).then_some(numbers)
}

/// Width and height of a screen as the user writes them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Viewport(pub [u32; 2]);

impl Viewport {
    /// Longer pictures take memory that nobody meant to ask for.
    const LONGEST_SIDE: u32 = 8192;

    /// # Errors
    /// Where so many pixels are not drawn.
    pub fn check_drawable(self) -> Result<(), Failure> {
        let Self([width, height]) = self;
        if width.max(height) <= Self::LONGEST_SIDE {
            return Ok(());
        }
        Err(Failure::user(format!("--size {width}x{height} is too large"))
            .with_hint(format!("each side may have up to {} pixels", Self::LONGEST_SIDE)))
    }
}

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
pub fn tan(angle: f64) -> f64 {
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
        assert_eq!("0,-1.5,2,0.5".parse(), Ok(Region([0.0, -1.5, 2.0, 0.5])));
        assert_eq!("1,-0.5".parse(), Ok(Gaze([1.0, -0.5])));
        for wrong in ["", "1,2,3", "1,2,3,-1", "1,2,3,inf"] {
            assert!(wrong.parse::<Region>().is_err(), "{wrong:?} was taken");
        }
        assert_eq!("1,0,3,0,2,-1".parse(), Ok(Corners { min: [0.0, 0.0, -1.0], max: [1.0, 2.0, 3.0] }));
        for wrong in ["", "1,2,3,4,5", "1,2,3,4,5,inf", "1,2,3,4,5,6,7"] {
            assert!(wrong.parse::<Corners>().is_err(), "{wrong:?} was taken");
        }
        for wrong in ["", "0", "0,1.5", "0,0,0"] {
            assert!(wrong.parse::<Gaze>().is_err(), "{wrong:?} was taken");
        }
        for wrong in ["", "16", "0x9", "16x", "16x9x2", "-1x5"] {
            assert!(wrong.parse::<Viewport>().is_err(), "{wrong:?} was taken");
        }
    }
}
