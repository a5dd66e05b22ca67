//! `caches`: misses of files.

use crate::workbench::{Workbench, assert_keys};

#[test]
fn every_file_has_its_misses() {
    let bench = Workbench::with_ball();
    let report = bench.json("caches sphere.obj sphere.obj");
    let files = report["files"].as_array().expect("a list");
    assert_eq!(files.len(), 2);
    for file in files {
        assert_keys(
            file,
            &["name", "triangle_count", "acmr_16", "meshoptimizer_acmr_16", "ratio", "first_use_share"],
        );
        assert_eq!((&file["name"], &file["triangle_count"]), (&"sphere.obj".into(), &512.into()));
        let acmr = file["acmr_16"].as_f64().expect("a number");
        assert!((0.5..3.0).contains(&acmr), "{acmr}");
        assert_eq!(file["ratio"].is_null(), cfg!(not(feature = "peers")));
    }
}
