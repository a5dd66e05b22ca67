//! Placement of series names in a chart: next to one of their points, without covering anything else.

/// Pixel coordinates to the right and downward.
pub(super) type Pixel = (i32, i32);

/// Position of a label.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct LabelPosition {
    /// Horizontal position of the anchor.
    pub x: i32,
    /// Vertical position of the label's center.
    pub y: i32,
    /// The part of the text at `x`.
    pub anchor: Anchor,
}

/// The part of a text at its position.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Anchor {
    Start,
    Middle,
    End,
}

/// A rectangle in pixels.
#[derive(Clone, Copy, Debug)]
pub(super) struct PixelRect {
    /// Smallest x.
    pub left: i32,
    /// Smallest y.
    pub top: i32,
    /// Largest x.
    pub right: i32,
    /// Largest y.
    pub bottom: i32,
}

impl PixelRect {
    fn around((x, y): Pixel, px: i32) -> Self {
        Self { left: x - px, top: y - px, right: x + px, bottom: y + px }
    }

    fn overlaps(&self, other: &Self) -> bool {
        self.left < other.right
            && other.left < self.right
            && self.top < other.bottom
            && other.top < self.bottom
    }

    fn contains(&self, other: &Self) -> bool {
        self.left <= other.left
            && self.top <= other.top
            && other.right <= self.right
            && other.bottom <= self.bottom
    }
}

/// Places labels one after another; placed labels do not move.
#[derive(Debug)]
pub(super) struct Labels {
    rect: PixelRect,
    font_px: i32,
    occupied: Vec<PixelRect>,
}

impl Labels {
    /// Half the size of a mark, with padding.
    const MARK_PX: i32 = 8;
    /// Half the width of a line, with padding.
    const LINE_PX: i32 = 3;

    /// Creates an empty layout inside a rectangle.
    pub(super) fn new(rect: PixelRect, font_px: i32) -> Self {
        Self { rect, font_px, occupied: Vec::new() }
    }

    /// Reserves points, with or without marks, and the line through them, so that no label covers them.
    pub(super) fn reserve(&mut self, points: &[Pixel], has_marks: bool) {
        let point_px = if has_marks { Self::MARK_PX } else { Self::LINE_PX };
        self.occupied.extend(points.iter().map(|&point| PixelRect::around(point, point_px)));
        for pair in points.windows(2) {
            let ((x0, y0), (x1, y1)) = (pair[0], pair[1]);
            let count = ((x1 - x0).abs().max((y1 - y0).abs()) / Self::LINE_PX).max(1);
            let between = (0..count).map(|i| (x0 + (x1 - x0) * i / count, y0 + (y1 - y0) * i / count));
            self.occupied.extend(between.map(|point| PixelRect::around(point, Self::LINE_PX)));
        }
    }

    /// Finds the first free position next to one of the points, or farther away, and reserves it. `None`
    /// if there are no points.
    pub(super) fn place(&mut self, name: &str, points: &[Pixel]) -> Option<LabelPosition> {
        // Font metrics differ; six tenths of the height per character is wide enough for most.
        let width = name.chars().count() as i32 * self.font_px * 6 / 10;
        let line = self.font_px * 11 / 10;
        let gap = Self::MARK_PX + 3;
        let position =
            |(x, y): Pixel, dx: i32, dy: i32, anchor| LabelPosition { x: x + dx, y: y + dy, anchor };
        let around = |&point: &Pixel| {
            [
                position(point, gap, 0, Anchor::Start),
                position(point, -gap, 0, Anchor::End),
                position(point, 0, -line, Anchor::Middle),
                position(point, 0, line, Anchor::Middle),
                position(point, 0, -line, Anchor::End),
                position(point, 0, line, Anchor::End),
                position(point, 0, -line, Anchor::Start),
                position(point, 0, line, Anchor::Start),
            ]
        };
        let &first = points.first()?;
        let farther = (2..12).flat_map(|i| {
            let up = [Anchor::Middle, Anchor::Start, Anchor::End]
                .map(|anchor| position(first, 0, -i * line, anchor));
            let down = [Anchor::Middle, Anchor::Start, Anchor::End]
                .map(|anchor| position(first, 0, i * line, anchor));
            up.into_iter().chain(down)
        });
        let free =
            points.iter().flat_map(around).chain(farther).find(|&position| self.is_free(position, width));
        let position = free.unwrap_or(position(first, gap, 0, Anchor::Start));
        self.occupied.push(self.rect_of(position, width));
        Some(position)
    }

    fn rect_of(&self, position: LabelPosition, width: i32) -> PixelRect {
        let left = match position.anchor {
            Anchor::Start => position.x,
            Anchor::Middle => position.x - width / 2,
            Anchor::End => position.x - width,
        };
        let half = self.font_px / 2;
        PixelRect { left, top: position.y - half, right: left + width, bottom: position.y + half }
    }

    fn is_free(&self, position: LabelPosition, width: i32) -> bool {
        let candidate = self.rect_of(position, width);
        self.rect.contains(&candidate) && !self.occupied.iter().any(|other| candidate.overlaps(other))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn labels_are_next_to_their_points_and_do_not_overlap() {
        let mut labels = Labels::new(PixelRect { left: 0, top: 0, right: 400, bottom: 300 }, 20);
        let points = [(100, 100), (100, 104), (390, 50), (100, 96)];
        points.iter().for_each(|&point| labels.reserve(&[point], true));
        let positions: Vec<LabelPosition> =
            points.iter().map(|&p| labels.place("name", &[p]).unwrap()).collect();
        assert_eq!(positions[0], LabelPosition { x: 111, y: 100, anchor: Anchor::Start });
        assert_eq!(positions[2].anchor, Anchor::End, "a name at the edge goes to the left");
        let boxes: Vec<PixelRect> = positions.iter().map(|&position| labels.rect_of(position, 48)).collect();
        for (i, a) in boxes.iter().enumerate() {
            assert!(boxes[..i].iter().all(|b| !a.overlaps(b)), "{positions:?}");
        }
        assert_eq!(labels.place("nothing", &[]), None);
    }

    #[test]
    fn labels_do_not_cover_lines() {
        let mut labels = Labels::new(PixelRect { left: 0, top: 0, right: 400, bottom: 300 }, 20);
        let line = [(50, 50), (350, 250)];
        labels.reserve(&line, true);
        let position = labels.place("a longer name", &line[1..]).unwrap();
        let rect = labels.rect_of(position, 156);
        for x in 50..350 {
            let point = PixelRect::around((x, 50 + (x - 50) * 2 / 3), 1);
            assert!(!rect.overlaps(&point), "{position:?} at {x}");
        }
    }
}
