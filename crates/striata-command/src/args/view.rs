//! Flags that describe a view: the camera, and how large errors may appear on the screen.

use std::str::FromStr;

use clap::Args;
use striata::view::{Camera, CameraError, Fovea, ScreenError, Sphere};

use crate::failure::Failure;

/// Help heading of these flags.
const VIEW: &str = "View (with --eye)";

/// Everything about a view except the position of its eye. All flags have defaults; none makes sense without
/// `--eye`.
#[derive(Clone, Copy, Debug, Args)]
#[command(next_help_heading = VIEW)]
pub struct ViewArgs {
    /// Point that the eye looks at [default: center of the mesh]
    #[arg(long, value_name = "X,Y,Z", allow_hyphen_values = true)]
    look_at: Option<Point>,
    /// Direction that is up on the screen [default: 0,1,0]
    #[arg(long, value_name = "X,Y,Z", allow_hyphen_values = true)]
    up: Option<Point>,
    /// Vertical field of view [default: 60]
    #[arg(long, value_name = "DEG", allow_negative_numbers = true, value_parser = parse_angle)]
    fov: Option<f64>,
    /// Screen size in pixels [default: 1920x1080]
    #[arg(long, value_name = "WxH")]
    viewport: Option<Viewport>,
    /// Largest error allowed on the screen [default: 1]
    #[arg(
        long,
        value_name = "PX",
        allow_negative_numbers = true,
        value_parser = super::strips::parse_at_least_zero,
    )]
    pixels: Option<f64>,
    /// Largest error allowed along silhouettes [default: --pixels]
    #[arg(
        long,
        value_name = "PX",
        allow_negative_numbers = true,
        value_parser = super::strips::parse_at_least_zero,
    )]
    silhouette_pixels: Option<f64>,
    /// Region of interest: center and radius of a sphere
    #[arg(long, value_name = "X,Y,Z,R", allow_hyphen_values = true)]
    region: Option<Region>,
    /// Largest error allowed in the region [default: a tenth of --pixels]
    #[arg(
        long,
        value_name = "PX",
        allow_negative_numbers = true,
        value_parser = super::strips::parse_at_least_zero,
        requires = "region",
    )]
    region_pixels: Option<f64>,
    /// Screen point that the viewer looks at, -1 to 1 right and up; farther than 5 degrees from it, errors
    /// may grow
    #[arg(long, value_name = "X,Y", allow_hyphen_values = true)]
    gaze: Option<Gaze>,
    /// Growth of the allowed error away from the gaze, in --pixels per radian [default: 10]
    #[arg(
        long,
        value_name = "FACTOR",
        allow_negative_numbers = true,
        value_parser = super::strips::parse_at_least_zero,
        requires = "gaze",
    )]
    gaze_falloff: Option<f64>,
}

/// Radius of the region of sharp vision around the gaze, radians: 5 degrees.
const FOVEA_RADIUS: f32 = 0.087_266_46;

impl ViewArgs {
    /// Whether the user gave any of these flags.
    pub fn is_given(&self) -> bool {
        // The parser accepts the other two flags only together with `--region` and `--gaze`.
        let Self { look_at, up, fov, viewport, pixels, silhouette_pixels, region, gaze, .. } = self;
        let has_camera = fov.is_some() || viewport.is_some() || look_at.is_some() || up.is_some();
        let has_focus = region.is_some() || gaze.is_some();
        has_camera || has_focus || pixels.is_some() || silhouette_pixels.is_some()
    }

    /// Returns the largest error allowed on the screen, in pixels.
    pub fn pixels(&self) -> f64 {
        self.pixels.unwrap_or(1.0)
    }

    /// Returns the refinement criterion for a camera.
    pub fn criterion(&self, camera: Camera) -> ScreenError {
        let mut criterion = ScreenError::new(camera, self.pixels() as f32);
        if let Some(pixels) = self.silhouette_pixels {
            criterion = criterion.with_silhouettes(pixels as f32);
        }
        if let Some(Region([x, y, z, radius])) = self.region {
            let pixels = self.region_pixels.unwrap_or(self.pixels() / 10.0);
            let sphere = Sphere { center: [x, y, z].map(|x| x as f32), radius: radius as f32 };
            criterion = criterion.with_region(sphere, pixels as f32);
        }
        if let Some(Gaze(at)) = self.gaze {
            let falloff = self.gaze_falloff.unwrap_or(10.0) as f32;
            let at = at.map(|x| x as f32);
            criterion = criterion.with_fovea(Fovea { at, radius: FOVEA_RADIUS, falloff });
        }
        criterion
    }

    /// Returns the camera at `eye`, which looks at `center` unless `--look-at` was given.
    ///
    /// # Errors
    /// If the camera has no direction (it looks at its own position, or along `up`) or cannot be projected.
    pub fn camera(&self, eye: Point, center: [f32; 3]) -> Result<Camera, CameraError> {
        let target = self.look_at().unwrap_or(center);
        let up = self.up().unwrap_or([0.0, 1.0, 0.0]);
        let Viewport(screen) = self.viewport.unwrap_or(Viewport([1920, 1080]));
        Camera::new(eye.in_f32(), target, up, tan(self.fov.unwrap_or(60.0).to_radians() / 2.0), screen)
    }
}

impl ViewArgs {
    /// Returns the same flags with all points relative to the origin of a mesh; users give them in the
    /// coordinates of the file.
    #[must_use]
    pub fn relative_to(self, origin: [f64; 3]) -> Self {
        let region = self.region.map(|Region([x, y, z, radius])| {
            let Point([x, y, z]) = Point([x, y, z]).relative_to(origin);
            Region([x, y, z, radius])
        });
        Self { look_at: self.look_at.map(|point| point.relative_to(origin)), region, ..self }
    }

    /// Returns the point that the eye looks at, if given.
    pub fn look_at(&self) -> Option<[f32; 3]> {
        self.look_at.map(Point::in_f32)
    }

    /// Returns the up direction, if given.
    pub fn up(&self) -> Option<[f32; 3]> {
        self.up.map(Point::in_f32)
    }

    /// Returns the vertical field of view in radians, if given.
    pub fn fov(&self) -> Option<f64> {
        self.fov.map(f64::to_radians)
    }

    /// Returns the screen size in pixels, if given.
    pub fn viewport(&self) -> Option<[u32; 2]> {
        self.viewport.map(|viewport| viewport.0)
    }

    /// Sets the screen size to `screen` pixels unless the user gave one.
    pub fn on_screen(self, screen: [u32; 2]) -> Self {
        Self { viewport: self.viewport.or(Some(Viewport(screen))), ..self }
    }

    /// Whether the user gave any flag that only the refinement criterion uses, not the camera.
    pub fn has_criterion(&self) -> bool {
        let Self { viewport, pixels, silhouette_pixels, region, gaze, .. } = self;
        let has_focus = region.is_some() || gaze.is_some();
        viewport.is_some() || has_focus || pixels.is_some() || silhouette_pixels.is_some()
    }
}

/// A point, written as three numbers: `0,1.5,-2`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Point(pub [f64; 3]);

impl Point {
    /// Returns the point relative to the origin of a mesh.
    #[must_use]
    pub fn relative_to(self, origin: [f64; 3]) -> Self {
        Self([0, 1, 2].map(|axis| self.0[axis] - origin[axis]))
    }

    /// Returns the coordinates in single precision.
    pub fn in_f32(self) -> [f32; 3] {
        self.0.map(|x| x as f32)
    }
}

impl FromStr for Point {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        match numbers(text) {
            Some(point) => Ok(Self(point)),
            None => Err(format!("{text:?} is not a point; write three numbers: 0,1.5,-2")),
        }
    }
}

/// An axis-aligned box, written as two opposite corners: `0,0,0,1,1.5,2`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AxisAlignedBox {
    /// Smallest coordinates.
    pub min: [f64; 3],
    /// Largest coordinates.
    pub max: [f64; 3],
}

impl AxisAlignedBox {
    /// Returns the smallest and largest coordinates relative to the origin of a mesh, in single precision.
    pub fn relative_to(self, origin: [f64; 3]) -> [[f32; 3]; 2] {
        [self.min, self.max].map(|corner| Point(corner).relative_to(origin).in_f32())
    }
}

impl FromStr for AxisAlignedBox {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let wrong = || format!("{text:?} is not a box; write two opposite corners: 0,0,0,1,1.5,2");
        let [a, b, c, x, y, z] = numbers(text).ok_or_else(wrong)?;
        Ok(Self { min: [a.min(x), b.min(y), c.min(z)], max: [a.max(x), b.max(y), c.max(z)] })
    }
}

/// A sphere, written as its center and its radius: `0,1.5,-2,0.1`.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Region([f64; 4]);

impl FromStr for Region {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        match numbers(text) {
            Some(region) if region[3] >= 0.0 => Ok(Self(region)),
            _ => Err(format!("{text:?} is not a sphere; write its center and its radius: 0,1.5,-2,0.1")),
        }
    }
}

/// A point on the screen, written as two numbers from -1 to 1: `0.2,-0.5`.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Gaze([f64; 2]);

impl FromStr for Gaze {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        match numbers(text) {
            Some(point) if point.iter().all(|x| x.abs() <= 1.0) => Ok(Self(point)),
            _ => Err(format!(
                "{text:?} is not a point on the screen; write two numbers from -1 to 1: 0.2,-0.5"
            )),
        }
    }
}

/// Parses exactly `COUNT` finite numbers, separated by commas.
fn numbers<const COUNT: usize>(text: &str) -> Option<[f64; COUNT]> {
    let numbers: Result<Vec<f64>, _> = text.split(',').map(|part| part.trim().parse::<f64>()).collect();
    let numbers: [f64; COUNT] = numbers.ok()?.try_into().ok()?;
    numbers.iter().all(|&x| (x as f32).is_finite()).then_some(numbers)
}

/// Width and height in pixels, written `1920x1080`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Viewport(pub [u32; 2]);

impl Viewport {
    /// Larger pictures take more memory than anyone means to use.
    const MAX_SIDE: u32 = 8192;

    /// Checks that a picture of this size can be drawn.
    ///
    /// # Errors
    /// If a side has more than 8192 pixels.
    pub fn check_drawable(self) -> Result<(), Failure> {
        let Self([width, height]) = self;
        if width.max(height) <= Self::MAX_SIDE {
            return Ok(());
        }
        Err(Failure::usage(format!("--size {width}x{height} is too large"))
            .with_hint(format!("each side may have at most {} pixels", Self::MAX_SIDE)))
    }
}

impl FromStr for Viewport {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let sides = text.split_once('x').map(|(width, height)| (width.parse(), height.parse()));
        match sides {
            Some((Ok(width @ 1..), Ok(height @ 1..))) => Ok(Self([width, height])),
            _ => Err(format!("{text:?} is not a size; write width and height in pixels: 1920x1080")),
        }
    }
}

fn parse_angle(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(angle) if angle > 0.0 && angle < 180.0 => Ok(angle),
        _ => Err("must be an angle greater than 0 and less than 180 degrees".to_owned()),
    }
}

/// Returns the tangent of an angle up to a quarter turn, by its continued fraction: the same on every
/// machine.
pub fn tan(angle: f64) -> f64 {
    let square = angle * angle;
    let rest = (1..=20).rev().map(|i| f64::from(2 * i + 1)).fold(43.0, |below, odd| odd - square / below);
    angle / (1.0 - square / rest)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tangents_match_tabulated_values() {
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
    fn points_boxes_and_sizes_parse_or_fail() {
        assert_eq!("0,-1.5, 2".parse(), Ok(Point([0.0, -1.5, 2.0])));
        assert_eq!("16x9".parse(), Ok(Viewport([16, 9])));
        for wrong in ["", "1,2", "1,2,3,4", "a,b,c", "1,2,nan"] {
            assert!(wrong.parse::<Point>().is_err(), "{wrong:?} was accepted");
        }
        assert_eq!("0,-1.5,2,0.5".parse(), Ok(Region([0.0, -1.5, 2.0, 0.5])));
        assert_eq!("1,-0.5".parse(), Ok(Gaze([1.0, -0.5])));
        for wrong in ["", "1,2,3", "1,2,3,-1", "1,2,3,inf"] {
            assert!(wrong.parse::<Region>().is_err(), "{wrong:?} was accepted");
        }
        assert_eq!(
            "1,0,3,0,2,-1".parse(),
            Ok(AxisAlignedBox { min: [0.0, 0.0, -1.0], max: [1.0, 2.0, 3.0] })
        );
        for wrong in ["", "1,2,3,4,5", "1,2,3,4,5,inf", "1,2,3,4,5,6,7"] {
            assert!(wrong.parse::<AxisAlignedBox>().is_err(), "{wrong:?} was accepted");
        }
        for wrong in ["", "0", "0,1.5", "0,0,0"] {
            assert!(wrong.parse::<Gaze>().is_err(), "{wrong:?} was accepted");
        }
        for wrong in ["", "16", "0x9", "16x", "16x9x2", "-1x5"] {
            assert!(wrong.parse::<Viewport>().is_err(), "{wrong:?} was accepted");
        }
    }
}
