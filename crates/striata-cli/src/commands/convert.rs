//! `convert`: converts a mesh to another format.

use serde::Serialize;
use serde_json::Value;

use super::{paged, scene};
use crate::args::ConvertArgs;
use striata_command::failure::Failure;
use striata_command::output::{Output, format_count};
use striata_command::save::{Primitives, display_name, format_of, georeference_of, is_stdout, write_mesh};
use striata_command::scene::with_mesh_textures;

#[derive(Serialize)]
struct Report {
    vertex_count: usize,
    triangle_count: usize,
    format: &'static str,
    #[serde(skip_serializing_if = "Option::is_none")]
    georeference: Option<Value>,
}

/// Reads the input and writes the output.
///
/// # Errors
/// If either fails.
pub(crate) fn run(args: &ConvertArgs, output: &Output) -> Result<(), Failure> {
    let path = args.output().ok_or_else(|| Failure::internal("no output was named"))?;
    output.check_stdout_is_free(is_stdout(path))?;
    let format = format_of(path, &args.format)?;
    let input = paged::open_input(&args.input, usize::MAX)?;
    if format.has_scenes() && input.scene_kind().is_some() && !args.scene.flat {
        return scene::convert(args, &input, path, format.extension(), output);
    }
    let mesh = with_mesh_textures(input.mesh(output)?, args.textures.options().as_ref(), output)?;
    // Meshes keep the order that they come in; levels have none of their own.
    let has_levels = input.has_levels() || input.has_scene_levels();
    let primitives = if has_levels { Primitives::Triangles } else { Primitives::UnsortedTriangles };
    write_mesh(&mesh, primitives, path, &args.format, output)?;
    let report = Report {
        vertex_count: mesh.vertex_count(),
        triangle_count: mesh.triangle_count(),
        format: format.extension(),
        georeference: georeference_of(&mesh),
    };
    let text = format!(
        "{}: {} vertices, {} triangles",
        display_name(path),
        format_count(report.vertex_count),
        format_count(report.triangle_count)
    );
    output.summary(&report, &text)
}
