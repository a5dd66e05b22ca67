//! Snapshots of the `--help` output.

use crate::workbench::Workbench;

#[test]
fn every_verb_ends_with_two_examples() {
    for verb in ["compare", "poses", "caches", "bench-gpu"] {
        if verb == "bench-gpu" && cfg!(not(feature = "gpu")) {
            continue;
        }
        let bench = Workbench::new();
        let assert = bench.command(&format!("{verb} --help")).env("COLUMNS", "80").assert().success();
        let text = String::from_utf8_lossy(&assert.get_output().stdout).into_owned();
        let (_, examples) = text.split_once("Examples:\n").expect("examples");
        assert_eq!(examples.lines().filter(|line| line.starts_with("  striata-lab ")).count(), 2, "{text}");
        insta::assert_snapshot!(verb, text);
    }
}
