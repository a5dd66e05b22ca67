//! Builds the wasm and the script that calls it.

use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Context, Result};
use wasm_bindgen_cli_support::Bindgen;

use crate::machine::WASM_TARGET;
use crate::steps::{self, cargo};
use crate::workspace;

/// Instruction sets that all recent browsers support: Chrome 91, Firefox 89, Safari 16.4.
const TARGET_FEATURES: &str =
    "-Ctarget-feature=+simd128,+bulk-memory,+sign-ext,+nontrapping-fptoint,+mutable-globals";

/// Flags of wasm-opt for these features and for those that wasm-bindgen adds. If all features were enabled,
/// wasm-opt would write code that browsers reject.
const WASM_OPT_FEATURES: [&str; 7] = [
    "--enable-simd",
    "--enable-bulk-memory",
    "--enable-sign-ext",
    "--enable-nontrapping-float-to-int",
    "--enable-mutable-globals",
    "--enable-reference-types",
    "--enable-multivalue",
];

/// How wasm is built.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum WasmBuild {
    /// As it is published: small and quick.
    Published,
    /// For tests: with little optimization, in a third of the time.
    Quick,
}

/// Profile of quick builds.
const QUICK_PROFILE: &str = "web-quick";

/// A wasm module that is built from `crates/striata-web`.
#[derive(Clone, Copy)]
pub(super) struct Module {
    /// Name of the wasm file and its script.
    name: &'static str,
    /// Cargo feature that it contains.
    feature: &'static str,
    profile: &'static str,
    /// Optimization by wasm-opt.
    optimization: &'static str,
}

/// Modules of pages: one that every page loads, one that simplifies plain meshes, and one that reads `.striata` files.
pub(super) const MODULES: [Module; 3] = [
    Module { name: "striata", feature: "stream", profile: "web", optimization: "-Os" },
    Module { name: "striata-builder", feature: "build", profile: "web-builder", optimization: "-Oz" },
    Module { name: "striata-files", feature: "files", profile: "web-builder", optimization: "-Oz" },
];

/// Module that the viewer page loads in place of the builder: it also saves models.
pub(super) const ENCODER: Module =
    Module { name: "striata-encoder", feature: "encode", profile: "web-builder", optimization: "-Oz" };

/// Files built from `crates/striata-web`.
pub(super) struct BuiltFiles {
    name: &'static str,
    wasm: Vec<u8>,
    script: String,
    types: String,
}

/// Builds a module and its script.
///
/// # Errors
/// If a tool fails.
pub(super) fn build(module: Module, build: WasmBuild) -> Result<BuiltFiles> {
    let Module { name, feature, profile, optimization } = module;
    let profile = if build == WasmBuild::Quick { QUICK_PROFILE } else { profile };
    let arguments = ["build", "--locked", "-p", "striata-web", "--lib", "--target", WASM_TARGET];
    let options = ["--no-default-features", "--features", feature, "--profile", profile];
    let mut command = cargo(&[&arguments[..], &options].concat());
    steps::run(command.env("CARGO_ENCODED_RUSTFLAGS", flags()?.join("\x1f")))?;
    let compiled = target_folder()?.join(WASM_TARGET).join(profile).join("striata_web.wasm");
    let mut bindgen = Bindgen::new();
    bindgen.input_path(compiled).web(true)?.typescript(true);
    bindgen.omit_default_module_path(true).remove_producers_section(true);
    let mut output = bindgen.generate_output().context("wasm-bindgen failed")?;
    let wasm = output.wasm_mut().emit_wasm();
    let wasm = if build == WasmBuild::Quick { wasm } else { optimized(&wasm, optimization)? };
    let (script, types) = (output.js().to_owned(), without_raw_exports(output.ts().unwrap_or_default()));
    Ok(BuiltFiles { name, wasm, script, types })
}

/// Writes the built files.
///
/// # Errors
/// If a file cannot be written.
pub(super) fn write(built: &BuiltFiles, dist: &Path, scripts: &Path) -> Result<()> {
    let BuiltFiles { name, .. } = built;
    let files = [
        (dist.join(format!("{name}.wasm")), &built.wasm[..]),
        (scripts.join(format!("{name}.js")), built.script.as_bytes()),
        (scripts.join(format!("{name}.d.ts")), built.types.as_bytes()),
    ];
    for (path, bytes) in files {
        std::fs::create_dir_all(path.parent().unwrap_or(&path))?;
        std::fs::write(&path, bytes).with_context(|| path.display().to_string())?;
    }
    Ok(())
}

/// Types of a script without those of the wasm's own functions, which nobody calls, and which are as long as
/// the rest.
fn without_raw_exports(types: &str) -> String {
    const START: &str = "export interface InitOutput {\n";
    let Some((before, rest)) = types.split_once(START) else { return types.to_owned() };
    let Some((exports, after)) = rest.split_once("}\n") else { return types.to_owned() };
    let memory: String =
        exports.lines().filter(|line| line.contains("memory:")).map(|line| format!("{line}\n")).collect();
    format!("{before}{START}{memory}}}\n{after}")
}

/// Returns compiler flags that enable the features and remove paths of this machine.
fn flags() -> Result<Vec<String>> {
    let home = std::env::var_os("CARGO_HOME").map(PathBuf::from);
    let home = home.or_else(|| Some(PathBuf::from(std::env::var_os("HOME")?).join(".cargo")));
    let home = home.context("neither CARGO_HOME nor HOME is set")?;
    let sysroot = rustc_output(&["--print", "sysroot"])?;
    let remap = |from: &str, to: &str| format!("--remap-path-prefix={from}={to}");
    Ok(vec![
        TARGET_FEATURES.to_owned(),
        remap(&sysroot, "/rust"),
        remap(&home.to_string_lossy(), "/cargo"),
        remap(&workspace().canonicalize()?.to_string_lossy(), "/striata"),
    ])
}

/// Returns the output of rustc.
///
/// # Errors
/// If it does not start.
pub(crate) fn rustc_output(arguments: &[&str]) -> Result<String> {
    let rustc = std::env::var_os("RUSTC").unwrap_or_else(|| "rustc".into());
    let output = Command::new(rustc).args(arguments).output().context("cannot start rustc")?;
    Ok(String::from_utf8_lossy(&output.stdout).trim().to_owned())
}

/// Folder of the npm package.
pub(super) fn folder() -> PathBuf {
    workspace().join("web")
}

/// Returns the target folder, according to cargo, since environment variables and configuration files affect
/// it.
fn target_folder() -> Result<PathBuf> {
    let output = cargo(&["metadata", "--format-version", "1", "--no-deps"]).output()?;
    let text = String::from_utf8_lossy(&output.stdout);
    let (_, rest) =
        text.split_once("\"target_directory\":\"").context("cargo metadata names no target folder")?;
    let (folder, _) = rest.split_once('"').context("cargo metadata names no target folder")?;
    Ok(PathBuf::from(folder.replace("\\\\", "\\")))
}

/// Optimizes the wasm with wasm-opt.
fn optimized(wasm: &[u8], optimization: &str) -> Result<Vec<u8>> {
    let scratch = std::env::temp_dir().join(format!("striata-wasm-{}", std::process::id()));
    std::fs::create_dir_all(&scratch)?;
    let (input, output) = (scratch.join("in.wasm"), scratch.join("out.wasm"));
    std::fs::write(&input, wasm)?;
    let mut command = Command::new("node");
    command
        .arg(folder().join("node_modules/binaryen/bin/wasm-opt"))
        .arg(optimization)
        .args(WASM_OPT_FEATURES);
    steps::run(command.arg(&input).arg("-o").arg(&output))?;
    let bytes = std::fs::read(&output)?;
    std::fs::remove_dir_all(&scratch)?;
    Ok(bytes)
}
