//! `tiles --format neuroglancer`: one segment of the input, or one for each mesh of a folder.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::time::Instant;

use serde::Serialize;
use striata_command::failure::Failure;
use striata_command::output::{Output, format_bytes, format_count, format_duration, format_noun_count};
use striata_io::Format;
use striata_tiles::{NeuroglancerOptions, NeuroglancerReport, NeuroglancerWriter, Sharding, VertexBits};

use super::{failure, opened, table_of};
use crate::args::TilesArgs;
use crate::commands::paged;

#[derive(Serialize)]
struct WrittenSegments<'a> {
    output: &'a Path,
    seconds: f64,
    #[serde(flatten)]
    meshes: NeuroglancerReport,
}

pub(super) fn run(args: &TilesArgs, output: &Output) -> Result<(), Failure> {
    let start = Instant::now();
    let segments = segments(args, output)?;
    let mut options = NeuroglancerOptions::default();
    options.fragment_triangles = args.tile_triangles.unwrap_or(options.fragment_triangles);
    if args.neuroglancer.bits.as_deref() == Some("10") {
        options.bits = VertexBits::Ten;
    }
    options.sharding = args.neuroglancer.sharded.then(|| Sharding::of_count(segments.len() as u64));
    let mut writer = NeuroglancerWriter::new(&args.output, options).map_err(failure)?;
    for (id, inputs) in segments {
        let (mut file, _work) = opened(&inputs, args, output)?;
        let mut bar = output.bar();
        writer.add(id, &mut file, &mut |p| bar.show(p)).map_err(failure)?;
    }
    let meshes = writer.finish().map_err(failure)?;
    meshes.left_out.iter().for_each(|warning| output.say(&format!("warning: {warning}")));
    let report = WrittenSegments { output: &args.output, seconds: start.elapsed().as_secs_f64(), meshes };
    output.summary(&report, &text_of(&report))
}

/// The inputs of each segment.
fn segments(args: &TilesArgs, output: &Output) -> Result<BTreeMap<u64, Vec<PathBuf>>, Failure> {
    let folder = match &args.inputs[..] {
        [path] if path.is_dir() && !paged::is_paged_file(path) => path,
        _ => {
            let id = args.neuroglancer.segment_id.unwrap_or(1);
            return Ok(BTreeMap::from([(id, args.inputs.clone())]));
        }
    };
    if args.neuroglancer.segment_id.is_some() {
        let message = format!("{}: --segment-id has no effect on a folder", folder.display());
        return Err(Failure::usage(message).with_hint("remove --segment-id, and name the files by segments"));
    }
    let unreadable = |error: std::io::Error| Failure::user(format!("{}: {error}", folder.display()));
    let mut paths = Vec::new();
    for entry in fs::read_dir(folder).map_err(unreadable)? {
        paths.push(entry.map_err(unreadable)?.path());
    }
    paths.sort();
    let mut segments: BTreeMap<u64, Vec<PathBuf>> = BTreeMap::new();
    for path in paths {
        if Format::from_extension(&path).is_none() {
            output.say(&format!("warning: left out: {}; its name is not that of a mesh", path.display()));
            continue;
        }
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        let stem = name.split('.').next().unwrap_or_default();
        let is_number = stem.bytes().all(|byte| byte.is_ascii_digit());
        let id = stem.parse().ok().filter(|_| is_number).ok_or_else(|| {
            let message = format!("{}: the name is not the number of a segment", path.display());
            Failure::user(message).with_hint("name the files by segments, like 17.ply, or move this one")
        })?;
        if let Some(other) = segments.insert(id, vec![path.clone()]) {
            let [other, path] = [other[0].display(), path.display()];
            return Err(Failure::user(format!("{other} and {path} are both segment {id}")));
        }
    }
    if segments.is_empty() {
        return Err(Failure::user(format!("{}: there are no meshes in this folder", folder.display())));
    }
    Ok(segments)
}

fn text_of(report: &WrittenSegments<'_>) -> String {
    let meshes = &report.meshes;
    format!(
        "{}: {}, {} fragments of {} levels, {}; errors are estimates\nwritten in {}\n\n{}",
        report.output.display(),
        format_noun_count(meshes.segments as usize, "segment", "segments"),
        format_count(meshes.fragments as usize),
        meshes.levels.len(),
        format_bytes(meshes.bytes as usize),
        format_duration(report.seconds),
        table_of(&meshes.levels, "fragments").to_text(),
    )
}
