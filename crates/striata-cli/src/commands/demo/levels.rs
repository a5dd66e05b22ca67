//! The levels of the demo: measured for a table, and written as meshes.

use std::time::Instant;

use serde::Serialize;
use striata::file::StriataFile;
use striata::model::{LodModel, StripModel as _};
use striata_io::{Format, WriteOptions, to_bytes};

use super::folder::DemoFolder;
use crate::commands::build::BuildOutput;
use crate::strip_lists::stitched;
use striata_command::failure::Failure;
use striata_command::output::{format_bytes, format_count, format_duration};

/// Fractions of the triangles for which the table has a row.
const TABLE_SHARES: [f64; 8] = [1.0, 0.5, 0.25, 0.1, 0.05, 0.02, 0.01, 0.005];

/// One row of the table.
#[derive(Clone, Debug, Serialize)]
pub(super) struct Level {
    triangle_share: f64,
    detail: f64,
    split_count: usize,
    triangle_count: usize,
    vertex_count: usize,
    error: f32,
    error_of_diagonal: f64,
    strip_count: usize,
    /// GPU memory needed to draw the level: positions and strip indices.
    drawn_bytes: usize,
    /// Time to go from full detail to this level, seconds.
    seek_secs: f64,
}

/// Measures each level of the table.
pub(super) fn measure(built: &BuildOutput) -> Vec<Level> {
    let diagonal = built.refinable().mesh.diagonal();
    TABLE_SHARES.iter().map(|&share| measure_one(built, share, diagonal)).collect()
}

fn measure_one(built: &BuildOutput, share: f64, diagonal: f64) -> Level {
    let sequence = &built.refinable().sequence;
    let split_count = split_count_at(built, share);
    let mut state = built.lod_strips().new_state();
    // The best of three runs: the first one includes page faults of memory that is used for the first time.
    let mut seek_secs = f64::INFINITY;
    for _ in 0..3 {
        built.lod_strips().move_to(&mut state, sequence.step_count());
        let started = Instant::now();
        built.lod_strips().move_to(&mut state, split_count);
        seek_secs = seek_secs.min(started.elapsed().as_secs_f64());
    }
    let strips = built.lod_strips().strips_at(&state);
    let index_count = strips.to_restart_indices().indices.len();
    let vertex_count = sequence.vertex_count_at(split_count);
    let error = sequence.error_at(split_count);
    Level {
        triangle_share: share,
        detail: split_count as f64 / sequence.step_count().max(1) as f64,
        split_count,
        triangle_count: sequence.triangle_count_at(split_count),
        vertex_count,
        error,
        error_of_diagonal: f64::from(error) / diagonal,
        strip_count: strips.strip_count(),
        drawn_bytes: 12 * vertex_count + 4 * index_count,
        seek_secs,
    }
}

/// Returns the rows of the table, header first.
pub(super) fn rows(levels: &[Level]) -> Vec<Vec<String>> {
    let head = ["share", "triangles", "vertices", "error", "strips", "GPU memory", "seek time"];
    let mut rows = vec![head.map(str::to_owned).to_vec()];
    rows.extend(levels.iter().map(|level| {
        vec![
            percent(level.triangle_share),
            format_count(level.triangle_count),
            format_count(level.vertex_count),
            format!("{:.4} %", 100.0 * level.error_of_diagonal),
            format_count(level.strip_count),
            format_bytes(level.drawn_bytes),
            format_duration(level.seek_secs),
        ]
    }));
    rows
}

/// Writes some levels as mesh files.
///
/// # Errors
/// If a level cannot be extracted or written.
pub(super) fn write_meshes(
    file: &StriataFile<'_>,
    built: &BuildOutput,
    folder: &mut DemoFolder<'_>,
) -> Result<(), Failure> {
    let wanted = [
        (0.5, Format::Glb, false),
        (0.1, Format::Glb, false),
        (0.1, Format::Glb, true),
        (0.02, Format::Ply, false),
        (0.005, Format::Obj, false),
    ];
    let mut state = built.lod_strips().new_state();
    for (share, format, as_strips) in wanted {
        let split_count = split_count_at(built, share);
        built.lod_strips().move_to(&mut state, split_count);
        let mesh = file.level_of(built.lod_strips(), &state)?;
        let mut options = WriteOptions::default().with_cache_order(true);
        if as_strips {
            options = options.with_strips(stitched(&built.lod_strips().strips_at(&state)));
        }
        let form = if as_strips { "-strips" } else { "" };
        let name = format!("nefertiti-{}-percent{form}.{}", 100.0 * share, format.extension());
        let what = format!(
            "{} triangles{}",
            format_count(mesh.triangle_count()),
            if as_strips { " as strips" } else { "" }
        );
        folder.write(&name, &what, &to_bytes(format, &mesh, &options)?)?;
    }
    Ok(())
}

/// Returns the split count of the level with this fraction of the triangles.
pub(super) fn split_count_at(built: &BuildOutput, share: f64) -> usize {
    let sequence = &built.refinable().sequence;
    let full = sequence.triangle_count_at(sequence.step_count());
    sequence.split_count_for_triangles((share * full as f64).round() as usize)
}

/// Formats a fraction as a percentage.
pub(super) fn percent(share: f64) -> String {
    format!("{} %", 100.0 * share)
}
