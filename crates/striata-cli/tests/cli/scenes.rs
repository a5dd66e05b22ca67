//! Scenes: verbs keep nodes, materials, skins and animations, and `--flat` gives one mesh.

use serde_json::{Value, json};
use striata_testing::scenes::{self, TestScene};

use crate::workbench::Workbench;

fn bench_of(scene: &TestScene) -> Workbench {
    let bench = Workbench::new();
    bench.write("a.glb", scene.to_glb());
    bench
}

/// Returns the document of a GLB file without what depends on the stored vertices.
fn document(bench: &Workbench, name: &str) -> Value {
    let bytes = bench.read(name);
    let length = u32::from_le_bytes(bytes[12..16].try_into().unwrap()) as usize;
    let mut root: Value = serde_json::from_slice(&bytes[20..20 + length]).unwrap();
    let map = root.as_object_mut().unwrap();
    for key in ["accessors", "bufferViews", "buffers"] {
        map.remove(key);
    }
    without_references(&mut root);
    root
}

/// Removes the numbers of accessors and buffer views.
fn without_references(value: &mut Value) {
    match value {
        Value::Array(entries) => entries.iter_mut().for_each(without_references),
        Value::Object(members) => {
            for key in ["indices", "bufferView", "inverseBindMatrices", "input", "output"] {
                members.remove(key);
            }
            for key in ["attributes", "TRANSLATION"] {
                if let Some(Value::Object(attributes)) = members.get_mut(key) {
                    attributes.values_mut().for_each(|value| *value = Value::Null);
                }
            }
            if let Some(Value::Array(targets)) = members.get_mut("targets") {
                for target in targets.iter_mut().filter_map(Value::as_object_mut) {
                    target.values_mut().for_each(|value| *value = Value::Null);
                }
            }
            members.values_mut().for_each(without_references);
        }
        _ => {}
    }
}

#[test]
fn documents_survive_every_verb() {
    for scene in [scenes::hierarchy(), scenes::skinned(), scenes::morphed(), scenes::mixed_primitives()] {
        let bench = bench_of(&scene);
        let original = document(&bench, "a.glb");
        bench.json("convert a.glb converted.glb");
        bench.json("build a.glb -o a.striata");
        bench.json("extract a.striata -o full.glb --detail 1");
        bench.json("simplify a.glb -o half.glb --ratio 0.5");
        bench.json("encode a.glb -o a.stri --lossless");
        bench.json("decode a.stri -o decoded.glb");
        bench.json("convert a.striata again.glb");
        for name in ["converted.glb", "full.glb", "half.glb", "decoded.glb", "again.glb"] {
            assert_eq!(document(&bench, name), original, "{}: {name}", scene.name);
        }
    }
}

#[test]
fn targets_count_all_instances_in_units_of_the_scene() {
    let bench = bench_of(&scenes::hierarchy());
    let facts = bench.json("info a.glb")["scene"].clone();
    assert_eq!((facts["instance_count"].clone(), facts["node_count"].clone()), (json!(4), json!(7)));
    // A mesh that only another scene shows does not count.
    let full = bench.json("build a.glb -o a.striata")["triangle_count"].as_u64().unwrap();
    assert_eq!(bench.json("info a.glb")["triangle_count"], full);
    for share in [50, 20, 5] {
        let report = bench.json(&format!("extract a.striata -o level.glb --triangles {share}%"));
        let count = report["triangle_count"].as_u64().unwrap();
        assert!(count <= full * share / 100 + full / 20 && count > 0, "{count} of {full}");
        assert_eq!(report["shortfall"], Value::Null);
    }
    // The same length as a share of the diagonal and in units.
    let by_share = bench.json("extract a.striata -o level.glb --error 1%");
    let diagonal = bench.json("info a.glb")["diagonal"].as_f64().unwrap();
    let by_length = bench.json(&format!("extract a.striata -o level.glb --error {}", diagonal / 100.0));
    assert_eq!(by_share["triangle_count"], by_length["triangle_count"]);
    assert!(by_share["error"].as_f64().unwrap() <= diagonal / 100.0);
    let bounded = bench.json("simplify a.glb -o level.glb --max-error 2%");
    assert_eq!(bounded["error_is_guaranteed"], true);
    assert!(bounded["error"].as_f64().unwrap() <= diagonal / 50.0);
}

#[test]
fn other_formats_and_flat_files_contain_one_mesh() {
    let bench = bench_of(&scenes::hierarchy());
    let flat = bench.json("info a.glb --flat");
    assert_eq!(flat.get("scene"), None);
    for line in
        ["convert a.glb flat.ply", "convert a.glb flat.glb --flat", "simplify a.glb -o flat.obj --detail 1"]
    {
        bench.json(line);
        let name = if line.ends_with("--flat") {
            "flat.glb"
        } else {
            line.split(' ').rfind(|w| w.starts_with("flat.")).unwrap()
        };
        let info = bench.json(&format!("info {name} --flat"));
        let bounds = |info: &Value| info["diagonal"].as_f64().unwrap();
        assert!((bounds(&info) - bounds(&flat)).abs() < 1e-3 * bounds(&flat), "{line}");
        assert_eq!(info["triangle_count"], flat["triangle_count"], "{line}");
    }
    let nodes = document(&bench, "flat.glb")["nodes"].as_array().unwrap().clone();
    assert!(nodes.iter().all(|node| node.get("scale").or(node.get("matrix")).is_none()), "{nodes:?}");
    bench.json("build a.glb --flat --models fans -o flat.striata");
    bench.json("extract flat.striata --eye 0,0,20 -o view.ply");
    let levels = bench.json("simplify a.glb --flat --placement optimal -o optimal.glb --triangles 100");
    assert!(levels["triangle_count"].as_u64().unwrap() <= 100);
}

#[test]
fn one_level_of_a_scene_is_fitted_unless_something_refers_to_vertices() {
    let bench = bench_of(&scenes::hierarchy());
    let rms = |flags: &str, placement: &str| {
        let level = bench.json(&format!("simplify a.glb -o level.glb --ratio 0.2 {flags}"));
        assert_eq!(level["placement"].as_str().unwrap_or("subset"), placement, "{flags}");
        let distance = bench.json("distance a.glb level.glb");
        let count = level["triangle_count"].as_u64().expect("a count");
        (count, distance["rms"].as_f64().expect("a distance"))
    };
    let (count, fitted) = rms("", "optimal");
    assert_eq!((count, fitted), rms("--placement optimal", "optimal"));
    for flags in ["--placement subset", "--certify", "--lock-boundary"] {
        let (subset_count, subset) = rms(flags, "subset");
        // Guaranteed errors are others, and distribute a few triangles differently.
        let allowed = if flags == "--certify" { 4 } else { 0 };
        assert!(count.abs_diff(subset_count) <= allowed, "{flags}: {count} and {subset_count}");
        assert!(fitted < 0.8 * subset, "{flags}: {fitted} against {subset}");
    }
    let chain = bench.json("simplify a.glb -o b.glb --levels 50%,20% --lod-chain");
    assert!(chain.get("placement").is_none(), "{chain}");
    let message = bench.refused("simplify a.glb -o c.glb --ratio 0.5 --certify --placement optimal");
    assert!(message.contains("or --certify"), "{message}");
}

#[test]
fn meshes_with_skins_keep_their_vertices() {
    let bench = bench_of(&scenes::skinned());
    let level = bench.json("simplify a.glb -o level.glb --ratio 0.5");
    assert_eq!(level["placement"], "subset");
    let run = bench.run("simplify a.glb -o level.glb --ratio 0.5 --placement optimal").success();
    let text = String::from_utf8_lossy(&run.get_output().stderr).into_owned();
    assert!(text.contains("1 mesh with skins or morph targets"), "{text}");
}

#[test]
fn options_for_one_mesh_are_refused_with_a_hint() {
    let bench = bench_of(&scenes::hierarchy());
    bench.json("build a.glb -o a.striata");
    for (line, flag) in [
        ("build a.glb -o b.striata --models fans", "--models"),
        ("build a.glb -o b.striata --order hausdorff", "--order hausdorff"),
        ("extract a.striata -o b.glb --ratio 0.5 --as fans", "--as fans"),
        ("extract a.striata -o b.glb --ratio 0.5 --model mts", "--model"),
        ("encode a.glb -o b.striata", ".striata"),
        ("extract a.glb -o b.glb --ratio 0.5", "without levels"),
        ("simplify a.glb -o b.ply --levels 50% --lod-chain", "--lod-chain"),
    ] {
        let message = bench.refused(line);
        assert!(message.contains(flag) && message.contains("hint:"), "{line}: {message}");
    }
    assert_eq!(bench.names(), ["a.glb", "a.striata"], "a refused run leaves no output");
}

#[test]
fn every_prefix_of_a_stream_is_a_scene() {
    let bench = bench_of(&scenes::hierarchy());
    let report = bench.json("encode a.glb -o a.stri");
    let stream = bench.read("a.stri");
    let drawable = report["sizes"]["drawable_at"].as_u64().unwrap() as usize;
    let full = bench.json("decode a.stri -o whole.glb")["triangle_count"].as_u64().unwrap();
    let mut last = 0;
    for length in [drawable, (drawable + stream.len()) / 2, stream.len() - 1, stream.len()] {
        bench.write("cut.stri", &stream[..length]);
        let decoded = bench.json("decode cut.stri -o cut.glb");
        let count = decoded["triangle_count"].as_u64().unwrap();
        assert!(count >= last && count <= full, "{count} triangles after {length} bytes");
        let facts = bench.json("info cut.stri")["scene"].clone();
        assert_eq!(facts["is_complete"], length == stream.len());
        assert_eq!(facts["instance_count"], 4);
        last = count;
    }
    assert_eq!(last, full);
    bench.write("cut.stri", &stream[..drawable]);
    let short = bench.json(&format!("decode cut.stri -o cut.glb --triangles {full}"));
    assert_eq!(short["shortfall"], "the input ends before this level");
    let by_error = bench.json("decode cut.stri -o cut.glb --error 1e-9");
    assert_eq!(by_error["shortfall"], "the input ends before this level");
    assert!(bench.refused("extract cut.stri -o x.glb --error 1e-9 --strict").contains("--strict"));
    for length in [0, 20, drawable / 2, drawable - 1] {
        bench.write("head.stri", &stream[..length]);
        assert!(bench.refused("decode head.stri -o x.glb").contains("head.stri"), "{length} bytes");
    }
    assert!(!bench.names().contains(&"x.glb".to_owned()));
}

#[test]
fn a_glb_with_streams_opens_coarse_and_decodes_in_full() {
    let bench = bench_of(&scenes::skinned());
    let full = bench.json("info a.glb")["triangle_count"].clone();
    bench.json("encode a.glb -o streams.glb --lossless");
    assert_eq!(document(&bench, "streams.glb")["extensionsUsed"], json!(["STRIATA_lod"]));
    bench.json("decode streams.glb -o decoded.glb");
    assert_eq!(document(&bench, "decoded.glb"), document(&bench, "a.glb"));
    assert_eq!(bench.json("info decoded.glb")["triangle_count"], full);
    let facts = bench.json("info streams.glb");
    assert!(facts["scene"]["levels"]["step_count"].as_u64().unwrap() > 100);
    assert_eq!(facts["triangle_count"], full);
    let level = bench.json("extract streams.glb -o level.glb --ratio 0.25");
    assert!(level["triangle_count"].as_u64().unwrap() * 4 <= full.as_u64().unwrap());
    // The name of the extension may occur anywhere.
    let mut named = scenes::skinned();
    named.document["nodes"][0]["name"] = json!("STRIATA_lod");
    bench.write("named.glb", named.to_glb());
    assert_eq!(bench.json("convert named.glb x.glb")["triangle_count"], full);
    // A mesh without nodes becomes a scene, too.
    bench.json("encode shape:torus -o torus.glb");
    assert_eq!(
        bench.json("decode torus.glb -o torus-full.glb")["triangle_count"],
        bench.json("info shape:torus")["triangle_count"]
    );
}

#[test]
fn views_are_fine_where_the_camera_is() {
    let bench = bench_of(&scenes::hierarchy());
    bench.json("build a.glb -o a.striata");
    let count = |line: &str| bench.json(line)["triangle_count"].as_u64().unwrap();
    let near = count("extract a.striata -o near.glb --eye 0,0,20 --pixels 1");
    let far = count("extract a.striata -o far.glb --eye 0,0,2000 --pixels 1");
    let some = count(&format!("extract a.striata -o some.glb --eye 0,0,20 --triangles {}", near / 2));
    assert!(far < near && some <= near / 2 && some > far, "{near}, {far}, {some}");
    assert_eq!(document(&bench, "near.glb")["nodes"], document(&bench, "a.glb")["nodes"]);
}

#[test]
fn chains_contain_all_levels_in_one_file() {
    let bench = bench_of(&scenes::hierarchy());
    let report = bench.json("simplify a.glb -o chain.glb --levels 50%,10% --lod-chain");
    assert_eq!(report["levels"].as_array().unwrap().len(), 2);
    bench.json("build a.glb -o a.striata");
    bench.json("extract a.striata -o extracted.glb --levels 50%,10% --lod-chain --meshopt");
    bench.json("build shape:torus -o torus.striata");
    bench.json("extract torus.striata -o torus.glb --levels 50%,10% --lod-chain");
    let flat = bench.json("simplify a.glb --flat -o flat.glb --levels 50%,10% --lod-chain");
    assert_eq!(flat["levels"][1]["path"], "flat.glb");
    let mut without_scenes = scenes::skinned();
    without_scenes.document.as_object_mut().unwrap().remove("scenes");
    without_scenes.document.as_object_mut().unwrap().remove("scene");
    bench.write("b.glb", without_scenes.to_glb());
    bench.json("simplify b.glb -o b-chain.glb --levels 50%,10% --lod-chain");
    let shown = |name: &str| bench.json(&format!("info {name}"))["triangle_count"].clone();
    assert_eq!(shown("b-chain.glb"), shown("b.glb"), "only the full mesh is shown");
    for name in ["chain.glb", "extracted.glb", "torus.glb", "flat.glb", "b-chain.glb"] {
        let root = document(&bench, name);
        let used = root["extensionsUsed"].as_array().unwrap();
        assert!(used.iter().any(|extension| extension == "MSFT_lod"), "{name}");
        let nodes = root["nodes"].as_array().unwrap();
        let chains = nodes.iter().filter(|node| node.pointer("/extensions/MSFT_lod/ids").is_some());
        assert!(chains.count() > 0, "{name}");
    }
}

#[test]
fn textures_are_only_changed_on_request() {
    let bench = bench_of(&scenes::hierarchy());
    let image = |name: &str| bench.json(&format!("info {name}"))["scene"]["images"][0].clone();
    bench.json("simplify a.glb -o same.glb --ratio 0.5");
    assert_eq!(image("same.glb"), image("a.glb"));
    let said = bench.run("convert a.glb webp.glb --texture-format webp").success();
    let said = String::from_utf8_lossy(&said.get_output().stderr).into_owned();
    assert!(said.contains("textures: 1 image re-encoded"), "{said}");
    assert_eq!(image("webp.glb")["mime_type"], "image/webp");
    for verb in ["build a.glb -o b.striata", "encode a.glb -o b.stri", "simplify a.glb -o b.glb --ratio 1"] {
        bench.json(&format!("{verb} --texture-format jpeg --texture-max 1 --texture-quality 50"));
    }
    for name in ["b.striata", "b.stri", "b.glb"] {
        assert_eq!(image(name)["mime_type"], "image/jpeg", "{name}");
    }
    bench.write("m.mtl", "newmtl m\nmap_Kd t.png\n");
    bench.write("t.png", scenes::PNG);
    bench.write("m.obj", "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nusemtl m\nf 1/1 2/1 3/1\n");
    bench.json("convert m.obj m.glb --texture-format webp");
    assert_eq!(image("m.glb")["mime_type"], "image/webp");
    bench.json("encode m.obj -o m.stri");
    assert_eq!(image("m.stri")["mime_type"], "image/png", "a textured OBJ is streamed with its textures");
}

#[test]
fn verbs_for_one_mesh_take_scenes_as_one_mesh() {
    let bench = bench_of(&scenes::hierarchy());
    bench.json("build a.glb -o a.striata");
    bench.json("encode a.glb -o a.stri --lossless");
    let full = bench.json("strip a.glb")["triangle_count"].clone();
    for name in ["a.striata", "a.stri"] {
        assert_eq!(bench.json(&format!("strip {name}"))["triangle_count"], full, "{name}");
        let distance = bench.json(&format!("distance a.glb {name} --samples 2000"));
        assert!(distance["max"].as_f64().unwrap() < 1e-4, "{name}: {distance}");
        bench.json(&format!("render {name} -o {name}.png --size 64x64"));
    }
}
