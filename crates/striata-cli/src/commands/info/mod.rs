//! `info`: shows what a mesh, .striata file or stream contains.

mod limits;
mod part_statistics;
mod seam_statistics;
mod step_statistics;

use serde::Serialize;
use serde_json::{Map, Value, json};
use striata::file::{DecodeError, FORMAT_VERSION, StriataFile};
use striata::mesh::{AttributeLayer, IndexedMesh, LevelTable, Statistics, TriangleGroup, validate, weld};
use striata::model::{LodModel, ModelKind, PartBytes, StripModel};
use striata_io::Scene;
use striata_stream::{StreamDefect, StreamInfo, StreamLevels};

use self::limits::{Parts, Seams, StepSummary, notes};
use crate::args::InfoArgs;
use crate::commands::build::{ModelCost, model_costs, parts_in_file};
use crate::commands::paged;
use crate::commands::scene::SceneFacts;
use striata_command::failure::Failure;
use striata_command::input::Input;
use striata_command::output::{
    Output, Table, format_bytes, format_count, format_duration, format_length, format_noun_count,
};
use striata_command::save::georeference_of;
use striata_command::stream::stream_facts_json;

/// Number of defects that the text lists; JSON lists more of them.
const LISTED_DEFECTS: usize = 5;

/// Report on a mesh or file.
///
/// Topological counts are null if the mesh is inconsistent; the defects say why.
#[derive(Serialize)]
struct InfoReport {
    kind: &'static str,
    format_version: Option<u32>,
    /// Size of the file; null for a shape.
    file_bytes: Option<usize>,
    vertex_count: usize,
    triangle_count: usize,
    position_count: Option<usize>,
    component_count: Option<usize>,
    boundary_edge_count: Option<usize>,
    boundary_loop_count: Option<usize>,
    non_manifold_edge_count: Option<usize>,
    non_manifold_vertex_count: Option<usize>,
    inconsistent_edge_count: Option<usize>,
    degenerate_triangle_count: Option<usize>,
    duplicate_triangle_count: Option<usize>,
    unused_vertex_count: Option<usize>,
    genus: Option<usize>,
    is_closed: Option<bool>,
    area: Option<f64>,
    /// Seams; null if an index is out of range, a layer has the wrong length, or a coordinate is not finite.
    seams: Option<Seams>,
    /// Connected parts; null under the same conditions as `seams`, and if there are no triangles.
    parts: Option<Parts>,
    attributes: Vec<Value>,
    face_attributes: Vec<Value>,
    groups: Vec<Value>,
    materials: Vec<String>,
    /// Smallest and largest coordinates in the file.
    bounds: Option<Value>,
    /// Origin that positions are relative to, if single precision cannot hold the coordinates of the file.
    #[serde(skip_serializing_if = "Option::is_none")]
    origin: Option<[f64; 3]>,
    /// Place on the Earth of a terrain.
    #[serde(skip_serializing_if = "Option::is_none")]
    georeference: Option<Value>,
    diagonal: f64,
    models: Map<String, Value>,
    /// Sizes and build times of all models, with `--models`.
    #[serde(skip_serializing_if = "Option::is_none")]
    model_costs: Option<Vec<ModelCost>>,
    step_count: Option<usize>,
    base: Option<Value>,
    error_max: Option<f32>,
    error_is_guaranteed: Option<bool>,
    /// Special steps, for files with collapses.
    #[serde(skip_serializing_if = "Option::is_none")]
    steps: Option<StepSummary>,
    /// Sentences about what limits simplification.
    notes: Vec<String>,
    /// Facts about the stream, for files with a stream.
    #[serde(skip_serializing_if = "Option::is_none")]
    stream: Option<Value>,
    /// Parts of a scene; missing for a mesh.
    #[serde(skip_serializing_if = "Option::is_none")]
    scene: Option<SceneFacts>,
    sections: Vec<Value>,
    defect_counts: Map<String, Value>,
    defects: Vec<String>,
}

/// Reads the input and prints the report.
///
/// # Errors
/// If the file cannot be read.
pub(crate) fn run(args: &InfoArgs, output: &Output) -> Result<(), Failure> {
    if paged::is_paged_file(&args.input) {
        return paged::info(&args.input, output);
    }
    let input = Input::open(&args.input)?.with_raster(args.raster)?;
    let (mut report, mesh) = if input.has_levels() {
        of_container(&input, output)?
    } else if let Some((facts, scene)) = scene_of(&input, args, output)? {
        // Reading a file of a scene as one mesh shows it as it is, with defects and unused vertices.
        let mesh = if input.has_scene_levels() { scene.flattened()? } else { input.mesh(&Output::quiet())? };
        let mut report = InfoReport::new(&input, &mesh);
        report.set_scene(facts, &scene);
        (report, mesh)
    } else {
        let mesh = input.mesh(output)?;
        (InfoReport::new(&input, &mesh), mesh)
    };
    if args.models {
        let costs = model_costs(&mesh, &mut output.bar());
        report.model_costs = Some(costs.map_err(|failure| failure.in_file(&input.name))?);
    }
    output.data(&report, &report.to_text(&input.name))
}

/// Returns the parts of a scene and its full scene; `None` if the input is no scene, or the user wants one
/// mesh.
fn scene_of(input: &Input, args: &InfoArgs, output: &Output) -> Result<Option<(SceneFacts, Scene)>, Failure> {
    if args.scene.flat { Ok(None) } else { SceneFacts::read(input, output) }
}

/// Returns the report on a file with levels, and its full mesh.
fn of_container(input: &Input, output: &Output) -> Result<(InfoReport, IndexedMesh), Failure> {
    let file = input.striata()?;
    input.remark_on(&file, output)?;
    let mesh = file.mesh().map_err(|error| input.damaged(&error))?;
    let mut report = InfoReport::new(input, &mesh);
    report.format_version = (input.kind() == "striata").then_some(FORMAT_VERSION);
    report.add_levels(&file.levels().map_err(|error| input.damaged(&error))?);
    let is_guaranteed = file.has_guaranteed_errors().map_err(|error| input.damaged(&error))?;
    report.error_is_guaranteed = Some(is_guaranteed);
    if file.has_collapses() {
        let refinable = file.refinable_mesh().map_err(|error| input.damaged(&error))?;
        report.steps = Some(StepSummary::of(&refinable));
    }
    if let Some(model) = file.lod_strips() {
        let model = model.map_err(|error| input.damaged(&error))?;
        let strip_count = model.draw_counts(&model.new_state()).strip_count;
        report.add_model(ModelKind::LodStrips, &parts_in_file(model.bytes()), Some(strip_count));
    }
    if let Some(model) = file.mts() {
        let model = model.map_err(|error| input.damaged(&error))?;
        report.add_model(ModelKind::Mts, &model.bytes(), Some(model.strip_count()));
    }
    if let Some(model) = file.fans() {
        let fans = model.map_err(|error| input.damaged(&error))?;
        report.add_model(ModelKind::Fans, &parts_in_file(fans.bytes()), None);
    }
    if let Some(model) = file.patterns() {
        let patterns = model.map_err(|error| input.damaged(&error))?;
        report.add_model(ModelKind::Patterns, &patterns.bytes(), None);
        let model = &mut report.models[ModelKind::Patterns.as_str()];
        model["rule_count"] = json!(patterns.rule_count());
        model["overlap_count"] = json!(patterns.overlap_count());
        model["has_overlap_errors"] = json!(patterns.has_overlap_errors());
    }
    if let Some(stream) = file.stream() {
        report.add_stream(&file, stream.map_err(|error| input.damaged(&error))?, input)?;
    }
    report.sections =
        file.sections().iter().map(|s| json!({ "kind": s.kind.to_string(), "bytes": s.bytes })).collect();
    Ok((report, mesh))
}

impl InfoReport {
    /// Adds the facts from the header of the stream, and how much of the stream is present.
    fn add_stream(&mut self, file: &StriataFile<'_>, stream: &[u8], input: &Input) -> Result<(), Failure> {
        let damaged = |error: DecodeError| input.damaged(&error);
        let facts = StreamInfo::read(stream).map_err(|error| damaged(error.into()))?;
        let facts = facts.ok_or(StreamDefect::NoBase).map_err(|error| damaged(error.into()))?;
        self.add_model(ModelKind::Progressive, &[PartBytes { name: "stream", bytes: stream.len() }], None);
        let split_count = match (file.is_stream_only(), file.is_truncated()) {
            (true, _) => file.levels().map_err(damaged)?.step_count(),
            (false, false) => facts.step_count,
            (false, true) => {
                let mut levels = StreamLevels::new(stream).map_err(damaged)?;
                levels.decode_all().map_err(damaged)?;
                levels.decoder().split_count()
            }
        };
        let mut described = stream_facts_json(&facts);
        described["read_bytes"] = json!(stream.len());
        described["split_count"] = json!(split_count);
        described["is_complete"] = json!(!file.is_truncated());
        self.stream = Some(described);
        Ok(())
    }

    fn add_model(&mut self, kind: ModelKind, parts: &[PartBytes], strip_count: Option<usize>) {
        let bytes: usize = parts.iter().map(|part| part.bytes).sum();
        let by_part: Map<String, Value> = parts.iter().map(|p| (p.name.to_owned(), p.bytes.into())).collect();
        let bytes_per_vertex = bytes as f64 / self.vertex_count.max(1) as f64;
        let mut model = json!({ "bytes": bytes, "bytes_per_vertex": bytes_per_vertex, "parts": by_part });
        if let Some(strip_count) = strip_count {
            model["strip_count"] = json!(strip_count);
        }
        self.models.insert(kind.to_string(), model);
    }

    fn new(input: &Input, mesh: &IndexedMesh) -> Self {
        let statistics = Statistics::of(mesh).ok();
        let count = |pick: fn(&Statistics) -> usize| statistics.as_ref().map(pick);
        let defects = validate(mesh);
        let welded = weld(mesh).ok();
        let (seams, parts) = (welded.as_ref().map(Seams::of), welded.as_ref().and_then(Parts::of));
        let notes = notes(seams.as_ref(), parts.as_ref(), statistics.as_ref());
        Self {
            kind: input.kind(),
            format_version: None,
            file_bytes: input.file_bytes(),
            vertex_count: mesh.vertex_count(),
            triangle_count: mesh.triangle_count(),
            position_count: count(|s| s.position_count),
            component_count: count(|s| s.component_count),
            boundary_edge_count: count(|s| s.boundary_edge_count),
            boundary_loop_count: count(|s| s.boundary_loop_count),
            non_manifold_edge_count: count(|s| s.non_manifold_edge_count),
            non_manifold_vertex_count: count(|s| s.non_manifold_vertex_count),
            inconsistent_edge_count: count(|s| s.inconsistent_edge_count),
            degenerate_triangle_count: count(|s| s.degenerate_triangle_count),
            duplicate_triangle_count: count(|s| s.duplicate_triangle_count),
            unused_vertex_count: count(|s| s.unused_vertex_count),
            genus: statistics.as_ref().and_then(|s| s.genus),
            is_closed: statistics.as_ref().map(|s| s.is_closed),
            area: statistics.as_ref().map(|s| s.area),
            seams,
            parts,
            attributes: mesh.layers.iter().map(described).collect(),
            face_attributes: mesh.triangle_layers.iter().map(described).collect(),
            groups: groups(mesh),
            materials: mesh.appearance.materials.iter().map(|material| material.name.clone()).collect(),
            bounds: bounds_in_file(mesh),
            origin: mesh.needs_doubles().then_some(mesh.origin),
            georeference: georeference_of(mesh),
            diagonal: mesh.diagonal(),
            models: Map::new(),
            model_costs: None,
            step_count: None,
            base: None,
            error_max: None,
            error_is_guaranteed: None,
            steps: None,
            notes,
            stream: None,
            scene: None,
            sections: Vec::new(),
            defect_counts: defects
                .counts()
                .map(|(kind, count)| (kind.as_str().to_owned(), count.into()))
                .collect(),
            defects: defects.defects().iter().map(ToString::to_string).collect(),
        }
    }

    /// Adds the parts of a scene, with the defects of each of its meshes: as one mesh, vertices without a
    /// skin would count as defective next to others with one.
    fn set_scene(&mut self, facts: SceneFacts, scene: &Scene) {
        self.scene = Some(facts);
        (self.defect_counts, self.defects) = (Map::new(), Vec::new());
        for (index, mesh) in scene.meshes().iter().enumerate() {
            let Some(found) = mesh.as_ref().map(validate) else { continue };
            for (kind, count) in found.counts() {
                let sum = self.defect_counts.entry(kind.as_str()).or_insert(json!(0));
                *sum = json!(sum.as_u64().unwrap_or(0) + count as u64);
            }
            let name = || match scene.mesh_name(index) {
                "" => format!("mesh {index}"),
                name => format!("mesh {index} ({name})"),
            };
            self.defects.extend(found.defects().iter().map(|defect| format!("{}: {defect}", name())));
        }
    }

    fn add_levels(&mut self, sequence: &LevelTable) {
        self.step_count = Some(sequence.step_count());
        self.base = Some(json!({
            "vertex_count": sequence.base_vertex_count(),
            "triangle_count": sequence.triangle_count_at(0),
        }));
        self.error_max = Some(sequence.error_at(0));
    }

    fn to_text(&self, name: &str) -> String {
        let mut table = Table::default();
        let mut row = |name: &str, value: String| table.row(vec![name.to_owned(), value]);
        let size = self.file_bytes.map_or_else(String::new, |bytes| format!(", {}", format_bytes(bytes)));
        row("file", format!("{name} ({}{size})", self.kind));
        row("triangles", format_count(self.triangle_count));
        row("vertices", format_count(self.vertex_count));
        let number = |count: Option<usize>| count.map_or_else(|| "unknown".to_owned(), format_count);
        row("positions", number(self.position_count));
        row("connected parts", number(self.component_count));
        for (name, value) in self.parts.iter().flat_map(Parts::rows) {
            row(name, value);
        }
        for (name, value) in self.seams.iter().flat_map(Seams::rows) {
            row(name, value);
        }
        row("boundary edges", number(self.boundary_edge_count));
        row("non-manifold edges", number(self.non_manifold_edge_count));
        for (name, count) in [
            ("degenerate triangles", self.degenerate_triangle_count),
            ("duplicate triangles", self.duplicate_triangle_count),
        ] {
            if count.is_none_or(|count| count > 0) {
                row(name, number(count));
            }
        }
        row("genus", number(self.genus));
        let names = |values: &[Value]| {
            let names = values.iter().filter_map(|value| value["name"].as_str());
            names.collect::<Vec<_>>().join(", ")
        };
        row("attributes", or_none(names(&self.attributes)));
        if !self.face_attributes.is_empty() {
            let typed =
                |value: &Value| Some(format!("{} ({})", value["name"].as_str()?, value["type"].as_str()?));
            let typed: Vec<String> = self.face_attributes.iter().filter_map(typed).collect();
            row("face attributes", typed.join(", "));
        }
        row("materials", or_none(self.materials.join(", ")));
        row("diagonal", format_length(self.diagonal));
        if let Some([x, y, z]) = self.origin {
            row("origin", format!("{x}, {y}, {z} (coordinates in double precision)"));
        }
        for (name, value) in self.scene.iter().flat_map(SceneFacts::rows) {
            row(name, value);
        }
        if let (Some(step_count), Some(base), Some(error)) = (self.step_count, &self.base, self.error_max) {
            row("levels", format_count(step_count + 1));
            let kind = if self.error_is_guaranteed == Some(true) { "guaranteed error" } else { "error" };
            let triangles = base["triangle_count"].as_u64().unwrap_or(0) as usize;
            let triangles = format_noun_count(triangles, "triangle", "triangles");
            row("base mesh", format!("{triangles}, {kind} {}", format_length(error.into())));
        }
        for (name, value) in self.steps.iter().flat_map(StepSummary::rows) {
            row(name, value);
        }
        for (model, facts) in &self.models {
            let bytes_per_vertex = facts["bytes_per_vertex"].as_f64().unwrap_or(0.0);
            row(model, format!("{bytes_per_vertex:.1} bytes per vertex"));
        }
        if let Some(stream) = &self.stream {
            let number = |key: &str| format_count(stream[key].as_u64().unwrap_or(0) as usize);
            let effort = stream["effort"].as_str().unwrap_or_default();
            let exact = if stream["is_lossless"] == true { ", lossless" } else { "" };
            let [bits, chunks] = [number("grid_bits"), number("chunk_count")];
            let step = format_length(stream["grid_step"].as_f64().unwrap_or(0.0));
            row("stream", format!("{effort} effort, {bits} bits (step {step}){exact}, {chunks} chunks"));
            let [read, whole] = [number("read_bytes"), number("bytes")];
            let [split_count, step_count] = [number("split_count"), number("step_count")];
            row("stream read", format!("{read} of {whole} bytes, split {split_count} of {step_count}"));
        }
        for cost in self.model_costs.iter().flatten() {
            row(&format!("{} if built", cost.name), text_of_cost(cost));
        }
        for (kind, count) in &self.defect_counts {
            row("defects", format!("{count} {kind}"));
        }
        let mut text = table.to_text();
        for defect in self.defects.iter().take(LISTED_DEFECTS) {
            text.push_str(&format!("  {defect}\n"));
        }
        for note in &self.notes {
            text.push_str(&format!("\n{note}\n"));
        }
        text
    }
}

fn text_of_cost(cost: &ModelCost) -> String {
    let instance = match cost.instance_bytes {
        Some(bytes) => format!(", {} per instance", format_bytes(bytes)),
        None => String::new(),
    };
    let bytes = format!("{}, {:.1} bytes per vertex", format_bytes(cost.bytes), cost.bytes_per_vertex);
    format!("{bytes}{instance}, built in {}", format_duration(cost.build_secs))
}

fn or_none(names: String) -> String {
    if names.is_empty() { "none".to_owned() } else { names }
}

fn described(layer: &AttributeLayer) -> Value {
    json!({
        "name": layer.semantic.to_string(),
        "component_count": layer.component_count,
        "type": layer.data.type_name(),
        "normalized": layer.normalized,
    })
}

fn groups(mesh: &IndexedMesh) -> Vec<Value> {
    let described = |group: &TriangleGroup| {
        let TriangleGroup { name, material, count, .. } = group;
        json!({ "name": name, "material": material, "triangle_count": count })
    };
    mesh.groups.iter().map(described).collect()
}

/// Returns the smallest and largest coordinates in the file.
fn bounds_in_file(mesh: &IndexedMesh) -> Option<Value> {
    if !mesh.needs_doubles() {
        return mesh.bounds().map(|bounds| json!({ "min": bounds.min, "max": bounds.max }));
    }
    mesh.file_bounds().map(|[min, max]| json!({ "min": min, "max": max }))
}
