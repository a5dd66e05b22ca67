//! The rasterizer, for machines without a GPU.
//!
//! A band of the picture is drawn in three passes. First, opaque triangles leave their depth and their
//! number at each sample, with [`DOWNSAMPLING`] by [`DOWNSAMPLING`] samples per pixel. Then, each triangle is
//! shaded once for all of its samples in a pixel, at their mean position: textures are filtered for pixels,
//! so more would not be visible. Edges are drawn at every sample. Last, transparent triangles are
//! blended over the samples from back to front. Bands are drawn in parallel. Colors, lights and edges match
//! those of `gpu`. Time O(samples covered + bands triangles).
//!
//! Large opaque triangles come first, from front to back, and skip tiles in which everything is nearer:
//! a hundred thousand sheets that hide each other would take minutes otherwise.

use std::ops::Range;

use striata_scene::drawn::AlphaMode;

use super::finish::{Finish, light_of};
use super::surface::Surface;
use super::view::{DOWNSAMPLING, ScreenPoint, View};
use crate::canvas::over;
use crate::scene_look::in_parallel;
use crate::shot::{LineTriangles, Shot};
use crate::{Camera, Canvas, Rgba};

/// No triangle at a sample.
const NONE: u32 = u32::MAX;

/// Number of bands that a picture is divided into at least, so that threads share the work evenly.
const LEAST_BANDS: usize = 16;

/// Columns and rows of the tiles whose farthest sample is known, and of larger tiles that consist of them.
const TILES: [[usize; 2]; 2] = [[16, 8], [128, 64]];

/// Triangles are large if their bounding boxes have this many samples or more.
const LARGE: f32 = 4096.0;

/// Draws a shot, at most some rows at a time; uncovered pixels are transparent.
pub(crate) fn draw(
    shot: &Shot<'_>,
    camera: &Camera,
    [width, height]: [usize; 2],
    max_band_rows: usize,
) -> Canvas {
    let view = View::new(shot, camera, [DOWNSAMPLING * width, DOWNSAMPLING * height]);
    let surface = Surface::new(shot, &view);
    let finish = Finish::new(shot, shot.edge_opacity(camera, height));
    let lines = LineTriangles::new(&shot.lines, camera, 0);
    let line = |(corners, color): (&[u32; 3], _)| {
        let corners = corners.map(|v| view.to_camera_space(lines.positions[v as usize]));
        (corners.map(|corner| view.project(corner)), light_of(color).extend(1.0).to_array())
    };
    let lines = lines.triangles.iter().zip(lines.colors.iter().copied()).map(line).collect();
    let triangles = ScreenTriangles::new(&surface, &finish, &view);
    let picture = Picture { triangles, lines, surface, finish, view };
    let band_rows = max_band_rows.min(height.div_ceil(LEAST_BANDS)).max(1);
    let starts: Vec<usize> = (0..height).step_by(band_rows).collect();
    let bands = in_parallel(starts.len(), &|band| {
        let rows = starts[band]..(starts[band] + band_rows).min(height);
        picture.draw_rows(width, rows)
    });
    let mut canvas = Canvas::filled(width, height, [0.0; 4]);
    for (first, band) in starts.into_iter().zip(bands) {
        canvas.blend(&band, 0, first);
    }
    canvas
}

/// Everything that bands share.
struct Picture<'a> {
    surface: Surface<'a>,
    finish: Finish<'a>,
    triangles: ScreenTriangles,
    lines: Vec<(Corners, Rgba)>,
    view: View,
}

/// Corners of a triangle on the screen.
type Corners = [ScreenPoint; 3];

/// Triangles in front of the eye, on the screen.
struct ScreenTriangles {
    /// The vertices.
    points: Vec<ScreenPoint>,
    /// Large opaque triangles between vertices, by number, from front to back.
    large: Vec<u32>,
    /// Other opaque triangles between vertices, by number.
    whole: Vec<u32>,
    /// Parts of opaque triangles that the near plane cuts, each with its number.
    cut: Vec<(u32, Corners)>,
    /// Transparent triangles, from back to front.
    blended: Vec<(u32, Corners)>,
}

impl ScreenTriangles {
    fn new(surface: &Surface<'_>, finish: &Finish<'_>, view: &View) -> Self {
        let points: Vec<_> = surface.positions.iter().map(|&position| view.project(position)).collect();
        let (mut large, mut whole, mut cut, mut blended) = (Vec::new(), Vec::new(), Vec::new(), Vec::new());
        for (index, triangle) in (0..).zip(surface.triangles) {
            let Some(alpha_mode) = finish.alpha_mode(surface, index as usize) else { continue };
            let corners = triangle.map(|v| surface.positions[v as usize]);
            let is_blended = alpha_mode == AlphaMode::Blend;
            if !is_blended && corners.iter().all(|&corner| view.is_inside(corner)) {
                let corners = triangle.map(|v| points[v as usize]);
                if box_area(&corners) >= LARGE {
                    large.push((nearest_of(&corners), index));
                } else {
                    whole.push(index);
                }
                continue;
            }
            let parts = view.clip(corners).map(|corners| (index, corners.map(|corner| view.project(corner))));
            if is_blended { blended.extend(parts) } else { cut.extend(parts) }
        }
        let nearness = |corners: &Corners| corners.iter().map(|corner| corner.inverse_depth).sum::<f32>();
        blended.sort_by(|(_, a), (_, b)| nearness(a).total_cmp(&nearness(b)));
        large.sort_by(|(a, _), (b, _)| b.total_cmp(a));
        let large = large.into_iter().map(|(_, index)| index).collect();
        Self { points, large, whole, cut, blended }
    }
}

/// A band of samples.
struct Band {
    canvas: Canvas,
    /// Inverse depths.
    nearest: Vec<f32>,
    rows: Range<usize>,
}

/// Depths and triangles of the samples of a band.
struct DepthBand<'b> {
    nearest: &'b mut [f32],
    numbers: &'b mut [u32],
    width: usize,
    start: usize,
}

impl Picture<'_> {
    /// Draws some rows of pixels.
    fn draw_rows(&self, width: usize, rows: Range<usize>) -> Canvas {
        let (width, rows) = (DOWNSAMPLING * width, DOWNSAMPLING * rows.start..DOWNSAMPLING * rows.end);
        let canvas = Canvas::filled(width, rows.len(), [0.0; 4]);
        let mut band = Band { canvas, nearest: vec![0.0; width * rows.len()], rows };
        self.draw_opaque(&mut band);
        for (index, corners) in &self.triangles.blended {
            self.blend(*index as usize, corners, &mut band);
        }
        for (corners, color) in &self.lines {
            let Band { canvas, nearest, rows } = &mut band;
            let Some(triangle) = ScreenTriangle::new(corners, rows, width) else { continue };
            triangle.visit([&(0..width), rows], |x, y, depth| {
                let nearest = &mut nearest[(y - rows.start) * width + x];
                if depth > *nearest {
                    *nearest = depth;
                    canvas.row_mut(y - rows.start)[x] = *color;
                }
            });
        }
        band.canvas.downsampled(DOWNSAMPLING)
    }

    fn draw_opaque(&self, band: &mut Band) {
        let width = band.canvas.width;
        let numbers = self.nearest_triangles(&mut band.nearest, &band.rows, width);
        for row in 0..band.rows.len() / DOWNSAMPLING {
            for column in 0..width / DOWNSAMPLING {
                self.shade_pixel(band, &numbers, [column, row]);
            }
        }
    }

    /// Finds the nearest opaque triangle at each sample of some rows, and its inverse depth.
    fn nearest_triangles(&self, nearest: &mut [f32], rows: &Range<usize>, width: usize) -> Vec<u32> {
        let mut numbers = vec![NONE; width * rows.len()];
        let mut depths = DepthBand { nearest, numbers: &mut numbers, width, start: rows.start };
        let ScreenTriangles { points, large, whole, cut, .. } = &self.triangles;
        let corners_of = |index: u32| self.surface.triangles[index as usize].map(|v| points[v as usize]);
        let [mut tiles, mut large_tiles] = TILES.map(|size| DepthTiles::new(size, width, rows));
        for &index in large {
            let Some(triangle) = ScreenTriangle::new(&corners_of(index), rows, width) else { continue };
            let planes = TrianglePlanes::new(&triangle);
            let box_of_triangle = [triangle.columns.clone(), triangle.rows.clone()];
            for outer in large_tiles.that_meet(&box_of_triangle) {
                if large_tiles.hides(outer, &planes) {
                    continue;
                }
                let [columns, of_rows] = large_tiles.samples(outer);
                let inner = [common(&columns, &triangle.columns), common(&of_rows, &triangle.rows)];
                let mut is_changed = false;
                for tile in tiles.that_meet(&inner) {
                    if tiles.hides(tile, &planes) {
                        continue;
                    }
                    let [columns, of_rows] = tiles.samples(tile);
                    if self.cover(&triangle, index, &mut depths, [&columns, &of_rows]) {
                        let row = |y: usize| &depths.nearest[(y - rows.start) * width..][columns.clone()];
                        tiles.farthest[tile] = of_rows.flat_map(row).copied().fold(f32::INFINITY, f32::min);
                        is_changed = true;
                    }
                }
                if is_changed {
                    let inside = tiles.that_meet(&[columns, of_rows]).map(|tile| tiles.farthest[tile]);
                    large_tiles.farthest[outer] = inside.fold(f32::INFINITY, f32::min);
                }
            }
        }
        let cut = cut.iter().map(|(index, corners)| (*index, *corners));
        for (index, corners) in whole.iter().map(|&index| (index, corners_of(index))).chain(cut) {
            if let Some(triangle) = ScreenTriangle::new(&corners, rows, width) {
                self.cover(&triangle, index, &mut depths, [&triangle.columns, &triangle.rows]);
            }
        }
        numbers
    }

    /// Notes an opaque triangle in those of its samples in some columns and rows that it is nearest in, and returns
    /// whether there are any.
    fn cover(
        &self,
        triangle: &ScreenTriangle,
        index: u32,
        band: &mut DepthBand<'_>,
        samples: [&Range<usize>; 2],
    ) -> bool {
        let cutoff = self.finish.cutoff(index as usize);
        let is_visible = |x: usize, y: usize, cutoff: f32| {
            let sample = [x as f64 + 0.5, y as f64 + 0.5];
            self.finish.alpha(&self.surface, &self.view, index as usize, sample) >= cutoff
        };
        let mut is_changed = false;
        triangle.visit(samples, |x, y, depth| {
            let at = (y - band.start) * band.width + x;
            // Of triangles at equal depth, the first one of the mesh is visible, in any order of drawing.
            let is_nearer =
                depth > band.nearest[at] || (depth == band.nearest[at] && index < band.numbers[at]);
            if is_nearer && cutoff.is_none_or(|cutoff| is_visible(x, y, cutoff)) {
                (band.nearest[at], band.numbers[at]) = (depth, index);
                is_changed = true;
            }
        });
        is_changed
    }

    /// Shades each triangle that is visible in a pixel of the picture.
    fn shade_pixel(&self, band: &mut Band, numbers: &[u32], [column, row]: [usize; 2]) {
        let width = band.canvas.width;
        let samples: [[usize; 2]; DOWNSAMPLING * DOWNSAMPLING] = std::array::from_fn(|i| {
            [DOWNSAMPLING * column + i % DOWNSAMPLING, DOWNSAMPLING * row + i / DOWNSAMPLING]
        });
        let number = samples.map(|[x, y]| numbers[y * width + x]);
        for first in 0..number.len() {
            if number[first] == NONE || number[..first].contains(&number[first]) {
                continue;
            }
            let (triangle, start) = (number[first] as usize, band.rows.start);
            let same = || (first..number.len()).filter(|&i| number[i] == number[first]);
            let middle = mean(same().map(|i| samples[i]), start);
            let [r, g, b, a] = self.finish.shade(&self.surface, &self.view, triangle, middle);
            for [x, y] in same().map(|i| samples[i]) {
                let sample = [x as f64 + 0.5, (y + start) as f64 + 0.5];
                let light = 1.0 - self.finish.line(&self.surface, &self.view, triangle, sample);
                band.canvas.row_mut(y)[x] = [light * r, light * g, light * b, a];
            }
        }
    }

    /// Blends a transparent triangle over what has been drawn.
    fn blend(&self, index: usize, corners: &Corners, band: &mut Band) {
        let (width, start) = (band.canvas.width, band.rows.start);
        let mut visible: Vec<[usize; 2]> = Vec::new();
        let Some(triangle) = ScreenTriangle::new(corners, &band.rows, width) else { return };
        triangle.visit([&(0..width), &band.rows], |x, y, depth| {
            if depth > band.nearest[(y - start) * width + x] {
                visible.push([x, y - start]);
            }
        });
        let pixel = |[x, y]: &[usize; 2]| [y / DOWNSAMPLING, x / DOWNSAMPLING];
        visible.sort_unstable_by_key(pixel);
        for samples in visible.chunk_by(|a, b| pixel(a) == pixel(b)) {
            let middle = mean(samples.iter().copied(), start);
            let color = self.finish.shade(&self.surface, &self.view, index, middle);
            for &[x, y] in samples {
                let below = &mut band.canvas.row_mut(y)[x];
                *below = over(color, *below);
            }
        }
    }
}

/// Mean position of samples of a band that starts at this row.
fn mean(samples: impl Iterator<Item = [usize; 2]>, start: usize) -> [f64; 2] {
    let (mut sum, mut count) = ([0.0; 2], 0.0);
    for [x, y] in samples {
        sum = [sum[0] + x as f64 + 0.5, sum[1] + (y + start) as f64 + 0.5];
        count += 1.0;
    }
    sum.map(|x| x / count)
}

/// Samples that both ranges have.
fn common(a: &Range<usize>, b: &Range<usize>) -> Range<usize> {
    a.start.max(b.start)..a.end.min(b.end)
}

/// Tiles of one size in a band.
struct DepthTiles {
    size: [usize; 2],
    per_row: usize,
    width: usize,
    rows: Range<usize>,
    /// Inverse depth of the farthest sample of each tile, or less.
    farthest: Vec<f32>,
}

impl DepthTiles {
    fn new(size: [usize; 2], width: usize, rows: &Range<usize>) -> Self {
        let per_row = width.div_ceil(size[0]);
        let farthest = vec![0.0; per_row * rows.len().div_ceil(size[1])];
        Self { size, per_row, width, rows: rows.clone(), farthest }
    }

    /// Returns the tiles that some columns and rows meet.
    fn that_meet(&self, [columns, rows]: &[Range<usize>; 2]) -> impl Iterator<Item = usize> + use<> {
        let across = columns.start / self.size[0]..columns.end.div_ceil(self.size[0]);
        let down = (rows.start - self.rows.start) / self.size[1]
            ..(rows.end - self.rows.start).div_ceil(self.size[1]);
        let per_row = self.per_row;
        down.flat_map(move |row| across.clone().map(move |column| row * per_row + column))
    }

    /// Returns the columns and rows of a tile.
    fn samples(&self, tile: usize) -> [Range<usize>; 2] {
        let x = tile % self.per_row * self.size[0];
        let y = self.rows.start + tile / self.per_row * self.size[1];
        [x..(x + self.size[0]).min(self.width), y..(y + self.size[1]).min(self.rows.end)]
    }

    /// Whether a triangle is certainly not visible in a tile, which it misses or in which every sample is nearer.
    fn hides(&self, tile: usize, planes: &TrianglePlanes) -> bool {
        let samples = self.samples(tile);
        planes.misses(&samples) || self.farthest[tile] > planes.nearest_in(&samples)
    }
}

/// Functions that are linear on the screen: a value at zero, and changes per column and row.
type ScreenPlane = [f64; 3];

/// Largest value of a function in some columns and rows.
fn largest([origin, dx, dy]: &ScreenPlane, [columns, rows]: &[Range<usize>; 2]) -> f64 {
    let x = if *dx > 0.0 { columns.end } else { columns.start } as f64;
    let y = if *dy > 0.0 { rows.end } else { rows.start } as f64;
    origin + dx * x + dy * y
}

/// Bounds of what a triangle covers.
struct TrianglePlanes {
    /// Functions of the sides, positive inside, and the limit of their errors in single precision.
    sides: [ScreenPlane; 3],
    side_error: f64,
    inverse_depth: ScreenPlane,
    /// Inverse depth of the nearest corner.
    nearest: f64,
    /// Limit of the errors of inverse depths in single precision, which are large in slivers.
    depth_error: f64,
}

impl TrianglePlanes {
    fn new(triangle: &ScreenTriangle) -> Self {
        let [a, b, c] = triangle.corners.map(|p| [p.x, p.y, p.inverse_depth].map(f64::from));
        let [ab, ac] = [b, c].map(|p| [p[0] - a[0], p[1] - a[1], p[2] - a[2]]);
        let area = ab[0] * ac[1] - ab[1] * ac[0];
        let (dx, dy) = ((ab[2] * ac[1] - ab[1] * ac[2]) / area, (ab[0] * ac[2] - ab[2] * ac[0]) / area);
        let side = |p: [f64; 3], q: [f64; 3]| {
            [p[0] * q[1] - p[1] * q[0], p[1] - q[1], q[0] - p[0]].map(|term| term * area.signum())
        };
        let nearest = f64::from(nearest_of(&triangle.corners));
        let side_error = 16.0 * f64::from(f32::EPSILON) * f64::from(box_area(&triangle.corners));
        Self {
            sides: [side(b, c), side(c, a), side(a, b)],
            side_error,
            inverse_depth: [a[2] - dx * a[0] - dy * a[1], dx, dy],
            nearest,
            depth_error: nearest * (1e-6 + side_error / area.abs()),
        }
    }

    /// Whether no sample of some columns and rows is inside.
    fn misses(&self, samples: &[Range<usize>; 2]) -> bool {
        self.sides.iter().any(|side| largest(side, samples) < -self.side_error)
    }

    /// Inverse depth that no sample of some columns and rows exceeds.
    fn nearest_in(&self, samples: &[Range<usize>; 2]) -> f32 {
        let bound = largest(&self.inverse_depth, samples);
        // Slopes of slivers may be anything.
        if bound.is_finite() { (bound.min(self.nearest) + self.depth_error) as f32 } else { f32::INFINITY }
    }
}

/// A triangle in a band.
struct ScreenTriangle {
    corners: Corners,
    area: f32,
    /// Whether the triangle has the samples on each of its sides. Of two triangles that share a side, exactly
    /// one has them: else, transparent ones would cover them twice.
    owns: [bool; 3],
    columns: Range<usize>,
    rows: Range<usize>,
    /// Limits of the columns by row, see [`limits_of`].
    left: [[f64; 2]; 3],
    right: [[f64; 2]; 3],
}

impl ScreenTriangle {
    /// Returns a triangle, unless it covers none of these rows.
    fn new(corners: &Corners, rows: &Range<usize>, width: usize) -> Option<Self> {
        let [a, b, c] = *corners;
        let rows = covered([a.y, b.y, c.y], rows);
        let area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
        let is_behind = corners.iter().any(|p| p.inverse_depth <= 0.0 || !p.inverse_depth.is_finite());
        if rows.is_empty() || is_behind || area == 0.0 || !area.is_finite() {
            return None;
        }
        let owns = sides(corners).map(|(p, q)| {
            let (dx, dy) = ((q.x - p.x) * area.signum(), (q.y - p.y) * area.signum());
            dy > 0.0 || (dy == 0.0 && dx > 0.0)
        });
        let columns = covered([a.x, b.x, c.x], &(0..width));
        let [left, right] = limits_of(corners, area);
        Some(Self { corners: *corners, area, owns, columns, rows, left, right })
    }

    /// Calls `visit` with each sample of some columns and rows inside the triangle, as column and row, and its
    /// inverse depth.
    fn visit(&self, [columns, rows]: [&Range<usize>; 2], mut visit: impl FnMut(usize, usize, f32)) {
        let [a, b, c] = self.corners;
        let columns = columns.start.max(self.columns.start)..columns.end.min(self.columns.end);
        for y in rows.start.max(self.rows.start)..rows.end.min(self.rows.end) {
            let py = y as f32 + 0.5;
            for x in self.span(py, &columns) {
                let px = x as f32 + 0.5;
                // Both triangles of a side compute the same number up to its sign.
                let weights = sides(&self.corners)
                    .map(|(p, q)| ((p.x - px) * (q.y - py) - (p.y - py) * (q.x - px)) * self.area.signum());
                if (0..3).all(|k| weights[k] > 0.0 || (weights[k] == 0.0 && self.owns[k])) {
                    let [wa, wb, wc] = weights.map(|weight| weight / self.area.abs());
                    visit(x, y, wa * a.inverse_depth + wb * b.inverse_depth + wc * c.inverse_depth);
                }
            }
        }
    }

    /// Columns in which samples of a row may be inside; all that are, rounding included.
    fn span(&self, py: f32, columns: &Range<usize>) -> Range<usize> {
        let py = f64::from(py);
        let at = |[origin, slope]: &[f64; 2]| origin + slope * py;
        let first = self.left.iter().map(at).fold(columns.start as f64, f64::max);
        let end = self.right.iter().map(at).fold(columns.end as f64, f64::min);
        // Casts of floats saturate.
        first as usize..end.ceil() as usize
    }
}

/// Columns that each side of a triangle allows, as limits at row zero and changes per row: from the first ones, to the
/// last ones. They include all samples that are inside by the rounded functions of the sides.
fn limits_of(corners: &Corners, area: f32) -> [[[f64; 2]; 3]; 2] {
    let (mut left, mut right) = ([[f64::NEG_INFINITY, 0.0]; 3], [[f64::INFINITY, 0.0]; 3]);
    let error = 8.0 * f64::from(f32::EPSILON) * f64::from(box_area(corners));
    for (k, (p, q)) in sides(corners).into_iter().enumerate() {
        let rows = f64::from(q.y) - f64::from(p.y);
        if rows == 0.0 {
            continue;
        }
        let slope = (f64::from(q.x) - f64::from(p.x)) / rows;
        let (origin, margin) = (f64::from(p.x) - slope * f64::from(p.y), 1.5 + error / rows.abs());
        // The function of the side falls with the column on one side of the triangle.
        if rows * f64::from(area) > 0.0 {
            right[k] = [origin + margin, slope];
        } else {
            left[k] = [origin - margin, slope];
        }
    }
    [left, right]
}

/// The sides of a triangle, each opposite to the corner of its number.
fn sides(&[a, b, c]: &Corners) -> [(ScreenPoint, ScreenPoint); 3] {
    [(b, c), (c, a), (a, b)]
}

/// Inverse depth of the nearest corner.
fn nearest_of(corners: &Corners) -> f32 {
    corners.iter().map(|corner| corner.inverse_depth).fold(0.0, f32::max)
}

/// Area of the bounding box of a triangle, in samples.
fn box_area(corners: &Corners) -> f32 {
    let extent = |of: fn(&ScreenPoint) -> f32| {
        let [a, b, c] = [0, 1, 2].map(|k| of(&corners[k]));
        a.max(b).max(c) - a.min(b).min(c)
    };
    extent(|p| p.x) * extent(|p| p.y)
}

/// Range of rows or columns whose sample centers may lie between three coordinates.
fn covered(corners: [f32; 3], samples: &Range<usize>) -> Range<usize> {
    let [first, end] = [samples.start, samples.end].map(|sample| sample as f32);
    let min = corners.into_iter().fold(f32::INFINITY, f32::min).floor().clamp(first, end);
    let max = corners.into_iter().fold(f32::NEG_INFINITY, f32::max).ceil().clamp(first, end);
    min as usize..max as usize
}

#[cfg(test)]
mod tests {
    use striata::mesh::{
        AttributeLayer, ColorSpace, IndexedMesh, Material as MeshMaterial, Semantic, TriangleGroup, shapes,
    };
    use striata_scene::drawn::{Material, Sampler, TextureUse, UvTransform};
    use striata_scene::textures::RgbaImage;

    use super::*;
    use crate::{Paint, SceneLook, Style};

    const CAMERA: Camera = Camera { eye: [0.0, 0.0, 4.0], look_at: [0.0; 3], up: [0.0, 1.0, 0.0], fov: 0.8 };
    const SIZE: usize = 60;

    const fn texture(image: usize) -> TextureUse {
        let sampler = Sampler {
            wrap: [striata_scene::drawn::Wrap::ClampToEdge; 2],
            is_smooth: false,
            has_mip_maps: false,
        };
        let transform = UvTransform([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]);
        TextureUse { image, sampler, uv_set: 0, transform }
    }

    /// A material that shows its color as it is.
    fn plain(base_color: [f32; 4]) -> Material {
        Material { base_color, is_unlit: true, ..Material::default() }
    }

    /// Squares that face the eye at these depths, one for each material, with texture coordinates that begin
    /// at the top left.
    fn squares(depths: &[f32]) -> IndexedMesh {
        let corners = |z: f32| [[-1.0, 1.0, z], [-1.0, -1.0, z], [1.0, -1.0, z], [1.0, 1.0, z]];
        let positions = depths.iter().flat_map(|&z| corners(z)).collect();
        let triangles =
            (0..depths.len() as u32).flat_map(|i| [[0, 1, 2], [0, 2, 3]].map(|t| t.map(|v| v + 4 * i)));
        let mut mesh = IndexedMesh::new(positions, triangles.collect());
        let uvs = depths.iter().flat_map(|_| [0.0, 0.0, 0.0, 1.0, 1.0, 1.0, 1.0, 0.0]).collect();
        mesh.layers.push(AttributeLayer::from_f32(Semantic::TexCoord(0), 2, uvs));
        mesh.appearance.materials = vec![MeshMaterial::default(); depths.len()];
        let group =
            |i: u32| TriangleGroup { first: 2 * i, count: 2, material: Some(i), ..TriangleGroup::default() };
        mesh.groups = (0..depths.len() as u32).map(group).collect();
        mesh
    }

    fn look(materials: Vec<Material>, images: Vec<RgbaImage>) -> SceneLook {
        SceneLook::new(materials, images.into_iter().map(Some).collect())
    }

    fn drawn(mesh: &IndexedMesh, look: &SceneLook, camera: &Camera) -> Canvas {
        let shot = Shot { look: Some(look), ..Shot::of(mesh, Paint::Surface, Style::SMOOTH) };
        draw(&shot, camera, [SIZE, SIZE], 1000)
    }

    fn at(canvas: &Canvas, x: usize, y: usize) -> [f32; 4] {
        canvas.pixels()[y * SIZE + x]
    }

    fn middle(canvas: &Canvas) -> [f32; 4] {
        at(canvas, SIZE / 2, SIZE / 2)
    }

    fn assert_near(found: [f32; 4], expected: [f32; 4]) {
        let distance = found.iter().zip(expected).map(|(a, b)| (a - b).abs()).fold(0.0, f32::max);
        assert!(distance < 0.01, "{found:?} instead of {expected:?}");
    }

    /// Red and green above, blue and white below; the right half is half transparent.
    fn four_colors() -> RgbaImage {
        let rgba = vec![255, 0, 0, 255, 0, 255, 0, 100, 0, 0, 255, 255, 255, 255, 255, 100];
        RgbaImage { width: 2, height: 2, rgba: rgba.into() }
    }

    #[test]
    fn images_are_upright_and_masks_cut_them() {
        let mut material = plain([1.0; 4]);
        material.base_color_texture = Some(texture(0));
        let (a, b) = (SIZE / 3, SIZE - SIZE / 3);
        let opaque = drawn(&squares(&[0.0]), &look(vec![material.clone()], vec![four_colors()]), &CAMERA);
        assert_near(at(&opaque, a, a), [1.0, 0.0, 0.0, 1.0]);
        assert_near(at(&opaque, b, a), [0.0, 1.0, 0.0, 1.0]);
        assert_near(at(&opaque, a, b), [0.0, 0.0, 1.0, 1.0]);
        assert_near(at(&opaque, b, b), [1.0; 4]);
        material.alpha_mode = AlphaMode::Mask(0.5);
        let masked = drawn(&squares(&[0.0]), &look(vec![material.clone()], vec![four_colors()]), &CAMERA);
        assert_near(at(&masked, a, b), [0.0, 0.0, 1.0, 1.0]);
        assert_near(at(&masked, b, a), [0.0; 4]);
        material.alpha_mode = AlphaMode::Blend;
        material.base_color[3] = 0.5;
        let blended = drawn(&squares(&[0.0]), &look(vec![material], vec![four_colors()]), &CAMERA);
        assert_near(at(&blended, a, a), [0.5, 0.0, 0.0, 0.5]);
    }

    #[test]
    fn texture_coordinates_are_correct_in_perspective() {
        // A floor that runs from below the eye into the distance, with a gradient along it.
        let mut mesh = squares(&[0.0]);
        mesh.positions = vec![[-1.0, -1.0, -20.0], [-1.0, -1.0, 5.0], [1.0, -1.0, 5.0], [1.0, -1.0, -20.0]];
        let gradient = (0..=255u8).flat_map(|y| [y, y, y, 255]).collect::<Vec<u8>>();
        let gradient = RgbaImage { width: 1, height: 256, rgba: gradient.into() };
        let mut material = plain([1.0; 4]);
        // As numbers rather than colors, through the image of occlusion, would need light: compare in sRGB.
        material.base_color_texture = Some(texture(0));
        let canvas = drawn(&mesh, &look(vec![material], vec![gradient]), &CAMERA);
        let slope = (0.4f32).tan();
        for y in SIZE * 2 / 3..SIZE {
            let down = slope * (2.0 * (y as f32 + 0.5) / SIZE as f32 - 1.0);
            let z = 4.0 - 1.0 / down;
            let byte = (256.0 * (z + 20.0) / 25.0).floor();
            let expected = crate::srgb::from_srgb(byte as u8);
            let found = at(&canvas, SIZE / 2, y)[0];
            assert!((found - expected).abs() < 0.03, "row {y}: {found} instead of {expected}");
        }
    }

    #[test]
    fn transparent_surfaces_are_sorted_and_hidden_by_opaque_ones() {
        let glass = |color: [f32; 3]| Material {
            alpha_mode: AlphaMode::Blend,
            ..plain([color[0], color[1], color[2], 0.5])
        };
        let materials = vec![glass([1.0, 0.0, 0.0]), plain([0.0, 0.0, 1.0, 1.0]), glass([0.0, 1.0, 0.0])];
        let canvas = drawn(&squares(&[0.6, 0.0, -1.0]), &look(materials.clone(), Vec::new()), &CAMERA);
        assert_near(middle(&canvas), [0.5, 0.0, 0.5, 1.0]);
        // Red is in front of green, although it comes first.
        let canvas = drawn(&squares(&[0.6, -1.0, 0.3]), &look(materials, Vec::new()), &CAMERA);
        assert_near(middle(&canvas), [0.5, 0.25, 0.25, 1.0]);
    }

    #[test]
    fn backs_are_visible_only_if_the_material_has_two_sides() {
        let behind = Camera { eye: [0.0, 0.0, -4.0], ..CAMERA };
        let mut material = plain([1.0, 0.5, 0.0, 1.0]);
        let of = |material: &Material| {
            middle(&drawn(&squares(&[0.0]), &look(vec![material.clone()], Vec::new()), &behind))
        };
        assert_near(of(&material), [0.0; 4]);
        material.is_double_sided = true;
        assert_near(of(&material), [1.0, 0.5, 0.0, 1.0]);
        material.is_unlit = false;
        assert!(of(&material)[0] > 0.02, "the back is lit");
    }

    #[test]
    fn vertex_colors_emission_and_normal_maps_have_an_effect() {
        let mut mesh = squares(&[0.0]);
        mesh.layers.push(AttributeLayer::from_f32(Semantic::Color(0), 3, [0.5, 1.0, 0.0].repeat(4)));
        mesh.appearance.color_space = ColorSpace::Linear;
        let canvas = drawn(&mesh, &look(vec![plain([1.0; 4])], Vec::new()), &CAMERA);
        assert_near(middle(&canvas), [0.5, 1.0, 0.0, 1.0]);
        let rough = Material { metallic: 0.0, base_color: [0.2, 0.2, 0.2, 1.0], ..Material::default() };
        let of = |material: &Material, images: Vec<RgbaImage>| {
            middle(&drawn(&squares(&[0.0]), &look(vec![material.clone()], images), &CAMERA))
        };
        let usual = of(&rough, Vec::new());
        let glowing = of(&Material { emissive: [0.0, 0.3, 0.0], ..rough.clone() }, Vec::new());
        assert_near(glowing, [usual[0], usual[1] + 0.3, usual[2], 1.0]);
        // A map that turns the surface to the left and up, toward the strongest lamp, or away from it.
        let map = |x: u8, y: u8| RgbaImage { width: 1, height: 1, rgba: vec![x, y, 200, 255].into() };
        let bent = Material { normal_texture: Some(texture(0)), ..rough };
        let [toward, away] = [map(60, 195), map(195, 60)].map(|map| of(&bent, vec![map])[1]);
        assert!(toward > 1.2 * away, "{toward} and {away}, {} without", usual[1]);
        assert!(toward > usual[1], "{toward}, {} without", usual[1]);
    }

    #[test]
    fn bands_leave_no_seams() {
        let mut mesh = squares(&[0.6, 0.0]);
        mesh.groups[0].material = Some(1);
        let glass = Material {
            alpha_mode: AlphaMode::Blend,
            base_color: [0.1, 0.2, 0.3, 0.4],
            ..Material::default()
        };
        let look = look(vec![glass, Material::default()], Vec::new());
        let shot = Shot { look: Some(&look), ..Shot::of(&mesh, Paint::Surface, Style::SMOOTH) };
        let torus = shapes::torus(24, 12, 1.0, 0.4);
        for shot in [shot, Shot::of(&torus, Paint::Surface, Style::FACETED)] {
            let whole = draw(&shot, &CAMERA, [40, 30], 30);
            for rows in [1, 7, 29] {
                assert_eq!(draw(&shot, &CAMERA, [40, 30], rows), whole, "{rows} rows");
            }
        }
    }

    #[test]
    fn many_large_triangles_that_hide_each_other_look_like_a_plain_loop() {
        // Sheets around an axis, nearly edge-on ones among them, and a square that cuts through all.
        let mut mesh = squares(&[0.1]);
        for i in 0..200 {
            let (sin, cos) = (i as f32 * 0.0314_f32).sin_cos();
            let first = mesh.positions.len() as u32;
            mesh.positions.extend([[0.0, -2.0, 0.0], [0.0, 2.0, 0.0], [1.5 * cos, 0.3, 1.5 * sin]]);
            mesh.triangles.push([first, first + 1, first + 2]);
        }
        mesh.layers.clear();
        mesh.groups.clear();
        let colors: Vec<[u8; 4]> =
            (0..mesh.triangles.len()).map(|i| [i as u8, (i >> 8) as u8, 0, 255]).collect();
        let shot = Shot::of(&mesh, Paint::Triangles(colors), Style::FLAT);
        let (width, height) = (240, 160);
        // No sample lies exactly on a side.
        let camera = Camera { eye: [0.013, 0.007, 4.0], ..CAMERA };
        let view = View::new(&shot, &camera, [DOWNSAMPLING * width, DOWNSAMPLING * height]);
        let surface = Surface::new(&shot, &view);
        let finish = Finish::new(&shot, 0.0);
        let triangles = ScreenTriangles::new(&surface, &finish, &view);
        assert!(triangles.large.len() > 150, "{} large triangles", triangles.large.len());
        let (width, height) = (DOWNSAMPLING * width, DOWNSAMPLING * height);
        let (mut nearest, mut expected) = (vec![0.0; width * height], vec![NONE; width * height]);
        for (index, triangle) in (0..).zip(surface.triangles) {
            let corners = triangle.map(|v| triangles.points[v as usize]);
            let [a, b, c] = corners;
            let area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
            for at in 0..width * height {
                let (x, y) = ((at % width) as f32 + 0.5, (at / width) as f32 + 0.5);
                let weight = |(p, q): (ScreenPoint, ScreenPoint)| {
                    ((p.x - x) * (q.y - y) - (p.y - y) * (q.x - x)) * area.signum()
                };
                let weights = sides(&corners).map(weight);
                let [wa, wb, wc] = weights.map(|weight| weight / area.abs());
                let depth = wa * a.inverse_depth + wb * b.inverse_depth + wc * c.inverse_depth;
                if weights.iter().all(|&weight| weight > 0.0) && depth > nearest[at] {
                    (nearest[at], expected[at]) = (depth, index);
                }
            }
        }
        let picture = Picture { triangles, lines: Vec::new(), surface, finish, view };
        for rows in [height, 21] {
            for start in (0..height).step_by(rows) {
                let band = start..(start + rows).min(height);
                let found = picture.nearest_triangles(&mut vec![0.0; width * band.len()], &band, width);
                let expected = &expected[start * width..][..found.len()];
                let count = (0..found.len()).filter(|&at| found[at] != expected[at]).count();
                assert_eq!(count, 0, "samples of rows {band:?} that differ");
            }
        }
    }

    /// Draws triangles with a color each.
    fn drawn_plain(positions: &[[f32; 3]], triangles: &[[u32; 3]], colors: &[[u8; 4]]) -> Canvas {
        let mesh = IndexedMesh::new(positions.to_vec(), triangles.to_vec());
        draw(&Shot::of(&mesh, Paint::Triangles(colors.to_vec()), Style::FLAT), &CAMERA, [21, 21], 10)
    }

    #[test]
    fn the_nearer_triangle_hides_the_other_in_any_order() {
        let corners = |z: f32| [[-1.0, -1.0, z], [1.0, -1.0, z], [0.0, 1.0, z]];
        let positions = [corners(0.0), corners(1.0)].concat();
        let (far, near) = ([0, 1, 2], [3, 4, 5]);
        let (red, blue) = ([255, 0, 0, 255], [0, 0, 255, 255]);
        let one = drawn_plain(&positions, &[far, near], &[red, blue]);
        assert_eq!(one, drawn_plain(&positions, &[near, far], &[blue, red]));
        let middle = one.pixels()[10 * 21 + 10];
        assert!(middle[2] > 2.0 * middle[0], "blue is in front: {middle:?}");
        assert_eq!(one.pixels()[0], [0.0; 4], "the corner is empty");
    }

    #[test]
    fn triangles_behind_the_eye_are_not_drawn_plain() {
        let positions = [[-1.0, -1.0, 9.0], [1.0, -1.0, 9.0], [0.0, 1.0, 9.0]];
        let canvas = drawn_plain(&positions, &[[0, 1, 2]], &[[255; 4]]);
        assert!(canvas.pixels().iter().all(|&pixel| pixel == [0.0; 4]));
    }
}
