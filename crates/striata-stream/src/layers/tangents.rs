//! Estimates tangents from texture coordinates and normals.

use striata::mesh::Semantic;

use crate::layers::direction_model::UNIT_BITS;
use crate::layers::directions::{Octahedron, scaled};
use crate::layers::form::{LayerForm, ValueTransform};
use crate::layers::layer_neighborhood::{LayerNeighborhood, LayerValues};

/// The layers that tangents are estimated from: texture coordinates, whose first component increases
/// along the tangent, and normals, to which the tangent is perpendicular.
#[derive(Clone, Debug)]
pub(crate) struct TangentSources {
    texcoords: usize,
    normals: Option<(usize, Octahedron)>,
}

impl TangentSources {
    /// Finds these layers in a stream, if it has them.
    pub(crate) fn of(forms: &[LayerForm]) -> Option<Self> {
        let texcoords = forms.iter().position(|form| {
            let is_grid = matches!(form.transform, ValueTransform::Uniform { .. });
            matches!(form.semantic, Semantic::TexCoord(_)) && is_grid && form.component_count == 2
        })?;
        let normals = forms.iter().enumerate().find_map(|(index, form)| match form.transform {
            ValueTransform::Octahedral { bits } if form.semantic == Semantic::Normal => {
                Some((index, Octahedron::new(bits)))
            }
            _ => None,
        });
        Some(Self { texcoords, normals })
    }

    /// Returns the direction in which the first texture coordinate increases at a vertex, estimated from
    /// the triangles around it.
    pub(crate) fn tangent(
        &self,
        values: &[LayerValues],
        neighborhood: &LayerNeighborhood<'_>,
        vertex: u32,
    ) -> [i64; 3] {
        let texcoords = |vertex: u32| -> [i64; 2] {
            let of = values[self.texcoords].of(vertex);
            [i64::from(of[0]), i64::from(of[1])]
        };
        let here = texcoords(vertex);
        let mut sum = [0i64; 3];
        let mut add = |a: usize, b: usize| {
            let [p, q] = [a, b].map(|i| {
                let there = texcoords(neighborhood.ring[i]);
                [there[0] - here[0], there[1] - here[1]]
            });
            let sign =
                (i128::from(p[0]) * i128::from(q[1]) - i128::from(p[1]) * i128::from(q[0])).signum() as i64;
            for (axis, sum) in sum.iter_mut().enumerate() {
                *sum +=
                    sign * (neighborhood.fit.arms[a][axis] * q[1] - neighborhood.fit.arms[b][axis] * p[1]);
            }
        };
        (1..neighborhood.ring.len()).for_each(|i| add(i - 1, i));
        if neighborhood.fit.is_closed && neighborhood.ring.len() > 2 {
            add(neighborhood.ring.len() - 1, 0);
        }
        match self.normals {
            Some((layer, grid)) => {
                let of = values[layer].of(vertex);
                across(scaled(sum, 1 << UNIT_BITS), grid.direction([of[0], of[1]]))
            }
            None => sum,
        }
    }
}

/// Returns the component of a direction that is perpendicular to a normal.
fn across(direction: [i64; 3], normal: [i64; 3]) -> [i64; 3] {
    let dot = |a: [i64; 3], b: [i64; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    let (along, squared) = (dot(direction, normal), dot(normal, normal).max(1));
    std::array::from_fn(|a| direction[a] - normal[a] * along / squared)
}

#[cfg(test)]
mod tests {
    use striata::mesh::AttributeLayer;

    use super::*;
    use crate::layers::form::NumberType;
    use crate::layers::options::LayerOptions;
    use crate::layers::ring_fit::RingFit;

    #[test]
    fn tangents_follow_texture_coordinates() {
        let ring = [[40, 0, 8], [10, 30, 2], [-30, 10, -6], [-20, -30, -4], [20, -20, 4]];
        let mut fit = RingFit::default();
        fit.measure([0; 3], &ring, true);
        let neighborhood = LayerNeighborhood::new(Some(0), &[0, 1, 2, 3, 4], &fit);
        for mirror in [1, -1] {
            // The plane is z = x / 5; u increases along x + y and v perpendicular to it.
            let texcoord = |p: &[i32; 3]| [500 + p[0] + p[1], 500 + mirror * (p[1] - p[0])];
            let integers = ring.iter().chain(&[[0; 3]]).flat_map(texcoord).collect();
            let layers = [
                AttributeLayer::from_f32(Semantic::TexCoord(0), 2, vec![0.0, 1000.0, 0.0, 1000.0]),
                AttributeLayer::from_f32(Semantic::Normal, 3, vec![0.0, 0.0, 1.0]),
            ];
            let forms = layers.map(|layer| LayerForm::of(&layer, &LayerOptions::default()));
            assert_eq!(forms[0].number_type, NumberType::F32);
            let texcoords = LayerValues::from_integers(integers, 2);
            let normals = LayerValues::from_integers(vec![0; 12], 2);
            let values = [texcoords, normals];
            let alone = TangentSources::of(&forms[..1]).unwrap().tangent(&values, &neighborhood, 5);
            let [x, y, z] = scaled(alone, 1100);
            assert!((x - 500).abs() < 3 && (y - 500).abs() < 3 && (z - 100).abs() < 3, "{alone:?}");
            // The given normal points straight up, so the slope disappears.
            let level = TangentSources::of(&forms).unwrap().tangent(&values, &neighborhood, 5);
            let [x, y, z] = scaled(level, 1000);
            assert!((x - 500).abs() < 3 && (y - 500).abs() < 3 && z.abs() < 3, "{level:?}");
        }
        assert!(TangentSources::of(&[]).is_none());
    }
}
