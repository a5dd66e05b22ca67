//! Distance to the mesh after a number of bytes: our streams, levels sent one after another, and the files
//! of other coders.
//!
//! Positions only, on the same grid for all: 2^bits - 1 steps along the longest side of the bounds.
//! Distances are sampled in both directions and reported as shares of the diagonal.

mod coded;
mod discrete;
mod distance_meter;
mod draco;
#[cfg(feature = "peers")]
mod meshoptimizer;
mod streams;

use serde::Serialize;
use striata::mesh::IndexedMesh;
use striata_stream::Effort;

use self::coded::{CodedMesh, Coder, RUNS, stream_name};
use self::distance_meter::{DistanceMeter, RateRow};
use self::draco::Draco;
use self::streams::Streams;
use super::page::{PageBlock, PageSection};
use super::plot::{Chart, PlotSeries};
use super::scale::Scale;
use crate::args::RateArgs;
use striata_command::failure::Failure;
use striata_command::output::{Bar, format_count, format_duration};
use striata_command::stream::effort_name;

/// Bits per coordinate at which single files are compared.
const FILE_BITS: [u32; 5] = [8, 10, 12, 14, 16];
/// Bits per coordinate at which sizes are compared.
const SIZE_BITS: [u32; 2] = [12, 14];
/// Sizes, and distances after a number of bytes, of one mesh.
#[derive(Serialize)]
pub(super) struct RateReport {
    /// Bits per coordinate in streams and levels.
    rate_bits: u32,
    rate: Vec<RateRow>,
    sizes: Vec<SizeRow>,
}

/// Size and times of a whole file.
#[derive(Clone, Debug, Serialize)]
struct SizeRow {
    name: String,
    bits: u32,
    bytes: usize,
    bits_per_vertex: f64,
    /// Present if Draco is installed.
    #[serde(skip_serializing_if = "Option::is_none")]
    ratio_to_draco: Option<f64>,
    encode_secs: f64,
    decode_secs: f64,
    triangles_per_sec: f64,
}

/// Measures all coders on one mesh.
///
/// # Errors
/// If the mesh is inconsistent or a coder fails.
pub(super) fn measure(
    mesh: &IndexedMesh,
    args: &RateArgs,
    bar: &mut Bar,
    say: &dyn Fn(&str),
) -> Result<RateReport, Failure> {
    let positions_only = IndexedMesh {
        positions: mesh.positions.clone(),
        triangles: mesh.triangles.clone(),
        ..IndexedMesh::default()
    };
    say("collapses in batches");
    let streams = Streams::build(&positions_only, bar)?;
    let meter = DistanceMeter { reference: streams.mesh() };
    let draco = Draco::find()?;
    if draco.is_none() {
        say("draco_encoder and draco_decoder are not on the PATH: left out");
    }
    let mut peers: Vec<(String, Coder<'_>)> = Vec::new();
    if let Some(draco) = &draco {
        peers.push((draco::NAME.to_owned(), Box::new(|mesh, bits| draco.code(mesh, bits))));
    }
    #[cfg(feature = "peers")]
    peers.push((meshoptimizer::NAME.to_owned(), Box::new(meshoptimizer::code)));
    let mut rate = Vec::new();
    let mut sizes = Vec::new();
    for effort in args.efforts() {
        say(&format!("streams, {} effort", effort_name(effort)));
        if !args.sizes_only {
            rate.extend(streams.prefixes(args.bits, effort, &meter)?);
        }
        for bits in SIZE_BITS {
            let coded = streams.code(bits, effort)?;
            sizes.push(SizeRow::new(stream_name(effort), bits, &coded));
        }
    }
    for (name, code) in &peers {
        say(name);
        for bits in FILE_BITS.into_iter().filter(|bits| !args.sizes_only || SIZE_BITS.contains(bits)) {
            let coded = code(streams.mesh(), bits)?;
            if !args.sizes_only {
                rate.extend(meter.row(name, coded.bytes, &coded.mesh));
            }
            if SIZE_BITS.contains(&bits) {
                sizes.push(SizeRow::new(name.clone(), bits, &coded));
            }
        }
    }
    if args.sizes_only {
        compute_ratios(&mut sizes);
        return Ok(RateReport { rate_bits: args.bits, rate, sizes });
    }
    say("levels one after another");
    peers.push((stream_name(Effort::Compact), Box::new(streams::code_level)));
    rate.extend(discrete::measure(&positions_only, args.bits, &peers, &meter, bar)?);
    compute_ratios(&mut sizes);
    Ok(RateReport { rate_bits: args.bits, rate, sizes })
}

/// Computes the ratios of sizes to those of Draco.
fn compute_ratios(sizes: &mut [SizeRow]) {
    let theirs: Vec<(u32, usize)> =
        sizes.iter().filter(|row| row.name == draco::NAME).map(|row| (row.bits, row.bytes)).collect();
    for row in sizes {
        let base = theirs.iter().find(|(bits, _)| *bits == row.bits);
        row.ratio_to_draco = base.map(|&(_, bytes)| row.bytes as f64 / bytes as f64);
    }
}

impl SizeRow {
    fn new(name: String, bits: u32, coded: &CodedMesh) -> Self {
        Self {
            name,
            bits,
            bytes: coded.bytes,
            bits_per_vertex: coded.bytes as f64 * 8.0 / coded.mesh.vertex_count().max(1) as f64,
            ratio_to_draco: None,
            encode_secs: coded.encode_secs,
            decode_secs: coded.decode_secs,
            triangles_per_sec: coded.mesh.triangle_count() as f64 / coded.decode_secs.max(1e-6),
        }
    }
}

/// Both tables as text.
pub(super) fn to_text(report: &RateReport, text_of: impl Fn(Vec<Vec<String>>) -> String) -> String {
    if report.rate.is_empty() {
        return format!("Whole files, positions only\n{}", text_of(size_table(report)));
    }
    format!(
        "Whole files, positions only\n{}\n\
         Distance after a number of bytes, {} bits per coordinate unless noted\n{}",
        text_of(size_table(report)),
        report.rate_bits,
        text_of(rate_table(report))
    )
}

fn size_table(report: &RateReport) -> Vec<Vec<String>> {
    let head =
        ["file", "bits", "bytes", "bits per vertex", "to Draco", "encoding", "decoding", "M triangles/s"];
    let rows = report.sizes.iter().map(|row| {
        vec![
            row.name.clone(),
            row.bits.to_string(),
            format_count(row.bytes),
            format!("{:.2}", row.bits_per_vertex),
            row.ratio_to_draco.map_or_else(|| "-".to_owned(), |ratio| format!("{ratio:.3}")),
            format_duration(row.encode_secs),
            format_duration(row.decode_secs),
            format!("{:.2}", row.triangles_per_sec / 1e6),
        ]
    });
    with_head(&head, rows)
}

fn rate_table(report: &RateReport) -> Vec<Vec<String>> {
    let rows = report.rate.iter().map(|row| {
        let counts = [format_count(row.bytes), format_count(row.triangle_count)];
        let distances = [row.rms, row.max].map(|percent| format!("{percent:.5}"));
        [row.name.clone()].into_iter().chain(counts).chain(distances).collect()
    });
    with_head(&["way", "bytes", "triangles", "RMS, %", "max, %"], rows)
}

fn with_head(head: &[&str], rows: impl Iterator<Item = Vec<String>>) -> Vec<Vec<String>> {
    let head = head.iter().map(|&cell| cell.to_owned()).collect();
    std::iter::once(head).chain(rows).collect()
}

/// The page section with charts and tables.
///
/// # Errors
/// If a chart cannot be drawn.
pub(super) fn section(report: &RateReport) -> Result<PageSection, Failure> {
    if report.rate.is_empty() {
        return Ok(PageSection {
            title: "Sizes of whole files".to_owned(),
            intro: format!(
                "Positions only. Decoding times are the fastest of up to {RUNS} runs on one core."
            ),
            blocks: vec![PageBlock::WideTable(size_table(report))],
        });
    }
    Ok(PageSection {
        title: "Distance after a number of bytes".to_owned(),
        intro: format!(
            "Distance between the mesh and what can be shown after a number of bytes, positions only, as \
             a share of the diagonal, sampled in both directions. Streams and levels have {} bits per \
             coordinate; levels halve their triangles, are coded separately and arrive from coarse to \
             fine. Files of other coders are usable after their last byte: a point for each of {} bits \
             per coordinate. Decoding times are the fastest of up to {RUNS} runs on one core; encoding \
             times of streams include simplification.",
            report.rate_bits,
            FILE_BITS.map(|bits| bits.to_string()).join(", ")
        ),
        blocks: vec![
            PageBlock::chart(
                &chart(report, "RMS, % of the diagonal", |row| row.rms),
                "RMS distance by bytes",
            )?,
            PageBlock::chart(
                &chart(report, "largest, % of the diagonal", |row| row.max),
                "Largest distance by bytes",
            )?,
            PageBlock::WideTable(size_table(report)),
            PageBlock::WideTable(rate_table(report)),
        ],
    })
}

fn chart(report: &RateReport, y_title: &'static str, distance: fn(&RateRow) -> f64) -> Chart {
    // Exact results have no place on a logarithmic scale, so small distances are clamped.
    let point = |row: &RateRow| (row.bytes as f64, distance(row).max(1e-5));
    let mut series: Vec<PlotSeries> = Vec::new();
    for row in &report.rate {
        match series.iter_mut().find(|series| series.name == row.name) {
            Some(series) => series.points.push(point(row)),
            None => {
                let (name, points) = (row.name.clone(), vec![point(row)]);
                series.push(PlotSeries { name, points, spread: Vec::new() });
            }
        }
    }
    Chart {
        x_title: "bytes",
        y_title,
        x: Scale::log(report.rate.iter().map(|row| point(row).0)),
        y: Scale::log(report.rate.iter().map(|row| point(row).1)),
        series,
    }
}
