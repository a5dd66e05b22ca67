//! The report of `render`.

use std::time::Instant;

use serde::Serialize;
use striata::strip::StripSet;

use super::figure::Figure;
use super::layout::Layout;
use super::source::PictureSource;
use crate::args::RenderArgs;
use striata_command::level::shortfall_note;
use striata_command::output::{format_duration, format_length, format_noun_count};
use striata_command::save::georeference_of;
use striata_viewer::PictureRenderer;

/// Report on a picture.
#[derive(Serialize)]
pub(super) struct RenderReport {
    path: String,
    width: u32,
    height: u32,
    adapter: String,
    /// Triangles of all panels together.
    triangle_count: usize,
    /// Time to draw one frame of all panels, after uploading, seconds.
    frame_secs: f64,
    levels: Vec<Level>,
    #[serde(skip_serializing_if = "Option::is_none")]
    heat: Option<HeatReport>,
    /// The place of a terrain on the Earth.
    #[serde(skip_serializing_if = "Option::is_none")]
    georeference: Option<serde_json::Value>,
    secs: f64,
}

#[derive(Serialize)]
struct Level {
    model: &'static str,
    split_count: Option<usize>,
    vertex_count: usize,
    triangle_count: usize,
    error: f32,
    error_is_guaranteed: bool,
    #[serde(skip_serializing_if = "Option::is_none")]
    strip_count: Option<usize>,
    /// For views: the pixel tolerance.
    #[serde(skip_serializing_if = "Option::is_none")]
    pixels: Option<f64>,
    /// How the level misses its target; null if it does not.
    shortfall: Option<String>,
    /// Largest distance from a vertex of the original to the level.
    #[serde(skip_serializing_if = "Option::is_none")]
    distance_max: Option<f64>,
}

#[derive(Serialize)]
struct HeatReport {
    /// Distance at the end of the color scale, mesh units.
    top: f64,
    /// Distance at the end of the color scale, as a fraction of the diagonal.
    top_of_diagonal: f64,
}

/// The renderer that drew the picture, and the times that it took.
pub(super) struct DrawingReport<'a> {
    pub artist: &'a PictureRenderer,
    pub frame_secs: f64,
    pub started: Instant,
}

impl RenderReport {
    pub(super) fn new(
        args: &RenderArgs,
        source: &PictureSource<'_>,
        figures: &[Figure],
        layout: &Layout<'_>,
        DrawingReport { artist, frame_secs, started }: DrawingReport<'_>,
    ) -> Self {
        let [width, height] = args.size.0;
        let levels: Vec<Level> = figures
            .iter()
            .enumerate()
            .map(|(index, figure)| Level {
                model: figure.model,
                split_count: figure.split_count,
                vertex_count: figure.vertex_count,
                triangle_count: figure.mesh.triangle_count(),
                error: figure.error,
                error_is_guaranteed: figure.error_is_guaranteed,
                strip_count: figure.strips.as_ref().map(StripSet::strip_count),
                pixels: figure.pixels,
                shortfall: figure.shortfall.clone(),
                distance_max: layout.heats.get(index).map(|heat| heat.max),
            })
            .collect();
        let diagonal = source.diagonal();
        let of_panel = |level: &Level| {
            if args.heat { source.mesh().triangle_count() } else { level.triangle_count }
        };
        Self {
            path: args.output.display().to_string(),
            width,
            height,
            adapter: artist.name(),
            triangle_count: args.colors.len() * levels.iter().map(of_panel).sum::<usize>(),
            frame_secs,
            heat: args.heat.then(|| HeatReport {
                top: layout.heat_top,
                top_of_diagonal: if diagonal > 0.0 { layout.heat_top / diagonal } else { 0.0 },
            }),
            levels,
            georeference: georeference_of(source.mesh()),
            secs: started.elapsed().as_secs_f64(),
        }
    }

    pub(super) fn to_text(&self) -> String {
        let heat = self.heat.as_ref().map_or_else(String::new, |heat| {
            let share = 100.0 * heat.top_of_diagonal;
            format!(", colors up to {} ({share:.4} % of the diagonal)", format_length(heat.top))
        });
        let shortfalls = self.levels.iter().filter_map(|level| level.shortfall.as_ref());
        let shortfalls: String = shortfalls.map(|text| format!("\n{}", shortfall_note(None, text))).collect();
        format!(
            "{}: {} x {} pixels, {}{heat}; one frame took {} on {}, {} in total{shortfalls}",
            self.path,
            self.width,
            self.height,
            format_noun_count(self.triangle_count, "triangle", "triangles"),
            format_duration(self.frame_secs),
            self.adapter,
            format_duration(self.secs)
        )
    }
}
