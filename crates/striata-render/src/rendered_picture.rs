//! A drawn picture and its timing.

use super::Canvas;

/// A drawn picture. Pixels not covered by the model are transparent.
#[derive(Clone, Debug)]
pub struct Drawn {
    /// The picture.
    pub canvas: Canvas,
    /// Time to draw one frame, not counting setup, seconds.
    pub secs: f64,
}
