//! Checks of GLB files: what the glTF specification demands of their accessors and references, and counts of their
//! parts.

use std::collections::{BTreeMap, BTreeSet};

use serde_json::Value;

/// Decodes a compressed buffer view from its extension object and its bytes.
pub type Decode = fn(&Value, &[u8]) -> Vec<u8>;

/// A GLB file that is checked.
#[derive(Debug)]
pub struct CheckedGlb {
    document: Value,
    /// Bytes of each buffer view.
    views: Vec<Vec<u8>>,
    faults: Vec<String>,
}

/// Numbers of an accessor, one vector for each element.
type Elements = Vec<Vec<f64>>;

/// Compressions of buffer views.
const COMPRESSIONS: [&str; 2] = ["EXT_meshopt_compression", "KHR_meshopt_compression"];

impl CheckedGlb {
    /// Reads a GLB file and checks it; `decode` is for compressed buffer views.
    pub fn new(glb: &[u8], decode: Decode) -> Self {
        let (document, binary) = chunks(glb);
        let mut glb = Self { document, views: Vec::new(), faults: Vec::new() };
        for (index, view) in glb.list("bufferViews").to_vec().iter().enumerate() {
            let bytes = glb.view_bytes(index, view, &binary, decode);
            glb.views.push(bytes);
        }
        glb.check_accessors();
        glb.check_meshes();
        glb.check_nodes();
        glb.check_animations();
        glb.check_materials();
        glb.check_extensions();
        glb
    }

    /// Faults that were found; empty if there are none.
    pub fn faults(&self) -> &[String] {
        &self.faults
    }

    /// The document of the file.
    pub fn document(&self) -> &Value {
        &self.document
    }

    /// Counts of the parts that every change of triangles keeps.
    pub fn counts(&self) -> BTreeMap<&'static str, usize> {
        let mut counts = BTreeMap::new();
        for name in [
            "scenes",
            "nodes",
            "skins",
            "animations",
            "materials",
            "textures",
            "samplers",
            "images",
            "cameras",
        ] {
            counts.insert(name, self.list(name).len());
        }
        let lengths = |of: &str, list: &str| {
            self.list(of).iter().map(|entry| entries(entry, list).len()).sum::<usize>()
        };
        counts.insert("joints", lengths("skins", "joints"));
        counts.insert("channels", lengths("animations", "channels"));
        counts.insert("meshes", self.list("meshes").len());
        let primitives = || self.list("meshes").iter().flat_map(|mesh| entries(mesh, "primitives"));
        counts.insert("primitives", primitives().count());
        counts.insert("targets", primitives().map(|primitive| entries(primitive, "targets").len()).sum());
        let attributes = |primitive: &Value| primitive["attributes"].as_object().map_or(0, |map| map.len());
        counts.insert("attributes", primitives().map(attributes).sum());
        let mappings = |primitive: &Value| {
            primitive
                .pointer("/extensions/KHR_materials_variants/mappings")
                .and_then(Value::as_array)
                .map_or(0, Vec::len)
        };
        counts.insert("mappings", primitives().map(mappings).sum());
        let lights =
            self.document.pointer("/extensions/KHR_lights_punctual/lights").and_then(Value::as_array);
        counts.insert("lights", lights.map_or(0, Vec::len));
        let mut named = NameCounts::default();
        count_names(&self.document, &mut named);
        counts.extend([("names", named.names), ("extras", named.extras)]);
        counts
    }

    fn list(&self, key: &str) -> &[Value] {
        entries(&self.document, key)
    }

    fn fault(&mut self, text: String) {
        self.faults.push(text);
    }

    /// Reports the fault unless the condition holds.
    fn require(&mut self, holds: bool, text: impl FnOnce() -> String) {
        if !holds {
            self.fault(text());
        }
    }

    fn view_bytes(&mut self, index: usize, view: &Value, binary: &[u8], decode: Decode) -> Vec<u8> {
        let stride = view["byteStride"].as_u64();
        let is_valid = stride.is_none_or(|stride| (4..=252).contains(&stride) && stride % 4 == 0);
        self.require(is_valid, || format!("bufferViews[{index}] has the stride {stride:?}"));
        let compressed = COMPRESSIONS.iter().find_map(|name| view.get("extensions")?.get(name));
        let owner = compressed.unwrap_or(view);
        let start = number(owner, "byteOffset").unwrap_or(0);
        let end = start + number(owner, "byteLength").unwrap_or(0);
        let Some(bytes) = binary.get(start..end) else {
            self.fault(format!("bufferViews[{index}] ends at {end} of {} bytes", binary.len()));
            return Vec::new();
        };
        let Some(compressed) = compressed else { return bytes.to_vec() };
        let decoded = decode(compressed, bytes);
        let declared = number(view, "byteLength");
        self.require(declared == Some(decoded.len()), || {
            format!("bufferViews[{index}]: {declared:?} bytes declared")
        });
        decoded
    }

    fn check_accessors(&mut self) {
        for index in 0..self.list("accessors").len() {
            let accessor = self.list("accessors")[index].clone();
            let place = format!("accessors[{index}]");
            let Some(elements) = self.elements(index as u64) else {
                self.fault(format!("{place} lies outside its buffer view: {accessor}"));
                continue;
            };
            self.require(!elements.is_empty(), || format!("{place} is empty"));
            for (key, pick) in [("min", f64::min as fn(f64, f64) -> f64), ("max", f64::max)] {
                let Some(declared) = accessor[key].as_array() else { continue };
                let declared: Vec<f64> = declared.iter().filter_map(Value::as_f64).collect();
                let width = elements.first().map_or(0, Vec::len);
                let found: Vec<f64> =
                    (0..width).filter_map(|c| elements.iter().map(|e| e[c]).reduce(pick)).collect();
                // Numbers are written with the digits of single precision.
                let is_equal = |(a, b): (&f64, &f64)| *a as f32 == *b as f32;
                let fits = declared.len() == found.len() && declared.iter().zip(&found).all(is_equal);
                self.require(fits, || format!("{place}.{key} is {declared:?}, not {found:?}"));
            }
            self.check_alignment(&accessor, &place);
        }
    }

    fn check_alignment(&mut self, accessor: &Value, place: &str) {
        let (size, width) = size_and_width(accessor);
        for (offset, view) in [
            (number(accessor, "byteOffset"), accessor.get("bufferView")),
            (
                number(&accessor["sparse"]["values"], "byteOffset"),
                accessor.pointer("/sparse/values/bufferView"),
            ),
        ] {
            let Some(view) =
                view.and_then(Value::as_u64).and_then(|view| self.list("bufferViews").get(view as usize))
            else {
                continue;
            };
            let offset = offset.unwrap_or(0);
            let begin = number(view, "byteOffset").unwrap_or(0);
            let stride = number(view, "byteStride").unwrap_or(size * width);
            let is_aligned =
                offset % size == 0 && (offset + begin).is_multiple_of(size) && stride.is_multiple_of(size);
            let is_long_enough = stride >= size * width;
            self.require(is_aligned && is_long_enough, || format!("{place} is not aligned: {accessor}"));
        }
    }

    /// Numbers of an accessor with its sparse values; normalized integers stay integers. [`None`] if one lies
    /// outside.
    fn elements(&self, index: u64) -> Option<Elements> {
        let accessor = self.list("accessors").get(index as usize)?;
        let (size, width) = size_and_width(accessor);
        let (kind, count) = (number(accessor, "componentType")?, number(accessor, "count")?);
        let read = |bytes: &[u8], start: usize, kind: usize| -> Option<f64> {
            let of = |length: usize| bytes.get(start..start + length);
            Some(match kind {
                5120 => f64::from(of(1)?[0] as i8),
                5121 => f64::from(of(1)?[0]),
                5122 => f64::from(i16::from_le_bytes(of(2)?.try_into().ok()?)),
                5123 => f64::from(u16::from_le_bytes(of(2)?.try_into().ok()?)),
                5125 => f64::from(u32::from_le_bytes(of(4)?.try_into().ok()?)),
                _ => f64::from(f32::from_le_bytes(of(4)?.try_into().ok()?)),
            })
        };
        let vector = |bytes: &[u8], start: usize| -> Option<Vec<f64>> {
            (0..width).map(|c| read(bytes, start + c * size, kind)).collect()
        };
        let mut elements: Elements = match number(accessor, "bufferView") {
            None => vec![vec![0.0; width]; count],
            Some(view) => {
                let bytes = self.views.get(view)?;
                let stride = number(&self.list("bufferViews")[view], "byteStride").unwrap_or(size * width);
                let start = number(accessor, "byteOffset").unwrap_or(0);
                (0..count).map(|element| vector(bytes, start + element * stride)).collect::<Option<_>>()?
            }
        };
        let Some(sparse) = accessor.get("sparse") else { return Some(elements) };
        let (places, values) = (&sparse["indices"], &sparse["values"]);
        let bytes = [places, values].map(|part| self.views.get(number(part, "bufferView")?));
        let starts = [places, values].map(|part| number(part, "byteOffset").unwrap_or(0));
        let place_kind = number(places, "componentType")?;
        let place_size = size_of(place_kind);
        let mut next = 0;
        for entry in 0..number(sparse, "count")? {
            let place = read(bytes[0]?, starts[0] + entry * place_size, place_kind)? as usize;
            if place < next {
                return None;
            }
            next = place + 1;
            *elements.get_mut(place)? = vector(bytes[1]?, starts[1] + entry * size * width)?;
        }
        Some(elements)
    }

    /// Numbers of an accessor that something refers to, as fractions if they are normalized.
    fn referred(&mut self, reference: &Value, place: &str) -> Elements {
        let found = reference.as_u64().and_then(|index| {
            let mut elements = self.elements(index)?;
            let accessor = &self.list("accessors")[index as usize];
            if accessor["normalized"] == true {
                let largest = match number(accessor, "componentType")? {
                    5120 => 127.0,
                    5121 => 255.0,
                    5122 => 32767.0,
                    _ => 65535.0,
                };
                elements.iter_mut().flatten().for_each(|x| *x = (*x / largest).max(-1.0));
            }
            Some(elements)
        });
        self.require(found.is_some(), || format!("{place} refers to {reference}"));
        found.unwrap_or_default()
    }

    fn check_meshes(&mut self) {
        for (index, mesh) in self.list("meshes").to_vec().iter().enumerate() {
            let primitives = entries(mesh, "primitives");
            let place = format!("meshes[{index}]");
            self.require(!primitives.is_empty(), || format!("{place} has no primitives"));
            let target_count = primitives.first().map_or(0, |first| entries(first, "targets").len());
            let weights = entries(mesh, "weights").len();
            self.require(weights == 0 || weights == target_count, || {
                format!("{place} has {weights} weights")
            });
            for (number, primitive) in primitives.iter().enumerate() {
                let place = format!("{place}.primitives[{number}]");
                let own = entries(primitive, "targets").len();
                self.require(own == target_count, || format!("{place} has {own} targets"));
                self.check_primitive(primitive, &place);
            }
        }
    }

    fn check_primitive(&mut self, primitive: &Value, place: &str) {
        let positions = &primitive["attributes"]["POSITION"];
        let accessor =
            positions.as_u64().and_then(|index| self.list("accessors").get(index as usize)).cloned();
        let has_bounds = accessor.as_ref().is_some_and(|a| a["min"].is_array() && a["max"].is_array());
        self.require(has_bounds, || format!("{place}: positions without bounds"));
        let count = accessor.as_ref().and_then(|accessor| number(accessor, "count")).unwrap_or(0);
        let mut of_semantic: BTreeMap<String, Elements> = BTreeMap::new();
        let targets = entries(primitive, "targets");
        for (set, members) in std::iter::once(&primitive["attributes"]).chain(targets).enumerate() {
            let members = members.as_object().cloned().unwrap_or_default();
            self.require(!members.is_empty(), || format!("{place}: target {set} is empty"));
            for (name, reference) in members {
                let place = format!("{place}: {name} of set {set}");
                let elements = self.referred(&reference, &place);
                let own = elements.len();
                self.require(own == count, || format!("{place} has {own} elements, not {count}"));
                self.check_vertex_alignment(&reference, &place);
                if set == 0 {
                    of_semantic.insert(name, elements);
                }
            }
        }
        self.check_lengths(&of_semantic, place);
        self.check_weights(&of_semantic, place);
        let Some(indices) = primitive.get("indices") else { return };
        let elements = self.referred(indices, place);
        let largest = elements.iter().map(|e| e[0]).fold(0.0, f64::max);
        self.require((largest as usize) < count, || format!("{place}: index {largest} of {count} vertices"));
        let kind =
            indices.as_u64().and_then(|i| number(&self.list("accessors")[i as usize], "componentType"));
        let is_number = matches!(kind, Some(5121 | 5123 | 5125));
        self.require(is_number, || format!("{place}: indices of type {kind:?}"));
        let restart = match kind {
            Some(5121) => 255.0,
            Some(5123) => 65535.0,
            _ => f64::from(u32::MAX),
        };
        self.require(largest < restart, || format!("{place}: {largest} restarts the primitive"));
        let mode = primitive.get("mode").map_or(Some(4), Value::as_u64);
        self.require(mode != Some(4) || elements.len().is_multiple_of(3), || {
            format!("{place}: no whole triangles")
        });
    }

    fn check_vertex_alignment(&mut self, reference: &Value, place: &str) {
        let accessor = reference.as_u64().and_then(|index| self.list("accessors").get(index as usize));
        let Some(accessor) = accessor else { return };
        let view = number(accessor, "bufferView").and_then(|view| self.list("bufferViews").get(view));
        // Sparse values over zeros lie without gaps.
        let Some(view) = view else { return };
        let (size, width) = size_and_width(accessor);
        let stride = number(view, "byteStride").unwrap_or(size * width);
        let offset = number(accessor, "byteOffset").unwrap_or(0);
        self.require(offset.is_multiple_of(4) && stride.is_multiple_of(4), || {
            format!("{place} is not aligned to four bytes")
        });
    }

    fn check_lengths(&mut self, of_semantic: &BTreeMap<String, Elements>, place: &str) {
        for name in ["NORMAL", "TANGENT"] {
            for vector in of_semantic.get(name).into_iter().flatten() {
                let length = vector[..3].iter().map(|x| x * x).sum::<f64>().sqrt();
                // Bytes round by half of 1/127 along each axis.
                self.require((length - 1.0).abs() < 0.012, || {
                    format!("{place}: a {name} has the length {length}")
                });
            }
        }
    }

    /// Weights add up to one, and each set has its joints.
    fn check_weights(&mut self, of_semantic: &BTreeMap<String, Elements>, place: &str) {
        let set = |prefix: &str| {
            of_semantic.keys().filter_map(|name| name.strip_prefix(prefix)).collect::<Vec<_>>()
        };
        let sets = set("WEIGHTS_");
        self.require(sets == set("JOINTS_"), || format!("{place}: joints and weights differ"));
        if sets.is_empty() {
            return;
        }
        let of_set = |number: &&str| &of_semantic[&format!("WEIGHTS_{number}")];
        for vertex in 0..of_set(&sets[0]).len() {
            let sum: f64 = sets.iter().filter_map(|s| of_set(s).get(vertex)).flatten().sum();
            self.require((sum - 1.0).abs() < 1e-5, || {
                format!("{place}: the weights of {vertex} add up to {sum}")
            });
        }
    }

    fn check_nodes(&mut self) {
        let lengths: BTreeMap<&str, usize> =
            ["nodes", "meshes", "skins", "cameras"].map(|key| (key, self.list(key).len())).into();
        let lights = self.counts()["lights"];
        for (index, node) in self.list("nodes").to_vec().iter().enumerate() {
            let place = format!("nodes[{index}]");
            for (key, list) in [("mesh", "meshes"), ("skin", "skins"), ("camera", "cameras")] {
                self.require(refers_below(node.get(key), lengths[list]), || format!("{place}: {key}"));
            }
            let ids = node.pointer("/extensions/MSFT_lod/ids").and_then(Value::as_array);
            for node in entries(node, "children").iter().chain(ids.into_iter().flatten()) {
                self.require(refers_below(Some(node), lengths["nodes"]), || format!("{place}: {node}"));
            }
            let light = node.pointer("/extensions/KHR_lights_punctual/light");
            self.require(refers_below(light, lights), || format!("{place}: light"));
            let instances = node.pointer("/extensions/EXT_mesh_gpu_instancing/attributes");
            let mut counts = BTreeSet::new();
            for (name, reference) in instances.and_then(Value::as_object).into_iter().flatten() {
                counts.insert(self.referred(reference, &format!("{place}: {name}")).len());
            }
            self.require(counts.len() < 2, || format!("{place}: {counts:?} instances"));
            self.check_skinned(node, &place);
        }
        for (index, skin) in self.list("skins").to_vec().iter().enumerate() {
            let joints = entries(skin, "joints");
            for joint in joints.iter().chain(skin.get("skeleton")) {
                self.require(refers_below(Some(joint), lengths["nodes"]), || {
                    format!("skins[{index}]: {joint}")
                });
            }
            if let Some(matrices) = skin.get("inverseBindMatrices") {
                let count = self.referred(matrices, &format!("skins[{index}]")).len();
                self.require(count >= joints.len(), || format!("skins[{index}] has {count} matrices"));
            }
        }
    }

    /// Joints of a skinned mesh are those of its skin, and the weights of the node are those of its mesh.
    fn check_skinned(&mut self, node: &Value, place: &str) {
        let Some(mesh) = number(node, "mesh").and_then(|mesh| self.list("meshes").get(mesh)).cloned() else {
            return;
        };
        let targets = entries(&mesh, "primitives").first().map_or(0, |first| entries(first, "targets").len());
        let weights = entries(node, "weights").len();
        self.require(weights == 0 || weights == targets, || format!("{place} has {weights} weights"));
        let Some(skin) = number(node, "skin").and_then(|skin| self.list("skins").get(skin)) else { return };
        let joint_count = entries(skin, "joints").len() as f64;
        for primitive in entries(&mesh, "primitives") {
            let attributes = primitive["attributes"].as_object().cloned().unwrap_or_default();
            let has_joints = attributes.contains_key("JOINTS_0");
            self.require(has_joints, || format!("{place}: a primitive of a skinned mesh has no joints"));
            for (name, joints) in attributes.iter().filter(|(name, _)| name.starts_with("JOINTS_")) {
                let joints = self.referred(joints, place);
                let largest = joints.iter().flatten().copied().fold(0.0, f64::max);
                self.require(largest < joint_count, || format!("{place}: {name} {largest} of {joint_count}"));
            }
        }
    }

    fn check_animations(&mut self) {
        for (index, animation) in self.list("animations").to_vec().iter().enumerate() {
            let samplers = entries(animation, "samplers");
            for (number, channel) in entries(animation, "channels").iter().enumerate() {
                let place = format!("animations[{index}].channels[{number}]");
                let sampler = channel["sampler"].as_u64().and_then(|sampler| samplers.get(sampler as usize));
                let Some(sampler) = sampler else {
                    self.fault(format!("{place} has no sampler"));
                    continue;
                };
                let times = self.referred(&sampler["input"], &place);
                let is_rising = times.windows(2).all(|pair| pair[0] < pair[1]);
                self.require(is_rising, || format!("{place}: times do not rise"));
                let input = sampler["input"].as_u64().and_then(|i| self.list("accessors").get(i as usize));
                let has_bounds = input.is_some_and(|a| a["min"].is_array() && a["max"].is_array());
                self.require(has_bounds, || format!("{place}: times without bounds"));
                let values = self.referred(&sampler["output"], &place).len();
                let keys = times.len() * if sampler["interpolation"] == "CUBICSPLINE" { 3 } else { 1 };
                let target = &channel["target"];
                let width = if target["path"] == "weights" { self.target_count(target) } else { 1 };
                self.require(values == keys * width, || format!("{place}: {values} values at {keys} keys"));
                let pointer =
                    target.pointer("/extensions/KHR_animation_pointer/pointer").and_then(Value::as_str);
                // Properties may have their default.
                let object = pointer.and_then(|pointer| Some(pointer.rsplit_once('/')?.0));
                let resolves = object.is_none_or(|object| self.document.pointer(object).is_some());
                self.require(resolves, || format!("{place}: {pointer:?} leads nowhere"));
            }
        }
    }

    fn target_count(&self, target: &Value) -> usize {
        let node = number(target, "node").and_then(|node| self.list("nodes").get(node));
        let mesh = node.and_then(|node| self.list("meshes").get(number(node, "mesh")?));
        mesh.map_or(0, |mesh| entries(&mesh["primitives"][0], "targets").len())
    }

    fn check_materials(&mut self) {
        let [materials, textures, images, samplers] =
            ["materials", "textures", "images", "samplers"].map(|key| self.list(key).len());
        let variants = self.document.pointer("/extensions/KHR_materials_variants/variants");
        let variants = variants.and_then(Value::as_array).map_or(0, Vec::len);
        for (index, mesh) in self.list("meshes").to_vec().iter().enumerate() {
            for primitive in entries(mesh, "primitives") {
                let mut used = primitive.get("material").into_iter().collect::<Vec<_>>();
                let mappings = primitive.pointer("/extensions/KHR_materials_variants/mappings");
                for mapping in mappings.and_then(Value::as_array).into_iter().flatten() {
                    used.extend(mapping.get("material"));
                    let are_known =
                        entries(mapping, "variants").iter().all(|v| refers_below(Some(v), variants));
                    self.require(are_known, || format!("meshes[{index}]: {mapping}"));
                }
                for material in used {
                    let is_known = refers_below(Some(material), materials);
                    self.require(is_known, || format!("meshes[{index}]: material {material}"));
                    let entry = material.as_u64().and_then(|i| self.list("materials").get(i as usize));
                    let mut sets = BTreeSet::new();
                    entry.into_iter().for_each(|entry| texcoord_sets(entry, &mut sets));
                    for set in sets {
                        let has = primitive["attributes"].get(format!("TEXCOORD_{set}")).is_some();
                        self.require(has, || format!("meshes[{index}]: no TEXCOORD_{set} for {material}"));
                    }
                }
            }
        }
        let mut found = Vec::new();
        self.list("materials").iter().for_each(|material| texture_indices(material, &mut found));
        for texture in found {
            self.require(refers_below(Some(&texture), textures), || format!("texture {texture}"));
        }
        for (index, texture) in self.list("textures").to_vec().iter().enumerate() {
            let is_known =
                refers_below(texture.get("source"), images) && refers_below(texture.get("sampler"), samplers);
            self.require(is_known, || format!("textures[{index}]: {texture}"));
        }
        for (index, image) in self.list("images").to_vec().iter().enumerate() {
            let bytes = number(image, "bufferView").and_then(|view| self.views.get(view));
            let is_whole = match image["mimeType"].as_str() {
                Some("image/png") => bytes.is_some_and(|bytes| bytes.starts_with(b"\x89PNG")),
                _ => image.get("uri").is_some() || image.get("mimeType").is_some(),
            };
            self.require(is_whole, || format!("images[{index}]: {image}"));
        }
    }

    fn check_extensions(&mut self) {
        let mut used = BTreeSet::new();
        extensions_in(&self.document, &mut used);
        let names = |key: &str| -> BTreeSet<String> {
            self.list(key).iter().filter_map(Value::as_str).map(str::to_owned).collect()
        };
        let (declared, required) = (names("extensionsUsed"), names("extensionsRequired"));
        let missing: Vec<&String> =
            used.difference(&declared).chain(required.difference(&declared)).collect();
        let missing = format!("{missing:?}");
        self.require(missing == "[]", || format!("extensionsUsed lacks {missing}"));
        let is_quantized = |mesh: &Value| {
            entries(mesh, "primitives").iter().any(|primitive| {
                let accessor = primitive["attributes"]["POSITION"].as_u64();
                let accessor = accessor.and_then(|index| self.list("accessors").get(index as usize));
                accessor
                    .and_then(|accessor| number(accessor, "componentType"))
                    .is_some_and(|kind| kind != 5126)
            })
        };
        let needs = self.list("meshes").iter().any(is_quantized);
        let has = required.contains("KHR_mesh_quantization");
        self.require(!needs || has, || "KHR_mesh_quantization is not required".to_owned());
        for name in required.union(&declared).filter(|name| !used.contains(*name)) {
            self.require(name == "KHR_mesh_quantization", || format!("{name} is declared and not used"));
        }
    }
}

/// Returns the document and the binary data of a GLB file.
fn chunks(glb: &[u8]) -> (Value, Vec<u8>) {
    let length = |at: usize| u32::from_le_bytes(glb[at..at + 4].try_into().expect("four bytes")) as usize;
    assert_eq!((&glb[..4], length(8)), (&b"glTF"[..], glb.len()), "the header of a GLB file");
    let text = 20 + length(12);
    let document = serde_json::from_slice(&glb[20..text]).expect("the document is JSON");
    let binary = if text < glb.len() { glb[text + 8..text + 8 + length(text)].to_vec() } else { Vec::new() };
    (document, binary)
}

fn entries<'v>(value: &'v Value, key: &str) -> &'v [Value] {
    value.get(key).and_then(Value::as_array).map_or(&[], Vec::as_slice)
}

fn number(value: &Value, key: &str) -> Option<usize> {
    value.get(key)?.as_u64().and_then(|number| usize::try_from(number).ok())
}

/// Whether a reference is absent or below the number of entries.
fn refers_below(reference: Option<&Value>, count: usize) -> bool {
    reference.is_none_or(|reference| reference.as_u64().is_some_and(|index| (index as usize) < count))
}

fn size_of(component: usize) -> usize {
    match component {
        5120 | 5121 => 1,
        5122 | 5123 => 2,
        _ => 4,
    }
}

fn size_and_width(accessor: &Value) -> (usize, usize) {
    let width = match accessor["type"].as_str() {
        Some("VEC2") => 2,
        Some("VEC3") => 3,
        Some("VEC4" | "MAT2") => 4,
        Some("MAT3") => 9,
        Some("MAT4") => 16,
        _ => 1,
    };
    (size_of(number(accessor, "componentType").unwrap_or(0)), width)
}

fn extensions_in(value: &Value, found: &mut BTreeSet<String>) {
    match value {
        Value::Object(members) => {
            for (key, member) in members.iter().filter(|(key, _)| *key != "extras") {
                if key == "extensions" {
                    found.extend(member.as_object().into_iter().flatten().map(|(name, _)| name.clone()));
                }
                extensions_in(member, found);
            }
        }
        Value::Array(entries) => entries.iter().for_each(|entry| extensions_in(entry, found)),
        _ => {}
    }
}

/// Numbers of names and extras in a document.
#[derive(Default)]
struct NameCounts {
    names: usize,
    extras: usize,
}

/// Counts names and extras.
fn count_names(value: &Value, counts: &mut NameCounts) {
    match value {
        Value::Object(members) => {
            counts.names += usize::from(members.contains_key("name"));
            counts.extras += usize::from(members.contains_key("extras"));
            members
                .iter()
                .filter(|(key, _)| *key != "extras")
                .for_each(|(_, member)| count_names(member, counts));
        }
        Value::Array(entries) => entries.iter().for_each(|entry| count_names(entry, counts)),
        _ => {}
    }
}

/// References to textures: members whose names end with `Texture`.
fn texture_uses<'v>(value: &'v Value, visit: &mut dyn FnMut(&'v Value)) {
    match value {
        Value::Object(members) => {
            for (key, member) in members {
                if key.ends_with("Texture") && member.get("index").is_some() {
                    visit(member);
                }
                texture_uses(member, visit);
            }
        }
        Value::Array(entries) => entries.iter().for_each(|entry| texture_uses(entry, visit)),
        _ => {}
    }
}

fn texture_indices(material: &Value, found: &mut Vec<Value>) {
    texture_uses(material, &mut |texture| found.push(texture["index"].clone()));
}

fn texcoord_sets(material: &Value, found: &mut BTreeSet<u64>) {
    texture_uses(material, &mut |texture| {
        let moved = texture.pointer("/extensions/KHR_texture_transform/texCoord");
        let set = moved.or_else(|| texture.get("texCoord")).and_then(Value::as_u64);
        found.insert(set.unwrap_or(0));
    });
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;
    use crate::scenes;

    fn plain(_: &Value, _: &[u8]) -> Vec<u8> {
        Vec::new()
    }

    #[test]
    fn test_scenes_are_valid() {
        for scene in scenes::varied() {
            let glb = CheckedGlb::new(&scene.to_glb(), plain);
            assert_eq!(glb.faults(), [""; 0], "{}", scene.name);
        }
    }

    #[test]
    fn faults_are_found() {
        for (pointer, value, expected) in [
            ("/accessors/0/min", json!([0.0, 0.0, 0.0]), "min"),
            ("/accessors/0/count", json!(100_000), "outside"),
            ("/meshes/0/primitives/0/material", json!(9), "material 9"),
            ("/meshes/0/primitives/0/indices", json!(0), "indices of type"),
            ("/nodes/0/mesh", json!(4), "mesh"),
            ("/extensionsUsed", json!(["VENDOR_x"]), "declared"),
            ("/nodes/1/extensions", json!({ "VENDOR_x": {} }), "lacks"),
            ("/bufferViews/0/byteLength", json!(1_000_000), "bufferViews[0] ends"),
        ] {
            let mut scene = scenes::shared_accessors();
            scene.document["extensionsUsed"] = json!([]);
            scene.document["nodes"][1]["extensions"] = json!({});
            *scene.document.pointer_mut(pointer).expect("a place of the document") = value;
            let faults = CheckedGlb::new(&scene.to_glb(), plain).faults;
            assert!(faults.iter().any(|fault| fault.contains(expected)), "{pointer}: {faults:?}");
        }
    }
}
