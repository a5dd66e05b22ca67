//! A temporary folder for one test, in which it creates meshes and runs the command.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};

use assert_cmd::Command;
use assert_cmd::assert::Assert;
use serde_json::Value;
use tempfile::TempDir;

/// Environment variables that hide all graphics drivers.
pub(crate) const NO_DRIVERS: [(&str, &str); 3] = [
    ("VK_DRIVER_FILES", "/nonexistent"),
    ("__EGL_VENDOR_LIBRARY_DIRS", "/nonexistent"),
    ("LIBGL_DRIVERS_PATH", "/nonexistent"),
];

/// A temporary folder that is deleted after the test.
pub(crate) struct Workbench {
    folder: TempDir,
}

impl Workbench {
    /// Creates an empty folder.
    pub(crate) fn new() -> Self {
        Self { folder: tempfile::tempdir().expect("a temporary folder") }
    }

    /// Returns the path of a file in the folder.
    pub(crate) fn path(&self, name: &str) -> PathBuf {
        self.folder.path().join(name)
    }

    /// Writes a file.
    pub(crate) fn write(&self, name: &str, content: impl AsRef<[u8]>) {
        std::fs::write(self.path(name), content).expect("the folder is writable");
    }

    /// Reads a file.
    pub(crate) fn read(&self, name: &str) -> Vec<u8> {
        std::fs::read(self.path(name)).expect("the file exists")
    }

    /// Returns all file names, sorted.
    pub(crate) fn names(&self) -> Vec<String> {
        let entries = std::fs::read_dir(self.folder.path()).expect("the folder is writable");
        let mut names: Vec<String> = entries
            .map(|entry| entry.expect("an entry").file_name().to_string_lossy().into_owned())
            .collect();
        names.sort();
        names
    }

    /// Returns the command with arguments separated by spaces, without running it.
    pub(crate) fn command(&self, arguments: &str) -> Command {
        let mut command = Command::cargo_bin(crate::COMMAND).expect("the command is built");
        command.current_dir(self.folder.path()).args(arguments.split_whitespace());
        command
    }

    /// Runs the command.
    pub(crate) fn run(&self, arguments: &str) -> Assert {
        self.command(arguments).assert()
    }

    /// Runs the command with `--json` and returns the object that it prints.
    pub(crate) fn json(&self, arguments: &str) -> Value {
        let assert = self.command(arguments).arg("--json").assert().success();
        let stdout = &assert.get_output().stdout;
        let value: Value = serde_json::from_slice(stdout).expect("one JSON object on stdout");
        assert!(value.is_object(), "{value}");
        value
    }

    /// Runs the command, which must fail because of its files or its words, and returns its stderr. With `--json`,
    /// stdout has an object that says the same.
    pub(crate) fn refused(&self, arguments: &str) -> String {
        let assert = self.run(arguments).failure();
        let output = assert.get_output();
        let stderr = String::from_utf8_lossy(&output.stderr).into_owned();
        assert!(matches!(output.status.code(), Some(1 | 2)), "{:?}: {stderr}", output.status);
        assert!(!stderr.contains("panicked"), "{stderr}");
        if arguments.contains("--json") {
            let printed: Value = serde_json::from_slice(&output.stdout).expect("one JSON object on stdout");
            let kind = if output.status.code() == Some(2) { "usage" } else { "failed" };
            assert_eq!(printed["error"]["kind"], kind, "{printed}");
        } else {
            assert_eq!(output.stdout, b"", "{stderr}");
        }
        stderr
    }
}

/// Panics unless the object has every key; `a.b` means key `b` of object `a`.
pub(crate) fn assert_keys(object: &Value, keys: &[&str]) {
    for key in keys {
        let found = key.split('.').try_fold(object, |value, part| value.get(part));
        assert!(found.is_some(), "no key {key} in {object}");
    }
}

/// Returns a ball as OBJ: `rings` circles of latitude with `segments` vertices each, and two poles.
pub(crate) fn sphere(rings: usize, segments: usize) -> String {
    let mut text = String::from("v 0 1 0\n");
    for ring in 1..=rings {
        let polar = std::f64::consts::PI * ring as f64 / (rings + 1) as f64;
        for segment in 0..segments {
            let around = std::f64::consts::TAU * segment as f64 / segments as f64;
            let (x, z) = (polar.sin() * around.sin(), polar.sin() * around.cos());
            writeln!(text, "v {x} {} {z}", polar.cos()).expect("writing to memory succeeds");
        }
    }
    text.push_str("v 0 -1 0\n");
    let vertex = |ring: usize, segment: usize| 2 + (ring - 1) * segments + segment % segments;
    for s in 0..segments {
        writeln!(text, "f 1 {} {}", vertex(1, s), vertex(1, s + 1)).expect("writing to memory succeeds");
        for ring in 1..rings {
            let quad = [vertex(ring, s), vertex(ring + 1, s), vertex(ring + 1, s + 1), vertex(ring, s + 1)];
            writeln!(text, "f {} {} {} {}", quad[0], quad[1], quad[2], quad[3]).expect(
                "writing to memory \
                succeeds",
            );
        }
        let south = 2 + rings * segments;
        writeln!(text, "f {south} {} {}", vertex(rings, s + 1), vertex(rings, s)).expect(
            "writing to \
            memory succeeds",
        );
    }
    text
}

/// Returns the path of a file in the `assets` folder of the repository.
pub(crate) fn asset(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../assets").join(name)
}
