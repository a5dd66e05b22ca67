//! Terrains: rasters of heights as one mesh.
//!
//! All rasters must lie on one grid of samples, as tiles of a survey do; they may share their outermost samples
//! or not. The mesh has a vertex for each sample with a height: x to the east, y to the north, z up, in meters
//! (or in the units of a projection), from the lower left corner of all rasters.

mod geotiff;
mod hgt;
mod png_heights;
mod raster;

use std::path::{Path, PathBuf};

use serde_json::{Value, json};
use striata::mesh::IndexedMesh;

use super::{Piece, PieceGroup, PieceOptions, PieceSource, PieceSummary};
use crate::error::Place;
use crate::report::Warnings;
use crate::{ReadError, Warning};
use raster::{Raster, RasterPlacement};

/// Quads along each side of a piece.
const BLOCK: u64 = 224;
/// Largest number of samples that are read as one mesh, which takes 36 bytes for each.
const MAX_SAMPLES_IN_MEMORY: u64 = 1 << 27;
/// Length of a degree of latitude, in meters.
const METERS_PER_DEGREE: f64 = 111_319.490_793;
/// The grid of all rasters may have this many times their own samples; what lies between them is void.
const MAX_GRID_PER_SAMPLE: f64 = 10_000.0;
/// Rasters lie on one grid if their offsets differ by less than this share of a sample.
const MAX_SHIFT: f64 = 0.05;

/// Rasters of heights as one mesh, read in pieces.
pub struct Terrain {
    rasters: Vec<PlacedRaster>,
    /// Samples of all rasters together.
    size: [u64; 2],
    /// Distance of neighboring samples, mesh units.
    step: [f64; 2],
    z_scale: f64,
    nodata: Option<f64>,
    summary: PieceSummary,
}

struct PlacedRaster {
    raster: Box<dyn Raster>,
    /// Column and row of its upper left sample.
    at: [u64; 2],
}

/// Whether a file is a raster of heights, by its extension.
pub fn is_raster(path: &Path) -> bool {
    let extension = path.extension().unwrap_or_default().to_ascii_lowercase();
    ["tif", "tiff", "hgt", "png"].iter().any(|&raster| extension == raster)
}

fn open_raster(path: &Path, nodata: Option<f64>) -> Result<Box<dyn Raster>, ReadError> {
    let extension = path.extension().unwrap_or_default().to_ascii_lowercase();
    if extension == "hgt" {
        return Ok(Box::new(hgt::Hgt::open(path)?));
    }
    if extension == "png" {
        return Ok(Box::new(png_heights::PngHeights::open(path)?));
    }
    Ok(Box::new(geotiff::GeoTiff::open(path, nodata)?))
}

impl Terrain {
    /// Opens GeoTIFF, SRTM (`.hgt`) and gray PNG files, with the factor of heights and the sample without
    /// height that the options name.
    ///
    /// # Errors
    /// [`ReadError`] if a file cannot be read, or if the files do not lie on one grid.
    pub fn open(paths: &[PathBuf], options: &PieceOptions) -> Result<Self, ReadError> {
        let (z_scale, nodata) = (options.z_scale, options.nodata);
        let rasters: Result<Vec<_>, ReadError> = paths.iter().map(|path| open_raster(path, nodata)).collect();
        let rasters = rasters?;
        let Some(first) = rasters.first().map(|raster| *raster.placement()) else {
            return Err(misplaced("", "no raster was given"));
        };
        let (mut west, mut north) = (first.west, first.north);
        for raster in &rasters {
            let placement = raster.placement();
            check_same_grid(raster.name(), &first, placement)?;
            west = west.min(placement.west);
            north = north.max(placement.north);
        }
        check_distances(&rasters, [west, north])?;
        let mut size = [0; 2];
        let mut placed = Vec::new();
        for raster in rasters {
            let placement = raster.placement();
            let at = [(placement.west - west) / first.step[0], (north - placement.north) / first.step[1]];
            let at = at.map(|x| x.round() as u64);
            let [width, height] = raster.size();
            size = [size[0].max(at[0] + width), size[1].max(at[1] + height)];
            placed.push(PlacedRaster { raster, at });
        }
        let corner = [west, north - (size[1].max(1) - 1) as f64 * first.step[1]];
        let step = steps_in_units(&first, north, size[1]);
        let extent = [0, 1].map(|axis| (step[axis] * size[axis] as f64) as f32);
        if !extent.iter().all(|x| x.is_finite() && *x > 0.0) {
            let reason = format!("samples that are {} by {} apart make no surface", step[0], step[1]);
            return Err(misplaced(paths[0].to_string_lossy().as_ref(), &reason));
        }
        let names: Vec<String> = paths.iter().map(|path| path.display().to_string()).collect();
        let summary = PieceSummary {
            name: match names.len() {
                1 => names[0].clone(),
                count => format!("{} and {} more", names[0], count - 1),
            },
            groups: vec![PieceGroup::default()],
            triangle_count: 2 * size[0].saturating_sub(1) * size[1].saturating_sub(1),
            byte_count: paths.iter().filter_map(|path| std::fs::metadata(path).ok()).map(|m| m.len()).sum(),
            georeference: Some(georeference(&first, corner, step, z_scale)),
            ..PieceSummary::default()
        };
        Ok(Self { rasters: placed, size, step, z_scale, nodata, summary })
    }

    /// Number of pieces along each axis.
    fn blocks(&self) -> [u64; 2] {
        self.size.map(|count| count.saturating_sub(1).div_ceil(BLOCK))
    }

    /// Heights of a block of samples, row by row from the north; NaN where there are none.
    fn heights(&self, at: [u64; 2], [width, height]: [u64; 2]) -> Result<Vec<f32>, ReadError> {
        let mut heights = vec![f32::NAN; (width * height) as usize];
        for placed in &self.rasters {
            let size = placed.raster.size();
            let from = [at[0].max(placed.at[0]), at[1].max(placed.at[1])];
            let to =
                [(at[0] + width).min(placed.at[0] + size[0]), (at[1] + height).min(placed.at[1] + size[1])];
            if from[0] >= to[0] || from[1] >= to[1] {
                continue;
            }
            let count = [to[0] - from[0], to[1] - from[1]];
            let block = placed.raster.read([from[0] - placed.at[0], from[1] - placed.at[1]], count)?;
            for row in 0..count[1] {
                for column in 0..count[0] {
                    let target = (from[1] - at[1] + row) * width + from[0] - at[0] + column;
                    let value = block[(row * count[0] + column) as usize];
                    let is_void =
                        placed.raster.is_raw() && self.nodata.is_some_and(|named| named as f32 == value);
                    // The first file that knows a sample counts.
                    if heights[target as usize].is_nan() && !is_void {
                        heights[target as usize] = value;
                    }
                }
            }
        }
        Ok(heights)
    }
}

/// Distances of neighboring samples in mesh units: meters if the grid is in degrees.
fn steps_in_units(placement: &RasterPlacement, north: f64, height: u64) -> [f64; 2] {
    if !placement.is_geographic {
        return placement.step;
    }
    let middle = north - 0.5 * height as f64 * placement.step[1];
    let across = libm::cos(middle.to_radians());
    [placement.step[0] * METERS_PER_DEGREE * across, placement.step[1] * METERS_PER_DEGREE]
}

fn georeference(placement: &RasterPlacement, corner: [f64; 2], step: [f64; 2], z_scale: f64) -> Value {
    json!({
        "origin": corner,
        "sample_step": placement.step,
        "mesh_step": step,
        "is_geographic": placement.is_geographic,
        "epsg": placement.epsg,
        "z_scale": z_scale,
    })
}

fn misplaced(name: &str, reason: &str) -> ReadError {
    ReadError::Malformed { file: name.to_owned(), place: Place::File, reason: reason.to_owned() }
}

fn check_same_grid(name: &str, first: &RasterPlacement, other: &RasterPlacement) -> Result<(), ReadError> {
    if first.epsg != other.epsg || first.is_geographic != other.is_geographic {
        return Err(misplaced(name, "its coordinate system differs from that of the first raster"));
    }
    let is_same = |a: f64, b: f64| (a - b).abs() <= 1e-6 * a.abs();
    if !(0..2).all(|axis| is_same(first.step[axis], other.step[axis])) {
        return Err(misplaced(name, "its resolution differs from that of the first raster"));
    }
    let offsets = [(other.west - first.west) / first.step[0], (other.north - first.north) / first.step[1]];
    if offsets.iter().any(|x| (x - x.round()).abs() > MAX_SHIFT) {
        return Err(misplaced(name, "its samples lie between those of the first raster"));
    }
    Ok(())
}

/// Refuses rasters that are so far apart that the grid between them would be far larger than they are.
fn check_distances(rasters: &[Box<dyn Raster>], [west, north]: [f64; 2]) -> Result<(), ReadError> {
    let (mut grid, mut samples) = ([0.0f64; 2], 0.0);
    for raster in rasters {
        let (placement, size) = (raster.placement(), raster.size().map(|count| count as f64));
        let at = [placement.west - west, north - placement.north];
        grid = [0, 1].map(|axis| grid[axis].max(at[axis] / placement.step[axis] + size[axis]));
        samples += size[0] * size[1];
        let is_near = grid[0] * grid[1] <= MAX_GRID_PER_SAMPLE * samples.max(1e6);
        if !is_near {
            let reason = format!(
                "its place is too far from the other rasters: {} by {} samples in all",
                grid[0], grid[1]
            );
            return Err(misplaced(raster.name(), &reason));
        }
    }
    Ok(())
}

impl PieceSource for Terrain {
    fn summary(&self) -> &PieceSummary {
        &self.summary
    }

    fn piece_count(&self) -> u64 {
        let [columns, rows] = self.blocks();
        columns * rows
    }

    fn warnings(&self) -> Vec<Warning> {
        let mut all = Warnings::of_list(&self.summary.name, self.summary.warnings.clone());
        for PlacedRaster { raster, .. } in &self.rasters {
            for remark in raster.remarks() {
                all.push_for(raster.name(), Place::File, remark);
            }
        }
        all.into_list()
    }

    fn read_piece(&self, index: u64) -> Result<Piece, ReadError> {
        let columns = self.blocks()[0].max(1);
        let at = [index % columns * BLOCK, index / columns * BLOCK];
        let count = [0, 1].map(|axis| BLOCK.min(self.size[axis] - 1 - at[axis]) + 1);
        self.block(at, count)
    }
}

impl Terrain {
    /// Reads all samples as one mesh.
    ///
    /// # Errors
    /// [`ReadError`] if a raster is damaged, has no heights, or has more samples than a mesh in memory.
    pub fn mesh(&self) -> Result<IndexedMesh, ReadError> {
        let name = &self.summary.name;
        if self.size[0].saturating_mul(self.size[1]) > MAX_SAMPLES_IN_MEMORY {
            let [width, height] = self.size;
            let reason = format!(
                "{width} by {height} samples are too many for memory; build a paged file: striata build"
            );
            return Err(misplaced(name, &reason));
        }
        let block = self.block([0; 2], self.size)?;
        if block.triangles.is_empty() {
            return Err(misplaced(name, "no four neighboring samples have heights"));
        }
        let mut mesh = IndexedMesh::new(block.positions, block.triangles);
        mesh.appearance.georeference =
            self.summary.georeference.as_ref().map(Value::to_string).unwrap_or_default();
        Ok(mesh)
    }

    /// Reads a block of samples.
    fn block(&self, at: [u64; 2], count: [u64; 2]) -> Result<Piece, ReadError> {
        let heights = self.heights(at, count)?;
        let [width, height] = count;
        let is_too_high =
            |height: &f32| !height.is_nan() && !((f64::from(*height) * self.z_scale) as f32).is_finite();
        if let Some(place) = heights.iter().position(is_too_high) {
            let (column, row) = (at[0] + place as u64 % width, at[1] + place as u64 / width);
            let reason =
                format!("the sample in column {column}, row {row} is {}, which is no height", heights[place]);
            return Err(misplaced(&self.summary.name, &reason));
        }
        let mut number = vec![u32::MAX; heights.len()];
        let mut piece = Piece::default();
        let is_known = |i: u64| !heights[i as usize].is_nan();
        let mut vertex = |i: u64, positions: &mut Vec<[f32; 3]>| {
            if number[i as usize] == u32::MAX {
                number[i as usize] = positions.len() as u32;
                let (column, row) = (at[0] + i % width, at[1] + i / width);
                let x = column as f64 * self.step[0];
                let y = (self.size[1] - 1 - row) as f64 * self.step[1];
                let z = f64::from(heights[i as usize]) * self.z_scale;
                positions.push([x as f32, y as f32, z as f32]);
            }
            number[i as usize]
        };
        for row in 0..height - 1 {
            for column in 0..width - 1 {
                let nw = row * width + column;
                let [ne, sw, se] = [nw + 1, nw + width, nw + width + 1];
                // Counterclockwise seen from above. A quad with one unknown corner keeps the triangle without it.
                let triangles: &[[u64; 3]] = match [nw, ne, sw, se].map(is_known) {
                    [true, true, true, true] => &[[sw, se, ne], [sw, ne, nw]],
                    [false, true, true, true] => &[[sw, se, ne]],
                    [true, true, true, false] => &[[sw, ne, nw]],
                    [true, false, true, true] => &[[sw, se, nw]],
                    [true, true, false, true] => &[[se, ne, nw]],
                    _ => &[],
                };
                for corners in triangles {
                    let corners = corners.map(|i| vertex(i, &mut piece.positions));
                    piece.triangles.push(corners);
                }
            }
        }
        Ok(piece)
    }
}
