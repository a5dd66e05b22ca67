//! The verbs, one file or folder each.

mod build;
mod completions;
mod convert;
mod decode;
mod demo;
mod distance;
mod encode;
mod extract;
mod info;
mod levels;
mod paged;
mod placement;
mod render;
mod scene;
mod simplify;
mod strip;
mod strip_blocks;
mod strip_levels;
mod tiles;

use crate::args::{Cli, Verb};
use striata_command::failure::Failure;
use striata_command::output::Output;
#[cfg(feature = "serve")]
use striata_viewer::serve;

/// Runs the verb on the command line.
///
/// # Errors
/// If the verb fails.
pub(crate) fn run(cli: &Cli) -> Result<(), Failure> {
    let output = Output::new(cli.report);
    check_json(cli)?;
    check_inputs_stay(cli)?;
    if let Some(count) = cli.verb.thread_count() {
        // Whatever uses several threads uses those of the pool.
        let pool = rayon::ThreadPoolBuilder::new().num_threads(count).build_global();
        pool.map_err(|error| Failure::user(format!("{count} threads could not be started: {error}")))?;
    }
    match &cli.verb {
        Verb::Build(args) => build::run(args, &output),
        Verb::Plan(args) => paged::plan(args, &output),
        Verb::Run(args) => paged::run(args, &output),
        Verb::Info(args) => info::run(args, &output),
        Verb::Extract(args) => extract::run(args, &output),
        Verb::Simplify(args) => simplify::run(args, &output),
        Verb::Strip(args) => strip::run(args, &output),
        Verb::Distance(args) => distance::run(args, &output),
        Verb::Convert(args) => convert::run(args, &output),
        Verb::Encode(args) => encode::run(args, &output),
        Verb::Decode(args) => decode::run(args, &output),
        Verb::Tiles(args) => tiles::run(args, &output),
        #[cfg(feature = "gpu")]
        Verb::Render(args) => render::run(args, &output.with_drivers(args.drivers)),
        #[cfg(not(feature = "gpu"))]
        Verb::Render(args) => render::run(args, &output),
        #[cfg(feature = "serve")]
        Verb::Serve(args) => serve::run(args, &output),
        #[cfg(feature = "serve")]
        Verb::Thumbnail(args) => serve::thumbnail(args, &output),
        #[cfg(feature = "serve")]
        Verb::View(args) => serve::show(args, &output),
        #[cfg(feature = "gpu")]
        Verb::Demo(args) => demo::run(args, &output.with_drivers(args.drivers)),
        #[cfg(not(feature = "gpu"))]
        Verb::Demo(args) => demo::run(args, &output),
        Verb::Completions(args) => completions::run(args),
    }
}

/// Checks that the output does not replace an input, unless the user insists.
///
/// # Errors
/// If it would.
fn check_inputs_stay(cli: &Cli) -> Result<(), Failure> {
    let Some(output) = cli.verb.output().filter(|_| !cli.verb.is_forced()) else { return Ok(()) };
    // A file that does not exist is none of the inputs.
    let Ok(place) = output.canonicalize() else { return Ok(()) };
    if !cli.verb.inputs().iter().any(|input| input.canonicalize().is_ok_and(|input| input == place)) {
        return Ok(());
    }
    let way_out = match cli.verb {
        Verb::Render(_) | Verb::Tiles(_) => "choose another name",
        _ => "choose another name, or add --force",
    };
    let message = format!("{}: the output would overwrite the input", output.display());
    Err(Failure::usage(message).with_hint(way_out))
}

/// Checks that `--json` is given only to verbs that report something.
///
/// # Errors
/// If it is given to another verb.
fn check_json(cli: &Cli) -> Result<(), Failure> {
    let verb = match &cli.verb {
        Verb::Completions(_) => "completions",
        #[cfg(feature = "serve")]
        Verb::Thumbnail(_) => "thumbnail",
        #[cfg(feature = "serve")]
        Verb::View(_) => "view",
        _ => return Ok(()),
    };
    if !cli.report.json {
        return Ok(());
    }
    Err(Failure::usage(format!("`{verb}` has no JSON report")).with_hint("remove --json"))
}
