//! Maintenance tasks of the workspace; continuous integration runs `cargo xtask test`.

mod bare;
mod browser;
mod command;
mod cpu_time;
mod gltf;
mod golden;
mod house;
mod licenses;
#[cfg(test)]
mod links;
mod machine;
mod oldest_rust;
mod packages;
mod py;
mod release;
mod results;
mod site;
mod steps;
mod test;
mod web;

use std::path::PathBuf;
use std::process::ExitCode;

use anyhow::Context as _;
use clap::{Parser, Subcommand};

/// Maintenance tasks of the striata workspace
#[derive(Debug, Parser)]
#[command(name = "cargo xtask")]
struct TaskCli {
    #[command(subcommand)]
    task: MaintenanceTask,
}

#[derive(Debug, Subcommand)]
enum MaintenanceTask {
    /// Run what a change must pass: format, lints, tests, docs, wasm32, golden files, Python, Chromium
    Test {
        /// Also run what few changes break: Firefox, the lab, each feature alone, the oldest Rust, fuzz targets
        #[arg(long)]
        all: bool,
    },
    /// Run only the demo check: with Vulkan, with only OpenGL, and without graphics drivers
    Bare,
    /// Run only the golden check: run the demo and validate its files
    Golden,
    /// Run the verbs over glTF files, and check what they write with the glTF validator
    Gltf(gltf::GltfTaskArgs),
    /// Run only the browser tests: the viewer page in Chromium, served by `striata serve`
    Browser,
    /// Build the wasm, the npm package and the viewer page (which is committed)
    Web {
        /// Build only the wasm and the npm package
        #[arg(long)]
        package: bool,
    },
    /// Run only the web checks: build and test the npm package, check that the viewer is up to date
    WebCheck,
    /// Run only the checks of the Python package: build the wheel, install it, test it, check its types
    Py,
    /// Run only the package check: pack the published crates, check that no file is missing
    Packages,
    /// Check or build what a release publishes (RELEASING.md)
    Release(release::ReleaseArgs),
    /// Build the site with its gallery and playground, and open it in a browser
    Site,
    /// Run only the license check: `cargo deny` for all dependencies
    Licenses,
    /// Run only the check of the oldest Rust: compile with the version in `rust-version`
    OldestRust,
    /// Run only the checks of the shape of the code: circles of files, tuple parameters, weak names
    House {
        /// List each place, even within the limits
        #[arg(long)]
        list: bool,
    },
    /// List or verify the tables in the docs: run their commands, compare counts and sizes
    Results(results::ResultsArgs),
}

fn main() -> ExitCode {
    let outcome = match TaskCli::parse().task {
        MaintenanceTask::Test { all: true } => test::run(steps::CheckExtent::All),
        MaintenanceTask::Test { all: false } => test::run(steps::CheckExtent::Quick),
        MaintenanceTask::Bare => bare::run(),
        MaintenanceTask::Golden => golden::run(),
        MaintenanceTask::Gltf(args) => gltf::check(&args),
        MaintenanceTask::Browser => browser::run(),
        MaintenanceTask::Web { package: true } => web::prepare_library(web::WasmBuild::Published),
        MaintenanceTask::Web { package: false } => web::build(),
        MaintenanceTask::WebCheck => web::check(steps::CheckExtent::All),
        MaintenanceTask::Py => py::run(),
        MaintenanceTask::Packages => packages::run(),
        MaintenanceTask::Release(args) => release::run(&args),
        MaintenanceTask::Site => {
            site::run().map(|folder| steps::say(&format!("the site is {}", folder.display())))
        }
        MaintenanceTask::Licenses => licenses::check(),
        MaintenanceTask::OldestRust => oldest_rust::check(),
        MaintenanceTask::House { list } => house::check(list),
        MaintenanceTask::Results(args) => results::run(&args),
    };
    match outcome {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            steps::say(&format!("error: {error:#}"));
            ExitCode::FAILURE
        }
    }
}

/// Returns the folder of the workspace.
fn workspace() -> PathBuf {
    // Clones may share a target folder, so that the one that this was compiled in may be another, or gone.
    let package = std::env::var_os("CARGO_MANIFEST_DIR");
    PathBuf::from(package.unwrap_or_else(|| env!("CARGO_MANIFEST_DIR").into())).join("..")
}

/// Returns the target folder of cargo, which contains this program.
///
/// # Errors
/// If the path of this program is unknown.
fn target_folder() -> anyhow::Result<PathBuf> {
    let program = std::env::current_exe()?;
    let folder = program.ancestors().nth(2).context("this program is not in a target folder")?;
    Ok(folder.to_owned())
}
