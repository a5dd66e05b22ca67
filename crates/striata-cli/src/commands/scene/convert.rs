//! `convert` for scenes.

use std::path::Path;

use serde::Serialize;
use striata_command::failure::Failure;
use striata_command::input::Input;
use striata_command::output::{Output, format_count, format_noun_count};
use striata_command::save::{display_name, write_scene};
use striata_command::scene::{edited, with_textures};

use crate::args::ConvertArgs;

#[derive(Serialize)]
struct Report {
    vertex_count: usize,
    triangle_count: usize,
    mesh_count: usize,
    format: &'static str,
}

/// Reads a scene, writes it, and reports.
///
/// # Errors
/// If either fails.
pub(in crate::commands) fn convert(
    args: &ConvertArgs,
    input: &Input,
    path: &Path,
    format: &'static str,
    output: &Output,
) -> Result<(), Failure> {
    let scene = edited(input.scene(output)?, &args.edits, false, output)?;
    let scene = with_textures(scene, args.textures.options().as_ref(), output)?;
    write_scene(&scene, input.has_scene_levels(), path, &args.format, output)?;
    let report = Report {
        vertex_count: scene.meshes().iter().flatten().map(|mesh| mesh.vertex_count()).sum(),
        triangle_count: scene.triangle_count(),
        mesh_count: scene.meshes().iter().flatten().count(),
        format,
    };
    let text = format!(
        "{}: {} vertices in {}, {} triangles",
        display_name(path),
        format_count(report.vertex_count),
        format_noun_count(report.mesh_count, "mesh", "meshes"),
        format_count(report.triangle_count)
    );
    output.summary(&report, &text)
}
