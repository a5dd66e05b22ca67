//! The surface of a shot at the samples where it is seen, and its look without materials.

use std::borrow::Cow;

use glam::{DVec3, Vec3};
use striata::mesh::{AttributeLayer, IndexedMesh, Semantic};
use striata_scene::drawn::AlphaMode;

use super::materials::Materials;
use super::raster::DOWNSAMPLING;
use super::view::View;
use crate::Rgba;
use crate::camera::to_f64;
use crate::paint::Color;
use crate::shot::{Paint, STONE, Shot};

/// The triangles of a shot with the attributes of its vertices.
pub(crate) struct Surface<'a> {
    pub mesh: &'a IndexedMesh,
    pub triangles: &'a [[u32; 3]],
    /// Positions in camera space.
    pub positions: Vec<Vec3>,
    /// [`None`] for flat shading.
    pub normals: Option<&'a AttributeLayer>,
    finish: Finish<'a>,
}

/// How the triangles look.
enum Finish<'a> {
    Materials(Box<Materials<'a>>),
    Plain(Plain<'a>),
}

/// One color for each triangle or vertex, in lights that move with the camera.
struct Plain<'a> {
    of_triangles: Option<Cow<'a, [Color]>>,
    of_vertices: Option<Vec<Vec3>>,
    light: f32,
    /// Opacity of edges.
    edges: f32,
}

impl<'a> Surface<'a> {
    /// Prepares the surface of a shot for a picture with this number of samples per column.
    pub(crate) fn new(shot: &'a Shot<'_>, view: &View, edges: f32) -> Self {
        let mesh = shot.vertices;
        let normals = mesh.layer(&Semantic::Normal).filter(|layer| layer.component_count >= 3);
        Self {
            mesh,
            triangles: &shot.triangles,
            positions: mesh.positions.iter().map(|&p| view.to_camera_space(p)).collect(),
            normals: normals.filter(|_| !shot.is_flat),
            finish: match shot.visible_look() {
                Some(look) => Finish::Materials(Box::new(Materials::new(shot, look))),
                None => Finish::Plain(Plain::new(shot, edges)),
            },
        }
    }

    /// How a triangle covers what is behind it; [`None`] if it shows a back that is never drawn.
    pub(crate) fn alpha_mode(&self, triangle: usize) -> Option<AlphaMode> {
        let Finish::Materials(materials) = &self.finish else { return Some(AlphaMode::Opaque) };
        let material = materials.of(triangle);
        (material.is_double_sided || self.is_front(triangle)).then_some(material.alpha_mode)
    }

    /// Opacity below which the mask of a triangle hides it; [`None`] if it has none.
    pub(crate) fn cutoff(&self, triangle: usize) -> Option<f32> {
        let Finish::Materials(materials) = &self.finish else { return None };
        match materials.of(triangle).alpha_mode {
            AlphaMode::Mask(cutoff) => Some(cutoff),
            _ => None,
        }
    }

    /// Whether each sample is shaded by itself, rather than all those of a triangle in a pixel together.
    pub(crate) fn has_details(&self) -> bool {
        matches!(&self.finish, Finish::Plain(plain) if plain.edges > 0.0)
    }

    /// Returns opacity at a sample, to be compared with the cutoff of a mask.
    pub(crate) fn alpha(&self, triangle: usize, view: &View, sample: [f64; 2]) -> f32 {
        match &self.finish {
            Finish::Materials(materials) => materials.point(self, view, triangle, sample).base_color()[3],
            Finish::Plain(_) => 1.0,
        }
    }

    /// Returns the light and the opacity of a triangle at a sample.
    pub(crate) fn shade(&self, triangle: usize, view: &View, sample: [f64; 2]) -> Rgba {
        match &self.finish {
            Finish::Materials(materials) => materials.point(self, view, triangle, sample).shade(),
            Finish::Plain(plain) => plain.shade(self, view, triangle, sample),
        }
    }

    /// Whether a triangle shows its front to the eye.
    pub(crate) fn is_front(&self, triangle: usize) -> bool {
        let [a, b, c] = self.corners(triangle);
        b.cross(c).dot(a) < 0.0
    }

    /// The corners of a triangle in camera space.
    pub(crate) fn corners(&self, triangle: usize) -> [DVec3; 3] {
        self.triangles[triangle].map(|v| self.positions[v as usize].as_dvec3())
    }

    /// Mean of an attribute of the corners; components that the layer lacks are 1.
    pub(crate) fn attribute<const N: usize>(
        &self,
        layer: &AttributeLayer,
        triangle: usize,
        shares: [f32; 3],
    ) -> [f32; N] {
        let corners = self.triangles[triangle];
        let width = usize::from(layer.component_count);
        std::array::from_fn(|k| {
            if k >= width {
                return 1.0;
            }
            (0..3).map(|i| shares[i] * layer.get(corners[i] as usize, k)).sum()
        })
    }

    /// The mean of the normals of the corners, if it has a direction.
    pub(crate) fn smooth_normal(&self, triangle: usize, shares: [f32; 3]) -> Option<Vec3> {
        Vec3::from(self.attribute::<3>(self.normals?, triangle, shares)).try_normalize()
    }
}

/// The sides of a triangle as planes through the eye: the product with a ray is 0 on the side, and the share of
/// the opposite corner up to a common factor elsewhere. This is exact in perspective, also for triangles that
/// reach behind the eye.
pub(crate) fn sides([a, b, c]: [DVec3; 3]) -> [DVec3; 3] {
    [b.cross(c), c.cross(a), a.cross(b)]
}

/// Shares of the corners where a ray meets a triangle with these sides.
pub(crate) fn shares(sides: &[DVec3; 3], ray: DVec3) -> [f32; 3] {
    let volumes = sides.map(|side| side.dot(ray));
    let total = volumes[0] + volumes[1] + volumes[2];
    let shares = volumes.map(|volume| (volume / total) as f32);
    if shares.iter().all(|share| share.is_finite()) { shares } else { [1.0, 0.0, 0.0] }
}

/// Normal of a triangle in camera space.
pub(crate) fn flat_normal([a, b, c]: [DVec3; 3]) -> DVec3 {
    (b - a).cross(c - a).normalize_or_zero()
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
        let lit = color.lerp(lit(color, normal, -ray.as_vec3().normalize_or_zero()), self.light);
        (lit * (1.0 - self.line(&sides, ray, view.scale))).extend(1.0).to_array()
    }

    /// Opacity of the edges of a triangle where a ray meets it, measured like a GPU's `fwidth`.
    fn line(&self, sides: &[DVec3; 3], ray: DVec3, scale: f64) -> f32 {
        if self.edges == 0.0 {
            return 0.0;
        }
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
