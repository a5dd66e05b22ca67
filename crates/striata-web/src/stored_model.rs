//! Reads models that are stored in the sections of a `.striata` file.
//!
//! The library's own function also decodes patterns, which would add a tenth to the wasm that a page
//! fetches. So triangles are read here from the models that nearly all files contain; files with patterns
//! only are rejected with a hint.

use striata::file::StriataFile;
use striata::mesh::{IndexedMesh, RefinableMesh};
use striata::model::{LodModel, StoredModel};
use striata::strip::strip_triangles;

use crate::Failure;
use crate::built_model::BuiltModel;

/// Reads the mesh, its levels and, if present, the fans.
///
/// # Errors
/// If a section is invalid, or no section contains triangles.
pub(crate) fn read(file: &StriataFile<'_>) -> Result<BuiltModel, Failure> {
    let fans = file.fans().transpose()?;
    if fans.is_none() && !file.has_collapses() {
        return Err(patterns_only());
    }
    let mut mesh = IndexedMesh {
        positions: file.positions()?.into_owned(),
        origin: file.origin()?,
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
        return Err(patterns_only());
    }
    mesh.check().map_err(Failure::corrupt)?;
    let (found, expected) = (mesh.triangle_count(), file.summary().triangle_count);
    if found != expected {
        return Err(Failure::corrupt(format!(
            "the file contains {found} triangles, but its summary says {expected}"
        )));
    }
    Ok(match fans {
        Some(fans) => BuiltModel::from_parts(mesh, file.levels_of_fans(&fans)?, fans),
        None => BuiltModel::new(RefinableMesh { mesh, sequence: file.sequence()? }),
    })
}

/// Starts a group at the current end of the triangles.
fn begin_group(mesh: &mut IndexedMesh, group: usize) {
    let first = mesh.triangles.len() as u32;
    if let Some(group) = mesh.groups.get_mut(group) {
        group.first = first;
    }
}

fn patterns_only() -> Failure {
    Failure::unsupported("the file contains only the patterns model, which pages cannot show")
        .with_hint("build it again with `striata build --models fans`")
}
