//! `compare --parts models`: every model has every key, on meshes of all kinds.

use serde_json::Value;

use crate::workbench::{Workbench, assert_keys};

const MODELS: [&str; 16] = [
    "lodstrips",
    "lodstrips-staged",
    "mts",
    "fans",
    "patterns",
    "lodstrips-original",
    "lodstrips-published",
    "mts-graph",
    "skip-strips",
    "progressive-meshes",
    "progressive-meshes-hoppe",
    "ordered-meshes",
    "loop-patterns",
    "multi-triangulation",
    "discrete-5",
    "discrete-10",
];

/// The models that draw a list.
const LISTS: [&str; 7] = [
    "fans",
    "patterns",
    "progressive-meshes",
    "progressive-meshes-hoppe",
    "ordered-meshes",
    "loop-patterns",
    "multi-triangulation",
];

const QUICK: &str = "--parts models --model-strips greedy --frames 12";

fn rows(mesh: &Value) -> &[Value] {
    mesh["models"].as_array().expect("a list")
}

fn number(object: &Value, path: &str) -> f64 {
    let found = path.split('.').try_fold(object, |value, part| value.get(part));
    found.and_then(Value::as_f64).unwrap_or_else(|| panic!("no number {path} in {object}"))
}

#[test]
fn every_model_has_every_key() {
    let bench = Workbench::with_ball();
    let report = bench.json(&format!("compare sphere.obj {QUICK}"));
    let mesh = &report["meshes"][0];
    assert!(mesh.get("strips").is_none(), "strips were not requested");
    assert_eq!(
        (&mesh["models_of"]["triangle_count"], &mesh["models_of"]["vertex_count"]),
        (&512.into(), &258.into())
    );
    let plain = number(mesh, "models_of.plain_bytes");
    assert_eq!(plain, 12.0 * 258.0 + 4.0 * number(mesh, "models_of.strips.index_count"));
    let names: Vec<&str> = rows(mesh).iter().filter_map(|row| row["name"].as_str()).collect();
    assert_eq!(names, MODELS);
    for row in rows(mesh) {
        assert_keys(row, &["sweep_ns_per_step", "paper_bytes", "paper_bytes_per_vertex", "state_bytes"]);
        let parts = row["parts"].as_object().expect("an object");
        let bytes: f64 = parts.values().filter_map(Value::as_f64).sum();
        assert_eq!(number(row, "bytes"), bytes);
        assert_eq!(number(row, "total_bytes"), bytes + 12.0 * 258.0);
        // The JSON parser used here may lose a number's last digit.
        let is_near = |key: &str, expected: f64| (number(row, key) - expected).abs() < 1e-9 * expected;
        assert!(is_near("bytes_per_vertex", bytes / 258.0), "{row}");
        assert!(is_near("ratio_to_plain", (bytes + 12.0 * 258.0) / plain), "{row}");
        assert!(number(row, "seek_secs") >= 0.0 && number(row, "build_secs") > 0.0, "{row}");
        let has_few_levels = row["name"].as_str().is_some_and(|name| name.starts_with("discrete"));
        assert_eq!(row["sweep_ns_per_step"].is_null(), has_few_levels, "{row}");
    }
}

#[test]
fn walks_lead_from_the_full_mesh_to_the_base() {
    let bench = Workbench::with_ball();
    let report = bench.json(&format!("compare sphere.obj {QUICK}"));
    let mesh = &report["meshes"][0];
    let (step_count, base) =
        (number(mesh, "models_of.step_count"), number(mesh, "models_of.base_triangle_count"));
    for row in rows(mesh) {
        for pace in ["linear", "exponential"] {
            let walk = &row["walks"][pace];
            let (extract, sent) = (number(walk, "extract_secs"), number(walk, "extract_and_send_secs"));
            assert!(0.0 <= extract && extract <= sent, "{walk}");
            let series = walk["series"].as_object().expect("an object");
            for (name, values) in series {
                let values = values.as_array().expect("a list");
                assert!(values.len() == 13 && values.iter().all(Value::is_number), "{name}: {values:?}");
            }
            let at = |name: &str, i: usize| series[name][i].as_f64().expect("a number");
            assert_eq!((at("split_count", 0), at("triangle_count", 0)), (step_count, 512.0), "{walk}");
            let is_triangles = LISTS.iter().any(|name| row["name"] == *name);
            assert_eq!(at("index_count", 0) == 3.0 * 512.0, is_triangles, "{walk}");
            assert_eq!(at("strip_count", 0) == 0.0, is_triangles, "{walk}");
            let has_few_levels = row["sweep_ns_per_step"].is_null();
            assert!(has_few_levels || at("triangle_count", 12) == base, "{walk}");
            assert!(number(walk, "triangle_count") < 512.0 && number(walk, "index_count") > 0.0, "{walk}");
        }
        // The exponential walk drops more detail while it is near the object.
        let triangles = |pace: &str| number(row, &format!("walks.{pace}.triangle_count"));
        assert!(triangles("exponential") < triangles("linear"), "{row}");
    }
}

#[test]
fn only_named_models_are_measured() {
    let bench = Workbench::with_ball();
    let report = bench.json(&format!("compare sphere.obj ball.striata {QUICK} --models discrete-5,mts,mts"));
    for mesh in report["meshes"].as_array().expect("a list") {
        let names: Vec<&str> = rows(mesh).iter().filter_map(|row| row["name"].as_str()).collect();
        assert_eq!(names, ["mts", "discrete-5"]);
    }
}

#[test]
fn tiny_meshes_have_rows() {
    let bench = Workbench::new();
    bench.write("empty.off", "OFF\n0 0 0\n");
    bench.write("points.off", "OFF\n0 0 0\n");
    bench.write("one.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
    bench.write("nowhere.off", "OFF\n3 1 0\n0 0 0\n0 0 0\n0 0 0\n3 0 1 2\n");
    for mesh in ["empty.off", "points.off", "one.off", "nowhere.off"] {
        let report = bench.json(&format!("compare {mesh} --parts models --frames 1 --html page.html"));
        for row in rows(&report["meshes"][0]) {
            let sound = ["bytes", "ratio_to_plain", "seek_secs", "walks.linear.index_count"];
            assert!(sound.iter().all(|key| number(row, key) >= 0.0), "{mesh}: {row}");
        }
        assert_eq!(rows(&report["meshes"][0]).len(), MODELS.len(), "{mesh}");
    }
}

#[test]
fn seams_materials_and_one_sided_shapes_are_correct_in_all_models() {
    // The command itself checks every model against the oracle.
    let bench = Workbench::new();
    const LOOPS: &str = "loop-patterns";
    const HOPPE: &str = "progressive-meshes-hoppe";
    for (shape, refused) in [
        ("cylinder", &[(LOOPS, "one a position")][..]),
        ("two-materials", &[(LOOPS, "group")]),
        ("moebius", &[(HOPPE, "edge"), (LOOPS, "")]),
        ("grid", &[(LOOPS, "loops through one fragment")]),
        ("torus", &[]),
        ("klein-bottle", &[(HOPPE, "edge"), (LOOPS, "")]),
    ] {
        let line = format!("compare shape:{shape} {QUICK}");
        let mesh = &bench.json(&line)["meshes"][0];
        assert_eq!(mesh["name"], format!("shape:{shape}"));
        // The published patterns support only orientable surfaces with one group, no seams and few
        // overlaps per fragment; split records need oriented manifolds.
        let names: Vec<&str> = rows(mesh).iter().filter_map(|row| row["name"].as_str()).collect();
        let is_refused = |name: &str| refused.iter().any(|&(model, _)| model == name);
        assert!(names.iter().eq(MODELS.iter().filter(|name| !is_refused(name))), "{shape}: {names:?}");
        let refusals = mesh["models_refused"].as_array().expect("a list");
        assert_eq!(refusals.len(), refused.len(), "{shape}: {refusals:?}");
        if refused.is_empty() {
            continue;
        }
        let text_report = bench.run(&line).success();
        let text_report = String::from_utf8_lossy(&text_report.get_output().stdout).into_owned();
        for (refusal, (model, why)) in refusals.iter().zip(refused) {
            let reason = refusal["cannot_be_built"].as_str().expect("a reason");
            assert!(refusal["name"] == *model && reason.contains(why), "{shape}: {model}: {reason}");
            assert!(text_report.contains(&format!("{model} cannot be built: {reason}.")), "{text_report}");
        }
    }
}

#[test]
fn sphere_of_the_papers_is_compared_with_their_figures() {
    let bench = Workbench::new();
    let line = format!("compare shape:sphere shape:cube {QUICK} --models progressive-meshes-hoppe");
    let report = bench.json(&line);
    let papers = report["meshes"][0]["papers"].as_array().expect("a list");
    let row = |what: &str| papers.iter().find(|row| row["what"] == what).expect("a row");
    for (what, theirs) in [("vertices", 15_314.0), ("triangles", 30_624.0)] {
        assert_eq!((number(row(what), "theirs"), number(row(what), "ours")), (theirs, theirs));
    }
    let storage = row("PM, storage");
    assert_eq!((number(storage, "theirs"), &storage["source"]), (1.318, &"[BRR02] table 2".into()));
    let paper_bytes = number(&rows(&report["meshes"][0])[0], "short_paper_bytes");
    assert!((1e6 * number(storage, "ours") - paper_bytes).abs() < 0.01, "{storage}");
    assert!(row("MTS, storage")["ours"].is_null(), "MTS was not measured");
    assert_eq!(report["meshes"][1]["papers"], serde_json::json!([]), "no paper measured a cube");
    let text_report = bench.run(&line).success();
    let text_report = String::from_utf8_lossy(&text_report.get_output().stdout).into_owned();
    assert_eq!(text_report.matches("Compared with the papers").count(), 1, "{text_report}");
}

#[test]
fn page_with_all_parts_is_self_contained() {
    let bench = Workbench::with_ball();
    let line = "compare sphere.obj --model-strips greedy --frames 150 --seeds 1 --tunnels 3 --strips greedy";
    let assert = bench.run(&format!("{line} --html page.html")).success();
    let text_report = String::from_utf8_lossy(&assert.get_output().stdout).into_owned();
    for text in ["Models: ", "Linear walk, 150 frames", "Exponential walk", "Strips by the longest tunnel"] {
        assert!(text_report.contains(text), "no {text:?} in {text_report}");
    }
    let page = String::from_utf8(bench.read("page.html")).expect("text");
    assert_eq!((page.matches("<svg").count(), page.matches("<table>").count()), (11 + 17 + 3, 5 + 8 + 2));
    for model in MODELS {
        assert!(text_report.contains(model) && page.matches(model).count() >= 8, "{model}");
    }
    for outside in ["http", "src=\"", "{{", "@import"] {
        // The name of SVG's namespace is a URL that is never fetched.
        let found = page.replace("http://www.w3.org/2000/svg", "").contains(outside);
        assert!(!found, "{outside} in the page");
    }
    assert!(!page.contains("NaN") && !page.contains(">inf"));
}
