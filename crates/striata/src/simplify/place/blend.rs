//! Interpolates the attributes of two vertices for a vertex between them.

use crate::mesh::{AttributeLayer, LayerData, Semantic};

/// How a layer is interpolated.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum BlendRule {
    /// Linear interpolation.
    Linear,
    /// Unit vectors: the first three components are interpolated and normalized.
    Direction,
    /// Indices, and values that only make sense with them: copied from the nearer vertex.
    Nearer,
}

fn rule_of(layer: &AttributeLayer) -> BlendRule {
    let is_single = matches!(layer.data, LayerData::F32(_));
    match layer.semantic {
        Semantic::Joints(_) | Semantic::Weights(_) => BlendRule::Nearer,
        Semantic::Normal | Semantic::Tangent if is_single && layer.component_count >= 3 => {
            BlendRule::Direction
        }
        Semantic::Normal | Semantic::Tangent => BlendRule::Nearer,
        _ if layer.has_identifiers() => BlendRule::Nearer,
        _ => BlendRule::Linear,
    }
}

/// The rules of all layers of a mesh.
#[derive(Clone, Debug)]
pub(super) struct Blender {
    rules: Vec<BlendRule>,
}

impl Blender {
    pub(super) fn new(layers: &[AttributeLayer]) -> Self {
        Self { rules: layers.iter().map(rule_of).collect() }
    }

    /// Moves the attributes of vertex `kept` by `share` of the way toward those of vertex `removed`.
    pub(super) fn blend(&self, layers: &mut [AttributeLayer], removed: u32, kept: u32, share: f64) {
        if share == 0.0 {
            return;
        }
        for (layer, &rule) in layers.iter_mut().zip(&self.rules) {
            blend_layer(layer, rule, removed, kept, share);
        }
    }
}

fn blend_layer(layer: &mut AttributeLayer, rule: BlendRule, removed: u32, kept: u32, share: f64) {
    let n = layer.component_count as usize;
    let (from, to) = (removed as usize * n, kept as usize * n);
    let whole = |x: f64, y: f64| (x + (y - x) * share).round();
    match &mut layer.data {
        LayerData::F32(data) if rule == BlendRule::Direction => mix_direction(data, n, from, to, share),
        LayerData::F32(data) if rule == BlendRule::Linear => {
            for i in 0..n {
                data[to + i] = mix(data[to + i], data[from + i], share);
            }
        }
        LayerData::U8(data) if rule == BlendRule::Linear => {
            for i in 0..n {
                data[to + i] = whole(data[to + i].into(), data[from + i].into()) as u8;
            }
        }
        LayerData::U16(data) if rule == BlendRule::Linear => {
            for i in 0..n {
                data[to + i] = whole(data[to + i].into(), data[from + i].into()) as u16;
            }
        }
        LayerData::U32(data) if rule == BlendRule::Linear => {
            for i in 0..n {
                data[to + i] = whole(data[to + i].into(), data[from + i].into()) as u32;
            }
        }
        LayerData::F64(data) if rule == BlendRule::Linear => {
            for i in 0..n {
                data[to + i] += (data[from + i] - data[to + i]) * share;
            }
        }
        LayerData::I8(data) if rule == BlendRule::Linear => {
            for i in 0..n {
                data[to + i] = whole(data[to + i].into(), data[from + i].into()) as i8;
            }
        }
        LayerData::I16(data) if rule == BlendRule::Linear => {
            for i in 0..n {
                data[to + i] = whole(data[to + i].into(), data[from + i].into()) as i16;
            }
        }
        _ if share <= 0.5 => {}
        data => data.copy_within(from..from + n, to),
    }
}

fn mix(x: f32, y: f32, share: f64) -> f32 {
    let (x, y) = (f64::from(x), f64::from(y));
    (x + (y - x) * share) as f32
}

fn mix_direction(data: &mut [f32], n: usize, from: usize, to: usize, share: f64) {
    let mixed: [f32; 3] = std::array::from_fn(|i| mix(data[to + i], data[from + i], share));
    let length = mixed.iter().map(|&x| f64::from(x) * f64::from(x)).sum::<f64>().sqrt();
    if share > 0.5 {
        data.copy_within(from..from + n, to);
    }
    // Opposite directions cancel out and cannot be normalized: keep the nearer one.
    if length > 1e-6 {
        for (slot, x) in data[to..].iter_mut().zip(mixed) {
            *slot = (f64::from(x) / length) as f32;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_kind_of_layer_is_blended_by_its_rule() {
        let mut layers = vec![
            AttributeLayer::from_f32(Semantic::Normal, 3, vec![1., 0., 0., 0., 1., 0.]),
            AttributeLayer::from_f32(Semantic::TexCoord(0), 2, vec![0., 1., 1., 3.]),
            AttributeLayer::from_f32(Semantic::Weights(0), 4, vec![1., 0., 0., 0., 0., 1., 0., 0.]),
            AttributeLayer {
                semantic: Semantic::Joints(0),
                component_count: 1,
                normalized: false,
                data: LayerData::U16(vec![3, 9]),
            },
            AttributeLayer {
                semantic: Semantic::Color(0),
                component_count: 1,
                normalized: true,
                data: LayerData::U8(vec![0, 200]),
            },
            AttributeLayer::from_f32(Semantic::Generic("id".into()), 1, vec![300_000.0, -1.0]),
            AttributeLayer::from_f32(Semantic::Generic("heat".into()), 1, vec![0.5, 3.0]),
        ];
        let untouched = layers.clone();
        let blender = Blender::new(&layers);
        blender.blend(&mut layers, 1, 0, 0.0);
        assert_eq!(layers, untouched);
        blender.blend(&mut layers, 1, 0, 0.75);
        assert_eq!(layers[1].data, LayerData::F32(vec![0.75, 2.5, 1., 3.]));
        assert_eq!(layers[2].data, LayerData::F32(vec![0., 1., 0., 0., 0., 1., 0., 0.]));
        assert_eq!(layers[3].data, LayerData::U16(vec![9, 9]));
        assert_eq!(layers[4].data, LayerData::U8(vec![150, 200]));
        assert_eq!(layers[5].data, LayerData::F32(vec![-1.0, -1.0]));
        assert_eq!(layers[6].data, LayerData::F32(vec![2.375, 3.0]));
        let length: f32 = (0..3).map(|c| layers[0].get(0, c)).map(|x| x * x).sum();
        assert!((length - 1.0).abs() < 1e-6 && layers[0].get(0, 1) > layers[0].get(0, 0));
    }

    #[test]
    fn opposite_normals_do_not_cancel() {
        let mut layers = vec![AttributeLayer::from_f32(Semantic::Normal, 3, vec![0., 0., 1., 0., 0., -1.])];
        Blender::new(&layers).blend(&mut layers, 1, 0, 0.5);
        assert_eq!(layers[0].data, LayerData::F32(vec![0., 0., 1., 0., 0., -1.]));
    }
}
