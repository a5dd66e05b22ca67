//! Scenes that use what glTF has: all kinds of primitives, accessors, animations and extensions, with names and
//! extras.

use serde_json::{Value, json};
use striata::mesh::{IndexedMesh, shapes};

use super::{PNG, TestScene};

/// Component types of accessors.
const I8: u32 = 5120;
const U8: u32 = 5121;
const I16: u32 = 5122;
const U16: u32 = 5123;
const U32: u32 = 5125;

/// All scenes of this file.
pub fn varied() -> Vec<TestScene> {
    vec![
        shared_accessors(),
        several_sets(),
        mixed_attributes(),
        odd_accessors(),
        every_mode(),
        animated_properties(),
        sparse_morphs(),
        many_skins(),
        variants(),
        instances_with_attributes(),
        small_integers(),
        chains(),
        nothing_used(),
    ]
}

impl TestScene {
    /// Appends integers as an accessor whose elements begin at multiples of four bytes, and returns its index.
    pub fn push_integers(&mut self, kind: &str, component: u32, normalized: bool, numbers: &[i64]) -> usize {
        let width = ["", "SCALAR", "VEC2", "VEC3", "VEC4"].iter().position(|name| *name == kind).unwrap_or(1);
        let size = match component {
            I8 | U8 => 1,
            I16 | U16 => 2,
            _ => 4,
        };
        // Indices lie without gaps.
        let stride = if width == 1 { size } else { (width * size).next_multiple_of(4) };
        let mut bytes = Vec::new();
        for element in numbers.chunks(width) {
            let end = bytes.len() + stride;
            element.iter().for_each(|number| bytes.extend_from_slice(&number.to_le_bytes()[..size]));
            bytes.resize(end, 0);
        }
        let view = self.push_view(&bytes);
        if width * size != stride {
            self.document["bufferViews"][view]["byteStride"] = json!(stride);
        }
        let count = numbers.len() / width;
        let mut accessor =
            json!({ "bufferView": view, "componentType": component, "count": count, "type": kind });
        if normalized {
            accessor["normalized"] = json!(true);
        }
        self.push("accessors", accessor)
    }

    fn push_indices(&mut self, component: u32, indices: impl IntoIterator<Item = u32>) -> usize {
        let indices: Vec<i64> = indices.into_iter().map(i64::from).collect();
        self.push_integers("SCALAR", component, false, &indices)
    }

    fn push_positions(&mut self, mesh: &IndexedMesh) -> usize {
        self.push_floats("VEC3", 3, mesh.positions.as_flattened())
    }

    /// Appends a texture of an image with its own name, which differs from all others in its bytes and sampler.
    fn push_texture(&mut self, name: &str) -> usize {
        let view = self.push_view(&[PNG, name.as_bytes()].concat());
        let image =
            json!({ "bufferView": view, "mimeType": "image/png", "name": name, "extras": { "of": name } });
        let image = self.push("images", image);
        let wrap = [33071, 33648, 10497][image % 3];
        let sampler = self.push("samplers", json!({ "wrapS": wrap, "wrapT": 33648, "name": name }));
        self.push("textures", json!({ "source": image, "sampler": sampler, "name": name }))
    }

    /// Adds nodes in one scene.
    fn show(&mut self, nodes: &[Value]) {
        self.document["nodes"] = json!(nodes);
        let children: Vec<u64> = nodes
            .iter()
            .filter_map(|node| node.get("children")?.as_array())
            .flatten()
            .filter_map(Value::as_u64)
            .collect();
        let roots: Vec<u64> = (0..nodes.len() as u64).filter(|node| !children.contains(node)).collect();
        self.document["scenes"] = json!([{ "nodes": roots, "name": "all", "extras": [1, "two"] }]);
        self.document["scene"] = json!(0);
    }
}

/// Corners of the triangles of a mesh.
fn corners(mesh: &IndexedMesh) -> Vec<u32> {
    mesh.triangles.as_flattened().to_vec()
}

/// Normals of a convex mesh around the origin.
fn directions(mesh: &IndexedMesh) -> Vec<f32> {
    let unit = |p: &[f32; 3]| {
        let length = p.iter().map(|x| x * x).sum::<f32>().sqrt();
        p.map(|x| x / length)
    };
    mesh.positions.iter().flat_map(unit).collect()
}

/// Meshes and primitives over the same accessors: all of it, parts of it, and with other materials.
pub fn shared_accessors() -> TestScene {
    let mut scene = TestScene::named("shared accessors");
    scene.push_materials(4);
    let ball = shapes::icosphere(2, 1.0);
    let positions = scene.push_positions(&ball);
    let normals = scene.push_floats("VEC3", 3, &directions(&ball));
    let (lower, upper) = ball.triangles.split_at(ball.triangles.len() / 2);
    let halves = [lower, upper].map(|half| scene.push_indices(U16, half.as_flattened().iter().copied()));
    let whole = scene.push_indices(U32, corners(&ball));
    let primitive = |indices: usize, material: usize| {
        json!({ "attributes": { "POSITION": positions, "NORMAL": normals }, "indices": indices,
                "material": material, "extras": { "material": material } })
    };
    for material in 0..3 {
        let mesh = json!({ "primitives": [primitive(whole, material)], "name": format!("ball {material}") });
        scene.push("meshes", mesh);
    }
    let halves = json!([primitive(halves[0], 3), primitive(halves[1], 0)]);
    scene.push("meshes", json!({ "primitives": halves, "name": "halves", "extras": { "two": true } }));
    let node = |mesh: usize| {
        json!({ "mesh": mesh % 4, "translation": [3.0 * mesh as f32, 0.0, 0.0], "scale": [1.0, -1.0, 1.0],
                "name": format!("node {mesh}"), "extras": { "number": mesh } })
    };
    scene.show(&(0..5).map(node).collect::<Vec<_>>());
    scene
}

/// Three sets of texture coordinates and two of colors, each in another type, under indices of 8, 16 and 32 bits.
pub fn several_sets() -> TestScene {
    let mut scene = TestScene::named("several sets");
    let mesh = shapes::uv_cylinder(12, 9);
    let count = mesh.vertex_count() as i64;
    let uvs = mesh
        .layers
        .iter()
        .find(|layer| layer.component_count == 2)
        .expect("a cylinder has texture coordinates");
    let uvs: Vec<f32> = (0..mesh.vertex_count()).flat_map(|v| [uvs.get(v, 0), uvs.get(v, 1)]).collect();
    let numbers = |width: i64, limit: i64| (0..width * count).map(|i| i * 77 % limit).collect::<Vec<_>>();
    let scaled = |factor: f32| uvs.iter().map(|x| (x * factor).round() as i64).collect::<Vec<_>>();
    let attributes = json!({
        "POSITION": scene.push_positions(&mesh),
        "TEXCOORD_0": scene.push_floats("VEC2", 2, &uvs),
        "TEXCOORD_1": scene.push_integers("VEC2", U8, true, &scaled(255.0)),
        "TEXCOORD_2": scene.push_integers("VEC2", U16, true, &scaled(65535.0)),
        "COLOR_0": scene.push_integers("VEC4", U8, true, &numbers(4, 256)),
        "COLOR_1": scene.push_integers("VEC3", U16, true, &numbers(3, 65536)),
        "_HEAT": scene.push_floats("SCALAR", 1, &uvs[..mesh.vertex_count()]),
    });
    let textures: Vec<usize> = ["base", "glow", "shade"].map(|name| scene.push_texture(name)).into();
    scene.document["materials"] = json!([{
        "pbrMetallicRoughness": { "baseColorTexture": {
            "index": textures[0], "texCoord": 1,
            "extensions": {
                "KHR_texture_transform": { "scale": [2.0, 3.0], "rotation": 0.5, "texCoord": 2 },
            },
        } },
        "emissiveTexture": { "index": textures[1], "texCoord": 2 },
        "occlusionTexture": { "index": textures[2], "strength": 0.5 },
        "alphaMode": "MASK", "alphaCutoff": 0.25, "doubleSided": true, "name": "all", "extras": { "a": [1] },
    }]);
    scene.document["extensionsUsed"] = json!(["KHR_texture_transform"]);
    let thirds = mesh.triangles.chunks(mesh.triangles.len() / 3 + 1);
    let thirds: Vec<Vec<u32>> = thirds.map(|third| third.as_flattened().to_vec()).collect();
    for (third, component) in thirds.into_iter().zip([U8, U16, U32]) {
        let indices = scene.push_indices(component, third);
        let primitive = json!({ "attributes": attributes, "indices": indices, "material": 0 });
        scene.push("meshes", json!({ "primitives": [primitive] }));
    }
    scene.show(&(0..3).map(|mesh| json!({ "mesh": mesh })).collect::<Vec<_>>());
    scene
}

/// A mesh whose primitives have different attributes, and the same ones in different types.
pub fn mixed_attributes() -> TestScene {
    let mut scene = TestScene::named("mixed attributes");
    scene.push_materials(3);
    let ball = shapes::icosphere(2, 1.0);
    let count = ball.vertex_count() as i64;
    let (positions, indices) = (scene.push_positions(&ball), scene.push_indices(U16, corners(&ball)));
    let normals = scene.push_floats("VEC3", 3, &directions(&ball));
    let tangents: Vec<f32> = directions(&ball).chunks(3).flat_map(|n| [n[1], n[2], n[0], -1.0]).collect();
    let floats: Vec<f32> = (0..3 * count).map(|i| (i % 11) as f32 / 10.0).collect();
    let numbers = |step: i64, limit: i64| (0..4 * count).map(|i| i * step % limit).collect::<Vec<_>>();
    let first = json!({
        "POSITION": positions, "NORMAL": normals, "TANGENT": scene.push_floats("VEC4", 4, &tangents),
        "COLOR_0": scene.push_floats("VEC3", 3, &floats),
        "TEXCOORD_0": scene.push_floats("VEC2", 2, &floats[..2 * count as usize]),
    });
    let second = json!({
        "POSITION": positions, "COLOR_0": scene.push_integers("VEC4", U8, true, &numbers(7, 256)),
        "TEXCOORD_0": scene.push_integers("VEC2", U16, true, &numbers(77, 65536)[..2 * count as usize]),
        "_ID": scene.push_integers("SCALAR", U16, false, &numbers(1, 65536)[..count as usize]),
    });
    let third = json!({ "POSITION": positions });
    let primitives = [first, second, third].into_iter().enumerate().map(|(material, attributes)| {
        json!({ "attributes": attributes, "indices": indices, "material": material })
    });
    let primitives: Vec<Value> = primitives.collect();
    // Elements of vertex attributes begin at multiples of four bytes.
    let ids = primitives[1]["attributes"]["_ID"].as_u64().expect("an accessor") as usize;
    let padded: Vec<u8> = (0..count).flat_map(|i| (i as u32).to_le_bytes()).collect();
    let view = scene.push_view(&padded);
    scene.document["bufferViews"][view]["byteStride"] = json!(4);
    scene.document["accessors"][ids]["bufferView"] = json!(view);
    scene.push("meshes", json!({ "primitives": primitives, "name": "three" }));
    scene.show(&[json!({ "mesh": 0 })]);
    scene
}

/// Accessors without a view or with sparse values, for points, skins and animations; interleaved vertices.
pub fn odd_accessors() -> TestScene {
    let mut scene = TestScene::named("odd accessors");
    let tube = shapes::uv_cylinder(12, 10);
    let count = tube.vertex_count();
    let mut vertices = Vec::new();
    for p in &tube.positions {
        p.iter().for_each(|x| vertices.extend_from_slice(&x.to_le_bytes()));
        vertices.extend_from_slice(&[0, 1, 0, 0, 255 - (p[2] * 255.0) as u8, (p[2] * 255.0) as u8, 0, 0]);
    }
    let view = scene.push_view(&vertices);
    scene.document["bufferViews"][view]["byteStride"] = json!(20);
    let mut part = |offset: usize, component: u32, kind: &str| {
        let accessor = json!({ "bufferView": view, "byteOffset": offset, "componentType": component,
                               "count": count, "type": kind });
        scene.push("accessors", accessor)
    };
    let (positions, joints, weights) = (part(0, 5126, "VEC3"), part(12, U8, "VEC4"), part(16, U8, "VEC4"));
    scene.document["accessors"][weights]["normalized"] = json!(true);
    let bounds = tube.bounds().expect("a tube has vertices");
    scene.document["accessors"][positions]["min"] = json!(bounds.min);
    scene.document["accessors"][positions]["max"] = json!(bounds.max);
    let indices = scene.push_indices(U8, corners(&tube));
    scene.push(
        "meshes",
        json!({ "primitives": [{
        "attributes": { "POSITION": positions, "JOINTS_0": joints, "WEIGHTS_0": weights }, "indices": indices,
    }] }),
    );
    let zeros = json!({
        "componentType": 5126, "count": 3, "type": "VEC3", "min": [0.0, 0.0, 0.0], "max": [0.0, 0.0, 0.0],
    });
    let zeros = scene.push("accessors", zeros);
    scene.push("meshes", json!({ "primitives": [{ "attributes": { "POSITION": zeros }, "mode": 0 }] }));
    let mut sparse = |kind: &str, count: usize, places: &[u16], values: &[f32]| {
        let places_view = scene.push_view(&places.iter().flat_map(|x| x.to_le_bytes()).collect::<Vec<u8>>());
        let values = scene.push_view(&values.iter().flat_map(|x| x.to_le_bytes()).collect::<Vec<u8>>());
        let sparse = json!({ "count": places.len(),
                             "indices": { "bufferView": places_view, "componentType": U16 },
                             "values": { "bufferView": values } });
        scene.push(
            "accessors",
            json!({ "componentType": 5126, "count": count, "type": kind, "sparse": sparse }),
        )
    };
    let identity: Vec<f32> = (0..16).map(|i| f32::from(u8::from(i % 5 == 0))).collect();
    let binds = sparse("MAT4", 2, &[0, 1], &[&identity[..], &identity].concat());
    let moves = sparse("VEC3", 3, &[1], &[0.0, 0.5, 0.0]);
    scene.push("skins", json!({ "joints": [1, 2], "inverseBindMatrices": binds }));
    scene.show(&[
        json!({ "mesh": 0, "skin": 0 }),
        json!({ "children": [2] }),
        json!({ "translation": [0.0, 0.0, 0.0] }),
        json!({ "mesh": 1 }),
    ]);
    let times = scene.push_floats("SCALAR", 1, &[0.0, 1.0, 2.0]);
    let one = scene.push_floats("SCALAR", 1, &[0.5]);
    let turn = scene.push_floats("VEC4", 4, &[0.0, 0.0, 0.0, 1.0]);
    let target =
        |sampler: usize, path: &str| json!({ "sampler": sampler, "target": { "node": 2, "path": path } });
    scene.push(
        "animations",
        json!({
            "channels": [target(0, "translation"), target(1, "rotation")],
            "samplers": [{ "input": times, "output": moves },
                         { "input": one, "output": turn, "interpolation": "STEP" }],
        }),
    );
    scene
}

/// Points, lines, loops, strips of lines, triangles, strips and fans, with and without indices; the points are a
/// sparse accessor.
pub fn every_mode() -> TestScene {
    let mut scene = TestScene::named("every mode");
    scene.push_materials(6);
    let zigzag: Vec<f32> =
        (0..12).flat_map(|i| [(i / 2) as f32, (i % 2) as f32, 0.1 * (i * i % 5) as f32]).collect();
    let circle: Vec<f32> = std::iter::once([0.0; 3])
        .chain((0..11).map(|i| {
            let (sin, cos) = (i as f32 * 0.5).sin_cos();
            [cos, sin, 0.1]
        }))
        .flatten()
        .collect();
    let zigzag = scene.push_floats("VEC3", 3, &zigzag);
    // Two accessors have this view.
    scene.document["bufferViews"][0]["byteStride"] = json!(12);
    let circle = scene.push_floats("VEC3", 3, &circle);
    let moved = scene.push_floats("VEC3", 3, &[5.0, 6.0, 7.0]);
    let places = scene.push_indices(U8, [3]);
    let sparse = json!({
        "count": 1,
        "indices": { "bufferView": scene.document["accessors"][places]["bufferView"], "componentType": U8 },
        "values": { "bufferView": scene.document["accessors"][moved]["bufferView"] },
    });
    // Only the values are used.
    scene.document["accessors"].as_array_mut().expect("a list").truncate(moved);
    let mut points = scene.document["accessors"][zigzag].clone();
    points["sparse"] = sparse;
    points["max"] = json!([5.0, 6.0, 7.0]);
    let points = scene.push("accessors", points);
    let indices = [U8, U16, U32].map(|component| scene.push_indices(component, 0..12));
    for mode in 0..7 {
        let positions = match mode {
            0 => points,
            6 => circle,
            _ => zigzag,
        };
        let plain = json!({ "attributes": { "POSITION": positions }, "mode": mode, "material": mode % 6 });
        let mut indexed = plain.clone();
        indexed["indices"] = json!(indices[mode % 3]);
        scene.push("meshes", json!({ "primitives": [plain, indexed], "name": format!("mode {mode}") }));
    }
    let node = |mesh: usize| json!({ "mesh": mesh, "translation": [0.0, 3.0 * mesh as f32, 0.0] });
    scene.show(&(0..7).map(node).collect::<Vec<_>>());
    scene
}

/// Animations of all paths and interpolations, of pointers, and of values in small integers.
pub fn animated_properties() -> TestScene {
    let mut scene = TestScene::named("animated properties");
    scene.push_materials(2);
    let texture = scene.push_texture("sky");
    scene.document["materials"][0]["emissiveTexture"] = json!({
        "index": texture, "extensions": { "KHR_texture_transform": { "offset": [0.0, 0.0] } },
    });
    let mesh = scene.push_mesh("tube", &shapes::uv_cylinder(12, 9));
    scene.document["meshes"][mesh]["primitives"][0]["material"] = json!(0);
    scene.push(
        "cameras",
        json!({ "type": "orthographic", "name": "flat", "extras": { "lens": 1 },
        "orthographic": { "xmag": 1.0, "ymag": 2.0, "znear": 0.0, "zfar": 9.0 } }),
    );
    scene.push(
        "cameras",
        json!({ "type": "perspective",
        "perspective": { "yfov": 0.7, "znear": 0.1, "zfar": 99.0, "aspectRatio": 1.5 } }),
    );
    let spot = json!({ "innerConeAngle": 0.1, "outerConeAngle": 0.5 });
    scene.document["extensions"] = json!({ "KHR_lights_punctual": { "lights": [
        { "type": "spot", "spot": spot, "name": "lamp", "intensity": 3.0, "range": 7.0 },
        { "type": "directional", "extras": { "sun": true } },
    ] } });
    scene.document["extensionsUsed"] =
        json!(["KHR_lights_punctual", "KHR_animation_pointer", "KHR_texture_transform"]);
    let light = |light: usize| json!({ "KHR_lights_punctual": { "light": light } });
    scene.show(&[
        json!({ "mesh": mesh, "name": "turning", "children": [1, 2], "scale": [1.0, 2.0, -1.0] }),
        json!({ "camera": 0, "name": "eye", "extensions": light(0) }),
        json!({ "camera": 1, "extensions": light(1) }),
        json!({ "mesh": mesh, "translation": [4.0, 0.0, 0.0] }),
    ]);
    let times = scene.push_floats("SCALAR", 1, &[0.0, 0.5, 2.0]);
    let moves = scene.push_floats("VEC3", 3, &[0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 1.0, 1.0, 0.0]);
    let sizes = scene.push_floats("VEC3", 3, &[1.0, 1.0, 1.0, 1.0, 2.0, 1.0, 3.0, 1.0, 1.0]);
    let curve: Vec<f32> = (0..3)
        .flat_map(|key| {
            let angle = 0.4 * key as f32;
            [0.1, 0.0, 0.2, 0.0, 0.0, angle.sin(), 0.0, angle.cos(), 0.0, 0.0, -0.1, 0.0]
        })
        .collect();
    let curve = scene.push_floats("VEC4", 4, &curve);
    let turns = [0, 0, 0, 32767, 0, 0, 23170, 23170, 0, 0, 32767, 0];
    let turns = scene.push_integers("VEC4", I16, true, &turns);
    let path = |sampler: usize, node: usize, path: &str| {
        let target = json!({ "node": node, "path": path });
        json!({ "sampler": sampler, "target": target, "extras": { "path": path } })
    };
    let sampler = |output: usize, interpolation: &str| {
        let interpolation = json!(interpolation);
        json!({ "input": times, "output": output, "interpolation": interpolation })
    };
    scene.push(
        "animations",
        json!({
            "name": "dance", "extras": { "beat": 120 },
            "channels": [path(0, 0, "translation"), path(1, 0, "rotation"), path(2, 0, "scale"),
                         path(1, 1, "rotation"), path(3, 2, "rotation"), path(0, 3, "translation")],
            "samplers": [sampler(moves, "STEP"), sampler(curve, "CUBICSPLINE"), sampler(sizes, "LINEAR"),
                         sampler(turns, "LINEAR")],
        }),
    );
    let pointer = |sampler: usize, pointer: &str| {
        json!({ "sampler": sampler, "target": { "path": "pointer",
                "extensions": { "KHR_animation_pointer": { "pointer": pointer } } } })
    };
    let colors = scene.push_floats("VEC4", 4, &[1.0, 0.0, 0.0, 1.0, 0.0, 1.0, 0.0, 1.0, 0.0, 0.0, 1.0, 1.0]);
    let offsets = scene.push_floats("VEC2", 2, &[0.0, 0.0, 0.5, 0.0, 0.5, 0.5]);
    let numbers = scene.push_floats("SCALAR", 1, &[0.5, 0.75, 1.0]);
    scene.push(
        "animations",
        json!({
            "channels": [
                pointer(0, "/materials/0/pbrMetallicRoughness/baseColorFactor"),
                pointer(0, "/materials/1/pbrMetallicRoughness/baseColorFactor"),
                pointer(1, "/materials/0/emissiveTexture/extensions/KHR_texture_transform/offset"),
                pointer(2, "/extensions/KHR_lights_punctual/lights/0/intensity"),
                pointer(2, "/cameras/1/perspective/yfov"),
                pointer(3, "/nodes/2/translation"),
            ],
            "samplers": [sampler(colors, "LINEAR"), sampler(offsets, "STEP"), sampler(numbers, "LINEAR"),
                         sampler(moves, "LINEAR")],
        }),
    );
    scene
}

/// Morph targets that are dense, sparse, sparse over zeros, and zero; two primitives, one of which has normals.
pub fn sparse_morphs() -> TestScene {
    let mut scene = TestScene::named("sparse morphs");
    scene.push_materials(2);
    let ball = shapes::icosphere(3, 1.0);
    let count = ball.vertex_count();
    let positions = scene.push_positions(&ball);
    let normals = scene.push_floats("VEC3", 3, &directions(&ball));
    let dense: Vec<f32> = ball.positions.iter().flat_map(|p| [0.0, 0.25 * p[2], 0.1]).collect();
    let dense = scene.push_floats("VEC3", 3, &dense);
    let places = scene.push_view(&[1u16, 5, 40, 641].map(u16::to_le_bytes).concat());
    let values: Vec<u8> = [1.0f32, 0.0, 0.0, 0.0, 0.5, 0.0, 0.0, 0.0, 0.25, 0.5, 0.5, 0.5]
        .iter()
        .flat_map(|number| number.to_le_bytes())
        .collect();
    let values = scene.push_view(&values);
    let replaced = json!({ "count": 4, "indices": { "bufferView": places, "componentType": U16 },
                           "values": { "bufferView": values } });
    let zero = json!({ "componentType": 5126, "count": count, "type": "VEC3", "min": [0.0, 0.0, 0.0],
                       "max": [0.0, 0.0, 0.0] });
    let mut few = zero.clone();
    (few["sparse"], few["max"]) = (replaced.clone(), json!([1.0, 0.5, 0.5]));
    let (zero, few) = (scene.push("accessors", zero), scene.push("accessors", few));
    // Normals stay short of unit length where both add up.
    let mut bent = json!({ "componentType": 5126, "count": count, "type": "VEC3" });
    bent["sparse"] = replaced;
    let bent = scene.push("accessors", bent);
    let (lower, upper) = ball.triangles.split_at(ball.triangles.len() / 3);
    let indices = [lower, upper].map(|part| scene.push_indices(U16, part.as_flattened().iter().copied()));
    let targets = |with_normals: bool| {
        let target = |accessor: usize| match with_normals {
            true => json!({ "POSITION": accessor, "NORMAL": bent }),
            false => json!({ "POSITION": accessor }),
        };
        json!([target(dense), target(few), target(zero)])
    };
    let mesh = json!({
        "name": "face", "weights": [0.0, 0.5, 1.0], "extras": { "targetNames": ["dense", "few", "none"] },
        "primitives": [
            { "attributes": { "POSITION": positions, "NORMAL": normals },
              "indices": indices[0], "material": 0, "targets": targets(true) },
            { "attributes": { "POSITION": positions }, "indices": indices[1], "material": 1,
              "targets": targets(false) },
        ],
    });
    let mesh = scene.push("meshes", mesh);
    scene.show(&[
        json!({ "mesh": mesh, "name": "one" }),
        json!({ "mesh": mesh, "weights": [1.0, 0.0, 0.0], "translation": [3.0, 0.0, 0.0] }),
    ]);
    let times = scene.push_floats("SCALAR", 1, &[0.0, 1.0]);
    let weights = scene.push_integers("SCALAR", U8, true, &[0, 128, 255, 255, 0, 0]);
    let curve: Vec<f32> = (0..2 * 3 * 3).map(|i| 0.05 * i as f32).collect();
    let curve = scene.push_floats("SCALAR", 1, &curve);
    let weight =
        |sampler: usize| json!({ "sampler": sampler, "target": { "node": sampler, "path": "weights" } });
    scene.push(
        "animations",
        json!({
            "channels": [weight(0), weight(1)],
            "samplers": [{ "input": times, "output": weights, "interpolation": "STEP" },
                         { "input": times, "output": curve, "interpolation": "CUBICSPLINE" }],
        }),
    );
    scene
}

/// One mesh with two skins, another with eight joints for each vertex, and a skin without matrices.
pub fn many_skins() -> TestScene {
    let mut scene = TestScene::named("many skins");
    scene.push_materials(1);
    let tube = shapes::uv_cylinder(12, 10);
    let positions = scene.push_positions(&tube);
    let indices = scene.push_indices(U8, corners(&tube));
    let height = |p: &[f32; 3]| (255.0 * p[2]).round() as i64;
    let joints: Vec<i64> = tube.positions.iter().flat_map(|_| [2, 0, 0, 0]).collect();
    let weights: Vec<i64> = tube.positions.iter().flat_map(|p| [255 - height(p), height(p), 0, 0]).collect();
    let joints = scene.push_integers("VEC4", U8, false, &joints);
    let weights = scene.push_integers("VEC4", U8, true, &weights);
    let more: Vec<f32> =
        tube.positions.iter().flat_map(|p| [0.5 * p[2], 0.5 - 0.5 * p[2], 0.0, 0.0]).collect();
    let half: Vec<f32> = tube.positions.iter().flat_map(|_| [0.5, 0.0, 0.0, 0.0]).collect();
    let more = [more, half].map(|weights| scene.push_floats("VEC4", 4, &weights));
    let places: Vec<i64> = tube.positions.iter().flat_map(|_| [0, 1, 0, 0]).collect();
    let others: Vec<i64> = tube.positions.iter().flat_map(|_| [2, 0, 0, 0]).collect();
    let places = [&places, &others].map(|list| scene.push_integers("VEC4", U16, false, list));
    let four = json!({ "POSITION": positions, "JOINTS_0": joints, "WEIGHTS_0": weights });
    let eight = json!({ "POSITION": positions, "JOINTS_0": places[0], "WEIGHTS_0": more[0],
                        "JOINTS_1": places[1], "WEIGHTS_1": more[1] });
    for attributes in [four, eight] {
        let primitive = json!({ "attributes": attributes, "indices": indices, "material": 0 });
        scene.push("meshes", json!({ "primitives": [primitive] }));
    }
    let lifted = |z: f32| [1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, z, 1.0];
    let binds = scene.push_floats("MAT4", 16, &[0.0, -0.5, -1.0].map(lifted).concat());
    scene.push(
        "skins",
        json!({ "joints": [3, 4, 5], "inverseBindMatrices": binds, "skeleton": 3,
                                "name": "first", "extras": { "rig": 1 } }),
    );
    scene.push("skins", json!({ "joints": [5, 4, 3], "inverseBindMatrices": binds }));
    scene.push("skins", json!({ "joints": [3, 4, 5], "name": "bare" }));
    scene.show(&[
        json!({ "mesh": 0, "skin": 0 }),
        json!({ "mesh": 0, "skin": 1 }),
        json!({ "mesh": 1, "skin": 2 }),
        json!({ "children": [4], "name": "hip" }),
        json!({ "children": [5], "name": "knee", "translation": [0.0, 0.0, 0.5] }),
        json!({ "name": "foot", "translation": [0.0, 0.0, 0.5], "extras": { "ground": true } }),
    ]);
    scene
}

/// Variants of materials, one of which only some primitives name, and textures with transforms.
pub fn variants() -> TestScene {
    let mut scene = TestScene::named("variants");
    scene.push_materials(4);
    let textures = ["day", "night"].map(|name| scene.push_texture(name));
    for (material, texture) in textures.into_iter().enumerate() {
        scene.document["materials"][material]["pbrMetallicRoughness"]["baseColorTexture"] = json!({
            "index": texture,
            "extensions": { "KHR_texture_transform": { "offset": [0.25, 0.5], "scale": [4.0, 4.0] } },
        });
    }
    scene.document["materials"][2]["extensions"] = json!({
        "KHR_materials_clearcoat": { "clearcoatTexture": { "index": textures[1] } },
        "KHR_materials_unlit": {},
    });
    let mesh = scene.push_mesh("shoe", &shapes::uv_cylinder(14, 11));
    let mut second = scene.primitives_of(&shapes::uv_cylinder(9, 5));
    second[0]["material"] = json!(1);
    let primitives = scene.document["meshes"][mesh]["primitives"].as_array_mut().expect("a list");
    primitives.append(&mut second);
    primitives[0]["material"] = json!(0);
    primitives[0]["extensions"] = json!({ "KHR_materials_variants": { "mappings": [
        { "material": 2, "variants": [0, 2], "name": "mapped" }, { "material": 3, "variants": [1] },
    ] } });
    primitives[1]["extensions"] =
        json!({ "KHR_materials_variants": { "mappings": [{ "material": 0, "variants": [1] }] } });
    let names =
        json!([{ "name": "day" }, { "name": "night", "extras": { "dark": true } }, { "name": "rain" }]);
    scene.document["extensions"] = json!({ "KHR_materials_variants": { "variants": names } });
    scene.document["extensionsUsed"] = json!([
        "KHR_materials_variants",
        "KHR_texture_transform",
        "KHR_materials_clearcoat",
        "KHR_materials_unlit"
    ]);
    scene.document["extensionsRequired"] = json!(["KHR_texture_transform"]);
    scene.show(&[
        json!({ "mesh": mesh, "matrix": [0.0, 1.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 2.0, 0.0,
                                                  5.0, 0.0, 0.0, 1.0] }),
    ]);
    scene
}

/// Instances with places, rotations in small integers, sizes and attributes of their own, in a file that requires
/// the extension.
pub fn instances_with_attributes() -> TestScene {
    let mut scene = TestScene::named("instances with attributes");
    scene.push_materials(1);
    let mesh = scene.push_mesh("tree", &shapes::torus(12, 9, 1.0, 0.25));
    scene.document["meshes"][mesh]["primitives"][0]["material"] = json!(0);
    let places: Vec<f32> = (0..4).flat_map(|i| [4.0 * i as f32, 0.0, 0.0]).collect();
    let turns = [0, 0, 0, 127, 0, 0, 127, 0, 0, 90, 0, 90, 90, 0, 0, 90];
    let attributes = json!({
        "TRANSLATION": scene.push_floats("VEC3", 3, &places),
        "ROTATION": scene.push_integers("VEC4", I8, true, &turns),
        "SCALE": scene.push_floats("VEC3", 3, &[1.0, 1.0, 1.0, -1.0, 1.0, 1.0, 2.0, 2.0, 2.0, 1.0, 0.5, 1.0]),
        "_AGE": scene.push_floats("SCALAR", 1, &[1.0, 2.0, 3.0, 4.0]),
    });
    let instancing = json!({ "EXT_mesh_gpu_instancing": { "attributes": attributes } });
    scene.show(&[
        json!({ "mesh": mesh, "extensions": instancing, "children": [1], "name": "wood" }),
        json!({ "mesh": mesh, "translation": [0.0, 9.0, 0.0] }),
    ]);
    scene.document["extensionsUsed"] = json!(["EXT_mesh_gpu_instancing"]);
    scene.document["extensionsRequired"] = json!(["EXT_mesh_gpu_instancing"]);
    scene
}

/// Quantized positions, normals and texture coordinates, of triangles and of points.
pub fn small_integers() -> TestScene {
    let mut scene = TestScene::named("small integers");
    scene.push_materials(1);
    let ball = shapes::icosphere(2, 1.0);
    let scaled = |factor: f32| {
        let numbers = ball.positions.as_flattened().iter();
        numbers.map(|x| (x * factor).round() as i64).collect::<Vec<_>>()
    };
    let positions = scene.push_integers("VEC3", I16, false, &scaled(1000.0));
    let normals = scene.push_integers("VEC3", I8, true, &scaled(127.0));
    let uvs: Vec<i64> = scaled(50.0).chunks(3).flat_map(|p| [p[0] + 50, p[1] + 50]).collect();
    let uvs = scene.push_integers("VEC2", U8, false, &uvs);
    let bound = |pick: fn(i64, i64) -> i64| -> Vec<i64> {
        let numbers = scaled(1000.0);
        let column = |axis: usize| numbers.iter().skip(axis).step_by(3).copied();
        (0..3).map(|axis| column(axis).reduce(pick).unwrap_or(0)).collect()
    };
    scene.document["accessors"][positions]["min"] = json!(bound(i64::min));
    scene.document["accessors"][positions]["max"] = json!(bound(i64::max));
    let indices = scene.push_indices(U16, corners(&ball));
    let attributes = json!({ "POSITION": positions, "NORMAL": normals, "TEXCOORD_0": uvs });
    scene.push(
        "meshes",
        json!({ "primitives": [
        { "attributes": attributes, "indices": indices, "material": 0 },
    ] }),
    );
    scene.push("meshes", json!({ "primitives": [{ "attributes": { "POSITION": positions }, "mode": 0 }] }));
    let scale = [0.001, 0.001, 0.001];
    scene.show(&[
        json!({ "mesh": 0, "scale": scale }),
        json!({ "mesh": 1, "scale": scale, "translation": [3.0, 0.0, 0.0] }),
    ]);
    scene.document["extensionsUsed"] = json!(["KHR_mesh_quantization"]);
    scene.document["extensionsRequired"] = json!(["KHR_mesh_quantization"]);
    scene
}

/// Levels of nodes and of materials (`MSFT_lod`).
pub fn chains() -> TestScene {
    let mut scene = TestScene::named("chains");
    scene.push_materials(3);
    for (name, mesh) in [("fine", shapes::icosphere(3, 1.0)), ("coarse", shapes::icosphere(1, 1.0))] {
        let mesh = scene.push_mesh(name, &mesh);
        scene.document["meshes"][mesh]["primitives"][0]["material"] = json!(0);
    }
    scene.document["materials"][0]["extensions"] = json!({ "MSFT_lod": { "ids": [1, 2] } });
    scene.show(&[
        json!({ "mesh": 0, "extensions": { "MSFT_lod": { "ids": [1] } },
                "extras": { "MSFT_screencoverage": [0.5, 0.01] } }),
        json!({ "mesh": 1 }),
    ]);
    scene.document["scenes"] = json!([{ "nodes": [0] }]);
    scene.document["extensionsUsed"] = json!(["MSFT_lod"]);
    scene
}

/// Nodes, meshes, materials, images, cameras, skins and scenes that nothing uses.
pub fn nothing_used() -> TestScene {
    let mut scene = TestScene::named("nothing used");
    scene.push_materials(5);
    for name in ["a", "b"] {
        scene.push_texture(name);
    }
    for name in ["shown", "hidden", "in no scene"] {
        let mesh = scene.push_mesh(name, &shapes::icosphere(2, 1.0));
        scene.document["meshes"][mesh]["primitives"][0]["material"] = json!(3);
        scene.document["meshes"][mesh]["extras"] = json!({ "name": name });
    }
    scene.push("cameras", json!({ "type": "perspective", "perspective": { "yfov": 1.0, "znear": 0.1 } }));
    scene.show(&[json!({ "mesh": 0, "name": "same" }), json!({ "name": "same" }), json!({ "mesh": 1 })]);
    scene.push("skins", json!({ "joints": [1], "name": "unused" }));
    scene.document["scenes"] =
        json!([{ "nodes": [0], "name": "first" }, { "nodes": [2, 0], "name": "second" }, { "name": "none" }]);
    scene.document["asset"]["extras"] = json!({ "made by": "hand" });
    scene.document["asset"]["copyright"] = json!("nobody");
    scene.document["extras"] = json!({ "anything": [null, {}] });
    scene
}
