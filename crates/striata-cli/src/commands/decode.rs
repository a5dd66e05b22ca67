//! `decode`: the mesh of a stream, or of as much of it as is there.

use std::time::Instant;

use serde::Serialize;
use striata::codec::StriataFile;

use crate::args::DecodeArgs;
use crate::failure::Failure;
use crate::input::Input;
use crate::output::{Output, grouped, lasted, measured};
use crate::save::{Drawn, format_of, is_stdout, save};
use crate::stream::{Received, effort_name};

#[derive(Serialize)]
struct Report {
    vertex_count: usize,
    triangle_count: usize,
    split_count: usize,
    step_count: usize,
    is_complete: bool,
    effort: &'static str,
    /// Bytes of the stream that are there.
    read_bytes: usize,
    /// Bytes of the whole stream.
    stream_bytes: u64,
    error: f32,
    decode_secs: f64,
    /// In the decoder alone.
    triangles_per_sec: f64,
    secs: f64,
}

/// Reads, decodes, writes, reports.
///
/// # Errors
/// Where any of it fails.
pub(crate) fn run(args: &DecodeArgs, output: &Output) -> Result<(), Failure> {
    let started = Instant::now();
    output.check_stdout_is_free(is_stdout(&args.output.output))?;
    format_of(&args.output.output, &args.output.format)?;
    let mut bar = output.bar();
    bar.phase("read");
    let input = Input::open(&args.input)?;
    let file = input.striata()?;
    let stream = stream_of(&file, &input)?;
    bar.phase("decode");
    let received = Received::read_all(stream).map_err(|error| input.damaged(&error))?;
    let mesh = received.refinable().map_err(|error| input.damaged(&error))?.mesh;
    bar.phase("write");
    save(&mesh, Drawn::Triangles, &args.output.output, &args.output.format)?;
    drop(bar);
    if let Some(remark) = received.remark(&input.name) {
        output.say(&remark);
    }
    let report = Report {
        vertex_count: mesh.vertex_count(),
        triangle_count: mesh.triangle_count(),
        split_count: received.decoder.split_count(),
        step_count: received.facts.step_count,
        is_complete: !received.is_cut,
        effort: effort_name(received.facts.effort),
        read_bytes: received.read_bytes,
        stream_bytes: received.facts.stream_bytes,
        error: received.decoder.error().unwrap_or_default(),
        decode_secs: received.decode_secs,
        triangles_per_sec: mesh.triangle_count() as f64 / received.decode_secs,
        secs: started.elapsed().as_secs_f64(),
    };
    output.summary(&report, &report.to_text())
}

/// The stream of a file, as far as it is there.
///
/// # Errors
/// Where it has none, or it is damaged.
pub(super) fn stream_of<'a>(file: &StriataFile<'a>, input: &Input) -> Result<&'a [u8], Failure> {
    let stream = file.stream().ok_or_else(|| {
        Failure::user(format!("{}: no model progressive is in this file", input.name))
            .with_hint("build it again with --models progressive, or make a stream with `striata encode`")
    })?;
    stream.map_err(|error| input.damaged(&error))
}

impl Report {
    fn to_text(&self) -> String {
        format!(
            "{} triangles, {} vertices, split {} of {}, error {}; decoded in {} ({:.2} M triangles/s)",
            grouped(self.triangle_count),
            grouped(self.vertex_count),
            grouped(self.split_count),
            grouped(self.step_count),
            measured(self.error.into()),
            lasted(self.decode_secs),
            self.triangles_per_sec / 1e6
        )
    }
}
