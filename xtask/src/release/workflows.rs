//! The workflows: they parse, run only pinned actions, need no secrets, and publish all that they build.

use std::collections::BTreeSet;
use std::fs;
use std::path::PathBuf;

use anyhow::{Context, Result, bail, ensure};
use serde_json::Value;

use crate::workspace;

/// Platforms that have a binary and a wheel.
const TARGETS: [&str; 6] = [
    "aarch64-apple-darwin",
    "aarch64-pc-windows-msvc",
    "aarch64-unknown-linux-gnu",
    "x86_64-apple-darwin",
    "x86_64-pc-windows-msvc",
    "x86_64-unknown-linux-gnu",
];

/// Jobs of the release that publish to a registry, which trusts them by their name.
const PUBLISHERS: [&str; 3] = ["crates-io", "pypi", "npm"];

/// Checks all files in `.github`.
///
/// # Errors
/// If one does not parse, or a workflow is not as it should be.
pub(crate) fn check() -> Result<()> {
    let folder = workspace().join(".github");
    for path in yaml_files(&[folder.join("ISSUE_TEMPLATE"), folder.clone()])? {
        parsed(&fs::read_to_string(&path)?).with_context(|| path.display().to_string())?;
    }
    for path in yaml_files(&[folder.join("workflows")])? {
        let text = fs::read_to_string(&path)?;
        check_workflow(&text).with_context(|| path.display().to_string())?;
    }
    let release = fs::read_to_string(folder.join("workflows/release.yml"))?;
    check_release(&parsed(&release)?).context("release.yml")
}

fn yaml_files(folders: &[PathBuf]) -> Result<Vec<PathBuf>> {
    let mut files = Vec::new();
    for folder in folders {
        for entry in fs::read_dir(folder).with_context(|| folder.display().to_string())? {
            files.push(entry?.path());
        }
    }
    files.retain(|path| path.extension().is_some_and(|extension| extension == "yml"));
    files.sort();
    Ok(files)
}

fn parsed(text: &str) -> Result<Value> {
    Ok(serde_saphyr::from_str(text)?)
}

/// Returns the jobs with their names.
fn jobs(workflow: &Value) -> Result<&serde_json::Map<String, Value>> {
    workflow["jobs"].as_object().context("there are no jobs")
}

/// Returns the steps of a job.
fn steps_of(job: &Value) -> impl Iterator<Item = &Value> {
    job["steps"].as_array().into_iter().flatten()
}

/// Checks what holds for every workflow.
fn check_workflow(text: &str) -> Result<()> {
    ensure!(!text.contains("secrets."), "it uses a secret; registries trust the workflow itself");
    let workflow = parsed(text)?;
    let permissions = workflow["permissions"].as_object().context("there are no permissions for all jobs")?;
    ensure!(permissions.values().all(|right| right == "read"), "all jobs may write");
    for (name, job) in jobs(&workflow)? {
        ensure!(job["timeout-minutes"].is_u64(), "job {name} has no timeout");
        for action in steps_of(job).filter_map(|step| step["uses"].as_str()) {
            let commit = action.split_once('@').map_or("", |(_, commit)| commit);
            let is_commit = commit.len() == 40 && commit.chars().all(|c| c.is_ascii_hexdigit());
            ensure!(is_commit, "job {name} uses {action}, which is not pinned to a commit");
        }
    }
    Ok(())
}

/// Checks that the release publishes all that it builds, for all platforms.
fn check_release(workflow: &Value) -> Result<()> {
    let jobs = jobs(workflow)?;
    for name in ["binaries", "wheels"] {
        let targets = jobs.get(name).map(targets_of).unwrap_or_default();
        ensure!(targets == BTreeSet::from(TARGETS), "job {name} builds {targets:?}");
    }
    let builders: BTreeSet<&str> =
        jobs.iter().filter(|(_, job)| uploads(job).next().is_some()).map(|(name, _)| name.as_str()).collect();
    for name in PUBLISHERS {
        let job = jobs.get(name).with_context(|| format!("there is no job {name}"))?;
        let needed: BTreeSet<&str> =
            job["needs"].as_array().into_iter().flatten().filter_map(Value::as_str).collect();
        ensure!(needed == builders, "job {name} does not wait for {builders:?}");
        ensure!(job["permissions"]["id-token"] == "write", "job {name} cannot show who it is");
        ensure!(job["environment"] == "release", "job {name} runs without a review");
    }
    let patterns: Vec<&str> = jobs.values().flat_map(downloads).collect();
    for artifact in jobs.values().flat_map(uploads) {
        if !patterns.iter().any(|pattern| is_match(pattern, artifact)) {
            bail!("nothing publishes the artifact {artifact}");
        }
    }
    Ok(())
}

fn targets_of(job: &Value) -> BTreeSet<&str> {
    let entries = job["strategy"]["matrix"]["include"].as_array();
    entries.into_iter().flatten().filter_map(|entry| entry["target"].as_str()).collect()
}

/// Returns the values of an input of the steps that use an action.
fn inputs_of<'a>(job: &'a Value, action: &'a str, input: &'a str) -> impl Iterator<Item = &'a str> {
    let is_of_action =
        move |step: &&Value| step["uses"].as_str().is_some_and(|used| used.starts_with(action));
    steps_of(job).filter(is_of_action).filter_map(move |step| step["with"][input].as_str())
}

/// Returns the names of the artifacts that a job makes.
fn uploads(job: &Value) -> impl Iterator<Item = &str> {
    inputs_of(job, "actions/upload-artifact@", "name")
}

/// Returns the names and patterns of the artifacts that a job takes.
fn downloads(job: &Value) -> impl Iterator<Item = &str> {
    let action = "actions/download-artifact@";
    inputs_of(job, action, "name").chain(inputs_of(job, action, "pattern"))
}

/// Whether an artifact has a name, or one that begins like a pattern that ends with `*`.
fn is_match(pattern: &str, artifact: &str) -> bool {
    pattern.strip_suffix('*').map_or(pattern == artifact, |beginning| artifact.starts_with(beginning))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn release() -> String {
        fs::read_to_string(workspace().join(".github/workflows/release.yml"))
            .expect("it is in the repository")
    }

    #[test]
    fn the_workflows_are_as_they_should_be() -> Result<()> {
        check()
    }

    #[test]
    fn secrets_loose_actions_and_rights_are_refused() {
        let release = release();
        for (from, to) in [
            ("github.token", "secrets.TOKEN"),
            ("@de0fac2e4500dabe0009e67214ff5f5447ce83dd", "@v6"),
            ("permissions:\n  contents: read", "permissions:\n  contents: write"),
            ("    timeout-minutes: 15\n", ""),
            ("jobs:", "jobs: ["),
        ] {
            assert!(release.contains(from), "{from}");
            assert!(check_workflow(&release.replacen(from, to, 1)).is_err(), "{from}");
        }
    }

    #[test]
    fn what_is_built_and_not_published_is_refused() {
        let release = release();
        for (from, to) in [
            ("pattern: wheel-*", "pattern: wheels-*"),
            (
                "          name: npm-package\n      - uses: actions/setup-node",
                "          name: other\n      - uses: actions/setup-node",
            ),
            ("needs: [binaries, wheels, source, npm-package]", "needs: [binaries]"),
            (
                "{ target: aarch64-apple-darwin, system: macos-latest }",
                "{ target: riscv, system: macos-latest }",
            ),
            ("id-token: write", "id-token: none"),
        ] {
            assert!(release.contains(from), "{from}");
            let changed = parsed(&release.replacen(from, to, 1)).expect("it still parses");
            assert!(check_release(&changed).is_err(), "{from}");
        }
    }
}
