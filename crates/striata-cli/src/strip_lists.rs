//! Strips in the form that glTF requires: one index list per group, without restart indices.
//!
//! glTF has no restart index, so the strips of a group are joined by degenerate triangles. A strip of one
//! triangle then takes six indices, and groups of such strips (flat shading, soups, coarse levels) are
//! shorter as single triangles.

use std::path::Path;

use striata::mesh::{IndexedMesh, MeshError};
use striata::strip::{StripSet, stripify};
use striata_command::args::FormatArgs;
use striata_command::failure::Failure;
use striata_command::output::Output;
use striata_command::save::{check_place, format_of, is_stdout};
use striata_io::Format;

/// One index list per group: a single strip, or an empty list if a triangle list takes fewer indices.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct StripLists {
    /// The lists; an empty one stands for a triangle list.
    pub lists: Vec<Vec<u32>>,
    /// Number of indices needed to draw all groups.
    pub index_count: usize,
    /// Number of groups that are written as triangle lists.
    pub plain_group_count: usize,
}

impl StripLists {
    /// Joins the strips of each group of a mesh.
    pub(crate) fn new(mesh: &IndexedMesh, strips: &StripSet) -> Self {
        let mut out = Self { lists: stitched(strips), index_count: 0, plain_group_count: 0 };
        for (list, group) in out.lists.iter_mut().zip(mesh.groups_or_whole()) {
            let plain_count = 3 * group.count as usize;
            if list.len() > plain_count {
                list.clear();
                out.plain_group_count += 1;
                out.index_count += plain_count;
            }
            out.index_count += list.len();
        }
        out
    }

    /// Returns the strips that the model has for a level, or new ones if there are none or new ones are
    /// shorter.
    ///
    /// # Errors
    /// If the mesh is inconsistent.
    pub(crate) fn of_level(mesh: &IndexedMesh, model_strips: Option<&StripSet>) -> Result<Self, MeshError> {
        let restripified = Self::new(mesh, &stripify(mesh)?);
        let from_model = model_strips.map(|strips| Self::new(mesh, strips));
        Ok(from_model.filter(|lists| lists.index_count <= restripified.index_count).unwrap_or(restripified))
    }
}

/// Returns one index list per group, with the strips of the group joined by degenerate triangles.
pub(crate) fn stitched(strips: &StripSet) -> Vec<Vec<u32>> {
    let joined = strips.to_stitched_indices();
    let of_group =
        |range: &std::ops::Range<u32>| joined.indices[range.start as usize..range.end as usize].to_vec();
    joined.group_ranges.iter().map(of_group).collect()
}

/// Checks that the output can be written.
///
/// # Errors
/// If its format has no strips, or stdout would have to take both the output and the report.
pub(crate) fn check_output(path: &Path, format: &FormatArgs, output: &Output) -> Result<(), Failure> {
    output.check_stdout_is_free(is_stdout(path))?;
    let format = format_of(path, format)?;
    let instead = match format {
        Format::Ply => "use --block-triangles, which writes strips to .ply",
        _ => "remove -o to see only the cost of the strips",
    };
    check_form_fits("strips", path, format, instead)?;
    check_place(path)
}

/// Checks that a format supports strips or fans; `instead` is a hint for the user, besides choosing another
/// format.
///
/// # Errors
/// If the format does not support them.
pub(crate) fn check_form_fits(what: &str, path: &Path, format: Format, instead: &str) -> Result<(), Failure> {
    if matches!(format, Format::Glb | Format::Gltf) {
        return Ok(());
    }
    let name = if is_stdout(path) { "stdout".into() } else { path.to_string_lossy() };
    Err(Failure::usage(format!("{name}: {format} files cannot contain {what}"))
        .with_hint(format!("write .glb or .gltf (`--to glb` for stdout), or {instead}")))
}

#[cfg(test)]
mod tests {
    use striata::mesh::{TriangleGroup, shapes};

    use super::*;

    fn group(first: u32, count: u32) -> TriangleGroup {
        TriangleGroup { name: String::new(), material: None, first, count }
    }

    #[test]
    fn groups_of_separate_triangles_become_triangle_lists() {
        let mut mesh = shapes::grid(4, 1);
        let (strip_count, first) = (mesh.triangle_count() as u32, mesh.positions.len() as u32);
        for i in 0..3 {
            let at = i as f32;
            mesh.positions.extend([[at, 9.0, 0.0], [at + 0.5, 9.0, 0.0], [at, 9.5, 0.0]]);
            mesh.triangles.push([first + 3 * i, first + 3 * i + 1, first + 3 * i + 2]);
        }
        mesh.groups = vec![group(0, strip_count), group(strip_count, 3), group(strip_count + 3, 0)];
        let strips = stripify(&mesh).expect("the mesh is consistent");
        let lists = StripLists::new(&mesh, &strips);
        assert_eq!((lists.lists[1].len(), lists.lists[2].len(), lists.plain_group_count), (0, 0, 1));
        assert_eq!(lists.index_count, lists.lists[0].len() + 9);
        assert_eq!(StripLists::of_level(&mesh, Some(&strips)).expect("the mesh is consistent"), lists);
    }

    #[test]
    fn a_level_is_restripified_if_that_saves_indices() {
        let mesh = shapes::grid(8, 8);
        let mut single_triangles = StripSet::new();
        mesh.triangles.iter().for_each(|triangle| single_triangles.push(triangle));
        single_triangles.end_group();
        let found = StripLists::of_level(&mesh, Some(&single_triangles)).expect("the mesh is consistent");
        assert!(found.index_count < 2 * mesh.triangle_count(), "{}", found.index_count);
        assert_eq!(found, StripLists::of_level(&mesh, None).expect("the mesh is consistent"));
    }
}
