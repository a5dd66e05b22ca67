//! `compare --parts patterns`: fragments of every source in every form, and extraction times.

use serde_json::Value;

use crate::workbench::{Workbench, assert_keys};

const SOURCES: [&str; 6] = ["quadric", "removal", "removal-collapse", "removal-strict", "edges", "triangles"];
/// Number of sources, the first ones, that remove one vertex in each step.
const PUBLISHED: usize = 4;
const MODELS: [&str; 3] = ["patterns", "multi-triangulation", "loop-patterns"];

fn list<'v>(object: &'v Value, key: &str) -> &'v [Value] {
    object[key].as_array().unwrap_or_else(|| panic!("no list {key} in {object}"))
}

fn number(object: &Value, key: &str) -> f64 {
    object[key].as_f64().unwrap_or_else(|| panic!("no number {key} in {object}"))
}

fn patterns(report: &Value, mesh: usize) -> &Value {
    &list(report, "meshes")[mesh]["patterns"]
}

#[test]
fn every_source_has_every_form() {
    let bench = Workbench::new();
    let report = bench.json("compare shape:terrain --parts patterns");
    assert!(report["meshes"][0].get("models").is_none() && report["meshes"][0].get("views").is_none());
    let report = patterns(&report, 0);
    let vertices = number(report, "vertex_count");
    let names: Vec<&str> = list(report, "sources").iter().filter_map(|row| row["source"].as_str()).collect();
    assert_eq!(names, SOURCES);
    for row in list(report, "sources").iter().take(PUBLISHED) {
        let fragments = number(row, "fragment_count");
        assert!(fragments > 0.99 * vertices - 8.0 && fragments < vertices, "{row}");
        assert!(number(row, "rule_count") >= 4.0 && number(row, "loop_rule_count") >= 4.0, "{row}");
        let overlaps = number(row, "overlaps_per_fragment");
        assert!((2.0..2.6).contains(&overlaps) && row["cannot_be_published"].is_null(), "{row}");
        let paper_bits = number(row, "paper_bits_per_fragment");
        assert!((paper_bits - (116.0 + 36.0 * overlaps)).abs() < 0.01, "{row}");
        for (bytes, bits, per_vertex) in [
            ("bytes", "bits_per_fragment", "bytes_per_vertex"),
            ("loop_bytes", "loop_bits_per_fragment", "loop_bytes_per_vertex"),
        ] {
            let bytes = number(row, bytes);
            assert!((8.0 * bytes / fragments - number(row, bits)).abs() < 1e-6, "{row}");
            assert!((bytes / vertices - number(row, per_vertex)).abs() < 1e-6, "{row}");
        }
        let sequential = number(row, "sequential_bits_per_fragment");
        assert!((44.0..46.0).contains(&sequential), "{row}");
        assert!(number(row, "sequential_bytes") > sequential * fragments / 8.0, "{row}");
        assert!(number(row, "bytes") < number(row, "loop_bytes"), "{row}");
        let ratio = (number(row, "multi_triangulation_bytes") - 4.0 * fragments) / number(row, "bytes");
        assert!(ratio > 6.0 && (ratio - number(row, "multi_triangulation_ratio")).abs() < 1e-6, "{row}");
        let explicit = number(row, "multi_triangulation_bytes_per_vertex");
        let ratio = explicit / number(row, "bytes_per_vertex_with_bounds");
        let found = number(row, "multi_triangulation_ratio_with_bounds");
        assert!(found > 6.0 && (ratio - found).abs() < 1e-6, "{row}");
        let errors = number(row, "bytes_per_vertex_with_overlap_errors");
        assert!(errors > number(row, "bytes_per_vertex_with_bounds"), "{row}");
        assert_keys(
            row,
            &[
                "multi_triangulation_bytes_per_vertex",
                "multi_triangulation_paper_bytes_per_vertex",
                "fragments_secs",
                "build_secs",
                "loop_build_secs",
                "multi_triangulation_build_secs",
                "overlap_count",
            ],
        );
    }
    // Small meshes need nearly as many rules as fragments.
    for row in &list(report, "sources")[PUBLISHED..] {
        assert!(number(row, "bits_per_fragment") < 1500.0 && number(row, "open_secs") > 0.0, "{row}");
        let form = |key| row[key].is_null() == row["cannot_be_general"].is_string();
        assert!(form("general_bits_per_fragment") && form("general_rule_count"), "{row}");
    }
    for row in list(report, "overlap_errors") {
        let [fragments, overlaps] = ["by_fragment", "by_overlap"].map(|key| number(row, key));
        assert!(overlaps > 0.0 && overlaps <= fragments, "{row}");
    }
    assert_eq!(list(report, "overlap_errors").len(), 4);
    assert_eq!(report["extracted_from"], "removal");
    let sizes: Vec<f64> =
        list(report, "extraction").iter().map(|row| number(row, "triangle_count")).collect();
    assert!(sizes.len() >= 4 && sizes.is_sorted_by(|a, b| a < b) && sizes[0] <= 1000.0, "{sizes:?}");
    assert_eq!(sizes.last(), Some(&number(report, "triangle_count")));
    for (row, triangles) in list(report, "extraction").iter().zip(sizes) {
        let names: Vec<&str> = list(row, "models").iter().filter_map(|time| time["name"].as_str()).collect();
        assert_eq!(names, MODELS);
        assert_eq!(row["error"].is_null(), triangles == number(report, "triangle_count"));
        for time in list(row, "models") {
            let secs = number(time, "secs");
            assert!(
                secs > 0.0 && (1e9 * secs / triangles - number(time, "ns_per_triangle")).abs() < 1e-3,
                "{row}"
            );
        }
    }
}

#[test]
fn unsupported_meshes_report_the_reason() {
    let bench = Workbench::new();
    let line = "compare shape:cylinder --parts patterns";
    let report = bench.json(line);
    for row in list(patterns(&report, 0), "sources") {
        assert!(
            row["cannot_be_published"].as_str().is_some_and(|why| why.contains("one a position")),
            "{row}"
        );
        for key in ["loop_bytes", "loop_rule_count", "sequential_bytes", "loop_build_secs"] {
            assert!(row[key].is_null(), "{key}: {row}");
        }
        assert!(number(row, "multi_triangulation_ratio") > 4.0, "{row}");
    }
    let sizes = list(patterns(&report, 0), "extraction").iter().map(|row| number(row, "triangle_count"));
    assert_eq!(sizes.max_by(f64::total_cmp), Some(number(patterns(&report, 0), "triangle_count")));
    assert!(list(patterns(&report, 0), "extraction").len() > 2);
    for row in list(patterns(&report, 0), "extraction") {
        let names: Vec<&str> = list(row, "models").iter().filter_map(|time| time["name"].as_str()).collect();
        assert_eq!(names, MODELS[..2]);
    }
    let text_report = bench.run(line).success();
    let text_report = String::from_utf8_lossy(&text_report.get_output().stdout).into_owned();
    assert_eq!(
        text_report.matches("The published form cannot represent ").count(),
        SOURCES.len(),
        "{text_report}"
    );
}

#[test]
fn tiny_meshes_have_patterns() {
    let bench = Workbench::with_ball();
    bench.write("empty.off", "OFF\n0 0 0\n");
    bench.write("points.off", "OFF\n0 0 0\n");
    bench.write("one.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
    bench.write("nowhere.off", "OFF\n3 1 0\n0 0 0\n0 0 0\n0 0 0\n3 0 1 2\n");
    let line =
        "compare empty.off points.off one.off nowhere.off sphere.obj --parts patterns --html page.html";
    let report = bench.json(line);
    for mesh in 0..5 {
        let report = patterns(&report, mesh);
        assert_eq!(list(report, "sources").len(), SOURCES.len());
        let last = list(report, "extraction").last().expect("the full mesh");
        assert_eq!(last["triangle_count"], report["triangle_count"]);
    }
    let page = String::from_utf8(bench.read("page.html")).expect("text");
    assert!(!page.contains("NaN") && !page.contains(">inf"));
    assert_eq!((page.matches("<svg").count(), page.matches("<table>").count()), (5 * 3, 5 * 2));
    let text_report = bench.run(line).success();
    let text_report = String::from_utf8_lossy(&text_report.get_output().stdout).into_owned();
    assert_eq!(
        text_report.matches("Extraction from the base by a condition on errors").count(),
        5,
        "{text_report}"
    );
}
