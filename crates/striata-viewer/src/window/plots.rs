//! Plots of recent frames: time, triangles, uploads.

use std::collections::VecDeque;

use egui::{Color32, RichText, Ui};
use egui_plot::{Line, Plot, PlotPoints};

use striata_command::output::{format_bytes, format_count, format_duration};

/// Number of frames kept.
const MAX_SAMPLES: usize = 240;

/// Measurements of one frame.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Sample {
    /// From reading the input to submitting the last GPU command.
    pub frame_secs: f64,
    /// Part of it spent changing the level.
    pub level_secs: f64,
    pub triangle_count: usize,
    pub uploaded_bytes: u64,
}

/// Measurements of the most recent frames in which the picture changed.
#[derive(Clone, Debug, Default)]
pub(super) struct PlotHistory {
    samples: VecDeque<Sample>,
    /// Total number of frames recorded.
    frame_count: u64,
}

impl PlotHistory {
    /// Adds a frame, dropping the oldest if necessary.
    pub(super) fn push(&mut self, sample: Sample) {
        if self.samples.len() == MAX_SAMPLES {
            self.samples.pop_front();
        }
        self.samples.push_back(sample);
        self.frame_count += 1;
    }

    /// Removes all frames.
    pub(super) fn clear(&mut self) {
        *self = Self::default();
    }

    /// The most recent frame.
    pub(super) fn last(&self) -> Option<&Sample> {
        self.samples.back()
    }

    fn points(&self, value: impl Fn(&Sample) -> f64) -> PlotPoints<'static> {
        let first = self.frame_count - self.samples.len() as u64;
        (first..).zip(&self.samples).map(|(frame, sample)| [frame as f64, value(sample)]).collect()
    }
}

/// Shows the three plots one below the other.
pub(super) fn show(ui: &mut Ui, history: &PlotHistory) {
    let last = history.last().copied().unwrap_or_default();
    let frame = format!("{} · level {}", format_duration(last.frame_secs), format_duration(last.level_secs));
    let blue = Color32::from_rgb(86, 156, 255);
    let orange = Color32::from_rgb(240, 146, 60);
    let green = Color32::from_rgb(70, 176, 110);
    let frame_lines = vec![
        Line::new("frame", history.points(|s| 1e3 * s.frame_secs)).color(blue),
        Line::new("level", history.points(|s| 1e3 * s.level_secs)).color(orange),
    ];
    plot(ui, "Frame time, ms", &frame, frame_lines);
    let triangles = vec![Line::new("triangles", history.points(|s| s.triangle_count as f64)).color(green)];
    plot(ui, "Triangles", &format_count(last.triangle_count), triangles);
    let bytes = vec![Line::new("bytes", history.points(|s| s.uploaded_bytes as f64)).color(orange)];
    plot(ui, "Uploaded", &format_bytes(last.uploaded_bytes as usize), bytes);
}

fn plot(ui: &mut Ui, name: &'static str, value: &str, lines: Vec<Line<'static>>) {
    ui.horizontal(|ui| {
        ui.label(RichText::new(name).weak().small());
        ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
            ui.label(RichText::new(value).small().monospace());
        });
    });
    Plot::new(name)
        .height(44.0)
        .show_axes([false, false])
        .show_grid([false, true])
        .allow_drag(false)
        .allow_zoom(false)
        .allow_scroll(false)
        .allow_boxed_zoom(false)
        .include_y(0.0)
        .show_x(false)
        .show(ui, |plot| lines.into_iter().for_each(|line| plot.line(line)));
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_recent_frames_are_kept_with_their_numbers() {
        let mut history = PlotHistory::default();
        for triangle_count in 0..MAX_SAMPLES + 10 {
            history.push(Sample { triangle_count, ..Default::default() });
        }
        assert_eq!(history.samples.len(), MAX_SAMPLES);
        assert_eq!(history.last().map(|s| s.triangle_count), Some(MAX_SAMPLES + 9));
        let points = history.points(|sample| sample.triangle_count as f64);
        assert!(points.points().iter().all(|point| point.x == point.y), "frame n has n triangles");
        history.clear();
        assert!(history.last().is_none());
    }
}
