//! The Python package: builds its wheel, installs it into a virtual environment, and runs its tests there.

use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Context, Result};

use crate::steps::{self, cargo, say};
use crate::{machine, target_folder, workspace};

/// Python programs to look for; the first that starts makes the virtual environment.
const INTERPRETERS: [&str; 2] = ["python3", "python"];

/// A virtual environment of its own, kept between runs.
pub(crate) struct VirtualEnvironment {
    folder: PathBuf,
}

/// Lints the extension, then builds, installs and tests the package.
///
/// # Errors
/// If a step fails.
pub(crate) fn run() -> Result<()> {
    let lint = ["clippy", "-p", "striata-py", "--features", "python", "--", "-D", "warnings"];
    // Without an interpreter, and without linking to one.
    let variables = [("PYO3_NO_PYTHON", "1"), ("PYO3_BUILD_EXTENSION_MODULE", "1")];
    steps::run(cargo(&lint).envs(variables))?;
    let environment = VirtualEnvironment::new(target_folder()?.join("py/venv"))?;
    let package = package();
    environment.install(&["-r", "tests/requirements.txt"])?;
    // Packages of hundreds of megabytes, which not every platform has.
    for line in std::fs::read_to_string(package.join("tests/requirements-optional.txt"))?.lines() {
        if !line.starts_with('#') && environment.install(&["--only-binary", ":all:", line]).is_err() {
            say(&format!("!!! {line} is not available; the tests that need it are skipped"));
        }
    }
    environment.install_wheel()?;
    // Installed code is tested, not the source folder, which has no extension.
    environment.python(&["-m", "pytest", "tests"])?;
    environment.python(&["-m", "pytest", "--doctest-modules", "--pyargs", "striata"])?;
    let guide = "../../docs/guide";
    // Without the cache, which would be a folder among the guides.
    let options = ["-p", "no:cacheprovider", "--doctest-glob=python*.md", "--rootdir", guide, guide];
    environment.python(&[&["-m", "pytest"], options.as_slice()].concat())?;
    environment.python(&["-m", "mypy", "--config-file", "pyproject.toml"])?;
    // Every subclass of a tuple counts as a disjoint base, which stubs cannot say before Python 3.15.
    let options = ["--ignore-disjoint-bases", "--mypy-config-file", "pyproject.toml"];
    environment.python(&[&["-m", "mypy.stubtest", "striata"], options.as_slice()].concat())
}

/// Builds the wheel, and uses it in an environment that has nothing but its dependencies.
///
/// # Errors
/// If a step fails.
pub(crate) fn check_wheel() -> Result<()> {
    let builder = VirtualEnvironment::new(target_folder()?.join("py/venv"))?;
    builder.install(&["-r", "tests/requirements.txt"])?;
    let wheel = builder.build_wheel("dist")?;
    let fresh = target_folder()?.join("py/fresh");
    machine::remove_folder(&fresh)?;
    let fresh = VirtualEnvironment::new(fresh)?;
    fresh.install(&[&wheel.to_string_lossy()])?;
    let use_it =
        "import striata; assert len(striata.simplify(*striata.shapes.torus(64, 32), ratio=0.1)[1]) > 100";
    fresh.python(&["-c", use_it])
}

/// Folder of the package.
fn package() -> PathBuf {
    workspace().join("crates/striata-py")
}

impl VirtualEnvironment {
    /// Opens a virtual environment, or makes it if it does not work.
    ///
    /// # Errors
    /// If there is no Python, or it makes none.
    pub(crate) fn new(folder: PathBuf) -> Result<Self> {
        let environment = Self { folder };
        if !machine::starts(&environment.interpreter().to_string_lossy()) {
            machine::remove_folder(&environment.folder)?;
            let found = INTERPRETERS.into_iter().find(|program| machine::starts(program));
            let python = found.context("there is no python3; please install it")?;
            steps::run(Command::new(python).args(["-m", "venv"]).arg(&environment.folder))?;
        }
        Ok(environment)
    }

    fn interpreter(&self) -> PathBuf {
        let program = if cfg!(windows) { "Scripts/python.exe" } else { "bin/python" };
        self.folder.join(program)
    }

    fn command(&self, arguments: &[&str]) -> Command {
        let mut command = Command::new(self.interpreter());
        // Tools that compile find the environment by this variable.
        command.args(arguments).current_dir(package()).env("VIRTUAL_ENV", &self.folder);
        command
    }

    /// Runs Python in the folder of the package.
    ///
    /// # Errors
    /// If it fails.
    pub(crate) fn python(&self, arguments: &[&str]) -> Result<()> {
        steps::run(&mut self.command(arguments))
    }

    /// Installs packages with pip.
    ///
    /// # Errors
    /// If that fails twice.
    pub(crate) fn install(&self, arguments: &[&str]) -> Result<()> {
        let pip = ["-m", "pip", "install", "--quiet", "--disable-pip-version-check"];
        steps::run_twice(self.command(&pip).args(arguments))
    }

    /// Builds the wheel and installs it.
    fn install_wheel(&self) -> Result<()> {
        let wheel = self.build_wheel("release")?;
        self.install(&["--force-reinstall", "--no-deps", &wheel.to_string_lossy()])
    }

    /// Builds the wheel with a profile; none of them is unoptimized, since tests measure times.
    fn build_wheel(&self, profile: &str) -> Result<PathBuf> {
        let wheels = target_folder()?.join("py/wheels");
        machine::remove_folder(&wheels)?;
        let build = ["-m", "maturin", "build", "--profile", profile, "--out"];
        let target = target_folder()?;
        steps::run(self.command(&build).arg(&wheels).env("CARGO_TARGET_DIR", target))?;
        the_wheel(&wheels)
    }
}

fn the_wheel(folder: &Path) -> Result<PathBuf> {
    let mut files = std::fs::read_dir(folder)?.filter_map(|entry| Some(entry.ok()?.path()));
    files.find(|path| path.extension().is_some_and(|e| e == "whl")).context("maturin built no wheel")
}
