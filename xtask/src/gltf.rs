//! Runs the verbs over the glTF files of folders, and compares what the glTF validator of Khronos says about inputs and
//! outputs: an output may have no error that its input does not have.

use std::collections::{BTreeMap, BTreeSet};
use std::io::Write as _;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use anyhow::{Context, Result, ensure};
use clap::Args;

use crate::machine::{npm_install, remove_folder};
use crate::steps::{cargo, run, say};
use crate::{target_folder, workspace};

/// Commands that write GLB files of the input `IN`; `{}` is a name in the scratch folder without extension.
const LINES: [&[&str]; 10] = [
    &["convert IN {}.glb"],
    &["convert IN {}.glb --meshopt"],
    &["convert IN {}.glb --quantize --dedup --resample"],
    &["convert IN {}.glb --draco"],
    &["simplify IN -o {}.glb --ratio .5"],
    &["simplify IN -o {}.glb --levels 50%,10% --lod-chain"],
    &["build IN -o {}.striata", "extract {}.striata -o {}.glb --ratio .5"],
    &["encode IN -o {}.stri", "decode {}.stri -o {}.glb"],
    &["encode IN -o {}.glb"],
    &["build IN -o {}.glb --ranges 3"],
];

/// Arguments of `cargo xtask gltf`.
#[derive(Debug, Args)]
pub(crate) struct GltfTaskArgs {
    /// Folders whose glTF files are read, with their subfolders
    #[arg(required = true)]
    folders: Vec<PathBuf>,
    /// Use this `striata` instead of a release build of this workspace
    #[arg(long, value_name = "PATH")]
    striata: Option<PathBuf>,
}

/// Number of messages for each code, of errors and of warnings.
type Messages = BTreeMap<String, usize>;

/// Prints a table with a row for each input.
///
/// # Errors
/// If Node.js or the validator is missing, or an output has an error that its input does not have.
pub(crate) fn check(args: &GltfTaskArgs) -> Result<()> {
    let validator = workspace().join("xtask/gltf-validate");
    npm_install(&validator)?;
    let striata = match &args.striata {
        Some(path) => path.canonicalize()?,
        None => {
            run(&mut cargo(&["build", "--release", "--package", "striata-cli", "--no-default-features"]))?;
            target_folder()?.join("release").join(format!("striata{}", std::env::consts::EXE_SUFFIX))
        }
    };
    let mut files = Vec::new();
    for folder in &args.folders {
        add_files(&folder.canonicalize()?, &mut files)?;
    }
    let scratch = std::env::temp_dir().join(format!("striata-gltf-{}", std::process::id()));
    let mut rows = vec![
        "| file | errors | outputs | refused | errors of outputs | new errors |".to_owned(),
        "| --- | --- | --- | --- | --- | --- |".to_owned(),
    ];
    let mut faults = Vec::new();
    for file in &files {
        remove_folder(&scratch)?;
        std::fs::create_dir_all(&scratch)?;
        let (row, own) = check_file(file, &striata, &validator, &scratch)?;
        rows.push(row);
        faults.extend(own);
    }
    remove_folder(&scratch)?;
    writeln!(std::io::stdout(), "{}", rows.join("\n"))?;
    faults.iter().for_each(|fault| say(fault));
    ensure!(faults.is_empty(), "{} outputs have errors that their inputs do not have", faults.len());
    Ok(())
}

/// Adds the glTF files of a folder and its subfolders, sorted.
fn add_files(folder: &Path, files: &mut Vec<PathBuf>) -> Result<()> {
    let entries = std::fs::read_dir(folder).with_context(|| format!("no folder {}", folder.display()))?;
    let mut paths = entries.map(|entry| Ok(entry?.path())).collect::<Result<Vec<_>>>()?;
    paths.sort();
    for path in paths {
        if path.is_dir() {
            add_files(&path, files)?;
        } else if path.extension().is_some_and(|extension| extension == "glb" || extension == "gltf") {
            files.push(path);
        }
    }
    Ok(())
}

/// Runs all commands for a file; returns its row of the table and its faults.
fn check_file(
    file: &Path,
    striata: &Path,
    validator: &Path,
    scratch: &Path,
) -> Result<(String, Vec<String>)> {
    let mut refused = 0;
    let mut outputs: Vec<(PathBuf, &str)> = Vec::new();
    for (number, lines) in LINES.iter().enumerate() {
        let name = scratch.join(number.to_string()).to_string_lossy().into_owned();
        let runs = |line: &&str| {
            let words = line.replace("{}", &name);
            let words =
                words.split(' ').map(|word| if word == "IN" { file.as_os_str() } else { word.as_ref() });
            let status = Command::new(striata)
                .args(words)
                .arg("--quiet")
                .stdin(Stdio::null())
                .stderr(Stdio::null())
                .status()?;
            ensure!(
                matches!(status.code(), Some(0 | 1)),
                "`{line}` of {} ended with {status}",
                file.display()
            );
            Ok(status.success())
        };
        let mut is_written = true;
        for line in *lines {
            is_written = is_written && runs(line)?;
        }
        if is_written {
            outputs.push((PathBuf::from(format!("{name}.glb")), lines[lines.len() - 1]));
        } else {
            refused += 1;
        }
    }
    let paths = std::iter::once(file).chain(outputs.iter().map(|(path, _)| path.as_path()));
    let messages = validated(validator, paths)?;
    let (input, of_outputs) = messages.split_first().context("the validator printed nothing")?;
    let known: BTreeSet<&String> = input.keys().collect();
    let mut faults = Vec::new();
    let (mut errors, mut new_errors) = (0, 0);
    for ((_, line), found) in outputs.iter().zip(of_outputs) {
        errors += found.values().sum::<usize>();
        for (code, count) in found.iter().filter(|(code, _)| !known.contains(code)) {
            new_errors += count;
            faults.push(format!("{}: {line}: {count} times {code}", file.display()));
        }
    }
    let name = file.file_name().unwrap_or_default().to_string_lossy();
    let folder = file.parent().and_then(Path::file_name).unwrap_or_default().to_string_lossy();
    let own: usize = input.values().sum();
    let row =
        format!("| {folder}/{name} | {own} | {} | {refused} | {errors} | {new_errors} |", outputs.len());
    Ok((row, faults))
}

/// Returns the errors of each file, by code.
fn validated<'p>(validator: &Path, files: impl Iterator<Item = &'p Path>) -> Result<Vec<Messages>> {
    let mut node = Command::new("node");
    node.args(["validate.mjs", "--codes"]).args(files).current_dir(validator).stderr(Stdio::inherit());
    let output = node.output().context("cannot start node")?;
    ensure!(output.status.success(), "the validator ended with {}", output.status);
    let text = String::from_utf8(output.stdout)?;
    text.lines().map(|line| Ok(serde_json::from_str(line)?)).collect()
}
