//! Where the name of a series goes in a chart: beside one of its points, over nothing else.

/// Pixels to the right and downwards.
pub(super) type Pixel = (i32, i32);

/// A place for a text: its anchor in pixels, and which part of the text lies there.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Spot {
    /// To the right.
    pub(super) x: i32,
    /// Downwards, the middle of the line.
    pub(super) y: i32,
    /// Which part of the text `x` is.
    pub(super) anchor: Anchor,
}

/// Which part of a text lies at its spot.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Anchor {
    Start,
    Middle,
    End,
}

/// Pixels from a corner to the one across.
#[derive(Clone, Copy, Debug)]
pub(super) struct Frame {
    /// The least x.
    pub(super) left: i32,
    /// The least y.
    pub(super) top: i32,
    /// The greatest x.
    pub(super) right: i32,
    /// The greatest y.
    pub(super) bottom: i32,
}

impl Frame {
    fn around((x, y): Pixel, px: i32) -> Self {
        Self { left: x - px, top: y - px, right: x + px, bottom: y + px }
    }

    fn overlaps(&self, other: &Self) -> bool {
        self.left < other.right
            && other.left < self.right
            && self.top < other.bottom
            && other.top < self.bottom
    }

    fn holds(&self, other: &Self) -> bool {
        self.left <= other.left
            && self.top <= other.top
            && other.right <= self.right
            && other.bottom <= self.bottom
    }
}

/// Places names one after the other; what is placed stays.
#[derive(Debug)]
pub(super) struct Labels {
    frame: Frame,
    font_px: i32,
    taken: Vec<Frame>,
}

impl Labels {
    /// Half a mark, with some air.
    const MARK_PX: i32 = 8;
    /// Half a line, with some air.
    const LINE_PX: i32 = 3;

    /// No name yet inside this frame.
    pub(super) fn new(frame: Frame, font_px: i32) -> Self {
        Self { frame, font_px, taken: Vec::new() }
    }

    /// Points, marked or not, and the line through them, that no name may cover.
    pub(super) fn keep_free(&mut self, points: &[Pixel], has_marks: bool) {
        let point_px = if has_marks { Self::MARK_PX } else { Self::LINE_PX };
        self.taken.extend(points.iter().map(|&point| Frame::around(point, point_px)));
        for pair in points.windows(2) {
            let ((x0, y0), (x1, y1)) = (pair[0], pair[1]);
            let count = ((x1 - x0).abs().max((y1 - y0).abs()) / Self::LINE_PX).max(1);
            let between = (0..count).map(|i| (x0 + (x1 - x0) * i / count, y0 + (y1 - y0) * i / count));
            self.taken.extend(between.map(|point| Frame::around(point, Self::LINE_PX)));
        }
    }

    /// The first free place beside one of these points, or further off; `None` where there are no points.
    pub(super) fn place(&mut self, name: &str, points: &[Pixel]) -> Option<Spot> {
        // Fonts differ; six tenths of their height is wide for most.
        let width = name.chars().count() as i32 * self.font_px * 6 / 10;
        let line = self.font_px * 11 / 10;
        let beside = Self::MARK_PX + 3;
        let spot = |(x, y): Pixel, dx: i32, dy: i32, anchor| Spot { x: x + dx, y: y + dy, anchor };
        let around = |&point: &Pixel| {
            [
                spot(point, beside, 0, Anchor::Start),
                spot(point, -beside, 0, Anchor::End),
                spot(point, 0, -line, Anchor::Middle),
                spot(point, 0, line, Anchor::Middle),
                spot(point, 0, -line, Anchor::End),
                spot(point, 0, line, Anchor::End),
                spot(point, 0, -line, Anchor::Start),
                spot(point, 0, line, Anchor::Start),
            ]
        };
        let &first = points.first()?;
        let far = (2..12).flat_map(|i| {
            let up =
                [Anchor::Middle, Anchor::Start, Anchor::End].map(|anchor| spot(first, 0, -i * line, anchor));
            let down =
                [Anchor::Middle, Anchor::Start, Anchor::End].map(|anchor| spot(first, 0, i * line, anchor));
            up.into_iter().chain(down)
        });
        let free = points.iter().flat_map(around).chain(far).find(|&spot| self.is_free(spot, width));
        let spot = free.unwrap_or(spot(first, beside, 0, Anchor::Start));
        self.taken.push(self.box_of(spot, width));
        Some(spot)
    }

    fn box_of(&self, spot: Spot, width: i32) -> Frame {
        let left = match spot.anchor {
            Anchor::Start => spot.x,
            Anchor::Middle => spot.x - width / 2,
            Anchor::End => spot.x - width,
        };
        let half = self.font_px / 2;
        Frame { left, top: spot.y - half, right: left + width, bottom: spot.y + half }
    }

    fn is_free(&self, spot: Spot, width: i32) -> bool {
        let wanted = self.box_of(spot, width);
        self.frame.holds(&wanted) && !self.taken.iter().any(|other| wanted.overlaps(other))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_lie_beside_their_points_and_not_over_each_other() {
        let mut labels = Labels::new(Frame { left: 0, top: 0, right: 400, bottom: 300 }, 20);
        let points = [(100, 100), (100, 104), (390, 50), (100, 96)];
        points.iter().for_each(|&point| labels.keep_free(&[point], true));
        let spots: Vec<Spot> = points.iter().map(|&p| labels.place("name", &[p]).unwrap()).collect();
        assert_eq!(spots[0], Spot { x: 111, y: 100, anchor: Anchor::Start });
        assert_eq!(spots[2].anchor, Anchor::End, "a name at the edge goes to the left");
        let boxes: Vec<Frame> = spots.iter().map(|&spot| labels.box_of(spot, 48)).collect();
        for (i, a) in boxes.iter().enumerate() {
            assert!(boxes[..i].iter().all(|b| !a.overlaps(b)), "{spots:?}");
        }
        assert_eq!(labels.place("nothing", &[]), None);
    }

    #[test]
    fn names_keep_off_lines() {
        let mut labels = Labels::new(Frame { left: 0, top: 0, right: 400, bottom: 300 }, 20);
        let line = [(50, 50), (350, 250)];
        labels.keep_free(&line, true);
        let spot = labels.place("a longer name", &line[1..]).unwrap();
        let frame = labels.box_of(spot, 156);
        for x in 50..350 {
            let point = Frame::around((x, 50 + (x - 50) * 2 / 3), 1);
            assert!(!frame.overlaps(&point), "{spot:?} at {x}");
        }
    }
}
