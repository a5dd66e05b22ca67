//! The report of `build`.

use serde::Serialize;
use serde_json::{Map, Value, json};
use striata::mesh::IndexedMesh;
use striata_stream::StreamInfo;

use super::build_output::BuildOutput;
use crate::args::BuildArgs;
use striata_command::clock::{Phases, peak_rss_bytes};
use striata_command::output::{Table, format_bytes, format_count, format_duration, format_length};
use striata_command::save::{DEFAULT_NAME_NOTE, georeference_of};
use striata_command::stream::stream_facts_json;
use striata_command::strip_report::StripReport;

#[derive(Serialize)]
pub(super) struct BuildReport {
    path: String,
    input: Value,
    step_count: usize,
    base: Value,
    error_max: f32,
    error_is_guaranteed: bool,
    order: &'static str,
    stop_reason: &'static str,
    /// Why the base mesh has more triangles than `--base`; null if it does not.
    pub shortfall: Option<String>,
    models: Map<String, Value>,
    strips: Value,
    #[serde(skip_serializing_if = "Option::is_none")]
    stream: Option<Value>,
    #[serde(skip_serializing_if = "Option::is_none")]
    georeference: Option<Value>,
    output_bytes: usize,
    #[serde(flatten)]
    pub phases: Phases,
    peak_rss_bytes: Option<u64>,
}

impl BuildReport {
    pub(super) fn new(
        mesh: &IndexedMesh,
        built: &BuildOutput,
        path: String,
        output_bytes: usize,
        phases: Phases,
    ) -> Self {
        let sequence = built.steps.levels();
        let vertex_count = built.steps.mesh().vertex_count().max(1);
        let mut models = Map::new();
        for (kind, parts) in built.models.parts() {
            let bytes = parts.iter().map(|part| part.bytes).sum::<usize>();
            let per_vertex = bytes as f64 / vertex_count as f64;
            models.insert(kind.to_string(), json!({ "bytes": bytes, "bytes_per_vertex": per_vertex }));
        }
        let mut strips = json!(built.strip_report);
        if !strips.is_null() {
            strips["secs"] = json!(phases.secs_of("strip"));
        }
        let facts = built.models.stream.as_ref().and_then(|s| StreamInfo::read(&s.bytes).ok().flatten());
        Self {
            path,
            shortfall: None,
            stream: facts.as_ref().map(stream_facts_json),
            georeference: georeference_of(mesh),
            input: json!({
                "vertex_count": mesh.vertex_count(),
                "triangle_count": mesh.triangle_count(),
                "position_count": sequence.positions().position_count(),
            }),
            step_count: sequence.step_count(),
            base: json!({
                "vertex_count": sequence.base_vertex_count(),
                "triangle_count": sequence.triangle_count_at(0),
            }),
            error_max: sequence.error_at(0),
            error_is_guaranteed: built.error_is_guaranteed,
            order: built.order.as_str(),
            stop_reason: built.stop_reason.as_str(),
            models,
            strips,
            output_bytes,
            phases,
            peak_rss_bytes: peak_rss_bytes(),
        }
    }

    pub(super) fn to_text(&self, args: &BuildArgs, built: &BuildOutput, diagonal: f64) -> String {
        let sequence = built.steps.levels();
        let last = sequence.step_count();
        let error = f64::from(sequence.error_at(0));
        let share = if diagonal > 0.0 { 100.0 * error / diagonal } else { 0.0 };
        let mut table = Table::default();
        let mut row = |name: &str, value: String| table.row(vec![name.to_owned(), value]);
        let triangles = |at| format_count(sequence.triangle_count_at(at));
        row("triangles", format!("{} down to {}", triangles(last), triangles(0)));
        row("levels", format_count(last + 1));
        let kind = if self.error_is_guaranteed { "guaranteed" } else { "estimated" };
        row("error of base mesh", format!("{} ({share:.3} % of the diagonal), {kind}", format_length(error)));
        if let Some(StripReport { algorithm, strip_count, indices_per_triangle, .. }) = &built.strip_report {
            let strips = format!("{} ({algorithm})", format_count(*strip_count));
            row("strips", format!("{strips}, {indices_per_triangle:.3} indices per triangle"));
        }
        for (name, model) in &self.models {
            let bytes = model["bytes"].as_u64().unwrap_or(0) as usize;
            let per_vertex = model["bytes_per_vertex"].as_f64().unwrap_or(0.0);
            row(name, format!("{}, {per_vertex:.1} bytes per vertex", format_bytes(bytes)));
        }
        let chosen = if args.output.is_none() { DEFAULT_NAME_NOTE } else { "" };
        row("file", format!("{} ({}){chosen}", self.path, format_bytes(self.output_bytes)));
        row("time", format_duration(self.phases.total_secs()));
        let shortfall =
            self.shortfall.as_ref().map(|shortfall| format!("--base was not reached: {shortfall}"));
        table.to_text() + &shortfall.unwrap_or_default()
    }
}
