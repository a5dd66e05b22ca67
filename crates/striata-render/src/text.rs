//! Draws text on a canvas with the embedded font.

use std::sync::LazyLock;

use ab_glyph::{Font, FontRef, Glyph, PxScale, ScaleFont, point};

use super::{Canvas, Rgba};

/// The font; none only if it cannot be parsed, which a test rules out.
static FONT: LazyLock<Option<FontRef<'static>>> =
    LazyLock::new(|| FontRef::try_from_slice(epaint_default_fonts::UBUNTU_LIGHT).ok());

/// Horizontal alignment of text relative to its position.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Align {
    /// The text starts at the position.
    Left,
    /// The text is centered at the position.
    Middle,
}

/// Size and color of a text.
#[derive(Clone, Copy)]
pub(crate) struct TextStyle {
    /// Height of the letters, pixels.
    pub size: f32,
    /// Color of the letters.
    pub color: Rgba,
}

/// Writes a line of text with its capital letters vertically centered at the position.
pub(crate) fn write(canvas: &mut Canvas, text: &str, style: TextStyle, [x, y]: [f32; 2], align: Align) {
    let TextStyle { size, color } = style;
    let Some(font) = FONT.as_ref() else { return };
    let (glyphs, width) = layout(font, text, size);
    let left = if align == Align::Middle { x - width / 2.0 } else { x };
    // Capital letters reach about 0.69 of the font size above the baseline.
    let base = (y + 0.35 * size * CAPITALS).round();
    for mut glyph in glyphs {
        glyph.position += point(left, base);
        let Some(outline) = font.outline_glyph(glyph) else { continue };
        let bounds = outline.px_bounds();
        outline.draw(|dx, dy, amount| {
            let pixel = [bounds.min.x as i64 + i64::from(dx), bounds.min.y as i64 + i64::from(dy)];
            canvas.tint(pixel, color, amount.clamp(0.0, 1.0));
        });
    }
}

/// Height of capital letters, relative to 0.7 of the font size.
const CAPITALS: f32 = 0.69 / 0.7;

/// Width of a text in pixels.
pub(crate) fn width(text: &str, size: f32) -> f32 {
    FONT.as_ref().map_or(0.0, |font| layout(font, text, size).1)
}

/// Lays out glyphs from x = 0, and returns them with the total width.
fn layout(font: &FontRef<'static>, text: &str, size: f32) -> (Vec<Glyph>, f32) {
    let scaled = font.as_scaled(PxScale::from(size));
    let (mut glyphs, mut x, mut last) = (Vec::new(), 0.0, None);
    for letter in text.chars() {
        let glyph = font.glyph_id(letter);
        if let Some(last) = last {
            x += scaled.kern(last, glyph);
        }
        glyphs.push(glyph.with_scale_and_position(size, point(x, 0.0)));
        x += scaled.h_advance(glyph);
        last = Some(glyph);
    }
    (glyphs, x)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn letters_are_drawn_at_the_right_position() {
        let mut canvas = Canvas::filled(120, 40, [0.0, 0.0, 0.0, 1.0]);
        write(&mut canvas, "H", TextStyle { size: 24.0, color: [1.0; 4] }, [60.0, 20.0], Align::Middle);
        let inked: Vec<[usize; 2]> =
            (0..40 * 120).filter(|&i| canvas.pixels()[i][0] > 0.5).map(|i| [i % 120, i / 120]).collect();
        let middle = |k: usize| {
            let (min, max) = (inked.iter().map(|p| p[k]).min(), inked.iter().map(|p| p[k]).max());
            (min.expect("ink") + max.expect("ink")) as f32 / 2.0
        };
        assert!(
            (middle(0) - 59.5).abs() < 2.0 && (middle(1) - 19.5).abs() < 2.0,
            "{} {}",
            middle(0),
            middle(1)
        );
    }

    #[test]
    fn longer_texts_are_wider_and_the_font_has_all_letters() {
        assert!(width("10 %", 20.0) > width("1 %", 20.0) && width("", 20.0) == 0.0);
        let font = FONT.as_ref().expect("the font is sound");
        for letter in "0123456789 %,.-+eabcdefghijklmnopqrstuvwxyzµ·ABCDEFGHIJKLMNOPQRSTUVWXYZ".chars() {
            assert!(font.glyph_id(letter).0 != 0, "{letter:?} is not in the font");
        }
    }
}
