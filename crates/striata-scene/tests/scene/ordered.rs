//! GLB files with the extensions `STRIATA_order` and `STRIATA_clusters`: their levels by the rule, compared with the
//! oracle.

use serde_json::Value;
use striata::clusters::{ClusterDag, ClusterOptions};
use striata::mesh::{IndexedMesh, RefinableMesh, canonical_triangles, replay, shapes};
use striata::strip::{cache_order, fifo_cache_cost};
use striata::{Lod, LodOptions};
use striata_io::{Format, Scene, Source, WriteOptions, read_scene_bytes, scene_to_bytes};
use striata_scene::clustered::CLUSTER_EXTENSION;
use striata_scene::ordered::ORDER_EXTENSION;
use striata_scene::{ClusteredScene, LodScene};
use striata_testing::gltf_check::CheckedGlb;
use striata_testing::meshes;
use striata_testing::scenes;

/// The levels of a file, read from its bytes alone.
struct Reader {
    document: Value,
    binary: Vec<u8>,
}

impl Reader {
    fn new(glb: &[u8]) -> Self {
        let number = |at: usize| u32::from_le_bytes(glb[at..at + 4].try_into().unwrap()) as usize;
        let end = 20 + number(12);
        let binary = glb.get(end + 8..).unwrap_or_default().to_vec();
        Self { document: serde_json::from_slice(&glb[20..end]).unwrap(), binary }
    }

    fn integers(&self, accessor: &Value) -> Vec<u32> {
        let accessor = &self.document["accessors"][index(accessor)];
        let view = &self.document["bufferViews"][index(&accessor["bufferView"])];
        let start = index(&view["byteOffset"]) + index(&accessor["byteOffset"]);
        let width = if accessor["componentType"] == 5125 { 4 } else { 2 };
        let bytes = &self.binary[start..start + index(&accessor["count"]) * width];
        let number = |bytes: &[u8]| bytes.iter().rev().fold(0, |sum, &byte| sum << 8 | u32::from(byte));
        bytes.chunks(width).map(number).collect()
    }

    /// Primitives of a mesh that have levels.
    fn primitives(&self, mesh: usize) -> impl Iterator<Item = &Value> {
        self.extended(mesh, ORDER_EXTENSION)
    }

    /// Primitives of a mesh that have an extension.
    fn extended<'a>(&'a self, mesh: usize, extension: &'a str) -> impl Iterator<Item = &'a Value> {
        let primitives = self.document["meshes"][mesh]["primitives"].as_array().unwrap();
        primitives.iter().filter(move |primitive| primitive["extensions"].get(extension).is_some())
    }
}

fn index(value: &Value) -> usize {
    value.as_u64().unwrap_or(0) as usize
}

fn triangles(indices: &[u32]) -> Vec<[u32; 3]> {
    indices.as_chunks().0.to_vec()
}

/// The rule of the extension.
fn level(full: &[[u32; 3]], targets: &[u32], vertex_count: usize) -> Vec<[u32; 3]> {
    let mut map: Vec<u32> = Vec::new();
    for (vertex, &target) in targets.iter().enumerate() {
        map.push(if vertex < vertex_count { vertex as u32 } else { map[target as usize] });
    }
    let mapped = full.iter().map(|triangle| triangle.map(|vertex| map[vertex as usize]));
    mapped.filter(|&[a, b, c]| a != b && b != c && c != a).collect()
}

/// The triangles of each group that has any at full detail, from the oracle, at a number of vertices.
fn replayed(lod: &Lod, vertex_count: usize) -> Vec<Vec<[u32; 3]>> {
    let refinable = RefinableMesh { mesh: lod.mesh().clone(), sequence: lod.sequence().clone() };
    let split_count = lod.sequence().split_count_for_vertices(vertex_count);
    assert_eq!(lod.sequence().vertex_count_at(split_count), vertex_count);
    let level = replay(&refinable, split_count);
    let groups = level.groups_or_whole().into_iter().zip(lod.mesh().groups_or_whole());
    groups.filter(|(_, full)| full.count > 0).map(|(g, _)| level.triangles[g.range()].to_vec()).collect()
}

/// Checks an extension against its schema.
fn check_schema(order: &Value) {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs/STRIATA_order.schema.json");
    let schema: Value = serde_json::from_slice(&std::fs::read(path).unwrap()).unwrap();
    let has = |name: &str| order.get(name).is_some();
    assert!(schema["required"].as_array().unwrap().iter().all(|name| has(name.as_str().unwrap())), "{order}");
    assert_eq!(has("indices"), has("ranges"), "{order}");
    for (name, value) in order.as_object().unwrap() {
        let rules = &schema["properties"][name];
        assert_eq!(rules["type"], if value.is_u64() { "integer" } else { "array" }, "{name}");
        let columns = rules["items"]["prefixItems"].as_array().map_or(0, Vec::len);
        let mut rows = value.as_array().into_iter().flatten();
        assert!(rows.all(|row| row.as_array().is_some_and(|row| row.len() == columns)), "{name}: {value}");
    }
}

/// Compares all levels of a file with the oracle; returns the number of levels.
fn check(name: &str, lods: &LodScene, range_count: usize) -> usize {
    let glb = lods.to_ordered_glb(range_count).unwrap();
    let checked = CheckedGlb::new(&glb.bytes, |_, _| panic!("nothing is compressed"));
    assert_eq!(checked.faults(), &[] as &[String], "{name}");
    assert_eq!(glb.plain_bytes + glb.order_bytes + glb.range_bytes, glb.bytes.len(), "{name}");
    let reader = Reader::new(&glb.bytes);
    let mut count = 0;
    for (mesh, lod) in lods.lods().iter().enumerate() {
        let Some(lod) = lod.as_ref().filter(|lod| lod.mesh().triangle_count() > 0) else { continue };
        let full_groups = replayed(lod, lod.mesh().vertex_count());
        assert_eq!(reader.primitives(mesh).count(), full_groups.len(), "{name}");
        for (group, primitive) in reader.primitives(mesh).enumerate() {
            let order = &primitive["extensions"][ORDER_EXTENSION];
            check_schema(order);
            let targets = reader.integers(&order["targets"]);
            let full = triangles(&reader.integers(&primitive["indices"]));
            assert_eq!(targets.len(), lod.mesh().vertex_count(), "{name}");
            let all = order.get("indices").map(|all| reader.integers(all)).unwrap_or_default();
            let ranges = order.get("ranges").and_then(Value::as_array).cloned().unwrap_or_default();
            let levels = order["levels"].as_array().unwrap();
            assert_eq!(ranges.len(), range_count.min(levels.len()), "{name}");
            let mut coarsest = 0.0;
            for (number, row) in levels.iter().enumerate() {
                let vertex_count = index(&row[0]);
                let found = level(&full, &targets, vertex_count);
                let place = format!("{name}: meshes[{mesh}], group {group}, level {number}");
                let expected = canonical_triangles(&replayed(lod, vertex_count)[group]);
                assert_eq!(canonical_triangles(&found), expected, "{place}");
                assert_eq!(found.len(), index(&row[1]), "{place}");
                let error = row[2].as_f64().unwrap();
                assert!(error >= coarsest, "{place}: {error} after {coarsest}");
                coarsest = error;
                count += 1;
                let Some(range) = ranges.get(number) else { continue };
                let (first, length) = (index(&range[0]), index(&range[1]));
                let in_range = triangles(&all[first..first + length]);
                assert_eq!(canonical_triangles(&in_range), expected, "{place}");
                assert_eq!((&range[2], &range[3]), (&row[0], &row[2]), "{place}");
                assert!(in_range.iter().flatten().all(|&v| (v as usize) < vertex_count), "{place}");
            }
            assert_eq!(index(&levels[levels.len() - 1][0]), lod.sequence().base_vertex_count(), "{name}");
        }
    }
    let uses = |list: &str| {
        let names = reader.document.get(list).and_then(Value::as_array).into_iter().flatten();
        names.into_iter().any(|name| name == ORDER_EXTENSION)
    };
    assert_eq!((uses("extensionsUsed"), uses("extensionsRequired")), (count > 0, false), "{name}");
    check_plain_file(name, &lods.full_scene(), &glb.bytes);
    count
}

/// Checks that readers without the extension find what a plain file has.
fn check_plain_file(name: &str, scene: &Scene, glb: &[u8]) {
    let read = |bytes: &[u8]| read_scene_bytes(bytes, &Source::new("test.glb")).unwrap();
    let plain = scene_to_bytes(Format::Glb, scene, &WriteOptions::default()).unwrap();
    let (found, expected) = (read(glb), read(&plain));
    // If an unknown extension refers to numbers, freed ones stay.
    let document = |scene: &Scene| {
        let mut document = scene.document().clone();
        for list in ["accessors", "bufferViews"] {
            let Some(list) = document.get_mut(list).and_then(Value::as_array_mut) else { continue };
            list.truncate(list.iter().rposition(|entry| !entry.is_null()).map_or(0, |last| last + 1));
        }
        document
    };
    assert_eq!(document(&found), document(&expected), "{name}");
    assert_eq!(found.buffer(), expected.buffer(), "{name}");
    assert_eq!(found.images(), expected.images(), "{name}");
    for (found, expected) in found.meshes().iter().zip(expected.meshes()) {
        let corners = |mesh: &IndexedMesh| {
            let mesh = mesh.with_vertices_by_first_use();
            let corner = |&v: &u32| {
                let layers = mesh.layers.iter().map(|layer| {
                    let size = layer.vertex_bytes();
                    layer.data.as_bytes()[v as usize * size..][..size].to_vec()
                });
                (mesh.positions[v as usize].map(|x| (x + 0.0).to_bits()), layers.collect::<Vec<_>>())
            };
            let groups = mesh.groups_or_whole().into_iter().map(|group| {
                let mut list: Vec<_> = mesh.triangles[group.range()]
                    .iter()
                    .map(|triangle| {
                        let mut corners: Vec<_> = triangle.iter().map(corner).collect();
                        let first = (0..3).min_by_key(|&k| corners[k].clone()).unwrap();
                        corners.rotate_left(first);
                        corners
                    })
                    .collect();
                list.sort();
                list
            });
            groups.collect::<Vec<_>>()
        };
        assert_eq!(found.as_ref().map(corners), expected.as_ref().map(corners), "{name}");
    }
}

#[test]
fn levels_of_meshes_by_the_rule_are_those_of_the_oracle() {
    let mut count = 0;
    for (name, mesh) in meshes::all() {
        let Ok(scene) = Scene::from_mesh(mesh) else { continue };
        let Ok(lods) = LodScene::build(&scene, &LodOptions::default()) else { continue };
        if name == "attributes not a number" {
            assert!(lods.to_ordered_glb(0).unwrap_err().to_string().contains("NaN in texcoord_0"));
            continue;
        }
        count += check(&name, &lods, 3);
    }
    assert!(count > 200, "{count} levels");
}

#[test]
fn levels_of_scenes_by_the_rule_are_those_of_the_oracle() {
    let mut count = 0;
    for sample in scenes::all() {
        let scene = read_scene_bytes(&sample.to_glb(), &Source::new("test.glb")).unwrap();
        let lods = LodScene::build(&scene, &LodOptions::default()).unwrap();
        for range_count in [0, 2, 100] {
            count += check(sample.name, &lods, range_count);
        }
    }
    assert!(count > 200, "{count} levels");
}

#[test]
fn ranges_need_as_few_cache_misses_as_the_best_order() {
    let scene = Scene::from_mesh(meshes::rough(shapes::torus(60, 40, 2.0, 1.0), 0.1, 1)).unwrap();
    let lods = LodScene::build(&scene, &LodOptions::default()).unwrap();
    let ordered = lods.ordered(6)[0].clone().unwrap();
    let primitive = &ordered.primitives[0];
    assert_eq!(primitive.ranges.len(), 6);
    for range in &primitive.ranges {
        let indices = &primitive.indices[range.first_index..][..range.index_count];
        let level =
            level(&lods.lods()[0].as_ref().unwrap().mesh().triangles, &ordered.targets, range.vertex_count);
        let best: Vec<u32> = cache_order(&level).iter().flat_map(|&t| level[t as usize]).collect();
        let misses = |indices: &[u32]| fifo_cache_cost(indices, indices.len() / 3, 16).miss_count;
        assert!(
            misses(indices) as f64 <= 1.03 * misses(&best) as f64,
            "{} of {}",
            misses(indices),
            misses(&best)
        );
    }
    assert_eq!(&primitive.indices[..primitive.ranges[0].index_count], ordered.mesh.triangles.as_flattened());
}

/// A torus of glass.
fn blended() -> Scene {
    let mut parts = Scene::from_mesh(shapes::torus(20, 10, 2.0, 1.0)).unwrap().into_parts();
    parts.document["materials"] = serde_json::json!([{ "alphaMode": "BLEND" }]);
    parts.document["meshes"][0]["primitives"][0]["material"] = 0.into();
    Scene::from_parts(parts).unwrap()
}

#[test]
fn blended_triangles_keep_their_order() {
    let lods = LodScene::build(&blended(), &LodOptions::default()).unwrap();
    let full = &lods.lods()[0].as_ref().unwrap().mesh().triangles;
    let ordered = lods.ordered(4)[0].clone().unwrap();
    for range in &ordered.primitives[0].ranges {
        let found = triangles(&ordered.primitives[0].indices[range.first_index..][..range.index_count]);
        assert_eq!(found, level(full, &ordered.targets, range.vertex_count));
    }
}

/// Triangles of a cut of a file, for each of the primitives of a mesh, by the rule of the extension.
fn cluster_cut(reader: &Reader, mesh: usize, error: f32) -> Vec<Vec<[u32; 3]>> {
    let groups =
        reader.document["meshes"][mesh]["extensions"][CLUSTER_EXTENSION]["groups"].as_array().unwrap();
    let is_coarse = |group: u32| groups[group as usize][5].as_f64().unwrap() as f32 <= error;
    let cut = |primitive: &Value| {
        let clusters = &primitive["extensions"][CLUSTER_EXTENSION];
        let all = triangles(&reader.integers(&clusters["indices"]));
        let (mut drawn, mut first) = (Vec::new(), 0);
        for row in reader.integers(&clusters["clusters"]).chunks(3) {
            let own = first..first + row[0] as usize;
            first = own.end;
            if !is_coarse(row[1]) && (row[2] == 0 || is_coarse(row[2] - 1)) {
                drawn.extend_from_slice(&all[own]);
            }
        }
        assert_eq!(first, all.len());
        drawn
    };
    reader.extended(mesh, CLUSTER_EXTENSION).map(cut).collect()
}

/// Compares cuts of a file with those of the library; returns their number.
fn check_clusters(name: &str, scene: &Scene) -> usize {
    let options = ClusterOptions::default().with_max_triangles(16).with_group_size(4);
    let clustered = ClusteredScene::build(scene.clone(), &options).unwrap();
    let glb = clustered.to_glb().unwrap();
    let checked = CheckedGlb::new(&glb.bytes, |_, _| panic!("nothing is compressed"));
    assert_eq!(checked.faults(), &[] as &[String], "{name}");
    assert!(glb.plain_bytes <= glb.bytes.len(), "{name}");
    let reader = Reader::new(&glb.bytes);
    let mut count = 0;
    for (mesh, dag) in clustered.dags().iter().enumerate() {
        let Some(dag) = dag.as_ref().filter(|dag| !dag.groups.is_empty()) else { continue };
        // Shown: the full mesh.
        let full = cluster_cut(&reader, mesh, -1.0);
        let primitives = reader.extended(mesh, CLUSTER_EXTENSION);
        let shown: Vec<_> = primitives.map(|p| triangles(&reader.integers(&p["indices"]))).collect();
        assert_eq!(full, shown, "{name}");
        let errors = dag.groups.iter().map(|group| group.error).filter(|error| error.is_finite());
        for error in errors.step_by(3) {
            let found = cluster_cut(&reader, mesh, error).concat();
            let expected = dag.triangles_of(&dag.cut_for_error(error));
            assert_eq!(canonical_triangles(&found), canonical_triangles(&expected), "{name}: {error}");
            count += 1;
        }
        check_groups(&reader.document["meshes"][mesh]["extensions"][CLUSTER_EXTENSION], dag);
    }
    let lods = LodScene::build(scene, &LodOptions::default()).unwrap();
    check_plain_file(name, &lods.full_scene(), &glb.bytes);
    count
}

/// Compares the table of groups with the library, and both with the schema.
fn check_groups(extension: &Value, dag: &ClusterDag) {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs/STRIATA_clusters.schema.json");
    let schema: Value = serde_json::from_slice(&std::fs::read(path).unwrap()).unwrap();
    let columns =
        schema["$defs"]["mesh"]["properties"]["groups"]["items"]["prefixItems"].as_array().unwrap().len();
    let rows = extension["groups"].as_array().unwrap();
    assert_eq!(rows.len(), dag.groups.len());
    for (row, group) in rows.iter().zip(&dag.groups) {
        let row: Vec<f32> = row.as_array().unwrap().iter().map(|x| x.as_f64().unwrap() as f32).collect();
        let [x, y, z] = group.sphere.center;
        let expected =
            [group.depth as f32, x, y, z, group.sphere.radius.min(f32::MAX), group.error.min(f32::MAX)];
        assert_eq!((row.len(), row), (columns, expected.to_vec()));
    }
}

#[test]
fn cuts_of_clusters_by_the_rule_are_those_of_the_library() {
    let mut count = 0;
    for sample in scenes::all() {
        let scene = read_scene_bytes(&sample.to_glb(), &Source::new("test.glb")).unwrap();
        count += check_clusters(sample.name, &scene);
    }
    for (name, mesh) in meshes::all().into_iter().filter(|(name, _)| *name != "attributes not a number") {
        let Ok(scene) = Scene::from_mesh(mesh) else { continue };
        if ClusteredScene::build(scene.clone(), &ClusterOptions::default()).is_ok() {
            count += check_clusters(&name, &scene);
        }
    }
    assert!(count > 100, "{count} cuts");
}

#[test]
fn blended_triangles_of_clusters_keep_their_order() {
    let options = ClusterOptions::default().with_max_triangles(16).with_group_size(4);
    let clustered = ClusteredScene::build(blended(), &options).unwrap();
    let glb = clustered.to_glb().unwrap().bytes;
    let checked = CheckedGlb::new(&glb, |_, _| panic!("nothing is compressed"));
    assert_eq!(checked.faults(), &[] as &[String]);
    let reader = Reader::new(&glb);
    let primitive = reader.extended(0, CLUSTER_EXTENSION).next().unwrap();
    let shown = triangles(&reader.integers(&primitive["indices"]));
    assert_eq!(shown, clustered.scene().meshes()[0].as_ref().unwrap().triangles);
    let full = cluster_cut(&reader, 0, -1.0).concat();
    assert_ne!(full, shown, "clusters have another order");
    assert_eq!(canonical_triangles(&full), canonical_triangles(&shown));
    let dag = clustered.dags()[0].as_ref().unwrap();
    let error = dag.groups[0].error;
    let expected = dag.triangles_of(&dag.cut_for_error(error));
    assert_eq!(canonical_triangles(&cluster_cut(&reader, 0, error).concat()), canonical_triangles(&expected));
}
