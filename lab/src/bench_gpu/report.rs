//! Report of `bench-gpu`: tables for people, and JSON.

use std::time::Instant;

use serde::Serialize;
use striata_render::gpu::{Gpu, wgpu};

use super::bench_scene::BenchScene;
use super::crowd::CrowdReport;
use super::timings::{TimeSpread, Timings, WayCost};
use super::ways;
use crate::args::BenchGpuArgs;
use crate::pace::Pace;
use striata_command::args::Viewport;
use striata_command::output::{Table, format_bytes, format_count, format_duration};

/// Results of all meshes on one adapter.
#[derive(Serialize)]
pub(super) struct GpuReport {
    adapter: AdapterReport,
    /// Width and height of the picture, in pixels.
    size: [u32; 2],
    /// Frames from the full mesh to the base mesh; the way back has as many.
    frames: u32,
    /// How the level falls on the walk.
    pace: Pace,
    meshes: Vec<GpuMeshReport>,
    secs: f64,
}

#[derive(Serialize)]
struct AdapterReport {
    name: String,
    backend: String,
    driver: String,
    draws_on_the_processor: bool,
}

/// Results of one mesh.
#[derive(Serialize)]
pub(super) struct GpuMeshReport {
    name: String,
    vertex_count: usize,
    triangle_count: usize,
    base_triangle_count: usize,
    step_count: usize,
    strip_count: usize,
    rounds: usize,
    ways: Vec<WayCost>,
    crowd: Option<CrowdReport>,
}

impl GpuMeshReport {
    /// Combines the mesh's counts with the measured times.
    pub(super) fn new(
        name: String,
        bench: &BenchScene<'_>,
        timings: Timings,
        crowd: Option<CrowdReport>,
    ) -> Self {
        let Timings { costs: ways, rounds } = timings;
        Self {
            name,
            vertex_count: bench.refinable.mesh.vertex_count(),
            triangle_count: bench.refinable.mesh.triangle_count(),
            base_triangle_count: bench.refinable.sequence.triangle_count_at(0),
            step_count: bench.step_count(),
            strip_count: bench.strips.strip_count(),
            rounds,
            ways,
            crowd,
        }
    }

    fn add_text(&self, text: &mut String) {
        text.push_str(&format!(
            "\n{}: {} triangles, {} vertices, base {}; {} strips; best of {}\n",
            self.name,
            format_count(self.triangle_count),
            format_count(self.vertex_count),
            format_count(self.base_triangle_count),
            format_count(self.strip_count),
            self.rounds,
        ));
        let head = [
            "way",
            "frame",
            "95 %",
            "update",
            "95 %",
            "recovery",
            "%rec",
            "GPU",
            "95 %",
            "sent",
            "indices",
            "on the GPU",
        ];
        let mut table = Table::with_head(&head);
        for way in &self.ways {
            let [frame, frame_most] = way.frame_secs.cells();
            let [update, update_most] = way.update_secs.cells();
            let [recover, _] = way.recover_secs.cells();
            let dash = || "-".to_owned();
            let [gpu, gpu_most] = way.gpu_secs.map_or_else(|| [dash(), dash()], TimeSpread::cells);
            let sent =
                if way.is_resident { dash() } else { format_bytes(way.uploaded_bytes.round() as usize) };
            table.row(vec![
                way.name.to_owned(),
                frame,
                frame_most,
                update,
                update_most,
                recover,
                format!("{:.2}", 100.0 * way.recover_share),
                gpu,
                gpu_most,
                sent,
                format_count(way.index_count.round() as usize),
                format_bytes(way.gpu_bytes),
            ]);
        }
        text.push_str(&table.to_text());
        text.extend(self.crowd.iter().map(CrowdReport::to_text));
    }
}

impl GpuReport {
    /// Collects the results of a whole run.
    pub(super) fn new(gpu: &Gpu, args: &BenchGpuArgs, meshes: Vec<GpuMeshReport>, started: Instant) -> Self {
        let info = gpu.info();
        let Viewport(size) = args.size;
        let adapter = AdapterReport {
            name: info.name.clone(),
            backend: info.backend.to_string(),
            driver: [&info.driver[..], &info.driver_info].join(" ").trim().to_owned(),
            draws_on_the_processor: info.device_type == wgpu::DeviceType::Cpu,
        };
        let (frames, pace) = (args.frames, args.pace);
        Self { adapter, size, frames, pace, meshes, secs: started.elapsed().as_secs_f64() }
    }

    /// Tables with explanations of their columns.
    pub(super) fn to_text(&self) -> String {
        let Self { adapter, size: [width, height], frames, pace, .. } = self;
        let mut text = format!("{} ({}, {})\n", adapter.name, adapter.backend, adapter.driver);
        text.push_str(&format!(
            "{width} x {height} pixels; {frames} frames from the full mesh to the base, {frames} back, {}\n",
            pace.as_str()
        ));
        text.push_str("times in milliseconds: the median of all frames, and the 95th percentile\n");
        if adapter.draws_on_the_processor {
            text.push_str("this adapter draws on the CPU: its times include all shading\n");
        }
        self.meshes.iter().for_each(|mesh| mesh.add_text(&mut text));
        let used = |name: &str| self.meshes.iter().any(|mesh| mesh.ways.iter().any(|way| way.name == name));
        text.push('\n');
        for entry in ways::all().iter().filter(|entry| used(entry.name)) {
            text.push_str(&format!("{}: {}\n", entry.name, entry.about));
        }
        text.push_str("\nframe: from requesting a level to the finished picture\n");
        text.push_str("update: the part of it that the CPU needs to hand everything over\n");
        text.push_str(
            "recovery: the part of that in which the model moves to the level; %rec: its share of all \
                       frames\n",
        );
        text.push_str("GPU: from its first to its last command by GPU time stamps, without transfers\n");
        text.push_str(&format!("all measured in {}\n", format_duration(self.secs)));
        text
    }
}

impl TimeSpread {
    /// Both values in milliseconds.
    fn cells(self) -> [String; 2] {
        [self.median, self.p95].map(|secs| format!("{:.3}", secs * 1e3))
    }
}
