//! Runs every command of the guides in `docs/guide`, in the folder that they describe.

use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use crate::workbench::{NO_DRIVERS, Workbench, asset};

/// Returns the guides to the command with their names, sorted. Those to the Python package and to the C library are
/// tested with them.
fn guides() -> Vec<(String, String)> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/guide");
    let entries = std::fs::read_dir(folder).expect("the guides are in the repository");
    let mut paths: Vec<PathBuf> = entries.map(|entry| entry.expect("an entry").path()).collect();
    paths.retain(|path| {
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        name.ends_with(".md") && !name.starts_with("python") && name != "c.md"
    });
    paths.sort();
    let read = |path: &PathBuf| std::fs::read_to_string(path).expect("a guide is text");
    paths
        .iter()
        .map(|path| (path.file_name().unwrap_or_default().to_string_lossy().into_owned(), read(path)))
        .collect()
}

/// Returns the contents of all code blocks in one language.
fn blocks(guide: &str, language: &str) -> Vec<String> {
    let fences = guide.split("```").skip(1).step_by(2);
    fences.filter_map(|block| block.strip_prefix(language)?.strip_prefix('\n')).map(str::to_owned).collect()
}

/// Makes the folder that the guides begin with.
fn folder() -> Workbench {
    let bench = Workbench::new();
    let bust = Path::new(env!("CARGO_MANIFEST_DIR")).join("assets/nefertiti.ply.zst");
    for file in [asset("spot.obj.zst"), asset("arm.glb"), bust] {
        let name = file.file_name().expect("a file").to_string_lossy().into_owned();
        std::fs::copy(&file, bench.path(&name)).expect("the folder is ours");
    }
    bench
}

/// The command under test: an optimized one if the environment names one, since the guides take a while.
fn command() -> PathBuf {
    let optimized = std::env::var_os("STRIATA_OPTIMIZED").map(PathBuf::from);
    optimized.unwrap_or_else(|| assert_cmd::cargo::cargo_bin("striata"))
}

/// Runs a block of commands in a shell that finds the tested `striata` first and stops at the first failure.
fn run_in_shell(bench: &Workbench, commands: &str) -> Output {
    let program = command();
    let own = program.parent().expect("a program is in a folder").to_path_buf();
    let others = std::env::var_os("PATH").unwrap_or_default();
    let path =
        std::env::join_paths(std::iter::once(own).chain(std::env::split_paths(&others))).expect("a path");
    let mut shell = Command::new("sh");
    shell.args(["-e", "-c", commands]).current_dir(bench.path(".")).env("PATH", path).envs(NO_DRIVERS);
    shell.output().expect("a shell")
}

#[test]
fn the_guide_to_scenes_lists_all_known_extensions() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/guide/scenes.md");
    let guide = std::fs::read_to_string(path).expect("the guide is in the repository");
    let row =
        |name: &str| guide.lines().find(|line| line.starts_with("| ") && line.contains(&format!("`{name}`")));
    for name in striata_io::known_extensions() {
        let usage = striata_io::extension_use(name).expect("it is known").as_str();
        let row = row(name).unwrap_or_else(|| panic!("no row has {name}"));
        assert!(row.starts_with(&format!("| {usage} |")), "{name} is {usage}: {row}");
    }
}

#[test]
fn every_command_of_the_guides_works() {
    let guides = guides();
    assert!(guides.len() >= 4, "{} guides", guides.len());
    for (name, guide) in guides {
        let bench = folder();
        let blocks = blocks(&guide, "sh");
        assert!(blocks.len() >= 3, "{name} has {} blocks of commands", blocks.len());
        for block in blocks {
            let output = run_in_shell(&bench, &block);
            let stderr = String::from_utf8_lossy(&output.stderr);
            assert!(output.status.success(), "{name}:\n{block}\n{stderr}");
            for word in block.split_whitespace().filter(|word| word.contains('.') && !word.contains('{')) {
                let is_output =
                    [".glb", ".striata", ".stri", ".png", ".ply"].iter().any(|end| word.ends_with(end));
                assert!(!is_output || bench.path(word).exists(), "{name}: {block} leaves no {word}");
            }
        }
    }
}

#[test]
fn commands_that_stay_open_are_serve_and_view_with_files_that_the_guide_has_made() {
    for (name, guide) in guides() {
        let made = blocks(&guide, "sh").concat();
        for block in blocks(&guide, "console") {
            let words: Vec<&str> = block.split_whitespace().collect();
            let ["$", "striata", verb, file, ..] = words[..] else { panic!("{name}: {block}") };
            assert!(matches!(verb, "serve" | "view"), "{name}: {block}");
            assert!(file == "." || made.contains(file), "{name}: {block} needs {file}");
        }
    }
}

#[cfg(feature = "serve")]
#[test]
fn the_server_of_the_guides_starts() {
    let bench = folder();
    let program = command();
    let server = striata_testing::server::Server::start(&program, &bench.path("."), &[]);
    assert_eq!(server.report["models"], 3);
}

#[cfg(all(unix, feature = "serve"))]
#[test]
fn the_pages_of_the_guides_open() {
    for (name, guide) in guides() {
        let commands = blocks(&guide, "console").concat();
        for command in commands.lines().filter_map(|line| line.strip_prefix("$ striata view ")) {
            let bench = folder();
            let made = run_in_shell(&bench, &blocks(&guide, "sh")[0]);
            assert!(made.status.success(), "{name}: {}", String::from_utf8_lossy(&made.stderr));
            let arguments: Vec<&str> = command.split_whitespace().collect();
            let shown = crate::view::Shown::start(&bench, &arguments);
            assert!(shown.address().contains(&format!("?model=models/{}", arguments[0])), "{command}");
        }
    }
}
