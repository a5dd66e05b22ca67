//! Horizontal bar charts: a group of bars per name, with one bar per kind of value.

use std::error::Error;

use plotters::coord::Shift;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

use super::plot::{FONT, FONT_PX, INK, RULE, SERIES, SIZE, SOFT};
use super::scale::Scale;
use striata_command::failure::Failure;

/// A group of bars: a name and one value of each kind.
#[derive(Clone, Debug)]
pub(super) struct Bars {
    /// Name of the group.
    pub name: String,
    /// One value per kind; later ones may be missing.
    pub values: Vec<f64>,
}

/// A bar chart.
#[derive(Clone, Debug)]
pub(super) struct BarChart {
    /// Title of the value axis.
    pub title: &'static str,
    /// The kinds of values, in the order of their colors.
    pub kinds: Vec<&'static str>,
    /// The groups, from top to bottom.
    pub bars: Vec<Bars>,
}

/// Pixels reserved for names on the left, values behind bars, the legend on top, and the axis.
const NAMES_PX: i32 = 215;
const VALUES_PX: i32 = 84;
const KINDS_PX: i32 = 48;
const AXIS_PX: i32 = 66;

/// Part of a group's height that stays empty.
const GAP: f64 = 0.25;

impl BarChart {
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

    fn draw(&self, root: &DrawingArea<SVGBackend<'_>, Shift>) -> Result<(), Box<dyn Error + '_>> {
        let (width, height) = (SIZE.0 as i32, SIZE.1 as i32);
        let (right, bottom) = (width - VALUES_PX, height - AXIS_PX);
        let scale = Scale::linear(self.bars.iter().flat_map(|bars| bars.values.iter().copied()).chain([0.0]));
        let across = |value: f64| scale.pixel(value, NAMES_PX, right);
        let text = |color: RGBColor, side: HPos| {
            (FONT, FONT_PX).into_font().color(&color).pos(Pos::new(side, VPos::Center))
        };
        for &tick in scale.ticks() {
            let x = across(tick);
            root.draw(&PathElement::new([(x, KINDS_PX), (x, bottom)], RULE.0))?;
            root.draw_text(&Scale::label(tick), &text(SOFT.0, HPos::Center), (x, bottom + 18))?;
        }
        root.draw_text(self.title, &text(INK.0, HPos::Center), ((NAMES_PX + right) / 2, height - 16))?;
        self.draw_kinds(root)?;
        let group_px = f64::from(bottom - KINDS_PX) / self.bars.len().max(1) as f64;
        let bar_px = group_px * (1.0 - GAP) / self.kinds.len().max(1) as f64;
        let value_px = (FONT_PX as f64).min(bar_px);
        for (i, bars) in self.bars.iter().enumerate() {
            let middle = f64::from(KINDS_PX) + group_px * (i as f64 + 0.5);
            root.draw_text(&bars.name, &text(INK.0, HPos::Right), (NAMES_PX - 10, middle as i32))?;
            let first = middle - bar_px * bars.values.len() as f64 / 2.0;
            for (k, (&value, (color, _))) in bars.values.iter().zip(SERIES).enumerate() {
                let from = first + bar_px * k as f64;
                let to = from + bar_px - 1.0;
                let bar = [(NAMES_PX, from as i32), (across(value), to as i32)];
                root.draw(&Rectangle::new(bar, color.filled()))?;
                let style =
                    (FONT, value_px).into_font().color(&SOFT.0).pos(Pos::new(HPos::Left, VPos::Center));
                let position = (across(value) + 6, ((from + to) / 2.0) as i32);
                root.draw_text(&format!("{value:.1}"), &style, position)?;
            }
        }
        root.present()?;
        Ok(())
    }

    /// Draws the legend: a square in each color with its kind.
    fn draw_kinds(&self, root: &DrawingArea<SVGBackend<'_>, Shift>) -> Result<(), Box<dyn Error + '_>> {
        let mut x = NAMES_PX;
        for (kind, (color, _)) in self.kinds.iter().zip(SERIES) {
            root.draw(&Rectangle::new([(x, 16), (x + 16, 32)], color.filled()))?;
            let style = (FONT, FONT_PX).into_font().color(&INK.0).pos(Pos::new(HPos::Left, VPos::Center));
            root.draw_text(kind, &style, (x + 24, 24))?;
            x += 56 + kind.chars().count() as i32 * FONT_PX as i32 * 6 / 10;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_value_has_a_bar_and_a_label() {
        let bars = |name: &str, values: &[f64]| Bars { name: name.to_owned(), values: values.to_vec() };
        let chart = BarChart {
            title: "bytes",
            kinds: vec!["one", "another"],
            bars: vec![bars("<first>", &[3.0, 41.5]), bars("second", &[7.0])],
        };
        let svg = chart.to_svg().unwrap();
        // Three bars, and a legend square for each kind.
        assert_eq!(svg.matches("<rect").count(), 5, "{svg}");
        for text in ["bytes", "one", "another", "&lt;first&gt;", "second", "3.0", "41.5", "7.0"] {
            assert!(svg.contains(text), "{text:?} is not in the chart");
        }
        let style = super::super::plot::style();
        for color in svg.split("=\"#").skip(1).map(|rest| &rest[..6]) {
            assert!(style.contains(color), "the style does not know #{color}");
        }
    }

    #[test]
    fn empty_charts_and_zeros_can_be_drawn() {
        for bars in [Vec::new(), vec![Bars { name: "none".to_owned(), values: vec![0.0] }]] {
            assert!(BarChart { title: "bytes", kinds: vec!["one"], bars }.to_svg().is_ok());
        }
    }
}
