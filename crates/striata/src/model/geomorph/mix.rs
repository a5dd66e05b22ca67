//! Interpolates the attribute values of two vertices.

use crate::mesh::{AttributeLayer, Semantic};

/// How the components of a layer are interpolated.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::model) enum Mix {
    /// Each component separately.
    Linear,
    /// The first three components are normalized; the others, such as a tangent's handedness, come from
    /// the nearer vertex.
    Unit,
    /// All components come from the nearer vertex. For values that cannot be interpolated, such as joint
    /// indices and other identifiers.
    Nearer,
}

impl Mix {
    /// Returns how a layer is interpolated.
    pub(in crate::model) fn of(layer: &AttributeLayer) -> Self {
        match layer.semantic {
            Semantic::Normal | Semantic::Tangent => Self::Unit,
            Semantic::Joints(_) | Semantic::Weights(_) => Self::Nearer,
            Semantic::Generic(_) if layer.has_identifiers() => Self::Nearer,
            _ => Self::Linear,
        }
    }

    /// Interpolates from `from` (factor 0) to `to` (factor 1); both ends are reproduced exactly.
    pub(in crate::model) fn write(self, from: &[f32], to: &[f32], factor: f32, out: &mut [f32]) {
        let nearer = if factor < 0.5 { from } else { to };
        if self == Self::Nearer || factor <= 0.0 || factor >= 1.0 {
            out.copy_from_slice(nearer);
            return;
        }
        for ((out, from), to) in out.iter_mut().zip(from).zip(to) {
            *out = from * (1.0 - factor) + to * factor;
        }
        if self == Self::Unit && out.len() >= 3 {
            let length = out[..3].iter().map(|x| x * x).sum::<f32>().sqrt();
            // Opposite normals cancel out.
            if length > 1e-6 {
                out[..3].iter_mut().for_each(|x| *x /= length);
                out[3..].copy_from_slice(&nearer[3..]);
            } else {
                out.copy_from_slice(nearer);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::LayerData;

    fn mixed(mix: Mix, from: &[f32], to: &[f32], factor: f32) -> Vec<f32> {
        let mut out = vec![0.0; from.len()];
        mix.write(from, to, factor, &mut out);
        out
    }

    #[test]
    fn ends_are_exact_for_any_numbers() {
        for mix in [Mix::Linear, Mix::Unit, Mix::Nearer] {
            let (from, to) = ([0.1, f32::INFINITY, 3.0], [7.7, f32::MAX, -0.3]);
            assert_eq!(mixed(mix, &from, &to, 0.0), from);
            assert_eq!(mixed(mix, &from, &to, 1.0), to);
        }
    }

    #[test]
    fn normals_stay_normalized_and_tangents_keep_their_handedness() {
        let half = std::f32::consts::FRAC_1_SQRT_2;
        let found = mixed(Mix::Unit, &[1.0, 0.0, 0.0, -1.0], &[0.0, 1.0, 0.0, 1.0], 0.5);
        assert!((found[0] - half).abs() < 1e-6 && (found[1] - half).abs() < 1e-6);
        assert_eq!(found[2..], [0.0, 1.0]);
        assert_eq!(mixed(Mix::Unit, &[1.0, 0.0, 0.0], &[-1.0, 0.0, 0.0], 0.5), [-1.0, 0.0, 0.0]);
        assert_eq!(mixed(Mix::Linear, &[1.0, 0.0], &[0.0, 4.0], 0.25), [0.75, 1.0]);
        assert_eq!(mixed(Mix::Nearer, &[1.0, 2.0], &[3.0, 4.0], 0.4), [1.0, 2.0]);
    }

    #[test]
    fn identifiers_are_not_interpolated() {
        let rule = |data| {
            let semantic = Semantic::Generic("id".to_owned());
            Mix::of(&AttributeLayer { semantic, component_count: 1, normalized: false, data })
        };
        assert_eq!(rule(LayerData::U32(vec![7, u32::MAX])), Mix::Nearer);
        assert_eq!(rule(LayerData::F32(vec![7.0, -300_000.0])), Mix::Nearer);
        assert_eq!(rule(LayerData::F32(vec![7.0, 0.5])), Mix::Linear);
        assert_eq!(rule(LayerData::F32(vec![7.0, f32::NAN])), Mix::Linear);
        assert_eq!(rule(LayerData::F32(vec![16_777_216.0])), Mix::Linear);
    }
}
