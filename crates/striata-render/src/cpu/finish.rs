//! How the triangles of a shot look: with materials, or in one color each.

use std::borrow::Cow;

use glam::{DVec3, Vec3};
use striata_scene::drawn::AlphaMode;

use super::materials::Materials;
use super::surface::{Surface, flat_normal, shares, sides};
use super::view::{DOWNSAMPLING, View};
use crate::Rgba;
use crate::camera::to_f64;
use crate::paint::Color;
use crate::shot::{Paint, STONE, Shot};

/// How the triangles look.
pub(crate) enum Finish<'a> {
    Materials(Box<Materials<'a>>),
    Plain(Plain<'a>),
}

/// One color for each triangle or vertex, in lights that move with the camera.
pub(crate) struct Plain<'a> {
    of_triangles: Option<Cow<'a, [Color]>>,
    of_vertices: Option<Vec<Vec3>>,
    light: f32,
    /// Opacity of edges.
    edges: f32,
}

impl<'a> Finish<'a> {
    /// Prepares the look of a shot; `edges` is the opacity of edges.
    pub(crate) fn new(shot: &'a Shot<'_>, edges: f32) -> Self {
        match shot.visible_look() {
            Some(look) => Self::Materials(Box::new(Materials::new(shot, look))),
            None => Self::Plain(Plain::new(shot, edges)),
        }
    }

    /// How a triangle covers what is behind it; [`None`] if it shows a back that is never drawn.
    pub(crate) fn alpha_mode(&self, surface: &Surface<'_>, triangle: usize) -> Option<AlphaMode> {
        let Self::Materials(materials) = self else { return Some(AlphaMode::Opaque) };
        let material = materials.of(triangle);
        (material.is_double_sided || surface.is_front(triangle)).then_some(material.alpha_mode)
    }

    /// Opacity below which the mask of a triangle hides it; [`None`] if it has none.
    pub(crate) fn cutoff(&self, triangle: usize) -> Option<f32> {
        let Self::Materials(materials) = self else { return None };
        match materials.of(triangle).alpha_mode {
            AlphaMode::Mask(cutoff) => Some(cutoff),
            _ => None,
        }
    }

    /// Opacity of the edges of a triangle at a sample.
    #[inline]
    pub(crate) fn line(&self, surface: &Surface<'_>, view: &View, triangle: usize, sample: [f64; 2]) -> f32 {
        match self {
            Self::Plain(plain) if plain.edges > 0.0 => {
                plain.line(&sides(surface.corners(triangle)), view.ray(sample), view.scale)
            }
            _ => 0.0,
        }
    }

    /// Returns opacity at a sample, to be compared with the cutoff of a mask.
    pub(crate) fn alpha(&self, surface: &Surface<'_>, view: &View, triangle: usize, sample: [f64; 2]) -> f32 {
        match self {
            Self::Materials(materials) => materials.point(surface, view, triangle, sample).base_color()[3],
            Self::Plain(_) => 1.0,
        }
    }

    /// Returns the light and the opacity of a triangle at a sample.
    pub(crate) fn shade(
        &self,
        surface: &Surface<'_>,
        view: &View,
        triangle: usize,
        sample: [f64; 2],
    ) -> Rgba {
        match self {
            Self::Materials(materials) => materials.point(surface, view, triangle, sample).shade(),
            Self::Plain(plain) => plain.shade(surface, view, triangle, sample),
        }
    }
}

/// A color as linear light.
pub(crate) fn light_of([r, g, b, _]: Color) -> Vec3 {
    Vec3::from([r, g, b].map(|byte| f32::from(byte) / 255.0))
}

impl<'a> Plain<'a> {
    fn new(shot: &'a Shot<'_>, edges: f32) -> Self {
        let of_mesh = |[r, g, b, _]: [f32; 4]| Vec3::new(r, g, b).min(Vec3::ONE);
        let of_vertices = match &shot.paint {
            Paint::Vertices(colors) => Some(colors.iter().copied().map(light_of).collect()),
            Paint::Surface => {
                shot.vertices.linear_colors().map(|colors| colors.into_iter().map(of_mesh).collect())
            }
            Paint::Triangles(_) => None,
        };
        Self { of_triangles: shot.colors_of_triangles(), of_vertices, light: shot.light(), edges }
    }

    fn shade(&self, surface: &Surface<'_>, view: &View, triangle: usize, sample: [f64; 2]) -> Rgba {
        let (corners, ray) = (surface.corners(triangle), view.ray(sample));
        let sides = sides(corners);
        let shares = shares(&sides, ray);
        let color = match (&self.of_triangles, &self.of_vertices) {
            (Some(colors), _) => light_of(colors[triangle]),
            (None, Some(colors)) => {
                let corners = surface.triangles[triangle].map(|v| colors[v as usize]);
                (0..3).map(|k| shares[k] * corners[k]).sum()
            }
            (None, None) => STONE.into(),
        };
        let flat = flat_normal(corners);
        let facing = (if flat.dot(corners[0]) > 0.0 { -flat } else { flat }).as_vec3();
        let smooth = surface.smooth_normal(triangle, shares);
        let normal = smooth.map_or(facing, |normal| view.turned(to_f64(normal.into())));
        // Both sides of a surface are lit: normals that face away are flipped.
        let normal = if normal.dot(facing) < 0.0 { -normal } else { normal };
        let to_eye = -ray.as_vec3().normalize_or_zero();
        color.lerp(lit(color, normal, to_eye), self.light).extend(1.0).to_array()
    }

    /// Opacity of the edges of a triangle where a ray meets it, measured like a GPU's `fwidth`.
    fn line(&self, sides: &[DVec3; 3], ray: DVec3, scale: f64) -> f32 {
        let distances = sides.map(|side| scale * side.dot(ray).abs() / (side.x.abs() + side.y.abs()));
        let samples = distances.into_iter().fold(f64::INFINITY, f64::min) as f32;
        // Lines are as wide as on a GPU, which downsamples by 2.
        let x = (2.0 / DOWNSAMPLING as f32 * samples - 0.5).clamp(0.0, 1.0);
        self.edges * (1.0 - x * x * (3.0 - 2.0 * x))
    }
}

/// Light of a surface without materials, as in `light.wgsl`.
fn lit(color: Vec3, normal: Vec3, to_eye: Vec3) -> Vec3 {
    let towards_key = Vec3::new(-0.55, 0.65, 0.75).normalize();
    let key = 0.78 * normal.dot(towards_key).max(0.0);
    let fill = 0.16 * normal.dot(Vec3::new(0.9, 0.1, 0.35).normalize()).max(0.0);
    let sky = 0.5 + 0.5 * normal.y;
    let half_way = (to_eye + towards_key).normalize_or_zero();
    let gloss = 0.06 * normal.dot(half_way).max(0.0).powi(40);
    color * (0.05 + 0.13 * sky + key + fill) + gloss
}
