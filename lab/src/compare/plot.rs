//! Line charts as SVG inside a page: lines with a spread, and points with names, in the page's colors.
//!
//! The SVG contains the colors of the light theme, so that a chart is readable on its own. [`style`]
//! generates the CSS rules by which the page maps them to its variables.

use std::error::Error;
use std::fmt::Write as _;

use plotters::coord::Shift;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

use super::labels::{Anchor, Labels, Pixel, PixelRect};
use super::scale::Scale;
use striata_command::failure::Failure;

/// Size of a chart as drawn, in pixels; the page scales it.
pub(super) const SIZE: (u32, u32) = (960, 560);
/// Font family.
pub(crate) const FONT: &str = "sans-serif";
/// Font size in pixels.
pub(super) const FONT_PX: u32 = 22;

/// Margin around a chart, and margin on the right if series names are listed there.
const MARGIN_PX: u32 = 16;
const NAMES_PX: u32 = 236;
/// Margin on the right otherwise: half of the last tick's label.
const TICK_PX: u32 = 44;

/// Color of names and titles, with the page's variable for it.
pub(crate) const INK: (RGBColor, &str) = (RGBColor(0x23, 0x20, 0x1c), "ink");
/// Color of numbers on axes.
pub(crate) const SOFT: (RGBColor, &str) = (RGBColor(0x6d, 0x66, 0x5c), "soft");
/// Color of grid lines.
pub(crate) const RULE: (RGBColor, &str) = (RGBColor(0xdd, 0xd7, 0xcd), "rule");

/// Colors of series in the light and the dark theme.
pub(crate) const SERIES: [(RGBColor, &str); 17] = [
    (RGBColor(0x0b, 0x6e, 0x99), "#5bb8e0"),
    (RGBColor(0xc2, 0x57, 0x1a), "#f0955a"),
    (RGBColor(0x2e, 0x8b, 0x57), "#6fcf97"),
    (RGBColor(0x8e, 0x44, 0xad), "#c58ae0"),
    (RGBColor(0xa8, 0x7d, 0x0b), "#e0b84c"),
    (RGBColor(0xc0, 0x39, 0x2b), "#f07c6e"),
    (RGBColor(0x16, 0x80, 0x7a), "#52c7be"),
    (RGBColor(0x1f, 0x3a, 0x93), "#8ea6f5"),
    (RGBColor(0xb0, 0x3a, 0x78), "#ee86bb"),
    (RGBColor(0x5d, 0x6d, 0x7e), "#b3bcc6"),
    (RGBColor(0x6a, 0x7d, 0x00), "#b5cc4a"),
    (RGBColor(0x7a, 0x4a, 0x24), "#cf9f78"),
    (RGBColor(0x6a, 0x5a, 0xcd), "#b0a4ff"),
    (RGBColor(0x00, 0x72, 0x4e), "#4fd0a0"),
    (RGBColor(0x9a, 0x1f, 0x4b), "#f57fa4"),
    (RGBColor(0x3d, 0x4f, 0x2f), "#a9bf95"),
    (RGBColor(0x2f, 0x6f, 0xd0), "#86b4ff"),
];

/// Named points, connected by a line if there are several.
#[derive(Clone, Debug)]
pub(super) struct PlotSeries {
    /// Name of the series.
    pub name: String,
    /// Its points from left to right.
    pub points: Vec<(f64, f64)>,
    /// Minimum and maximum of the values that each point stands for; empty if there is no spread.
    pub spread: Vec<(f64, f64)>,
}

impl PlotSeries {
    /// A series with more points is drawn as a line without marks.
    const MAX_MARKS: usize = 30;

    fn has_marks(&self) -> bool {
        self.points.len() <= Self::MAX_MARKS
    }
}

/// A line chart.
#[derive(Clone, Debug)]
pub(super) struct Chart {
    /// Title of the horizontal axis.
    pub x_title: &'static str,
    /// Title of the vertical axis.
    pub y_title: &'static str,
    /// The horizontal axis.
    pub x: Scale,
    /// The vertical axis.
    pub y: Scale,
    /// The series to draw.
    pub series: Vec<PlotSeries>,
}

type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;

impl Chart {
    /// Renders the chart as an SVG element.
    ///
    /// # Errors
    /// If drawing fails, which would be a bug.
    pub(super) fn to_svg(&self) -> Result<String, Failure> {
        let mut svg = String::new();
        let drawn = self.draw(&SVGBackend::with_string(&mut svg, SIZE).into_drawing_area());
        drawn.map_err(|error| Failure::internal(format!("chart: {error}")))?;
        Ok(svg)
    }

    fn draw(&self, root: &Area<'_>) -> Result<(), Box<dyn Error + '_>> {
        let text = (FONT, FONT_PX).into_font();
        let mut chart = ChartBuilder::on(root)
            .margin(MARGIN_PX)
            .margin_right(if self.lists_names() { NAMES_PX } else { TICK_PX })
            .x_label_area_size(68)
            .y_label_area_size(112)
            .build_cartesian_2d(self.x.clone(), self.y.clone())?;
        chart
            .configure_mesh()
            .axis_style(SOFT.0)
            .bold_line_style(RULE.0)
            .light_line_style(TRANSPARENT)
            .label_style(text.color(&SOFT.0))
            .axis_desc_style(text.color(&INK.0))
            .x_desc(self.x_title)
            .y_desc(self.y_title)
            .draw()?;
        for (series, (color, _)) in self.series.iter().zip(SERIES.iter().cycle()) {
            let low = series.points.iter().zip(&series.spread).map(|(&(x, _), &(low, _))| (x, low));
            let high = series.points.iter().zip(&series.spread).map(|(&(x, _), &(_, high))| (x, high));
            let outline: Vec<_> = low.chain(high.rev()).collect();
            if outline.len() > 2 {
                chart.plotting_area().draw(&Polygon::new(outline, color.mix(0.22)))?;
            }
            chart.plotting_area().draw(&PathElement::new(series.points.clone(), color.stroke_width(3)))?;
            for &point in series.points.iter().filter(|_| series.has_marks()) {
                chart.plotting_area().draw(&Circle::new(point, 5, color.filled()))?;
            }
        }
        if self.lists_names() {
            self.list_names(root)?;
            root.present()?;
            return Ok(());
        }
        let (across, down) = chart.plotting_area().get_pixel_range();
        let rect = PixelRect { left: across.start, top: down.start, right: across.end, bottom: down.end };
        let pixel = |point: &(f64, f64)| chart.plotting_area().map_coordinate(point);
        let pixels: Vec<Vec<Pixel>> =
            self.series.iter().map(|series| series.points.iter().map(pixel).collect()).collect();
        self.name_series(root, Labels::new(rect, FONT_PX as i32), &pixels)?;
        root.present()?;
        Ok(())
    }

    /// Whether names are listed next to the chart, because lines with many points leave no room for them.
    fn lists_names(&self) -> bool {
        self.series.iter().any(|series| !series.has_marks())
    }

    /// Lists the names in a column to the right of the chart, highest lines first.
    fn list_names(&self, root: &Area<'_>) -> Result<(), Box<dyn Error + '_>> {
        let height = |series: &PlotSeries| {
            series.points.iter().map(|&(_, y)| y).sum::<f64>() / series.points.len() as f64
        };
        let drawn = self.series.iter().zip(SERIES.iter().cycle()).filter(|(s, _)| !s.points.is_empty());
        let mut named: Vec<_> = drawn.map(|(series, (color, _))| (height(series), series, color)).collect();
        named.sort_by(|a, b| b.0.total_cmp(&a.0));
        let left = (SIZE.0 - NAMES_PX) as i32 + 12;
        for (line, (_, series, color)) in named.into_iter().enumerate() {
            let y = MARGIN_PX as i32 + 14 + line as i32 * FONT_PX as i32 * 3 / 2;
            root.draw(&PathElement::new([(left, y), (left + 18, y)], color.stroke_width(4)))?;
            let style = (FONT, FONT_PX).into_font().color(color).pos(Pos::new(HPos::Left, VPos::Center));
            root.draw_text(&series.name, &style, (left + 26, y))?;
        }
        Ok(())
    }

    /// Writes each name next to its series, where nothing else is drawn.
    fn name_series(
        &self,
        root: &Area<'_>,
        mut labels: Labels,
        pixels: &[Vec<Pixel>],
    ) -> Result<(), Box<dyn Error + '_>> {
        for (series, points) in self.series.iter().zip(pixels) {
            labels.reserve(points, series.has_marks());
        }
        let drawn = self.series.iter().zip(pixels).zip(SERIES.iter().cycle());
        for ((series, points), (color, _)) in drawn {
            let from_the_right: Vec<Pixel> = points.iter().rev().copied().collect();
            let Some(position) = labels.place(&series.name, &from_the_right) else { continue };
            let anchor = match position.anchor {
                Anchor::Start => HPos::Left,
                Anchor::Middle => HPos::Center,
                Anchor::End => HPos::Right,
            };
            let style = (FONT, FONT_PX).into_font().color(color).pos(Pos::new(anchor, VPos::Center));
            root.draw_text(&series.name, &style, (position.x, position.y))?;
        }
        Ok(())
    }
}

/// CSS rules by which a page shows charts in its own colors.
pub(super) fn style() -> String {
    let hex = |RGBColor(r, g, b): RGBColor| format!("#{r:02X}{g:02X}{b:02X}");
    let mut rules = String::from(".chart svg { display: block; width: 100%; height: auto; }\n");
    for (color, variable) in [INK, SOFT, RULE] {
        for property in ["fill", "stroke"] {
            let color = hex(color);
            // Writing to a string cannot fail.
            let _ = writeln!(rules, ".chart [{property}=\"{color}\"] {{ {property}: var(--{variable}); }}");
        }
    }
    let mut dark = String::new();
    for (index, (color, in_dark)) in SERIES.into_iter().enumerate() {
        let color = hex(color);
        let _ = write!(dark, "--series-{index}: {in_dark}; ");
        for property in ["fill", "stroke"] {
            let _ = writeln!(
                rules,
                ".chart [{property}=\"{color}\"] {{ {property}: var(--series-{index}, {color}); }}"
            );
        }
    }
    let _ = write!(
        rules,
        "@media (prefers-color-scheme: dark) {{ :root:not([data-theme=\"light\"]) {{ {dark}}} }}\n\
         :root[data-theme=\"dark\"] {{ {dark}}}\n"
    );
    rules
}

#[cfg(test)]
mod tests {
    use super::*;

    fn chart(series: Vec<PlotSeries>) -> Chart {
        let x = Scale::at(&[1.0, 3.0, 5.0]);
        Chart { x_title: "to the right", y_title: "upwards", x, y: Scale::log([2.0, 900.0]), series }
    }

    #[test]
    fn chart_names_its_series_and_axes_in_known_colors() {
        let line = |name: &str, y: f64| PlotSeries {
            name: name.to_owned(),
            points: vec![(1.0, y), (3.0, y / 2.0), (5.0, y / 3.0)],
            spread: vec![(y / 2.0, y * 2.0), (y / 4.0, y), (y / 6.0, y)],
        };
        let svg = chart(vec![line("a <b>", 400.0), line("second", 30.0)]).to_svg().unwrap();
        assert!(svg.starts_with("<svg") && svg.trim_end().ends_with("</svg>"));
        for text in ["to the right", "upwards", "a &lt;b&gt;", "second"] {
            assert!(svg.contains(text), "{text:?} is not in the chart");
        }
        assert_eq!(svg.matches("<circle").count(), 6);
        let style = style();
        for color in svg.split("=\"#").skip(1).map(|rest| &rest[..6]) {
            assert!(style.contains(color), "the style does not know #{color}");
        }
    }

    #[test]
    fn names_of_long_lines_are_listed_from_highest_to_lowest() {
        let line = |name: &str, y: f64| PlotSeries {
            name: name.to_owned(),
            points: (0..100).map(|i| (1.0 + f64::from(i) / 25.0, y)).collect(),
            spread: Vec::new(),
        };
        let nothing = PlotSeries { name: "nothing".to_owned(), points: Vec::new(), spread: Vec::new() };
        let svg = chart(vec![line("low", 3.0), nothing, line("high", 500.0)]).to_svg().unwrap();
        assert!(svg.find("high").unwrap() < svg.find("low").unwrap());
        assert!(!svg.contains("nothing") && !svg.contains("<circle"));
    }

    #[test]
    fn empty_chart_still_has_axes() {
        assert!(chart(Vec::new()).to_svg().unwrap().contains("upwards"));
    }
}
