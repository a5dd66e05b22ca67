//! Runs commands and steps, with headings, times and a summary.

use std::ffi::OsStr;
use std::fmt::Write as _;
use std::io::{Write, stderr};
use std::process::Command;
use std::time::{Duration, Instant};

use anyhow::{Context, Result, bail};

use crate::cpu_time::CpuTime;
use crate::workspace;

/// Prints a line to stderr, where other tools also print their messages.
pub(crate) fn say(text: &str) {
    // A closed stderr is no reason to stop.
    let _ = writeln!(stderr(), "{text}");
}

/// Which checks run.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum CheckExtent {
    /// The checks that every change must pass.
    Quick,
    /// The checks of changes, and those that few changes fail: everything that CONTRIBUTING.md lists.
    All,
}

/// The steps run so far, with their times.
#[derive(Debug, Default)]
pub(crate) struct CiSteps {
    done: Vec<(String, Duration, Option<f64>)>,
    skipped: Vec<String>,
}

impl CiSteps {
    /// Runs a step under a heading.
    ///
    /// # Errors
    /// The error of the step, with its name.
    pub(crate) fn step(&mut self, name: &str, work: impl FnOnce() -> Result<()>) -> Result<()> {
        say(&format!("\n=== {name}"));
        let (started, cpu) = (Instant::now(), CpuTime::now());
        work().with_context(|| format!("step `{name}` failed"))?;
        let took = started.elapsed();
        let cpu_secs = cpu.secs_since();
        say(&format!("=== {name}: ok, {}", times(took, cpu_secs).trim_start()));
        self.done.push((name.to_owned(), took, cpu_secs));
        Ok(())
    }

    /// Reports prominently that a step was skipped.
    pub(crate) fn skip(&mut self, name: &str, reason: &str) {
        say(&format!("\n!!! {name} SKIPPED: {reason}"));
        self.skipped.push(format!("{name}: {reason}"));
    }

    /// Returns a summary of all steps with their times.
    pub(crate) fn summary(&self) -> String {
        let mut text = String::from("\n=== all steps passed\n");
        for (name, took, cpu_secs) in &self.done {
            // Writing to a string cannot fail.
            let _ = writeln!(text, "{}  {name}", times(*took, *cpu_secs));
        }
        let total: Duration = self.done.iter().map(|(_, took, _)| *took).sum();
        let cpu_total: Option<f64> = self.done.iter().map(|(_, _, cpu_secs)| *cpu_secs).sum();
        let _ = write!(text, "{}  total", times(total, cpu_total));
        for skipped in &self.skipped {
            let _ = write!(text, "\n!!! SKIPPED {skipped}");
        }
        text
    }
}

/// Formats elapsed seconds, and processor seconds if known.
fn times(took: Duration, cpu_secs: Option<f64>) -> String {
    let cpu = cpu_secs.map_or(String::new(), |secs| format!("  {secs:>7.1} CPU s"));
    format!("{:>7.1} s{cpu}", took.as_secs_f64())
}

/// Returns a cargo command in the workspace, with the same cargo that runs this program.
pub(crate) fn cargo(arguments: &[&str]) -> Command {
    let mut command = Command::new(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
    command.args(arguments).current_dir(workspace());
    command
}

/// Runs a command and waits for it.
///
/// # Errors
/// If it cannot start or fails.
pub(crate) fn run(command: &mut Command) -> Result<()> {
    let line = command_line(command);
    say(&format!("$ {line}"));
    let status = command.status().with_context(|| format!("cannot start `{line}`"))?;
    if !status.success() {
        bail!("`{line}` ended with {status}");
    }
    Ok(())
}

/// Runs a command and tries once more if it fails, as networks and package managers occasionally do.
///
/// # Errors
/// If it fails twice.
pub(crate) fn run_twice(command: &mut Command) -> Result<()> {
    if let Err(error) = run(command) {
        say(&format!("{error:#}; trying again in 10 s"));
        std::thread::sleep(Duration::from_secs(10));
        return run(command);
    }
    Ok(())
}

fn command_line(command: &Command) -> String {
    let words = std::iter::once(command.get_program()).chain(command.get_args());
    words.map(OsStr::to_string_lossy).collect::<Vec<_>>().join(" ")
}
