//! Snapshots of the help texts, which are part of the interface.

use crate::workbench::Workbench;

fn help(arguments: &str) -> String {
    let bench = Workbench::new();
    let assert = bench.command(arguments).env("COLUMNS", "80").assert().success();
    String::from_utf8_lossy(&assert.get_output().stdout).into_owned()
}

#[test]
fn the_whole_help_fits_one_screen() {
    let text = help("--help");
    assert!(text.lines().count() <= 24, "{} lines", text.lines().count());
    assert!(text.lines().all(|line| line.chars().count() <= 80), "a line is too long:\n{text}");
    insta::assert_snapshot!("striata", text);
}

#[test]
fn every_verb_ends_with_two_examples() {
    for verb in [
        "build",
        "plan",
        "run",
        "info",
        "extract",
        "simplify",
        "strip",
        "distance",
        "convert",
        "encode",
        "decode",
        "tiles",
        "serve",
        "thumbnail",
        "render",
        "view",
        "demo",
        "completions",
    ] {
        let text = help(&format!("{verb} --help"));
        let (_, examples) = text.split_once("Examples:\n").expect("examples");
        let count = examples.lines().filter(|line| line.starts_with("  striata ")).count();
        assert_eq!(count, 2, "{verb}:\n{text}");
        insta::assert_snapshot!(verb, text);
    }
}
