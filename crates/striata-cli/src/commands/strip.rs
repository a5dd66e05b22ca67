//! `strip`: converts a mesh to triangle strips and reports their cost.

use std::path::Path;
use std::time::Instant;

use serde::Serialize;
use serde_json::Value;
use striata::mesh::weld;

use super::{strip_blocks, strip_levels};
use crate::args::StripArgs;
use crate::strip_lists::{StripLists, check_output};
use striata_command::failure::Failure;
use striata_command::input::Input;
use striata_command::output::{Output, format_count, format_noun_count};
use striata_command::save::{Primitives, georeference_of, is_stdout, write_mesh};
use striata_command::strip_report::StripReport;

#[derive(Serialize)]
struct StripCostReport {
    #[serde(flatten)]
    strips: StripReport,
    seed: u64,
    budget_secs: Option<f64>,
    /// Number of indices in the file that was written, which uses degenerate triangles instead of restarts,
    /// or triangle lists for groups that need fewer indices that way.
    stitched_index_count: Option<usize>,
    /// Number of groups that were written as triangle lists, since these need fewer indices.
    plain_group_count: Option<usize>,
    #[serde(skip_serializing_if = "Option::is_none")]
    georeference: Option<Value>,
    secs: f64,
}

/// Reads and stripifies the mesh, writes it if requested, and reports.
///
/// # Errors
/// If any of this fails; an existing output is then left unchanged.
pub(crate) fn run(args: &StripArgs, output: &Output) -> Result<(), Failure> {
    if let Some(block_triangles) = args.block_triangles {
        return strip_blocks::run(args, block_triangles, output);
    }
    if let Some(levels) = &args.levels.levels {
        return strip_levels::run(args, levels, output);
    }
    let started = Instant::now();
    let format = args.format();
    args.output.iter().try_for_each(|path| check_output(path, &format, output))?;
    let mut bar = output.bar();
    bar.phase("read");
    let input = Input::open(&args.input)?;
    let in_file = |failure: Failure| failure.in_file(&input.name);
    let mut mesh = input.mesh(output)?;
    if args.weld {
        bar.phase("weld");
        mesh = weld(&mesh).map_err(|error| in_file(error.into()))?.mesh;
    }
    let stripped = args.plan().run(&mesh, &mut |share| bar.share("strip", share));
    let stripped = stripped.map_err(|error| in_file(error.into()))?;
    let strips =
        StripReport::new(args.strips.to_string(), &mesh, &stripped, args.search.cache_size as usize)?
            .with_strip_count_bound(&args.strips, &mesh);
    let mut report = StripCostReport {
        strips,
        seed: args.search.seed,
        budget_secs: args.search.budget,
        stitched_index_count: None,
        plain_group_count: None,
        georeference: georeference_of(&mesh),
        secs: 0.0,
    };
    if let Some(path) = &args.output {
        bar.phase("write");
        let StripLists { lists, index_count, plain_group_count } = StripLists::new(&mesh, &stripped.strips);
        report.stitched_index_count = Some(index_count);
        report.plain_group_count = Some(plain_group_count);
        write_mesh(&mesh, Primitives::Strips(lists), path, &format, output)?;
    }
    drop(bar);
    report.secs = started.elapsed().as_secs_f64();
    let text = report.to_text(args.output.as_deref());
    match args.output {
        Some(_) => output.summary(&report, &text)?,
        None => output.data(&report, &text)?,
    }
    let StripReport { strip_count, triangle_count, indices_per_triangle, .. } = report.strips;
    if !args.weld && triangle_count > 1 && strip_count == triangle_count {
        output.say("hint: every strip is a single triangle; use --weld to merge equal vertices");
    } else if indices_per_triangle > 3.0 {
        output.say("hint: a triangle list takes fewer indices, since few triangles share an edge");
    }
    Ok(())
}

impl StripCostReport {
    fn to_text(&self, path: Option<&Path>) -> String {
        let mut text = self.strips.to_text();
        if let (Some(path), Some(count)) = (path, self.stitched_index_count) {
            let name = if is_stdout(path) { "stdout".into() } else { path.to_string_lossy() };
            let plain = match self.plain_group_count {
                None | Some(0) => String::new(),
                Some(groups) => {
                    let groups = format_noun_count(groups, "group", "groups");
                    format!("; {groups} as triangle lists, which are shorter")
                }
            };
            text.push_str(&format!(
                "{name}: {} indices, strips joined by degenerate triangles{plain}\n",
                format_count(count)
            ));
        }
        text
    }
}
