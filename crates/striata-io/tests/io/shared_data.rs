//! Data that several meshes of a scene share, and data that number their vertices.

use serde_json::{Value, json};
use striata::mesh::{IndexedMesh, Semantic, shapes};
use striata_io::{
    Format, GridScope, QuantizeOptions, Scene, Source, WriteOptions, read_scene_bytes, scene_to_bytes,
};
use striata_testing::scenes::{self, TestScene};

fn read(scene: &TestScene) -> Scene {
    read_scene_bytes(&scene.to_glb(), &Source::new("x.glb")).expect("the scene is valid")
}

fn written(scene: &Scene, options: &WriteOptions) -> Vec<u8> {
    scene_to_bytes(Format::Glb, scene, options).expect("it can be written")
}

fn document(glb: &[u8]) -> Value {
    let length = u32::from_le_bytes(glb[12..16].try_into().expect("four bytes")) as usize;
    serde_json::from_slice(&glb[20..20 + length]).expect("JSON")
}

fn again(glb: &[u8]) -> Scene {
    read_scene_bytes(glb, &Source::new("x.glb")).expect("what was written can be read")
}

/// Shows each mesh with a node.
fn show_all(scene: &mut TestScene) {
    let count = scene.document["meshes"].as_array().map_or(0, Vec::len);
    scene.document["nodes"] = (0..count).map(|mesh| json!({ "mesh": mesh })).collect();
    scene.document["scenes"] = json!([{ "nodes": (0..count).collect::<Vec<_>>() }]);
}

/// Balls in many colors, over one set of accessors.
fn colors(count: usize) -> TestScene {
    let mut scene = scenes::empty();
    scene.push_mesh("ball", &shapes::icosphere(3, 1.0));
    let ball = scene.document["meshes"][0].clone();
    let meshes = (0..count).map(|material| {
        let mut mesh = ball.clone();
        mesh["primitives"][0]["material"] = json!(material);
        mesh
    });
    scene.document["meshes"] = meshes.collect();
    scene.document["materials"] = (0..count).map(|i| json!({ "name": format!("{i}") })).collect();
    show_all(&mut scene);
    scene
}

#[test]
fn meshes_that_share_accessors_share_them_again() {
    let sample = colors(20);
    let scene = read(&sample);
    for options in
        [WriteOptions::default(), WriteOptions::default().with_quantize(QuantizeOptions::default())]
    {
        let one = written(&read(&colors(1)), &options).len();
        let glb = written(&scene, &options);
        assert!(glb.len() < one + 20 * 300, "{} bytes, one ball takes {one}", glb.len());
        assert_eq!(again(&glb).triangle_count(), scene.triangle_count());
    }
    let glb = written(&scene, &WriteOptions::default());
    assert_eq!(again(&glb).meshes(), scene.meshes());
    assert!(glb.len() as f64 <= 1.05 * sample.to_glb().len() as f64);
}

/// Replaces the only mesh by one for each list of triangles, all over its vertices.
fn divide(scene: &mut TestScene, lists: &[&[[u32; 3]]]) {
    let whole = scene.document["meshes"][0]["primitives"][0].clone();
    let meshes = lists.iter().map(|triangles| {
        let bytes: Vec<u8> = triangles.iter().flatten().flat_map(|v| v.to_le_bytes()).collect();
        let view = scene.push_view(&bytes);
        let accessor = json!({
            "bufferView": view, "componentType": 5125, "count": 3 * triangles.len(), "type": "SCALAR",
        });
        let mut primitive = whole.clone();
        primitive["indices"] = json!(scene.push("accessors", accessor));
        json!({ "primitives": [primitive] })
    });
    let meshes: Vec<Value> = meshes.collect();
    scene.document["meshes"] = json!(meshes);
    show_all(scene);
}

/// A grid of which each mesh shows some rows, over one set of vertices.
fn strips_of_grid(side: u32, rows: u32) -> TestScene {
    let grid = shapes::grid(side, side);
    let mut scene = scenes::empty();
    scene.push_mesh("rows", &grid);
    let per_mesh = (2 * side * rows) as usize;
    let lists: Vec<&[[u32; 3]]> = grid.triangles.chunks(per_mesh).collect();
    divide(&mut scene, &lists);
    scene
}

#[test]
fn parts_of_one_vertex_buffer_share_it_again() {
    let sample = strips_of_grid(40, 1);
    let scene = read(&sample);
    let glb = written(&scene, &WriteOptions::default());
    let document = document(&glb);
    let position = |mesh: usize| &document["meshes"][mesh]["primitives"][0]["attributes"]["POSITION"];
    assert!((0..40).all(|mesh| position(mesh).is_u64() && position(mesh) == position(0)));
    let corners = |scene: &Scene| -> Vec<Vec<[u32; 3]>> {
        let corner = |mesh: &IndexedMesh, v: u32| mesh.positions[v as usize].map(f32::to_bits);
        let corners =
            |mesh: &IndexedMesh| mesh.triangles.iter().flatten().map(|&v| corner(mesh, v)).collect();
        scene.meshes().iter().flatten().map(corners).collect()
    };
    assert_eq!(corners(&again(&glb)), corners(&scene));
}

/// One mesh with a primitive for each color, all over the same accessors.
fn colors_of_one_mesh(count: usize) -> TestScene {
    let mut scene = colors(count);
    let of = |mesh: &Value| mesh["primitives"][0].clone();
    let primitives: Vec<Value> = scene.document["meshes"].as_array().into_iter().flatten().map(of).collect();
    scene.document["meshes"] = json!([{ "primitives": primitives }]);
    show_all(&mut scene);
    scene
}

#[test]
fn primitives_that_share_accessors_share_them_again() {
    let sample = colors_of_one_mesh(20);
    let scene = read(&sample);
    let glb = written(&scene, &WriteOptions::default());
    assert_eq!(again(&glb).meshes(), scene.meshes());
    assert!(glb.len() as f64 <= 1.05 * sample.to_glb().len() as f64);
    // Equal vertices of the primitives, as after simplification.
    let mut mesh = scene.meshes()[0].clone().expect("triangles");
    let count = mesh.vertex_count() as u32;
    let all: Vec<u32> = (0..20).flat_map(|_| 0..count).collect();
    for (number, group) in (0..).zip(mesh.groups.clone()) {
        let own = mesh.triangles[group.range()].iter_mut().flatten();
        own.for_each(|vertex| *vertex += number * count);
    }
    mesh.positions = all.iter().map(|&v| mesh.positions[v as usize]).collect();
    mesh.layers = mesh.layers.iter().map(|layer| layer.gather(&all)).collect();
    let copied = scene.clone().with_meshes(vec![Some(mesh)]).expect("the groups are the same");
    let again = written(&copied, &WriteOptions::default());
    assert_eq!(again.len(), glb.len());
}

#[test]
fn attributes_that_meshes_share_are_stored_once() {
    let mut sample = colors(6);
    for mesh in 0..6u8 {
        let count = shapes::icosphere(3, 1.0).vertex_count();
        let view = sample.push_view(&vec![mesh; 4 * count]);
        let accessor = json!({
            "bufferView": view, "componentType": 5121, "count": count, "type": "VEC4", "normalized": true,
        });
        let accessor = sample.push("accessors", accessor);
        sample.document["meshes"][mesh as usize]["primitives"][0]["attributes"]["COLOR_0"] = json!(accessor);
    }
    let scene = read(&sample);
    let glb = written(&scene, &WriteOptions::default());
    let document = document(&glb);
    let attribute =
        |mesh: usize, name: &str| document["meshes"][mesh]["primitives"][0]["attributes"][name].clone();
    for mesh in 1..6 {
        assert_eq!(attribute(mesh, "POSITION"), attribute(0, "POSITION"));
        assert_ne!(attribute(mesh, "COLOR_0"), attribute(0, "COLOR_0"));
    }
    assert!(glb.len() as f64 <= 1.05 * sample.to_glb().len() as f64);
    assert_eq!(again(&glb).meshes(), scene.meshes());
}

#[test]
fn many_meshes_of_a_few_vertices_share_views_and_vertices() {
    let mut sample = scenes::empty();
    for number in 0..200 {
        let mut part = shapes::grid(1, 1);
        part.positions.iter_mut().for_each(|p| p[0] += 3.0 * number as f32);
        sample.push_mesh("part", &part);
    }
    show_all(&mut sample);
    let scene = read(&sample);
    for options in
        [WriteOptions::default(), WriteOptions::default().with_quantize(QuantizeOptions::default())]
    {
        let glb = written(&scene, &options);
        let document = document(&glb);
        let length = |key: &str| document[key].as_array().map_or(0, Vec::len);
        assert!(length("bufferViews") < 8 && length("accessors") < 210, "{} views", length("bufferViews"));
        let (written, read) = (glb.len(), sample.to_glb().len());
        assert!(written < read, "{written} of {read} bytes");
        let found = again(&glb);
        assert_eq!(found.triangle_count(), scene.triangle_count());
        if options.quantize.is_none() {
            assert_eq!(found.meshes(), scene.meshes());
        }
    }
}

#[test]
fn tiles_that_only_touch_keep_their_own_vertices() {
    let scene = read(&strips_of_grid(40, 20));
    let glb = written(&scene, &WriteOptions::default());
    let document = document(&glb);
    let position = |mesh: usize| &document["meshes"][mesh]["primitives"][0]["attributes"]["POSITION"];
    assert_ne!(position(0), position(1));
}

/// Each of many meshes uses three vertices of a large accessor, which must not be read whole for each.
#[test]
fn few_vertices_of_a_large_accessor_are_looked_up() {
    let mut scene = scenes::empty();
    let grid = shapes::grid(400, 400);
    scene.push_mesh("grid", &grid);
    let lists: Vec<&[[u32; 3]]> = grid.triangles.chunks(70).take(4000).map(|run| &run[..1]).collect();
    divide(&mut scene, &lists);
    let read = read(&scene);
    assert_eq!(read.triangle_count(), 4000);
    for (number, mesh) in read.meshes().iter().flatten().enumerate() {
        let expected = grid.triangles[number * 70].map(|v| grid.positions[v as usize]);
        let found = mesh.triangles[0].map(|v| mesh.positions[v as usize]);
        assert_eq!(found, expected);
        assert_eq!(mesh.vertex_count(), 3);
    }
}

#[test]
fn known_extensions_may_be_required() {
    for name in striata_io::known_extensions().filter(|name| !name.contains("compression")) {
        let mut scene = colors(1);
        scene.document["extensionsUsed"] = json!([name]);
        scene.document["extensionsRequired"] = json!([name]);
        let glb = written(&read(&scene), &WriteOptions::default());
        let is_kept = ["KHR_mesh_quantization", "STRIATA_lod"].contains(&name)
            || document(&glb)["extensionsRequired"][0] == name
            || striata_io::extension_use(name) == Some(striata_io::ExtensionUse::Removed);
        assert!(is_kept, "{name} is still required");
    }
    let mut scene = colors(1);
    scene.document["extensionsRequired"] = json!(["VENDOR_unknown"]);
    assert!(read_scene_bytes(&scene.to_glb(), &Source::new("x.glb")).is_err());
}

#[test]
fn features_by_vertex_become_an_attribute() {
    let mut sample = colors(1);
    let features = json!({ "featureIds": [{ "featureCount": 642, "propertyTable": 0 }] });
    sample.document["meshes"][0]["primitives"][0]["extensions"] = json!({ "EXT_mesh_features": features });
    sample.document["extensionsUsed"] = json!(["EXT_mesh_features"]);
    let scene = read(&sample);
    assert!(scene.warnings().is_empty(), "{:?}", scene.warnings());
    let mesh = scene.meshes()[0].as_ref().expect("a mesh");
    let ids = mesh.layer(&Semantic::Generic("FEATURE_ID_0".to_owned())).expect("ids");
    let ball = shapes::icosphere(3, 1.0);
    for vertex in 0..mesh.vertex_count() {
        assert_eq!(ball.positions[ids.get(vertex, 0) as usize], mesh.positions[vertex]);
    }
    let document = document(&written(&scene, &WriteOptions::default()));
    let primitive = &document["meshes"][0]["primitives"][0];
    assert_eq!(primitive["extensions"]["EXT_mesh_features"]["featureIds"][0]["attribute"], 0);
    assert!(primitive["attributes"]["_FEATURE_ID_0"].is_u64());
}

#[test]
fn what_numbers_vertices_is_left_out_with_a_warning() {
    for name in ["CESIUM_primitive_outline", "FB_ngon_encoding", "EXT_mesh_manifold"] {
        let mut sample = colors(2);
        for mesh in 0..2 {
            sample.document["meshes"][mesh]["primitives"][0]["extensions"] =
                json!({ name: { "indices": 1 } });
        }
        sample.document["extensionsUsed"] = json!([name, "KHR_materials_unlit"]);
        let scene = read(&sample);
        let warnings: Vec<String> = scene.warnings().iter().map(ToString::to_string).collect();
        assert_eq!(warnings.len(), 1, "{warnings:?}");
        assert!(warnings[0].contains(name) && warnings[0].contains("and 1 more"), "{warnings:?}");
        let document = document(&written(&scene, &WriteOptions::default()));
        assert!(!document.to_string().contains(name));
        assert_eq!(document["extensionsUsed"], json!(["KHR_materials_unlit"]));
    }
    let mut sample = colors(1);
    sample.document["meshes"][0]["primitives"][0]["extensions"] = json!({ "VENDOR_x": { "accessor": 0 } });
    let scene = read(&sample);
    assert!(scene.warnings()[0].to_string().contains("VENDOR_x is unknown; it is kept"));
}

/// Half a grid step is the most that quantization moves a vertex, also far from the origin.
#[test]
fn quantization_keeps_nodes_far_from_the_origin_in_place() {
    let place = [6_378_117.123, 999_980.456, -2_000_020.789];
    for use_matrix in [false, true] {
        let mut sample = colors(1);
        sample.document["nodes"][0] = match use_matrix {
            false => json!({ "mesh": 0, "translation": place }),
            true => json!({
                "mesh": 0,
                "matrix": [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, place[0], place[1], place[2], 1],
            }),
        };
        let options = WriteOptions::default().with_quantize(QuantizeOptions::default());
        let document = document(&written(&read(&sample), &options));
        let node = &document["nodes"][0];
        let at = |k: usize| match use_matrix {
            false => node["translation"][k].as_f64().expect("a number"),
            true => node["matrix"][12 + k].as_f64().expect("a number"),
        };
        // The grid begins at the corner (-1, -1, -1) of the ball.
        for (k, place) in place.iter().enumerate() {
            assert!((at(k) - (place - 1.0)).abs() < 1e-6, "{node}");
        }
    }
}

/// A grid of a wavy surface from x0 to x1, relative to `origin`.
fn tile([x0, x1]: [f64; 2], origin: f64, count: u32) -> IndexedMesh {
    let mut mesh = shapes::grid(count, count);
    let bounds = mesh.bounds().expect("vertices");
    for p in &mut mesh.positions {
        let share = |k: usize| f64::from((p[k] - bounds.min[k]) / (bounds.max[k] - bounds.min[k]));
        let (x, y) = (x0 + (x1 - x0) * share(0), share(1));
        let height = 0.1 * libm::sin(7.3 * x) * libm::cos(5.1 * y);
        *p = [(x - origin) as f32, y as f32, height as f32];
    }
    mesh.layers.clear();
    mesh
}

/// Largest distance between points of two meshes that were equal before.
fn gap(scene: &Scene, places: [f64; 2]) -> f64 {
    let border = |mesh: usize| -> Vec<[f64; 3]> {
        let instance = scene.instances().iter().find(|instance| instance.mesh == mesh).expect("it is shown");
        let m = instance.transform;
        let of = |p: &[f32; 3]| {
            let p = p.map(f64::from);
            [0, 1, 2].map(|k| m[k] * p[0] + m[4 + k] * p[1] + m[8 + k] * p[2] + m[12 + k])
        };
        let all = scene.meshes()[mesh].as_ref().expect("a mesh").positions.iter().map(of);
        all.filter(|p| (p[0] - places[0]).abs() < 0.01).collect()
    };
    let (a, b) = (border(0), border(1));
    assert!(a.len() > 5 && b.len() > 5);
    let nearest = |p: &[f64; 3]| {
        let distance = |q: &[f64; 3]| (0..3).map(|k| (p[k] - q[k]).abs()).fold(0.0, f64::max);
        b.iter().map(distance).fold(f64::INFINITY, f64::min)
    };
    a.iter().map(nearest).fold(0.0, f64::max) * places[1]
}

#[test]
fn borders_of_meshes_that_touch_still_meet_after_quantization() {
    for (origin, bits) in [(0.0, 14), (0.0, 10), (0.0, 16), (1.0, 14), (0.3, 12)] {
        let mut sample = scenes::empty();
        sample.push_mesh("a", &tile([0.0, 1.0], 0.0, 20));
        sample.push_mesh("b", &tile([1.0, 2.7], origin, 20));
        show_all(&mut sample);
        sample.document["nodes"][1]["translation"] = json!([origin, 0, 0]);
        let scene = read(&sample);
        let plain = WriteOptions::default();
        let forms = [plain.clone(), plain.clone().with_meshopt(true), plain.with_draco(true)];
        let gap_with = |grid: GridScope, form: &WriteOptions| {
            let quantize = QuantizeOptions::default().with_position_bits(bits).with_grid(grid);
            let options = form.clone().with_quantize(quantize);
            gap(&again(&written(&scene, &options)), [1.0, 1.0])
        };
        let before = gap(&scene, [1.0, 1.0]);
        for (number, form) in forms.iter().enumerate() {
            for grid in [GridScope::Touching, GridScope::Scene] {
                let found = gap_with(grid, form);
                assert!(found <= 2.0 * before, "{origin} {bits} {grid:?} {number}: {found} {before}");
            }
            assert!(gap_with(GridScope::Mesh, form) > 1e-6, "{origin} {bits} {number}");
        }
    }
}

#[test]
fn small_meshes_keep_their_precision_next_to_large_ones() {
    let mut sample = scenes::empty();
    let mut large = tile([0.0, 1.0], 0.0, 20);
    large.positions.iter_mut().flatten().for_each(|x| *x *= 1000.0);
    let mut small = shapes::icosphere(2, 1.0);
    // They have one point in common.
    small.positions[0] = large.positions[0];
    sample.push_mesh("ground", &large);
    sample.push_mesh("stone", &small);
    show_all(&mut sample);
    let scene = read(&sample);
    let options = WriteOptions::default().with_quantize(QuantizeOptions::default());
    let coarse = again(&written(&scene, &options));
    let bounds = |scene: &Scene, mesh: usize| {
        let instance = &scene.instances()[mesh];
        let mesh = scene.meshes()[mesh].as_ref().expect("a mesh").bounds().expect("vertices");
        (f64::from(mesh.max[0]) - f64::from(mesh.min[0])) * instance.scale
    };
    assert!((bounds(&coarse, 1) - bounds(&scene, 1)).abs() < 3e-4, "the stone has its own grid");
}

/// Primitives of one mesh are compressed apart, in boxes of different sizes.
#[test]
fn parts_of_a_mesh_still_meet_after_draco() {
    let mut sample = scenes::empty();
    let sides = [tile([0.0, 1.0], 0.0, 20), tile([1.0, 3.7], 0.0, 20)];
    for (name, side) in ["grass", "rock"].into_iter().zip(&sides) {
        sample.push_mesh(name, side);
    }
    let mut rock = sample.document["meshes"][1]["primitives"][0].clone();
    rock["material"] = json!(1);
    sample.document["meshes"][0]["primitives"][0]["material"] = json!(0);
    sample.document["meshes"][0]["primitives"].as_array_mut().expect("a list").push(rock);
    sample.document["meshes"].as_array_mut().expect("a list").truncate(1);
    sample.document["materials"] = json!([{ "name": "grass" }, { "name": "rock" }]);
    show_all(&mut sample);
    let quantize = QuantizeOptions::default().with_grid(GridScope::Mesh);
    let options = WriteOptions::default().with_draco(true).with_quantize(quantize);
    let point_count = |scene: &Scene| {
        let positions = scene.meshes().iter().flatten().flat_map(|mesh| &mesh.positions);
        positions.map(|point| point.map(f32::to_bits)).collect::<std::collections::HashSet<_>>().len()
    };
    let scene = read(&sample);
    assert_eq!(point_count(&again(&written(&scene, &options))), point_count(&scene));
}
