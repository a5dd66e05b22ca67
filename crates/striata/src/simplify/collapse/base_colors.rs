//! Cost of what a collapse changes in the colors that textures show.
//!
//! Points of the triangles around a removed vertex are compared with the points of the fan that replace them,
//! seen along the mean normal. Each point stands for a third of its triangle, and shows the texture averaged
//! over as many pixels. A difference of colors counts over that area like a squared distance.
//!
//! ```text
//!       b                 b
//!      /|\               / \        x  points of the triangle (v, a, b)
//!     / |x\             /  x\       the same points of the fan around u, with
//!    /  v--x a   ->    u ---x a     texture coordinates interpolated there
//! ```

use glam::{Vec2, Vec3, Vec4};

use crate::mesh::{AttributeLayer, Semantic, Welded};
use crate::simplify::base_color::BaseColor;

/// Barycentric coordinates of the points that are compared; they integrate quadratic functions exactly.
const POINTS: [[f32; 3]; 3] =
    [[2.0 / 3.0, 1.0 / 6.0, 1.0 / 6.0], [1.0 / 6.0, 2.0 / 3.0, 1.0 / 6.0], [1.0 / 6.0, 1.0 / 6.0, 2.0 / 3.0]];
/// Multiple of the weight of texture coordinates for a difference of one channel from 0 to 1. With 1, the
/// colors of palettes still mix; with 10, the shape suffers without a gain in color.
const COLOR_FACTOR: f32 = 4.0;
/// Material of vertices whose color is not known.
const UNKNOWN: u32 = u32::MAX;

/// A triangle with the vertices that determine its colors, relative to the removed vertex.
#[derive(Clone, Copy, Debug)]
pub(in crate::simplify) struct ShownTriangle {
    pub vertices: [u32; 3],
    pub points: [Vec3; 3],
}

/// A point of the texture of the material that a vertex has.
#[derive(Clone, Copy)]
struct TexturePoint {
    vertex: u32,
    /// Texture coordinates.
    at: [f32; 2],
}

impl ShownTriangle {
    fn doubled_normal(&self) -> Vec3 {
        let [a, b, c] = self.points;
        (b - a).cross(c - a)
    }
}

/// Base colors of the materials of a mesh, and the texture coordinates that show them.
#[derive(Debug)]
pub(in crate::simplify) struct BaseColors {
    materials: Vec<Option<BaseColor>>,
    factors: Vec<Vec4>,
    /// Material of each vertex, or [`UNKNOWN`].
    material_of: Vec<u32>,
    /// Transformed texture coordinates of each vertex.
    texcoords: Vec<[f32; 2]>,
    /// Color around each vertex, averaged over the size of its triangles.
    colors: Vec<Vec4>,
    /// Squared distance that a difference of 1 counts for.
    weight_squared: f32,
}

impl BaseColors {
    /// Reads the texture coordinates of a mesh; [`None`] if no vertex shows a known texture. `material_of`
    /// returns the material of a vertex, `weight` is that of texture coordinates.
    pub(in crate::simplify) fn new(
        welded: &Welded,
        materials: &[Option<BaseColor>],
        material_of: impl Fn(usize) -> Option<u32>,
        weight: f32,
    ) -> Option<Self> {
        let mesh = &welded.mesh;
        let layer = |set: u8| mesh.layers.iter().find(|layer| is_set(layer, set));
        let layers: Vec<_> =
            materials.iter().map(|m| m.as_ref().and_then(|m| layer(m.texcoord_set))).collect();
        if weight <= 0.0 || materials.iter().all(Option::is_none) {
            return None;
        }
        let vertex_count = mesh.vertex_count();
        let mut found = Self {
            materials: materials.to_vec(),
            factors: materials
                .iter()
                .map(|m| m.as_ref().map_or(Vec4::ONE, BaseColor::shown_factor))
                .collect(),
            material_of: vec![UNKNOWN; vertex_count],
            texcoords: vec![[0.0; 2]; vertex_count],
            colors: vec![Vec4::ZERO; vertex_count],
            weight_squared: (COLOR_FACTOR * weight).powi(2),
        };
        for vertex in 0..vertex_count {
            let Some(material) = material_of(vertex) else { continue };
            let Some(Some(color)) = materials.get(material as usize) else { continue };
            match layers[material as usize] {
                Some(layer) => {
                    found.texcoords[vertex] = color.transformed([0, 1].map(|axis| layer.get(vertex, axis)));
                }
                // Texture coordinates that are missing do not matter to a plain color.
                None if color.pixel_count() > 1.0 => continue,
                None => {}
            }
            found.material_of[vertex] = material;
        }
        found.load_colors(&mesh.triangles);
        found.material_of.iter().any(|&material| material != UNKNOWN).then_some(found)
    }

    /// Returns the colors of some of the vertices, in this order.
    pub(super) fn gathered(&self, vertices: &[u32]) -> Self {
        Self {
            materials: self.materials.clone(),
            factors: self.factors.clone(),
            material_of: gathered(&self.material_of, vertices),
            texcoords: gathered(&self.texcoords, vertices),
            colors: gathered(&self.colors, vertices),
            ..*self
        }
    }

    /// Computes the color around each vertex.
    fn load_colors(&mut self, triangles: &[[u32; 3]]) {
        let mut areas = vec![(0.0f32, 0.0f32); self.colors.len()];
        for &triangle in triangles {
            let area = self.pixel_area(triangle);
            for vertex in triangle {
                let (sum, count) = &mut areas[vertex as usize];
                (*sum, *count) = (*sum + area, *count + 1.0);
            }
        }
        for (vertex, (sum, count)) in areas.into_iter().enumerate() {
            let color = self.color(vertex as u32, self.texcoords[vertex], sum / f32::max(count, 1.0));
            self.colors[vertex] = color.unwrap_or_default();
        }
    }

    /// Area of a triangle in the texture, in pixels of its largest level.
    fn pixel_area(&self, triangle: [u32; 3]) -> f32 {
        let material = self.material_of[triangle[0] as usize];
        let Some(Some(color)) = self.materials.get(material as usize) else { return 0.0 };
        let [a, b, c] = triangle.map(|vertex| self.texcoords[vertex as usize]);
        let doubled = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
        0.5 * doubled.abs() * color.pixel_count()
    }

    /// Color of a vertex's material at texture coordinates.
    fn color(&self, vertex: u32, texcoords: [f32; 2], pixel_area: f32) -> Option<Vec4> {
        let material = self.material_of[vertex as usize] as usize;
        let color = self.materials.get(material)?.as_ref()?;
        Some(self.factors[material] * color.at(texcoords, pixel_area))
    }

    /// Texture coordinates at a point of a triangle.
    #[inline]
    fn texcoords_in(&self, vertices: [u32; 3], weights: [f32; 3]) -> [f32; 2] {
        let [a, b, c] = vertices.map(|vertex| self.texcoords[vertex as usize]);
        [0, 1].map(|axis| weights[0] * a[axis] + weights[1] * b[axis] + weights[2] * c[axis])
    }

    /// Whether two points show the same texture at nearly the same place.
    #[inline]
    fn is_close(&self, own: TexturePoint, other: TexturePoint, pixel_area: f32) -> bool {
        let material = self.material_of[own.vertex as usize];
        let color = self.materials.get(material as usize).and_then(Option::as_ref);
        material == self.material_of[other.vertex as usize]
            && color.is_some_and(|color| color.is_close(own.at, other.at, pixel_area))
    }

    /// Whether the color of a vertex is known and depends on its texture coordinates.
    pub(in crate::simplify) fn is_textured(&self, vertex: u32) -> bool {
        let material = self.materials.get(self.material_of[vertex as usize] as usize);
        material.is_some_and(|material| material.as_ref().is_some_and(|color| color.pixel_count() > 1.0))
    }

    /// Whether the color of a vertex is known.
    fn is_known(&self, vertex: u32) -> bool {
        self.material_of[vertex as usize] != UNKNOWN
    }

    /// Squared difference between the colors of two vertices; 0 if one is not known.
    pub(in crate::simplify) fn difference_squared(&self, a: u32, b: u32) -> f32 {
        match self.is_known(a) && self.is_known(b) {
            true => self.weight_squared * self.colors[a as usize].distance_squared(self.colors[b as usize]),
            false => 0.0,
        }
    }

    /// Squared difference between two points on triangles, each given by its corners and barycentric
    /// coordinates; 0 if one color is not known.
    pub(in crate::simplify) fn points_difference_squared(
        &self,
        corners: [u32; 3],
        weights: [f32; 3],
        other_corners: [u32; 3],
        other_weights: [f32; 3],
    ) -> f32 {
        let at = |corners: [u32; 3], weights| {
            self.color(corners[0], self.texcoords_in(corners, weights), self.pixel_area(corners))
        };
        match (at(corners, weights), at(other_corners, other_weights)) {
            (Some(a), Some(b)) => self.weight_squared * a.distance_squared(b),
            _ => 0.0,
        }
    }

    /// Cost of replacing triangles: the integral of the squared difference of their colors.
    pub(in crate::simplify) fn cost(&self, old: &[ShownTriangle], new: &[ShownTriangle]) -> f32 {
        if self.is_uniform(old, new) {
            return 0.0;
        }
        let normal: Vec3 = old.iter().map(ShownTriangle::doubled_normal).sum();
        let plane = <[Vec3; 2]>::from(normal.normalize_or(Vec3::Z).any_orthonormal_pair());
        let fan: Vec<FlatTriangle> =
            new.iter().filter_map(|triangle| FlatTriangle::new(self, triangle, plane)).collect();
        if fan.is_empty() {
            return 0.0;
        }
        let mut sum = 0.0;
        for triangle in old {
            let area = triangle.doubled_normal().length();
            let pixel_area = self.pixel_area(triangle.vertices) / POINTS.len() as f32;
            let corners = triangle.points.map(|point| flat(point, plane));
            let is_turned = (corners[1] - corners[0]).perp_dot(corners[2] - corners[0]) < 0.0;
            for weights in POINTS {
                let at = corners[0] * weights[0] + corners[1] * weights[1] + corners[2] * weights[2];
                let (shown, shown_weights) = point_of(&fan, at, is_turned);
                let before = self.texcoords_in(triangle.vertices, weights);
                let after = self.texcoords_in(shown.vertices, shown_weights);
                let [own, other] = [triangle.vertices[0], shown.vertices[0]];
                let is_close = self.is_close(
                    TexturePoint { vertex: own, at: before },
                    TexturePoint { vertex: other, at: after },
                    pixel_area,
                );
                if is_close {
                    continue;
                }
                // A triangle that is stretched over an atlas would average out at its own size.
                let mut shown_area = shown.pixels_per_area * area / POINTS.len() as f32;
                if self.material_of[own as usize] == self.material_of[other as usize] {
                    shown_area = shown_area.min(pixel_area);
                }
                let colors = (self.color(own, before, pixel_area), self.color(other, after, shown_area));
                if let (Some(before), Some(after)) = colors {
                    sum += area * before.distance_squared(after);
                }
            }
        }
        0.5 / POINTS.len() as f32 * self.weight_squared * sum
    }

    /// Whether all corners show one point of one texture, as those of one patch of a palette do.
    fn is_uniform(&self, old: &[ShownTriangle], new: &[ShownTriangle]) -> bool {
        let Some(first) = old.first().map(|triangle| triangle.vertices[0] as usize) else { return true };
        let is_same = |vertex: u32| {
            self.texcoords[vertex as usize] == self.texcoords[first]
                && self.material_of[vertex as usize] == self.material_of[first]
        };
        old.iter().chain(new).all(|triangle| triangle.vertices.into_iter().all(is_same))
    }
}

/// Returns the rows of some vertices, or none if there are none.
pub(super) fn gathered<T: Copy>(rows: &[T], vertices: &[u32]) -> Vec<T> {
    if rows.is_empty() { Vec::new() } else { vertices.iter().map(|&v| rows[v as usize]).collect() }
}

/// A triangle seen along a direction.
struct FlatTriangle {
    vertices: [u32; 3],
    first: Vec2,
    /// Rows that map a point relative to the first corner to the weights of the two others.
    rows: [Vec2; 2],
    is_turned: bool,
    /// Pixels of the texture per doubled area.
    pixels_per_area: f32,
}

impl FlatTriangle {
    /// Projects a triangle; [`None`] if it is seen from its edge.
    fn new(colors: &BaseColors, triangle: &ShownTriangle, plane: [Vec3; 2]) -> Option<Self> {
        let [first, b, c] = triangle.points.map(|point| flat(point, plane));
        let (b, c) = (b - first, c - first);
        let doubled = b.perp_dot(c);
        let inverse = 1.0 / doubled;
        let vertices = triangle.vertices;
        inverse.is_finite().then(|| Self {
            vertices,
            first,
            rows: [inverse * Vec2::new(c.y, -c.x), inverse * Vec2::new(-b.y, b.x)],
            is_turned: doubled < 0.0,
            pixels_per_area: colors.pixel_area(vertices)
                / triangle.doubled_normal().length().max(f32::MIN_POSITIVE),
        })
    }

    /// Barycentric coordinates of a point, which may lie outside.
    #[inline]
    fn weights(&self, at: Vec2) -> [f32; 3] {
        let [b, c] = self.rows.map(|row| row.dot(at - self.first));
        [1.0 - b - c, b, c]
    }
}

/// Position on a plane that is given by two orthogonal directions.
#[inline]
fn flat(point: Vec3, [x, y]: [Vec3; 2]) -> Vec2 {
    Vec2::new(point.dot(x), point.dot(y))
}

/// Returns the triangle in which a point lies, or the one that it is nearest to, measured by the triangle's
/// size, and the barycentric coordinates there. Triangles that show the same side come first: those of thin
/// plates overlap.
fn point_of(fan: &[FlatTriangle], at: Vec2, is_turned: bool) -> (&FlatTriangle, [f32; 3]) {
    /// More than any point of the star is outside of a triangle that is not a needle.
    const OTHER_SIDE: f32 = 1e3;
    let mut best = (&fan[0], [1.0, 0.0, 0.0]);
    let mut most = f32::NEG_INFINITY;
    for triangle in fan {
        let weights = triangle.weights(at);
        let depth = weights[0].min(weights[1]).min(weights[2]);
        let depth = if triangle.is_turned == is_turned { depth } else { depth - OTHER_SIDE };
        if depth > most {
            (best, most) = ((triangle, weights), depth);
        }
    }
    let inside = best.1.map(|weight| weight.max(0.0));
    let sum: f32 = inside.iter().sum();
    (best.0, inside.map(|weight| weight / sum))
}

fn is_set(layer: &AttributeLayer, set: u8) -> bool {
    layer.semantic == Semantic::TexCoord(set) && layer.component_count >= 2
}
