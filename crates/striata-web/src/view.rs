//! The camera of a page, converted to the library's.

use striata::view::{Camera, ScreenError};
use wasm_bindgen::prelude::wasm_bindgen;

use crate::Failure;

/// A camera in model space, its screen size, and the tolerance.
#[wasm_bindgen]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct View {
    eye: [f32; 3],
    target: [f32; 3],
    up: [f32; 3],
    tan_half_fov: f64,
    screen: [u32; 2],
    /// Tolerated screen error, pixels.
    pub pixels: f32,
    /// Maximum number of triangles; 0 for no limit.
    pub triangle_limit: u32,
}

#[wasm_bindgen]
impl View {
    /// Creates a view from 12 `numbers`: eye, target and up (three each), tangent of half the vertical
    /// field of view, and width and height of the screen in pixels.
    ///
    /// # Errors
    /// If there are not 12 numbers.
    #[wasm_bindgen(constructor)]
    pub fn new(numbers: &[f64], pixels: f32, triangle_limit: u32) -> Result<Self, Failure> {
        let Ok(&[ex, ey, ez, tx, ty, tz, ux, uy, uz, tan_half_fov, width, height]) =
            <&[f64; 12]>::try_from(numbers)
        else {
            return Err(Failure::unsupported(format!("a view needs 12 numbers, not {}", numbers.len())));
        };
        let point = |p: [f64; 3]| p.map(|x| x as f32);
        Ok(Self {
            eye: point([ex, ey, ez]),
            target: point([tx, ty, tz]),
            up: point([ux, uy, uz]),
            tan_half_fov,
            screen: [width, height].map(|side| side as u32),
            pixels,
            triangle_limit,
        })
    }
}

impl View {
    /// Criterion of selective refinement for this view.
    ///
    /// # Errors
    /// If such a camera sees nothing.
    pub(crate) fn criterion(&self) -> Result<ScreenError, Failure> {
        let camera = Camera::new(self.eye, self.target, self.up, self.tan_half_fov, self.screen);
        Ok(ScreenError::new(camera.map_err(Failure::unsupported)?, self.pixels))
    }
}
