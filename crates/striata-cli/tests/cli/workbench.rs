//! A folder of one test's own, with meshes made for it, and the command run in it.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};

use assert_cmd::Command;
use assert_cmd::assert::Assert;
use serde_json::Value;
use tempfile::TempDir;

/// What makes a machine look as if it had no graphics driver.
pub(crate) const NO_DRIVERS: [(&str, &str); 3] = [
    ("VK_DRIVER_FILES", "/nonexistent"),
    ("__EGL_VENDOR_LIBRARY_DIRS", "/nonexistent"),
    ("LIBGL_DRIVERS_PATH", "/nonexistent"),
];

/// A folder with meshes in it that is gone after the test.
pub(crate) struct Workbench {
    folder: TempDir,
}

impl Workbench {
    /// An empty folder.
    pub(crate) fn new() -> Self {
        Self { folder: tempfile::tempdir().expect("a temporary folder") }
    }

    /// Where a file of that name lies.
    pub(crate) fn path(&self, name: &str) -> PathBuf {
        self.folder.path().join(name)
    }

    /// Writes a file.
    pub(crate) fn write(&self, name: &str, content: impl AsRef<[u8]>) {
        std::fs::write(self.path(name), content).expect("the folder is ours");
    }

    /// The bytes of a file.
    pub(crate) fn read(&self, name: &str) -> Vec<u8> {
        std::fs::read(self.path(name)).expect("the file is there")
    }

    /// All file names, sorted.
    pub(crate) fn names(&self) -> Vec<String> {
        let entries = std::fs::read_dir(self.folder.path()).expect("the folder is ours");
        let mut names: Vec<String> = entries
            .map(|entry| entry.expect("an entry").file_name().to_string_lossy().into_owned())
            .collect();
        names.sort();
        names
    }

    /// The command, not yet run, with arguments separated by blanks.
    pub(crate) fn command(&self, arguments: &str) -> Command {
        let mut command = Command::cargo_bin(crate::COMMAND).expect("the command is built");
        command.current_dir(self.folder.path()).args(arguments.split_whitespace());
        command
    }

    /// Runs the command.
    pub(crate) fn run(&self, arguments: &str) -> Assert {
        self.command(arguments).assert()
    }

    /// Runs the command with `--json` and gives the one object that it must print.
    pub(crate) fn json(&self, arguments: &str) -> Value {
        let assert = self.command(arguments).arg("--json").assert().success();
        let stdout = &assert.get_output().stdout;
        let value: Value = serde_json::from_slice(stdout).expect("one JSON object on stdout");
        assert!(value.is_object(), "{value}");
        value
    }

    /// Runs the command, which must fail as the user's fault, and gives what it said.
    pub(crate) fn refused(&self, arguments: &str) -> String {
        let assert = self.run(arguments).code(1).stdout("");
        let stderr = String::from_utf8_lossy(&assert.get_output().stderr).into_owned();
        assert!(!stderr.contains("panicked"), "{stderr}");
        stderr
    }
}

/// Panics unless the object has every key; `a.b` looks inside `a`.
pub(crate) fn assert_keys(object: &Value, keys: &[&str]) {
    for key in keys {
        let found = key.split('.').try_fold(object, |value, part| value.get(part));
        assert!(found.is_some(), "no key {key} in {object}");
    }
}

/// A ball as OBJ: `rings` circles of latitude with `segments` vertices each, and two poles.
pub(crate) fn sphere(rings: usize, segments: usize) -> String {
    let mut text = String::from("v 0 1 0\n");
    for ring in 1..=rings {
        let polar = std::f64::consts::PI * ring as f64 / (rings + 1) as f64;
        for segment in 0..segments {
            let around = std::f64::consts::TAU * segment as f64 / segments as f64;
            let (x, z) = (polar.sin() * around.sin(), polar.sin() * around.cos());
            writeln!(text, "v {x} {} {z}", polar.cos()).expect("memory takes it");
        }
    }
    text.push_str("v 0 -1 0\n");
    let vertex = |ring: usize, segment: usize| 2 + (ring - 1) * segments + segment % segments;
    for s in 0..segments {
        writeln!(text, "f 1 {} {}", vertex(1, s), vertex(1, s + 1)).expect("memory takes it");
        for ring in 1..rings {
            let quad = [vertex(ring, s), vertex(ring + 1, s), vertex(ring + 1, s + 1), vertex(ring, s + 1)];
            writeln!(text, "f {} {} {} {}", quad[0], quad[1], quad[2], quad[3]).expect("memory takes it");
        }
        let south = 2 + rings * segments;
        writeln!(text, "f {south} {} {}", vertex(rings, s + 1), vertex(rings, s)).expect("memory takes it");
    }
    text
}

/// A file of the repository's `assets` folder.
pub(crate) fn asset(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../assets").join(name)
}
