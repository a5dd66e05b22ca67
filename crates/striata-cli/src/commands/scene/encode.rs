//! `encode` for scenes: one stream, or a GLB file that opens everywhere.

use std::path::Path;

use serde::Serialize;
use serde_json::Value;
use striata::LodOptions;
use striata::mesh::IndexedMesh;
use striata::simplify::BatchOptions;
use striata_command::clock::{Phases, peak_rss_bytes};
use striata_command::failure::Failure;
use striata_command::input::Input;
use striata_command::output::{Bar, Output, Table, format_bytes, format_count, format_duration};
use striata_command::save::{DEFAULT_NAME_NOTE, display_name, write_bytes};
use striata_command::scene::{edited, flat_scene, with_textures};
use striata_io::{Format, Scene, scene_losses};
use striata_scene::stream::{SceneStreamOptions, SceneStreamSizes, encode_scene_with_progress};
use striata_scene::{BuildError, GlbStreamOptions, LodScene};

use super::super::encode::warn_of_merging;
use super::build::mesh_count_text;
use crate::args::EncodeArgs;

/// Phases whose times are reported.
const PHASES: [&str; 3] = ["read", "encode", "write"];

#[derive(Serialize)]
struct SceneEncodeReport {
    path: String,
    format: &'static str,
    mesh_count: usize,
    triangle_count: usize,
    image_count: usize,
    /// Bytes of each kind of content of a stream; null for a GLB file.
    sizes: Option<Sizes>,
    #[serde(skip_serializing_if = "Option::is_none")]
    georeference: Option<Value>,
    output_bytes: usize,
    #[serde(flatten)]
    phases: Phases,
    peak_rss_bytes: Option<u64>,
}

#[derive(Serialize)]
struct Sizes {
    document_bytes: usize,
    base_bytes: usize,
    refinement_bytes: usize,
    /// Animations, skins, points and lines.
    buffer_bytes: usize,
    preview_bytes: usize,
    image_bytes: usize,
    packet_bytes: usize,
    /// Length of the prefix that shows every mesh.
    drawable_at: usize,
    /// Length of the prefix that shows every mesh, with previews of all images.
    textured_at: usize,
}

/// Encodes a scene, writes it, and reports.
///
/// # Errors
/// If any of this fails; an existing output is then left unchanged.
pub(in crate::commands) fn encode(
    args: &EncodeArgs,
    input: &Input,
    path: &Path,
    format: Format,
    output: &Output,
) -> Result<(), Failure> {
    let mut phases = Phases::new(&PHASES);
    let mut bar = output.bar();
    phases.enter("read");
    bar.phase("read");
    let is_mesh = args.scene.flat || input.scene_kind().is_none();
    let scene =
        if is_mesh { flat_scene(input, &display_name(path), output)? } else { input.scene(output)? };
    output.warn_of_losses(&scene_losses(format, &scene, &display_name(path)));
    let scene = edited(scene, &args.edits, true, output)?;
    let scene = with_textures(scene, args.textures.options().as_ref(), output)?;
    phases.enter("encode");
    let (bytes, sizes) = match format {
        Format::Glb => (glb(args, input, &scene, &mut bar)?, None),
        _ => {
            let options = stream_options(args, &scene)?;
            let vertex_count = scene.meshes().iter().flatten().map(IndexedMesh::vertex_count).sum();
            warn_of_merging(options.merged_position_count(&scene), vertex_count, output);
            let encoded = encode_scene_with_progress(&scene, &options, &mut |progress| bar.show(progress));
            let encoded = encoded.map_err(|error| Failure::user(format!("{}: {error}", input.name)))?;
            (encoded.bytes, Some(encoded.sizes.into()))
        }
    };
    phases.enter("write");
    bar.phase("write");
    write_bytes(&bytes, path)?;
    phases.leave();
    drop(bar);
    let report = SceneEncodeReport {
        path: display_name(path),
        format: format.extension(),
        mesh_count: scene.meshes().iter().flatten().count(),
        triangle_count: scene.triangle_count(),
        image_count: scene.images().len(),
        sizes,
        georeference: scene.georeference().cloned(),
        output_bytes: bytes.len(),
        phases,
        peak_rss_bytes: peak_rss_bytes(),
    };
    output.summary(&report, &report.to_text(args.output().is_none()))
}

fn batches(args: &EncodeArgs, lods: &LodOptions) -> BatchOptions {
    let mut batches = BatchOptions::default().with_sequence(lods.sequence.clone());
    batches.share = args.stream.share.unwrap_or(batches.share);
    batches
}

fn stream_options(args: &EncodeArgs, scene: &Scene) -> Result<SceneStreamOptions, Failure> {
    let lods = args.sequence.scene_options(scene, false)?;
    Ok(SceneStreamOptions::default()
        .with_stream(args.stream.options(scene.diagonal()))
        .with_batches(batches(args, &lods))
        .with_preview_side(args.preview))
}

/// Encodes a GLB file that shows a coarse level and contains the stream of each mesh.
fn glb(args: &EncodeArgs, input: &Input, scene: &Scene, bar: &mut Bar) -> Result<Vec<u8>, Failure> {
    let failed = |error: BuildError| Failure::user(format!("{}: {error}", input.name));
    let options = args.sequence.scene_options(scene, false)?;
    let batches = batches(args, &options);
    let lods = LodScene::build_with_progress(scene, &options, &mut |progress| bar.show(progress));
    let options =
        GlbStreamOptions::default().with_stream(args.stream.options(scene.diagonal())).with_batches(batches);
    let bytes = lods.map_err(failed)?.to_glb_with_stream(&options);
    bytes.map_err(|error| Failure::user(format!("{}: {error}", input.name)))
}

impl From<SceneStreamSizes> for Sizes {
    fn from(sizes: SceneStreamSizes) -> Self {
        Self {
            document_bytes: sizes.document_bytes,
            base_bytes: sizes.base_bytes,
            refinement_bytes: sizes.refinement_bytes,
            buffer_bytes: sizes.buffer_bytes,
            preview_bytes: sizes.preview_bytes,
            image_bytes: sizes.image_bytes,
            packet_bytes: sizes.packet_bytes,
            drawable_at: sizes.drawable_at,
            textured_at: sizes.textured_at,
        }
    }
}

impl SceneEncodeReport {
    fn to_text(&self, is_default_name: bool) -> String {
        let mut table = Table::default();
        let mut row = |name: &str, value: String| table.row(vec![name.to_owned(), value]);
        let meshes = mesh_count_text(self.mesh_count);
        row("triangles", format!("{} in {meshes}", format_count(self.triangle_count)));
        row("images", format_count(self.image_count));
        if let Some(sizes) = &self.sizes {
            for (part, bytes) in [
                ("document", sizes.document_bytes),
                ("base meshes", sizes.base_bytes),
                ("animations and skins", sizes.buffer_bytes),
                ("previews", sizes.preview_bytes),
                ("refinement", sizes.refinement_bytes),
                ("images", sizes.image_bytes),
                ("packets", sizes.packet_bytes),
            ] {
                row(&format!("  {part}"), format_bytes(bytes));
            }
            row("all meshes after", format_bytes(sizes.drawable_at));
            row("all previews after", format_bytes(sizes.textured_at));
        }
        let chosen = if is_default_name { DEFAULT_NAME_NOTE } else { "" };
        row("file", format!("{} ({}){chosen}", self.path, format_bytes(self.output_bytes)));
        row("time", format_duration(self.phases.total_secs()));
        table.to_text()
    }
}
