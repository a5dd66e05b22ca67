//! Options of opening inputs in pieces.

use std::path::PathBuf;

/// Options of [`open_pieces`](super::open_pieces) and [`open_several`](super::open_several).
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct PieceOptions {
    /// Number of triangles per piece, about; at least 1. Default: 100,000.
    pub piece_triangle_count: u32,
    /// Folder for temporary copies of inputs that cannot be read in place (text, compressed files). Default:
    /// [`None`], the system's folder for temporary files.
    pub scratch: Option<PathBuf>,
    /// Origin of all positions, in mesh units. Default: [`None`]: zero, or one near the mesh if single precision
    /// cannot hold its coordinates.
    pub origin: Option<[f64; 3]>,
    /// Factor of the heights of a terrain. Default: 1.
    pub z_scale: f64,
    /// Sample of a raster that stands for no height, besides what the file says itself. Default: [`None`].
    pub nodata: Option<f64>,
}

impl Default for PieceOptions {
    fn default() -> Self {
        Self { piece_triangle_count: 100_000, scratch: None, origin: None, z_scale: 1.0, nodata: None }
    }
}

impl PieceOptions {
    /// Sets [`piece_triangle_count`](Self::piece_triangle_count).
    #[must_use]
    pub fn with_piece_triangle_count(self, piece_triangle_count: u32) -> Self {
        Self { piece_triangle_count, ..self }
    }

    /// Sets [`scratch`](Self::scratch).
    #[must_use]
    pub fn with_scratch(self, scratch: PathBuf) -> Self {
        Self { scratch: Some(scratch), ..self }
    }

    /// Sets [`origin`](Self::origin).
    #[must_use]
    pub fn with_origin(self, origin: [f64; 3]) -> Self {
        Self { origin: Some(origin), ..self }
    }

    /// Sets [`z_scale`](Self::z_scale).
    #[must_use]
    pub fn with_z_scale(self, z_scale: f64) -> Self {
        Self { z_scale, ..self }
    }

    /// Sets [`nodata`](Self::nodata).
    #[must_use]
    pub fn with_nodata(self, nodata: Option<f64>) -> Self {
        Self { nodata, ..self }
    }

    /// Number of triangles per piece, never zero.
    pub(super) fn piece_size(&self) -> usize {
        self.piece_triangle_count.max(1) as usize
    }
}
