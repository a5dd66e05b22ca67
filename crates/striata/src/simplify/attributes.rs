//! What a collapse does to attributes: how far the removed vertex's values lie from those of the new fan.
//!
//! Weighted attributes are further coordinates beside the position (as in [Hop99], though there by quadrics): the
//! nearest point of the fan is found in space, its attributes by interpolation, and their squared difference
//! counts over the area of the star like a squared distance.
//!
//! If a wedge crosses a seam, the triangles that it leaves take over values that do not belong to them. Over each of these
//! triangles, the difference falls linearly from the crossing corner to the opposite edge; its mean square counts over the area.

use crate::mesh::{Semantic, Welded};

use super::fan::nearest;
use super::options::AttributeWeights;
use super::star::Star;
use super::wedges::Wedges;

/// How much more a crossed seam costs in texture coordinates and materials than in normals and colors: 6 smears charts
/// over their neighbors, 60 keeps them better at 4 to 8 % more RMS.
const CROSSING_FACTOR: f32 = 20.0;
/// Mean square of a linear function over a triangle that is 1 at one corner and 0 at the others.
const CORNER_SHARE: f32 = 1.0 / 6.0;
/// Wedges of one star that are told apart; further ones count nothing.
const MAX_WEDGES: usize = 12;

/// Attributes of all vertices as coordinates in scaled units.
#[derive(Debug)]
pub(super) struct AttributeSpace {
    dimension: usize,
    values: Vec<f32>,
    /// For each coordinate, what its squared difference costs in a crossed seam.
    factors: Vec<f32>,
    /// The material of each vertex; empty if there is only one.
    materials: Vec<u32>,
    /// Squared difference between any two materials.
    material_squared: f32,
}

impl AttributeSpace {
    /// The weighted layers of a mesh; `None` where no layer has a weight.
    pub(super) fn new(welded: &Welded, weights: &AttributeWeights) -> Option<Self> {
        let weight = |semantic: &Semantic| match semantic {
            Semantic::Normal => weights.normal,
            Semantic::TexCoord(_) => weights.texcoord,
            Semantic::Color(_) => weights.color,
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
        let factor = |semantic: &Semantic| match semantic {
            Semantic::TexCoord(_) => CROSSING_FACTOR,
            _ => 1.0,
        };
        let factors = layers
            .iter()
            .flat_map(|(layer, _)| {
                std::iter::repeat_n(factor(&layer.semantic), layer.component_count as usize)
            })
            .collect();
        let mut values = Vec::with_capacity(dimension * welded.mesh.vertex_count());
        for vertex in 0..welded.mesh.vertex_count() {
            for (layer, weight) in &layers {
                values.extend((0..layer.component_count as usize).map(|c| {
                    let value = weight * layer.get(vertex, c);
                    // A value that is no number must not decide anything.
                    if value.is_finite() { value } else { 0.0 }
                }));
            }
        }
        Some(Self { dimension, values, factors, materials, material_squared })
    }

    fn of(&self, vertex: u32) -> &[f32] {
        &self.values[vertex as usize * self.dimension..][..self.dimension]
    }

    /// True if both vertices belong to one material.
    fn share_material(&self, a: u32, b: u32) -> bool {
        self.materials.is_empty() || self.materials[a as usize] == self.materials[b as usize]
    }

    /// Squared difference of two vertices' attributes and materials.
    pub(super) fn difference_squared(&self, a: u32, b: u32) -> f32 {
        let squared: f32 = self.of(a).iter().zip(self.of(b)).map(|(x, y)| (x - y) * (x - y)).sum();
        if self.share_material(a, b) { squared } else { squared + self.material_squared }
    }

    /// Squared difference between two points of triangles, each given by its corners and barycentric coordinates.
    pub(super) fn points_difference_squared(
        &self,
        (corners, weights): ([u32; 3], [f32; 3]),
        (other_corners, other_weights): ([u32; 3], [f32; 3]),
    ) -> f32 {
        let at = |corners: [u32; 3], weights: [f32; 3], d: usize| -> f32 {
            corners.into_iter().zip(weights).map(|(corner, weight)| weight * self.of(corner)[d]).sum()
        };
        let squared: f32 = (0..self.dimension)
            .map(|d| at(corners, weights, d) - at(other_corners, other_weights, d))
            .map(|difference| difference * difference)
            .sum();
        if self.share_material(corners[0], other_corners[0]) {
            squared
        } else {
            squared + self.material_squared
        }
    }

    /// What it costs over a unit of area that `to` stands for `from` on the other side of a seam.
    pub(super) fn crossing_squared(&self, from: u32, to: u32) -> f32 {
        let pairs = self.of(from).iter().zip(self.of(to)).zip(&self.factors);
        let squared: f32 = pairs.map(|((x, y), factor)| factor * (x - y) * (x - y)).sum();
        if self.share_material(from, to) {
            squared
        } else {
            squared + CROSSING_FACTOR * self.material_squared
        }
    }

    /// What collapsing `v` to neighbour `k` of its star costs in attributes; the wedges must be paired already.
    pub(super) fn cost(&self, star: &Star, wedges: Option<&Wedges<'_>>, v: u32, k: usize) -> f32 {
        let vertex_at = |t: usize, position: u32| {
            wedges.map_or(position, |w| {
                if w.is_split(position) { w.shown(star.triangles[t], position) } else { w.first(position) }
            })
        };
        let u = star.offset(k);
        // The wedge in question, the least distance to its side of the fan, and the difference there.
        let mut found: [(u32, f32, f32); MAX_WEDGES] = [(u32::MAX, f32::INFINITY, 0.0); MAX_WEDGES];
        let mut crossing = 0.0;
        for t in 0..star.triangle_count() {
            let [i, j] = star.triangle(t);
            if i == k || j == k {
                continue;
            }
            let wedge = vertex_at(t, v);
            let (a, b) = (star.offset(i), star.offset(j));
            if wedges.is_some_and(|w| w.crosses(wedge)) {
                let target = wedges.map_or(wedge, |w| w.paired(wedge, star.ids[k]));
                let areas = [a.cross(b), (a - u).cross(b - u)].map(|normal| 0.5 * normal.length());
                crossing += areas[0].max(areas[1]) * self.crossing_squared(wedge, target);
                continue;
            }
            let Some(slot) = found.iter_mut().find(|f| f.0 == wedge || f.0 == u32::MAX) else { continue };
            let [x, y, z] = nearest(u, a, b);
            let distance = (u * x + a * y + b * z).length_squared();
            if distance < slot.1 {
                let target = wedges.map_or(star.ids[k], |w| w.paired(wedge, star.ids[k]));
                let corners = [target, vertex_at(t, star.ids[i]), vertex_at(t, star.ids[j])];
                *slot = (wedge, distance, self.interpolation_error(wedge, corners, [x, y, z]));
            }
        }
        star.area() * found.iter().map(|f| f.2).sum::<f32>() + CORNER_SHARE * crossing
    }

    /// Squared difference between a vertex and a point of the triangle `corners` with these barycentric coordinates.
    pub(super) fn interpolation_error(&self, wedge: u32, corners: [u32; 3], weights: [f32; 3]) -> f32 {
        let [a, b, c] = corners.map(|corner| self.of(corner));
        let own = self.of(wedge);
        (0..self.dimension)
            .map(|d| own[d] - (weights[0] * a[d] + weights[1] * b[d] + weights[2] * c[d]))
            .map(|difference| difference * difference)
            .sum()
    }
}

/// The material of every vertex, which welding keeps to one, or nothing if all share it.
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
