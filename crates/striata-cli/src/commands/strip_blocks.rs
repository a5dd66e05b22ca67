//! `strip --block-triangles`: stripifies a mesh that need not fit into memory.

use std::path::{Path, PathBuf};
use std::time::Instant;

use serde::Serialize;
use striata_io::{Format, ReadError, StripSpool, TriangleBlocks, WriteError};
use striata_strip::{BlockOptions, BlocksError, BlocksReport, stripify_blocks_with_progress};

use super::paged::{is_generated, open_generated};
use crate::args::StripArgs;
use striata_command::clock::peak_rss_bytes;
use striata_command::failure::Failure;
use striata_command::output::{Output, Table, format_bytes, format_count, format_duration};
use striata_command::save::{check_place, format_of, is_stdout};
use striata_command::shapes::Shape;

#[derive(Serialize)]
struct StripBlocksReport {
    algorithm: String,
    seed: u64,
    vertex_count: u32,
    triangle_count: usize,
    degenerate_triangle_count: u64,
    strip_count: usize,
    swap_count: usize,
    restart_count: usize,
    index_count: usize,
    indices_per_triangle: f64,
    longest_strip: usize,
    /// This and the next two fields are null, because they are known only for a mesh in memory.
    component_count: Option<usize>,
    acmr_16: Option<f64>,
    atvr_16: Option<f64>,
    block_triangles: usize,
    block_count: u32,
    peak_block_triangles: usize,
    peak_window_triangles: usize,
    peak_held_triangles: usize,
    carried_count: usize,
    /// Number of indices in the file that was written, including those that separate or join strips.
    written_index_count: Option<u64>,
    read_secs: f64,
    stripify_secs: f64,
    secs: f64,
    peak_rss_bytes: Option<u64>,
}

/// Sorts triangles into blocks, stripifies one block after another, writes the strips if requested, and
/// reports.
///
/// # Errors
/// If any of this fails; an existing output is then left unchanged.
pub(crate) fn run(args: &StripArgs, block_triangles: usize, output: &Output) -> Result<(), Failure> {
    let started = Instant::now();
    let options = BlockOptions::default().with_strip(args.only_stripifier()?);
    let format = check_files(args)?;
    let scratch = scratch_folder(args.output.as_deref());
    let mut bar = output.bar();
    bar.phase("read");
    let mut blocks = if is_generated(&args.input) {
        TriangleBlocks::of_pieces(&*open_generated(&args.input)?, block_triangles, &scratch)?
    } else {
        TriangleBlocks::open(&args.input, block_triangles, &scratch)?
    };
    output.warn(blocks.warnings())?;
    let read_secs = started.elapsed().as_secs_f64();
    let mut spool = format.map(|format| StripSpool::new(format, &scratch)).transpose()?;
    let mut write = |_: u32, strip: &[u32]| match &mut spool {
        Some(spool) => spool.push(strip),
        None => Ok(()),
    };
    let made =
        stripify_blocks_with_progress(&mut blocks, &options, &mut write, &mut |progress| bar.show(progress))
            .map_err(failure_of)?;
    let stripify_secs = started.elapsed().as_secs_f64() - read_secs;
    let mut losses = Vec::new();
    let written_index_count = match (spool, &args.output) {
        (Some(spool), Some(path)) => {
            bar.phase("write");
            losses = blocks.losses(format.unwrap_or(Format::Glb))?;
            Some(spool.write(path, &blocks)?)
        }
        _ => None,
    };
    drop(bar);
    output.warn_of_losses(&losses);
    let report = StripBlocksReport {
        written_index_count,
        read_secs,
        stripify_secs,
        secs: started.elapsed().as_secs_f64(),
        peak_rss_bytes: peak_rss_bytes(),
        ..StripBlocksReport::new(args, block_triangles, &blocks, &made)
    };
    match args.output {
        Some(_) => output.summary(&report, &report.to_text()),
        None => output.data(&report, &report.to_text()),
    }
}

/// Checks input and output, and returns the format of the output, if there is one.
///
/// # Errors
/// If the input or output is not a file, or the format cannot be written block by block.
fn check_files(args: &StripArgs) -> Result<Option<Format>, Failure> {
    if args.weld {
        return Err(Failure::usage("--weld needs the whole mesh in memory")
            .with_hint("remove --weld or --block-triangles"));
    }
    if !is_generated(&args.input) && Shape::from_input_name(&args.input)?.is_some() {
        return Err(Failure::usage(format!(
            "{}: --block-triangles needs an input file",
            args.input.display()
        ))
        .with_hint("use shape:terrain:N, or write a file first: striata convert SHAPE OUT.ply"));
    }
    if is_stdout(&args.input) {
        return Err(Failure::usage(
            "stdin: --block-triangles needs an input file, which it reads several times",
        )
        .with_hint("name a .ply, .stl, .obj, .off or .glb file"));
    }
    let Some(path) = &args.output else { return Ok(None) };
    if is_stdout(path) {
        return Err(
            Failure::usage("stdout: --block-triangles needs an output file").with_hint("name an output file")
        );
    }
    let format = format_of(path, &args.format())?;
    if !matches!(format, Format::Glb | Format::Ply) {
        return Err(Failure::usage(format!(
            "{}: {format} files cannot be written in blocks",
            path.display()
        ))
        .with_hint("write .glb or .ply"));
    }
    check_place(path)?;
    Ok(Some(format))
}

/// Returns the folder for temporary files: that of the output, which has room for it, or that of the system.
fn scratch_folder(output: Option<&Path>) -> PathBuf {
    match output.and_then(Path::parent) {
        Some(folder) if !folder.as_os_str().is_empty() => folder.to_owned(),
        Some(_) => PathBuf::from("."),
        None => std::env::temp_dir(),
    }
}

impl StripBlocksReport {
    fn new(args: &StripArgs, block_triangles: usize, blocks: &TriangleBlocks, made: &BlocksReport) -> Self {
        let cost = made.cost;
        Self {
            algorithm: args.strips.to_string(),
            seed: args.search.seed,
            vertex_count: blocks.vertex_count(),
            triangle_count: cost.triangle_count,
            degenerate_triangle_count: blocks.triangle_count() - cost.triangle_count as u64,
            strip_count: cost.strip_count,
            swap_count: cost.swap_count,
            restart_count: cost.strip_count.saturating_sub(1),
            index_count: cost.index_count,
            indices_per_triangle: cost.indices_per_triangle,
            longest_strip: cost.longest_strip,
            component_count: None,
            acmr_16: None,
            atvr_16: None,
            block_triangles,
            block_count: made.block_count,
            peak_block_triangles: made.peak_block_triangles,
            peak_window_triangles: made.peak_window_triangles,
            peak_held_triangles: made.peak_held_triangles,
            carried_count: made.carried_count,
            written_index_count: None,
            read_secs: 0.0,
            stripify_secs: 0.0,
            secs: 0.0,
            peak_rss_bytes: None,
        }
    }

    fn to_text(&self) -> String {
        let mut table = Table::default();
        let mut row = |name: &str, value: String| table.row(vec![name.to_owned(), value]);
        row("algorithm", self.algorithm.clone());
        row("triangles", format_count(self.triangle_count));
        if self.degenerate_triangle_count > 0 {
            row("degenerate triangles skipped", self.degenerate_triangle_count.to_string());
        }
        row("strips", format_count(self.strip_count));
        row("swaps", format_count(self.swap_count));
        row("indices", format_count(self.index_count));
        row("indices per triangle", format!("{:.4}", self.indices_per_triangle));
        row("indices of longest strip", format_count(self.longest_strip));
        row("blocks", format_count(self.block_count as usize));
        row("peak triangles per window", format_count(self.peak_window_triangles));
        row("peak triangles waiting", format_count(self.peak_held_triangles));
        row("time to sort into blocks", format_duration(self.read_secs));
        row("stripification time", format_duration(self.stripify_secs));
        if let Some(bytes) = self.peak_rss_bytes {
            row("peak memory", format_bytes(bytes as usize));
        }
        table.to_text()
    }
}

fn failure_of(error: BlocksError<ReadError, WriteError>) -> Failure {
    match error {
        BlocksError::Read { error, .. } => error.into(),
        BlocksError::Write(error) => error.into(),
        BlocksError::TooLarge { .. } => {
            Failure::user(error.to_string()).with_hint("use a smaller --block-triangles")
        }
        _ => Failure::internal(error.to_string()),
    }
}
