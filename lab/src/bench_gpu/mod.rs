//! `bench-gpu`: measures what a frame costs while the level changes, for each way of drawing a level.
//!
//! By default this is the linear test of \[RCRG06\], its figures 7 and 8: from the full mesh to the base in even
//! steps, and back. `--pace exponential` is the other test of \[BRR02\], its figure 4. The camera stays still, so every way draws the same pixels and only the triangles change.

mod bench_scene;
mod crowd;
mod report;
mod timings;
pub(crate) mod ways;

use std::time::Instant;

use striata_render::gpu::{AdapterKind, Gpu, GpuOptions};

use self::bench_scene::BenchScene;
use self::crowd::CrowdReport;
use self::report::{GpuMeshReport, GpuReport};
use self::timings::Timings;
use crate::args::BenchGpuArgs;
use striata_command::args::Viewport;
use striata_command::driver_messages::without_driver_messages;
use striata_command::failure::Failure;
use striata_command::input::Input;
use striata_command::output::Output;

/// Draws every mesh in every way and prints the report.
///
/// # Errors
/// If no adapter is available, a mesh cannot be read, or a way's name is unknown.
pub(crate) fn run(args: &BenchGpuArgs, output: &Output) -> Result<(), Failure> {
    let started = Instant::now();
    let entries = ways::entries(&args.way_names())?;
    let options = GpuOptions {
        kind: if args.software { AdapterKind::Cpu } else { AdapterKind::Any },
        adapter_name: args.adapter.clone(),
    };
    let gpu = without_driver_messages(output, || Gpu::new(&options))?;
    // Open all inputs first, so that a missing file is reported before any work is done.
    let inputs: Vec<Input> = args.inputs.iter().map(|path| Input::open(path)).collect::<Result<_, _>>()?;
    let (Viewport(size), plan) = (args.size, args.strip_plan());
    let mut meshes = Vec::new();
    for input in &inputs {
        let mut bar = output.bar();
        bar.phase("read");
        let mesh = input.mesh(output)?;
        let in_input = |failure: Failure| failure.in_file(&input.name);
        let bench = BenchScene::new(&gpu, (&input.name, &mesh), (size, &plan), &mut bar).map_err(in_input)?;
        let timings =
            Timings::run(&bench, &entries, args.pace, args.frames as usize, &mut bar).map_err(in_input)?;
        let crowd = |count: u32| {
            bar.phase("crowd");
            CrowdReport::new(&gpu, &bench.refinable, count as usize, args.crowd_triangles as usize)
        };
        let crowd = args.crowd.map(crowd).transpose().map_err(in_input)?;
        meshes.push(GpuMeshReport::new(input.file_name(), &bench, timings, crowd));
    }
    let report = GpuReport::new(&gpu, args, meshes, started);
    output.data(&report, &report.to_text())
}
