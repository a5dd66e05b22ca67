//! `compare --parts assets`: the report has every requested row, with plausible values.

use std::f64::consts::PI;

use serde_json::Value;

use crate::workbench::{Workbench, assert_keys};

fn number(row: &Value, key: &str) -> f64 {
    row[key].as_f64().unwrap_or_else(|| panic!("no number {key} in {row}"))
}

fn levels(report: &Value) -> &[Value] {
    report["meshes"][0]["assets"]["levels"].as_array().map_or(&[], Vec::as_slice)
}

const SEGMENTS: usize = 64;
const RINGS: usize = 32;

/// A barrel with 4,096 triangles, open at both ends, with normals and a UV chart whose seam runs from end
/// to end.
fn barrel() -> String {
    let mut text = String::new();
    let rows = || (0..=RINGS).map(|ring| ring as f64 / RINGS as f64);
    for y in rows() {
        // The radius follows half a sine wave, and the normal is perpendicular to its slope.
        let (bulge, slope) = ((PI * y).sin(), PI * (PI * y).cos());
        for segment in 0..SEGMENTS {
            let (sine, cosine) = (2.0 * PI * segment as f64 / SEGMENTS as f64).sin_cos();
            let (radius, length) = (0.5 + 0.2 * bulge, (1.0 + (0.2 * slope).powi(2)).sqrt());
            text.push_str(&format!("v {} {y} {}\n", radius * cosine, radius * sine));
            text.push_str(&format!("vn {} {} {}\n", cosine / length, -0.2 * slope / length, sine / length));
        }
    }
    for y in rows() {
        (0..=SEGMENTS).for_each(|k| text.push_str(&format!("vt {} {y}\n", k as f64 / SEGMENTS as f64)));
    }
    let corner = |ring: usize, segment: usize| {
        let vertex = 1 + ring * SEGMENTS + segment % SEGMENTS;
        format!("{vertex}/{}/{vertex}", 1 + ring * (SEGMENTS + 1) + segment)
    };
    for (ring, segment) in (0..RINGS).flat_map(|ring| (0..SEGMENTS).map(move |segment| (ring, segment))) {
        let [a, b] = [corner(ring, segment), corner(ring, segment + 1)];
        let [c, d] = [corner(ring + 1, segment + 1), corner(ring + 1, segment)];
        text.push_str(&format!("f {a} {c} {b}\nf {a} {d} {c}\n"));
    }
    text
}

#[test]
fn levels_of_a_mesh_with_a_seam_have_all_values() {
    let bench = Workbench::new();
    bench.write("barrel.obj", barrel());
    let report =
        bench.json("compare barrel.obj --parts assets --shares 50,5 --contenders striata --html page.html");
    let assets = &report["meshes"][0]["assets"];
    assert_eq!((&assets["has_normals"], &assets["has_uvs"]), (&true.into(), &true.into()));
    assert_eq!(levels(&report).len(), 2);
    for (row, percent) in levels(&report).iter().zip([50.0, 5.0]) {
        assert_keys(row, &["contender", "triangle_count", "target_count", "max", "error", "secs"]);
        assert_eq!((number(row, "percent"), &row["is_reached"]), (percent, &true.into()), "{row}");
        let (mean, tail) = (number(row, "uv_mean"), number(row, "uv_p95"));
        assert!(0.0 < mean && mean <= tail && tail < 0.05, "{row}");
        assert!(number(row, "normal_p95_degrees") < 20.0 && number(row, "same_side_share") > 0.99, "{row}");
        assert!(number(row, "rms") < 0.02 && number(row, "gray_rms") < 30.0, "{row}");
        assert!((0.9..1.01).contains(&number(row, "silhouette")), "{row}");
        assert!((0.3..1.5).contains(&number(row, "error_ratio")), "{row}");
    }
    let [fine, coarse] = [0, 1].map(|at| &levels(&report)[at]);
    for key in ["rms", "normal_mean_degrees", "gray_rms"] {
        assert!(number(fine, key) < number(coarse, key), "{key}");
    }
    let page = String::from_utf8(bench.read("page.html")).expect("a page");
    assert!(page.contains("Levels next to other simplifiers") && page.contains("UV difference by triangles"));
}

#[test]
fn contenders_that_cannot_run_are_noted() {
    let bench = Workbench::new();
    let arguments =
        "compare shape:torus --parts assets --shares 10 --contenders striata,gltfpack,gltfpack-sp --json";
    let assert = bench.command(arguments).env("PATH", "").assert().success();
    let report: Value = serde_json::from_slice(&assert.get_output().stdout).expect("a report");
    assert_eq!(levels(&report).len(), 1);
    let notes = report["meshes"][0]["assets"]["notes"].as_array().expect("notes");
    assert_eq!(notes.len(), 1, "{notes:?}");
    assert!(notes[0].as_str().is_some_and(|note| note.contains("left out")), "{notes:?}");
    assert!(report.get("assets_summary").is_none(), "there is nothing to compare with");
    // The torus has neither normals nor texture coordinates, so smooth normals are compared.
    let row = &levels(&report)[0];
    assert!(row["uv_mean"].is_null() && number(row, "normal_mean_degrees") > 0.0, "{row}");
}

#[test]
fn fitted_levels_are_closer_than_those_of_kept_vertices() {
    let bench = Workbench::new();
    bench.write("barrel.obj", barrel());
    let report =
        bench.json("compare barrel.obj --parts assets --shares 20 --contenders striata,striata-subset");
    let [fitted, kept] = [0, 1].map(|at| &levels(&report)[at]);
    assert_eq!([fitted, kept].map(|row| &row["contender"]), ["striata", "striata-subset"]);
    assert!(number(fitted, "rms") < 0.9 * number(kept, "rms"), "{fitted} {kept}");
}

#[cfg(feature = "peers")]
#[test]
fn meshoptimizer_takes_part_and_is_summarized() {
    let bench = Workbench::new();
    bench.write("barrel.obj", barrel());
    let contenders = "striata,meshoptimizer,meshoptimizer-permissive";
    let report =
        bench.json(&format!("compare barrel.obj --parts assets --shares 20 --contenders {contenders}"));
    let names: Vec<&str> = levels(&report).iter().filter_map(|row| row["contender"].as_str()).collect();
    assert_eq!(names.join(","), contenders);
    assert!(levels(&report).iter().all(|row| row["is_reached"] == true));
    let summary = report["assets_summary"].as_array().expect("a summary");
    assert_eq!(summary.len(), 8);
    for row in summary {
        assert_eq!((&row["against"], &row["level_count"]), (&"meshoptimizer".into(), &1.into()), "{row}");
        assert!(number(row, "ratio") > 0.0 && number(row, "worse_count") <= 1.0, "{row}");
    }
}

#[test]
fn shares_and_names_are_checked() {
    let bench = Workbench::new();
    for wrong in ["--shares 0", "--shares 100", "--shares many", "--contenders nobody"] {
        bench.command(&format!("compare shape:cube --parts assets {wrong}")).assert().failure();
    }
}
