//! Interface of all rasters of heights: their size, place and samples.

use crate::ReadError;
use crate::error::Place;

/// Coordinates of the samples of a raster.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct RasterPlacement {
    /// Coordinates of the upper left sample.
    pub west: f64,
    pub north: f64,
    /// Distance of neighboring samples along x and y, positive.
    pub step: [f64; 2],
    /// Whether coordinates are degrees.
    pub is_geographic: bool,
    /// EPSG code of the coordinate system, if the file names one.
    pub epsg: Option<u32>,
}

/// A raster of heights. Several threads may read it.
pub(super) trait Raster: Send + Sync {
    /// Name of the file.
    fn name(&self) -> &str;
    /// Columns and rows.
    fn size(&self) -> [u64; 2];
    /// Coordinates of the samples.
    fn placement(&self) -> &RasterPlacement;
    /// Whether heights are samples as they are; otherwise the raster itself leaves out samples without heights.
    fn is_raw(&self) -> bool {
        true
    }
    /// Remarks on the samples that have been read.
    fn remarks(&self) -> Vec<String> {
        Vec::new()
    }
    /// Reads a block of samples, row by row from the north; NaN for samples without a height.
    fn read(&self, at: [u64; 2], count: [u64; 2]) -> Result<Vec<f32>, ReadError>;
}

/// An error about a whole file.
pub(super) fn malformed(name: &str, reason: impl Into<String>) -> ReadError {
    ReadError::Malformed { file: name.to_owned(), place: Place::File, reason: reason.into() }
}
