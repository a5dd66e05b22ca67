//! Tests of the passes over whole documents that are built by hand.

mod compaction;
mod compression;
mod hostile;
mod quantization;
mod world;

use serde_json::{Value, json};

use super::additions::{Additions, ViewKind, plain_view};
use super::elements::Elements;
use super::parts::{GltfParts, push_entries};
use crate::gltf::component_type::GltfComponentType;

/// Side of the sheet in squares.
const SIDE: u32 = 8;

/// Vertices of the sheet.
const VERTEX_COUNT: u32 = (SIDE + 1) * (SIDE + 1);

/// Document under construction.
struct Sketch {
    parts: GltfParts,
    additions: Additions,
}

impl Sketch {
    fn new() -> Self {
        let root = json!({
            "asset": { "version": "2.0" },
            "scene": 0,
            "scenes": [{ "nodes": [] }],
            "nodes": [],
            "meshes": [],
            "accessors": [],
            "bufferViews": [],
        });
        let additions = Additions::new(&root);
        Self { parts: GltfParts { root, ..GltfParts::default() }, additions }
    }

    /// Adds vertex data, and returns the accessor.
    fn vertices(&mut self, role: &str, elements: &Elements) -> usize {
        let mut accessor = elements.accessor();
        if role.contains("POSITION") {
            elements.declare_bounds(&mut accessor);
        }
        self.additions.push(ViewKind::of_vertices(role, elements), elements, accessor)
    }

    /// Adds other data, and returns the accessor.
    fn others(&mut self, elements: &Elements) -> usize {
        let kind = ViewKind::of_others("others", elements);
        self.additions.push(kind, elements, elements.accessor())
    }

    fn indices(&mut self, indices: &[u32]) -> usize {
        let integers = indices.iter().map(|&v| i64::from(v));
        let elements = Elements::integers(integers, 1, GltfComponentType::U32);
        self.additions.push(ViewKind::of_indices("indices", &elements), &elements, elements.accessor())
    }

    fn add(&mut self, array: &str, value: Value) -> usize {
        push_entries(&mut self.parts.root, array, vec![value]);
        super::parts::array_length(&self.parts.root, array) - 1
    }

    /// Adds a node at the root of the scene.
    fn node(&mut self, value: Value) -> usize {
        let node = self.add("nodes", value);
        self.parts.root["scenes"][0]["nodes"].as_array_mut().unwrap().push(json!(node));
        node
    }

    fn finish(self) -> GltfParts {
        let Self { mut parts, additions } = self;
        additions.apply(&mut parts, plain_view);
        parts
    }
}

/// Positions of a wavy sheet; `seed` moves and bends it.
fn sheet(seed: f32) -> Vec<f32> {
    let point = |i: u32| {
        let (x, y) = ((i % (SIDE + 1)) as f32, (i / (SIDE + 1)) as f32);
        [x * 0.37 + seed, y * 0.51 - seed * 3.0, ((x * 0.7 + seed).sin() + y * 0.1) * 0.8]
    };
    (0..VERTEX_COUNT).flat_map(point).collect()
}

fn sheet_triangles() -> Vec<u32> {
    let cell = |i: u32| {
        let a = i / SIDE * (SIDE + 1) + i % SIDE;
        [a, a + 1, a + SIDE + 2, a, a + SIDE + 2, a + SIDE + 1]
    };
    (0..SIDE * SIDE).flat_map(cell).collect()
}

/// Unit vectors, one for each vertex.
fn directions() -> Vec<f32> {
    let direction = |i: u32| {
        let (sin, cos) = (i as f32 * 0.37).sin_cos();
        [sin * 0.6, cos * 0.6, if i.is_multiple_of(2) { 0.8 } else { -0.8 }]
    };
    (0..VERTEX_COUNT).flat_map(direction).collect()
}

/// Weights of four joints, and the joints.
fn weights() -> (Elements, Elements) {
    let weight = |i: u32| {
        let (a, b) = ((i % 7) as f32 / 14.0, (i % 3) as f32 / 6.0);
        [a, b, 1.0 - a - b, 0.0]
    };
    let weights: Vec<f32> = (0..VERTEX_COUNT).flat_map(weight).collect();
    let joints = (0..VERTEX_COUNT).flat_map(|i| [i % 2, 1, 0, 0].map(i64::from));
    (Elements::floats(&weights, 4), Elements::integers(joints, 4, GltfComponentType::U16))
}

/// Adds a mesh with attributes of all kinds; `seed` makes it different from others.
fn add_mesh(sketch: &mut Sketch, seed: f32) -> usize {
    let position = sketch.vertices("POSITION", &Elements::floats(&sheet(seed), 3));
    let normal = sketch.vertices("NORMAL", &Elements::floats(&directions(), 3));
    let tangents: Vec<f32> = directions().chunks(3).flat_map(|d| [d[1], d[2], d[0], -1.0]).collect();
    let tangent = sketch.vertices("TANGENT", &Elements::floats(&tangents, 4));
    let texcoords: Vec<f32> = sheet(0.0).chunks(3).flat_map(|p| [p[0] / 4.0, p[1] / 5.0]).collect();
    let texcoord = sketch.vertices("TEXCOORD", &Elements::floats(&texcoords, 2));
    let colors: Vec<f32> = directions().iter().map(|x| x.abs()).collect();
    let color = sketch.vertices("COLOR", &Elements::floats(&colors, 3));
    let moves: Vec<f32> = directions().iter().map(|x| x * 0.3).collect();
    let target = sketch.vertices("target POSITION", &Elements::floats(&moves, 3));
    let indices = sketch.indices(&sheet_triangles());
    sketch.add(
        "meshes",
        json!({
            "primitives": [{
                "attributes": {
                    "POSITION": position, "NORMAL": normal, "TANGENT": tangent,
                    "TEXCOORD_0": texcoord, "COLOR_0": color,
                },
                "indices": indices,
                "targets": [{ "POSITION": target }],
            }],
            "weights": [0.25],
        }),
    )
}

/// Adds a mesh with joints and weights, and without morph targets.
fn add_skinned_mesh(sketch: &mut Sketch, seed: f32) -> usize {
    let position = sketch.vertices("POSITION", &Elements::floats(&sheet(seed), 3));
    let (weights, joints) = weights();
    let (weights, joints) = (sketch.vertices("WEIGHTS", &weights), sketch.vertices("JOINTS", &joints));
    let indices = sketch.indices(&sheet_triangles());
    let attributes = json!({ "POSITION": position, "JOINTS_0": joints, "WEIGHTS_0": weights });
    sketch.add("meshes", json!({ "primitives": [{ "attributes": attributes, "indices": indices }] }))
}

/// A document with most of what documents have: see the nodes.
fn everything() -> GltfParts {
    let mut sketch = Sketch::new();
    let meshes = [add_mesh(&mut sketch, 0.5), add_mesh(&mut sketch, -4.0)];
    let skinned = [add_skinned_mesh(&mut sketch, 1.0), add_skinned_mesh(&mut sketch, 9.0)];
    let matrices: Vec<f32> = (0..32).map(|i| if i % 16 % 5 == 0 { 1.0 } else { 0.01 * i as f32 }).collect();
    let matrices = sketch.others(&Elements::floats(&matrices, 16));
    let leaf = sketch.node(json!({
        "mesh": meshes[0],
        "translation": [1.0, 2.0, 3.0], "rotation": [0.6, 0.0, 0.0, 0.8], "scale": [2.0, 3.0, 0.5],
    }));
    sketch.node(json!({
        "mesh": meshes[1],
        "matrix": [0.0, 2.0, 0.0, 0.0, 1.0, 0.0, 0.5, 0.0, 0.0, 0.0, 3.0, 0.0, 4.0, 5.0, 6.0, 1.0],
    }));
    let parent = sketch.node(json!({
        "mesh": meshes[1], "children": [leaf], "camera": 0, "weights": [0.75], "name": "parent",
    }));
    sketch.parts.root["scenes"][0]["nodes"] = json!([1, parent]);
    let animated = sketch.node(json!({ "mesh": meshes[0], "translation": [5.0, 0.0, 0.0] }));
    let joints = [sketch.node(json!({})), sketch.node(json!({ "mesh": meshes[0] }))];
    let skins = [
        sketch.add("skins", json!({ "joints": joints, "inverseBindMatrices": matrices })),
        sketch.add("skins", json!({ "joints": joints })),
    ];
    sketch.node(json!({ "mesh": skinned[0], "skin": skins[0] }));
    sketch.node(json!({ "mesh": skinned[1], "skin": skins[0], "translation": [9.0, 9.0, 9.0] }));
    sketch.node(json!({ "mesh": skinned[1], "skin": skins[1] }));
    let moves = sketch.others(&Elements::floats(&[0.0, 1.0, 2.0, 3.0, 4.0, 5.0], 3));
    let turns = Elements::integers([0, 0, 0, 127, 90, 0, 0, 90], 4, GltfComponentType::I8).into_normalized();
    let turns = sketch.others(&turns);
    let attributes = json!({ "TRANSLATION": moves, "ROTATION": turns });
    sketch.node(json!({
        "mesh": meshes[1], "scale": [2.0, 2.0, 2.0],
        "extensions": { "EXT_mesh_gpu_instancing": { "attributes": attributes } },
    }));
    let times = sketch.others(&Elements::floats(&[0.0, 0.4, 1.0], 1));
    let levels = sketch.others(&Elements::floats(&[0.0, 1.0, 0.3], 1));
    let places = sketch.others(&Elements::floats(&[0.0, 1.0, 0.3, 2.0, 2.0, 2.0, 0.1, 0.2, 0.3], 3));
    let pointer = json!({ "pointer": format!("/nodes/{parent}/weights/0") });
    sketch.add(
        "animations",
        json!({
            "samplers": [{ "input": times, "output": levels }, { "input": times, "output": places }],
            "channels": [
                { "sampler": 0, "target": { "node": parent, "path": "weights" } },
                { "sampler": 1, "target": { "node": animated, "path": "translation" } },
                { "sampler": 0, "target": {
                    "path": "pointer", "extensions": { "KHR_animation_pointer": pointer },
                } },
            ],
        }),
    );
    sketch.add("cameras", json!({ "type": "perspective", "perspective": { "yfov": 1.0, "znear": 0.1 } }));
    let image = Elements::integers([137, 80, 78, 71, 13, 10, 26], 1, GltfComponentType::U8);
    let mut place = json!({});
    sketch.additions.store(ViewKind::of_others("image", &image), &image, &mut place);
    sketch.add("images", json!({ "bufferView": place["bufferView"], "mimeType": "image/png" }));
    sketch.add("extensionsUsed", json!("EXT_mesh_gpu_instancing"));
    sketch.finish()
}
