//! Arranges panels in a grid, with text above and below and a color bar at the side.

use super::distance_map::color_at;
use super::srgb::from_srgb;
use super::text::{Align, TextStyle, width, write};
use super::{Canvas, Rgba};

/// Colors of the background and the text.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Theme {
    background: Rgba,
    ink: Rgba,
    soft_ink: Rgba,
}

impl Theme {
    /// Light letters on nearly black.
    pub const DARK: Self = Self {
        background: [0.012, 0.013, 0.017, 1.0],
        ink: [0.85, 0.83, 0.80, 1.0],
        soft_ink: [0.46, 0.45, 0.43, 1.0],
    };
    /// Dark letters on nearly white.
    pub const LIGHT: Self = Self {
        background: [0.90, 0.89, 0.87, 1.0],
        ink: [0.012, 0.013, 0.017, 1.0],
        soft_ink: [0.10, 0.10, 0.11, 1.0],
    };

    /// Theme for an sRGB background color.
    pub fn on_srgb(srgb: [u8; 3]) -> Self {
        let [r, g, b] = srgb.map(from_srgb);
        Self::on([r, g, b, 1.0])
    }

    /// Theme with text that is legible on a background, linear light; on a transparent one it is gray,
    /// which suits most pages.
    pub fn on(background: Rgba) -> Self {
        let [r, g, b, opacity] = background;
        if opacity == 0.0 {
            let gray = [0.22, 0.22, 0.22, 1.0];
            return Self { background, ink: gray, soft_ink: gray };
        }
        let theme = if 0.2126 * r + 0.7152 * g + 0.0722 * b > 0.18 { Self::LIGHT } else { Self::DARK };
        Self { background, ..theme }
    }
}

/// A picture with its title and caption.
#[derive(Clone, Debug)]
pub struct Panel {
    /// Picture of size [`Sheet::panel_size`].
    pub canvas: Canvas,
    /// Text above the picture.
    pub title: String,
    /// Text below the picture.
    pub caption: String,
}

/// Color scale from 0 to a distance.
#[derive(Clone, Debug, PartialEq)]
pub struct ColorBar {
    /// Title of the bar.
    pub title: String,
    /// Evenly spaced labels, from 0 to the end of the bar.
    pub marks: Vec<String>,
}

impl ColorBar {
    /// Bar of distances up to `top`; marked as open-ended if `largest` is greater.
    pub fn up_to(top: f64, largest: f64) -> Self {
        const QUARTERS: u32 = 4;
        let mark = |i: u32| match f64::from(i) / f64::from(QUARTERS) * top {
            0.0 => "0".to_owned(),
            distance => significant(distance, 3),
        };
        let mut marks: Vec<String> = (0..=QUARTERS).map(mark).collect();
        if let (Some(last), true) = (marks.last_mut(), largest > top) {
            last.insert_str(0, "from ");
        }
        Self { title: "distance".to_owned(), marks }
    }
}

/// Formats a number with this many significant digits.
pub fn significant(number: f64, digits: usize) -> String {
    if number == 0.0 || !number.is_finite() {
        return format!("{number}");
    }
    let before = number.abs().log10().floor() as i32;
    if !(-5..6).contains(&before) {
        return format!("{number:.*e}", digits.saturating_sub(1));
    }
    let after = usize::try_from(digits as i32 - 1 - before).unwrap_or(0);
    format!("{number:.after$}")
}

/// Layout of a grid of panels.
#[derive(Clone, Debug)]
pub struct Sheet {
    size: [usize; 2],
    columns: usize,
    rows: usize,
    /// Whether there is text above and below the panels.
    has_text: bool,
    /// Whether titles appear only above the first row and captions only below the last.
    shares_text: bool,
    bar: Option<ColorBar>,
}

impl Sheet {
    /// Creates a sheet of `[width, height]` pixels with a grid of panels.
    pub fn new(size: [usize; 2], columns: usize, rows: usize) -> Self {
        let (columns, rows) = (columns.max(1), rows.max(1));
        Self { size, columns, rows, has_text: false, shares_text: false, bar: None }
    }

    /// Adds text above and below each row, or only around the whole grid if `shares_text`.
    pub fn with_text(self, shares_text: bool) -> Self {
        Self { has_text: true, shares_text, ..self }
    }

    /// Adds a color bar on the right.
    pub fn with_bar(self, bar: ColorBar) -> Self {
        Self { bar: Some(bar), ..self }
    }

    /// Size of each panel, pixels.
    pub fn panel_size(&self) -> [usize; 2] {
        let text_rows = if self.shares_text { 1 } else { self.rows };
        let text = if self.has_text { text_rows * (self.head_height() + self.foot_height()) } else { 0 };
        let width = self.size[0].saturating_sub(self.bar_width()) / self.columns;
        [width.max(1), (self.size[1].saturating_sub(text) / self.rows).max(1)]
    }

    /// Draws the panels, row by row, on the theme's background.
    pub fn assemble(&self, panels: &[Panel], theme: &Theme) -> Canvas {
        let mut sheet = Canvas::filled(self.size[0], self.size[1], theme.background);
        let [width, height] = self.panel_size();
        // Leftover columns are split between both sides.
        let left = self.size[0].saturating_sub(self.bar_width() + width * self.columns) / 2;
        let mut top = 0;
        for (row, panels) in panels.chunks(self.columns).enumerate() {
            let is_first = row == 0 || !self.shares_text;
            let is_last = row + 1 == self.rows || !self.shares_text;
            let middle = |column: usize| (left + column * width) as f32 + width as f32 / 2.0;
            if self.has_text && is_first {
                let y = top as f32 + 0.56 * self.head_height() as f32;
                for (column, panel) in panels.iter().enumerate() {
                    let style = TextStyle { size: self.title_size(), color: theme.ink };
                    self.write(&mut sheet, &panel.title, style, [middle(column), y]);
                }
                top += self.head_height();
            }
            for (column, panel) in panels.iter().enumerate() {
                sheet.blend(&panel.canvas, left + column * width, top);
            }
            top += height;
            if self.has_text && is_last {
                let y = top as f32 + 0.42 * self.foot_height() as f32;
                for (column, panel) in panels.iter().enumerate() {
                    let style = TextStyle { size: 0.74 * self.title_size(), color: theme.soft_ink };
                    self.write(&mut sheet, &panel.caption, style, [middle(column), y]);
                }
                top += self.foot_height();
            }
        }
        if let Some(bar) = &self.bar {
            self.draw_bar(&mut sheet, bar, theme);
        }
        sheet
    }

    /// Writes text centered in a panel's width, smaller if it would not fit.
    fn write(
        &self,
        sheet: &mut Canvas,
        text: &str,
        TextStyle { size, color }: TextStyle,
        position: [f32; 2],
    ) {
        let room = 0.88 * self.panel_size()[0] as f32;
        let size = size * (room / width(text, size).max(1.0)).min(1.0);
        write(sheet, text, TextStyle { size, color }, position, Align::Middle);
    }

    /// Font size of titles, pixels.
    fn title_size(&self) -> f32 {
        let [width, height] = self.size.map(|side| side as f32);
        (width / self.columns as f32 / 8.5).min(height / self.rows as f32 / 11.0).clamp(11.0, 44.0)
    }

    fn head_height(&self) -> usize {
        (2.1 * self.title_size()) as usize
    }

    fn foot_height(&self) -> usize {
        (1.9 * self.title_size()) as usize
    }

    /// Font size of the color bar, pixels.
    fn mark_size(&self) -> f32 {
        (self.size[1] as f32 / 30.0).min(self.size[0] as f32 / 60.0).clamp(11.0, 26.0)
    }

    fn bar_width(&self) -> usize {
        let Some(bar) = &self.bar else { return 0 };
        let size = self.mark_size();
        let texts = bar.marks.iter().map(|mark| width(mark, size) + 2.6 * size);
        let title = width(&bar.title, size);
        (texts.fold(title, f32::max) + 1.5 * size).ceil() as usize
    }

    fn draw_bar(&self, sheet: &mut Canvas, bar: &ColorBar, theme: &Theme) {
        let size = self.mark_size();
        let [left, thick] = [self.size[0].saturating_sub(self.bar_width()), (1.1 * size) as usize];
        let height = self.size[1];
        let (top, bottom) = (height * 22 / 100, height * 78 / 100);
        for y in top..bottom {
            let share = (bottom - 1 - y) as f64 / (bottom - 1 - top).max(1) as f64;
            let [r, g, b] = color_at(share);
            for x in left..(left + thick).min(self.size[0]) {
                sheet.row_mut(y)[x] = [r, g, b, 1.0];
            }
        }
        let x = left as f32;
        write(
            sheet,
            &bar.title,
            TextStyle { size, color: theme.ink },
            [x, top as f32 - 1.5 * size],
            Align::Left,
        );
        let last = bar.marks.len().saturating_sub(1).max(1) as f32;
        for (index, mark) in bar.marks.iter().enumerate() {
            let y = bottom as f32 - index as f32 / last * (bottom - top) as f32;
            let tick = y.min(bottom as f32 - 1.0).max(top as f32) as i64;
            for dx in 0..(0.4 * size) as i64 {
                sheet.tint([(left + thick) as i64 + dx, tick], theme.soft_ink, 1.0);
            }
            let position = [x + thick as f32 + 0.65 * size, y];
            write(sheet, mark, TextStyle { size, color: theme.ink }, position, Align::Left);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn panel(size: [usize; 2], color: Rgba) -> Panel {
        let canvas = Canvas::filled(size[0], size[1], color);
        Panel { canvas, title: "10 %".to_owned(), caption: "5,000 triangles".to_owned() }
    }

    #[test]
    fn panels_are_placed_between_their_texts() {
        let sheet = Sheet::new([400, 300], 2, 2).with_text(true);
        let size = sheet.panel_size();
        let colors = [[1.0, 0.0, 0.0, 1.0], [0.0, 1.0, 0.0, 1.0], [0.0, 0.0, 1.0, 1.0], [0.5, 0.5, 0.0, 1.0]];
        let panels = colors.map(|color| panel(size, color));
        let canvas = sheet.assemble(&panels, &Theme::DARK);
        let at = |x: usize, y: usize| canvas.pixels()[y * 400 + x];
        let head = sheet.head_height();
        for (i, color) in colors.into_iter().enumerate() {
            let (x, y) = (i % 2 * size[0] + size[0] / 2, head + i / 2 * size[1] + size[1] / 2);
            assert_eq!(at(x, y), color, "panel {i}");
        }
        let inked = |rows: std::ops::Range<usize>| {
            rows.flat_map(|y| (0..400).map(move |x| (x, y))).filter(|&(x, y)| at(x, y)[0] > 0.15).count()
        };
        assert!(inked(0..head) > 20, "no titles");
        assert!(inked(head + 2 * size[1]..300) > 20, "no captions");
        assert!(head + 2 * size[1] + sheet.foot_height() <= 300);
    }

    #[test]
    fn a_bar_goes_from_the_first_color_to_the_last() {
        let marks = ["0", "0.5", "1"].map(str::to_owned).to_vec();
        let bar = ColorBar { title: "distance".to_owned(), marks };
        let sheet = Sheet::new([300, 200], 1, 1).with_bar(bar);
        let [width, _] = sheet.panel_size();
        assert!(width < 260);
        let canvas = sheet.assemble(&[panel(sheet.panel_size(), [0.0; 4])], &Theme::DARK);
        let color = |share: f64| {
            let [r, g, b] = color_at(share);
            [r, g, b, 1.0]
        };
        let at = |y: usize| canvas.pixels()[y * 300 + 300 - sheet.bar_width() + 2];
        assert_eq!((at(44), at(155)), (color(1.0), color(0.0)));
        assert_eq!(at(43), Theme::DARK.background);
    }

    #[test]
    fn tiny_sheets_are_drawn() {
        for size in [[1, 1], [3, 200], [200, 3]] {
            let marks = vec!["0".to_owned(), "1".to_owned()];
            let bar = ColorBar { title: "t".to_owned(), marks };
            let sheet = Sheet::new(size, 3, 2).with_text(false).with_bar(bar);
            let panels = vec![panel(sheet.panel_size(), [1.0; 4]); 6];
            let canvas = sheet.assemble(&panels, &Theme::on([0.0; 4]));
            assert_eq!([canvas.width, canvas.height], size);
        }
    }

    #[test]
    fn numbers_have_the_significant_digits() {
        for (number, text) in [
            (0.0, "0"),
            (1.0, "1.00"),
            (0.012_345, "0.0123"),
            (12.345, "12.3"),
            (98_765.4, "98765"),
            (1.5e-9, "1.50e-9"),
            (2.5e9, "2.50e9"),
        ] {
            assert_eq!(significant(number, 3), text);
        }
    }

    #[test]
    fn a_bar_marks_distances_beyond_its_top() {
        assert_eq!(ColorBar::up_to(2.0, 2.0).marks, ["0", "0.500", "1.00", "1.50", "2.00"]);
        assert_eq!(ColorBar::up_to(2.0, 3.0).marks[4], "from 2.00");
        assert_eq!(ColorBar::up_to(0.0, 0.0).marks, ["0"; 5]);
    }
}
