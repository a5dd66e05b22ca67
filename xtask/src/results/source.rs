//! Runs the commands of tables, each only once, and keeps their output.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use anyhow::{Context, Result, bail, ensure};

use crate::machine::remove_folder;
use crate::steps::{cargo, say};
use crate::workspace;

/// Runs commands and keeps their output.
pub(super) struct Commands {
    meshes: Option<PathBuf>,
    striata: Option<PathBuf>,
    /// Temporary folder in which `striata` runs, so that commands may write files.
    scratch: PathBuf,
    printed: BTreeMap<String, String>,
}

impl Drop for Commands {
    fn drop(&mut self) {
        // If this fails, files are left in the folder for temporary files, which does no harm.
        let _ = remove_folder(&self.scratch);
    }
}

impl Commands {
    /// Sets the folder of meshes, and the `striata` to use.
    ///
    /// # Errors
    /// If one of them does not exist.
    pub(super) fn new(meshes: Option<&Path>, striata: Option<&Path>) -> Result<Self> {
        let found = |path: &Path| path.canonicalize().with_context(|| format!("no {}", path.display()));
        let (meshes, striata) = (meshes.map(found).transpose()?, striata.map(found).transpose()?);
        let scratch = std::env::temp_dir().join(format!("striata-results-{}", std::process::id()));
        Ok(Self { meshes, striata, scratch, printed: BTreeMap::new() })
    }

    /// Returns the stdout of a command.
    ///
    /// # Errors
    /// If the command is not `striata`, `striata-lab`, `cargo bench` or `cargo xtask gltf`, cannot start, or fails.
    pub(super) fn output(&mut self, line: &str) -> Result<String> {
        if let Some(printed) = self.printed.get(line) {
            return Ok(printed.clone());
        }
        let words: Vec<String> =
            line.split_whitespace().map(|word| self.resolved(word)).collect::<Result<_>>()?;
        let mut command = self.command(&words)?;
        std::fs::create_dir_all(&self.scratch)?;
        say(&format!("$ {line}"));
        let output =
            command.stderr(Stdio::inherit()).output().with_context(|| format!("cannot start `{line}`"))?;
        ensure!(output.status.success(), "`{line}` ended with {}", output.status);
        let text = String::from_utf8_lossy(&output.stdout).into_owned();
        self.printed.insert(line.to_owned(), text.clone());
        Ok(text)
    }

    fn command(&self, words: &[String]) -> Result<Command> {
        let arguments: Vec<&str> = words.iter().map(String::as_str).collect();
        match (arguments.as_slice(), &self.striata) {
            (["striata", rest @ ..], Some(program)) => {
                let mut command = Command::new(program);
                command.args(rest).arg("--quiet").current_dir(&self.scratch);
                Ok(command)
            }
            (["striata", rest @ ..], None) => {
                Ok(self.built("Cargo.toml", &["--no-default-features"], rest)?)
            }
            (["striata-lab", rest @ ..], _) => {
                Ok(self.built("lab/Cargo.toml", &["--features", "peers"], rest)?)
            }
            (["cargo", "bench", ..], _) => Ok(cargo(&arguments[1..])),
            (["cargo", "xtask", "gltf", folders @ ..], striata) => {
                let mut command = Command::new(std::env::current_exe()?);
                command.arg("gltf").args(folders);
                if let Some(program) = striata {
                    command.arg("--striata").arg(program);
                }
                Ok(command)
            }
            _ => bail!(
                "`{}` is not `striata`, `striata-lab`, `cargo bench` or `cargo xtask gltf`",
                arguments.join(" ")
            ),
        }
    }

    /// Returns the command of one of the workspaces here, which is compiled when it runs.
    fn built(&self, manifest: &str, features: &[&str], arguments: &[&str]) -> Result<Command> {
        let mut command = cargo(&["run", "--release", "--quiet"]);
        command.args(features).arg("--manifest-path").arg(workspace().canonicalize()?.join(manifest));
        command.arg("--").args(arguments).arg("--quiet").current_dir(&self.scratch);
        Ok(command)
    }

    /// Replaces `$MESHES` in a word; `NAME.*` becomes the first file with that name.
    fn resolved(&self, word: &str) -> Result<String> {
        let Some(name) = word.strip_prefix("$MESHES") else { return Ok(word.to_owned()) };
        let folder =
            self.meshes.as_ref().context("the command needs meshes: give their folder with --meshes DIR")?;
        let Some(name) = name.strip_prefix('/') else { return Ok(folder.to_string_lossy().into_owned()) };
        let file = match name.strip_suffix('*') {
            Some(beginning) => first_file(folder, beginning)?,
            None => folder.join(name),
        };
        ensure!(file.is_file(), "no mesh {}", file.display());
        Ok(file.to_string_lossy().into_owned())
    }
}

fn first_file(folder: &Path, beginning: &str) -> Result<PathBuf> {
    let mut found = Vec::new();
    for entry in std::fs::read_dir(folder)? {
        let entry = entry?;
        if entry.file_name().to_string_lossy().starts_with(beginning) {
            found.push(entry.path());
        }
    }
    found.sort();
    found.into_iter().next().with_context(|| format!("no mesh {beginning}* in {}", folder.display()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn meshes_are_found_without_their_extension() {
        // Not the folder where the test was compiled: build folders move between clones.
        let package = std::env::var_os("CARGO_MANIFEST_DIR").unwrap();
        let commands = Commands::new(Some(&Path::new(&package).join("../assets")), None).unwrap();
        assert!(commands.resolved("$MESHES/spot.*").unwrap().ends_with("spot.obj.zst"));
        assert!(commands.resolved("$MESHES/cube.*").is_err());
        assert_eq!(commands.resolved("--json").unwrap(), "--json");
        assert!(Commands::new(None, None).unwrap().resolved("$MESHES/spot.*").is_err());
    }

    #[test]
    fn other_commands_are_refused() {
        let commands = Commands::new(None, None).unwrap();
        assert!(commands.command(&["rm".to_owned(), "-r".to_owned()]).is_err());
        assert!(commands.command(&["cargo".to_owned(), "publish".to_owned()]).is_err());
    }
}
