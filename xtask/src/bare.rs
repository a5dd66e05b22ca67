//! Runs the demo under the conditions of three machines: with Vulkan, with only OpenGL, and without any
//! graphics drivers.
//!
//! The demo is the first command of the README. It must succeed in each case, write the same files, and draw
//! the same pictures. The release build that draws on a GPU does, and it runs before anything is installed.

use std::collections::BTreeSet;
use std::fs::File;
use std::io::BufReader;
use std::path::{Path, PathBuf};

use anyhow::{Context, Result, ensure};

use crate::command::built_command;
use crate::machine;
use crate::steps::say;

/// A kind of machine: its name, and the environment variables that simulate it.
struct MachineKind {
    name: &'static str,
    environment: &'static [(&'static str, &'static str)],
}

const KINDS: [MachineKind; 3] = [
    MachineKind { name: "as it is", environment: &[] },
    MachineKind { name: "OpenGL alone", environment: &[("WGPU_BACKEND", "gl")] },
    MachineKind {
        name: "no drivers",
        environment: &[
            ("VK_DRIVER_FILES", "/nonexistent"),
            ("__EGL_VENDOR_LIBRARY_DIRS", "/nonexistent"),
            ("LIBGL_DRIVERS_PATH", "/nonexistent"),
        ],
    },
];

/// Extensions of files that contain no timings and must therefore be identical on all machines.
const SAME_BYTES: [&str; 4] = ["striata", "stri", "glb", "ply"];

/// Pixels per thousand whose channels may differ by more than [`FAR`]: drivers disagree about the edges of
/// triangles.
const FAR_PER_MILLE: usize = 15;
/// Difference of channels that counts as large, of 255.
const FAR: u8 = 32;

/// Largest mean difference of channels, of 255.
const MEAN: f64 = 1.0;

/// Builds the command and runs the demo for each kind of machine.
///
/// # Errors
/// If the demo fails on a kind of machine, or its files differ.
pub(crate) fn run() -> Result<()> {
    let command = built_command()?;
    let scratch = std::env::temp_dir().join(format!("striata-bare-{}", std::process::id()));
    machine::remove_folder(&scratch)?;
    let folders = KINDS.map(|kind| scratch.join(kind.name.replace(' ', "-")));
    for (kind, folder) in KINDS.iter().zip(&folders) {
        demo(&command, kind, folder).with_context(|| format!("a machine with {}", kind.name))?;
    }
    for (kind, folder) in KINDS.iter().zip(&folders).skip(1) {
        compare(&folders[0], folder).with_context(|| format!("a machine with {}", kind.name))?;
    }
    machine::remove_folder(&scratch)
}

/// Whether a line says how long a phase has run, as slow machines print.
fn is_progress(line: &str) -> bool {
    let time = line.rsplit_once(", ").and_then(|(_, time)| time.strip_suffix(" s"));
    time.is_some_and(|secs| secs.parse::<u32>().is_ok())
}

/// Runs the demo as a new user would; messages from drivers count as failures.
fn demo(command: &Path, kind: &MachineKind, folder: &Path) -> Result<()> {
    say(&format!("$ striata demo   ({})", kind.name));
    let mut run = std::process::Command::new(command);
    for (name, _) in KINDS.iter().flat_map(|kind| kind.environment) {
        run.env_remove(name);
    }
    // Bare machines have no session.
    run.env_remove("XDG_RUNTIME_DIR").arg("demo").arg(folder).envs(kind.environment.iter().copied());
    let output = run.output()?;
    let stderr = String::from_utf8_lossy(&output.stderr);
    ensure!(output.status.success(), "the demo ended with {}: {stderr}", output.status);
    for line in stderr.lines().take_while(|line| !line.starts_with("Open ")) {
        let is_expected = line.is_empty() || line.starts_with("note: ") || is_progress(line);
        ensure!(is_expected, "unexpected message: {line}");
        say(line);
    }
    Ok(())
}

/// Compares the files of two kinds of machines.
fn compare(expected: &Path, found: &Path) -> Result<()> {
    let names = names(expected)?;
    ensure!(names == self::names(found)?, "the files are {:?}, not {names:?}", self::names(found)?);
    let pictures: Vec<&String> = names.iter().filter(|name| name.ends_with(".png")).collect();
    ensure!(pictures.len() >= 4, "there are only {} pictures", pictures.len());
    for name in pictures {
        let [a, b] = [expected, found].map(|folder| PngPixels::read(&folder.join(name)));
        a?.expect_like(&b?).with_context(|| name.clone())?;
    }
    let is_exact = |name: &&String| SAME_BYTES.iter().any(|ending| name.ends_with(&format!(".{ending}")));
    for name in names.iter().filter(is_exact) {
        ensure!(std::fs::read(expected.join(name))? == std::fs::read(found.join(name))?, "{name} differs");
    }
    Ok(())
}

fn names(folder: &Path) -> Result<BTreeSet<String>> {
    let entries =
        std::fs::read_dir(folder)?.map(|entry| Ok(entry?.file_name().to_string_lossy().into_owned()));
    entries.collect()
}

/// A PNG file, decoded.
struct PngPixels {
    size: (u32, u32),
    channels: usize,
    bytes: Vec<u8>,
}

impl PngPixels {
    fn read(path: &PathBuf) -> Result<Self> {
        let mut reader = png::Decoder::new(BufReader::new(File::open(path)?)).read_info()?;
        let mut bytes = vec![0; reader.output_buffer_size().context("it is too large")?];
        let info = reader.next_frame(&mut bytes)?;
        bytes.truncate(info.buffer_size());
        Ok(Self { size: (info.width, info.height), channels: info.color_type.samples(), bytes })
    }

    fn expect_like(&self, other: &Self) -> Result<()> {
        ensure!((self.size, self.channels) == (other.size, other.channels), "sizes or channels differ");
        let pairs = self.bytes.iter().zip(&other.bytes).map(|(a, b)| a.abs_diff(*b));
        let mean = pairs.clone().map(f64::from).sum::<f64>() / self.bytes.len().max(1) as f64;
        let pixels = self.bytes.chunks(self.channels).zip(other.bytes.chunks(self.channels));
        let far = pixels.filter(|(a, b)| a.iter().zip(*b).any(|(x, y)| x.abs_diff(*y) > FAR)).count();
        let per_mille = 1000.0 * (far * self.channels) as f64 / self.bytes.len().max(1) as f64;
        say(&format!(
            "  channels differ by {mean:.2} of 255 on average, {per_mille:.1} ‰ of the pixels by more than \
             {FAR}"
        ));
        ensure!(mean <= MEAN && per_mille <= FAR_PER_MILLE as f64, "the pictures differ");
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn picture(byte: impl Fn(usize) -> u8) -> PngPixels {
        PngPixels { size: (100, 10), channels: 3, bytes: (0..3000).map(byte).collect() }
    }

    #[test]
    fn pictures_may_differ_a_little_and_no_more() {
        let gray = picture(|_| 100);
        gray.expect_like(&picture(|_| 101)).expect("rounding");
        gray.expect_like(&picture(|i| if i < 30 { 200 } else { 100 })).expect("a few pixels");
        assert!(gray.expect_like(&picture(|_| 102)).is_err(), "all pixels are lighter");
        assert!(
            gray.expect_like(&picture(|i| if i < 60 { 140 } else { 100 })).is_err(),
            "20 pixels are far off"
        );
        assert!(gray.expect_like(&PngPixels { size: (10, 100), ..picture(|_| 100) }).is_err());
    }
}
