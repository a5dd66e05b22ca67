//! gltfpack, run through npx; it simplifies each material separately.
//!
//! Nothing is quantized (`-noq`), no attribute is dropped (`-kv`), and materials are not merged (`-km`).
//! The time is that of one run, including the start of Node and file access.

use std::collections::HashSet;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::time::Instant;

use striata::mesh::IndexedMesh;
use striata_io::WriteOptions;
use tempfile::TempDir;

use super::contender::Request;
use super::contender::{Level, Simplify};
use super::error_limits::with_smallest_limit;
use super::subject::{ComparedAsset, key};
use striata_command::failure::Failure;

/// A temporary folder with the mesh as a file that gltfpack reads.
struct Workplace {
    folder: TempDir,
    positions: HashSet<[u32; 3]>,
}

/// Writes the mesh for gltfpack; a permissive run may collapse across seams of normals. The inner error is
/// the reason why gltfpack cannot take part.
///
/// # Errors
/// If the mesh cannot be written.
pub(super) fn prepare<'a>(
    subject: &ComparedAsset,
    is_permissive: bool,
) -> Result<Result<Simplify<'a>, String>, Failure> {
    if let Err(why) = run(&["-v"]) {
        return Ok(Err(format!("gltfpack is left out: {why}")));
    }
    let folder = TempDir::new();
    let folder = folder.map_err(|error| Failure::user(format!("a folder for gltfpack's files: {error}")))?;
    let workplace = Workplace { folder, positions: subject.mesh.positions.iter().map(key).collect() };
    striata_io::write(workplace.input(), &subject.mesh, &WriteOptions::default())?;
    Ok(Ok(Box::new(move |request| {
        with_smallest_limit(request, |limit| workplace.simplify(request, limit, is_permissive))
    })))
}

impl Workplace {
    fn input(&self) -> PathBuf {
        self.folder.path().join("in.glb")
    }

    fn simplify(&self, request: &Request, limit: f64, is_permissive: bool) -> Result<Option<Level>, String> {
        let output = self.folder.path().join("out.glb");
        let (share, limit) = ((request.percent / 100.0).to_string(), limit.to_string());
        let (from, to) = (self.input(), output.clone());
        let mut arguments = vec!["-i", utf8(&from)?, "-o", utf8(&to)?];
        arguments.extend(["-noq", "-kv", "-km", "-se", &limit, "-si", &share]);
        arguments.extend(is_permissive.then_some("-sp"));
        let started = Instant::now();
        run(&arguments)?;
        let secs = started.elapsed().as_secs_f64();
        let mesh = striata_io::read(&output).map_err(|error| error.to_string())?;
        self.check(&mesh)?;
        let is_empty = mesh.triangles.is_empty();
        Ok((!is_empty).then_some(Level { mesh, secs, error: None, error_limit: None }))
    }

    /// Checks that positions were neither quantized nor moved, since distances would then be meaningless.
    fn check(&self, mesh: &IndexedMesh) -> Result<(), String> {
        match mesh.positions.iter().find(|position| !self.positions.contains(&key(position))) {
            Some(position) => Err(format!("no vertex of the original is at {position:?}")),
            None => Ok(()),
        }
    }
}

fn utf8(path: &Path) -> Result<&str, String> {
    path.to_str().ok_or_else(|| "the temporary folder's name is not UTF-8".to_owned())
}

/// Runs gltfpack. The error is a one-line reason.
fn run(arguments: &[&str]) -> Result<Output, String> {
    let output = Command::new("npx").args(["--yes", "gltfpack"]).args(arguments).output();
    let output = output.map_err(|error| format!("npx: {error}"))?;
    if output.status.success() {
        return Ok(output);
    }
    let message = String::from_utf8_lossy(&output.stderr).into_owned();
    let last = message.lines().rev().find(|line| !line.trim().is_empty());
    Err(last.map_or_else(|| format!("{}", output.status), |line| line.trim().to_owned()))
}
