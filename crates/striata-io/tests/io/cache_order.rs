//! `WriteOptions::cache_order`: triangles change their order, and nothing else; blended ones keep it.
use serde_json::json;
use striata::mesh::{AttributeLayer, IndexedMesh, LayerData, Material, Semantic, TriangleGroup, shapes};
use striata::strip::fifo_cache_cost;
use striata_io::{
    Format, Scene, SceneWriter, SharedMesh, Source, WriteOptions, read_bytes, read_scene_bytes,
    scene_to_bytes, to_bytes,
};

/// A shuffled grid of two materials, of which the first is blended.
fn shuffled() -> IndexedMesh {
    let mut mesh = shapes::grid(24, 24);
    let half = mesh.triangle_count() / 2;
    for (begin, count) in [(0, half), (half, mesh.triangle_count() - half)] {
        (0..count).for_each(|i| mesh.triangles.swap(begin + i, begin + i * 389 % count));
    }
    let group = |material: u32, first: usize, count: usize| TriangleGroup {
        name: String::new(),
        material: Some(material),
        first: first as u32,
        count: count as u32,
    };
    mesh.groups = vec![group(0, 0, half), group(1, half, mesh.triangle_count() - half)];
    let material = |name: &str, mode: &str| Material {
        name: name.to_owned(),
        gltf_json: json!({ "alphaMode": mode }).to_string(),
    };
    mesh.appearance.materials = vec![material("glass", "BLEND"), material("leaves", "MASK")];
    mesh
}

fn ordered() -> WriteOptions {
    WriteOptions::default().with_cache_order(true)
}

/// Corner positions of the triangles.
fn corners(mesh: &IndexedMesh) -> Vec<[[u32; 3]; 3]> {
    mesh.triangles.iter().map(|t| t.map(|v| mesh.positions[v as usize].map(f32::to_bits))).collect()
}

fn acmr(triangles: &[[u32; 3]]) -> f64 {
    fifo_cache_cost(triangles.as_flattened(), triangles.len(), 16).acmr
}

/// Checks that a mesh shows what another one does, with the second group in a better order.
fn check_ordered(name: &str, before: &IndexedMesh, after: &IndexedMesh) {
    let half = before.groups[0].count as usize;
    let [mut old, mut new] = [before, after].map(corners);
    assert_eq!(old[..half], new[..half], "{name}: blended triangles moved");
    assert_ne!(old, new, "{name}");
    old.sort_unstable();
    new.sort_unstable();
    assert_eq!(old, new, "{name}: a triangle was lost or turned");
    assert!(acmr(&before.triangles[half..]) > 2.0 && acmr(&after.triangles[half..]) < 0.75, "{name}");
}

fn is_by_first_use(mesh: &IndexedMesh) -> bool {
    let mut next = 0;
    mesh.triangles.iter().flatten().all(|&v| {
        let is_known_or_next = v <= next;
        next = next.max(v + 1);
        is_known_or_next
    })
}

#[test]
fn every_format_has_the_order_if_it_is_asked_for() {
    let mesh = shuffled();
    for (format, name) in [(Format::Glb, "a.glb"), (Format::Gltf, "a.gltf"), (Format::Obj, "a.obj")] {
        let read = |options: &WriteOptions| {
            let bytes = to_bytes(format, &mesh, options).expect("a file");
            read_bytes(&bytes, &Source::new(name)).expect("a mesh")
        };
        assert_eq!(corners(&read(&WriteOptions::default())), corners(&mesh), "{name}");
        let written = read(&ordered());
        check_ordered(name, &mesh, &written);
        assert!(is_by_first_use(&written), "{name}");
    }
    for (format, name) in [(Format::Ply, "a.ply"), (Format::Off, "a.off"), (Format::Stl, "a.stl")] {
        let plain = IndexedMesh {
            groups: vec![],
            ..IndexedMesh::new(mesh.positions.clone(), mesh.triangles.clone())
        };
        let bytes = to_bytes(format, &plain, &ordered()).expect("a file");
        let written = read_bytes(&bytes, &Source::new(name)).expect("a mesh");
        assert!(acmr(&plain.triangles) > 2.0 && acmr(&written.triangles) < 0.75, "{name}");
        assert!(is_by_first_use(&written), "{name}");
    }
}

#[test]
fn shading_divides_vertices_before_they_are_ordered() {
    let cube = IndexedMesh { groups: vec![], ..shapes::cube() };
    let bytes = to_bytes(Format::Glb, &cube, &ordered().with_shading(true)).expect("a file");
    let written = read_bytes(&bytes, &Source::new("a.glb")).expect("a mesh");
    assert_eq!(written.vertex_count(), 24);
    assert!(is_by_first_use(&written));
}

#[test]
fn data_of_triangles_follow_them() {
    let mut mesh = shuffled();
    mesh.groups.clear();
    mesh.appearance.materials.clear();
    let label = |t: &[u32; 3]| t[0] * 3 + t[1] + 7 * t[2];
    mesh.triangle_layers = vec![AttributeLayer {
        semantic: Semantic::Generic("label".to_owned()),
        component_count: 1,
        normalized: false,
        data: LayerData::U32(mesh.triangles.iter().map(label).collect()),
    }];
    let read = |options: &WriteOptions| {
        let bytes = to_bytes(Format::Ply, &mesh, options).expect("a file");
        let mesh = read_bytes(&bytes, &Source::new("a.ply")).expect("a mesh");
        let labels: Vec<f32> =
            (0..mesh.triangle_count()).map(|t| mesh.triangle_layers[0].get(t, 0)).collect();
        let mut labeled: Vec<_> =
            corners(&mesh).into_iter().zip(labels.iter().map(|x| x.to_bits())).collect();
        labeled.sort_unstable();
        (labels, labeled)
    };
    let [before, after] = [WriteOptions::default(), ordered()].map(|options| read(&options));
    assert_ne!(before.0, after.0);
    assert_eq!(before.1, after.1);
}

fn scene() -> Scene {
    Scene::from_mesh(shuffled()).expect("a scene")
}

fn written(bytes: &[u8]) -> Scene {
    read_scene_bytes(bytes, &Source::new("a.glb")).expect("a scene")
}

#[test]
fn primitives_of_scenes_keep_their_order_if_they_are_blended() {
    let before = scene();
    let mesh = before.meshes()[0].as_ref().expect("triangles");
    let after = written(&scene_to_bytes(Format::Glb, &before, &ordered()).expect("a file"));
    let found = after.meshes()[0].as_ref().expect("triangles");
    check_ordered("scene", mesh, found);
    assert!(is_by_first_use(found));
    let kept = written(&scene_to_bytes(Format::Glb, &before, &WriteOptions::default()).expect("a file"));
    assert_eq!(corners(kept.meshes()[0].as_ref().expect("triangles")), corners(mesh));
    // A variant that is blended counts as well.
    let mut parts = scene().into_parts();
    let primitive = &mut parts.document["meshes"][0]["primitives"][1];
    primitive["extensions"] =
        json!({ "KHR_materials_variants": { "mappings": [{ "material": 0, "variants": [0] }] } });
    let varied = Scene::from_parts(parts).expect("a scene");
    let after = written(&scene_to_bytes(Format::Glb, &varied, &ordered()).expect("a file"));
    assert_eq!(corners(after.meshes()[0].as_ref().expect("triangles")), corners(mesh));
}

#[test]
fn vertices_that_other_levels_use_stay_where_they_are() {
    let mut parts = scene().into_parts();
    let entry = parts.document["meshes"][0].clone();
    parts.document["meshes"].as_array_mut().expect("meshes").push(entry);
    parts.document["nodes"].as_array_mut().expect("nodes").push(json!({ "mesh": 1 }));
    parts.document["scenes"][0]["nodes"].as_array_mut().expect("nodes").push(json!(1));
    parts.meshes.push(None);
    let both = Scene::from_parts(parts).expect("a scene");
    let mesh = both.meshes()[0].clone().expect("triangles");
    let lists: Vec<Vec<u32>> =
        mesh.groups.iter().map(|group| mesh.triangles[group.range()].as_flattened().to_vec()).collect();
    let shared = SharedMesh { vertices_of: 0, vertex_count: mesh.vertex_count(), index_lists: lists };
    let bytes = SceneWriter::new(&both).with_shared_mesh(1, shared).to_bytes(Format::Glb, &ordered());
    let after = written(&bytes.expect("a file"));
    for found in after.meshes().iter().flatten() {
        assert_eq!(found.positions, mesh.positions);
        check_ordered("shared", &mesh, found);
    }
    assert_eq!(after.meshes().len(), 2);
}
