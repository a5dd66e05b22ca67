//! `compare --parts rate`: distances after a number of bytes, and file sizes.

use serde_json::Value;

use crate::workbench::{Workbench, assert_keys, sphere};

fn number(report: &Value, key: &str) -> f64 {
    report[key].as_f64().unwrap_or_else(|| panic!("no number {key} in {report}"))
}

#[test]
fn distances_are_reported_for_numbers_of_bytes() {
    let bench = Workbench::new();
    bench.write("sphere.obj", sphere(20, 20));
    let line = "compare sphere.obj --rate --rate-bits 10 --rate-efforts fast,compact --html rate.html --json";
    let assert = bench.command(line).env("PATH", "").assert().success();
    let report: Value = serde_json::from_slice(&assert.get_output().stdout).expect("JSON on stdout");
    let mesh = &report["meshes"][0];
    assert_keys(mesh, &["rate_bits", "rate", "sizes"]);
    let rows = |name: &str| -> Vec<&Value> {
        let rows = mesh["rate"].as_array().expect("rows").iter();
        rows.filter(|row| row["name"] == name).collect()
    };
    for name in ["striata fast", "striata compact", "levels, striata compact"] {
        let rows = rows(name);
        assert!(rows.len() >= 3, "{name}: {rows:?}");
        for pair in rows.windows(2) {
            assert!(number(pair[0], "bytes") <= number(pair[1], "bytes"), "{name}");
            assert!(number(pair[0], "triangle_count") <= number(pair[1], "triangle_count"), "{name}");
        }
        let [first, last] = [rows[0], rows[rows.len() - 1]];
        assert_eq!(last["triangle_count"], 800);
        for key in ["max", "rms"] {
            // One grid step is about 0.06 % of the diagonal.
            assert!(
                number(last, key) < 0.06 && number(last, key) < 0.2 * number(first, key),
                "{name}: {key}"
            );
        }
    }
    let sizes = mesh["sizes"].as_array().expect("rows");
    for bits in [12, 14] {
        let row = sizes.iter().find(|row| row["name"] == "striata compact" && row["bits"] == bits);
        assert!(row.is_some_and(|row| number(row, "bytes") > 100.0 && row.get("ratio_to_draco").is_none()));
    }
    let page = String::from_utf8(bench.read("rate.html")).expect("text");
    assert!(page.contains("Distance after a number of bytes") && page.contains("RMS, % of the diagonal"));
    let line = "compare sphere.obj --rate --rate-sizes --rate-efforts fast --json";
    let assert = bench.command(line).env("PATH", "").assert().success();
    let report: Value = serde_json::from_slice(&assert.get_output().stdout).expect("JSON on stdout");
    let mesh = &report["meshes"][0];
    assert!(mesh["rate"].as_array().is_some_and(Vec::is_empty));
    let fast = |row: &&Value| row["name"] == "striata fast";
    assert_eq!(mesh["sizes"].as_array().map(|rows| rows.iter().filter(fast).count()), Some(2));
    assert!(bench.refused("compare sphere.obj --rate --parts strips").contains("--parts"));
}
