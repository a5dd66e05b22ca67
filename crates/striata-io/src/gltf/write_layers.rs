//! Attribute layers as glTF accessors, in the types that glTF allows for each attribute.
//!
//! Normals, tangents and weights are normalized and colors clamped to 0 to 1, as glTF demands. Data without
//! a glTF type (32-bit integers, doubles) are written as floats under their own name with an underscore before
//! it; integers that floats would change are left out. Displacements of morph targets that are mostly zero
//! become sparse accessors.

use std::collections::BTreeMap;

use serde_json::{Map, Value, json};
use striata::mesh::{AttributeLayer, Bounds, IndexedMesh, LayerData, Semantic};

use super::builder::GltfBuilder;
use super::component_type::GltfComponentType;
use super::semantics::target_of;
use crate::error::Refusal;
use crate::normals::unit;

/// Attributes and morph targets that all primitives share.
pub(super) struct SharedAttributes {
    pub attributes: Map<String, Value>,
    pub targets: Vec<Value>,
    /// Accessor of each layer.
    pub of_layer: BTreeMap<Semantic, Value>,
}

/// Numbers in a type that glTF allows.
enum Encoded {
    Floats(Vec<f32>),
    Bytes(Vec<u8>),
    Words(Vec<u16>),
    SignedBytes(Vec<i8>),
    SignedWords(Vec<i16>),
}

/// Adds all positions and layers of a mesh, and returns their accessors.
pub(super) fn attributes(builder: &mut GltfBuilder, mesh: &IndexedMesh) -> Result<SharedAttributes, Refusal> {
    let mut out = SharedAttributes { attributes: Map::new(), targets: Vec::new(), of_layer: BTreeMap::new() };
    let positions = mesh.positions.as_flattened();
    check_finite(positions, 3, "POSITION")?;
    out.attributes.insert("POSITION".to_owned(), push_points(builder, positions));
    let mut sparse = SparseData::default();
    for layer in mesh.layers.iter().filter(|layer| !is_unstorable(mesh, layer)) {
        let is_free = match target_of(&layer.semantic, layer.component_count) {
            Some((target, key)) => {
                let accessor = match layer.semantic {
                    Semantic::Generic(_) => push_generic(builder, layer)?.1,
                    _ => push_displacements(builder, &mut sparse, &floats(layer, 3)?, key == "POSITION"),
                };
                let target = target as usize;
                if out.targets.len() <= target {
                    out.targets.resize(target + 1, json!({}));
                }
                let is_free = out.targets[target].get(key).is_none();
                out.of_layer.insert(layer.semantic.clone(), accessor.clone());
                out.targets[target][key] = accessor;
                is_free
            }
            None => {
                let (name, accessor) = push_layer(builder, mesh, layer)?;
                out.of_layer.insert(layer.semantic.clone(), accessor.clone());
                out.attributes.insert(name, accessor).is_none()
            }
        };
        if !is_free {
            return Err(Refusal::Unsupported(format!("two layers are called {}", layer.semantic)));
        }
    }
    fill_targets(builder, &mut sparse, &mut out.targets, mesh.positions.len());
    sparse.store(builder);
    Ok(out)
}

/// Data of the sparse accessors of a mesh, which share a view of indices and a view of values, because a view
/// takes about as much JSON as a hundred indices take bytes.
#[derive(Default)]
struct SparseData {
    indices: Vec<u8>,
    values: Vec<[f32; 3]>,
    accessors: Vec<usize>,
}

/// Characters of JSON that a sparse accessor takes in addition to those of another one and its view.
const SPARSE_JSON_BYTES: usize = 64;

impl SparseData {
    /// Adds the vectors that are not zero, and describes them in an accessor; returns false if it takes fewer
    /// bytes to store all vectors. If all are zero, the first one is stored, because some readers refuse
    /// accessors without any data.
    fn add(&mut self, vectors: &[[f32; 3]], accessor: &mut Value) -> bool {
        let is_used = |vector: &[f32; 3]| *vector != [0.0; 3];
        let mut places: Vec<u32> =
            (0..).zip(vectors).filter(|(_, vector)| is_used(vector)).map(|(place, _)| place).collect();
        if places.is_empty() {
            places.push(0);
        }
        let count = places.len();
        let (index, index_bytes) =
            if vectors.len() <= 0xffff { (GltfComponentType::U16, 2) } else { (GltfComponentType::U32, 4) };
        if count * (12 + index_bytes) + SPARSE_JSON_BYTES >= vectors.len() * 12 {
            return false;
        }
        accessor["sparse"] = json!({
            "count": count,
            "indices": { "byteOffset": self.indices.len(), "componentType": index.number() },
            "values": { "byteOffset": self.values.len() * 12 },
        });
        for place in places {
            self.indices.extend_from_slice(&place.to_le_bytes()[..index_bytes]);
            self.values.push(vectors[place as usize]);
        }
        true
    }

    /// Adds the views, and completes the accessors.
    fn store(&self, builder: &mut GltfBuilder) {
        if self.accessors.is_empty() {
            return;
        }
        let indices = builder.push_view(&self.indices, None, None);
        let values = builder.push_view(bytemuck::cast_slice(&self.values), None, None);
        for &accessor in &self.accessors {
            let sparse = &mut builder.accessors[accessor]["sparse"];
            sparse["indices"]["bufferView"] = json!(indices);
            sparse["values"]["bufferView"] = json!(values);
        }
    }
}

/// Fills in missing morph targets with zero displacements, because a target must not be empty.
fn fill_targets(
    builder: &mut GltfBuilder,
    sparse: &mut SparseData,
    targets: &mut [Value],
    vertex_count: usize,
) {
    let is_empty = |target: &Value| target.as_object().is_some_and(Map::is_empty);
    if !targets.iter().any(is_empty) {
        return;
    }
    let zeros = push_displacements(builder, sparse, &vec![0.0; 3 * vertex_count], true);
    for target in targets.iter_mut().filter(|target| is_empty(target)) {
        target["POSITION"] = zeros.clone();
    }
}

/// Returns the name of a layer's attribute: that of glTF if its numbers fit, otherwise one of its own.
pub(crate) fn attribute_name(mesh: &IndexedMesh, layer: &AttributeLayer) -> String {
    standard_name(mesh, layer).unwrap_or_else(|| own_name(layer))
}

/// Returns the glTF name of a layer; [`None`] if its numbers do not fit.
fn standard_name(mesh: &IndexedMesh, layer: &AttributeLayer) -> Option<String> {
    let has = |semantic: Semantic| mesh.layer(&semantic).is_some_and(|layer| layer.component_count == 4);
    let width = layer.component_count as usize;
    Some(match layer.semantic {
        Semantic::Normal if width == 3 => "NORMAL".to_owned(),
        Semantic::Tangent if width == 4 => "TANGENT".to_owned(),
        Semantic::TexCoord(set) if width == 2 => format!("TEXCOORD_{set}"),
        Semantic::Color(set) if matches!(width, 3 | 4) => format!("COLOR_{set}"),
        Semantic::Joints(set) if width == 4 && has(Semantic::Weights(set)) && is_joints(layer) => {
            format!("JOINTS_{set}")
        }
        Semantic::Weights(set) if width == 4 && has(Semantic::Joints(set)) => format!("WEIGHTS_{set}"),
        _ => return None,
    })
}

fn own_name(layer: &AttributeLayer) -> String {
    match &layer.semantic {
        Semantic::Generic(name) => format!("_{name}"),
        other => format!("_{other}"),
    }
}

/// Adds a layer under its glTF name, or under its own.
fn push_layer(
    builder: &mut GltfBuilder,
    mesh: &IndexedMesh,
    layer: &AttributeLayer,
) -> Result<(String, Value), Refusal> {
    let Some(name) = standard_name(mesh, layer) else { return push_generic(builder, layer) };
    let width = layer.component_count as usize;
    let keeps_integers = match layer.semantic {
        Semantic::TexCoord(_) | Semantic::Color(_) | Semantic::Weights(_) => layer.normalized,
        Semantic::Joints(_) => true,
        _ => false,
    };
    let encoded = match &layer.data {
        LayerData::U8(bytes) if keeps_integers => Encoded::Bytes(bytes.clone()),
        LayerData::U16(words) if keeps_integers => Encoded::Words(words.clone()),
        LayerData::U32(words) if keeps_integers => {
            Encoded::Words(words.iter().map(|&word| word as u16).collect())
        }
        _ => Encoded::Floats(legal_floats(mesh, layer, width)?),
    };
    let normalized = layer.normalized && !matches!(encoded, Encoded::Floats(_));
    let accessor = push(builder, &name, &encoded, width, normalized);
    Ok((name, accessor))
}

/// Whether glTF allows the layer's numbers as joints.
fn is_joints(layer: &AttributeLayer) -> bool {
    match &layer.data {
        LayerData::U8(_) | LayerData::U16(_) => true,
        LayerData::U32(joints) => joints.iter().all(|&joint| joint <= u32::from(u16::MAX)),
        _ => false,
    }
}

/// Whether a layer is one that glTF has no type for: 32-bit integers that no float represents. Such layers are
/// left out, because rounded identifiers are wrong ones.
pub(crate) fn is_unstorable(mesh: &IndexedMesh, layer: &AttributeLayer) -> bool {
    let is_wide = matches!(layer.data, LayerData::U32(_) | LayerData::I32(_));
    let has_type = standard_name(mesh, layer).is_some();
    let is_rounded = |i| layer.data.number(i).abs() > f64::from(1 << 24);
    is_wide && !has_type && (0..layer.data.len()).any(is_rounded)
}

fn push_generic(builder: &mut GltfBuilder, layer: &AttributeLayer) -> Result<(String, Value), Refusal> {
    let name = own_name(layer);
    let width = layer.component_count as usize;
    if !matches!(width, 1..=4 | 9 | 16) || (width > 4 && layer.data.component_bytes() < 4) {
        let reason = format!("layer {} has {width} components a vertex", layer.semantic);
        return Err(Refusal::Unsupported(reason));
    }
    let encoded = match &layer.data {
        LayerData::U8(bytes) => Encoded::Bytes(bytes.clone()),
        LayerData::U16(words) => Encoded::Words(words.clone()),
        LayerData::I8(bytes) => Encoded::SignedBytes(bytes.clone()),
        LayerData::I16(words) => Encoded::SignedWords(words.clone()),
        _ => Encoded::Floats(floats(layer, width)?),
    };
    let normalized = layer.normalized && !matches!(encoded, Encoded::Floats(_));
    let accessor = push(builder, &name, &encoded, width, normalized);
    Ok((name, accessor))
}

/// Returns a layer's numbers as floats; fails if one is not finite. Generic attributes may lack values, which
/// become 0; [`lost_data`](crate::lost_data) says so.
fn floats(layer: &AttributeLayer, width: usize) -> Result<Vec<f32>, Refusal> {
    let mut numbers: Vec<f32> = match &layer.data {
        LayerData::F32(numbers) => numbers.clone(),
        data => {
            let vertex_count = data.len() / width.max(1);
            (0..vertex_count).flat_map(|v| (0..width).map(move |c| layer.get(v, c))).collect()
        }
    };
    if matches!(layer.semantic, Semantic::Generic(_)) {
        numbers.iter_mut().filter(|x| !x.is_finite()).for_each(|x| *x = 0.0);
    }
    check_finite(&numbers, width, &layer.semantic.to_string())?;
    Ok(numbers)
}

fn check_finite(numbers: &[f32], width: usize, name: &str) -> Result<(), Refusal> {
    match numbers.iter().position(|x| !x.is_finite()) {
        None => Ok(()),
        Some(place) => {
            let (vertex, value) = (place / width.max(1), numbers[place]);
            Err(Refusal::Unsupported(format!("vertex {vertex} has the value {value} in {name}")))
        }
    }
}

/// Returns floats within the limits that glTF sets for their attribute.
fn legal_floats(mesh: &IndexedMesh, layer: &AttributeLayer, width: usize) -> Result<Vec<f32>, Refusal> {
    let mut numbers = floats(layer, width)?;
    match layer.semantic {
        Semantic::Normal => numbers.as_chunks_mut::<3>().0.iter_mut().for_each(make_unit),
        Semantic::Tangent => {
            for [x, y, z, w] in numbers.as_chunks_mut::<4>().0 {
                let mut direction = [*x, *y, *z];
                make_unit(&mut direction);
                [*x, *y, *z] = direction;
                *w = if *w < 0.0 { -1.0 } else { 1.0 };
            }
        }
        Semantic::Color(_) => numbers.iter_mut().for_each(|x| *x = x.clamp(0.0, 1.0)),
        Semantic::Weights(_) => {
            for (vertex, weights) in numbers.chunks_exact_mut(width).enumerate() {
                let total = total_weight(mesh, vertex);
                weights.iter_mut().for_each(|x| *x = (f64::from(x.max(0.0)) / total) as f32);
            }
        }
        _ => {}
    }
    Ok(numbers)
}

/// Sum of a vertex's weights over all sets, by which they are divided; 1 if it is right already or zero.
///
/// Weights that were rounded, such as those of a decoded stream, may miss the sum of 1 that glTF demands.
fn total_weight(mesh: &IndexedMesh, vertex: usize) -> f64 {
    let sets = mesh.layers.iter().filter(|layer| matches!(layer.semantic, Semantic::Weights(_)));
    let weights = sets.flat_map(|layer| (0..layer.component_count as usize).map(|c| layer.get(vertex, c)));
    let total: f64 = weights.map(|weight| f64::from(weight.max(0.0))).sum();
    let is_right = (total - 1.0).abs() <= 2e-7 || total == 0.0 || !total.is_finite();
    if is_right { 1.0 } else { total }
}

/// Normalizes a vector; a unit vector is unchanged, and a zero vector becomes +z.
fn make_unit(vector: &mut [f32; 3]) {
    let wide = vector.map(f64::from);
    let square: f64 = wide.iter().map(|x| x * x).sum();
    if (square - 1.0).abs() > 1e-4 {
        *vector = unit(wide).unwrap_or([0.0, 0.0, 1.0]);
    }
}

/// Adds points, with the bounds that glTF requires.
fn push_points(builder: &mut GltfBuilder, numbers: &[f32]) -> Value {
    let mut accessor = accessor_of_points(numbers, true);
    accessor["bufferView"] = json!(builder.push_vertex_data("POSITION", bytemuck::cast_slice(numbers), 12));
    json!(builder.push_shared_accessor("POSITION", accessor))
}

/// Adds the displacements of a morph target: only those that are not zero if that takes fewer bytes.
fn push_displacements(
    builder: &mut GltfBuilder,
    sparse: &mut SparseData,
    numbers: &[f32],
    has_bounds: bool,
) -> Value {
    let mut accessor = accessor_of_points(numbers, has_bounds);
    if sparse.add(numbers.as_chunks().0, &mut accessor) {
        let accessor = builder.push_accessor(accessor);
        sparse.accessors.push(accessor);
        return json!(accessor);
    }
    accessor["bufferView"] =
        json!(builder.push_vertex_data("displacements", bytemuck::cast_slice(numbers), 12));
    json!(builder.push_shared_accessor("displacements", accessor))
}

/// Returns an accessor of points without a place in a view.
fn accessor_of_points(numbers: &[f32], has_bounds: bool) -> Value {
    let (points, _) = numbers.as_chunks::<3>();
    let mut accessor = json!({
        "componentType": GltfComponentType::F32.number(),
        "count": points.len(),
        "type": "VEC3",
    });
    if has_bounds {
        let bounds = Bounds::of(points).unwrap_or(Bounds { min: [0.0; 3], max: [0.0; 3] });
        accessor["min"] = json!(bounds.min.map(f64::from));
        accessor["max"] = json!(bounds.max.map(f64::from));
    }
    accessor
}

fn push(builder: &mut GltfBuilder, name: &str, encoded: &Encoded, width: usize, normalized: bool) -> Value {
    let (bytes, component): (&[u8], _) = match encoded {
        Encoded::Floats(numbers) => (bytemuck::cast_slice(numbers), GltfComponentType::F32),
        Encoded::Bytes(numbers) => (numbers, GltfComponentType::U8),
        Encoded::Words(numbers) => (bytemuck::cast_slice(numbers), GltfComponentType::U16),
        Encoded::SignedBytes(numbers) => (bytemuck::cast_slice(numbers), GltfComponentType::I8),
        Encoded::SignedWords(numbers) => (bytemuck::cast_slice(numbers), GltfComponentType::I16),
    };
    let element_bytes = width * component.bytes();
    // Vertex data must be aligned to 4 bytes.
    let stride = element_bytes.next_multiple_of(4);
    let count = bytes.len() / element_bytes;
    let view = if stride == element_bytes {
        builder.push_vertex_data(name, bytes, stride)
    } else {
        let mut padded = Vec::with_capacity(count * stride);
        for element in bytes.chunks_exact(element_bytes) {
            padded.extend_from_slice(element);
            padded.resize(padded.len() + stride - element_bytes, 0);
        }
        builder.push_vertex_data(name, &padded, stride)
    };
    let kind = match width {
        1 => "SCALAR",
        2 => "VEC2",
        3 => "VEC3",
        9 => "MAT3",
        16 => "MAT4",
        _ => "VEC4",
    };
    let mut accessor = json!({
        "bufferView": view,
        "componentType": component.number(),
        "count": count,
        "type": kind,
    });
    if normalized {
        accessor["normalized"] = json!(true);
    }
    json!(builder.push_shared_accessor(name, accessor))
}
