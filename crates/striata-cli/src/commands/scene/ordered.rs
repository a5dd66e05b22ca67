//! `build` with a GLB output: a plain glTF file with its vertices in refinement order.

use std::path::Path;

use serde::Serialize;
use serde_json::{Value, json};
use striata_command::failure::Failure;
use striata_command::input::Input;
use striata_command::output::{Output, format_bytes};
use striata_io::{Format, Scene, losses, lost_group_names, shaded};
use striata_scene::{LodScene, OrderedGlb};

use crate::args::BuildArgs;
use crate::commands::build::BuildFormat;

/// Flags of models, with whether each is given.
pub(super) fn model_flags(args: &BuildArgs) -> [(&'static str, bool); 4] {
    let strip_flag = args.strip_flag();
    let stream_flag = args.stream_encoding.first_given_flag();
    [
        ("--stream", args.is_stream()),
        ("--models", args.model_names() != ["lodstrips"]),
        (strip_flag.unwrap_or_default(), strip_flag.is_some()),
        (stream_flag.unwrap_or_default(), stream_flag.is_some()),
    ]
}

/// Checks that the flags fit the format of the output.
///
/// # Errors
/// If a flag is given that is for the other format, or a GLB file would have to be paged.
pub(in crate::commands) fn check_order_flags(
    args: &BuildArgs,
    path: &Path,
    format: BuildFormat,
    is_paged: bool,
) -> Result<(), Failure> {
    let name = path.display();
    let is_striata = format == BuildFormat::Striata;
    let for_others = [
        ("--ranges", args.ranges.filter(|_| is_striata)),
        ("--clusters", args.clusters.filter(|_| format != BuildFormat::Glb)),
    ];
    if let Some((flag, _)) = for_others.into_iter().find(|(_, value)| value.is_some()) {
        return Err(Failure::usage(format!("{name}: {flag} is for .glb outputs"))
            .with_hint(format!("use the extension .glb, or remove {flag}")));
    }
    if is_striata {
        return Ok(());
    }
    if is_paged {
        return Err(Failure::usage(format!("{name}: a paged file is a .striata file"))
            .with_hint("use the extension .striata"));
    }
    let sequence = &args.sequence;
    let removal = sequence.removal.first_given_flag();
    let flags = [
        ("--order", sequence.order.of_removals().is_some()),
        ("--new-vertices", sequence.new_vertices.is_some()),
        ("--overlap-errors", args.overlap_errors),
        (removal.unwrap_or_default(), removal.is_some()),
    ];
    let limits = [
        ("--base", args.limits.base.is_some()),
        ("--max-error", args.limits.max_error.is_some()),
        ("--certify", sequence.certify),
        ("--pair-distance", sequence.pair_distance.is_some()),
    ];
    let limit = limits.into_iter().find(|&(_, is_given)| is_given && args.clusters.is_some());
    if let Some((flag, _)) = limit {
        return Err(Failure::usage(format!("{name}: {flag} is not for --clusters")).with_hint(format!(
            "remove {flag}: clusters go down to the coarsest level, with estimated errors"
        )));
    }
    match model_flags(args).into_iter().chain(flags).find(|&(_, is_given)| is_given) {
        None => Ok(()),
        Some((flag, _)) => Err(Failure::usage(format!("{name}: {flag} is for .striata files"))
            .with_hint(format!("use the extension .striata, or remove {flag}"))),
    }
}

/// Returns the scene to order. A single mesh gets normals and a material if it has none, before its levels are made:
/// they all use the same vertices.
///
/// # Errors
/// If the input is malformed.
pub(super) fn ordered_input(input: &Input, args: &BuildArgs, output: &Output) -> Result<Scene, Failure> {
    if input.scene_kind().is_some() && !args.scene.flat {
        return input.scene(output);
    }
    let mesh = input.mesh(output)?;
    output.warn_of_losses(&losses(Format::Glb, &mesh, &input.name));
    output.warn_of_losses(&lost_group_names(&mesh, &input.name));
    let failed = |error| Failure::user(format!("{}: {error}", input.name));
    mesh.check().map_err(|error| Failure::from(error).in_file(&input.name))?;
    Scene::from_mesh(shaded(&mesh).into_owned()).map_err(failed)
}

/// Bytes that the order of a file takes, and the levels of its primitives.
#[derive(Serialize)]
pub(super) struct OrderReport {
    /// Size of the file without the extension.
    plain_bytes: usize,
    /// Bytes of the targets and the tables of levels.
    order_bytes: usize,
    /// Bytes of the index ranges.
    range_bytes: usize,
    /// For each mesh of the document its primitives with tables of levels and ranges, as in the extension; null for a
    /// mesh without triangles.
    meshes: Vec<Value>,
}

impl OrderReport {
    pub(super) fn new(glb: &OrderedGlb, lods: &LodScene) -> Self {
        let mesh = |(index, mesh): (usize, &Option<_>)| {
            let Some(mesh): &Option<striata_scene::OrderedMesh> = mesh else { return Value::Null };
            let primitives: Vec<Value> = mesh.primitives.iter().map(|levels| levels.to_json()).collect();
            json!({
                "name": lods.scene().mesh_name(index),
                "vertex_count": mesh.mesh.vertex_count(),
                "primitives": primitives,
            })
        };
        Self {
            plain_bytes: glb.plain_bytes,
            order_bytes: glb.order_bytes,
            range_bytes: glb.range_bytes,
            meshes: glb.meshes.iter().enumerate().map(mesh).collect(),
        }
    }

    /// Adds rows of a table.
    pub(super) fn rows(&self, row: &mut impl FnMut(&str, String)) {
        let cost = |bytes: usize| {
            let share = 100.0 * bytes as f64 / self.plain_bytes.max(1) as f64;
            format!("{} (+{share:.1} % of the plain file)", format_bytes(bytes))
        };
        row("order", cost(self.order_bytes));
        if self.range_bytes > 0 {
            row("index ranges", cost(self.range_bytes));
        }
    }
}
