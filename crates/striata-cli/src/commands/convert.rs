//! `convert`: converts a mesh or scene to another format.

use serde::Serialize;
use serde_json::Value;

use super::paged;
use crate::args::ConvertArgs;
use striata_command::failure::Failure;
use striata_command::output::{Output, format_count, format_noun_count};
use striata_command::save::{
    Primitives, check_place, display_name, format_of, georeference_of, is_stdout, write_mesh, write_scene,
};
use striata_command::scene::{edited, with_mesh_textures, with_textures};

#[derive(Serialize)]
struct ConvertReport {
    vertex_count: usize,
    triangle_count: usize,
    /// For a scene that stays one.
    #[serde(skip_serializing_if = "Option::is_none")]
    mesh_count: Option<usize>,
    format: &'static str,
    #[serde(skip_serializing_if = "Option::is_none")]
    georeference: Option<Value>,
}

/// Reads the input and writes the output.
///
/// # Errors
/// If either fails.
pub(crate) fn run(args: &ConvertArgs, output: &Output) -> Result<(), Failure> {
    let path = args.output.path();
    output.check_stdout_is_free(is_stdout(path))?;
    let format = format_of(path, &args.output.format)?;
    check_place(path)?;
    let input = paged::open_input(&args.input, usize::MAX)?.with_raster(args.raster)?;
    let textures = args.textures.options();
    let report = if format.has_scenes() && input.scene_kind().is_some() && !args.scene.flat {
        let scene = edited(input.scene(output)?, &args.edits, false, output)?;
        let scene = with_textures(scene, textures.as_ref(), output)?;
        write_scene(&scene, input.has_scene_levels(), path, &args.output.format, output)?;
        ConvertReport {
            vertex_count: scene.meshes().iter().flatten().map(|mesh| mesh.vertex_count()).sum(),
            triangle_count: scene.triangle_count(),
            mesh_count: Some(scene.meshes().iter().flatten().count()),
            format: format.extension(),
            georeference: scene.georeference().cloned(),
        }
    } else {
        let mesh = with_mesh_textures(input.mesh(output)?, textures.as_ref(), output)?;
        // Meshes keep the order that they come in; levels have none of their own.
        let has_levels = input.has_levels() || input.has_scene_levels();
        let primitives = if has_levels { Primitives::Triangles } else { Primitives::UnsortedTriangles };
        write_mesh(&mesh, primitives, path, &args.output.format, output)?;
        ConvertReport {
            vertex_count: mesh.vertex_count(),
            triangle_count: mesh.triangle_count(),
            mesh_count: None,
            format: format.extension(),
            georeference: georeference_of(&mesh),
        }
    };
    let meshes = report
        .mesh_count
        .map_or_else(String::new, |count| format!(" in {}", format_noun_count(count, "mesh", "meshes")));
    let text = format!(
        "{}: {} vertices{meshes}, {} triangles",
        display_name(path),
        format_count(report.vertex_count),
        format_count(report.triangle_count)
    );
    output.summary(&report, &text)
}
