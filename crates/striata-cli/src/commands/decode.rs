//! `decode`: decodes a stream, complete or cut off, or one level of it, into a mesh.

use std::time::Instant;

use striata::simplify::Target;

use super::levels::{
    LevelJob, LevelSource, LevelsReport, SceneSource, StreamSource, decoded_text, full_of, write_levels,
};
use crate::args::{DecodeArgs, TriangleForm};
use striata_command::args::LevelsArgs;
use striata_command::failure::Failure;
use striata_command::input::Input;
use striata_command::level::level_requests;
use striata_command::output::Output;
use striata_command::save::{format_of, is_stdout};

/// Reads and decodes the stream, writes the mesh, and reports.
///
/// # Errors
/// If any of this fails.
pub(crate) fn run(args: &DecodeArgs, output: &Output) -> Result<(), Failure> {
    let started = Instant::now();
    output.check_stdout_is_free(is_stdout(args.output.path()))?;
    format_of(args.output.path(), &args.output.format)?;
    let mut bar = output.bar();
    bar.phase("decode");
    let input = Input::open(&args.input)?;
    let report = if input.scene_kind().is_some() {
        let received = input.received_scene(output)?;
        decode(&mut SceneSource::new(received, None, output)?, args, started, output)?
    } else {
        let file = input.striata()?;
        decode(&mut StreamSource::new(&file, TriangleForm::List, &input)?, args, started, output)?
    };
    drop(bar);
    output.summary(&report, &decoded_text(&report))
}

/// Writes the level that the user asks for, or everything.
fn decode<S: LevelSource>(
    source: &mut S,
    args: &DecodeArgs,
    started: Instant,
    output: &Output,
) -> Result<LevelsReport, Failure> {
    let level = &args.level.level;
    let full = full_of(source, level)?;
    let requests =
        level_requests(level, &LevelsArgs { levels: None, lod_chain: false }, full, args.output.path())?;
    let job = LevelJob {
        requests,
        is_list: false,
        default_target: Target::Detail(1.0),
        is_strict: false,
        format: &args.output.format,
        max_error: None,
        started,
    };
    write_levels(source, &job, output)
}
