//! Fits the attributes of a level.
//!
//! A pair whose attribute differs a lot is probably one across a seam or a crease, and counts little: its
//! weight is that of a Cauchy estimator, by a scale for each kind of layer.

use super::corner_forms::CornerForm;
use super::pairs::materials_of;
use super::pairs::{FitPairs, Pair};
use crate::mesh::{Adjacency, AttributeLayer, IndexedMesh, LayerData, Semantic};

/// Sweeps of Gauss-Seidel relaxation; more change results by less than a percent.
const SWEEPS: usize = 12;
/// Resistance to change, as a share of what the pairs around a vertex weigh.
const STIFFNESS: f64 = 0.02;
/// Largest number of components that are fitted together.
const WIDTH: usize = 4;

type Value = [f64; WIDTH];

/// How a layer is fitted.
struct FitRule {
    /// Number of components of a vertex.
    row: usize,
    /// Number of components that are fitted.
    width: usize,
    /// Whether the components are a unit vector.
    is_direction: bool,
    /// Values that the result must not exceed.
    range: [f64; 2],
    /// Difference that counts half.
    scale: LayerScale,
}

#[derive(Clone, Copy)]
enum LayerScale {
    Fixed(f64),
    /// A share of how much the values differ within the triangle.
    OfTriangle(f64),
}

impl FitRule {
    /// Returns how to fit a layer; `None` if its values stay.
    fn of(layer: &AttributeLayer) -> Option<Self> {
        let row = usize::from(layer.component_count);
        let is_fraction = layer.normalized && !layer.data.is_float();
        if layer.has_identifiers() || row > WIDTH || !(layer.data.is_float() || is_fraction) {
            return None;
        }
        let unlimited = [f64::NEG_INFINITY, f64::INFINITY];
        let plain = Self {
            row,
            width: row,
            is_direction: false,
            range: unlimited,
            scale: LayerScale::OfTriangle(1.0),
        };
        match layer.semantic {
            Semantic::Normal | Semantic::Tangent if row >= 3 => {
                Some(Self { width: 3, is_direction: true, scale: LayerScale::Fixed(0.2), ..plain })
            }
            Semantic::TexCoord(_) => Some(Self { scale: LayerScale::OfTriangle(0.2), ..plain }),
            Semantic::Color(_) => Some(Self { range: [0.0, 1.0], scale: LayerScale::Fixed(0.2), ..plain }),
            Semantic::Generic(_) => Some(plain),
            _ => None,
        }
    }

    fn value(&self, layer: &AttributeLayer, v: u32) -> Value {
        let mut value = [0.0; WIDTH];
        for (k, value) in value.iter_mut().enumerate().take(self.width) {
            *value = match &layer.data {
                LayerData::F64(values) => values[v as usize * self.row + k],
                _ => f64::from(layer.get(v as usize, k)),
            };
        }
        value
    }

    /// Value at a point of a triangle with these values at its corners.
    fn mixed(&self, corners: &[Value; 3], shares: [f64; 3]) -> Value {
        let mixed = std::array::from_fn(|k| (0..3).map(|corner| shares[corner] * corners[corner][k]).sum());
        if self.is_direction { unit(mixed).unwrap_or(mixed) } else { mixed }
    }

    /// Square of the difference that counts half, in a triangle.
    fn squared_scale(&self, corners: &[Value; 3]) -> f64 {
        match self.scale {
            LayerScale::Fixed(scale) => scale * scale,
            LayerScale::OfTriangle(share) => {
                let [a, b, c] = corners;
                let widest = [(a, b), (b, c), (c, a)].map(|(a, b)| squared_difference(a, b));
                share * share * widest.into_iter().fold(0.0, f64::max)
            }
        }
    }
}

fn squared_difference(a: &Value, b: &Value) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a - b) * (a - b)).sum()
}

fn unit(value: Value) -> Option<Value> {
    let length = value.iter().map(|x| x * x).sum::<f64>().sqrt();
    (length > 0.1).then(|| value.map(|x| x / length))
}

/// Changes the attributes of all vertices so that the level shows what the original does at its pairs.
pub(super) fn fit_layers(level: &mut IndexedMesh, pairs: &FitPairs, original: &IndexedMesh) {
    let rules: Vec<Option<FitRule>> = level.layers.iter().map(FitRule::of).collect();
    if rules.iter().all(Option::is_none) {
        return;
    }
    let (own, others) = (materials_of(level), materials_of(original));
    let has_same_material =
        |pair: &&Pair| own[pair.level.triangle as usize] == others[pair.original.triangle as usize];
    let pairs: Vec<Pair> = pairs.all().filter(has_same_material).copied().collect();
    let adjacency = Adjacency::of_vertices(level);
    for (layer, rule) in level.layers.iter_mut().zip(&rules) {
        let source = original.layers.iter().find(|source| source.semantic == layer.semantic);
        let (Some(rule), Some(source)) = (rule, source) else { continue };
        if source.component_count == layer.component_count {
            let forms = forms_of(
                rule,
                LayerOfMesh { layer, triangles: adjacency.triangles() },
                LayerOfMesh { layer: source, triangles: &original.triangles },
                &pairs,
            );
            apply(rule, layer, &solve(&forms, &adjacency));
        }
    }
}

/// A layer, and the triangles whose corners have its values.
#[derive(Clone, Copy)]
struct LayerOfMesh<'m> {
    layer: &'m AttributeLayer,
    triangles: &'m [[u32; 3]],
}

/// Collects what the pairs wish for each triangle of the level.
fn forms_of(
    rule: &FitRule,
    LayerOfMesh { layer, triangles }: LayerOfMesh<'_>,
    original: LayerOfMesh<'_>,
    pairs: &[Pair],
) -> Vec<CornerForm<WIDTH>> {
    let mut forms = vec![CornerForm::default(); triangles.len()];
    for pair in pairs {
        let corners = triangles[pair.level.triangle as usize].map(|v| rule.value(layer, v));
        let sources =
            original.triangles[pair.original.triangle as usize].map(|v| rule.value(original.layer, v));
        let now = rule.mixed(&corners, pair.level.shares);
        let wanted = rule.mixed(&sources, pair.original.shares);
        let wish: Value = std::array::from_fn(|k| wanted[k] - now[k]);
        let squared = squared_difference(&wanted, &now);
        if !squared.is_finite() {
            continue;
        }
        if squared > 0.0 {
            let squared_scale = rule.squared_scale(&corners).max(rule.squared_scale(&sources));
            let weight = squared_scale / (squared_scale + squared);
            forms[pair.level.triangle as usize].add(pair.area * weight * weight, pair.level.shares, wish);
        } else {
            forms[pair.level.triangle as usize].add(pair.area, pair.level.shares, wish);
        }
    }
    forms
}

/// Returns the change of each vertex.
fn solve(forms: &[CornerForm<WIDTH>], adjacency: &Adjacency) -> Vec<Value> {
    let mut changes = vec![[0.0; WIDTH]; adjacency.position_count()];
    for _ in 0..SWEEPS {
        for v in 0..changes.len() {
            let (mut weight, mut rest) = (0.0, [0.0; WIDTH]);
            for &at in adjacency.corners(v as u32) {
                let (t, corner) = (at as usize / 3, at as usize % 3);
                let around = adjacency.triangles()[t].map(|v| changes[v as usize]);
                weight += forms[t].weight(corner);
                rest.iter_mut().zip(forms[t].rest(corner, around)).for_each(|(sum, rest)| *sum += rest);
            }
            if weight > 0.0 {
                changes[v] = rest.map(|rest| rest / (weight * (1.0 + STIFFNESS)));
            }
        }
    }
    changes
}

fn apply(rule: &FitRule, layer: &mut AttributeLayer, changes: &[Value]) {
    for (v, change) in changes.iter().enumerate().filter(|(_, change)| **change != [0.0; WIDTH]) {
        let before = rule.value(layer, v as u32);
        let mut value: Value =
            std::array::from_fn(|k| (before[k] + change[k]).clamp(rule.range[0], rule.range[1]));
        if rule.is_direction {
            value = unit(value).unwrap_or(before);
        }
        for (k, value) in value.into_iter().enumerate().take(rule.width) {
            let index = v * rule.row + k;
            match &mut layer.data {
                LayerData::F32(values) => values[index] = value as f32,
                LayerData::F64(values) => values[index] = value,
                // Conversion from floats saturates.
                LayerData::U8(values) => values[index] = (value * 255.0).round() as u8,
                LayerData::U16(values) => values[index] = (value * 65535.0).round() as u16,
                LayerData::I8(values) => values[index] = (value * 127.0).round() as i8,
                LayerData::I16(values) => values[index] = (value * 32767.0).round() as i16,
                LayerData::U32(_) | LayerData::I32(_) => {}
            }
        }
    }
}
