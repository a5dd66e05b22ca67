//! Figures that the papers published for their meshes, compared with those measured here.
//!
//! Meshes are recognized by their number of triangles. Published figures are constants, tagged with the
//! table they come from. Ours are from this run: in the paper's accounting as far as it is known, and as
//! stored. Published times are from other machines; they show relative speeds, not absolute ones.

use serde::Serialize;

use super::models::{ModelRow, ModelsReport};
use super::page::{PageBlock, PageSection};
use crate::pace::Pace;
use striata_command::output::format_count;

/// Explanation of the table.
pub(super) const READING: &str = "theirs as published, ours of this run; MB = 10^6 bytes, positions included";

/// A published figure and ours.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub(super) struct PaperRow {
    /// The paper and table of the figure.
    source: &'static str,
    /// The measured quantity.
    what: &'static str,
    unit: &'static str,
    theirs: f64,
    /// Ours in the paper's accounting; null if the model was not measured.
    ours: Option<f64>,
    /// Ours as stored, if that differs.
    ours_as_stored: Option<f64>,
    /// The model or data that ours refers to.
    of: &'static str,
}

/// A published figure.
struct PublishedFigure {
    source: &'static str,
    what: &'static str,
    theirs: f64,
    figure: FigureKind,
}

/// The kind of a published figure.
#[derive(Clone, Copy)]
enum FigureKind {
    Vertices,
    Triangles,
    Strips,
    PlainMegabytes,
    /// Memory of one of our models.
    Megabytes(&'static str),
    /// Like `Megabytes`, but with 2 bytes per integer.
    ShortMegabytes(&'static str),
    Ratio(&'static str),
    RenderMillis(&'static str),
    BuildSecs(&'static str),
}

const fn published(
    source: &'static str,
    what: &'static str,
    theirs: f64,
    figure: FigureKind,
) -> PublishedFigure {
    PublishedFigure { source, what, theirs, figure }
}

const BRR02_1: &str = "[BRR02] table 1";
const BRR02_2: &str = "[BRR02] table 2";
const RCRG06_1: &str = "[RCRG06] table 1";
const RCRG06_2: &str = "[RCRG06] table 2";

/// Names of our models for those of the papers.
const MTS: &str = "mts-graph";
const PM: &str = "progressive-meshes-hoppe";
const SKIP_STRIPS: &str = "skip-strips";
const ORIGINAL: &str = "lodstrips-original";
const EFFICIENT: &str = "lodstrips-published";

/// 5,804 triangles.
const COW: [PublishedFigure; 8] = [
    published(BRR02_1, "vertices", 2904.0, FigureKind::Vertices),
    published(BRR02_1, "triangles", 5804.0, FigureKind::Triangles),
    published(BRR02_1, "strips", 136.0, FigureKind::Strips),
    published(BRR02_2, "MTS, storage", 0.286, FigureKind::ShortMegabytes(MTS)),
    published(BRR02_2, "PM, storage", 0.256, FigureKind::ShortMegabytes(PM)),
    published(BRR02_2, "MTS, construction", 31.0, FigureKind::BuildSecs(MTS)),
    published(RCRG06_2, "vertices and strips, storage", 0.13, FigureKind::PlainMegabytes),
    published(RCRG06_2, "efficient LodStrips, storage", 0.31, FigureKind::Megabytes(EFFICIENT)),
];

/// 30,624 triangles.
const SPHERE: [PublishedFigure; 6] = [
    published(BRR02_1, "vertices", 15_314.0, FigureKind::Vertices),
    published(BRR02_1, "triangles", 30_624.0, FigureKind::Triangles),
    published(BRR02_1, "strips", 173.0, FigureKind::Strips),
    published(BRR02_2, "MTS, storage", 2.145, FigureKind::ShortMegabytes(MTS)),
    published(BRR02_2, "PM, storage", 1.318, FigureKind::ShortMegabytes(PM)),
    published(BRR02_2, "MTS, construction", 5804.0, FigureKind::BuildSecs(MTS)),
];

/// 69,451 triangles.
const BUNNY: [PublishedFigure; 19] = [
    published(BRR02_1, "vertices", 34_834.0, FigureKind::Vertices),
    published(BRR02_1, "triangles", 69_451.0, FigureKind::Triangles),
    published(BRR02_1, "strips", 1229.0, FigureKind::Strips),
    published(BRR02_2, "MTS, storage", 5.301, FigureKind::ShortMegabytes(MTS)),
    published(BRR02_2, "PM, storage", 2.993, FigureKind::ShortMegabytes(PM)),
    published(BRR02_2, "MTS, construction", 11_946.0, FigureKind::BuildSecs(MTS)),
    published(RCRG06_1, "vertices and strips, storage", 1.54, FigureKind::PlainMegabytes),
    published(RCRG06_1, "Skip Strips, storage", 4.36, FigureKind::Megabytes(SKIP_STRIPS)),
    published(RCRG06_1, "Skip Strips, ratio", 2.83, FigureKind::Ratio(SKIP_STRIPS)),
    published(RCRG06_1, "Skip Strips, rendering", 3.56, FigureKind::RenderMillis(SKIP_STRIPS)),
    published(RCRG06_1, "MTS, storage", 7.55, FigureKind::Megabytes(MTS)),
    published(RCRG06_1, "MTS, ratio", 4.90, FigureKind::Ratio(MTS)),
    published(RCRG06_1, "MTS, rendering", 4.37, FigureKind::RenderMillis(MTS)),
    published(RCRG06_1, "LodStrips, storage", 4.30, FigureKind::Megabytes(ORIGINAL)),
    published(RCRG06_1, "LodStrips, ratio", 2.79, FigureKind::Ratio(ORIGINAL)),
    published(RCRG06_1, "LodStrips, rendering", 2.43, FigureKind::RenderMillis(ORIGINAL)),
    published(RCRG06_1, "efficient LodStrips, storage", 3.20, FigureKind::Megabytes(EFFICIENT)),
    published(RCRG06_1, "efficient LodStrips, ratio", 2.08, FigureKind::Ratio(EFFICIENT)),
    published(RCRG06_1, "efficient LodStrips, rendering", 2.07, FigureKind::RenderMillis(EFFICIENT)),
];

/// Memory of fans in \[Cor01\] in 10^6 bytes, for a mesh with this number of triangles; `None` if it was
/// not measured.
pub(super) fn cor01_megabytes(triangle_count: usize) -> Option<f64> {
    const MESHES: [(usize, f64); 6] =
        [(268_686, 11.15), (151_558, 6.35), (134_074, 5.61), (96_966, 4.03), (69_451, 2.89), (5_651, 0.235)];
    MESHES.iter().find(|&&(triangles, _)| triangles == triangle_count).map(|&(_, megabytes)| megabytes)
}

/// Memory of patterns and the Multi-Triangulation in \[KG98\], sections 3.2 and 3.3: bytes per vertex,
/// without positions.
pub(super) const KG98_BYTES_PER_VERTEX: [u32; 2] = [26, 160];
/// Bits per fragment in \[KG98\], and the number of overlaps per fragment that this assumes.
pub(super) const KG98_FRAGMENT_BITS: u32 = 206;
pub(super) const KG98_OVERLAPS: f64 = 2.5;
/// Bits per fragment in \[KG98\] in the form for transmission, section 3.1.
pub(super) const KG98_SEQUENTIAL_BITS: u32 = 44;

/// The figures published for a mesh with this number of triangles.
fn published_about(triangle_count: usize) -> &'static [PublishedFigure] {
    match triangle_count {
        5_804 => &COW,
        30_624 => &SPHERE,
        69_451 => &BUNNY,
        _ => &[],
    }
}

/// Compares the published figures of a mesh with ours; empty if no paper measured it.
pub(super) fn compare(report: &ModelsReport) -> Vec<PaperRow> {
    published_about(report.basis.triangle_count).iter().map(|figure| figure.compare(report)).collect()
}

impl PublishedFigure {
    fn compare(&self, report: &ModelsReport) -> PaperRow {
        let basis = &report.basis;
        let of_model = |name: &str, value: &dyn Fn(&ModelRow) -> f64| {
            report.rows.iter().find(|row| row.name == name).map(value)
        };
        let megabytes = |bytes: usize| bytes as f64 / 1e6;
        let (unit, of, ours, ours_as_stored) = match self.figure {
            FigureKind::Vertices => ("", "the mesh", Some(basis.vertex_count as f64), None),
            FigureKind::Triangles => ("", "the mesh", Some(basis.triangle_count as f64), None),
            FigureKind::Strips => ("", "the strips", Some(basis.strips.strip_count as f64), None),
            FigureKind::PlainMegabytes => ("MB", "the strips", Some(megabytes(basis.plain_bytes)), None),
            FigureKind::Megabytes(name) => (
                "MB",
                name,
                of_model(name, &|row| megabytes(row.paper_bytes)),
                of_model(name, &|row| megabytes(row.total_bytes)),
            ),
            FigureKind::ShortMegabytes(name) => (
                "MB",
                name,
                of_model(name, &|row| megabytes(row.short_paper_bytes)),
                of_model(name, &|row| megabytes(row.total_bytes)),
            ),
            FigureKind::Ratio(name) => (
                "x plain",
                name,
                of_model(name, &|row| row.paper_ratio_to_plain),
                of_model(name, &|row| row.ratio_to_plain),
            ),
            FigureKind::RenderMillis(name) => {
                let millis = |row: &ModelRow| row.walk(Pace::Linear).extract_and_send_secs * 1e3;
                ("ms", name, of_model(name, &millis), None)
            }
            FigureKind::BuildSecs(name) => {
                let before = basis.sequence_secs + basis.strips.stripify_secs;
                ("s", name, of_model(name, &|row| before + row.build_secs), None)
            }
        };
        let Self { source, what, theirs, .. } = *self;
        PaperRow { source, what, unit, theirs, ours, ours_as_stored, of }
    }
}

/// Header and rows of the table.
pub(super) fn table(rows: &[PaperRow]) -> Vec<Vec<String>> {
    let head = ["what", "published in", "unit", "theirs", "ours, their count", "ours, as stored", "ours is"];
    let mut table = vec![head.map(str::to_owned).to_vec()];
    for row in rows {
        let or_dash =
            |value: Option<f64>| value.map_or_else(|| "-".to_owned(), |value| digits(value, row.unit));
        table.push(vec![
            row.what.to_owned(),
            row.source.to_owned(),
            row.unit.to_owned(),
            digits(row.theirs, row.unit),
            or_dash(row.ours),
            or_dash(row.ours_as_stored),
            row.of.to_owned(),
        ]);
    }
    table
}

fn digits(value: f64, unit: &str) -> String {
    match unit {
        "" => format_count(value.round() as usize),
        "s" if value >= 100.0 => format_count(value.round() as usize),
        "ms" | "MB" => format!("{value:.3}"),
        _ => format!("{value:.2}"),
    }
}

/// The page section with the same table.
pub(super) fn section(rows: &[PaperRow]) -> PageSection {
    PageSection {
        title: "Compared with the papers".to_owned(),
        intro: "Figures that the papers published about this mesh, and those that this run measured on a mesh \
                with as many triangles. MB are 10^6 bytes, including positions at 12 bytes per vertex. Ours in \
                their count takes 4 bytes for every number, index and pointer for [RCRG06]; for [BRR02] \
                2 for an integer and 4 for a pointer or a long one. The vertices and strips of \
                [RCRG06] take 44 bytes per vertex, twice the size of positions and strips here: compare \
                megabytes, not ratios. Construction counts the sequence, the strips and the model. \
                Rendering is theirs in OpenGL's immediate mode on a graphics card of 2006, drawing \
                included; ours is extraction and sending to a buffer, which is the CPU's part, over the \
                linear walk."
            .to_owned(),
        blocks: vec![PageBlock::WideTable(table(rows))],
    }
}
