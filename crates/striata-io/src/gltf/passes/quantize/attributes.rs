//! Replacement of the attributes, morph targets and indices of primitives.

use std::collections::BTreeMap;

use serde_json::{Value, json};

use super::changes::{DocumentChanges, Texcoords};
use super::convert;
use super::grid::{Grids, MeshGrid};
use crate::QuantizeOptions;
use crate::gltf::accessor::{Accessor, accessor};
use crate::gltf::component_type::GltfComponentType;
use crate::gltf::document::GltfDocument;
use crate::gltf::passes::additions::ViewKind;
use crate::gltf::passes::elements::Elements;
use crate::gltf::passes::extensions::are_free_of_values;
use crate::gltf::passes::parts::entries_mut;
use crate::gltf::passes::primitives::PassPrimitive;

/// How numbers are converted.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum ConversionRule {
    /// Positions, by the number of their grid.
    Position(usize),
    /// Displacements of positions, by the number of their grid.
    Displacement(usize),
    Direction,
    TextureCoordinate,
    Color,
    Joints,
    Index,
}

/// Part of a primitive that refers to an accessor.
#[derive(Clone, Copy, Debug)]
enum AttributePart<'a> {
    Attribute(&'a str),
    Target(usize, &'a str),
    Indices,
}

/// Converts and replaces accessors.
pub(super) struct AttributeQuantizer<'a, 'c, 'r> {
    document: &'a GltfDocument<'a>,
    grids: &'a Grids,
    options: &'a QuantizeOptions,
    texcoords: Texcoords,
    changes: &'c mut DocumentChanges<'r>,
    /// Replacements; [`None`] if an accessor stays as it is.
    known: BTreeMap<(u64, ConversionRule), Option<usize>>,
    known_weights: BTreeMap<Vec<u64>, Option<Vec<usize>>>,
}

impl<'a, 'c, 'r> AttributeQuantizer<'a, 'c, 'r> {
    pub(super) fn new(
        document: &'a GltfDocument<'a>,
        grids: &'a Grids,
        options: &'a QuantizeOptions,
        texcoords: Texcoords,
        changes: &'c mut DocumentChanges<'r>,
    ) -> Self {
        let (known, known_weights) = (BTreeMap::new(), BTreeMap::new());
        Self { document, grids, options, texcoords, changes, known, known_weights }
    }

    /// Quantizes everything that belongs to a primitive.
    pub(super) fn quantize(&mut self, primitive: &PassPrimitive) {
        let grid = self.grids.number(primitive.mesh);
        let is_free = primitive.has_triangles() && are_free_of_values(&primitive.extensions);
        for (name, accessor) in &primitive.attributes {
            let rule = match rule_of(name) {
                Some(ConversionRule::Position(_)) => grid.map(ConversionRule::Position),
                rule => rule.filter(|_| is_free),
            };
            if let Some(rule) = rule {
                self.replace(primitive, AttributePart::Attribute(name), *accessor, rule);
            }
        }
        for (number, target) in primitive.targets.iter().enumerate() {
            for (name, accessor) in target {
                let rule = match name.as_str() {
                    "POSITION" => grid.map(ConversionRule::Displacement),
                    "NORMAL" | "TANGENT" => Some(ConversionRule::Direction).filter(|_| is_free),
                    _ => None,
                };
                if let Some(rule) = rule {
                    self.replace(primitive, AttributePart::Target(number, name), *accessor, rule);
                }
            }
        }
        if is_free {
            if let Some(indices) = primitive.indices {
                self.replace(primitive, AttributePart::Indices, indices, ConversionRule::Index);
            }
            self.replace_weights(primitive);
        }
    }

    fn replace(
        &mut self,
        primitive: &PassPrimitive,
        part: AttributePart<'_>,
        index: u64,
        rule: ConversionRule,
    ) {
        // Displacements may have the same name as attributes, but are no unit vectors.
        let role = match part {
            AttributePart::Attribute(name) => name.to_owned(),
            AttributePart::Target(_, name) => format!("target {name}"),
            AttributePart::Indices => "indices".to_owned(),
        };
        let new = match self.known.get(&(index, rule)) {
            Some(&known) => known,
            None => {
                let new = self.converted(index, rule, &role);
                self.known.insert((index, rule), new);
                new
            }
        };
        if let (Some(new), Some(slot)) = (new, slot(self.changes.root, primitive, part)) {
            *slot = json!(new);
            self.changes.replaced.insert(index);
        }
    }

    /// Adds an accessor of converted numbers.
    fn converted(&mut self, index: u64, rule: ConversionRule, role: &str) -> Option<usize> {
        let source = accessor(self.document, index, &self.document.root).ok()?;
        let elements = convert_by(&source, rule, self.grids, self.options, self.texcoords)?;
        let old = self.document.item("accessors", index, &self.document.root).ok()?.value;
        if elements.bytes.is_empty() || old.get("bufferView").is_none() && old.get("sparse").is_none() {
            // Zeros take no bytes.
            return None;
        }
        let mut accessor = elements.accessor();
        if let Some(name) = old.get("name") {
            accessor["name"] = name.clone();
        }
        if matches!(rule, ConversionRule::Position(_) | ConversionRule::Displacement(_)) {
            elements.declare_bounds(&mut accessor);
        }
        let is_core = matches!(rule, ConversionRule::Color | ConversionRule::Joints | ConversionRule::Index);
        self.changes.needs_extension |= !is_core && elements.component != GltfComponentType::F32;
        let additions = &mut self.changes.additions;
        if rule == ConversionRule::Index {
            return Some(additions.push(ViewKind::of_indices(role, &elements), &elements, accessor));
        }
        if old.get("bufferView").is_none()
            && let Some((indices, values)) = sparse_parts(&elements)
        {
            let count = values.count;
            let [mut at, mut of] = [json!({}), json!({})];
            additions.store(ViewKind::of_others("sparse indices", &indices), &indices, &mut at);
            additions.store(ViewKind::of_others("sparse values", &values), &values, &mut of);
            at["componentType"] = json!(indices.component.number());
            accessor["sparse"] = json!({ "count": count, "indices": at, "values": of });
            return Some(additions.push_accessor(accessor));
        }
        Some(additions.push(ViewKind::of_vertices(role, &elements), &elements, accessor))
    }

    fn replace_weights(&mut self, primitive: &PassPrimitive) {
        let names: Vec<String> = (0..)
            .map(|set| format!("WEIGHTS_{set}"))
            .take_while(|name| primitive.attribute(name).is_some())
            .collect();
        let sets: Vec<u64> = names.iter().filter_map(|name| primitive.attribute(name)).collect();
        let new = match self.known_weights.get(&sets) {
            Some(known) => known.clone(),
            None => {
                let new = self.converted_weights(&sets);
                self.known_weights.insert(sets.clone(), new.clone());
                new
            }
        };
        for (place, new) in new.into_iter().flatten().enumerate() {
            if let Some(slot) = slot(self.changes.root, primitive, AttributePart::Attribute(&names[place])) {
                *slot = json!(new);
                self.changes.replaced.insert(sets[place]);
            }
        }
    }

    fn converted_weights(&mut self, sets: &[u64]) -> Option<Vec<usize>> {
        let mut numbers = Vec::new();
        for &set in sets {
            let source = accessor(self.document, set, &self.document.root).ok()?;
            if source.component != GltfComponentType::F32 || source.component_count != 4 || source.count == 0
            {
                return None;
            }
            numbers.push(source.floats());
        }
        let converted = convert::weights(&numbers)?;
        let push = |elements: Elements| {
            let kind = ViewKind::of_vertices("WEIGHTS", &elements);
            self.changes.additions.push(kind, &elements, elements.accessor())
        };
        Some(converted.into_iter().map(push).collect())
    }
}

/// Returns the rule for an attribute; the number of the grid is still to be set.
fn rule_of(name: &str) -> Option<ConversionRule> {
    Some(match name {
        "POSITION" => ConversionRule::Position(0),
        "NORMAL" | "TANGENT" => ConversionRule::Direction,
        name if name.starts_with("TEXCOORD_") => ConversionRule::TextureCoordinate,
        name if name.starts_with("COLOR_") => ConversionRule::Color,
        name if name.starts_with("JOINTS_") => ConversionRule::Joints,
        _ => return None,
    })
}

/// Converts an accessor; [`None`] if it stays as it is.
fn convert_by(
    source: &Accessor<'_>,
    rule: ConversionRule,
    grids: &Grids,
    options: &QuantizeOptions,
    texcoords: Texcoords,
) -> Option<Elements> {
    let is_float = source.component == GltfComponentType::F32;
    let (width, floats) = (source.component_count, || source.floats());
    let grid = |number: usize| -> Option<MeshGrid> { *grids.grids.get(number)? };
    match rule {
        ConversionRule::Position(number) => {
            (is_float && width == 3).then_some(())?;
            Some(convert::positions(&floats(), &grid(number)?))
        }
        ConversionRule::Displacement(number) => {
            (width == 3).then_some(()).and_then(|()| convert::displacements(&floats(), &grid(number)?))
        }
        ConversionRule::Direction => {
            (is_float && matches!(width, 3 | 4)).then_some(())?;
            convert::signed_fractions(&floats(), width, options.normal_bits)
        }
        ConversionRule::TextureCoordinate => {
            (is_float && width == 2).then_some(())?;
            convert::texture_coordinates(&floats(), options.texcoord_bits, texcoords)
        }
        ConversionRule::Color => {
            let is_larger = is_float || source.component == GltfComponentType::U16 && options.color_bits <= 8;
            (is_larger && matches!(width, 3 | 4)).then_some(())?;
            convert::fractions(&floats(), width, options.color_bits)
        }
        ConversionRule::Joints => {
            (source.component == GltfComponentType::U16 && width == 4).then_some(())?;
            small_integers(source, 0xff, GltfComponentType::U8)
        }
        // The largest 16-bit value is left for primitive restart.
        ConversionRule::Index => {
            (source.component == GltfComponentType::U32 && width == 1).then_some(())?;
            small_integers(source, 0xfffe, GltfComponentType::U16)
        }
    }
}

fn small_integers(source: &Accessor<'_>, most: u32, component: GltfComponentType) -> Option<Elements> {
    let integers = source.integers()?;
    let fit = integers.iter().all(|&x| x <= most);
    fit.then(|| Elements::integers(integers.into_iter().map(i64::from), source.component_count, component))
}

/// Returns the elements that are not zero, and where they are; [`None`] if storing all takes fewer bytes.
fn sparse_parts(elements: &Elements) -> Option<(Elements, Elements)> {
    let size = elements.element_bytes();
    let chunks = elements.bytes.chunks_exact(size).enumerate();
    let mut places: Vec<u32> =
        chunks.filter(|(_, e)| e.iter().any(|&b| b != 0)).map(|(i, _)| i as u32).collect();
    if places.is_empty() {
        places.push(0);
    }
    let component = if elements.count <= 0xffff { GltfComponentType::U16 } else { GltfComponentType::U32 };
    if places.len() * (size + component.bytes()) >= elements.count * elements.stride() {
        return None;
    }
    let values = elements.reordered(&places);
    Some((Elements::integers(places.into_iter().map(i64::from), 1, component), values))
}

/// Returns the reference to an accessor in the document.
fn slot<'r>(
    root: &'r mut Value,
    primitive: &PassPrimitive,
    part: AttributePart<'_>,
) -> Option<&'r mut Value> {
    let primitive = root.pointer_mut(&primitive.path())?;
    match part {
        AttributePart::Attribute(name) => primitive.get_mut("attributes")?.get_mut(name),
        AttributePart::Target(number, name) => {
            entries_mut(primitive, "targets").get_mut(number)?.get_mut(name)
        }
        AttributePart::Indices => primitive.get_mut("indices"),
    }
}
