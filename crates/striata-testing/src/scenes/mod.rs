//! glTF documents for tests of scenes: hierarchies, instances, skins, morph targets, animations.

mod varied;

pub use varied::*;

use serde_json::{Value, json};
use striata::mesh::{AttributeLayer, IndexedMesh, LayerData, Semantic, TriangleGroup, shapes};

/// A glTF document with one buffer.
#[derive(Clone, Debug)]
pub struct TestScene {
    pub name: &'static str,
    pub document: Value,
    pub buffer: Vec<u8>,
}

/// All test scenes.
pub fn all() -> Vec<TestScene> {
    let mut all = vec![
        hierarchy(),
        skinned(),
        morphed(),
        bending_tube(),
        folding_grid(),
        two_sizes(),
        mixed_primitives(),
        without_nodes(),
        with_unknown_references(),
        vanishing_primitive(),
        instanced_by_extension(),
        empty(),
    ];
    all.extend(varied());
    all
}

impl TestScene {
    /// Creates an empty document.
    pub fn named(name: &'static str) -> Self {
        Self { name, document: json!({ "asset": { "version": "2.0" } }), buffer: Vec::new() }
    }

    /// Encodes the document as a GLB file.
    pub fn to_glb(&self) -> Vec<u8> {
        self.to_glb_with(&[])
    }

    /// Encodes the document as a GLB file, after some of its strings have been replaced by JSON texts: arrays
    /// of a million entries would take gigabytes as values.
    pub fn to_glb_with(&self, texts: &[(&str, String)]) -> Vec<u8> {
        let mut document = self.document.clone();
        let mut buffer = self.buffer.clone();
        buffer.resize(buffer.len().next_multiple_of(4), 0);
        if !buffer.is_empty() {
            document["buffers"] = json!([{ "byteLength": buffer.len() }]);
        }
        let mut text = document.to_string();
        for (string, value) in texts {
            text = text.replace(&format!("\"{string}\""), value);
        }
        let mut text = text.into_bytes();
        text.resize(text.len().next_multiple_of(4), b' ');
        let chunks = [(b"JSON", text), (b"BIN\0", buffer)];
        let chunks: Vec<_> = chunks.into_iter().filter(|(_, bytes)| !bytes.is_empty()).collect();
        let length = 12 + chunks.iter().map(|(_, bytes)| 8 + bytes.len()).sum::<usize>();
        let mut out = b"glTF\x02\0\0\0".to_vec();
        out.extend((length as u32).to_le_bytes());
        for (kind, bytes) in chunks {
            out.extend((bytes.len() as u32).to_le_bytes());
            out.extend(kind);
            out.extend(bytes);
        }
        out
    }

    /// Appends an entry to an array of the document, and returns its index.
    pub fn push(&mut self, array: &str, entry: Value) -> usize {
        if self.document[array].is_null() {
            self.document[array] = json!([]);
        }
        let entries = self.document[array].as_array_mut().expect("an array of the document");
        entries.push(entry);
        entries.len() - 1
    }

    /// Appends bytes as a buffer view, and returns its index.
    pub fn push_view(&mut self, bytes: &[u8]) -> usize {
        self.buffer.resize(self.buffer.len().next_multiple_of(4), 0);
        let view = json!({ "buffer": 0, "byteOffset": self.buffer.len(), "byteLength": bytes.len() });
        self.buffer.extend_from_slice(bytes);
        self.push("bufferViews", view)
    }

    /// Appends floats as an accessor of vectors, and returns its index.
    pub fn push_floats(&mut self, kind: &str, width: usize, numbers: &[f32]) -> usize {
        let bytes: Vec<u8> = numbers.iter().flat_map(|x| x.to_le_bytes()).collect();
        let view = self.push_view(&bytes);
        let mut accessor = json!({
            "bufferView": view, "componentType": 5126, "count": numbers.len() / width, "type": kind,
        });
        if !numbers.is_empty() && width <= 3 {
            let column = |c: usize| numbers.iter().skip(c).step_by(width).copied();
            let of = |pick: fn(f32, f32) -> f32| -> Vec<f32> {
                (0..width).map(|c| column(c).reduce(pick).unwrap_or(0.0)).collect()
            };
            (accessor["min"], accessor["max"]) = (json!(of(f32::min)), json!(of(f32::max)));
        }
        self.push("accessors", accessor)
    }

    fn push_shorts(&mut self, kind: &str, width: usize, numbers: &[u16]) -> usize {
        let bytes: Vec<u8> = numbers.iter().flat_map(|x| x.to_le_bytes()).collect();
        let view = self.push_view(&bytes);
        self.push(
            "accessors",
            json!({
                "bufferView": view, "componentType": 5123, "count": numbers.len() / width, "type": kind,
            }),
        )
    }

    /// Returns the primitives of a mesh, one for each group, over accessors that they share.
    pub fn primitives_of(&mut self, mesh: &IndexedMesh) -> Vec<Value> {
        let mut attributes =
            json!({ "POSITION": self.push_floats("VEC3", 3, mesh.positions.as_flattened()) });
        let mut targets: Vec<Value> = Vec::new();
        for layer in &mesh.layers {
            let width = layer.component_count as usize;
            let kind = ["", "SCALAR", "VEC2", "VEC3", "VEC4"][width];
            let accessor = match &layer.data {
                LayerData::F32(numbers) => self.push_floats(kind, width, numbers),
                LayerData::U16(numbers) => self.push_shorts(kind, width, numbers),
                other => panic!("no test scene has layers like {other:?}"),
            };
            match &layer.semantic {
                Semantic::Normal => attributes["NORMAL"] = json!(accessor),
                Semantic::TexCoord(set) => attributes[format!("TEXCOORD_{set}")] = json!(accessor),
                Semantic::Joints(set) => attributes[format!("JOINTS_{set}")] = json!(accessor),
                Semantic::Weights(set) => attributes[format!("WEIGHTS_{set}")] = json!(accessor),
                Semantic::MorphPosition(_) => targets.push(json!({ "POSITION": accessor })),
                other => panic!("no test scene has layers like {other}"),
            }
        }
        let primitive = |group: &TriangleGroup| {
            let triangles = &mesh.triangles[group.range()];
            let corners: Vec<u16> = triangles.as_flattened().iter().map(|&v| v as u16).collect();
            let indices = self.push_shorts("SCALAR", 1, &corners);
            let mut primitive = json!({ "attributes": attributes, "indices": indices });
            if let Some(material) = group.material {
                primitive["material"] = json!(material);
            }
            if !targets.is_empty() {
                primitive["targets"] = json!(targets);
            }
            primitive
        };
        mesh.groups_or_whole().iter().map(primitive).collect()
    }

    /// Adds a mesh with a primitive for each group, and returns its index.
    pub fn push_mesh(&mut self, name: &str, mesh: &IndexedMesh) -> usize {
        let primitives = self.primitives_of(mesh);
        self.push("meshes", json!({ "name": name, "primitives": primitives }))
    }

    fn push_materials(&mut self, count: usize) {
        for material in 0..count {
            let color = [0.2 * material as f32, 0.5, 0.8, 1.0];
            let factors = json!({ "baseColorFactor": color, "metallicFactor": 0.0 });
            self.push(
                "materials",
                json!({ "name": format!("m{material}"), "pbrMetallicRoughness": factors }),
            );
        }
    }
}

/// The smallest PNG file: one pixel.
pub const PNG: &[u8] = &[
    0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a, 0x00, 0x00, 0x00, 0x0d, 0x49, 0x48, 0x44, 0x52, 0x00,
    0x00, 0x00, 0x01, 0x00, 0x00, 0x00, 0x01, 0x08, 0x00, 0x00, 0x00, 0x00, 0x3a, 0x7e, 0x9b, 0x55, 0x00,
    0x00, 0x00, 0x0a, 0x49, 0x44, 0x41, 0x54, 0x78, 0x9c, 0x63, 0x68, 0x00, 0x00, 0x00, 0x82, 0x00, 0x81,
    0x77, 0xcd, 0x72, 0xb6, 0x00, 0x00, 0x00, 0x00, 0x49, 0x45, 0x4e, 0x44, 0xae, 0x42, 0x60, 0x82,
];

/// Nested nodes with negative and uneven scales, a mesh shown three times, two scenes, a camera, a light, an
/// image, and an extension without references that nobody knows.
pub fn hierarchy() -> TestScene {
    let mut scene = TestScene::named("hierarchy");
    scene.push_materials(3);
    let view = scene.push_view(PNG);
    scene.push("images", json!({ "bufferView": view, "mimeType": "image/png", "name": "pixel" }));
    scene.push("textures", json!({ "source": 0 }));
    scene.document["materials"][1]["emissiveTexture"] = json!({ "index": 0 });
    scene.document["materials"][1]["emissiveFactor"] = json!([1.0, 1.0, 1.0]);
    let mut sphere = shapes::two_material_sphere(12, 18);
    sphere.groups[1].material = Some(2);
    let ball = scene.push_mesh("ball", &sphere);
    let ring = scene.push_mesh("ring", &shapes::torus(24, 12, 1.0, 0.3));
    scene.push_mesh("only in the other scene", &shapes::icosphere(2, 1.0));
    scene.push(
        "cameras",
        json!({
            "type": "perspective", "perspective": { "yfov": 0.8, "znear": 0.01 }, "name": "eye",
        }),
    );
    let lights = json!({ "lights": [{ "type": "point", "color": [1.0, 0.5, 0.2] }] });
    scene.document["extensions"] = json!({ "KHR_lights_punctual": lights });
    let half = std::f32::consts::FRAC_1_SQRT_2;
    scene.document["nodes"] = json!([
        { "name": "root", "children": [1, 2, 5], "scale": [2.0, 2.0, 2.0] },
        { "name": "left", "mesh": ball, "translation": [-2.0, 0.0, 0.0], "scale": [-1.0, 1.0, 1.0],
          "extras": { "tag": "kept" } },
        { "name": "right", "mesh": ball, "children": [3, 4], "rotation": [0.0, half, 0.0, half] },
        { "name": "deep", "mesh": ring, "scale": [0.5, 3.0, 0.25],
          "extensions": { "KHR_lights_punctual": { "light": 0 } } },
        { "name": "matrix", "mesh": ball,
          "matrix": [0.0, 1.0, 0.0, 0.0, -1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 4.0, 0.0, 1.0, 2.0, 3.0, 1.0] },
        { "name": "viewer", "camera": 0 },
        { "name": "alone", "mesh": 2, "extensions": { "VENDOR_secret": { "strength": 3 } } },
    ]);
    scene.document["scenes"] = json!([{ "nodes": [6] }, { "nodes": [0], "name": "main" }]);
    scene.document["scene"] = json!(1);
    scene.document["extensionsUsed"] = json!(["KHR_lights_punctual", "VENDOR_secret"]);
    scene
}

/// A tube with two joints, one of which is animated.
pub fn skinned() -> TestScene {
    let mut scene = TestScene::named("skinned");
    scene.push_materials(1);
    let mut tube = shapes::uv_cylinder(16, 20);
    let height = |p: &[f32; 3]| (p[1] * 0.5 + 0.5).clamp(0.0, 1.0);
    let joints = tube.positions.iter().flat_map(|_| [0u16, 1, 0, 0]).collect();
    let weights = tube.positions.iter().flat_map(|p| [1.0 - height(p), height(p), 0.0, 0.0]).collect();
    let layer = |semantic, data| AttributeLayer { semantic, component_count: 4, normalized: false, data };
    tube.layers.push(layer(Semantic::Joints(0), LayerData::U16(joints)));
    tube.layers.push(layer(Semantic::Weights(0), LayerData::F32(weights)));
    let mesh = scene.push_mesh("tube", &tube);
    let identity = [1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0];
    let binds = scene.push_floats("MAT4", 16, &[identity, identity].concat());
    let times = scene.push_floats("SCALAR", 1, &[0.0, 1.0]);
    let turns = scene.push_floats("VEC4", 4, &[0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 1.0, 0.0]);
    scene.document["nodes"] = json!([
        { "mesh": mesh, "skin": 0, "name": "body" },
        { "name": "lower", "children": [2], "scale": [3.0, 3.0, 3.0] },
        { "name": "upper" },
    ]);
    scene.push("skins", json!({ "joints": [1, 2], "inverseBindMatrices": binds, "skeleton": 1 }));
    scene.push(
        "animations",
        json!({
            "channels": [{ "sampler": 0, "target": { "node": 2, "path": "rotation" } }],
            "samplers": [{ "input": times, "output": turns }],
        }),
    );
    scene.document["scenes"] = json!([{ "nodes": [0, 1] }]);
    scene.document["scene"] = json!(0);
    scene
}

/// A sphere with two morph targets, whose weights are animated, and a node with a child.
pub fn morphed() -> TestScene {
    let mut scene = TestScene::named("morphed");
    let mut sphere = shapes::icosphere(3, 1.0);
    for target in 0..2 {
        let delta = sphere.positions.iter().flat_map(|p| [p[0] * 0.5, p[1] * f32::from(target), 0.25]);
        sphere.layers.push(AttributeLayer {
            semantic: Semantic::MorphPosition(target),
            component_count: 3,
            normalized: false,
            data: LayerData::F32(delta.collect()),
        });
    }
    let mesh = scene.push_mesh("face", &sphere);
    scene.document["meshes"][mesh]["weights"] = json!([0.25, 0.0]);
    scene.document["meshes"][mesh]["extras"] = json!({ "targetNames": ["wide", "tall"] });
    let small = scene.push_mesh("nose", &shapes::torus(12, 8, 0.2, 0.1));
    let times = scene.push_floats("SCALAR", 1, &[0.0, 2.0]);
    let weights = scene.push_floats("SCALAR", 1, &[0.0, 1.0, 1.0, 0.0]);
    let moves = scene.push_floats("VEC3", 3, &[0.0, 0.0, 0.0, 0.0, 1.0, 0.0]);
    scene.document["nodes"] = json!([
        { "mesh": mesh, "weights": [0.5, 0.5], "children": [1] },
        { "mesh": small, "translation": [0.0, 0.0, 1.0] },
        { "mesh": mesh, "translation": [3.0, 0.0, 0.0] },
    ]);
    scene.push(
        "animations",
        json!({
            "channels": [
                { "sampler": 0, "target": { "node": 0, "path": "weights" } },
                { "sampler": 0, "target": { "node": 2, "path": "weights" } },
                { "sampler": 1, "target": { "node": 2, "path": "translation" } },
            ],
            "samplers": [{ "input": times, "output": weights }, { "input": times, "output": moves }],
        }),
    );
    scene.document["scenes"] = json!([{ "nodes": [0, 2] }]);
    scene
}

/// A straight tube of 40 rings, whose middle ring its animation bends by a right angle.
pub fn bending_tube() -> TestScene {
    let mut scene = TestScene::named("bending tube");
    let mesh = scene.push_mesh("tube", &jointed_tube());
    let half = std::f32::consts::FRAC_1_SQRT_2;
    scene.push_bend([0.0, half, 0.0, half]);
    scene.document["nodes"] = json!([
        { "mesh": mesh, "skin": 0 },
        { "name": "lower", "children": [2] },
        { "name": "upper", "translation": [0.0, 0.0, 2.0] },
    ]);
    scene.push_skin([1, 2]);
    scene.document["scenes"] = json!([{ "nodes": [0, 1] }]);
    scene
}

/// The tube of [`bending_tube`] twice, in two sizes with a skin each; the animation bends only one of them.
pub fn two_sizes() -> TestScene {
    let mut scene = TestScene::named("two sizes");
    let mesh = scene.push_mesh("tube", &jointed_tube());
    let half = std::f32::consts::FRAC_1_SQRT_2;
    scene.push_bend([0.0, half, 0.0, half]);
    scene.document["nodes"] = json!([
        { "mesh": mesh, "skin": 0 },
        { "name": "lower", "children": [2], "scale": [0.25, 0.25, 0.25] },
        { "name": "upper", "translation": [0.0, 0.0, 2.0] },
        { "mesh": mesh, "skin": 1 },
        { "name": "large lower", "children": [5], "scale": [3.0, 3.0, 3.0], "translation": [9.0, 0.0, 0.0] },
        { "name": "large upper", "translation": [0.0, 0.0, 2.0] },
    ]);
    scene.push_skin([1, 2]);
    scene.push_skin([4, 5]);
    scene.document["scenes"] = json!([{ "nodes": [0, 1, 3, 4] }]);
    scene
}

/// A flat grid that its morph targets fold to a roof and raise to a ridge.
pub fn folding_grid() -> TestScene {
    let mut scene = TestScene::named("folding grid");
    let mut grid = shapes::grid(24, 24);
    let bounds = grid.bounds().expect("a grid has vertices");
    let width = bounds.max[0] - bounds.min[0];
    let across = |p: &[f32; 3]| (p[0] - bounds.min[0]) / width;
    let roof = |p: &[f32; 3]| [0.0, 0.0, width * (0.5 - (across(p) - 0.5).abs())];
    let ridge = |p: &[f32; 3]| [0.0, 0.0, width * (0.25 - (across(p) - 0.25).abs()).max(0.0)];
    for (target, delta) in [
        grid.positions.iter().flat_map(roof).collect::<Vec<f32>>(),
        grid.positions.iter().flat_map(ridge).collect(),
    ]
    .into_iter()
    .enumerate()
    {
        let semantic = Semantic::MorphPosition(target as u16);
        grid.layers.push(AttributeLayer::from_f32(semantic, 3, delta));
    }
    let mesh = scene.push_mesh("grid", &grid);
    let times = scene.push_floats("SCALAR", 1, &[0.0, 1.0, 2.0]);
    let weights = scene.push_floats("SCALAR", 1, &[0.0, 0.0, 1.0, 0.0, 0.0, 1.0]);
    scene.document["nodes"] = json!([{ "mesh": mesh }]);
    scene.push(
        "animations",
        json!({
            "channels": [{ "sampler": 0, "target": { "node": 0, "path": "weights" } }],
            "samplers": [{ "input": times, "output": weights }],
        }),
    );
    scene.document["scenes"] = json!([{ "nodes": [0] }]);
    scene
}

/// A tube along z from 0 to 4, the upper half of which follows the second of two joints.
fn jointed_tube() -> IndexedMesh {
    let mut tube = shapes::uv_cylinder(24, 40);
    tube.layers.clear();
    for position in &mut tube.positions {
        position[0] *= 0.5;
        position[1] *= 0.5;
        position[2] *= 4.0;
    }
    // The weight rises from 0 to 1 around the middle.
    let upper = |p: &[f32; 3]| ((p[2] - 1.6) / 0.8).clamp(0.0, 1.0);
    let joints = tube.positions.iter().flat_map(|_| [0u16, 1, 0, 0]).collect();
    let weights = tube.positions.iter().flat_map(|p| [1.0 - upper(p), upper(p), 0.0, 0.0]).collect();
    let layer = |semantic, data| AttributeLayer { semantic, component_count: 4, normalized: false, data };
    tube.layers.push(layer(Semantic::Joints(0), LayerData::U16(joints)));
    tube.layers.push(layer(Semantic::Weights(0), LayerData::F32(weights)));
    tube
}

impl TestScene {
    /// Adds an animation that turns node 2 from its rest to a rotation within a second.
    fn push_bend(&mut self, rotation: [f32; 4]) {
        let times = self.push_floats("SCALAR", 1, &[0.0, 1.0]);
        let turns = self.push_floats("VEC4", 4, &[[0.0, 0.0, 0.0, 1.0], rotation].concat());
        self.push(
            "animations",
            json!({
                "channels": [{ "sampler": 0, "target": { "node": 2, "path": "rotation" } }],
                "samplers": [{ "input": times, "output": turns }],
            }),
        );
    }

    /// Adds a skin of two joints, the second of which is two units above the first.
    fn push_skin(&mut self, joints: [usize; 2]) {
        let lifted = |z: f32| {
            let mut matrix = [0.0; 16];
            (0..4).for_each(|i| matrix[5 * i] = 1.0);
            matrix[14] = z;
            matrix
        };
        let binds = self.push_floats("MAT4", 16, &[lifted(0.0), lifted(-2.0)].concat());
        self.push("skins", json!({ "joints": joints, "inverseBindMatrices": binds }));
    }
}

/// A mesh of triangles and points, and one of lines only.
pub fn mixed_primitives() -> TestScene {
    let mut scene = TestScene::named("mixed primitives");
    scene.push_materials(2);
    let mut primitives = scene.primitives_of(&shapes::two_material_sphere(10, 14));
    let points = scene.push_floats("VEC3", 3, &[0.0, 0.0, 0.0, 1.0, 2.0, 3.0]);
    primitives.insert(1, json!({ "attributes": { "POSITION": points }, "mode": 0 }));
    let both = scene.push("meshes", json!({ "primitives": primitives }));
    let ends = scene.push_floats("VEC3", 3, &[0.0, 0.0, 0.0, 5.0, 5.0, 5.0]);
    let lines = json!({ "attributes": { "POSITION": ends }, "mode": 1, "material": 1 });
    let lines = scene.push("meshes", json!({ "primitives": [lines] }));
    scene.document["nodes"] = json!([{ "mesh": both }, { "mesh": lines }]);
    scene.document["scenes"] = json!([{ "nodes": [0, 1] }]);
    scene
}

/// Meshes that no node shows.
pub fn without_nodes() -> TestScene {
    let mut scene = TestScene::named("without nodes");
    scene.push_mesh("a", &shapes::icosphere(2, 1.0));
    scene.push_mesh("b", &shapes::torus(10, 8, 2.0, 0.5));
    scene
}

/// An unknown extension that refers to an accessor and a buffer view, which must keep their numbers.
pub fn with_unknown_references() -> TestScene {
    let mut scene = TestScene::named("unknown references");
    let mesh = scene.push_mesh("ball", &shapes::icosphere(2, 1.0));
    let accessor = scene.push_floats("SCALAR", 1, &[1.0, 2.0, 3.0]);
    let view = scene.push_view(b"opaque data");
    let secret = json!({ "VENDOR_secret": { "accessor": accessor, "bufferView": view } });
    scene.document["nodes"] = json!([{ "mesh": mesh, "extensions": secret }]);
    scene.document["scenes"] = json!([{ "nodes": [0] }]);
    scene.document["extensionsUsed"] = json!(["VENDOR_secret"]);
    scene
}

/// A large sphere with a tiny separate primitive, of which coarse levels show nothing, and an empty one.
pub fn vanishing_primitive() -> TestScene {
    let mut scene = TestScene::named("vanishing primitive");
    scene.push_materials(3);
    let mut mesh = shapes::icosphere(3, 1.0);
    let first = mesh.triangles.len() as u32;
    let tiny = shapes::icosphere(0, 0.001);
    let offset = mesh.positions.len() as u32;
    mesh.positions.extend(tiny.positions.iter().map(|p| [p[0] + 1.2, p[1], p[2]]));
    mesh.layers.clear();
    mesh.triangles.extend(tiny.triangles.iter().map(|t| t.map(|v| v + offset)));
    let group = |material, first, count| TriangleGroup {
        material: Some(material),
        first,
        count,
        ..TriangleGroup::default()
    };
    let tiny_count = tiny.triangles.len() as u32;
    mesh.groups = vec![group(2, 0, first), group(0, first, tiny_count)];
    // All corners of this primitive are at one point.
    let flat = IndexedMesh::new(vec![[0.5; 3]; 3], vec![[0, 1, 2]]);
    let mut primitives = scene.primitives_of(&mesh);
    let mut flat = scene.primitives_of(&flat);
    flat[0]["material"] = json!(1);
    primitives.insert(1, flat.remove(0));
    let mesh = scene.push("meshes", json!({ "primitives": primitives }));
    scene.document["nodes"] = json!([{ "mesh": mesh }]);
    scene.document["scenes"] = json!([{ "nodes": [0] }]);
    scene
}

/// A node whose mesh an extension shows several times.
pub fn instanced_by_extension() -> TestScene {
    let mut scene = TestScene::named("instanced by extension");
    let mesh = scene.push_mesh("tree", &shapes::uv_cylinder(12, 9));
    let places = scene.push_floats("VEC3", 3, &[0.0, 0.0, 0.0, 5.0, 0.0, 0.0, 0.0, 0.0, 5.0]);
    let instancing = json!({ "EXT_mesh_gpu_instancing": { "attributes": { "TRANSLATION": places } } });
    scene.document["nodes"] = json!([{ "mesh": mesh, "extensions": instancing, "name": "forest" }]);
    scene.document["scenes"] = json!([{ "nodes": [0] }]);
    scene.document["extensionsUsed"] = json!(["EXT_mesh_gpu_instancing"]);
    scene
}

/// A document without anything to show.
pub fn empty() -> TestScene {
    TestScene::named("empty")
}
