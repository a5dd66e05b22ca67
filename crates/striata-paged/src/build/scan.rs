//! The first pass over the input: its bounds, and samples for the partition.

use std::sync::Mutex;

use striata::mesh::{ColorSpace, Image};
use striata::simplify::cells::Partition;
use striata::{Progress, ProgressFn};
use striata_io::pieces::{Piece, PieceSource};

use super::plan::Scanned;
use super::runner::in_parallel;
use super::weld::{WeldMap, border};
use super::{BuildOptions, PagedBuildError};
use crate::{Metadata, PagedGrid, PagedGroup, PagedImage, PagedLayer};

/// One triangle in this many is a sample for the partition.
const SAMPLE_STRIDE: usize = 32;

/// Largest number of edges of a piece that are measured.
const EDGES_PER_PIECE: usize = 512;

/// Bounds, number of triangles and samples of one piece.
#[derive(Default)]
struct PieceScan {
    min: [f32; 3],
    max: [f32; 3],
    triangle_count: u64,
    /// Lengths of some edges.
    edges: Vec<f32>,
    samples: Vec<[f32; 3]>,
    /// Positions that may be welded to others.
    border: Vec<[f32; 3]>,
}

/// Reads the whole input once.
pub(super) fn scan(
    source: &dyn PieceSource,
    options: &BuildOptions,
    threads: usize,
    progress: &mut ProgressFn<'_>,
) -> Result<Scanned, PagedBuildError> {
    let count = source.piece_count();
    let scans: Mutex<Vec<Option<PieceScan>>> = Mutex::new((0..count).map(|_| None).collect());
    let mut report = |done| Progress { phase: "read", done, total: count }.report(progress);
    in_parallel(count as usize, threads, &mut report, |index| {
        let piece = source.read_piece(index as u64)?;
        let border = if options.weld_distance.is_some() { border(&piece) } else { Vec::new() };
        let scan = PieceScan { border, ..scan_piece(&piece) };
        if let Ok(mut scans) = scans.lock() {
            scans[index] = Some(scan);
        }
        Ok(())
    })?;
    let scans: Vec<PieceScan> = scans.into_inner().into_iter().flatten().flatten().collect();
    let full = scans.iter().filter(|scan| scan.triangle_count > 0);
    let mut total = PieceScan { min: [f32::MAX; 3], max: [f32::MIN; 3], ..PieceScan::default() };
    for scan in full {
        total.edges.extend(&scan.edges);
        for axis in 0..3 {
            total.min[axis] = total.min[axis].min(scan.min[axis]);
            total.max[axis] = total.max[axis].max(scan.max[axis]);
        }
        total.triangle_count += scan.triangle_count;
    }
    if total.triangle_count == 0 {
        return Err(PagedBuildError::Empty { input: source.summary().name.clone() });
    }
    let weld = options.weld_distance.map(|distance| {
        WeldMap::of(scans.iter().flat_map(|scan| scan.border.iter().copied()).collect(), distance)
    });
    let samples: Vec<[f32; 3]> = scans.into_iter().flat_map(|scan| scan.samples).collect();
    let per_sample = total.triangle_count as f64 / samples.len().max(1) as f64;
    let mut partition = Partition::new(&samples, per_sample, options.cell);
    let base = options.base_triangle_count(total.triangle_count);
    if base > 0 {
        partition = partition.with_level_limit(level_limit(total.triangle_count, base));
    }
    let mut metadata = describe(source, options, &total);
    metadata.cell_counts = partition.levels().iter().map(|level| level.cell_count()).collect();
    let is_too_large = !options.exact && metadata.grid.is_none();
    let mut notes = Vec::new();
    if is_too_large {
        let note = "positions are kept bit for bit: the bounds are too large to round them";
        notes.push(note.to_owned());
    }
    let edge = median(&total.edges);
    if let Some(distance) = options.weld_distance.filter(|distance| 2.0 * distance > edge) {
        notes.push(format!(
            "the median edge is {edge:.3} long, so --weld-distance {distance} may also join vertices of one file, and \
             triangles vanish"
        ));
    }
    Ok(Scanned { metadata, partition, piece_count: count, notes, weld })
}

/// Number of levels before the base mesh. Every level but the last leaves a quarter of the triangles; only the
/// last one, which has a single cell, can stop at a given number of triangles.
fn level_limit(mut triangle_count: u64, base: u64) -> usize {
    let mut levels = 1;
    while triangle_count / 4 >= base {
        triangle_count /= 4;
        levels += 1;
    }
    levels
}

fn scan_piece(piece: &Piece) -> PieceScan {
    let mut scan = PieceScan { min: [f32::MAX; 3], max: [f32::MIN; 3], ..PieceScan::default() };
    let stride = piece.triangles.len().div_ceil(EDGES_PER_PIECE).max(1);
    for (index, corners) in piece.triangles.iter().enumerate() {
        let at = corners.map(|v| piece.positions[v as usize]);
        for (axis, &x) in at.iter().flat_map(|p| p.iter().enumerate()) {
            scan.min[axis] = scan.min[axis].min(x);
            scan.max[axis] = scan.max[axis].max(x);
        }
        if index % stride == 0 {
            let [from, to] = [at[index / stride % 3], at[(index / stride + 1) % 3]];
            let square: f64 = (0..3).map(|a| f64::from(from[a] - to[a]).powi(2)).sum();
            scan.edges.push(square.sqrt() as f32);
        }
        if index % SAMPLE_STRIDE == 0 {
            scan.samples.push(at[0]);
        }
    }
    scan.triangle_count = piece.triangles.len() as u64;
    scan
}

fn describe(source: &dyn PieceSource, options: &BuildOptions, total: &PieceScan) -> Metadata {
    let summary = source.summary();
    let groups: Vec<PagedGroup> = summary
        .groups
        .iter()
        .map(|group| PagedGroup { name: group.name.clone(), material: group.material })
        .collect();
    let mut metadata = Metadata {
        source: without_folder(&summary.name).to_owned(),
        triangle_count: total.triangle_count,
        origin: summary.origin,
        min: total.min,
        max: total.max,
        grid: grid_of(options, total),
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
        images: summary.appearance.images.iter().map(image).collect(),
        georeference: summary
            .georeference
            .clone()
            .or_else(|| serde_json::from_str(&summary.appearance.georeference).ok()),
        options: stored_options(options),
        ..Metadata::default()
    };
    metadata.declare_material_layer();
    metadata
}

/// A name without its folder, because the result must neither depend on the folder nor reveal it.
fn without_folder(name: &str) -> &str {
    name.rsplit(['/', '\\']).next().unwrap_or(name)
}

/// The options that the result depends on.
fn stored_options(options: &BuildOptions) -> serde_json::Value {
    let mut value = serde_json::to_value(options).unwrap_or_default();
    if let Some(object) = value.as_object_mut() {
        object.retain(|name, _| !name.ends_with("_per_task") && name != "strict");
    }
    value
}

/// Grid of the positions; `None` if they are stored exactly.
///
/// The median edge is at least 256 steps long, so a few large triangles or one stray vertex do not make the grid
/// coarser. An axis with other units, such as heights in meters above degrees, gets a step from its extent: `n`
/// triangles have about `sqrt(n)` positions along it.
fn grid_of(options: &BuildOptions, total: &PieceScan) -> Option<PagedGrid> {
    const STEPS_PER_EDGE: f64 = 256.0;
    const STEPS_PER_POSITION: f64 = 64.0;
    if options.exact {
        return None;
    }
    let floor = |most: f64| if most > 0.0 { most.log2().floor().exp2() } else { 0.0 };
    let edge = median(&total.edges) / STEPS_PER_EDGE;
    let step = std::array::from_fn(|axis| {
        let extent = f64::from(total.max[axis]) - f64::from(total.min[axis]);
        let along = extent / (STEPS_PER_POSITION * (total.triangle_count as f64).sqrt());
        floor(if along > 0.0 { edge.min(along) } else { edge })
    });
    PagedGrid::of(total.min, total.max, step)
}

/// The median of the lengths that are not zero; 0 if there are none.
fn median(lengths: &[f32]) -> f64 {
    let mut lengths: Vec<f32> = lengths.iter().copied().filter(|&length| length > 0.0).collect();
    let middle = lengths.len() / 2;
    if lengths.is_empty() {
        return 0.0;
    }
    f64::from(*lengths.select_nth_unstable_by(middle, f32::total_cmp).1)
}

/// Materials as JSON.
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
    let mut value = serde_json::json!({
        "materials": materials.collect::<Vec<_>>(),
        "textures": appearance.textures_json.iter().map(|t| parsed(t)).collect::<Vec<_>>(),
        "samplers": appearance.samplers_json.iter().map(|t| parsed(t)).collect::<Vec<_>>(),
    });
    if appearance.color_space == ColorSpace::Linear {
        value["color_space"] = "linear".into();
    }
    if !appearance.extensions_used.is_empty() {
        value["extensions"] = appearance.extensions_used.clone().into();
    }
    value
}

fn image(image: &Image) -> PagedImage {
    let Image { name, uri, mime_type, bytes } = image.clone();
    let (byte_count, crc) = (bytes.len() as u64, crc32fast::hash(&bytes));
    PagedImage { name, uri, mime_type, offset: 0, byte_count, crc, bytes }
}
