//! `encode`: compresses a mesh into a progressive stream.

use std::path::Path;

use serde::Serialize;
use serde_json::{Value, json};
use striata::file::{WriteOptions, write_fragments, write_striata};
use striata::mesh::{IndexedMesh, Steps, weld};
use striata_io::{Format, losses};
use striata_stream::{
    EncodedStream, StreamInfo, StreamLevels, StreamOptions, encode_fragments_with_progress,
    encode_stream_with_progress, file_model,
};

use super::paged::open_input;
use super::scene;
use crate::args::EncodeArgs;
use striata_command::clock::{Phases, peak_rss_bytes};
use striata_command::failure::Failure;
use striata_command::input::Input;
use striata_command::output::{
    Bar, Output, Table, format_bytes, format_count, format_duration, format_length,
};
use striata_command::save::{
    DEFAULT_NAME_NOTE, check_not_compressed, check_place, default_output_path, display_name, georeference_of,
    is_stdout, write_bytes,
};
use striata_command::scene::with_mesh_textures;
use striata_command::sequence::{Limits, SequencePlan, SimplifiedSteps};
use striata_command::stream::{precision_name, stream_facts_json};

/// Phases whose times are reported.
const PHASES: [&str; 5] = ["read", "weld", "simplify", "encode", "write"];

/// Reads and encodes the mesh, writes the stream, and reports.
///
/// # Errors
/// If any of this fails; an existing output is then left unchanged.
pub(crate) fn run(args: &EncodeArgs, output: &Output) -> Result<(), Failure> {
    let path = match args.output() {
        Some(path) => path.to_owned(),
        None => default_output_path(&args.input, "stri")?,
    };
    output.check_stdout_is_free(is_stdout(&path))?;
    check_not_compressed(&path, "streams")?;
    let format = format_of_output(&path)?;
    check_place(&path)?;
    let mut phases = Phases::new(&PHASES);
    let mut bar = output.bar();
    phases.enter("read");
    bar.phase("read");
    let input = open_input(&args.input, usize::MAX)?.with_raster(args.raster)?;
    if is_scene(&input, format, args) {
        return encode_scene(args, &input, &path, format, output);
    }
    let mesh = input.mesh(output)?;
    if !mesh.appearance.images.is_empty() && format == Format::Stream && !args.scene.flat {
        let losses = losses(Format::Glb, &mesh, &input.name);
        if losses.is_empty() {
            // The stream of a scene sends previews of textures before the textures.
            return encode_scene(args, &input, &path, format, output);
        }
        output.say("note: encoded as one mesh, since the stream of a scene cannot hold all of its data");
    }
    let mesh = with_mesh_textures(mesh, args.textures.options().as_ref(), output)?;
    phases.enter("weld");
    let welded = weld(&mesh).map_err(|error| Failure::from(error).in_file(&input.name))?;
    phases.enter("simplify");
    let mut plan = args.sequence.plan_for(&mesh, Limits::default())?;
    if let SequencePlan::Quadric { .. } = plan {
        plan.use_batches(args.stream.batches(&mesh)?)?;
    }
    args.sequence.warn_about_groups(&mesh, output);
    let sequenced = plan.run(welded, &mut |progress| bar.show(progress));
    let sequenced = sequenced.map_err(|error| Failure::from(error).in_file(&input.name))?;
    phases.enter("encode");
    bar.phase("encode");
    let options = args.stream.options(mesh.diagonal());
    let stream = encoded(&sequenced, &options, &mut bar)?;
    let merged = options.merged_position_count(&mesh).unwrap_or(0);
    warn_of_merging(merged, mesh.vertex_count(), output);
    let bytes = match format == Format::Striata {
        true => in_striata_file(&stream, &input.file_name())?,
        false => stream.bytes.clone(),
    };
    phases.enter("write");
    bar.phase("write");
    write_bytes(&bytes, &path)?;
    phases.leave();
    drop(bar);
    let encoded = EncodeResult { mesh: &mesh, sequenced: &sequenced, stream: &stream };
    let report = EncodeReport::new(&encoded, display_name(&path), bytes.len(), phases)?;
    output.summary(&report, &report.to_text(args, &options))
}

/// Warns if rounding makes more than one in a thousand vertices fall on others.
pub(super) fn warn_of_merging(merged: usize, vertex_count: usize, output: &Output) {
    if merged * 1000 > vertex_count {
        let (merged, all) = (format_count(merged), format_count(vertex_count));
        output.say(&format!(
            "warning: at this precision, {merged} of {all} vertices fall on others; --bits or --lossless keeps them apart"
        ));
    }
}

/// Encodes the collapses batch by batch, or all steps as fragments if there are no batches.
///
/// # Errors
/// If the mesh cannot be encoded.
fn encoded(
    sequenced: &SimplifiedSteps,
    options: &StreamOptions,
    bar: &mut Bar,
) -> Result<EncodedStream, Failure> {
    let mut show = |progress| bar.show(progress);
    if let (Steps::Collapses(refinable), Some(batches)) = (&sequenced.steps, &sequenced.batches) {
        return Ok(encode_stream_with_progress(refinable, batches, options, &mut show)?);
    }
    Ok(encode_fragments_with_progress(&*sequenced.fragments(&mut show)?, options, &mut show)?)
}

/// Returns the format that the name requests.
///
/// # Errors
/// If the name is that of another format.
fn format_of_output(path: &Path) -> Result<Format, Failure> {
    match Format::from_extension(path) {
        Some(format @ (Format::Striata | Format::Glb)) => Ok(format),
        None | Some(Format::Stream) => Ok(Format::Stream),
        Some(_) => Err(Failure::usage(format!("{}: `encode` writes streams", path.display()))
            .with_hint("use the extension .stri, .glb or .striata; `striata convert` writes meshes")),
    }
}

/// Whether the input is encoded as a scene: GLB files always contain one.
fn is_scene(input: &Input, format: Format, args: &EncodeArgs) -> bool {
    format == Format::Glb || (input.scene_kind().is_some() && !args.scene.flat)
}

/// Encodes the input as a scene.
///
/// # Errors
/// If this fails, or the output is a `.striata` file.
fn encode_scene(
    args: &EncodeArgs,
    input: &Input,
    path: &Path,
    format: Format,
    output: &Output,
) -> Result<(), Failure> {
    if format == Format::Striata {
        let path = path.display();
        return Err(Failure::user(format!("{path}: a .striata file cannot contain the stream of a scene"))
            .with_hint("use the extension .stri or .glb, or write the levels with `striata build`"));
    }
    scene::encode(args, input, path, format, output)
}

/// Wraps the stream in a `.striata` file without other models.
fn in_striata_file(stream: &EncodedStream, source: &str) -> Result<Vec<u8>, Failure> {
    let options = WriteOptions::default()
        .with_metadata("creator", concat!("striata ", env!("CARGO_PKG_VERSION")))
        .with_metadata("source", source);
    let models = [file_model(&stream.bytes)?];
    let mut bytes = Vec::new();
    match StreamLevels::decoded(&stream.bytes)?.into_steps()? {
        Steps::Collapses(refinable) => write_striata(&refinable, &models, &options, &mut bytes)?,
        Steps::Fragments(fragmented) => write_fragments(&fragmented, &models, &options, &mut bytes)?,
    }
    Ok(bytes)
}

/// The data that the report is made from.
struct EncodeResult<'a> {
    mesh: &'a IndexedMesh,
    sequenced: &'a SimplifiedSteps,
    stream: &'a EncodedStream,
}

#[derive(Serialize)]
struct EncodeReport {
    path: String,
    vertex_count: usize,
    triangle_count: usize,
    position_count: usize,
    step_count: usize,
    /// Null if the steps are not in batches.
    batch_count: Option<usize>,
    base: Value,
    error_max: f32,
    effort: Value,
    stream: Value,
    /// Size of the whole output.
    bits_per_vertex: f64,
    connectivity_bits_per_vertex: f64,
    position_bits_per_vertex: f64,
    attribute_bits_per_vertex: f64,
    /// Size of the base mesh, the header, and the file around the stream, if any.
    other_bits_per_vertex: f64,
    #[serde(skip_serializing_if = "Option::is_none")]
    georeference: Option<Value>,
    output_bytes: usize,
    #[serde(flatten)]
    phases: Phases,
    peak_rss_bytes: Option<u64>,
}

impl EncodeReport {
    fn new(
        encoded: &EncodeResult<'_>,
        path: String,
        output_bytes: usize,
        phases: Phases,
    ) -> Result<Self, Failure> {
        let levels = encoded.sequenced.steps.levels();
        let facts = StreamInfo::read(&encoded.stream.bytes)?.unwrap_or_default();
        let stream = stream_facts_json(&facts);
        let sizes = &encoded.stream.sizes;
        let vertex_count = encoded.mesh.vertex_count();
        let per_vertex = |bits: f64| bits / vertex_count.max(1) as f64;
        let output_bits = output_bytes as f64 * 8.0;
        let coded_bits = sizes.connectivity_bits + sizes.position_bits + sizes.attribute_bits;
        Ok(Self {
            path,
            vertex_count,
            triangle_count: encoded.mesh.triangle_count(),
            position_count: levels.positions().position_count(),
            step_count: levels.step_count(),
            batch_count: encoded.sequenced.batches.as_ref().map(|batches| batches.len() - 1),
            base: json!({
                "vertex_count": levels.base_vertex_count(),
                "triangle_count": levels.triangle_count_at(0),
            }),
            error_max: levels.error_at(0),
            effort: stream["effort"].clone(),
            stream,
            bits_per_vertex: per_vertex(output_bits),
            connectivity_bits_per_vertex: per_vertex(sizes.connectivity_bits),
            position_bits_per_vertex: per_vertex(sizes.position_bits),
            attribute_bits_per_vertex: per_vertex(sizes.attribute_bits),
            other_bits_per_vertex: per_vertex(output_bits - coded_bits),
            georeference: georeference_of(encoded.mesh),
            output_bytes,
            phases,
            peak_rss_bytes: peak_rss_bytes(),
        })
    }

    fn to_text(&self, args: &EncodeArgs, options: &StreamOptions) -> String {
        let mut table = Table::default();
        let mut row = |name: &str, value: String| table.row(vec![name.to_owned(), value]);
        row(
            "triangles",
            format!("{} down to {}", format_count(self.triangle_count), self.base["triangle_count"]),
        );
        row("vertices", format_count(self.vertex_count));
        let batches = self.batch_count.map_or_else(String::new, |count| format!(" in {count} batches"));
        row("levels", format_count(self.step_count + 1) + &batches);
        row("error of base mesh", format_length(self.error_max.into()));
        let effort = self.effort.as_str().unwrap_or_default();
        row("encoding", format!("{}, {effort} effort", precision_name(options.precision)));
        row("bits per vertex", format!("{:.2}", self.bits_per_vertex));
        for (part, bits) in [
            ("  connectivity", self.connectivity_bits_per_vertex),
            ("  positions", self.position_bits_per_vertex),
            ("  attributes", self.attribute_bits_per_vertex),
            ("  base and headers", self.other_bits_per_vertex),
        ] {
            row(part, format!("{bits:.2}"));
        }
        let chosen = if args.output().is_none() { DEFAULT_NAME_NOTE } else { "" };
        row("file", format!("{} ({}){chosen}", self.path, format_bytes(self.output_bytes)));
        row("time", format_duration(self.phases.total_secs()));
        table.to_text()
    }
}
