//! Draco, through its command-line tools if they are on the PATH.

use std::path::Path;
use std::process::Command;

use striata::mesh::IndexedMesh;
use tempfile::TempDir;

use super::coded::{CodedMesh, fastest};
use striata_command::failure::Failure;

/// Name of its files in the report.
pub(super) const NAME: &str = "Draco -cl 10";

/// The tools, with a folder for their files.
pub(super) struct Draco {
    folder: TempDir,
}

impl Draco {
    /// Finds the tools; returns `None` if they are not installed.
    ///
    /// # Errors
    /// If no temporary folder can be created.
    pub(super) fn find() -> Result<Option<Self>, Failure> {
        let is_installed = |tool| Command::new(tool).arg("-h").output().is_ok();
        if !is_installed("draco_encoder") || !is_installed("draco_decoder") {
            return Ok(None);
        }
        let folder = TempDir::new();
        let folder = folder.map_err(|error| Failure::user(format!("a folder for Draco's files: {error}")))?;
        Ok(Some(Self { folder }))
    }

    /// Encodes positions and triangles at the highest compression. Times are those the tools report, in
    /// whole milliseconds.
    ///
    /// # Errors
    /// If a tool fails.
    pub(super) fn code(&self, mesh: &IndexedMesh, bits: u32) -> Result<CodedMesh, Failure> {
        let [plain, packed, back] =
            ["in.ply", "out.drc", "back.ply"].map(|name| self.folder.path().join(name));
        striata_io::write(&plain, mesh, &striata_io::WriteOptions::default())?;
        let bits = bits.to_string();
        let encode_secs = run("draco_encoder", &plain, &packed, &["-cl", "10", "-qp", &bits])?;
        let decode_secs = fastest(|| run("draco_decoder", &packed, &back, &[]))?;
        let bytes =
            std::fs::metadata(&packed).map_err(|error| failed("draco_encoder", &error.to_string()))?;
        let mesh = striata_io::read(&back)?;
        Ok(CodedMesh { bytes: bytes.len() as usize, mesh, encode_secs, decode_secs })
    }
}

/// Runs a tool and returns the seconds it reports, which exclude file access.
fn run(tool: &str, from: &Path, to: &Path, flags: &[&str]) -> Result<f64, Failure> {
    let output = Command::new(tool).arg("-i").arg(from).arg("-o").arg(to).args(flags).output();
    let output = output.map_err(|error| failed(tool, &error.to_string()))?;
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    if !output.status.success() {
        return Err(failed(tool, text.trim()));
    }
    parse_secs(&text).ok_or_else(|| failed(tool, "its output contains no time"))
}

/// Parses the time in `(12 ms to decode)`.
fn parse_secs(text: &str) -> Option<f64> {
    let (before, _) = text.split_once(" ms to ")?;
    let (_, millis) = before.rsplit_once('(')?;
    Some(millis.parse::<f64>().ok()? / 1e3)
}

fn failed(tool: &str, why: &str) -> Failure {
    Failure::user(format!("{tool}: {why}")).with_hint("take it off the PATH to leave it out")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn times_are_parsed_from_the_output() {
        let text =
            "Encoder options:\n  Level = 10 (best)\n\nEncoded mesh saved to a.drc (38 ms to encode).\n";
        assert_eq!(parse_secs(text), Some(0.038));
        assert_eq!(parse_secs("Decoded geometry saved to a (b).ply (0 ms to decode)\n"), Some(0.0));
        assert_eq!(parse_secs("nothing"), None);
    }
}
