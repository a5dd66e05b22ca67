//! A software rasterizer with a z-buffer, for machines without a GPU.
//!
//! Triangles are clipped at the near plane, projected to pixels, and rasterized over their bounding
//! rectangles with a depth test. Colors, lights and edges match those of `gpu`. Time O(pixels
//! covered), memory O(pixels of the picture) plus a band.

use std::ops::Range;

use glam::DVec3;
use striata::mesh::{IndexedMesh, Semantic};

use super::clip::{ClippedTriangle, Corner, clip};
use crate::camera::{Axes, Camera, to_f64};
use crate::paint::Color;
use crate::shot::{LineTriangles, Paint, STONE, Shot};
use crate::{Canvas, Rgba};

type Vec3 = [f32; 3];

/// Downsampling factor: each final pixel is the mean of a square of this many pixels per side.
pub(crate) const DOWNSAMPLING: usize = 3;

/// Draws a shot without materials, some rows at a time; uncovered pixels are transparent.
pub(crate) fn draw(
    shot: &Shot<'_>,
    camera: &Camera,
    [width, height]: [usize; 2],
    band_rows: usize,
) -> Canvas {
    let view = View::new(shot, camera, [DOWNSAMPLING * width, DOWNSAMPLING * height]);
    let triangles = ShotTriangles::new(shot, &view, shot.edge_opacity(camera, height));
    let lines = LineTriangles::new(&shot.lines, camera, 0);
    let mut canvas = Canvas::filled(width, height, [0.0; 4]);
    for first in (0..height).step_by(band_rows) {
        let rows = DOWNSAMPLING * first..DOWNSAMPLING * (first + band_rows).min(height);
        let mut band = Band::new(DOWNSAMPLING * width, rows);
        for index in 0..shot.triangles.len() {
            triangles.fill(index, &view, &mut band);
        }
        for (corners, &paint) in lines.triangles.iter().zip(&lines.colors) {
            let corners = corners.map(|v| view.to_camera_space(lines.positions[v as usize]));
            band.fill_line(&view, corners, paint);
        }
        canvas.blend(&band.canvas.downsampled(DOWNSAMPLING), 0, first);
    }
    canvas
}

/// Triangles of a shot, prepared for drawing into any band.
struct ShotTriangles<'a> {
    shot: &'a Shot<'a>,
    /// Vertex positions in camera space.
    camera_positions: Vec<Vec3>,
    /// Vertex normals; none for flat shading.
    normals: Option<Vec<Vec3>>,
    triangle_colors: Option<std::borrow::Cow<'a, [Color]>>,
    vertex_colors: Option<Vec<Vec3>>,
    style: SurfaceStyle,
}

impl<'a> ShotTriangles<'a> {
    fn new(shot: &'a Shot<'a>, view: &View, edges: f32) -> Self {
        let normals = if shot.is_flat { None } else { normals_of(shot.vertices) };
        let vertex_colors = match &shot.paint {
            Paint::Vertices(colors) => Some(colors.iter().copied().map(color).collect()),
            Paint::Surface => colors_of(shot.vertices),
            Paint::Triangles(_) => None,
        };
        let style = SurfaceStyle { has_normals: normals.is_some(), light: shot.light(), edges };
        let camera_positions = shot.vertices.positions.iter().map(|&p| view.to_camera_space(p)).collect();
        let triangle_colors = shot.colors_of_triangles();
        Self { shot, camera_positions, normals, triangle_colors, vertex_colors, style }
    }

    /// Clips and draws one triangle.
    fn fill(&self, index: usize, view: &View, band: &mut Band) {
        let corners = self.shot.triangles[index];
        let colors = match (&self.triangle_colors, &self.vertex_colors) {
            (Some(colors), _) => [color(colors[index]); 3],
            (None, Some(colors)) => corners.map(|v| colors[v as usize]),
            (None, None) => [STONE; 3],
        };
        let normal = |v: u32| {
            self.normals
                .as_ref()
                .map_or([0.0; 3], |normals| view.direction_to_camera_space(normals[v as usize]))
        };
        let corner = |k: usize| {
            let v = corners[k];
            Corner { position: self.camera_positions[v as usize], color: colors[k], normal: normal(v) }
        };
        for triangle in clip([corner(0), corner(1), corner(2)], view.near) {
            band.fill(view, &triangle, &self.style);
        }
    }
}

fn color([r, g, b, _]: Color) -> Vec3 {
    [r, g, b].map(|byte| f32::from(byte) / 255.0)
}

fn normals_of(mesh: &IndexedMesh) -> Option<Vec<Vec3>> {
    let layer = mesh.layer(&Semantic::Normal).filter(|layer| layer.component_count >= 3)?;
    Some((0..mesh.vertex_count()).map(|v| [0, 1, 2].map(|k| layer.get(v, k))).collect())
}

fn colors_of(mesh: &IndexedMesh) -> Option<Vec<Vec3>> {
    let colors = mesh.linear_colors()?.into_iter();
    Some(colors.map(|[r, g, b, _]| [r, g, b].map(|light| light.min(1.0))).collect())
}

/// A point on the screen: pixel coordinates and inverse depth.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ScreenPoint {
    pub x: f32,
    pub y: f32,
    pub inverse_depth: f32,
}

/// Camera as three axes and a scale.
pub(crate) struct View {
    pub axes: Axes,
    eye: DVec3,
    pub scale: f64,
    pub center: [f64; 2],
    /// Distance of the near plane.
    pub near: f32,
}

impl View {
    pub(crate) fn new(shot: &Shot<'_>, camera: &Camera, [width, height]: [usize; 2]) -> Self {
        let scale = height as f64 / 2.0 / (f64::from(camera.fov) / 2.0).tan();
        let (middle, radius) = shot.vertices.bounds().map_or((DVec3::ZERO, 1.0), |bounds| {
            ((to_f64(bounds.min) + to_f64(bounds.max)) / 2.0, bounds.diagonal() / 2.0)
        });
        Self {
            axes: camera.axes(),
            eye: camera.eye_64(),
            scale,
            center: [width as f64 / 2.0, height as f64 / 2.0],
            near: camera.near_plane(middle, radius) as f32,
        }
    }

    /// Transforms a point to camera space.
    pub(crate) fn to_camera_space(&self, point: Vec3) -> Vec3 {
        let p = to_f64(point) - self.eye;
        self.axes.map(|axis| axis.dot(p) as f32)
    }

    /// Projects a point in camera space to the screen.
    pub(crate) fn project(&self, point: Vec3) -> ScreenPoint {
        let [x, y, z] = point.map(f64::from);
        ScreenPoint {
            x: (self.center[0] - self.scale * x / z) as f32,
            y: (self.center[1] + self.scale * y / z) as f32,
            inverse_depth: (-1.0 / z) as f32,
        }
    }

    /// Transforms a direction to camera space: right, up, toward the eye.
    fn direction_to_camera_space(&self, n: Vec3) -> Vec3 {
        self.axes.map(|axis| axis.dot(to_f64(n)) as f32)
    }
}

/// Surface appearance shared by triangles.
#[derive(Clone, Copy)]
struct SurfaceStyle {
    has_normals: bool,
    light: f32,
    /// Opacity of edges.
    edges: f32,
}

/// A band of pixels with a depth buffer of inverse depths.
pub(crate) struct Band {
    pub canvas: Canvas,
    pub nearest: Vec<f32>,
    pub rows: Range<usize>,
}

impl Band {
    pub(crate) fn new(width: usize, rows: Range<usize>) -> Self {
        let canvas = Canvas::filled(width, rows.len(), [0.0; 4]);
        Self { canvas, nearest: vec![0.0; width * rows.len()], rows }
    }

    /// Draws a triangle of a line, in camera space and already clipped in front of the eye.
    pub(crate) fn fill_line(&mut self, view: &View, corners: [Vec3; 3], paint: Color) {
        let color = color(paint);
        let corners = corners.map(|position| Corner { position, color, normal: [0.0; 3] });
        let style = SurfaceStyle { has_normals: false, light: 0.0, edges: 0.0 };
        self.fill(view, &ClippedTriangle { corners, is_edge: [false; 3] }, &style);
    }

    /// Draws a triangle with depth test, at pixel centers.
    fn fill(&mut self, view: &View, triangle: &ClippedTriangle, style: &SurfaceStyle) {
        let screen = triangle.corners.map(|corner| view.project(corner.position));
        let [a, b, c] = screen;
        let area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
        let is_behind = screen.iter().any(|p| p.inverse_depth <= 0.0 || !p.inverse_depth.is_finite());
        if is_behind || area == 0.0 || !area.is_finite() {
            return;
        }
        let rows = covered([a.y, b.y, c.y], &self.rows);
        let columns = covered([a.x, b.x, c.x], &(0..self.canvas.width));
        if rows.is_empty() || columns.is_empty() {
            return;
        }
        let facing = facing(&triangle.corners);
        // Height of the triangle over each side in pixels, measured like a GPU's `fwidth`.
        let heights =
            [(b, c), (c, a), (a, b)].map(|(p, q)| area.abs() / ((p.x - q.x).abs() + (p.y - q.y).abs()));
        for y in rows {
            let py = y as f32 + 0.5;
            let row = y - self.rows.start;
            for x in columns.clone() {
                let px = x as f32 + 0.5;
                let wa = ((b.x - px) * (c.y - py) - (b.y - py) * (c.x - px)) / area;
                let wb = ((c.x - px) * (a.y - py) - (c.y - py) * (a.x - px)) / area;
                let on_screen = [wa, wb, 1.0 - wa - wb];
                if on_screen.iter().any(|&w| w < 0.0) {
                    continue;
                }
                let parts: Vec3 = std::array::from_fn(|k| on_screen[k] * screen[k].inverse_depth);
                let depth = parts[0] + parts[1] + parts[2];
                let nearest = &mut self.nearest[row * self.canvas.width + x];
                if depth > *nearest {
                    *nearest = depth;
                    let weights = parts.map(|part| part / depth);
                    let edges = (0..3).filter(|&k| triangle.is_edge[k]);
                    let edge_distance =
                        edges.map(|k| on_screen[k] * heights[k]).fold(f32::INFINITY, f32::min);
                    self.canvas.row_mut(row)[x] = style.at(&triangle.corners, weights, facing, edge_distance);
                }
            }
        }
    }
}

impl SurfaceStyle {
    /// Color of a point at a distance in pixels from the nearest edge.
    fn at(&self, corners: &[Corner; 3], weights: Vec3, facing: glam::Vec3, edge_distance: f32) -> Rgba {
        let mixed = |of: fn(&Corner) -> Vec3| -> glam::Vec3 {
            (0..3).map(|k| weights[k] * glam::Vec3::from(of(&corners[k]))).sum()
        };
        let color = mixed(|corner| corner.color);
        let normal =
            if self.has_normals { mixed(|corner| corner.normal).normalize_or_zero() } else { facing };
        // Both sides of a surface are lit: normals that face away are flipped.
        let normal = if normal.dot(facing) < 0.0 { -normal } else { normal };
        let to_eye = -mixed(|corner| corner.position).normalize_or_zero();
        let lit = lit(color, normal, to_eye);
        // Lines are as wide as on a GPU, which downsamples by 2.
        let line = self.edges * (1.0 - smooth_step(2.0 / DOWNSAMPLING as f32 * edge_distance - 0.5));
        (color.lerp(lit, self.light) * (1.0 - line)).extend(1.0).to_array()
    }
}

fn smooth_step(x: f32) -> f32 {
    let x = x.clamp(0.0, 1.0);
    x * x * (3.0 - 2.0 * x)
}

/// Normal of a triangle, flipped toward the eye.
fn facing(corners: &[Corner; 3]) -> glam::Vec3 {
    let [a, b, c] = corners.map(|corner| to_f64(corner.position));
    let normal = (b - a).cross(c - a).normalize_or_zero();
    (if normal.dot(a) > 0.0 { -normal } else { normal }).as_vec3()
}

/// Lighting of a surface, as in `light.wgsl`; the lights move with the camera.
fn lit(color: glam::Vec3, normal: glam::Vec3, to_eye: glam::Vec3) -> glam::Vec3 {
    let towards_key = glam::Vec3::new(-0.55, 0.65, 0.75).normalize();
    let key = 0.78 * normal.dot(towards_key).max(0.0);
    let fill = 0.16 * normal.dot(glam::Vec3::new(0.9, 0.1, 0.35).normalize()).max(0.0);
    let sky = 0.5 + 0.5 * normal.y;
    let half_way = (to_eye + towards_key).normalize_or_zero();
    let gloss = 0.06 * normal.dot(half_way).max(0.0).powi(40);
    color * (0.05 + 0.13 * sky + key + fill) + gloss
}

/// Range of rows or columns whose pixel centers may lie between three coordinates.
pub(crate) fn covered(corners: [f32; 3], pixels: &Range<usize>) -> Range<usize> {
    let [first, end] = [pixels.start, pixels.end].map(|pixel| pixel as f32);
    let min = corners.into_iter().fold(f32::INFINITY, f32::min).floor().clamp(first, end);
    let max = corners.into_iter().fold(f32::NEG_INFINITY, f32::max).ceil().clamp(first, end);
    min as usize..max as usize
}

#[cfg(test)]
mod tests {
    use std::borrow::Cow;

    use super::*;
    use crate::Style;

    const CAMERA: Camera = Camera { eye: [0.0, 0.0, 5.0], look_at: [0.0; 3], up: [0.0, 1.0, 0.0], fov: 0.8 };

    fn drawn(positions: &[Vec3], triangles: &[[u32; 3]], colors: &[Color]) -> Canvas {
        let mesh = IndexedMesh::new(positions.to_vec(), triangles.to_vec());
        let shot = Shot {
            vertices: &mesh,
            triangles: Cow::Borrowed(triangles),
            strips: None,
            paint: Paint::Triangles(colors.to_vec()),
            has_edges: false,
            is_flat: true,
            look: None,
            lines: Vec::new(),
        };
        draw(&shot, &CAMERA, [21, 21], 10)
    }

    #[test]
    fn the_nearer_triangle_hides_the_other_in_any_order() {
        let corners = |z: f32| [[-1.0, -1.0, z], [1.0, -1.0, z], [0.0, 1.0, z]];
        let positions = [corners(0.0), corners(1.0)].concat();
        let (far, near) = ([0, 1, 2], [3, 4, 5]);
        let (red, blue) = ([255, 0, 0, 255], [0, 0, 255, 255]);
        let one = drawn(&positions, &[far, near], &[red, blue]);
        assert_eq!(one, drawn(&positions, &[near, far], &[blue, red]));
        let middle = one.pixels()[10 * 21 + 10];
        assert!(middle[2] > 2.0 * middle[0], "blue is in front: {middle:?}");
        assert_eq!(one.pixels()[0], [0.0; 4], "the corner is empty");
    }

    #[test]
    fn bands_leave_no_seams() {
        let mesh = striata::mesh::shapes::torus(24, 12, 1.0, 0.4);
        let shot = Shot::of(&mesh, Paint::Surface, Style::FACETED);
        let whole = draw(&shot, &CAMERA, [40, 30], 30);
        for band_rows in [1, 7, 29] {
            assert_eq!(draw(&shot, &CAMERA, [40, 30], band_rows), whole, "{band_rows} rows per band");
        }
    }

    #[test]
    fn triangles_behind_the_eye_are_not_drawn() {
        let positions = [[-1.0, -1.0, 9.0], [1.0, -1.0, 9.0], [0.0, 1.0, 9.0]];
        let canvas = drawn(&positions, &[[0, 1, 2]], &[[255; 4]]);
        assert!(canvas.pixels().iter().all(|&pixel| pixel == [0.0; 4]));
    }
}
