//! Codes the integers of attribute layers, vertex by vertex, relative to the vertices around.
//!
//! For each layer there are a few predictions (the target's value, the ring's mean, its affine fit, for normals the
//! geometry too), and the one that did best lately is taken. The rest is a number whose context is how far the ring spreads around the
//! prediction. Joints are labels: mostly the same as a neighbour's; weights follow the joints that they belong to.
//!
//! Integers only; all that is looked at is what a reader has.

use super::super::entropy::{AdaptiveBit, AdaptiveNumber, Coder, Part, Rate};
use super::Effort;
use super::direction_model::{DirectionModel, TangentSources};
use super::layers::{LayerForm, NumberType, Transform};
use super::residuals::{Contest, Residuals, scale_of};
use super::ring_fit::{RingFit, WEIGHT_BITS};
use crate::mesh::Semantic;

/// What is known around a vertex when its attributes are coded.
#[derive(Clone, Copy, Debug)]
pub(super) struct LayerHood<'a> {
    /// The vertex that it collapses to, or any that is near; none for the first of all.
    pub(super) target: Option<u32>,
    /// Vertices that it shares triangles with, in ring order; those of other places are not among them.
    pub(super) ring: &'a [u32],
    /// Fitted to the places of the ring.
    pub(super) fit: &'a RingFit,
}

/// The integers of a layer, vertex by vertex.
#[derive(Clone, Debug, Default)]
pub(super) struct LayerValues {
    integers: Vec<i32>,
    count: usize,
}

impl LayerValues {
    /// No vertices, so many integers each.
    pub(super) fn new(integer_count: usize) -> Self {
        Self { integers: Vec::new(), count: integer_count }
    }

    /// All integers of a layer.
    pub(super) fn from_integers(integers: Vec<i32>, integer_count: usize) -> Self {
        Self { integers, count: integer_count }
    }

    /// The integers of a vertex.
    #[inline]
    pub(super) fn of(&self, vertex: u32) -> &[i32] {
        &self.integers[vertex as usize * self.count..][..self.count]
    }

    /// The integers of all vertices.
    pub(super) fn integers(&self) -> &[i32] {
        &self.integers
    }

    /// Appends integers of the next vertex.
    pub(super) fn push(&mut self, integers: &[i32]) {
        self.integers.extend_from_slice(integers);
    }

    /// Vertices that are whole.
    pub(super) fn vertex_count(&self) -> usize {
        self.integers.len() / self.count
    }

    /// Forgets all but the first vertices.
    pub(super) fn truncate(&mut self, vertex_count: usize) {
        self.integers.truncate(vertex_count * self.count);
    }
}

/// All layers of a stream.
#[derive(Clone, Debug)]
pub(super) struct LayerModel {
    layers: Vec<OneLayer>,
    /// The order in which layers are coded, what others are predicted from first; and whose the bits are.
    order: Vec<(usize, Part)>,
}

#[derive(Clone, Debug)]
enum OneLayer {
    /// Normals, and other directions of which the geometry tells nothing.
    Directions(DirectionModel),
    Tangents(DirectionModel, Option<TangentSources>),
    Numbers(NumberModel),
    Labels(LabelModel),
    /// Weights of the joints of another layer.
    Weights(NumberModel, usize),
}

impl LayerModel {
    /// Nothing learned.
    pub(super) fn new(forms: &[LayerForm], effort: Effort) -> Self {
        let layers: Vec<_> = forms
            .iter()
            .map(|form| match form.transform {
                Transform::Octahedral { bits } => {
                    let model = DirectionModel::new(bits, form.integer_count() > 2, effort);
                    match form.semantic {
                        Semantic::Tangent => OneLayer::Tangents(model, TangentSources::of(forms)),
                        _ => OneLayer::Directions(model),
                    }
                }
                _ if is_label(form) => OneLayer::Labels(LabelModel::new(form)),
                _ => match joints_of(forms, form) {
                    Some(joints) => OneLayer::Weights(NumberModel::new(form, effort), joints),
                    None => OneLayer::Numbers(NumberModel::new(form, effort)),
                },
            })
            .collect();
        let is_last =
            |index: &usize| matches!(layers[*index], OneLayer::Tangents(..) | OneLayer::Weights(..));
        let mut order: Vec<_> = (0..).zip(forms).map(|(index, form)| (index, part_of(form))).collect();
        order.sort_by_key(|(index, _)| is_last(index));
        Self { layers, order }
    }

    /// Codes the integers of the next vertex in all layers; `actual` are all layers of the writer and the vertex there.
    ///
    /// Where the coder overran, the caller truncates what was appended.
    pub(super) fn code<C: Coder>(
        &mut self,
        coder: &mut C,
        values: &mut [LayerValues],
        hood: &LayerHood<'_>,
        actual: Option<(&[LayerValues], u32)>,
    ) {
        for &(index, part) in &self.order {
            coder.part(part);
            let meant = actual.map(|(layers, vertex)| layers[index].of(vertex));
            let mut own = std::mem::take(&mut values[index]);
            match &mut self.layers[index] {
                OneLayer::Directions(model) => model.code(coder, &mut own, (hood, hood.fit.normal), meant),
                OneLayer::Tangents(model, sources) => {
                    let vertex = own.vertex_count() as u32;
                    let tangent = sources.as_ref().map(|sources| sources.tangent(values, hood, vertex));
                    model.code(coder, &mut own, (hood, tangent.unwrap_or_default()), meant);
                }
                OneLayer::Labels(model) => model.code(coder, &mut own, hood, meant),
                OneLayer::Numbers(model) => {
                    model.code(coder, &mut own, meant, |own, coded| plain_hints(own, hood, coded.len()));
                }
                OneLayer::Weights(model, joints) => {
                    let joints = &values[*joints];
                    model.code(coder, &mut own, meant, |own, coded| weight_hints(own, joints, hood, coded));
                }
            }
            values[index] = own;
        }
    }
}

fn part_of(form: &LayerForm) -> Part {
    match form.semantic {
        Semantic::Normal => Part::Normals,
        Semantic::TexCoord(_) => Part::TexCoords,
        _ => Part::OtherLayers,
    }
}

/// True for integers that name something: nothing lies between two of them.
fn is_label(form: &LayerForm) -> bool {
    let is_name = matches!(form.semantic, Semantic::Joints(_) | Semantic::Generic(_));
    is_name && form.number_type != NumberType::F32 && !form.normalized
}

/// The layer with the joints that weights belong to.
fn joints_of(forms: &[LayerForm], form: &LayerForm) -> Option<usize> {
    let Semantic::Weights(set) = form.semantic else { return None };
    let matches =
        |f: &LayerForm| f.semantic == Semantic::Joints(set) && f.component_count == form.component_count;
    forms.iter().position(|f| is_label(f) && matches(f))
}

/// Predictions of one integer, and how far those around spread.
struct Hints {
    predictions: [i64; 4],
    /// How far two of them are from each other, in 1/16.
    conflict: u64,
    /// The mean distance of the ring's values from their mean, in 1/16.
    spread: u64,
}

impl Hints {
    fn alone(value: i64) -> Self {
        Self { predictions: [value; 4], conflict: u64::from(u32::MAX), spread: u64::from(u32::MAX) }
    }
}

fn plain_hints(values: &LayerValues, hood: &LayerHood<'_>, component: usize) -> Hints {
    let value = |vertex: u32| i64::from(values.of(vertex)[component]);
    let Some(target) = hood.target.map(value) else { return Hints::alone(0) };
    if hood.ring.is_empty() {
        return Hints::alone(target);
    }
    let n = hood.ring.len() as i64;
    let (mut sum, mut weighted) = (0, 0);
    for (&vertex, &weight) in hood.ring.iter().zip(&hood.fit.weights) {
        let from_target = value(vertex) - target;
        sum += from_target;
        weighted += from_target * i64::from(weight);
    }
    let mean = target + (2 * sum + n).div_euclid(2 * n);
    let affine = target + ((weighted + (1 << WEIGHT_BITS >> 1)) >> WEIGHT_BITS);
    let spread: u64 = hood.ring.iter().map(|&v| (value(v) - mean).unsigned_abs()).sum();
    let conflict = 16 * (affine - mean).unsigned_abs();
    Hints {
        conflict,
        predictions: [affine, mean, (affine + mean) >> 1, target],
        spread: 16 * spread / n as u64,
    }
}

/// Predictions of the weight of a component's joint, by the weights that the vertices around give to that joint.
fn weight_hints(values: &LayerValues, joints: &LayerValues, hood: &LayerHood<'_>, coded: &[i32]) -> Hints {
    let component = coded.len();
    let joint = joints.of(values.vertex_count() as u32)[component];
    let weight = |vertex: u32| -> i64 {
        let (joints, weights) = (joints.of(vertex), values.of(vertex));
        // The same joint at the same place, since names of joints without weight repeat.
        let at = Some(component).filter(|&c| joints[c] == joint);
        at.or_else(|| joints.iter().position(|&j| j == joint)).map_or(0, |c| i64::from(weights[c]))
    };
    let Some(target) = hood.target else { return Hints::alone(0) };
    let sum: i64 = values.of(target).iter().map(|&w| i64::from(w)).sum();
    let left = sum - coded.iter().map(|&w| i64::from(w)).sum::<i64>();
    let n = hood.ring.len().max(1) as i64;
    let mean = hood.ring.iter().map(|&v| weight(v)).sum::<i64>() / n;
    let spread: u64 = hood.ring.iter().map(|&v| (weight(v) - mean).unsigned_abs()).sum();
    let rest = left.clamp(0, sum.max(0));
    let conflict = 16 * (mean - rest).unsigned_abs();
    Hints {
        conflict,
        predictions: [mean, rest, weight(target), mean.min(rest)],
        spread: 16 * spread / n as u64,
    }
}

/// Integers on an even scale.
#[derive(Clone, Debug)]
struct NumberModel {
    contests: Vec<Contest<4>>,
    residuals: Residuals,
    recent: Vec<u64>,
    /// Smallest and largest value there can be.
    limits: (i64, i64),
    /// The vertex that is being coded.
    coded: Vec<i32>,
}

impl NumberModel {
    fn new(form: &LayerForm, effort: Effort) -> Self {
        let limits = match (&form.transform, form.number_type) {
            (Transform::Uniform { bits, .. }, _) => (0, (1i64 << bits) - 1),
            (_, NumberType::U8) => (0, 0xFF),
            (_, NumberType::U16) => (0, 0xFFFF),
            _ => (i64::from(i32::MIN), i64::from(i32::MAX)),
        };
        let count = form.integer_count();
        Self {
            contests: vec![Contest::new(); count],
            residuals: Residuals::new(effort, count),
            recent: vec![0; count],
            limits,
            coded: Vec::with_capacity(count),
        }
    }

    fn code<C: Coder>(
        &mut self,
        coder: &mut C,
        values: &mut LayerValues,
        meant: Option<&[i32]>,
        hints: impl Fn(&LayerValues, &[i32]) -> Hints,
    ) {
        self.coded.clear();
        let mut before = 0u64;
        for component in 0..values.count {
            let Hints { predictions, conflict, spread } = hints(values, &self.coded);
            let contest = &mut self.contests[component];
            let predicted = predictions[contest.best()].clamp(self.limits.0, self.limits.1) as i32;
            let scales = [spread, conflict, self.recent[component], before].map(scale_of);
            let off = meant.map_or(0, |m| m[component].wrapping_sub(predicted));
            let off = self.residuals.signed(coder, component, scales, off);
            let value = predicted.wrapping_add(off);
            contest.learn(predictions.map(|p| (p - i64::from(value)).unsigned_abs()));
            let size = 16 * u64::from(off.unsigned_abs());
            self.recent[component] = (7 * self.recent[component] + size) / 8;
            before = size;
            self.coded.push(value);
        }
        values.integers.extend_from_slice(&self.coded);
    }
}

/// Kinds of labels around a vertex that are asked for.
const MOST_KNOWN: usize = 32;

/// Integers that name something.
#[derive(Clone, Debug)]
struct LabelModel {
    /// Whether all is as at a vertex around: the target, then each other kind in the order of the ring.
    is_known: [AdaptiveBit; 4],
    numbers: AdaptiveNumber,
    known: Vec<u32>,
}

impl LabelModel {
    fn new(form: &LayerForm) -> Self {
        Self {
            is_known: [AdaptiveBit::new(Rate::Steady); 4],
            numbers: AdaptiveNumber::new(form.integer_count(), Rate::Steady),
            known: Vec::new(),
        }
    }

    fn code<C: Coder>(
        &mut self,
        coder: &mut C,
        values: &mut LayerValues,
        hood: &LayerHood<'_>,
        meant: Option<&[i32]>,
    ) {
        self.known.clear();
        for vertex in hood.target.into_iter().chain(hood.ring.iter().copied()) {
            if self.known.len() == MOST_KNOWN {
                break;
            }
            if !self.known.iter().any(|&k| values.of(k) == values.of(vertex)) {
                self.known.push(vertex);
            }
        }
        for (at, &vertex) in self.known.iter().enumerate() {
            let bit = &mut self.is_known[at.min(3)];
            if bit.code(coder, meant.is_some_and(|m| m == values.of(vertex))) {
                let from = vertex as usize * values.count;
                values.integers.extend_from_within(from..from + values.count);
                return;
            }
        }
        let from = hood.target.map(|v| v as usize * values.count);
        for component in 0..values.count {
            let near = from.map_or(0, |from| values.integers[from + component]);
            let off = meant.map_or(0, |m| m[component].wrapping_sub(near));
            let value = near.wrapping_add(self.numbers.signed(coder, component, off));
            values.integers.push(value);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::super::entropy::{RangeReader, RangeWriter};
    use super::super::layers::LayerOptions;
    use super::*;
    use crate::mesh::{AttributeLayer, LayerData, Random};

    /// A vertex of a made-up refinement: what is around it, and where it is.
    struct Site {
        target: Option<u32>,
        ring: Vec<u32>,
        place: [i32; 3],
    }

    /// Points of a grid in random order, each with the nearest earlier ones around it.
    fn sites(side: u32, seed: u64) -> Vec<Site> {
        let mut random = Random::new(seed);
        let mut order: Vec<u32> = (0..side * side).collect();
        (1..order.len()).rev().for_each(|i| order.swap(i, random.below(i as u32 + 1) as usize));
        let place = |cell: u32| {
            let (x, y) = ((cell % side) as i32 * 40, (cell / side) as i32 * 40);
            [x, y, (x * x + y * y) / (40 * side as i32)]
        };
        let mut sites: Vec<Site> = Vec::new();
        for &cell in &order {
            let here = place(cell);
            let distance = |other: [i32; 3]| (other[0] - here[0]).pow(2) + (other[1] - here[1]).pow(2);
            let mut near: Vec<u32> = (0..sites.len() as u32).collect();
            near.sort_by_key(|&v| (distance(sites[v as usize].place), v));
            near.truncate(6);
            let target = near.first().copied();
            let quadrant = |v: u32| {
                let p = sites[v as usize].place;
                let (x, y) = (f64::from(p[0] - here[0]), f64::from(p[1] - here[1]));
                if y >= 0.0 { -x / (x.abs() + y.abs()) } else { 2.0 + x / (x.abs() + y.abs()) }
            };
            near.sort_by(|&a, &b| quadrant(a).total_cmp(&quadrant(b)));
            sites.push(Site { target, ring: near, place: here });
        }
        sites
    }

    fn layer(semantic: Semantic, count: u8, data: LayerData) -> AttributeLayer {
        AttributeLayer { semantic, component_count: count, normalized: false, data }
    }

    /// Layers that go evenly over the places.
    fn even_layers(sites: &[Site]) -> Vec<AttributeLayer> {
        let of = |f: &dyn Fn(f32, f32) -> Vec<f32>| -> Vec<f32> {
            sites.iter().flat_map(|s| f(s.place[0] as f32 / 1000.0, s.place[1] as f32 / 1000.0)).collect()
        };
        let unit = |x: f32, y: f32| {
            let length = (x * x + y * y + 0.3).sqrt();
            [x / length, y / length, -(0.3f32.sqrt()) / length]
        };
        let joints = |x: f32| if x < 0.4 { [3u8, 7, 0, 0] } else { [7, 3, 9, 0] };
        vec![
            AttributeLayer::from_f32(Semantic::Normal, 3, of(&|x, y| unit(x, y).to_vec())),
            AttributeLayer::from_f32(
                Semantic::Tangent,
                4,
                of(&|x, y| unit(y, x).into_iter().chain([if x < 0.5 { 1.0 } else { -1.0 }]).collect()),
            ),
            AttributeLayer::from_f32(Semantic::TexCoord(0), 2, of(&|x, y| vec![x + 0.3 * y, y - 0.1 * x])),
            AttributeLayer {
                normalized: true,
                ..layer(
                    Semantic::Color(0),
                    3,
                    LayerData::U8(
                        of(&|x, y| vec![x * 99.0, y * 99.0, 50.0]).into_iter().map(|x| x as u8).collect(),
                    ),
                )
            },
            layer(
                Semantic::Joints(0),
                4,
                LayerData::U8(sites.iter().flat_map(|s| joints(s.place[0] as f32 / 1000.0)).collect()),
            ),
            AttributeLayer::from_f32(
                Semantic::Weights(0),
                4,
                of(&|x, _| if x < 0.4 { vec![1.0 - x, x, 0.0, 0.0] } else { vec![x, 1.0 - x, 0.0, 0.0] }),
            ),
            layer(
                Semantic::Generic("part".into()),
                1,
                LayerData::U32(sites.iter().map(|s| if s.place[1] < 300 { u32::MAX } else { 12 }).collect()),
            ),
        ]
    }

    /// The same without any order in them.
    fn wild_layers(count: usize) -> Vec<AttributeLayer> {
        let mut random = Random::new(77);
        let mut floats: Vec<f32> = (0..3 * count).map(|_| f32::from_bits(random.next_u64() as u32)).collect();
        floats[0] = f32::NAN;
        let mut bits = |n: usize| -> Vec<u32> { (0..n * count).map(|_| random.next_u64() as u32).collect() };
        let directions = bits(3);
        let normals = directions.chunks_exact(3).flat_map(|v| {
            let v = [v[0], v[1], v[2]].map(|x| f64::from(x) / 2f64.powi(31) - 1.0);
            let length = v.iter().map(|x| x * x).sum::<f64>().sqrt();
            v.map(|x| (x / length) as f32)
        });
        vec![
            AttributeLayer::from_f32(Semantic::Normal, 3, normals.collect()),
            AttributeLayer::from_f32(Semantic::Generic("wild".into()), 3, floats),
            layer(Semantic::Joints(1), 4, LayerData::U16(bits(4).iter().map(|&x| x as u16).collect())),
            layer(Semantic::Weights(1), 4, LayerData::U16(bits(4).iter().map(|&x| x as u16).collect())),
            layer(Semantic::Generic("id".into()), 1, LayerData::U32(bits(1))),
        ]
    }

    fn code<C: Coder>(
        coder: &mut C,
        sites: &[Site],
        forms: &[LayerForm],
        actual: Option<&[LayerValues]>,
        effort: Effort,
    ) -> Vec<LayerValues> {
        let mut model = LayerModel::new(forms, effort);
        let mut values: Vec<_> = forms.iter().map(|form| LayerValues::new(form.integer_count())).collect();
        let mut fit = RingFit::default();
        for (vertex, site) in sites.iter().enumerate() {
            let places: Vec<_> = site.ring.iter().map(|&v| sites[v as usize].place).collect();
            fit.measure(site.place, &places, true);
            let hood = LayerHood { target: site.target, ring: &site.ring, fit: &fit };
            model.code(coder, &mut values, &hood, actual.map(|layers| (layers, vertex as u32)));
        }
        values
    }

    /// Bits a vertex of each layer by itself, weights with their joints; what is read must be what was written.
    fn bits(sites: &[Site], layers: &[AttributeLayer], options: &LayerOptions, effort: Effort) -> Vec<f64> {
        let each: Vec<f64> = (0..layers.len())
            .map(|i| {
                let of = |layers| bits_together(sites, layers, options, effort);
                match layers[i].semantic {
                    Semantic::Weights(_) => of(&layers[i - 1..=i]) - of(&layers[i - 1..i]),
                    _ => of(&layers[i..=i]),
                }
            })
            .collect();
        // Together they may only gain.
        let all = bits_together(sites, layers, options, effort);
        assert!(all < each.iter().sum::<f64>() + 0.5, "{all} for {each:?}");
        each
    }

    /// Bits a vertex of all layers; what is read must be what was written.
    fn bits_together(
        sites: &[Site],
        layers: &[AttributeLayer],
        options: &LayerOptions,
        effort: Effort,
    ) -> f64 {
        let forms: Vec<_> = layers.iter().map(|layer| LayerForm::of(layer, options)).collect();
        let whole: Vec<_> = forms
            .iter()
            .zip(layers)
            .map(|(form, layer)| LayerValues::from_integers(form.integers(layer), form.integer_count()))
            .collect();
        let mut writer = RangeWriter::new();
        code(&mut writer, sites, &forms, Some(&whole), effort);
        let (bytes, _) = writer.finish();
        let read = code(&mut RangeReader::new(&bytes, true), sites, &forms, None, effort);
        assert!(read.iter().zip(&whole).all(|(a, b)| a.integers() == b.integers()));
        bytes.len() as f64 * 8.0 / sites.len() as f64
    }

    #[test]
    fn even_layers_take_few_bits() {
        let sites = sites(30, 1);
        let layers = even_layers(&sites);
        let most = [5.8, 6.0, 10.5, 2.6, 0.3, 5.0, 0.3];
        for effort in [Effort::Fast, Effort::Default, Effort::Small] {
            let found = bits(&sites, &layers, &LayerOptions::default(), effort);
            assert!(found.iter().zip(most).all(|(found, most)| *found < most), "{effort:?}: {found:?}");
        }
    }

    #[test]
    fn layers_may_come_in_any_order() {
        let sites = sites(20, 4);
        let mut layers = even_layers(&sites);
        let options = LayerOptions::default();
        let before = bits_together(&sites, &layers, &options, Effort::Default);
        layers.reverse();
        // Weights are before their joints now, tangents before what they are told from.
        let after = bits_together(&sites, &layers, &options, Effort::Default);
        assert!((before - after).abs() < 0.05, "{before} became {after}");
    }

    #[test]
    fn layers_without_order_come_back_too() {
        let sites = sites(16, 2);
        let options = LayerOptions::default();
        for effort in [Effort::Fast, Effort::Small] {
            let found = bits(&sites, &wild_layers(sites.len()), &options, effort);
            let least = [17.0, 88.0, 60.0, 60.0, 30.0];
            assert!(found.iter().zip(least).all(|(found, least)| *found < 1.2 * least + 8.0), "{found:?}");
            let even = even_layers(&sites);
            bits(&sites, &even, &options.clone().with_lossless(true), effort);
            bits(&sites, &even, &options.clone().with_normal_bits(16).with_texcoord_bits(24), effort);
            bits(&sites, &even, &options.clone().with_normal_bits(2).with_texcoord_bits(1), effort);
        }
    }

    #[test]
    fn any_bytes_give_integers_within_their_form() {
        let sites = sites(10, 3);
        let mut random = Random::new(5);
        let mut layers = even_layers(&sites);
        layers.extend(wild_layers(sites.len()));
        let forms: Vec<_> =
            layers.iter().map(|layer| LayerForm::of(layer, &LayerOptions::default())).collect();
        for length in [0, 1, 10, 100, 1000, 5000] {
            let bytes: Vec<u8> = (0..length).map(|_| random.next_u64() as u8).collect();
            let values = code(&mut RangeReader::new(&bytes, true), &sites, &forms, None, Effort::Default);
            for (form, values) in forms.iter().zip(values) {
                assert_eq!(values.vertex_count(), sites.len());
                let mut layer = form.empty_layer();
                form.append(values.integers(), &mut layer.data);
                assert_eq!(layer.data.len(), sites.len() * form.component_count as usize);
            }
        }
    }

    #[test]
    fn vertices_that_are_not_whole_can_be_forgotten() {
        let mut values = LayerValues::from_integers((0..12).collect(), 3);
        values.truncate(2);
        assert_eq!((values.vertex_count(), values.of(1)), (2, &[3, 4, 5][..]));
    }
}
