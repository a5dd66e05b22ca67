//! `info --models`: the size of each model of a mesh.

use serde_json::Value;

use crate::workbench::{Workbench, assert_keys};

const NAMES: [&str; 5] = ["lodstrips", "mts", "fans", "patterns", "progressive"];

/// Returns the costs of all models, in order.
fn costs(bench: &Workbench, file: &str) -> Vec<Value> {
    let report = bench.json(&format!("info {file} --models"));
    let costs = report["model_costs"].as_array().expect("a list").clone();
    assert_eq!(costs.iter().map(|cost| cost["name"].as_str().expect("a name")).collect::<Vec<_>>(), NAMES);
    costs
}

fn text(bench: &Workbench, arguments: &str) -> String {
    let assert = bench.run(arguments).success();
    String::from_utf8_lossy(&assert.get_output().stdout).into_owned()
}

#[test]
fn sizes_are_those_of_separate_builds() {
    let bench = Workbench::with_ball();
    for cost in costs(&bench, "sphere.obj") {
        assert_keys(&cost, &["name", "bytes", "bytes_per_vertex", "instance_bytes", "build_secs"]);
        let name = cost["name"].as_str().expect("a name");
        let built = bench.json(&format!("build sphere.obj -o one.striata --models {name}"));
        assert_eq!(cost["bytes"], built["models"][name]["bytes"], "{name}");
        assert_eq!(cost["bytes_per_vertex"], built["models"][name]["bytes_per_vertex"], "{name}");
        assert!(cost["build_secs"].as_f64().is_some_and(|secs| (0.0..60.0).contains(&secs)), "{cost}");
        let instance_bytes = cost["instance_bytes"].as_u64();
        if name == "progressive" {
            assert!(cost["instance_bytes"].is_null(), "a stream has no instances: {cost}");
        } else {
            assert!(instance_bytes.is_some_and(|bytes| bytes > 0), "{cost}");
        }
        if name == "fans" {
            let step_count = built["step_count"].as_u64().expect("a count");
            let bit_bytes = 8 * step_count.div_ceil(64);
            assert!(instance_bytes.is_some_and(|bytes| bytes < bit_bytes + 64), "one bit per step: {cost}");
        }
    }
}

#[test]
fn files_with_levels_and_shapes_have_sizes_too() {
    let bench = Workbench::with_ball();
    bench.json("encode sphere.obj -o ball.stri");
    for file in ["ball.striata", "ball.stri"] {
        for cost in costs(&bench, file) {
            assert!(cost["bytes"].as_u64().is_some_and(|bytes| bytes > 100), "{file}: {cost}");
        }
    }
    costs(&bench, "shape:cube");
    let report = bench.json("info ball.striata");
    assert!(report.get("model_costs").is_none(), "only with --models: {report}");
    assert_keys(&bench.json("info ball.striata --models"), &["models.lodstrips.parts", "model_costs"]);
}

#[test]
fn the_table_has_a_row_for_each_model() {
    let bench = Workbench::with_ball();
    let report = text(&bench, "info sphere.obj --models");
    for name in NAMES {
        let row = report.lines().find(|line| line.starts_with(&format!("{name} if built")));
        let row = row.unwrap_or_else(|| panic!("{name} is missing:\n{report}"));
        assert!(row.contains("bytes per vertex") && row.contains("built in"), "{row}");
        assert_eq!(row.contains("per instance"), name != "progressive", "{row}");
    }
    assert!(!text(&bench, "info sphere.obj").contains("if built"));
}

#[test]
fn models_of_a_mesh_of_which_nothing_is_left_are_refused() {
    let bench = Workbench::new();
    bench.write("nan.off", "OFF\n4 2 0\n0 0 0\n1 0 0\n0 nan 0\n1 1 0\n3 0 1 2\n3 1 3 2\n");
    for verb in ["info nan.off", "info nan.off --models"] {
        let message = bench.refused(verb);
        assert!(message.starts_with("error: nan.off: ") && message.contains("NaN"), "{message}");
    }
}
