//! Codes the vertex of a new corner: an import, or the position, attributes, key and error of an owned vertex.

use striata::mesh::LayerData;
use striata_stream::entropy::{Coder, QuickNumber, Rate};

use super::lattice::{from_ordered, from_ordered_double, ordered, ordered_double};
use super::triangles::{CodedShape, TriangleCoder};
use super::vertex_models::VertexSite;
use crate::metadata::index_of;
use crate::{Import, Page, PagedLayer};

/// Number of low bits of keys and errors that are always zero.
const KEY_BITS: u32 = 18;
const ERROR_BITS: u32 = 17;
const UNMET: u32 = u32::MAX;

impl TriangleCoder<'_> {
    /// Codes an owned vertex: of a known position, or of a new one near some vertices.
    pub(super) fn new_vertex<C: Coder>(
        &mut self,
        coder: &mut C,
        page: Option<&Page>,
        actual: u32,
        site: VertexSite,
    ) -> u32 {
        let VertexSite { node, near } = site;
        let vertex = self.shape.vertices.len() as u32;
        let mut known = near[..2].iter().copied().find(|&v| v < CodedShape::IMPORTS);
        let position = match node {
            Some(position) => {
                known = self.shape.wedges.latest_first(position).next();
                position
            }
            None => {
                let position = self.shape.positions.len() as u32;
                self.position(coder, page.map(|page| page.positions[actual as usize]), near);
                self.shape.wedges.add_position();
                if !self.is_base {
                    self.cost(coder, page, position, near);
                }
                position
            }
        };
        if let Some(page) = page {
            self.met[actual as usize] = vertex;
            self.layers(coder, Some((page, actual)), known);
        } else {
            self.layers(coder, None, known);
        }
        self.shape.vertices.push(position);
        self.shape.wedges.add_vertex(position);
        vertex
    }

    /// Codes a position; near the two ends of a gate and the third corner of its triangle.
    fn position<C: Coder>(&mut self, coder: &mut C, actual: Option<[f32; 3]>, near: [u32; 3]) {
        let places = &self.models.places;
        let at = |v: u32| (v < CodedShape::IMPORTS).then(|| places[self.shape.vertices[v as usize] as usize]);
        let [a, b, d] = near.map(at);
        let (quality, expected) = match (a, b, d) {
            (Some(a), Some(b), Some(d)) => (0, [0, 1, 2].map(|i| a[i] + b[i] - d[i])),
            (Some(a), Some(b), None) => (1, [0, 1, 2].map(|i| (a[i] + b[i]) >> 1)),
            (Some(p), None, _) | (None, Some(p), _) | (None, None, Some(p)) => (1, p),
            (None, None, None) => (2, places.last().copied().unwrap_or_default()),
        };
        let lattice = &self.counts.lattice;
        let actual = actual.map_or([0; 3], |position| lattice.place_of(position, self.metadata));
        let place: [i64; 3] = std::array::from_fn(|axis| {
            let difference = actual[axis].wrapping_sub(expected[axis]);
            let difference = self.models.positions.signed(coder, 3 * quality + axis, difference);
            // Damaged bytes must not overflow sums of places.
            (expected[axis] + difference).clamp(-(1 << 50), 1 << 50)
        });
        self.models.places.push(place);
        self.shape.positions.push(lattice.position_of(place, self.metadata));
    }

    /// Codes key and error of a position.
    fn cost<C: Coder>(&mut self, coder: &mut C, page: Option<&Page>, position: u32, near: [u32; 3]) {
        let actual = |values: &[f32], bits: u32| {
            values.get(position as usize).map_or(0, |x| (x.to_bits() >> bits) as i32)
        };
        let neighbor = near.iter().copied().find(|&v| v < CodedShape::IMPORTS);
        let context = usize::from(neighbor.is_none());
        let neighbor = neighbor.map(|v| self.shape.vertices[v as usize] as usize);
        let models = &mut self.models;
        let last = models.key_classes.len().checked_sub(1);
        let near_class = |classes: &[i32]| neighbor.or(last).map_or(0, |p| classes[p]);
        let (near_key, near_error) = (near_class(&models.key_classes), near_class(&models.error_classes));
        let key = page.map_or(0, |page| actual(&page.keys, KEY_BITS));
        let key = i64::from(near_key) + models.keys.signed(coder, context, i64::from(key - near_key));
        let key = key.clamp(0, largest_class(KEY_BITS).into()) as i32;
        // An error is a length and a key its fourth power, in classes half as fine.
        let expected = (near_error + (key - near_key) / 2).clamp(0, largest_class(ERROR_BITS));
        let error = page.map_or(0, |page| actual(&page.errors, ERROR_BITS));
        let error = i64::from(expected) + models.errors.signed(coder, context, i64::from(error - expected));
        let error = error.clamp(0, largest_class(ERROR_BITS).into()) as i32;
        models.key_classes.push(key);
        models.error_classes.push(error);
        self.shape.keys.push(f32::from_bits((key as u32) << KEY_BITS));
        self.shape.errors.push(f32::from_bits((error as u32) << ERROR_BITS));
    }

    /// Codes the attributes of a vertex; `known` is one that is likely to have similar ones.
    fn layers<C: Coder>(&mut self, coder: &mut C, actual: Option<(&Page, u32)>, known: Option<u32>) {
        let mut context = 0;
        let last = self.shape.vertices.len().checked_sub(1).map(|v| v as u32);
        let near = known.or(last);
        for (i, kind) in self.metadata.layers.iter().enumerate() {
            for component in 0..kind.component_count as usize {
                let count = kind.component_count as usize;
                let place = |data: &LayerData, v: u32| place_of(kind, data, v as usize * count + component);
                let data = &self.shape.layers[i].data;
                let expected = near.map_or(0, |v| place(data, v));
                let value = actual.map_or(0, |(page, v)| place(&page.layers[i].data, v));
                let slot = 2 * context + usize::from(known.is_none());
                let data = &mut self.shape.layers[i].data;
                let place = coded_place(coder, &mut self.models.layers, slot, data, [value, expected]);
                push_place(kind, data, place);
                context += 1;
            }
        }
    }

    /// Codes the data of all triangles, each expected to equal those of the triangle before it.
    pub(super) fn triangle_layers<C: Coder>(&mut self, coder: &mut C, page: Option<&Page>) {
        for (i, kind) in self.metadata.triangle_layers.iter().enumerate() {
            let width = kind.component_count as usize;
            let mut model = QuickNumber::new(width, Rate::Quick);
            let data = &mut self.shape.triangle_layers[i].data;
            for index in 0..self.shape.triangles.len() * width {
                if coder.overran() {
                    return;
                }
                let expected = index.checked_sub(width).map_or(0, |before| place_of(kind, data, before));
                let value = page.map_or(0, |page| place_of(kind, &page.triangle_layers[i].data, index));
                let place = coded_place(coder, &mut model, index % width, data, [value, expected]);
                push_place(kind, data, place);
            }
        }
    }

    /// Codes an import near some vertices.
    pub(super) fn import<C: Coder>(&mut self, coder: &mut C, actual: Import, near: [u32; 3]) -> Import {
        let pages = &self.counts.pages;
        let models = &mut self.models;
        models.last_imports.resize(pages.len(), 0);
        let near =
            near[..2].iter().filter_map(|&v| v.checked_sub(CodedShape::IMPORTS).filter(|_| v != UNMET));
        let near: Vec<Import> = near.map(|import| self.shape.imports[import as usize]).collect();
        let slot_of = |page: u32| pages.partition_point(|&p| p < page).min(pages.len() - 1);
        let expected_slot = near.first().map_or(models.last_slot, |import| slot_of(import.page));
        let actual_slot = slot_of(actual.page);
        let slot = if pages.len() == 1 || models.same_page.code(coder, actual_slot == expected_slot) {
            expected_slot
        } else {
            (models.page.unsigned(coder, 0, actual_slot as u64) as usize).min(pages.len() - 1)
        };
        let neighbor = near.iter().find(|import| import.page == pages[slot]);
        let (context, expected) = match neighbor {
            Some(import) => (0, import.vertex),
            None => (1, models.last_imports[slot]),
        };
        let difference = i64::from(actual.vertex) - i64::from(expected);
        let vertex = (i64::from(expected) + models.import.signed(coder, context, difference)) as u32;
        models.last_imports[slot] = vertex;
        models.last_slot = slot;
        Import { page: pages[slot], vertex }
    }
}

/// Lower half of a number.
const LOW_HALF: i64 = 0xFFFF_FFFF;

/// Class of the largest finite number.
fn largest_class(bits: u32) -> i32 {
    (f32::MAX.to_bits() >> bits) as i32
}

/// Codes a value of `data` as its difference from the predicted one, both as integers, and returns it.
fn coded_place<C: Coder>(
    coder: &mut C,
    model: &mut QuickNumber,
    context: usize,
    data: &LayerData,
    [value, expected]: [i64; 2],
) -> i64 {
    let mut coded =
        |value: i64, expected: i64| expected.wrapping_add(model.signed(coder, context, value - expected));
    match data {
        // The difference of two doubles has up to 64 bits, more than a number of the codec.
        LayerData::F64(_) => {
            let high = coded(value >> 32, expected >> 32);
            high << 32 | coded(value & LOW_HALF, expected & LOW_HALF) & LOW_HALF
        }
        _ => coded(value, expected),
    }
}

/// A value as an integer: multiples of the step, or ordered bits.
fn place_of(kind: &PagedLayer, data: &LayerData, index: usize) -> i64 {
    match (data, kind.step) {
        (LayerData::F32(values), Some(step)) => index_of(values[index], step),
        (LayerData::F32(values), None) => ordered(values[index]),
        (LayerData::U8(values), _) => i64::from(values[index]),
        (LayerData::U16(values), _) => i64::from(values[index]),
        (LayerData::U32(values), _) => i64::from(values[index]),
        (LayerData::I8(values), _) => i64::from(values[index]),
        (LayerData::I16(values), _) => i64::from(values[index]),
        (LayerData::I32(values), _) => i64::from(values[index]),
        (LayerData::F64(values), _) => ordered_double(values[index]),
    }
}

fn push_place(kind: &PagedLayer, data: &mut LayerData, place: i64) {
    match (data, kind.step) {
        (LayerData::F32(values), Some(step)) => values.push((place as f64 * step) as f32),
        (LayerData::F32(values), None) => values.push(from_ordered(place)),
        (LayerData::U8(values), _) => values.push(place as u8),
        (LayerData::U16(values), _) => values.push(place as u16),
        (LayerData::U32(values), _) => values.push(place as u32),
        (LayerData::I8(values), _) => values.push(place as i8),
        (LayerData::I16(values), _) => values.push(place as i16),
        (LayerData::I32(values), _) => values.push(place as i32),
        (LayerData::F64(values), _) => values.push(from_ordered_double(place)),
    }
}
