//! `strip --levels`: strips that stay in repair while a mesh moves from level to level.

use std::path::Path;
use std::time::Instant;

use serde::Serialize;
use serde_json::Value;
use striata::mesh::{RefinableMesh, replay, weld};
use striata_strip::{LiveStripBuffer, LiveStrips, RepairReport};

use crate::args::StripArgs;
use crate::strip_lists::{StripLists, check_output};
use striata::mesh::Steps;
use striata_command::args::Level;
use striata_command::failure::Failure;
use striata_command::input::Input;
use striata_command::level::paths_of_levels;
use striata_command::output::{Bar, Output, Table, format_count, format_duration};
use striata_command::save::{LevelFiles, Primitives, georeference_of};
use striata_command::sequence::SequencePlan;

#[derive(Serialize)]
struct StripLevelsReport {
    algorithm: String,
    seed: u64,
    /// Number of moves by which each level after the first is reached.
    frames: u32,
    repair: &'static str,
    step_count: usize,
    levels: Vec<LevelStripsReport>,
    #[serde(skip_serializing_if = "Option::is_none")]
    georeference: Option<Value>,
    secs: f64,
}

/// A level, and how it was reached from the one before.
#[derive(Serialize)]
struct LevelStripsReport {
    /// The text that the user wrote for the level.
    level: String,
    split_count: usize,
    triangle_count: usize,
    strip_count: usize,
    swap_count: usize,
    index_count: usize,
    indices_per_triangle: f64,
    /// Number of collapses and vertex splits since the level before.
    step_count: usize,
    /// Number of tunnels that improved the strips.
    tunnel_count: usize,
    /// Number of moves that changed anything.
    frame_count: usize,
    /// Time of the stripifier for the first level, and of repair for the others.
    strip_secs: f64,
    /// Time to write the strips that changed to the index buffer.
    buffer_secs: f64,
    /// Number of ranges of the index buffer that changed, over all moves.
    changed_range_count: usize,
    /// Number of indices in these ranges.
    changed_index_count: usize,
    /// Number of indices that are drawn, including restarts that fill gaps.
    drawn_index_count: usize,
    #[serde(skip_serializing_if = "Option::is_none")]
    path: Option<String>,
}

/// Reads or builds the levels, follows them, writes the strips of each if requested, and reports.
///
/// # Errors
/// If any of this fails.
pub(crate) fn run(args: &StripArgs, levels: &[Level], output: &Output) -> Result<(), Failure> {
    let started = Instant::now();
    let format = args.format();
    let paths = match &args.output {
        Some(path) => Some(paths_of_levels(levels, path)?),
        None => None,
    };
    paths.iter().flatten().try_for_each(|path| check_output(path, &format, output))?;
    let mut bar = output.bar();
    bar.phase("read");
    let input = Input::open(&args.input)?;
    let refinable = refinable(&input, &mut bar, output)?;
    let mut follower = StripFollower::new(args, &refinable, levels, &mut bar)?;
    let mut files = LevelFiles::new(&format, true, output);
    let mut reports = Vec::with_capacity(levels.len());
    for (index, level) in levels.iter().enumerate() {
        bar.share("levels", index as f64 / levels.len() as f64);
        let mut report = follower.move_to(level);
        if let Some(path) = paths.as_ref().map(|paths| &paths[index]) {
            follower.write(path, &mut files)?;
            report.path = Some(path.display().to_string());
        }
        reports.push(report);
    }
    files.commit()?;
    drop(bar);
    let report = StripLevelsReport {
        algorithm: args.strips.to_string(),
        seed: args.search.seed,
        frames: args.levels.frames,
        repair: args.levels.repair.as_str(),
        step_count: refinable.sequence.step_count(),
        levels: reports,
        georeference: georeference_of(&refinable.mesh),
        secs: started.elapsed().as_secs_f64(),
    };
    match args.output {
        Some(_) => output.summary(&report, &report.to_text()),
        None => output.data(&report, &report.to_text()),
    }
}

/// The collapses of a .striata file, or those of a mesh.
///
/// # Errors
/// If the file is damaged or has no collapses, or the mesh is inconsistent.
pub(super) fn refinable(input: &Input, bar: &mut Bar, output: &Output) -> Result<RefinableMesh, Failure> {
    let no_collapses = || {
        Failure::user(format!("{}: this file has no collapses, from which levels are made", input.name))
            .with_hint("build the file again without --retriangulation free")
    };
    if input.has_levels() {
        let file = input.striata()?;
        if !file.has_collapses() {
            return Err(no_collapses());
        }
        input.remark_on(&file, output)?;
        return file.refinable_mesh().map_err(|error| input.damaged(&error));
    }
    let in_file = |failure: Failure| failure.in_file(&input.name);
    let mesh = input.mesh(output)?;
    bar.phase("weld");
    let welded = weld(&mesh).map_err(|error| in_file(error.into()))?;
    let simplified = SequencePlan::default().run(welded, &mut |progress| bar.show(progress));
    match simplified.map_err(|error| in_file(error.into()))?.steps {
        Steps::Collapses(refinable) => Ok(refinable),
        Steps::Fragments(_) => Err(no_collapses()),
    }
}

/// Live strips with their index buffer, and what it took to make and to move them.
struct StripFollower<'a> {
    refinable: &'a RefinableMesh,
    live: LiveStrips<'a>,
    buffer: LiveStripBuffer,
    frames: u32,
    /// Time of the stripifier, until the first level has been reported.
    stripify_secs: Option<f64>,
}

impl<'a> StripFollower<'a> {
    /// Makes the strips of the first level.
    ///
    /// # Errors
    /// If the mesh is inconsistent.
    fn new(
        args: &StripArgs,
        refinable: &'a RefinableMesh,
        levels: &[Level],
        bar: &mut Bar,
    ) -> Result<Self, Failure> {
        let split_count = levels.first().map_or(0, |level| split_count_of(refinable, level));
        let level = replay(refinable, split_count);
        let made = args.plan().run(&level, &mut |share| bar.share("strip", share))?;
        let options = args.levels.repair_options();
        let mut live = LiveStrips::new(refinable, split_count, &made.strips, &options)
            .map_err(|error| Failure::internal(error.to_string()))?;
        let buffer = LiveStripBuffer::new(&mut live);
        Ok(Self { refinable, live, buffer, frames: args.levels.frames, stripify_secs: Some(made.secs) })
    }

    /// Moves to a level in as many frames as requested.
    fn move_to(&mut self, level: &Level) -> LevelStripsReport {
        let (from, to) = (self.live.split_count(), split_count_of(self.refinable, level));
        let (mut moves, mut changes) = (RepairReport::default(), StripChanges::default());
        for frame in 1..=self.frames as usize {
            let at = from as f64 + (to as f64 - from as f64) * frame as f64 / f64::from(self.frames);
            let started = Instant::now();
            let report =
                self.live.move_to(if frame == self.frames as usize { to } else { at.round() as usize });
            let moved = Instant::now();
            self.buffer.sync(&mut self.live);
            changes.strip_secs += (moved - started).as_secs_f64();
            changes.buffer_secs += moved.elapsed().as_secs_f64();
            if report.collapse_count + report.split_count > 0 {
                changes.frame_count += 1;
                moves.collapse_count += report.collapse_count;
                moves.split_count += report.split_count;
                moves.tunnel_count += report.tunnel_count;
            }
            let ranges = self.buffer.take_changed_ranges();
            // The first upload is of the whole buffer, whatever the level.
            if self.stripify_secs.is_none() {
                changes.range_count += ranges.len();
                changes.index_count += ranges.iter().map(ExactSizeIterator::len).sum::<usize>();
            }
        }
        if let Some(secs) = self.stripify_secs.take() {
            changes.strip_secs = secs;
        }
        self.report(level, moves, &changes)
    }

    fn report(&self, level: &Level, moves: RepairReport, changes: &StripChanges) -> LevelStripsReport {
        let cost = self.live.to_strip_set().cost();
        LevelStripsReport {
            level: level.text.clone(),
            split_count: self.live.split_count(),
            triangle_count: cost.triangle_count,
            strip_count: cost.strip_count,
            swap_count: cost.swap_count,
            index_count: cost.index_count,
            indices_per_triangle: cost.indices_per_triangle,
            step_count: moves.collapse_count + moves.split_count,
            tunnel_count: moves.tunnel_count,
            frame_count: changes.frame_count,
            strip_secs: changes.strip_secs,
            buffer_secs: changes.buffer_secs,
            changed_range_count: changes.range_count,
            changed_index_count: changes.index_count,
            drawn_index_count: self.buffer.group_ranges().map(|range| range.len()).sum(),
            path: None,
        }
    }

    /// Writes the level with its strips.
    ///
    /// # Errors
    /// If the format cannot represent the mesh or writing fails.
    fn write(&self, path: &Path, files: &mut LevelFiles<'_>) -> Result<(), Failure> {
        let mesh = replay(self.refinable, self.live.split_count());
        let strips = self.live.to_strip_set().on_used_vertices(&mesh);
        let mesh = mesh.without_unused_vertices();
        let strips =
            strips.ok_or_else(|| Failure::internal("a strip uses a vertex that no triangle uses"))?;
        files.write(&mesh, Primitives::Strips(StripLists::new(&mesh, &strips).lists), path)
    }
}

/// Work of the moves to a level.
#[derive(Default)]
struct StripChanges {
    strip_secs: f64,
    buffer_secs: f64,
    frame_count: usize,
    range_count: usize,
    index_count: usize,
}

fn split_count_of(refinable: &RefinableMesh, level: &Level) -> usize {
    let count = level.triangles.of_triangles(refinable.mesh.triangle_count());
    refinable.sequence.levels().split_count_for_triangles(count)
}

impl StripLevelsReport {
    fn to_text(&self) -> String {
        let head = [
            "level",
            "triangles",
            "strips",
            "indices per triangle",
            "steps",
            "strips in",
            "buffer in",
            "ranges per move",
            "indices per move",
        ];
        let mut table = Table::with_head(&head);
        for level in &self.levels {
            let per_move = |count: usize| match level.frame_count {
                0 => "–".to_owned(),
                frames => format_count(count.div_ceil(frames)),
            };
            table.row(vec![
                level.level.clone(),
                format_count(level.triangle_count),
                format_count(level.strip_count),
                format!("{:.4}", level.indices_per_triangle),
                format_count(level.step_count),
                format_duration(level.strip_secs),
                format_duration(level.buffer_secs),
                per_move(level.changed_range_count),
                per_move(level.changed_index_count),
            ]);
        }
        let files = self.levels.iter().filter_map(|level| level.path.as_deref());
        let files: String = files.map(|path| format!("{path}\n")).collect();
        format!(
            "{}{files}strips of the first level by {}, repaired in {} moves per level\n",
            table.to_text(),
            self.algorithm,
            self.frames
        )
    }
}
