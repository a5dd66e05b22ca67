//! Limits on simplifying a mesh, and their cost: seams, connected parts, and non-manifold edges.

use super::part_statistics::PartStatistics;
use super::seam_statistics::{SeamCause, SeamStatistics};
use super::step_statistics::StepStatistics;
use serde::Serialize;
use serde_json::{Map, Value};
use striata::mesh::{RefinableMesh, Semantic, Statistics, Welded};

use striata_command::output::{format_count, format_noun_count};

/// Parts with at most this many triangles are counted as tiny.
const TINY_PART: usize = 16;

/// Smallest fraction of split positions for which a mesh counts as consisting mostly of seams.
const MOSTLY_SPLIT: f64 = 0.9;

/// Smallest mean number of vertices per position for which a mesh counts as consisting mostly of seams.
const MANY_WEDGES: f64 = 3.0;

/// Seams, where attributes or materials split a position into several vertices.
#[derive(Serialize)]
pub(super) struct Seams {
    seam_edge_count: usize,
    inner_edge_count: usize,
    split_position_count: usize,
    largest_wedge_count: usize,
    wedges_per_position: f64,
    /// Split positions by layer, and by `material`.
    split_by: Map<String, Value>,
    #[serde(skip)]
    position_count: usize,
    /// Causes in words, such as `normals`, the most frequent one first.
    #[serde(skip)]
    causes: Vec<String>,
}

/// Connected parts, which share no position.
#[derive(Serialize)]
pub(super) struct Parts {
    count: usize,
    smallest_triangle_count: usize,
    median_triangle_count: usize,
    largest_triangle_count: usize,
    /// Parts of at most 16 triangles.
    tiny_count: usize,
    /// Smallest number of triangles of a level that shows all parts.
    least_triangle_count: usize,
}

/// Steps of a file that do more than remove triangles.
#[derive(Serialize)]
pub(super) struct StepSummary {
    crossing_count: usize,
    empty_count: usize,
    part_count: usize,
    vanished_part_count: usize,
    /// Split count of the coarsest level that has triangles of every part.
    all_parts_split_count: usize,
    all_parts_triangle_count: usize,
}

impl Seams {
    pub(super) fn of(welded: &Welded) -> Self {
        let found = SeamStatistics::of(welded);
        let mut causes = found.causes.clone();
        causes.sort_by_key(|&(_, count)| std::cmp::Reverse(count));
        let key = |cause: &SeamCause| match cause {
            SeamCause::Layer(semantic) => semantic.to_string(),
            _ => "material".to_owned(),
        };
        Self {
            seam_edge_count: found.seam_edge_count,
            inner_edge_count: found.inner_edge_count,
            split_position_count: found.split_position_count,
            largest_wedge_count: found.largest_wedge_count,
            wedges_per_position: found.wedge_count as f64 / found.position_count.max(1) as f64,
            split_by: found.causes.iter().map(|(cause, count)| (key(cause), (*count).into())).collect(),
            position_count: found.position_count,
            causes: causes.iter().map(|(cause, _)| name_of_cause(cause)).collect(),
        }
    }

    fn split_share(&self) -> f64 {
        self.split_position_count as f64 / self.position_count.max(1) as f64
    }

    /// Returns rows for the table.
    pub(super) fn rows(&self) -> Vec<(&'static str, String)> {
        let inner = format_count(self.inner_edge_count);
        let mut rows = vec![("seam edges", format!("{} of {inner}", format_count(self.seam_edge_count)))];
        if self.split_position_count > 0 {
            let [split, all] = [self.split_position_count, self.position_count].map(format_count);
            let causes = join_names(&self.causes);
            rows.push(("split positions", format!("{split} of {all}, by {causes}")));
            let per_position = self.wedges_per_position;
            let most = self.largest_wedge_count;
            rows.push(("vertices per position", format!("{per_position:.2}, at most {most}")));
        }
        rows
    }

    fn note(&self) -> Option<String> {
        if self.split_position_count == 0 {
            return None;
        }
        let by = join_names(&self.causes);
        if self.split_share() < MOSTLY_SPLIT || self.wedges_per_position < MANY_WEDGES {
            let share = percent(self.seam_edge_count as f64 / self.inner_edge_count.max(1) as f64);
            return Some(format!(
                "Seams ({by}) run along {share} of the edges. Simplification crosses them at a cost. With \
                 --keep-seams, seams are only collapsed along themselves, and some levels may be unreachable."
            ));
        }
        let is_flat = self.causes == [NORMALS];
        let shading = if is_flat { "the mesh is flat shaded" } else { "few triangles share a vertex" };
        Some(format!(
            "The {by} are split at {} of the positions: {shading}. Simplification crosses seams at a cost; \
             with --keep-seams, almost nothing could be removed.",
            percent(self.split_share())
        ))
    }
}

impl Parts {
    /// Measures the parts of a mesh; `None` if there are no triangles.
    pub(super) fn of(welded: &Welded) -> Option<Self> {
        let PartStatistics { triangle_counts, least_triangle_count, .. } = PartStatistics::of(welded);
        let (&smallest, &largest) = (triangle_counts.first()?, triangle_counts.last()?);
        Some(Self {
            count: triangle_counts.len(),
            smallest_triangle_count: smallest,
            median_triangle_count: triangle_counts[triangle_counts.len() / 2],
            largest_triangle_count: largest,
            tiny_count: triangle_counts.partition_point(|&count| count <= TINY_PART),
            least_triangle_count,
        })
    }

    /// Returns rows for the table.
    pub(super) fn rows(&self) -> Vec<(&'static str, String)> {
        if self.count == 1 {
            return Vec::new();
        }
        let counts = [self.smallest_triangle_count, self.median_triangle_count, self.largest_triangle_count];
        let [smallest, median, largest] = counts.map(format_count);
        let tiny = format_count(self.tiny_count);
        vec![
            ("triangles per part", format!("{smallest} to {largest}, median {median}")),
            ("tiny parts", format!("{tiny} with at most {TINY_PART} triangles")),
        ]
    }

    fn note(&self) -> Option<String> {
        let [count, least] = [self.count, self.least_triangle_count].map(format_count);
        (self.count > 1).then(|| {
            format!(
                "The mesh has {count} disconnected parts. A level with fewer than {least} triangles cannot \
                 show all of them, and a part disappears earlier if that costs less than simplifying others. \
                 With --keep-parts, no level has fewer than {least} triangles."
            )
        })
    }
}

impl StepSummary {
    pub(super) fn of(refinable: &RefinableMesh) -> Self {
        let found = StepStatistics::of(refinable);
        Self {
            crossing_count: found.crossing_count,
            empty_count: found.empty_count,
            part_count: found.part_count,
            vanished_part_count: found.vanished_part_count,
            all_parts_split_count: found.all_parts_split_count,
            all_parts_triangle_count: refinable.sequence.triangle_count_at(found.all_parts_split_count),
        }
    }

    /// Returns rows for the table.
    pub(super) fn rows(&self) -> Vec<(&'static str, String)> {
        let mut rows = vec![
            ("steps across seams", format_count(self.crossing_count)),
            ("steps that remove no triangle", format_count(self.empty_count)),
        ];
        if self.vanished_part_count > 0 {
            let left = format_count(self.part_count - self.vanished_part_count);
            let from = format_noun_count(self.all_parts_triangle_count, "triangle", "triangles");
            rows.push((
                "parts in the base mesh",
                format!("{left} of {}; all parts in levels of {from} or more", format_count(self.part_count)),
            ));
        }
        rows
    }
}

/// Returns sentences about what limits simplification.
pub(super) fn notes(
    seams: Option<&Seams>,
    parts: Option<&Parts>,
    statistics: Option<&Statistics>,
) -> Vec<String> {
    let mut notes: Vec<String> = Vec::new();
    notes.extend(seams.and_then(Seams::note));
    notes.extend(parts.and_then(Parts::note));
    let Some(statistics) = statistics else { return notes };
    if statistics.non_manifold_edge_count > 0 {
        let edges = format_noun_count(statistics.non_manifold_edge_count, "edge has", "edges have");
        notes.push(format!(
            "{edges} more than two triangles. Simplification removes them like others, but a stream keeps \
             their positions at every level."
        ));
    }
    if statistics.duplicate_triangle_count > 0 {
        let triangles =
            format_noun_count(statistics.duplicate_triangle_count, "triangle repeats", "triangles repeat");
        notes.push(format!("{triangles} the positions of another one. Each copy counts toward a target."));
    }
    if statistics.degenerate_triangle_count > 0 {
        let triangles =
            format_noun_count(statistics.degenerate_triangle_count, "triangle has", "triangles have");
        notes.push(format!(
            "{triangles} no area. Those with two corners at one position are removed before simplification."
        ));
    }
    notes
}

const NORMALS: &str = "normals";

fn name_of_cause(cause: &SeamCause) -> String {
    match cause {
        SeamCause::Layer(Semantic::Normal) => NORMALS.to_owned(),
        SeamCause::Layer(Semantic::Tangent) => "tangents".to_owned(),
        SeamCause::Layer(Semantic::TexCoord(_)) => "UVs".to_owned(),
        SeamCause::Layer(Semantic::Color(_)) => "colors".to_owned(),
        SeamCause::Layer(other) => other.to_string(),
        _ => "materials".to_owned(),
    }
}

/// Joins names: `normals, UVs and materials`.
fn join_names(names: &[String]) -> String {
    match names {
        [all @ .., before, last] if !all.is_empty() => format!("{}, {before} and {last}", all.join(", ")),
        _ => names.join(" and "),
    }
}

/// Formats a fraction as a percentage; one greater than 0 is never shown as 0.
fn percent(share: f64) -> String {
    match 100.0 * share {
        percent if percent < 1.0 => "less than 1 %".to_owned(),
        percent => format!("{percent:.0} %"),
    }
}
