//! Memory of view-dependent models, as in figure 5 of \[Cor01\]: static data, and what each instance owns.

use serde::Serialize;
use striata::model::LodModel;
use striata_lab::baseline::{OrderedMeshes, ProgressiveMeshes};
use striata_lab::{Accounting, PaperBytes};

use super::super::bars::{BarChart, Bars};
use super::super::papers::cor01_megabytes;
use super::figures::{NORMAL_BYTES, PACKED_NORMAL_BYTES, POSITION_BYTES};
use super::followers::{FANS, KEPT, Models, NAMES, PUBLISHED, STATELESS, UNIFORM, VDPM, VDPM_KEPT};
use super::scenario::ScenarioRun;

/// Memory of a model in bytes per vertex of the full mesh.
#[derive(Clone, Debug, Serialize)]
pub(super) struct MemoryRow {
    name: &'static str,
    /// Static data without positions and normals.
    bytes_per_vertex: f64,
    /// Including positions, and normals of 4 bytes.
    bytes_per_vertex_packed: f64,
    /// Including positions, and normals of 12 bytes.
    bytes_per_vertex_plain: f64,
    /// Static data as the model's paper counts it; null if there is no paper.
    paper_bytes_per_vertex: Option<f64>,
    /// Maximum owned by an instance on the orbit at the smallest screen error.
    instance_bytes_per_vertex: f64,
    /// Instance memory as papers count it; null if they do not specify it.
    paper_instance_bytes_per_vertex: Option<f64>,
    /// Published value for this mesh in 10^6 bytes; null if there is none.
    published_megabytes: Option<f64>,
}

/// Static bytes of the models used by the followers, in the order of their names.
pub(super) fn static_bytes(models: &Models<'_>) -> [usize; NAMES.len()] {
    let fans = bytes_of(&models.fans);
    // Uniform levels need no bounds.
    let bounds = models.fans.bytes().into_iter().find(|part| part.name == "bounds");
    let table = fans - bounds.map_or(0, |part| part.bytes);
    let vdpm = models.vdpm.as_ref().map_or(0, bytes_of);
    let published = models.published.as_ref().map_or(0, bytes_of);
    [fans, fans, fans, vdpm, vdpm, published, fans, table]
}

fn bytes_of(model: &impl LodModel) -> usize {
    model.bytes().iter().map(|part| part.bytes).sum()
}

/// Measures all models; `runs` are the followers' runs on the orbit.
pub(super) fn measure(models: &Models<'_>, runs: &[Option<ScenarioRun>]) -> Vec<MemoryRow> {
    let mesh = &models.refinable.mesh;
    let per_vertex = |bytes: usize| bytes as f64 / mesh.vertex_count().max(1) as f64;
    let row = |name, model: usize, paper: Option<f64>, instance: usize| MemoryRow {
        name,
        bytes_per_vertex: per_vertex(model),
        bytes_per_vertex_packed: per_vertex(model) + POSITION_BYTES + PACKED_NORMAL_BYTES,
        bytes_per_vertex_plain: per_vertex(model) + POSITION_BYTES + NORMAL_BYTES,
        paper_bytes_per_vertex: paper,
        instance_bytes_per_vertex: per_vertex(instance),
        paper_instance_bytes_per_vertex: None,
        published_megabytes: None,
    };
    let paper = |bytes: usize| Some(per_vertex(bytes) + POSITION_BYTES + NORMAL_BYTES);
    let max_of = |follower: usize| {
        let run = runs[follower].as_ref()?;
        Some((run.instance_bytes, run.triangles.iter().copied().max().unwrap_or(0)))
    };
    let most_uniform = max_of(UNIFORM).map_or(0, |(_, triangles)| triangles);
    let progressive = ProgressiveMeshes::build(models.refinable);
    let mut state = progressive.new_state();
    progressive.move_to(&mut state, models.refinable.sequence.split_count_for_triangles(most_uniform));
    let ordered = OrderedMeshes::build(models.refinable);
    let [fans, ..] = static_bytes(models);
    let bits = max_of(STATELESS).map_or(0, |(bytes, _)| bytes);
    let mut rows = vec![
        row("plain mesh", 12 * mesh.triangle_count(), None, 0),
        row(
            "progressive-meshes",
            bytes_of(&progressive),
            paper(progressive.paper_bytes(Accounting::Words)),
            progressive.state_bytes(&state),
        ),
        row(
            "ordered-meshes",
            bytes_of(&ordered),
            paper(ordered.paper_bytes(Accounting::Words)),
            ordered.state_bytes(&ordered.new_state()),
        ),
        MemoryRow { paper_instance_bytes_per_vertex: Some(1.0 / 8.0), ..row("fans", fans, None, bits) },
        row("fans, a front", fans, None, max_of(FANS).map_or(0, |(bytes, _)| bytes)),
        row("fans, all kept", fans, None, max_of(KEPT).map_or(0, |(bytes, _)| bytes)),
    ];
    if let (Ok(published), Some((bytes, _))) = (&models.published, max_of(PUBLISHED)) {
        rows.push(MemoryRow {
            published_megabytes: cor01_megabytes(mesh.triangle_count()),
            paper_instance_bytes_per_vertex: Some(1.0 / 8.0),
            ..row(
                "fans-published",
                bytes_of(published),
                paper(published.paper_bytes(Accounting::Words)),
                bytes,
            )
        });
    }
    if let (Ok(vdpm), Some((bytes, triangles))) = (&models.vdpm, max_of(VDPM)) {
        rows.push(MemoryRow {
            // A closed surface has half as many vertices as triangles.
            paper_instance_bytes_per_vertex: Some(per_vertex(112 * triangles / 2)),
            ..row("vdpm", bytes_of(vdpm), paper(vdpm.paper_bytes(Accounting::Words)), bytes)
        });
        let kept = max_of(VDPM_KEPT).map_or(0, |(bytes, _)| bytes);
        rows.push(row("vdpm-kept", bytes_of(vdpm), None, kept));
    }
    rows
}

/// Header and rows of the table.
pub(super) fn table(rows: &[MemoryRow]) -> Vec<Vec<String>> {
    let head = [
        "model",
        "bytes per vertex",
        "with positions, 4-byte normals",
        "12-byte normals",
        "as its paper counts",
        "published, MB",
        "instance",
        "as papers count",
    ];
    let mut table = vec![head.map(str::to_owned).to_vec()];
    let or_dash = |value: Option<f64>| value.map_or_else(|| "-".to_owned(), |value| format!("{value:.2}"));
    for row in rows {
        table.push(vec![
            row.name.to_owned(),
            format!("{:.1}", row.bytes_per_vertex),
            format!("{:.1}", row.bytes_per_vertex_packed),
            format!("{:.1}", row.bytes_per_vertex_plain),
            or_dash(row.paper_bytes_per_vertex),
            or_dash(row.published_megabytes),
            format!("{:.2}", row.instance_bytes_per_vertex),
            or_dash(row.paper_instance_bytes_per_vertex),
        ]);
    }
    table
}

/// Bar chart of the same data.
pub(super) fn chart(rows: &[MemoryRow]) -> BarChart {
    let bars = |row: &MemoryRow| Bars {
        name: row.name.to_owned(),
        values: [
            Some(row.bytes_per_vertex_plain),
            Some(row.instance_bytes_per_vertex),
            row.paper_bytes_per_vertex,
        ]
        .into_iter()
        .flatten()
        .collect(),
    };
    BarChart {
        title: "bytes per vertex, including positions and 12-byte normals",
        kinds: vec!["static", "instance", "static, paper"],
        bars: rows.iter().map(bars).collect(),
    }
}
