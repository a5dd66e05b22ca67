//! `build` with a GLB output: plain glTF files in refinement order, or with clusters.

use serde_json::{Value, json};

use crate::workbench::{Workbench, asset, sphere};

fn arm() -> Workbench {
    let bench = Workbench::new();
    std::fs::copy(asset("arm.glb"), bench.path("arm.glb")).expect("the folder is ours");
    bench
}

#[test]
fn an_ordered_file_is_the_scene_with_the_tables_of_the_report() {
    let bench = arm();
    let report = bench.json("build arm.glb -o ordered.glb --ranges 4");
    let number = |key: &str| report[key].as_u64().expect("a number") as usize;
    assert_eq!(number("plain_bytes") + number("order_bytes") + number("range_bytes"), number("output_bytes"));
    assert!(number("order_bytes") * 100 < number("plain_bytes") * 12, "{report}");
    let bytes = bench.read("ordered.glb");
    assert_eq!(bytes.len(), number("output_bytes"));
    let length = u32::from_le_bytes(bytes[12..16].try_into().expect("four bytes")) as usize;
    let document: Value = serde_json::from_slice(&bytes[20..20 + length]).expect("a document");
    for (mesh, entry) in document["meshes"].as_array().expect("meshes").iter().enumerate() {
        for (place, primitive) in entry["primitives"].as_array().expect("primitives").iter().enumerate() {
            let order = &primitive["extensions"]["STRIATA_order"];
            let tables = &report["meshes"][mesh]["primitives"][place];
            assert_eq!((&order["levels"], &order["ranges"]), (&tables["levels"], &tables["ranges"]));
            assert_eq!(tables["ranges"].as_array().map(Vec::len), Some(4));
        }
    }
    let facts = |name: &str| bench.json(&format!("info {name}"));
    let (plain, ordered) = (facts("arm.glb"), facts("ordered.glb"));
    for key in ["triangle_count", "vertex_count", "diagonal"] {
        assert_eq!(ordered[key], plain[key], "{key}");
    }
    assert_eq!(ordered["scene"]["node_count"], plain["scene"]["node_count"]);
    // An extension that no longer matches a changed file is left out, with a warning.
    let converted = bench.json("convert ordered.glb again.glb");
    assert!(converted["warnings"].to_string().contains("STRIATA_order"), "{converted}");
    assert!(!String::from_utf8_lossy(&bench.read("again.glb")).contains("STRIATA_order"));
}

#[test]
fn meshes_get_normals_a_material_and_a_coarsest_level() {
    let bench = Workbench::new();
    bench.write("ball.obj", sphere(20, 30));
    let report = bench.json("build ball.obj -o ball.glb --base 100");
    let levels = report["meshes"][0]["primitives"][0]["levels"].as_array().expect("levels").clone();
    assert_eq!(levels[0][1], report["triangle_count"]);
    let coarsest = levels[levels.len() - 1][1].as_u64().expect("a number");
    assert!((1..=100).contains(&coarsest), "{levels:?}");
    assert_eq!(
        (&report["range_bytes"], report["meshes"][0]["primitives"][0].get("ranges")),
        (&json!(0), None)
    );
    let text = String::from_utf8_lossy(&bench.read("ball.glb")).into_owned();
    assert!(text.contains("NORMAL") && text.contains("pbrMetallicRoughness"));
    let assert = bench.run("build ball.obj -o ball.glb").success();
    let summary = String::from_utf8_lossy(&assert.get_output().stderr).into_owned();
    assert!(summary.contains("(+") && summary.contains("% of the plain file)"), "{summary}");
}

#[test]
fn the_file_of_the_python_tests_is_current() {
    let bench = Workbench::new();
    bench.run("build shape:moebius -o ordered.glb --ranges 4").success();
    let known = asset("../crates/striata-py/tests/ordered.glb");
    assert_eq!(bench.read("ordered.glb"), std::fs::read(known).expect("the file is in the repository"));
}

#[test]
fn flags_of_the_other_format_are_refused_by_name() {
    let bench = arm();
    for (flags, name) in [
        ("-o x.glb --models fans", "--models"),
        ("-o x.glb --stream", "--stream"),
        ("-o x.glb --strips greedy", "--strips"),
        ("-o x.glb --bits 9", "--bits"),
        ("-o x.glb --overlap-errors", "--overlap-errors"),
        ("-o x.glb --order hausdorff", "--order"),
        ("-o x.glb --retriangulation free", "--retriangulation"),
        ("-o x.glb --paged", "paged"),
        ("-o x.glb.gz", "already compressed"),
        ("-o x.gltf", "`build` writes .striata and .glb files"),
        ("-o x.striata --ranges 4", "--ranges is for .glb outputs"),
        ("--ranges 4", "--ranges is for .glb outputs"),
        ("-o x.striata --clusters", "--clusters is for .glb outputs"),
        ("-o x.glb --clusters --base 9", "--base is not for --clusters"),
        ("-o x.glb --clusters --max-error 1%", "--max-error is not for --clusters"),
        ("-o x.glb --clusters --certify", "--certify is not for --clusters"),
    ] {
        let message = bench.refused(&format!("build arm.glb {flags}"));
        assert!(message.contains(name) && message.contains("hint:"), "{flags}: {message}");
    }
    assert_eq!(bench.names(), ["arm.glb"]);
}

#[test]
fn clusters_are_stored_in_a_plain_file() {
    let bench = arm();
    let report = bench.json("build arm.glb -o clusters.glb --clusters=32");
    let number = |key: &str| report[key].as_u64().expect("a number") as usize;
    assert_eq!(number("plain_bytes") + number("cluster_bytes"), number("output_bytes"));
    let (full, all) = (number("triangle_count"), number("cluster_triangle_count"));
    assert!(number("base_triangle_count") * 4 < full && full < all && all < 3 * full, "{report}");
    assert!(number("cluster_count") * 32 >= all && number("group_count") < number("cluster_count"));
    assert!(report["error_max"].as_f64().expect("a number") > 0.0);
    let facts = |name: &str| bench.json(&format!("info {name}"));
    let (plain, clustered) = (facts("arm.glb"), facts("clusters.glb"));
    for key in ["triangle_count", "vertex_count", "diagonal"] {
        assert_eq!(clustered[key], plain[key], "{key}");
    }
    let converted = bench.json("convert clusters.glb again.glb");
    assert!(converted["warnings"].to_string().contains("STRIATA_clusters"), "{converted}");
    assert!(!String::from_utf8_lossy(&bench.read("again.glb")).contains("STRIATA_clusters"));
    // A single mesh, with the default size.
    bench.write("ball.obj", sphere(20, 30));
    let ball = bench.json("build ball.obj -o ball.glb --clusters");
    assert_eq!(ball["triangle_count"], facts("ball.obj")["triangle_count"]);
    let summary = bench.run("build ball.obj -o ball.glb --clusters").success();
    let summary = String::from_utf8_lossy(&summary.get_output().stderr).into_owned();
    assert!(summary.contains("clusters") && summary.contains("groups"), "{summary}");
}

#[test]
fn files_for_godot_have_all_levels_and_say_what_is_left_out() {
    let bench = arm();
    let run = bench.run("build arm.glb -o arm.tscn").success();
    let said = String::from_utf8_lossy(&run.get_output().stderr).into_owned();
    let text = String::from_utf8(bench.read("arm.tscn")).expect("text");
    assert!(text.starts_with("[gd_scene format=4]"));
    assert!(text.contains("type=\"MeshInstance3D\" parent=\".\"") && text.contains("\"lods\": ["));
    let has_animations = String::from_utf8_lossy(&bench.read("arm.glb")).contains("\"animations\"");
    assert_eq!(said.contains("animations are left out"), has_animations, "{said}");
    bench.write("ball.obj", sphere(20, 30));
    let report = bench.json("build ball.obj -o ball.tres --ranges 3");
    let text = String::from_utf8(bench.read("ball.tres")).expect("text");
    assert_eq!(report["output_bytes"].as_u64(), Some(text.len() as u64));
    let levels = text.split("\"lods\": [").nth(1).and_then(|rest| rest.split("],").next()).expect("levels");
    assert_eq!(levels.matches("PackedByteArray").count(), 2, "besides the full mesh");
    for (arguments, expected) in [
        ("arm.glb -o arm.tres", "a .tres file has one mesh"),
        ("ball.obj -o ball.tscn --clusters", "--clusters is for .glb outputs"),
        ("ball.obj -o ball.tscn --models fans", "--models is for .striata files"),
    ] {
        let run = bench.run(&format!("build {arguments}")).failure();
        let said = String::from_utf8_lossy(&run.get_output().stderr).into_owned();
        assert!(said.contains(expected), "{said}");
    }
}
