//! An SVG picture made of panels, on which triangles, links and texts are drawn.

use std::ops::Range;

use glam::DVec2;
use plotters::element::DashedPathElement;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};
use striata_command::failure::Failure;

use crate::compare::plot::{FONT, INK, RULE, SERIES, SOFT};

/// Size of the picture in pixels.
pub(super) const SIZE: DVec2 = DVec2::new(1200.0, 640.0);
/// Height of the part for panels; texts go below it.
const PANEL_HEIGHT: f64 = 470.0;
/// Margin around what a panel shows.
const MARGIN: f64 = 36.0;
/// Lightness that is added to a color to fill an area.
const TINT: f64 = 0.72;

pub(super) const DARK: RGBColor = INK.0;
pub(super) const GRAY: RGBColor = SOFT.0;
const PALE: RGBColor = RULE.0;

/// Color of a strip, a step or a level.
pub(super) fn color(index: usize) -> RGBColor {
    SERIES[index % SERIES.len()].0
}

/// A light version of a color.
pub(super) fn tint(RGBColor(r, g, b): RGBColor) -> RGBColor {
    let light = |x: u8| (f64::from(x) + TINT * (255.0 - f64::from(x))) as u8;
    RGBColor(light(r), light(g), light(b))
}

/// How a line is drawn.
#[derive(Clone, Copy, Debug)]
pub(super) struct LineStyle {
    pub color: RGBColor,
    pub width: u32,
    pub is_dashed: bool,
}

impl LineStyle {
    pub(super) const fn solid(color: RGBColor, width: u32) -> Self {
        Self { color, width, is_dashed: false }
    }

    pub(super) const fn dashed(color: RGBColor, width: u32) -> Self {
        Self { color, width, is_dashed: true }
    }
}

/// How a text is aligned with its point.
#[derive(Clone, Copy, Debug)]
pub(super) enum TextAlign {
    Left,
    Center,
}

enum DrawnShape {
    Area(Vec<DVec2>, RGBColor),
    Path(Vec<DVec2>, LineStyle),
    Dot(DVec2, i32, RGBColor),
    Text(DVec2, String, TextAlign, i32, RGBColor),
}

/// Shapes that are drawn, in order, in pixels.
#[derive(Default)]
pub(super) struct FigureSheet {
    shapes: Vec<DrawnShape>,
}

impl FigureSheet {
    pub(super) fn area(&mut self, corners: &[DVec2], color: RGBColor) {
        self.shapes.push(DrawnShape::Area(corners.to_vec(), color));
    }

    pub(super) fn path(&mut self, points: &[DVec2], line: LineStyle) {
        self.shapes.push(DrawnShape::Path(points.to_vec(), line));
    }

    /// A closed outline.
    pub(super) fn outline(&mut self, corners: &[DVec2], line: LineStyle) {
        let closed: Vec<DVec2> = corners.iter().chain(corners.first()).copied().collect();
        self.path(&closed, line);
    }

    pub(super) fn dot(&mut self, at: DVec2, radius: i32, color: RGBColor) {
        self.shapes.push(DrawnShape::Dot(at, radius, color));
    }

    pub(super) fn text(&mut self, at: DVec2, text: impl Into<String>, align: TextAlign) {
        self.shapes.push(DrawnShape::Text(at, text.into(), align, 20, DARK));
    }

    /// The number of a vertex, on a disc.
    pub(super) fn number(&mut self, at: DVec2, number: u32) {
        self.dot(at, 13, PALE);
        self.label(at, number.to_string(), DARK);
    }

    /// Lines of text across the sheet, from a height downward.
    pub(super) fn lines(&mut self, y: f64, lines: &[String]) {
        for (i, line) in lines.iter().enumerate() {
            self.text(DVec2::new(48.0, y + 26.0 * i as f64), line.as_str(), TextAlign::Left);
        }
    }

    /// A small text in a color, centered.
    pub(super) fn label(&mut self, at: DVec2, text: impl Into<String>, color: RGBColor) {
        self.shapes.push(DrawnShape::Text(at, text.into(), TextAlign::Center, 16, color));
    }

    /// Draws everything.
    ///
    /// # Errors
    /// If the back end fails.
    pub(super) fn to_svg(&self) -> Result<String, Failure> {
        let mut svg = String::new();
        self.draw(&mut svg).map_err(|error| Failure::internal(error.to_string()))?;
        Ok(svg)
    }

    fn draw(&self, svg: &mut String) -> Result<(), Box<dyn std::error::Error>> {
        let root = SVGBackend::with_string(svg, (SIZE.x as u32, SIZE.y as u32)).into_drawing_area();
        root.fill(&WHITE)?;
        let pixel = |p: &DVec2| (p.x.round() as i32, p.y.round() as i32);
        for shape in &self.shapes {
            match shape {
                DrawnShape::Area(corners, color) => {
                    root.draw(&Polygon::new(corners.iter().map(pixel).collect::<Vec<_>>(), color.filled()))?;
                }
                DrawnShape::Path(points, LineStyle { color, width, is_dashed }) => {
                    let points: Vec<_> = points.iter().map(pixel).collect();
                    let style = color.stroke_width(*width);
                    if *is_dashed {
                        root.draw(&DashedPathElement::new(points, 6, 5, style))?;
                    } else {
                        root.draw(&PathElement::new(points, style))?;
                    }
                }
                DrawnShape::Dot(at, radius, color) => {
                    root.draw(&Circle::new(pixel(at), *radius, color.filled()))?;
                }
                DrawnShape::Text(at, text, align, size, color) => {
                    let (h, v) = match align {
                        TextAlign::Left => (HPos::Left, VPos::Center),
                        TextAlign::Center => (HPos::Center, VPos::Center),
                    };
                    let style = (FONT, *size).into_font().color(color).pos(Pos::new(h, v));
                    root.draw(&Text::new(text.as_str(), pixel(at), style))?;
                }
            }
        }
        root.present()?;
        Ok(())
    }
}

/// A part of the sheet in which points of a plane are seen.
#[derive(Clone, Copy, Debug)]
pub(super) struct SheetPanel {
    scale: f64,
    offset: DVec2,
    pub middle: f64,
}

impl SheetPanel {
    /// The panel that covers a range of pixels from left to right, and shows all points.
    pub(super) fn new(pixels: Range<f64>, points: &[DVec2]) -> Self {
        let min = points.iter().copied().fold(DVec2::INFINITY, DVec2::min);
        let max = points.iter().copied().fold(DVec2::NEG_INFINITY, DVec2::max);
        let room = DVec2::new(pixels.end - pixels.start, PANEL_HEIGHT) - 2.0 * MARGIN;
        let scale = (room / (max - min).max(DVec2::splat(f64::MIN_POSITIVE))).min_element();
        let middle = 0.5 * (pixels.start + pixels.end);
        let center = DVec2::new(middle, 0.5 * PANEL_HEIGHT);
        Self { scale, offset: center - scale * 0.5 * (min + max), middle }
    }

    pub(super) fn at(&self, point: DVec2) -> DVec2 {
        self.scale * point + self.offset
    }

    pub(super) fn corners(&self, points: &[DVec2], triangle: &[u32; 3]) -> [DVec2; 3] {
        triangle.map(|v| self.at(points[v as usize]))
    }
}

/// The panels of a sheet with `count` pictures of the same points.
pub(super) fn panels(count: usize, points: &[DVec2]) -> Vec<SheetPanel> {
    let width = SIZE.x / count as f64;
    (0..count).map(|i| SheetPanel::new(i as f64 * width..(i + 1) as f64 * width, points)).collect()
}
