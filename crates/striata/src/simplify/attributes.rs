//! What a collapse does to attributes: how far the removed vertex's values lie from those of the new fan.
//!
//! Weighted attributes are further coordinates beside the position (as in [Hop99], though there by quadrics): the
//! nearest point of the fan is found in space, its attributes by interpolation, and their squared difference
//! counts over the area of the star like a squared distance.

use crate::mesh::{Semantic, Welded};

use super::fan::nearest;
use super::options::AttributeWeights;
use super::star::Star;
use super::wedges::Wedges;

/// Attributes of all vertices as coordinates in scaled units.
#[derive(Debug)]
pub(super) struct AttributeSpace {
    dimension: usize,
    values: Vec<f32>,
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
        if dimension == 0 {
            return None;
        }
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
        Some(Self { dimension, values })
    }

    fn of(&self, vertex: u32) -> &[f32] {
        &self.values[vertex as usize * self.dimension..][..self.dimension]
    }

    /// Squared difference of two vertices' attributes.
    pub(super) fn difference_squared(&self, a: u32, b: u32) -> f32 {
        self.of(a).iter().zip(self.of(b)).map(|(x, y)| (x - y) * (x - y)).sum()
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
        let mut found: [(u32, f32, f32); 4] = [(u32::MAX, f32::INFINITY, 0.0); 4];
        for t in 0..star.triangle_count() {
            let [i, j] = star.triangle(t);
            if i == k || j == k {
                continue;
            }
            let wedge = vertex_at(t, v);
            let Some(slot) = found.iter_mut().find(|f| f.0 == wedge || f.0 == u32::MAX) else { continue };
            let (a, b) = (star.offset(i), star.offset(j));
            let [x, y, z] = nearest(u, a, b);
            let distance = (u * x + a * y + b * z).length_squared();
            if distance < slot.1 {
                let target = wedges.map_or(star.ids[k], |w| w.paired(wedge, star.ids[k]));
                let corners = [target, vertex_at(t, star.ids[i]), vertex_at(t, star.ids[j])];
                *slot = (wedge, distance, self.interpolation_error(wedge, corners, [x, y, z]));
            }
        }
        star.area() * found.iter().map(|f| f.2).sum::<f32>()
    }

    fn interpolation_error(&self, wedge: u32, corners: [u32; 3], weights: [f32; 3]) -> f32 {
        let [a, b, c] = corners.map(|corner| self.of(corner));
        let own = self.of(wedge);
        (0..self.dimension)
            .map(|d| own[d] - (weights[0] * a[d] + weights[1] * b[d] + weights[2] * c[d]))
            .map(|difference| difference * difference)
            .sum()
    }
}
