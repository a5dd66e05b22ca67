//! Peak memory of welding and simplifying one mesh, measured in a separate process.
//!
//! The kernel reports the resident set (`/proc/self/status`), so the table is available on Linux only.

use std::env;
use std::fs;
use std::hint::black_box;
use std::io::Write;
use std::process::Command;

use striata::mesh::{IndexedMesh, weld};

use crate::table::Table;
use crate::{Fallible, Request, Subject, simplifiers_of};

/// Environment variables that pass the mesh and the cost to a child process.
const MESH_VARIABLE: &str = "STRIATA_MEMORY_MESH";
const COST_VARIABLE: &str = "STRIATA_MEMORY_COST";

pub(crate) struct ChildRequest {
    path: String,
    cost: String,
}

impl ChildRequest {
    pub(crate) fn from_environment() -> Option<Self> {
        Some(Self { path: env::var(MESH_VARIABLE).ok()?, cost: env::var(COST_VARIABLE).ok()? })
    }

    /// Prints the resident bytes with only the mesh loaded, and the peak while simplifying it.
    pub(crate) fn measure(self) -> Fallible<()> {
        let mesh = striata_io::read(&self.path)?;
        let mesh = IndexedMesh::new(mesh.positions, mesh.triangles);
        // Reset the peak so that reading does not count.
        fs::write("/proc/self/clear_refs", "5")?;
        let loaded = status_bytes("VmRSS:")?;
        for simplifier in simplifiers_of(&self.cost)? {
            black_box(simplifier.build(weld(&mesh)?)?);
        }
        let peak = status_bytes("VmHWM:")?;
        writeln!(std::io::stdout(), "{loaded} {peak}")?;
        Ok(())
    }
}

fn status_bytes(key: &str) -> Fallible<u64> {
    let status = fs::read_to_string("/proc/self/status")?;
    let line = status
        .lines()
        .find_map(|line| line.strip_prefix(key))
        .ok_or("the kernel does not report this count")?;
    let kibibytes: u64 = line.trim().trim_end_matches("kB").trim().parse()?;
    Ok(kibibytes * 1024)
}

pub(crate) fn report(request: &Request, subjects: &[Subject], out: &mut dyn Write) -> Fallible<()> {
    if !cfg!(target_os = "linux") {
        return Ok(());
    }
    writeln!(out, "Peak resident memory of a process that welds and simplifies, in bytes per triangle.\n")?;
    let mut table = Table::new(["mesh", "cost", "the process", "above the loaded mesh"]);
    for (path, subject) in request.paths.iter().zip(subjects) {
        for simplifier in &request.simplifiers {
            let mut child = Command::new(env::current_exe()?);
            let output = child.env(MESH_VARIABLE, path).env(COST_VARIABLE, simplifier.name()).output()?;
            let text = String::from_utf8(output.stdout)?;
            let numbers = text.split_whitespace().map(str::parse).collect::<Result<Vec<u64>, _>>()?;
            let [loaded, peak] = numbers[..] else {
                return Err(String::from_utf8_lossy(&output.stderr).into());
            };
            let per_triangle =
                |bytes: u64| format!("{:.0}", bytes as f64 / subject.mesh().triangle_count() as f64);
            let above = peak.saturating_sub(loaded);
            table.push(vec![
                subject.name.clone(),
                simplifier.name(),
                per_triangle(peak),
                per_triangle(above),
            ]);
        }
    }
    table.print(out)?;
    Ok(())
}
