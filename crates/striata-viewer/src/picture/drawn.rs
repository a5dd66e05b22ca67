//! What comes of drawing.

use super::Canvas;

/// What was drawn. Where nothing was drawn the picture is transparent.
#[derive(Clone, Debug)]
pub struct Drawn {
    /// The picture.
    pub canvas: Canvas,
    /// Seconds that one frame took, once everything was in place.
    pub secs: f64,
}
