//! Models that stand in the sections of a `.striata` file.
//!
//! The library's own way to a file's mesh knows patterns too, and with them comes a tenth of what a page would fetch; so
//! triangles are taken here from what nearly all files have. Files of patterns alone are refused, with the cure.

use striata::file::StriataFile;
use striata::mesh::{IndexedMesh, RefinableMesh};
use striata::model::{LodModel, StoredModel};
use striata::strip::strip_triangles;

use crate::Failure;
use crate::built::Built;

/// Reads mesh, steps and, where they are there, fans.
///
/// # Errors
/// Where a section is unsound, or there is none that holds triangles.
pub(crate) fn read(file: &StriataFile<'_>) -> Result<Built, Failure> {
    if !file.has_collapses() {
        return Err(of_patterns());
    }
    let fans = file.fans().transpose()?;
    let mut mesh = IndexedMesh {
        positions: file.positions()?.into_owned(),
        layers: file.layers()?,
        groups: file.groups()?,
        ..IndexedMesh::default()
    };
    if let Some(fans) = &fans {
        let full = fans.new_state();
        for group in 0..fans.group_count() {
            begin_group(&mut mesh, group);
            fans.group_triangles_into(&full, group, &mut mesh.triangles);
        }
    } else if let Some(strips) = file.strips().transpose()? {
        for group in 0..strips.group_count() {
            begin_group(&mut mesh, group);
            for strip in strips.group_strips(group) {
                mesh.triangles.extend(strip_triangles(strips.strip(strip)));
            }
        }
    } else if let Some(triangles) = file.triangles().transpose()? {
        mesh.triangles = triangles.into_owned();
    } else {
        return Err(of_patterns());
    }
    mesh.check().map_err(Failure::corrupt)?;
    let refinable = RefinableMesh { mesh, sequence: file.sequence()? };
    let (found, expected) = (refinable.mesh.triangle_count(), file.summary().triangle_count);
    if found != expected {
        return Err(Failure::corrupt(format!("the file holds {found} triangles, but says {expected}")));
    }
    Ok(match fans {
        Some(fans) => Built::of_parts(refinable, fans),
        None => Built::new(refinable),
    })
}

/// Triangles of a group begin where those of the one before end.
fn begin_group(mesh: &mut IndexedMesh, group: usize) {
    let first = mesh.triangles.len() as u32;
    if let Some(group) = mesh.groups.get_mut(group) {
        group.first = first;
    }
}

fn of_patterns() -> Failure {
    Failure::unsupported("the file knows its levels by patterns alone, which pages do not show")
        .with_hint("`striata encode` makes a stream of it, and `striata build` without --model patterns a file with fans")
}
