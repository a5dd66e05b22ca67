//! The `striata-lab` command: measures striata and the models and tools it is compared with.
//!
//! In reading order: `args` defines the command line, `compare` measures sizes, levels and views of all
//! models, `poses` measures levels of animated meshes, `caches` counts vertex cache misses of files, `bench_gpu`
//! measures frame times on a GPU, and `show` draws the structures of the papers.

mod args;
#[cfg(feature = "gpu")]
mod bench_gpu;
mod caches;
mod compare;
mod pace;
mod poses;
mod show;

use std::process::ExitCode;

use striata_command::failure::Failure;
use striata_command::output::Output;

use crate::args::{LabCli, LabVerb};

fn main() -> ExitCode {
    striata_command::run(std::env::args_os(), |_| None, run)
}

fn run(cli: &LabCli) -> Result<(), Failure> {
    let output = Output::new(cli.report);
    match &cli.verb {
        LabVerb::Compare(args) => compare::run(args, &output),
        LabVerb::Poses(args) => poses::run(args, &output),
        LabVerb::Caches(args) => caches::run(args, &output),
        LabVerb::Show(args) => show::run(args, &output),
        #[cfg(feature = "gpu")]
        LabVerb::BenchGpu(args) => bench_gpu::run(args, &output.with_drivers(args.drivers)),
    }
}
