//! View-dependent refinement: bounds of parts of a mesh, and criteria such as a camera's screen-space error.
//!
//! All tests are conservative. A bound contains everything that it bounds, rounding included; a part is
//! only called invisible if nothing of it can be seen, and its screen-space error is never underestimated.
//! Angles are never computed: sines and cosines are combined by square roots, which give the same results
//! on every machine.
//!
//! ```
//! use striata::view::{Camera, ScreenError};
//!
//! let camera = Camera::new([0.0, 0.0, 3.0], [0.0; 3], [0.0, 1.0, 0.0], 0.577, [1920, 1080])?;
//! let error = ScreenError::new(camera, 1.0).with_silhouettes(0.5); // 1 pixel, half a pixel at silhouettes
//! # Ok::<(), striata::view::CameraError>(())
//! ```

mod camera;
mod cone;
mod criterion;
mod detail_box;
mod fixed_log;
mod grid_camera;
mod screen_error;
mod screen_lanes;
mod sphere;
mod step_box;

pub use camera::{Camera, CameraError};
pub use cone::NormalCone;
pub use criterion::{Criterion, Part, Verdict};
pub use detail_box::DetailBox;
pub use grid_camera::GridCamera;
pub use screen_error::{Fovea, ScreenError};
pub use sphere::Sphere;
pub use step_box::{BoxGrid, StepBox};

/// Upper bound on the rounding error of a sum of a few products of numbers around 1.
const SLACK: f32 = 1e-5;
