//! Cameras as engines have them: matrices and the size of the screen.

use striata::view::Camera;

use crate::status::{CallFailure, CallResult};

/// A camera: the two matrices that a vertex shader gets, and the size of the screen.
///
/// Matrices are lists of columns, as in OpenGL, Vulkan and WebGPU. Perspective projections of any convention work, also
/// off-center, reversed and infinite ones, and orthographic ones.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default)]
pub struct StriataCamera {
    /// From the space of the mesh to the space of the view: the view matrix times the matrix of the object.
    pub view: [f32; 16],
    /// From the space of the view to clip space.
    pub projection: [f32; 16],
    /// Width of the screen, in pixels.
    pub width: u32,
    /// Height of the screen, in pixels.
    pub height: u32,
}

impl StriataCamera {
    pub(crate) fn to_camera(self) -> CallResult<Camera> {
        let columns = |matrix: [f32; 16]| [0, 4, 8, 12].map(|at| [0, 1, 2, 3].map(|row| matrix[at + row]));
        let (view, projection) = (columns(self.view), columns(self.projection));
        Camera::from_matrices(view, projection, [self.width, self.height])
            .map_err(|error| CallFailure::argument("camera", error))
    }
}

/// Checks a tolerance in pixels.
pub(crate) fn checked_pixels(pixels: f32) -> CallResult<f32> {
    if pixels.is_finite() && pixels >= 0.0 {
        return Ok(pixels);
    }
    Err(CallFailure::argument("pixels", format_args!("{pixels} is not a finite number of at least 0")))
}
