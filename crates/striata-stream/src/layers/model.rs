//! Codes the integers of attribute layers, vertex by vertex, relative to the vertices around.
//!
//! For each layer there are a few predictions (the target's value, the ring's mean, its affine fit, for normals the
//! geometry too), and the one that did best lately is taken. The rest is a number whose context is how far the ring spreads
//! around the prediction. From version 2 on, exact copies are coded first ([`LayerHistory`](crate::layers::history::LayerHistory)).
//! Joints are labels: mostly the same as a neighbor's; weights follow the joints that they belong to.
//!
//! Integers only; all that is looked at is what a reader has.

use striata::mesh::Semantic;

use crate::entropy::{AdaptiveBit, AdaptiveNumber, Coder, Part, Rate};
use crate::format::form::{Effort, StreamVersion};
use crate::layers::direction_model::DirectionModel;
use crate::layers::form::{LayerForm, NumberType, Transform};
use crate::layers::hood::{LayerHood, LayerValues};
use crate::layers::number_model::{NumberModel, plain_hints, weight_hints};
use crate::layers::tangents::TangentSources;

/// All layers of a stream.
#[derive(Clone, Debug)]
pub(crate) struct LayerModel {
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
    pub(crate) fn new(forms: &[LayerForm], terms: (Effort, StreamVersion)) -> Self {
        let layers: Vec<_> = forms
            .iter()
            .map(|form| match form.transform {
                Transform::Octahedral { bits } => {
                    let model = DirectionModel::new(bits, form.integer_count() > 2, terms);
                    match form.semantic {
                        Semantic::Tangent => OneLayer::Tangents(model, TangentSources::of(forms)),
                        _ => OneLayer::Directions(model),
                    }
                }
                _ if is_label(form) => OneLayer::Labels(LabelModel::new(form)),
                _ => match joints_of(forms, form) {
                    Some(joints) => OneLayer::Weights(NumberModel::new(form, terms), joints),
                    None => OneLayer::Numbers(NumberModel::new(form, terms)),
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
    pub(crate) fn code<C: Coder>(
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
                    model.code(coder, &mut own, (hood, meant), |own, coded| {
                        plain_hints(own, hood, coded.len())
                    });
                }
                OneLayer::Weights(model, joints) => {
                    let joints = &values[*joints];
                    let hints = |own: &LayerValues, coded: &[i32]| weight_hints(own, joints, hood, coded);
                    model.code(coder, &mut own, (hood, meant), hints);
                }
            }
            values[index] = own;
        }
    }

    /// Forgets what is known of all but the first vertices.
    pub(crate) fn truncate(&mut self, vertex_count: usize) {
        for layer in &mut self.layers {
            match layer {
                OneLayer::Directions(model) | OneLayer::Tangents(model, _) => model.truncate(vertex_count),
                OneLayer::Numbers(model) | OneLayer::Weights(model, _) => model.truncate(vertex_count),
                OneLayer::Labels(_) => {}
            }
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
                values.copy(vertex);
                return;
            }
        }
        for component in 0..values.integer_count() {
            let near = hood.target.map_or(0, |v| values.of(v)[component]);
            let off = meant.map_or(0, |m| m[component].wrapping_sub(near));
            let value = near.wrapping_add(self.numbers.signed(coder, component, off));
            values.push(&[value]);
        }
    }
}

#[cfg(test)]
mod tests {
    use striata::mesh::{AttributeLayer, LayerData, Random};

    use super::*;
    use crate::entropy::{RangeReader, RangeWriter};
    use crate::layers::options::LayerOptions;
    use crate::layers::ring_fit::RingFit;

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
        let mut model = LayerModel::new(forms, (effort, StreamVersion::Two));
        let mut values: Vec<_> = forms.iter().map(|form| LayerValues::new(form.integer_count())).collect();
        let mut fit = RingFit::default();
        for (vertex, site) in sites.iter().enumerate() {
            let places: Vec<_> = site.ring.iter().map(|&v| sites[v as usize].place).collect();
            fit.measure(site.place, &places, true);
            let hood = LayerHood::new(site.target, &site.ring, &fit);
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
