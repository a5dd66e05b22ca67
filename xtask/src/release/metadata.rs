//! Checks that what registries show of the packages is complete and of one version.

use std::fs;

use anyhow::{Context, Result, ensure};
use serde_json::Value;
use toml_edit::DocumentMut;

use crate::steps::cargo;
use crate::workspace;

/// Version of everything that is published together.
const VERSION: &str = env!("CARGO_PKG_VERSION");

/// Fields that every crate must have.
const CRATE_FIELDS: [&str; 7] =
    ["description", "license", "repository", "homepage", "documentation", "readme", "rust_version"];

/// Papers that striata unites, which `CITATION.cff` lists.
const PAPER_COUNT: usize = 5;

/// Checks the metadata of the crates, the npm package, the Python package and the citation.
///
/// # Errors
/// If a field is missing, or versions differ.
pub(crate) fn check() -> Result<()> {
    check_crates()?;
    check_npm(&serde_json::from_str(&read("web/package.json")?)?)?;
    check_python(&read("crates/striata-py/pyproject.toml")?)?;
    check_citation(&read("CITATION.cff")?)
}

fn read(path: &str) -> Result<String> {
    fs::read_to_string(workspace().join(path)).with_context(|| path.to_owned())
}

fn check_crates() -> Result<()> {
    let output = cargo(&["metadata", "--format-version", "1", "--no-deps"]).output()?;
    let metadata: Value = serde_json::from_slice(&output.stdout).context("cargo metadata")?;
    let packages = metadata["packages"].as_array().context("cargo metadata has no packages")?;
    for package in packages.iter().filter(|package| !package["publish"].is_array()) {
        check_crate(package).with_context(|| package["name"].to_string())?;
    }
    Ok(())
}

fn check_crate(package: &Value) -> Result<()> {
    for field in CRATE_FIELDS {
        ensure!(package[field].is_string(), "there is no {field}");
    }
    for list in ["keywords", "categories", "authors"] {
        ensure!(package[list].as_array().is_some_and(|entries| !entries.is_empty()), "there are no {list}");
    }
    ensure!(package["version"] == VERSION, "the version is not {VERSION}");
    Ok(())
}

fn check_npm(package: &Value) -> Result<()> {
    for field in ["description", "license", "repository", "homepage", "bugs", "keywords", "author"] {
        ensure!(!package[field].is_null(), "web/package.json: there is no {field}");
    }
    ensure!(package["version"] == VERSION, "web/package.json: the version is not {VERSION}");
    Ok(())
}

fn check_python(text: &str) -> Result<()> {
    let document: DocumentMut = text.parse().context("pyproject.toml")?;
    let project = &document["project"];
    let urls = project.get("urls").context("pyproject.toml: there are no project.urls")?;
    for url in ["Homepage", "Documentation", "Repository", "Changelog", "Issues"] {
        ensure!(urls.get(url).is_some(), "pyproject.toml: there is no URL {url}");
    }
    for field in ["description", "readme", "license", "keywords", "classifiers", "requires-python"] {
        ensure!(project.get(field).is_some(), "pyproject.toml: there is no {field}");
    }
    Ok(())
}

fn check_citation(text: &str) -> Result<()> {
    let citation: Value = serde_saphyr::from_str(text).context("CITATION.cff")?;
    ensure!(citation["version"] == VERSION, "CITATION.cff: the version is not {VERSION}");
    let count = citation["references"].as_array().map_or(0, Vec::len);
    ensure!(count == PAPER_COUNT, "CITATION.cff has {count} references, expected the {PAPER_COUNT} papers");
    Ok(())
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;

    #[test]
    fn all_packages_have_complete_metadata() -> Result<()> {
        check()
    }

    #[test]
    fn gaps_and_other_versions_are_refused() {
        let mut package =
            json!({ "version": VERSION, "keywords": ["a"], "categories": ["b"], "authors": ["c"] });
        CRATE_FIELDS.iter().for_each(|&field| package[field] = json!("text"));
        assert!(check_crate(&package).is_ok());
        for (field, value) in
            [("homepage", json!(null)), ("keywords", json!([])), ("version", json!("0.0.1"))]
        {
            let mut other = package.clone();
            other[field] = value;
            assert!(check_crate(&other).is_err(), "{field}");
        }
        assert!(check_python("[project]\nname = 'a'\n").is_err());
        assert!(check_citation(&format!("version: {VERSION}\nreferences: [{{title: a}}]\n")).is_err());
    }
}
