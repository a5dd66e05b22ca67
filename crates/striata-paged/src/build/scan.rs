//! The first pass over the input: its bounds, and samples for the partition.

use std::sync::Mutex;

use striata::mesh::ColorSpace;
use striata::simplify::cells::Partition;
use striata::{Progress, ProgressFn};
use striata_io::pieces::{Piece, PieceSource};

use super::plan::Scanned;
use super::runner::in_parallel;
use super::{BuildError, BuildOptions};
use crate::{Grid, Metadata, PagedGroup, PagedLayer};

/// One triangle in this many is a sample for the partition.
const SAMPLE_STRIDE: usize = 32;

/// What is known about one piece.
#[derive(Default)]
struct PieceScan {
    min: [f32; 3],
    max: [f32; 3],
    triangle_count: u64,
    edge_sum: f64,
    samples: Vec<[f32; 3]>,
}

/// Reads the whole input once.
pub(super) fn scan(
    source: &dyn PieceSource,
    options: &BuildOptions,
    (threads, progress): (usize, &mut ProgressFn<'_>),
) -> Result<Scanned, BuildError> {
    let count = source.piece_count();
    let scans: Mutex<Vec<Option<PieceScan>>> = Mutex::new((0..count).map(|_| None).collect());
    let mut report = |done| Progress { phase: "read", done, total: count }.report(progress);
    in_parallel(count as usize, (threads, &mut report), |index| {
        let scan = scan_piece(&source.read_piece(index as u64)?);
        if let Ok(mut scans) = scans.lock() {
            scans[index] = Some(scan);
        }
        Ok(())
    })?;
    let scans: Vec<PieceScan> = scans.into_inner().into_iter().flatten().flatten().collect();
    let full = scans.iter().filter(|scan| scan.triangle_count > 0);
    let mut total = PieceScan { min: [f32::MAX; 3], max: [f32::MIN; 3], ..PieceScan::default() };
    for scan in full {
        for axis in 0..3 {
            total.min[axis] = total.min[axis].min(scan.min[axis]);
            total.max[axis] = total.max[axis].max(scan.max[axis]);
        }
        total.triangle_count += scan.triangle_count;
        total.edge_sum += scan.edge_sum;
    }
    if total.triangle_count == 0 {
        return Err(BuildError::Empty { input: source.summary().name.clone() });
    }
    let samples: Vec<[f32; 3]> = scans.into_iter().flat_map(|scan| scan.samples).collect();
    let per_sample = total.triangle_count as f64 / samples.len().max(1) as f64;
    let partition = Partition::new(&samples, per_sample, options.cell);
    let mut metadata = describe(source, options, &total);
    metadata.cell_counts = partition.levels().iter().map(|level| level.cell_count()).collect();
    Ok(Scanned { metadata, partition, piece_count: count })
}

fn scan_piece(piece: &Piece) -> PieceScan {
    let mut scan = PieceScan { min: [f32::MAX; 3], max: [f32::MIN; 3], ..PieceScan::default() };
    for (index, corners) in piece.triangles.iter().enumerate() {
        let at = corners.map(|v| piece.positions[v as usize]);
        for (axis, &x) in at.iter().flat_map(|p| p.iter().enumerate()) {
            scan.min[axis] = scan.min[axis].min(x);
            scan.max[axis] = scan.max[axis].max(x);
        }
        let edge: f64 = (0..3).map(|a| f64::from(at[0][a] - at[1][a]).powi(2)).sum();
        scan.edge_sum += edge.sqrt();
        if index % SAMPLE_STRIDE == 0 {
            scan.samples.push(at[0]);
        }
    }
    scan.triangle_count = piece.triangles.len() as u64;
    scan
}

fn describe(source: &dyn PieceSource, options: &BuildOptions, total: &PieceScan) -> Metadata {
    let summary = source.summary();
    let mean_edge = total.edge_sum / total.triangle_count as f64;
    let groups: Vec<PagedGroup> = summary
        .groups
        .iter()
        .map(|group| PagedGroup { name: group.name.clone(), material: group.material })
        .collect();
    let mut metadata = Metadata {
        source: summary.name.clone(),
        triangle_count: total.triangle_count,
        origin: summary.origin,
        min: total.min,
        max: total.max,
        grid: (!options.exact).then(|| Grid::of(total.min, total.max, grid_step(options, mean_edge))),
        layers: summary
            .layers
            .iter()
            .map(|kind| PagedLayer::of(&kind.empty_layer(), options.exact))
            .collect(),
        triangle_layers: summary
            .triangle_layers
            .iter()
            .map(|kind| PagedLayer::of(&kind.empty_layer(), true))
            .collect(),
        groups,
        appearance: appearance(source),
        georeference: summary.georeference.clone(),
        options: stored_options(options),
        ..Metadata::default()
    };
    metadata.declare_material_layer();
    metadata
}

/// The options that the result depends on.
fn stored_options(options: &BuildOptions) -> serde_json::Value {
    let mut value = serde_json::to_value(options).unwrap_or_default();
    if let Some(object) = value.as_object_mut() {
        object.retain(|name, _| !name.ends_with("_per_task"));
    }
    value
}

/// Distance of neighboring positions: a power of two.
fn grid_step(options: &BuildOptions, mean_edge: f64) -> f64 {
    let most = options.weld_distance.unwrap_or(mean_edge / 256.0);
    if most > 0.0 { most.log2().floor().exp2() } else { 0.0 }
}

/// Materials as JSON; images by address.
fn appearance(source: &dyn PieceSource) -> serde_json::Value {
    let appearance = &source.summary().appearance;
    let parsed = |json: &str| serde_json::from_str(json).unwrap_or(serde_json::Value::Null);
    let materials = appearance.materials.iter().map(|material| {
        let mut object = parsed(&material.gltf_json);
        if let serde_json::Value::Null = object {
            object = serde_json::json!({});
        }
        object["name"] = material.name.clone().into();
        object
    });
    let images =
        appearance.images.iter().map(|image| serde_json::json!({"name": image.name, "uri": image.uri}));
    let mut value = serde_json::json!({
        "materials": materials.collect::<Vec<_>>(),
        "images": images.collect::<Vec<_>>(),
        "textures": appearance.textures_json.iter().map(|t| parsed(t)).collect::<Vec<_>>(),
        "samplers": appearance.samplers_json.iter().map(|t| parsed(t)).collect::<Vec<_>>(),
    });
    if appearance.color_space == ColorSpace::Linear {
        value["color_space"] = "linear".into();
    }
    value
}
