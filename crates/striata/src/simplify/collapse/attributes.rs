//! Attribute cost of a collapse: how far the removed vertex's attributes are from those of the new fan.
//!
//! Weighted attributes are treated as further coordinates of the position (as in [Hop99], which uses
//! quadrics for them). The nearest point of the fan is found in space, its attributes by interpolation,
//! and their squared difference counts over the area of the star like a squared distance.
//!
//! If a wedge crosses a seam, its triangles take over values that do not belong to them. Over each of
//! these triangles, the difference falls linearly from the crossing corner to the opposite edge; its
//! mean square counts over the triangle's area.

use std::ops::Range;

use glam::Vec3;

use crate::mesh::{AttributeLayer, Semantic, Welded};

use super::base_colors::{BaseColors, ShownTriangle, gathered};
use super::charts;
use super::fan::nearest;
use super::star::Star;
use super::wedges::Wedges;
use crate::simplify::options::SequenceOptions;

/// Factors on attribute differences at seams that are crossed or whose shape changes.
#[derive(Clone, Copy, Debug)]
struct SeamFactors {
    crossing: f32,
    border: f32,
}

const PLAIN: SeamFactors = SeamFactors { crossing: 1.0, border: 1.0 };
/// Factors for tiled texture coordinates and for materials; a crossing factor of 6 lets collapses smear
/// them over their neighbors.
const TILED: SeamFactors = SeamFactors { crossing: 20.0, border: 1.0 };
/// Factors for texture coordinates of an atlas, whose charts must not mix. They reduce the texture
/// errors of the Spot model at a tenth of its triangles by a quarter, for 1 % more RMS; with a crossing
/// factor of 1,000 the shape suffers.
const ATLAS: SeamFactors = SeamFactors { crossing: 60.0, border: 20.0 };
/// Upper limit of the squared distance that smeared attributes count for: showing a wrong part of the
/// texture is no worse than a dent of a seventh of the diagonal.
const MAX_SMEAR: f32 = 0.02;
/// Factor on the difference of stretched texture coordinates, relative to the difference at the removed
/// vertex.
const STRETCH_FACTOR: f32 = 5.0;
/// Limit on how far texture coordinates are extrapolated beyond a triangle, in multiples of its edges.
const MAX_EXTENSION: f32 = 3.0;
/// Multiple of the default weight for the texture coordinates of an atlas, if one unit of them is as
/// long as the diagonal of the mesh: what the viewer sees is how far the texture slides on the surface.
const SLIDE_FACTOR: f32 = 3.0;
/// Lower and upper limit of that multiple.
const MIN_SLIDE: f32 = 0.3;
const MAX_SLIDE: f32 = 4.0;
/// Factor on differences of texture coordinates if the colors that they show are known. It bounds how far
/// details slide that the averages over triangles do not show. With 1, the color errors of palettes are 3 %
/// larger.
const TEXTURED_SHARE: f32 = 0.5;
/// Additional factor on squared changes of normals on a smooth surface, per area in squared diagonals. With
/// the default weight, a small change of one radian counts like a distance of twice the side of a square as
/// large as the area that shows it. A weight that is the same for all sizes ruins the shape of fine meshes
/// long before it helps coarse ones: for equal normals, its RMS errors on thirteen assets are 10 to 20 % larger.
const HIGHLIGHT_FACTOR: f32 = 80_000.0;
/// Squared change of a normal at which half of that is left. The sides of a thin wall trade places in one
/// step, which is a change of the shape, not of a highlight.
const MAX_HIGHLIGHT: f32 = 0.1;
/// Mean of one minus the cosine between a vertex's normal and its triangles at which half of that is left: at
/// creases, nobody sees where a highlight ends.
const SMOOTH_DEVIATION: f32 = 0.03;
/// Mean square over a triangle of the linear function that is 1 at one corner and 0 at the others.
const CORNER_SHARE: f32 = 1.0 / 6.0;
/// Maximum number of wedges that are distinguished in one star; any more do not add to the cost.
const MAX_WEDGES: usize = 12;

/// Attributes of all vertices as coordinates, in scaled units.
#[derive(Debug)]
pub(in crate::simplify) struct AttributeSpace {
    dimension: usize,
    values: Vec<f32>,
    /// Bit mask of the coordinates that are texture coordinates.
    texcoords: u32,
    /// The coordinates that are normals.
    normals: Range<usize>,
    /// Squared weight of normals.
    normal_weight_squared: f32,
    /// For each vertex, the additional factor on the squared change of its normal per unit of area; empty if
    /// there are no normals.
    highlights: Vec<f32>,
    /// For each vertex, a bit mask of its coordinates that belong to an atlas; empty if there are none.
    atlases: Vec<u32>,
    /// Material of each vertex; empty if there is only one.
    materials: Vec<u32>,
    /// Squared difference between any two materials.
    material_squared: f32,
    /// Base colors that textures show, if some are known.
    base_colors: Option<BaseColors>,
}

/// A wedge of the removed vertex and its side of the fan.
#[derive(Clone, Copy)]
struct WedgeSide {
    /// The vertex, or `u32::MAX`.
    wedge: u32,
    /// Area of its triangles.
    area: f32,
    /// Least squared distance to this side of the fan, and the triangle of the star and the barycentric coordinates
    /// there.
    distance: f32,
    triangle: usize,
    weights: [f32; 3],
}

impl Default for WedgeSide {
    fn default() -> Self {
        Self { wedge: u32::MAX, area: 0.0, distance: f32::INFINITY, triangle: 0, weights: [0.0; 3] }
    }
}

impl AttributeSpace {
    /// Creates the space of a mesh's weighted layers; `scale` is the length of the unit of scaled positions.
    /// Returns `None` if no layer has a weight.
    pub(in crate::simplify) fn new(welded: &Welded, options: &SequenceOptions, scale: f64) -> Option<Self> {
        let weights = &options.attribute_weights;
        let is_displacement = |layer: &&AttributeLayer| matches!(layer.semantic, Semantic::MorphPosition(_));
        let displacement_count = welded.mesh.layers.iter().filter(is_displacement).count() as f32;
        // The mean over all displacements counts, not their sum.
        let displacement = weights.displacement / (scale as f32 * displacement_count.sqrt());
        let weight = |semantic: &Semantic| match semantic {
            Semantic::Normal => weights.normal,
            Semantic::TexCoord(_) => weights.texcoord,
            Semantic::Color(_) => weights.color,
            Semantic::MorphPosition(_) => displacement,
            _ => 0.0,
        };
        let layers: Vec<_> = welded
            .mesh
            .layers
            .iter()
            .map(|layer| (layer, weight(&layer.semantic)))
            .filter(|(_, weight)| *weight > 0.0)
            .collect();
        let dimension = layers.iter().map(|(layer, _)| layer.component_count as usize).sum();
        let material_squared = weights.texcoord * weights.texcoord;
        let materials = if material_squared > 0.0 { materials_of(welded) } else { Vec::new() };
        if dimension == 0 && materials.is_empty() {
            return None;
        }
        let vertex_count = welded.mesh.vertex_count();
        let mut space = Self {
            dimension,
            values: vec![0.0; dimension * vertex_count],
            texcoords: 0,
            normals: 0..0,
            normal_weight_squared: weights.normal * weights.normal,
            highlights: Vec::new(),
            atlases: Vec::new(),
            materials,
            material_squared,
            base_colors: None,
        };
        let material_of = |vertex| space.material(welded, vertex);
        let known = &options.base_colors;
        space.base_colors = BaseColors::new(welded, known, material_of, weights.texcoord);
        let mut first = 0;
        for (layer, weight) in layers {
            space.fill((welded, scale), layer, (first, weight), options);
            first += layer.component_count as usize;
        }
        Some(space)
    }

    /// Returns the space of some of the vertices, in this order: a part of a mesh, at a later time, counts like the
    /// original.
    pub(in crate::simplify) fn gathered(&self, vertices: &[u32]) -> Self {
        Self {
            values: vertices.iter().flat_map(|&v| self.of(v)).copied().collect(),
            normals: self.normals.clone(),
            highlights: gathered(&self.highlights, vertices),
            atlases: gathered(&self.atlases, vertices),
            materials: gathered(&self.materials, vertices),
            base_colors: self.base_colors.as_ref().map(|colors| colors.gathered(vertices)),
            ..*self
        }
    }

    /// Fills in the coordinates of a layer, beginning at coordinate `first`.
    fn fill(
        &mut self,
        (welded, scale): (&Welded, f64),
        layer: &AttributeLayer,
        (first, weight): (usize, f32),
        options: &SequenceOptions,
    ) {
        let count = layer.component_count as usize;
        let bits = (first..first + count).filter(|&d| d < 32).fold(0, |bits, d| bits | 1 << d);
        if layer.semantic == Semantic::Normal {
            self.normals = first..first + count;
            self.highlights = highlights_of(welded, layer);
        }
        let mut lengths = Vec::new();
        let is_texcoord = matches!(layer.semantic, Semantic::TexCoord(_));
        if is_texcoord {
            self.texcoords |= bits;
            lengths = charts::atlas_unit_lengths(welded, layer, scale, &options.texcoord_scales);
            self.atlases.resize(lengths.len(), 0);
            for (mask, &length) in self.atlases.iter_mut().zip(&lengths) {
                *mask |= if length > 0.0 { bits } else { 0 };
            }
        }
        for vertex in 0..welded.mesh.vertex_count() {
            let slide = match lengths.get(vertex) {
                Some(&length) if length > 0.0 => (SLIDE_FACTOR * length).clamp(MIN_SLIDE, MAX_SLIDE),
                _ => 1.0,
            };
            let (mut factor, mut parts) = (1.0, [1.0; 2]);
            if is_texcoord {
                let material = self.material(welded, vertex);
                if self.base_colors.as_ref().is_some_and(|colors| colors.is_textured(vertex as u32)) {
                    factor = TEXTURED_SHARE;
                }
                parts = charts::scale_of(material, &options.texcoord_scales);
            }
            for c in 0..count {
                let scale = parts.get(c).copied().unwrap_or(1.0);
                let value = factor * slide * weight * scale * layer.get(vertex, c);
                // A value that is not finite must not affect the cost.
                self.values[vertex * self.dimension + first + c] =
                    if value.is_finite() { value } else { 0.0 };
            }
        }
    }

    /// Material of a vertex, if it has one.
    fn material(&self, welded: &Welded, vertex: usize) -> Option<u32> {
        match self.materials.get(vertex) {
            Some(&material) => material.checked_sub(1),
            // All groups share one material.
            None => welded.mesh.groups.first().and_then(|group| group.material),
        }
    }

    /// Factors of coordinate `d` of a vertex at seams.
    fn factors(&self, vertex: u32, d: usize) -> SeamFactors {
        let is_set = |mask: u32| d < 32 && mask >> d & 1 == 1;
        if !is_set(self.texcoords) {
            return PLAIN;
        }
        if self.atlases.get(vertex as usize).is_some_and(|&mask| is_set(mask)) { ATLAS } else { TILED }
    }

    fn of(&self, vertex: u32) -> &[f32] {
        &self.values[vertex as usize * self.dimension..][..self.dimension]
    }

    /// Whether both vertices belong to the same material.
    fn share_material(&self, a: u32, b: u32) -> bool {
        self.materials.is_empty() || self.materials[a as usize] == self.materials[b as usize]
    }

    /// Squared difference of two vertices in attributes and material.
    pub(in crate::simplify) fn difference_squared(&self, a: u32, b: u32) -> f32 {
        let squared: f32 = self.of(a).iter().zip(self.of(b)).map(|(x, y)| (x - y) * (x - y)).sum();
        let squared = squared + self.color_squared(a, b);
        if self.share_material(a, b) { squared } else { squared + self.material_squared }
    }

    /// Squared difference of two vertices in the colors of their textures.
    fn color_squared(&self, a: u32, b: u32) -> f32 {
        self.base_colors.as_ref().map_or(0.0, |colors| colors.difference_squared(a, b))
    }

    /// Squared difference in attributes and material between the two sides of a seam whose shape changes.
    pub(in crate::simplify) fn border_squared(&self, a: u32, b: u32) -> f32 {
        let squared = self.weighted_squared(a, b, |factors| factors.border) + self.color_squared(a, b);
        if self.share_material(a, b) { squared } else { squared + self.material_squared }
    }

    /// Squared difference between the texture coordinates of `target` and those that the triangle with
    /// corners at the origin, `a` and `b` would have at the new position `u` if it were extended to it.
    fn stretch_squared(&self, corners: [u32; 3], target: u32, [u, a, b]: [Vec3; 3]) -> f32 {
        let normal = a.cross(b);
        let area_squared = normal.length_squared().max(f32::MIN_POSITIVE);
        let clamped =
            |doubled: Vec3| (doubled.dot(normal) / area_squared).clamp(-MAX_EXTENSION, MAX_EXTENSION);
        let (x, y) = (clamped(u.cross(b)), clamped(a.cross(u)));
        let new = self.of(target);
        let [v, a, b] = corners.map(|corner| self.of(corner));
        let difference = |d: usize| v[d] + x * (a[d] - v[d]) + y * (b[d] - v[d]) - new[d];
        let mask = self.atlases[corners[0] as usize];
        let is_charted = |d: &usize| *d < 32 && mask >> d & 1 == 1;
        let squared: f32 =
            (0..self.dimension).filter(is_charted).map(|d| difference(d) * difference(d)).sum();
        (STRETCH_FACTOR * squared).min(MAX_SMEAR)
    }

    /// Squared difference between two points on triangles, each given by its corners and barycentric
    /// coordinates.
    pub(in crate::simplify) fn points_difference_squared(
        &self,
        corners: [u32; 3],
        weights: [f32; 3],
        other_corners: [u32; 3],
        other_weights: [f32; 3],
    ) -> f32 {
        let at = |corners: [u32; 3], weights: [f32; 3], d: usize| -> f32 {
            corners.into_iter().zip(weights).map(|(corner, weight)| weight * self.of(corner)[d]).sum()
        };
        let squared: f32 = (0..self.dimension)
            .map(|d| at(corners, weights, d) - at(other_corners, other_weights, d))
            .map(|difference| difference * difference)
            .sum();
        let colors = self.base_colors.as_ref().map_or(0.0, |colors| {
            colors.points_difference_squared(corners, weights, other_corners, other_weights)
        });
        let squared: f32 = squared + colors;
        if self.share_material(corners[0], other_corners[0]) {
            squared
        } else {
            squared + self.material_squared
        }
    }

    /// Squared difference of two vertices' attributes, with a factor that depends on the coordinates of `a`.
    fn weighted_squared(&self, a: u32, b: u32, factor: impl Fn(SeamFactors) -> f32) -> f32 {
        let pairs = self.of(a).iter().zip(self.of(b)).enumerate();
        pairs.map(|(d, (x, y))| factor(self.factors(a, d)) * (x - y) * (x - y)).sum()
    }

    /// Cost per unit of area of replacing `from` by `to` on the other side of a seam.
    pub(in crate::simplify) fn crossing_squared(&self, from: u32, to: u32) -> f32 {
        (self.smear_squared(from, to) + self.color_squared(from, to)).min(MAX_SMEAR)
    }

    /// Cost per unit of area of replacing `from` by `to` on the other side of a seam, without the colors.
    fn smear_squared(&self, from: u32, to: u32) -> f32 {
        let squared = self.weighted_squared(from, to, |factors| factors.crossing);
        let material =
            if self.share_material(from, to) { 0.0 } else { TILED.crossing * self.material_squared };
        (squared + material).min(MAX_SMEAR)
    }

    /// Attribute cost of collapsing `v` to neighbor `k` of its star; the wedges must be paired already.
    pub(in crate::simplify) fn cost(
        &self,
        star: &Star,
        wedges: Option<&Wedges<'_>>,
        v: u32,
        k: usize,
    ) -> f32 {
        let vertex_at = |t: usize, position: u32| vertex_at(star, wedges, t, position);
        let u = star.offset(k);
        let mut sides = [WedgeSide::default(); MAX_WEDGES];
        let mut crossing = 0.0;
        for t in 0..star.ring.triangle_count() {
            let [i, j] = star.ring.triangle(t);
            if i == k || j == k {
                continue;
            }
            let wedge = vertex_at(t, v);
            let (a, b) = (star.offset(i), star.offset(j));
            if self.atlases.get(wedge as usize).is_some_and(|&mask| mask != 0) {
                let target = wedges.map_or(star.ring.ids[k], |w| w.paired(wedge, star.ring.ids[k]));
                let corners = [wedge, vertex_at(t, star.ring.ids[i]), vertex_at(t, star.ring.ids[j])];
                let areas = [a.cross(b), (a - u).cross(b - u)].map(|normal| 0.5 * normal.length());
                crossing += areas[0].max(areas[1]) * self.stretch_squared(corners, target, [u, a, b]);
            }
            if wedges.is_some_and(|w| w.crosses(wedge)) {
                let target = wedges.map_or(wedge, |w| w.paired(wedge, star.ring.ids[k]));
                let areas = [a.cross(b), (a - u).cross(b - u)].map(|normal| 0.5 * normal.length());
                crossing += areas[0].max(areas[1]) * self.smear_squared(wedge, target);
                continue;
            }
            let Some(side) = sides.iter_mut().find(|side| [wedge, u32::MAX].contains(&side.wedge)) else {
                continue;
            };
            side.wedge = wedge;
            side.area += 0.5 * a.cross(b).length();
            let [x, y, z] = nearest(u, a, b);
            let distance = (u * x + a * y + b * z).length_squared();
            if distance < side.distance {
                (side.distance, side.triangle, side.weights) = (distance, t, [x, y, z]);
            }
        }
        let (mut errors, mut highlights) = (0.0, 0.0);
        for side in sides.iter().filter(|side| side.distance < f32::INFINITY) {
            let [i, j] = star.ring.triangle(side.triangle).map(|corner| star.ring.ids[corner]);
            let target = wedges.map_or(star.ring.ids[k], |w| w.paired(side.wedge, star.ring.ids[k]));
            let corners = [target, vertex_at(side.triangle, i), vertex_at(side.triangle, j)];
            errors += self.interpolation_error(side.wedge, corners, side.weights);
            highlights += side.area * side.area * self.highlight_error(side.wedge, corners, side.weights);
        }
        star.area() * errors + highlights + CORNER_SHARE * crossing
    }

    /// Cost of what collapsing `v` to neighbor `k` of its star changes in the colors that textures show; the
    /// wedges must be paired already.
    pub(in crate::simplify) fn color_cost(
        &self,
        star: &Star,
        wedges: Option<&Wedges<'_>>,
        v: u32,
        k: usize,
    ) -> f32 {
        let Some(colors) = &self.base_colors else { return 0.0 };
        let (u, target) = (star.offset(k), star.ring.ids[k]);
        let triangle = |t: usize, center: u32, at: Vec3| {
            let [i, j] = star.ring.triangle(t);
            let vertices = [
                center,
                vertex_at(star, wedges, t, star.ring.ids[i]),
                vertex_at(star, wedges, t, star.ring.ids[j]),
            ];
            ShownTriangle { vertices, points: [at, star.offset(i), star.offset(j)] }
        };
        let wedge = |t: usize| vertex_at(star, wedges, t, v);
        let paired = |t: usize| wedges.map_or(target, |w| w.paired(wedge(t), target));
        let all = 0..star.ring.triangle_count();
        let is_left = |&t: &usize| !star.ring.triangle(t).contains(&k);
        let old: Vec<_> = all.clone().map(|t| triangle(t, wedge(t), Vec3::ZERO)).collect();
        let new: Vec<_> = all.filter(is_left).map(|t| triangle(t, paired(t), u)).collect();
        colors.cost(&old, &new)
    }

    /// Whether the colors that some textures show are known.
    pub(in crate::simplify) fn has_colors(&self) -> bool {
        self.base_colors.is_some()
    }

    /// Squared difference between a vertex's attributes and those at barycentric coordinates in a triangle.
    pub(in crate::simplify) fn interpolation_error(
        &self,
        wedge: u32,
        corners: [u32; 3],
        weights: [f32; 3],
    ) -> f32 {
        let [a, b, c] = corners.map(|corner| self.of(corner));
        let own = self.of(wedge);
        (0..self.dimension)
            .map(|d| own[d] - (weights[0] * a[d] + weights[1] * b[d] + weights[2] * c[d]))
            .map(|difference| difference * difference)
            .sum()
    }

    /// Additional cost, per squared area, of the difference between a vertex's normal and that at barycentric
    /// coordinates in a triangle.
    fn highlight_error(&self, wedge: u32, corners: [u32; 3], weights: [f32; 3]) -> f32 {
        let Some(&factor) = self.highlights.get(wedge as usize) else { return 0.0 };
        let [own, a, b, c] =
            [wedge, corners[0], corners[1], corners[2]].map(|v| &self.of(v)[self.normals.clone()]);
        let squared: f32 = (0..own.len())
            .map(|d| own[d] - (weights[0] * a[d] + weights[1] * b[d] + weights[2] * c[d]))
            .map(|difference| difference * difference)
            .sum();
        let most = MAX_HIGHLIGHT * self.normal_weight_squared;
        factor * squared * most / (most + squared)
    }
}

/// Returns the factor on the squared change of each vertex's normal, per unit of the area that shows it: the
/// more the triangles around a vertex agree with its normal, the more is seen of a change.
fn highlights_of(welded: &Welded, normals: &AttributeLayer) -> Vec<f32> {
    // Deviations of triangles and their areas, both doubled.
    let mut sums = vec![[0.0f32; 2]; welded.mesh.vertex_count()];
    for triangle in &welded.mesh.triangles {
        let [a, b, c] = triangle.map(|v| Vec3::from(welded.mesh.positions[v as usize]));
        let cross = (b - a).cross(c - a);
        let area = cross.length();
        for &v in triangle {
            let normal = Vec3::from([0, 1, 2].map(|axis| normals.get(v as usize, axis)));
            let deviation = (area - cross.dot(normal)).max(0.0);
            if deviation.is_finite() {
                let sum = &mut sums[v as usize];
                *sum = [sum[0] + deviation, sum[1] + area];
            }
        }
    }
    let factor = |&[deviation, area]: &[f32; 2]| {
        let smooth = SMOOTH_DEVIATION * area;
        if smooth > 0.0 { HIGHLIGHT_FACTOR * smooth / (smooth + deviation) } else { 0.0 }
    };
    sums.iter().map(factor).collect()
}

/// Returns the vertex that a triangle of a star uses at a position.
fn vertex_at(star: &Star, wedges: Option<&Wedges<'_>>, t: usize, position: u32) -> u32 {
    wedges.map_or(position, |w| match w.is_split(position) {
        true => w.vertex_at(star.ring.triangles[t], position),
        false => w.first(position),
    })
}

/// Returns the index of each vertex's material plus one, or 0 if it has none; empty if all vertices
/// share one material. Welding ensures that every vertex has one material only.
fn materials_of(welded: &Welded) -> Vec<u32> {
    let groups = &welded.mesh.groups;
    if groups.windows(2).all(|pair| pair[0].material == pair[1].material) {
        return Vec::new();
    }
    let mut materials = vec![0; welded.mesh.vertex_count()];
    for group in groups {
        for &vertex in welded.mesh.triangles[group.range()].as_flattened() {
            materials[vertex as usize] = group.material.map_or(0, |m| m + 1);
        }
    }
    materials
}

#[cfg(test)]
mod tests {
    use crate::mesh::{IndexedMesh, Material, TriangleGroup, weld};

    use super::*;

    /// Two separate triangles with texture coordinates that differ at every corner.
    fn two_triangles(materials: [Option<u32>; 2]) -> Welded {
        let positions = (0..6).map(|i| [i as f32, (i * i) as f32, 0.0]).collect();
        let mut mesh = IndexedMesh::new(positions, vec![[0, 1, 2], [3, 4, 5]]);
        let uvs = (0..6).flat_map(|i| [0.1 * i as f32, 0.05 * (i * i) as f32]).collect();
        mesh.layers.push(AttributeLayer::from_f32(Semantic::TexCoord(0), 2, uvs));
        mesh.appearance.materials = vec![Material::default(); 2];
        mesh.groups = materials
            .into_iter()
            .zip(0..)
            .map(|(material, first)| TriangleGroup { first, count: 1, material, ..TriangleGroup::default() })
            .collect();
        weld(&mesh).expect("the mesh is valid")
    }

    /// Squared differences between two vertices of the first triangle and of the second.
    fn differences(welded: &Welded, scales: &[f32]) -> [f32; 2] {
        let scales = scales.iter().map(|&scale| [scale; 2]).collect();
        let options = SequenceOptions::default().with_texcoord_scales(scales);
        let space = AttributeSpace::new(welded, &options, 1.0).expect("there are UVs");
        [welded.mesh.triangles[0], welded.mesh.triangles[1]].map(|[a, b, _]| space.difference_squared(a, b))
    }

    #[test]
    fn scales_of_texture_coordinates_are_those_of_the_material() {
        for materials in [[Some(0), Some(1)], [None, Some(1)], [Some(1), Some(1)]] {
            let welded = two_triangles(materials);
            let usual = differences(&welded, &[]);
            assert!(usual.iter().all(|&squared| squared > 0.0));
            assert_eq!(differences(&welded, &[1.0, 1.0]), usual, "{materials:?}");
            assert_eq!(differences(&welded, &[1.0]), usual, "material 1 is not listed: {materials:?}");
            let expected = |at: usize| if materials[at] == Some(1) { 0.0 } else { usual[at] };
            assert_eq!(differences(&welded, &[1.0, 0.0]), [expected(0), expected(1)], "{materials:?}");
        }
    }
}
