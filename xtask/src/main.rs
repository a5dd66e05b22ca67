//! Chores of the workspace; `cargo xtask test` is what continuous integration runs.

mod bare;
mod browser;
mod command;
mod cpu_time;
mod golden;
mod licenses;
mod machine;
mod oldest_rust;
mod packages;
mod results;
mod steps;
mod test;
mod web;

use std::path::PathBuf;
use std::process::ExitCode;

use anyhow::Context as _;
use clap::{Parser, Subcommand};

/// Chores of the striata workspace.
#[derive(Debug, Parser)]
#[command(name = "cargo xtask")]
struct Chores {
    #[command(subcommand)]
    chore: Chore,
}

#[derive(Debug, Subcommand)]
enum Chore {
    /// Format, lints, tests, docs, features, wasm32, golden files and browser: all that must pass
    Test,
    /// The first part alone: the demo on machines with Vulkan, with OpenGL alone, and without drivers
    Bare,
    /// The golden part alone: run the demo and check what it writes
    Golden,
    /// The browser part alone: the viewer page in Chromium, over `striata serve`
    Browser,
    /// Builds the wasm, the npm package and the viewer page, which is committed, into their places
    Web,
    /// The web part alone: build and test the package, and check that the viewer is what the sources make
    WebCheck,
    /// The packages alone: pack what would be published, and check that nothing is missing in it
    Packages,
    /// The licenses alone: `cargo deny` over all dependencies
    Licenses,
    /// The oldest Rust alone: compile with the one that `rust-version` claims
    OldestRust,
    /// The tables of the docs: run their commands again and compare counts and bytes
    Results(results::ResultsArgs),
}

fn main() -> ExitCode {
    let outcome = match Chores::parse().chore {
        Chore::Test => test::run(),
        Chore::Bare => bare::run(),
        Chore::Golden => golden::run(),
        Chore::Browser => browser::run(),
        Chore::Web => web::build(),
        Chore::WebCheck => web::check(),
        Chore::Packages => packages::run(),
        Chore::Licenses => licenses::check(),
        Chore::OldestRust => oldest_rust::check(),
        Chore::Results(args) => results::run(&args),
    };
    match outcome {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            steps::say(&format!("error: {error:#}"));
            ExitCode::FAILURE
        }
    }
}

/// The folder of the workspace.
fn workspace() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// The folder that cargo builds into: this program lies in one of its folders.
///
/// # Errors
/// Where the system does not say where this program is.
fn target_folder() -> anyhow::Result<PathBuf> {
    let program = std::env::current_exe()?;
    let folder = program.ancestors().nth(2).context("this program lies in no target folder")?;
    Ok(folder.to_owned())
}
