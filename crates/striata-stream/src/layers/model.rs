//! Codes the integers of all attribute layers, vertex by vertex, relative to the surrounding vertices.
//!
//! For each layer there are a few predictions (the target's value, the ring's mean, its affine fit, and
//! for normals also the geometry), and the model uses the one that did best recently. The residual is
//! coded in the context of how far the ring's values spread around the prediction. Exact copies are coded
//! first ([`LayerHistory`](crate::layers::history::LayerHistory)). Joints are labels, which mostly equal a
//! neighbor's; weights follow the joints that they belong to.
//!
//! All arithmetic is on integers and uses only data that a reader has.

use striata::mesh::Semantic;

use crate::entropy::{AdaptiveBit, AdaptiveNumber, Coder, Part, Rate};
use crate::format::effort::Effort;
use crate::layers::direction_model::{DirectionModel, DirectionPlace};
use crate::layers::form::{LayerForm, ValueTransform};
use crate::layers::layer_neighborhood::{LayerNeighborhood, LayerValues};
use crate::layers::number_model::{NumberModel, NumberPlace, predict_number, predict_weight};
use crate::layers::tangents::TangentSources;

/// Models of all layers of a stream.
#[derive(Clone, Debug)]
pub(crate) struct LayerModel {
    layers: Vec<OneLayer>,
    /// Layers in coding order, those that others are predicted from first, and the part of the stream to
    /// which their bits are attributed.
    order: Vec<(usize, Part)>,
}

/// The model of one layer.
#[derive(Clone, Debug)]
enum OneLayer {
    /// Normals, and other directions that cannot be derived from the geometry.
    Directions(DirectionModel),
    Tangents(DirectionModel, Option<TangentSources>),
    Numbers(NumberModel),
    Labels(LabelModel),
    /// Weights of the joints in another layer.
    Weights(NumberModel, usize),
}

impl LayerModel {
    /// Creates untrained models.
    pub(crate) fn new(forms: &[LayerForm], effort: Effort) -> Self {
        let layers: Vec<_> = forms
            .iter()
            .map(|form| match form.transform {
                ValueTransform::Octahedral { bits } => {
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

    /// Codes the integers of the next vertex in all layers. A writer passes all its layers and the index
    /// of the vertex in them.
    ///
    /// If the coder overruns, the caller must truncate what was appended.
    pub(crate) fn code<C: Coder>(
        &mut self,
        coder: &mut C,
        values: &mut [LayerValues],
        neighborhood: &LayerNeighborhood<'_>,
        actual: Option<(&[LayerValues], u32)>,
    ) {
        for &(index, part) in &self.order {
            coder.part(part);
            let own_actual = actual.map(|(layers, vertex)| layers[index].of(vertex));
            let mut own = std::mem::take(&mut values[index]);
            match &mut self.layers[index] {
                OneLayer::Directions(model) => model.code(
                    coder,
                    &mut own,
                    DirectionPlace { neighborhood, geometric: neighborhood.fit.normal },
                    own_actual,
                ),
                OneLayer::Tangents(model, sources) => {
                    let vertex = own.vertex_count() as u32;
                    let tangent =
                        sources.as_ref().map(|sources| sources.tangent(values, neighborhood, vertex));
                    model.code(
                        coder,
                        &mut own,
                        DirectionPlace { neighborhood, geometric: tangent.unwrap_or_default() },
                        own_actual,
                    );
                }
                OneLayer::Labels(model) => model.code(coder, &mut own, neighborhood, own_actual),
                OneLayer::Numbers(model) => {
                    model.code(
                        coder,
                        &mut own,
                        NumberPlace { neighborhood, actual: own_actual },
                        |own, coded| predict_number(own, neighborhood, coded.len()),
                    );
                }
                OneLayer::Weights(model, joints) => {
                    let joints = &values[*joints];
                    let predict =
                        |own: &LayerValues, coded: &[i32]| predict_weight(own, joints, neighborhood, coded);
                    model.code(coder, &mut own, NumberPlace { neighborhood, actual: own_actual }, predict);
                }
            }
            values[index] = own;
        }
    }

    /// Removes the history of all but the first vertices.
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

/// Returns the part of the stream to which a layer's bits are attributed.
pub(crate) fn part_of(form: &LayerForm) -> Part {
    match form.semantic {
        Semantic::Normal => Part::Normals,
        Semantic::TexCoord(_) => Part::TexCoords,
        _ => Part::OtherLayers,
    }
}

/// Whether a layer's integers are identifiers, between which no interpolation makes sense.
fn is_label(form: &LayerForm) -> bool {
    let is_name = matches!(form.semantic, Semantic::Joints(_) | Semantic::Generic(_));
    is_name && !form.number_type.is_float() && !form.normalized
}

/// Returns the layer with the joints that a layer of weights belongs to.
fn joints_of(forms: &[LayerForm], form: &LayerForm) -> Option<usize> {
    let Semantic::Weights(set) = form.semantic else { return None };
    let matches =
        |f: &LayerForm| f.semantic == Semantic::Joints(set) && f.component_count == form.component_count;
    forms.iter().position(|f| is_label(f) && matches(f))
}

/// Maximum number of distinct surrounding labels that are tried.
const MOST_KNOWN: usize = 32;

/// Model of a layer of identifiers.
#[derive(Clone, Debug)]
struct LabelModel {
    /// Whether all components equal those of a surrounding vertex: first the target, then each other
    /// distinct value in ring order.
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
        neighborhood: &LayerNeighborhood<'_>,
        actual: Option<&[i32]>,
    ) {
        self.known.clear();
        for vertex in neighborhood.target.into_iter().chain(neighborhood.ring.iter().copied()) {
            if self.known.len() == MOST_KNOWN {
                break;
            }
            if !self.known.iter().any(|&k| values.of(k) == values.of(vertex)) {
                self.known.push(vertex);
            }
        }
        for (at, &vertex) in self.known.iter().enumerate() {
            let bit = &mut self.is_known[at.min(3)];
            if bit.code(coder, actual.is_some_and(|m| m == values.of(vertex))) {
                values.copy(vertex);
                return;
            }
        }
        for component in 0..values.integer_count() {
            let near = neighborhood.target.map_or(0, |v| values.of(v)[component]);
            let off = actual.map_or(0, |m| m[component].wrapping_sub(near));
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

    /// A vertex of a synthetic refinement: its position and neighborhood.
    struct Site {
        target: Option<u32>,
        ring: Vec<u32>,
        grid_point: [i32; 3],
    }

    /// Points of a grid in random order, each surrounded by the nearest earlier ones.
    fn sites(side: u32, seed: u64) -> Vec<Site> {
        let mut random = Random::new(seed);
        let mut order: Vec<u32> = (0..side * side).collect();
        (1..order.len()).rev().for_each(|i| order.swap(i, random.below(i as u32 + 1) as usize));
        let grid_point = |cell: u32| {
            let (x, y) = ((cell % side) as i32 * 40, (cell / side) as i32 * 40);
            [x, y, (x * x + y * y) / (40 * side as i32)]
        };
        let mut sites: Vec<Site> = Vec::new();
        for &cell in &order {
            let here = grid_point(cell);
            let distance = |other: [i32; 3]| (other[0] - here[0]).pow(2) + (other[1] - here[1]).pow(2);
            let mut near: Vec<u32> = (0..sites.len() as u32).collect();
            near.sort_by_key(|&v| (distance(sites[v as usize].grid_point), v));
            near.truncate(6);
            let target = near.first().copied();
            let quadrant = |v: u32| {
                let p = sites[v as usize].grid_point;
                let (x, y) = (f64::from(p[0] - here[0]), f64::from(p[1] - here[1]));
                if y >= 0.0 { -x / (x.abs() + y.abs()) } else { 2.0 + x / (x.abs() + y.abs()) }
            };
            near.sort_by(|&a, &b| quadrant(a).total_cmp(&quadrant(b)));
            sites.push(Site { target, ring: near, grid_point: here });
        }
        sites
    }

    fn layer(semantic: Semantic, count: u8, data: LayerData) -> AttributeLayer {
        AttributeLayer { semantic, component_count: count, normalized: false, data }
    }

    /// Layers that vary smoothly with the position.
    fn smooth_layers(sites: &[Site]) -> Vec<AttributeLayer> {
        let of = |f: &dyn Fn(f32, f32) -> Vec<f32>| -> Vec<f32> {
            sites
                .iter()
                .flat_map(|s| f(s.grid_point[0] as f32 / 1000.0, s.grid_point[1] as f32 / 1000.0))
                .collect()
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
                LayerData::U8(sites.iter().flat_map(|s| joints(s.grid_point[0] as f32 / 1000.0)).collect()),
            ),
            AttributeLayer::from_f32(
                Semantic::Weights(0),
                4,
                of(&|x, _| if x < 0.4 { vec![1.0 - x, x, 0.0, 0.0] } else { vec![x, 1.0 - x, 0.0, 0.0] }),
            ),
            layer(
                Semantic::Generic("part".into()),
                1,
                LayerData::U32(
                    sites.iter().map(|s| if s.grid_point[1] < 300 { u32::MAX } else { 12 }).collect(),
                ),
            ),
        ]
    }

    /// Layers of random numbers.
    fn random_layers(count: usize) -> Vec<AttributeLayer> {
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
            let grid_points: Vec<_> = site.ring.iter().map(|&v| sites[v as usize].grid_point).collect();
            fit.measure(site.grid_point, &grid_points, true);
            let neighborhood = LayerNeighborhood::new(site.target, &site.ring, &fit);
            model.code(coder, &mut values, &neighborhood, actual.map(|layers| (layers, vertex as u32)));
        }
        values
    }

    /// Bits per vertex of each layer on its own, and of weights together with their joints. Also checks
    /// that the decoded layers equal the encoded ones.
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
        // Coding them together must not cost more.
        let all = bits_together(sites, layers, options, effort);
        assert!(all < each.iter().sum::<f64>() + 0.5, "{all} for {each:?}");
        each
    }

    /// Bits per vertex of all layers. Also checks that the decoded layers equal the encoded ones.
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
    fn smooth_layers_take_few_bits() {
        let sites = sites(30, 1);
        let layers = smooth_layers(&sites);
        let most = [5.8, 6.0, 10.5, 2.6, 0.3, 5.0, 0.3];
        for effort in [Effort::Fast, Effort::Compact] {
            let found = bits(&sites, &layers, &LayerOptions::default(), effort);
            assert!(found.iter().zip(most).all(|(found, most)| *found < most), "{effort:?}: {found:?}");
        }
    }

    #[test]
    fn order_of_layers_does_not_matter() {
        let sites = sites(20, 4);
        let mut layers = smooth_layers(&sites);
        let options = LayerOptions::default();
        let before = bits_together(&sites, &layers, &options, Effort::Compact);
        layers.reverse();
        // Weights now precede their joints, and tangents the layers they are predicted from.
        let after = bits_together(&sites, &layers, &options, Effort::Compact);
        assert!((before - after).abs() < 0.05, "{before} became {after}");
    }

    #[test]
    fn random_layers_are_decoded_exactly() {
        let sites = sites(16, 2);
        let options = LayerOptions::default();
        for effort in [Effort::Fast, Effort::Compact] {
            let found = bits(&sites, &random_layers(sites.len()), &options, effort);
            let least = [17.0, 88.0, 60.0, 60.0, 30.0];
            assert!(found.iter().zip(least).all(|(found, least)| *found < 1.2 * least + 8.0), "{found:?}");
            let even = smooth_layers(&sites);
            bits(&sites, &even, &options.clone().with_lossless(true), effort);
            bits(&sites, &even, &options.clone().with_normal_bits(16).with_texcoord_bits(24), effort);
            bits(&sites, &even, &options.clone().with_normal_bits(2).with_texcoord_bits(1), effort);
        }
    }

    #[test]
    fn random_bytes_give_valid_integers() {
        let sites = sites(10, 3);
        let mut random = Random::new(5);
        let mut layers = smooth_layers(&sites);
        layers.extend(random_layers(sites.len()));
        let forms: Vec<_> =
            layers.iter().map(|layer| LayerForm::of(layer, &LayerOptions::default())).collect();
        for length in [0, 1, 10, 100, 1000, 5000] {
            let bytes: Vec<u8> = (0..length).map(|_| random.next_u64() as u8).collect();
            let values = code(&mut RangeReader::new(&bytes, true), &sites, &forms, None, Effort::Compact);
            for (form, values) in forms.iter().zip(values) {
                assert_eq!(values.vertex_count(), sites.len());
                let mut layer = form.empty_layer();
                form.append(values.integers(), &mut layer.data);
                assert_eq!(layer.data.len(), sites.len() * form.component_count as usize);
            }
        }
    }

    #[test]
    fn truncation_removes_incomplete_vertices() {
        let mut values = LayerValues::from_integers((0..12).collect(), 3);
        values.truncate(2);
        assert_eq!((values.vertex_count(), values.of(1)), (2, &[3, 4, 5][..]));
    }
}
