//! `encode`: a mesh becomes a progressive stream.

use std::path::Path;

use serde::Serialize;
use serde_json::{Value, json};
use striata::file::{WriteOptions, to_striata};
use striata::mesh::{IndexedMesh, RefinableMesh, weld};
use striata_io::Format;
use striata_stream::{EncodedStream, StreamInfo, StreamOptions, encode_stream, file_model};

use crate::args::EncodeArgs;
use striata_command::clock::{Phases, peak_rss_bytes};
use striata_command::failure::Failure;
use striata_command::input::Input;
use striata_command::output::{Output, Table, format_bytes, format_count, format_duration, format_length};
use striata_command::save::{CHOSEN_NAME, beside, check_not_packed, is_stdout, name_of, put};
use striata_command::sequence::{SequencePlan, Steps};
use striata_command::stream::{facts_in_json, precision_name};

/// The phases that are reported.
const PHASES: [&str; 5] = ["read", "weld", "simplify", "encode", "write"];

/// Reads, encodes, writes, reports.
///
/// # Errors
/// Where any of it fails; the output is then as it was.
pub(crate) fn run(args: &EncodeArgs, output: &Output) -> Result<(), Failure> {
    let path = match &args.output {
        Some(path) => path.clone(),
        None => beside(&args.input, "stri")?,
    };
    output.check_stdout_is_free(is_stdout(&path))?;
    check_not_packed(&path, "streams")?;
    let in_container = is_container(&path)?;
    let mut phases = Phases::new(&PHASES);
    let mut bar = output.bar();
    phases.enter("read");
    bar.phase("read");
    let input = Input::open(&args.input)?;
    let mesh = input.mesh(output)?;
    phases.enter("weld");
    let welded = weld(&mesh).map_err(|error| Failure::from(error).in_file(&input.name))?;
    phases.enter("simplify");
    let mut plan = SequencePlan::default();
    plan.come_in_batches(args.stream.batches(&mesh)?)?;
    let sequenced = plan.run(welded, &mut |progress| bar.show(progress));
    let sequenced = sequenced.map_err(|error| Failure::from(error).in_file(&input.name))?;
    let (Steps::Collapses(refinable), Some(batches)) = (&sequenced.steps, &sequenced.batches) else {
        return Err(Failure::internal("collapses come in batches"));
    };
    phases.enter("encode");
    bar.phase("encode");
    let options = args.stream.options(mesh.diagonal());
    let stream = encode_stream(refinable, batches, &options)?;
    let bytes = match in_container {
        true => contained(refinable, &stream, &input.file_name())?,
        false => stream.bytes.clone(),
    };
    phases.enter("write");
    bar.phase("write");
    put(&bytes, &path)?;
    phases.leave();
    drop(bar);
    let made = Made { mesh: &mesh, refinable, batch_count: batches.len() - 1, stream: &stream };
    let report = Report::new(&made, (name_of(&path), bytes.len()), phases)?;
    output.summary(&report, &report.to_text(args, &options))
}

/// Whether the name asks for a `.striata` file around the stream.
///
/// # Errors
/// Where it says that the output is something else.
fn is_container(path: &Path) -> Result<bool, Failure> {
    match Format::from_extension(path) {
        Some(Format::Striata) => Ok(true),
        None | Some(Format::Stream) => Ok(false),
        Some(_) => Err(Failure::user(format!("{}: `encode` writes streams", path.display()))
            .with_hint("end the name in .stri or .striata; `striata convert` writes meshes")),
    }
}

/// The stream as all that a `.striata` file has.
fn contained(refinable: &RefinableMesh, stream: &EncodedStream, source: &str) -> Result<Vec<u8>, Failure> {
    let options = WriteOptions::default()
        .with_metadata("creator", concat!("striata ", env!("CARGO_PKG_VERSION")))
        .with_metadata("source", source);
    Ok(to_striata(&stream.reorder(refinable), &[file_model(&stream.bytes)?], &options)?)
}

/// What a report is made from.
struct Made<'a> {
    mesh: &'a IndexedMesh,
    refinable: &'a RefinableMesh,
    batch_count: usize,
    stream: &'a EncodedStream,
}

#[derive(Serialize)]
struct Report {
    path: String,
    vertex_count: usize,
    triangle_count: usize,
    position_count: usize,
    step_count: usize,
    batch_count: usize,
    base: Value,
    error_max: f32,
    effort: Value,
    stream: Value,
    /// All bytes of the output.
    bits_per_vertex: f64,
    connectivity_bits_per_vertex: f64,
    position_bits_per_vertex: f64,
    attribute_bits_per_vertex: f64,
    /// The base mesh, the head, and what a file around the stream takes.
    other_bits_per_vertex: f64,
    output_bytes: usize,
    phases: Phases,
    secs: f64,
    peak_rss_bytes: Option<u64>,
}

impl Report {
    fn new(made: &Made<'_>, (path, output_bytes): (String, usize), phases: Phases) -> Result<Self, Failure> {
        let sequence = &made.refinable.sequence;
        let facts = StreamInfo::read(&made.stream.bytes)?.unwrap_or_default();
        let stream = facts_in_json(&facts);
        let sizes = &made.stream.sizes;
        let vertex_count = made.mesh.vertex_count();
        let per_vertex = |bits: f64| bits / vertex_count.max(1) as f64;
        let output_bits = output_bytes as f64 * 8.0;
        let told = sizes.connectivity_bits + sizes.position_bits + sizes.attribute_bits;
        Ok(Self {
            path,
            vertex_count,
            triangle_count: made.mesh.triangle_count(),
            position_count: sequence.positions().position_count(),
            step_count: sequence.step_count(),
            batch_count: made.batch_count,
            base: json!({
                "vertex_count": sequence.base_vertex_count(),
                "triangle_count": sequence.triangle_count_at(0),
            }),
            error_max: sequence.error_at(0),
            effort: stream["effort"].clone(),
            stream,
            bits_per_vertex: per_vertex(output_bits),
            connectivity_bits_per_vertex: per_vertex(sizes.connectivity_bits),
            position_bits_per_vertex: per_vertex(sizes.position_bits),
            attribute_bits_per_vertex: per_vertex(sizes.attribute_bits),
            other_bits_per_vertex: per_vertex(output_bits - told),
            output_bytes,
            secs: phases.total_secs(),
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
        row("levels", format!("{} in {} batches", format_count(self.step_count + 1), self.batch_count));
        row("error of the base", format_length(self.error_max.into()));
        let effort = self.effort.as_str().unwrap_or_default();
        row("coded", format!("{}, {effort} effort", precision_name(options.precision)));
        row("bits a vertex", format!("{:.2}", self.bits_per_vertex));
        for (part, bits) in [
            ("  connectivity", self.connectivity_bits_per_vertex),
            ("  positions", self.position_bits_per_vertex),
            ("  attributes", self.attribute_bits_per_vertex),
            ("  base, head, rest", self.other_bits_per_vertex),
        ] {
            row(part, format!("{bits:.2}"));
        }
        let chosen = if args.output.is_none() { CHOSEN_NAME } else { "" };
        row("file", format!("{} ({}){chosen}", self.path, format_bytes(self.output_bytes)));
        row("time", format_duration(self.secs));
        table.to_text()
    }
}
