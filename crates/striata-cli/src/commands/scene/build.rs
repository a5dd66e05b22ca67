//! `build` for scenes: a `.striata` file with the document, its images, and the levels of every mesh, a glTF file with its
//! vertices in refinement order, or a file for Godot.

use std::fmt::Display;

use serde::Serialize;
use serde_json::Value;
use striata::file::WriteOptions;
use striata::simplify::{StopReason, Target};
use striata_command::clock::{Phases, peak_rss_bytes};
use striata_command::failure::Failure;
use striata_command::input::Input;
use striata_command::level::{CoarseningLimit, ReachedLevel, check_strict, shortfall, shortfall_note};
use striata_command::output::{
    Output, Table, format_bytes, format_count, format_duration, format_length, format_noun_count,
};
use striata_command::save::{DEFAULT_NAME_NOTE, display_name, write_encoded};
use striata_command::scene::{build_scene, check_scene_flags, edited, with_textures};
use striata_command::sequence::{Limits, StepKind, limit_in_units};
use striata_io::OutputFiles;
use striata_scene::LodScene;

use super::clusters::{self, ClusterReport};
use super::ordered::{OrderReport, model_flags, ordered_input};
use crate::args::BuildArgs;
use crate::commands::build::{BuildFile, BuildFormat, timings_text};

/// Phases whose times are reported.
const PHASES: [&str; 3] = ["read", "simplify", "write"];

#[derive(Serialize)]
struct SceneBuildReport {
    path: String,
    mesh_count: usize,
    vertex_count: usize,
    /// Number of triangles; those of a mesh count once for each instance.
    triangle_count: usize,
    step_count: usize,
    base_triangle_count: usize,
    /// Error of the coarsest level, scene units.
    error_max: f64,
    error_is_guaranteed: bool,
    /// Why the coarsest level has more triangles than `--base`; null if it does not.
    shortfall: Option<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    georeference: Option<Value>,
    image_bytes: usize,
    output_bytes: usize,
    /// Order of a glTF file; absent for other files.
    #[serde(flatten)]
    order: Option<OrderReport>,
    #[serde(flatten)]
    phases: Phases,
    peak_rss_bytes: Option<u64>,
}

/// Builds the levels of a scene, writes them, and reports.
///
/// # Errors
/// If any of this fails; an existing output is then left unchanged.
pub(in crate::commands) fn build(
    args: &BuildArgs,
    input: &Input,
    file: &BuildFile<'_>,
    output: &Output,
) -> Result<(), Failure> {
    let &BuildFile { path, format } = file;
    check_scene_flags(input, &model_flags(args))?;
    let is_ordered = format != BuildFormat::Striata;
    let mut phases = Phases::new(&PHASES);
    let mut bar = output.bar();
    phases.enter("read");
    bar.phase("read");
    let scene = if is_ordered { ordered_input(input, args, output)? } else { input.scene(output)? };
    let scene = edited(scene, &args.edits, false, output)?;
    let scene = with_textures(scene, args.textures.options().as_ref(), output)?;
    phases.enter("simplify");
    if let Some(max_triangles) = args.clusters {
        let progress = &mut |progress| bar.show(progress);
        let clustered = clusters::clustered(input, scene, &args.sequence, max_triangles as usize, progress)?;
        phases.enter("write");
        let report = ClusterReport::write(&clustered, path, phases)?;
        drop(bar);
        return output.summary(&report, &(report.to_text() + &timings_text(args, &report.phases)));
    }
    let base = args.limits.base.map(|count| count.of_triangles(scene.triangle_count()));
    let limits = Limits {
        base_triangle_count: base.unwrap_or(0),
        max_error: limit_in_units(args.limits.max_error, scene.diagonal()),
    };
    let lods = build_scene(input, &scene, &args.sequence, limits, &mut |progress| bar.show(progress))?;
    let shortfall = base.and_then(|base| shortfall_of(&lods, base, args));
    check_strict(args.limits.strict, None, shortfall.as_deref())?;
    phases.enter("write");
    bar.phase("write");
    let options = WriteOptions::default()
        .with_metadata("creator", concat!("striata ", env!("CARGO_PKG_VERSION")))
        .with_metadata("source", input.file_name());
    let failed = |error: &dyn Display| Failure::user(format!("{}: {error}", input.name));
    let plain = |bytes: Vec<u8>| OutputFiles::new(&[], None).finish(bytes);
    let mut order = None;
    let encoded = match format {
        BuildFormat::Striata => plain(lods.to_striata(&options).map_err(|error| failed(&error))?),
        BuildFormat::Glb => {
            let range_count = args.ranges.map_or(0, |count| count as usize);
            let glb = lods.to_ordered_glb(range_count).map_err(|error| failed(&error))?;
            order = Some(OrderReport::new(&glb, &lods));
            plain(glb.bytes)
        }
        BuildFormat::Godot(kind) => {
            let level_count = args.ranges.map_or(usize::MAX, |count| count as usize);
            let encoded = lods.to_godot(kind, level_count, Some(path));
            encoded.map_err(|error| failed(&error).with_hint("use the extension .tscn, or add --flat"))?
        }
    };
    write_encoded(&encoded, path, output)?;
    phases.leave();
    drop(bar);
    let report = SceneBuildReport {
        path: display_name(path),
        mesh_count: lods.lods().iter().flatten().count(),
        vertex_count: lods.levels().vertex_count(),
        triangle_count: lods.triangle_count(),
        step_count: lods.levels().step_count(),
        base_triangle_count: lods.levels().base_triangle_count(),
        error_max: lods.levels().base_error(),
        error_is_guaranteed: lods.has_guaranteed_errors(),
        shortfall,
        georeference: scene.georeference().cloned(),
        image_bytes: scene.images().iter().map(|image| image.bytes.len()).sum(),
        output_bytes: encoded.bytes.len(),
        order,
        phases,
        peak_rss_bytes: peak_rss_bytes(),
    };
    let text = report.to_text(args.output.is_none());
    output.summary(&report, &(text + &timings_text(args, &report.phases)))
}

/// Explains why the coarsest level has more triangles than requested, if it has.
fn shortfall_of(lods: &LodScene, base: usize, args: &BuildArgs) -> Option<String> {
    let level = lods.level(Target::Triangles(base));
    let reached = ReachedLevel {
        vertex_count: level.vertex_count,
        triangle_count: level.triangle_count,
        stop_reason: match level.stop_reason {
            StopReason::BaseReached if args.limits.max_error.is_some() => StopReason::ErrorLimit,
            reason => reason,
        },
    };
    let limit = CoarseningLimit::Simplification(args.sequence.describe_limit(StepKind::Single));
    shortfall(Target::Triangles(base), reached, &limit)
}

impl SceneBuildReport {
    fn to_text(&self, is_default_name: bool) -> String {
        let mut table = Table::default();
        let mut row = |name: &str, value: String| table.row(vec![name.to_owned(), value]);
        row("meshes", format_count(self.mesh_count));
        let [full, base] = [self.triangle_count, self.base_triangle_count].map(format_count);
        row("triangles", format!("{full} down to {base}"));
        row("vertices", format_count(self.vertex_count));
        row("levels", format_count(self.step_count + 1));
        let kind = if self.error_is_guaranteed { "guaranteed" } else { "estimated" };
        row("error of coarsest level", format!("{} ({kind})", format_length(self.error_max)));
        row("images", format_bytes(self.image_bytes));
        let chosen = if is_default_name { DEFAULT_NAME_NOTE } else { "" };
        if let Some(order) = &self.order {
            order.rows(&mut row);
        }
        row("file", format!("{} ({}){chosen}", self.path, format_bytes(self.output_bytes)));
        row("time", format_duration(self.phases.total_secs()));
        let mut text = table.to_text();
        if let Some(shortfall) = &self.shortfall {
            text.push_str(&shortfall_note(None, shortfall));
            text.push('\n');
        }
        text
    }
}

/// Describes a number of meshes.
pub(super) fn mesh_count_text(count: usize) -> String {
    format_noun_count(count, "mesh", "meshes")
}
