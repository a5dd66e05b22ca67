//! `bench-gpu`: what a frame costs while the level changes, for each way to get a level onto the screen.
//!
//! The linear test of \[RCRG06\], its figures 7 and 8: from the full mesh to the base by even steps, and back. What is looked at
//! stays where it is, so that every way draws the same pixels and only triangles change.

mod course;
mod report;
mod stage;
pub(crate) mod ways;

use std::time::Instant;

use striata_gpu::{Gpu, GpuOptions};

use self::course::Course;
use self::report::{MeshReport, Report};
use self::stage::Stage;
use crate::args::BenchGpuArgs;
use striata_command::args::Viewport;
use striata_command::driver_messages::without_driver_messages;
use striata_command::failure::Failure;
use striata_command::input::Input;
use striata_command::output::Output;

/// Draws every mesh in every way, reports.
///
/// # Errors
/// Where there is no adapter, a mesh cannot be read, or a way has no such name.
pub(crate) fn run(args: &BenchGpuArgs, output: &Output) -> Result<(), Failure> {
    let started = Instant::now();
    let entries = ways::entries(&args.way_names())?;
    let options = GpuOptions::default().with_fallback(args.software).with_adapter_name(args.adapter.clone());
    let gpu = without_driver_messages(output, || Gpu::new(&options))?;
    // All are opened first: a file that is not there is told before any work.
    let inputs: Vec<Input> = args.inputs.iter().map(|path| Input::open(path)).collect::<Result<_, _>>()?;
    let (Viewport(size), plan) = (args.size, args.strip_plan());
    let mut meshes = Vec::new();
    for input in &inputs {
        let mut bar = output.bar();
        bar.phase("read");
        let mesh = input.mesh(output)?;
        let blamed = |failure: Failure| failure.in_file(&input.name);
        let stage = Stage::new(&gpu, (&input.name, &mesh), (size, &plan), &mut bar).map_err(blamed)?;
        let course = Course::run(&stage, &entries, args.frames as usize, &mut bar).map_err(blamed)?;
        meshes.push(MeshReport::new(input.file_name(), &stage, course));
    }
    let report = Report::new(&gpu, args, meshes, started);
    output.data(&report, &report.to_text())
}
